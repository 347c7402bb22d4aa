/* Gazes at a target: over the zenith at the start, at the end, all the time and across the seam of a closed path; at the
 * target at the start, in the middle and round a loop. Nothing jumps but what passes its target. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/camera.h>

enum { STEPS = 4000 };

static bat_camera *looking(int count, const double *points, bool closed, const double target[3],
                           const double up[3]) {
    double knots[32];
    bat_curve *path = NULL;
    bat_camera *camera = NULL;
    for (int i = 0; i < count + (closed ? 1 : 4); i++)
        knots[i] = closed ? i : i < 4 ? 0 : i >= count ? count - 3 : i - 3;
    assert_int_equal(
        bat_curve_create(3, 3, closed, (size_t)count, points, count + (closed ? 1 : 4), knots, &path),
        BAT_OK);
    bat_camera_options options = bat_camera_defaults();
    options.mode = BAT_CAMERA_LOOK_AT;
    memcpy(options.target, target, sizeof options.target), memcpy(options.up, up, sizeof options.up);
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    bat_curve_free(path);
    return camera;
}

static double angle(const double *a, const double *b) {
    double dot = 0;
    for (int k = 0; k < 4; k++) dot += a[k] * b[k];
    return 2 * acos(fmin(fabs(dot), 1));
}

/* The camera's axis: -1 is z, 1 is x. */
static void axis_of(const double *q, bool across, double out[3]) {
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double level[3] = {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)};
    const double back[3] = {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
    memcpy(out, across ? level : back, sizeof level);
}

/* The greatest turn from one step to the next, in radians; each aims at the target, and away from up and down it is level. */
static double check(const bat_camera *camera, const double target[3], bool closed) {
    double domain[2], most = 0, length, back[3], level[3];
    bat_camera_pose now, before = {.u = 0};
    bat_camera_domain(camera, domain);
    for (int i = 0; i <= STEPS; i++) {
        bat_camera_at(camera, domain[0] + (domain[1] - domain[0]) * i / STEPS, &now);
        axis_of(now.rotation, false, back), axis_of(now.rotation, true, level);
        const double away[3] = {now.position[0] - target[0], now.position[1] - target[1],
                                now.position[2] - target[2]};
        length = sqrt(away[0] * away[0] + away[1] * away[1] + away[2] * away[2]);
        for (int k = 0; k < 3 && length > 1e-4; k++) assert_true(fabs(away[k] / length - back[k]) < 1e-12);
        if (length > 1e-4 && fabs(away[2]) < 0.996 * length) assert_true(fabs(level[2]) < 1e-12);
        if (i > 0) most = fmax(most, angle(now.rotation, before.rotation));
        before = now;
    }
    bat_camera_at(camera, domain[0], &now);
    if (closed) assert_true(angle(now.rotation, before.rotation) < 1e-7);
    return most;
}

static const double UP[3] = {0, 0, 1}, ORIGIN[3] = {0, 0, 0};

static void over_the_zenith(void **state) {
    (void)state;
    static const double from_there[] = {0, 0, 10, 0.1, 0.1, 10, 3, 0.5, 10, 6, 0, 9, 9, 1, 8, 12, 0, 6};
    static const double there[] = {12, 0, 6, 9, 1, 8, 6, 0, 9, 3, 0.5, 10, 0.1, 0.1, 10, 0.01, 0, 10};
    static const double within[] = {0.1,  0,   10, 0.2, 0.1, 11, 0.1, 0.2, 10,
                                    -0.1, 0.1, 9,  0,   0.1, 10, 0.1, 0,   10};
    static const double beside[] = {3, 0, 10, 6, 3, 9, 3, 9, 8, -3, 9, 7, -6, 3, 9, -3, 0, 10};
    const double *const paths[] = {from_there, there, within, beside};
    for (size_t i = 0; i < sizeof paths / sizeof *paths; i++)
        for (int down = 0; down < 2; down++) {
            bat_camera *camera = looking(6, paths[i], false, ORIGIN, (double[]){0, 0, down ? -1 : 1});
            assert_true(check(camera, ORIGIN, false) < 0.1);
            assert_int_equal(bat_camera_held(camera, 0, NULL), 0);
            bat_camera_free(camera);
        }
}

static void across_the_seam(void **state) {
    (void)state;
    double points[3 * 8];
    for (int from = 0; from < 8; from++) { /* the seam is in the cone, at its edge, and outside */
        for (int i = 0; i < 8; i++) {
            const double at = 3.14159265358979323846 * (1 + (i + from) / 4.0);
            const double corner[3] = {1.9 + 2 * cos(at), 2 * sin(at), 10 + 0.2 * sin(2 * at)};
            memcpy(points + 3 * i, corner, sizeof corner);
        }
        bat_camera *camera = looking(8, points, true, ORIGIN, UP);
        assert_true(check(camera, ORIGIN, true) < 0.05);
        bat_camera_free(camera);
    }
}

/* From the target, to it, through it: the gaze beside it is kept there. */
static void at_the_target(void **state) {
    (void)state;
    static const double line[] = {0, 0, 0, 1, 0, 0, 3, 0, 0, 5, 0, 0, 8, 0, 0, 9, 0, 0};
    static const double targets[][3] = {{0, 0, 0}, {9, 0, 0}, {4, 0, 0}};
    for (size_t i = 0; i < sizeof targets / sizeof *targets; i++) {
        double held[2], domain[2];
        bat_camera *camera = looking(6, line, false, targets[i], UP);
        bat_camera_domain(camera, domain);
        assert_int_equal(bat_camera_held(camera, 1, held), 1);
        assert_true(held[0] >= domain[0] && held[1] <= domain[1] && held[1] > held[0] &&
                    held[1] - held[0] < 1e-3);
        bat_camera_pose in, out;
        bat_camera_at(camera, 0.5 * (held[0] + held[1]), &in);
        bat_camera_at(camera, i == 0 ? held[1] : held[0] - 1e-9, &out);
        assert_true(angle(in.rotation, out.rotation) < 1e-6);
        bat_camera_free(camera);
    }
    /* A loop that begins at its target. */
    double ring[3 * 5], knots[6] = {0, 1, 2, 3, 4, 5}, start[3];
    for (int i = 0; i < 5; i++)
        ring[3 * i] = 5 * cos(1.2566 * i), ring[3 * i + 1] = 5 * sin(1.2566 * i), ring[3 * i + 2] = i % 2;
    bat_curve *path = NULL;
    assert_int_equal(bat_curve_create(3, 3, true, 5, ring, 6, knots, &path), BAT_OK);
    bat_curve_eval(path, 0, 0, start);
    bat_curve_free(path);
    bat_camera *camera = looking(5, ring, true, start, UP);
    assert_true(bat_camera_held(camera, 0, NULL) >= 1);
    check(camera, start, false);
    bat_camera_free(camera);
}

static void refused(void **state) {
    (void)state;
    const double spot[12] = {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3};
    bat_curve *path = NULL;
    bat_camera *camera = NULL;
    assert_int_equal(bat_curve_create_clamped(3, 3, 4, spot, &path), BAT_OK);
    bat_camera_options options = bat_camera_defaults();
    options.mode = BAT_CAMERA_LOOK_AT;
    memcpy(options.target, spot, sizeof options.target);
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_SINGULAR);
    options.target[0] = (double)INFINITY;
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_NUMBER);
    options.target[0] = 9;
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    bat_camera_free(camera);
    bat_curve_free(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(over_the_zenith), cmocka_unit_test(across_the_seam),
                                       cmocka_unit_test(at_the_target), cmocka_unit_test(refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
