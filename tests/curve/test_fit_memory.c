/* Closest points and fits survive the failure of any allocation: BAT_MEMORY, no output, nothing leaked. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <math.h>
#include <cmocka.h>
#include <batten/fit.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include "support/alloc_fail.h"

static double x[120];

static void fits(void **state) {
    (void)state;
    for (int i = 0; i < 60; i++) x[2 * i] = i, x[2 * i + 1] = 5 * sin(i * 0.2);
    const long live = alloc_live();
    for (int n = 1;; n++) {
        bat_fit_options options = bat_fit_defaults();
        bat_curve *curve = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_fit(2, 60, x, &options, &curve, NULL);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            assert_true(n > 2);
            bat_curve_free(curve);
            break;
        }
        assert_int_equal(status, BAT_MEMORY);
        assert_null(curve);
        assert_true(alloc_live() == live);
    }
    assert_true(alloc_live() == live);
}

static void searches(void **state) {
    (void)state;
    const double knots[] = {0, 0, 1, 2, 2}, points[] = {0, 0, 1, 1, 2, 0}, point[] = {1, 0};
    bat_curve *curve;
    assert_int_equal(bat_curve_create(2, 1, false, 3, points, 5, knots, &curve), BAT_OK);
    const long live = alloc_live();
    for (int what = 0; what < 3; what++)
        for (int n = 1;; n++) {
            bat_near near = {.u = 77};
            size_t count = 77;
            double there = 77, back = 77;
            alloc_fail_at(n);
            const bat_status status = what == 0 ? bat_curve_nearest(curve, point, &near)
                                      : what == 1
                                          ? bat_curve_nearest_all(curve, point, INFINITY, 0, NULL, &count)
                                          : bat_curve_distance(curve, curve, 3, &there, &back);
            const bool reached = alloc_fail_reached();
            assert_true(alloc_live() == live);
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            if (!reached) {
                assert_true(n > 1);
                break;
            }
            assert_true(near.u == 77 && count == 77 && there == 77 && back == 77);
        }
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(fits), cmocka_unit_test(searches)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
