/*
 * Levels copied to another curve: onto a copy of their own base they restore the shape, onto a moved and turned copy
 * the moved and turned shape; on curves with other knots, another degree, or open instead of closed, the base keeps its
 * shape bit for bit and the detail is unchanged at the same parameters.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/levels.h>
#include <batten/refine.h>
#include "curve/curve.h"
#include "support/alloc_fail.h"
#include "support/shapes.h"

static uint64_t seed;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) / 9007199254740992.0;
}

static bat_curve *wavy(int degree, int dimension, bool closed, int count, double noise) {
    double points[300], knots[120], t = 3;
    for (int i = 0; i < count; i++) {
        points[i * dimension] = closed ? 200 * cos(6.2831853 * i / count) : 60.0 * i;
        points[i * dimension + 1] = closed ? 200 * sin(6.2831853 * i / count) : 0;
        if (dimension == 3) points[i * dimension + 2] = 0;
        for (int d = 0; d < dimension; d++) points[i * dimension + d] += uniform(-noise, noise);
    }
    for (int i = 0; i < (closed ? count + 1 : count + degree + 1); i++) {
        knots[i] = t;
        if (closed || (i >= degree && i < count)) t += uniform(0.5, 2);
    }
    bat_curve *curve;
    assert_int_equal(bat_curve_create(dimension, degree, closed, (size_t)count, points,
                                      closed ? count + 1 : count + degree + 1, knots, &curve),
                     BAT_OK);
    return curve;
}

static void onto_its_own_base(void **state) {
    (void)state;
    seed = 21;
    for (int round = 0; round < 40; round++) {
        int dimension = 2 + round % 2;
        bat_curve *curve = wavy(3, dimension, round / 2 % 2 != 0, 40, 10);
        bat_shape_options options = bat_shape_defaults();
        options.frame = round % 4 == 3 ? BAT_FRAMES_FIXED : BAT_FRAMES_RMF;
        bat_shape *shape, *again, *turned;
        assert_int_equal(bat_shape_decompose(curve, 1, &options, &shape), BAT_OK);
        assert_int_equal(bat_shape_add_level(shape, 0, NULL, NULL, NULL), BAT_OK);
        for (int i = 0; i < bat_point_count(shape_finest(shape)); i++)
            assert_int_equal(bat_shape_move(shape, 2, i, (double[]){uniform(-2, 2), uniform(-2, 2), 0}),
                             BAT_OK);
        assert_int_equal(bat_shape_set_gain(shape, 1, 1.25), BAT_OK);
        if (round % 3 == 0) assert_int_equal(bat_shape_set_muted(shape, 2, true), BAT_OK);
        assert_int_equal(bat_shape_copy_levels(shape, bat_shape_curve(shape, 0), &again), BAT_OK);
        assert_true(bat_shape_gain(again, 1) == 1.25 && bat_shape_is_muted(again, 2) == (round % 3 == 0));
        double size = bat_curve_size(curve), a = uniform(0, 6);
        /* In space another first normal turns all detail about the curve by one angle. */
        if (dimension == 2)
            assert_true(points_apart(shape_finest(shape), shape_finest(again)) < 1e-11 * size);
        if (dimension == 2 && options.frame == BAT_FRAMES_RMF) {
            const double matrix[6] = {cos(a), -sin(a), 50, sin(a), cos(a), -20};
            bat_curve *base, *image;
            assert_int_equal(bat_curve_transform(bat_shape_curve(shape, 0), matrix, &base), BAT_OK);
            assert_int_equal(bat_curve_transform(shape_finest(shape), matrix, &image), BAT_OK);
            assert_int_equal(bat_shape_copy_levels(shape, base, &turned), BAT_OK);
            assert_true(points_apart(image, shape_finest(turned)) < 1e-11 * size);
            bat_shape_free(turned);
            bat_curve_free(base);
            bat_curve_free(image);
        }
        bat_shape_free(again);
        bat_shape_free(shape);
        bat_curve_free(curve);
    }
}

