/*
 * Curves made symmetric: the control points mirror each other to rounding, the tangent at the axis is perpendicular to
 * it and the curvature is continuous; far from the axis the kept half is the original curve, bit for bit; near it the
 * curve stays within the tolerance. Curves that only touch the axis, cross it too often or lie apart from it are
 * refused. Axes of any direction.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "curve/mirror.h"
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>
#include <math.h>
#include <string.h>

static const double REACH = 12, TOLERANCE = 0.5;

static bat_mirror axis(double x, double y, double degrees) {
    const double a = degrees * 3.14159265358979323846 / 180;
    bat_mirror m = {true, {x, y}, {cos(a), sin(a)}};
    if (degrees == 90) m.along[0] = 0, m.along[1] = 1;
    return m;
}

/* Places given in coordinates of the axis: across, along. */
static bat_curve *laid(const bat_mirror *m, int degree, size_t count, const double *at) {
    double points[64];
    bat_curve *curve = NULL;
    for (size_t i = 0; i < count; i++) {
        points[2 * i] = m->at[0] + at[2 * i] * m->along[1] + at[2 * i + 1] * m->along[0];
        points[2 * i + 1] = m->at[1] - at[2 * i] * m->along[0] + at[2 * i + 1] * m->along[1];
    }
    assert_int_equal(bat_curve_create_clamped(2, degree, count, points, &curve), BAT_OK);
    return curve;
}

/* Control points and knots are those of the image run backwards; closed ones: of some turn of it. */
static void is_symmetric(const bat_mirror *m, const bat_curve *curve) {
    const size_t n = bat_curve_count(curve);
    const double *points = bat_curve_points(curve), size = bat_curve_size(curve);
    const bool closed = bat_curve_is_closed(curve);
    double least = INFINITY;
    for (size_t turn = 0; turn < (closed ? n : 1); turn++) {
        double worst = 0, at[2];
        for (size_t i = 0; i < n; i++) {
            const double *p = points + 2 * i, *q = points + 2 * ((2 * n - 1 - i + turn) % n);
            bat_mirror_point(m, p, at);
            worst = fmax(worst, hypot(at[0] - q[0], at[1] - q[1]));
        }
        least = fmin(least, worst);
    }
    assert_true(least <= 1e-12 * size);
    const double *t = bat_curve_knots(curve);
    const int count = bat_curve_knot_count(curve);
    if (!closed)
        for (int i = 0; i < count; i++) assert_true(t[i] == -t[count - 1 - i]);
}

/* At the parameter it is on the axis, runs straight across it, and is C2. */
static void crosses_well(const bat_mirror *m, const bat_curve *curve, double u) {
    double left[6], right[6];
    const double size = bat_curve_size(curve);
    bat_curve_eval_left(curve, u, 2, left);
    bat_curve_eval(curve, u, 2, right);
    assert_true(fabs(bat_mirror_side(m, right)) <= 1e-12 * size);
    const double speed = hypot(right[2], right[3]);
    assert_true(fabs(right[2] * m->along[0] + right[3] * m->along[1]) <= 1e-9 * speed);
    for (int k = 2; k < 6; k++) assert_true(fabs(left[k] - right[k]) <= 1e-9 * (speed + size));
}

/* The whole passes the curve's stretch u0..u1 within the tolerance. */
static void follows(const bat_curve *whole, const bat_curve *curve, double u0, double u1, double within) {
    for (int i = 0; i <= 200; i++) {
        double at[2];
        bat_near near;
        bat_curve_eval(curve, u0 + (u1 - u0) * i / 200, 0, at);
        assert_int_equal(bat_curve_nearest(whole, at, &near), BAT_OK);
        assert_true(near.distance <= within);
    }
}

static const double degrees[] = {90, 0, 37, -120};

static void one_across_keeps_its_longer_side(void **state) {
    (void)state;
    static const double at[] = {-300, 40, -220, -60, -160, 20, -60, 60, 0, 10, 40, 30, 90, 60, 120, 80};
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++)
        for (int degree = 1; degree <= 5; degree++) {
            const bat_mirror m = axis(500, 400, degrees[i]);
            bat_curve *curve = laid(&m, degree, 8, at), *whole = NULL;
            assert_int_equal(bat_mirror_whole(&m, curve, 0, REACH, TOLERANCE, &whole), BAT_OK);
            is_symmetric(&m, whole);
            crosses_well(&m, whole, 0);
            assert_false(bat_curve_is_closed(whole));
            double domain[2], first[2], start[2];
            bat_curve_domain(curve, domain);
            double lo = domain[0], hi = domain[1], mid = 0, p[2];
            for (int k = 0; k < 80; k++) {
                mid = (lo + hi) / 2;
                bat_curve_eval(curve, mid, 0, p);
                if (bat_mirror_side(&m, p) < 0)
                    lo = mid;
                else
                    hi = mid;
            }
            follows(whole, curve, domain[0], mid, TOLERANCE + 1e-9);
            /* It runs as it was drawn, and its end is the one that was drawn. */
            bat_curve_eval(curve, domain[0], 0, first);
            bat_curve_domain(whole, domain);
            bat_curve_eval(whole, domain[0], 0, start);
            assert_true(hypot(first[0] - start[0], first[1] - start[1]) <= 1e-9);
            bat_curve_free(curve);
            bat_curve_free(whole);
        }
}

