/* New curves of other degrees than 3, above all of degree 5 (class A): they are C^(degree - 1) and stay so when they are
 * redrawn, joined and closed, and they are fairer than cubics. Measured values are printed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

#include "curve/curve.h"
#include "hands/sketch/meant.h"
#include "support/known_strokes.h"

enum { CLASS_A = 5 };

static bat_sketch_options of_degree(int degree) {
    bat_sketch_options options = bat_sketch_defaults();
    options.degree = degree;
    return options;
}

static double size_of(const double *x, int m) {
    return m == 2 ? hypot(x[0], x[1]) : hypot(hypot(x[0], x[1]), x[2]);
}

/* The greatest jump of a derivative of an order below the degree, at a knot, of that derivative's greatest value. */
static double greatest_jump(const bat_curve *curve) {
    enum { LOOKS = 400 };
    const int p = bat_curve_degree(curve), m = bat_curve_dimension(curve),
              count = bat_curve_knot_count(curve);
    const bool closed = bat_curve_is_closed(curve);
    const double *knots = bat_curve_knots(curve);
    double domain[2], scale[BAT_DEGREE_MAX] = {0}, worst = 0;
    double left[BAT_DEGREE_MAX * BAT_DIMENSION_MAX], right[BAT_DEGREE_MAX * BAT_DIMENSION_MAX];
    bat_curve_domain(curve, domain);
    for (int i = 0; i <= LOOKS; i++) {
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / LOOKS, p - 1, right);
        for (int k = 0; k < p; k++) scale[k] = fmax(scale[k], size_of(right + k * m, m));
    }
    for (int i = 0; i < count; i++) {
        if (!closed && !(knots[i] > domain[0] && knots[i] < domain[1])) continue;
        bat_curve_eval_left(curve, closed && i == 0 ? domain[1] : knots[i], p - 1, left);
        bat_curve_eval(curve, closed && i + 1 == count ? domain[0] : knots[i], p - 1, right);
        for (int k = 0; k < p; k++) {
            double d[BAT_DIMENSION_MAX];
            for (int c = 0; c < m; c++) d[c] = left[k * m + c] - right[k * m + c];
            worst = fmax(worst, size_of(d, m) / scale[k]);
        }
    }
    return worst;
}

static void is_smooth(const bat_curve *curve, int degree) {
    assert_int_equal(bat_curve_degree(curve), degree);
    assert_true(greatest_jump(curve) < 1e-9);
}

static bat_curve *drawn_new(random_source *r, int kind, int degree, sample_set *s) {
    const profile p = random_profile(r, kind);
    draw(r, &p, 0.12, s);
    const bat_stroke stroke = {.dimension = 2, .count = s->count, .points = s->points, .time = s->time};
    const bat_sketch_options options = of_degree(degree);
    bat_curve *curve = NULL;
    assert_int_equal(bat_sketch_new(&stroke, false, &options, &curve, NULL), BAT_OK);
    return curve;
}

/* The samples from one to the other, moved sideways by a smooth bump. */
static size_t bump_over(const sample_set *s, size_t from, size_t to, double height, double *out) {
    size_t n = 0;
    for (size_t i = from; i <= to; i++, n++) {
        const double f = (double)(i - from) / (double)(to - from), up = height * sin(pi * f) * sin(pi * f);
        const size_t a = i > 0 ? i - 1 : i, b = i + 1 < s->count ? i + 1 : i;
        const double x = s->points[2 * b] - s->points[2 * a], y = s->points[2 * b + 1] - s->points[2 * a + 1];
        const double length = hypot(x, y) > 0 ? hypot(x, y) : 1;
        out[2 * n] = s->points[2 * i] - up * y / length,
                out[2 * n + 1] = s->points[2 * i + 1] + up * x / length;
    }
    return n;
}

static void every_degree_is_as_smooth_as_it_can_be(void **state) {
    (void)state;
    static sample_set s;
    static double x[2 * ROOM];
    random_source r = {1003};
    for (int degree = 3; degree <= BAT_DEGREE_MAX; degree++)
        for (int n = 0; n < 2 * KINDS; n++) {
            bat_curve *curve = drawn_new(&r, n % KINDS, degree, &s), *now = NULL;
            is_smooth(curve, degree);
            assert_true(farthest(curve, s.points, 0, s.count - 1) < 2.5);
            /* Redrawn as an option of degree 3 asks for: it keeps its own. */
            const size_t from = s.count / 3, to = 2 * s.count / 3;
            const bat_stroke stroke = {.dimension = 2, .points = x, .count = bump_over(&s, from, to, 8, x)};
            bat_sketch_report report;
            assert_int_equal(bat_sketch(curve, &stroke, NULL, &now, &report), BAT_OK);
            is_smooth(now, degree);
            assert_true(report.max_error <= 1 + 1e-9);
            assert_true(bat_point_count(now) <= bat_point_count(curve) + 4 * degree);
            bat_curve_free(curve);
            bat_curve_free(now);
        }
}

static void a_cubic_stays_a_cubic(void **state) {
    (void)state;
    static sample_set s;
    static double x[2 * ROOM];
    random_source r = {1004};
    bat_curve *curve = drawn_new(&r, HUMP, 3, &s), *now = NULL;
    const bat_sketch_options options = of_degree(CLASS_A);
    const bat_stroke stroke = {
        .dimension = 2, .points = x, .count = bump_over(&s, s.count / 3, 2 * s.count / 3, 8, x)};
    assert_int_equal(bat_sketch(curve, &stroke, &options, &now, NULL), BAT_OK);
    is_smooth(now, 3);
    bat_curve_free(curve);
    bat_curve_free(now);
}

