/* The levels tool: what stays while a level is dragged. Length, area and symmetry by their switches, places by pins; a pin that is put twice holds
 * the direction, too, and the third time it is gone. */
#include "base/real.h"
#include "curve/curve.h"
#include "curve/mirror.h"
#include "editor/edit/symmetry.h"
#include "editor/scene/path.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/settings.h"
#include "editor/tools/levels/state.h"
#include "editor/view/stage.h"
#include <math.h>
#include <string.h>

static const double REACH = 12, SIZE = 4,
                    BAR = 16;    /* px: to a pin; its half; half the direction that is held */
static const double ON_AXIS = 6; /* px: what is pressed so near the axis moves along it */
static const double EVEN = 1e-5; /* of the size: as symmetric as a file with few digits says it */

enum { HALVINGS = 7 }; /* of the way that cannot be gone as a whole */

/* The axis about which the chosen curve is its own mirror image, and stays it: of several the one nearest to the drawing's own. */
static bool axis_now(const bat_context *c, bat_mirror *out) {
    const bat_curve *curve = bat_leveling_curve(c);
    const double upright[2] = {0, 1};
    int turn;
    return curve && c->settings->values[BAT_PROPERTY_HOLD_SYMMETRY] != 0 &&
           bat_mirror_find(curve, c->session->axis.on ? c->session->axis.along : upright,
                           EVEN * bat_curve_size(curve), out, &turn);
}

/* What is held of the chosen curve; room: for the parameters. */
static bat_shape_held held_now(const bat_context *c, double points[BAT_HELD_MAX],
                               double directions[BAT_HELD_MAX]) {
    const bat_leveling *l = bat_leveling_of(c);
    const bat_curve *curve = bat_leveling_curve(c);
    bat_shape_held held = {.points = points, .directions = directions};
    bat_mirror axis;
    if (!curve) return held;
    held.length = c->settings->values[BAT_PROPERTY_HOLD_LENGTH] != 0;
    held.area = c->settings->values[BAT_PROPERTY_HOLD_AREA] != 0 && bat_curve_is_closed(curve) &&
                bat_curve_dimension(curve) == 2;
    held.symmetry = axis_now(c, &axis);
    if (held.symmetry) memcpy(held.upright, axis.along, sizeof held.upright);
    for (int i = 0; i < l->pin_count; i++) {
        points[held.point_count++] = l->pins[i].u;
        if (l->pins[i].direction) directions[held.direction_count++] = l->pins[i].u;
    }
    return held;
}

bool bat_leveling_holds(const bat_context *c) {
    double points[BAT_HELD_MAX], directions[BAT_HELD_MAX];
    const bat_shape_held held = held_now(c, points, directions);
    return held.length || held.area || held.symmetry || held.point_count > 0;
}

/* What is dragged from the axis goes along it. */
static void keep_on_axis(const bat_context *c, const bat_shape *shape, const bat_handle *grip,
                         double delta[3]) {
    double place[BAT_DIMENSION_MAX];
    bat_mirror axis;
    if (!axis_now(c, &axis)) return;
    if (grip->kind == BAT_HANDLE_POINT)
        memcpy(place, bat_curve_points(bat_shape_curve(shape, bat_leveling_of(c)->level)) + 2 * grip->index,
               2 * sizeof *place);
    else
        bat_curve_eval(bat_shape_curve(shape, bat_shape_levels(shape)), grip->u, 0, place);
    if (fabs(bat_mirror_side(&axis, place)) > ON_AXIS * bat_stage_pixel(c->stage)) return;
    const double along = delta[0] * axis.along[0] + delta[1] * axis.along[1];
    for (int k = 0; k < 2; k++) delta[k] = along * axis.along[k];
}

/* The shape as it was at the beginning, moved by a share of the way; one that is there already is replaced when that can be. */
static bat_status move_by(const bat_context *c, bat_shape_live *live, const bat_handle *grip,
                          const double delta[3], double share, const bat_shape_held *held, bat_shape **out) {
    static const double still[BAT_DIMENSION_MAX] = {0};
    const int level = bat_leveling_of(c)->level;
    double way[3] = {share * delta[0], share * delta[1], share * delta[2]};
    bat_shape *shape = NULL;
    bat_status status = bat_shape_live_move(live, 0, 1, still); /* as it was at the beginning */
    if (status == BAT_OK) status = bat_shape_copy(bat_shape_live_shape(live), &shape);
    if (status == BAT_OK) keep_on_axis(c, shape, grip, way);
    if (status == BAT_OK)
        status = grip->kind == BAT_HANDLE_POINT ? bat_shape_move_held(shape, level, grip->index, way, held)
                                                : bat_shape_drag_held(shape, level, grip->u, way, held);
    if (status == BAT_OK) status = bat_shape_commit(shape);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return status;
    }
    bat_shape_free(*out);
    *out = shape;
    return BAT_OK;
}

