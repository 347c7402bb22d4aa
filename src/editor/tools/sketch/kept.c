#include "editor/tools/sketch/kept.h"
#include "editor/choice/choice.h"
#include "editor/edit/curves_of.h"
#include "editor/scene/path.h"
#include "editor/session/session.h"
#include "editor/session/undo.h"
#include "editor/tools/sketch/again.h"
#include <batten/nearest.h>
#include <stdlib.h>
#include <string.h>

static const double STILL = 1e-3; /* px: a stretch that moved less is as it was */
static const float FIT_WIDTH = 2;

/* ---- what is kept ---- */

static void free_stroke(bat_kept_stroke *stroke) {
    if (!stroke) return;
    for (int i = 0; i < stroke->count; i++)
        bat_object_release(stroke->before[i]), bat_object_release(stroke->after[i]);
    bat_samples_free(&stroke->edit.samples);
    free(stroke);
}

static void drop_fit(bat_kept *kept) { bat_edit_result_clear(&kept->fit); }

void bat_kept_free(bat_kept *kept) {
    drop_fit(kept);
    while (kept->count > 0) free_stroke(kept->stroke[--kept->count]);
}

static void drop_oldest(bat_kept *kept) {
    free_stroke(kept->stroke[0]);
    memmove(kept->stroke, kept->stroke + 1, (size_t)--kept->count * sizeof kept->stroke[0]);
}

/* The newest one; as many old ones go as there is no room for. */
static uint32_t push(bat_kept *kept, bat_kept_stroke *stroke) {
    size_t bytes = bat_samples_size(stroke->edit.samples.count);
    int first = kept->count;
    while (first > 0 && kept->count - first < BAT_KEPT_MOST - 1) {
        bytes += bat_samples_size(kept->stroke[first - 1]->edit.samples.count);
        if (bytes > BAT_KEPT_BYTES) break;
        first--;
    }
    while (first-- > 0) drop_oldest(kept);
    stroke->serial = ++kept->serial;
    kept->revision = 0;
    kept->stroke[kept->count++] = stroke;
    return stroke->serial;
}

static const bat_object *object_of(const bat_document *document, bat_id id) {
    return bat_document_at(document, bat_document_find(document, id));
}

static bat_object *retained(const bat_object *object) { return object ? bat_object_retain(object) : NULL; }

/* Places on the curve, along the stroke. */
static void note_places(bat_kept_stroke *stroke, const bat_document *document) {
    const bat_edit *edit = &stroke->edit;
    const bat_samples *samples = &edit->samples;
    const bat_curve *curve = bat_edit_target(document, edit->object, edit->curve);
    stroke->places = 0;
    if (!curve || edit->kind == BAT_EDIT_SEVERAL || edit->kind == BAT_EDIT_LEVEL) return;
    for (size_t i = 0; i < BAT_KEPT_PLACES; i++) {
        bat_near near;
        const double *at = samples->places + 2 * (i * (samples->count - 1) / (BAT_KEPT_PLACES - 1));
        if (bat_curve_nearest(curve, at, &near) != BAT_OK) return;
        memcpy(stroke->place + 2 * i, near.point, 2 * sizeof *near.point);
    }
    stroke->places = BAT_KEPT_PLACES;
}

/* A stroke that has just changed these objects, which were `before`. */
static bat_kept_stroke *create(const bat_document *document, const bat_edit *edit, int count,
                               const bat_id *ids, bat_object *const *before) {
    bat_kept_stroke *stroke = calloc(1, sizeof *stroke);
    if (!stroke) return NULL;
    stroke->edit = *edit;
    stroke->edit.samples = (bat_samples){0};
    if (bat_samples_copy(&edit->samples, &stroke->edit.samples) != BAT_OK) {
        free(stroke);
        return NULL;
    }
    memcpy(stroke->end, edit->samples.places + 2 * (edit->samples.count - 1), 2 * sizeof *stroke->end);
    stroke->count = count;
    for (int i = 0; i < count; i++) {
        stroke->object[i] = ids[i];
        stroke->before[i] = retained(before[i]);
        stroke->after[i] = retained(object_of(document, ids[i]));
    }
    note_places(stroke, document);
    return stroke;
}

