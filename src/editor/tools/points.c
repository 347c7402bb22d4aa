/*
 * The points tool. Shows control polygon, control points and knots of the chosen curve (or else the one under the
 * pen). Control points can be dragged directly, with smooth nodes kept smooth unless Alt is held; the curve can be
 * dragged anywhere by direct manipulation, while its ends and a chosen knot stay in place. A double tap inserts a
 * knot, Delete removes one.
 *
 * IDLE --down--> pressed --moved--> dragging (a transaction is open) --up--> IDLE (one step); pressed --up--> a tap,
 * which chooses. cancel: reverts a drag or drops a press; otherwise deselects.
 */
#include "base/vec.h"
#include "curve/curve.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/stroke.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/pick/snap.h"
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
#include "editor/tools/points.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"
#include "editor/view/unit.h"
#include "editor/view/stage.h"
#include "editor/view/way.h"
#include "base/real.h"
#include "editor/pick/pick.h"
#include "editor/edit/pull.h"
#include "editor/edit/smooth_node.h"
#include "editor/edit/curves_of.h"
#include <batten/measure.h>
#include <batten/refine.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double HANDLE_REACH = 9, CURVE_REACH = 10, HANDLE_LEAD = 5; /* px */
static const double TOUCH = 2.2;                                         /* factor on the reach for fingers */
static const double TAP = 4, DOUBLE_TAP = 400;                           /* px, ms */
static const float STRETCH_WIDTH = 4, HIGHLIGHT_WIDTH = 3;

static double reach(const bat_context *c, const bat_pointing *p, double pixels) {
    double factor = p->device == BAT_DEVICE_TOUCH ? TOUCH : 1;
    return pixels * factor * bat_stage_pixel(c->stage);
}

/* The chosen curve; NULL when there is none or it is gone. */
static const bat_curve *chosen_curve(const bat_context *c, const bat_pointing *p) {
    return p->object ? bat_edit_target_in(c->session->document, 0, p->object, p->curve) : NULL;
}

static void choose_nothing(bat_pointing *p) {
    p->chosen = (bat_handle){0};
    p->measured = false;
}

/* Takes over, once, what has been selected elsewhere. */
static void adopt(bat_context *c, bat_pointing *p) {
    if (c->choice->selection.count != 1 || c->choice->selection.ids[0] == p->adopted) return;
    p->object = p->adopted = c->choice->selection.ids[0];
    p->curve = 0;
    choose_nothing(p);
}

/* Undo and other commands may have removed what was chosen. */
static void settle(bat_context *c, bat_pointing *p) {
    adopt(c, p);
    const bat_curve *curve = chosen_curve(c, p);
    if (!curve || bat_seen_out_of_reach(c, bat_document_find(c->session->document, p->object))) {
        p->object = 0;
        choose_nothing(p);
        return;
    }
    if (p->chosen.kind == BAT_HANDLE_POINT && p->chosen.index >= bat_point_count(curve)) choose_nothing(p);
    if (p->chosen.kind == BAT_HANDLE_KNOT && !bat_knot_held(curve, p->chosen.u)) choose_nothing(p);
    if (p->chosen.kind != BAT_HANDLE_KNOT) p->measured = false;
}

static bool same(const bat_handle *a, const bat_handle *b) {
    return a->kind == b->kind && a->object == b->object && a->curve == b->curve && a->index == b->index &&
           a->u == b->u;
}

static void choose_curve(bat_context *c, bat_pointing *p, bat_id object, int curve) {
    if (p->object != object || p->curve != curve) choose_nothing(p);
    p->object = object;
    p->curve = curve;
    p->adopted = object;
    bat_selection_clear(&c->choice->selection);
    if (object) bat_selection_add(&c->choice->selection, object); /* out of memory: not selected */
}

