/* Shapes that stay shapes: their curves against closed forms, their images, their numbers and handles. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "hands/figures/primitive.h"
#include "support/alloc_fail.h"
#include <batten/measure.h>

#include <math.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

static double area(const bat_primitive *p) {
    bat_curve *curve = NULL;
    assert_int_equal(bat_primitive_curve(p, &curve), BAT_OK);
    const double found = fabs(bat_curve_area(curve));
    bat_curve_free(curve);
    return found;
}

static bat_primitive some(int i) {
    bat_primitive p = bat_primitive_rectangle((double[]){10, 20, 110, 80}, 12);
    if (i == 1) {
        p = bat_primitive_ellipse((double[]){10, 20, 110, 80});
        p.start = 30, p.sweep = 200;
    }
    if (i == 2) {
        p = bat_primitive_polygon((double[]){10, 20}, (double[]){60, 40}, 5);
        p.depth = 0.4, p.roundness = 0.3;
    }
    return p;
}

/* A part of an ellipse: pie and segment; a star: two triangles a corner. */
static void areas(void **state) {
    (void)state;
    bat_primitive p = bat_primitive_ellipse((double[]){0, 0, 200, 100});
    assert_true(fabs(area(&p) / (PI * 5000) - 1) < 3e-4);
    for (double sweep = 10; sweep < 360; sweep += 35) {
        const double turn = sweep * PI / 180;
        p.sweep = sweep;
        p.ends = BAT_ARC_PIE;
        assert_true(fabs(area(&p) - 2500 * turn) < 3e-4 * 2500 * turn);
        p.ends = BAT_ARC_CHORD;
        assert_true(fabs(area(&p) - 2500 * (turn - sin(turn))) < 3e-4 * 2500 * turn);
        p.ends = BAT_ARC_OPEN;
        bat_curve *curve = NULL;
        assert_int_equal(bat_primitive_curve(&p, &curve), BAT_OK);
        assert_false(bat_curve_is_closed(curve));
        bat_curve_free(curve);
    }
    for (int sides = 3; sides < 12; sides++) {
        p = bat_primitive_polygon((double[]){5, 6}, (double[]){105, 6}, sides);
        const double whole = sides * 5000 * sin(2 * PI / sides);
        assert_true(fabs(area(&p) - whole) < 1e-6);
        p.depth = 0.25; /* each triangle loses as much of its height */
        assert_true(fabs(area(&p) - 0.75 * whole) < 1e-6);
        p.depth = 0, p.roundness = 1; /* the circle in it */
        const double inner = 100 * cos(PI / sides);
        assert_true(fabs(area(&p) / (PI * inner * inner) - 1) < 3e-3);
    }
}

/* A circle is four cubics. */
static void four_segments(void **state) {
    (void)state;
    const bat_primitive p = bat_primitive_ellipse((double[]){0, 0, 10, 10});
    bat_curve *curve = NULL;
    assert_int_equal(bat_primitive_curve(&p, &curve), BAT_OK);
    assert_int_equal(bat_curve_count(curve), 8); /* two a knot, smooth */
    bat_curve_free(curve);
}

/* The curve of the image is the image of the curve; what is skewed is no rectangle. */
static void images(void **state) {
    (void)state;
    const double turned[6] = {0.6, 0.8, -0.8, 0.6, 3, 4}, mirrored[6] = {-2, 0, 0, 2, 1, 1},
                 wide[6] = {3, 0, 0, 1, 0, 0}, skewed[6] = {1, 0, 0.5, 1, 0, 0};
    const double *const matrices[] = {turned, mirrored, wide, skewed};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++) {
            const bat_primitive p = some(i);
            const double *m = matrices[k];
            bat_primitive image;
            const bool is = bat_primitive_map(&p, m, &image);
            assert_int_equal(is, i > 0 || k < 3);
            if (!is) continue;
            bat_curve *curve = NULL, *mapped = NULL, *other = NULL;
            assert_int_equal(bat_primitive_curve(&p, &curve), BAT_OK);
            assert_int_equal(bat_primitive_curve(&image, &other), BAT_OK);
            const double rows[6] = {m[0], m[2], m[4], m[1], m[3], m[5]};
            assert_int_equal(bat_curve_transform(curve, rows, &mapped), BAT_OK);
            assert_int_equal(bat_curve_count(mapped), bat_curve_count(other));
            for (size_t n = 0; n < 2 * bat_curve_count(mapped); n++)
                assert_true(fabs(bat_curve_points(mapped)[n] - bat_curve_points(other)[n]) < 1e-9);
            bat_curve_free(curve), bat_curve_free(mapped), bat_curve_free(other);
        }
    const bat_primitive p = some(0);
    bat_primitive image;
    assert_false(bat_primitive_map(&p, (double[]){1, 0, 0, 0, 0, 0}, &image));
}

