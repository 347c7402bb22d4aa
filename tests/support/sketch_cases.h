/* Shared by the tests of the sketch hand: random smooth curves and strokes, and measures of a redraw. */
#ifndef BATTEN_TESTS_SKETCH_CASES_H
#define BATTEN_TESTS_SKETCH_CASES_H

#include "support/random_curve.h"

#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>
#include <batten/sketch.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static inline double random_normal(random_source *r) {
    const double a = random_unit(r), b = random_unit(r);
    return sqrt(-2 * log(1 - a)) * cos(2 * 3.14159265358979 * b);
}

/* A clamped cubic along a gentle wave, some 600 units long. */
static inline bat_curve *wavy_curve(random_source *r, int count, double strength) {
    double points[2 * 128], knots[140];
    for (int i = 0; i < count; i++) {
        points[2 * i] = 60 + 600.0 * i / (count - 1);
        points[2 * i + 1] = 300 + strength * random_between(r, -1, 1);
    }
    int n = 0;
    for (int i = 0; i < 4; i++) knots[n++] = 0;
    for (int i = 1; i < count - 3; i++) knots[n++] = i;
    for (int i = 0; i < 4; i++) knots[n++] = count - 3;
    bat_curve *curve = NULL;
    if (bat_curve_create(2, 3, false, (size_t)count, points, count + 4, knots, &curve) != BAT_OK) abort();
    return curve;
}

/* A closed cubic around (400, 300). */
static inline bat_curve *ring_curve(random_source *r, int count, double strength) {
    double points[2 * 128], knots[130];
    for (int i = 0; i < count; i++) {
        const double a = 2 * 3.14159265358979 * i / count, radius = 200 + strength * random_between(r, -1, 1);
        points[2 * i] = 400 + radius * cos(a), points[2 * i + 1] = 300 + radius * sin(a);
    }
    for (int i = 0; i <= count; i++) knots[i] = i;
    bat_curve *curve = NULL;
    if (bat_curve_create(2, 3, true, (size_t)count, points, count + 1, knots, &curve) != BAT_OK) abort();
    return curve;
}

/* A stroke that follows the curve from u0 to u1 with smooth sideways bumps; noise in units. */
typedef struct drawn {
    bat_stroke stroke;
    double *points, *truth;
} drawn;

static inline drawn draw_along(random_source *r, const bat_curve *curve, double u0, double u1, size_t count,
                               double height, double noise) {
    drawn d;
    const size_t m = (size_t)bat_curve_dimension(curve);
    d.points = malloc(count * m * sizeof(double)), d.truth = malloc(count * m * sizeof(double));
    if (!d.points || !d.truth) abort();
    const double lift = height * random_between(r, -1, 1), tilt = height * random_between(r, -0.5, 0.5);
    const double waves = random_between(r, 0.5, 2), phase = random_between(r, 0, 6);
    for (size_t i = 0; i < count; i++) {
        const double f = (double)i / (double)(count - 1);
        double jet[2 * BAT_DIMENSION_MAX], v = 0;
        bat_curve_eval(curve, u0 + (u1 - u0) * f, 1, jet);
        for (size_t c = 0; c < m; c++) v += jet[m + c] * jet[m + c];
        v = v > 0 ? sqrt(v) : 1;
        const double side = tilt + lift * sin(3.14159265358979 * f) * cos(waves * 6.28 * f + phase);
        for (size_t c = 0; c < m; c++) d.truth[i * m + c] = jet[c];
        d.truth[i * m] -= side * jet[m + 1] / v, d.truth[i * m + 1] += side * jet[m] / v;
        for (size_t c = 0; c < m; c++) d.points[i * m + c] = d.truth[i * m + c] + noise * random_normal(r);
    }
    d.stroke = (bat_stroke){.dimension = (int)m, .count = count, .points = d.points};
    return d;
}

/* A stroke by a calm hand: a Bézier curve whose seven control points are points of the stretch, displaced at random. */
static inline drawn draw_calmly(random_source *r, const bat_curve *curve, double u0, double u1, size_t count,
                                double height, double noise) {
    enum { DEGREE = 6 };
    drawn d;
    double control[DEGREE + 1][2];
    for (int k = 0; k <= DEGREE; k++) {
        bat_curve_eval(curve, u0 + (u1 - u0) * k / DEGREE, 0, control[k]);
        const double move = k == 0 || k == DEGREE ? 0.2 * height : height;
        for (int c = 0; c < 2; c++) control[k][c] += move * random_between(r, -1, 1);
    }
    d.points = malloc(count * 2 * sizeof(double)), d.truth = malloc(count * 2 * sizeof(double));
    if (!d.points || !d.truth) abort();
    for (size_t i = 0; i < count; i++) {
        const double f = (double)i / (double)(count - 1);
        double row[DEGREE + 1][2];
        memcpy(row, control, sizeof row);
        for (int q = DEGREE; q > 0; q--)
            for (int k = 0; k < q; k++)
                for (int c = 0; c < 2; c++) row[k][c] += f * (row[k + 1][c] - row[k][c]);
        for (int c = 0; c < 2; c++) {
            d.truth[2 * i + (size_t)c] = row[0][c];
            d.points[2 * i + (size_t)c] = row[0][c] + noise * random_normal(r);
        }
    }
    d.stroke = (bat_stroke){.dimension = 2, .count = count, .points = d.points};
    return d;
}

