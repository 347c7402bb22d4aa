/* Drags under constraints: the place arrives, what is held stays to 1e-9 of the size, at every level, in the plane and in space; the move is the
 * least there is; what cannot be leaves the shape as it was. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <cmocka.h>
#include <batten/drag.h>
#include <batten/levels.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { POINTS = 26 };
static const double TURN = 6.283185307179586, NEAR = 1e-9;

/* A rough ring of about `size`, or in space a rough open arc. */
static bat_shape *rough(random_source *r, bool closed, int dimension, double size, int levels) {
    double points[POINTS * 3], knots[POINTS + 4];
    bat_curve *curve = NULL;
    bat_shape *shape = NULL;
    for (int i = 0; i < POINTS; i++) {
        const double w = TURN * i / POINTS * (closed ? 1 : 0.7), far = size * (0.5 + 0.02 * random_unit(r));
        double *p = points + i * dimension;
        p[0] = far * cos(w), p[1] = 0.7 * far * sin(w);
        if (dimension == 3) p[2] = size * (0.3 * sin(2 * w) + 0.01 * random_unit(r));
    }
    for (int i = 0; i <= POINTS; i++) knots[i] = i;
    if (closed)
        assert_int_equal(bat_curve_create(dimension, 3, true, POINTS, points, POINTS + 1, knots, &curve),
                         BAT_OK);
    else
        assert_int_equal(bat_curve_create_clamped(dimension, 3, POINTS, points, &curve), BAT_OK);
    assert_int_equal(levels ? bat_shape_decompose_to(curve, levels, 7, NULL, &shape)
                            : bat_shape_create(curve, NULL, &shape),
                     BAT_OK);
    bat_curve_free(curve);
    return shape;
}

static const bat_curve *finest(const bat_shape *shape) {
    return bat_shape_curve(shape, bat_shape_levels(shape));
}

static double whole(const bat_curve *curve) {
    double domain[2];
    bat_curve_domain(curve, domain);
    return bat_curve_length(curve, domain[0], domain[1], 1e-13);
}

static double apart(const bat_curve *a, const bat_curve *b, double u, const double *delta) {
    double p[3] = {0}, q[3] = {0}, sum = 0;
    bat_curve_eval(a, u, 0, p), bat_curve_eval(b, u, 0, q);
    for (int d = 0; d < bat_curve_dimension(a); d++) sum = hypot(sum, q[d] - p[d] - (delta ? delta[d] : 0));
    return sum;
}

static double turned(const bat_curve *a, const bat_curve *b, double u) {
    const int n = bat_curve_dimension(a);
    double p[6], q[6], pp = 0, qq = 0, pq = 0;
    bat_curve_eval(a, u, 1, p), bat_curve_eval(b, u, 1, q);
    for (int d = n; d < 2 * n; d++) pp += p[d] * p[d], qq += q[d] * q[d], pq += p[d] * q[d];
    double off = 0;
    for (int d = n; d < 2 * n; d++) off = hypot(off, q[d] / sqrt(qq) - p[d] / sqrt(pp));
    return pq > 0 ? off : 4;
}

static void what_is_held_stays(void **state) {
    (void)state;
    random_source r = {3};
    for (int i = 0; i < 24; i++) {
        const bool closed = i % 2;
        const int dimension = i % 4 < 2 ? 2 : 3, levels = i % 3;
        const double size = i % 5 ? 400 : 0.004;
        bat_shape *shape = rough(&r, closed, dimension, size, levels), *before = NULL;
        double domain[2], delta[3], points[2], directions[1];
        assert_int_equal(bat_shape_copy(shape, &before), BAT_OK);
        bat_curve_domain(finest(shape), domain);
        const double across = domain[1] - domain[0], u = domain[0] + 0.5 * across;
        points[0] = domain[0] + 0.2 * across, points[1] = domain[0] + 0.8 * across;
        directions[0] = domain[0] + 0.35 * across;
        for (int d = 0; d < 3; d++) delta[d] = size * random_between(&r, -0.05, 0.05);
        bat_shape_held held = {.length = i % 3 != 1,
                               .area = closed && dimension == 2 && i % 3 != 0,
                               .point_count = 2,
                               .points = points,
                               .direction_count = i % 6 < 4,
                               .directions = directions};
        const int level = levels ? i / 3 % (levels + 1) : 0;
        assert_int_equal(bat_shape_drag_held(shape, level, u, delta, &held), BAT_OK);
        const bat_curve *a = finest(before), *b = finest(shape);
        assert_true(apart(a, b, u, delta) <= NEAR * size);
        for (int k = 0; k < 2; k++) assert_true(apart(a, b, points[k], NULL) <= NEAR * size);
        if (held.direction_count) assert_true(turned(a, b, directions[0]) <= NEAR);
        if (held.length) assert_true(fabs(whole(a) - whole(b)) <= NEAR * size);
        if (held.area) assert_true(fabs(bat_curve_area(a) - bat_curve_area(b)) <= NEAR * size * size);
        bat_shape_free(shape), bat_shape_free(before);
    }
}

