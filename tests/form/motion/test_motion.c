/* Motions: frames that are kept bit for bit, edits of one joint and of all, another path, another walk's style; refusals;
 * every allocation may fail. Tolerances, bones and places of joints are compared with numpy in tests/cli/test_motion.py. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/motion.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { JOINTS = 5, CHANNELS = 13, FRAMES = 40 };

static const bat_bone BONES[JOINTS] = {
    {"hips",
     -1,
     false,
     {0, 0, 0},
     6,
     {BAT_X_POSITION, BAT_Y_POSITION, BAT_Z_POSITION, BAT_Z_ROTATION, BAT_X_ROTATION, BAT_Y_ROTATION}},
    {"thigh", 0, false, {1, -2, 0}, 3, {BAT_X_ROTATION, BAT_Y_ROTATION, BAT_Z_ROTATION}},
    {"knee", 1, false, {0, -40, 0}, 1, {BAT_X_ROTATION}},
    {"", 2, true, {0, -39, 3}, 0, {BAT_X_POSITION}},
    {"head", 0, false, {0, 60, 0}, 3, {BAT_Y_ROTATION, BAT_X_ROTATION, BAT_Z_ROTATION}}};

/* A walk whose swing and shake depend on the seed. */
static bat_take *walk(int seed, size_t frames) {
    random_source r = {(uint64_t)seed};
    double *values = malloc(frames * CHANNELS * sizeof *values);
    assert_non_null(values);
    double swing[CHANNELS], phase[CHANNELS];
    for (int k = 0; k < CHANNELS; k++) {
        swing[k] = random_between(&r, 10, 30);
        phase[k] = random_between(&r, 0, 6);
    }
    for (size_t i = 0; i < frames; i++)
        for (int k = 0; k < CHANNELS; k++) {
            const double noise = random_between(&r, -.2, .2);
            const double turn = swing[k] * sin(.2 * (double)i + phase[k]) + noise;
            values[i * CHANNELS + (size_t)k] = k < 3 ? (k == 2   ? 2.0 * (double)i
                                                        : k == 1 ? 90
                                                                 : 0) +
                                                           .1 * turn
                                                     : turn;
        }
    bat_take *take = NULL;
    assert_int_equal(bat_take_create(JOINTS, BONES, frames, 1 / 60.0, values, &take), BAT_OK);
    free(values);
    return take;
}

static bat_motion *fit(const bat_take *take, double tolerance, int levels) {
    bat_motion_options options = bat_motion_defaults();
    bat_motion *motion = NULL;
    options.tolerance = tolerance, options.levels = levels;
    assert_int_equal(bat_motion_fit(take, &options, &motion, NULL), BAT_OK);
    assert_int_equal(bat_motion_levels(motion), levels > 0 || tolerance > 0 ? levels : 1);
    return motion;
}

static bat_take *sample(const bat_motion *motion) {
    bat_take *take = NULL;
    assert_int_equal(bat_motion_sample(motion, &take), BAT_OK);
    return take;
}

/* The largest difference of the values of channels first .. last - 1. */
static double differ(const bat_take *a, const bat_take *b, size_t first, size_t last) {
    size_t frames, channels;
    const double *p = bat_take_values(a, &frames, &channels), *q = bat_take_values(b, NULL, NULL);
    double most = 0;
    for (size_t i = 0; i < frames; i++)
        for (size_t k = first; k < last; k++)
            most = fmax(most, fabs(p[i * channels + k] - q[i * channels + k]));
    return most;
}

static void frames_are_kept(void **state) {
    (void)state;
    for (int levels = 0; levels <= 12; levels += 3) {
        bat_take *take = walk(3 + levels, FRAMES);
        bat_motion *motion = fit(take, 0, levels);
        for (int l = 1; l <= levels; l++) assert_int_equal(bat_motion_set_gain(motion, -1, l, 1), BAT_OK);
        bat_take *again = sample(motion);
        assert_true(differ(take, again, 0, CHANNELS) == 0);
        bat_take_free(again), bat_take_free(take);
        bat_motion_free(motion);
    }
}

/* A gain of one joint changes that joint alone; back to 1, every bit is as before. */
static void one_joint_alone(void **state) {
    (void)state;
    bat_take *take = walk(5, FRAMES);
    bat_motion *motion = fit(take, 0, 3);
    assert_int_equal(bat_motion_set_gain(motion, 1, 2, 3), BAT_OK);
    bat_take *again = sample(motion);
    assert_true(differ(take, again, 6, 9) > .1);
    assert_true(differ(take, again, 0, 6) == 0 && differ(take, again, 9, CHANNELS) == 0);
    bat_take_free(again);
    assert_int_equal(bat_motion_set_gain(motion, 1, 2, 1), BAT_OK);
    again = sample(motion);
    assert_true(differ(take, again, 0, CHANNELS) == 0);
    bat_take_free(again), bat_take_free(take);
    bat_motion_free(motion);
}

