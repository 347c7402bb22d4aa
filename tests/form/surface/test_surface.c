/* Surfaces: closed forms (bilinear, paraboloid, torus), lines and grids against single points, finite differences,
 * insertion, rigid motion, collapsed edges, huge and tiny surfaces, bad data. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/surface.h>
#include "support/random_surface.h"

enum { MOST = 63 }; /* surfaces of every kind and degree */

static double apart(const double *a, const double *b, int size) {
    double d = 0;
    for (int c = 0; c < size; c++) d = fmax(d, fabs(a[c] - b[c]));
    return d;
}

/* Clamped, of one span in each direction, over [0, 1] x [0, 1]. */
static bat_surface *patch(int p, int q, const double *points) {
    const int degree[2] = {p, q}, count[2] = {2 * p + 2, 2 * q + 2};
    const size_t n[2] = {(size_t)p + 1, (size_t)q + 1};
    double u[16] = {0}, v[16] = {0};
    for (int i = 0; i <= p; i++) u[p + 1 + i] = 1;
    for (int i = 0; i <= q; i++) v[q + 1 + i] = 1;
    bat_surface *surface = NULL;
    assert_int_equal(
        bat_surface_create(degree, (const bool[2]){false, false}, n, points, count, u, v, &surface), BAT_OK);
    return surface;
}

static void bilinear(void **state) {
    (void)state;
    const double points[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1}; /* z = u v */
    bat_surface *s = patch(1, 1, points);
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= 8; j++) {
            const double u = i / 8.0, v = j / 8.0;
            const double want[18] = {u, v, u * v, 1, 0, v, 0, 1, u, 0, 0, 0, 0, 0, 1, 0, 0, 0};
            double got[18], normal[3], gauss, mean;
            bat_surface_eval(s, u, v, 2, got);
            assert_true(apart(got, want, 18) < 1e-15);
            assert_int_equal(bat_surface_normal(s, u, v, normal), BAT_OK);
            const double w = 1 + u * u + v * v, n[3] = {-v / sqrt(w), -u / sqrt(w), 1 / sqrt(w)};
            assert_true(apart(normal, n, 3) < 1e-15);
            assert_int_equal(bat_surface_curvature(s, u, v, &gauss, &mean), BAT_OK);
            assert_true(fabs(gauss + 1 / (w * w)) < 1e-14);
            assert_true(fabs(mean + u * v / (w * sqrt(w))) < 1e-14);
        }
    bat_surface_free(s);
}

/* z = x^2 + y^2 over [-1, 1]^2 with x = 2u - 1, y = 2v - 1: exactly representable. It bends upwards, towards the normal
 * (0, 0, 1): the mean curvature at the bottom is 2, the Gauss curvature 4. */
static void paraboloid(void **state) {
    (void)state;
    const double x[3] = {-1, 0, 1}, square[3] = {1, -1, 1};
    double points[27];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double *p = points + 3 * (3 * i + j);
            p[0] = x[i], p[1] = x[j], p[2] = square[i] + square[j];
        }
    bat_surface *s = patch(2, 2, points);
    for (int i = 0; i <= 10; i++)
        for (int j = 0; j <= 10; j++) {
            double got[3], gauss, mean;
            bat_surface_eval(s, i / 10.0, j / 10.0, 0, got);
            const double a = 0.2 * i - 1, b = 0.2 * j - 1, r = a * a + b * b, w = 1 + 4 * r;
            assert_true(apart(got, (const double[3]){a, b, r}, 3) < 1e-15);
            assert_int_equal(bat_surface_curvature(s, i / 10.0, j / 10.0, &gauss, &mean), BAT_OK);
            assert_true(fabs(gauss - 4 / (w * w)) < 1e-13);
            assert_true(fabs(mean - (2 + 4 * r) / (w * sqrt(w))) < 1e-13);
        }
    bat_surface_free(s);
}

