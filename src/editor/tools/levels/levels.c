/*
 * The levels tool. It shows the active level's control polygon for the chosen curve. Its control points can be
 * dragged directly; the curve can be dragged anywhere, and the active level bends so that the point under the pen
 * follows, with the details above riding along. A tap chooses another curve, or, while detail is being copied, the
 * curve that receives it. A curve that is being taken apart is previewed until Enter or Esc.
 *
 * IDLE --down--> pressed --moved--> dragging (a transaction is open) --up--> IDLE (one step); pressed --up--> a tap.
 * cancel: reverts a drag, or else drops taking apart or copying.
 */
#include "base/vec.h"
#include "curve/curve.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/stroke.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/pick/snap.h"
#include "editor/pick/surface.h"
#include "editor/scene/path.h"
#include "editor/scene/scene.h"
#include "editor/scene/seen.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/show/handles.h"
#include "editor/show/overlay.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/levels/state.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"
#include "editor/view/way.h"
#include "base/real.h"
#include "editor/pick/pick.h"
#include "editor/edit/curves_of.h"
#include <batten/measure.h>
#include <batten/relief.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double HANDLE_REACH = 9, CURVE_REACH = 10, HANDLE_LEAD = 5, TAP = 4; /* px */
static const double TOUCH = 2.2;                /* factor on the reach for fingers */
static const double CLOSE = 0.02;               /* px between the pen and the point it drags */
static const double AXIS = 18, AXES_APART = 26; /* px: length of an axis; distance between frames */
enum { AXES_MAX = 400 };

static double reach(const bat_context *c, double pixels) {
    return pixels * (bat_leveling_of(c)->device == BAT_DEVICE_TOUCH ? TOUCH : 1) * bat_stage_pixel(c->stage);
}

/* The control polygon whose points can be dragged. */
static const bat_curve *active(const bat_context *c) {
    const bat_shape *shape = bat_leveling_shape(c);
    return shape && !bat_ladder_any(bat_leveling_of(c)->apart)
               ? bat_shape_curve(shape, bat_leveling_of(c)->level)
               : NULL;
}

static double near_point(const bat_curve *curve, const bat_stage *stage, const double at[2], int *index) {
    double best = INFINITY, seen[2];
    for (int i = 0; i < bat_point_count(curve); i++) {
        bat_handle_seen(curve, stage, &(bat_handle){.kind = BAT_HANDLE_POINT, .index = i}, seen);
        double d = bat_hypot(seen[0] - at[0], seen[1] - at[1]);
        if (d < best) best = d, *index = i;
    }
    return best;
}

/* What a press here would grab: points of the active level before curves, but a curve under the pen before a point
 * beside it. */
static bat_handle find(bat_context *c, const double pixel[2]) {
    const bat_leveling *l = bat_leveling_of(c);
    double point[2];
    bat_seen_sync(c);
    bat_stage_seen(c->stage, pixel, point);
    bat_pick pick = bat_pick_curve(c->scene, 0, point, reach(c, CURVE_REACH));
    const bat_curve *polygon = l->copying ? NULL : active(c);
    int index = 0;
    double distance = polygon ? near_point(polygon, c->stage, point, &index) : INFINITY;
    if (distance <= reach(c, HANDLE_REACH) &&
        (!pick.object || distance <= pick.near.distance + reach(c, HANDLE_LEAD)))
        return (bat_handle){BAT_HANDLE_POINT, l->object, l->curve, index, 0};
    if (!pick.object) {
        const bat_object *solid = bat_pick_surface(c, pixel);
        if (solid) pick.object = bat_object_id(solid), pick.curve = 0;
    }
    if (!pick.object) return (bat_handle){0};
    return (bat_handle){BAT_HANDLE_CURVE, pick.object, pick.curve, 0, pick.near.u};
}

/* ---- dragging ---- */

/* Moves the grip of the session's shape by delta from its original position. */
static bat_status moved(const bat_context *c, bat_shape_live *live, const bat_handle *grip,
                        const double delta[3]) {
    if (grip->kind == BAT_HANDLE_POINT) return bat_shape_live_move(live, grip->index, 1, delta);
    bat_status status = bat_shape_live_drag_finest(live, grip->u, delta, CLOSE * bat_stage_pixel(c->stage),
                                                   NULL);
    /* Where the details turn faster than the sweep moves, only the sweep follows. */
    return status == BAT_TOLERANCE ? bat_shape_live_drag(live, grip->u, delta) : status;
}

