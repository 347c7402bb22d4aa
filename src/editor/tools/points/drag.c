/* The points tool: points and curves that are moved, by the pen, by keys and by numbers. */
#include "editor/tools/points/state.h"
#include "curve/curve.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/pull.h"
#include "editor/edit/smooth_node.h"
#include "editor/pick/snap.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/view/stage.h"
#include "editor/view/way.h"
#include <string.h>

/* Whether the control point belongs to a smooth node that is to stay smooth. */
bool bat_pointing_is_tied(const bat_pointing *p, const bat_curve *curve, const bat_handle *handle) {
    bat_smooth_node node;
    if (!bat_smooth_node_of(curve, handle->index, &node)) return false;
    return !p->corner.kind || handle->object != p->corner.object || handle->curve != p->corner.curve ||
           node.u != p->corner.u;
}

static bat_status moved(const bat_context *c, const bat_pointing *p, const bat_curve *base,
                        const bat_handle *grip, const double delta[3], bat_curve **out) {
    const bat_handle *held = &p->chosen;
    bool alone = c->modifiers & BAT_ALT || !bat_pointing_is_tied(p, base, grip);
    if (grip->kind == BAT_HANDLE_POINT && p->marked > 1 && bat_pointing_is_marked(p, grip->index))
        return bat_pull_points(base, p->marks, delta, out);
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

void bat_pointing_release(bat_pointing *p) {
    bat_curve_free(p->base);
    p->base = NULL;
    p->pressed = p->dragging = p->due = p->boxing = false;
}

static void give_up(bat_context *c, bat_pointing *p, bat_status status) {
    bat_pointing_release(p);
    bat_transaction_cancel(c);
    bat_notice_failure(c, status);
}

void bat_pointing_drag(bat_context *c, bat_pointing *p) {
    double delta[3];
    bat_curve *curve = NULL;
    if (!p->dragging || !p->due) return;
    p->due = false;
    if (!drag_delta(c, p, delta)) return;
    bat_status status = moved(c, p, p->base, &p->grip, delta, &curve);
    if (status == BAT_OK) status = bat_put_curve(c, p->grip.object, p->grip.curve, curve);
    if (status != BAT_OK) give_up(c, p, status);
}

void bat_pointing_begin_drag(bat_context *c, bat_pointing *p) {
    const bat_curve *target = bat_edit_target_in(c->session->document, 0, p->grip.object, p->grip.curve);
    bat_status status = target ? bat_curve_copy(target, &p->base) : BAT_STATE;
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_pointing_release(p);
        bat_notice_failure(c, status);
        return;
    }
    bat_pointing_choose_curve(c, p, p->grip.object, p->grip.curve);
    if (p->grip.kind != BAT_HANDLE_POINT || !bat_pointing_is_marked(p, p->grip.index)) bat_pointing_unmark(p);
    if (p->grip.kind != BAT_HANDLE_CURVE) p->chosen = p->grip;
    p->measured = false;
    p->dragging = true;
}

/* Moves the handle that is chosen; delta: of the curve's dimension. */
static bat_status shift(bat_context *c, bat_pointing *p, const bat_curve *curve, const double delta[3]) {
    bat_curve *after = NULL;
    bat_status status = moved(c, p, curve, &p->chosen, delta, &after);
    if (status == BAT_OK)
        status = bat_commit_curve(c, p->object, p->curve, after,
                                  p->chosen.kind == BAT_HANDLE_POINT ? BAT_STRING_STEP_CONTROL_POINT
                                                                     : BAT_STRING_STEP_PULL);
    return bat_pointing_told(c, status);
}

bat_status bat_pointing_shift(bat_context *c, const double delta[2]) {
    bat_pointing *p = bat_pointing_of(c);
    const bat_curve *curve = bat_pointing_curve(c, p);
    const double way[3] = {delta[0], delta[1], 0};
    return curve && p->chosen.kind ? shift(c, p, curve, way) : BAT_STATE;
}

bat_status bat_pointing_nudge(bat_context *c, double x, double y) {
    bat_pointing *p = bat_pointing_of(c);
    const bat_curve *curve = bat_pointing_curve(c, p);
    const double pixels = c->modifiers & BAT_SHIFT ? 10 : 1, far = pixels * bat_stage_pixel(c->stage);
    double way[3];
    if (!bat_stage_tilted(c->stage)) return bat_pointing_shift(c, (double[]){x * far, y * far});
    if (!curve || !p->chosen.kind ||
        !bat_stage_way(c->stage, curve, (double[]){0, 0}, (double[]){x * pixels, y * pixels}, false, way))
        return BAT_STATE;
    return shift(c, p, curve, way);
}
