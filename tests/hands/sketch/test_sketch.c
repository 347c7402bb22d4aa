/* Drawing over a curve: what is kept stays, the stroke is followed, the joints are C2. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "support/sketch_cases.h"

enum { CASES = 120 };

/* Random strokes along open and closed curves, half of them against the curve's direction. */
static void redraws(bool closed, uint64_t seed, int pins) {
    random_source r = {seed};
    for (int n = 0; n < CASES; n++) {
        bat_curve *curve = closed ? ring_curve(&r, random_int(&r, 6, 20), 40)
                                  : wavy_curve(&r, random_int(&r, 6, 20), 50);
        double domain[2];
        bat_curve_domain(curve, domain);
        const double T = domain[1] - domain[0];
        double u0 = domain[0] + T * random_unit(&r),
               length = T * random_between(&r, 0.12, closed ? 0.6 : 0.4);
        if (!closed) u0 = domain[0] + (T - length) * random_unit(&r);
        double u1 = u0 + length;
        const bool reversed = random_unit(&r) < 0.5;
        const double noise = random_between(&r, 0, 1);
        drawn d = draw_along(&r, curve, reversed ? u1 : u0, reversed ? u0 : u1,
                             (size_t)random_int(&r, 40, 300), 40, noise);
        bat_sketch_options options = bat_sketch_defaults();
        options.pins = pins;
        bat_curve *now = NULL;
        bat_sketch_report report;
        assert_int_equal(bat_sketch(curve, &d.stroke, &options, &now, &report), BAT_OK);
        assert_int_equal(report.reversed, reversed);
        assert_true(report.max_error <= 1);
        if (pins == 3) assert_true(kept_moves(curve, now, &report) <= 1e-12);
        assert_true(worst_jump(now) <= 1e-9);
        bat_curve_free(now);
        bat_curve_free(curve);
        drawn_free(&d);
    }
}

static void open_curves(void **state) {
    (void)state;
    redraws(false, 1, 3);
}
static void closed_curves(void **state) {
    (void)state;
    redraws(true, 2, 3);
}
static void two_pins(void **state) {
    (void)state;
    redraws(false, 3, 2);
    redraws(true, 4, 2);
}

/* Most of a drop, from its tip or up to it, so coarsely that the new piece has hardly a knot of its own: its pins hang on
 * knots before it, too. */
static void most_of_a_drop(void **state) {
    (void)state;
    random_source r = {5};
    const double knots[9] = {0, 2, 4, 4, 4, 5, 6, 8, 10};
    for (int n = 0; n < 60; n++) {
        double points[16];
        for (int i = 0; i < 8; i++) {
            const double a = 0.785 * i, radius = i == 4 ? 380 : 200 + 20 * random_between(&r, -1, 1);
            points[2 * i] = 400 + radius * cos(a), points[2 * i + 1] = 300 + radius * sin(a);
        }
        bat_curve *curve = NULL, *now = NULL;
        assert_int_equal(bat_curve_create(2, 3, true, 8, points, 9, knots, &curve), BAT_OK);
        const double length = random_between(&r, 5, 8.9);
        const bool up = random_unit(&r) < 0.5, back = random_unit(&r) < 0.5;
        const double from = up ? 14 - length : 4, to = up ? 14 : 4 + length;
        drawn d = draw_along(&r, curve, back ? to : from, back ? from : to, 12, 12, 0);
        bat_sketch_options options = bat_sketch_defaults();
        options.tolerance = 150, options.keep_corners = true;
        bat_sketch_report report;
        const bat_status status = bat_sketch(curve, &d.stroke, &options, &now, &report);
        assert_true(status == BAT_OK || status == BAT_TOLERANCE);
        assert_true(report.replaced || kept_moves(curve, now, &report) <= 1e-12);
        bat_curve_free(now), bat_curve_free(curve);
        drawn_free(&d);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(open_curves), cmocka_unit_test(closed_curves),
                                       cmocka_unit_test(two_pins), cmocka_unit_test(most_of_a_drop)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
