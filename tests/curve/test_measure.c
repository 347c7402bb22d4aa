/* Lengths against closed forms, boxes and inflections against dense sampling, curvature of the circle. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <math.h>
#include <cmocka.h>
#include <batten/measure.h>
#include "curve/curve.h"
#include "support/random_curve.h"

static bat_curve *make(int p, int m, bool closed, int n, const double *knots, const double *points) {
    bat_curve *curve = NULL;
    assert_int_equal(
        bat_curve_create(m, p, closed, (size_t)n, points, closed ? n + 1 : n + p + 1, knots, &curve), BAT_OK);
    return curve;
}

static const double bezier3[] = {0, 0, 0, 0, 1, 1, 1, 1}, bezier2[] = {0, 0, 0, 1, 1, 1};

/* y = x^2: the arc from 0 to a is a sqrt(1 + 4 a^2) / 2 + asinh(2 a) / 4. Accuracy is swept. */
static void parabola_length(void **state) {
    (void)state;
    const double points[] = {-2, 4, 0, -4, 2, 4};
    bat_curve *curve = make(2, 2, false, 3, bezier2, points);
    for (double relative = 1e-2; relative > 1e-15; relative *= 0.1)
        for (double a = 0; a <= 2; a += 0.125) {
            const double want = a * sqrt(1 + 4 * a * a) / 2 + asinh(2 * a) / 4, u = 0.5 + a / 4;
            assert_true(fabs(bat_curve_length(curve, 0.5, u, relative) - want) <=
                        (relative + 4e-15) * (want + 1));
            assert_true(bat_curve_length(curve, u, 0.5, relative) ==
                        -bat_curve_length(curve, 0.5, u, relative));
            assert_true(fabs(bat_curve_at_length(curve, 0.5, want, relative) - u) < relative + 1e-14);
            assert_true(fabs(bat_curve_at_length(curve, u, -want, relative) - 0.5) < relative + 1e-14);
        }
    assert_true(bat_curve_at_length(curve, 0.5, 1e9, 1e-9) == 1 &&
                bat_curve_at_length(curve, 0.5, -1e9, 1e-9) == 0);
    bat_curve_free(curve);
}

/* (t^2, t^3), a cusp inside the span: the arc from the cusp is ((4 + 9 t^2)^(3/2) - 8) / 27. */
static void cusp_length(void **state) {
    (void)state;
    const double points[] = {1, -1, -1. / 3, 1, -1. / 3, -1, 1, 1};
    bat_curve *curve = make(3, 2, false, 4, bezier3, points);
    const double want = 2 * (pow(13, 1.5) - 8) / 27;
    assert_true(fabs(bat_curve_length(curve, 0, 1, 1e-12) - want) < 1e-12 * want);
    /* the speed vanishes at the middle: the inverse still arrives */
    assert_true(fabs(bat_curve_at_length(curve, 0, want / 2, 1e-12) - 0.5) < 1e-5);
    const double quarter = (pow(4 + 9 * 0.25, 1.5) - 8) / 27;
    assert_true(fabs(bat_curve_at_length(curve, 0.5, quarter, 1e-12) - 0.75) < 1e-11);
    assert_true(bat_curve_curvature(curve, 0.5) == 0);
    bat_curve_free(curve);
}

/* Closed: a square of lines, over the seam and round more than once; both ways. */
static void closed_length(void **state) {
    (void)state;
    const double knots[] = {0, 1, 2, 3, 4}, points[] = {0, 0, 1, 0, 1, 1, 0, 1};
    bat_curve *curve = make(1, 2, true, 4, knots, points);
    assert_true(fabs(bat_curve_length(curve, 3.5, 4.5, 1e-9) - 1) < 1e-14);
    assert_true(fabs(bat_curve_length(curve, -0.25, 11, 1e-9) - 11.25) < 1e-13);
    assert_true(fabs(bat_curve_length(curve, 11, -0.25, 1e-9) + 11.25) < 1e-13);
    assert_true(fabs(bat_curve_at_length(curve, 3.5, 1, 1e-9) - 4.5) < 1e-9);
    assert_true(fabs(bat_curve_at_length(curve, 0.25, -10, 1e-9) + 9.75) < 1e-8);
    assert_true(isnan(bat_curve_length(curve, 0, NAN, 1e-9)));
    assert_true(isnan(bat_curve_at_length(curve, 0, NAN, 1e-9)));
    bat_curve_free(curve);
}

