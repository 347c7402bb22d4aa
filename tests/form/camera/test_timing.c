/* Timing redrawn by strokes: never runs back, meets the stroke where that rises, leaves the rest; pauses; ease. Shake and muted
 * levels. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/camera.h>
#include <batten/format.h>
#include "support/alloc_fail.h"
#include "support/timing.h"

static void meets_a_stroke_that_rises(void **state) {
    (void)state;
    random_source r = {5};
    bat_camera *camera = along(&r, true);
    enum { N = 60 };
    double stroke[2 * N];
    for (int i = 0; i < N; i++) { /* a wave about the diagonal, from .25 to .75 */
        const double t = 0.25 + 0.5 * i / (N - 1);
        stroke[2 * i] = t, stroke[2 * i + 1] = t - 0.06 * sin(4 * 3.14159265358979 * (t - 0.25));
    }
    assert_int_equal(bat_camera_retime(camera, N, stroke), BAT_OK);
    double most = 0;
    for (int i = 0; i < N; i++) most = fmax(most, fabs(share_at(camera, stroke[2 * i]) - stroke[2 * i + 1]));
    assert_true(most < 0.006);
    for (int i = 0; i <= 20; i++) { /* outside, four spans away, it is even as before */
        assert_true(fabs(share_at(camera, 0.01 * i * 0.8) - 0.01 * i * 0.8) < 1e-12);
        assert_true(fabs(share_at(camera, 1 - 0.01 * i * 0.8) - (1 - 0.01 * i * 0.8)) < 1e-12);
    }
    bat_camera_free(camera);
}

static void flat_is_a_pause(void **state) {
    (void)state;
    random_source r = {7};
    bat_camera *camera = along(&r, false);
    const double stroke[4] = {0.3, 0.5, 0.7, 0.5};
    assert_int_equal(bat_camera_retime(camera, 2, stroke), BAT_OK);
    never_falls(camera);
    bat_camera_pose a, b;
    bat_camera_at_time(camera, 0.42 * 4, &a);
    bat_camera_at_time(camera, 0.58 * 4, &b);
    for (int k = 0; k < 3; k++) assert_true(a.position[k] == b.position[k]);
    assert_true(fabs(share_at(camera, 0.5) - 0.5) < 1e-12);
    bat_camera_free(camera);
}

static void eases(void **state) {
    (void)state;
    random_source r = {9};
    bat_camera *camera = along(&r, false);
    assert_int_equal(bat_camera_ease(camera, 1, 0.5), BAT_OK);
    never_falls(camera);
    assert_true(share_at(camera, 0.001) < 1e-4 &&
                share_at(camera, 0.999) > 1 - 2e-4); /* it stands at both ends */
    for (int i = 0; i <= 10; i++)
        assert_true(fabs(share_at(camera, 0.35 + 0.04 * i) - (0.35 + 0.04 * i)) < 1e-12);
    const double steps[3] = {share_at(camera, 0.05), share_at(camera, 0.1) - share_at(camera, 0.05),
                             share_at(camera, 0.15) - share_at(camera, 0.1)};
    assert_true(steps[0] < steps[1] && steps[1] < steps[2]);
    assert_int_equal(bat_camera_ease(camera, 0, 0), BAT_OK);
    assert_int_equal(bat_camera_ease(camera, 1e9, 1e9), BAT_OK); /* halves at most */
    never_falls(camera);
    assert_int_equal(bat_camera_ease(camera, -1, 0), BAT_NUMBER);
    assert_int_equal(bat_camera_ease(camera, NAN, 0), BAT_NUMBER);
    assert_int_equal(bat_camera_ease(NULL, 0, 0), BAT_ARGUMENT);
    bat_camera_free(camera);
}