/* Whether the handle is an end control point of an open curve, which fixes its end. */
static bool is_end(const bat_curve *curve, const bat_handle *handle) {
    bool last = handle->index == 0 || handle->index == bat_point_count(curve) - 1;
    return handle->kind == BAT_HANDLE_POINT && last && !bat_curve_is_closed(curve);
}

/* The handle at the point. A handle beside the curve yields to the curve when the pen is on the curve: otherwise the
 * curve could not be pulled where its control polygon is close to it. */
static bool handle_at(const bat_context *c, const bat_pointing *p, const bat_curve *curve,
                      const double point[2], const bat_pick *pick, bat_handle *out) {
    double at[2];
    if (!bat_handle_find(curve, c->stage, point, reach(c, p, HANDLE_REACH), out)) return false;
    if (!pick->object || is_end(curve, out)) return true;
    bat_handle_seen(curve, c->stage, out, at);
    double distance = bat_hypot(at[0] - point[0], at[1] - point[1]);
    return distance <= pick->near.distance + reach(c, p, HANDLE_LEAD);
}

/* What a press here would grab: handles of the displayed curve before curves. */
static bat_handle find(bat_context *c, bat_pointing *p, const double pixel[2]) {
    double point[2];
    bat_handle handle = {0};
    bat_seen_sync(c);
    bat_stage_seen(c->stage, pixel, point);
    bat_pick pick = bat_pick_curve(c->scene, 0, point, reach(c, p, CURVE_REACH));
    const bat_curve *curve = chosen_curve(c, p);
    if (curve && handle_at(c, p, curve, point, &pick, &handle)) {
        handle.object = p->object;
        handle.curve = p->curve;
        return handle;
    }
    if (!pick.object) return (bat_handle){0};
    curve = bat_edit_target_in(c->session->document, 0, pick.object, pick.curve);
    if (!curve || !handle_at(c, p, curve, point, &pick, &handle)) {
        handle.kind = BAT_HANDLE_CURVE;
        handle.index = 0;
        handle.u = pick.near.u;
    }
    handle.object = pick.object;
    handle.curve = pick.curve;
    return handle;
}

/* ---- dragging ---- */

/* Whether the control point belongs to a smooth node that is to stay smooth. */
static bool is_tied(const bat_pointing *p, const bat_curve *curve, const bat_handle *handle) {
    bat_smooth_node node;
    if (!bat_smooth_node_of(curve, handle->index, &node)) return false;
    return !p->corner.kind || handle->object != p->corner.object || handle->curve != p->corner.curve ||
           node.u != p->corner.u;
}

static bat_status moved(const bat_context *c, const bat_pointing *p, const bat_curve *base,
                        const bat_handle *grip, const double delta[3], bat_curve **out) {
    const bat_handle *held = &p->chosen;
    bool alone = c->modifiers & BAT_ALT || !is_tied(p, base, grip);
    if (grip->kind == BAT_HANDLE_POINT) return bat_pull_point(base, grip->index, delta, alone, out);
    double u[2] = {grip->u, held->u}, deltas[2 * BAT_DIMENSION_MAX] = {0};
    memcpy(deltas, delta, (size_t)bat_curve_dimension(base) * sizeof *delta);
    bool holds = held->kind == BAT_HANDLE_KNOT && held->object == grip->object &&
                 held->curve == grip->curve && held->u != grip->u;
    bat_status status = holds ? bat_pull(base, 2, u, deltas, out) : BAT_SINGULAR;
    return status == BAT_SINGULAR ? bat_pull(base, 1, u, deltas, out) : status;
}

/* From the press to the pen, document units; face-on the grip snaps on the page, Shift constrains to angle steps. False:
 * the pen cannot tell. */
