/* Every change of representation keeps the shape: elevation, pieces, opening, closing, reversal, other intervals;
 * splitting and joining is the identity; joins are as smooth as requested. Over seeded random curves of every kind. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/refine.h>
#include "curve/curve.h"
#include "support/random_curve.h"

enum { CLAMPED, OPEN, CLOSED };
static const double EPS = 4e-13; /* coordinates are up to 10 */

static void elevation(void **state) {
    (void)state;
    random_source r = {11};
    for (int round = 0; round < 400; round++) {
        int degree = random_int(&r, 1, 7), to = random_int(&r, degree, 7);
        bat_curve *curve = random_curve(&r, degree, 2 + round % 2, round % 3, random_int(&r, 0, 9)),
                  *up = NULL;
        assert_int_equal(bat_curve_elevate(curve, to, &up), BAT_OK);
        assert_int_equal(bat_curve_degree(up), to);
        double a[2], b[2];
        bat_curve_domain(curve, a);
        bat_curve_domain(up, b);
        assert_true(a[0] == b[0] && a[1] == b[1]);
        assert_true(curve_gap(curve, up, 1, 0, 100) < EPS);
        /* Every knot gains a copy for every degree: continuity stays what it was. */
        const double *t = bat_curve_knots(curve);
        double middle = t[bat_curve_knot_count(curve) / 2];
        if (middle > a[0] && middle < a[1])
            assert_int_equal(bat_knot_multiplicity(up, middle),
                             bat_knot_multiplicity(curve, middle) + to - degree);
        bat_curve_free(up);
        bat_curve_free(curve);
    }
}

static void pieces(void **state) {
    (void)state;
    random_source r = {12};
    for (int round = 0; round < 600; round++) {
        int degree = random_int(&r, 1, 7), kind = round % 3;
        bat_curve *curve = random_curve(&r, degree, 2 + round % 2, kind, random_int(&r, 0, 9)), *piece = NULL;
        double d[2], e[2];
        bat_curve_domain(curve, d);
        double period = d[1] - d[0], a = random_between(&r, d[0], d[1]), b = random_between(&r, a, d[1]);
        if (kind == CLOSED) {
            a += random_int(&r, -2, 2) * period;
            b = a + random_between(&r, 0.05, 1) * period;
        } else if (round % 5 == 0) {
            a = bat_curve_knots(curve)[bat_span(curve, a, -1)], b = d[1]; /* at a knot, up to the end */
        }
        assert_int_equal(bat_curve_piece(curve, a, b, &piece), BAT_OK);
        bat_curve_domain(piece, e);
        assert_true(e[0] == a && e[1] == b);
        assert_true(curve_gap(piece, curve, 1, 0, 100) < (kind == CLOSED ? 100 : 1) * EPS);
        bat_curve_free(piece);
        bat_curve_free(curve);
    }
}

/* Split then join gives back the curve; what was not at the cut is the same to the bit. */
static void split_and_join(void **state) {
    (void)state;
    random_source r = {13};
    for (int round = 0; round < 300; round++) {
        int degree = random_int(&r, 1, 7), dimension = 2 + round % 2;
        bat_curve *curve = random_curve(&r, degree, dimension, round % 2, random_int(&r, 0, 12));
        bat_curve *left = NULL, *right = NULL, *both = NULL;
        double d[2], moved = -1;
        bat_curve_domain(curve, d);
        double u = random_between(&r, d[0], d[1]);
        if (round % 4 == 0) u = bat_curve_knots(curve)[bat_point_count(curve) / 2];
        if (!(u > d[0] && u < d[1])) u = 0.5 * (d[0] + d[1]);
        assert_int_equal(bat_curve_split(curve, u, &left, &right), BAT_OK);
        assert_int_equal(bat_curve_join(left, right, 0, 1e-12, &both, &moved), BAT_OK);
        assert_true(moved < EPS);
        assert_true(curve_gap(curve, both, 1, 0, 100) < EPS);
        assert_int_equal(bat_knot_multiplicity(both, u), degree);
        if (round % 2 == CLAMPED) {
            int kept = bat_span_left(curve, u, -1) - degree +
                       1; /* points without u in their support's inside */
            assert_memory_equal(bat_curve_points(curve), bat_curve_points(left),
                                (size_t)(kept * dimension) * sizeof(double));
            int tail = bat_point_count(curve) - bat_span(curve, u, -1);
            assert_memory_equal(bat_curve_points(curve) + (bat_point_count(curve) - tail) * dimension,
                                bat_curve_points(right) + (bat_point_count(right) - tail) * dimension,
                                (size_t)(tail * dimension) * sizeof(double));
        }
        bat_curve *thin = NULL;
        int removed;
        double error;
        int had = bat_knot_multiplicity(curve, u);
        assert_int_equal(bat_curve_remove_knot(both, u, degree - had, 1e-9, &thin, &removed, &error), BAT_OK);
        assert_int_equal(removed, degree - had);
        assert_true(error < 1e-9 && curve_gap(curve, thin, 1, 0, 100) < error + EPS);
        bat_curve_free(thin);
        bat_curve_free(both);
        bat_curve_free(left);
        bat_curve_free(right);
        bat_curve_free(curve);
    }
}

