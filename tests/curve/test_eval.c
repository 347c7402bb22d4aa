/* Evaluation: closed forms, properties of the basis and the blossom, derivatives against differences, bulk calls
 * against single ones, parameters outside the domain, knots of any magnitude. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/refine.h>
#include "curve/curve.h"
#include "support/random_curve.h"

/* The blossom of u^k, k <= p: the mean of the products of k of the p arguments. */
static double monomial_blossom(const double *x, int p, int k) {
    double e[8] = {1}, binomial = 1;
    for (int i = 0; i < p; i++)
        for (int j = k; j >= 1; j--) e[j] += e[j - 1] * x[i];
    for (int j = 0; j < k; j++) binomial = binomial * (p - j) / (j + 1);
    return e[k] / binomial;
}

/* Control points from the blossom of x = u^p, y = 1 - u + u^(p/2): the curve is that polynomial on every knot
 * vector, and so are its derivatives. Oracle: the closed form. */
static void polynomials_are_reproduced(void **state) {
    (void)state;
    random_source r = {31};
    for (int round = 0; round < 200; round++) {
        int p = random_int(&r, 1, 7), k = p / 2;
        bat_curve *shape = random_curve(&r, p, 2, round % 2, random_int(&r, 0, 9)), *scaled = NULL,
                  *curve = NULL;
        assert_int_equal(bat_curve_reparametrise(shape, -1, 1, &scaled), BAT_OK);
        int n = bat_point_count(scaled);
        const double *t = bat_curve_knots(scaled);
        double points[64];
        for (int i = 0; i < n; i++) {
            points[2 * i] = monomial_blossom(t + i + 1, p, p);
            points[2 * i + 1] = 1 - monomial_blossom(t + i + 1, p, 1) + monomial_blossom(t + i + 1, p, k);
        }
        assert_int_equal(bat_curve_create(2, p, false, (size_t)n, points, n + p + 1, t, &curve), BAT_OK);
        for (int i = 0; i <= 40; i++) {
            double u = -1 + i / 20.0, out[2 * 9];
            bat_curve_eval(curve, u, 8, out);
            double x = pow(u, p), y = 1 - u + pow(u, k);
            assert_true(fabs(out[0] - x) < 1e-13 && fabs(out[1] - y) < 1e-13);
            double dx = p * pow(u, p - 1), dy = -1 + (k > 0 ? k * pow(u, k - 1) : 0);
            assert_true(fabs(out[2] - dx) < 1e-11 && fabs(out[3] - dy) < 1e-11);
            double ddx = p < 2 ? 0 : p * (p - 1) * pow(u, p - 2);
            assert_true(fabs(out[4] - ddx) < 1e-8);
            for (int order = p + 1; order <= 8; order++)
                assert_true(out[2 * order] == 0 && out[2 * order + 1] == 0);
        }
        bat_curve_free(curve);
        bat_curve_free(scaled);
        bat_curve_free(shape);
    }
}

/* Basis: non-negative, sums to one, gives the curve; its derivatives sum to zero and give the curve's. */
static void basis_functions(void **state) {
    (void)state;
    random_source r = {32};
    for (int round = 0; round < 300; round++) {
        int p = random_int(&r, 1, 7), n;
        bat_curve *curve = random_curve(&r, p, 2, round % 3, random_int(&r, 0, 9));
        double d[2], values[8], x[2], all[64], greville[32];
        bat_curve_domain(curve, d);
        n = bat_point_count(curve);
        double u = random_between(&r, d[0], d[1]);
        int first = -1;
        bat_curve_basis(curve, u, &first, values);
        bat_curve_eval(curve, u, 0, x);
        double sum = 0, px = 0, py = 0;
        for (int j = 0; j <= p; j++) {
            const double *point = bat_curve_points(curve) + 2 * ((first + j) % n);
            assert_true(values[j] >= 0);
            sum += values[j], px += values[j] * point[0], py += values[j] * point[1];
        }
        assert_true(fabs(sum - 1) < 1e-14 && fabs(px - x[0]) < 1e-13 && fabs(py - x[1]) < 1e-13);
        int span = bat_span(curve, u, -1);
        double h = curve->knots[span + 1] - curve->knots[span];
        bat_basis(curve, span, u, 2, all);
        double out[6];
        bat_curve_eval_span(curve, span, u, 2, out);
        for (int k = 1; k <= 2; k++) {
            double total = 0, dx = 0;
            for (int j = 0; j <= p; j++) {
                total += all[k * (p + 1) + j];
                dx += all[k * (p + 1) + j] * curve->points[2 * (span - p + j)];
            }
            assert_true(fabs(total) < 1e-12 * pow(1 / h, k) + 1e-12);
            assert_true(fabs(dx - out[2 * k]) < 1e-11 * pow(1 / h, k) + 1e-11);
        }
        bat_curve_greville(curve, greville);
        for (int i = 0; i < n; i++) {
            const double *t = bat_curve_knots(curve);
            double mean = 0;
            for (int j = 1; j <= p; j++) mean += t[i + j] / p; /* the next period follows in memory */
            assert_true(fabs(mean - greville[i]) < 1e-13);
        }
        bat_curve_free(curve);
    }
}

