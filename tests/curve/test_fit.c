/* The fit: within tolerance in true distance, economical, corners kept, closed without a seam, exact on what it can
 * represent, robust on bad input. Economy against FITPACK: fit_economy.py. */
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
#include <batten/refine.h>
#include "curve/curve.h"
#include "support/sketch_cases.h"

enum { MOST = 1200 };

static double true_error(const bat_curve *curve, int m, size_t count, const double *x) {
    bat_finder *finder;
    double worst = 0;
    assert_int_equal(bat_finder_create(curve, &finder), BAT_OK);
    for (size_t i = 0; i < count; i++) {
        bat_near near;
        bat_finder_nearest(finder, x + i * (size_t)m, &near);
        worst = fmax(worst, near.distance);
    }
    bat_finder_free(finder);
    return worst;
}

/* A wavy line, an arc and a hook with noise; every degree and dimension; the promise holds in true distance,
 * and the report never says less than the truth. */
static void tolerance_holds(void **state) {
    (void)state;
    random_source r = {4};
    static double x[MOST * 3];
    for (int p = 1; p <= 7; p++)
        for (int m = 2; m <= 3; m++)
            for (int closed = 0; closed <= 1; closed++) {
                const size_t count = 300;
                for (size_t i = 0; i < count; i++) {
                    const double t = (double)i / (double)count, a = 6.283185307179586 * t;
                    const double wave = closed ? 60 + 12 * sin(5 * a) : 60 + 40 * t;
                    x[i * (size_t)m] = wave * cos(a) + random_between(&r, -0.2, 0.2);
                    x[i * (size_t)m + 1] = wave * sin(a) + random_between(&r, -0.2, 0.2);
                    if (m == 3) x[i * 3 + 2] = 10 * sin(2 * a);
                }
                bat_fit_options options = bat_fit_defaults();
                options.tolerance = 0.6, options.degree = p, options.closed = closed;
                bat_curve *curve = NULL;
                bat_fit_report report;
                assert_int_equal(bat_fit(m, count, x, &options, &curve, &report), BAT_OK);
                const double truth = true_error(curve, m, count, x);
                assert_true(truth <= report.max_error + 1e-12 && report.max_error <= 0.6);
                assert_int_equal(bat_curve_degree(curve), p);
                assert_true(bat_curve_is_closed(curve) == closed);
                assert_true(bat_point_count(curve) < (p == 1 ? 110 : 45));
                assert_int_equal(report.knots,
                                 closed ? bat_point_count(curve) : bat_point_count(curve) - p - 1);
                bat_curve_free(curve);
            }
}

/* Points of a straight line need no interior knot; points of a cubic few: chord length is not
 * its parameter. */
static void exact_shapes(void **state) {
    (void)state;
    double x[200];
    bat_fit_options options = bat_fit_defaults();
    bat_fit_report report;
    bat_curve *curve = NULL;
    for (int i = 0; i < 100; i++) x[2 * i] = 3 + 0.7 * i, x[2 * i + 1] = 1e4 - 2.1 * i;
    options.tolerance = 1e-8;
    assert_int_equal(bat_fit(2, 100, x, &options, &curve, &report), BAT_OK);
    assert_int_equal(report.knots, 0);
    assert_true(report.max_error < 1e-9);
    bat_curve_free(curve);
    for (int i = 0; i < 100; i++) x[2 * i] = i / 10., x[2 * i + 1] = 0.01 * pow(i / 10. - 4, 3);
    options.tolerance = 1e-3;
    assert_int_equal(bat_fit(2, 100, x, &options, &curve, &report), BAT_OK);
    assert_true(report.knots <= 6);
    bat_curve_free(curve);
    assert_int_equal(bat_fit(2, 2, x, &options, &curve, &report), BAT_OK); /* two points: a line */
    assert_true(report.max_error < 1e-6 && bat_point_count(curve) == 4);
    bat_curve_free(curve);
    for (size_t count = 3; count < 12; count++)
        for (int p = 1; p <= 7; p++) { /* few points, any degree */
            options.degree = p, options.tolerance = 0.05;
            assert_int_equal(bat_fit(2, count, x, &options, &curve, &report), BAT_OK);
            assert_true(true_error(curve, 2, count, x) <= 0.05);
            bat_curve_free(curve);
        }
}

