/* A stretch of a timing redrawn: the sketch hand's fit of one interval (docs/math/sketch.md 5.7), on the graph in pixels, with the
 * time as its parameter; its coefficients are then made ascending (docs/math/camera.md, math 4). */
#include "form/camera/retime.h"

#include "base/real.h"
#include "curve/curve.h"
#include "hands/sketch/fit_interval.h"

#include <batten/camera.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    SIDE = 300,
    TRIES = 4,
    SHORTEST = 6,
    RAMP = 6,
    RAMP_MOST = 24,
    MARGIN = 3,
    REST = 5,
    STEP = 6
}; /* px */
static const double TOLERANCE = 1.5,
                    MET = 2.5; /* px: of the fit at first, and of what it has become once ascending */
static const double LIGHT = 1e-3, WAVE = 18, SPAN = 12, FAIRNESS = 0.4;
static const double LEVEL = 0.3; /* px that a rest may rise by */

/* The graph is SIDE pixels wide and high; samples lie a pixel apart, from pixel `from` on. */
typedef struct redrawing {
    const bat_curve *old; /* the timing */
    bat_curve *graph;     /* the same in pixels: time, distance */
    size_t count;         /* of the stroke, in pixels: */
    const double *points;
    double low, high; /* the stretch */
    double ramp[2], jump[2],
        gone[2];  /* how far the ends reach beside it, how high they step, where each begins */
    int from, to; /* the interval that is fitted */
    double height[SIDE + 1];
    double w[SIDE + 1], x[2 * (SIDE + 1)], weight[SIDE + 1], allowed[SIDE + 1], law[SIDE + 1];
} redrawing;

double bat_stroke_height(size_t count, const double *points, double time) {
    for (size_t i = count - 1; i > 0; i--) {
        const double *a = points + 2 * (i - 1), *b = points + 2 * i;
        if (time < fmin(a[0], b[0]) || time > fmax(a[0], b[0])) continue;
        const double width = b[0] - a[0], share = width != 0 ? (time - a[0]) / width : 1;
        return a[1] + share * (b[1] - a[1]);
    }
    return points[1];
}

/* ---- the target ---- */

static bat_status graph_of(const bat_curve *timing, bat_curve **out) {
    const size_t n = (size_t)timing->count, size = (size_t)timing->dimension;
    const int knots = bat_curve_knot_count(timing);
    double *numbers = malloc((3 * n + (size_t)knots) * sizeof *numbers);
    if (!numbers) return BAT_MEMORY;
    double *scaled = numbers + 2 * n, *places = scaled + knots;
    bat_curve_greville(timing, places);
    for (size_t i = 0; i < n; i++) {
        numbers[2 * i] = SIDE * places[i];
        numbers[2 * i + 1] = SIDE * timing->points[i * size];
    }
    for (int i = 0; i < knots; i++) scaled[i] = SIDE * bat_curve_knots(timing)[i];
    const bat_status status = bat_curve_create(2, timing->degree, false, n, numbers, knots, scaled, out);
    free(numbers);
    return status;
}

static double old_at(const redrawing *r, double time) {
    double at[2];
    bat_curve_eval(r->graph, time, 0, at);
    return at[1];
}

static double drawn_at(const redrawing *r, double time) {
    return bat_stroke_height(r->count, r->points, time);
}

static double smooth(double x) { return x >= 1 ? 1 : x <= 0 ? 0 : x * x * (3 - 2 * x); }

/* What is wanted at a time: the stroke, and beside it what there was, which gives way; a step goes over a few pixels. */
static double wanted_at(const redrawing *r, const double ends[2], double time) {
    const double before = time < r->low ? fmin(old_at(r, time) + fmax(r->jump[0], 0), ends[0]) : 0,
                 after = time > r->high ? fmax(old_at(r, time) - fmax(r->jump[1], 0), ends[1]) : 0;
    double height = time < r->low ? before : time > r->high ? after : drawn_at(r, time);
    if (r->jump[0] > 0) height -= r->jump[0] * (1 - smooth((time - r->gone[0]) / r->ramp[0]));
    if (r->jump[1] > 0) height += r->jump[1] * smooth((time - r->gone[1]) / r->ramp[1]);
    return height;
}

static double ramp_for(double jump) { return fmin(fmax(jump, RAMP), RAMP_MOST); }