/* By the last step: what it changed was `before`. Returns how many objects; 0: too many. */
static int changed(const bat_session *session, bat_id *ids, bat_object **before) {
    const bat_history *history = &session->history;
    if (!history->done) return 0;
    const bat_step *step = &history->steps[history->done - 1];
    if (step->count > BAT_EDIT_PARTS) return 0;
    for (int i = 0; i < step->count; i++) {
        const bat_delta *delta = &step->deltas[i];
        ids[i] = bat_object_id(delta->after ? delta->after : delta->before);
        before[i] = delta->before;
        for (int k = 0; k < i; k++)
            if (ids[k] == ids[i]) return 0;
    }
    return step->count;
}

uint32_t bat_kept_add(const bat_context *c, bat_kept *kept, const bat_edit *edit, double amount,
                      double tolerance, uint32_t instead) {
    const bat_document *document = c->session->document;
    bat_id ids[BAT_EDIT_PARTS];
    bat_object *before[BAT_EDIT_PARTS];
    if (instead && kept->count && kept->stroke[kept->count - 1]->serial == instead)
        free_stroke(kept->stroke[--kept->count]);
    const int count = changed(c->session, ids, before);
    if (!count || !edit->samples.count || edit->samples.dimension == 3 || edit->mirror.on ||
        edit->kind == BAT_EDIT_BLEND) /* whose ends say how it runs, and no tolerance */
        return 0;
    bat_kept_stroke *stroke = create(document, edit, count, ids, before);
    if (!stroke) return 0;
    stroke->amount = amount, stroke->tolerance = tolerance;
    return push(kept, stroke);
}

/* ---- whether it can still be refitted ---- */

static bool same_curves(const bat_object *a, const bat_object *b) {
    if (!a || !b) return a == b;
    if (a == b) return true;
    const int count = bat_object_curve_count(a);
    if (count != bat_object_curve_count(b)) return false;
    for (int i = 0; i < count; i++)
        if (!bat_curve_is_equal(bat_object_curve(a, i), bat_object_curve(b, i))) return false;
    return true;
}

/* All that it changed is as it left it. */
static bool whole(const bat_kept_stroke *stroke, const bat_document *document) {
    for (int i = 0; i < stroke->count; i++)
        if (!same_curves(stroke->after[i], object_of(document, stroke->object[i]))) return false;
    return true;
}

/* Its stretch of the curve is. */
static bool untouched(const bat_kept_stroke *stroke, const bat_document *document) {
    const bat_edit *edit = &stroke->edit;
    const bat_curve *curve = bat_edit_target(document, edit->object, edit->curve);
    bat_near near;
    for (int i = 0; curve && i < stroke->places; i++)
        if (bat_curve_nearest(curve, stroke->place + 2 * i, &near) != BAT_OK ||
            !(near.distance <= STILL * edit->options.pixel))
            return false;
    return curve && stroke->places;
}

static bool concerns(const bat_kept_stroke *stroke, bat_id id) {
    for (int i = 0; i < stroke->count; i++)
        if (stroke->object[i] == id) return true;
    return false;
}

const bat_kept_stroke *bat_kept_offered(const bat_context *c, const bat_kept *kept) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    if (selection->count != 1 || c->session->busy || c->session->read_only) return NULL;
    for (int i = kept->count - 1; i >= 0; i--) {
        const bat_kept_stroke *stroke = kept->stroke[i];
        if (concerns(stroke, selection->ids[0]) && (whole(stroke, document) || untouched(stroke, document)))
            return stroke;
    }
    return NULL;
}

/* ---- refitting ---- */

