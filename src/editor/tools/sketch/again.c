#include "editor/tools/sketch/again.h"
#include "base/real.h"
#include "editor/choice/choice.h"
#include "editor/edit/arrange.h"
#include "editor/edit/curves_of.h"
#include "editor/session/session.h"
#include "editor/session/undo.h"
#include <math.h>
#include <string.h>

static const double RANGE = 16;     /* tolerance of the fairest over that of the rawest */
static const double NOT_MUCH = 0.5; /* how much dearer than the best a reading may be, px per px of stroke */

static bool same(const bat_edit *a, const bat_edit *b) {
    return a->kind == b->kind && a->object == b->object && a->curve == b->curve && a->other == b->other &&
           a->other_curve == b->other_curve && a->part_count == b->part_count;
}

/* What the edit, not yet done, will redraw. */
static void note_before(const bat_context *c, bat_again *again, const bat_edit *edit) {
    const bat_curve *target = NULL;
    if (edit->kind == BAT_EDIT_REDRAW || edit->kind == BAT_EDIT_EXTEND)
        target = bat_edit_target(c->session->document, edit->object, edit->curve);
    bat_curve_free(again->before);
    again->before = NULL;
    if (target) bat_curve_copy(target, &again->before); /* no memory: no preview */
}

static void offer(bat_again *again, const bat_edit *edit) {
    for (int i = 0; i < again->count; i++)
        if (same(&again->edit[i], edit)) return;
    again->edit[again->count++] = *edit;
}

/* What joins two curves, or closes one, could be a curve of its own between their ends. */
static void offer_blend(bat_again *again) {
    for (int i = 0; i < again->count; i++) {
        bat_edit blend = again->edit[i];
        if (blend.kind != BAT_EDIT_JOIN && blend.kind != BAT_EDIT_CLOSE) continue;
        if (blend.kind == BAT_EDIT_CLOSE) blend.other = blend.object, blend.other_curve = blend.curve;
        blend.kind = BAT_EDIT_BLEND;
        offer(again, &blend);
        return;
    }
}

void bat_again_gather(bat_context *c, const bat_meaning *m, const bat_edit *edit, bat_again *again) {
    bat_again_drop(again);
    note_before(c, again, edit);
    for (int i = 0; i < m->count; i++) {
        const bat_intent_reading *reading = &m->readings[i];
        bool fresh = reading->kind == BAT_INTENT_NEW;
        bool near = reading->cost - m->readings[0].cost <= NOT_MUCH * bat_intent_length(m->intent);
        if (!fresh && (!(near || reading->between) || again->count >= BAT_AGAIN_MOST - 1))
            continue; /* one place is for the new line */
        bat_edit other = *edit;
        bat_meaning_apply(c, m, reading, &other);
        if (again->count < BAT_AGAIN_MOST) offer(again, &other);
    }
    offer_blend(again);
}

static void take_samples(bat_samples *own, bat_samples *samples) {
    bat_samples spare = *own;
    *own = *samples;
    *samples = spare;
    bat_samples_clear(samples);
}

/* The figure that the stroke offers, in place of what it was taken as. */
static void keep_figure(bat_again *again, const bat_sketch_hold *hold) {
    again->figure = again->converged = -1;
    again->kind = hold->figure.kind;
    const bat_edit *drawn = &again->edit[again->at];
    if (bat_hold_edit(hold, drawn, &again->along, &again->edit[again->count]) == BAT_OK)
        again->figure = again->count++;
}

void bat_again_keep(bat_context *c, bat_again *again, const bat_edit *edit, bat_samples *samples,
                    const bat_sketch_hold *hold) {
    again->at = -1;
    for (int i = 0; i < again->count; i++)
        if (again->edit[i].kind == edit->kind && (edit->kind == BAT_EDIT_NEW || same(&again->edit[i], edit)))
            again->at = i;
    again->amount = 0.5;
    again->tolerance = edit->options.tolerance;
    if (again->at < 0 || !samples->count) {
        again->count = 0;
        return;
    }
    again->edit[again->at].object = edit->object;
    take_samples(&again->samples, samples);
    for (int i = 0; i < again->count; i++) again->edit[i].samples = again->samples;
    keep_figure(again, hold);
    const size_t size = (size_t)again->samples.dimension;
    again->place[2] = 0;
    memcpy(again->place, again->samples.places + size * (again->samples.count - 1),
           size * sizeof *again->place);
    again->revision = c->session->revision;
    again->selection = c->choice->selection.version;
    again->kept = 0;
    again->version++;
}

void bat_again_converged(bat_again *again, bat_together *together) {
    if (!again->count) return;
    again->converged = again->count++;
    again->edit[again->converged] = again->edit[again->at];
    again->at = again->converged;
    again->together = *together;
    *together = (bat_together){0};
}

static void drop_fit(bat_again *again) { bat_edit_result_clear(&again->fit); }

void bat_again_drop(bat_again *again) {
    drop_fit(again);
    bat_together_drop(&again->together);
    again->count = 0;
}

