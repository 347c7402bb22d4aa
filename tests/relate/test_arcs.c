/* Curves as arcs: the curve and the arcs are nowhere further from each other than the tolerance, the arcs follow each other
 * on one tangent wherever the curve does, a third of the tolerance's order tells their number, and lines stay lines. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/nearest.h>
#include <batten/relate.h>
#include "support/random_curve.h"

static const double CORNER = 0.02;

/* How far the end of an arc has turned from its start, with its sign; 0 for lines. */
static double sweep_of(const bat_arc *arc) {
    if (!(arc->radius > 0)) return 0;
    const double a = atan2(arc->from[1] - arc->centre[1], arc->from[0] - arc->centre[0]);
    const double b = atan2(arc->to[1] - arc->centre[1], arc->to[0] - arc->centre[0]);
    double sweep = arc->ccw ? b - a : a - b;
    if (sweep < 0) sweep += 2 * acos(-1);
    return arc->ccw ? sweep : -sweep;
}

static void on_arc(const bat_arc *arc, double share, double *point) {
    for (int c = 0; c < 2; c++) point[c] = arc->from[c] + share * (arc->to[c] - arc->from[c]);
    if (!(arc->radius > 0)) return;
    const double a = atan2(arc->from[1] - arc->centre[1], arc->from[0] - arc->centre[0]) +
                     share * sweep_of(arc);
    point[0] = arc->centre[0] + arc->radius * cos(a), point[1] = arc->centre[1] + arc->radius * sin(a);
}

static double heading(const bat_arc *arc, bool at_end) {
    const double *x = at_end ? arc->to : arc->from;
    if (!(arc->radius > 0)) return atan2(arc->to[1] - arc->from[1], arc->to[0] - arc->from[0]);
    return atan2(x[1] - arc->centre[1], x[0] - arc->centre[0]) + (arc->ccw ? 1 : -1) * acos(-1) / 2;
}

static double to_arc(const bat_arc *arc, const double *x) {
    double best = fmin(hypot(x[0] - arc->from[0], x[1] - arc->from[1]),
                       hypot(x[0] - arc->to[0], x[1] - arc->to[1]));
    if (arc->radius > 0) {
        bat_arc part = *arc;
        const double dx = x[0] - arc->centre[0], dy = x[1] - arc->centre[1], r = hypot(dx, dy);
        part.to[0] = arc->centre[0] + arc->radius * dx / r,
        part.to[1] = arc->centre[1] + arc->radius * dy / r;
        if (fabs(sweep_of(&part)) <= fabs(sweep_of(arc))) best = fmin(best, fabs(r - arc->radius));
    } else {
        const double dx = arc->to[0] - arc->from[0], dy = arc->to[1] - arc->from[1],
                     square = dx * dx + dy * dy;
        const double t = ((x[0] - arc->from[0]) * dx + (x[1] - arc->from[1]) * dy) / square;
        if (t > 0 && t < 1)
            best = fmin(best, fabs((x[0] - arc->from[0]) * dy - (x[1] - arc->from[1]) * dx) / sqrt(square));
    }
    return best;
}

/* Whether the curve has one tangent around a point of it. */
static bool smooth_at(const bat_curve *curve, const double *point) {
    bat_near near;
    double before[4], behind[4], domain[2];
    bat_curve_domain(curve, domain);
    const double step = 1e-6 * (domain[1] - domain[0]);
    bat_curve_nearest(curve, point, &near);
    bat_curve_eval(curve, near.u - step, 1, before), bat_curve_eval(curve, near.u + step, 1, behind);
    const double cross = before[2] * behind[3] - before[3] * behind[2],
                 along = before[2] * behind[2] + before[3] * behind[3];
    return fabs(atan2(cross, along)) < 1e-3;
}

static void arcs_are_the_curve(void **state) {
    (void)state;
    random_source r = {7};
    size_t all = 0;
    for (int round = 0; round < 120; round++) {
        const int p = random_int(&r, 1, 6), kind = random_int(&r, 0, 2);
        bat_curve *curve = random_curve(&r, p, 2, kind, random_int(&r, 0, 9));
        const double size = bat_curve_size(curve), tolerance = size * pow(10, -random_between(&r, 1.5, 5));
        size_t count;
        bat_arc *arcs;
        double error;
        assert_int_equal(bat_curve_arcs(curve, tolerance, CORNER, &count, &arcs, &error), BAT_OK);
        assert_true(count > 0 && error <= tolerance);
        for (size_t i = 0; i < count; i++) {
            for (int k = 0; k <= 6; k++) {
                double x[2];
                bat_near near;
                on_arc(arcs + i, k / 6.0, x);
                bat_curve_nearest(curve, x, &near);
                assert_true(near.distance <= tolerance * (1 + 1e-6) + 1e-12 * size);
            }
            if (i + 1 == count) continue;
            assert_true(arcs[i].to[0] == arcs[i + 1].from[0] && arcs[i].to[1] == arcs[i + 1].from[1]);
            const double turn = remainder(heading(arcs + i + 1, false) - heading(arcs + i, true),
                                          2 * acos(-1));
            if (smooth_at(curve, arcs[i].to)) assert_true(fabs(turn) <= 1e-6);
        }
        double u[400], x[800];
        bat_curve_spread(curve, 400, u);
        assert_int_equal(bat_curve_eval_many(curve, 400, u, 0, x), BAT_OK);
        for (int k = 0; k < 400; k++) {
            double best = INFINITY;
            for (size_t i = 0; i < count; i++) best = fmin(best, to_arc(arcs + i, x + 2 * k));
            assert_true(best <= tolerance * (1 + 1e-6) + 1e-12 * size);
        }
        all += count;
        bat_free(arcs), bat_curve_free(curve);
    }
    assert_true(all > 2000);
}

