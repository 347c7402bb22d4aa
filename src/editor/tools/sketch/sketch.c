/*
 * The sketch tool. The meaning of a stroke is decided from the whole of it (meaning.h): a new curve, a redraw of one
 * or several curves, an extension, a join, a closing; Alt smooths. While the pen is down the meaning so far is shown
 * with its fit, computed once per frame. Nothing is final before the pen is lifted.
 *
 * IDLE --down--> DRAWING --up--> IDLE (committed, or nothing), or PENDING when the tolerance could not be met.
 * PENDING: accept or a tap commits, cancel drops, a stroke drops it and draws anew. cancel: to IDLE from any state.
 */
#include "editor/edit/curves_of.h"
#include "editor/input/contacts.h"
#include "editor/input/input.h"
#include "editor/input/samples.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/show/disc.h"
#include "editor/show/overlay.h"
#include "editor/tools/sketch/parts.h"
#include "editor/tools/toolbox.h"
#include "editor/view/stage.h"

static bool cancel(bat_context *c, void *state) {
    bat_sketching *s = state;
    if (s->state == BAT_SKETCHING_IDLE) return false;
    bool drawing = s->state == BAT_SKETCHING_DRAWING;
    /* While drawing over a pending fit, only the stroke is dropped: the fit stays pending. */
    if (!drawing) bat_sketching_drop_pending(s);
    bat_sketching_end_stroke(s);
    bat_notice(c, drawing ? BAT_STRING_NOTICE_CANCELLED : BAT_STRING_NOTICE_DROPPED);
    return true;
}

static void drop(bat_context *c, void *state) {
    bat_sketching *s = state;
    (void)c;
    if (s->state == BAT_SKETCHING_DRAWING) bat_sketching_end_stroke(s);
}

static void modifiers(bat_context *c, void *state) {
    bat_sketching *s = state;
    if (s->state == BAT_SKETCHING_DRAWING && c->modifiers & BAT_ALT) bat_sketching_start_smoothing(s);
}

static bool busy(const bat_context *c, const void *state) {
    (void)c;
    const bat_sketching *s = state;
    return s->state == BAT_SKETCHING_DRAWING;
}

static void update(bat_context *c, void *state) {
    bat_sketching *s = state;
    if (s->state == BAT_SKETCHING_DRAWING)
        bat_sketching_update_stroke(c, s);
    else
        bat_sketching_look(c, s);
}

/* What a stroke would land on. */
static void show_landing(const bat_context *c, const bat_sketching *s, bat_overlay *list) {
    if (!s->over.ground.type) return; /* not looked yet */
    bat_sketching_show_ground(c, &s->over, list);
    bat_disc_show(&s->over, s->hover, list);
}

static void overlay(bat_context *c, void *state, bat_overlay *list) {
    bat_sketching *s = state;
    if (s->again.fit.count && bat_sketching_readings(c, s)) bat_sketching_show_refit(c, s, list);
    if (s->has_pending) bat_sketching_show_pending(c, s, list);
    if (s->state == BAT_SKETCHING_DRAWING)
        bat_sketching_show_stroke(c, s, list);
    else if (s->hovering)
        show_landing(c, s, list);
    if (s->state != BAT_SKETCHING_DRAWING && s->pick.object && !c->input->holding_pan &&
        bat_contacts_clear(c))
        bat_sketching_highlight(c, list, bat_stage_dimension(&s->over), s->pick.object, s->pick.curve);
}

static const bat_stage *lands(const bat_context *c, const void *state) {
    const bat_sketching *s = state;
    (void)c;
    return s->state == BAT_SKETCHING_DRAWING    ? &s->edit.stage
           : s->hovering && s->over.ground.type ? &s->over
                                                : NULL;
}

static const char *check(const bat_context *c, const void *state) {
    const bat_sketching *s = state;
    bool drawing = s->state == BAT_SKETCHING_DRAWING;
    if (drawing && !s->edit.samples.count) return "a stroke under way has no samples";
    if (!drawing && s->edit.samples.count) return "samples are left of a stroke that ended";
    if (!drawing && (s->live || s->preview.curve)) return "a preview outlived its stroke";
    if (drawing && bat_contacts_count(&c->input->contacts, BAT_DUTY_TOOL, NULL) != 1)
        return "a stroke without a pen";
    if (s->fed > s->edit.samples.count) return "the session has samples that the stroke has not";
    if (s->has_pending != (s->pending_result.count > 0)) return "a pending fit without a curve";
    if (s->state == BAT_SKETCHING_PENDING && !s->has_pending) return "nothing is pending";
    if (s->state == BAT_SKETCHING_IDLE && s->has_pending) return "a pending fit is forgotten";
    if (drawing && s->edit.kind != BAT_EDIT_NEW &&
        !bat_edit_curve(c->session->document, &s->edit, s->edit.object, s->edit.curve))
        return "the curve under the pen is gone";
    return NULL;
}

static void readout(const bat_context *c, const void *state, bat_readout *out) {
    (void)c;
    const bat_sketching *s = state;
    bool drawn = s->state == BAT_SKETCHING_DRAWING && s->preview.curve;
    out->curve = drawn ? s->preview.curve : NULL;
    out->report = drawn ? &s->preview.report : s->has_pending ? &s->pending_report : NULL;
    out->followers = drawn ? &s->preview.followers : NULL;
    out->waits = s->has_pending;
    if (!drawn || s->edit.kind == BAT_EDIT_NEW) return;
    out->object = s->edit.object, out->number = s->edit.curve;
}

static uint32_t readings(const bat_context *c, const void *state) {
    const bat_sketching *s = state;
    if (!s->again.count && !s->kept.count) return 0;
    const bat_kept_stroke *offered = bat_sketching_offered(c, s);
    if (offered) return 1U << 30 | offered->serial;
    return bat_sketching_readings(c, s) ? s->again.version : 0;
}

void bat_sketching_show_kept(const bat_context *c, bat_overlay *overlay) {
    const bat_sketching *s = bat_sketching_of(c);
    if (s->kept.fit.count) bat_kept_show(c, &s->kept, overlay);
}

const bat_tool *bat_tool_sketch(void) {
    static const bat_tool tool = {.focus = bat_sketching_focus,
                                  .size = sizeof(bat_sketching),
                                  .end = bat_sketching_end,
                                  .trace = bat_sketching_trace,
                                  .lift = bat_sketching_lift,
                                  .drop = drop,
                                  .hover = bat_sketching_hover,
                                  .leave = bat_sketching_leave,
                                  .down = bat_sketching_down,
                                  .move = bat_sketching_move,
                                  .up = bat_sketching_up,
                                  .cancel = cancel,
                                  .accept = bat_sketching_accept,
                                  .command = bat_sketching_command,
                                  .modifiers = modifiers,
                                  .busy = busy,
                                  .update = update,
                                  .overlay = overlay,
                                  .hint = bat_sketching_hint,
                                  .lands = lands,
                                  .cursor = bat_sketching_cursor,
                                  .readout = readout,
                                  .readings = readings,
                                  .check = check};
    return &tool;
}

bat_sketching *bat_sketching_of(const bat_context *c) { return bat_toolbox_state(c, bat_tool_sketch()); }
