/* An angle of a joint redrawn by a stroke: it is where the stroke is, at every level that can bend so, and the rest stays. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/camera.h>
#include "support/alloc_fail.h"
#include "support/walker.h"

enum { FRAMES = 120, STROKE = 80, THIGH = 1, LEVELS = 3 };
static const double FROM = 0.5, TO = 1.5; /* seconds, of 2 */

static bat_motion *motion_of(int seed) {
    bat_take *take = walker(seed, FRAMES);
    bat_motion *motion = NULL;
    bat_motion_options options = bat_motion_defaults();
    options.tolerance = 0, options.levels = LEVELS;
    assert_int_equal(bat_motion_fit(take, &options, &motion, NULL), BAT_OK);
    bat_take_free(take);
    return motion;
}

static double angle_at(const bat_motion *motion, int joint, int angle, double time) {
    double degrees = NAN;
    assert_int_equal(bat_motion_angle(motion, joint, angle, time, &degrees), BAT_OK);
    return degrees;
}

/* What the angle was, and a bump of so many degrees that begins and ends gently. */
static double bump_at(const bat_motion *was, int angle, double time, double high) {
    const double x = (time - FROM) / (TO - FROM), s = x <= 0 || x >= 1 ? 0 : sin(3.141592653589793 * x);
    return angle_at(was, THIGH, angle, time) + high * s * s;
}

static void stroke_of(const bat_motion *was, int angle, double high, double *points) {
    for (int i = 0; i < STROKE; i++) {
        points[2 * i] = FROM + (TO - FROM) * i / (STROKE - 1);
        points[2 * i + 1] = bump_at(was, angle, points[2 * i], high);
    }
}

static void the_angle_is_that_of_the_take(void **state) {
    (void)state;
    bat_motion *motion = motion_of(1);
    size_t channels;
    const double *values = bat_take_values(bat_motion_take(motion), NULL, &channels);
    for (size_t f = 0; f < FRAMES; f++)
        for (int k = 0; k < 3; k++) {
            assert_true(fabs(angle_at(motion, 0, k, (double)f / 60) - values[f * channels + 3 + (size_t)k]) <
                        1e-6);
            assert_true(fabs(angle_at(motion, THIGH, k, (double)f / 60) -
                             values[f * channels + 6 + (size_t)k]) < 1e-6);
            if (k == 0)
                assert_true(fabs(angle_at(motion, 2, 0, (double)f / 60) - values[f * channels + 9]) < 1e-6);
        }
    bat_motion_free(motion);
}

/* At the finest level, which has a knot at every frame, a stroke is met; elsewhere every bit of the rotation stays, and the other
 * angles stay throughout. */
static void is_where_the_stroke_is(void **state) {
    (void)state;
    for (int number = 0; number < 18; number++) {
        bat_motion *was = motion_of(number / 3), *motion = NULL;
        double points[2 * STROKE];
        const int angle = number % 3;
        stroke_of(was, angle, number % 2 ? 25 : -40, points);
        assert_int_equal(bat_motion_copy(was, &motion), BAT_OK);
        assert_int_equal(bat_motion_redraw(motion, THIGH, angle, LEVELS, STROKE, points), BAT_OK);
        double most = 0, other = 0;
        for (int i = 0; i < 240; i++) {
            const double time = i / 120.0, now = angle_at(motion, THIGH, angle, time);
            most = fmax(most, fabs(now - bump_at(was, angle, time, number % 2 ? 25 : -40)));
            for (int k = 0; k < 3; k++)
                if (k != angle)
                    other = fmax(other,
                                 fabs(angle_at(motion, THIGH, k, time) - angle_at(was, THIGH, k, time)));
            if (time < FROM - 0.2 || time > TO + 0.2) assert_true(now == angle_at(was, THIGH, angle, time));
        }
        assert_true(most < 0.2);
        assert_true(other < 0.02);
        bat_motion_free(motion), bat_motion_free(was);
    }
}

/* A coarse level goes as near as it can, the base with its few keys half the way: the levels above keep every bit, and what lies beyond the
 * points that meet the stretch does, too. */
