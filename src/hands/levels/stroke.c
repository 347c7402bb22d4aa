/* A stroke drawn over C^j: which point of the curve each sample is meant for, then the least squares of 3.6.
 */
#include "hands/sketch/correspond.h"
#include "hands/levels/shape.h"
#include "hands/sketch/sketch.h"

#include <batten/nearest.h>

#include <math.h>
#include <stdlib.h>

enum { PROJECTIONS = 3 };

/* Equal fractions of the two lengths, then the nearest point close by: targets then differ across the curve.
 */
static void assign(const bat_canvas *canvas, const bat_clean *clean, const bat_correspondence *found,
                   double *u) {
    for (size_t i = 0; i < clean->count; i++) {
        double s = found->start + (found->end - found->start) * clean->arc[i] / clean->length;
        u[i] = bat_curve_project_near(canvas->pixels, clean->points + i * (size_t)clean->dimension,
                                      bat_track_u(&canvas->track, s), PROJECTIONS);
    }
}

bat_status bat_shape_sketch_stroke(bat_shape *shape, int level, const bat_stroke *stroke,
                                   const bat_sketch_options *options) {
    if (!shape || level < 0 || level > shape->count) return BAT_ARGUMENT;
    bat_sketch_options o;
    bat_status status = bat_sketch_check(stroke, options, &o);
    if (status != BAT_OK) return status;
    const bat_curve *curve = bat_shape_curve(shape, level);
    if (stroke->dimension != bat_curve_dimension(curve)) return BAT_DIMENSION;
    double origin[BAT_DIMENSION_MAX];
    bat_stroke_origin(stroke, origin);
    const bat_clean_options cleaning = {1 / o.pixel, origin, o.tolerance / o.pixel, false, NULL};
    bat_clean clean;
    status = bat_clean_stroke(stroke, &cleaning, &clean);
    if (status != BAT_OK) return status;
    bat_canvas canvas;
    status = bat_canvas_make(curve, origin, o.pixel, &canvas);
    if (status != BAT_OK) {
        bat_clean_free(&clean);
        return status;
    }
    bat_correspondence found = bat_correspond(&canvas.track, &clean, 0);
    if (found.reversed) bat_clean_reverse(&clean);
    const double near = fmin(found.offset[0], found.offset[1]);
    if (found.loop || near > fmax(40, 0.25 * clean.length)) status = BAT_FAR;
    double *u = malloc(clean.count * sizeof *u);
    if (!u && status == BAT_OK) status = BAT_MEMORY;
    if (status == BAT_OK) {
        assign(&canvas, &clean, &found, u);
        for (size_t i = 0; i < clean.count * (size_t)clean.dimension; i++)
            clean.points[i] = origin[i % (size_t)clean.dimension] + o.pixel * clean.points[i];
        status = bat_shape_sketch(shape, level, clean.count, u, clean.points);
    }
    free(u);
    bat_canvas_free(&canvas);
    bat_clean_free(&clean);
    return status;
}
