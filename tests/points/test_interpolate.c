/* Curves through points: every point is met, the curve is C2 everywhere, its ends are natural or as they were asked for (which
 * together says that there is no other); fits keep their tolerance whatever the points are, and stay near them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <cmocka.h>
#include <batten/interpolate.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { MOST = 60 };

static double far_from(const double *a, const double *b, int m) {
    double d = 0;
    for (int c = 0; c < m; c++) d = hypot(d, a[c] - b[c]);
    return d;
}

static void random_points(random_source *r, int m, size_t n, double *x) {
    for (size_t i = 0; i < n * (size_t)m; i++) x[i] = random_between(r, -10, 10);
}

/* Value, first and second derivative agree from both sides of a knot. */
static void check_smooth(const bat_curve *curve, double left, double right, double size) {
    double a[9], b[9];
    const int m = bat_curve_dimension(curve);
    bat_curve_eval_left(curve, left, 2, a), bat_curve_eval(curve, right, 2, b);
    for (int k = 0; k < 3; k++) {
        double most = size;
        for (int c = 0; c < m; c++) most = fmax(most, fabs(a[k * m + c]));
        assert_true(far_from(a + k * m, b + k * m, m) <= 1e-9 * most);
    }
}

static void points_are_met_smoothly(void **state) {
    (void)state;
    random_source r = {3};
    for (int round = 0; round < 400; round++) {
        const int m = random_int(&r, 2, 3);
        const bool closed = round % 2;
        const size_t n = (size_t)random_int(&r, closed ? 3 : 2, MOST);
        double x[MOST * 3], ends[6], end[9];
        random_points(&r, m, n, x), random_points(&r, m, 2, ends);
        const bool held = round % 4 == 2;
        bat_curve *curve;
        assert_int_equal(bat_interpolate(m, closed, n, x, held ? ends : NULL, &curve), BAT_OK);
        assert_int_equal(bat_curve_count(curve), closed ? n : n + 2);
        assert_true(bat_curve_is_closed(curve) == closed);
        const double *t = bat_curve_knots(curve) + (closed ? 0 : 3);
        for (size_t i = 0; i < n; i++) {
            double at[3];
            bat_curve_eval(curve, t[i], 0, at);
            assert_true(far_from(at, x + i * (size_t)m, m) <= 1e-11 * 20);
            if (i && i + 1 < n) check_smooth(curve, t[i], t[i], 20);
        }
        if (closed) check_smooth(curve, t[n], t[0], 20);
        for (int e = 0; e < 2 && !closed; e++) {
            bat_curve_eval(curve, t[e ? n - 1 : 0], 2, end);
            double most = 1, speed = 0, along = 0, asked = 0;
            for (int c = 0; c < m; c++) {
                most = fmax(most, fabs(end[2 * m + c])), speed = hypot(speed, end[m + c]);
                asked = hypot(asked, ends[e * m + c]), along += end[m + c] * ends[e * m + c];
            }
            if (held)
                assert_true(along >= (1 - 1e-9) * speed * asked);
            else if (n > 2)
                for (int c = 0; c < m; c++) assert_true(fabs(end[2 * m + c]) <= 1e-7);
        }
        bat_curve_free(curve);
    }
}

static void few_points_and_many(void **state) {
    (void)state;
    const double two[] = {0, 0, 3, 4}, twice[] = {0, 0, 0, 0, 3, 4, 3, 4, 3, 4}, one[] = {1, 1, 1, 1};
    bat_curve *a, *b;
    assert_int_equal(bat_interpolate(2, false, 2, two, NULL, &a), BAT_OK);
    assert_int_equal(bat_interpolate(2, false, 5, twice, NULL, &b), BAT_OK);
    assert_true(bat_curve_is_equal(a, b));
    double at[2];
    bat_curve_eval(a, 0.25 * bat_curve_knots(a)[7], 0, at);
    assert_true(fabs(at[0] * 4 - at[1] * 3) <= 1e-15);
    bat_curve_free(a), bat_curve_free(b);
    assert_int_equal(bat_interpolate(2, false, 2, one, NULL, &a), BAT_COUNT);
    assert_int_equal(bat_interpolate(2, true, 2, two, NULL, &a), BAT_COUNT);
    assert_int_equal(bat_interpolate(2, false, 1, two, NULL, &a), BAT_COUNT);
    assert_int_equal(bat_interpolate(4, false, 1, two, NULL, &a), BAT_DIMENSION);
    assert_int_equal(bat_interpolate(2, false, 2, NULL, NULL, &a), BAT_ARGUMENT);
    assert_int_equal(bat_interpolate(2, false, 2, two, (const double[]){0, 0, 1, 0}, &a), BAT_NUMBER);
    assert_int_equal(bat_interpolate(2, false, 2, (const double[]){0, 0, (double)NAN, 1}, NULL, &a),
                     BAT_NUMBER);
    enum { HUGE_COUNT = 200000 };
    double *x = malloc(2 * HUGE_COUNT * sizeof *x);
    for (int i = 0; i < HUGE_COUNT; i++) x[2 * i] = i, x[2 * i + 1] = i % 7;
    assert_int_equal(bat_interpolate(2, true, HUGE_COUNT, x, NULL, &a), BAT_OK);
    bat_curve_free(a), free(x);
}