static void coarse_levels_carry_the_details(void **state) {
    (void)state;
    for (int level = 0; level < LEVELS; level++) {
        bat_motion *was = motion_of(7 + level), *motion = NULL;
        double points[2 * STROKE], before = 0, after = 0;
        stroke_of(was, 0, 20, points);
        assert_int_equal(bat_motion_copy(was, &motion), BAT_OK);
        const bat_camera *a = bat_motion_joint(was, THIGH), *b = bat_motion_joint(motion, THIGH);
        assert_int_equal(bat_motion_redraw(motion, THIGH, 0, level, STROKE, points), BAT_OK);
        b = bat_motion_joint(motion, THIGH);
        for (int l = 1; l <= bat_camera_levels(a); l++) {
            const bat_curve *p = bat_camera_details(a, l), *q = bat_camera_details(b, l);
            const bool same = memcmp(bat_curve_points(p), bat_curve_points(q),
                                     3 * bat_curve_count(p) * sizeof(double)) == 0;
            assert_true(same == (l != level));
        }
        for (int i = 0; i < STROKE; i++) {
            const double now = angle_at(motion, THIGH, 0, points[2 * i]);
            before += fabs(angle_at(was, THIGH, 0, points[2 * i]) - points[2 * i + 1]);
            after += fabs(now - points[2 * i + 1]);
        }
        assert_true(after < (level ? 0.05 : 0.5) * before);
        bat_motion_free(motion), bat_motion_free(was);
    }
}

static void bad_strokes_are_refused(void **state) {
    (void)state;
    bat_motion *motion = motion_of(4);
    const double sound[4] = {0.5, 10, 0.6, 20}, endless[4] = {0.5, 10, INFINITY, 20},
                 wild[4] = {0.5, NAN, 0.6, 2};
    double degrees = 7;
    assert_int_equal(bat_motion_redraw(NULL, 1, 0, 1, 2, sound), BAT_ARGUMENT);
    assert_int_equal(bat_motion_redraw(motion, 3, 0, 1, 2, sound), BAT_ARGUMENT); /* an end */
    assert_int_equal(bat_motion_redraw(motion, 2, 1, 1, 2, sound), BAT_ARGUMENT); /* a knee has one angle */
    assert_int_equal(bat_motion_redraw(motion, 1, 0, LEVELS + 1, 2, sound), BAT_ARGUMENT);
    assert_int_equal(bat_motion_redraw(motion, 1, 0, -1, 2, sound), BAT_ARGUMENT);
    assert_int_equal(bat_motion_redraw(motion, 1, 0, 1, 1, sound), BAT_COUNT);
    assert_int_equal(bat_motion_redraw(motion, 1, 0, 1, 2, endless), BAT_NUMBER);
    assert_int_equal(bat_motion_redraw(motion, 1, 0, 1, 2, wild), BAT_NUMBER);
    assert_int_equal(bat_motion_set_gain(motion, 1, 2, 0), BAT_OK);
    assert_int_equal(bat_motion_redraw(motion, 1, 0, 2, 2, sound), BAT_ARGUMENT);
    assert_int_equal(bat_motion_angle(motion, 1, 3, 0, &degrees), BAT_ARGUMENT);
    assert_int_equal(bat_motion_angle(motion, 1, 0, NAN, &degrees), BAT_NUMBER);
    assert_true(degrees == 7);
    /* a stroke of one moment, and one beyond the ends, do something finite */
    const double moment[4] = {0.5, 10, 0.5, 20}, beyond[4] = {-5, 10, 900, 20};
    assert_int_equal(bat_motion_redraw(motion, 1, 0, LEVELS, 2, moment), BAT_OK);
    assert_int_equal(bat_motion_redraw(motion, 1, 0, LEVELS, 2, beyond), BAT_OK);
    assert_true(fabs(angle_at(motion, 1, 0, 1) - (10 + 10 * 6 / 905.0)) < 0.1);
    bat_motion_free(motion);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    bat_motion *was = motion_of(2), *motion = NULL;
    double points[2 * STROKE];
    stroke_of(was, 0, 10, points);
    for (int level = 0; level <= LEVELS; level += LEVELS) {
        assert_int_equal(bat_motion_copy(was, &motion), BAT_OK);
        bool reached = true;
        for (long n = 1; reached; n++) {
            const long live = alloc_live();
            alloc_fail_at(n);
            const bat_status status = bat_motion_redraw(motion, THIGH, 0, level, STROKE, points);
            reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            assert_int_equal(alloc_live(), live);
            if (reached) assert_true(angle_at(motion, THIGH, 0, 1) == angle_at(was, THIGH, 0, 1));
        }
        bat_motion_free(motion);
    }
    bat_motion_free(was);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_angle_is_that_of_the_take), cmocka_unit_test(is_where_the_stroke_is),
        cmocka_unit_test(coarse_levels_carry_the_details), cmocka_unit_test(bad_strokes_are_refused),
        cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