/* Pieces of a curve, in a chain, are the curve: one piece, too. */
static void chains(void **state) {
    (void)state;
    random_source r = {43};
    for (int round = 0; round < 200; round++) {
        const int degree = random_int(&r, 1, 5), knots = random_int(&r, 0, 6);
        bat_curve *curve = random_curve(&r, degree, 2 + round % 2, CLAMPED, knots), *parts[5], *all;
        double domain[2];
        bat_curve_domain(curve, domain);
        const int count = 1 + round % 5;
        for (int i = 0; i < count; i++) {
            double ends[2];
            for (int k = 0; k < 2; k++) ends[k] = domain[0] + (domain[1] - domain[0]) * (i + k) / count;
            ends[1] = i + 1 == count ? domain[1] : ends[1];
            assert_int_equal(bat_curve_piece(curve, ends[0], ends[1], &parts[i]), BAT_OK);
        }
        assert_int_equal(bat_curve_chain((size_t)count, (const bat_curve *const *)parts, 1e-9, &all), BAT_OK);
        assert_true(bat_curve_count(all) >= bat_curve_count(curve));
        assert_true(curve_gap(curve, all, 1, 0, 100) < EPS);
        bat_curve_free(all), bat_curve_free(curve);
        for (int i = 0; i < count; i++) bat_curve_free(parts[i]);
    }
}

static void open_close_and_seam(void **state) {
    (void)state;
    random_source r = {14};
    for (int round = 0; round < 300; round++) {
        int degree = random_int(&r, 1, 7);
        bat_curve *curve = random_curve(&r, degree, 2 + round % 2, CLOSED, random_int(&r, 1, 12));
        bat_curve *open = NULL, *closed = NULL, *moved = NULL;
        double d[2];
        bat_curve_domain(curve, d);
        double u = random_between(&r, d[0] - 5, d[1] + 5);
        if (round % 3 == 0) u = bat_curve_knots(curve)[bat_point_count(curve) / 2];
        assert_int_equal(bat_curve_open_at(curve, u, &open), BAT_OK);
        assert_false(bat_curve_is_closed(open));
        assert_true(curve_gap(open, curve, 1, 0, 100) < 100 * EPS);
        assert_int_equal(bat_curve_close(open, 1e-9, &closed), BAT_OK);
        assert_true(bat_curve_is_closed(closed));
        assert_true(curve_gap(closed, curve, 1, 0, 100) < 100 * EPS);
        assert_int_equal(bat_curve_move_seam(curve, u, &moved), BAT_OK);
        double m[2];
        bat_curve_domain(moved, m);
        assert_true(m[0] == bat_curve_reduce(curve, u));
        assert_true(curve_gap(moved, curve, 1, 0, 100) < 100 * EPS);
        bat_curve_free(moved);
        bat_curve_free(closed);
        bat_curve_free(open);
        bat_curve_free(curve);
    }
}