/* A rounded shape with sharp corners: those told become knots of multiplicity p on which the curve passes
 * near. */
static void corners_are_kept(void **state) {
    (void)state;
    double x[2 * 161];
    for (int i = 0; i <= 160; i++) { /* two arches */
        const double a = 3.14159265358979 * (i % 80 == 0 && i ? 80 : i % 80) / 80;
        x[2 * i] = (i > 80 ? 100 : 0) + 50 - 50 * cos(a), x[2 * i + 1] = 50 * sin(a);
    }
    for (int closed = 0; closed <= 1; closed++)
        for (int p = 2; p <= 5; p++) {
            const int corners[] = {0, 80};
            bat_fit_options options = bat_fit_defaults();
            options.tolerance = 0.1, options.corners = corners, options.corner_count = 2, options.degree = p;
            options.closed = closed;
            bat_curve *curve = NULL;
            bat_fit_report report;
            /* closed: the straight way back is sampled, too */
            double y[2 * 261];
            size_t count = 161;
            for (int i = 0; i < 322; i++) y[i] = x[i];
            const int three[] = {0, 80, 160};
            if (closed) {
                for (int i = 1; i < 100; i++) y[2 * count] = 200 - 2 * i, y[2 * count + 1] = 0, count++;
                options.corners = three, options.corner_count = 3;
            }
            assert_int_equal(bat_fit(2, count, y, &options, &curve, &report), BAT_OK);
            assert_true(true_error(curve, 2, count, y) <= 0.1);
            const double *t = bat_curve_knots(curve);
            int runs = 0, tips = 0;
            for (int i = closed ? 0 : p + 1; i + p <= bat_curve_knot_count(curve) - (closed ? 0 : p + 1);
                 i++) {
                if (t[i] != t[i + p - 1]) continue;
                runs++;
                double left[4], right[4]; /* the tip at (100, 0): the tangent turns there */
                bat_curve_eval_left(curve, t[i], 1, left), bat_curve_eval(curve, t[i], 1, right);
                if (hypot(right[0] - 100, right[1]) > 0.1) continue;
                assert_true(left[3] < 0 && right[3] > 0);
                tips++;
            }
            assert_int_equal(runs, closed ? 3 : 1);
            assert_int_equal(tips, 1);
            bat_curve_free(curve);
        }
}

/* Translated or scaled points give the translated or scaled curve; a closed fit does not care where it
 * starts. */
static void invariance(void **state) {
    (void)state;
    double x[400], y[400];
    for (int i = 0; i < 200; i++) x[2 * i] = i, x[2 * i + 1] = 20 * sin(i * 0.07);
    for (int i = 0; i < 400; i++) y[i] = 4 * x[i] + 4096;
    bat_fit_options options = bat_fit_defaults();
    bat_fit_report a, b;
    bat_curve *one = NULL, *two = NULL;
    options.tolerance = 0.25;
    assert_int_equal(bat_fit(2, 200, x, &options, &one, &a), BAT_OK);
    options.tolerance = 1;
    assert_int_equal(bat_fit(2, 200, y, &options, &two, &b), BAT_OK);
    assert_int_equal(a.knots, b.knots);
    for (int i = 0; i < 2 * bat_point_count(one); i++)
        assert_true(fabs(4 * bat_curve_points(one)[i] + 4096 - bat_curve_points(two)[i]) < 1e-6);
    bat_curve_free(one), bat_curve_free(two);
}