/* A circle's points: the error falls by the fourth power of their distance. */
static void circles_are_met_to_the_fourth_order(void **state) {
    (void)state;
    double before = 0;
    for (size_t n = 8; n <= 128; n *= 2) {
        double x[256], worst = 0;
        for (size_t i = 0; i < n; i++)
            x[2 * i] = cos(2 * acos(-1) * (double)i / (double)n),
                  x[2 * i + 1] = sin(2 * acos(-1) * (double)i / (double)n);
        bat_curve *curve;
        assert_int_equal(bat_interpolate(2, true, n, x, NULL, &curve), BAT_OK);
        for (int k = 0; k < 2000; k++) {
            double domain[2], at[2];
            bat_curve_domain(curve, domain);
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * k / 2000, 0, at);
            worst = fmax(worst, fabs(hypot(at[0], at[1]) - 1));
        }
        if (before > 0) assert_true(before / worst > 14 && before / worst < 20);
        before = worst;
        bat_curve_free(curve);
    }
}

static void fits_keep_their_tolerance_and_stay_near(void **state) {
    (void)state;
    random_source r = {17};
    for (int round = 0; round < 60; round++) {
        const int m = random_int(&r, 2, 3);
        const size_t n = (size_t)random_int(&r, 3, MOST);
        double x[MOST * 3], row = 0;
        random_points(&r, m, n, x);
        for (size_t i = 0; round % 3 == 0 && i < n; i++) /* a zigzag */
            x[i * (size_t)m] = (double)i, x[i * (size_t)m + 1] = i % 2 ? 8 : 0;
        bat_fit_options options = bat_fit_defaults();
        options.tolerance = pow(10, -random_between(&r, 0, 4));
        options.hold_ends = round % 2;
        options.closed = round % 5 == 4;
        for (size_t i = 1; i < n + options.closed; i++)
            row += far_from(x + (i - 1) * (size_t)m, x + i % n * (size_t)m, m);
        bat_curve *curve;
        bat_fit_report report;
        assert_int_equal(bat_fit_within(m, n, x, &options, &curve, &report), BAT_OK);
        assert_true(report.max_error <= options.tolerance);
        double domain[2];
        bat_curve_domain(curve, domain);
        assert_true(bat_curve_length(curve, domain[0], domain[1], 1e-6) <= 4.01 * row);
        for (size_t i = 0; i < n; i++) {
            bat_near near;
            assert_int_equal(bat_curve_nearest(curve, x + i * (size_t)m, &near), BAT_OK);
            assert_true(near.distance <= options.tolerance);
        }
        bat_curve_free(curve);
    }
}

static double far_from_row(int m, size_t n, const double *x, bool closed, const double *at, double *chord) {
    double least = INFINITY;
    for (size_t i = 0; i + !closed < n; i++) {
        const double *a = x + i * (size_t)m, *b = x + (i + 1) % n * (size_t)m, length = far_from(a, b, m);
        double along = 0, foot[3];
        for (int c = 0; c < m; c++) along += (at[c] - a[c]) * (b[c] - a[c]);
        along = length > 0 ? fmin(fmax(along / length / length, 0), 1) : 0;
        for (int c = 0; c < m; c++) foot[c] = a[c] + along * (b[c] - a[c]);
        least = fmin(least, far_from(at, foot, m));
        *chord = fmax(*chord, length);
    }
    return least;
}