/* With places alone the constraints are linear: the least move is that of bat_curve_drag. */
static void the_least_move(void **state) {
    (void)state;
    random_source r = {8};
    for (int i = 0; i < 6; i++) {
        bat_shape *shape = rough(&r, i % 2, 2 + i % 2, 100, 0);
        bat_curve *expected = NULL;
        double u[3] = {3.3, 8.1, 14.7}, deltas[9] = {0}, there, back;
        const int n = bat_curve_dimension(finest(shape));
        for (int d = 0; d < n; d++) deltas[d] = random_between(&r, -9, 9);
        double domain[2];
        bat_curve_domain(finest(shape), domain);
        for (int k = 0; k < 3; k++) u[k] = domain[0] + (domain[1] - domain[0]) * u[k] / 26;
        assert_int_equal(bat_curve_drag(finest(shape), 3, u, deltas, &expected), BAT_OK);
        assert_int_equal(
            bat_shape_drag_held(shape, 0, u[0], deltas, &(bat_shape_held){.point_count = 2, .points = u + 1}),
            BAT_OK);
        assert_int_equal(bat_curve_distance(finest(shape), expected, 8, &there, &back), BAT_OK);
        assert_true(fmax(there, back) <= 1e-9 * 100);
        bat_curve_free(expected), bat_shape_free(shape);
    }
}

/* A ring or an open arc that is its own mirror image about a slanted axis through (30, 40), whose seam lies anywhere. */
static bat_shape *even(random_source *r, bool closed, int seam, int levels, size_t coarsest, double axis[2]) {
    double points[POINTS * 2], knots[POINTS + 1], far[POINTS], slant = random_between(r, -1.2, 1.2);
    bat_curve *curve = NULL;
    bat_shape *shape = NULL;
    axis[0] = sin(slant), axis[1] = cos(slant);
    for (int i = 0; i < POINTS; i++) far[i] = 200 * (1 + 0.05 * random_unit(r));
    for (int i = 0; i < POINTS; i++) {
        const int k = (i + seam) % POINTS;
        const double w = closed ? TURN * k / POINTS : 0.3 + (TURN / 2 - 0.6) * k / (POINTS - 1);
        const int other = closed ? (POINTS - k) % POINTS : POINTS - 1 - k;
        const double size = far[k < other ? k : other];
        const double along = size * (closed ? cos(w) : sin(w)),
                     across = 0.6 * size * (closed ? sin(w) : cos(w));
        points[2 * i] = 30 + along * axis[0] - across * axis[1];
        points[2 * i + 1] = 40 + along * axis[1] + across * axis[0];
    }
    for (int i = 0; i <= POINTS; i++) knots[i] = i;
    if (closed)
        assert_int_equal(bat_curve_create(2, 3, true, POINTS, points, POINTS + 1, knots, &curve), BAT_OK);
    else
        assert_int_equal(bat_curve_create_clamped(2, 3, POINTS, points, &curve), BAT_OK);
    for (int again = 0; again < 2 && closed && seam % 3 == 1;
         again++) { /* as files have them: all knots threefold */
        bat_curve *finer = NULL;
        assert_int_equal(bat_curve_insert_knots(curve, POINTS, knots, &finer), BAT_OK);
        bat_curve_free(curve);
        curve = finer;
    }
    assert_int_equal(levels ? bat_shape_decompose_to(curve, levels, coarsest, NULL, &shape)
                            : bat_shape_create(curve, NULL, &shape),
                     BAT_OK);
    bat_curve_free(curve);
    return shape;
}

/* How far the curve's mirror image is from it: each of many points, from the nearest. */
static double unlike(const bat_curve *curve, const double axis[2]) {
    double worst = 0, domain[2];
    bat_curve_domain(curve, domain);
    for (int i = 0; i < 60; i++) {
        double p[2], image[2];
        bat_near near;
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * (i + 0.3) / 60, 0, p);
        const double along = (p[0] - 30) * axis[0] + (p[1] - 40) * axis[1];
        image[0] = 2 * (30 + along * axis[0]) - p[0], image[1] = 2 * (40 + along * axis[1]) - p[1];
        assert_int_equal(bat_curve_nearest(curve, image, &near), BAT_OK);
        worst = fmax(worst, near.distance);
    }
    return worst;
}

