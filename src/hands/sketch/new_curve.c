/* A new curve from a stroke (docs/math sketch 5.8): the same cleaning and fit with free ends. */
#include "hands/sketch/sketch.h"

#include <math.h>

/* Of the stroke, and times the distance: the length along which an end gives way to where it is put. */
static const double put_share = 0.2, put_gently = 4;

/* This end of the stroke goes to `tip` (document units), and from a little way off the stroke lies as it did. */
static void put_tip(bat_clean *clean, int side, const double *tip, const double *origin, double pixel) {
    const size_t d = (size_t)clean->dimension;
    const double *end = clean->points + (side ? d * (clean->count - 1) : 0);
    double move[BAT_DIMENSION_MAX], off = 0;
    for (size_t k = 0; k < d; k++) {
        move[k] = (tip[k] - origin[k]) / pixel - end[k];
        off += move[k] * move[k];
    }
    const double over = fmin(fmax(put_share * clean->length, put_gently * sqrt(off)), 0.5 * clean->length);
    for (size_t i = 0; i < clean->count; i++) {
        const double from = side ? clean->length - clean->arc[i] : clean->arc[i];
        if (from >= over) continue;
        const double f = 1 - from / over, fade = f * f * (3 - 2 * f);
        for (size_t k = 0; k < d; k++) clean->points[d * i + k] += fade * move[k];
    }
    bat_clean_cut(clean, 0, clean->count - 1); /* measures it again */
}

bat_status bat_sketch_new_with(const bat_stroke *stroke, const bat_sketch_options *given,
                               const bat_sketch_meaning *meaning, bat_sketch_hints *hints, bat_curve **out,
                               bat_sketch_report *report) {
    static const bat_sketch_meaning unknown = {0};
    if (!meaning) meaning = &unknown;
    bat_sketch_options o;
    if (!out) return BAT_ARGUMENT;
    bat_status status = bat_sketch_check(stroke, given, &o);
    if (status != BAT_OK) return status;
    double origin[BAT_DIMENSION_MAX];
    bat_clean clean;
    status = bat_sketch_clean(stroke, &o, true, hints, origin, &clean);
    if (status != BAT_OK) return status;
    /* Parameters of a new curve are lengths in document units. */
    bat_plan plan = {.degree = o.degree,
                     .dimension = stroke->dimension,
                     .pins = o.degree,
                     .tolerance = clean.share * (o.tolerance / o.pixel),
                     .width = o.width,
                     .fairness = o.fairness,
                     .keep_corners = true,
                     .stroke = &clean,
                     .speed = 1 / o.pixel};
    plan.end[0].kind = plan.end[1].kind = BAT_END_FREE;
    plan.periodic = meaning->closing == BAT_CLOSING_YES ||
                    (meaning->closing == BAT_CLOSING_AUTO && bat_clean_closes(&clean));
    for (int side = 0; side < 2 && !plan.periodic; side++)
        if (meaning->put[side]) put_tip(&clean, side, meaning->tip[side], origin, o.pixel);
    bat_sketch_report facts = {0};
    status = plan.periodic ? bat_plan_ring(&plan) : bat_plan_target(&plan);
    if (status == BAT_OK) status = bat_plan_finish(&plan, origin, o.pixel, hints, out, &facts);
    /* Of small strokes less than the tolerance is asked, and not insisted upon. */
    if (status == BAT_TOLERANCE && facts.max_error <= o.tolerance) status = BAT_OK;
    if (report && (status == BAT_OK || status == BAT_TOLERANCE)) *report = facts;
    bat_plan_free(&plan);
    bat_clean_free(&clean);
    return status;
}

bat_status bat_sketch_new(const bat_stroke *stroke, bool force_closed, const bat_sketch_options *options,
                          bat_curve **out, bat_sketch_report *report) {
    const bat_sketch_meaning meaning = {.closing = force_closed ? BAT_CLOSING_YES : BAT_CLOSING_AUTO};
    return bat_sketch_new_with(stroke, options, &meaning, NULL, out, report);
}

bat_status bat_sketch_new_meant(const bat_stroke *stroke, const bat_sketch_options *options,
                                const bat_sketch_meaning *meaning, bat_curve **out,
                                bat_sketch_report *report) {
    return bat_sketch_new_with(stroke, options, meaning, NULL, out, report);
}
