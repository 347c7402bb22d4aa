/* A stroke drawn over C^j: which point of the curve each sample is meant for, then the least squares of 3.6.
 */
#include "hands/sketch/correspond.h"
#include "hands/levels/fit.h"
#include "hands/sketch/sketch.h"

#include <batten/nearest.h>

#include <math.h>
#include <stdlib.h>

enum { PROJECTIONS = 3 };

/* Starts at equal fractions of the two lengths and takes the nearest point close by: targets then differ from
 * the curve across it. */
static void assign(const bat_workpiece *workpiece, const bat_clean *clean, const bat_correspondence *found,
                   double *u) {
    for (size_t i = 0; i < clean->count; i++) {
        double s = found->start + (found->end - found->start) * clean->arc[i] / clean->length;
        u[i] = bat_curve_project_near(workpiece->pixels, clean->points + i * (size_t)clean->dimension,
                                      bat_track_u(&workpiece->track, s), PROJECTIONS);
    }
}

/* The greatest distance from the stroke to the level's new curve; the samples' parameters are good first
 * guesses. */
static double miss(const bat_curve *curve, const bat_clean *clean, const double *u) {
    double worst = 0, at[BAT_DIMENSION_MAX];
    for (size_t i = 0; i < clean->count; i++) {
        const double *x = clean->points + i * (size_t)clean->dimension;
        bat_curve_eval(curve, bat_curve_project_near(curve, x, u[i], PROJECTIONS), 0, at);
        worst = fmax(worst, bat_distance(x, at, clean->dimension));
    }
    return worst;
}

/* Draws the cleaned stroke, in pixels about the origin, over C^level. Turns it round, and converts it back to
 * document units. */
static bat_status draw(bat_shape *shape, int level, bat_clean *clean, const double *origin, double pixel,
                       bat_sketch_report *report) {
    bat_workpiece workpiece;
    bat_status status = bat_workpiece_make(bat_shape_curve(shape, level), origin, pixel, &workpiece);
    if (status != BAT_OK) return status;
    bat_correspondence found = bat_correspond(&workpiece.track, clean, 0);
    if (found.reversed) bat_clean_reverse(clean);
    double *u = NULL;
    if (found.loop || bat_ends_far(clean, &found, workpiece.pixels->closed ? workpiece.track.length : 0))
        status = BAT_FAR;
    if (status == BAT_OK && !(u = malloc(clean->count * sizeof *u))) status = BAT_MEMORY;
    if (status == BAT_OK) {
        assign(&workpiece, clean, &found, u);
        for (size_t i = 0; i < clean->count * (size_t)clean->dimension; i++)
            clean->points[i] = origin[i % (size_t)clean->dimension] + pixel * clean->points[i];
        status = bat_level_fit(shape, level, clean->count, u, clean->points, &report->spans);
    }
    if (status == BAT_OK) {
        report->max_error = miss(bat_shape_curve(shape, level), clean, u);
        report->noise = clean->sigma * pixel;
        report->reversed = found.reversed;
    }
    free(u);
    bat_workpiece_free(&workpiece);
    return status;
}

bat_status bat_shape_redraw_level(bat_shape *shape, int level, const bat_stroke *stroke,
                                  const bat_sketch_options *options, bat_sketch_report *report) {
    if (!shape || level < 0 || level > bat_shape_levels(shape)) return BAT_ARGUMENT;
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
    const int knots = bat_curve_knot_count(curve);
    bat_sketch_report facts = {.knots_before = knots, .knots_after = knots};
    status = draw(shape, level, &clean, origin, o.pixel, &facts);
    bat_clean_free(&clean);
    if (status == BAT_OK && report) *report = facts;
    return status;
}

bat_status bat_shape_sketch_stroke(bat_shape *shape, int level, const bat_stroke *stroke,
                                   const bat_sketch_options *options) {
    return bat_shape_redraw_level(shape, level, stroke, options, NULL);
}
