/*
 * Levels against independent computation over random knots, including multiple ones: nodes and least-norm weights by
 * the Cox-de Boor recursion in extended precision, sketching at a level by dense elimination.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/levels.h>

#include "curve/curve.h"
#include "hands/levels/shape.h"

static uint64_t seed;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) / 9007199254740992.0;
}

/* Knots of one width or many, some double where the degree allows it. */
static bat_curve *random_curve(int round, int degree, int dimension, bool closed, int count) {
    double points[120], knots[60], t = uniform(-5, 5);
    int total = closed ? count + 1 : count + degree + 1;
    for (int i = 0; i < count * dimension; i++) points[i] = 50.0 * (i / dimension) + uniform(-60, 60);
    for (int i = 0; i < total; i++) {
        knots[i] = t;
        bool twice = degree > 2 && round % 3 == 0 && uniform(0, 1) < 0.2 && i > degree && i < count - 2 &&
                     knots[i - 1] < t;
        if ((closed || (i >= degree && i < count)) && !twice) t += round % 2 ? 1 : uniform(0.01, 3);
    }
    bat_curve *curve;
    assert_int_equal(bat_curve_create(dimension, degree, closed, (size_t)count, points, total, knots, &curve),
                     BAT_OK);
    return curve;
}

/* Knot i of the unrolled line. */
static long double knot(const bat_curve *curve, int i) {
    const double *t = bat_curve_knots(curve);
    int n = bat_point_count(curve), turns = 0;
    if (!bat_curve_is_closed(curve)) return t[i];
    while (i < 0) i += n, turns--;
    while (i >= n) i -= n, turns++;
    return (long double)t[i] + turns * ((long double)t[n] - t[0]);
}

/* N_i of a degree at u, from the right. */
static long double basis(const bat_curve *curve, int i, int degree, long double u) {
    if (degree == 0) return knot(curve, i) <= u && u < knot(curve, i + 1);
    long double a = knot(curve, i + degree) - knot(curve, i),
                b = knot(curve, i + degree + 1) - knot(curve, i + 1), sum = 0;
    if (a > 0) sum += (u - knot(curve, i)) / a * basis(curve, i, degree - 1, u);
    if (b > 0) sum += (knot(curve, i + degree + 1) - u) / b * basis(curve, i + 1, degree - 1, u);
    return sum;
}

static long double slope(const bat_curve *curve, int i, long double u) {
    int p = bat_curve_degree(curve);
    long double a = knot(curve, i + p) - knot(curve, i), b = knot(curve, i + p + 1) - knot(curve, i + 1);
    return (a > 0 ? p / a * basis(curve, i, p - 1, u) : 0) -
           (b > 0 ? p / b * basis(curve, i + 1, p - 1, u) : 0);
}

/* Greville abscissae are means; N_i rises just before its argmax and falls just behind it, or the domain ends there. */
static void nodes(void **state) {
    (void)state;
    seed = 41;
    for (int round = 0; round < 140; round++) {
        int p = 1 + round % 7;
        bat_curve *curve = random_curve(round, p, 2, round % 4 > 1, 9 + round % 9);
        double domain[2], out[40];
        bat_curve_domain(curve, domain);
        double period = domain[1] - domain[0], near = 1e-12 * period;
        for (int rule = 0; rule < 2; rule++) {
            assert_int_equal(bat_nodes(curve, (bat_node_rule)rule, out), BAT_OK);
            for (int i = 0; i < bat_point_count(curve); i++) {
                assert_true(out[i] >= domain[0] && out[i] <= domain[1]);
                long double mean = 0, low = knot(curve, i), high = knot(curve, i + p + 1), u = out[i];
                if (rule == BAT_NODES_GREVILLE) {
                    for (int k = 1; k <= p; k++) mean += knot(curve, i + k) / p;
                    long double miss = mean - u;
                    if (bat_curve_is_closed(curve)) miss = remainderl(miss, period);
                    assert_true(fabsl(miss) < near);
                    continue;
                }
                if (bat_curve_is_closed(curve)) /* the turn in which the support lies */
                    while (u < low) u += period;
                else
                    low = fmaxl(low, domain[0]), high = fminl(high, domain[1]);
                assert_true(u >= low - near && u <= high + near);
                assert_true(u - near <= low || slope(curve, i, u - near) > 0);
                assert_true(u + near >= high || slope(curve, i, u + near) < 0);
            }
        }
        bat_curve_free(curve);
    }
}