static void the_other_side_can_be_asked_for(void **state) {
    (void)state;
    static const double at[] = {-300, 0, -200, 50, -100, 0, 30, 10, 60, -20, 100, 0};
    const bat_mirror m = axis(0, 0, 90);
    bat_curve *curve = laid(&m, 3, 6, at), *whole = NULL;
    for (int side = -1; side <= 1; side += 2) {
        double low[2], high[2];
        assert_int_equal(bat_mirror_whole(&m, curve, side, REACH, TOLERANCE, &whole), BAT_OK);
        is_symmetric(&m, whole);
        bat_curve_bounds(whole, low, high);
        assert_true(fabs(high[0] - (side < 0 ? 300 : 100)) < 1e-9);
        bat_curve_free(whole);
    }
    bat_curve_free(curve);
}

static void ends_come_to_the_axis(void **state) {
    (void)state;
    /* stops short by 8; reaches over by 8; oblique; both ends */
    static const double at[][12] = {{-300, 0, -240, 60, -180, 60, -120, 20, -60, 0, -8, 0},
                                    {-300, 0, -240, 60, -180, 60, -120, 20, -60, 0, 8, 0},
                                    {-300, 0, -240, 60, -180, 120, -120, 180, -60, 240, 0, 300},
                                    {-5, 300, -200, 290, -300, 200, -320, 60, -150, -80, 4, -100}};
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++)
        for (int k = 0; k < 4; k++) {
            const bat_mirror m = axis(-20, 7, degrees[i]);
            bat_curve *curve = laid(&m, 3, 6, at[k]), *whole = NULL;
            assert_int_equal(bat_mirror_whole(&m, curve, 0, REACH, TOLERANCE, &whole), BAT_OK);
            is_symmetric(&m, whole);
            assert_true(bat_curve_is_closed(whole) == (k == 3));
            double domain[2];
            bat_curve_domain(whole, domain);
            crosses_well(&m, whole, 0);
            if (k == 3) crosses_well(&m, whole, (domain[0] + domain[1]) / 2);
            bat_curve_domain(curve, domain);
            follows(whole, curve, domain[0], domain[1], k == 2 ? TOLERANCE + 1e-9 : 17);
            bat_curve_free(curve);
            bat_curve_free(whole);
        }
}

static void far_from_the_axis_it_is_bitwise_the_curve(void **state) {
    (void)state;
    static const double at[] = {300, 40, 260, -60, 220, 20, 180, 60, 140, 10,
                                100, 30, 60,  60,  20,  80, -10, 70, -40, 90};
    const bat_mirror m = axis(12.5, 3.25, 90);
    bat_curve *curve = laid(&m, 3, 10, at), *whole = NULL;
    assert_int_equal(bat_mirror_whole(&m, curve, 0, REACH, TOLERANCE, &whole), BAT_OK);
    assert_memory_equal(bat_curve_points(whole), bat_curve_points(curve), 5 * 2 * sizeof(double));
    /* And what is symmetric already stays as it is. */
    bat_curve *again = NULL;
    assert_int_equal(bat_mirror_whole(&m, whole, 1, REACH, TOLERANCE, &again), BAT_OK);
    assert_int_equal(bat_curve_count(again), bat_curve_count(whole));
    for (size_t i = 0; i < 2 * bat_curve_count(whole); i++)
        assert_true(fabs(bat_curve_points(again)[i] - bat_curve_points(whole)[i]) <= 1e-10);
    assert_true(bat_mirror_twins(&m, whole, again, 1e-9));
    bat_curve_free(curve);
    bat_curve_free(whole);
    bat_curve_free(again);
}

static void rings_stay_rings(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++)
        for (int degree = 2; degree <= 5; degree++) {
            const bat_mirror m = axis(30, 50, degrees[i]);
            double points[20], knots[11];
            for (int k = 0; k < 10; k++) {
                const double a = 0.37 + k * 0.2 * 3.14159265358979323846;
                const double x = 25 + (100 + 20 * cos(2 * a)) * cos(a), y = 90 * sin(a) + 5 * cos(3 * a);
                points[2 * k] = m.at[0] + x * m.along[1] + y * m.along[0];
                points[2 * k + 1] = m.at[1] - x * m.along[0] + y * m.along[1];
            }
            for (int k = 0; k <= 10; k++) knots[k] = k;
            bat_curve *ring = NULL, *whole = NULL;
            assert_int_equal(bat_curve_create(2, degree, true, 10, points, 11, knots, &ring), BAT_OK);
            assert_int_equal(bat_mirror_whole(&m, ring, 0, REACH, TOLERANCE, &whole), BAT_OK);
            assert_true(bat_curve_is_closed(whole));
            is_symmetric(&m, whole);
            double domain[2], low[2], high[2], box[2][2];
            bat_curve_domain(whole, domain);
            crosses_well(&m, whole, 0);
            crosses_well(&m, whole, domain[1] / 2);
            bat_curve_bounds(whole, low, high);
            bat_curve_bounds(ring, box[0], box[1]);
            assert_true(high[0] - low[0] > 150);
            assert_true(bat_mirror_twins(&m, whole, whole, 1e-6));
            assert_false(bat_mirror_twins(&m, ring, ring, 1));
            bat_curve_free(ring);
            bat_curve_free(whole);
        }
}

