/* Curves beside curves survive the failure of any allocation: BAT_MEMORY, no output, nothing leaked. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/relate.h>
#include "support/alloc_fail.h"

typedef bat_status work(const bat_curve *a, const bat_curve *b);

static bat_status distance(const bat_curve *a, const bat_curve *b) {
    bat_apart apart;
    return bat_curve_hausdorff(a, b, 1e-6, &apart);
}

static bat_status crossings(const bat_curve *a, const bat_curve *b) {
    bat_meeting meeting = {0};
    const bat_status status = bat_curve_intersect(a, b, 1e-6, &meeting);
    if (status != BAT_OK) assert_null(meeting.crossings);
    bat_meeting_free(&meeting);
    return status;
}

static bat_status overlaps(const bat_curve *a, const bat_curve *b) {
    (void)b;
    return crossings(a, a);
}

static bat_status loops(const bat_curve *a, const bat_curve *b) {
    (void)b;
    bat_meeting meeting = {0};
    const bat_status status = bat_curve_self_intersect(a, 1e-6, &meeting);
    bat_meeting_free(&meeting);
    return status;
}

static bat_status polyline(const bat_curve *a, const bat_curve *b) {
    (void)b;
    size_t count;
    double *points = NULL, *u = NULL;
    const bat_status status = bat_curve_flatten(a, 1e-4, &count, &points, &u);
    if (status != BAT_OK) assert_null(points);
    bat_free(points), bat_free(u);
    return status;
}

static bat_status biarcs(const bat_curve *a, const bat_curve *b) {
    (void)b;
    size_t count;
    bat_arc *arcs = NULL;
    const bat_status status = bat_curve_arcs(a, 1e-5, 0.1, &count, &arcs, NULL);
    if (status != BAT_OK) assert_null(arcs);
    bat_free(arcs);
    return status;
}

static bat_status parallels(const bat_curve *a, const bat_curve *b) {
    (void)b;
    size_t count;
    bat_curve **all = NULL;
    const bat_status status = bat_curve_offset(a, 1, 1e-2, 0.1, &count, &all, NULL);
    if (status != BAT_OK)
        assert_null(all);
    else
        assert_true(count > 1), bat_curves_free(count, all);
    return status;
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    static work *const all[] = {distance, crossings, overlaps, loops, polyline, biarcs, parallels};
    const double x[] = {0, 0, 10, 9, -3, 9, 7, 0}, y[] = {0, 5, 3, 1, 5, 8, 9, 2};
    bat_curve *a, *b;
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, x, &a), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, y, &b), BAT_OK);
    const long live = alloc_live();
    for (size_t i = 0; i < sizeof all / sizeof *all; i++)
        for (int n = 1;; n++) {
            alloc_fail_at(n);
            const bat_status status = all[i](a, b);
            const bool reached = alloc_fail_reached();
            assert_int_equal(alloc_live(), live);
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            if (reached) continue;
            assert_true(n > 2);
            break;
        }
    bat_curve_free(a), bat_curve_free(b);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