static bool drag_delta(bat_context *c, bat_pointing *p, double delta[3]) {
    double from[2], to[2], held[3];
    int own = bat_document_find(c->session->document, p->grip.object);
    if (bat_stage_tilted(c->stage) || bat_curve_dimension(p->base) != 2) {
        c->snap->kind = BAT_SNAP_NONE;
        return bat_stage_way(c->stage, p->base, p->start, p->at, false, delta);
    }
    bat_stage_seen(c->stage, p->start, from);
    bat_stage_seen(c->stage, p->at, to);
    bat_handle_place(p->base, &p->grip, held);
    double place[2] = {held[0] + to[0] - from[0], held[1] + to[1] - from[1]};
    if (c->modifiers & BAT_SHIFT)
        bat_snap_angle(c, held, place);
    else
        bat_snap_point(c, 1, &own, place);
    delta[0] = place[0] - held[0];
    delta[1] = place[1] - held[1];
    return true;
}

static void release(bat_pointing *p) {
    bat_curve_free(p->base);
    p->base = NULL;
    p->pressed = p->dragging = p->due = false;
}

static void give_up(bat_context *c, bat_pointing *p, bat_status status) {
    release(p);
    bat_transaction_cancel(c);
    bat_notice_failure(c, status);
}

static void drag(bat_context *c, bat_pointing *p) {
    double delta[3];
    bat_curve *curve = NULL;
    if (!p->dragging || !p->due) return;
    p->due = false;
    if (!drag_delta(c, p, delta)) return;
    bat_status status = moved(c, p, p->base, &p->grip, delta, &curve);
    if (status == BAT_OK) status = bat_put_curve(c, p->grip.object, p->grip.curve, curve);
    if (status != BAT_OK) give_up(c, p, status);
}

static void begin_drag(bat_context *c, bat_pointing *p) {
    const bat_curve *target = bat_edit_target_in(c->session->document, 0, p->grip.object, p->grip.curve);
    bat_status status = target ? bat_curve_copy(target, &p->base) : BAT_STATE;
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        release(p);
        bat_notice_failure(c, status);
        return;
    }
    choose_curve(c, p, p->grip.object, p->grip.curve);
    if (p->grip.kind != BAT_HANDLE_CURVE) p->chosen = p->grip;
    p->measured = false;
    p->dragging = true;
}

static void down(bat_context *c, void *state, const bat_pointer *event) {
    bat_pointing *p = state;
    settle(c, p);
    p->device = event->device;
    p->hovering = true;
    p->hover[0] = p->start[0] = p->at[0] = event->x;
    p->hover[1] = p->start[1] = p->at[1] = event->y;
    p->grip = p->hot = find(c, p, p->start);
    p->pressed = true;
    p->dragging = p->due = false;
    bat_notice(c, BAT_STRING_COUNT);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_pointing *p = state;
    if (!p->pressed || event->predicted) return;
    p->at[0] = p->hover[0] = event->x;
    p->at[1] = p->hover[1] = event->y;
    p->due = true;
    bool far = bat_hypot(p->at[0] - p->start[0], p->at[1] - p->start[1]) > TAP;
    if (!p->dragging && far && p->grip.kind) begin_drag(c, p);
}

/* ---- knots ---- */

static void notice_number(bat_context *c, bat_string text, double value) {
    char number[32];
    snprintf(number, sizeof number, "%.3g", value);
    bat_notice_value(c, text, number);
}

static bat_status done(bat_context *c, bat_status status) {
    if (status != BAT_OK) bat_notice_failure(c, status);
    return status;
}

/* Inserts u until its multiplicity is `times` higher; the shape does not change. Chooses the knot. */
static bat_status insert(bat_context *c, bat_pointing *p, const bat_curve *curve, double u, int times,
                         bat_string label) {
    bat_curve *after = NULL;
    bat_status status = bat_curve_insert_knot(curve, u, times, &after);
    if (status == BAT_KNOTS) {
        bat_notice(c, BAT_STRING_NOTICE_KNOT_FULL);
        return BAT_STATE;
    }
    if (status != BAT_OK) return done(c, status);
    status = bat_commit_curve(c, p->object, p->curve, after, label);
    if (status != BAT_OK) return done(c, status);
    p->measured = false;
    double knot;
    if (bat_knot_near(chosen_curve(c, p), u, &knot))
        p->chosen = (bat_handle){BAT_HANDLE_KNOT, p->object, p->curve, 0, knot};
    return BAT_OK;
}