/* The same, as a separate shape. */
static bat_status edited(const bat_context *c, bat_shape_live *live, const bat_handle *grip,
                         const double delta[3], bat_shape **out) {
    bat_shape *shape = NULL;
    if (bat_leveling_holds(c)) return bat_leveling_move_held(c, live, grip, delta, out);
    bat_status status = moved(c, live, grip, delta);
    if (status == BAT_OK) status = bat_shape_copy(bat_shape_live_shape(live), &shape);
    if (status == BAT_OK) status = bat_shape_commit(shape);
    if (status != BAT_OK)
        bat_shape_free(shape);
    else
        *out = shape;
    return status;
}

static void tell(bat_context *c, bat_status status) {
    if (status == BAT_STATE)
        bat_notice(c, BAT_STRING_NOTICE_MUTED);
    else if (status == BAT_TOLERANCE)
        bat_notice(c, BAT_STRING_NOTICE_HELD);
    else if (status == BAT_SINGULAR && c->settings->values[BAT_PROPERTY_HOLD_SYMMETRY] != 0)
        bat_notice(c, BAT_STRING_NOTICE_LEVEL_UNEVEN);
    else if (status != BAT_OK)
        bat_notice_failure(c, status);
}

static void release(bat_leveling *l) {
    bat_shape_live_cancel(l->live);
    bat_bent_along_free(l->followers);
    bat_relief_free(l->carved);
    l->live = NULL, l->followers = NULL, l->carved = NULL;
    l->pressed = l->dragging = l->due = false;
}

static void give_up(bat_context *c, bat_status status) {
    release(bat_leveling_of(c));
    bat_transaction_cancel(c);
    tell(c, status);
}

/* From the press to the pen; Alt: along the curve's normal. False: the pen cannot tell. */
static bool drag_delta(bat_context *c, const bat_leveling *l, double delta[3]) {
    double from[2], to[2];
    const bat_curve *curve = bat_shape_curve(bat_shape_live_shape(l->live), 0);
    const bool rises = (c->modifiers & BAT_ALT) && bat_curve_dimension(curve) == 3;
    c->snap->kind = BAT_SNAP_NONE;
    if (!bat_stage_way(c->stage, curve, l->start, l->at, rises, delta)) return false;
    if ((c->modifiers & BAT_ALT) && !rises && (l->normal[0] != 0 || l->normal[1] != 0)) {
        const double along = delta[0] * l->normal[0] + delta[1] * l->normal[1];
        for (int k = 0; k < 2; k++) delta[k] = along * l->normal[k];
        return true;
    }
    if (!(c->modifiers & BAT_SHIFT) || bat_stage_tilted(c->stage) || rises) return true;
    bat_stage_seen(c->stage, l->start, from);
    bat_stage_seen(c->stage, l->at, to);
    bat_snap_angle(c, from, to);
    for (int k = 0; k < 2; k++) delta[k] = to[k] - from[k];
    return true;
}

static void drag(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    double delta[3];
    if (!l->dragging || !l->due) return;
    l->due = false;
    if (l->carved) {
        const bat_status pulled = bat_relief_pull(c);
        if (pulled != BAT_OK) give_up(c, pulled);
        return;
    }
    if (!drag_delta(c, l, delta)) return;
    bat_shape *shape = NULL;
    const bat_status held = edited(c, l->live, &l->grip, delta, &shape);
    bat_status status = held == BAT_TOLERANCE ? BAT_OK : held;
    if (status == BAT_OK && shape) status = bat_leveling_put(c, shape);
    if (status == BAT_OK && shape) status = bat_bent_along_move(c, l->followers);
    if (status != BAT_OK)
        give_up(c, status);
    else if (held == BAT_TOLERANCE)
        tell(c, held);
}

/* The normal of a curve in the plane where it is gripped: at a control point, where that point pulls most. */
static void find_normal(bat_leveling *l) {
    const bat_shape *shape = bat_shape_live_shape(l->live);
    const bool point = l->grip.kind == BAT_HANDLE_POINT;
    const bat_curve *curve = bat_shape_curve(shape, point ? l->level : bat_shape_levels(shape));
    double u = l->grip.u, there[4]; /* the place, and the tangent */
    l->normal[0] = l->normal[1] = 0;
    if (bat_curve_dimension(curve) != 2) return;
    if (point) {
        double *all = malloc(bat_curve_count(curve) * sizeof *all);
        if (!all) return;
        bat_curve_greville(curve, all);
        u = all[l->grip.index];
        free(all);
    }
    bat_curve_eval(curve, u, 1, there);
    const double speed = bat_hypot(there[2], there[3]);
    if (!(speed > 0)) return;
    l->normal[0] = -there[3] / speed;
    l->normal[1] = there[2] / speed;
}