/* A cubic ring of points around a ring: closed both ways, so that a period later everything is the same. */
static void ring_around_a_ring(void **state) {
    (void)state;
    enum { M = 12, N = 8 };
    double points[M * N * 3], u[M + 1], v[N + 1];
    for (int i = 0; i <= M; i++) u[i] = i;
    for (int j = 0; j <= N; j++) v[j] = j;
    for (int i = 0; i < M; i++)
        for (int j = 0; j < N; j++) {
            const double a = i * 2 * 3.14159265358979 / M, b = j * 2 * 3.14159265358979 / N, r = 3 + cos(b);
            const double p[3] = {r * cos(a), r * sin(a), sin(b)};
            memcpy(points + 3 * (N * i + j), p, sizeof p);
        }
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){true, true},
                                        (const size_t[2]){M, N}, points, (const int[2]){M + 1, N + 1}, u, v,
                                        &s),
                     BAT_OK);
    double a[18], b[18], turned[3];
    for (int i = 0; i < 40; i++) {
        const double x = i * 0.3, y = i * 0.2;
        bat_surface_eval(s, x, y, 2, a);
        bat_surface_eval(s, x + M, y - 3 * N, 2, b);
        assert_true(apart(a, b, 18) < 1e-13);
        /* one point further round is a turn by a twelfth */
        bat_surface_eval(s, x + 1, y, 0, b);
        const double c = cos(2 * 3.14159265358979 / M), d = sin(2 * 3.14159265358979 / M);
        turned[0] = c * a[0] - d * a[1], turned[1] = d * a[0] + c * a[1], turned[2] = a[2];
        assert_true(apart(turned, b, 3) < 1e-13);
    }
    double domain[2], spread[M];
    bat_surface_domain(s, BAT_U, domain);
    assert_true(domain[0] == 0 && domain[1] == M);
    bat_surface_spread(s, BAT_U, M, spread);
    assert_true(spread[M - 1] == M - 1);
    bat_surface_free(s);
}

/* A line at u is the surface to the bit; a line at v, and a grid, but for rounding. */
static void lines_and_grids_are_the_surface(void **state) {
    (void)state;
    random_source r = {21};
    for (int number = 0; number < MOST; number++) {
        bat_surface *s = some_surface(&r, number);
        double u[7], v[7], grid[7 * 7 * 18], one[18], on_line[9];
        bat_surface_spread(s, BAT_U, 7, u);
        bat_surface_spread(s, BAT_V, 7, v);
        for (int order = 0; order <= 2; order++) {
            const int block = 3 * (order + 1) * (order + 2) / 2;
            assert_int_equal(bat_surface_eval_grid(s, 7, u, 7, v, order, grid), BAT_OK);
            for (int k = 0; k < 49; k++) {
                bat_surface_eval(s, u[k / 7], v[k % 7], order, one);
                double most = 10;
                for (int c = 0; c < block; c++) most = fmax(most, fabs(one[c]));
                assert_true(apart(grid + k * block, one, block) < 1e-11 * most);
            }
        }
        for (int k = 0; k < 49; k++) {
            bat_curve *line = NULL;
            bat_surface_eval(s, u[k / 7], v[k % 7], 2, one);
            assert_int_equal(bat_surface_isocurve(s, BAT_U, u[k / 7], &line), BAT_OK);
            bat_curve_eval(line, v[k % 7], 2, on_line);
            assert_memory_equal(on_line, one, 3 * sizeof(double));
            assert_memory_equal(on_line + 3, one + 6, 3 * sizeof(double));
            assert_memory_equal(on_line + 6, one + 15, 3 * sizeof(double));
            bat_curve_free(line);
            assert_int_equal(bat_surface_isocurve(s, BAT_V, v[k % 7], &line), BAT_OK);
            assert_int_equal(bat_curve_knot_count(line), bat_surface_knot_count(s, BAT_U));
            assert_memory_equal(bat_curve_knots(line), bat_surface_knots(s, BAT_U),
                                (size_t)bat_curve_knot_count(line) * sizeof(double));
            bat_curve_eval(line, u[k / 7], 0, on_line);
            assert_true(apart(on_line, one, 3) < 1e-13);
            bat_curve_free(line);
        }
        bat_surface_free(s);
    }
}