/* Whatever is set is in range, and setting what it is changes nothing. A handle that is let go where it is leaves it so. */
static void numbers(void **state) {
    (void)state;
    static const double values[] = {-1e9, -90, -1, 0, 0.5, 3, 50, 99, 180, 359, 360, 720, 1e9};
    for (int i = 0; i < 3; i++)
        for (int n = 0; n < BAT_PRIMITIVE_NUMBERS; n++) {
            const bat_primitive_number number = (bat_primitive_number)n;
            bat_primitive p = some(i), again;
            double value, at[2];
            const bool has = bat_primitive_get(&p, number, &value);
            assert_int_equal(has, n == 0 ? i == 0 : n < 3 ? i == 1 : i == 2);
            assert_false(bat_primitive_set(&p, number, NAN));
            again = p;
            if (!has) continue;
            assert_true(bat_primitive_set(&again, number, value));
            assert_true(fabs(again.sweep - p.sweep) + fabs(again.depth - p.depth) < 1e-9);
            assert_true(bat_primitive_handle(&p, number, 1, at));
            bat_primitive_drag(&again, number, at, at);
            assert_true(fabs(again.sweep - p.sweep) + fabs(again.start - p.start) < 1e-9);
            assert_true(fabs(again.radii[0] - p.radii[0]) + fabs(again.depth - p.depth) < 1e-9);
            assert_int_equal(again.sides, p.sides);
            for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
                assert_true(bat_primitive_set(&again, number, values[k]));
                assert_int_equal(bat_primitive_check(&again), BAT_OK);
            }
        }
}

static void refused(void **state) {
    (void)state;
    bat_curve *curve = NULL;
    bat_primitive p = bat_primitive_rectangle((double[]){0, 0, 5, 0}, 0);
    assert_int_equal(bat_primitive_curve(&p, &curve), BAT_COUNT);
    p = bat_primitive_ellipse((double[]){0, 0, 0, 5});
    assert_int_equal(bat_primitive_curve(&p, &curve), BAT_COUNT);
    p = bat_primitive_rectangle((double[]){0, 0, NAN, 5}, 0);
    assert_int_equal(bat_primitive_curve(&p, &curve), BAT_NUMBER);
    for (int sides = 2; sides <= 1001; sides += 999) {
        p = bat_primitive_polygon((double[]){0, 0}, (double[]){1, 0}, sides);
        assert_int_equal(bat_primitive_curve(&p, &curve), BAT_COUNT);
    }
    p = some(1);
    p.sweep = 361;
    assert_int_equal(bat_primitive_curve(&p, &curve), BAT_NUMBER);
    assert_null(curve);
    for (int i = 0; i < 3; i++) {
        p = some(i);
        const long live = alloc_live();
        for (long n = 1;; n++) {
            alloc_fail_at(n);
            const bat_status status = bat_primitive_curve(&p, &curve);
            const bool reached = alloc_fail_reached();
            alloc_fail_at(0);
            if (!reached) break;
            assert_int_equal(status, BAT_MEMORY);
            assert_int_equal(alloc_live(), live);
        }
        bat_curve_free(curve);
        curve = NULL;
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(areas),   cmocka_unit_test(four_segments), cmocka_unit_test(images),
        cmocka_unit_test(numbers), cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