/* The curve of the object that is chosen with it; a surface is chosen as a whole. */
static int curve_of(const bat_context *c, const bat_handle *grip) {
    const bat_document *document = c->session->document;
    const bat_object *object = bat_document_at(document, bat_document_find(document, grip->object));
    return object && bat_object_surface(object) ? 0 : grip->curve;
}

static void begin_drag(bat_context *c) {
    bat_leveling *l = bat_leveling_of(c);
    const bool among = bat_selection_has(&c->choice->selection, l->grip.object);
    bat_apart_drop(c);
    (among ? bat_leveling_take : bat_leveling_choose)(c, l->grip.object, curve_of(c, &l->grip));
    bat_leveling_settle(c);
    const bat_shape *shape = bat_leveling_shape(c);
    if (!shape && !bat_leveling_relief(c)) { /* nothing can bend it */
        l->pressed = false;
        bat_notice(c, BAT_STRING_NOTICE_NO_LEVELS);
        return;
    }
    bat_status status = shape ? bat_shape_live_begin(shape, l->level, &l->live) : bat_relief_grip(c);
    if (status == BAT_OK && shape) status = bat_bent_along_gather(c, &l->followers);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        release(l);
        tell(c, status);
        return;
    }
    if (l->grip.kind == BAT_HANDLE_POINT) l->chosen = l->grip.index;
    if (l->live) find_normal(l);
    l->dragging = true;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    (void)state;
    bat_leveling *l = bat_leveling_of(c);
    bat_leveling_settle(c);
    l->device = event->device;
    l->hovering = true;
    l->hover[0] = l->start[0] = l->at[0] = event->x;
    l->hover[1] = l->start[1] = l->at[1] = event->y;
    l->grip = l->hot = find(c, l->start);
    l->pressed = true;
    l->dragging = l->due = false;
    bat_notice(c, BAT_STRING_COUNT);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    (void)state;
    bat_leveling *l = bat_leveling_of(c);
    if (!l->pressed || event->predicted) return;
    l->at[0] = l->hover[0] = event->x;
    l->at[1] = l->hover[1] = event->y;
    l->due = true;
    bool far = bat_hypot(l->at[0] - l->start[0], l->at[1] - l->start[1]) > TAP;
    if (!l->dragging && far && l->grip.kind && !l->copying) begin_drag(c);
}

static void tap(bat_context *c, const bat_pointer *event) {
    bat_leveling *l = bat_leveling_of(c);
    const bat_handle grip = l->grip;
    const int curve = curve_of(c, &grip);
    bool same = grip.object == l->object && curve == l->curve;
    const bool twice = bat_double_tap_ends(&l->tap, event);
    if (twice && same && !l->copying && grip.kind == BAT_HANDLE_CURVE && !bat_ladder_any(l->apart)) {
        bat_leveling_pin(c, grip.u);
        return;
    }
    if (l->copying) {
        if (!grip.object || same) return;
        l->copying = false;
        bat_leveling_copy_to(c, grip.object, curve);
        return;
    }
    if (bat_ladder_any(l->apart) && same) return;
    bat_apart_drop(c);
    bat_leveling_choose(c, grip.object, curve);
    l->chosen = grip.kind == BAT_HANDLE_POINT ? grip.index : -1;
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    (void)state;
    bat_leveling *l = bat_leveling_of(c);
    if (!l->pressed) return;
    drag(c);
    if (!l->pressed) return; /* it failed */
    bool dragged = l->dragging;
    bat_string label = l->grip.kind == BAT_HANDLE_POINT ? BAT_STRING_STEP_LEVEL_POINT
                                                        : BAT_STRING_STEP_LEVEL_PULL;
    release(l);
    if (!dragged)
        tap(c, event);
    else
        tell(c, bat_transaction_commit(c, label, NULL));
}

static bool undo(bat_context *c, void *state) {
    (void)state;
    bat_leveling *l = bat_leveling_of(c);
    if (!l->dragging) return bat_apart_drop(c);
    release(l);
    bat_transaction_cancel(c);
    bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
    return true;
}