static void symmetry_stays(void **state) {
    (void)state;
    random_source r = {12};
    for (int i = 0; i < 30; i++) {
        const bool closed = i % 3 != 0;
        const int levels = i % 4 == 3 ? 0 : 1 + i % 2;
        double axis[2], delta[2], domain[2];
        bat_shape *shape = even(&r, closed, closed ? i % POINTS : 0, levels, closed ? 8 : 6, axis);
        bat_curve_domain(finest(shape), domain);
        for (int level = 0; level <= levels; level++) {
            bat_shape *before = NULL, *free_one = NULL;
            const double pin = domain[0] + 0.77 * (domain[1] - domain[0]);
            const double u = domain[0] + random_between(&r, 0.1, 0.4) * (domain[1] - domain[0]);
            bat_shape_held held = {.symmetry = true,
                                   .length = i % 2 && i % POINTS % 3 != 1,
                                   .point_count = i % 5 == 0,
                                   .points = &pin};
            memcpy(held.upright, axis, sizeof held.upright);
            for (int d = 0; d < 2; d++) delta[d] = random_between(&r, -12, 12);
            assert_int_equal(bat_shape_copy(shape, &before), BAT_OK);
            assert_int_equal(bat_shape_copy(shape, &free_one), BAT_OK);
            assert_true(unlike(finest(before), axis) <= NEAR * 200);
            assert_int_equal(bat_shape_drag_held(shape, level, u, delta, &held), BAT_OK);
            assert_true(apart(finest(before), finest(shape), u, delta) <= NEAR * 200);
            assert_true(unlike(finest(shape), axis) <= NEAR * 200);
            assert_int_equal(bat_shape_drag_held(free_one, level, u, delta, &(bat_shape_held){0}), BAT_OK);
            assert_true(unlike(finest(free_one), axis) > 1e-3);
            bat_shape_free(before), bat_shape_free(free_one);
        }
        bat_shape_free(shape);
    }
}

/* The least symmetric move: that of dragging a place and its image together, each by its own way. */
static void the_least_symmetric_move(void **state) {
    (void)state;
    random_source r = {4};
    for (int i = 0; i < 4; i++) {
        double axis[2], there, back, domain[2], deltas[4] = {7, -5};
        bat_shape *shape = even(&r, i % 2, 0, 0, 0, axis);
        bat_curve *expected = NULL;
        bat_curve_domain(finest(shape), domain);
        const double u[2] = {domain[0] + 0.3 * (domain[1] - domain[0]),
                             domain[0] + 0.7 * (domain[1] - domain[0]) +
                                 (i % 2 ? 4 : 0)}; /* of rings: the axis is at 2 */
        const double along = deltas[0] * axis[0] + deltas[1] * axis[1];
        for (int k = 0; k < 2; k++) deltas[2 + k] = 2 * along * axis[k] - deltas[k];
        bat_shape_held held = {.symmetry = true};
        memcpy(held.upright, axis, sizeof held.upright);
        assert_int_equal(bat_curve_drag(finest(shape), 2, u, deltas, &expected), BAT_OK);
        assert_int_equal(bat_shape_drag_held(shape, 0, u[0], deltas, &held), BAT_OK);
        assert_int_equal(bat_curve_distance(finest(shape), expected, 8, &there, &back), BAT_OK);
        assert_true(fmax(there, back) <= NEAR * 200);
        bat_curve_free(expected), bat_shape_free(shape);
    }
}

/* A control point that is moved is where it was moved to, and the others give way. */
static void a_point_is_moved(void **state) {
    (void)state;
    random_source r = {5};
    bat_shape *shape = rough(&r, true, 2, 100, 1), *before = NULL;
    const double delta[2] = {4, -7}, pins[1] = {20};
    assert_int_equal(bat_shape_copy(shape, &before), BAT_OK);
    assert_int_equal(bat_shape_move_held(
                         shape, 0, 2, delta,
                         &(bat_shape_held){.length = true, .area = true, .point_count = 1, .points = pins}),
                     BAT_OK);
    const double *p = bat_curve_points(bat_shape_curve(before, 0)),
                 *q = bat_curve_points(bat_shape_curve(shape, 0));
    for (int d = 0; d < 2; d++) assert_true(fabs(q[4 + d] - p[4 + d] - delta[d]) <= NEAR * 100);
    assert_true(apart(finest(before), finest(shape), pins[0], NULL) <= NEAR * 100);
    assert_true(fabs(whole(finest(before)) - whole(finest(shape))) <= NEAR * 100);
    assert_true(fabs(bat_curve_area(finest(before)) - bat_curve_area(finest(shape))) <= NEAR * 1e4);
    assert_int_equal(bat_shape_move_held(shape, 0, -1, delta, &(bat_shape_held){0}), BAT_ARGUMENT);
    assert_int_equal(bat_shape_move_held(shape, 0, 1000, delta, &(bat_shape_held){0}), BAT_ARGUMENT);
    bat_shape_free(shape), bat_shape_free(before);
}