/* Derivatives against central differences of the order below. */
static void derivatives(void **state) {
    (void)state;
    random_source r = {33};
    for (int round = 0; round < 200; round++) {
        int p = random_int(&r, 1, 7), size = 2 + round % 2;
        bat_curve *curve = random_curve(&r, p, size, round % 3, random_int(&r, 0, 9));
        double d[2], low[24], high[24], at[24];
        bat_curve_domain(curve, d);
        int span = bat_span(curve, random_between(&r, d[0], d[1]), -1);
        double a = curve->knots[span], b = curve->knots[span + 1],
               u = a + random_between(&r, 0.2, 0.8) * (b - a);
        double h = 1e-5 * (b - a);
        bat_curve_eval(curve, u - h, p, low);
        bat_curve_eval(curve, u + h, p, high);
        bat_curve_eval(curve, u, p, at);
        for (int k = 1; k <= p; k++)
            for (int c = 0; c < size; c++) {
                double want = (high[(k - 1) * size + c] - low[(k - 1) * size + c]) / (2 * h), scale = 0;
                for (int i = 0; i <= p; i++) scale = fmax(scale, fabs(at[i * size + c]) * pow(b - a, i));
                assert_true(fabs(at[k * size + c] - want) < 1e-7 * (scale + 100) * pow(b - a, -k));
            }
        bat_curve_free(curve);
    }
}

/* Diagonal is the curve; symmetric; affine in each argument; control points are blossoms at consecutive
 * knots. */
static void blossoms(void **state) {
    (void)state;
    random_source r = {34};
    for (int round = 0; round < 300; round++) {
        int p = random_int(&r, 1, 7), size = 2 + round % 2;
        bat_curve *curve = random_curve(&r, p, size, round % 3, random_int(&r, 0, 9));
        double d[2], x[7], y[7], z[7], a[3], b[3], c[3];
        bat_curve_domain(curve, d);
        int span = bat_span(curve, random_between(&r, d[0], d[1]), -1);
        double low = curve->knots[span], h = curve->knots[span + 1] - low, u = low + h / 2;
        for (int i = 0; i < p; i++) x[i] = u;
        bat_curve_blossom(curve, u, x, false, a);
        bat_curve_eval(curve, u, 0, b);
        for (int i = 0; i < size; i++) assert_true(fabs(a[i] - b[i]) < 1e-12);
        for (int i = 0; i < p; i++) x[i] = random_between(&r, low - 0.2 * h, low + 1.2 * h);
        for (int i = 0; i < p; i++) y[i] = x[p - 1 - i];
        bat_curve_blossom(curve, u, x, round % 2, a);
        bat_curve_blossom(curve, u, y, round % 2, b);
        assert_memory_equal(a, b, (size_t)size * sizeof(double)); /* to the bit */
        int k = random_int(&r, 0, p - 1);
        memcpy(y, x, sizeof x), memcpy(z, x, sizeof x);
        y[k] = low, z[k] = low + h, x[k] = low + 0.25 * h;
        bat_curve_blossom(curve, u, x, false, a);
        bat_curve_blossom(curve, u, y, false, b);
        bat_curve_blossom(curve, u, z, false, c);
        for (int i = 0; i < size; i++) assert_true(fabs(a[i] - (0.75 * b[i] + 0.25 * c[i])) < 1e-10);
        for (int j = 0; j <= p; j++) {
            bat_curve_blossom_span(curve, span, curve->knots + span - p + j + 1, a);
            for (int i = 0; i < size; i++)
                assert_true(fabs(a[i] - curve->points[(span - p + j) * size + i]) < 1e-12);
        }
        bat_curve_free(curve);
    }
}

