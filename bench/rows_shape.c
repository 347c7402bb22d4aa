/* Closest point, the fit of the three strokes, and the sketch hand. */
#define _POSIX_C_SOURCE 199309L
#include "bench.h"
#include "made.h"
#include "reference.h"
#include "strokes.h"
#include "timing.h"

#include <batten/bezier.h>
#include <batten/fit.h>
#include <batten/nearest.h>
#include <batten/relate.h>
#include <batten/sketch.h>

enum { QUERIES = 1000, SAMPLES = 1000, REDRAWN = 100 };

typedef struct query {
    bat_curve *curve;
    bat_finder *finder;
    double points[2 * QUERIES];
} query;

static bat_curve *wave(int n) {
    double *knots = malloc(sizeof(double) * (size_t)(n + 4)),
           *points = malloc(sizeof(double) * (size_t)(n * 2));
    bat_curve *curve = NULL;
    if (knots && points) {
        bench_curve(n, 2, knots, points);
        if (bat_curve_create(2, 3, false, (size_t)n, points, n + 4, knots, &curve) != BAT_OK) curve = NULL;
    }
    free(knots), free(points);
    return curve;
}

static void *begin_nearest(int variant) {
    query *q = calloc(1, sizeof *q);
    if (!q) return NULL;
    q->curve = wave(variant);
    if (!q->curve || bat_finder_create(q->curve, &q->finder) != BAT_OK) return NULL;
    bench_queries(variant, QUERIES, q->points);
    return q;
}

static void run_nearest(void *context) {
    query *q = context;
    bat_near near;
    for (int i = 0; i < QUERIES; i++) bat_finder_nearest(q->finder, q->points + 2 * i, &near);
}

static void end_nearest(void *context) {
    query *q = context;
    bat_finder_free(q->finder);
    bat_curve_free(q->curve);
    free(q);
}

typedef struct fitted {
    double x[2 * SAMPLES];
    int count;
    bat_fit_report report;
} fitted;

static void *begin_fit(int variant) {
    fitted *f = calloc(1, sizeof *f);
    if (f) stroke_make(variant, SAMPLES, 0.25, f->x);
    return f;
}

static void run_fit(void *context) {
    fitted *f = context;
    bat_fit_options options = bat_fit_defaults();
    bat_curve *curve;
    options.tolerance = 0.5;
    if (bat_fit(2, SAMPLES, f->x, &options, &curve, &f->report) != BAT_OK) abort();
    f->count = (int)bat_curve_count(curve);
    bat_curve_free(curve);
}

static void note_fit(void *context, char *out, int room) {
    const fitted *f = context;
    snprintf(out, (size_t)room, "%d points, true error %.3f, %d solves", f->count, f->report.max_error,
             f->report.solves);
}

#ifdef BATTEN_BENCH_SKETCH
typedef struct redrawing {
    bat_curve *curve;
    double *points;
    bat_stroke stroke;
    double tolerance;
} redrawing;

static void *begin_sketch(int variant) { /* a stroke over the middle fifth of a 100-point curve */
    redrawing *r = calloc(1, sizeof *r);
    double knots[REDRAWN + 4], points[2 * REDRAWN];
    if (!r) return NULL;
    bench_curve(REDRAWN, 2, knots, points);
    for (int i = 0; i < REDRAWN; i++) points[2 * i] = 20.0 * i, points[2 * i + 1] = 40 * sin(i * 0.2);
    r->points = malloc(sizeof(double) * 2 * (size_t)variant);
    if (!r->points || bat_curve_create(2, 3, false, REDRAWN, points, REDRAWN + 4, knots, &r->curve) != BAT_OK)
        return NULL;
    uint64_t state = 8;
    for (int i = 0; i < variant; i++) {
        const double t = (double)i / (variant - 1), x = 800 + 400 * t;
        r->points[2 * i] = x + 0.2 * stroke_noise(&state);
        r->points[2 * i + 1] = 40 * sin(x * 0.01) + 25 * sin(3.14159265 * t) + 0.2 * stroke_noise(&state);
    }
    r->stroke = (bat_stroke){2, (size_t)variant, r->points, NULL, NULL};
    r->tolerance = bat_sketch_defaults().tolerance;
    return r;
}