static inline void drawn_free(drawn *d) {
    free(d->points);
    free(d->truth);
}

static inline double gap(const double *a, const double *b, int m) {
    double sum = 0;
    for (int c = 0; c < m; c++) sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sqrt(sum);
}

/* Greatest displacement of the kept parts at equal parameters, relative to the size. */
static inline double kept_moves(const bat_curve *old, const bat_curve *now, const bat_sketch_report *report) {
    enum { PLACES = 400 };
    double domain[2], worst = 0;
    const int m = bat_curve_dimension(old);
    bat_curve_domain(old, domain);
    const double period = domain[1] - domain[0];
    if (report->replaced) return 0;
    double from[2] = {domain[0], report->changed[1]}, to[2] = {report->changed[0], domain[1]};
    double shift[2] = {0, report->changed_new[1] - report->changed[1]};
    if (report->extended[0]) to[0] = from[0] - 1;
    if (report->extended[1]) to[1] = from[1] - 1;
    if (bat_curve_is_closed(old)) from[0] = report->changed[1] - period, to[1] = from[1] - 1;
    for (int part = 0; part < 2; part++)
        for (int i = 0; i <= PLACES && to[part] > from[part]; i++) {
            const double u = from[part] + (to[part] - from[part]) * i / PLACES;
            double a[BAT_DIMENSION_MAX], b[BAT_DIMENSION_MAX];
            bat_curve_eval(old, u, 0, a);
            bat_curve_eval(now, u + shift[part], 0, b);
            worst = fmax(worst, gap(a, b, m));
        }
    return worst / bat_curve_size(old);
}

/* Greatest jump of position and first two derivatives at simple interior knots, relative to the greatest
 * derivative of that order there. */
static inline double worst_jump(const bat_curve *curve) {
    const int m = bat_curve_dimension(curve), n = bat_curve_knot_count(curve), p = bat_curve_degree(curve);
    const double *t = bat_curve_knots(curve);
    double domain[2], worst = 0;
    bat_curve_domain(curve, domain);
    for (int i = 1; i + 1 < n; i++) {
        if (t[i] == t[i - 1] || t[i] == t[i + 1]) continue;
        if (!bat_curve_is_closed(curve) && (t[i] <= domain[0] || t[i] >= domain[1])) continue;
        double a[3 * BAT_DIMENSION_MAX], b[3 * BAT_DIMENSION_MAX], zero[BAT_DIMENSION_MAX] = {0};
        bat_curve_eval_left(curve, t[i], 2, a);
        bat_curve_eval(curve, t[i], 2, b);
        for (int k = 0; k <= (p < 3 ? p - 1 : 2); k++) {
            /* Second derivatives are differences of first ones over the shorter span. */
            double scale = gap(a + k * m, zero, m) + gap(b + k * m, zero, m) +
                           (k == 0 ? bat_curve_size(curve) : 0);
            if (k == 2) {
                const double h = fmin(t[i] - t[i - 1], t[i + 1] - t[i]);
                scale += gap(a + m, zero, m) / h;
            }
            if (scale > 0) worst = fmax(worst, gap(a + k * m, b + k * m, m) / scale);
        }
    }
    return worst;
}

/* Greatest distance from points to the curve. */
static inline double farthest(const bat_curve *curve, const double *points, size_t first, size_t last) {
    const size_t m = (size_t)bat_curve_dimension(curve);
    double worst = 0;
    bat_finder *finder = NULL;
    if (bat_finder_create(curve, &finder) != BAT_OK) abort();
    for (size_t i = first; i <= last; i++) {
        bat_near near;
        bat_finder_nearest(finder, points + i * m, &near);
        worst = fmax(worst, near.distance);
    }
    bat_finder_free(finder);
    return worst;
}

static inline double speed_ratio(const bat_curve *curve) {
    enum { PLACES = 2000 };
    double domain[2], least = INFINITY, most = 0;
    const int m = bat_curve_dimension(curve);
    bat_curve_domain(curve, domain);
    for (int i = 0; i <= PLACES; i++) {
        double jet[2 * BAT_DIMENSION_MAX], zero[BAT_DIMENSION_MAX] = {0};
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / PLACES, 1, jet);
        const double v = gap(jet + m, zero, m);
        least = fmin(least, v), most = fmax(most, v);
    }
    return most / least;
}

#endif
