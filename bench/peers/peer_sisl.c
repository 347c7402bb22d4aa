/* SISL: evaluation, insertion of knots, closest point, data reduction of strokes, offset, rays and crossings of surfaces. */
#define _POSIX_C_SOURCE 199309L
#include "../made.h"
#include "../reference.h"
#include "../strokes.h"
#include "../timing.h"

#include <sisl.h>
#include <stdlib.h>
#include <string.h>

enum { EVALS = 100000, QUERIES = 100, SAMPLES = 1000, NET = 32, SIDE = 512, RAYS = 100, WAVE = 100 };

typedef struct work {
    int n, derivatives, status, count, followed;
    double *knots, *points, *out, error;
    const double *queries;
    SISLCurve *curve;
    SISLSurf *surface, *other;
} work;

static work wave(int n, int dimension) {
    work w = {.n = n};
    w.knots = malloc(sizeof(double) * (size_t)(n + 4));
    w.points = malloc(sizeof(double) * (size_t)(n * dimension));
    if (!w.knots || !w.points) abort();
    bench_curve(n, dimension, w.knots, w.points);
    w.curve = newCurve(n, 4, w.knots, w.points, 1, dimension, 1);
    if (!w.curve) abort();
    return w;
}

static void end(work *w) {
    freeCurve(w->curve);
    free(w->knots), free(w->points);
}

static void must(int status) {
    if (status < 0) abort();
}

static void evaluate(void *context) { /* in order, so that the span found last is near */
    work *w = context;
    double out[9];
    for (int i = 0, left = 0; i < EVALS; i++)
        s1227(w->curve, w->derivatives, (double)i / EVALS, &left, out, &w->status);
    must(w->status);
}

static void evaluate_apart(void *context) {
    work *w = context;
    double out[3];
    for (int i = 0; i < EVALS; i++) {
        int left = 0;
        s1227(w->curve, 0, (double)(i * 7919LL % EVALS) / EVALS, &left, out, &w->status);
    }
    must(w->status);
}

static void insert(void *context) {
    work *w = context;
    double u[1000];
    SISLCurve *out = NULL;
    for (int i = 0; i < 1000; i++) u[i] = (i + 0.37) / 1000;
    s1018(w->curve, u, 1000, &out, &w->status);
    must(w->status);
    freeCurve(out);
}

static void draw(const void *context, double u, double *out) {
    const work *w = context;
    bench_point(w->n, 2, w->knots, w->points, u, out);
}

static double nearest_of(work *w, const double *x) {
    int points = 0, curves = 0, left = 0;
    double *found = NULL, out[2] = {0, 0};
    SISLIntcurve **same = NULL;
    s1953(w->curve, (double *)x, 2, 1e-9, 1e-9, &points, &found, &curves, &same, &w->status);
    must(w->status);
    if (points > 0) s1227(w->curve, 0, found[0], &left, out, &w->status);
    free(found);
    if (same) freeIntcrvlist(same, curves);
    return points > 0 ? hypot(out[0] - x[0], out[1] - x[1]) : HUGE_VAL;
}

static void nearest(void *context) {
    work *w = context;
    for (int i = 0; i < QUERIES; i++) nearest_of(w, w->queries + 2 * i);
}

static void fit(void *context) { /* queries: the samples */
    work *w = context;
    double tolerance[2] = {0.5, 0.5}, parameters[SAMPLES], errors[2],
           *x = malloc(sizeof(double) * 2 * SAMPLES);
    if (!x) abort();
    memcpy(x, w->queries, sizeof(double) * 2 * SAMPLES);
    SISLCurve *out = NULL;
    s1961(x, SAMPLES, 2, 1, parameters, tolerance, 0, 0, 1, 1e-6, 20, 4, &out, errors, &w->status);
    must(w->status);
    w->count = out->in;
    if (w->curve) freeCurve(w->curve);
    w->curve = out;
    free(x);
}

static void draw_fit(const void *context, double u, double *out) {
    const work *w = context;
    int left = 0, status;
    const double *t = w->curve->et;
    s1227(w->curve, 0, t[3] + u * (t[w->curve->in] - t[3]), &left, out, &status);
}

static void offset(void *context) {
    work *w = context;
    double plane[3] = {0, 0, 1};
    SISLCurve *out = NULL;
    s1360(w->curve, BENCH_OFFSET, BENCH_OFFSET_TOLERANCE, plane, 0, 2, &out, &w->status);
    must(w->status);
    w->count = out->in;
    freeCurve(out);
}

static void grid(void *context) {
    work *w = context;
    static double u[SIDE];
    for (int i = 0; i < SIDE; i++) u[i] = i / (SIDE - 1.0);
    s1506(w->surface, 0, SIDE, u, SIDE, u, w->out, w->out, &w->status);
    must(w->status);
}

static void rays(void *context) {
    work *w = context;
    w->count = 0;
    for (int k = 0; k < RAYS; k++) {
        double o[3], d[3], *found = NULL;
        int points = 0, curves = 0;
        SISLIntcurve **along = NULL;
        bench_ray(NET, k, o, d);
        s1856(w->surface, o, d, 3, 1e-9, 1e-6, &points, &found, &curves, &along, &w->status);
        must(w->status);
        w->count += points;
        free(found);
        if (along) freeIntcrvlist(along, curves);
    }
}