/* Bulk agrees with single within 1e-14 of the size for positions, over all degrees, kinds and orders, also
 * outside the domain and across the seam. */
static void bulk_is_single(void **state) {
    (void)state;
    random_source r = {35};
    enum { COUNT = 400 };
    static double u[COUNT], out[COUNT * 4 * 3];
    for (int round = 0; round < 300; round++) {
        int p = random_int(&r, 1, 7), size = 2 + round % 2, order = random_int(&r, 0, 3);
        bat_curve *curve = random_curve(&r, p, size, round % 3, random_int(&r, 0, 12));
        double d[2], one[12], extent = bat_curve_size(curve) + 10;
        bat_curve_domain(curve, d);
        double over = round % 4 == 0 ? 1.5 : 0;
        for (int i = 0; i < COUNT; i++) u[i] = d[0] - over + (d[1] - d[0] + 2 * over) * i / (COUNT - 1);
        if (over == 0) u[COUNT - 1] = d[1];
        for (int i = 100; i < 110; i++) u[i] = u[100];
        const double *t = bat_curve_knots(curve);
        double knot = t[bat_curve_knot_count(curve) / 2];
        for (int i = 1; i < COUNT; i++) /* a knot itself is among them */
            if (u[i - 1] < knot && u[i] > knot) u[i] = knot;
        assert_int_equal(bat_curve_eval_many(curve, COUNT, u, order, out), BAT_OK);
        for (int i = 0; i < COUNT; i++) {
            bat_curve_eval(curve, u[i], order, one);
            int span = bat_span(curve, bat_curve_reduce(curve, u[i]), -1);
            double h = curve->knots[span + 1] - curve->knots[span];
            for (int k = 0; k <= order; k++)
                for (int c = 0; c < size; c++)
                    assert_true(fabs(out[(i * (order + 1) + k) * size + c] - one[k * size + c]) <=
                                (k == 0 ? 1e-14 : 1e-12 * pow(h, -k)) * extent);
        }
        bat_curve_free(curve);
    }
}

/* Many knots in [0, 1], and domains of 1e-12 and 1e12, and a curve far from the origin: nothing snaps. */
static void no_knot_tolerance(void **state) {
    (void)state;
    enum { N = 100000 };
    double *knots = malloc((N + 4) * sizeof(double)), *points = malloc(2 * N * sizeof(double));
    double *u = malloc(N * sizeof(double)), *out = malloc(2 * N * sizeof(double));
    const double scales[] = {1, 1e-12, 1e12};
    for (int s = 0; s < 3; s++) {
        for (int i = 0; i < N + 4; i++)
            knots[i] = scales[s] * (i < 4 ? 0 : i >= N ? 1 : (double)(i - 3) / (N - 3));
        bat_curve *curve = NULL, *more = NULL;
        for (int i = 0; i < N; i++) { /* x = u / scale: linear precision by Greville abscissae */
            points[2 * i] = ((knots[i + 1] + knots[i + 2]) + knots[i + 3]) / 3 / scales[s];
            points[2 * i + 1] = i % 2;
        }
        assert_int_equal(bat_curve_create(2, 3, false, N, points, N + 4, knots, &curve), BAT_OK);
        bat_curve_spread(curve, N, u);
        assert_int_equal(bat_curve_eval_many(curve, N, u, 0, out), BAT_OK);
        for (int i = 0; i < N; i++) {
            double one[2];
            bat_curve_eval(curve, u[i], 0, one);
            assert_true(fabs(out[2 * i] - u[i] / scales[s]) < 1e-15 * 4);
            assert_true(fabs(out[2 * i] - one[0]) < 1e-15 * 4 && fabs(out[2 * i + 1] - one[1]) < 1e-14);
        }
        double near = nextafter(knots[5000], 2 * knots[5000]);
        assert_int_equal(bat_curve_insert_knot(curve, near, 3, &more), BAT_OK);
        assert_int_equal(bat_knot_multiplicity(more, near), 3);
        assert_int_equal(bat_knot_multiplicity(more, knots[5000]), 1);
        bat_curve_free(more);
        bat_curve_free(curve);
    }
    free(knots), free(points), free(u), free(out);
}

