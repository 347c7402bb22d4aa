/*
 * A free stroke over a shape: the base is the result of the sketch hand, bit for bit; beyond the stretch the finest
 * curve stays, in the plane and in space, open and closed; on it details are kept or dropped as requested.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/levels.h>

#include "curve/curve.h"
#include "support/alloc_fail.h"
#include "support/shapes.h"

static uint64_t seed;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) / 9007199254740992.0;
}

static bat_curve *base_of(int dimension, bool closed, int count) {
    double points[200], knots[80], t = 0;
    for (int i = 0; i < count; i++) {
        double a = 6.283185307179586 * i / count, *x = points + i * dimension;
        x[0] = closed ? 900 * cos(a) : 60.0 * i, x[1] = closed ? 900 * sin(a) : 40 * sin(0.5 * i);
        if (dimension == 3) x[2] = 120 * sin(closed ? 2 * a : 0.3 * i);
        for (int d = 0; d < dimension; d++) x[d] += uniform(-5, 5);
    }
    for (int i = 0; i < (closed ? count + 1 : count + 4); i++) {
        knots[i] = t;
        if (closed || (i >= 3 && i < count)) t += uniform(50, 80);
    }
    bat_curve *curve;
    assert_int_equal(bat_curve_create(dimension, 3, closed, (size_t)count, points,
                                      closed ? count + 1 : count + 4, knots, &curve),
                     BAT_OK);
    return curve;
}

static bat_shape *shape_of(int round) {
    bat_curve *base = base_of(2 + round % 2, (round / 2) % 2, 34);
    bat_shape *shape;
    assert_int_equal(bat_shape_create(base, NULL, &shape), BAT_OK);
    bat_curve_free(base);
    for (int l = 1; l <= 2; l++) {
        assert_int_equal(bat_shape_add_level(shape, 0, NULL, NULL, NULL), BAT_OK);
        for (int i = 0; i < bat_point_count(shape_finest(shape)); i++)
            assert_int_equal(
                bat_shape_move(shape, l, i, (double[]){uniform(-9, 9), uniform(-9, 9), uniform(-9, 9)}),
                BAT_OK);
    }
    assert_int_equal(bat_shape_commit(shape), BAT_OK);
    return shape;
}

/* A bulge over the base between two parameters, past the end of an open one when b is beyond it. */
static void stroke_over(const bat_curve *base, double a, double b, double *points, bat_stroke *stroke) {
    enum { COUNT = 200 };
    int size = bat_curve_dimension(base);
    double domain[2];
    bat_curve_domain(base, domain);
    for (int i = 0; i < COUNT; i++) {
        double w = (double)i / (COUNT - 1), u = a + (b - a) * w;
        bat_curve_eval(base, bat_curve_is_closed(base) ? u : fmin(u, domain[1]), 0, points + i * size);
        if (!bat_curve_is_closed(base) && u > domain[1]) points[i * size] += u - domain[1];
        points[i * size + 1] += 30 * sin(3.14159265 * w) * sin(3.14159265 * w);
    }
    *stroke = (bat_stroke){size, COUNT, points, NULL, NULL};
}

