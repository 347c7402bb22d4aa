/* Closest points: no sampled point of a curve is nearer than the result, over 12,000 queries on curves of every kind;
 * the results lie on the curve; the local minima are complete; degenerate curves take bounded time. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <cmocka.h>
#include <batten/nearest.h>
#include "support/random_curve.h"

enum { SAMPLES = 600 };

static double distance_of(const double *a, const double *b, int m) {
    double d = 0;
    for (int c = 0; c < m; c++) d = hypot(d, a[c] - b[c]);
    return d;
}

/* The answer lies on the curve, and none of the samples, nor the best of them after Newton, is nearer. */
static void check_query(const bat_curve *curve, const bat_finder *finder, const double *u, const double *x,
                        const double *point) {
    const int m = bat_curve_dimension(curve);
    const double size = bat_curve_size(curve);
    bat_near near;
    double at[3], best = INFINITY, best_u = 0;
    bat_finder_nearest(finder, point, &near);
    bat_curve_eval(curve, near.u, 0, at);
    /* at a knot where the speed is great, u carries less than the point does */
    assert_true(distance_of(at, near.point, m) <= 1e-11 * (size + distance_of(at, point, m)));
    assert_true(fabs(distance_of(near.point, point, m) - near.distance) <= 1e-13 * (size + near.distance));
    for (int i = 0; i < SAMPLES; i++) {
        const double d = distance_of(x + i * m, point, m);
        if (d < best) best = d, best_u = u[i];
    }
    bat_curve_eval(curve, bat_curve_project_near(curve, point, best_u, 20), 0, at);
    assert_true(distance_of(at, point, m) <= best + 1e-13 * size); /* bulk and single differ by rounding */
    best = distance_of(at, point, m);
    assert_true(near.distance <= best + 1e-12 * size);
}

static void nothing_is_nearer(void **state) {
    (void)state;
    random_source r = {11};
    static double u[SAMPLES], x[SAMPLES * 3];
    for (int round = 0; round < 6; round++)
        for (int p = 1; p <= 7; p++)
            for (int m = 2; m <= 3; m++)
                for (int kind = 0; kind < 3; kind++) {
                    bat_curve *curve = random_curve(&r, p, m, kind, random_int(&r, 0, round == 0 ? 60 : 10));
                    bat_finder *finder;
                    assert_int_equal(bat_finder_create(curve, &finder), BAT_OK);
                    bat_curve_spread(curve, SAMPLES, u);
                    assert_int_equal(bat_curve_eval_many(curve, SAMPLES, u, 0, x), BAT_OK);
                    for (int query = 0; query < 48; query++) {
                        double point[3], d[9], reach = query % 3 == 0 ? 1 : query % 3 == 1 ? 12 : 200;
                        for (int c = 0; c < m; c++) point[c] = random_between(&r, -reach, reach);
                        if (query % 4 == 0) { /* on the curve, or off it by little */
                            bat_curve_eval(curve, u[random_int(&r, 0, SAMPLES - 1)], 0, point);
                            if (query % 8 == 0) point[0] += random_between(&r, -1e-6, 1e-6);
                        } else if (query % 16 ==
                                   5) { /* centre of curvature: a stationary point of order three */
                            bat_curve_eval(curve, u[random_int(&r, 0, SAMPLES - 1)], 2, d);
                            const double cross = d[m] * d[2 * m + 1] - d[m + 1] * d[2 * m];
                            const double f = (d[m] * d[m] + d[m + 1] * d[m + 1]) / cross;
                            if (m == 2 && fabs(f) < 1e3)
                                point[0] = d[0] - f * d[3], point[1] = d[1] + f * d[2];
                        }
                        check_query(curve, finder, u, x, point);
                    }
                    bat_finder_free(finder);
                    bat_curve_free(curve);
                }
}

static bat_curve *make(int p, int m, bool closed, int n, const double *knots, const double *points) {
    bat_curve *curve = NULL;
    assert_int_equal(
        bat_curve_create(m, p, closed, (size_t)n, points, closed ? n + 1 : n + p + 1, knots, &curve), BAT_OK);
    return curve;
}

/* Point against parabola y = x^2: closed form by Cardano at (0, c): nearest is the vertex up to c = 1/2, then
 * x^2 = c - 1/2. */
