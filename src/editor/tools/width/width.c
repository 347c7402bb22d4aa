/*
 * The width tool: the width of a stroke, pulled on the drawing. The curve under the pen shows how wide it is there, as a pair of
 * handles; dragged away from the curve or towards it they change the width, evenly on both sides, and a stop of the profile
 * stands there. Stops are dragged along the curve by their middles, and taken out by Delete.
 *
 * IDLE --down--> pressed --moved--> dragging (a transaction is open) --up--> IDLE (one step); pressed --up--> a tap,
 * which chooses; a double tap asks for the width as a number. cancel: reverts a drag or drops a press; otherwise deselects. A fader of
 * the level strip holds a transaction, too, from its first move until it is let go (levels.c).
 */
#include "base/real.h"
#include "editor/edit/curves_of.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/pick/pick.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tools/tool.h"
#include "editor/tools/width/state.h"
#include "editor/view/stage.h"
#include <math.h>

static const double TAP = 4, REACH = 10; /* px */

static void down(bat_context *c, void *state, const bat_pointer *event) {
    bat_broadening *b = state;
    bat_broadening_settle(c, b);
    b->device = event->device;
    b->hovering = true;
    b->hover[0] = b->start[0] = b->at[0] = event->x;
    b->hover[1] = b->start[1] = b->at[1] = event->y;
    b->grip = b->hot = bat_broadening_find(c, b, b->start);
    b->pressed = true;
    b->dragging = b->sliding = b->due = false;
    bat_notice(c, BAT_STRING_COUNT);
}

static void move(bat_context *c, void *state, const bat_pointer *event) {
    bat_broadening *b = state;
    if (!b->pressed || event->predicted) return;
    b->at[0] = b->hover[0] = event->x;
    b->at[1] = b->hover[1] = event->y;
    b->due = true;
    const bool far = bat_hypot(b->at[0] - b->start[0], b->at[1] - b->start[1]) > TAP;
    if (!b->dragging && far && b->grip.object) bat_broadening_begin_drag(c, b);
}

/* A tap where no width can be changed says so where there is a curve. */
static void tell_why(bat_context *c, const bat_pointer *event) {
    double point[2];
    bat_stage_seen(c->stage, (double[]){event->x, event->y}, point);
    if (bat_pick_object(c->scene, point, REACH * bat_stage_pixel(c->stage)) >= 0)
        bat_notice(c, BAT_STRING_NOTICE_NO_WIDTHS);
}

static void tap(bat_context *c, bat_broadening *b, const bat_pointer *event) {
    const bat_breadth_hit grip = b->grip;
    const bool twice = bat_double_tap_ends(&b->tap, event);
    bat_broadening_choose(c, b, grip.object, grip.curve);
    b->chosen = false;
    if (grip.stop >= 0) bat_broadening_choose_at(b, grip.stop, grip.at);
    if (!grip.object) tell_why(c, event);
    if (!twice || !grip.object) return;
    if (grip.stop < 0 && bat_broadening_add(c, b, grip.at) != BAT_OK) return;
    c->notices->requests |= BAT_ASK_WIDTH;
}

static void up(bat_context *c, void *state, const bat_pointer *event) {
    bat_broadening *b = state;
    if (!b->pressed) return;
    bat_broadening_drag(c, b);
    if (!b->pressed) return; /* the drag has failed */
    const bool dragged = b->dragging;
    bat_broadening_release(b);
    if (!dragged) {
        tap(c, b, event);
        return;
    }
    const bat_status status = bat_transaction_commit(c, BAT_STRING_STEP_WIDTHS, NULL);
    if (status != BAT_OK) bat_notice_failure(c, status);
}