/* A drag changes each control point by N_i / sum N^2 of it, at any level. */
static void least_norm_weights(void **state) {
    (void)state;
    seed = 42;
    for (int round = 0; round < 84; round++) {
        int p = 1 + round % 7, size = 2 + round % 2;
        bat_curve *base = random_curve(round, p, size, round % 4 > 1, 16);
        bat_shape *shape, *after;
        assert_int_equal(bat_shape_create(base, NULL, &shape), BAT_OK);
        assert_int_equal(bat_shape_add_level(shape, 0, NULL, NULL, NULL), BAT_OK);
        int level = round / 4 % 2;
        const bat_curve *curve = bat_shape_curve(shape, level);
        double domain[2], delta[3] = {uniform(-30, 30), uniform(-30, 30), uniform(-30, 30)};
        bat_curve_domain(curve, domain);
        double u = uniform(domain[0], domain[1]);
        assert_int_equal(bat_shape_copy(shape, &after), BAT_OK);
        assert_int_equal(bat_shape_drag(after, level, u, delta), BAT_OK);
        long double weight[60], square = 0;
        int n = bat_point_count(curve);
        for (int i = 0; i < n; i++) {
            long double v = u;
            if (bat_curve_is_closed(curve))
                while (v < knot(curve, i)) v += domain[1] - domain[0];
            weight[i] = basis(curve, i, p, v);
            square += weight[i] * weight[i];
        }
        for (int i = 0; i < n; i++)
            for (int d = 0; d < size; d++) {
                double moved = bat_curve_points(bat_shape_curve(after, level))[i * size + d] -
                               bat_curve_points(curve)[i * size + d];
                assert_true(fabs(moved - (double)(weight[i] / square) * delta[d]) <
                            1e-12 * bat_curve_size(curve));
            }
        bat_shape_free(after);
        bat_shape_free(shape);
        bat_curve_free(base);
    }
}

/* Gauss with pivots; b is the solution. */
static void eliminate(int n, long double *a, long double *b, int columns) {
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            if (fabsl(a[i * n + k]) > fabsl(a[best * n + k])) best = i;
        for (int j = 0; j < n + columns; j++) {
            long double *x = j < n ? &a[k * n + j] : &b[k * columns + j - n],
                        *y = j < n ? &a[best * n + j] : &b[best * columns + j - n], kept = *x;
            *x = *y, *y = kept;
        }
        for (int i = 0; i < n; i++) {
            long double f = i == k ? 0 : a[i * n + k] / a[k * n + k];
            for (int j = k; j < n && f != 0; j++) a[i * n + j] -= f * a[k * n + j];
            for (int j = 0; j < columns && f != 0; j++) b[i * columns + j] -= f * b[k * columns + j];
        }
    }
    for (int i = 0; i < n * columns; i++) b[i] /= a[i / columns * n + i / columns];
}

/* The system of a sketch in extended precision, of the control points that the stroke meets. */
enum { SAMPLES = 50, MOST = 60 };
typedef struct dense {
    const bat_curve *curve;
    int n, size, met, place[MOST]; /* place: among those met, or -1 */
    long double a[MOST * MOST], b[3 * MOST];
} dense;

static void basis_row(const bat_curve *curve, double u, long double *row) {
    for (int i = 0; i < bat_point_count(curve); i++) {
        long double v = u, from = knot(curve, i);
        if (bat_curve_is_closed(curve)) {
            long double width = knot(curve, bat_point_count(curve)) - knot(curve, 0);
            while (v < from) v += width;
            while (v - width >= from) v -= width;
        }
        row[i] = basis(curve, i, bat_curve_degree(curve), v);
    }
}