/* length and its inverse on curves of every kind; additive; against a polygon of many chords from below. */
/* A power of two changes the scale and nothing else, where squares of speeds would overflow or vanish, too. */
static void length_at_every_scale(void **state) {
    (void)state;
    static const int powers[] = {-900, -530, -400, 100, 230};
    for (uint64_t seed = 1; seed <= 20; seed++) {
        random_source r = {seed};
        bat_curve *curve = random_curve(&r, 1 + (int)(seed % 7), 2 + (int)(seed % 2), seed % 3 == 0, 6);
        const int p = bat_curve_degree(curve), m = bat_curve_dimension(curve), n = bat_point_count(curve);
        double domain[2], *points = malloc(sizeof(double) * (size_t)(n * m));
        assert_non_null(points);
        bat_curve_domain(curve, domain);
        const double length = bat_curve_length(curve, domain[0], domain[1], 1e-9);
        const double u = bat_curve_at_length(curve, domain[0], 0.37 * length, 1e-9);
        for (size_t k = 0; k < sizeof powers / sizeof *powers; k++) {
            for (int i = 0; i < n * m; i++) points[i] = ldexp(bat_curve_points(curve)[i], powers[k]);
            bat_curve *scaled = make(p, m, bat_curve_is_closed(curve), n, bat_curve_knots(curve), points);
            const double there = bat_curve_length(scaled, domain[0], domain[1], 1e-9);
            assert_true(fabs(ldexp(there, -powers[k]) - length) <= 1e-12 * length);
            const double v = bat_curve_at_length(scaled, domain[0], ldexp(0.37 * length, powers[k]), 1e-9);
            assert_true(fabs(v - u) <= 1e-9 * (domain[1] - domain[0]));
            bat_curve_free(scaled);
        }
        free(points);
        bat_curve_free(curve);
    }
}

static void length_properties(void **state) {
    (void)state;
    random_source r = {3};
    for (int p = 1; p <= 7; p++)
        for (int kind = 0; kind < 3; kind++) {
            bat_curve *curve = random_curve(&r, p, 2 + p % 2, kind, 8);
            const int m = bat_curve_dimension(curve);
            double domain[2], chords = 0, last[3], now[3];
            bat_curve_domain(curve, domain);
            const double all = bat_curve_length(curve, domain[0], domain[1], 1e-10);
            bat_curve_eval(curve, domain[0], 0, last);
            for (int i = 1; i <= 20000; i++) {
                double d = 0;
                if (i < 20000)
                    bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / 20000, 0, now);
                else
                    bat_curve_eval_left(curve, domain[1], 0, now);
                for (int c = 0; c < m; c++) d = hypot(d, now[c] - last[c]), last[c] = now[c];
                chords += d;
            }
            assert_true(chords <= all * (1 + 1e-9) && chords > all * (1 - 1e-3));
            for (int k = 0; k < 10; k++) {
                const double u0 = random_between(&r, domain[0], domain[1]);
                const double s = random_between(&r, -1, 1) * all;
                const double u1 = bat_curve_at_length(curve, u0, s, 1e-10);
                const double got = bat_curve_length(curve, u0, u1, 1e-10);
                if (kind == 2 || (u1 > domain[0] && u1 < domain[1])) assert_true(fabs(got - s) < 1e-8 * all);
            }
            bat_curve_free(curve);
        }
}

