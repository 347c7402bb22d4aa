/*
 * The levels hand: closed forms of nodes, exact decomposition, rigid motion and mirror images, locality including the
 * bookkeeping of twist, edit and revert, over seeded random curves in the plane and in space, open and closed.
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
#include <batten/refine.h>

#include "curve/curve.h"
#include "hands/levels/shape.h"
#include "support/shapes.h"

static uint64_t seed;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) / 9007199254740992.0;
}

static bat_curve *random_curve(int degree, int dimension, bool closed, int count) {
    double points[400], knots[200], t = 0;
    int total = closed ? count + 1 : count + degree + 1;
    for (int i = 0; i < count; i++) {
        points[i * dimension] = closed ? 200 * cos(6.2831853 * i / count) : 60.0 * i;
        points[i * dimension + 1] = closed ? 200 * sin(6.2831853 * i / count) : 0;
        if (dimension == 3) points[i * dimension + 2] = 0;
        for (int d = 0; d < dimension; d++) points[i * dimension + d] += uniform(-50, 50);
    }
    for (int i = 0; i < total; i++) {
        knots[i] = t;
        if (closed || (i >= degree && i < count)) t += uniform(0.5, 2);
    }
    bat_curve *curve;
    assert_int_equal(bat_curve_create(dimension, degree, closed, (size_t)count, points, total, knots, &curve),
                     BAT_OK);
    return curve;
}

/* A base with three levels, details random. */
static bat_shape *random_shape(int round, bat_frame_rule rule, bat_propagation propagation) {
    bool closed = (round / 2) % 2;
    bat_curve *base = random_curve(3, 2 + round % 2, closed, 8 + round % 5);
    bat_shape_options options = bat_shape_defaults();
    options.frame = rule, options.propagation = propagation;
    options.nodes = (bat_node_rule)((round / 4) % 2);
    bat_shape *shape;
    assert_int_equal(bat_shape_create(base, &options, &shape), BAT_OK);
    bat_curve_free(base);
    for (int j = 1; j <= 3; j++) {
        double details[600];
        for (int i = 0; i < 600; i++) details[i] = uniform(-8, 8) / j;
        bat_curve *finer;
        const bat_curve *below = shape_finest(shape);
        double middle[200];
        const double *t = bat_curve_knots(below);
        int n = 0, p = 3, spans = closed ? bat_point_count(below) : bat_point_count(below) - p;
        for (int i = 0; i < spans; i++) {
            int k = closed ? i : i + p;
            middle[n++] = t[k] + (t[k + 1] - t[k]) / 2;
        }
        assert_int_equal(bat_curve_insert_knots(below, n, middle, &finer), BAT_OK);
        assert_int_equal(
            bat_shape_add_level(shape, bat_curve_knot_count(finer), bat_curve_knots(finer), details, NULL),
            BAT_OK);
        bat_curve_free(finer);
    }
    return shape;
}

static double worst_over(const bat_curve *a, const bat_curve *b, double from, double to) {
    double worst = 0;
    int n = bat_curve_dimension(a);
    for (int i = 0; i <= 400; i++) {
        double x[3], y[3], u = from + (to - from) * i / 400;
        bat_curve_eval(a, u, 0, x);
        bat_curve_eval(b, u, 0, y);
        for (int d = 0; d < n; d++) worst = fmax(worst, fabs(x[d] - y[d]));
    }
    return worst;
}
static double worst_between(const bat_curve *a, const bat_curve *b) {
    double domain[2];
    bat_curve_domain(a, domain);
    return worst_over(a, b, domain[0], domain[1]);
}

static void node_rules(void **state) {
    (void)state;
    double knots[12] = {0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5}, points[16] = {0}, nodes[8];
    bat_curve *curve;
    assert_int_equal(bat_curve_create(2, 3, false, 8, points, 12, knots, &curve), BAT_OK);
    assert_int_equal(bat_nodes(curve, BAT_NODES_ARGMAX, nodes), BAT_OK);
    assert_true(nodes[0] == 0 && nodes[7] == 5);
    assert_true(fabs(nodes[1] - (6 - 2 * sqrt(2)) / 7) < 1e-12);
    assert_true(fabs(nodes[2] - 1.10819) < 1e-5);
    assert_true(fabs(nodes[3] - 2) < 1e-7 && fabs(nodes[6] - (5 - nodes[1])) < 1e-12);
    bat_curve_free(curve);
}

