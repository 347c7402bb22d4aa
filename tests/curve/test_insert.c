/* Knot insertion keeps the shape, copies what it does not touch, and refuses what would break a curve. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/curve.h>
#include <batten/refine.h>
#include "curve/curve.h"
#include "support/random_curve.h"

static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* Shape, domain and the knots themselves, over all degrees, dimensions and kinds. */
static void shape_is_kept(void **state) {
    (void)state;
    random_source r = {1};
    for (int round = 0; round < 600; round++) {
        int degree = random_int(&r, 1, 7), dimension = random_int(&r, 2, 3), kind = round % 3;
        bat_curve *curve = random_curve(&r, degree, dimension, kind, random_int(&r, 0, 12)), *fine = NULL;
        double domain[2], after[2], u[12];
        bat_curve_domain(curve, domain);
        int count = 0;
        for (int i = 0; i < 8; i++) {
            double x = random_between(&r, domain[0], domain[1]);
            int room = degree - bat_knot_multiplicity(curve, x), n = random_int(&r, 1, room < 2 ? room : 2);
            for (; n > 0 && count < 12; n--) u[count++] = x;
        }
        const double *knots = bat_curve_knots(curve);
        double again = knots[bat_curve_knot_count(curve) / 2];
        if (count < 12 && again > domain[0] && again < domain[1] &&
            bat_knot_multiplicity(curve, again) < degree)
            u[count++] = again;
        qsort(u, (size_t)count, sizeof(double), ascending);
        assert_int_equal(bat_curve_insert_knots(curve, count, u, &fine), BAT_OK);
        assert_int_equal(bat_curve_count(fine), bat_point_count(curve) + count);
        bat_curve_domain(fine, after);
        assert_true(after[0] == domain[0] && after[1] == domain[1]);
        assert_true(curve_gap(curve, fine, 1, 0, 150) < 1e-13 * 40);
        for (int i = 0; i < count; i++) assert_true(bat_knot_multiplicity(fine, u[i]) >= 1);

        bat_curve *refined = NULL;
        assert_int_equal(bat_curve_refine(curve, bat_curve_knot_count(fine), bat_curve_knots(fine), &refined),
                         BAT_OK);
        assert_true(bat_curve_is_equal(fine, refined));
        assert_int_equal(bat_curve_refine(fine, bat_curve_knot_count(curve), knots, &refined), BAT_KNOTS);
        bat_curve_free(refined);
        bat_curve_free(fine);
        bat_curve_free(curve);
    }
}

/* Points whose knots are not disturbed are the same doubles; on a closed curve the seam is a knot like
 * others. */
static void untouched_points_are_copied(void **state) {
    (void)state;
    random_source r = {2};
    bat_curve *curve = random_curve(&r, 3, 2, 0, 30), *fine = NULL;
    const double *t = bat_curve_knots(curve), *before = bat_curve_points(curve);
    double u = 0.5 * (t[20] + t[21]);
    int span = bat_span(curve, u, -1);
    assert_int_equal(bat_curve_insert_knot(curve, u, 1, &fine), BAT_OK);
    const double *after = bat_curve_points(fine);
    assert_memory_equal(before, after, (size_t)(span - 2) * 2 * sizeof(double));
    assert_memory_equal(before + span * 2, after + (span + 1) * 2,
                        (size_t)(bat_point_count(curve) - span) * 2 * sizeof(double));
    bat_curve_free(fine);
    bat_curve_free(curve);
}

/* Free ends become clamped by insertion at the ends; the end points are then on the curve. */
static void ends_can_be_clamped(void **state) {
    (void)state;
    random_source r = {3};
    for (int degree = 1; degree <= 7; degree++) {
        bat_curve *curve = random_curve(&r, degree, 3, 1, 6), *fine = NULL, *both = NULL;
        double domain[2], p[3], q[3];
        bat_curve_domain(curve, domain);
        int m = bat_knot_multiplicity(curve, domain[0]), e = bat_knot_multiplicity(curve, domain[1]);
        assert_int_equal(bat_curve_insert_knot(curve, domain[0], degree + 1 - m, &fine), BAT_OK);
        assert_int_equal(bat_curve_insert_knot(fine, domain[1], degree + 1 - e, &both), BAT_OK);
        assert_int_equal(bat_curve_count(both), bat_point_count(curve));
        assert_true(curve_gap(curve, both, 1, 0, 100) < 1e-12);
        bat_curve_eval(curve, domain[0], 0, p);
        bat_curve_eval(curve, domain[1], 0, q);
        const double *points = bat_curve_points(both), *last = points + (bat_point_count(both) - 1) * 3;
        for (int c = 0; c < 3; c++) {
            assert_true(fabs(points[c] - p[c]) < 1e-12);
            assert_true(fabs(last[c] - q[c]) < 1e-12);
        }
        bat_curve *none = NULL;
        assert_int_equal(bat_curve_insert_knot(both, domain[0], 1, &none), BAT_KNOTS);
        assert_int_equal(bat_curve_insert_knot(both, domain[1] + 1, 1, &none), BAT_PARAMETER);
        assert_int_equal(bat_curve_insert_knot(both, NAN, 1, &none), BAT_NUMBER);
        assert_null(none);
        bat_curve_free(both);
        bat_curve_free(fine);
        bat_curve_free(curve);
    }
}

/* A closed cubic of three points and a triple seam is one Bezier loop; splitting its span keeps it. */
static void three_point_loop(void **state) {
    (void)state;
    const double knots[] = {0, 0, 0, 1}, points[] = {0, 0, 2, 3, -2, 3};
    bat_curve *curve = NULL, *fine = NULL;
    assert_int_equal(bat_curve_create(2, 3, true, 3, points, 4, knots, &curve), BAT_OK);
    /* P_i has its knots t_{i+1}..t_{i+p}: P_0 = f(0,0,1), P_1 = f(0,1,1), P_2 = f(1,1,1) = f(0,0,0). */
    for (int i = 0; i <= 20; i++) {
        double u = i / 20.0, v = 1 - u, p[2];
        bat_curve_eval_left(curve, i == 0 ? 0 : u, 0, p);
        double b[4] = {v * v * v, 3 * u * v * v, 3 * u * u * v, u * u * u};
        for (int c = 0; c < 2; c++) {
            double want = b[0] * points[4 + c] + b[1] * points[c] + b[2] * points[2 + c] +
                          b[3] * points[4 + c];
            assert_true(fabs(want - p[c]) < 1e-15 * 10);
        }
    }
    assert_int_equal(bat_curve_insert_knot(curve, 0.25, 3, &fine), BAT_OK);
    assert_true(curve_gap(curve, fine, 1, 0, 100) < 1e-14);
    bat_curve *none = NULL;
    assert_int_equal(bat_curve_insert_knot(curve, 1, 1, &none), BAT_KNOTS);
    assert_int_equal(bat_curve_insert_knot(curve, 7, 1, &none), BAT_KNOTS);
    bat_curve_free(fine);
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shape_is_kept), cmocka_unit_test(untouched_points_are_copied),
        cmocka_unit_test(ends_can_be_clamped), cmocka_unit_test(three_point_loop)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