/* The chosen curve stays chosen for the other tools; the command then deselects it. */
static bool cancel(bat_context *c, void *state) {
    (void)state;
    bat_leveling *l = bat_leveling_of(c);
    if (l->pressed && !l->dragging) { /* a finger of a pinch, say: what awaits confirmation stays */
        release(l);
        return true;
    }
    if (undo(c, state)) return true;
    bool any = l->copying;
    l->copying = false;
    return any;
}

/* ---- the keyboard ---- */

static bat_status step(bat_context *c, int direction) {
    bat_leveling *l = bat_leveling_of(c);
    bat_seen_sync(c);
    for (int i = 0; i < bat_document_count(c->session->document) && !l->object;
         i++) { /* the first curve of all */
        bat_id id = bat_object_id(bat_document_at(c->session->document, i));
        if (bat_edit_target_in(c->session->document, 0, id, 0) && !bat_seen_out_of_reach(c, i))
            bat_leveling_choose(c, id, 0);
    }
    const bat_curve *polygon = active(c);
    if (!polygon) return l->object ? BAT_OK : BAT_STATE;
    int count = bat_point_count(polygon), at = l->chosen + direction;
    if (l->chosen < 0) at = direction > 0 ? 0 : count - 1;
    l->chosen = at < 0 || at >= count ? -1 : at; /* the keyboard focus moves on to what follows the drawing */
    return l->chosen < 0 ? BAT_STATE : BAT_OK;
}

/* As one step; takes the shape over, whatever it returns. */
static bat_status commit_with_followers(bat_context *c, bat_shape *shape) {
    bat_bent_along *followers = NULL;
    bat_status status = bat_bent_along_gather(c, &followers);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_shape_free(shape);
    } else {
        status = bat_leveling_put(c, shape);
        if (status == BAT_OK) status = bat_bent_along_move(c, followers);
        status = bat_transaction_end(c, status, BAT_STRING_STEP_LEVEL_POINT);
    }
    bat_bent_along_free(followers);
    return status;
}

static bat_status nudge(bat_context *c, double x, double y) {
    bat_leveling *l = bat_leveling_of(c);
    if (l->chosen < 0 || !active(c)) return BAT_STATE;
    const double far = c->modifiers & BAT_SHIFT ? 10 : 1;
    double delta[3] = {x * far * bat_stage_pixel(c->stage), y * far * bat_stage_pixel(c->stage), 0};
    if (bat_stage_tilted(c->stage) &&
        !bat_stage_way(c->stage, active(c), (double[]){0, 0}, (double[]){x * far, y * far}, false, delta))
        return BAT_STATE;
    const bat_handle grip = {BAT_HANDLE_POINT, l->object, l->curve, l->chosen, 0};
    bat_shape_live *live = NULL;
    bat_shape *shape = NULL;
    bat_status status = bat_shape_live_begin(bat_leveling_shape(c), l->level, &live);
    if (status == BAT_OK) status = edited(c, live, &grip, delta, &shape);
    bat_shape_live_cancel(live);
    if (status == BAT_OK)
        status = commit_with_followers(c, shape);
    else
        bat_shape_free(shape);
    tell(c, status);
    return status == BAT_STATE || status == BAT_TOLERANCE
               ? BAT_OK
               : status; /* muted, held: BAT_OK keeps the key from moving the view */
}

/* At the chosen control point. */
static bat_status pin(bat_context *c) {
    const bat_leveling *l = bat_leveling_of(c);
    const bat_curve *polygon = active(c);
    if (l->chosen < 0 || !polygon) return BAT_STATE;
    bat_leveling_pin(c, bat_handle_greville(polygon, l->chosen));
    return BAT_OK;
}

static bat_status command(bat_context *c, void *state, bat_command_id id) {
    (void)state;
    bat_leveling_settle(c);
    switch (id) {
    case BAT_COMMAND_POINT_NEXT: return step(c, 1);
    case BAT_COMMAND_POINT_PREVIOUS: return step(c, -1);
    case BAT_COMMAND_POINT_ADD: return pin(c);
    case BAT_COMMAND_NUDGE_LEFT: return nudge(c, -1, 0);
    case BAT_COMMAND_NUDGE_RIGHT: return nudge(c, 1, 0);
    case BAT_COMMAND_NUDGE_UP: return nudge(c, 0, -1);
    case BAT_COMMAND_NUDGE_DOWN: return nudge(c, 0, 1);
    default: return BAT_STATE;
    }
}

/* ---- hover and picture ---- */

static void hover(bat_context *c, void *state, const bat_pointer *event) {
    (void)state;
    bat_leveling *l = bat_leveling_of(c);
    l->hovering = true;
    l->device = event->device;
    l->hover[0] = event->x;
    l->hover[1] = event->y;
}