static void few_arcs_are_enough(void **state) {
    (void)state;
    /* y = x^2: pairs of arcs are of the third order, so that an eighth of the tolerance doubles them */
    const double points[] = {-1, 1, 0, -1, 1, 1}, knots[] = {0, 0, 0, 1, 1, 1};
    bat_curve *parabola;
    assert_int_equal(bat_curve_create(2, 2, false, 3, points, 6, knots, &parabola), BAT_OK);
    size_t before = 0;
    for (double tolerance = 1e-3; tolerance > 1e-12; tolerance /= 8) {
        size_t count;
        bat_arc *arcs;
        assert_int_equal(bat_curve_arcs(parabola, tolerance, CORNER, &count, &arcs, NULL), BAT_OK);
        if (before)
            assert_true((double)count <= 2.0 * (double)before + 2 &&
                        (double)count >= 1.6 * (double)before - 2);
        before = count;
        bat_free(arcs);
    }
    bat_curve_free(parabola);
}

static void lines_stay_lines(void **state) {
    (void)state;
    const double points[] = {0, 0, 10, 0, 10, 5, 0, 5};
    bat_curve *square;
    assert_int_equal(bat_curve_create(2, 1, true, 4, points, 5, (const double[]){0, 1, 2, 3, 4}, &square),
                     BAT_OK);
    size_t count;
    bat_arc *arcs;
    double error;
    assert_int_equal(bat_curve_arcs(square, 0.01, CORNER, &count, &arcs, &error), BAT_OK);
    assert_int_equal(count, 4);
    for (size_t i = 0; i < count; i++) assert_true(arcs[i].radius == 0);
    assert_true(error <= 1e-15);
    bat_free(arcs), bat_curve_free(square);
    bat_curve *straight; /* uneven, but straight */
    assert_int_equal(
        bat_curve_create_clamped(2, 3, 5, (const double[]){0, 0, 1, 1, 5, 5, 6, 6, 9, 9}, &straight), BAT_OK);
    assert_int_equal(bat_curve_arcs(straight, 1e-6, CORNER, &count, &arcs, NULL), BAT_OK);
    assert_true(count == 1 && arcs[0].radius == 0);
    bat_free(arcs), bat_curve_free(straight);
}

static void cusps_and_dots_end(void **state) {
    (void)state;
    /* a cusp at the middle; a curve that turns back on itself; one place only */
    const double cases[][8] = {{0, 0, 10, 10, 0, 10, 10, 0},
                               {0, 0, 10, 0, -5, 0, 5, 0},
                               {1, 1, 1, 1, 1, 1, 1, 1},
                               {0, 0, 0, 0, 10, 10, 10, 10}};
    for (size_t i = 0; i < 4; i++)
        for (double tolerance = 1; tolerance > 1e-10; tolerance /= 1000) {
            bat_curve *curve;
            assert_int_equal(bat_curve_create_clamped(2, 3, 4, cases[i], &curve), BAT_OK);
            size_t count;
            bat_arc *arcs;
            assert_int_equal(bat_curve_arcs(curve, tolerance, CORNER, &count, &arcs, NULL), BAT_OK);
            assert_true(count <= 20000 && (count > 0) == (i != 2));
            for (int k = 0; k <= 50; k++) {
                double x[2], best = i == 2 ? 0 : INFINITY;
                bat_curve_eval(curve, k / 50.0, 0, x);
                for (size_t j = 0; j < count; j++) best = fmin(best, to_arc(arcs + j, x));
                assert_true(best <= tolerance + 1e-9);
            }
            bat_free(arcs), bat_curve_free(curve);
        }
}

static void bad_arguments(void **state) {
    (void)state;
    bat_curve *space;
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, (const double[]){0, 0, 0, 1, 1, 1}, &space), BAT_OK);
    size_t count;
    bat_arc *arcs;
    assert_int_equal(bat_curve_arcs(space, 1, 0, &count, &arcs, NULL), BAT_DIMENSION);
    assert_int_equal(bat_curve_arcs(space, (double)NAN, 0, &count, &arcs, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_arcs(NULL, 1, 0, &count, &arcs, NULL), BAT_ARGUMENT);
    bat_curve_free(space);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arcs_are_the_curve), cmocka_unit_test(few_arcs_are_enough),
        cmocka_unit_test(lines_stay_lines),   cmocka_unit_test(cusps_and_dots_end),
        cmocka_unit_test(bad_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