bat_status bat_leveling_move_held(const bat_context *c, bat_shape_live *live, const bat_handle *grip,
                                  const double delta[3], bat_shape **out) {
    double points[BAT_HELD_MAX], directions[BAT_HELD_MAX], near = 0, far = 1;
    const bat_shape_held held = held_now(c, points, directions);
    bat_status tried = move_by(c, live, grip, delta, 1, &held, out);
    if (tried != BAT_TOLERANCE) return tried;
    for (int i = 0; i < HALVINGS && (tried == BAT_OK || tried == BAT_TOLERANCE); i++) {
        const double share = (near + far) / 2;
        tried = move_by(c, live, grip, delta, share, &held, out);
        if (tried == BAT_OK)
            near = share;
        else
            far = share;
    }
    if (tried == BAT_OK || tried == BAT_TOLERANCE) return BAT_TOLERANCE;
    bat_shape_free(*out);
    *out = NULL;
    return tried;
}

bat_status bat_leveling_told_held(bat_context *c, bat_property_id id) {
    bat_mirror axis;
    if (id == BAT_PROPERTY_HOLD_SYMMETRY && c->settings->values[id] != 0 && bat_leveling_curve(c) &&
        !axis_now(c, &axis))
        bat_notice(c, BAT_STRING_NOTICE_NOT_SYMMETRIC);
    return BAT_OK;
}

static bool pin_seen(const bat_context *c, const bat_curve *curve, double u, double at[2]) {
    double place[BAT_DIMENSION_MAX];
    bat_curve_eval(curve, u, 0, place);
    return bat_stage_look(c->stage, bat_curve_dimension(curve), place, at);
}

void bat_leveling_pin(bat_context *c, double u) {
    bat_leveling *l = bat_leveling_of(c);
    const bat_curve *curve = bat_leveling_curve(c);
    double here[2], there[2];
    if (!curve || !bat_leveling_shape(c) || !pin_seen(c, curve, u, here)) return;
    l->version++;
    for (int i = 0; i < l->pin_count; i++) {
        if (!pin_seen(c, curve, l->pins[i].u, there) ||
            bat_hypot(there[0] - here[0], there[1] - here[1]) > REACH * bat_stage_pixel(c->stage))
            continue;
        if (l->pins[i].direction)
            memmove(l->pins + i, l->pins + i + 1, (size_t)(--l->pin_count - i) * sizeof *l->pins);
        else
            l->pins[i].direction = true;
        return;
    }
    if (l->pin_count == BAT_HELD_MAX)
        bat_notice(c, BAT_STRING_NOTICE_PINS_MANY);
    else
        l->pins[l->pin_count++] = (bat_pin){u, false};
}

/* A dashed line through the curve, and a bit beyond. */
static void show_axis(const bat_context *c, const bat_curve *curve, bat_overlay *list) {
    bat_mirror axis;
    double low = INFINITY, high = -INFINITY, from[2], to[2];
    if (!axis_now(c, &axis)) return;
    for (size_t i = 0; i < bat_curve_count(curve); i++) {
        const double s = bat_mirror_along(&axis, bat_curve_points(curve) + 2 * i);
        low = fmin(low, s), high = fmax(high, s);
    }
    const double beyond = BAR * bat_stage_pixel(c->stage);
    bat_mirror_place(&axis, low - beyond, from);
    bat_mirror_place(&axis, high + beyond, to);
    bat_overlay_item(list, BAT_ROLE_ARROW, BAT_ITEM_STROKED | BAT_ITEM_DASHED, 1);
    bat_overlay_page_line(list, from[0], from[1], to[0], to[1]);
}

void bat_leveling_show_pins(const bat_context *c, bat_overlay *list) {
    const bat_leveling *l = bat_leveling_of(c);
    const bat_curve *curve = bat_leveling_curve(c);
    const double pixel = bat_stage_pixel(c->stage);
    double at[2], jet[2 * BAT_DIMENSION_MAX], way[2];
    if (!curve) return;
    show_axis(c, curve, list);
    if (l->pin_count == 0) return;
    bat_overlay_item(list, BAT_ROLE_CHOSEN, BAT_ITEM_FILLED, 0);
    for (int i = 0; i < l->pin_count; i++)
        if (pin_seen(c, curve, l->pins[i].u, at)) bat_overlay_square(list, at, SIZE * pixel);
    bat_overlay_item(list, BAT_ROLE_ARROW, BAT_ITEM_STROKED, 1.5F);
    for (int i = 0; i < l->pin_count; i++) {
        if (!l->pins[i].direction || !pin_seen(c, curve, l->pins[i].u, at)) continue;
        const int n = bat_curve_dimension(curve);
        bat_curve_eval(curve, l->pins[i].u, 1, jet);
        bat_stage_look_along(c->stage, n, jet, jet + n, way);
        const double length = bat_hypot(way[0], way[1]), far = length > 0 ? BAR * pixel / length : 0;
        bat_path_move(&list->path, at[0] - far * way[0], at[1] - far * way[1]);
        bat_path_line(&list->path, at[0] + far * way[0], at[1] + far * way[1]);
    }
}
