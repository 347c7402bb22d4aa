/* Extremes are where a dense polyline turns back; an outline refitted on them has its joints there, level and upright to the bit, whole
 * numbers with a grid, and stays within the tolerance; a wobble within it makes no joint. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <math.h>
#include <cmocka.h>
#include <batten/fit.h>
#include <batten/measure.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { POINTS = 24, DENSE = 4000, MOST = 64 };
static const double TURN = 6.283185307179586, CORNER = 0.05;

/* A closed cubic around (x, y): an ellipse whose radii vary by `wobble` of them, `waves` times. */
static bat_curve *ring(double a, double b, double turn, double wobble, int waves) {
    double points[2 * POINTS], knots[POINTS + 1];
    bat_curve *out = NULL;
    for (int i = 0; i < POINTS; i++) {
        const double w = TURN * i / POINTS, r = 1 + wobble * sin(waves * w);
        const double x = a * r * cos(w), y = b * r * sin(w);
        points[2 * i] = 300 + x * cos(turn) - y * sin(turn),
                   points[2 * i + 1] = 200 + x * sin(turn) + y * cos(turn);
    }
    for (int i = 0; i <= POINTS; i++) knots[i] = i;
    assert_int_equal(bat_curve_create(2, 3, true, POINTS, points, POINTS + 1, knots, &out), BAT_OK);
    return out;
}

static double coordinate(const bat_curve *curve, double u, int axis) {
    double at[2];
    bat_curve_eval(curve, u, 0, at);
    return at[axis];
}

static void extremes_are_where_it_turns_back(void **state) {
    (void)state;
    random_source r = {5};
    for (int i = 0; i < 60; i++) {
        bat_curve *curve = random_curve(&r, random_int(&r, 1, 4), 2, i % 3, 4);
        for (int axis = 0; axis < 2; axis++) {
            double u[MOST], domain[2];
            const size_t count = bat_curve_extremes(curve, axis, MOST, u);
            assert_int_equal(bat_curve_extremes(curve, axis, 0, NULL), count);
            assert_true(count < MOST && (!bat_curve_is_closed(curve) || (count > 0 && count % 2 == 0)));
            bat_curve_domain(curve, domain);
            /* Between them, and from an open curve's start and to its end, it only rises or only falls. */
            for (size_t k = 0; k + 1 < count; k++) {
                const double from = coordinate(curve, u[k], axis), to = coordinate(curve, u[k + 1], axis);
                double last = from;
                assert_true(u[k] < u[k + 1]);
                for (int s = 1; s < 100; s++) {
                    const double now = coordinate(curve, u[k] + (u[k + 1] - u[k]) * s / 100, axis);
                    assert_true(to > from ? now >= last - 1e-9 * fabs(to - from)
                                          : now <= last + 1e-9 * fabs(to - from));
                    last = now;
                }
            }
        }
        bat_curve_free(curve);
    }
}

/* How many cubics, all joined at knots of multiplicity three. Handles at extremes lie along an axis to the bit. */
static int joints(const bat_curve *made, double grid, double low[2], double high[2], int *level) {
    const double *p = bat_curve_points(made);
    const int n = (int)bat_curve_count(made), cubics = n / 3;
    *level = 0;
    for (int c = 0; c < 2; c++) low[c] = INFINITY, high[c] = -INFINITY;
    for (int i = 2; i < n; i += 3) {
        const double *in = p + 2 * (i - 1), *at = p + 2 * i, *out = p + 2 * ((i + 1) % n);
        *level += (in[0] == at[0] && at[0] == out[0]) || (in[1] == at[1] && at[1] == out[1]);
        for (int c = 0; c < 2; c++) low[c] = fmin(low[c], at[c]), high[c] = fmax(high[c], at[c]);
    }
    for (int i = 0; i < 2 * n && grid > 0; i++) assert_true(p[i] == round(p[i] / grid) * grid);
    return cubics;
}