static void around(double *x, size_t count, double from, double to, double radius, double bump) {
    for (size_t i = 0; i < count; i++) {
        const double f = (double)i / (double)(count - 1), a = from + f * (to - from);
        const double R = radius + bump * sin(pi * f) * sin(pi * f) + 0.2 * sin(71.0 * (double)i);
        x[2 * i] = 300 + R * cos(a), x[2 * i + 1] = 300 + 0.8 * R * sin(a);
    }
}

static void rings_are_smooth_all_round(void **state) {
    (void)state;
    enum { COUNT = 300 };
    static double x[2 * COUNT];
    const bat_sketch_options options = of_degree(CLASS_A);
    bat_curve *ring = NULL, *now = NULL;
    bat_stroke stroke = {.dimension = 2, .points = x, .count = COUNT};
    around(x, COUNT, 0, 2 * pi, 120, 0);
    assert_int_equal(bat_sketch_new(&stroke, true, &options, &ring, NULL), BAT_OK);
    assert_true(bat_curve_is_closed(ring));
    is_smooth(ring, CLASS_A);
    for (int n = 0; n < 12; n++) { /* all places, the seam among them */
        around(x, COUNT / 3, n * pi / 6, n * pi / 6 + 1.5, 120, n % 2 ? 9 : -9);
        stroke.count = COUNT / 3;
        assert_int_equal(bat_sketch(ring, &stroke, &options, &now, NULL), BAT_OK);
        assert_true(bat_curve_is_closed(now));
        is_smooth(now, CLASS_A);
        bat_curve_free(now);
    }
    bat_curve_free(ring);
}

static void joined_and_closed_curves_are_smooth(void **state) {
    (void)state;
    enum { COUNT = 200 };
    static double x[2 * COUNT];
    const bat_sketch_options options = of_degree(CLASS_A);
    bat_curve *half[2], *joined = NULL, *closed = NULL;
    bat_stroke stroke = {.dimension = 2, .points = x, .count = COUNT};
    for (int i = 0; i < 2; i++) {
        around(x, COUNT, pi * i + 0.3, pi * i + pi - 0.3, 150, 0);
        assert_int_equal(bat_sketch_new(&stroke, false, &options, &half[i], NULL), BAT_OK);
    }
    around(x, COUNT / 4, pi - 0.35, pi + 0.35, 150, 0);
    stroke.count = COUNT / 4;
    assert_int_equal(bat_sketch_join(half[0], half[1], &stroke, &options, &joined, NULL), BAT_OK);
    is_smooth(joined, CLASS_A);
    around(x, COUNT / 4, -0.35, 0.35, 150, 0);
    assert_int_equal(bat_sketch_close(joined, &stroke, &options, &closed, NULL), BAT_OK);
    assert_true(bat_curve_is_closed(closed));
    is_smooth(closed, CLASS_A);
    for (int i = 0; i < 2; i++) bat_curve_free(half[i]);
    bat_curve_free(joined);
    bat_curve_free(closed);
}

static void it_is_fairer(void **state) {
    (void)state;
    enum { STROKES = 40 };
    static sample_set s;
    static double k[PLACES];
    int points[STROKES], added[2] = {0};
    double variation[2] = {0};
    for (int cubic = 1; cubic >= 0; cubic--) {
        random_source r = {4711};
        for (int n = 0; n < STROKES; n++) {
            bat_curve *curve = drawn_new(&r, n % KINDS, cubic ? 3 : CLASS_A, &s);
            double range[2];
            bat_curve_domain(curve, range);
            curvatures(curve, range, k);
            const int found = extrema(k, PLACES, threshold(k, PLACES));
            if (found > s.extrema) added[cubic] += found - s.extrema;
            for (int i = 1; i < PLACES; i++) variation[cubic] += fabs(k[i] - k[i - 1]);
            points[n] = bat_point_count(curve);
            bat_curve_free(curve);
        }
    }
    qsort(points, STROKES, sizeof *points, by_count); /* no ties */
    print_message("degree 5: %.2f of the cubics' change of curvature; %d false extrema in %d strokes; %d "
                  "points in the median\n",
                  variation[0] / variation[1], added[0], STROKES, points[STROKES / 2]);
    assert_true(variation[0] <= 0.95 * variation[1]);
    assert_true(added[0] == 0);
    assert_true(points[STROKES / 2] <= 8);
}

static void degrees_are_checked(void **state) {
    (void)state;
    const double x[] = {0, 0, 30, 10, 60, 0, 90, -10, 120, 0};
    const bat_stroke stroke = {.dimension = 2, .count = 5, .points = x};
    bat_curve *curve = NULL;
    static const int bad[] = {-1, 0, 2, BAT_DEGREE_MAX + 1};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const bat_sketch_options options = of_degree(bad[i]);
        assert_int_equal(bat_sketch_new(&stroke, false, &options, &curve, NULL), BAT_DEGREE);
        assert_null(curve);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_degree_is_as_smooth_as_it_can_be),
                                       cmocka_unit_test(a_cubic_stays_a_cubic),
                                       cmocka_unit_test(rings_are_smooth_all_round),
                                       cmocka_unit_test(joined_and_closed_curves_are_smooth),
                                       cmocka_unit_test(it_is_fairer),
                                       cmocka_unit_test(degrees_are_checked)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
