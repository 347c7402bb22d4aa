/*
 * Shapes in other frames: another frame rule leaves every level's curve where it is; an affine map (including shears
 * and mirror images) takes each to its exact image; muting hides a level and unmuting restores it to the bit;
 * decomposition down to a given number of points is exact and nested, and leaves the coarse curves with simple knots.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>

#include "curve/curve.h"
#include <batten/format.h>
#include <batten/levels.h>
#include <batten/refine.h>
#include "support/shapes.h"

static uint64_t seed;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) / 9007199254740992.0;
}

/* Simple knots at uneven distances. */
static bat_curve *wavy(int dimension, bool closed, int count) {
    double points[300], knots[100], t = 0;
    for (int i = 0; i < count; i++) {
        points[i * dimension] = closed ? 200 * cos(6.2831853 * i / count) : 60.0 * i;
        points[i * dimension + 1] = closed ? 200 * sin(6.2831853 * i / count) : 0;
        if (dimension == 3) points[i * dimension + 2] = 0;
        for (int d = 0; d < dimension; d++) points[i * dimension + d] += uniform(-20, 20);
    }
    for (int i = 0; i < (closed ? count + 1 : count + 4); i++) {
        knots[i] = t;
        if (closed || (i >= 3 && i < count)) t += uniform(0.5, 2);
    }
    bat_curve *curve;
    assert_int_equal(bat_curve_create(dimension, 3, closed, (size_t)count, points,
                                      closed ? count + 1 : count + 4, knots, &curve),
                     BAT_OK);
    return curve;
}

static bat_shape *random_shape(int round) {
    bat_curve *curve = wavy(2 + round % 2, round / 2 % 2 != 0, 40);
    bat_shape_options options = bat_shape_defaults();
    options.frame = (bat_frame_rule)(round % 3);
    bat_shape *shape;
    assert_int_equal(bat_shape_decompose(curve, 3, &options, &shape), BAT_OK);
    bat_curve_free(curve);
    return shape;
}

/* Seen along z, each level is the same curve without its z, to rounding; in space again, with z = 0. Muted levels are seen when
 * they are unmuted. */
static void in_the_page(void **state) {
    (void)state;
    seed = 31;
    for (int round = 0; round < 24; round++) {
        bat_shape *shape = random_shape(round), *flat = NULL, *back = NULL;
        const int from = bat_curve_dimension(bat_shape_curve(shape, 0));
        if (round % 3 == 1) assert_int_equal(bat_shape_set_gain(shape, 2, 0.6), BAT_OK);
        if (round % 3 == 2) assert_int_equal(bat_shape_set_muted(shape, 1, true), BAT_OK);
        for (int loud = 0; loud < 2; loud++) {
            bat_shape *kept = NULL;
            assert_int_equal(bat_shape_to_dimension(shape, 2, &flat), BAT_OK);
            assert_int_equal(bat_shape_to_dimension(flat, 3, &back), BAT_OK);
            assert_int_equal(bat_shape_levels(flat), bat_shape_levels(shape));
            if (loud && round % 3 == 2) { /* unmuted after, not before */
                assert_int_equal(bat_shape_set_muted(flat, 1, false), BAT_OK);
                assert_int_equal(bat_shape_set_muted(back, 1, false), BAT_OK);
                assert_int_equal(bat_shape_copy(shape, &kept), BAT_OK);
                assert_int_equal(bat_shape_set_muted(kept, 1, false), BAT_OK);
            }
            for (int l = 0; l <= bat_shape_levels(shape); l++) {
                const bat_curve *was = bat_shape_curve(kept ? kept : shape, l);
                const bat_curve *is = bat_shape_curve(flat, l), *again = bat_shape_curve(back, l);
                /* Details turn with what is unmuted below them: only the level itself is the same. */
                if (kept && l > 1) continue;
                assert_int_equal(bat_curve_dimension(is), 2);
                assert_int_equal(bat_curve_count(is), bat_curve_count(was));
                for (size_t i = 0; i < bat_curve_count(is); i++)
                    for (int d = 0; d < 2; d++) {
                        const double x = bat_curve_points(was)[i * (size_t)from + (size_t)d];
                        assert_true(fabs(bat_curve_points(is)[2 * i + (size_t)d] - x) < 1e-9);
                        assert_true(fabs(bat_curve_points(again)[3 * i + (size_t)d] - x) < 1e-9);
                        assert_true(fabs(bat_curve_points(again)[3 * i + 2]) < 1e-9);
                    }
                if (l > 0) assert_true(bat_shape_gain(flat, l) == bat_shape_gain(shape, l));
            }
            bat_shape_free(flat), bat_shape_free(back), bat_shape_free(kept);
        }
        assert_int_equal(bat_shape_to_dimension(shape, 4, &flat), BAT_DIMENSION);
        assert_int_equal(bat_shape_to_dimension(NULL, 2, &flat), BAT_ARGUMENT);
        assert_int_equal(bat_shape_to_dimension(shape, 2, NULL), BAT_ARGUMENT);
        bat_shape_free(shape);
    }
}