/* Waves shorter than the smoothing length go, longer ones stay: within the tolerance. */
static void smoothing_takes_short_waves(void **state) {
    (void)state;
    double x[1200], bend[2] = {0, 0};
    for (int i = 0; i < 600; i++)
        x[2 * i] = i, x[2 * i + 1] = 40 * sin(i * 0.02) + 0.5 * sin(6.283185307179586 * i / 9.0);
    for (int k = 0; k < 2; k++) {
        bat_fit_options options = bat_fit_defaults();
        options.tolerance = k ? 0.75 : 0.3, options.smoothing = k ? 30 : 0;
        bat_curve *curve = NULL;
        bat_fit_report report;
        assert_int_equal(bat_fit(2, 600, x, &options, &curve, &report), BAT_OK);
        double domain[2];
        bat_curve_domain(curve, domain);
        for (int i = 50; i < 950; i++)
            bend[k] = fmax(bend[k],
                           fabs(bat_curve_curvature(curve, domain[0] + (domain[1] - domain[0]) * i / 1000)));
        bat_curve_free(curve);
    }
    assert_true(bend[1] < 0.04 && bend[0] > 0.08); /* the long wave alone bends 0.016 */
}

static void bad_input(void **state) {
    (void)state;
    double x[40], bad[] = {0, 0, NAN, 1, 2, 2}, same[] = {1, 2, 1, 2, 1, 2}, great[] = {0, 0, 1e300, 0};
    for (int i = 0; i < 40; i++) x[i] = i;
    bat_fit_options options = bat_fit_defaults();
    bat_curve *curve = NULL;
    bat_fit_report report;
    assert_int_equal(bat_fit(2, 3, bad, &options, &curve, &report), BAT_NUMBER);
    assert_int_equal(bat_fit(2, 2, great, &options, &curve, &report), BAT_NUMBER);
    assert_int_equal(bat_fit(2, 3, same, &options, &curve, &report), BAT_COUNT);
    assert_int_equal(bat_fit(2, 1, x, &options, &curve, &report), BAT_COUNT);
    assert_int_equal(bat_fit(2, SIZE_MAX, x, &options, &curve, &report), BAT_COUNT);
    assert_int_equal(bat_fit(4, 4, x, &options, &curve, &report), BAT_DIMENSION);
    assert_int_equal(bat_fit(2, 4, NULL, &options, &curve, &report), BAT_ARGUMENT);
    const int corners[] = {2, 1};
    options.corners = corners, options.corner_count = 2;
    assert_int_equal(bat_fit(2, 20, x, &options, &curve, &report), BAT_ARGUMENT);
    options = bat_fit_defaults(), options.tolerance = 0;
    assert_int_equal(bat_fit(2, 20, x, &options, &curve, &report), BAT_ARGUMENT);
    options.tolerance = NAN;
    assert_int_equal(bat_fit(2, 20, x, &options, &curve, &report), BAT_ARGUMENT);
    options = bat_fit_defaults(), options.degree = 8;
    assert_int_equal(bat_fit(2, 20, x, &options, &curve, &report), BAT_DEGREE);
    assert_null(curve);
    /* a tolerance below rounding: the best is handed over, with the truth about it */
    double zigzag[200];
    random_source r = {2};
    for (int i = 0; i < 200; i++) zigzag[i] = random_between(&r, -1, 1);
    options = bat_fit_defaults(), options.tolerance = 1e-300, options.solves_max = 30;
    assert_int_equal(bat_fit(2, 100, zigzag, &options, &curve, &report), BAT_TOLERANCE);
    assert_true(report.max_error > 0 && report.solves <= 30 + 5);
    assert_true(true_error(curve, 2, 100, zigzag) <= report.max_error + 1e-12);
    bat_curve_free(curve);
}

/* A wiggly curve of that many spans, even or not. */
typedef struct wiggle {
    int degree, dimension, spans;
    bool closed, even;
} wiggle;

