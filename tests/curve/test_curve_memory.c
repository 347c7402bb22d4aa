/* Every curve function survives the failure of any one of its allocations: BAT_MEMORY, outputs untouched,
 * nothing leaked. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/fit.h>
#include <batten/refine.h>
#include "curve/curve.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

static bat_curve *open_curve, *closed_curve, *loose_curve, *quintic, *ring;
static double *cubics;
static char marker;

static void make_curves(void) {
    random_source r = {41};
    open_curve = random_curve(&r, 3, 2, 0, 12);
    loose_curve = random_curve(&r, 3, 2, 1, 12);
    closed_curve = random_curve(&r, 3, 2, 2, 12);
    quintic = random_curve(&r, 5, 2, 0, 6);
    if (bat_curve_open_at(closed_curve, 0.3, &ring) != BAT_OK) abort();
}

static void free_curves(void) {
    bat_curve_free(open_curve), bat_curve_free(loose_curve), bat_curve_free(closed_curve);
    bat_curve_free(quintic), bat_curve_free(ring);
}

typedef bat_status operation(bat_curve **a, bat_curve **b);

static bat_status create(bat_curve **a, bat_curve **b) {
    (void)b;
    return bat_curve_create(2, 3, false, bat_curve_count(open_curve), bat_curve_points(open_curve),
                            bat_curve_knot_count(open_curve), bat_curve_knots(open_curve), a);
}
static bat_status copy(bat_curve **a, bat_curve **b) { return (void)b, bat_curve_copy(open_curve, a); }
static bat_status transform(bat_curve **a, bat_curve **b) {
    const double m[] = {1, 2, 3, 4, 5, 6};
    return (void)b, bat_curve_transform(closed_curve, m, a);
}
static bat_status dimension(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_to_dimension(closed_curve, 3, a);
}
static bat_status insert(bat_curve **a, bat_curve **b) {
    double d[2];
    bat_curve_domain(loose_curve, d);
    return (void)b, bat_curve_insert_knot(loose_curve, d[0], 1, a);
}
static bat_status refine(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_refine(closed_curve, bat_curve_knot_count(closed_curve),
                                     bat_curve_knots(closed_curve), a);
}
static bat_status remove_seam(bat_curve **a, bat_curve **b) {
    return (void)b,
           bat_curve_remove_knot(closed_curve, bat_curve_knots(closed_curve)[0], 3, 1e9, a, NULL, NULL);
}
static bat_status simplify(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_simplify(open_curve, 2, 4, a, NULL);
}
static bat_status simplify_nothing(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_simplify(closed_curve, 0, 4, a, NULL);
}
static bat_status refit(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_refit(open_curve, 2, 4, a, NULL);
}
static bat_status refit_g1(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_refit_g1(open_curve, 2, 4, a, NULL);
}
static bat_status elevate(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_elevate(closed_curve, 5, a);
}
static bat_status clamp(bat_curve **a, bat_curve **b) { return (void)b, bat_curve_clamp(loose_curve, a); }
static bat_status reverse(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_reverse(closed_curve, a);
}
static bat_status reparametrise(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_reparametrise(closed_curve, 3, 4, a);
}
static bat_status split(bat_curve **a, bat_curve **b) {
    double d[2];
    bat_curve_domain(open_curve, d);
    return bat_curve_split(open_curve, 0.5 * (d[0] + d[1]), a, b);
}
static bat_status piece(bat_curve **a, bat_curve **b) {
    double d[2];
    bat_curve_domain(closed_curve, d);
    return (void)b, bat_curve_piece(closed_curve, d[1] - 0.1, d[1] + 0.1, a);
}
static bat_status close_ring(bat_curve **a, bat_curve **b) { return (void)b, bat_curve_close(ring, 1e-6, a); }
static bat_status move_seam(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_move_seam(closed_curve, 0.777, a);
}
static bat_status join(bat_curve **a, bat_curve **b) {
    return (void)b, bat_curve_join(open_curve, quintic, 2, 1e9, a, NULL);
}
static bat_status to_cubics(bat_curve **a, bat_curve **b) {
    (void)a, (void)b;
    int count;
    return bat_curve_to_cubics(quintic, 1e-6, &count, &cubics);
}
static bat_status from_bezier(bat_curve **a, bat_curve **b) {
    const double path[] = {0, 0, 1, 1, 2, 1, 3, 0, 4, -1, 5, -1, 6, 0, 3, -9, 1, -9, 0, 0};
    return (void)b, bat_curve_from_bezier(2, 3, true, 3, path, 0.1, 0.1, a, NULL);
}

static void every_allocation(void **state) {
    (void)state;
    operation *const operations[] = {
        create,        copy,      transform, dimension, insert,      refine,          remove_seam, simplify,
        refit,         refit_g1,  elevate,   clamp,     reverse,     split,           piece,       close_ring,
        reparametrise, move_seam, join,      to_cubics, from_bezier, simplify_nothing};
    make_curves();
    for (size_t i = 0; i < sizeof operations / sizeof operations[0]; i++) {
        bat_curve *mark = (bat_curve *)(void *)&marker;
        for (int n = 1;; n++) {
            bat_curve *a = mark, *b = mark;
            cubics = (double *)(void *)&marker;
            long before = alloc_live();
            alloc_fail_at(n);
            bat_status status = operations[i](&a, &b);
            if (!alloc_fail_reached()) {
                assert_int_equal(status, BAT_OK);
                assert_true(n > 1); /* something was allocated, so something could fail */
                if (a != mark) bat_curve_free(a);
                if (b != mark) bat_curve_free(b);
                if (cubics != (double *)(void *)&marker) bat_free(cubics);
                assert_int_equal(alloc_live(), before);
                break;
            }
            assert_int_equal(status, BAT_MEMORY);
            assert_true(a == mark && b == mark && cubics == (double *)(void *)&marker);
            assert_int_equal(alloc_live(), before);
        }
    }
    free_curves();
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_allocation)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