static void leave(bat_context *c, void *state) {
    (void)state;
    bat_leveling_of(c)->hovering = false;
    bat_leveling_of(c)->hot = (bat_handle){0};
}

static void modifiers(bat_context *c, void *state) {
    (void)state;
    bat_leveling_of(c)->due = bat_leveling_of(c)->dragging;
}
static bool busy(const bat_context *c, const void *state) {
    (void)state;
    return bat_leveling_of(c)->pressed;
}

static void update(bat_context *c, void *state) {
    (void)state;
    bat_leveling *l = bat_leveling_of(c);
    if (!l->dragging) bat_leveling_settle(c);
    drag(c);
    if (!l->pressed) l->hot = l->hovering ? find(c, l->hover) : (bat_handle){0};
}

static void line(bat_overlay *list, bat_role role, float width, const bat_curve *curve) {
    bat_overlay_item(list, role, BAT_ITEM_STROKED, width);
    bat_path_curve(&list->path, curve);
}

/* Shows one axis of the frames at the nodes of the level above, thinned so that the marks stay distinguishable. */
static void show_axis(const bat_context *c, bat_overlay *list, bat_role role, size_t count,
                      const bat_frame3 *frames, bool across) {
    double pixel = bat_stage_pixel(c->stage), last[2] = {INFINITY, INFINITY};
    bat_overlay_item(list, role, BAT_ITEM_STROKED, 1.5F);
    for (size_t i = 0; i < count; i++) {
        const double *v = across ? frames[i].s : frames[i].t;
        double p[2], tip[3], end[2];
        for (int k = 0; k < 3; k++) tip[k] = frames[i].point[k] + AXIS * pixel * v[k];
        bat_stage_look(c->stage, 3, frames[i].point, p);
        bat_stage_look(c->stage, 3, tip, end);
        if (bat_hypot(p[0] - last[0], p[1] - last[1]) < AXES_APART * pixel) continue;
        last[0] = p[0], last[1] = p[1];
        bat_path_move(&list->path, p[0], p[1]);
        bat_path_line(&list->path, end[0], end[1]);
    }
}

static void show_frames(const bat_context *c, bat_overlay *list, const bat_shape *shape) {
    int top = bat_shape_levels(shape),
        level = bat_leveling_of(c)->level < top ? bat_leveling_of(c)->level : top - 1;
    if (level < 0) return;
    const bat_shape_options *o = bat_shape_options_of(shape);
    bat_frame_options options = bat_frame_defaults();
    const bat_curve *curve = bat_shape_curve(shape, level);
    double domain[2];
    bat_curve_domain(curve, domain);
    options.rule = o->frame;
    double *u = malloc(AXES_MAX * sizeof *u);
    bat_frame3 *frames = malloc(AXES_MAX * sizeof *frames);
    for (int i = 0; u && i < AXES_MAX; i++) u[i] = domain[0] + (domain[1] - domain[0]) * i / AXES_MAX;
    if (u && frames && bat_frames(curve, AXES_MAX, u, &options, frames, NULL) == BAT_OK) {
        show_axis(c, list, BAT_ROLE_ARROW, AXES_MAX, frames, false);
        show_axis(c, list, BAT_ROLE_GUIDE, AXES_MAX, frames, true);
    }
    free(u);
    free(frames);
}

