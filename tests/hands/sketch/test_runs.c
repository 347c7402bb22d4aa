/*
 * Boxes of runs of segments: of random paths of every count, with bends, coincident points and long leaps, nothing that
 * lies near enough is passed over, and far from a path next to nothing is visited.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "hands/sketch/runs.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { MOST = 130 };

static void random_path(random_source *r, int count, double *points) {
    double x[2] = {random_between(r, -500, 500), random_between(r, -500, 500)};
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 2; k++) {
            const double step = random_unit(r) < 0.1 ? 200 : random_unit(r) < 0.2 ? 0 : 8;
            points[2 * i + k] = x[k] += random_between(r, -step, step);
        }
}

/* Squared distance of p from item i, found by thirds: no formula of the code. */
static double distance2(const double *points, int count, int i, const double p[2]) {
    const double *a = points + 2 * i, *b = i + 1 < count ? a + 2 : a;
    double low = 0, high = 1, d[2] = {0, 0};
    for (int turn = 0; turn < 200; turn++) {
        const double t[2] = {(2 * low + high) / 3, (low + 2 * high) / 3};
        for (int k = 0; k < 2; k++) {
            const double x = a[0] + t[k] * (b[0] - a[0]) - p[0], y = a[1] + t[k] * (b[1] - a[1]) - p[1];
            d[k] = x * x + y * y;
        }
        if (d[0] < d[1])
            high = t[1];
        else
            low = t[0];
    }
    return fmin(d[0], d[1]);
}

static void nothing_near_is_passed_over(void **state) {
    (void)state;
    random_source r = {5};
    bat_runs runs = {0};
    double points[2 * MOST];
    for (int n = 0; n < 200; n++) {
        const int count = n < 12 ? n : random_int(&r, 12, MOST);
        random_path(&r, count, points);
        assert_int_equal(bat_runs_build(&runs, count, points), BAT_OK);
        const double p[2] = {random_between(&r, -600, 600), random_between(&r, -600, 600)};
        const double within = random_between(&r, 0, 300), d2 = within * within;
        int next = bat_runs_next(&runs, 0, p, d2), last = bat_runs_last(&runs, count - 1, p, d2);
        for (int i = 0; i < count; i++) {
            if (next < i) next = bat_runs_next(&runs, i, p, d2);
            assert_true(next == i || distance2(points, count, i, p) >= d2 * (1 - 1e-9));
        }
        for (int i = count - 1; i >= 0; i--) {
            if (last > i) last = bat_runs_last(&runs, i, p, d2);
            assert_true(last == i || distance2(points, count, i, p) >= d2 * (1 - 1e-9));
        }
    }
    bat_runs_free(&runs);
}

static void what_lies_far_off_is_passed_over(void **state) {
    (void)state;
    enum { COUNT = 4096 };
    static double points[2 * COUNT];
    bat_runs runs = {0};
    for (int i = 0; i < COUNT; i++) points[2 * i] = i, points[2 * i + 1] = 0;
    assert_int_equal(bat_runs_build(&runs, COUNT, points), BAT_OK);
    assert_int_equal(bat_runs_next(&runs, 0, (double[]){2000, 50}, 49 * 49), COUNT);
    assert_int_equal(bat_runs_last(&runs, COUNT - 1, (double[]){2000, 50}, 49 * 49), -1);
    int visited = 0;
    const double p[2] = {3000.5, 3};
    for (int i = bat_runs_next(&runs, 0, p, 25); i < COUNT; i = bat_runs_next(&runs, i + 1, p, 25)) visited++;
    assert_in_range(visited, 8, 12); /* eight units of the path lie within five of p */
    bat_runs_free(&runs);
}

static void memory(void **state) {
    (void)state;
    const double points[6] = {0, 0, 1, 1, 2, 0}, here[2] = {0, 0};
    bat_runs runs = {0};
    alloc_fail_at(1);
    assert_int_equal(bat_runs_build(&runs, 3, points), BAT_MEMORY);
    alloc_fail_at(0);
    assert_int_equal(bat_runs_next(&runs, 0, here, 1), 0); /* none: nothing there */
    assert_int_equal(bat_runs_build(&runs, 3, points), BAT_OK);
    assert_int_equal(bat_runs_next(&runs, 0, (double[]){0, NAN}, 1),
                     0); /* no number: nothing is passed over */
    bat_runs_free(&runs);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_near_is_passed_over),
        cmocka_unit_test(what_lies_far_off_is_passed_over),
        cmocka_unit_test(memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