static void redraws(void **state) {
    (void)state;
    seed = 31;
    int outside = 0, bare = 0, wrinkled = 0;
    for (int round = 0; round < 24; round++) {
        bat_shape *shape = shape_of(round), *kept, *dropped;
        const bat_curve *base = bat_shape_curve(shape, 0);
        bool closed = bat_curve_is_closed(base), past = !closed && round % 3 == 2,
             round_seam = closed && round % 3 == 2;
        double domain[2], points[600];
        bat_curve_domain(base, domain);
        double whole = domain[1] - domain[0], a = domain[0] + (past || round_seam ? 0.7 : 0.35) * whole,
               b = domain[0] + (past || round_seam ? 1.04 : 0.65) * whole;
        bat_stroke stroke;
        stroke_over(base, a, b, points, &stroke);
        bat_curve *expected;
        bat_sketch_report report, facts;
        assert_int_equal(bat_sketch(base, &stroke, NULL, &expected, &facts), BAT_OK);
        assert_int_equal(bat_shape_redraw(shape, &stroke, false, NULL, &kept, &report), BAT_OK);
        assert_int_equal(bat_shape_redraw(shape, &stroke, true, NULL, &dropped, NULL), BAT_OK);
        assert_true(bat_curve_is_equal(expected, bat_shape_curve(kept, 0)));
        assert_true(bat_curve_is_equal(expected, bat_shape_curve(dropped, 0)));
        assert_true(report.changed[0] == facts.changed[0] && !report.replaced);
        assert_true(bat_shape_levels(kept) == 2);
        double size = bat_curve_size(base), margin = 4 * 80;
        double moved = (report.changed_new[1] - report.changed_new[0]) -
                       (report.changed[1] - report.changed[0]);
        for (int i = 0; i <= 400; i++) {
            double u = domain[0] + whole * i / 400, x = u - report.changed[0], p[3], q[3], v = u;
            if (closed) x -= floor(x / whole) * whole;
            double reach = report.changed[1] - report.changed[0];
            if (x > -margin && x < reach + margin && (x >= 0 || !closed)) continue;
            if (closed && x > whole - margin) continue;
            if (x > 0) v = report.changed[0] + x + moved; /* closed: a period further on, maybe */
            bat_curve_eval(shape_finest(shape), u, 0, p);
            for (int k = 0; k < 2; k++) {
                bat_curve_eval(shape_finest(k ? dropped : kept), v, 0, q);
                for (int d = 0; d < bat_curve_dimension(base); d++)
                    assert_true(fabs(p[d] - q[d]) < 1e-9 * size);
            }
            outside++;
        }
        for (int i = 0; i <= 20; i++) {
            double low = report.changed_new[0] + margin, high = report.changed_new[1] - margin, p[3], q[3],
                   far = 0;
            if (low > high) continue;
            double u = low + (high - low) * i / 20;
            bat_curve_eval(expected, u, 0, p);
            bat_curve_eval(shape_finest(dropped), u, 0, q);
            for (int d = 0; d < bat_curve_dimension(base); d++) assert_true(fabs(p[d] - q[d]) < 1e-9 * size);
            bat_curve_eval(shape_finest(kept), u, 0, q);
            for (int d = 0; d < bat_curve_dimension(base); d++) far = fmax(far, fabs(p[d] - q[d]));
            bare++, wrinkled += far > 0.5;
        }
        bat_curve_free(expected);
        bat_shape_free(kept);
        bat_shape_free(dropped);
        bat_shape_free(shape);
    }
    assert_true(outside > 1000 && bare > 100 && wrinkled > bare * 3 / 4);
}

static void failures(void **state) {
    (void)state;
    seed = 32;
    bat_shape *shape = shape_of(1), *out = NULL;
    double points[600], dot[3] = {0, 0, 0};
    bat_stroke stroke, speck = {3, 1, dot, NULL, NULL};
    stroke_over(bat_shape_curve(shape, 0), 600, 1100, points, &stroke);
    assert_int_equal(bat_shape_redraw(NULL, &stroke, false, NULL, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_shape_redraw(shape, &speck, false, NULL, &out, NULL), BAT_DOT);
    for (int i = 0; i < 200; i++) points[3 * i + 1] += 1e6;
    assert_int_equal(bat_shape_redraw(shape, &stroke, false, NULL, &out, NULL), BAT_FAR);
    for (int i = 0; i < 200; i++) points[3 * i + 1] -= 1e6;
    for (int n = 1;; n++) {
        long before = alloc_live();
        alloc_fail_at(n);
        bat_status status = bat_shape_redraw(shape, &stroke, false, NULL, &out, NULL);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            break;
        }
        if (status == BAT_OK) { /* the sketch can do without some */
            bat_shape_free(out);
            out = NULL;
        } else {
            assert_int_equal(status, BAT_MEMORY);
        }
        assert_null(out);
        assert_true(alloc_live() == before);
    }
    bat_shape_free(out);
    bat_shape_free(shape);
}

/* A G1 spline is a base; flat is the finest curve. */
static void splines_and_flattening(void **state) {
    (void)state;
    const double points[10] = {0, 0, 50, 80, 120, 60, 180, -20, 260, 10};
    const bat_spline spline = {.dimension = 2, .count = 5, .points = points};
    bat_shape *shape = NULL;
    bat_curve *expected, *flat;
    assert_int_equal(bat_tangents(&spline, NULL, NULL, NULL, NULL, &expected), BAT_OK);
    assert_int_equal(bat_shape_from_spline(&spline, NULL, NULL, &shape), BAT_OK);
    assert_true(bat_curve_is_equal(expected, bat_shape_curve(shape, 0)));
    assert_int_equal(bat_shape_add_level(shape, 0, NULL, NULL, NULL), BAT_OK);
    assert_int_equal(bat_shape_move(shape, 1, 4, (double[]){3, 9}), BAT_OK);
    assert_int_equal(bat_shape_flatten(shape, &flat), BAT_OK);
    assert_true(bat_curve_is_equal(flat, shape_finest(shape)));
    assert_int_equal(bat_shape_flatten(NULL, &flat), BAT_ARGUMENT);
    bat_curve_free(flat);
    bat_curve_free(expected);
    bat_shape_free(shape);
    const bat_spline none = {.dimension = 2, .count = 1, .points = points};
    assert_int_equal(bat_shape_from_spline(&none, NULL, NULL, &shape), BAT_COUNT);
    assert_int_equal(bat_shape_from_spline(NULL, NULL, NULL, &shape), BAT_ARGUMENT);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(redraws),
        cmocka_unit_test(failures),
        cmocka_unit_test(splines_and_flattening),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