static void decomposition_is_exact(void **state) {
    (void)state;
    seed = 1;
    for (int round = 0; round < 120; round++) {
        int degree = 1 + round % 7;
        bat_curve *curve = random_curve(degree, 2 + round % 2, (round / 2) % 2, 40 + round % 30);
        bat_shape *shape;
        bat_shape_options options = bat_shape_defaults();
        options.frame = (bat_frame_rule)(round % 3);
        assert_int_equal(bat_shape_decompose(curve, 3, &options, &shape), BAT_OK);
        assert_int_equal(bat_shape_levels(shape), 3);
        assert_true(worst_between(curve, shape_finest(shape)) < 1e-12 * bat_curve_size(curve));
        assert_int_equal(bat_curve_knot_count(curve), bat_curve_knot_count(shape_finest(shape)));
        assert_true(bat_point_count(bat_shape_curve(shape, 0)) < bat_point_count(curve) / 4 + degree + 1);
        bat_shape_free(shape);
        bat_shape *none = NULL;
        assert_int_equal(bat_shape_decompose(curve, 20, NULL, &none), BAT_COUNT);
        assert_null(none);
        bat_curve_free(curve);
    }
}

/* Least squares reproduces what is already coarse: the details of a refined coarse curve vanish. */
static void coarse_curves_have_no_detail(void **state) {
    (void)state;
    seed = 2;
    for (int round = 0; round < 20; round++) {
        bat_curve *coarse = random_curve(3, 3, false, 12), *fine;
        const double *t = bat_curve_knots(coarse);
        double middle[9];
        for (int i = 0; i < 9; i++) middle[i] = (t[i + 3] + t[i + 4]) / 2;
        assert_int_equal(bat_curve_insert_knots(coarse, 9, middle, &fine), BAT_OK);
        bat_shape *shape;
        assert_int_equal(bat_shape_decompose(fine, 1, NULL, &shape), BAT_OK);
        for (int i = 0; i < 3 * bat_point_count(fine); i++)
            assert_true(fabs(bat_shape_details(shape, 1)[i]) < 1e-10);
        bat_shape_free(shape);
        bat_curve_free(coarse);
        bat_curve_free(fine);
    }
}

/* Rigid motions, scalings and mirror images carry the finest curve along. */
static void transforms(void **state) {
    (void)state;
    seed = 3;
    for (int round = 0; round < 48; round++) {
        bat_shape *shape = random_shape(round, (bat_frame_rule)(round % 3), BAT_PROPAGATION_LOCAL);
        int n = bat_curve_dimension(shape_finest(shape));
        double m[12] = {0}, a = uniform(0, 6), b = uniform(0, 6), scale = uniform(0.5, 2),
               side = round % 5 ? 1 : -1;
        if (n == 2) {
            const double rows[6] = {cos(a), -side * sin(a), 7, sin(a), side * cos(a), -3};
            for (int i = 0; i < 6; i++) m[i] = rows[i] * (i % 3 < 2 ? scale : 1);
        } else {
            const double rows[12] = {cos(a), -sin(a) * cos(b), side * sin(a) * sin(b),  7,
                                     sin(a), cos(a) * cos(b),  -side * cos(a) * sin(b), -3,
                                     0,      sin(b),           side * cos(b),           11};
            for (int i = 0; i < 12; i++) m[i] = rows[i] * (i % 4 < 3 ? scale : 1);
        }
        bat_curve *expected;
        assert_int_equal(bat_curve_transform(shape_finest(shape), m, &expected), BAT_OK);
        assert_int_equal(bat_shape_transform(shape, m), BAT_OK);
        assert_true(worst_between(expected, shape_finest(shape)) < 1e-12 * bat_curve_size(expected));
        bat_curve_free(expected);
        bat_shape_free(shape);
    }
}

/* Dragging a point of C^j moves it by exactly that; the shape outside what is touched stays, also in space.
 */
static void drags_are_exact_and_local(void **state) {
    (void)state;
    seed = 4;
    for (int round = 0; round < 80; round++) {
        bat_shape *shape = random_shape(round, BAT_FRAMES_RMF, BAT_PROPAGATION_LOCAL), *before;
        assert_int_equal(bat_shape_copy(shape, &before), BAT_OK);
        int level = 2 + round / 4 % 2, n = bat_curve_dimension(shape_finest(shape)); /* four spans and more */
        double domain[2], delta[3] = {uniform(-40, 40), uniform(-40, 40), uniform(-40, 40)}, x[3], y[3];
        bat_curve_domain(shape_finest(shape), domain);
        double length = domain[1] - domain[0], u = domain[0] + uniform(0.3, 0.5) * length;
        bat_curve_eval(bat_shape_curve(shape, level), u, 0, x);
        assert_int_equal(bat_shape_drag(shape, level, u, delta), BAT_OK);
        bat_curve_eval(bat_shape_curve(shape, level), u, 0, y);
        double size = bat_curve_size(shape_finest(before));
        for (int d = 0; d < n; d++) assert_true(fabs(y[d] - x[d] - delta[d]) < 1e-12 * size);
        /* Nine knots of the base and their finer relatives are the most that moves. */
        const bat_curve *base = bat_shape_curve(before, 0);
        const double *t = bat_curve_knots(base);
        int count = bat_point_count(base), first;
        double values[4];
        bat_curve_basis(base, u, &first, values);
        if (!bat_curve_is_closed(base)) {
            int low = first - 4, high = first + 12;
            if (low > 3)
                assert_true(worst_over(shape_finest(before), shape_finest(shape), domain[0], t[low]) <
                            1e-12 * size);
            if (high < count)
                assert_true(worst_over(shape_finest(before), shape_finest(shape), t[high], domain[1]) <
                            1e-12 * size);
        }
        for (int d = 0; d < 3; d++) delta[d] = -delta[d];
        assert_int_equal(bat_shape_drag(shape, level, u, delta), BAT_OK);
        assert_true(worst_between(shape_finest(before), shape_finest(shape)) < 1e-12 * size);
        bat_shape_free(shape);
        bat_shape_free(before);
    }
}