static void durations(void **state) {
    (void)state;
    random_source r = {11};
    bat_camera *camera = along(&r, false), *other = along(&r, false);
    assert_int_equal(bat_camera_set_timing(camera, 7.5, NULL), BAT_OK);
    assert_true(bat_camera_duration(camera) == 7.5);
    assert_int_equal(bat_camera_set_timing(camera, 0, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_camera_set_timing(camera, NAN, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_camera_set_timing(camera, 2e9, NULL), BAT_NUMBER);
    const double stroke[4] = {0, 0.1, 0.9, 0.2};
    assert_int_equal(bat_camera_retime(other, 2, stroke), BAT_OK);
    assert_int_equal(bat_camera_set_timing(camera, 3, bat_camera_timing(other)), BAT_OK);
    for (int i = 0; i <= 10; i++)
        assert_true(fabs(share_at(camera, i / 10.0) - share_at(other, i / 10.0)) < 1e-12);
    bat_function even = bat_function_of(0);
    assert_int_equal(bat_camera_set_timing(camera, 3, &even), BAT_OK);
    assert_true(fabs(share_at(camera, 0.3) - 0.3) < 1e-12);
    assert_int_equal(bat_camera_set_timing(NULL, 3, &even), BAT_ARGUMENT);
    const double bad[4] = {0, NAN, 1, 1};
    assert_int_equal(bat_camera_retime(camera, 2, bad), BAT_NUMBER);
    assert_int_equal(bat_camera_retime(camera, 1, stroke), BAT_COUNT);
    assert_int_equal(bat_camera_retime(camera, 2, NULL), BAT_ARGUMENT);
    bat_camera_free(camera), bat_camera_free(other);
}

/* ---- levels ---- */

static double angle_between(const bat_camera *a, const bat_camera *b, double time) {
    bat_camera_pose p, q;
    double dot = 0;
    bat_camera_at_time(a, time, &p);
    bat_camera_at_time(b, time, &q);
    for (int k = 0; k < 4; k++) dot += p.rotation[k] * q.rotation[k];
    return 2 * acos(fmin(fabs(dot), 1));
}

/* What a shake was drawn from is in the text, with which another camera is given the same level, and is gone once the
 * level is changed; the numbers may be left out of the text. */
static void replays(bat_camera *shaken, bat_camera *read) {
    bat_camera_shake was, now;
    char *text = NULL;
    size_t size = 0;
    assert_int_equal(bat_camera_shake_of(shaken, 1, &was), BAT_OK);
    assert_int_equal(bat_camera_shake_of(read, 1, &now), BAT_OK);
    assert_true(was.seed == 5 && was.amount == 0.02 && was.rate == 6);
    assert_true(now.seed == was.seed && now.amount == was.amount && now.rate == was.rate);
    assert_int_equal(bat_camera_add_shake(read, now.seed, now.amount, now.rate), BAT_OK);
    assert_true(bat_curve_is_equal(bat_camera_details(shaken, 1), bat_camera_details(read, 2)));
    assert_int_equal(bat_camera_write(shaken, &text, &size), BAT_OK);
    char *from = strstr(text, "\"levels\":[{\"knots\""), *to = strstr(text, "\"gain\":1.5");
    assert_true(from && to && strstr(to, "\"shake\":{\"seed\":5,\"amount\":0.02,\"rate\":6}"));
    from += strlen("\"levels\":[{");
    memmove(from, to, strlen(to) + 1);
    bat_camera *drawn = NULL;
    assert_int_equal(bat_camera_read(text, strlen(text), &drawn, NULL), BAT_OK);
    assert_true(bat_curve_is_equal(bat_camera_details(shaken, 1), bat_camera_details(drawn, 1)));
    assert_true(bat_camera_is_muted(drawn, 1) && bat_camera_gain(drawn, 1) == 1.5);
    bat_free(text);
    const double aside[4] = {0.1, 0, 0, 1};
    assert_int_equal(bat_camera_set_muted(drawn, 1, false), BAT_OK);
    assert_int_equal(bat_camera_turn(drawn, 1, 0, aside), BAT_OK);
    assert_int_equal(bat_camera_shake_of(drawn, 1, &now), BAT_STATE);
    bat_camera_free(drawn);
}

static void shakes(void **state) {
    (void)state;
    random_source r = {13};
    for (int closed = 0; closed < 2; closed++) {
        bat_camera *still = along(&r, closed), *shaken = NULL, *again = NULL, *other = NULL;
        assert_int_equal(bat_camera_copy(still, &shaken), BAT_OK);
        assert_int_equal(bat_camera_copy(still, &again), BAT_OK);
        assert_int_equal(bat_camera_copy(still, &other), BAT_OK);
        assert_int_equal(bat_camera_add_shake(shaken, 5, 0.02, 6), BAT_OK);
        assert_int_equal(bat_camera_add_shake(again, 5, 0.02, 6), BAT_OK);
        assert_int_equal(bat_camera_add_shake(other, 6, 0.02, 6), BAT_OK);
        assert_true(bat_curve_is_equal(bat_camera_details(shaken, 1), bat_camera_details(again, 1)));
        assert_false(bat_curve_is_equal(bat_camera_details(shaken, 1), bat_camera_details(other, 1)));
        assert_int_equal(bat_curve_count(bat_camera_details(shaken, 1)),
                         closed ? 24 : 27); /* 6 a second, 4 seconds */
        double most = 0;
        for (int i = 0; i <= 100; i++) most = fmax(most, angle_between(still, shaken, 0.04 * i));
        assert_true(most > 0.005 && most < 0.02 * sqrt(2.25) + 1e-9);
        /* Muted it is the move without shake, bit for bit; its gain stays. */
        assert_int_equal(bat_camera_set_gain(shaken, 1, 1.5), BAT_OK);
        assert_int_equal(bat_camera_set_muted(shaken, 1, true), BAT_OK);
        assert_true(bat_camera_is_muted(shaken, 1) && bat_camera_gain(shaken, 1) == 1.5);
        for (int i = 0; i <= 100; i++) {
            bat_camera_pose p, q;
            bat_camera_at_time(still, 0.04 * i, &p);
            bat_camera_at_time(shaken, 0.04 * i, &q);
            assert_memory_equal(p.rotation, q.rotation, sizeof p.rotation);
            assert_memory_equal(p.position, q.position, sizeof p.position);
        }
        const double aside[4] = {0.1, 0, 0, 1};
        assert_int_equal(bat_camera_turn(shaken, 1, 0, aside), BAT_ARGUMENT);
        char *text = NULL;
        size_t size = 0;
        bat_camera *read = NULL;
        assert_int_equal(bat_camera_write(shaken, &text, &size), BAT_OK);
        assert_int_equal(bat_camera_read(text, size, &read, NULL), BAT_OK);
        assert_true(bat_camera_is_muted(read, 1) && bat_camera_gain(read, 1) == 1.5);
        bat_free(text);
        replays(shaken, read);
        assert_int_equal(bat_camera_take_levels(still, other), BAT_OK);
        for (int i = 0; i <= 10; i++)
            assert_true(angle_between(still, other, 0.4 * i) < 1e-7); /* acos near 1 */
        assert_int_equal(bat_camera_take_levels(still, still), BAT_OK);
        bat_camera_free(still), bat_camera_free(shaken), bat_camera_free(again), bat_camera_free(other);
        bat_camera_free(read);
    }
    bat_camera *open = along(&r, false), *ring = along(&r, true);
    assert_int_equal(bat_camera_take_levels(open, ring), BAT_UNSUPPORTED);
    assert_int_equal(bat_camera_take_levels(NULL, ring), BAT_ARGUMENT);
    assert_int_equal(bat_camera_add_shake(NULL, 1, 0.1, 1), BAT_ARGUMENT);
    assert_int_equal(bat_camera_add_shake(open, 1, 0, 1), BAT_NUMBER);
    assert_int_equal(bat_camera_add_shake(open, BAT_CAMERA_SEED_MAX + 1, 0.1, 1), BAT_NUMBER);
    bat_camera_shake shake;
    assert_int_equal(bat_camera_shake_of(NULL, 1, &shake), BAT_ARGUMENT);
    assert_int_equal(bat_camera_shake_of(open, 1, &shake), BAT_ARGUMENT);
    assert_int_equal(bat_camera_shake_of(open, 1, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_camera_add_shake(open, 1, 0.1, NAN), BAT_NUMBER);
    assert_int_equal(bat_camera_add_shake(open, 1, 0.1, 1e9), BAT_COUNT);
    assert_int_equal(bat_camera_set_muted(open, 1, true), BAT_ARGUMENT);
    assert_false(bat_camera_is_muted(open, 1));
    bat_camera_free(open), bat_camera_free(ring);
}

/* A shake is as fast where the camera goes slowly: its knots lie at even times, whatever the timing, pauses included. */
static void shakes_at_even_times(void **state) {
    (void)state;
    random_source r = {15};
    bat_camera *camera = along(&r, false);
    const double rise[6] = {0, 0, 0.5, 0.15, 1, 1}, pause[4] = {0.2, 0.5, 0.8, 0.5};
    assert_int_equal(bat_camera_retime(camera, 3, rise), BAT_OK);
    assert_int_equal(bat_camera_add_shake(camera, 1, 0.1, 5), BAT_OK);
    const double *knots = bat_curve_knots(bat_camera_details(camera, 1));
    for (int i = 1; i < 20; i++) {
        bat_camera_pose pose;
        bat_camera_at_time(camera, 0.2 * i, &pose);
        assert_true(fabs(knots[3 + i] - pose.u) < 1e-12);
    }
    assert_int_equal(bat_camera_retime(camera, 2, pause), BAT_OK);
    assert_int_equal(bat_camera_add_shake(camera, 2, 0.1, 5), BAT_OK);
    bat_camera_free(camera);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    random_source r = {17};
    bat_camera *from = along(&r, false);
    const double stroke[4] = {0.2, 0.1, 0.9, 0.8};
    assert_int_equal(bat_camera_add_shake(from, 1, 0.1, 4), BAT_OK);
    assert_int_equal(bat_camera_retime(from, 2, stroke), BAT_OK);
    for (int which = 0; which < 5; which++) {
        bool reached = true;
        for (long n = 1; reached; n++) {
            bat_camera *camera = along(&r, false);
            alloc_fail_at(n);
            const bat_status status = which == 0   ? bat_camera_retime(camera, 2, stroke)
                                      : which == 1 ? bat_camera_ease(camera, 1, 1)
                                      : which == 2 ? bat_camera_add_shake(camera, 3, 0.1, 4)
                                      : which == 3
                                          ? bat_camera_take_levels(camera, from)
                                          : bat_camera_set_timing(camera, 2, bat_camera_timing(from));
            reached = alloc_fail_reached();
            alloc_fail_at(0);
            assert_true(status == BAT_OK || (reached && status == BAT_MEMORY));
            if (status != BAT_OK) {
                assert_int_equal(bat_camera_levels(camera), 0);
                assert_true(fabs(share_at(camera, 0.3) - 0.3) < 1e-9);
            }
            bat_camera_free(camera);
        }
    }
    bat_camera_free(from);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(meets_a_stroke_that_rises),
                                       cmocka_unit_test(flat_is_a_pause),
                                       cmocka_unit_test(eases),
                                       cmocka_unit_test(durations),
                                       cmocka_unit_test(shakes),
                                       cmocka_unit_test(shakes_at_even_times),
                                       cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