/* Its own style changes nothing; another's comes with all its shake, and the base stays: muted, both are as the first was. */
static void style(void **state) {
    (void)state;
    bat_take *a = walk(7, FRAMES), *b = walk(8, FRAMES + 9);
    bat_motion *one = fit(a, 0, 3), *same = fit(a, 0, 3), *other = fit(b, 0, 3);
    assert_int_equal(bat_motion_take_style(one, same), BAT_OK);
    bat_take *again = sample(one);
    assert_true(differ(a, again, 0, CHANNELS) == 0);
    bat_take_free(again);
    assert_int_equal(bat_motion_take_style(one, other), BAT_OK);
    again = sample(one);
    assert_true(differ(a, again, 3, CHANNELS) > .3);
    bat_take_free(again);
    for (int l = 1; l <= 3; l++) {
        assert_int_equal(bat_motion_set_gain(one, -1, l, 0), BAT_OK);
        assert_int_equal(bat_motion_set_gain(same, -1, l, 0), BAT_OK);
    }
    again = sample(one);
    bat_take *plain = sample(same);
    assert_true(differ(plain, again, 0, CHANNELS) < 1e-9);
    bat_take_free(again), bat_take_free(plain), bat_take_free(a), bat_take_free(b);
    bat_motion_free(one), bat_motion_free(same), bat_motion_free(other);
}

static bat_curve *way(void) {
    static const double points[15] = {0, 90, 0, 10, 90, 30, 40, 95, 40, 70, 90, 40, 99, 90, 80};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create_clamped(3, 3, 5, points, &curve), BAT_OK);
    return curve;
}

/* On another path, and back on its own: as before. Bones stay as long as they are. */
static void bends(void **state) {
    (void)state;
    bat_take *take = walk(9, FRAMES);
    bat_motion *motion = fit(take, 0, 3);
    bat_curve *path = way(), *own = NULL;
    assert_int_equal(bat_curve_copy(bat_shape_curve(bat_motion_path(motion), 0), &own), BAT_OK);
    assert_int_equal(bat_motion_bend(motion, path), BAT_OK);
    bat_take *bent = sample(motion);
    for (size_t i = 0; i < FRAMES; i++) {
        double at[3 * JOINTS];
        assert_int_equal(bat_take_positions(bent, i, at), BAT_OK);
        for (int j = 1; j < JOINTS; j++) {
            const double *p = at + 3 * BONES[j].parent, *q = at + 3 * j, *o = BONES[j].offset;
            const double length = sqrt(o[0] * o[0] + o[1] * o[1] + o[2] * o[2]);
            const double d = sqrt((q[0] - p[0]) * (q[0] - p[0]) + (q[1] - p[1]) * (q[1] - p[1]) +
                                  (q[2] - p[2]) * (q[2] - p[2]));
            assert_true(fabs(d / length - 1) < 1e-12);
        }
    }
    assert_true(differ(take, bent, 0, 6) > 10);
    assert_true(differ(take, bent, 6, CHANNELS) == 0);
    assert_int_equal(bat_motion_bend(motion, own), BAT_OK);
    bat_take *back = sample(motion);
    assert_true(differ(take, back, 0, 3) < 1e-9 && differ(take, back, 3, CHANNELS) < 1e-6);
    bat_take_free(take), bat_take_free(bent), bat_take_free(back);
    bat_curve_free(path), bat_curve_free(own);
    bat_motion_free(motion);
}