/* Every sample is inside; each side of the box is touched. */
static void boxes(void **state) {
    (void)state;
    random_source r = {9};
    for (int round = 0; round < 60; round++) {
        bat_curve *curve = random_curve(&r, 1 + round % 7, 2 + round % 2, round % 3, 6);
        const int m = bat_curve_dimension(curve);
        double low[3], high[3], least[3], most[3];
        bat_curve_bounds(curve, low, high);
        for (int c = 0; c < m; c++) least[c] = INFINITY, most[c] = -INFINITY;
        const double *t = bat_curve_knots(curve); /* span by span: some are very short */
        for (int k = 1; k < bat_curve_knot_count(curve); k++)
            for (int i = 0; i <= 200; i++) {
                double x[3];
                bat_curve_eval(curve, t[k - 1] + (t[k] - t[k - 1]) * i / 200, 0, x);
                for (int c = 0; c < m; c++) least[c] = fmin(least[c], x[c]), most[c] = fmax(most[c], x[c]);
            }
        for (int c = 0; c < m; c++) {
            assert_true(least[c] >= low[c] - 1e-12 && most[c] <= high[c] + 1e-12);
            assert_true(least[c] - low[c] < 0.05 && high[c] - most[c] < 0.05);
        }
        bat_curve_free(curve);
    }
    /* a derivative with a double zero at its start: x = -t^3 + 3/4 t^4 + ..., least inside; found by a fuzzer
     */
    const double knots5[] = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, late[] = {0, 0, 0, 0, 0, 0, -1, 0, 0, 1};
    bat_curve *flat = make(4, 2, false, 5, knots5, late);
    double least[2], most[2];
    bat_curve_bounds(flat, least, most);
    assert_true(fabs(least[0] + 27. / 64) < 1e-14); /* -4 t^3 (1 - t) at t = 3/4 */
    bat_curve_free(flat);
    /* closed form: x = 3t(1-t)^2 peaks at t = 1/3 with 4/9 */
    const double points[] = {0, 0, 1, 0, 0, 0, 0, 1};
    bat_curve *curve = make(3, 2, false, 4, bezier3, points);
    double low[2], high[2];
    bat_curve_bounds(curve, low, high);
    assert_true(fabs(high[0] - 4. / 9) < 1e-15 && low[0] == 0 && low[1] == 0 && high[1] == 1);
    bat_curve_free(curve);
}

/* A uniform periodic spline through a regular polygon is a circle nearly: its length and curvature tell. */
static void circle(void **state) {
    (void)state;
    enum { N = 64 };
    const double pi = acos(-1), h = 2 * pi / N;
    double knots[N + 1], points[2 * N];
    const double radius = 3 / (2. / 3 + cos(h) / 3); /* the spline's knots then lie on radius 3 */
    for (int i = 0; i <= N; i++) knots[i] = i;
    for (int i = 0; i < N; i++)
        points[2 * i] = 7 + radius * cos(i * h), points[2 * i + 1] = radius * sin(i * h);
    bat_curve *curve = make(3, 2, true, N, knots, points);
    assert_true(fabs(bat_curve_length(curve, 0, N, 1e-13) - 6 * pi) < 1e-5);
    for (double u = 0; u < N; u += 0.37) assert_true(fabs(bat_curve_curvature(curve, u) - 1. / 3) < 1e-3);
    double low[2], high[2], u[4];
    bat_curve_bounds(curve, low, high);
    assert_true(fabs(high[0] - 10) < 1e-6 && fabs(low[1] + 3) < 1e-6);
    assert_int_equal(bat_curve_inflections(curve, 4, u), 0);
    for (int i = 0; i < N; i++) points[2 * i + 1] = -points[2 * i + 1];
    bat_curve *mirrored = make(3, 2, true, N, knots, points);
    assert_true(fabs(bat_curve_curvature(mirrored, 5.5) + bat_curve_curvature(curve, 5.5)) < 1e-12);
    double there, back;
    assert_int_equal(bat_curve_distance(curve, mirrored, 8, &there, &back), BAT_OK);
    assert_true(there < 1e-9 && back < 1e-9);
    bat_curve_free(curve), bat_curve_free(mirrored);
    /* in space: a circle in a slanted plane keeps its curvature */
    const double helix[] = {0, 0, 0, 1, 0, 1, 1, 1, 2, 0, 1, 3};
    curve = make(3, 3, false, 4, bezier3, helix);
    double d[9];
    bat_curve_eval(curve, 0.3, 2, d);
    const double x = d[4] * d[8] - d[5] * d[7], y = d[5] * d[6] - d[3] * d[8], z = d[3] * d[7] - d[4] * d[6];
    const double v = sqrt(d[3] * d[3] + d[4] * d[4] + d[5] * d[5]);
    assert_true(fabs(bat_curve_curvature(curve, 0.3) - sqrt(x * x + y * y + z * z) / (v * v * v)) < 1e-13);
    bat_curve_free(curve);
}