static void parabola(void **state) {
    (void)state;
    const double knots[] = {0, 0, 0, 1, 1, 1}, points[] = {-2, 4, 0, -4, 2, 4};
    bat_curve *curve = make(2, 2, false, 3, knots, points);
    for (double c = -1; c < 3; c += 0.0625) {
        const double point[2] = {0, c};
        bat_near near, all[4];
        size_t count;
        assert_int_equal(bat_curve_nearest(curve, point, &near), BAT_OK);
        const double want = c <= 0.5 ? fabs(c) : sqrt(c - 0.25);
        assert_true(fabs(near.distance - want) < 1e-13);
        /* up to the cusp of the evolute; the ends are local minima when the distance grows inwards: never
         * here */
        assert_int_equal(bat_curve_nearest_all(curve, point, INFINITY, 4, all, &count), BAT_OK);
        assert_int_equal(count, c <= 0.5 ? 1 : 2);
        if (count == 2) {
            assert_true(fabs(all[0].u - (0.5 - sqrt(c - 0.5) / 4)) < 1e-9 ||
                        fabs(all[0].u - (0.5 + sqrt(c - 0.5) / 4)) < 1e-9);
            assert_true(fabs(all[0].u + all[1].u - 1) < 1e-9);
            assert_int_equal(bat_curve_nearest_all(curve, point, want * 0.999, 4, all, &count), BAT_OK);
            assert_int_equal(count, 0);
        }
    }
    bat_curve_free(curve);
}

/* A square of lines: from inside, each side is a local minimum; from outside, a corner is one. */
static void square_has_four(void **state) {
    (void)state;
    const double knots[] = {0, 1, 2, 3, 4}, points[] = {0, 0, 1, 0, 1, 1, 0, 1};
    bat_curve *curve = make(1, 2, true, 4, knots, points);
    bat_near all[2];
    size_t count;
    const double inside[] = {0.4, 0.3}, outside[] = {-0.5, -0.25}, centre[] = {0.5, 0.5};
    assert_int_equal(bat_curve_nearest_all(curve, inside, INFINITY, 2, all, &count), BAT_OK);
    assert_int_equal(count, 4);
    assert_true(fabs(all[0].distance - 0.3) < 1e-15 && fabs(all[1].distance - 0.4) < 1e-15);
    assert_int_equal(bat_curve_nearest_all(curve, centre, INFINITY, 2, all, &count), BAT_OK);
    assert_int_equal(count, 4);
    assert_int_equal(bat_curve_nearest_all(curve, outside, INFINITY, 2, all, &count), BAT_OK);
    assert_int_equal(count, 1);
    assert_true(fabs(all[0].distance - hypot(0.5, 0.25)) < 1e-15);
    assert_int_equal(bat_curve_nearest_all(curve, inside, 0.35, 0, NULL, &count), BAT_OK);
    assert_int_equal(count, 1);
    bat_curve_free(curve);
}

/* All local minima against the sign changes of a dense sampling. */
static void all_minima_are_found(void **state) {
    (void)state;
    random_source r = {5};
    enum { DENSE = 4000 };
    static double u[DENSE], x[DENSE * 2], d[DENSE];
    int total = 0;
    for (int round = 0; round < 60; round++) {
        const int p = 1 + round % 7, kind = round % 3;
        bat_curve *curve = random_curve(&r, p, 2, kind, 6);
        bat_curve_spread(curve, DENSE, u);
        assert_int_equal(bat_curve_eval_many(curve, DENSE, u, 0, x), BAT_OK);
        for (int query = 0; query < 5; query++) {
            const double point[2] = {random_between(&r, -8, 8), random_between(&r, -8, 8)};
            bat_near all[64];
            size_t count;
            assert_int_equal(bat_curve_nearest_all(curve, point, INFINITY, 64, all, &count), BAT_OK);
            assert_true(count >= 1 && count <= 64);
            const int found = (int)count;
            for (int i = 0; i < DENSE; i++) d[i] = distance_of(x + 2 * i, point, 2);
            for (int i = 0; i < DENSE; i++) {
                const int before = kind == 2 ? (i + DENSE - 1) % DENSE : i - 1;
                const int after = kind == 2 ? (i + 1) % DENSE : i + 1;
                if ((before >= 0 && d[before] <= d[i]) || (after < DENSE && d[after] <= d[i])) continue;
                double nearest = INFINITY; /* a sampled minimum: one of ours must lie beside it */
                const double step = u[1] - u[0], period = DENSE * step;
                for (int k = 0; k < found; k++) {
                    const double gap = fabs(all[k].u - u[i]);
                    nearest = fmin(nearest, kind == 2 ? fmin(gap, fabs(gap - period)) : gap);
                }
                assert_true(nearest <= 1.001 * step);
                total++;
            }
            for (int k = 1; k < found; k++) assert_true(all[k].distance >= all[k - 1].distance);
            bat_near best;
            assert_int_equal(bat_curve_nearest(curve, point, &best), BAT_OK);
            assert_true(fabs(best.distance - all[0].distance) < 1e-12);
        }
        bat_curve_free(curve);
    }
    assert_true(total > 300);
}

