/* Rings that are their own mirror image, with points moved: they are again, and what neither half moved stays bit for
 * bit. And what no such curve is; curves that are equal; knots that a map of the parameter would make coincide. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "curve/curve.h"
#include "curve/mirror.h"
#include "support/random_surface.h"
#include <batten/refine.h>

static const bat_mirror upright = {.on = true, .at = {0, 0}, .along = {0, 1}};
static const double pi = 3.14159265358979324;

/* A ring of so many points, its own image; which of them is the first is free. on_axis: two points lie there. */
static bat_curve *ring(int degree, int count, int first, bool on_axis) {
    double points[2 * 32], knots[33];
    for (int i = 0; i < count; i++) {
        const int k = (i + first) % count, twin = on_axis ? (count - k) % count : count - 1 - k;
        const double turn = (on_axis ? k : k + 0.5) * 2 * pi / count,
                     mirrored = (on_axis ? twin : twin + 0.5) * 2 * pi / count;
        points[2 * i] = k <= twin ? round(50 * sin(turn)) : -round(50 * sin(mirrored));
        points[2 * i + 1] = k <= twin ? round(70 * cos(turn)) : round(70 * cos(mirrored));
        if (k == twin) points[2 * i] = 0;
    }
    for (int i = 0; i <= count; i++) knots[i] = i;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, degree, true, (size_t)count, points, count + 1, knots, &curve),
                     BAT_OK);
    return curve;
}

/* The ring with other points. */
static bat_curve *with_points(const bat_curve *ring_before, const double *points) {
    const int count = (int)bat_curve_count(ring_before);
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, bat_curve_degree(ring_before), true, (size_t)count, points,
                                      count + 1, bat_curve_knots(ring_before), &curve),
                     BAT_OK);
    return curve;
}

static void points_of(const bat_curve *curve, double points[64]) {
    memcpy(points, bat_curve_points(curve), 2 * bat_curve_count(curve) * sizeof *points);
}

static void rings(void **state) {
    (void)state;
    random_source r = {31};
    for (int round = 0; round < 300; round++) {
        const int count = 2 * random_int(&r, 3, 12), degree = random_int(&r, 2, 4);
        bat_curve *before = ring(degree, count, random_int(&r, 0, count - 1), round % 2), *out = NULL;
        assert_true(bat_mirror_twins(&upright, before, before, 1e-9));
        const double *from = bat_curve_points(before);
        double points[64];
        points_of(before, points);
        bool touched[32] = {false};
        for (int moves = random_int(&r, 0, 4); moves > 0; moves--) {
            const int i = random_int(&r, 0, count - 1);
            double image[2];
            points[2 * i] += random_between(&r, -9, 9), points[2 * i + 1] += random_between(&r, -9, 9);
            bat_mirror_point(&upright, from + 2 * i, image);
            for (int j = 0; j < count; j++)
                touched[j] |= j == i || (fabs(from[2 * j] - image[0]) < 1e-9 &&
                                         fabs(from[2 * j + 1] - image[1]) < 1e-9);
        }
        bat_curve *after = with_points(before, points);
        assert_int_equal(bat_mirror_net(&upright, before, after, 1e-9, &out), BAT_OK);
        assert_true(bat_mirror_twins(&upright, out, out, 1e-9));
        for (int i = 0; i < count; i++)
            if (!touched[i])
                assert_memory_equal(bat_curve_points(out) + 2 * i, from + 2 * i, 2 * sizeof *points);
        bat_curve_free(out);
        bat_curve_free(after);
        bat_curve_free(before);
    }
}

/* Both of a pair move equally far, but not to images of each other: the first counts. */
static void equal_moves(void **state) {
    (void)state;
    bat_curve *before = ring(3, 8, 0, false), *out = NULL;
    double points[64];
    points_of(before, points);
    points[3] += 4, points[13] -= 4; /* 1 and 6 are a pair */
    bat_curve *after = with_points(before, points);
    assert_int_equal(bat_mirror_net(&upright, before, after, 1e-9, &out), BAT_OK);
    points[12] = -points[2], points[13] = points[3];
    assert_memory_equal(bat_curve_points(out), points, 16 * sizeof *points);
    bat_curve_free(out);
    bat_curve_free(after);
    bat_curve_free(before);
}