static void reversal_and_other_intervals(void **state) {
    (void)state;
    random_source r = {15};
    for (int round = 0; round < 300; round++) {
        int degree = random_int(&r, 1, 7), extra = random_int(&r, 0, 9);
        bat_curve *curve = random_curve(&r, degree, 2 + round % 2, round % 3, extra);
        bat_curve *back = NULL, *other = NULL;
        double d[2], a = random_between(&r, -1e3, 1e3), b = a + random_between(&r, 1e-3, 1e3), p[3], q[3];
        bat_curve_domain(curve, d);
        assert_int_equal(bat_curve_reverse(curve, &back), BAT_OK);
        for (int i = 0; i <= 50; i++) {
            double u = d[0] + (d[1] - d[0]) * i / 50;
            bat_curve_eval(curve, u, 0, p);
            bat_curve_eval(back, d[0] + (d[1] - u), 0, q);
            for (int c = 0; c < bat_curve_dimension(curve); c++) assert_true(fabs(p[c] - q[c]) < 100 * EPS);
        }
        assert_int_equal(bat_curve_reparametrise(curve, a, b, &other), BAT_OK);
        double e[2], scale = (d[1] - d[0]) / (b - a);
        bat_curve_domain(other, e);
        assert_true(e[0] == a && e[1] == b);
        assert_true(curve_gap(other, curve, scale, d[0] - a * scale, 50) < 1e-9);
        bat_curve_free(other);
        bat_curve_free(back);
        bat_curve_free(curve);
    }
}

/* After a C1 or C2 join the derivatives agree across the joint, and the joint's knot is that much simpler. */
static void smooth_joins(void **state) {
    (void)state;
    random_source r = {16};
    for (int round = 0; round < 200; round++) {
        int p = random_int(&r, 1, 6), q = random_int(&r, 1, 6), k = 1 + round % 2, degree = p > q ? p : q;
        if (degree <= k) degree = k + 1;
        bat_curve *a = random_curve(&r, p, 2, round % 3 == 0, random_int(&r, 0, 6)), *b = NULL,
                  *joined = NULL;
        bat_curve *other = random_curve(&r, q, 2, CLAMPED, random_int(&r, 0, 6));
        double d[2], end[2], start[2], moved = -1, left[6], right[6];
        bat_curve_domain(a, d);
        bat_curve_eval(a, d[1], 0, end);
        double first[2];
        bat_curve_domain(other, first);
        bat_curve_eval(other, first[0], 0, start);
        const double shift[] = {1, 0, end[0] - start[0] + 0.25, 0, 1, end[1] - start[1]};
        assert_int_equal(bat_curve_transform(other, shift, &b), BAT_OK);
        assert_int_equal(bat_curve_join(a, b, k, 0.1, &joined, &moved), BAT_ARGUMENT);
        assert_null(joined);
        assert_int_equal(bat_curve_join(a, b, k, 0.26, &joined, &moved), BAT_OK);
        assert_int_equal(bat_curve_degree(joined), degree);
        assert_true(bat_knot_multiplicity(joined, d[1]) <= degree - k);
        bat_curve_eval_left(joined, d[1], k, left);
        bat_curve_eval(joined, d[1], k, right);
        for (int i = 0; i < 2 * (k + 1); i++)
            assert_true(fabs(left[i] - right[i]) <= 1e-7 * (1 + fabs(left[i]) + fabs(right[i])));
        /* moved bounds how far a's part went */
        double worst = 0;
        for (int i = 0; i <= 50; i++) {
            double u = d[0] + (d[1] - d[0]) * i / 50, x[2], y[2];
            bat_curve_eval(a, u, 0, x);
            bat_curve_eval(joined, u, 0, y);
            worst = fmax(worst, hypot(x[0] - y[0], x[1] - y[1]));
        }
        assert_true(moved >= 0.125 - 1e-12 || k > 0);
        assert_true(worst <= moved + 1e-10);
        bat_curve_free(joined);
        bat_curve_free(b);
        bat_curve_free(other);
        bat_curve_free(a);
    }
}

/* The bound of a removal is a bound, on open and closed curves, and the result has the knot less. */
static void removal_is_bounded(void **state) {
    (void)state;
    random_source r = {17};
    int gone = 0;
    for (int round = 0; round < 600; round++) {
        int degree = random_int(&r, 1, 7), kind = round % 3;
        bat_curve *curve = random_curve(&r, degree, 2 + round % 2, kind, random_int(&r, 1, 14)), *less = NULL;
        const double *t = bat_curve_knots(curve);
        double u = t[random_int(&r, 0, bat_curve_knot_count(curve) - 1)], d[2], error = -1;
        bat_curve_domain(curve, d);
        if (u < d[0] || u > d[1]) u = 0.5 * (d[0] + d[1]);
        int before = bat_knot_multiplicity(curve, u), removed = -1;
        assert_int_equal(bat_curve_remove_knot(curve, u, 2, 1e6, &less, &removed, &error), BAT_OK);
        assert_int_equal(bat_curve_count(less), bat_point_count(curve) - removed);
        if (removed > 0) assert_int_equal(bat_knot_multiplicity(less, u), before - removed);
        assert_true(curve_gap(curve, less, 1, 0, 200) <= error + EPS);
        gone += removed;
        bat_curve_free(less);
        bat_curve_free(curve);
    }
    assert_true(gone > 300);
}