static void refusals(void **state) {
    (void)state;
    bat_take *take = walk(2, 5), *none = NULL;
    bat_motion *motion = fit(take, .5, 2), *other = fit(take, .5, 1), *out = NULL;
    bat_motion_options options = bat_motion_defaults();
    double value[CHANNELS] = {0}, at[3 * JOINTS];
    bat_bone bones[JOINTS];
    memcpy(bones, BONES, sizeof bones);
    assert_int_equal(bat_take_create(0, bones, 1, 1, value, &none), BAT_COUNT);
    assert_int_equal(bat_take_create(JOINTS, bones, 0, 1, value, &none), BAT_COUNT);
    assert_int_equal(bat_take_create(JOINTS, bones, (size_t)-1, 1, value, &none), BAT_COUNT);
    assert_int_equal(bat_take_create(JOINTS, bones, 1, 0, value, &none), BAT_ARGUMENT);
    assert_int_equal(bat_take_create(JOINTS, bones, 1, NAN, value, &none), BAT_ARGUMENT);
    assert_int_equal(bat_take_create(JOINTS, bones, 1, INFINITY, value, &none), BAT_NUMBER);
    assert_int_equal(bat_take_create(JOINTS, bones, 1, 1, NULL, &none), BAT_ARGUMENT);
    assert_int_equal(bat_take_create(JOINTS, NULL, 1, 1, value, &none), BAT_ARGUMENT);
    value[4] = NAN;
    assert_int_equal(bat_take_create(JOINTS, bones, 1, 1, value, &none), BAT_NUMBER);
    value[4] = 0;
    bones[2].parent = 2;
    assert_int_equal(bat_take_create(JOINTS, bones, 1, 1, value, &none), BAT_ARGUMENT);
    bones[2].parent = 1, bones[4].parent = 3; /* an end has no children */
    assert_int_equal(bat_take_create(JOINTS, bones, 1, 1, value, &none), BAT_ARGUMENT);
    bones[4].parent = 0, bones[1].channels[2] = BAT_X_ROTATION;
    assert_int_equal(bat_take_create(JOINTS, bones, 1, 1, value, &none), BAT_ARGUMENT);
    bones[1].channels[2] = BAT_Z_ROTATION, bones[1].offset[1] = INFINITY;
    assert_int_equal(bat_take_create(JOINTS, bones, 1, 1, value, &none), BAT_NUMBER);
    assert_int_equal(bat_take_positions(take, 5, at), BAT_ARGUMENT);
    assert_int_equal(bat_motion_fit(NULL, NULL, &out, NULL), BAT_ARGUMENT);
    options.tolerance = NAN;
    assert_int_equal(bat_motion_fit(take, &options, &out, NULL), BAT_ARGUMENT);
    options.tolerance = 1, options.levels = 13;
    assert_int_equal(bat_motion_fit(take, &options, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_motion_set_gain(motion, -2, 1, 1), BAT_ARGUMENT);
    assert_int_equal(bat_motion_set_gain(motion, JOINTS, 1, 1), BAT_ARGUMENT);
    assert_int_equal(bat_motion_set_gain(motion, 0, 0, 1), BAT_ARGUMENT);
    assert_int_equal(bat_motion_set_gain(motion, 0, 3, 1), BAT_ARGUMENT);
    assert_int_equal(bat_motion_set_gain(motion, 0, 1, NAN), BAT_NUMBER);
    assert_int_equal(bat_motion_take_style(motion, other), BAT_ARGUMENT);
    assert_int_equal(bat_motion_bend(motion, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_motion_sample(motion, NULL), BAT_ARGUMENT);
    assert_null(bat_motion_joint(motion, 3));
    assert_null(bat_motion_joint(motion, 99));
    assert_true(!none && !out);
    bat_take_free(take);
    bat_motion_free(motion), bat_motion_free(other);
}

/* Everything, with the n-th allocation failing. */
static bat_status all(const char *text, size_t size, const bat_curve *path) {
    bat_take *take = NULL, *again = NULL;
    bat_motion *motion = NULL;
    bat_motion_options options = bat_motion_defaults();
    bat_motion_report report;
    char *bytes = NULL, *json = NULL;
    size_t length;
    options.levels = 2;
    bat_status status = bat_bvh_read(text, size, &take, NULL);
    if (status == BAT_OK) status = bat_motion_fit(take, &options, &motion, &report);
    if (status == BAT_OK) status = bat_motion_bend(motion, path);
    if (status == BAT_OK) status = bat_motion_take_style(motion, motion);
    if (status == BAT_OK) status = bat_motion_sample(motion, &again);
    if (status == BAT_OK) status = bat_bvh_write(again, &bytes, &length);
    if (status == BAT_OK) status = bat_motion_write(motion, &report, &json, &length);
    bat_take_free(take), bat_take_free(again);
    bat_motion_free(motion);
    bat_free(bytes), bat_free(json);
    return status;
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    bat_take *take = walk(4, 12);
    bat_curve *path = way();
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_bvh_write(take, &text, &size), BAT_OK);
    bool reached = true;
    for (long n = 1; reached; n += 1 + n / 60) {
        const long before = alloc_live();
        alloc_fail_at(n);
        const bat_status status = all(text, size, path);
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        assert_int_equal(alloc_live(), before);
    }
    bat_free(text);
    bat_curve_free(path);
    bat_take_free(take);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_are_kept), cmocka_unit_test(one_joint_alone),
        cmocka_unit_test(style),           cmocka_unit_test(bends),
        cmocka_unit_test(refusals),        cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
