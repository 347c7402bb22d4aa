/* A stroke over a curve with levels: one level follows it, and the finer ones ride along. */
#include "editor/edit/stroke.h"
#include "editor/input/samples.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "hands/levels/shape.h"
#include <batten/nearest.h>
#include <math.h>

enum { MEASURED = 64 }; /* samples used to decide whether a level can follow the stroke */

/* Whether the stroke's samples lie within the tolerance of the shape. */
static bat_status meets(const bat_shape *shape, const bat_edit *edit, bool *near_enough) {
    bat_finder *finder = NULL;
    const bat_samples *samples = &edit->samples;
    const bat_stroke stroke = bat_samples_stroke(samples, 0);
    double worst = 0;
    size_t step = samples->count / MEASURED + 1;
    bat_status status = bat_finder_create(bat_shape_curve(shape, bat_shape_levels(shape)), &finder);
    if (status != BAT_OK) return status;
    for (size_t i = 0; i < samples->count; i += step) {
        bat_near near;
        bat_finder_nearest(finder, stroke.points + i * (size_t)stroke.dimension, &near);
        worst = fmax(worst, near.distance);
    }
    bat_finder_free(finder);
    *near_enough = worst <= edit->options.tolerance;
    return BAT_OK;
}

static bat_status at_level(const bat_shape *from, const bat_edit *edit, int level, bat_shape **out,
                           bat_sketch_report *report) {
    bat_shape *shape = NULL;
    bat_stroke stroke = bat_samples_stroke(&edit->samples, 0);
    bat_status status = bat_shape_copy(from, &shape);
    if (status == BAT_OK) status = bat_shape_redraw_level(shape, level, &stroke, &edit->options, report);
    if (status == BAT_OK) status = bat_shape_commit(shape);
    if (status != BAT_OK)
        bat_shape_free(shape);
    else
        *out = shape;
    return status;
}

static bat_status freely(const bat_shape *from, const bat_edit *edit, bat_shape **out,
                         bat_sketch_report *report) {
    bat_shape *shape = NULL;
    bat_stroke stroke = bat_samples_stroke(&edit->samples, 0);
    bat_status status = bat_shape_redraw(from, &stroke, edit->level == BAT_LEVEL_BARE, &edit->options, &shape,
                                         report);
    if (status != BAT_OK && status != BAT_TOLERANCE) return status;
    bat_status done = bat_shape_commit(shape);
    if (done != BAT_OK) {
        bat_shape_free(shape);
        return done;
    }
    *out = shape;
    return status;
}

bat_status bat_edit_shape(const bat_document *document, const bat_edit *edit, bat_shape **out,
                          bat_sketch_report *report) {
    const bat_object *object = bat_document_at(document, bat_document_find(document, edit->object));
    const bat_shape *from = object ? bat_object_shape(object, edit->curve) : NULL;
    if (!from || bat_curve_dimension(bat_shape_curve(from, 0)) != bat_stage_dimension(&edit->stage))
        return BAT_ARGUMENT;
    int top = bat_shape_levels(from);
    if (edit->level > top) return BAT_ARGUMENT;
    if (edit->level >= 0) return at_level(from, edit, edit->level, out, report);
    if (edit->level != BAT_LEVEL_AUTO) return freely(from, edit, out, report);
    bat_shape *best = NULL; /* the finest when none is close enough */
    bat_status status = BAT_STATE;
    for (int level = 0; level <= top; level++) {
        bat_shape *shape = NULL;
        bat_status now = at_level(from, edit, level, &shape, report);
        if (now == BAT_STATE) continue; /* skip it */
        bool near = false;
        if (now == BAT_OK && report->spans >= BAT_LEVEL_SPANS_LEAST) now = meets(shape, edit, &near);
        bat_shape_free(best);
        best = shape;
        status = now;
        if (status != BAT_OK || near) break;
    }
    if (status == BAT_OK)
        *out = best;
    else
        bat_shape_free(best);
    return status;
}