void bat_again_free(bat_again *again) {
    bat_again_drop(again);
    bat_curve_free(again->before);
    again->before = NULL;
    bat_samples_free(&again->samples);
    bat_samples_free(&again->along);
}

bool bat_again_holds(const bat_context *c, const bat_again *again) {
    return again->count > 0 && again->revision == c->session->revision;
}

/* What the strokes together mean, with the edit's tolerance. */
static bat_status converge(const bat_again *again, const bat_edit *edit, bat_curve **out) {
    bat_sketch_report report;
    if (!again->before) return BAT_STATE;
    return bat_together_shape(&again->together, edit, edit->options.tolerance / again->tolerance,
                              again->before, out, &report);
}

/* at: the reading. */
static bat_status carry_out(bat_context *c, bat_again *again, bat_edit *edit, int at) {
    bat_edit_result result;
    bat_sketch_report report;
    note_before(c, again, edit);
    if (at == again->converged) {
        bat_curve *curve = NULL;
        bat_status status = converge(again, edit, &curve);
        if (status != BAT_OK) return status;
        return bat_together_commit(c, &again->together, edit, curve);
    }
    bat_status status = bat_edit_compute(c->session->document, edit, NULL, &result, &report);
    if (status != BAT_OK && status != BAT_TOLERANCE) return status;
    edit->accepted = status == BAT_TOLERANCE; /* it was asked for by name */
    if (edit->kind == BAT_EDIT_NEW) {
        edit->object = bat_document_new_id(c->session->document);
        bat_arrange_place(c, &edit->parent);
    }
    return bat_edit_commit(c, edit, &result);
}

bat_status bat_again_read(bat_context *c, bat_again *again, int at) {
    if (!bat_again_holds(c, again) || at < 0 || at >= again->count) return BAT_STATE;
    if (at == again->at) return BAT_OK;
    drop_fit(again);
    bat_status status = bat_session_step(c, true);
    if (status != BAT_OK) return status;
    status = carry_out(c, again, &again->edit[at], at);
    if (status == BAT_OK) {
        again->at = at;
        again->amount = 0.5;
        again->tolerance = again->edit[at].options.tolerance;
    } else {
        bat_session_step(c, false);
    }
    again->revision = c->session->revision;
    again->version++;
    return status;
}

/* What the edit makes of the document as it was before the stroke. */
static bat_status preview(const bat_context *c, bat_again *again, const bat_edit *edit) {
    bat_document *before = NULL;
    bat_sketch_report report;
    bat_status status;
    drop_fit(again);
    if (again->at == again->converged) {
        status = converge(again, edit, again->fit.curve);
        again->fit.count = status == BAT_OK;
    } else {
        status = bat_history_before(&c->session->history, c->session->document, &before);
        if (status == BAT_OK) status = bat_edit_compute(before, edit, NULL, &again->fit, &report);
        bat_document_free(before);
    }
    return status == BAT_MEMORY ? status : BAT_OK;
}

void bat_again_amount(bat_edit *edit, double tolerance, double amount) {
    edit->options.tolerance = tolerance * bat_exp((amount - 0.5) * bat_log(RANGE));
    edit->options.fairness = (1 - amount) * BAT_FAIRNESS_LEAST + amount * BAT_FAIRNESS_MOST;
}

bat_status bat_again_refit(bat_context *c, bat_again *again, double amount, bool done) {
    if (!bat_again_holds(c, again)) return BAT_STATE;
    if (!(amount >= 0 && amount <= 1)) return BAT_ARGUMENT;
    bat_edit *now = &again->edit[again->at], edit = *now;
    bat_again_amount(&edit, again->tolerance, amount);
    if (!done) return preview(c, again, &edit);
    drop_fit(again);
    if (amount == again->amount) return BAT_OK;
    bat_status status = bat_session_step(c, true);
    if (status != BAT_OK) return status;
    status = carry_out(c, again, &edit, again->at);
    if (status == BAT_OK) {
        *now = edit;
        again->amount = amount;
    } else {
        bat_session_step(c, false);
    }
    again->revision = c->session->revision;
    return status;
}

bat_string bat_again_word(const bat_again *again, int reading) {
    static const bat_string words[BAT_EDIT_COUNT] = {
        [BAT_EDIT_NEW] = BAT_STRING_READ_NEW,        [BAT_EDIT_REDRAW] = BAT_STRING_READ_REDRAW,
        [BAT_EDIT_SMOOTH] = BAT_STRING_READ_REDRAW,  [BAT_EDIT_JOIN] = BAT_STRING_READ_JOIN,
        [BAT_EDIT_LEVEL] = BAT_STRING_READ_REDRAW,   [BAT_EDIT_EXTEND] = BAT_STRING_READ_EXTEND,
        [BAT_EDIT_BLEND] = BAT_STRING_READ_BLEND,    [BAT_EDIT_CLOSE] = BAT_STRING_READ_CLOSE,
        [BAT_EDIT_SEVERAL] = BAT_STRING_READ_SEVERAL};
    if (reading == again->figure) return bat_hold_word(again->kind);
    if (reading == again->converged) return BAT_STRING_READ_CONVERGED;
    return words[again->edit[reading].kind];
}
