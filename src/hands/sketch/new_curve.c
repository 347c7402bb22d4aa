/* A new curve from a stroke (docs/math sketch 5.8): the same cleaning and fit with free ends. */
#include "hands/sketch/sketch.h"

#include <math.h>

bat_status bat_sketch_new_with(const bat_stroke *stroke, const bat_sketch_options *given, bool force_closed,
                               bat_sketch_hints *hints, bat_curve **out, bat_sketch_report *report) {
    bat_sketch_options o;
    if (!out) return BAT_ARGUMENT;
    bat_status status = bat_sketch_check(stroke, given, &o);
    if (status != BAT_OK) return status;
    double origin[BAT_DIMENSION_MAX];
    bat_stroke_origin(stroke, origin);
    const double tolerance = o.tolerance / o.pixel;
    const bat_clean_options cleaning = {1 / o.pixel, origin, tolerance, true, hints ? hints->memory : NULL};
    bat_clean clean;
    status = bat_clean_stroke(stroke, &cleaning, &clean);
    if (status != BAT_OK) return status;
    /* Parameters of a new curve are lengths in document units. */
    bat_plan plan = {.degree = 3,
                     .dimension = stroke->dimension,
                     .pins = 3,
                     .tolerance = tolerance,
                     .width = o.width,
                     .keep_corners = true,
                     .stroke = &clean,
                     .speed = 1 / o.pixel};
    plan.end[0].kind = plan.end[1].kind = BAT_END_FREE;
    plan.periodic = force_closed || bat_clean_closes(&clean);
    bat_sketch_report facts = {0};
    status = plan.periodic ? bat_plan_ring(&plan) : bat_plan_target(&plan);
    if (status == BAT_OK) status = bat_plan_finish(&plan, origin, o.pixel, hints, out, &facts);
    if (report && (status == BAT_OK || status == BAT_TOLERANCE)) *report = facts;
    bat_plan_free(&plan);
    bat_clean_free(&clean);
    return status;
}

bat_status bat_sketch_new(const bat_stroke *stroke, const bat_sketch_options *options, bool force_closed,
                          bat_curve **out, bat_sketch_report *report) {
    return bat_sketch_new_with(stroke, options, force_closed, NULL, out, report);
}