/* Central differences, in a span's middle so that no knot lies between. */
static void derivatives_are_differences(void **state) {
    (void)state;
    random_source r = {5};
    for (int p = 2; p <= 7; p++)
        for (int q = 2; q <= 7; q++) {
            const int degree[2] = {p, q}, kind[2] = {0, 0}, extra[2] = {0, 0};
            bat_surface *s = random_surface(&r, degree, kind, extra);
            double du[2], dv[2], at[18], a[9], b[9];
            bat_surface_domain(s, BAT_U, du);
            bat_surface_domain(s, BAT_V, dv);
            const double u = 0.45 * du[0] + 0.55 * du[1], v = 0.3 * dv[0] + 0.7 * dv[1];
            const double h = 1e-5 * (du[1] - du[0]), k = 1e-5 * (dv[1] - dv[0]);
            bat_surface_eval(s, u, v, 2, at);
            double slope = 1, bend = 1;
            for (int c = 0; c < 9; c++) slope = fmax(slope, fabs(at[c])), bend = fmax(bend, fabs(at[c + 9]));
            bat_surface_eval(s, u - h, v, 1, a);
            bat_surface_eval(s, u + h, v, 1, b);
            for (int c = 0; c < 3; c++) {
                assert_true(fabs((b[c] - a[c]) / (2 * h) - at[3 + c]) < 1e-6 * slope);
                assert_true(fabs((b[3 + c] - a[3 + c]) / (2 * h) - at[9 + c]) < 1e-6 * bend);
                assert_true(fabs((b[6 + c] - a[6 + c]) / (2 * h) - at[12 + c]) < 1e-6 * bend);
            }
            bat_surface_eval(s, u, v - k, 1, a);
            bat_surface_eval(s, u, v + k, 1, b);
            for (int c = 0; c < 3; c++) {
                assert_true(fabs((b[c] - a[c]) / (2 * k) - at[6 + c]) < 1e-6 * slope);
                assert_true(fabs((b[6 + c] - a[6 + c]) / (2 * k) - at[15 + c]) < 1e-6 * bend);
            }
            bat_surface_free(s);
        }
}

/* Inserted knots do not change the shape; rows beyond their reach keep every bit; a superset refines. */
static void insertion_keeps_the_shape(void **state) {
    (void)state;
    random_source r = {9};
    int kept = 0;
    for (int number = 0; number < MOST; number++) {
        bat_surface *s = some_surface(&r, number), *fine = NULL, *same = NULL;
        for (bat_direction d = BAT_U; d <= BAT_V; d++) {
            const double x = random_parameter(&r, s, d);
            assert_int_equal(bat_surface_insert_knots(s, d, 1, &x, &fine), BAT_OK);
            assert_int_equal(bat_surface_count(fine, d), bat_surface_count(s, d) + 1);
            for (int k = 0; k < 20; k++) {
                double a[3], b[3];
                const double u = random_parameter(&r, s, BAT_U), v = random_parameter(&r, s, BAT_V);
                bat_surface_eval(s, u, v, 0, a);
                bat_surface_eval(fine, u, v, 0, b);
                assert_true(apart(a, b, 3) < 1e-12);
            }
            const size_t size = bat_surface_count(s, BAT_V) * 3 * sizeof(double);
            for (int i = 0; d == BAT_U && i < (int)bat_surface_count(s, d); i++)
                for (int k = 0; k <= 1; k++)
                    kept += memcmp(bat_surface_row(s, i), bat_surface_row(fine, i + k), size) == 0;
            assert_int_equal(
                bat_surface_refine(s, d, bat_surface_knot_count(fine, d), bat_surface_knots(fine, d), &same),
                BAT_OK);
            assert_true(bat_surface_is_equal(fine, same));
            assert_false(bat_surface_is_equal(fine, s));
            bat_surface_free(fine);
            bat_surface_free(same);
            const double outside = INFINITY;
            assert_int_not_equal(bat_surface_insert_knots(s, d, 1, &outside, &fine), BAT_OK);
        }
        bat_surface_free(s);
    }
    assert_true(kept > MOST);
}

