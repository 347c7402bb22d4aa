/* Bézier segments out and in: exact, knots in the right places, corners kept, circles periodic. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/nearest.h>
#include <batten/refine.h>
#include "curve/curve.h"
#include "support/random_curve.h"

static void bezier_point(const double *b, int p, int size, double u, double *out) {
    double d[8 * 3];
    memcpy(d, b, (size_t)((p + 1) * size) * sizeof(double));
    for (int r = 1; r <= p; r++)
        for (int i = 0; i <= (p - r) * size + size - 1; i++) d[i] = (1 - u) * d[i] + u * d[i + size];
    memcpy(out, d, (size_t)size * sizeof(double));
}

/* Segments out are the curve, for every degree and kind; cubics are within their tolerance. */
static void segments_are_the_curve(void **state) {
    (void)state;
    random_source r = {21};
    for (int round = 0; round < 150; round++) {
        int p = random_int(&r, 1, 7), size = 2 + round % 2;
        bat_curve *curve = random_curve(&r, p, size, round % 3, random_int(&r, 0, 9));
        int count = bat_curve_segment_count(curve), cubics = 0;
        double points[64 * 8 * 3], breaks[65], *cubic = NULL, x[3], y[3];
        assert_int_equal(bat_curve_to_bezier(curve, points, breaks), BAT_OK);
        for (int i = 0; i < count; i++)
            for (int k = 0; k <= 8; k++) {
                double w = k / 8.0, u = breaks[i] + w * (breaks[i + 1] - breaks[i]);
                bezier_point(points + i * (p + 1) * size, p, size, w, x);
                if (k == 8)
                    bat_curve_eval_left(curve, breaks[i + 1], 0, y);
                else
                    bat_curve_eval(curve, u, 0, y);
                for (int c = 0; c < size; c++) assert_true(fabs(x[c] - y[c]) < 1e-11);
            }
        assert_int_equal(bat_curve_to_cubics(curve, 1e-3, &cubics, &cubic), BAT_OK);
        if (p <= 3) {
            assert_int_equal(cubics, count);
            for (int i = 0; i < count; i++) {
                bezier_point(points + i * (p + 1) * size, p, size, 0.3, x);
                bezier_point(cubic + i * 4 * size, 3, size, 0.3, y);
                for (int c = 0; c < size; c++) assert_true(fabs(x[c] - y[c]) < 1e-12);
            }
        } else {
            assert_true(cubics >= count);
            for (int i = 0; i < cubics; i++) {
                bat_near near;
                bezier_point(cubic + i * 4 * size, 3, size, 0.5, x);
                assert_int_equal(bat_curve_nearest(curve, x, &near), BAT_OK);
                assert_true(near.distance <= 1e-3);
            }
        }
        bat_free(cubic);
        bat_curve_free(curve);
    }
}

/* The way out and in again gives the curve back with its knots, up to scale. */
static void out_and_in(void **state) {
    (void)state;
    random_source r = {22};
    for (int round = 0; round < 120; round++) {
        int p = random_int(&r, 2, 3), size = 2 + round % 2, n = random_int(&r, 9, 16);
        bool closed = round % 3 == 0;
        double knots[64], points[64 * 3];
        for (int i = 0; i < n + p + 1; i++) knots[i] = closed ? i : i < p ? 0 : i > n ? n - p : i - p;
        double span = random_between(&r, 0.3, 3); /* one uneven span: ratios are found, not assumed */
        for (int i = n / 2; i < n + p + 1; i++) knots[i] += span;
        for (int i = 0; i < n * size; i++) points[i] = random_between(&r, -10, 10);
        bat_curve *curve = NULL, *again = NULL;
        assert_int_equal(
            bat_curve_create(size, p, closed, (size_t)n, points, closed ? n + 1 : n + p + 1, knots, &curve),
            BAT_OK);
        double segments[64 * 4 * 3], path[64 * 4 * 3], error = -1;
        int count = bat_curve_segment_count(curve);
        bat_curve_to_bezier(curve, segments, NULL);
        for (int i = 0; i < count; i++)
            memcpy(path + i * p * size, segments + i * (p + 1) * size,
                   (size_t)((p + 1) * size) * sizeof(double));
        if (closed) memcpy(path + count * p * size, path, (size_t)size * sizeof(double));
        assert_int_equal(bat_curve_from_bezier(size, p, closed, count, path, 0.01, 1e-8, &again, &error),
                         BAT_OK);
        assert_int_equal(bat_curve_count(again), n);
        assert_true(error <= 1e-8);
        double a[2], b[2];
        bat_curve_domain(curve, a);
        bat_curve_domain(again, b);
        double scale = (b[1] - b[0]) / (a[1] - a[0]);
        assert_true(curve_gap(curve, again, scale, b[0] - a[0] * scale, 200) < 1e-7);
        bat_curve_free(again);
        bat_curve_free(curve);
    }
}

