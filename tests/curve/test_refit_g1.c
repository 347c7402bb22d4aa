/*
 * Refitting with cubics that share a tangent only: within the tolerance, by measures of its own; smooth wherever the
 * curve is; corners and ends where they were; the same at every size; and what lines, dots and cusps become.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/fit.h>
#include <batten/refine.h>
#include "support/sketch_cases.h"

enum { PLACES = 1001 };

static const double CORNER = 0.05;

/* Polyline of a curve, the same number of places on each span. */
static void trace(const bat_curve *curve, double *x) {
    const int m = bat_curve_dimension(curve), spans = bat_curve_segment_count(curve),
              each = (PLACES - 1) / spans;
    double *breaks = malloc(((size_t)spans + 1) * sizeof *breaks);
    assert_non_null(breaks);
    assert_int_equal(bat_curve_to_bezier(curve, NULL, breaks), BAT_OK);
    bat_curve_eval(curve, breaks[0], 0, x);
    for (int i = 1; i < PLACES; i++) {
        const int span = (i - 1) / each < spans ? (i - 1) / each : spans - 1;
        const double f = fmin(1, (double)(i - span * each) / each);
        bat_curve_eval_left(curve, breaks[span] + (breaks[span + 1] - breaks[span]) * f, 0, x + i * m);
    }
    free(breaks);
}

/* The greatest distance of a point of x from the polyline y. */
static double from_polyline(const double *x, const double *y, int m) {
    double worst = 0;
    for (int i = 0; i < PLACES; i++) {
        double least = INFINITY;
        for (int k = 0; k + 1 < PLACES; k++) {
            double along = 0, square = 0, sum = 0;
            for (int c = 0; c < m; c++) {
                const double side = y[(k + 1) * m + c] - y[k * m + c];
                along += (x[i * m + c] - y[k * m + c]) * side, square += side * side;
            }
            const double f = square > 0 ? fmin(1, fmax(0, along / square)) : 0;
            for (int c = 0; c < m; c++) {
                const double off = x[i * m + c] - y[k * m + c] - f * (y[(k + 1) * m + c] - y[k * m + c]);
                sum += off * off;
            }
            least = fmin(least, sum);
        }
        worst = fmax(worst, least);
    }
    return sqrt(worst);
}

/* Distance both ways. */
static double apart(const bat_curve *a, const bat_curve *b) {
    static double x[PLACES * 3], y[PLACES * 3];
    trace(a, x), trace(b, y);
    const int m = bat_curve_dimension(a);
    return fmax(from_polyline(x, y, m), from_polyline(y, x, m));
}

/* The sharpest turn at a joint of the curve's segments that is below `corner`; *corners: how many are above. */
static double sharpest(const bat_curve *curve, double corner, int *corners) {
    const int m = bat_curve_dimension(curve);
    const bool closed = bat_curve_is_closed(curve);
    int count = 0;
    double *points = NULL, worst = 0;
    *corners = 0;
    assert_int_equal(bat_curve_to_cubics(curve, 1e-9, &count, &points), BAT_OK);
    for (int i = closed ? 0 : 1; i < count; i++) {
        const double *a = points + 4 * m * ((i + count - 1) % count) + 2 * m, *b = points + 4 * m * i;
        double dot = 0, in = 0, out = 0;
        for (int c = 0; c < m; c++) {
            const double u = a[m + c] - a[c], v = b[m + c] - b[c];
            dot += u * v, in += u * u, out += v * v;
        }
        const double turn = acos(fmax(-1, fmin(1, dot / sqrt(in * out))));
        if (turn > corner)
            ++*corners;
        else
            worst = fmax(worst, turn);
    }
    bat_free(points);
    return worst;
}

/* A curve with more spans than it needs: around a gentle wave or a ring. */
static bat_curve *dense(random_source *r, int degree, int dimension, bool closed) {
    enum { POINTS = 70 };
    double points[3 * POINTS], knots[POINTS + 8];
    for (int i = 0; i < POINTS; i++) {
        const double a = 6.283185307179586 * i / POINTS * (closed ? 1 : 0.8);
        const double x[3] = {300 * cos(a) + random_between(r, -1, 1), 200 * sin(a) + random_between(r, -1, 1),
                             50 * cos(2 * a)};
        memcpy(points + i * dimension, x, (size_t)dimension * sizeof *points);
    }
    bat_curve *curve = NULL;
    if (closed) {
        for (int i = 0; i <= POINTS; i++) knots[i] = i;
        assert_int_equal(bat_curve_create(dimension, degree, true, POINTS, points, POINTS + 1, knots, &curve),
                         BAT_OK);
    } else {
        assert_int_equal(bat_curve_create_clamped(dimension, degree, POINTS, points, &curve), BAT_OK);
    }
    return curve;
}