/* Where what there was gives way no more, with a margin; whole pixels, an end of the graph where one is near. */
static void choose_interval(redrawing *r, const double ends[2]) {
    double a = r->jump[0] > 0 ? r->gone[0] : r->low, b = r->jump[1] > 0 ? r->gone[1] + r->ramp[1] : r->high;
    while (a > 0 && old_at(r, a) > ends[0]) a = fmax(a - 1, 0);
    while (b < SIDE && old_at(r, b) < ends[1]) b = fmin(b + 1, SIDE);
    r->from = (int)floor(a) - MARGIN, r->to = (int)ceil(b) + MARGIN;
    if (r->from < STEP) r->from = 0;
    if (r->to > SIDE - STEP) r->to = SIDE;
}

static bat_status make_target(redrawing *r) {
    const double ends[2] = {fmin(fmax(drawn_at(r, r->low), 0), SIDE),
                            fmin(fmax(drawn_at(r, r->high), 0), SIDE)};
    r->jump[0] = ends[0] - old_at(r, r->low), r->jump[1] = old_at(r, r->high) - ends[1];
    for (int k = 0; k < 2; k++) r->ramp[k] = ramp_for(r->jump[k]);
    r->gone[0] = fmax(r->low - r->ramp[0], 0);
    r->gone[1] = fmin(r->high, SIDE - r->ramp[1]);
    choose_interval(r, ends);
    for (int i = r->from; i <= r->to; i++) r->height[i] = fmin(fmax(wanted_at(r, ends, i), 0), SIDE);
    if (r->from == 0) r->height[0] = 0;
    if (r->to == SIDE) r->height[SIDE] = SIDE;
    return bat_pool_ascending((size_t)(r->to - r->from + 1), r->height + r->from);
}

/* A sample of a step beside the stroke. */
static bool steps(const redrawing *r, int i) {
    for (int k = 0; k < 2; k++)
        if (r->jump[k] > 0 && i > r->gone[k] && i < r->gone[k] + r->ramp[k]) return true;
    return false;
}

/* A sample of the stroke proper. */
static bool counts(const redrawing *r, int i) { return i >= r->low && i <= r->high && !steps(r, i); }

static void fill(redrawing *r, double tolerance) {
    for (int i = r->from; i <= r->to; i++) {
        const int k = i - r->from, a = i - 3 > r->from ? i - 3 : r->from, b = i + 3 < r->to ? i + 3 : r->to;
        const double slope = (r->height[b] - r->height[a]) / (b - a);
        const bool free = steps(r, i);
        r->w[k] = k, r->x[2 * k] = i, r->x[2 * k + 1] = r->height[i];
        r->weight[k] = free ? LIGHT : 1, r->allowed[k] = (free ? 4 : 1) * tolerance;
        r->law[k] = sqrt(1 + slope * slope);
    }
}

/* ---- the fit, put in its place ---- */

/* The stored span that ends (side 0) or begins (side 1) at a cut. */
static int span_at(const bat_curve *graph, int side, double cut) {
    int span = graph->degree;
    while (span + 1 < graph->spread &&
           (side == 0 ? graph->knots[span + 1] < cut : graph->knots[span + 1] <= cut))
        span++;
    return span;
}

static void make_side(const redrawing *r, int which, bat_local_side *side) {
    const int p = r->graph->degree, cut = which == 0 ? r->from : r->to;
    *side = (bat_local_side){.pins = p, .base = cut, .rate = 1, .at = which == 0 ? 0 : r->to - r->from};
    for (int i = 0; i < p; i++) side->outer[i] = side->at;
    if (cut == 0 || cut == SIDE) {
        side->pins = 1;
        side->point[0] = side->point[1] = cut;
        return;
    }
    side->curve = r->graph, side->span = span_at(r->graph, which, cut);
    for (int i = 1; i < p; i++) {
        const double *t = r->graph->knots + side->span + (which == 0 ? 1 - i : i);
        side->outer[which == 0 ? p - 1 - i : i] = side->at + *t - cut;
    }
}

/* What of the timing stays: points before the piece, and after it, and the knots between. */
typedef struct kept {
    int before, after; /* points that are copied */
    int left, right;   /* knots that are copied */
} kept;