/* Removes `times` copies of a knot if the curve then moves by no more than `within` document units. */
static bat_status take_out(bat_context *c, bat_pointing *p, double u, int times, double within,
                           bat_string label) {
    const bat_curve *curve = chosen_curve(c, p);
    bat_curve *after = NULL;
    int removed = 0;
    double error = 0;
    /* With an unlimited bound it tells what the removal would cost. */
    bat_status status = bat_curve_remove_knot(curve, u, times, bat_curve_size(curve) * 1e6, &after, &removed,
                                              &error);
    if (status != BAT_OK) return done(c, status);
    if (removed < times) {
        bat_curve_free(after);
        bat_notice(c, BAT_STRING_NOTICE_KNOT_NEEDED);
        return BAT_STATE;
    }
    if (error > within) {
        bat_curve_free(after);
        notice_number(c, BAT_STRING_NOTICE_KNOT_KEPT, error);
        return BAT_STATE;
    }
    status = bat_commit_curve(c, p->object, p->curve, after, label);
    if (status != BAT_OK) return done(c, status);
    settle(c, p);
    notice_number(c, BAT_STRING_NOTICE_MOVED_BY, error);
    return BAT_OK;
}

/* The knot that commands act on: the chosen one, or the one nearest to the chosen point. */
static bool meant_knot(const bat_context *c, const bat_pointing *p, double *u) {
    const bat_curve *curve = chosen_curve(c, p);
    if (!curve || !p->chosen.kind) return false;
    if (p->chosen.kind == BAT_HANDLE_KNOT) {
        *u = p->chosen.u;
        return true;
    }
    return bat_knot_near(curve, p->chosen.u, u);
}

static bat_status delete_knot(bat_context *c, bat_pointing *p) {
    double u;
    if (!p->chosen.kind) return BAT_STATE;
    if (!meant_knot(c, p, &u)) {
        bat_notice(c, BAT_STRING_NOTICE_KNOT_NEEDED);
        return BAT_STATE;
    }
    double within = c->settings->values[BAT_PROPERTY_TOLERANCE] * bat_stage_pixel(c->stage);
    return take_out(c, p, u, 1, within, BAT_STRING_STEP_KNOT_OUT);
}

/* Inserts a knot with no place given: under the pen, or in the middle of the span after what is chosen. */
static bat_status insert_knot(bat_context *c, bat_pointing *p) {
    if (p->hovering && p->hot.kind == BAT_HANDLE_CURVE) {
        choose_curve(c, p, p->hot.object, p->hot.curve);
        return insert(c, p, chosen_curve(c, p), p->hot.u, 1, BAT_STRING_STEP_KNOT_IN);
    }
    const bat_curve *curve = chosen_curve(c, p);
    if (!curve) return BAT_STATE;
    double domain[2], from, to;
    bat_curve_domain(curve, domain);
    from = p->chosen.kind ? p->chosen.u : domain[0];
    if (from >= domain[1]) from = domain[0];
    if (p->chosen.kind != BAT_HANDLE_KNOT) { /* a point: the span that contains its Greville abscissa */
        double u, start = domain[0];
        for (double after = -INFINITY; bat_knot_next(curve, after, &u, NULL) && u <= from; after = u)
            start = u;
        from = start;
    }
    if (!bat_knot_next(curve, from, &to, NULL)) to = domain[1];
    return insert(c, p, curve, from + (to - from) / 2, 1, BAT_STRING_STEP_KNOT_IN);
}

