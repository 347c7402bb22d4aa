/* What a refused curve or surface is told: the place that is wrong, in words; and the same status as from what makes it, whatever is given. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/check.h>
#include "support/random_curve.h"

static const double POINTS[] = {0, 0, 1, 0, 2, 1, 3, 1}, KNOTS[] = {0, 0, 0, 1, 2, 2, 2};

typedef struct wrong {
    int dimension, degree, knot_count, at;
    size_t count;
    double value;
    bool closed, of_points;
    const char *place, *message;
} wrong;

static const wrong WRONG[] = {
    {2, 9, 7, 0, 4, 0, false, false, "degree", "expected 1 to 7, found 9"},
    {4, 2, 7, 0, 4, 0, false, false, "dimension", "expected 2 to 3, found 4"},
    {2, 2, 7, 0, 2, 0, false, false, "count", "expected 3 to 16777216, found 2"},
    {2, 2, 6, 0, 4, 0, false, false, "knots", "expected 7, found 6"},
    {2, 2, 7, 4, 4, 0.5, false, false, "knots[4]", "expected at least 1, found 0.5"},
    {2, 2, 7, 3, 4, INFINITY, false, false, "knots[3]", "expected a number up to 1e30, found "},
    {2, 2, 7, 3, 4, 0, false, false, "knots[3]", "expected at most 3 equal knots, found 0"},
    {2, 2, 7, 3, 4, 1e-40, false, false, "knots[3]", "expected the knot before, or 1e-30 more, found 1e-40"},
    {2, 2, 7, 5, 4, NAN, false, true, "points[2][1]", "expected a number up to 1e75, found no number"},
};

static void each_is_named(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof WRONG / sizeof *WRONG; i++) {
        const wrong *w = WRONG + i;
        double points[8], knots[7];
        memcpy(points, POINTS, sizeof points), memcpy(knots, KNOTS, sizeof knots);
        if (w->of_points)
            points[w->at] = w->value;
        else if (w->at)
            knots[w->at] = w->value;
        bat_problem problem;
        bat_curve *curve = NULL;
        const bat_status status = bat_curve_create(w->dimension, w->degree, w->closed, w->count, points,
                                                   w->knot_count, knots, &curve);
        assert_int_not_equal(status, BAT_OK);
        assert_int_equal(bat_curve_check(w->dimension, w->degree, w->closed, w->count, points, w->knot_count,
                                         knots, &problem),
                         status);
        assert_string_equal(problem.place, w->place);
        assert_memory_equal(problem.message, w->message, strlen(w->message));
        assert_int_equal(
            bat_curve_check(w->dimension, w->degree, w->closed, w->count, points, w->knot_count, knots, NULL),
            status);
    }
    assert_int_equal(bat_curve_check(2, 2, false, 4, POINTS, 7, KNOTS, NULL), BAT_OK);
    assert_int_equal(bat_curve_check(2, 2, false, 4, NULL, 7, KNOTS, NULL), BAT_ARGUMENT);
}

/* Few values for each argument, so that much is right and much is wrong. */
static void the_status_is_that_of_what_makes_it(void **state) {
    (void)state;
    random_source r = {77};
    int refused = 0;
    for (int round = 0; round < 20000; round++) {
        double points[75], knots[2][12];
        for (int i = 0; i < 75; i++)
            points[i] = random_int(&r, 0, 400) ? (double)random_int(&r, -3, 3) : (double)NAN;
        int degree[2], knot_count[2];
        bool closed[2];
        size_t count[2];
        for (int d = 0; d < 2; d++) {
            degree[d] = random_int(&r, 0, 12) ? random_int(&r, 1, 3) : 8;
            closed[d] = random_int(&r, 0, 2) == 0;
            count[d] = (size_t)random_int(&r, 1, 5);
            knot_count[d] = (int)count[d] + (closed[d] ? 1 : degree[d] + 1) - (random_int(&r, 0, 9) == 0);
            if (knot_count[d] > 12) knot_count[d] = 12;
            for (int i = 0; i < 12; i++)
                knots[d][i] = i == 0 ? 0
                                     : knots[d][i - 1] + random_int(&r, random_int(&r, 0, 15) ? 0 : -1, 2);
        }
        bat_problem problem = {"", ""};
        bat_surface *surface = NULL;
        const bat_status status = bat_surface_create(degree, closed, count, points, knot_count, knots[0],
                                                     knots[1], &surface);
        bat_surface_free(surface);
        assert_int_equal(
            bat_surface_check(degree, closed, count, points, knot_count, knots[0], knots[1], &problem),
            status);
        assert_int_equal(problem.message[0] != 0, status != BAT_OK);
        refused += status != BAT_OK;
        bat_curve *curve = NULL;
        const bat_status of_curve = bat_curve_create(3, degree[0], closed[0], count[0], points, knot_count[0],
                                                     knots[0], &curve);
        bat_curve_free(curve);
        assert_int_equal(
            bat_curve_check(3, degree[0], closed[0], count[0], points, knot_count[0], knots[0], NULL),
            of_curve);
    }
    assert_in_range(refused, 5000, 19500);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_is_named),
                                       cmocka_unit_test(the_status_is_that_of_what_makes_it)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