static void add_row(dense *m, const long double *row, long double weight) {
    for (int i = 0; i < m->n; i++)
        for (int j = 0; j < m->n && m->place[i] >= 0; j++)
            if (m->place[j] >= 0) m->a[m->place[i] * m->met + m->place[j]] += weight * row[i] * row[j];
}

/* Spans from a to b (closed: forwards, over the seam where b < a). */
static double spans_between(const bat_curve *curve, double a, double b) {
    int n = bat_point_count(curve), p = bat_curve_degree(curve);
    bool closed = bat_curve_is_closed(curve);
    double spans = 0;
    if (closed && b < a) b += (double)(knot(curve, n) - knot(curve, 0));
    for (int i = closed ? 0 : p; i < (closed ? 2 * n : n); i++) {
        long double t0 = knot(curve, i), t1 = knot(curve, i + 1);
        if (t1 > t0) spans += (double)(fmaxl(fminl(b, t1) - fmaxl(a, t0), 0) / (t1 - t0));
    }
    return spans;
}

/* The parameter `away` spans from u, before it (sign -1) or behind it. */
static double walk(const bat_curve *curve, double u, double sign, double away) {
    double domain[2], middle;
    bat_curve_domain(curve, domain);
    double low = 0, high = 1; /* of the way to the end of the domain, or once round */
    double all = bat_curve_is_closed(curve) ? domain[1] - domain[0]
                 : sign < 0                 ? u - domain[0]
                                            : domain[1] - u;
    for (int k = 0; k < 200 && high - low > 0; k++) {
        middle = (low + high) / 2;
        double spans = 0, to = all * middle;
        for (int i = -3 * bat_point_count(curve); i < 3 * bat_point_count(curve); i++) {
            if (!bat_curve_is_closed(curve) && (i < bat_curve_degree(curve) || i >= bat_point_count(curve)))
                continue;
            long double t0 = knot(curve, i), t1 = knot(curve, i + 1), a = sign < 0 ? u - to : u,
                        b = sign < 0 ? u : u + to;
            if (t1 > t0) spans += (double)(fmaxl(fminl(b, t1) - fmaxl(a, t0), 0) / (t1 - t0));
        }
        if (middle <= low || middle >= high) break;
        if (spans < away)
            low = middle;
        else
            high = middle;
    }
    return u + sign * all * high;
}

/* Rows of no displacement over `length` spans from the stroke's end u on. */
static void add_still(dense *m, double u, double sign, double length, double density, double firmness) {
    long double row[MOST];
    int p = bat_curve_degree(m->curve);
    length = fmin(length, p + 1);
    if (!(length > 0)) return;
    int rows = (int)fmax(8, ceil(16 * length));
    for (int k = 1; k <= rows; k++) {
        double away = length * k / rows, at = walk(m->curve, u, sign, away), domain[2];
        bat_curve_domain(m->curve, domain);
        if (bat_curve_is_closed(m->curve)) /* into the domain */
            at -= floor((at - domain[0]) / (domain[1] - domain[0])) * (domain[1] - domain[0]);
        if (!bat_curve_is_closed(m->curve)) at = fmin(fmax(at, domain[0]), nextafter(domain[1], domain[0]));
        basis_row(m->curve, at, row);
        double weight = away < 1 ? away : 1 + 999 * fmin(away - 1, 1);
        add_row(m, row, (long double)(firmness * weight * density * length / rows));
    }
}

/* (N'N + Z'WZ + mu I + nu D2'D2) D = N'(Q - C), of the control points that the stroke meets; Z are rows of no
 * displacement beyond its ends, W their weights, all times the least power of four that keeps the bars. */