/* Every bad input has its status; outputs stay as they were. */
static void validation(void **state) {
    (void)state;
    const double good[] = {0, 0, 0, 0, 1, 2, 2, 2, 2}, ring[] = {0, 1, 2, 3};
    double points[15] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4};
    bat_curve *mark = (bat_curve *)(void *)points, *out = mark;
    const struct {
        int degree, dimension, closed, count;
        double knots[9];
        bat_status want;
    } table[] = {
        {0, 3, 0, 5, {0, 0, 0, 0, 1, 2, 2, 2, 2}, BAT_DEGREE},
        {8, 3, 0, 5, {0, 0, 0, 0, 1, 2, 2, 2, 2}, BAT_DEGREE},
        {-1, 3, 0, 5, {0, 0, 0, 0, 1, 2, 2, 2, 2}, BAT_DEGREE},
        {3, 1, 0, 5, {0, 0, 0, 0, 1, 2, 2, 2, 2}, BAT_DIMENSION},
        {3, 4, 0, 5, {0, 0, 0, 0, 1, 2, 2, 2, 2}, BAT_DIMENSION},
        {3, 3, 0, 3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, BAT_COUNT},
        {3, 3, 0, -5, {0, 0, 0, 0, 1, 2, 2, 2, 2}, BAT_COUNT},
        {3, 3, 0, 2147483647, {0, 0, 0, 0, 1, 2, 2, 2, 2}, BAT_COUNT},
        {3, 3, 1, 1, {0, 1}, BAT_COUNT},
        {3, 3, 0, 5, {0, 0, 0, 0, 1, 2, 2, 2, 1.9}, BAT_KNOTS},
        {3, 3, 0, 5, {0, 0, 0, 0, NAN, 2, 2, 2, 2}, BAT_NUMBER},
        {3, 3, 0, 5, {0, 0, 0, 0, 1, 2, 2, 2, INFINITY}, BAT_NUMBER},
        {3, 3, 0, 5, {0, 0, 0, 0, 1, 2, 2, 2, 1e31}, BAT_NUMBER},
        {3, 3, 0, 5, {0, 0, 0, 0, 1e-31, 2, 2, 2, 2}, BAT_NUMBER},
        {3, 3, 0, 5, {0, 0, 0, 0, 0, 2, 2, 2, 2}, BAT_KNOTS},
        {3, 3, 0, 5, {0, 0, 0, 0, 2, 2, 2, 2, 2}, BAT_KNOTS},
        {3, 3, 0, 5, {1, 1, 1, 1, 1, 1, 1, 1, 1}, BAT_KNOTS},
        {1, 3, 0, 5, {0, 0, 1, 1, 2, 3, 3}, BAT_KNOTS},
        {3, 3, 1, 3, {0, 0, 0, 0}, BAT_KNOTS},
        {2, 3, 1, 3, {0, 0, 0, 1}, BAT_KNOTS},
        {2, 3, 1, 4, {0, 0, 1, 2, 2}, BAT_KNOTS},
        {3, 3, 1, 3, {0, 2, 1, 3}, BAT_KNOTS},
    };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++) {
        assert_int_equal(
            bat_curve_create(
                table[i].dimension, table[i].degree, table[i].closed, (size_t)table[i].count, points,
                (int)((unsigned)table[i].count + (table[i].closed ? 1 : (unsigned)table[i].degree + 1)),
                table[i].knots, &out),
            table[i].want);
        assert_ptr_equal(out, mark);
    }
    const size_t many[] = {BAT_POINTS_MAX + (size_t)1, SIZE_MAX, SIZE_MAX / 2 + 5,
                           sizeof(size_t) > 4 ? (size_t)0x100000005 : SIZE_MAX};
    for (int i = 0; i < 4; i++) { /* none of them is five when it is cut short */
        assert_int_equal(bat_curve_create(3, 3, false, many[i], points, 9, good, &out), BAT_COUNT);
        assert_int_equal(bat_curve_create(3, 3, true, many[i], points, 6, good, &out), BAT_COUNT);
        assert_int_equal(bat_curve_create_clamped(3, 3, many[i], points, &out), BAT_COUNT);
        assert_ptr_equal(out, mark);
    }
    for (int given = -1; given < 20; given++) { /* one knot too few, too many, or those of a closed curve */
        if (given == 9) continue;
        assert_int_equal(bat_curve_create(3, 3, false, 5, points, given, good, &out), BAT_KNOTS);
        assert_ptr_equal(out, mark);
    }
    assert_int_equal(bat_curve_create(3, 3, false, 5, points, 9, NULL, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_create(3, 3, false, 5, NULL, 9, good, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_create(3, 3, false, 5, points, 9, good, NULL), BAT_ARGUMENT);
    const double bad[] = {NAN, INFINITY, -INFINITY, 1.1e75};
    for (int i = 0; i < 4; i++) {
        points[7] = bad[i];
        assert_int_equal(bat_curve_create(3, 3, false, 5, points, 9, good, &out), BAT_NUMBER);
        assert_ptr_equal(out, mark);
    }
    points[7] = 1e75; /* the limit itself is fine, and nothing overflows */
    assert_int_equal(bat_curve_create(3, 3, false, 5, points, 9, good, &out), BAT_OK);
    double x[24], u[3] = {0, 0.5, 1.5}, matrix[12] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0};
    for (int i = 0; i <= 20; i++) {
        bat_curve_eval(out, i / 10.0, 3, x);
        for (int k = 0; k < 12; k++) assert_true(isfinite(x[k]));
    }
    bat_curve *other = mark;
    assert_int_equal(bat_curve_transform(out, matrix, &other), BAT_NUMBER);
    assert_int_equal(bat_curve_to_dimension(out, 4, &other), BAT_DIMENSION);
    bat_curve_eval(out, NAN, 1, x);
    for (int k = 0; k < 6; k++) assert_true(isnan(x[k]));
    x[0] = 77;
    u[1] = NAN;
    assert_int_equal(bat_curve_eval_many(out, 3, u, 0, x), BAT_NUMBER);
    u[1] = 2;
    assert_int_equal(bat_curve_eval_many(out, 3, u, 0, x), BAT_PARAMETER);
    assert_int_equal(bat_curve_eval_many(out, 3, u, -1, x), BAT_ARGUMENT);
    assert_int_equal(bat_curve_eval_many(out, 3, NULL, 0, x), BAT_ARGUMENT);
    assert_int_equal(bat_curve_eval_many(out, 0, NULL, 0, NULL), BAT_OK);
    assert_true(x[0] == 77 && other == mark);
    bat_curve_free(out);
    assert_int_equal(bat_curve_create(3, 3, true, 3, points, 4, ring, &out), BAT_OK);
    for (int i = -40; i < 40; i++) { /* far over the ends, and at infinity: no endless loop, no crash */
        double far = ldexp(1.1, 25 * i);
        bat_curve_eval(out, i % 2 ? far : -far, 0, x);
        assert_true(isfinite(x[0]));
    }
    bat_curve_eval(out, INFINITY, 0, x);
    assert_true(isnan(x[0]));
    bat_curve_free(out);
    bat_curve_free(NULL);
}

