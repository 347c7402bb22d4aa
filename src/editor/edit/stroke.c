#include "editor/edit/breadths.h"
#include "editor/edit/pressing.h"
#include "editor/tables/settings.h"
#include "editor/edit/mirror.h"
#include "editor/edit/stroke.h"
#include "editor/input/samples.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "hands/levels/shape.h"
#include "text/text.h"
#include "editor/edit/stroke_blend.h"
#include "editor/edit/stroke_record.h"
#include "editor/edit/curves_of.h"
#include <batten/fit.h>
#include <stdlib.h>
#include <string.h>

static const double CORNER = 0.05; /* radians: larger turns stay corners */

const bat_curve *bat_edit_curve(const bat_document *document, const bat_edit *edit, bat_id object,
                                int curve) {
    return bat_edit_target_in(document, bat_stage_dimension(&edit->stage), object, curve);
}

/* The curves of a SEVERAL edit, one per part: BAT_OK, or BAT_TOLERANCE with the best ones found; otherwise none. */
static bat_status chain(const bat_document *document, const bat_edit *edit, bat_curve *out[BAT_EDIT_PARTS]) {
    const bat_curve *curves[BAT_EDIT_PARTS];
    bat_sketch_meaning meaning[BAT_EDIT_PARTS];
    double cuts[BAT_DIMENSION_MAX * BAT_EDIT_PARTS];
    bat_stroke stroke = bat_samples_stroke(&edit->samples, 0);
    const size_t d = (size_t)stroke.dimension;
    for (int i = 0; i < edit->part_count; i++) {
        curves[i] = bat_edit_curve(document, edit, edit->part[i].object, edit->part[i].curve);
        meaning[i] = edit->part[i].meaning;
        memcpy(cuts + d * (size_t)i, edit->part[i].end, d * sizeof *cuts);
        bool twice = false;
        for (int j = 0; j < i; j++) twice = twice || curves[j] == curves[i];
        if (!curves[i] || twice) return BAT_ARGUMENT;
    }
    return bat_sketch_chain(edit->part_count, curves, cuts, meaning, &stroke, &edit->options, out);
}

/* The curve of an edit that makes one. */
static bat_status one_curve(const bat_document *document, const bat_edit *edit, bat_curve **out,
                            bat_sketch_report *report) {
    bat_stroke stroke = bat_samples_stroke(&edit->samples, 0);
    if (edit->kind == BAT_EDIT_NEW && edit->meaning.mark)
        return bat_sketch_mark(&stroke, &edit->options, out, report);
    if (edit->kind == BAT_EDIT_NEW)
        return bat_sketch_new_meant(&stroke, &edit->options, &edit->meaning, out, report);
    const bat_curve *target = bat_edit_curve(document, edit, edit->object, edit->curve);
    if (!target) return BAT_ARGUMENT;
    if (edit->kind == BAT_EDIT_REDRAW || edit->kind == BAT_EDIT_EXTEND)
        return bat_sketch_meant(target, &stroke, &edit->options, &edit->meaning, out, report);
    if (edit->kind == BAT_EDIT_CLOSE) return bat_sketch_close(target, &stroke, &edit->options, out, report);
    if (edit->kind == BAT_EDIT_SMOOTH) return bat_sketch_smooth(target, &stroke, &edit->options, out, report);
    const bat_curve *other = bat_edit_curve(document, edit, edit->other, edit->other_curve);
    if (edit->kind == BAT_EDIT_BLEND && other) return bat_edit_blend(target, other, &stroke, out);
    if (!other || other == target) return BAT_ARGUMENT;
    return bat_sketch_join(target, other, &stroke, &edit->options, out, report);
}

size_t bat_edit_pressed(const bat_edit *edit, const bat_curve *curve, bat_width_stop *stops) {
    bat_pressing pressing;
    if (!edit->pressed || !bat_pressing_curve(&pressing, curve)) return 0;
    bat_pressing_add(&pressing, &edit->samples);
    return bat_pressing_stops(&pressing, edit->meaning.mark ? 0 : edit->style.width, stops);
}

/* The levels of a LEVEL edit, and the finest of them as its curve. */
static bat_status levels(const bat_document *document, const bat_edit *edit, bat_edit_result *out,
                         bat_sketch_report *report) {
    if (!bat_edit_curve(document, edit, edit->object, edit->curve)) return BAT_ARGUMENT;
    bat_status status = bat_edit_shape(document, edit, &out->shape, report);
    if (!out->shape) return status;
    bat_status copied = bat_shape_flatten(out->shape, out->curve);
    return copied == BAT_OK ? status : copied;
}

void bat_edit_result_clear(bat_edit_result *result) {
    for (int i = 0; i < result->count; i++) bat_curve_free(result->curve[i]);
    if (result->shape) bat_shape_free(result->shape);
    *result = (bat_edit_result){0};
}

/* On extremes and whole numbers, which is how fonts have outlines; what is smaller than that, or in space, stays. */
static bat_status put_on_extremes(const bat_edit *edit, bat_edit_result *made) {
    const double tolerance = edit->options.tolerance > 0 ? edit->options.tolerance : edit->options.pixel;
    for (int i = 0; i < made->count && !made->shape; i++) {
        bat_curve *fit = NULL;
        const bat_status status = bat_curve_refit_extremes(made->curve[i], tolerance, CORNER, 1, &fit, NULL);
        if (status == BAT_MEMORY) return status;
        if (status != BAT_OK) continue;
        bat_curve_free(made->curve[i]);
        made->curve[i] = fit;
    }
    return BAT_OK;
}