/* Every level of the one is the image of that of the other. */
static void same_image(const bat_shape *before, const bat_shape *after, const double *matrix) {
    assert_int_equal(bat_shape_levels(before), bat_shape_levels(after));
    for (int l = 0; l <= bat_shape_levels(before); l++) {
        bat_curve *image;
        const bat_curve *curve = bat_shape_curve(before, l);
        assert_int_equal(matrix ? bat_curve_transform(curve, matrix, &image) : bat_curve_copy(curve, &image),
                         BAT_OK);
        assert_true(points_apart(image, bat_shape_curve(after, l)) < 1e-11 * bat_curve_size(image));
        bat_curve_free(image);
    }
}

static void rules_keep_the_curves(void **state) {
    (void)state;
    seed = 11;
    for (int round = 0; round < 36; round++) {
        bat_shape *shape = random_shape(round), *other;
        bat_frame_rule rule = (bat_frame_rule)((round + 1 + round / 3) % 3);
        assert_int_equal(bat_shape_set_gain(shape, 2, 0.5), BAT_OK);
        assert_int_equal(bat_shape_copy(shape, &other), BAT_OK);
        assert_int_equal(bat_shape_reframe(other, NULL, rule), BAT_OK);
        assert_int_equal(bat_shape_options_of(other)->frame, rule);
        same_image(shape, other, NULL);
        /* The gain still works on the same detail. */
        assert_int_equal(bat_shape_set_gain(shape, 3, 0), BAT_OK);
        assert_int_equal(bat_shape_set_gain(other, 3, 0), BAT_OK);
        same_image(shape, other, NULL);
        bat_shape_free(shape);
        bat_shape_free(other);
    }
}

static void images_are_exact(void **state) {
    (void)state;
    seed = 12;
    for (int round = 0; round < 36; round++) {
        bat_shape *shape = random_shape(round), *image;
        int size = bat_curve_dimension(shape_finest(shape));
        double matrix[12];
        for (int i = 0; i < 12; i++) matrix[i] = uniform(-2, 2);
        for (int i = 0; i < size; i++) matrix[i * (size + 1) + i] += round % 4 < 2 ? 3 : -3;
        if (round % 5 == 0) assert_int_equal(bat_shape_set_muted(shape, 2, true), BAT_OK);
        assert_int_equal(bat_shape_copy(shape, &image), BAT_OK);
        assert_int_equal(bat_shape_reframe(image, matrix, bat_shape_options_of(shape)->frame), BAT_OK);
        same_image(shape, image, matrix);
        if (round % 5 == 0) { /* what was silent has gone along */
            assert_int_equal(bat_shape_set_muted(image, 2, false), BAT_OK);
            assert_int_equal(bat_shape_set_muted(shape, 2, false), BAT_OK);
            bat_curve *level;
            assert_int_equal(bat_curve_transform(bat_shape_curve(shape, 2), matrix, &level), BAT_OK);
            assert_true(points_apart(level, bat_shape_curve(image, 2)) < 1e-11 * bat_curve_size(level));
            bat_curve_free(level);
        }
        bat_shape_free(shape);
        bat_shape_free(image);
    }
    double flat[12] = {0}, nan[12] = {NAN};
    bat_shape *shape = random_shape(0);
    assert_int_equal(bat_shape_reframe(shape, flat, BAT_FRAMES_RMF), BAT_SINGULAR);
    assert_int_equal(bat_shape_reframe(shape, nan, BAT_FRAMES_RMF), BAT_NUMBER);
    assert_int_equal(bat_shape_reframe(shape, NULL, (bat_frame_rule)9), BAT_ARGUMENT);
    assert_int_equal(bat_shape_reframe(NULL, NULL, BAT_FRAMES_RMF), BAT_ARGUMENT);
    bat_shape_free(shape);
}