/* An affine image of the points is the affine image of the curve. */
static void affine_invariance(void **state) {
    (void)state;
    random_source r = {36};
    for (int round = 0; round < 100; round++) {
        int degree = random_int(&r, 1, 7), extra = random_int(&r, 0, 9);
        bat_curve *curve = random_curve(&r, degree, 3, round % 3, extra), *image = NULL;
        double m[12], d[2], a[3], b[3];
        for (int i = 0; i < 12; i++) m[i] = random_between(&r, -2, 2);
        assert_int_equal(bat_curve_transform(curve, m, &image), BAT_OK);
        bat_curve_domain(curve, d);
        for (int i = 0; i <= 20; i++) {
            double u = d[0] + (d[1] - d[0]) * i / 20;
            bat_curve_eval(curve, u, 0, a);
            bat_curve_eval(image, u, 0, b);
            for (int c = 0; c < 3; c++)
                assert_true(fabs(b[c] - (m[4 * c] * a[0] + m[4 * c + 1] * a[1] + m[4 * c + 2] * a[2] +
                                         m[4 * c + 3])) < 1e-12);
        }
        bat_curve *flat = NULL, *again = NULL, *copy = NULL;
        assert_int_equal(bat_curve_to_dimension(curve, 2, &flat), BAT_OK);
        assert_int_equal(bat_curve_to_dimension(flat, 3, &again), BAT_OK);
        bat_curve_eval(curve, d[0], 0, a);
        bat_curve_eval(again, d[0], 0, b);
        assert_true(a[0] == b[0] && a[1] == b[1] && b[2] == 0);
        assert_int_equal(bat_curve_copy(curve, &copy), BAT_OK);
        assert_true(bat_curve_is_equal(copy, curve) && !bat_curve_is_equal(curve, again));
        bat_curve_free(copy), bat_curve_free(flat), bat_curve_free(again);
        bat_curve_free(image), bat_curve_free(curve);
    }
}