static void refused(bat_shape *shape, int level, double u, const double *delta, const bat_shape_held *held,
                    bat_status expected) {
    bat_curve *before = NULL;
    assert_int_equal(bat_curve_copy(finest(shape), &before), BAT_OK);
    assert_int_equal(bat_shape_drag_held(shape, level, u, delta, held), expected);
    assert_true(bat_curve_is_equal(before, finest(shape)));
    bat_curve_free(before);
}

static void what_cannot_be(void **state) {
    (void)state;
    random_source r = {1};
    bat_shape *ring = rough(&r, true, 2, 100, 2), *arc = rough(&r, false, 2, 100, 0), *straight = NULL;
    bat_shape *space = rough(&r, true, 3, 100, 0);
    bat_curve *line = NULL;
    const double delta[3] = {5, 3, 0}, much[2] = {0, 400}, ends[2] = {0, 1}, at[1] = {2}, odd[1] = {NAN};
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, (double[]){0, 0, 10, 0, 20, 0, 30, 0}, &line), BAT_OK);
    assert_int_equal(bat_shape_create(line, NULL, &straight), BAT_OK);
    refused(ring, 0, 2, delta, &(bat_shape_held){.point_count = 1, .points = at}, BAT_TOLERANCE);
    refused(straight, 0, 0.5, much, &(bat_shape_held){.length = true, .point_count = 2, .points = ends},
            BAT_TOLERANCE);
    refused(arc, 0, 2, delta, &(bat_shape_held){.area = true}, BAT_DIMENSION);
    refused(ring, 3, 2, delta, &(bat_shape_held){0}, BAT_ARGUMENT);
    refused(ring, 0, 2, delta, &(bat_shape_held){.point_count = 1}, BAT_ARGUMENT);
    refused(ring, 0, 2, delta, NULL, BAT_ARGUMENT);
    refused(ring, 0, 2, delta, &(bat_shape_held){.symmetry = true}, BAT_SINGULAR);
    refused(ring, 0, 2, delta, &(bat_shape_held){.symmetry = true, .upright = {NAN, 1}}, BAT_NUMBER);
    refused(straight, 0, 0.5, (double[]){3, 0}, &(bat_shape_held){.symmetry = true}, BAT_TOLERANCE);
    refused(space, 0, 2, delta, &(bat_shape_held){.symmetry = true}, BAT_DIMENSION);
    refused(ring, 0, NAN, delta, &(bat_shape_held){0}, BAT_NUMBER);
    refused(ring, 0, 2, delta, &(bat_shape_held){.direction_count = 1, .directions = odd}, BAT_NUMBER);
    refused(ring, 0, 2, delta, &(bat_shape_held){.point_count = BAT_HELD_MAX + 1, .points = ends}, BAT_COUNT);
    assert_int_equal(bat_shape_set_muted(ring, 1, true), BAT_OK);
    refused(ring, 1, 2, delta, &(bat_shape_held){0}, BAT_STATE);
    bat_shape_free(ring), bat_shape_free(arc), bat_shape_free(straight), bat_curve_free(line);
    bat_shape_free(space);
}

static void allocations_may_fail(void **state) {
    (void)state;
    random_source r = {1};
    bat_shape *shape = rough(&r, true, 2, 100, 1);
    const double delta[2] = {2, 1}, at[1] = {5};
    bool reached = true;
    for (long n = 1; reached; n++) {
        bat_shape *copy = NULL;
        assert_int_equal(bat_shape_copy(shape, &copy), BAT_OK);
        const long live = alloc_live();
        alloc_fail_at(n);
        const bat_status status = bat_shape_drag_held(
            copy, 0, 2, delta, &(bat_shape_held){.length = true, .point_count = 1, .points = at});
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        if (reached) assert_int_equal(alloc_live(), live);
        bat_shape_free(copy);
    }
    bat_shape_free(shape);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_held_stays),   cmocka_unit_test(the_least_move),
        cmocka_unit_test(symmetry_stays),       cmocka_unit_test(the_least_symmetric_move),
        cmocka_unit_test(a_point_is_moved),     cmocka_unit_test(what_cannot_be),
        cmocka_unit_test(allocations_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