static void rings_meet_at_extremes(void **state) {
    (void)state;
    for (int i = 0; i < 12; i++) {
        const double grid = i % 3 == 2 ? 1 : 0, tolerance = 1;
        /* the third of each is an ellipse that wobbles by less than the tolerance */
        bat_curve *curve = ring(120, 80 + 10 * i, 0.2 * i, i % 3 ? 0.0005 : 0.12, i % 3 ? 9 : 3),
                  *made = NULL;
        double low[2], high[2], a[2], b[2], error;
        int level;
        assert_int_equal(bat_curve_refit_extremes(curve, tolerance, CORNER, grid, &made, &error), BAT_OK);
        assert_true(error <= tolerance + 0.75 * grid + (grid > 0 ? 0.75 : 0));
        const int cubics = joints(made, grid, low, high, &level);
        assert_true(level >= 4);
        if (i % 3) assert_true(cubics <= 6 && level == 4);
        bat_curve_bounds(curve, a, b);
        for (int c = 0; c < 2; c++) {
            assert_true(fabs(low[c] - a[c]) <= 1e-9 * 200 + 0.5 * grid + (i % 3 ? 0.2 : 0));
            assert_true(fabs(high[c] - b[c]) <= 1e-9 * 200 + 0.5 * grid + (i % 3 ? 0.2 : 0));
        }
        bat_curve_free(curve), bat_curve_free(made);
    }
    bat_curve *round = ring(100, 100, 0, 0, 1), *made = NULL;
    double low[2], high[2];
    int level;
    assert_int_equal(bat_curve_refit_extremes(round, 0.5, CORNER, 1, &made, NULL), BAT_OK);
    assert_int_equal(joints(made, 1, low, high, &level), 4);
    bat_curve_free(round), bat_curve_free(made);
}

static void corners_ends_and_lines_stay(void **state) {
    (void)state;
    const double box[8] = {10, 10, 90, 10, 90, 60, 10, 60}, knots[5] = {0, 1, 2, 3, 4};
    const double bow[8] = {0, 0, 40, 90, 110, 90, 130, 5};
    bat_curve *curve = NULL, *made = NULL;
    double error, at[2], domain[2];
    assert_int_equal(bat_curve_create(2, 1, true, 4, box, 5, knots, &curve), BAT_OK);
    assert_int_equal(bat_curve_refit_extremes(curve, 0.5, CORNER, 1, &made, &error), BAT_OK);
    assert_int_equal(bat_curve_count(made), 12);
    assert_true(error < 1e-12 * 100);
    bat_curve_free(curve), bat_curve_free(made);
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, bow, &curve), BAT_OK);
    assert_int_equal(bat_curve_refit_extremes(curve, 0.5, CORNER, 0, &made, &error), BAT_OK);
    assert_true(bat_curve_count(made) <= 7 && error <= 0.5);
    bat_curve_domain(made, domain);
    for (int side = 0; side < 2; side++) {
        bat_curve_eval(made, domain[side], 0, at);
        for (int c = 0; c < 2; c++) assert_true(at[c] == bow[6 * side + c]);
    }
    bat_curve_free(curve), bat_curve_free(made);
}

static void what_cannot_be(void **state) {
    (void)state;
    bat_curve *curve = ring(100, 60, 0, 0, 1), *space = NULL, *out = NULL;
    assert_int_equal(bat_curve_refit_extremes(NULL, 1, 0, 0, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_refit_extremes(curve, 0, 0, 0, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_refit_extremes(curve, NAN, 0, 0, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_refit_extremes(curve, 1, -1, 0, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_refit_extremes(curve, 1, 0, -1, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_refit_extremes(curve, 1, 0, 1e6, &out, NULL), BAT_COUNT);
    assert_int_equal(bat_curve_to_dimension(curve, 3, &space), BAT_OK);
    assert_int_equal(bat_curve_refit_extremes(space, 1, 0, 0, &out, NULL), BAT_DIMENSION);
    assert_int_equal(bat_curve_extremes(space, 0, 0, NULL), 0);
    assert_int_equal(bat_curve_extremes(curve, 2, 0, NULL), 0);
    assert_null(out);
    const long live = alloc_live();
    bool reached = true;
    for (long n = 1; reached; n++) {
        alloc_fail_at(n);
        const bat_status status = bat_curve_refit_extremes(curve, 1, CORNER, 1, &out, NULL);
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        bat_curve_free(out), out = NULL;
        assert_int_equal(alloc_live(), live);
    }
    bat_curve_free(curve), bat_curve_free(space);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(extremes_are_where_it_turns_back),
        cmocka_unit_test(rings_meet_at_extremes),
        cmocka_unit_test(corners_ends_and_lines_stay),
        cmocka_unit_test(what_cannot_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