static kept kept_of(const redrawing *r) {
    const int p = r->old->degree;
    kept k = {0, 0, p, p};
    if (r->from > 0) k.left = span_at(r->graph, 0, r->from) + 1, k.before = k.left - p;
    if (r->to < SIDE) {
        const int span = span_at(r->graph, 1, r->to);
        k.right = r->old->spread + p - span, k.after = r->old->spread - span;
    }
    return k;
}

static bat_status put_together(const redrawing *r, const bat_local_result *fit, bat_curve **out) {
    const bat_curve *old = r->old;
    const int p = old->degree, local = fit->interior + p + 1, all = bat_curve_knot_count(old);
    const size_t size = (size_t)old->dimension;
    const kept k = kept_of(r);
    const int n = k.before + local + k.after, knot_count = n + p + 1;
    double *t = calloc((size_t)knot_count + size * (size_t)n, sizeof *t), at[BAT_DIMENSION_MAX];
    if (!t) return BAT_MEMORY;
    double *points = t + knot_count;
    const double *own = bat_curve_knots(old);
    memcpy(t, own, (size_t)k.left * sizeof *t);
    int count = k.left;
    t[count++] = (double)r->from / SIDE;
    for (int i = 0; i < fit->interior; i++)
        t[count++] = fmin((r->from + fit->knots[i]) / SIDE, (double)r->to / SIDE);
    t[count++] = (double)r->to / SIDE;
    memcpy(t + count, own + all - k.right, (size_t)k.right * sizeof *t);
    memcpy(points, old->points, (size_t)k.before * size * sizeof *points);
    memcpy(points + (size_t)(k.before + local) * size, old->points + (size_t)(old->count - k.after) * size,
           (size_t)k.after * size * sizeof *points);
    for (int i = 0; i < local; i++) {
        double *to = points + (size_t)(k.before + i) * size;
        to[0] = fmin(fmax(fit->points[2 * i + 1] / SIDE, 0), 1);
        const bool left = i < p && r->from > 0, right = i >= local - p && r->to < SIDE;
        if (!left && !right) continue;
        const int span = span_at(r->graph, left ? 0 : 1, left ? r->from : r->to);
        bat_curve_blossom_span(old, span, t + k.before + i + 1, at);
        to[0] = at[0];
    }
    const bat_status status = bat_curve_create(old->dimension, p, false, (size_t)n, points, knot_count, t,
                                               out);
    free(t);
    return status;
}

/* ---- rests, and time that does not run back ---- */

/* Six knots where the graph rests: between the third and the fourth it then can stand still. */
static bat_status knots_for_rests(const redrawing *r, bat_curve **timing) {
    double more[6 * (SIDE / (REST * STEP) + 1)];
    int count = 0;
    for (int i = r->from, j; i < r->to; i = j) {
        for (j = i + 1; j < r->to && counts(r, j) && r->height[j] - r->height[i] <= LEVEL;) j++;
        if (!counts(r, i) || j - 1 - i < REST * STEP) continue;
        for (int k = 0; k < 6; k++)
            more[count++] = (k < 3 ? i + STEP * k : j - 1 - STEP * (5 - k)) / (double)SIDE;
    }
    bat_curve *made = NULL;
    if (count == 0) return BAT_OK;
    const bat_status status = bat_curve_insert_knots(*timing, count, more, &made);
    if (status != BAT_OK) return status;
    bat_curve_free(*timing);
    *timing = made;
    return BAT_OK;
}

/* Coefficients that belong to a rest become its height. */
static void rest(const redrawing *r, bat_curve *timing) {
    const int p = timing->degree;
    for (int i = r->from, j; i < r->to; i = j) {
        for (j = i + 1; j < r->to && counts(r, j) && r->height[j] - r->height[i] <= LEVEL;) j++;
        if (!counts(r, i) || j - 1 - i < REST * STEP) continue;
        const double *t = bat_curve_knots(timing), near = 1e-9;
        for (int k = 0; k < timing->count; k++)
            if (SIDE * t[k + 1] >= i - near && SIDE * t[k + p] <= j - 1 + near)
                timing->points[k * timing->dimension] = r->height[(i + j) / 2] / SIDE;
    }
}

/* Whether coefficients first..last-1 ascend. */
static bool ascend(const double *values, size_t first, size_t last) {
    for (size_t i = first + 1; i < last; i++)
        if (!(values[i] >= values[i - 1])) return false;
    return true;
}