static void along_the_axis_one_line(void **state) {
    (void)state;
    static const double at[] = {2, 0, -3, 50, 1, 100, 4, 150, -2, 200, 3, 260};
    for (size_t i = 0; i < sizeof degrees / sizeof *degrees; i++) {
        const bat_mirror m = axis(3, 4, degrees[i]);
        bat_curve *curve = laid(&m, 3, 6, at), *whole = NULL;
        assert_int_equal(bat_mirror_whole(&m, curve, 0, REACH, TOLERANCE, &whole), BAT_OK);
        for (size_t k = 0; k < bat_curve_count(whole); k++)
            assert_true(fabs(bat_mirror_side(&m, bat_curve_points(whole) + 2 * k)) <= 1e-12 * 300);
        assert_true(fabs(bat_curve_size(whole) - 260) < (degrees[i] == 90 || degrees[i] == 0 ? 1e-9 : 261));
        bat_curve_free(curve);
        bat_curve_free(whole);
    }
}

static void others_are_refused(void **state) {
    (void)state;
    /* apart; along it, its end near; three times across; an arc over it and back */
    static const double at[][12] = {{-300, 0, -240, 60, -180, 60, -120, 20, -60, 0, -30, 0},
                                    {-100, 0, -60, 30, -20, 60, -11, 120, -10, 200, -9, 300},
                                    {-200, 0, 200, 50, 100, 80, -250, 110, 100, 160, 200, 200},
                                    {-200, 0, 0, 10, 150, 50, 150, 150, 0, 190, -200, 200}};
    const bat_mirror m = axis(0, 0, 90);
    for (int k = 0; k < 4; k++) {
        bat_curve *curve = laid(&m, 3, 6, at[k]), *whole = NULL;
        assert_int_equal(bat_mirror_whole(&m, curve, 0, REACH, TOLERANCE, &whole), BAT_STATE);
        assert_null(whole);
        assert_int_equal(bat_mirror_curve(&m, curve, &whole), BAT_OK);
        assert_true(bat_mirror_twins(&m, curve, whole, 1e-9));
        assert_false(bat_mirror_twins(&m, curve, curve, 1));
        bat_curve_free(whole);
        bat_curve_free(curve);
    }
}

static void twins_need_not_have_the_same_points(void **state) {
    (void)state;
    static const double at[] = {-300, 40, -220, -60, -160, 20, -60, 60, -50, 10, -40, 30};
    const bat_mirror m = axis(500, 400, 37);
    bat_curve *curve = laid(&m, 3, 6, at), *image = NULL, *turned = NULL, *finer = NULL, *moved = NULL;
    assert_int_equal(bat_mirror_curve(&m, curve, &image), BAT_OK);
    assert_int_equal(bat_curve_reverse(image, &turned), BAT_OK);
    assert_int_equal(bat_curve_insert_knot(turned, 1.3, 2, &finer), BAT_OK);
    assert_true(bat_mirror_twins(&m, curve, finer, 1e-6));
    assert_int_equal(bat_curve_transform(finer, (double[]){1, 0, 3, 0, 1, 0}, &moved), BAT_OK);
    assert_false(bat_mirror_twins(&m, curve, moved, 1));
    assert_true(bat_mirror_twins(&m, curve, moved, 3.1));
    double matrix[6], p[2] = {12, -7}, q[2];
    bat_mirror_matrix(&m, matrix);
    bat_mirror_point(&m, p, q);
    assert_true(hypot(matrix[0] * p[0] + matrix[2] * p[1] + matrix[4] - q[0],
                      matrix[1] * p[0] + matrix[3] * p[1] + matrix[5] - q[1]) < 1e-12 * 1000);
    bat_curve_free(curve);
    bat_curve_free(image);
    bat_curve_free(turned);
    bat_curve_free(finer);
    bat_curve_free(moved);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_across_keeps_its_longer_side),
                                       cmocka_unit_test(the_other_side_can_be_asked_for),
                                       cmocka_unit_test(ends_come_to_the_axis),
                                       cmocka_unit_test(far_from_the_axis_it_is_bitwise_the_curve),
                                       cmocka_unit_test(rings_stay_rings),
                                       cmocka_unit_test(along_the_axis_one_line),
                                       cmocka_unit_test(others_are_refused),
                                       cmocka_unit_test(twins_need_not_have_the_same_points)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
