/* What follows a bent curve: exactly along a rigid move, not at all where nothing moves, and with what is near where a part is bent; islands are
 * what lies inside. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <math.h>
#include <cmocka.h>
#include "hands/levels/follow.h"
#include "support/alloc_fail.h"
#include <batten/drag.h>
#include <batten/measure.h>
#include <batten/refine.h>

enum { N = 12 };
static const double TURN = 6.283185307179586;

static bat_curve *ring(double x, double y, double radius) {
    double points[2 * N], knots[N + 1];
    bat_curve *out = NULL;
    for (int i = 0; i < N; i++)
        points[2 * i] = x + radius * cos(TURN * i / N), points[2 * i + 1] = y + radius * sin(TURN * i / N);
    for (int i = 0; i <= N; i++) knots[i] = i;
    assert_int_equal(bat_curve_create(2, 3, true, N, points, N + 1, knots, &out), BAT_OK);
    return out;
}

static double apart(const bat_curve *a, const bat_curve *b) {
    const double *p = bat_curve_points(a), *q = bat_curve_points(b);
    double most = 0;
    for (int i = 0; i < 2 * N; i++) most = fmax(most, fabs(p[i] - q[i]));
    return most;
}

static void rigid_moves_are_exact(void **state) {
    (void)state;
    const double matrix[6] = {0.8, -0.6, 30, 0.6, 0.8, -70};
    bat_curve *outline = ring(0, 0, 100), *island = ring(20, -10, 40), *moved = NULL, *expected = NULL,
              *made = NULL;
    assert_int_equal(bat_curve_transform(outline, matrix, &moved), BAT_OK);
    assert_int_equal(bat_curve_transform(island, matrix, &expected), BAT_OK);
    assert_int_equal(bat_curve_follow(island, outline, moved, &made), BAT_OK);
    assert_true(apart(made, expected) < 1e-11 * 200);
    bat_curve_free(made);
    assert_int_equal(bat_curve_follow(island, outline, outline, &made), BAT_OK);
    assert_true(apart(made, island) == 0);
    bat_curve_free(outline), bat_curve_free(island), bat_curve_free(moved), bat_curve_free(expected),
        bat_curve_free(made);
}

static void what_is_near_decides(void **state) {
    (void)state;
    bat_curve *outline = ring(0, 0, 100), *bent = NULL, *made[2];
    bat_curve *near = ring(80, 0, 8), *far = ring(-80, 0, 8);
    const double u = 2, delta[2] = {20, 0}; /* the middle of the first point's support: (96, 0) */
    double at[2];
    bat_curve_eval(outline, u, 0, at);
    assert_int_equal(bat_curve_drag(outline, 1, &u, delta, &bent), BAT_OK);
    bat_curve *pair[2] = {near, far};
    double shift[2];
    for (int k = 0; k < 2; k++) {
        double low[2], high[2], then[2], now[2];
        assert_int_equal(bat_curve_follow(pair[k], outline, bent, &made[k]), BAT_OK);
        bat_curve_bounds(pair[k], low, high), then[0] = low[0] + high[0], then[1] = low[1] + high[1];
        bat_curve_bounds(made[k], low, high), now[0] = low[0] + high[0], now[1] = low[1] + high[1];
        shift[k] = hypot(now[0] - then[0], now[1] - then[1]) / 2;
    }
    assert_true(at[0] > 90 && fabs(at[1]) < 1);
    if (!(shift[0] > 8 && shift[0] < 25 && shift[1] < 0.1)) fail_msg("%g %g", shift[0], shift[1]);
    for (int k = 0; k < 2; k++) bat_curve_free(made[k]), bat_curve_free(pair[k]);
    bat_curve_free(outline), bat_curve_free(bent);
}

static void islands_are_inside(void **state) {
    (void)state;
    bat_curve *outline = ring(0, 0, 100), *in = ring(20, 10, 30), *out = ring(300, 0, 30), *space = NULL,
              *made = NULL;
    assert_true(bat_curve_is_inside(in, outline));
    assert_false(bat_curve_is_inside(out, outline));
    assert_false(bat_curve_is_inside(outline, in));
    assert_int_equal(bat_curve_to_dimension(in, 3, &space), BAT_OK);
    assert_false(bat_curve_is_inside(space, outline));
    assert_int_equal(bat_curve_follow(space, outline, outline, &made), BAT_DIMENSION);
    const long live = alloc_live();
    bool reached = true;
    for (long n = 1; reached; n++) {
        alloc_fail_at(n);
        const bat_status status = bat_curve_follow(in, outline, outline, &made);
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        if (!reached) bat_curve_free(made);
        assert_int_equal(alloc_live(), live);
    }
    bat_curve_free(outline), bat_curve_free(in), bat_curve_free(out), bat_curve_free(space);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rigid_moves_are_exact),
        cmocka_unit_test(what_is_near_decides),
        cmocka_unit_test(islands_are_inside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