/* What was inserted can be removed for nothing, also at the seam, and everything else keeps its bits' worth.
 */
static void insertion_is_undone(void **state) {
    (void)state;
    random_source r = {18};
    for (int round = 0; round < 400; round++) {
        int degree = random_int(&r, 1, 7), kind = round % 3;
        bat_curve *curve = random_curve(&r, degree, 2, kind, random_int(&r, 6, 14)), *more = NULL,
                  *back = NULL;
        double d[2], error;
        bat_curve_domain(curve, d);
        double u = random_between(&r, d[0], d[1]);
        int n = random_int(&r, 1, degree), removed;
        assert_int_equal(bat_curve_insert_knot(curve, u, n, &more), BAT_OK);
        assert_int_equal(bat_curve_remove_knot(more, u, n, 1e-8, &back, &removed, &error), BAT_OK);
        assert_int_equal(removed, n);
        assert_int_equal(bat_curve_count(back), bat_point_count(curve));
        assert_true(error < 1e-9);
        assert_true(curve_gap(curve, back, 1, 0, 100) < error + EPS);
        bat_curve_free(back);
        bat_curve_free(more);
        bat_curve_free(curve);
    }
}

/* Simplification stays within its tolerance, its report is a bound, and all inserted knots go. */
static void simplification(void **state) {
    (void)state;
    random_source r = {19};
    for (int round = 0; round < 150; round++) {
        int degree = random_int(&r, 1, 5), kind = round % 3, count = 0;
        bat_curve *curve = random_curve(&r, degree, 2, kind, random_int(&r, 8, 14)), *more = NULL,
                  *less = NULL;
        double d[2], u[60], error = -1;
        bat_curve_domain(curve, d);
        for (; count < 60; count++) u[count] = d[0] + (d[1] - d[0]) * (count + 0.37) / 60;
        assert_int_equal(bat_curve_insert_knots(curve, count, u, &more), BAT_OK);
        assert_int_equal(bat_curve_simplify(more, 1e-9, 0.01, &less, &error), BAT_OK);
        assert_true(bat_point_count(less) <= bat_point_count(curve));
        assert_true(error <= 1e-9 && curve_gap(curve, less, 1, 0, 300) <= error + EPS);
        bat_curve_free(less);
        less = NULL;
        double tolerance = random_between(&r, 0.01, 3);
        assert_int_equal(bat_curve_simplify(more, tolerance, 4, &less, &error), BAT_OK);
        assert_true(error <= tolerance && curve_gap(more, less, 1, 0, 300) <= error + EPS);
        bat_curve_free(less);
        bat_curve_free(more);
        bat_curve_free(curve);
    }
}

/* However large the tolerance, a corner of the curve stays, to the bit; everything else may go. */
static void corners_stay(void **state) {
    (void)state;
    const double knots[] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1.5, 2, 2, 2, 2};
    const double points[] = {0, 0, 1, 2, 2, -1, 3, 1, 4, 4, 4, 5, 4, 7, 5, 8, 4, 9};
    bat_curve *curve = NULL, *less = NULL;
    double error, p[2];
    assert_int_equal(bat_curve_create(2, 3, false, 9, points, 13, knots, &curve), BAT_OK);
    assert_int_equal(bat_curve_simplify(curve, 1e3, 0.1, &less, &error), BAT_OK);
    assert_int_equal(bat_curve_count(less), 7);
    assert_int_equal(bat_knot_multiplicity(less, 1), 3);
    bat_curve_eval(less, 1, 0, p);
    assert_true(p[0] == 4 && p[1] == 4);
    bat_curve_free(less);
    assert_int_equal(bat_curve_simplify(curve, 1e3, 4, &less, &error), BAT_OK);
    assert_int_equal(bat_curve_count(less), 4);
    bat_curve_free(less);
    bat_curve_free(curve);
}