static bat_curve *wiggly(random_source *r, const wiggle *w) {
    enum { MOST_SPANS = 120, MOST_POINTS = MOST_SPANS + BAT_DEGREE_MAX };
    const int p = w->degree, m = w->dimension, n = w->closed ? w->spans : w->spans + p;
    const int knot_count = w->closed ? n + 1 : n + p + 1;
    double points[3 * MOST_POINTS], knots[MOST_POINTS + BAT_DEGREE_MAX + 1], way = 0, at[3] = {0};
    for (int i = 0; i < n; i++) {
        const double a = 2 * 3.14159265358979 * i / n, radius = 2.2 * n + random_between(r, -8, 8);
        way += random_between(r, -1.2, 1.2);
        at[0] += 14 * cos(way), at[1] += 14 * sin(way), at[2] += random_between(r, -3, 3);
        for (int c = 0; c < m; c++)
            points[i * m + c] = w->closed && c < 2 ? radius * (c ? sin(a) : cos(a)) : at[c];
    }
    for (int i = 0; i < knot_count; i++) {
        const bool end = !w->closed && (i <= p || i > w->spans + p);
        knots[i] = i == 0 ? 0 : knots[i - 1] + (end ? 0 : w->even ? 1 : random_between(r, 0.5, 1.5));
    }
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(m, p, w->closed, (size_t)n, points, knot_count, knots, &curve), BAT_OK);
    return curve;
}

/* Samples at even parameters from anywhere on a closed curve, with noise. */
static void sample(random_source *r, const bat_curve *curve, size_t count, double noise, double *x) {
    const size_t m = (size_t)bat_curve_dimension(curve);
    const bool closed = bat_curve_is_closed(curve);
    double domain[2];
    bat_curve_domain(curve, domain);
    const double length = domain[1] - domain[0], start = closed ? random_unit(r) * length : 0;
    for (size_t i = 0; i < count; i++) {
        double u = start + length * (double)i / (double)(closed ? count : count - 1);
        if (closed && u >= length) u -= length;
        bat_curve_eval(curve, domain[0] + u, 0, x + m * i);
        for (size_t c = 0; c < m && noise > 0; c++) x[m * i + c] += noise * random_normal(r);
    }
}

static int spans_of_fit(const double *x, size_t count, const wiggle *w, double tolerance) {
    bat_fit_options options = bat_fit_defaults();
    options.tolerance = tolerance, options.degree = w->degree, options.closed = w->closed;
    bat_curve *fit = NULL;
    bat_fit_report report;
    assert_int_equal(bat_fit(w->dimension, count, x, &options, &fit, &report), BAT_OK);
    assert_true(report.max_error <= tolerance);
    assert_true(true_error(fit, w->dimension, count, x) <= tolerance * (1 + 1e-9));
    bat_curve_free(fit);
    return report.knots + !w->closed;
}

/* Samples of a curve without noise never take more spans than the curve has: of any degree, in the plane and in space,
 * open and closed, with knots even and not, few and many. */
static void clean_data_take_no_more_spans(void **state) {
    (void)state;
    enum { COUNT = 2000 };
    static double x[3 * COUNT];
    static const int spans[] = {1, 2, 5, 20, 97};
    static const double tolerances[] = {0.02, 0.1, 0.45};
    random_source r = {97};
    for (int n = 0; n < 96; n++) {
        wiggle w = {2 + n % 4, 2 + n / 4 % 2, 0, n / 8 % 2, n / 16 % 2};
        w.spans = n < 16 ? 97 : spans[random_int(&r, 0, 4)];
        if (w.closed && w.spans < 5) w.spans = 5 + w.degree;
        bat_curve *curve = wiggly(&r, &w);
        sample(&r, curve, COUNT, 0, x);
        for (int k = 0; k < 3; k++) {
            const int taken = spans_of_fit(x, COUNT, &w, tolerances[k]);
            if (taken > w.spans)
                fail_msg("degree %d, %d D, %s: %d spans for %d within %g", w.degree, w.dimension,
                         w.closed ? "closed" : "open", taken, w.spans, tolerances[k]);
        }
        bat_curve_free(curve);
    }
}

/* With noise of a ninth of the tolerance: hardly more than without, and no more than the curve has. */
static void noisy_data_are_as_economical(void **state) {
    (void)state;
    enum { COUNT = 2000 };
    static double x[2 * COUNT];
    random_source r = {11};
    int clean = 0, noisy = 0, source = 0;
    for (int n = 0; n < 24; n++) {
        const wiggle w = {3, 2, n % 3 == 0 ? 97 : n % 3 == 1 ? 60 : 20, n / 3 % 2, n / 6 % 2};
        bat_curve *curve = wiggly(&r, &w);
        sample(&r, curve, COUNT, 0, x);
        clean += spans_of_fit(x, COUNT, &w, 0.45);
        sample(&r, curve, COUNT, 0.05, x);
        noisy += spans_of_fit(x, COUNT, &w, 0.45);
        source += w.spans;
        bat_curve_free(curve);
    }
    print_message("%d spans: %d without noise, %d with it\n", source, clean, noisy);
    assert_true(clean <= noisy && noisy <= source && noisy <= 1.25 * clean);
}