static bat_status make_corner(bat_context *c, bat_pointing *p) {
    const bat_curve *curve = chosen_curve(c, p);
    double u;
    if (!curve || !meant_knot(c, p, &u)) return BAT_STATE;
    int more = bat_curve_degree(curve) - bat_knot_held(curve, u);
    if (more <= 0) {
        bat_notice(c, BAT_STRING_NOTICE_CORNER_ALREADY);
        return BAT_STATE;
    }
    bat_status status = insert(c, p, curve, u, more, BAT_STRING_STEP_CORNER);
    if (status == BAT_OK) p->corner = p->chosen;
    return status;
}

/* Reduces the multiplicity until the curve is C2 (degree 2: C1), whatever the deviation, and reports the deviation. */
static bat_status smooth_corner(bat_context *c, bat_pointing *p) {
    const bat_curve *curve = chosen_curve(c, p);
    double u;
    if (!curve || !meant_knot(c, p, &u)) return BAT_STATE;
    int left = bat_curve_degree(curve) > 2 ? bat_curve_degree(curve) - 2 : 1;
    int less = bat_knot_held(curve, u) - left;
    if (less <= 0) {
        bat_notice(c, BAT_STRING_NOTICE_SMOOTH_ALREADY);
        return BAT_STATE;
    }
    return take_out(c, p, u, less, INFINITY, BAT_STRING_STEP_CORNER_OUT);
}

/* ---- taps ---- */

static void measure_to(bat_context *c, bat_pointing *p, double u) {
    const bat_curve *curve = chosen_curve(c, p);
    double domain[2];
    bat_curve_domain(curve, domain);
    p->stretch[0] = fmin(p->chosen.u, u);
    p->stretch[1] = fmax(p->chosen.u, u);
    double period = domain[1] - domain[0];
    if (bat_curve_is_closed(curve) &&
        p->stretch[1] - p->stretch[0] > period / 2) { /* the shorter way around */
        double from = p->stretch[0];
        p->stretch[0] = p->stretch[1];
        p->stretch[1] = from + period;
    }
    p->measured = p->stretch[0] < p->stretch[1];
}

static void tap(bat_context *c, bat_pointing *p, const bat_pointer *event) {
    const bat_handle grip = p->grip;
    bool twice = p->tapped && event->time - p->tap_time <= DOUBLE_TAP &&
                 bat_hypot(event->x - p->tap[0], event->y - p->tap[1]) <= 2 * TAP;
    p->tapped = !twice;
    p->tap[0] = event->x;
    p->tap[1] = event->y;
    p->tap_time = event->time;
    if (twice && grip.kind == BAT_HANDLE_CURVE) {
        choose_curve(c, p, grip.object, grip.curve);
        insert(c, p, chosen_curve(c, p), grip.u, 1, BAT_STRING_STEP_KNOT_IN);
        return;
    }
    bool on = grip.object && grip.object == p->object && grip.curve == p->curve;
    if (on && p->chosen.kind == BAT_HANDLE_KNOT && grip.kind != BAT_HANDLE_POINT &&
        event->modifiers & BAT_SHIFT) {
        measure_to(c, p, grip.u);
        return;
    }
    choose_curve(c, p, grip.object, grip.curve);
    choose_nothing(p);
    if (grip.kind == BAT_HANDLE_POINT || grip.kind == BAT_HANDLE_KNOT) p->chosen = grip;
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_pointing *p = state;
    if (!p->pressed) return;
    drag(c, p);
    if (!p->pressed) return; /* the drag has failed */
    bool dragged = p->dragging;
    bat_string label = p->grip.kind == BAT_HANDLE_POINT ? BAT_STRING_STEP_CONTROL_POINT
                                                        : BAT_STRING_STEP_PULL;
    release(p);
    if (dragged)
        done(c, bat_transaction_commit(c, label, NULL));
    else
        tap(c, p, event);
}

