/*
 * The points tool. Shows control polygon, control points and knots of the chosen curve (or else the one under the
 * pen). Control points can be dragged directly, with smooth nodes kept smooth unless Alt is held; the curve can be
 * dragged anywhere by direct manipulation, while its ends and a chosen knot stay in place. A double tap inserts a
 * knot, Delete removes one.
 *
 * IDLE --down--> pressed --moved--> dragging (a transaction is open) --up--> IDLE (one step); pressed --up--> a tap,
 * which chooses; with Shift it chooses one point more, or one less. A drag from nothing draws a box that chooses the points in
 * it (many.c). cancel: reverts a drag or drops a press; otherwise deselects.
 */
#include "base/vec.h"
#include "editor/tools/points/state.h"
#include "base/real.h"
#include "curve/curve.h"
#include "editor/edit/curves_of.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tools/tool.h"
#include <math.h>
#include <stdlib.h>

static const double TAP = 4; /* px */

/* ---- the pointer ---- */

static void down(bat_context *c, void *state, const bat_pointer *event) {
    bat_pointing *p = state;
    bat_pointing_settle(c, p);
    p->device = event->device;
    p->hovering = true;
    p->hover[0] = p->start[0] = p->at[0] = event->x;
    p->hover[1] = p->start[1] = p->at[1] = event->y;
    p->grip = p->hot = bat_pointing_find(c, p, p->start);
    p->pressed = true;
    p->dragging = p->due = p->boxing = false;
    bat_notice(c, BAT_STRING_COUNT);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_pointing *p = state;
    if (!p->pressed || event->predicted) return;
    p->at[0] = p->hover[0] = event->x;
    p->at[1] = p->hover[1] = event->y;
    p->due = true;
    bool far = bat_hypot(p->at[0] - p->start[0], p->at[1] - p->start[1]) > TAP;
    if (!p->dragging && far && p->grip.kind) bat_pointing_begin_drag(c, p);
    if (far && !p->grip.kind && p->object) p->boxing = true;
}

static void measure_to(bat_context *c, bat_pointing *p, double u) {
    const bat_curve *curve = bat_pointing_curve(c, p);
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
    const bool twice = bat_double_tap_ends(&p->tap, event);
    if (twice && grip.kind == BAT_HANDLE_CURVE) {
        bat_pointing_choose_curve(c, p, grip.object, grip.curve);
        bat_pointing_insert(c, p, bat_pointing_curve(c, p), grip.u, 1, BAT_STRING_STEP_KNOT_IN);
        return;
    }
    bool on = grip.object && grip.object == p->object && grip.curve == p->curve;
    if (on && p->chosen.kind == BAT_HANDLE_KNOT && grip.kind != BAT_HANDLE_POINT &&
        event->modifiers & BAT_SHIFT) {
        measure_to(c, p, grip.u);
        return;
    }
    if (on && grip.kind == BAT_HANDLE_POINT && p->chosen.kind == BAT_HANDLE_POINT &&
        event->modifiers & BAT_SHIFT) {
        bat_pointing_told(c, bat_pointing_toggle(p, bat_pointing_curve(c, p), grip.index));
        return;
    }
    bat_pointing_choose_curve(c, p, grip.object, grip.curve);
    bat_pointing_choose_nothing(p);
    if (grip.kind == BAT_HANDLE_POINT || grip.kind == BAT_HANDLE_KNOT) p->chosen = grip;
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_pointing *p = state;
    if (!p->pressed) return;
    bat_pointing_drag(c, p);
    if (!p->pressed) return; /* the drag has failed */
    const bat_curve *boxed = p->boxing ? bat_pointing_curve(c, p) : NULL;
    bool dragged = p->dragging;
    bat_string label = p->grip.kind == BAT_HANDLE_POINT ? BAT_STRING_STEP_CONTROL_POINT
                                                        : BAT_STRING_STEP_PULL;
    bat_pointing_release(p);
    if (boxed)
        bat_pointing_told(c, bat_pointing_mark_box(c, p, boxed, event->modifiers & BAT_SHIFT));
    else if (dragged)
        bat_pointing_told(c, bat_transaction_commit(c, label, NULL));
    else
        tap(c, p, event);
}

static bool cancel(bat_context *c, void *state) {
    bat_pointing *p = state;
    if (p->dragging) {
        bat_pointing_release(p);
        bat_transaction_cancel(c);
        bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
        return true;
    }
    if (p->pressed) { /* nothing is chosen yet: a tap chooses when it is lifted */
        bat_pointing_release(p);
        return true;
    }
    bool any = p->object || p->chosen.kind;
    p->object = 0;
    bat_pointing_choose_nothing(p);
    return any;
}

/* Undo reverts the drag under way, but what is chosen stays chosen. */
static bool undo(bat_context *c, void *state) {
    bat_pointing *p = state;
    return p->dragging && cancel(c, p);
}

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
    bat_pointing_settle(c, p);
    bat_pointing_drag(c, p);
    if (p->pressed) return;
    p->hot = p->hovering ? bat_pointing_find(c, p, p->hover) : (bat_handle){0};
}

/* ---- texts ---- */

static bat_string hint(const bat_context *c, const void *state) {
    const bat_pointing *p = state;
    if (p->dragging) return BAT_STRING_HINT_DRAGGING;
    if (p->boxing) return BAT_STRING_HINT_MARQUEE;
    if (p->measured) return BAT_STRING_HINT_MEASURED;
    if (p->hot.kind == BAT_HANDLE_POINT) {
        const bat_curve *curve = bat_edit_target_in(c->session->document, 0, p->hot.object, p->hot.curve);
        return curve && bat_pointing_is_tied(p, curve, &p->hot) ? BAT_STRING_HINT_TIED
                                                                : BAT_STRING_HINT_CONTROL_POINT;
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
    if (p->boxing && (!p->pressed || p->dragging)) return "a box without a press, or with a drag";
    if (p->marked > 0 && !bat_pointing_is_marked(p, p->chosen.index))
        return "several points are chosen, and the one that is chosen is none of them";
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

static void end(void *state) {
    bat_pointing *p = state;
    free(p->marks);
}

const bat_tool *bat_tool_points(void) {
    static const bat_tool tool = {.stretch = stretch,
                                  .end = end,
                                  .size = sizeof(bat_pointing),
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .undo = undo,
                                  .command = bat_pointing_command,
                                  .modifiers = modifiers,
                                  .busy = busy,
                                  .update = update,
                                  .overlay = bat_pointing_overlay,
                                  .hint = hint,
                                  .cursor = cursor,
                                  .check = check};
    return &tool;
}