static void within_the_tolerance_and_smooth(void **state) {
    (void)state;
    random_source r = {5};
    for (int n = 0; n < 16; n++) {
        const int degree = 2 + n % 4, dimension = n % 3 == 2 ? 3 : 2;
        const bool closed = n % 2;
        const double tolerance = n < 8 ? 2 : 0.2;
        bat_curve *curve = dense(&r, degree, dimension, closed), *again = NULL;
        double error = -1, ends[2][2], from[3], to[3];
        assert_int_equal(bat_curve_refit_g1(curve, tolerance, CORNER, &again, &error), BAT_OK);
        assert_int_equal(bat_curve_degree(again), 3);
        assert_int_equal(bat_curve_is_closed(again), closed);
        const int before = bat_curve_segment_count(curve), after = bat_curve_segment_count(again);
        assert_true(2 * after < before && after >= (closed ? 2 : 1));
        /* Two points a cubic; one more where the speed would leave its range. */
        assert_true((int)bat_curve_count(again) <= 2 * after + 2 + closed + after / 5);
        assert_true(error <= tolerance && apart(curve, again) <= error + 0.01);
        int corners;
        assert_true(sharpest(again, CORNER, &corners) < 1e-6);
        assert_int_equal(corners, 0);
        bat_curve_domain(curve, ends[0]), bat_curve_domain(again, ends[1]);
        for (int k = 0; k < 2 && !closed; k++) {
            bat_curve_eval(curve, ends[0][k], 0, from), bat_curve_eval(again, ends[1][k], 0, to);
            for (int c = 0; c < dimension; c++) assert_true(fabs(from[c] - to[c]) < 1e-9);
        }
        bat_curve_free(curve), bat_curve_free(again);
    }
}

/* Arcs of many segments each between corners, closed or open. */
static bat_curve *flower(bool closed, double scale) {
    enum { PETALS = 5, PARTS = 8, SEGMENTS = PETALS * PARTS };
    double points[2 * (3 * SEGMENTS + 1)];
    const double step = 3.141592653589793 / PARTS, handle = 4.0 / 3 * tan(step / 4);
    for (int i = 0; i <= SEGMENTS; i++) {
        const int petal = i / PARTS % PETALS;
        for (int k = 0; k < (i < SEGMENTS ? 3 : 1); k++) {
            const double a = (i % PARTS) * step + (k == 2 ? step : 0);
            double x = -cos(a), y = sin(a); /* an arc from (-1, 0) to (1, 0) */
            if (k == 1) x += handle * sin(a), y += handle * cos(a);
            if (k == 2) x -= handle * sin(a), y -= handle * cos(a);
            const double turn = 6.283185307179586 * petal / PETALS, side = tan(3.141592653589793 / PETALS);
            x *= side, y = 1 + y * side;
            points[2 * (3 * i + k)] = scale * (x * cos(turn) + y * sin(turn));
            points[2 * (3 * i + k) + 1] = scale * (y * cos(turn) - x * sin(turn));
        }
    }
    points[6 * SEGMENTS] = points[0], points[6 * SEGMENTS + 1] = points[1];
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_from_bezier(2, 3, closed, closed ? SEGMENTS : SEGMENTS - PARTS, points, CORNER,
                                           0, &curve, NULL),
                     BAT_OK);
    return curve;
}

/* A half circle of radius r is one cubic within 0.0189 r, two within 2.8e-4 r. */
static void corners_stay_and_arcs_get_the_cubics_they_need(void **state) {
    (void)state;
    for (int closed = 0; closed < 2; closed++)
        for (double scale = 1e-6; scale < 1e7; scale *= 1e4)
            for (int each = 1; each <= 2; each++) {
                const double radius = scale * tan(3.141592653589793 / 5);
                bat_curve *curve = flower(closed, scale), *again = NULL;
                double error;
                int corners;
                assert_int_equal(
                    bat_curve_refit_g1(curve, radius * (each == 1 ? 0.0189 : 2.8e-4), CORNER, &again, &error),
                    BAT_OK);
                assert_int_equal(bat_curve_segment_count(again), each * (4 + closed));
                assert_true(sharpest(again, CORNER, &corners) < 1e-6);
                assert_int_equal(corners, closed ? 5 : 3);
                bat_curve_free(curve), bat_curve_free(again);
            }
}