static bool cancel(bat_context *c, void *state) {
    bat_pointing *p = state;
    if (p->dragging) {
        release(p);
        bat_transaction_cancel(c);
        bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
        return true;
    }
    if (p->pressed) { /* nothing is chosen yet: a tap chooses when it is lifted */
        release(p);
        return true;
    }
    bool any = p->object || p->chosen.kind;
    p->object = 0;
    choose_nothing(p);
    return any;
}

/* Undo reverts the drag under way, but what is chosen stays chosen. */
static bool undo(bat_context *c, void *state) {
    bat_pointing *p = state;
    return p->dragging && cancel(c, p);
}

/* ---- commands ---- */

static bat_status step(bat_context *c, bat_pointing *p, int direction) {
    const bat_curve *curve = chosen_curve(c, p);
    if (!curve) { /* the selected curve, else the first curve */
        bat_seen_sync(c);
        for (int pass = 0; pass < 2 && !curve; pass++)
            for (int i = 0; i < bat_document_count(c->session->document) && !curve; i++) {
                bat_id id = bat_object_id(bat_document_at(c->session->document, i));
                if (pass == 0 && !bat_selection_has(&c->choice->selection, id)) continue;
                if (bat_seen_out_of_reach(c, i)) continue;
                if (!(curve = bat_edit_target_in(c->session->document, 0, id, 0))) continue;
                choose_curve(c, p, id, 0);
            }
        if (!curve) return BAT_STATE;
        choose_nothing(p);
    }
    int count = bat_point_count(curve), at = direction > 0 ? 0 : count - 1;
    if (p->chosen.kind == BAT_HANDLE_POINT) at = p->chosen.index + direction;
    if (at < 0 || at >= count) { /* the keyboard focus moves on to what follows the drawing */
        choose_nothing(p);
        return BAT_STATE;
    }
    p->chosen = (bat_handle){BAT_HANDLE_POINT, p->object, p->curve, at, bat_handle_greville(curve, at)};
    p->measured = false;
    return BAT_OK;
}

static bat_status step_knot(bat_context *c, bat_pointing *p, int direction) {
    const bat_curve *curve = chosen_curve(c, p);
    if (!curve) return step(c, p, direction);
    double u, best = 0, from = p->chosen.kind ? p->chosen.u : direction > 0 ? -INFINITY : INFINITY;
    bool found = false;
    for (double after = -INFINITY; bat_knot_next(curve, after, &u, NULL); after = u) {
        if (direction > 0 ? u <= from || found : u >= from) continue;
        best = u;
        found = true;
    }
    if (!found) return BAT_STATE;
    p->chosen = (bat_handle){BAT_HANDLE_KNOT, p->object, p->curve, 0, best};
    p->measured = false;
    return BAT_OK;
}

bool bat_pointing_chosen(bat_context *c, double place[2]) {
    bat_pointing *p = bat_pointing_of(c);
    settle(c, p);
    const bat_curve *curve = chosen_curve(c, p);
    if (!curve || !p->chosen.kind || bat_curve_dimension(curve) != 2) return false;
    bat_handle_place(curve, &p->chosen, place);
    return true;
}

/* Moves the handle that is chosen; delta: of the curve's dimension. */
static bat_status shift(bat_context *c, bat_pointing *p, const bat_curve *curve, const double delta[3]) {
    bat_curve *after = NULL;
    bat_status status = moved(c, p, curve, &p->chosen, delta, &after);
    if (status == BAT_OK)
        status = bat_commit_curve(c, p->object, p->curve, after,
                                  p->chosen.kind == BAT_HANDLE_POINT ? BAT_STRING_STEP_CONTROL_POINT
                                                                     : BAT_STRING_STEP_PULL);
    return done(c, status);
}

bat_status bat_pointing_shift(bat_context *c, const double delta[2]) {
    bat_pointing *p = bat_pointing_of(c);
    const bat_curve *curve = chosen_curve(c, p);
    const double way[3] = {delta[0], delta[1], 0};
    return curve && p->chosen.kind ? shift(c, p, curve, way) : BAT_STATE;
}