static void ends_are_held(void **state) {
    (void)state;
    enum { COUNT = 200 };
    random_source r = {12};
    double x[2 * COUNT];
    for (int i = 0; i < COUNT; i++)
        x[2 * i] = 1e4 + i + random_between(&r, -0.3, 0.3),
              x[2 * i + 1] = 20 * sin(i * 0.05) + random_between(&r, -0.3, 0.3);
    bat_fit_options options = bat_fit_defaults();
    options.hold_ends = true;
    for (options.degree = 1; options.degree <= 5; options.degree += 2) {
        bat_curve *fit = NULL;
        bat_fit_report report;
        assert_int_equal(bat_fit(2, COUNT, x, &options, &fit, &report), BAT_OK);
        double domain[2], at[2];
        bat_curve_domain(fit, domain);
        for (int end = 0; end < 2; end++) {
            bat_curve_eval(fit, domain[end], 0, at);
            for (int c = 0; c < 2; c++) assert_true(fabs(at[c] - x[2 * (end ? COUNT - 1 : 0) + c]) <= 4e-12);
        }
        assert_true(true_error(fit, 2, COUNT, x) <= 1);
        bat_curve_free(fit);
    }
}

/* A curve with knots it does not need, corners and all, again with few. */
static void refit_keeps_the_shape_with_fewer_points(void **state) {
    (void)state;
    random_source r = {31};
    size_t before = 0, removed = 0, refitted = 0;
    for (int n = 0; n < 12; n++) {
        bat_curve *curve = n % 3 == 2 ? ring_curve(&r, 60, 4) : wavy_curve(&r, 60, 3), *less = NULL,
                  *again = NULL;
        const double tolerance = n % 2 ? 0.3 : 1;
        double error = -1, there, back;
        assert_int_equal(bat_curve_simplify(curve, tolerance, 0.05, &less, NULL), BAT_OK);
        assert_int_equal(bat_curve_refit(curve, tolerance, 0.05, &again, &error), BAT_OK);
        assert_int_equal(bat_curve_distance(curve, again, 40, &there, &back), BAT_OK);
        assert_true(error >= 0 && error <= tolerance && fmax(there, back) <= 1.02 * tolerance);
        assert_true(bat_curve_count(again) <= bat_curve_count(less));
        assert_true(bat_curve_is_closed(again) == bat_curve_is_closed(curve));
        before += bat_curve_count(curve), removed += bat_curve_count(less),
            refitted += bat_curve_count(again);
        if (!bat_curve_is_closed(curve)) {
            double a[2], b[2], p[2], q[2];
            bat_curve_domain(curve, a);
            bat_curve_domain(again, b);
            for (int end = 0; end < 2; end++) {
                bat_curve_eval(curve, a[end], 0, p);
                bat_curve_eval(again, b[end], 0, q);
                assert_true(hypot(p[0] - q[0], p[1] - q[1]) < 1e-9);
            }
        }
        bat_curve_free(curve), bat_curve_free(less), bat_curve_free(again);
    }
    print_message("%zu points: %zu after removal, %zu after refitting\n", before, removed, refitted);
    assert_true(refitted < removed);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(clean_data_take_no_more_spans),
                                       cmocka_unit_test(noisy_data_are_as_economical),
                                       cmocka_unit_test(ends_are_held),
                                       cmocka_unit_test(refit_keeps_the_shape_with_fewer_points),
                                       cmocka_unit_test(tolerance_holds),
                                       cmocka_unit_test(exact_shapes),
                                       cmocka_unit_test(corners_are_kept),
                                       cmocka_unit_test(invariance),
                                       cmocka_unit_test(smoothing_takes_short_waves),
                                       cmocka_unit_test(bad_input)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