/* A straight base shows the details as they are: x is t, y is s. */
static void other_knots_same_detail(void **state) {
    (void)state;
    seed = 22;
    for (int round = 0; round < 40; round++) {
        bat_curve *base = wavy(3, 2, false, 12, 0), *other = wavy(3, 2, false, 17, 0), *bare, *flat;
        bat_shape *shape, *copy;
        assert_int_equal(bat_shape_create(base, NULL, &shape), BAT_OK);
        for (int l = 1; l <= 2; l++) {
            assert_int_equal(bat_shape_add_level(shape, 0, NULL, NULL, NULL), BAT_OK);
            /* Along the base alone, so that the second level's frames are the first's. */
            if (l == 1) continue;
            for (int i = 0; i < bat_point_count(shape_finest(shape)); i++)
                assert_int_equal(bat_shape_move(shape, 2, i, (double[]){uniform(-9, 9), uniform(-9, 9)}),
                                 BAT_OK);
        }
        assert_int_equal(bat_shape_copy_levels(shape, other, &copy), BAT_OK);
        assert_true(bat_curve_is_equal(bat_shape_curve(copy, 0), other));
        assert_int_equal(bat_shape_levels(copy), 2);
        double a[2], b[2], p[2], q[2], r[2], s[2];
        bat_curve_domain(base, a);
        bat_curve_domain(other, b);
        assert_int_equal(bat_curve_copy(base, &bare), BAT_OK);
        assert_int_equal(bat_curve_copy(other, &flat), BAT_OK);
        for (int i = 0; i <= 50; i++) {
            double u = a[0] + (a[1] - a[0]) * i / 50, v = b[0] + (b[1] - b[0]) * i / 50;
            bat_curve_eval(shape_finest(shape), u, 0, p);
            bat_curve_eval(bare, u, 0, q);
            bat_curve_eval(shape_finest(copy), v, 0, r);
            bat_curve_eval(flat, v, 0, s);
            for (int k = 0; k < 2; k++) assert_true(fabs(p[k] - q[k] - (r[k] - s[k])) < 1e-9);
        }
        bat_shape_free(shape);
        bat_shape_free(copy);
        bat_curve_free(base);
        bat_curve_free(other);
        bat_curve_free(bare);
        bat_curve_free(flat);
    }
}

static void any_onto_any(void **state) {
    (void)state;
    seed = 23;
    for (int round = 0; round < 64; round++) {
        int dimension = 2 + round % 2;
        bat_curve *curve = wavy(1 + round % 5, dimension, round / 2 % 2 != 0, 40, 10),
                  *onto = wavy(1 + round / 3 % 5, dimension, round / 4 % 2 != 0, 9 + round % 20, 30);
        bat_shape *shape, *copy;
        assert_int_equal(bat_shape_decompose(curve, 3, NULL, &shape), BAT_OK);
        assert_int_equal(bat_shape_copy_levels(shape, onto, &copy), BAT_OK);
        assert_int_equal(bat_shape_levels(copy), 3);
        assert_true(bat_curve_is_equal(bat_shape_curve(copy, 0), onto));
        assert_int_equal(bat_curve_validate(shape_finest(copy)), BAT_OK);
        for (int l = 1; l <= 3; l++) assert_int_equal(bat_shape_set_muted(copy, l, true), BAT_OK);
        double domain[2], p[3], q[3]; /* silent, it is the curve it was put on */
        bat_curve_domain(onto, domain);
        for (int i = 0; i < 30; i++) {
            double u = domain[0] + (domain[1] - domain[0]) * i / 30;
            bat_curve_eval(onto, u, 0, p);
            bat_curve_eval(shape_finest(copy), u, 0, q);
            for (int d = 0; d < dimension; d++) assert_true(fabs(p[d] - q[d]) < 1e-9);
        }
        bat_shape_free(shape);
        bat_shape_free(copy);
        bat_curve_free(curve);
        bat_curve_free(onto);
    }
    bat_curve *plane = wavy(3, 2, false, 9, 9), *space = wavy(3, 3, false, 9, 9);
    bat_shape *shape, *none = NULL;
    assert_int_equal(bat_shape_create(plane, NULL, &shape), BAT_OK);
    assert_int_equal(bat_shape_copy_levels(shape, space, &none), BAT_DIMENSION);
    assert_int_equal(bat_shape_copy_levels(NULL, space, &none), BAT_ARGUMENT);
    assert_int_equal(bat_shape_copy_levels(shape, NULL, &none), BAT_ARGUMENT);
    assert_int_equal(bat_shape_copy_levels(shape, plane, NULL), BAT_ARGUMENT);
    assert_null(none);
    bat_shape_free(shape);
    bat_curve_free(plane);
    bat_curve_free(space);
}

/* A detail that memory does not suffice for is not sampled instead: the copy is the same, or there is none. */
static void memory_may_run_out(void **state) {
    (void)state;
    seed = 5;
    bat_curve *curve = wavy(3, 2, false, 40, 10);
    bat_shape *shape, *wanted;
    assert_int_equal(bat_shape_decompose(curve, 2, NULL, &shape), BAT_OK);
    assert_int_equal(bat_shape_copy_levels(shape, bat_shape_curve(shape, 0), &wanted), BAT_OK);
    const long held = alloc_live();
    bool reached = true;
    for (long n = 1; reached; n++) {
        bat_shape *copy = NULL;
        alloc_fail_at(n);
        const bat_status status = bat_shape_copy_levels(shape, bat_shape_curve(shape, 0), &copy);
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        assert_true((copy == NULL) == reached);
        if (copy) assert_true(points_apart(shape_finest(copy), shape_finest(wanted)) == 0);
        bat_shape_free(copy);
        assert_true(alloc_live() == held);
    }
    bat_shape_free(wanted);
    bat_shape_free(shape);
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(onto_its_own_base),
        cmocka_unit_test(other_knots_same_detail),
        cmocka_unit_test(any_onto_any),
        cmocka_unit_test(memory_may_run_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