static bat_status nudge(bat_context *c, double x, double y) {
    bat_pointing *p = bat_pointing_of(c);
    const bat_curve *curve = chosen_curve(c, p);
    const double pixels = c->modifiers & BAT_SHIFT ? 10 : 1, far = pixels * bat_stage_pixel(c->stage);
    double way[3];
    if (!bat_stage_tilted(c->stage)) return bat_pointing_shift(c, (double[]){x * far, y * far});
    if (!curve || !p->chosen.kind ||
        !bat_stage_way(c->stage, curve, (double[]){0, 0}, (double[]){x * pixels, y * pixels}, false, way))
        return BAT_STATE;
    return shift(c, p, curve, way);
}

static bat_status command(bat_context *c, void *state, bat_command_id id) {
    bat_pointing *p = state;
    settle(c, p);
    switch (id) {
    case BAT_COMMAND_POINT_NEXT: return step(c, p, 1);
    case BAT_COMMAND_POINT_PREVIOUS: return step(c, p, -1);
    case BAT_COMMAND_KNOT_NEXT: return step_knot(c, p, 1);
    case BAT_COMMAND_KNOT_PREVIOUS: return step_knot(c, p, -1);
    case BAT_COMMAND_POINT_ADD: return insert_knot(c, p);
    case BAT_COMMAND_POINT_DELETE: return delete_knot(c, p);
    case BAT_COMMAND_CORNER_MAKE: return make_corner(c, p);
    case BAT_COMMAND_CORNER_SMOOTH: return smooth_corner(c, p);
    case BAT_COMMAND_NUDGE_LEFT: return nudge(c, -1, 0);
    case BAT_COMMAND_NUDGE_RIGHT: return nudge(c, 1, 0);
    case BAT_COMMAND_NUDGE_UP: return nudge(c, 0, -1);
    case BAT_COMMAND_NUDGE_DOWN: return nudge(c, 0, 1);
    default: return BAT_STATE;
    }
}

/* ---- hover and picture ---- */

static void hover(bat_context *c, void *state, const bat_pointer *event) {
    (void)c;
    bat_pointing *p = state;
    p->hovering = true;
    p->device = event->device;
    p->hover[0] = event->x;
    p->hover[1] = event->y;
}

static void leave(bat_context *c, void *state) {
    (void)c;
    bat_pointing *p = state;
    p->adopted = p->object; /* a selection made elsewhere meanwhile is taken over */
    p->hovering = false;
    p->hot = (bat_handle){0};
}

static void modifiers(bat_context *c, void *state) {
    (void)c;
    bat_pointing *p = state;
    p->due = p->dragging;
}
static bool busy(const bat_context *c, const void *state) {
    (void)c;
    const bat_pointing *p = state;
    return p->pressed;
}

static void update(bat_context *c, void *state) {
    bat_pointing *p = state;
    settle(c, p);
    drag(c, p);
    if (p->pressed) return;
    p->hot = p->hovering ? find(c, p, p->hover) : (bat_handle){0};
}

/* The stretch that a drag at u changes: the support of the basis functions at u. */
static void show_support(bat_overlay *list, const bat_curve *curve, double u) {
    double range[2];
    bat_knots_reached(curve, u, range);
    bat_overlay_item(list, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, STRETCH_WIDTH);
    bat_overlay_stretch(list, curve, range[0], range[1]);
}

