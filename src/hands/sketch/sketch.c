/* Draw over a curve (sketch-2005 sections 2 to 4, docs/math sketch 5). */
#include "hands/sketch/sketch.h"
#include "base/options.h"
#include <batten/refine.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const bat_sketch_options DEFAULTS = {sizeof DEFAULTS, .tolerance = 0, .pixel = 1,     .pins = 3,
                                            .width = 3,      .degree = 3,    .fairness = 0.4};
enum { LEAST = offsetof(bat_sketch_options, degree) }; /* the size in 0.2 */

void bat_sketch_options_init(bat_sketch_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

bat_status bat_sketch_check(const bat_stroke *stroke, const bat_sketch_options *given,
                            bat_sketch_options *o) {
    if (!stroke || !stroke->points) return BAT_ARGUMENT;
    if (stroke->dimension < 2 || stroke->dimension > BAT_DIMENSION_MAX) return BAT_DIMENSION;
    if (stroke->count > BAT_POINTS_MAX) return BAT_COUNT;
    *o = DEFAULTS;
    bat_status status = bat_options_read(given, LEAST, sizeof *o, o);
    if (status != BAT_OK) return status;
    if (isnan(o->pixel) || isnan(o->tolerance) || isnan(o->width) || isnan(o->fairness) ||
        isnan(o->smooth_limit))
        return BAT_NUMBER;
    if (!(o->pixel > 1e-100 && o->pixel < 1e100) || o->tolerance < 0 || o->smooth_limit < 0)
        return BAT_ARGUMENT;
    if (o->pins != 2 && o->pins != 3) return BAT_ARGUMENT;
    if (o->degree < 3 || o->degree > BAT_DEGREE_MAX) return BAT_DEGREE;
    if (!(o->width >= 0 && o->width <= 100)) return BAT_ARGUMENT;
    if (!(o->fairness >= BAT_FAIRNESS_LEAST && o->fairness <= BAT_FAIRNESS_MOST)) return BAT_ARGUMENT;
    if (o->tolerance == 0) o->tolerance = o->pixel;
    if (o->smooth_limit == 0) o->smooth_limit = 5 * o->pixel;
    const double pixels = o->tolerance / o->pixel;
    if (!(pixels >= 1e-3 && pixels <= 1e6)) return BAT_ARGUMENT;
    return BAT_OK;
}

void bat_stroke_origin(const bat_stroke *stroke, double *origin) {
    const size_t m = (size_t)stroke->dimension;
    for (size_t i = 0; i < stroke->count; i++) {
        bool finite = true;
        for (size_t c = 0; c < m; c++) {
            origin[c] = stroke->points[i * m + c];
            finite = finite && fabs(origin[c]) < 1e150;
        }
        if (finite) return;
    }
    for (size_t c = 0; c < m; c++) origin[c] = 0;
}

bat_status bat_workpiece_make(const bat_curve *curve, const double *origin, double pixel,
                              bat_workpiece *out) {
    memset(out, 0, sizeof *out);
    bat_status status = curve->degree < 3 ? bat_curve_elevate(curve, 3, &out->original)
                                          : bat_curve_copy(curve, &out->original);
    if (status == BAT_OK) status = bat_curve_copy(out->original, &out->pixels);
    if (status == BAT_OK) {
        const size_t m = (size_t)curve->dimension, count = (size_t)out->pixels->spread;
        double *points = out->pixels->points;
        for (size_t i = 0; i < count && status == BAT_OK; i++)
            for (size_t c = 0; c < m; c++) {
                points[i * m + c] = (points[i * m + c] - origin[c]) / pixel;
                if (!(fabs(points[i * m + c]) < 1e120)) status = BAT_NUMBER;
            }
    }
    if (status == BAT_OK) status = bat_track_create(out->pixels, &out->track);
    if (status != BAT_OK) bat_workpiece_free(out);
    return status;
}

void bat_workpiece_free(bat_workpiece *workpiece) {
    bat_track_free(&workpiece->track);
    bat_curve_free(workpiece->pixels);
    bat_curve_free(workpiece->original);
    memset(workpiece, 0, sizeof *workpiece);
}

void bat_workpiece_bind(bat_plan *plan, const bat_workpiece *workpiece) {
    for (int side = 0; side < 2; side++) {
        plan->end[side].curve = workpiece->pixels;
        plan->end[side].original = workpiece->original;
        plan->end[side].track = &workpiece->track;
    }
    plan->speed = workpiece->track.mean > 0 ? workpiece->track.mean : 1;
}

/* The kept arc of a closed curve must hold p - 1 knots for the pins of both ends to be told apart. */
bat_status bat_workpiece_enrich(bat_plan *plan, bat_workpiece *workpiece, const double *origin,
                                double pixel) {
    const int p = plan->degree;
    const bat_stroke_track *k = &workpiece->track;
    const double period = k->end - k->start, from = plan->end[1].cut, to = plan->end[0].cut + period;
    /* A knot beside another would leave a span of no length. */
    const double apart = (to - from) / (4 * (p + 1));
    bool taken[BAT_DEGREE_MAX] = {false};
    int inside = 0;
    for (int lap = -1; lap <= 2; lap++)
        for (int i = 0; i < workpiece->original->count; i++) {
            const double knot = bat_curve_knots(workpiece->original)[i] + lap * period;
            inside += knot > from && knot < to;
            for (int at = 0; at < p; at++)
                taken[at] |= fabs(knot - (from + (to - from) * (at + 1) / (p + 1))) < apart;
        }
    if (inside >= p - 1) return BAT_OK;
    double more[BAT_DEGREE_MAX];
    int count = 0;
    for (int at = 0; at < p; at++)
        if (!taken[at])
            more[count++] = bat_curve_reduce(workpiece->original, from + (to - from) * (at + 1) / (p + 1));
    for (int i = 1; i < count; i++)
        for (int j = i; j > 0 && more[j - 1] > more[j]; j--) {
            const double swap = more[j];
            more[j] = more[j - 1], more[j - 1] = swap;
        }
    bat_curve *finer;
    bat_status status = bat_curve_insert_knots(workpiece->original, count, more, &finer);
    if (status != BAT_OK) return status;
    bat_workpiece next;
    status = bat_workpiece_make(finer, origin, pixel, &next);
    bat_curve_free(finer);
    if (status != BAT_OK) return status;
    bat_workpiece_free(workpiece);
    *workpiece = next;
    bat_workpiece_bind(plan, workpiece);
    return BAT_OK;
}

/* Vector area of a closed polyline; in the plane its last coordinate. */
static void vector_area(size_t m, size_t count, const double *x, double *area) {
    area[0] = area[1] = area[2] = 0;
    for (size_t i = 0; i < count; i++) {
        const double *p = x + i * m, *q = x + (i + 1 == count ? 0 : i + 1) * m;
        double a[3] = {0}, b[3] = {0};
        for (size_t c = 0; c < m; c++) a[c] = p[c] - x[c], b[c] = q[c] - x[c];
        area[0] += a[1] * b[2] - a[2] * b[1];
        area[1] += a[2] * b[0] - a[0] * b[2];
        area[2] += a[0] * b[1] - a[1] * b[0];
    }
}

/* What a preview shows of the target. */
static bat_status take_target(const bat_plan *plan, bat_sketch_hints *hints, const double *origin,
                              double pixel) {
    const size_t m = (size_t)plan->dimension;
    const bat_target *t = &plan->target;
    hints->target = malloc(t->count * m * sizeof *hints->target);
    if (!hints->target) return BAT_MEMORY;
    for (size_t i = 0; i < t->count * m; i++) hints->target[i] = origin[i % m] + pixel * t->x[i];
    hints->target_count = t->count, hints->stroke_first = t->first, hints->stroke_last = t->last;
    return BAT_OK;
}

static void fill_report(const bat_plan *plan, const bat_local_result *fit, double pixel,
                        const bat_curve *result, const double changed_new[2], bat_sketch_report *report) {
    report->max_error = fit->max_error * pixel;
    report->noise = plan->stroke ? plan->stroke->sigma * pixel : 0;
    report->knots_after = bat_curve_knot_count(result);
    report->solves = fit->solves;
    for (int side = 0; side < 2; side++) {
        report->changed_new[side] = changed_new[side];
        report->transition[side] = plan->end[side].lead * pixel;
        report->extended[side] = plan->end[side].kind == BAT_END_FREE && !plan->periodic;
    }
    report->replaced = plan->periodic || (report->extended[0] && report->extended[1]);
    if (report->replaced) report->extended[0] = report->extended[1] = false;
}

bat_status bat_plan_finish(bat_plan *plan, const double *origin, double pixel, bat_sketch_hints *hints,
                           bat_curve **out, bat_sketch_report *report) {
    bat_local_problem problem;
    bat_local_result fit;
    if (plan->target.count < 3 || !(plan->target.end > 0)) return BAT_DOT;
    bat_plan_problem(plan, &problem);
    problem.remove = !hints;
    bat_status status = bat_local_fit(&problem, &fit);
    if (status != BAT_OK) return status;
    bat_curve *result;
    double changed_new[2] = {0, 0};
    if (hints) status = take_target(plan, hints, origin, pixel);
    if (status == BAT_OK) status = bat_splice(plan, &problem, &fit, origin, pixel, &result, changed_new);
    if (status == BAT_OK) {
        *out = result;
        if (report) fill_report(plan, &fit, pixel, result, changed_new, report);
        if (!fit.met) status = BAT_TOLERANCE;
    }
    bat_local_result_free(&fit);
    return status;
}

/* A stroke all round a closed curve. */
static bat_status plan_ring(bat_plan *plan, const bat_workpiece *workpiece, bat_sketch_report *report) {
    double mine[3], theirs[3];
    const size_t m = (size_t)plan->dimension;
    vector_area(m, plan->stroke->count, plan->stroke->points, mine);
    vector_area(m, (size_t)workpiece->track.count - 1, workpiece->track.points, theirs);
    report->reversed = mine[0] * theirs[0] + mine[1] * theirs[1] + mine[2] * theirs[2] < 0;
    if (report->reversed) bat_clean_reverse(plan->stroke);
    plan->periodic = true;
    return bat_plan_ring(plan);
}

/* Draws the cleaned stroke over the curve. Takes over no part of `clean`, but may turn it round. */
static bat_status redraw(const bat_curve *curve, bat_clean *clean, const bat_sketch_options *o,
                         const double *origin, const bat_sketch_meaning *meaning, bat_sketch_hints *hints,
                         bat_curve **out, bat_sketch_report *report) {
    bat_workpiece workpiece;
    bat_status status = bat_workpiece_make(curve, origin, o->pixel, &workpiece);
    if (status != BAT_OK) return status;
    const int p = workpiece.pixels->degree;
    bat_sketch_report facts = {.knots_before = bat_curve_knot_count(curve)};
    bat_plan plan = {.degree = p,
                     .dimension = clean->dimension,
                     .pins = o->pins == 2 ? p - 1 : p,
                     .tolerance = clean->share * o->tolerance / o->pixel,
                     .width = o->width,
                     .fairness = o->fairness,
                     .keep_corners = o->keep_corners,
                     .closed = curve->closed,
                     .stroke = clean};
    bat_workpiece_bind(&plan, &workpiece);
    const bat_correspondence found = bat_correspond(&workpiece.track, clean, meaning ? meaning->sense : 0);
    const bool ring = curve->closed && bat_clean_closes(clean) &&
                      clean->length > 0.5 * workpiece.track.length;
    const bool all_round = ring ||
                           (curve->closed && found.end - found.start >= 0.98 * workpiece.track.length);
    if (!all_round && found.reversed) bat_clean_reverse(clean);
    facts.reversed = found.reversed;
    for (int side = 0; side < 2 && meaning; side++) plan.end[side].rule = meaning->end[side ^ found.reversed];
    const double around = curve->closed && !ring ? workpiece.track.length : 0;
    status = around > 0 && bat_ends_far(clean, &found, around) ? BAT_FAR : bat_plan_ends(&plan, &found);
    facts.changed[0] = workpiece.track.start, facts.changed[1] = workpiece.track.end;
    if (status == BAT_OK && all_round) {
        status = plan_ring(&plan, &workpiece, &facts);
    } else if (status == BAT_OK) {
        bat_plan_leads(&plan);
        bat_plan_cuts(&plan);
        if (plan.closed) status = bat_workpiece_enrich(&plan, &workpiece, origin, o->pixel);
        if (plan.end[0].kind != BAT_END_FREE) facts.changed[0] = plan.end[0].cut;
        if (plan.end[1].kind != BAT_END_FREE) facts.changed[1] = plan.end[1].cut;
        if (status == BAT_OK) status = bat_plan_target(&plan);
    }
    if (status == BAT_OK) status = bat_plan_finish(&plan, origin, o->pixel, hints, out, &facts);
    if (report && (status == BAT_OK || status == BAT_TOLERANCE)) *report = facts;
    bat_plan_free(&plan);
    bat_workpiece_free(&workpiece);
    return status;
}

bat_status bat_sketch_clean(const bat_stroke *stroke, const bat_sketch_options *o, bool corners,
                            const bat_sketch_hints *hints, double *origin, bat_clean *out) {
    bat_stroke_origin(stroke, origin);
    const bat_clean_options cleaning = {1 / o->pixel, origin, o->tolerance / o->pixel, corners,
                                        hints ? hints->memory : NULL};
    return bat_clean_stroke(stroke, &cleaning, out);
}

bat_status bat_sketch_with(const bat_curve *curve, const bat_stroke *stroke, const bat_sketch_options *given,
                           const bat_sketch_meaning *meaning, bat_sketch_hints *hints, bat_curve **out,
                           bat_sketch_report *report) {
    bat_sketch_options o;
    if (!curve || !out) return BAT_ARGUMENT;
    bat_status status = bat_sketch_check(stroke, given, &o);
    if (status != BAT_OK) return status;
    if (stroke->dimension != curve->dimension) return BAT_DIMENSION;
    double origin[BAT_DIMENSION_MAX];
    bat_clean clean;
    status = bat_sketch_clean(stroke, &o, o.keep_corners, hints, origin, &clean);
    if (status != BAT_OK) return status;
    status = redraw(curve, &clean, &o, origin, meaning, hints, out, report);
    bat_clean_free(&clean);
    return status;
}

bat_status bat_sketch(const bat_curve *curve, const bat_stroke *stroke, const bat_sketch_options *options,
                      bat_curve **out, bat_sketch_report *report) {
    return bat_sketch_with(curve, stroke, options, NULL, NULL, out, report);
}

bat_status bat_sketch_meant(const bat_curve *curve, const bat_stroke *stroke,
                            const bat_sketch_options *options, const bat_sketch_meaning *meaning,
                            bat_curve **out, bat_sketch_report *report) {
    return bat_sketch_with(curve, stroke, options, meaning, NULL, out, report);
}

/* The sample nearest to the cut, after `first` and with some samples left on either side. */
static size_t cut_sample(const bat_clean *clean, const double *cut, const double *origin, double pixel,
                         size_t first) {
    const size_t dimension = (size_t)clean->dimension;
    double least = INFINITY;
    size_t best = first + 2;
    for (size_t i = first + 2; i + 2 < clean->count; i++) {
        double d = 0;
        for (size_t k = 0; k < dimension; k++) {
            const double r = clean->points[dimension * i + k] - (cut[k] - origin[k]) / pixel;
            d += r * r;
        }
        if (d < least) least = d, best = i;
    }
    return best;
}

static bat_status copy_part(const bat_clean *clean, size_t first, size_t last, bat_clean *out) {
    *out = *clean;
    const size_t numbers = clean->count * (size_t)clean->dimension;
    out->points = malloc(numbers * sizeof *out->points);
    out->arc = malloc(clean->count * sizeof *out->arc);
    out->corners = malloc((clean->corner_count + 1) * sizeof *out->corners);
    if (!out->points || !out->arc || !out->corners) return BAT_MEMORY;
    memcpy(out->points, clean->points, numbers * sizeof *out->points);
    memcpy(out->arc, clean->arc, clean->count * sizeof *out->arc);
    if (clean->corner_count) memcpy(out->corners, clean->corners, clean->corner_count * sizeof *out->corners);
    bat_clean_cut(out, first, last);
    return BAT_OK;
}

bat_status bat_sketch_chain(int count, const bat_curve *const *curves, const double *cuts,
                            const bat_sketch_meaning *meaning, const bat_stroke *stroke,
                            const bat_sketch_options *given, bat_curve **out) {
    bat_sketch_options o;
    if (count < 1 || !curves || !out || !meaning || (count > 1 && !cuts)) return BAT_ARGUMENT;
    bat_status status = bat_sketch_check(stroke, given, &o), met = BAT_OK;
    if (status != BAT_OK) return status;
    double origin[BAT_DIMENSION_MAX];
    bat_clean clean;
    status = bat_sketch_clean(stroke, &o, o.keep_corners, NULL, origin, &clean);
    if (status != BAT_OK) return status;
    int made = 0;
    size_t first = 0;
    for (int i = 0; i < count && status == BAT_OK; i++) {
        size_t last = clean.count - 1;
        if (i + 1 < count)
            last = cut_sample(&clean, cuts + (size_t)(i * stroke->dimension), origin, o.pixel, first);
        if (last >= clean.count || first + 1 >= last) status = BAT_DOT;
        if (curves[i]->dimension != clean.dimension) status = BAT_DIMENSION;
        bat_clean part = {0};
        if (status == BAT_OK) status = copy_part(&clean, first, last, &part);
        if (status == BAT_OK) status = redraw(curves[i], &part, &o, origin, &meaning[i], NULL, &out[i], NULL);
        bat_clean_free(&part);
        if (status == BAT_TOLERANCE) met = status, status = BAT_OK;
        if (status == BAT_OK) made++;
        first = last;
    }
    bat_clean_free(&clean);
    if (status == BAT_OK) return met;
    while (made > 0) {
        bat_curve_free(out[--made]);
        out[made] = NULL;
    }
    return status;
}
