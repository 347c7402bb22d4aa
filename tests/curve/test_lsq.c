/* The moment form of the normal equations equals the plain sums over basis functions; local polynomials equal
 * evaluation; the penalty equals quadrature; the error pass equals a dense search. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <math.h>
#include <cmocka.h>
#include <batten/refine.h>
#include "curve/lsq.h"

static uint64_t seed = 7;
static double uniform(void) { /* 0..1 */
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) / 9007199254740992.0;
}

enum { COUNT = 12, SAMPLES = 200 };

/* Random knots, one of them double where the degree lets it. */
static bat_curve *random_curve(int p, int dimension, bool closed) {
    double knots[64], points[64];
    const int k = closed ? COUNT + 1 : COUNT + p + 1;
    double t = 3 * uniform();
    for (int i = 0; i < k; i++) {
        knots[i] = t;
        const bool flat = closed ? i == 4 && p > 1 : (i < p || i >= k - p - 1 || (i == p + 2 && p > 1));
        if (!flat) t += 0.2 + uniform();
    }
    for (int i = 0; i < COUNT * dimension; i++) points[i] = 10 * uniform();
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(dimension, p, closed, COUNT, points, closed ? COUNT + 1 : COUNT + p + 1,
                                      knots, &curve),
                     BAT_OK);
    return curve;
}

static void each(void (*check)(const bat_curve *)) {
    for (int p = 1; p <= 7; p++)
        for (int dimension = 2; dimension <= 3; dimension++)
            for (int closed = 0; closed <= 1; closed++) {
                bat_curve *curve = random_curve(p, dimension, closed);
                check(curve);
                bat_curve_free(curve);
            }
}

static void check_assemble(const bat_curve *curve) {
    const int p = curve->degree, m = curve->dimension, n = curve->count;
    double u[SAMPLES], x[SAMPLES * 3], w[SAMPLES];
    double a[COUNT * 8] = {0}, b[COUNT * 3] = {0}, A[COUNT * 8] = {0}, B[COUNT * 3] = {0};
    bat_curve_spread(curve, SAMPLES, u);
    for (int i = 0; i < SAMPLES; i++) {
        w[i] = 0.1 + uniform();
        for (int c = 0; c < m; c++) x[i * m + c] = 100 * uniform();
        int first;
        double N[8];
        bat_curve_basis(curve, u[i], &first, N);
        for (int r = 0; r <= p; r++) {
            const int row = (first + r) % n;
            for (int s = 0; s <= r; s++) A[row * (p + 1) + r - s] += w[i] * N[r] * N[s];
            for (int c = 0; c < m; c++) B[row * m + c] += w[i] * N[r] * x[i * m + c];
        }
    }
    bat_lsq_assemble(curve, m, SAMPLES, u, x, w, a, b);
    for (int i = 0; i < n * (p + 1); i++) assert_true(fabs(a[i] - A[i]) < 1e-10);
    for (int i = 0; i < n * m; i++) assert_true(fabs(b[i] - B[i]) < 1e-8);
    size_t first[64];
    bat_lsq_ranges(curve, SAMPLES, u, first);
    for (int s = 0; s < bat_lsq_slots(curve); s++)
        for (size_t i = first[s]; i < first[s + 1]; i++) assert_int_equal(bat_span(curve, u[i], -1), s + p);
    assert_int_equal(first[bat_lsq_slots(curve)], SAMPLES);
}

static void check_local_and_penalty(const bat_curve *curve) {
    const int p = curve->degree, m = curve->dimension, n = curve->count, slots = bat_lsq_slots(curve);
    double local[64 * 8 * 3];
    bat_lsq_local(curve, m, bat_curve_points(curve), local);
    for (int order = 0; order <= p; order++) {
        /* c^T A c must be the integral of the squared derivative: Gauss-Legendre with 8 nodes is exact. */
        static const double node[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                       0.9602898564975363};
        static const double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                         0.1012285362903763};
        double a[COUNT * 8] = {0}, want = 0, got = 0;
        bat_lsq_penalty(curve, order, 0.5, NULL, a);
        for (int s = 0; s < slots; s++) {
            const double t0 = curve->knots[p + s], t1 = curve->knots[p + s + 1];
            if (!(t1 > t0)) continue;
            for (int q = -4; q < 4; q++) {
                const int j = q < 0 ? -q - 1 : q;
                const double z = q < 0 ? -node[j] : node[j], half = 0.5 * (t1 - t0);
                double d[8 * 3];
                bat_curve_eval(curve, t0 + half * (z + 1), order, d);
                for (int c = 0; c < m; c++) {
                    want += 0.5 * half * weight[j] * d[order * m + c] * d[order * m + c];
                    if (order) continue;
                    double f = 0;
                    for (int k = p; k >= 0; k--) f = f * z + local[(s * (p + 1) + k) * m + c];
                    assert_true(fabs(f - d[c]) < 1e-11);
                }
            }
        }
        const double *P = bat_curve_points(curve);
        for (int i = 0; i < n; i++)
            for (int d = 0; d <= p; d++) {
                const int j = i - d;
                if (j < 0 && !curve->closed) continue;
                for (int c = 0; c < m; c++)
                    got += (d ? 2 : 1) * a[i * (p + 1) + d] * P[i * m + c] * P[(j + n) % n * m + c];
            }
        assert_true(fabs(got - want) <= 1e-9 * want);
    }
}

