/* The smoothing stroke (docs/math sketch 5.8): the stretch it passes over is made fairer, as far as the limit
 * permits, with the same cuts and the same fit as a redraw. */
#include "hands/sketch/sketch.h"
#include "hands/sketch/whittaker.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double shortest_stretch = 24;

static double smoothstep(double f) {
    f = f < 0 ? 0 : f > 1 ? 1 : f;
    return f * f * f * (10 + f * (-15 + 6 * f));
}

/* x: the old curve between the joints, replaced by its fairer image. Third-order smoothing with the longest
 * wavelength whose greatest move stays within the limit; the move fades out towards both ends, with two
 * derivatives. */
static bat_status make_fair(size_t count, size_t m, double *x, double step, double limit) {
    double *z = malloc(count * (m + 4) * sizeof *z), *work = z ? z + count * m : NULL;
    if (!z) return BAT_MEMORY;
    const double length = step * (double)(count - 1), omega = 2 * length / (2 * BAT_PI * step);
    double high = bat_log(fmin(omega * omega * omega * omega * omega * omega, 1e11)), low = bat_log(1e-2),
           at = high;
    bat_status status = BAT_OK;
    double scale = 1;
    for (int round = 0; round < 24 && status == BAT_OK; round++) {
        status = bat_whittaker(count, (int)m, x, NULL, bat_exp(at), work, z);
        double worst = 0;
        for (size_t i = 0; i < count && status == BAT_OK; i++) {
            const double f = (double)i / (double)(count - 1);
            const double window = smoothstep(3 * fmin(f, 1 - f));
            double move = 0;
            for (size_t c = 0; c < m; c++) {
                const double d = window * (z[i * m + c] - x[i * m + c]);
                move += d * d;
            }
            worst = fmax(worst, sqrt(move));
        }
        scale = worst > limit ? limit / worst : 1;
        if (worst > limit)
            high = at;
        else if (round == 0 || worst > 0.97 * limit)
            break;
        else
            low = at;
        at = 0.5 * (low + high);
    }
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        const double f = (double)i / (double)(count - 1), window = scale * smoothstep(3 * fmin(f, 1 - f));
        for (size_t c = 0; c < m; c++) x[i * m + c] += window * (z[i * m + c] - x[i * m + c]);
    }
    free(z);
    return status;
}

static bat_status smooth_target(bat_plan *plan, double limit) {
    const size_t m = (size_t)plan->dimension;
    bat_target *t = &plan->target;
    t->count = 0, t->rate = plan->speed;
    const double from = plan->end[0].joint, to = plan->end[1].joint, length = to - from;
    const double step = fmax(length / 2000, fmin(2, length / 48));
    const size_t count = (size_t)ceil(length / step) + 1;
    double *x = malloc(count * m * sizeof *x);
    if (!x) return BAT_MEMORY;
    bat_status status = BAT_OK;
    if (plan->end[0].cut != plan->end[0].joint_u) status = bat_plan_add_kept(plan, 0, step);
    const size_t a = t->count;
    for (size_t i = 0; i < count; i++) {
        const double s = from + length * (double)i / (double)(count - 1);
        const double u = i == 0           ? plan->end[0].joint_u
                         : i + 1 == count ? plan->end[1].joint_u
                                          : bat_track_u(plan->end[0].track, s);
        if (i + 1 == count)
            bat_curve_eval_left(plan->end[0].curve, u, 0, x + i * m);
        else
            bat_curve_eval(plan->end[0].curve, u, 0, x + i * m);
    }
    if (status == BAT_OK) status = make_fair(count, m, x, length / (double)(count - 1), 0.8 * limit);
    t->first = a;
    for (size_t i = 0; i < count && status == BAT_OK; i++)
        status = bat_target_add(t, plan->dimension, x + i * m, fmin(plan->tolerance, 0.2 * limit));
    if (status == BAT_OK && t->count <= a + 2) status = BAT_DOT;
    t->last = t->count - 1;
    const size_t b = t->count - 1;
    if (status == BAT_OK && plan->end[1].cut != plan->end[1].joint_u)
        status = bat_plan_add_kept(plan, 1, step);
    if (status == BAT_OK) bat_plan_parameters(plan, a, b);
    free(x);
    return status;
}

bat_status bat_sketch_smooth_with(const bat_curve *curve, const bat_stroke *stroke,
                                  const bat_sketch_options *given, bat_sketch_hints *hints, bat_curve **out,
                                  bat_sketch_report *report) {
    bat_sketch_options o;
    if (!curve || !out) return BAT_ARGUMENT;
    bat_status status = bat_sketch_check(stroke, given, &o);
    if (status != BAT_OK) return status;
    if (stroke->dimension != curve->dimension) return BAT_DIMENSION;
    double origin[BAT_DIMENSION_MAX];
    bat_clean clean;
    status = bat_sketch_clean(stroke, &o, false, hints, origin, &clean);
    if (status != BAT_OK) return status;
    bat_workpiece workpiece;
    status = bat_workpiece_make(curve, origin, o.pixel, &workpiece);
    if (status != BAT_OK) {
        bat_clean_free(&clean);
        return status;
    }
    const int p = workpiece.pixels->degree;
    bat_plan plan = {.degree = p,
                     .dimension = stroke->dimension,
                     .pins = o.pins == 2 ? p - 1 : p,
                     .tolerance = o.tolerance / o.pixel,
                     .width = o.width,
                     .fairness = o.fairness,
                     .closed = curve->closed,
                     .stroke = &clean};
    bat_workpiece_bind(&plan, &workpiece);
    bat_correspondence found = bat_correspond(&workpiece.track, &clean, 0);
    bat_sketch_report facts = {.knots_before = bat_curve_knot_count(curve), .reversed = found.reversed};
    status = bat_plan_ends(&plan, &found);
    if (status == BAT_OK) {
        const double L = workpiece.track.length;
        double from = fmin(plan.end[0].s, plan.end[1].s), to = fmax(plan.end[0].s, plan.end[1].s);
        const double widen = fmax(0.5 * (shortest_stretch - (to - from)), 0);
        from -= widen, to += widen;
        if (curve->closed && to - from > 0.9 * L) to = from + 0.9 * L;
        if (!curve->closed) from = fmax(from, 0), to = fmin(to, L);
        plan.end[0].s = from, plan.end[1].s = to;
        for (int side = 0; side < 2; side++) plan.end[side].kind = BAT_END_KEPT;
        bat_plan_cuts(&plan);
        if (plan.closed) status = bat_workpiece_enrich(&plan, &workpiece, origin, o.pixel);
        for (int side = 0; side < 2; side++) facts.changed[side] = plan.end[side].cut;
        if (status == BAT_OK && !(plan.end[1].joint - plan.end[0].joint > 8)) status = BAT_DOT;
        if (status == BAT_OK) status = smooth_target(&plan, o.smooth_limit / o.pixel);
    }
    if (status == BAT_OK) status = bat_plan_finish(&plan, origin, o.pixel, hints, out, &facts);
    if (report && (status == BAT_OK || status == BAT_TOLERANCE)) *report = facts;
    bat_plan_free(&plan);
    bat_workpiece_free(&workpiece);
    bat_clean_free(&clean);
    return status;
}

bat_status bat_sketch_smooth(const bat_curve *curve, const bat_stroke *stroke,
                             const bat_sketch_options *options, bat_curve **out, bat_sketch_report *report) {
    return bat_sketch_smooth_with(curve, stroke, options, NULL, out, report);
}
