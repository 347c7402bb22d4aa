/* The preview of the stroke so far: its samples are fitted while the pen is down, once per frame. */
#include "document/document.h"
#include "editor/edit/curves_of.h"
#include "editor/edit/mirror.h"
#include "editor/input/samples.h"
#include "editor/session/session.h"
#include "editor/tools/sketch/parts.h"
#include "editor/view/stage.h"
#include <string.h>

bool bat_sketching_one_changes(const bat_edit *edit) {
    return edit->kind == BAT_EDIT_REDRAW || edit->kind == BAT_EDIT_EXTEND || edit->kind == BAT_EDIT_SMOOTH ||
           edit->kind == BAT_EDIT_LEVEL;
}

bat_status bat_sketching_feed(bat_context *c, bat_sketching *s) {
    if (!s->live) {
        bat_sketch_kind kind = s->edit.kind == BAT_EDIT_SMOOTH       ? BAT_SKETCH_SMOOTH
                               : bat_sketching_one_changes(&s->edit) ? BAT_SKETCH_REDRAW
                                                                     : BAT_SKETCH_NEW;
        const bat_curve *target = NULL;
        if (kind != BAT_SKETCH_NEW)
            target = bat_edit_curve(c->session->document, &s->edit, s->edit.object, s->edit.curve);
        if (kind != BAT_SKETCH_NEW && !target) return BAT_STATE;
        s->fed = 0;
        bat_status status = bat_sketch_live_begin(target, bat_stage_dimension(&s->edit.stage), kind,
                                                  &s->edit.options, &s->live);
        if (status != BAT_OK) return status;
    }
    if (s->edit.kind != BAT_EDIT_SMOOTH) bat_sketch_mean(s->live, &s->edit.meaning);
    if (s->fed == s->edit.samples.count) return BAT_OK;
    bat_stroke more = bat_samples_stroke(&s->edit.samples, s->fed);
    bat_status status = bat_sketch_live_add(s->live, &more);
    if (status == BAT_OK) s->fed = s->edit.samples.count;
    return status;
}

bool bat_sketching_converged(const bat_context *c, const bat_sketching *s, bat_together *together,
                             bat_curve **curve, bat_sketch_report *report) {
    const bat_edit *edit = &s->edit;
    if (s->forced || s->smoothing) return false;
    if (bat_hairs_join(c, &s->hairs, edit, together) != BAT_OK) return false;
    const bat_curve *target = bat_edit_target(c->session->document, edit->object, edit->curve);
    if (bat_together_shape(together, edit, 1, target, curve, report) == BAT_OK) return true;
    bat_together_drop(together);
    return false;
}

/* Shows what careless strokes make of their line. */
static bool preview_converged(const bat_context *c, bat_sketching *s) {
    bat_together together = {0};
    bat_sketching_preview *preview = &s->preview;
    preview->converges = bat_sketching_converged(c, s, &together, &preview->curve, &preview->report);
    preview->stop_count = together.stop_count;
    memcpy(preview->stops, together.stops, sizeof preview->stops);
    bat_together_drop(&together);
    return preview->converges;
}

static void fit(bat_context *c, bat_sketching *s) {
    if (preview_converged(c, s)) return;
    bat_sketch_live_info info = {0};
    bat_curve *curve = NULL;
    bat_status status;
    if (s->edit.kind == BAT_EDIT_LEVEL) {
        bat_edit_result result;
        status = bat_edit_compute(c->session->document, &s->edit, NULL, &result, &info.report);
        curve = result.curve[0];
        result.curve[0] = NULL;
        bat_edit_result_clear(&result);
    } else {
        status = bat_sketching_feed(c, s);
        if (status == BAT_OK) status = bat_sketch_live_preview(s->live, &curve, &info);
    }
    s->preview.status = status;
    if (status != BAT_OK && status != BAT_TOLERANCE) return;
    s->preview.curve = curve;
    s->preview.report = info.report;
    if (curve && s->edit.kind == BAT_EDIT_NEW)
        s->preview.stop_count = bat_edit_pressed(&s->edit, curve, s->preview.stops);
}

/* What follows the curve; with symmetry, also what follows its twin, which becomes its image. */
static void follow(bat_context *c, bat_sketching *s) {
    const bat_mirror *mirror = &s->edit.mirror;
    const double pixel = s->edit.options.pixel;
    bat_follow_change changes[2] = {{s->edit.object, s->preview.curve}};
    bat_curve *image = NULL;
    int count = 1, curve = 0;
    const bool doubles = mirror->on && bat_document_has_followers(c->session->document);
    const bat_id twin = doubles ? bat_mirror_twin(c, mirror, pixel, s->edit.object, 0, &curve) : 0;
    if (twin == s->edit.object) {
        const bat_object *object = bat_document_at(c->session->document,
                                                   bat_document_find(c->session->document, twin));
        bat_mirror_preview(c, mirror, pixel, s->edit.options.tolerance, bat_object_curve(object, 0),
                           s->preview.curve, &image);
        if (image) changes[0].curve = image;
    } else if (twin && curve == 0 && bat_mirror_curve(mirror, s->preview.curve, &image) == BAT_OK) {
        changes[count++] = (bat_follow_change){twin, image};
    }
    bat_followers_of(c, count, changes, &s->preview.followers);
    bat_curve_free(image);
}

void bat_sketching_refresh_preview(bat_context *c, bat_sketching *s) {
    s->preview_due = false;
    bat_sketching_drop_preview(s);
    fit(c, s);
    if (s->preview.curve && s->edit.curve == 0 && bat_sketching_one_changes(&s->edit)) follow(c, s);
}