/* y = x^3 turns at 0; lines and parabolas never; random curves where the sampled sign changes. */
static void inflections(void **state) {
    (void)state;
    const double cubic[] = {-1, -1, -1. / 3, 1, 1. / 3, -1, 1, 1},
                 line[] = {0, 0, 0.1, 0.3, 0.2, 0.6, 0.3, 0.9};
    double u[64];
    bat_curve *curve = make(3, 2, false, 4, bezier3, cubic);
    assert_int_equal(bat_curve_inflections(curve, 64, u), 1);
    assert_true(fabs(u[0] - 0.5) < 1e-15);
    assert_int_equal(bat_curve_inflections(curve, 0, NULL), 1);
    bat_curve_free(curve);
    curve = make(3, 2, false, 4, bezier3, line);
    assert_int_equal(bat_curve_inflections(curve, 64, u), 0);
    bat_curve_free(curve);
    random_source r = {21};
    int total = 0;
    for (int round = 0; round < 60; round++) {
        curve = random_curve(&r, 2 + round % 6, 2, round % 3, 6);
        const int count = (int)bat_curve_inflections(curve, 64, u);
        double domain[2];
        bat_curve_domain(curve, domain);
        for (int k = 1; k < count; k++) assert_true(u[k] >= u[k - 1]);
        const int steps = 4000;
        const double step = (domain[1] - domain[0]) / steps;
        for (int i = 0; i < steps; i++) { /* a change between two samples has one of ours between them */
            const double a = domain[0] + i * step, b = a + step;
            if (bat_curve_curvature(curve, a) * bat_curve_curvature(curve, b) >= 0) continue;
            int inside = 0;
            for (int k = 0; k < count; k++) inside += u[k] >= a - 1e-9 && u[k] <= b + 1e-9;
            if (round % 3 == 2 && i == steps - 1) inside += count > 0 && u[0] == domain[0]; /* the seam */
            assert_true(inside >= 1);
            total++;
        }
        for (int k = 0; k < count; k++) { /* and ours are changes */
            const double e = 1e-7 * (domain[1] - domain[0]);
            if (u[k] - e < domain[0] || u[k] + e > domain[1]) continue;
            assert_true(bat_curve_curvature(curve, u[k] - e) * bat_curve_curvature(curve, u[k] + e) <= 0);
        }
        bat_curve_free(curve);
    }
    assert_true(total > 60);
}

/* Two parallel lines, one longer: the farthest point is its free end. */
static void distances(void **state) {
    (void)state;
    const double knots[] = {0, 0, 1, 1}, a[] = {0, 0, 1, 0}, b[] = {0, 1, 3, 1};
    bat_curve *one = make(1, 2, false, 2, knots, a), *two = make(1, 2, false, 2, knots, b), *space = NULL;
    double there, back;
    assert_int_equal(bat_curve_distance(one, two, 7, &there, &back), BAT_OK);
    assert_true(fabs(there - 1) < 1e-12 && fabs(back - sqrt(5)) < 1e-12);
    assert_int_equal(bat_curve_to_dimension(one, 3, &space), BAT_OK);
    assert_int_equal(bat_curve_distance(one, space, 7, &there, &back), BAT_DIMENSION);
    assert_int_equal(bat_curve_distance(one, two, 0, &there, &back), BAT_ARGUMENT);
    assert_int_equal(bat_curve_distance(one, NULL, 1, &there, &back), BAT_ARGUMENT);
    bat_curve_free(one), bat_curve_free(two), bat_curve_free(space);
}

/* x = 8 u^3 + 3 u^4 rises from -5 to 11 over -1..1 and stands still at 0, where the first guess for the half is. */
static void half_way_at_a_standstill(void **state) {
    (void)state;
    const double points[10] = {-5, 0, 1, 0, 3, 0, -7, 0, 11, 0},
                 knots[10] = {-1, -1, -1, -1, -1, 1, 1, 1, 1, 1};
    bat_curve *curve = NULL;
    double at[2];
    assert_int_equal(bat_curve_create(2, 4, false, 5, points, 10, knots, &curve), BAT_OK);
    for (int k = 1; k < 64; k++) {
        bat_curve_eval(curve, bat_curve_at_length(curve, -1, 0.25 * k, 1e-12), 0, at);
        assert_true(fabs(at[0] - (-5 + 0.25 * k)) < 1e-9);
    }
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(parabola_length),
                                       cmocka_unit_test(half_way_at_a_standstill),
                                       cmocka_unit_test(cusp_length),
                                       cmocka_unit_test(closed_length),
                                       cmocka_unit_test(length_at_every_scale),
                                       cmocka_unit_test(length_properties),
                                       cmocka_unit_test(boxes),
                                       cmocka_unit_test(circle),
                                       cmocka_unit_test(inflections),
                                       cmocka_unit_test(distances)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