/* Points set off the curve by a little along the normal come back to their parameters. */
static void check_error(const bat_curve *curve) {
    const int p = curve->degree, m = curve->dimension;
    if (p < 3) return;
    double local[64 * 8 * 3], u[SAMPLES], x[SAMPLES * 3], start[SAMPLES], near[SAMPLES], distance[SAMPLES];
    bat_lsq_local(curve, m, bat_curve_points(curve), local);
    bat_curve_spread(curve, SAMPLES, u);
    for (int i = 0; i < SAMPLES; i++) {
        double d[9];
        bat_curve_eval(curve, u[i], 1, d);
        const double speed = sqrt(d[m] * d[m] + d[m + 1] * d[m + 1]);
        for (int c = 0; c < m; c++) x[i * m + c] = d[c];
        x[i * m] -= 1e-4 * d[m + 1] / speed, x[i * m + 1] += 1e-4 * d[m] / speed;
        start[i] = u[i] + (i > 0 && i < SAMPLES - 1 ? 1e-3 * (uniform() - 0.5) : 0);
    }
    const double worst = bat_lsq_error(curve, m, local, SAMPLES, start, x, 5, near, distance);
    assert_true(sqrt(worst) < 1.0001e-4);
    for (int i = 0; i < SAMPLES; i++) {
        double d[3], r = 0;
        bat_curve_eval(curve, near[i], 0, d);
        for (int c = 0; c < m; c++) r += (d[c] - x[i * m + c]) * (d[c] - x[i * m + c]);
        assert_true(fabs(sqrt(r) - sqrt(distance[i])) < 1e-11);
    }
    /* no steps: plain distance at the given parameters */
    assert_true(bat_lsq_error(curve, m, local, SAMPLES, start, x, 0, NULL, NULL) >= worst);
}

/* Samples near and far, whose steps often lead out of their slots: all of them at once, and each by itself, give the same bits. */
static void check_alone(const bat_curve *curve) {
    const int m = curve->dimension;
    double local[64 * 8 * 3], u[SAMPLES], x[SAMPLES * 3], near[SAMPLES], distance[SAMPLES];
    bat_lsq_local(curve, m, bat_curve_points(curve), local);
    bat_curve_spread(curve, SAMPLES, u);
    for (int i = 0; i < SAMPLES; i++) {
        double d[3];
        bat_curve_eval(curve, u[i], 0, d);
        const double off = i % 3 == 0 ? 1e-3 : i % 3 == 1 ? 1 : 20;
        for (int c = 0; c < m; c++) x[i * m + c] = d[c] + off * (uniform() - 0.5);
    }
    for (int steps = 0; steps < 6; steps++) {
        const double worst = bat_lsq_error(curve, m, local, SAMPLES, u, x, steps, near, distance);
        double most = 0;
        for (int i = 0; i < SAMPLES; i++) {
            double one, far;
            bat_lsq_error(curve, m, local, 1, u + i, x + i * m, steps, &one, &far);
            assert_true(one == near[i] && far == distance[i]);
            most = fmax(most, far);
        }
        assert_true(most == worst);
    }
}

/* An inserted knot is no knot: its rank is rounding, while the others keep theirs. */
static void check_rank(const bat_curve *curve) {
    const int p = curve->degree, m = curve->dimension;
    double local[64 * 8 * 3], rank[64];
    const double at = 0.5 * (curve->knots[p + 3] + curve->knots[p + 4]);
    if (!(curve->knots[p + 4] > curve->knots[p + 3])) return;
    bat_curve *more = NULL;
    assert_int_equal(bat_curve_insert_knot(curve, at, 1, &more), BAT_OK);
    bat_lsq_local(more, m, bat_curve_points(more), local);
    bat_lsq_rank(more, m, local, rank);
    int own = 0;
    for (int s = 0; s <= bat_lsq_slots(more); s++)
        if (more->knots[p + s] == at)
            assert_true(rank[s] < 1e-8), own++;
        else
            assert_true(rank[s] > 1e-3);
    assert_int_equal(own, 1);
    bat_curve_free(more);
}

