/* The levels tool: what stays while a level is dragged. Length and area by their switches, places by pins; a pin that is put twice holds
 * the direction, too, and the third time it is gone. */
#include "base/real.h"
#include "curve/curve.h"
#include "editor/scene/path.h"
#include "editor/session/notice.h"
#include "editor/tables/settings.h"
#include "editor/tools/levels/state.h"
#include "editor/view/stage.h"
#include <math.h>
#include <string.h>

static const double REACH = 12, SIZE = 4,
                    BAR = 16; /* px: to a pin; its half; half the direction that is held */

/* What is held of the chosen curve; room: for the parameters. */
static bat_shape_held held_now(const bat_context *c, double points[BAT_HELD_MAX],
                               double directions[BAT_HELD_MAX]) {
    const bat_leveling *l = bat_leveling_of(c);
    const bat_curve *curve = bat_leveling_curve(c);
    bat_shape_held held = {.points = points, .directions = directions};
    if (!curve) return held;
    held.length = c->settings->values[BAT_PROPERTY_HOLD_LENGTH] != 0;
    held.area = c->settings->values[BAT_PROPERTY_HOLD_AREA] != 0 && bat_curve_is_closed(curve) &&
                bat_curve_dimension(curve) == 2;
    for (int i = 0; i < l->pin_count; i++) {
        points[held.point_count++] = l->pins[i].u;
        if (l->pins[i].direction) directions[held.direction_count++] = l->pins[i].u;
    }
    return held;
}

bool bat_leveling_holds(const bat_context *c) {
    double points[BAT_HELD_MAX], directions[BAT_HELD_MAX];
    const bat_shape_held held = held_now(c, points, directions);
    return held.length || held.area || held.point_count > 0;
}

bat_status bat_leveling_move_held(const bat_context *c, bat_shape_live *live, const bat_handle *grip,
                                  const double delta[3], bat_shape **out) {
    static const double still[BAT_DIMENSION_MAX] = {0};
    double points[BAT_HELD_MAX], directions[BAT_HELD_MAX];
    const bat_shape_held held = held_now(c, points, directions);
    const int level = bat_leveling_of(c)->level;
    bat_shape *shape = NULL;
    bat_status status = bat_shape_live_move(live, 0, 1, still); /* as it was at the beginning */
    if (status == BAT_OK) status = bat_shape_copy(bat_shape_live_shape(live), &shape);
    if (status == BAT_OK)
        status = grip->kind == BAT_HANDLE_POINT ? bat_shape_move_held(shape, level, grip->index, delta, &held)
                                                : bat_shape_drag_held(shape, level, grip->u, delta, &held);
    if (status == BAT_OK) status = bat_shape_commit(shape);
    if (status == BAT_OK)
        *out = shape;
    else
        bat_shape_free(shape);
    return status;
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

void bat_leveling_show_pins(const bat_context *c, bat_overlay *list) {
    const bat_leveling *l = bat_leveling_of(c);
    const bat_curve *curve = bat_leveling_curve(c);
    const double pixel = bat_stage_pixel(c->stage);
    double at[2], jet[2 * BAT_DIMENSION_MAX], way[2];
    if (!curve || l->pin_count == 0) return;
    bat_overlay_item(list, BAT_ROLE_CHOSEN, BAT_ITEM_FILLED, 0);
    for (int i = 0; i < l->pin_count; i++)
        if (pin_seen(c, curve, l->pins[i].u, at)) bat_overlay_square(list, at, SIZE * pixel);
    bat_overlay_item(list, BAT_ROLE_CHOSEN, BAT_ITEM_STROKED, 1.5F);
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