static void no_such_curves(void **state) {
    (void)state;
    bat_curve *before = ring(3, 8, 0, false), *out = NULL;
    bat_curve *others[] = {ring(2, 8, 0, false), ring(3, 10, 0, false), NULL, NULL, NULL};
    const double line[16] = {0, 0, 9, 9, 20, 5};
    assert_int_equal(bat_curve_create_clamped(2, 3, 8, line, &others[2]), BAT_OK);
    assert_int_equal(bat_curve_reparametrise(before, 0, 9, &others[3]), BAT_OK);
    assert_int_equal(bat_curve_insert_knot(before, 0.5, 1, &others[4]), BAT_OK);
    for (int i = 0; i < 5; i++) {
        assert_int_equal(bat_mirror_net(&upright, before, others[i], 1e-9, &out), BAT_STATE);
        assert_false(bat_curve_is_equal(before, others[i]));
        bat_curve_free(others[i]);
    }
    double points[64];
    points_of(before, points);
    points[4] += 1; /* no longer its own image */
    bat_curve *spoilt = with_points(before, points);
    assert_int_equal(bat_mirror_net(&upright, spoilt, spoilt, 1e-9, &out), BAT_STATE);
    assert_false(bat_mirror_twins(&upright, spoilt, spoilt, 1e-9));
    assert_null(out);
    bat_curve_free(spoilt);
    bat_curve_free(before);
}

static void planar_or_not(void **state) {
    (void)state;
    const double points[24] = {0, 0, 0, 9, 9, 1, 20, 5, 2, 30, 9, 3, 40, 1, 4, 50, 9, 5, 60, 1, 6, 70, 7, 7};
    bat_curve *space = NULL, *flat = ring(3, 8, 0, false), *lower = NULL, *raised = NULL;
    assert_int_equal(bat_curve_create_clamped(3, 3, 8, points, &space), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(2, 3, 8, points, &lower), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(2, 2, 8, points, &raised), BAT_OK);
    assert_false(bat_mirror_twins(&upright, space, flat, 1));
    assert_false(bat_mirror_twins(&upright, flat, space, 1));
    assert_false(bat_curve_is_equal(space, lower));
    assert_false(bat_curve_is_equal(lower, raised));
    assert_true(bat_curve_is_equal(lower, lower));
    bat_curve_free(space);
    bat_curve_free(flat);
    bat_curve_free(lower);
    bat_curve_free(raised);
}

/* A map that is too coarse for the knots is refused. */
static void knots_stay_apart(void **state) {
    (void)state;
    const double points[10] = {0, 0, 9, 9, 20, 5, 30, 9, 40, 1}, knots[9] = {0, 0, 0, 0, 1e-20, 1, 1, 1, 1};
    bat_curve *curve = NULL, *out = NULL;
    assert_int_equal(bat_curve_create(2, 3, false, 5, points, 9, knots, &curve), BAT_OK);
    assert_int_equal(bat_curve_reverse(curve, &out), BAT_KNOTS); /* 1 - 1e-20 is 1 */
    assert_int_equal(bat_curve_reparametrise(curve, 1, 2, &out), BAT_KNOTS);
    assert_null(out);
    assert_int_equal(bat_curve_reparametrise(curve, 0, 2, &out), BAT_OK);
    assert_true(out->knots[4] == 2e-20);
    bat_curve_free(out);
    bat_curve_free(curve);
}

static void surfaces_are_equal(void **state) {
    (void)state;
    random_source r = {5};
    bat_surface *one = random_surface(&r, (int[]){2, 2}, (int[]){0, 0}, (int[]){3, 3});
    bat_surface *others[] = {random_surface(&r, (int[]){3, 2}, (int[]){0, 0}, (int[]){2, 3}),
                             random_surface(&r, (int[]){2, 2}, (int[]){0, 2}, (int[]){3, 3}),
                             random_surface(&r, (int[]){2, 2}, (int[]){0, 0}, (int[]){4, 3}),
                             random_surface(&r, (int[]){2, 2}, (int[]){0, 0}, (int[]){3, 3})};
    assert_true(bat_surface_is_equal(one, one));
    for (int i = 0; i < 4; i++) {
        assert_false(bat_surface_is_equal(one, others[i]));
        bat_surface_free(others[i]);
    }
    bat_surface_free(one);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(rings),
                                       cmocka_unit_test(equal_moves),
                                       cmocka_unit_test(no_such_curves),
                                       cmocka_unit_test(planar_or_not),
                                       cmocka_unit_test(knots_stay_apart),
                                       cmocka_unit_test(surfaces_are_equal)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