static void *begin_missed(int variant) { /* noise, and a tolerance that no curve meets */
    redrawing *r = begin_sketch(variant);
    uint64_t state = 9;
    if (!r) return NULL;
    for (int i = 0; i < variant; i++) r->points[2 * i + 1] += 3 * stroke_noise(&state);
    r->tolerance = 1e-3;
    return r;
}

static void run_sketch(void *context) {
    redrawing *r = context;
    bat_sketch_options options = bat_sketch_defaults();
    bat_curve *out = NULL;
    options.tolerance = r->tolerance;
    const bat_status status = bat_sketch(r->curve, &r->stroke, &options, &out, NULL);
    if (status != BAT_OK && status != BAT_TOLERANCE) abort();
    bat_curve_free(out);
}

static void end_sketch(void *context) {
    redrawing *r = context;
    bat_curve_free(r->curve);
    free(r->points), free(r);
}
#endif

/* ---- parallels ---- */

typedef struct parallel {
    bat_curve *curve;
    size_t count;
    int spans;
} parallel;

static void *begin_parallel(int variant) {
    parallel *p = calloc(1, sizeof *p);
    if (!p) return NULL;
    p->curve = wave(variant);
    return p->curve ? p : NULL;
}

static void take(parallel *p, bat_curve **made) {
    p->spans = 0;
    for (size_t i = 0; i < p->count; i++) p->spans += bat_curve_segment_count(made[i]);
    bat_curves_free(p->count, made);
}

static void offset_by(parallel *p, double distance) {
    bat_curve **out;
    if (bat_curve_offset(p->curve, distance, BENCH_OFFSET_TOLERANCE, 0.02, &p->count, &out, NULL) != BAT_OK)
        abort();
    take(p, out);
}

static void run_offset(void *context) { offset_by(context, BENCH_OFFSET); }
static void run_far_offset(void *context) { offset_by(context, BENCH_OFFSET_FAR); }

static void run_outline(void *context) {
    parallel *p = context;
    const bat_nib nib = {2 * BENCH_OFFSET, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4};
    bat_curve **out;
    if (bat_curve_outline(p->curve, &nib, BENCH_OFFSET_TOLERANCE, 0.02, &p->count, &out, NULL) != BAT_OK)
        abort();
    take(p, out);
}

static void note_parallel(void *context, char *out, int room) {
    const parallel *p = context;
    snprintf(out, (size_t)room, "%zu curves, %d cubics", p->count, p->spans);
}

static void end_parallel(void *context) {
    parallel *p = context;
    bat_curve_free(p->curve);
    free(p);
}

const bench_row bench_rows_shape[] = {
    {"nearest, planar cubic, n=100", "us", 1e6, QUERIES, 100, begin_nearest, run_nearest, end_nearest, 0},
    {"nearest, planar cubic, n=100000", "us", 1e6, QUERIES, 100000, begin_nearest, run_nearest, end_nearest,
     0},
    {"fit 1000, eight bends", "us", 1e6, 1, 0, begin_fit, run_fit, free, note_fit},
    {"fit 1000, spiral", "us", 1e6, 1, 1, begin_fit, run_fit, free, note_fit},
    {"fit 1000, car line", "us", 1e6, 1, 2, begin_fit, run_fit, free, note_fit},
    {"offset, 100 points, no loops", "us", 1e6, 1, 100, begin_parallel, run_offset, end_parallel,
     note_parallel},
    {"offset, 100 points, loops cut off", "us", 1e6, 1, 100, begin_parallel, run_far_offset, end_parallel,
     note_parallel},
    {"outline of a stroke, 100 points", "us", 1e6, 1, 100, begin_parallel, run_outline, end_parallel,
     note_parallel},
#ifdef BATTEN_BENCH_SKETCH
    {"sketch, 240 samples", "us", 1e6, 1, 240, begin_sketch, run_sketch, end_sketch, 0},
    {"sketch, 2400 samples", "us", 1e6, 1, 2400, begin_sketch, run_sketch, end_sketch, 0},
    {"sketch, tolerance missed, 400 samples", "us", 1e6, 1, 400, begin_missed, run_sketch, end_sketch, 0},
    {"sketch, tolerance missed, 2400 samples", "us", 1e6, 1, 2400, begin_missed, run_sketch, end_sketch, 0},
#endif
    {0},
};
