/* When the pen is lifted: the meaning of the whole stroke is carried out. */
#include "editor/edit/arrange.h"
#include "base/real.h"
#include "editor/edit/curves_of.h"
#include "editor/pick/surface.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/undo.h"
#include "editor/tools/sketch/parts.h"
#include "editor/view/stage.h"
#include <math.h>
#include <string.h>

static const double DOUBLE_TAP = 400, NEAR = 8; /* ms, px */

/* Computes what is fitted to the stroke. */
static bat_status compute(bat_context *c, bat_sketching *s, bat_edit_result *result,
                          bat_sketch_report *report) {
    bat_sketch_live *live = NULL;
    if (s->edit.kind == BAT_EDIT_SMOOTH || s->forced) {
        bat_status status = s->edit.kind == BAT_EDIT_LEVEL ? BAT_OK : bat_sketching_feed(c, s);
        if (status != BAT_OK) return status;
        live = s->live;
        s->live = NULL;
    }
    return bat_edit_compute(c->session->document, &s->edit, live, result, report);
}

/* Carries out the best reading of the whole stroke, or the next one that works. A forced redraw that is too far away
 * makes a new curve. */
static bat_status make(bat_context *c, bat_sketching *s, bat_edit_result *result, bat_sketch_report *report,
                       bool *strayed) {
    bat_edit *edit = &s->edit;
    bat_status status = BAT_OK;
    int tried = 0;
    if (!s->forced && !s->smoothing) {
        status = bat_meaning_look(c, &s->meaning, &edit->stage, &edit->samples, true);
        if (status != BAT_OK && status != BAT_DOT) return status;
        s->nothing = status == BAT_OK && !s->meaning.count;
        if (status == BAT_DOT) s->meaning.count = 0;
        if (s->nothing) return BAT_STATE;
    }
    do {
        if (tried < s->meaning.count && !s->smoothing)
            bat_meaning_apply(c, &s->meaning, &s->meaning.readings[tried], edit);
        status = compute(c, s, result, report);
        if (status == BAT_FAR && edit->kind != BAT_EDIT_NEW && edit->kind != BAT_EDIT_SMOOTH && s->forced) {
            edit->kind = BAT_EDIT_NEW;
            *strayed = true;
            return bat_edit_compute(c->session->document, edit, NULL, result, report);
        }
    } while (status != BAT_OK && status != BAT_TOLERANCE && status != BAT_MEMORY && status != BAT_DOT &&
             status != BAT_STATE && ++tried < s->meaning.count);
    return status;
}

/* Handles one of several careless strokes over a line: the line becomes what all of them together mean, and the
 * readings of the stroke by itself are kept. */
static bool converge(bat_context *c, bat_sketching *s) {
    bat_curve *curve = NULL;
    bat_sketch_report report;
    bat_together together = {0};
    if (!bat_sketching_converged(c, s, &together, &curve, &report)) return false;
    bat_again_gather(c, &s->meaning, &s->edit, &s->again);
    bat_status status = bat_together_commit(c, &together, &s->edit, curve);
    if (status == BAT_OK) {
        bat_hairs_note(c, &s->hairs, &s->edit, true);
        bat_again_keep(c, &s->again, &s->edit, &s->edit.samples, &s->hold);
        bat_again_converged(&s->again, &together);
        bat_notice(c, BAT_STRING_COUNT);
    } else {
        bat_again_drop(&s->again);
        bat_notice_failure(c, status);
    }
    bat_together_drop(&together);
    return true;
}

/* Commits the result, and keeps the other readings of the stroke. */
static void commit(bat_context *c, bat_sketching *s, bat_edit_result *result, const bat_sketch_report *report,
                   bool strayed) {
    bool closed = bat_curve_is_closed(result->curve[0]), choice = !s->forced && !s->smoothing;
    if (choice) bat_again_gather(c, &s->meaning, &s->edit, &s->again);
    bat_status status = bat_edit_commit(c, &s->edit, result);
    if (status != BAT_OK) {
        bat_again_drop(&s->again);
        bat_notice_failure(c, status);
        return;
    }
    bat_sketching_say_done(c, &s->edit, report, strayed, closed);
    bat_hairs_note(c, &s->hairs, &s->edit, false);
    if (!choice) return;
    bat_again_keep(c, &s->again, &s->edit, &s->edit.samples, &s->hold);
    bat_sketching_keep(c, s);
}