/* With corners, at any size and for few points between them: within the tolerance of the points, and nowhere far from the row. */
static void fits_with_corners_stay_near(void **state) {
    (void)state;
    random_source r = {31};
    static const double sizes[] = {1, 1e-6, 1e6, 1e-30};
    for (int round = 0; round < 120; round++) {
        const int m = random_int(&r, 2, 3), size = round % 4;
        const size_t n = (size_t)random_int(&r, 4, MOST);
        double x[MOST * 3], way[3] = {1, 0, 0};
        int corners[MOST];
        bat_fit_options options = bat_fit_defaults();
        options.corners = corners, options.closed = round % 7 == 6;
        for (size_t i = 0; i < n; i++) {
            const bool turns = i > 0 && i + 1 < n && random_unit(&r) < 0.2;
            if (turns) corners[options.corner_count++] = (int)i;
            for (int c = 0; c < m; c++) {
                x[i * (size_t)m + (size_t)c] = i ? x[(i - 1) * (size_t)m + (size_t)c] + sizes[size] * way[c]
                                                 : 0;
                way[c] = turns ? random_between(&r, -1, 1) : way[c] + random_between(&r, -0.1, 0.1);
            }
        }
        options.tolerance = sizes[size] * pow(10, -random_between(&r, -0.3, 3));
        bat_curve *curve;
        bat_fit_report report;
        assert_int_equal(bat_fit_within(m, n, x, &options, &curve, &report), BAT_OK);
        assert_true(report.max_error <= options.tolerance);
        double domain[2], at[3], chord = 0;
        bat_curve_domain(curve, domain);
        for (int k = 0; k <= 400; k++) {
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * k / 400, 0, at);
            const double far = far_from_row(m, n, x, options.closed, at, &chord);
            assert_true(far <= 3 * options.tolerance + 1.5 * chord);
        }
        for (size_t i = 0; i < n; i++) {
            bat_near near;
            assert_int_equal(bat_curve_nearest(curve, x + i * (size_t)m, &near), BAT_OK);
            assert_true(near.distance <= options.tolerance * (1 + 1e-9));
        }
        bat_curve_free(curve);
    }
}

/* Fits are the same in all units, up to those that a coordinate may have; open ends are the points' to the bit. */
static void fits_are_as_good_in_any_unit(void **state) {
    (void)state;
    random_source r = {29};
    for (int round = 0; round < 12; round++) {
        const int m = 2 + round % 2, power = (int[]){240, -300, 150, -150, 0, 3}[round / 2];
        double x[40 * 3];
        for (size_t i = 0; i < 40; i++) {
            const double t = (double)i / 8;
            for (int c = 0; c < m; c++)
                x[i * (size_t)m + (size_t)c] = ldexp((c == 0   ? t
                                                      : c == 1 ? sin(t)
                                                               : t * t) +
                                                         random_between(&r, 0, 1e-3),
                                                     power);
        }
        bat_fit_options options = bat_fit_defaults();
        options.tolerance = ldexp(1e-2, power), options.hold_ends = true;
        bat_curve *curve;
        bat_fit_report report;
        assert_int_equal(bat_fit_within(m, 40, x, &options, &curve, &report), BAT_OK);
        assert_true(report.max_error > 0 && report.max_error <= options.tolerance);
        assert_true(bat_curve_count(curve) < 20);
        const double *first = bat_curve_points(curve),
                     *last = first + (bat_curve_count(curve) - 1) * (size_t)m;
        assert_memory_equal(first, x, (size_t)m * sizeof *x);
        assert_memory_equal(last, x + 39 * m, (size_t)m * sizeof *x);
        bat_curve_free(curve);
    }
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    double x[24], vast[24];
    for (int i = 0; i < 12; i++) x[2 * i] = i, x[2 * i + 1] = i % 2 ? 8 : 0;
    for (int i = 0; i < 24; i++) vast[i] = ldexp(x[i], 200);
    bat_fit_options options = bat_fit_defaults();
    options.tolerance = 1e-3;
    static const int corners[] = {3, 7};
    options.corners = corners;
    for (int kind = 0; kind < 6; kind++) { /* the last two with corners, open and closed */
        options.corner_count = kind > 3 ? 2 : 0, options.closed = kind == 5;
        options.tolerance = kind == 3 ? ldexp(1e-3, 200) : 1e-3;
        for (int n = 1;; n++) {
            const long live = alloc_live();
            bat_curve *curve = NULL;
            alloc_fail_at(n);
            const bat_status status = kind >= 2 ? bat_fit_within(2, 12, kind != 3 ? x : vast, &options,
                                                                 &curve, NULL)
                                                : bat_interpolate(2, kind, 12, x, NULL, &curve);
            const bool reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            if (reached) assert_null(curve);
            bat_curve_free(curve);
            assert_int_equal(alloc_live(), live);
            if (reached) continue;
            assert_true(n > 2);
            break;
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_met_smoothly),
        cmocka_unit_test(few_points_and_many),
        cmocka_unit_test(circles_are_met_to_the_fourth_order),
        cmocka_unit_test(fits_keep_their_tolerance_and_stay_near),
        cmocka_unit_test(fits_with_corners_stay_near),
        cmocka_unit_test(fits_are_as_good_in_any_unit),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