static void check_kept(const bat_curve *curve, double tolerance, int spans) {
    bat_curve *again = NULL;
    double error = -1;
    assert_int_equal(bat_curve_refit_g1(curve, tolerance, CORNER, &again, &error), BAT_OK);
    assert_int_equal(bat_curve_segment_count(again), spans);
    assert_true(error >= 0 && error <= tolerance && apart(curve, again) <= 1.01 * tolerance + 1e-9);
    bat_curve_free(again);
}

static void lines_dots_and_cusps(void **state) {
    (void)state;
    bat_curve *curve = NULL;
    const double line[] = {0, 0, 30, 10, 60, 20, 75, 25, 90, 30, 120, 40, 150, 50};
    for (int degree = 1; degree <= 3; degree++) { /* on one straight line: one span, whatever the tolerance */
        assert_int_equal(bat_curve_create_clamped(2, degree, 7, line, &curve), BAT_OK);
        for (double tolerance = 1e-6; tolerance < 1e9; tolerance *= 1e3) check_kept(curve, tolerance, 1);
        bat_curve_free(curve);
    }
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, line, &curve), BAT_OK);
    check_kept(curve, 1, 1), check_kept(curve, 0, 1);
    bat_curve_free(curve);
    const double dot[] = {5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
    assert_int_equal(bat_curve_create_clamped(2, 3, 5, dot, &curve), BAT_OK);
    check_kept(curve, 1, 1);
    bat_curve_free(curve);
    const double cusp[] = {0, 0, 100, 100, 0, 100, 100, 0}; /* within one span */
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, cusp, &curve), BAT_OK);
    check_kept(curve, 1e-3, 1);
    bat_curve *fine = NULL;
    const double at[] = {0.2, 0.4, 0.5, 0.7, 0.9};
    assert_int_equal(bat_curve_insert_knots(curve, 5, at, &fine), BAT_OK);
    check_kept(fine, 1e-3, 1);
    bat_curve_free(curve), bat_curve_free(fine);
    const double star[] = {0,  0,   50, 80,  50, 80,  50,
                           80, 100, 0,  130, 90, 200, 20}; /* a corner of coincident points */
    assert_int_equal(bat_curve_create_clamped(2, 3, 7, star, &curve), BAT_OK);
    for (double tolerance = 1e-3; tolerance < 30; tolerance *= 30) {
        bat_curve *again = NULL;
        assert_int_equal(bat_curve_refit_g1(curve, tolerance, CORNER, &again, NULL), BAT_OK);
        assert_true(apart(curve, again) <= 1.01 * tolerance + 0.01);
        assert_true(bat_curve_segment_count(again) <= bat_curve_segment_count(curve));
        bat_curve_free(again);
    }
    bat_curve_free(curve);
}

/* However much is allowed, a ring stays one; what cannot do with fewer cubics stays as it is. */
static void extreme_tolerances(void **state) {
    (void)state;
    random_source r = {11};
    bat_curve *ring = dense(&r, 3, 2, true), *again = NULL, *same = NULL;
    assert_int_equal(bat_curve_refit_g1(ring, 1e30, CORNER, &again, NULL), BAT_OK);
    assert_true(bat_curve_is_closed(again) && bat_curve_segment_count(again) >= 2);
    bat_curve_free(again);
    for (double tolerance = 0; tolerance < 1e-12; tolerance += 1e-13) {
        assert_int_equal(bat_curve_refit_g1(ring, tolerance, CORNER, &again, NULL), BAT_OK);
        assert_true(bat_curve_segment_count(again) <= bat_curve_segment_count(ring));
        assert_true(apart(ring, again) < 1e-9);
        bat_curve_free(again);
    }
    assert_int_equal(bat_curve_refit_g1(ring, 2, CORNER, &again, NULL), BAT_OK);
    assert_int_equal(bat_curve_refit_g1(again, 1e-6, CORNER, &same, NULL), BAT_OK);
    assert_true(bat_curve_segment_count(same) <= bat_curve_segment_count(again));
    bat_curve_free(ring), bat_curve_free(again), bat_curve_free(same);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(within_the_tolerance_and_smooth),
                                       cmocka_unit_test(corners_stay_and_arcs_get_the_cubics_they_need),
                                       cmocka_unit_test(lines_dots_and_cusps),
                                       cmocka_unit_test(extreme_tolerances)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