/* Four cubics of a circle: periodic, C1, four double knots and eight points; no seam. */
static void circle(void **state) {
    (void)state;
    const double k = 0.5522847498307936;
    const double path[] = {1, 0,  1,  k,  k,  1, 0,  1, -k, 1, -1, k, -1,
                           0, -1, -k, -k, -1, 0, -1, k, -1, 1, -k, 1, 0};
    bat_curve *curve = NULL;
    double error = -1;
    assert_int_equal(bat_curve_from_bezier(2, 3, true, 4, path, 0.01, 0, &curve, &error), BAT_OK);
    assert_true(bat_curve_is_closed(curve));
    assert_int_equal(bat_curve_count(curve), 8);
    assert_true(error < 1e-14);
    double d[2], p[4], q[4];
    bat_curve_domain(curve, d);
    assert_int_equal(bat_knot_multiplicity(curve, d[0]), 2);
    for (int i = 0; i < 100; i++) {
        bat_curve_eval(curve, d[0] + (d[1] - d[0]) * i / 100, 0, p);
        assert_true(fabs(hypot(p[0], p[1]) - 1) < 2.8e-4);
    }
    bat_curve_eval(curve, d[0], 1, p);
    bat_curve_eval_left(curve, d[0], 1, q);
    for (int i = 0; i < 4; i++) assert_true(fabs(p[i] - q[i]) < 1e-14);
    bat_curve_free(curve);
}

/* A square of lines written as cubics: each corner a triple knot, wherever the path starts; sides that were
 * cut into collinear parts heal. */
static void square_of_lines(void **state) {
    (void)state;
    for (int start = 0; start < 5; start++) {
        const double vertices[5][2] = {{0, 0}, {2, 0}, {6, 0}, {6, 6}, {0, 6}}; /* (2, 0) is no corner */
        double path[16 * 2];
        for (int i = 0; i < 5; i++) {
            const double *a = vertices[(start + i) % 5], *b = vertices[(start + i + 1) % 5];
            for (int j = 0; j <= 3; j++)
                for (int c = 0; c < 2; c++) path[(i * 3 + j) * 2 + c] = a[c] + (b[c] - a[c]) * j / 3;
        }
        bat_curve *curve = NULL;
        double error = -1;
        for (int c = 0; c < 2; c++) path[30 + c] = path[c];
        assert_int_equal(bat_curve_from_bezier(2, 3, true, 5, path, 0.05, 1e-6, &curve, &error), BAT_OK);
        double d[2];
        bat_curve_domain(curve, d);
        /* Four corners of three knots, and no trace of (2, 0), even where it was the seam. */
        assert_int_equal(bat_curve_count(curve), 12);
        assert_int_equal(bat_knot_multiplicity(curve, d[0]), 3);
        bat_curve_free(curve);
    }
}