/* Statuses of the surgery; outputs stay as they were. */
static void bad_arguments(void **state) {
    (void)state;
    random_source r = {20};
    bat_curve *open = random_curve(&r, 3, 2, OPEN, 5), *closed = random_curve(&r, 3, 2, CLOSED, 5);
    bat_curve *space = random_curve(&r, 3, 3, OPEN, 5), *mark = open, *out = mark, *second = mark;
    double d[2], error;
    int removed;
    bat_curve_domain(open, d);
    assert_int_equal(bat_curve_insert_knot(open, d[0] - 1, 1, &out), BAT_PARAMETER);
    assert_int_equal(bat_curve_insert_knot(open, 0.5 * (d[0] + d[1]), -1, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_insert_knot(open, 0.5 * (d[0] + d[1]), 4, &out), BAT_KNOTS);
    const double falling[] = {d[1], d[0]};
    assert_int_equal(bat_curve_insert_knots(open, 2, falling, &out), BAT_PARAMETER);
    assert_int_equal(bat_curve_insert_knots(open, 2147483647, falling, &out), BAT_COUNT);
    assert_int_equal(bat_curve_insert_knots(open, -1, falling, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_refine(open, 2, falling, &out), BAT_KNOTS);
    assert_int_equal(bat_curve_remove_knot(open, d[1] + 1, 1, 0, &out, &removed, &error), BAT_PARAMETER);
    assert_int_equal(bat_curve_remove_knot(open, d[1], 1, -1, &out, &removed, &error), BAT_ARGUMENT);
    assert_int_equal(bat_curve_remove_knot(open, NAN, 1, 0, &out, &removed, &error), BAT_NUMBER);
    assert_int_equal(bat_curve_simplify(open, NAN, 0, &out, &error), BAT_ARGUMENT);
    assert_int_equal(bat_curve_elevate(open, 2, &out), BAT_DEGREE);
    assert_int_equal(bat_curve_elevate(open, 8, &out), BAT_DEGREE);
    assert_int_equal(bat_curve_clamp(closed, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_split(closed, 0.5, &out, &second), BAT_ARGUMENT);
    assert_int_equal(bat_curve_split(open, d[0], &out, &second), BAT_PARAMETER);
    assert_int_equal(bat_curve_split(open, NAN, &out, &second), BAT_NUMBER);
    assert_int_equal(bat_curve_piece(open, d[0], d[0], &out), BAT_PARAMETER);
    assert_int_equal(bat_curve_piece(open, d[0], d[1] + 1, &out), BAT_PARAMETER);
    assert_int_equal(bat_curve_piece(closed, 0, 1e9, &out), BAT_PARAMETER);
    assert_int_equal(bat_curve_piece(closed, NAN, 1, &out), BAT_NUMBER);
    assert_int_equal(bat_curve_open_at(open, 0, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_open_at(closed, INFINITY, &out), BAT_NUMBER);
    assert_int_equal(bat_curve_move_seam(open, 0, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_close(closed, 0, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_close(open, 1e-9, &out), BAT_ARGUMENT);
    assert_int_equal(bat_curve_reparametrise(open, 1, 1, &out), BAT_PARAMETER);
    assert_int_equal(bat_curve_reparametrise(open, 0, INFINITY, &out), BAT_NUMBER);
    assert_int_equal(bat_curve_join(open, closed, 0, 1e9, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_join(open, space, 0, 1e9, &out, NULL), BAT_DIMENSION);
    assert_int_equal(bat_curve_join(open, open, 3, 1e9, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_join(open, open, 0, NAN, &out, NULL), BAT_ARGUMENT);
    assert_ptr_equal(out, mark);
    assert_ptr_equal(second, mark);
    bat_curve_free(open), bat_curve_free(closed), bat_curve_free(space);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(elevation),           cmocka_unit_test(pieces),
        cmocka_unit_test(split_and_join),      cmocka_unit_test(chains),
        cmocka_unit_test(open_close_and_seam), cmocka_unit_test(reversal_and_other_intervals),
        cmocka_unit_test(smooth_joins),        cmocka_unit_test(removal_is_bounded),
        cmocka_unit_test(insertion_is_undone), cmocka_unit_test(simplification),
        cmocka_unit_test(corners_stay),        cmocka_unit_test(bad_arguments)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