/* A rigid motion moves points and normals and leaves curvatures; a mirror turns normals and mean curvature round. */
static void motion(void **state) {
    (void)state;
    random_source r = {77};
    const double c = cos(1.1), d = sin(1.1);
    const double turn[12] = {c, -d, 0, 5, d, c, 0, -3, 0, 0, 1, 2},
                 flip[12] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    for (int number = 0; number < MOST; number++) {
        const int degree[2] = {2 + number % 6, 2 + number / 3 % 6}, kind[2] = {number % 3, number / 3 % 3};
        bat_surface *s = random_surface(&r, degree, kind, (const int[2]){8, 8}), *moved, *mirrored;
        assert_int_equal(bat_surface_transform(s, turn, &moved), BAT_OK);
        assert_int_equal(bat_surface_transform(s, flip, &mirrored), BAT_OK);
        assert_true(fabs(bat_surface_size(mirrored) - bat_surface_size(s)) < 1e-13);
        for (int k = 0; k < 10; k++) {
            const double u = random_parameter(&r, s, BAT_U), v = random_parameter(&r, s, BAT_V);
            double a[3], b[3], n[3], m[3], gauss[3], mean[3];
            bat_surface_eval(s, u, v, 0, a);
            bat_surface_eval(moved, u, v, 0, b);
            const double want[3] = {c * a[0] - d * a[1] + 5, d * a[0] + c * a[1] - 3, a[2] + 2};
            assert_true(apart(b, want, 3) < 1e-13);
            assert_int_equal(bat_surface_normal(s, u, v, n), BAT_OK);
            assert_int_equal(bat_surface_normal(moved, u, v, m), BAT_OK);
            const double turned[3] = {c * n[0] - d * n[1], d * n[0] + c * n[1], n[2]};
            assert_true(apart(m, turned, 3) < 1e-9);
            assert_int_equal(bat_surface_curvature(s, u, v, gauss, mean), BAT_OK);
            assert_int_equal(bat_surface_curvature(moved, u, v, gauss + 1, mean + 1), BAT_OK);
            assert_int_equal(bat_surface_curvature(mirrored, u, v, gauss + 2, mean + 2), BAT_OK);
            const double scale = 1e-7 * (1 + fabs(gauss[0]) + mean[0] * mean[0]);
            assert_true(fabs(gauss[1] - gauss[0]) < scale && fabs(gauss[2] - gauss[0]) < scale);
            assert_true(fabs(mean[1] - mean[0]) < scale && fabs(mean[2] + mean[0]) < scale);
        }
        bat_surface_free(s), bat_surface_free(moved), bat_surface_free(mirrored);
    }
}

/* A cone's tip, and a sheet whose parameters run along one line, have no normal; beside them there is one. */
static void where_there_is_no_normal(void **state) {
    (void)state;
    const double cone[] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const double line[] = {0, 0, 0, 1, 2, 3, 2, 4, 6, 3, 6, 9};
    double n[3] = {7, 7, 7}, gauss = 7, mean = 7;
    bat_surface *s = patch(1, 2, cone);
    assert_int_equal(bat_surface_normal(s, 0, 0.5, n), BAT_SINGULAR);
    assert_int_equal(bat_surface_curvature(s, 0, 0.5, &gauss, &mean), BAT_SINGULAR);
    assert_true(n[0] == 7 && gauss == 7 && mean == 7);
    assert_int_equal(bat_surface_normal(s, 1e-6, 0.5, n), BAT_OK);
    assert_int_equal(bat_surface_normal(s, NAN, 0.5, n), BAT_NUMBER);
    bat_surface_free(s);
    s = patch(1, 1, line);
    for (int i = 0; i <= 10; i++) assert_int_equal(bat_surface_normal(s, i / 10.0, 0.3, n), BAT_SINGULAR);
    bat_surface_free(s);
}

/* Sizes from 1e-75 to 1e75: the same surface but for the scale. */
static void huge_and_tiny(void **state) {
    (void)state;
    const double points[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1};
    for (int power = -240; power <= 240; power += 48) {
        const double scale = ldexp(1, power), matrix[12] = {scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0};
        bat_surface *s = patch(1, 1, points), *other = NULL;
        double a[3], b[3], n[3], m[3], gauss[2], mean[2];
        assert_int_equal(bat_surface_transform(s, matrix, &other), BAT_OK);
        bat_surface_eval(s, 0.3, 0.7, 0, a);
        bat_surface_eval(other, 0.3, 0.7, 0, b);
        for (int c = 0; c < 3; c++) assert_true(b[c] == a[c] * scale);
        assert_int_equal(bat_surface_normal(s, 0.3, 0.7, n), BAT_OK);
        assert_int_equal(bat_surface_normal(other, 0.3, 0.7, m), BAT_OK);
        assert_true(apart(n, m, 3) < 1e-15);
        assert_int_equal(bat_surface_curvature(s, 0.3, 0.7, gauss, mean), BAT_OK);
        assert_int_equal(bat_surface_curvature(other, 0.3, 0.7, gauss + 1, mean + 1), BAT_OK);
        assert_true(fabs(gauss[1] * scale * scale / gauss[0] - 1) < 1e-14);
        assert_true(fabs(mean[1] * scale / mean[0] - 1) < 1e-14);
        bat_surface_free(s), bat_surface_free(other);
    }
}