/* The document as it was before the stroke: only its objects are, and what it removed is in front. */
static bat_status before_it(const bat_kept_stroke *stroke, const bat_document *document, bat_document **out) {
    bat_document *copy = NULL;
    bat_status status = bat_document_copy(document, &copy);
    for (int i = 0; i < stroke->count && status == BAT_OK; i++) {
        const int at = bat_document_find(copy, stroke->object[i]);
        bat_object *free_one = NULL;
        if (!stroke->before[i]) continue;
        status = bat_object_with_parent(stroke->before[i],
                                        at < 0 ? 0 : bat_object_parent(bat_document_at(copy, at)), &free_one);
        if (status == BAT_OK)
            status = at < 0 ? bat_document_insert(copy, bat_document_count(copy), free_one)
                            : bat_document_replace(copy, at, free_one);
        bat_object_release(free_one);
    }
    if (status == BAT_OK)
        *out = copy;
    else
        bat_document_free(copy);
    return status;
}

/* What the edit makes of that document takes the place of the present curves, as one step. */
static bat_status put(bat_context *c, const bat_edit *edit, bat_edit_result *fit) {
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK) status = bat_edit_put(c, edit, fit);
    return bat_transaction_end(c, status, BAT_STRING_STEP_REFIT);
}

/* Makes the step, instead of the last one if that was a refit of the same stroke. */
static bat_status carry_out(bat_context *c, bat_kept *kept, const bat_kept_stroke *stroke,
                            const bat_edit *edit, double amount) {
    const bool again = kept->revision == c->session->revision;
    const uint32_t serial = stroke->serial;
    const bool all = whole(stroke, c->session->document);
    bat_id ids[BAT_EDIT_PARTS];
    bat_object *were[BAT_EDIT_PARTS];
    bat_status status = again ? bat_session_step(c, true) : BAT_OK;
    if (status != BAT_OK) return status;
    status = put(c, edit, &kept->fit);
    if (status != BAT_OK) {
        if (again) bat_session_step(c, false);
        if (again) kept->revision = c->session->revision;
        return status;
    }
    int count = all ? stroke->count : changed(c->session, ids, were);
    bat_kept_stroke *next = !count ? NULL
                                   : create(c->session->document, edit, count, all ? stroke->object : ids,
                                            all ? stroke->before : were);
    if (!next) return BAT_OK;
    next->amount = amount, next->tolerance = stroke->tolerance;
    if (again && kept->stroke[kept->count - 1]->serial == serial) free_stroke(kept->stroke[--kept->count]);
    push(kept, next);
    kept->revision = c->session->revision;
    return BAT_OK;
}

bat_status bat_kept_refit(bat_context *c, bat_kept *kept, double amount, bool done) {
    const bat_kept_stroke *stroke = bat_kept_offered(c, kept);
    if (!stroke) return BAT_STATE;
    if (!(amount >= 0 && amount <= 1)) return BAT_ARGUMENT;
    drop_fit(kept);
    if (done && amount == stroke->amount) return BAT_OK;
    bat_edit edit = stroke->edit;
    bat_document *before = NULL;
    bat_again_amount(&edit, stroke->tolerance, amount);
    const bool all = whole(stroke, c->session->document);
    if (!all) edit.kind = BAT_EDIT_REDRAW, edit.meaning = (bat_sketch_meaning){0};
    bat_status status = all ? before_it(stroke, c->session->document, &before)
                            : bat_document_copy(c->session->document, &before);
    bat_sketch_report report;
    if (status == BAT_OK) status = bat_edit_compute(before, &edit, NULL, &kept->fit, &report);
    if (status == BAT_OK || status == BAT_TOLERANCE) {
        kept->shown = stroke->serial;
        status = done ? carry_out(c, kept, stroke, &edit, amount) : BAT_OK;
        if (done) drop_fit(kept);
    }
    bat_document_free(before);
    return status;
}

void bat_kept_show(const bat_context *c, const bat_kept *kept, bat_overlay *overlay) {
    if (!kept->fit.count) return;
    const bat_kept_stroke *stroke = bat_kept_offered(c, kept);
    if (!stroke || stroke->serial != kept->shown) return;
    for (int i = 0; i < kept->fit.count; i++) {
        bat_overlay_item(overlay, BAT_ROLE_FIT, BAT_ITEM_STROKED, FIT_WIDTH);
        bat_path_curve(&overlay->path, kept->fit.curve[i]);
    }
}