/* A second tap on a surface makes it the ground, or the page again; the dot that the first one made goes. */
static bool tapped(bat_context *c, bat_sketching *s) {
    const double *at = s->edit.samples.pixels;
    const double far = bat_hypot(at[0] - s->tap[0], at[1] - s->tap[1]);
    const bool twice = s->tap_time > 0 && c->time - s->tap_time <= DOUBLE_TAP && far <= NEAR;
    memcpy(s->tap, at, sizeof s->tap);
    s->tap_time = twice ? 0 : c->time;
    const bat_object *surface = twice ? bat_pick_surface(c, at) : NULL;
    if (!surface) return false;
    if (s->tap_revision == c->session->revision) bat_session_step(c, true);
    bat_ground_take(c, bat_object_id(surface) == c->stage->ground.object ? NULL : surface);
    return true;
}

/* Sets the edit for a stroke that is too short for any other meaning, and computes it. */
static bat_status mark(bat_context *c, bat_sketching *s, bat_edit_result *result, bat_sketch_report *report) {
    bat_edit *edit = &s->edit;
    const bat_samples *samples = &edit->samples;
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    edit->kind = BAT_EDIT_NEW;
    edit->object = edit->other = 0;
    edit->curve = edit->other_curve = edit->part_count = 0;
    edit->meaning = (bat_sketch_meaning){.mark = true};
    s->meaning.count = 0;
    for (size_t i = 0; i < 2 * samples->count; i++) {
        low[i % 2] = fmin(low[i % 2], samples->pixels[i]);
        high[i % 2] = fmax(high[i % 2], samples->pixels[i]);
    }
    /* What is hardly longer than the line is wide would hardly be seen without its ends. */
    if (bat_hypot(high[0] - low[0], high[1] - low[1]) * edit->options.pixel < edit->style.width)
        edit->style.cap = BAT_CAP_ROUND;
    return bat_edit_compute(c->session->document, edit, NULL, result, report);
}

void bat_sketching_up(bat_context *c, void *state, const bat_pointer *event) {
    bat_sketching *s = state;
    if (s->state != BAT_SKETCHING_DRAWING) return;
    if (s->has_pending) { /* a real stroke would have dropped it, so this was a tap */
        bat_sketching_accept(c, s);
        return;
    }
    if (bat_sketching_smooths_nothing(s)) {
        bat_sketching_end_stroke(s);
        bat_notice(c, BAT_STRING_NOTICE_NOTHING_TO_SMOOTH);
        return;
    }
    (void)event;
    bat_edit_result result = {0};
    bat_sketch_report report;
    bool strayed = false;
    const bool left = s->edit.samples.last.beside;
    const bool beside = 3 * s->dropped > s->dropped + s->edit.samples.count;
    bat_status status = beside ? BAT_FAR : make(c, s, &result, &report, &strayed);
    bool again = false;
    const bool dot = status == BAT_DOT && !s->smoothing && !s->forced;
    if (dot) again = tapped(c, s);
    if (dot && !again) status = mark(c, s, &result, &report);
    if (status == BAT_TOLERANCE && s->edit.kind == BAT_EDIT_NEW) s->edit.accepted = true, status = BAT_OK;
    if (again) {
        bat_notice(c, BAT_STRING_COUNT);
    } else if (status == BAT_OK || status == BAT_TOLERANCE) {
        if (s->edit.kind == BAT_EDIT_NEW) {
            s->edit.object = bat_document_new_id(c->session->document);
            bat_arrange_place(c, &s->edit.parent);
        }
        if (converge(c, s)) {
            bat_edit_result_clear(&result);
        } else if (status == BAT_TOLERANCE) {
            bat_sketching_keep_pending(s, &result, &report);
            bat_notice(c, BAT_STRING_NOTICE_PENDING);
        } else {
            commit(c, s, &result, &report, strayed);
        }
    } else {
        bat_sketching_say_failed(c, s, status);
    }
    if (dot) s->tap_revision = c->session->revision, s->tap_touched = s->device == BAT_DEVICE_TOUCH;
    bat_sketching_say_dropped(c, s, beside, left);
    bat_sketching_end_stroke(s);
}