static void mute_hides_and_brings_back(void **state) {
    (void)state;
    seed = 13;
    for (int round = 0; round < 12; round++) {
        bat_shape *shape = random_shape(round), *before, *silent;
        assert_int_equal(bat_shape_set_gain(shape, 2, 1.5), BAT_OK);
        assert_int_equal(bat_shape_copy(shape, &before), BAT_OK);
        assert_int_equal(bat_shape_copy(shape, &silent), BAT_OK);
        assert_int_equal(bat_shape_set_gain(silent, 2, 0), BAT_OK);
        assert_int_equal(bat_shape_set_muted(shape, 2, true), BAT_OK);
        assert_true(bat_shape_is_muted(shape, 2) && bat_shape_gain(shape, 2) == 1.5);
        assert_true(bat_curve_is_equal(shape_finest(shape), shape_finest(silent)));
        assert_int_equal(bat_shape_move(shape, 2, 0, (double[]){1, 1, 1}), BAT_STATE);
        /* There and back through the file. */
        char *text;
        size_t length;
        bat_shape *again;
        assert_int_equal(bat_shape_write(shape, &text, &length), BAT_OK);
        assert_int_equal(bat_shape_read(text, length, &again, NULL), BAT_OK);
        assert_true(bat_shape_is_muted(again, 2) && bat_shape_gain(again, 2) == 1.5);
        bat_free(text);
        assert_int_equal(bat_shape_set_muted(shape, 2, false), BAT_OK);
        assert_true(bat_curve_is_equal(shape_finest(shape), shape_finest(before)));
        assert_int_equal(bat_shape_set_muted(shape, 0, true), BAT_ARGUMENT);
        bat_shape_free(shape);
        bat_shape_free(before);
        bat_shape_free(silent);
        bat_shape_free(again);
    }
}

static void apart_to_a_number(void **state) {
    (void)state;
    seed = 14;
    for (int round = 0; round < 40; round++) {
        bool closed = round % 2 != 0;
        bat_curve *curve = wavy(2, closed, 60), *sharp;
        double domain[2], twice[40];
        bat_curve_domain(curve, domain);
        const double *t = bat_curve_knots(curve);
        int first = closed ? 1 : 4, extra = 0;
        for (int i = first; i < first + 20; i++) twice[extra++] = t[i], twice[extra++] = t[i];
        assert_int_equal(bat_curve_insert_knots(curve, extra, twice, &sharp), BAT_OK);
        int levels = 1 + round % 6, coarsest = 5 + round % 30, n = bat_point_count(sharp);
        bat_shape *shape = NULL;
        assert_int_equal(bat_shape_decompose_to(sharp, levels, (size_t)coarsest, NULL, &shape), BAT_OK);
        assert_int_equal(bat_shape_levels(shape), levels);
        assert_int_equal(bat_curve_count(bat_shape_curve(shape, 0)), coarsest);
        assert_true(points_apart(sharp, shape_finest(shape)) < 1e-12 * bat_curve_size(sharp));
        for (int l = 0; l < levels; l++)
            assert_true(bat_point_count(bat_shape_curve(shape, l)) <
                        bat_point_count(bat_shape_curve(shape, l + 1)));
        /* Sixty points' knots are enough for the base, so none of them is there twice. */
        const bat_curve *base = bat_shape_curve(shape, 0);
        for (int i = closed ? 1 : 4; i < bat_point_count(base); i++)
            assert_true(bat_curve_knots(base)[i] > bat_curve_knots(base)[i - 1]);
        bat_shape_free(shape);
        shape = NULL;
        assert_int_equal(bat_shape_decompose_to(sharp, 3, (size_t)(n - 2), NULL, &shape), BAT_COUNT);
        assert_int_equal(bat_shape_decompose_to(sharp, 1, 2, NULL, &shape), BAT_COUNT);
        assert_int_equal(bat_shape_decompose_to(sharp, 0, 9, NULL, &shape), BAT_COUNT);
        assert_int_equal(bat_shape_decompose_to(sharp, 25, 9, NULL, &shape), BAT_COUNT);
        assert_int_equal(bat_shape_decompose_to(NULL, 1, 9, NULL, &shape), BAT_ARGUMENT);
        assert_null(shape);
        assert_int_equal(bat_shape_decompose_to(sharp, 3, (size_t)(n - 3), NULL, &shape), BAT_OK);
        bat_shape_free(shape);
        bat_curve_free(curve);
        bat_curve_free(sharp);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rules_keep_the_curves),      cmocka_unit_test(images_are_exact),
        cmocka_unit_test(mute_hides_and_brings_back), cmocka_unit_test(in_the_page),
        cmocka_unit_test(apart_to_a_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