/* Against the knots written out, of every degree; the ends are the first and the last point. */
static void clamped(void **state) {
    (void)state;
    for (int p = 1; p <= BAT_DEGREE_MAX; p++)
        for (int n = p + 1; n <= p + 6; n++) {
            double knots[32], points[3 * 16], at[3];
            for (int i = 0; i <= n + p; i++) knots[i] = fmin(fmax(i - p, 0), n - p);
            for (int i = 0; i < 3 * n; i++) points[i] = cos(i * 1.7) * 100;
            bat_curve *expected, *curve;
            assert_int_equal(bat_curve_create(3, p, false, (size_t)n, points, n + p + 1, knots, &expected),
                             BAT_OK);
            assert_int_equal(bat_curve_create_clamped(3, p, (size_t)n, points, &curve), BAT_OK);
            assert_true(bat_curve_is_equal(curve, expected));
            bat_curve_eval(curve, 0, 0, at);
            assert_memory_equal(at, points, sizeof at);
            bat_curve_eval(curve, n - p, 0, at);
            assert_memory_equal(at, points + 3 * (n - 1), sizeof at);
            bat_curve_free(curve), bat_curve_free(expected);
        }
    const double some[] = {0, 0, 1, 1, 2, NAN};
    bat_curve *mark = (bat_curve *)(void *)&some, *out = mark;
    assert_int_equal(bat_curve_create_clamped(2, 2, 2, some, &out), BAT_COUNT);
    assert_int_equal(bat_curve_create_clamped(2, 2, 3, some, &out), BAT_NUMBER);
    assert_int_equal(bat_curve_create_clamped(2, 8, 3, some, &out), BAT_DEGREE);
    assert_int_equal(bat_curve_create_clamped(4, 1, 3, some, &out), BAT_DIMENSION);
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, NULL, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, some, NULL), BAT_ARGUMENT);
    assert_ptr_equal(out, mark);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(polynomials_are_reproduced),
                                       cmocka_unit_test(basis_functions),
                                       cmocka_unit_test(derivatives),
                                       cmocka_unit_test(blossoms),
                                       cmocka_unit_test(bulk_is_single),
                                       cmocka_unit_test(no_knot_tolerance),
                                       cmocka_unit_test(validation),
                                       cmocka_unit_test(clamped),
                                       cmocka_unit_test(affine_invariance)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