static bool cancel(bat_context *c, void *state) {
    bat_broadening *b = state;
    if (b->dragging) {
        bat_broadening_release(b);
        bat_transaction_cancel(c);
        b->chosen = false;
        bat_notice(c, BAT_STRING_NOTICE_CANCELLED);
        return true;
    }
    if (b->pressed) {
        bat_broadening_release(b);
        return true;
    }
    const bool any = b->chosen || b->object;
    if (b->chosen)
        b->chosen = false;
    else
        b->object = 0;
    return any;
}

/* Undo reverts the drag under way, but what is chosen stays chosen. */
static bool undo(bat_context *c, void *state) {
    return ((bat_broadening *)state)->dragging && cancel(c, state);
}

/* Enter: the width as a number. */
static bool accept(bat_context *c, void *state) {
    bat_broadening *b = state;
    bat_broadening_settle(c, b);
    if (b->chosen) c->notices->requests |= BAT_ASK_WIDTH;
    return b->chosen;
}

static void hover(bat_context *c, void *state, const bat_pointer *event) {
    bat_broadening *b = state;
    (void)c;
    b->hovering = true;
    b->device = event->device;
    b->hover[0] = event->x;
    b->hover[1] = event->y;
}

static void leave(bat_context *c, void *state) {
    bat_broadening *b = state;
    (void)c;
    b->adopted = b->object; /* a selection made elsewhere meanwhile is taken over */
    b->hovering = false;
    b->hot = (bat_breadth_hit){.stop = -1};
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    return ((const bat_broadening *)state)->pressed;
}

static void update(bat_context *c, void *state) {
    bat_broadening *b = state;
    if (!b->dragging) bat_broadening_settle(c, b);
    bat_broadening_drag(c, b);
    if (b->pressed) return;
    b->hot = b->hovering ? bat_broadening_find(c, b, b->hover) : (bat_breadth_hit){.stop = -1};
}

static bat_string hint(const bat_context *c, const void *state) {
    const bat_broadening *b = state;
    (void)c;
    if (b->dragging) return b->sliding ? BAT_STRING_HINT_WIDTH_SLIDING : BAT_STRING_HINT_WIDTH_DRAGGING;
    if (b->hot.object && b->hot.stop >= 0) return BAT_STRING_HINT_WIDTH_STOP;
    if (b->hot.object) return BAT_STRING_HINT_WIDTH_PULL;
    return b->chosen ? BAT_STRING_HINT_WIDTH_CHOSEN : BAT_STRING_HINT_WIDTH;
}

static bat_cursor cursor(const bat_context *c, const void *state) {
    const bat_broadening *b = state;
    (void)c;
    return b->dragging || b->hot.object ? BAT_CURSOR_MOVE : BAT_CURSOR_ARROW;
}

static bool held_by_panel(const void *state) { return ((const bat_broadening *)state)->fading; }

static void let_go(bat_context *c, void *state) {
    (void)state;
    bat_broadening_let_go(c);
}

static const char *check(const bat_context *c, const void *state) {
    const bat_broadening *b = state;
    if (b->dragging && !b->pressed) return "a drag without a press";
    if (b->dragging && !c->session->transaction.open) return "a drag without a transaction";
    if (b->dragging && (size_t)b->held >= b->base.count) return "a drag without its stop";
    if (b->fading && !c->session->transaction.open) return "a fader without a transaction";
    if (b->pressed && bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a press without a pointer";
    return NULL;
}

const bat_tool *bat_tool_width(void) {
    static const bat_tool tool = {.size = sizeof(bat_broadening),
                                  .hover = hover,
                                  .leave = leave,
                                  .down = down,
                                  .move = move,
                                  .up = up,
                                  .cancel = cancel,
                                  .undo = undo,
                                  .accept = accept,
                                  .command = bat_broadening_command,
                                  .busy = busy,
                                  .held_by_panel = held_by_panel,
                                  .let_go = let_go,
                                  .update = update,
                                  .overlay = bat_broadening_overlay,
                                  .hint = hint,
                                  .cursor = cursor,
                                  .check = check};
    return &tool;
}
