/* Moving a few points leaves frames that came out turned as they are, until the shape is committed. Whatever is done to
 * the shape next gives the same whether it was committed before or not, up to how it is turned about its base. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "hands/levels/shape.h"
#include "support/random_curve.h"
#include "support/shapes.h"
#include <batten/levels.h>

typedef bat_status work(bat_shape *shape);

static bat_status gain(bat_shape *shape) { return bat_shape_set_gain(shape, 1, 1.5); }
static bat_status mute(bat_shape *shape) { return bat_shape_set_muted(shape, 1, true); }
static bat_status move_far(bat_shape *shape) {
    double deltas[3 * 64];
    const int count = bat_point_count(bat_shape_curve(shape, 0));
    for (int i = 0; i < 3 * count; i++) deltas[i] = 5 + i % 3;
    return bat_shape_move_many(shape, 0, 0, (size_t)count, deltas);
}
static bat_status scale(bat_shape *shape) {
    static const double matrix[12] = {2, 0, 0, 7, 0, 2, 0, 8, 0, 0, 2, 9};
    return bat_shape_transform(shape, matrix);
}
static bat_status mirrored(bat_shape *shape) {
    static const double matrix[12] = {-1, 0, 0, 7, 0, 1, 0, 8, 0, 0, 1, 9};
    return bat_shape_transform(shape, matrix);
}

static bat_curve *in_space(random_source *r) {
    double points[3 * 24];
    bat_curve *curve = NULL;
    for (int i = 0; i < 24; i++) {
        points[3 * i] = 40 * i;
        points[3 * i + 1] = 30 * sin(i) + random_between(r, -3, 3);
        points[3 * i + 2] = 30 * cos(i) + random_between(r, -3, 3);
    }
    assert_int_equal(bat_curve_create_clamped(3, 3, 24, points, &curve), BAT_OK);
    return curve;
}

static void committed_or_not(void **state) {
    (void)state;
    static work *const all[] = {gain, mute, move_far, scale, mirrored};
    random_source r = {23};
    for (int round = 0; round < 20; round++)
        for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
            bat_curve *curve = in_space(&r);
            bat_shape *first = NULL, *second = NULL;
            assert_int_equal(bat_shape_decompose(curve, 1, NULL, &first), BAT_OK);
            assert_int_equal(bat_shape_move(first, 0, 3, (double[]){20, -15, 25}), BAT_OK);
            assert_true(first->turned);
            assert_int_equal(bat_shape_copy(first, &second), BAT_OK);
            assert_true(second->turned);
            assert_int_equal(bat_shape_commit(first), BAT_OK);
            assert_false(first->turned);
            assert_int_equal(all[i](first), BAT_OK);
            assert_int_equal(all[i](second), BAT_OK);
            assert_int_equal(bat_shape_commit(first), BAT_OK);
            assert_int_equal(bat_shape_commit(second), BAT_OK);
            const double apart = points_apart(shape_finest(first), shape_finest(second));
            if (!(apart < 1e-9 * bat_curve_size(curve))) fail_msg("%zu: %g", i, apart);
            bat_shape_free(first);
            bat_shape_free(second);
            bat_curve_free(curve);
        }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(committed_or_not)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
