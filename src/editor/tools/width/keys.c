/* The width tool on the keyboard: its commands, and the numbers of the stop that is chosen. */
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tools/width/state.h"
#include "editor/view/stage.h"
#include "editor/view/unit.h"
#include <math.h>
#include <string.h>

static void tell(bat_context *c, double width) {
    char text[BAT_UNIT_ROOM];
    bat_unit_write(c, width, text);
    bat_notice_value(c, BAT_STRING_NOTICE_WIDTH_HERE, text);
}

/* A step of its own; `stop` is chosen then, -1: none. */
static bat_status commit(bat_context *c, bat_broadening *b, const bat_breadths *breadths, int stop) {
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK)
        status = bat_transaction_end(c, bat_breadths_put(c, b->object, breadths->count, breadths->stops),
                                     BAT_STRING_STEP_WIDTHS);
    if (status == BAT_OK)
        bat_broadening_keep(c, b, breadths, stop);
    else
        bat_notice_failure(c, status);
    return status;
}

bat_status bat_broadening_add(bat_context *c, bat_broadening *b, double at) {
    bat_breadths breadths;
    b->chosen = false;
    bat_broadening_chosen(c, b, &breadths);
    if (!b->object) return BAT_STATE;
    const int stop = bat_breadths_add(&breadths, at);
    return stop < 0 ? BAT_STATE : commit(c, b, &breadths, stop);
}

/* The selected curve, else the first whose width can be changed. */
static bool choose_some(bat_context *c, bat_broadening *b) {
    bat_seen_sync(c);
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < bat_document_count(c->session->document); i++) {
            const bat_id id = bat_object_id(bat_document_at(c->session->document, i));
            if (pass == 0 && !bat_selection_has(&c->choice->selection, id)) continue;
            if (bat_seen_out_of_reach(c, i) || !bat_broadening_object(c, id, 0)) continue;
            bat_broadening_choose(c, b, id, 0);
            return true;
        }
    return false;
}

static bat_status step(bat_context *c, bat_broadening *b, int direction) {
    bat_breadths breadths;
    if (!b->object && !choose_some(c, b)) return BAT_STATE;
    const bat_object *object = bat_broadening_object(c, b->object, b->curve);
    const int now = bat_broadening_chosen(c, b, &breadths), count = object ? (int)breadths.count : 0;
    const int at = now >= 0 ? now + direction : direction > 0 ? 0 : count - 1;
    b->chosen = false;
    if (at < 0 || at >= count) return BAT_STATE; /* the keyboard focus moves on to what follows the drawing */
    bat_broadening_keep(c, b, &breadths, at);
    tell(c, breadths.stops[at].share * bat_object_style(object)->width);
    return BAT_OK;
}

/* In the middle of the way to the next stop; of the last, to the one before. */
static bat_status add_beside(bat_context *c, bat_broadening *b) {
    bat_breadths breadths;
    const int now = bat_broadening_chosen(c, b, &breadths);
    if (!b->object) return BAT_STATE;
    if (now < 0 || breadths.count < 2) return bat_broadening_add(c, b, 0.5);
    const int last = (int)breadths.count - 1;
    const double from = breadths.stops[now].at;
    double to = breadths.stops[now < last ? now + 1 : last - 1].at;
    if (now == last && breadths.closed) to = breadths.stops[0].at + 1;
    const double at = (from + to) / 2;
    return bat_broadening_add(c, b, at > 1 ? at - 1 : at);
}

static bat_status take_out(bat_context *c, bat_broadening *b) {
    bat_breadths breadths;
    const int now = bat_broadening_chosen(c, b, &breadths);
    if (now < 0) return BAT_STATE;
    bat_width_remove(&breadths.count, breadths.stops, now);
    return commit(c, b, &breadths, -1);
}

/* pixels: across, on either side; along: on the way of the curve. */
static bat_status nudge(bat_context *c, bat_broadening *b, double wider, double along) {
    bat_breadths breadths;
    const bat_object *object = bat_broadening_object(c, b->object, b->curve);
    int at = bat_broadening_chosen(c, b, &breadths);
    if (at < 0) return BAT_STATE;
    const double pixel = bat_stage_pixel(c->stage) * (c->modifiers & BAT_SHIFT ? 10 : 1);
    const double length = bat_broadening_length(object, b->curve), width = bat_object_style(object)->width;
    if (along != 0 && length > 0)
        at = bat_breadths_slide(&breadths, at, breadths.stops[at].at + along * pixel / length);
    bat_breadths_pull(&breadths, at, breadths.stops[at].share + 2 * wider * pixel / width,
                      bat_broadening_pulled(b));
    const bat_status status = commit(c, b, &breadths, at);
    if (status == BAT_OK && wider != 0) tell(c, breadths.stops[at].share * width);
    return status;
}

bat_status bat_broadening_command(bat_context *c, void *state, bat_command_id id) {
    bat_broadening *b = state;
    bat_broadening_settle(c, b);
    switch (id) {
    case BAT_COMMAND_POINT_NEXT: return step(c, b, 1);
    case BAT_COMMAND_POINT_PREVIOUS: return step(c, b, -1);
    case BAT_COMMAND_POINT_ADD: return add_beside(c, b);
    case BAT_COMMAND_POINT_DELETE: return take_out(c, b);
    case BAT_COMMAND_LEVEL_UP: return bat_broadening_step_level(c, b, 1);
    case BAT_COMMAND_LEVEL_DOWN: return bat_broadening_step_level(c, b, -1);
    case BAT_COMMAND_NUDGE_LEFT: return nudge(c, b, 0, -1);
    case BAT_COMMAND_NUDGE_RIGHT: return nudge(c, b, 0, 1);
    case BAT_COMMAND_NUDGE_UP: return nudge(c, b, 1, 0);
    case BAT_COMMAND_NUDGE_DOWN: return nudge(c, b, -1, 0);
    default: return BAT_STATE;
    }
}

bool bat_broadening_number(bat_context *c, bool place, double *value) {
    bat_broadening *b = bat_broadening_of(c);
    bat_breadths breadths;
    if (!b->dragging) bat_broadening_settle(c, b);
    const bat_object *object = bat_broadening_object(c, b->object, b->curve);
    const int now = bat_broadening_chosen(c, b, &breadths);
    if (now < 0) return false;
    *value = place ? breadths.stops[now].at * bat_broadening_length(object, b->curve)
                   : breadths.stops[now].share * bat_object_style(object)->width;
    return true;
}

bat_status bat_broadening_enter(bat_context *c, bool place, double value) {
    bat_broadening *b = bat_broadening_of(c);
    bat_breadths breadths;
    const bat_object *object = bat_broadening_object(c, b->object, b->curve);
    int at = bat_broadening_chosen(c, b, &breadths);
    if (at < 0) return BAT_STATE;
    if (!(value >= 0)) return BAT_ARGUMENT;
    const double length = bat_broadening_length(object, b->curve);
    if (place && length > 0)
        at = bat_breadths_slide(&breadths, at, value / length);
    else if (!place)
        bat_breadths_pull(&breadths, at, value / bat_object_style(object)->width, bat_broadening_pulled(b));
    return commit(c, b, &breadths, at);
}