static void sketch_solves_the_normal_equations(void **state) {
    (void)state;
    seed = 43;
    int plain = 0;
    for (int round = 0; round < 28; round++) {
        int p = 1 + round % 7, size = 2 + round % 2;
        bool closed = round % 4 > 1;
        bat_curve *base = random_curve(round, p, size, closed, 16);
        bat_shape *shape, *after;
        assert_int_equal(bat_shape_create(base, NULL, &shape), BAT_OK);
        assert_int_equal(bat_shape_add_level(shape, 0, NULL, NULL, NULL), BAT_OK);
        int level = round / 4 % 2;
        const bat_curve *curve = bat_shape_curve(shape, level);
        double domain[2], u[SAMPLES], q[3 * SAMPLES], x[3];
        long double row[SAMPLES][MOST];
        bat_curve_domain(curve, domain);
        double from = uniform(0, closed ? 0.9 : 0.5), width = domain[1] - domain[0];
        static dense whole, m;
        whole = (dense){.curve = curve, .n = bat_point_count(curve), .size = size};
        for (int k = 0; k < SAMPLES; k++) { /* loops: perhaps around the seam */
            double w = from + 0.3 * k / (SAMPLES - 1);
            u[k] = domain[0] + width * (w - floor(w));
            bat_curve_eval(curve, u[k], 0, x);
            for (int d = 0; d < size; d++) q[k * size + d] = x[d] + uniform(-9, 9);
            basis_row(curve, u[k], row[k]);
        }
        for (int i = 0; i < whole.n; i++) {
            bool meets = false;
            for (int k = 0; k < SAMPLES; k++) meets = meets || row[k][i] > 0;
            whole.place[i] = meets ? whole.met++ : -1;
        }
        for (int k = 0; k < SAMPLES; k++) {
            bat_curve_eval(curve, u[k], 0, x);
            add_row(&whole, row[k], 1);
            for (int i = 0; i < whole.n; i++)
                for (int d = 0; d < size && whole.place[i] >= 0; d++)
                    whole.b[whole.place[i] * size + d] += row[k][i] * ((long double)q[k * size + d] - x[d]);
        }
        for (int i = 0; i < whole.met; i++) whole.a[i * whole.met + i] += 1e-6L;
        const long double second[3] = {1, -2, 1};
        for (int i = 0; i < (closed ? whole.n : whole.n - 2); i++) {
            memset(row[0], 0, sizeof row[0]);
            for (int r = 0; r < 3; r++) row[0][(i + r) % whole.n] += second[r];
            add_row(&whole, row[0], 1e-3L);
        }
        double covered = spans_between(curve, u[0], u[SAMPLES - 1]), density = SAMPLES / fmax(covered, 1),
               ends[2];
        ends[0] = spans_between(curve, domain[0], u[0]),
        ends[1] = spans_between(curve, u[SAMPLES - 1], domain[1]);
        if (closed) ends[0] = ends[1] = (spans_between(curve, domain[0], domain[1]) - covered) / 2;
        assert_int_equal(bat_shape_copy(shape, &after), BAT_OK);
        assert_int_equal(bat_shape_sketch(after, level, SAMPLES, u, q), BAT_OK);
        double best = INFINITY;
        for (int power = 0; power < 8 && best > 1e-10; power++) {
            double worst = 0, firmness = pow(4, power);
            m = whole;
            add_still(&m, u[0], -1, ends[0], density, firmness);
            add_still(&m, u[SAMPLES - 1], 1, ends[1], density, firmness);
            eliminate(m.met, m.a, m.b, size);
            for (int i = 0; i < m.n; i++)
                for (int d = 0; d < size; d++) {
                    double moved = bat_curve_points(bat_shape_curve(after, level))[i * size + d] -
                                   bat_curve_points(curve)[i * size + d];
                    double expected = m.place[i] < 0 ? 0 : (double)m.b[m.place[i] * size + d];
                    worst = fmax(worst, fabs(moved - expected) / bat_curve_size(curve));
                }
            best = worst;
            plain += power == 0 && best <= 1e-10;
        }
        assert_true(best <= 1e-10);
        bat_shape_free(after);
        bat_shape_free(shape);
        bat_curve_free(base);
    }
    assert_true(plain > 14); /* most need no more than the rows as they are */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes),
        cmocka_unit_test(least_norm_weights),
        cmocka_unit_test(sketch_solves_the_normal_equations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