/* In space, plain propagation spins what lies downstream of an edit; bookkeeping leaves it where it is. */
static void twist_bookkeeping(void **state) {
    (void)state;
    seed = 5;
    int spun = 0;
    for (int round = 0; round < 20; round++) {
        bat_curve *base = random_curve(3, 3, round % 2, 24);
        double details[300];
        for (int i = 0; i < 300; i++) details[i] = uniform(-10, 10);
        for (int mode = 0; mode < 2; mode++) {
            bat_shape_options options = bat_shape_defaults();
            options.propagation = (bat_propagation)mode;
            bat_shape *shape, *before;
            assert_int_equal(bat_shape_create(base, &options, &shape), BAT_OK);
            assert_int_equal(
                bat_shape_add_level(shape, bat_curve_knot_count(base), bat_curve_knots(base), details, NULL),
                BAT_OK);
            assert_int_equal(bat_shape_copy(shape, &before), BAT_OK);
            double delta[3] = {30, -40, 50};
            assert_int_equal(bat_shape_move(shape, 0, 8, delta), BAT_OK);
            const double *t = bat_curve_knots(base);
            double moved = worst_over(shape_finest(before), shape_finest(shape), t[17], t[20]);
            if (mode == 0)
                assert_true(moved < 1e-12 * bat_curve_size(base));
            else
                spun += moved > 0.1;
            bat_shape_free(shape);
            bat_shape_free(before);
        }
        bat_curve_free(base);
    }
    assert_true(spun >= 15);
}

static void gains(void **state) {
    (void)state;
    seed = 6;
    bat_shape *shape = random_shape(3, BAT_FRAMES_RMF, BAT_PROPAGATION_LOCAL), *before;
    assert_int_equal(bat_shape_copy(shape, &before), BAT_OK);
    assert_int_equal(bat_shape_set_gain(shape, 3, 0), BAT_OK);
    assert_true(worst_between(bat_shape_curve(shape, 2), shape_finest(shape)) <
                1e-12 * bat_curve_size(shape_finest(shape)));
    double delta[3] = {1, 1, 1};
    assert_int_equal(bat_shape_drag(shape, 3, 1, delta), BAT_STATE);
    assert_int_equal(bat_shape_set_gain(shape, 3, 1), BAT_OK);
    assert_true(bat_curve_is_equal(shape_finest(before), shape_finest(shape)));
    assert_int_equal(bat_shape_set_gain(shape, 3, NAN), BAT_NUMBER);
    assert_int_equal(bat_shape_set_gain(shape, 0, 1), BAT_ARGUMENT);
    bat_shape_free(shape);
    bat_shape_free(before);
}

static void finest_point_follows(void **state) {
    (void)state;
    seed = 7;
    for (int round = 0; round < 24; round++) {
        bat_shape *shape = random_shape(round, BAT_FRAMES_RMF, BAT_PROPAGATION_LOCAL);
        double domain[2], x[3], y[3], delta[3] = {12, -7, 9}, left;
        bat_curve_domain(shape_finest(shape), domain);
        double u = domain[0] + 0.4 * (domain[1] - domain[0]);
        bat_curve_eval(shape_finest(shape), u, 0, x);
        bat_status status = bat_shape_drag_finest(shape, round % 3, u, delta, 1e-6, &left);
        assert_int_equal(status, BAT_OK);
        bat_curve_eval(shape_finest(shape), u, 0, y);
        for (int d = 0; d < bat_curve_dimension(shape_finest(shape)); d++)
            assert_true(fabs(y[d] - x[d] - delta[d]) < 1e-5);
        bat_shape_free(shape);
    }
}