bat_status bat_edit_compute(const bat_document *document, const bat_edit *edit, bat_sketch_live *live,
                            bat_edit_result *out, bat_sketch_report *report) {
    bat_edit_result made = {.count = edit->kind == BAT_EDIT_SEVERAL ? edit->part_count : 1};
    bat_status status;
    *report = (bat_sketch_report){0};
    *out = (bat_edit_result){0};
    if (live)
        status = bat_sketch_live_commit(live, made.curve, report);
    else if (edit->kind == BAT_EDIT_SEVERAL)
        status = chain(document, edit, made.curve);
    else if (edit->kind == BAT_EDIT_LEVEL)
        status = levels(document, edit, &made, report);
    else
        status = one_curve(document, edit, made.curve, report);
    if (status == BAT_OK && !made.curve[0]) status = BAT_SINGULAR;
    bool any = status == BAT_OK || status == BAT_TOLERANCE;
    if (any && edit->on_extremes && edit->kind != BAT_EDIT_BLEND && put_on_extremes(edit, &made) != BAT_OK)
        status = BAT_MEMORY, any = false;
    if (any)
        *out = made;
    else if (status == BAT_MEMORY)
        bat_edit_result_clear(&made);
    else
        bat_shape_free(made.shape);
    return status;
}

bat_status bat_edit_put(bat_context *c, const bat_edit *edit, bat_edit_result *result) {
    bat_status status = BAT_OK;
    if (result->shape) {
        bat_shape *shape = result->shape;
        result->shape = NULL;
        status = bat_put_shape(c, edit->object, edit->curve, shape);
    } else {
        for (int i = 0; i < result->count && status == BAT_OK; i++) {
            const bool several = edit->kind == BAT_EDIT_SEVERAL;
            bat_curve *curve = result->curve[i];
            result->curve[i] = NULL;
            status = bat_put_curve(c, several ? edit->part[i].object : edit->object,
                                   several ? edit->part[i].curve : edit->curve, curve);
        }
    }
    bat_edit_result_clear(result);
    return status;
}

/* The object just made, with the pen's pressure as the width along it; flat lines stay flat. */
static bat_status press(bat_context *c, const bat_edit *edit) {
    const bat_curve *curve = bat_edit_target(c->session->document, edit->object, 0);
    bat_width_stop stops[BAT_PRESSED_STOPS];
    const size_t count = curve ? bat_edit_pressed(edit, curve, stops) : 0;
    return count ? bat_breadths_put(c, edit->object, count, stops) : BAT_OK;
}

/* A new object of the result's one curve. */
static bat_status insert(bat_context *c, const bat_edit *edit, bat_edit_result *result) {
    bat_curve *curve = result->curve[0];
    result->curve[0] = NULL;
    const bat_status status = bat_keep_view_plane(c, &edit->stage.ground, edit->object);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    return bat_insert_curve(c, edit->object, &edit->style, edit->parent, curve);
}

/* A new object of it in front of the edit's, in the same style. */
static bat_status insert_beside(bat_context *c, const bat_edit *edit, bat_edit_result *result) {
    bat_document *document = c->session->document;
    const int index = bat_document_find(document, edit->object);
    bat_object *made = NULL, *placed = NULL;
    bat_curve *curve = result->curve[0];
    result->curve[0] = NULL;
    bat_status status = bat_object_with_curves(bat_document_at(document, index), 1, &curve, &made);
    if (status == BAT_OK) status = bat_object_with_id(made, bat_document_new_id(document), &placed);
    if (status == BAT_OK) status = bat_transaction_insert(c, index + 1, placed);
    bat_object_release(made), bat_object_release(placed);
    return status;
}

bat_status bat_edit_commit(bat_context *c, const bat_edit *edit, bat_edit_result *result) {
    bat_text line = {0};
    bat_edit_write(edit, &line);
    bat_status status = bat_transaction_begin(c);
    if (status == BAT_OK)
        status = edit->kind == BAT_EDIT_NEW     ? insert(c, edit, result)
                 : edit->kind == BAT_EDIT_BLEND ? insert_beside(c, edit, result)
                                                : bat_edit_put(c, edit, result);
    bat_edit_result_clear(result);
    if (status == BAT_OK && edit->kind == BAT_EDIT_NEW) status = bat_dash_new(c, edit->object, edit->dashes);
    if (status == BAT_OK && edit->kind == BAT_EDIT_NEW) status = press(c, edit);
    /* The joined curve replaces the first; the second has become part of it. */
    if (status == BAT_OK && edit->kind == BAT_EDIT_JOIN)
        status = bat_remove_curve(c, edit->other, edit->other_curve);
    if (status == BAT_OK && edit->mirror.on)
        status = bat_mirror_changes(c, &edit->mirror, BAT_MIRROR_STROKE, edit->options.pixel,
                                    edit->options.tolerance);
    if (status == BAT_OK)
        status = bat_transaction_commit(c, bat_edit_label(edit->kind), &line);
    else
        bat_transaction_cancel(c);
    bat_text_free(&line);
    if (status == BAT_OK && edit->kind == BAT_EDIT_REDRAW) bat_settings_follow(c->settings, BAT_FIRST_DRAW);
    return status;
}