/* Bad handles, zero-length segments, all points one: no NaN, corners where nothing else is known. */
static void degenerate_paths(void **state) {
    (void)state;
    const double path[] = {0, 0, 0, 0, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 6, 0, 6, 0};
    bat_curve *curve = NULL;
    double error = -1, p[2];
    assert_int_equal(bat_curve_from_bezier(2, 3, false, 3, path, 0.01, 0, &curve, &error), BAT_OK);
    assert_int_equal(bat_curve_segment_count(curve), 2);
    bat_curve_eval(curve, bat_curve_knots(curve)[4], 0, p);
    assert_true(p[0] == 3 && p[1] == 3);
    bat_curve_free(curve);
    curve = NULL;
    const double dot[14] = {0};
    assert_int_equal(bat_curve_from_bezier(2, 3, true, 2, dot, 0.01, 0, &curve, &error), BAT_COUNT);
    assert_int_equal(bat_curve_from_bezier(2, 3, true, 0, dot, 0.01, 0, &curve, &error), BAT_COUNT);
    assert_int_equal(bat_curve_from_bezier(2, 3, true, 3, path, 0.01, 0, &curve, &error), BAT_ARGUMENT);
    assert_int_equal(bat_curve_from_bezier(2, 8, false, 1, path, 0.01, 0, &curve, &error), BAT_DEGREE);
    assert_int_equal(bat_curve_from_bezier(4, 3, false, 1, path, 0.01, 0, &curve, &error), BAT_DIMENSION);
    assert_int_equal(bat_curve_from_bezier(2, 3, false, 1, path, NAN, 0, &curve, &error), BAT_ARGUMENT);
    const double bad[] = {0, 0, 1, 0, NAN, 1, 2, 2};
    assert_int_equal(bat_curve_from_bezier(2, 3, false, 1, bad, 0.01, 0, &curve, &error), BAT_NUMBER);
    assert_null(curve);
    /* Handles and segments of wildly different length. */
    random_source r = {23};
    for (int round = 0; round < 200; round++) {
        double wild[61 * 2];
        for (int i = 0; i < 122; i++)
            wild[i] = i >= 2 && random_unit(&r) < 0.3 ? wild[i - 2] : pow(10, random_between(&r, -9, 9));
        wild[120] = wild[0], wild[121] = wild[1];
        assert_int_equal(bat_curve_from_bezier(2, 3, round % 2, 20, wild, 0.1, 1e-3, &curve, &error), BAT_OK);
        assert_true(error <= 1e-3 + 1e-3);
        bat_curve_free(curve);
    }
}

/* A closed chain whose first handles make its parameter run fast, and a piece that is far shorter than the parameter's digits:
 * it is there all the same, within the tolerance of its joints. */
static void a_piece_shorter_than_its_period_allows(void **state) {
    (void)state;
    enum { PIECES = 400 };
    static double points[2 * (3 * PIECES + 1)];
    const double sizes[] = {1, 1e-6, 1e6};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
        for (int i = 0; i <= 3 * PIECES; i++) {
            const double angle = 6.283185307179586477 * (i / 3) / PIECES,
                         next = angle + 6.283185307179586477 / PIECES,
                         share = i == 2 ? 1 - 1e-5 : i % 3 / 3.0;
            points[2 * i] = sizes[k] * (cos(angle) + share * (cos(next) - cos(angle)));
            points[2 * i + 1] = sizes[k] * (sin(angle) + share * (sin(next) - sin(angle)));
        }
        double *last = points + 2 * (3 * PIECES - 3); /* all but without length, and across */
        for (int i = 0; i < 3; i++)
            last[2 * i] = points[0] + sizes[k] * (3 - i) * 1e-13,
                     last[2 * i + 1] = points[1] + sizes[k] * i * 1e-13;
        points[2 * 3 * PIECES] = points[0], points[2 * 3 * PIECES + 1] = points[1];
        bat_curve *curve = NULL;
        double error = -1;
        assert_int_equal(
            bat_curve_from_bezier(2, 3, true, PIECES, points, 0.05, 1e-9 * sizes[k], &curve, &error), BAT_OK);
        assert_true(error <= 2e-9 * sizes[k]);
        for (int i = 0; i < PIECES; i += 7) {
            bat_near near;
            assert_int_equal(bat_curve_nearest(curve, points + (size_t)6 * (size_t)i, &near), BAT_OK);
            assert_true(near.distance <= 2e-9 * sizes[k]);
        }
        bat_curve_free(curve);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(segments_are_the_curve),
                                       cmocka_unit_test(out_and_in),
                                       cmocka_unit_test(circle),
                                       cmocka_unit_test(square_of_lines),
                                       cmocka_unit_test(a_piece_shorter_than_its_period_allows),
                                       cmocka_unit_test(degenerate_paths)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