static void bad_data(void **state) {
    (void)state;
    const double knots[] = {0, 0, 1, 1}, bad[] = {0, 0, NAN, 1}, falls[] = {0, 0, 1, 0.5};
    const double points[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1}, same[12] = {0};
    double wild[12];
    memcpy(wild, points, sizeof wild);
    wild[7] = INFINITY;
    const int one[2] = {1, 1}, eight[2] = {1, 8}, four[2] = {4, 4}, five[2] = {5, 4};
    const bool open[2] = {false, false};
    const size_t two[2] = {2, 2}, few[2] = {1, 2}, many[2] = {1 << 23, 1 << 23};
    bat_surface *s = NULL;
    assert_int_equal(bat_surface_create(eight, open, two, points, four, knots, knots, &s), BAT_DEGREE);
    assert_int_equal(bat_surface_create(one, open, few, points, four, knots, knots, &s), BAT_COUNT);
    assert_int_equal(bat_surface_create(one, open, many, points, four, knots, knots, &s), BAT_COUNT);
    assert_int_equal(bat_surface_create(one, open, two, points, five, knots, knots, &s), BAT_KNOTS);
    assert_int_equal(bat_surface_create(one, open, two, points, four, falls, knots, &s), BAT_KNOTS);
    assert_int_equal(bat_surface_create(one, open, two, points, four, knots, bad, &s), BAT_NUMBER);
    assert_int_equal(bat_surface_create(one, open, two, wild, four, knots, knots, &s), BAT_NUMBER);
    assert_int_equal(bat_surface_create(one, open, two, same, four, knots, knots, &s), BAT_SINGULAR);
    assert_int_equal(bat_surface_create(one, open, two, NULL, four, knots, knots, &s), BAT_ARGUMENT);
    assert_null(s);
    assert_int_equal(bat_surface_create(one, open, two, points, four, knots, knots, &s), BAT_OK);
    double out[18] = {0};
    const double sorted[] = {0, 1}, unsorted[] = {1, 0};
    bat_curve *line = NULL;
    assert_int_equal(bat_surface_eval_grid(s, 2, unsorted, 2, sorted, 0, out), BAT_OK);
    assert_int_equal(bat_surface_eval_grid(s, 2, sorted, 2, unsorted, 0, out), BAT_PARAMETER);
    assert_int_equal(bat_surface_eval_grid(s, 2, bad + 1, 2, sorted, 0, out), BAT_NUMBER);
    assert_int_equal(bat_surface_eval_grid(s, 2, sorted, 2, sorted, 3, out), BAT_ARGUMENT);
    assert_int_equal(bat_surface_eval_grid(s, 0, NULL, 2, sorted, 0, NULL), BAT_OK);
    assert_int_equal(bat_surface_isocurve(s, BAT_U, NAN, &line), BAT_NUMBER);
    bat_surface_eval(s, NAN, 0, 7, out);
    for (int i = 0; i < 18; i++) assert_true(isnan(out[i]));
    bat_surface_eval(s, -1, 2, -1, out); /* clamped */
    assert_true(apart(out, points + 3, 3) == 0);
    bat_surface_free(s);
    bat_surface_free(NULL);
}

/* What is written reads back to the bit. */
static void text_and_back(void **state) {
    (void)state;
    random_source r = {31};
    for (int number = 0; number < MOST; number++) {
        bat_surface *s = some_surface(&r, number), *back = NULL;
        char *text = NULL;
        size_t size = 0;
        assert_int_equal(bat_surface_write(s, &text, &size), BAT_OK);
        assert_int_equal(bat_surface_read(text, size, &back, NULL), BAT_OK);
        assert_true(bat_surface_is_equal(s, back));
        bat_free(text);
        bat_surface_free(s), bat_surface_free(back);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bilinear),
        cmocka_unit_test(paraboloid),
        cmocka_unit_test(ring_around_a_ring),
        cmocka_unit_test(lines_and_grids_are_the_surface),
        cmocka_unit_test(derivatives_are_differences),
        cmocka_unit_test(insertion_keeps_the_shape),
        cmocka_unit_test(motion),
        cmocka_unit_test(where_there_is_no_normal),
        cmocka_unit_test(huge_and_tiny),
        cmocka_unit_test(bad_data),
        cmocka_unit_test(text_and_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
