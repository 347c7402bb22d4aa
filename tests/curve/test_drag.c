/* Direct manipulation: points move by exactly the amount dragged, with the least change, and locally. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <batten/batten.h>
#include <math.h>
#include <string.h>

static bat_curve *make(int degree, bool closed, int count) {
    double points[64], knots[48];
    for (int i = 0; i < count; i++) {
        points[2 * i] = 100 * cos(6.283185307179586 * i / count) + 7 * sin(3.0 * i);
        points[2 * i + 1] = 80 * sin(6.283185307179586 * i / count) + 5 * cos(5.0 * i);
    }
    if (closed)
        for (int i = 0; i <= count; i++) knots[i] = i + 0.3 * sin(i % count);
    else
        for (int i = 0; i < count + degree + 1; i++)
            knots[i] = i <= degree ? 0 : i >= count ? count - degree : i - degree + 0.25 * sin(i);
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, degree, closed, (size_t)count, points,
                                      closed ? count + 1 : count + degree + 1, knots, &curve),
                     BAT_OK);
    return curve;
}

static void one_point_goes_where_it_is_dragged(void **state) {
    (void)state;
    for (int closed = 0; closed < 2; closed++)
        for (int degree = 1; degree <= 7; degree++) {
            bat_curve *curve = make(degree, closed, 12), *moved = NULL;
            double domain[2], delta[2] = {13.25, -40.5};
            bat_curve_domain(curve, domain);
            for (int k = 0; k <= 20; k++) {
                double u = domain[0] + (domain[1] - domain[0]) * k / 20, before[2], after[2];
                assert_int_equal(bat_curve_drag(curve, 1, &u, delta, &moved), BAT_OK);
                bat_curve_eval(curve, u, 0, before);
                bat_curve_eval(moved, u, 0, after);
                assert_true(hypot(after[0] - before[0] - delta[0], after[1] - before[1] - delta[1]) < 1e-12);
                /* math 3.5: the move of each control point */
                double basis[8], square = 0;
                int first, changed = 0;
                bat_curve_basis(curve, u, &first, basis);
                for (int i = 0; i <= degree; i++) square += basis[i] * basis[i];
                for (int i = 0; i < 12; i++) {
                    double weight = 0;
                    for (int j = 0; j <= degree; j++)
                        if ((first + j) % 12 == i) weight += basis[j];
                    const double *p = bat_curve_points(curve) + 2 * i, *q = bat_curve_points(moved) + 2 * i;
                    assert_true(fabs(q[0] - p[0] - weight * delta[0] / square) < 1e-12);
                    changed += p[0] != q[0];
                }
                assert_true(changed <= degree + 1);
                bat_curve_free(moved);
            }
            bat_curve_free(curve);
        }
}

/* The least of all: any other move that does the same is longer (it differs by a vector of the null space, to
 * which the least one is normal). */
static void several_points_least_change(void **state) {
    (void)state;
    for (int closed = 0; closed < 2; closed++) {
        bat_curve *curve = make(3, closed, 14), *moved = NULL;
        double u[3] = {2.1, 2.9, 6.5}, delta[6] = {10, 0, 0, 0, -5, 8};
        assert_int_equal(bat_curve_drag(curve, 3, u, delta, &moved), BAT_OK);
        for (int k = 0; k < 3; k++) {
            double before[2], after[2];
            bat_curve_eval(curve, u[k], 0, before);
            bat_curve_eval(moved, u[k], 0, after);
            assert_true(fabs(after[0] - before[0] - delta[2 * k]) < 1e-11);
            assert_true(fabs(after[1] - before[1] - delta[2 * k + 1]) < 1e-11);
        }
        /* a null vector of N: start from anything, drag its values at u back to zero */
        double points[28], zero[28] = {0};
        for (int i = 0; i < 28; i++) points[i] = sin(1.7 * i);
        bat_curve *any = NULL, *null = NULL;
        bat_curve_create(2, 3, closed, 14, points, bat_curve_knot_count(curve), bat_curve_knots(curve), &any);
        for (int k = 0; k < 3; k++) {
            bat_curve_eval(any, u[k], 0, zero + 2 * k);
            zero[2 * k] *= -1, zero[2 * k + 1] *= -1;
        }
        assert_int_equal(bat_curve_drag(any, 3, u, zero, &null), BAT_OK);
        double dot = 0;
        for (int i = 0; i < 28; i++)
            dot += (bat_curve_points(moved)[i] - bat_curve_points(curve)[i]) * bat_curve_points(null)[i];
        assert_true(fabs(dot) < 1e-10);
        bat_curve_free(null);
        bat_curve_free(any);
        bat_curve_free(moved);
        bat_curve_free(curve);
    }
}

static void refusals(void **state) {
    (void)state;
    bat_curve *curve = make(3, false, 9), *out = NULL;
    double u[2] = {1, 1}, delta[4] = {1, 1, 2, 2}, outside = 99, bad = NAN;
    assert_int_equal(bat_curve_drag(curve, 2, u, delta, &out), BAT_SINGULAR);
    assert_int_equal(bat_curve_drag(curve, 1, &outside, delta, &out), BAT_PARAMETER);
    assert_int_equal(bat_curve_drag(curve, 1, &bad, delta, &out), BAT_NUMBER);
    assert_int_equal(bat_curve_drag(curve, 1, u, (double[]){NAN, 0}, &out), BAT_NUMBER);
    assert_int_equal(bat_curve_drag(curve, 99, u, delta, &out), BAT_COUNT);
    assert_int_equal(bat_curve_drag(curve, 0, u, delta, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_drag(NULL, 1, u, delta, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_move_point(curve, 9, delta, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_move_point(curve, 0, (double[]){1e300, 0}, &out), BAT_NUMBER);
    assert_null(out);
    assert_int_equal(bat_curve_move_point(curve, 4, delta, &out), BAT_OK);
    for (int i = 0; i < 18; i++)
        assert_true(bat_curve_points(out)[i] == bat_curve_points(curve)[i] + (i / 2 == 4 ? 1 : 0));
    bat_curve_free(out);
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_point_goes_where_it_is_dragged),
        cmocka_unit_test(several_points_least_change),
        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
