/*
 * The small pictures of levels: all within their box; a wave's height says its gain, not its size; what is too small to be seen is
 * flat; many values keep the least and the greatest; a shape keeps its proportions. With any allocation failing.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/alloc_fail.h"
#include "base/real.h"
#include "editor/panels/level_picture.h"
#include <batten/levels.h>
#include <batten/relief.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROOM = 800 };

typedef struct places {
    size_t count, lines;
    double at[ROOM][2];
} places;

/* The places of the path data, which has nothing but them. */
static places read(bat_text *text) {
    places p = {0};
    char *data = NULL;
    size_t size;
    assert_int_equal(bat_text_finish(text, &data, &size), BAT_OK);
    for (char *next = data; *next;) {
        if (*next == 'M') p.lines++, next++;
        assert_true(p.count < ROOM);
        for (int k = 0; k < 2; k++) {
            char *end;
            p.at[p.count][k] = strtod(next, &end);
            assert_true(end > next);
            next = end;
        }
        assert_true(p.at[p.count][0] >= 2 && p.at[p.count][0] <= BAT_LEVEL_WIDE - 2);
        assert_true(p.at[p.count][1] >= 2 && p.at[p.count][1] <= BAT_LEVEL_HIGH - 2);
        p.count++;
    }
    free(data);
    return p;
}

static places wave(size_t count, const double *values, double size, double gain) {
    bat_text text = {0};
    bat_level_wave(&text, count, values, size, gain);
    return read(&text);
}

/* How far it goes from the middle. */
static double height(const places *p) {
    double most = 0;
    for (size_t i = 0; i < p->count; i++) most = fmax(most, fabs(p->at[i][1] - BAT_LEVEL_HIGH / 2.0));
    return most;
}

static void a_wave_tells_its_gain(void **state) {
    (void)state;
    for (double scale = 1e-6; scale < 1e7; scale *= 1000) {
        double values[20];
        for (int i = 0; i < 20; i++) values[i] = scale * bat_sin(0.7 * i);
        const double expected[][2] = {{1, 4}, {0.5, 2}, {2, 8}, {-1, 4}, {100, 8}, {0, 0}};
        for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
            const places p = wave(20, values, 10 * scale, expected[k][0]);
            assert_true(fabs(height(&p) - expected[k][1]) < 0.06);
        }
        const places there = wave(20, values, 10 * scale, 1), back = wave(20, values, 10 * scale, -1);
        for (size_t i = 0; i < there.count; i++)
            assert_true(fabs(there.at[i][1] + back.at[i][1] - BAT_LEVEL_HIGH) < 0.11);
        const places small = wave(20, values, 1e5 * scale, 1);
        assert_true(small.count == 2 && height(&small) == 0);
    }
}

static void few_and_many_values(void **state) {
    (void)state;
    double *values = calloc(100000, sizeof *values);
    assert_non_null(values);
    for (size_t count = 0; count < 2; count++) { /* none and one: flat */
        values[0] = 1;
        const places p = wave(count, values, 1, 1);
        assert_true(p.count == 2 && height(&p) == 0);
    }
    values[0] = 0;
    values[56789] = 3, values[23456] = -2;
    const places p = wave(100000, values, 1, 1);
    assert_true(p.count <= 40);
    double least = INFINITY, most = -INFINITY, x = -INFINITY;
    for (size_t i = 0; i < p.count; i++) {
        least = fmin(least, p.at[i][1]), most = fmax(most, p.at[i][1]);
        assert_true(p.at[i][0] >= x);
        x = p.at[i][0];
    }
    assert_true(fabs(least - 6) < 0.06 && fabs(most - (10 + 8.0 / 3)) < 0.06);
    free(values);
}

static bat_curve *circle_of(int dimension, double radius) {
    double points[3 * 8];
    bat_curve *made;
    for (int i = 0; i < 8; i++) {
        points[dimension * i] = 1e3 + radius * bat_cos(i * 0.78539816339744831);
        points[dimension * i + 1] = radius * bat_sin(i * 0.78539816339744831);
        if (dimension == 3) points[3 * i + 2] = 7;
    }
    const double knots[9] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    assert_int_equal(bat_curve_create(dimension, 3, true, 8, points, 9, knots, &made), BAT_OK);
    return made;
}