/* Makes the coefficients of the piece ascending, between those that are given on both sides. False: those do not ascend. */
static bool pool(size_t n, double *values, size_t before, size_t after, bat_status *status) {
    const double low = before > 0 ? values[before - 1] : 0, high = after > 0 ? values[n - after] : 1;
    if (!(low <= high) || before + after >= n) return false;
    if (!ascend(values, 0, before) || !ascend(values, n - after, n)) return false;
    *status = bat_pool_ascending(n - before - after, values + before);
    for (size_t i = before; i + after < n; i++) values[i] = fmin(fmax(values[i], low), high);
    if (before == 0) values[0] = 0;
    if (after == 0) values[n - 1] = 1;
    return *status == BAT_OK;
}

/* Makes it ascending; whether it then still goes where it was drawn. */
static bool settles(const redrawing *r, bat_curve *timing, bat_status *status) {
    const size_t n = (size_t)timing->count, size = (size_t)timing->dimension;
    const kept k = kept_of(r);
    const size_t p = (size_t)timing->degree, before = r->from > 0 ? (size_t)k.before + p : 0,
                 after = r->to < SIDE ? (size_t)k.after + p : 0;
    double *values = malloc(n * sizeof *values), at[BAT_DIMENSION_MAX];
    if (!values) *status = BAT_MEMORY;
    for (size_t i = 0; i < n && values; i++) values[i] = timing->points[i * size];
    bool fine = values && pool(n, values, before, after, status);
    for (size_t i = 0; i < n && fine; i++) timing->points[i * size] = values[i];
    free(values);
    for (int i = r->from; i <= r->to && fine; i++) {
        bat_curve_eval(timing, (double)i / SIDE, 0, at);
        fine = !(counts(r, i - RAMP) && counts(r, i + RAMP)) || fabs(SIDE * at[0] - r->height[i]) <= MET;
    }
    return fine;
}

static bat_status attempt(redrawing *r, double tolerance, bat_curve **out) {
    bat_local_result fit;
    bat_curve *made = NULL;
    fill(r, tolerance);
    bat_local_problem q = {.degree = r->old->degree,
                           .dimension = 2,
                           .end = r->to - r->from,
                           .count = (size_t)(r->to - r->from + 1),
                           .w = r->w,
                           .x = r->x,
                           .weight = r->weight,
                           .allowed = r->allowed,
                           .law = r->law,
                           .last = (size_t)(r->to - r->from),
                           .tolerance = tolerance,
                           .fairness = FAIRNESS,
                           .span = SPAN,
                           .wavelength = WAVE,
                           .remove = true};
    for (int side = 0; side < 2; side++) make_side(r, side, &q.side[side]);
    bat_status status = bat_local_fit(&q, &fit);
    if (status != BAT_OK) return status == BAT_MEMORY ? status : BAT_OK;
    status = put_together(r, &fit, &made);
    bat_local_result_free(&fit);
    if (status == BAT_OK) status = knots_for_rests(r, &made);
    if (status == BAT_OK) rest(r, made);
    if (status == BAT_OK && settles(r, made, &status)) {
        *out = made;
        return BAT_OK;
    }
    bat_curve_free(made);
    return status == BAT_MEMORY ? status : BAT_OK;
}

bat_status bat_timing_fit(const bat_curve *timing, size_t count, const double *points, double low,
                          double high, bat_curve **out) {
    const bool clamped = timing->points[0] == 0 &&
                         timing->points[((size_t)timing->count - 1) * (size_t)timing->dimension] == 1;
    *out = NULL;
    if (!clamped || SIDE * (high - low) < SHORTEST) return BAT_OK;
    redrawing *r = calloc(1, sizeof *r);
    double *pixels = malloc(2 * count * sizeof *pixels);
    bat_status status = r && pixels ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        for (size_t i = 0; i < 2 * count; i++) pixels[i] = SIDE * points[i];
        *r = (redrawing){
            .old = timing, .count = count, .points = pixels, .low = SIDE * low, .high = SIDE * high};
        status = graph_of(timing, &r->graph);
    }
    if (status == BAT_OK) status = make_target(r);
    double tolerance = TOLERANCE;
    for (int n = 0; n < TRIES && status == BAT_OK && !*out; n++, tolerance /= 2)
        status = attempt(r, tolerance, out);
    if (r) bat_curve_free(r->graph);
    free(r), free(pixels);
    return status;
}