/* All points coincident; a cusp; doubled-back lines; a huge curve: right, and soon. */
static void degenerate_curves(void **state) {
    (void)state;
    for (int p = 1; p <= 7; p++) {
        double knots[32], points[64];
        for (int i = 0; i < 20 + p + 1; i++) knots[i] = i;
        for (int i = 0; i < 64; i++) points[i] = i % 2 ? 0.7 : 0.1;
        bat_curve *open = make(p, 2, false, 20, knots, points), *closed = make(p, 2, true, 20, knots, points);
        const double far[] = {3.1, 4.7}, on[] = {0.1, 0.7};
        bat_near near, all[3];
        size_t count;
        for (int k = 0; k < 2; k++) {
            const bat_curve *curve = k ? closed : open;
            double domain[2];
            bat_curve_domain(curve, domain);
            assert_int_equal(bat_curve_nearest(curve, far, &near), BAT_OK);
            assert_true(fabs(near.distance - 5) < 1e-13);
            assert_int_equal(bat_curve_nearest_all(curve, far, INFINITY, 3, all, &count), BAT_OK);
            assert_int_equal(count, 1);
            assert_int_equal(bat_curve_nearest(curve, on, &near), BAT_OK);
            assert_true(near.distance < 1e-15 && near.u == domain[0]);
        }
        bat_curve_free(open), bat_curve_free(closed);
    }
    /* cusp of (t^2, t^3) at t = 0 */
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 1}, cusp[] = {1, -1, -1. / 3, 1, -1. / 3, -1, 1, 1};
    bat_curve *curve = make(3, 2, false, 4, knots, cusp);
    const double point[] = {-0.25, 0}, tip[] = {0, 0};
    bat_near near;
    assert_int_equal(bat_curve_nearest(curve, point, &near), BAT_OK);
    assert_true(fabs(near.distance - 0.25) < 1e-14);
    assert_int_equal(bat_curve_nearest(curve, tip, &near), BAT_OK);
    assert_true(near.distance < 1e-9 && fabs(near.u - 0.5) < 1e-4);
    bat_curve_free(curve);
    const double great[] = {0, 0, 1e300, 1e300, -1e300, 1e300, 1e300, -1e300};
    if (bat_curve_create(2, 3, false, 4, great, 8, knots, &curve) == BAT_OK) {
        assert_int_equal(bat_curve_nearest(curve, point, &near), BAT_OK);
        bat_curve_free(curve);
    }
}

static void bad_input(void **state) {
    (void)state;
    const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 1, 1};
    bat_curve *curve = make(1, 2, false, 2, knots, points);
    const double bad[] = {NAN, 0}, far[] = {INFINITY, 0}, good[] = {0, 1};
    bat_near near;
    size_t count;
    assert_int_equal(bat_curve_nearest(curve, bad, &near), BAT_NUMBER);
    assert_int_equal(bat_curve_nearest(curve, far, &near), BAT_NUMBER);
    assert_int_equal(bat_curve_nearest(NULL, good, &near), BAT_ARGUMENT);
    assert_int_equal(bat_curve_nearest(curve, good, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_nearest_all(curve, good, NAN, 0, NULL, &count), BAT_ARGUMENT);
    assert_int_equal(bat_curve_nearest_all(curve, good, -1, 0, NULL, &count), BAT_ARGUMENT);
    assert_int_equal(bat_curve_nearest_all(curve, good, 1, 2, NULL, &count), BAT_ARGUMENT);
    bat_finder *finder;
    assert_int_equal(bat_finder_create(curve, &finder), BAT_OK);
    bat_finder_nearest(finder, bad, &near);
    assert_true(isnan(near.distance));
    bat_finder_free(finder);
    bat_finder_free(NULL);
    assert_true(isnan(bat_curve_project_near(curve, good, NAN, 3)));
    assert_true(fabs(bat_curve_project_near(curve, good, -1e300, 3) - 0.5) < 1e-15);
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_nearer), cmocka_unit_test(parabola),
        cmocka_unit_test(square_has_four),   cmocka_unit_test(all_minima_are_found),
        cmocka_unit_test(degenerate_curves), cmocka_unit_test(bad_input)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