static void show_length(const bat_context *c, const bat_pointing *p, bat_overlay *list,
                        const bat_curve *curve) {
    double at[2], length = bat_curve_length(curve, p->stretch[0], p->stretch[1], 1e-6);
    char text[64];
    bat_unit_write(c, length, text);
    const bat_handle middle = {.kind = BAT_HANDLE_CURVE, .u = (p->stretch[0] + p->stretch[1]) / 2};
    bat_handle_seen(curve, c->stage, &middle, at);
    bat_overlay_label(list, BAT_ROLE_VALUE, at, 14, -14, text);
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    bat_pointing *p = state;
    const bat_handle *hot = p->dragging ? &p->grip : &p->hot;
    const bat_curve *curve = chosen_curve(c, p);
    const bat_curve *under = hot->object
                                 ? bat_edit_target_in(c->session->document, 0, hot->object, hot->curve)
                                 : NULL;
    if (c->input->holding_pan) under = NULL;
    bool other = under && under != curve;
    if (other) {
        bat_overlay_item(list, BAT_ROLE_HIGHLIGHT, BAT_ITEM_STROKED, HIGHLIGHT_WIDTH);
        bat_path_curve(&list->path, under);
    }
    if (under && hot->kind != BAT_HANDLE_POINT) show_support(list, under, hot->u);
    if (curve && p->measured) {
        bat_overlay_item(list, BAT_ROLE_STRETCH, BAT_ITEM_STROKED, STRETCH_WIDTH);
        bat_overlay_stretch(list, curve, p->stretch[0], p->stretch[1]);
        show_length(c, p, list, curve);
    }
    const bat_curve *shown = curve ? curve : under;
    if (shown) {
        bat_handles_show_points(list, shown, c->stage);
        bat_handles_show_knots(list, shown, c->stage);
    }
    if (curve && p->chosen.kind) bat_handles_show_one(list, curve, &p->chosen, BAT_ROLE_CHOSEN, c->stage);
    if (under && !(same(hot, &p->chosen) && curve))
        bat_handles_show_one(list, under, hot, BAT_ROLE_HANDLE, c->stage);
}

static bat_string hint(const bat_context *c, const void *state) {
    const bat_pointing *p = state;
    if (p->dragging) return BAT_STRING_HINT_DRAGGING;
    if (p->measured) return BAT_STRING_HINT_MEASURED;
    if (p->hot.kind == BAT_HANDLE_POINT) {
        const bat_curve *curve = bat_edit_target_in(c->session->document, 0, p->hot.object, p->hot.curve);
        return curve && is_tied(p, curve, &p->hot) ? BAT_STRING_HINT_TIED : BAT_STRING_HINT_CONTROL_POINT;
    }
    if (p->hot.kind == BAT_HANDLE_KNOT) return BAT_STRING_HINT_KNOT;
    if (p->hot.kind == BAT_HANDLE_CURVE)
        return p->chosen.kind == BAT_HANDLE_KNOT && p->hot.object == p->object ? BAT_STRING_HINT_PULL_HELD
                                                                               : BAT_STRING_HINT_PULL;
    if (p->chosen.kind) return BAT_STRING_HINT_CHOSEN;
    return BAT_STRING_HINT_POINTS;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    (void)c;
    const bat_pointing *p = state;
    if (p->dragging) return BAT_CURSOR_MOVE;
    return p->hot.kind ? BAT_CURSOR_MOVE : BAT_CURSOR_ARROW;
}

static const char *check(const bat_context *c, const void *state) {
    const bat_pointing *p = state;
    if (p->dragging && !p->pressed) return "a drag without a press";
    if (p->dragging != (p->base != NULL)) return "a drag without its curve, or a curve without its drag";
    if (p->dragging && !c->session->transaction.open) return "a drag without a transaction";
    if (p->pressed && bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a press without a pointer";
    return NULL;
}

static bool stretch(const bat_context *c, const void *state, bat_stretch *out) {
    const bat_pointing *p = state;
    (void)c;
    *out = (bat_stretch){p->object, p->curve, {p->stretch[0], p->stretch[1]}};
    return p->measured;
}

const bat_tool *bat_tool_points(void) {
    static const bat_tool tool = {.stretch = stretch,
                                  .size = sizeof(bat_pointing),
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
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

bat_pointing *bat_pointing_of(const bat_context *c) { return bat_toolbox_state(c, bat_tool_points()); }