static void a_shape_keeps_its_proportions(void **state) {
    (void)state;
    for (double radius = 1e-9; radius < 1e10; radius *= 1e6) {
        bat_curve *curve = circle_of(2, radius);
        bat_shape *shape;
        assert_int_equal(bat_shape_create(curve, NULL, &shape), BAT_OK);
        bat_text text = {0};
        bat_level_picture(&text, (bat_ladder){shape, NULL}, 0);
        const places p = read(&text);
        assert_true(p.lines == 1 && p.count > 40);
        if (radius > 1e-6) /* below, 1000 swallows it */
            for (size_t i = 0; i < p.count; i++)
                assert_true(fabs(bat_hypot(p.at[i][0] - 16, p.at[i][1] - 10) - 8) < 0.2);
        bat_shape_free(shape);
        bat_curve_free(curve);
    }
    const double points[4] = {5, 5, 5, 5}; /* a point */
    bat_curve *curve;
    bat_shape *shape;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &curve), BAT_OK);
    assert_int_equal(bat_shape_create(curve, NULL, &shape), BAT_OK);
    bat_text text = {0};
    bat_level_picture(&text, (bat_ladder){shape, NULL}, 0);
    const places p = read(&text);
    assert_true(height(&p) == 0 && p.at[0][0] == 16);
    bat_shape_free(shape);
    bat_curve_free(curve);
}

/* A ring in space with one level, whose detail stands up from it. */
static bat_shape *ring(void) {
    bat_curve *curve = circle_of(3, 50);
    bat_shape *shape;
    double details[3 * 16] = {0};
    for (int i = 0; i < 16; i++) details[3 * i + 2] = i % 2 ? 4 : -4;
    assert_int_equal(bat_shape_create(curve, NULL, &shape), BAT_OK);
    assert_int_equal(bat_shape_add_level(shape, 0, NULL, details, NULL), BAT_OK);
    bat_curve_free(curve);
    return shape;
}

static bat_relief *bumps(void) {
    double points[3 * 25], details[3 * 49] = {0};
    for (int i = 0; i < 25; i++) points[3 * i] = i / 5, points[3 * i + 1] = i % 5, points[3 * i + 2] = 0;
    const double knots[9] = {0, 0, 0, 0, 1, 2, 2, 2, 2};
    const int degree[2] = {3, 3};
    const bool closed[2] = {false, false};
    const size_t count[2] = {5, 5};
    const int knot_count[2] = {9, 9};
    bat_surface *surface;
    bat_relief *relief;
    assert_int_equal(bat_surface_create(degree, closed, count, points, knot_count, knots, knots, &surface),
                     BAT_OK);
    assert_int_equal(bat_relief_create(surface, &relief), BAT_OK);
    details[3 * (7 * 2 + 3) + 2] = 1; /* in one row of many */
    assert_int_equal(bat_relief_add_level(relief, (int[2]){0, 0}, NULL, NULL, details, NULL), BAT_OK);
    bat_surface_free(surface);
    return relief;
}

static void details_to_either_side(void **state) {
    (void)state;
    bat_shape *shape = ring();
    bat_text text = {0};
    bat_level_picture(&text, (bat_ladder){shape, NULL}, 1);
    const places up = read(&text);
    assert_true(up.count == 16 && fabs(height(&up) - 4) < 0.06);
    bat_shape_set_gain(shape, 1, 2);
    text = (bat_text){0};
    bat_level_picture(&text, (bat_ladder){shape, NULL}, 1);
    const places twice = read(&text);
    assert_true(fabs(height(&twice) - 8) < 0.06);
    bat_shape_free(shape);

    bat_relief *relief = bumps();
    text = (bat_text){0};
    bat_level_picture(&text, (bat_ladder){NULL, relief}, 0);
    const places grid = read(&text);
    assert_int_equal(grid.lines, 6);
    text = (bat_text){0};
    bat_level_picture(&text, (bat_ladder){NULL, relief}, 1);
    const places bump = read(&text);
    assert_true(bump.count == 7 && fabs(height(&bump) - 4) < 0.06 && bump.at[3][1] < 7 &&
                bump.at[2][1] == 10);
    bat_relief_free(relief);
}

static void memory_may_end(void **state) {
    (void)state;
    const long before = alloc_live();
    bat_shape *shape = ring();
    bat_relief *relief = bumps();
    for (int n = 1;; n++) {
        alloc_fail_at(n);
        bat_text text = {0};
        for (int level = 0; level < 2; level++) {
            bat_level_picture(&text, (bat_ladder){shape, NULL}, level);
            bat_level_picture(&text, (bat_ladder){NULL, relief}, level);
        }
        const bool reached = alloc_fail_reached();
        alloc_fail_at(0);
        char *data = NULL;
        size_t size;
        assert_int_equal(bat_text_finish(&text, &data, &size), reached ? BAT_MEMORY : BAT_OK);
        free(data);
        if (!reached) break;
    }
    bat_shape_free(shape);
    bat_relief_free(relief);
    assert_int_equal(alloc_live(), before);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wave_tells_its_gain),
        cmocka_unit_test(few_and_many_values),
        cmocka_unit_test(a_shape_keeps_its_proportions),
        cmocka_unit_test(details_to_either_side),
        cmocka_unit_test(memory_may_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