static void sketch_at_a_level(void **state) {
    (void)state;
    seed = 8;
    for (int round = 0; round < 24; round++) {
        bat_shape *shape = random_shape(round, BAT_FRAMES_RMF, BAT_PROPAGATION_LOCAL), *before;
        assert_int_equal(bat_shape_copy(shape, &before), BAT_OK);
        int level = 2 + round / 4 % 2, n = bat_curve_dimension(shape_finest(shape)); /* four spans and more */
        const bat_curve *curve = bat_shape_curve(before, level);
        double domain[2], u[120], targets[360], worst = 0;
        bat_curve_domain(curve, domain);
        double a = domain[0] + 0.4 * (domain[1] - domain[0]), b = domain[0] + 0.6 * (domain[1] - domain[0]);
        for (int i = 0; i < 120; i++) {
            double x[3];
            u[i] = a + (b - a) * i / 119;
            bat_curve_eval(curve, u[i], 0, x);
            for (int d = 0; d < n; d++) targets[i * n + d] = x[d] + (d == 1 ? 6 * sin(3.14159 * i / 119) : 0);
        }
        assert_int_equal(bat_shape_sketch(shape, level, 120, u, targets), BAT_OK);
        for (int i = 0; i < 120; i++) {
            double x[3];
            bat_curve_eval(bat_shape_curve(shape, level), u[i], 0, x);
            for (int d = 0; d < n; d++) worst = fmax(worst, fabs(x[d] - targets[i * n + d]));
        }
        assert_true(worst < 1.5);
        /* Coefficients whose support misses the stroke are bitwise as they were. */
        if (level > 0) {
            const double *t = bat_curve_knots(curve);
            for (int i = 0; i < bat_point_count(curve) && !bat_curve_is_closed(curve); i++)
                if (t[i + 4] <= a || t[i] >= b)
                    for (int d = 0; d < 3; d++)
                        assert_true(bat_shape_details(shape, level)[3 * i + d] ==
                                    bat_shape_details(before, level)[3 * i + d]);
        }
        bat_shape_free(shape);
        bat_shape_free(before);
    }
}

/* Turning the start about keeps the curve when the persistent pair is taken anew. */
static void rebase_moves_nothing(void **state) {
    (void)state;
    seed = 9;
    for (int round = 0; round < 10; round++) {
        bat_shape *shape = random_shape(1 + 2 * (round % 4), BAT_FRAMES_RMF, BAT_PROPAGATION_LOCAL), *before;
        double delta[3] = {150, 10, 5};
        assert_int_equal(bat_shape_move(shape, 0, 0, delta), BAT_OK);
        assert_int_equal(bat_shape_copy(shape, &before), BAT_OK);
        assert_int_equal(bat_shape_commit(shape), BAT_OK);
        assert_true(worst_between(shape_finest(before), shape_finest(shape)) <
                    1e-12 * bat_curve_size(shape_finest(before)));
        bat_shape_free(shape);
        bat_shape_free(before);
    }
}

static void bad_arguments(void **state) {
    (void)state;
    seed = 10;
    bat_curve *base = random_curve(3, 2, false, 8), *other = random_curve(3, 2, false, 8);
    bat_shape *shape;
    assert_int_equal(bat_shape_create(base, NULL, &shape), BAT_OK);
    assert_int_equal(
        bat_shape_add_level(shape, bat_curve_knot_count(other), bat_curve_knots(other), NULL, NULL),
        BAT_KNOTS);
    double nan[2] = {NAN, 0}, delta[2] = {1, 1};
    assert_int_equal(bat_shape_move(shape, 0, 0, nan), BAT_NUMBER);
    assert_int_equal(bat_shape_move(shape, 1, 0, delta), BAT_ARGUMENT);
    assert_int_equal(bat_shape_move(shape, 0, 8, delta), BAT_ARGUMENT);
    assert_int_equal(bat_shape_drag(shape, 0, NAN, delta), BAT_NUMBER);
    double zero[6] = {0};
    assert_int_equal(bat_shape_transform(shape, zero), BAT_SINGULAR);
    assert_true(bat_curve_is_equal(base, shape_finest(shape)));
    bat_shape_free(shape);
    bat_curve_free(base);
    bat_curve_free(other);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(node_rules),
        cmocka_unit_test(decomposition_is_exact),
        cmocka_unit_test(coarse_curves_have_no_detail),
        cmocka_unit_test(transforms),
        cmocka_unit_test(drags_are_exact_and_local),
        cmocka_unit_test(twist_bookkeeping),
        cmocka_unit_test(gains),
        cmocka_unit_test(finest_point_follows),
        cmocka_unit_test(sketch_at_a_level),
        cmocka_unit_test(rebase_moves_nothing),
        cmocka_unit_test(bad_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