/* One solve after the other with knots removed and new, same samples and others: the sums are those of a fresh
 * assembly, and so are penalty and local polynomials; plain distances are those of no Newton step. */
static void check_memo(const bat_curve *curve) {
    const int p = curve->degree, m = curve->dimension;
    double u[SAMPLES], x[SAMPLES * 3], w[SAMPLES], *block[2];
    bat_lsq_memo memo[2];
    const size_t size = bat_lsq_memo_size(p, m, 64);
    for (int i = 0; i < 2; i++) {
        assert_non_null(block[i] = malloc(size * sizeof(double)));
        bat_lsq_memo_place(&memo[i], p, m, 64, block[i]);
    }
    bat_curve_spread(curve, SAMPLES, u);
    for (int i = 0; i < SAMPLES; i++) {
        w[i] = 0.1 + uniform();
        for (int c = 0; c < m; c++) x[i * m + c] = 100 * uniform();
    }
    for (int round = 0; round < 6; round++) {
        bat_curve *finer = NULL; /* another knot each time, so that old ones go */
        const double at = curve->knots[p] +
                          (0.1 + 0.15 * round) * (curve->knots[curve->spread] - curve->knots[p]);
        assert_int_equal(bat_curve_insert_knot(curve, at, 1, &finer), BAT_OK);
        const bat_curve *space = round == 3 ? curve : finer;
        if (round == 4)
            for (int i = 0; i < SAMPLES * m; i++) x[i] += 1;
        double a[32 * 8] = {0}, b[32 * 3] = {0}, A[32 * 8] = {0}, B[32 * 3] = {0};
        double local[64 * 24] = {0}, expected[64 * 24] = {0}, distance[SAMPLES], plain[SAMPLES];
        size_t first[64];
        bat_lsq_ranges(space, SAMPLES, u, first);
        bat_lsq_memo_fill(space, m, first, u, x, w, &memo[(round + 1) % 2], round != 4, &memo[round % 2]);
        bat_lsq_memo_add(space, m, &memo[round % 2], a, b);
        bat_lsq_memo_penalty(space, 1, 0.5, NULL, &memo[round % 2], a);
        bat_lsq_memo_local(space, m, &memo[round % 2], bat_curve_points(space), local);
        bat_lsq_assemble(space, m, SAMPLES, u, x, w, A, B);
        bat_lsq_penalty(space, 1, 0.5, NULL, A);
        bat_lsq_local(space, m, bat_curve_points(space), expected);
        for (int i = 0; i < space->count * (p + 1); i++)
            assert_true(fabs(a[i] - A[i]) <= 1e-12 * (1 + fabs(A[i])));
        for (int i = 0; i < space->count * m; i++) assert_true(fabs(b[i] - B[i]) <= 1e-12 * (1 + fabs(B[i])));
        for (int i = 0; i < bat_lsq_slots(space) * (p + 1) * m; i++)
            assert_true(fabs(local[i] - expected[i]) <= 1e-12 * (1 + fabs(expected[i])));
        bat_lsq_plain(space, m, local, first, u, x, plain);
        bat_lsq_error(space, m, local, SAMPLES, u, x, 0, NULL, distance);
        for (int i = 0; i < SAMPLES; i++) assert_true(fabs(plain[i] - distance[i]) <= 1e-9 * (1 + plain[i]));
        bat_curve_free(finer);
    }
    free(block[0]), free(block[1]);
}

static void side_by_side(void **state) {
    (void)state;
    each(check_alone);
}

static void remembers(void **state) {
    (void)state;
    each(check_memo);
}

static void assembles(void **state) {
    (void)state;
    each(check_assemble);
}
static void penalises(void **state) {
    (void)state;
    each(check_local_and_penalty);
}
static void projects(void **state) {
    (void)state;
    each(check_error);
}
static void ranks(void **state) {
    (void)state;
    each(check_rank);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(assembles), cmocka_unit_test(side_by_side),
                                       cmocka_unit_test(remembers), cmocka_unit_test(penalises),
                                       cmocka_unit_test(projects),  cmocka_unit_test(ranks)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