static void show_levels(const bat_context *c, bat_overlay *list, const bat_shape *shape, int level,
                        bool all) {
    for (int k = 0; all && k <= bat_shape_levels(shape); k++)
        if (k != level) line(list, BAT_ROLE_GHOST, 1, bat_shape_curve(shape, k));
    const bat_curve *curve = bat_shape_curve(shape, level);
    if (level < bat_shape_levels(shape)) line(list, BAT_ROLE_FIT, 1.5F, curve);
    bat_handles_show_points(list, curve, c->stage);
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    (void)state;
    const bat_leveling *l = bat_leveling_of(c);
    const bat_shape *shape = l->apart.shape ? l->apart.shape : bat_leveling_shape(c);
    const bat_handle *hot = l->dragging ? &l->grip : &l->hot;
    const bat_curve *chosen = bat_leveling_curve(c), *under = NULL;
    if (hot->object && !c->input->holding_pan)
        under = bat_edit_target_in(c->session->document, 0, hot->object, hot->curve);
    if (under && under != chosen) line(list, BAT_ROLE_HIGHLIGHT, 3, under);
    bat_relief_show(c, list);
    if (!shape) return;
    int level = l->apart.shape ? 0 : l->level;
    const bat_curve *curve = bat_shape_curve(shape, level);
    if (under && under == chosen && !l->apart.shape && !l->copying && hot->kind == BAT_HANDLE_CURVE) {
        double range[2]; /* the part that would bend */
        bat_knots_reached(curve, hot->u, range);
        bat_overlay_item(list, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, 4);
        bat_overlay_stretch(list, under, range[0], range[1]);
    }
    show_levels(c, list, shape, level, l->apart.shape || c->settings->values[BAT_PROPERTY_SHOW_LEVELS] != 0);
    if (c->settings->values[BAT_PROPERTY_SHOW_FRAMES] != 0) show_frames(c, list, shape);
    bat_leveling_show_pins(c, list);
    bat_handle one = {BAT_HANDLE_POINT, l->object, l->curve, l->chosen, 0};
    if (l->chosen >= 0 && !l->apart.shape) bat_handles_show_one(list, curve, &one, BAT_ROLE_CHOSEN, c->stage);
    if (under && hot->kind == BAT_HANDLE_POINT && hot->index != l->chosen)
        bat_handles_show_one(list, curve, hot, BAT_ROLE_HANDLE, c->stage);
}

static bat_string hint(const bat_context *c, const void *state) {
    (void)state;
    const bat_leveling *l = bat_leveling_of(c);
    if (l->dragging) return BAT_STRING_HINT_DRAGGING;
    if (l->copying) return BAT_STRING_HINT_COPY_TO;
    if (bat_ladder_any(l->apart)) return BAT_STRING_HINT_APART;
    if (l->hot.kind == BAT_HANDLE_POINT) return BAT_STRING_HINT_CONTROL_POINT;
    bool own = l->hot.object && l->hot.object == l->object && curve_of(c, &l->hot) == l->curve;
    if (l->hot.kind && !own) return BAT_STRING_HINT_CHOOSE;
    if (!l->object) return BAT_STRING_HINT_LEVELS;
    return bat_ladder_any(bat_leveling_ladder(c)) ? BAT_STRING_HINT_LEVEL_PULL : BAT_STRING_HINT_LEVELS_NONE;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)state;
    const bat_leveling *l = bat_leveling_of(c);
    if (l->copying) return BAT_CURSOR_PEN;
    return l->dragging || l->hot.kind ? BAT_CURSOR_MOVE : BAT_CURSOR_ARROW;
}

static const char *check(const bat_context *c, const void *state) {
    (void)state;
    const bat_leveling *l = bat_leveling_of(c);
    const bat_ladder ladder = bat_leveling_ladder(c);
    if (l->dragging && !l->pressed) return "a drag without a press";
    if (l->dragging != (l->live || l->carved)) return "a drag without its session, or the reverse";
    if (l->fading != bat_ladder_any(l->base)) return "a fader without its shape, or the reverse";
    if (l->dragging && !c->session->transaction.open) return "a drag without a transaction";
    if (l->pressed && bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a press without a pointer";
    if (l->dragging && (!bat_ladder_any(ladder) || l->level > bat_ladder_levels(ladder)))
        return "a level is dragged that is not there";
    return NULL;
}

static void begin(void *state) { ((bat_leveling *)state)->chosen = -1; }

static void end(void *state) {
    bat_bent_along_free(((bat_leveling *)state)->followers);
    bat_leveling_free(state);
}

static bool held_by_panel(const void *state) { return ((const bat_leveling *)state)->fading; }

static void let_go(bat_context *c, void *state) {
    (void)state;
    bat_leveling_let_go(c);
}

static bool focus(const bat_context *c, const void *state, bat_focus *out) {
    (void)c;
    const bat_leveling *l = state;
    *out = (bat_focus){l->object, l->curve, l->level};
    return l->object != 0;
}

static bool accept(bat_context *c, void *state) {
    (void)state;
    return bat_apart_accept(c);
}

const bat_tool *bat_tool_levels(void) {
    static const bat_tool tool = {.size = sizeof(bat_leveling),
                                  .begin = begin,
                                  .end = end,
                                  .held_by_panel = held_by_panel,
                                  .let_go = let_go,
                                  .focus = focus,
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .accept = accept,
                                  .undo = undo,
                                  .command = command,
                                  .modifiers = modifiers,
                                  .busy = busy,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = hint,
                                  .cursor = cursor,
                                  .check = check};
    return &tool;
}