/* The curve in which they cross: where its loops are, then their points, one by one. */
static void meet(void *context) {
    work *w = context;
    int points = 0, curves = 0;
    double *first = NULL, *second = NULL;
    SISLIntcurve **along = NULL;
    s1859(w->surface, w->other, 1e-9, BENCH_MEET_TOLERANCE, &points, &first, &second, &curves, &along,
          &w->status);
    must(w->status);
    w->count = curves, w->followed = 0;
    for (int i = 0; i < curves; i++) {
        s1310(w->surface, w->other, along[i], BENCH_MEET_TOLERANCE, 0, 2, 0, &w->status);
        w->followed += w->status >= 0;
    }
    free(first), free(second);
    if (along) freeIntcrvlist(along, curves);
}

static SISLSurf *tube(int which) { /* the ring comes round again by its first three points */
    static double points[2][6 * (BENCH_TUBE + 3)], across[4] = {0, 0, 1, 1}, around[BENCH_TUBE + 7];
    double whole[6 * BENCH_TUBE];
    bench_tube(which, whole);
    for (int i = 0; i < BENCH_TUBE + 7; i++) around[i] = i - 3;
    for (int i = 0; i < BENCH_TUBE + 3; i++)
        for (int row = 0; row < 2; row++)
            memcpy(points[which] + 3 * (2 * i + row), whole + 3 * (row * BENCH_TUBE + i % BENCH_TUBE),
                   3 * sizeof(double));
    SISLSurf *made = newSurf(2, BENCH_TUBE + 3, 2, 4, across, around, points[which], 1, 3, 1),
             *clamped = NULL;
    int status = 0;
    s1001(made, 0, 0, 1, BENCH_TUBE, &clamped, &status);
    must(status);
    freeSurf(made);
    return clamped;
}

static void curves(void) {
    static const int sizes[] = {16, 1000, 100000};
    char text[80];
    for (int i = 0; i < 3; i++) {
        work w = wave(sizes[i], 3);
        double out[3], right[3];
        int left = 0;
        s1227(w.curve, 0, 0.37, &left, out, &w.status);
        bench_point(w.n, 3, w.knots, w.points, 0.37, right);
        for (int c = 0; c < 3; c++) w.error = fmax(w.error, fabs(out[c] - right[c]));
        snprintf(text, sizeof text, "off by %.1g", w.error);
        char name[80];
        snprintf(name, sizeof name, "eval 1e6 sorted, 3D cubic, n=%d", sizes[i]);
        bench_print("sisl", name, "ns/point", bench_measure(evaluate, &w), EVALS, 1e9, text);
        w.derivatives = 2;
        if (i == 1) {
            bench_print("sisl", "eval 2 derivatives, n=1000", "ns/point", bench_measure(evaluate, &w), EVALS,
                        1e9, "");
            bench_print("sisl", "eval single, n=1000", "ns/point", bench_measure(evaluate_apart, &w), EVALS,
                        1e9, "");
        }
        end(&w);
    }
    work plane = wave(1000, 2);
    bench_print("sisl", "insert 1000 knots into 1000", "us", bench_measure(insert, &plane), 1, 1e6, "");
    end(&plane);
    work w = wave(WAVE, 2);
    double x[2 * QUERIES];
    bench_queries(WAVE, QUERIES, x);
    w.queries = x;
    for (int i = 0; i < QUERIES; i++)
        w.error = fmax(w.error, fabs(nearest_of(&w, x + 2 * i) - bench_distance(draw, &w, 20000, x + 2 * i)));
    snprintf(text, sizeof text, "distances off by %.1g", w.error);
    bench_print("sisl", "nearest, planar cubic, n=100", "us", bench_measure(nearest, &w), QUERIES, 1e6, text);
    bench_time t = bench_measure(offset, &w);
    snprintf(text, sizeof text, "%d points, loops stay", w.count);
    bench_print("sisl", "offset, 100 points, no loops", "us", t, 1, 1e6, text);
    end(&w);
    static const char *const names[] = {"fit 1000, eight bends", "fit 1000, spiral", "fit 1000, car line"};
    for (int k = 0; k < 3; k++) {
        double samples[2 * SAMPLES];
        work f = {.queries = samples};
        stroke_make(k, SAMPLES, 0.25, samples);
        t = bench_measure(fit, &f);
        for (int i = 0; i < SAMPLES; i++)
            f.error = fmax(f.error, bench_distance(draw_fit, &f, 2000, samples + 2 * i));
        snprintf(text, sizeof text, "%d points, true error %.3f", f.count, f.error);
        bench_print("sisl", names[k], "us", t, 1, 1e6, text);
        freeCurve(f.curve);
    }
}

static void surfaces(void) {
    static double knots[NET + 4], points[3 * NET * NET], out[3 * SIDE * SIDE];
    char text[80];
    work w = {.out = out};
    bench_surface(NET, 3, knots, points);
    w.surface = newSurf(NET, NET, 4, 4, knots, knots, points, 1, 3, 1);
    if (!w.surface) abort();
    bench_print("sisl", "bicubic 32 x 32 on 512 x 512", "ns", bench_measure(grid, &w), SIDE * SIDE, 1e9, "");
    bench_time t = bench_measure(rays, &w);
    snprintf(text, sizeof text, "%d hits of %d rays", w.count, RAYS);
    bench_print("sisl", "ray, bicubic 32 x 32", "us", t, RAYS, 1e6, text);
    freeSurf(w.surface);
    w.surface = tube(0), w.other = tube(1);
    t = bench_measure(meet, &w);
    snprintf(text, sizeof text, "%d of %d pieces followed", w.followed, w.count);
    bench_print("sisl", "intersection of two tubes", "us", t, 1, 1e6, text);
    freeSurf(w.surface), freeSurf(w.other);
}

int main(void) {
    curves();
    surfaces();
    return 0;
}
