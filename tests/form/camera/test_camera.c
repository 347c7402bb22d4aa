/* Camera moves: edits of the gaze at every level, exact where they are asked for; copies; what is refused. The formula,
 * arc lengths and gazes are compared with numpy in tests/cli/test_camera.py. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/camera.h>
#include "support/random_curve.h"

enum { KEYS = 7, PLACES = 40 };
static const double KNOTS[KEYS + 4] = {0, 0, 0, 0, .2, .5, .8, 1, 1, 1, 1};

static void random_rotation(random_source *r, double q[4]) {
    double length = 0;
    for (int k = 0; k < 4; k++) q[k] = random_between(r, -1, 1), length += q[k] * q[k];
    for (int k = 0; k < 4; k++) q[k] /= sqrt(length);
}

/* How far two unit quaternions are apart as rotations, in radians. */
static double apart(const double *a, const double *b) {
    double minus = 0, plus = 0;
    for (int k = 0; k < 4; k++) minus += (a[k] - b[k]) * (a[k] - b[k]), plus += (a[k] + b[k]) * (a[k] + b[k]);
    return 4 * asin(fmin(0.5 * sqrt(fmin(minus, plus)), 1));
}

/* Keys that turn by less than a right angle from one to the next. */
static void random_keys(random_source *r, double keys[4 * KEYS]) {
    random_rotation(r, keys);
    for (int i = 1; i < KEYS; i++)
        for (int k = 0; k < 4; k++) keys[4 * i + k] = keys[4 * (i - 1) + k] + random_between(r, -0.4, 0.4);
}

static bat_camera *random_camera(random_source *r, bat_camera_mode mode, bool closed, int levels) {
    double keys[4 * KEYS], details[3 * KEYS];
    static const double period[KEYS + 1] = {0, 1, 2.5, 3, 4, 5.5, 6, 7};
    bat_curve *path = random_curve(r, 3, 3, closed ? 2 : 0, 8);
    bat_camera *camera = NULL;
    random_keys(r, keys);
    const bat_rotation_curve base = {.degree = 3,
                                     .closed = closed,
                                     .count = KEYS,
                                     .points = keys,
                                     .knot_count = closed ? KEYS + 1 : KEYS + 4,
                                     .knots = closed ? period : KNOTS};
    bat_camera_options options = bat_camera_defaults();
    options.mode = mode;
    options.base = &base;
    options.target[0] = 50;
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    for (int l = 0; l < levels; l++) {
        for (int i = 0; i < 3 * KEYS; i++) details[i] = random_between(r, -0.5, 0.5);
        const bool round = closed;
        assert_int_equal(
            bat_camera_add_level(camera, round ? KEYS + 1 : KEYS + 4, round ? period : KNOTS, KEYS, details),
            BAT_OK);
    }
    assert_int_equal(bat_camera_levels(camera), levels);
    bat_curve_free(path);
    return camera;
}

static double place(const bat_camera *camera, int i) {
    double domain[2];
    bat_camera_domain(camera, domain);
    return domain[0] + (domain[1] - domain[0]) * i / PLACES;
}

static void turns_are_exact(void **state) {
    (void)state;
    random_source r = {5};
    for (int round = 0; round < 60; round++) {
        const bat_camera_mode mode = (bat_camera_mode)(round % 3);
        bat_camera *camera = random_camera(&r, mode, round % 2 == 1, 3);
        for (int level = mode == BAT_CAMERA_LOOK_AT ? 1 : 0; level <= 3; level++) {
            const double u = place(camera, random_int(&r, 0, PLACES));
            bat_camera_pose pose;
            double wanted[4];
            bat_camera_at(camera, u, &pose);
            random_rotation(&r, wanted);
            for (int k = 0; k < 4; k++)
                wanted[k] = pose.rotation[k] + (level == 0 ? 0.2 : 1) * wanted[k]; /* any length */
            const bat_status status = bat_camera_turn(camera, level, u, wanted);
            assert_int_equal(status, BAT_OK);
            bat_camera_at(camera, u, &pose);
            double length = 0;
            for (int k = 0; k < 4; k++) length += wanted[k] * wanted[k];
            for (int k = 0; k < 4; k++) wanted[k] /= sqrt(length);
            assert_true(apart(pose.rotation, wanted) <= 1e-9);
        }
        bat_camera_free(camera);
    }
}

/* An edit and its opposite give back what was there. */
static void turns_revert(void **state) {
    (void)state;
    random_source r = {6};
    for (int level = 1; level <= 3; level++) {
        bat_camera *camera = random_camera(&r, BAT_CAMERA_FREE, false, 3);
        bat_camera_pose before[PLACES + 1], pose;
        for (int i = 0; i <= PLACES; i++) bat_camera_at(camera, place(camera, i), &before[i]);
        double other[4] = {0.1, 0.2, -0.1, 0};
        for (int k = 0; k < 4; k++) other[k] += before[13].rotation[k];
        assert_int_equal(bat_camera_turn(camera, level, place(camera, 13), other), BAT_OK);
        bat_camera_at(camera, place(camera, 14), &pose);
        assert_true(apart(pose.rotation, before[14].rotation) > 1e-3);
        assert_int_equal(bat_camera_turn(camera, level, place(camera, 13), before[13].rotation), BAT_OK);
        for (int i = 0; i <= PLACES; i++) {
            bat_camera_at(camera, place(camera, i), &pose);
            assert_true(apart(pose.rotation, before[i].rotation) <= 1e-12);
        }
        bat_camera_free(camera);
    }
}

/* Turning the base turns all that is seen, and no detail changes a bit. */
static void aiming_carries_details(void **state) {
    (void)state;
    random_source r = {7};
    bat_camera *camera = random_camera(&r, BAT_CAMERA_FREE, true, 2), *copy = NULL;
    assert_int_equal(bat_camera_copy(camera, &copy), BAT_OK);
    const double quarter[4] = {0, 0, 3, 3};
    assert_int_equal(bat_camera_turn_base(camera, quarter), BAT_OK);
    for (int l = 1; l <= 2; l++)
        assert_true(bat_curve_is_equal(bat_camera_details(camera, l), bat_camera_details(copy, l)));
    for (int i = 0; i <= PLACES; i++) {
        bat_camera_pose a, b;
        bat_camera_at(camera, place(camera, i), &a), bat_camera_at(copy, place(camera, i), &b);
        const double *q = b.rotation, s = sqrt(0.5);
        const double own[4] = {s * (q[0] - q[1]), s * (q[1] + q[0]), s * (q[2] + q[3]), s * (q[3] - q[2])};
        assert_true(apart(a.rotation, own) <= 1e-12);
        assert_memory_equal(a.position, b.position, sizeof a.position);
    }
    bat_camera_free(camera), bat_camera_free(copy);
}

static void copies_and_gains(void **state) {
    (void)state;
    random_source r = {8};
    for (int mode = 0; mode < 3; mode++) {
        bat_camera *camera = random_camera(&r, (bat_camera_mode)mode, mode == 1, 2), *copy = NULL;
        assert_int_equal(bat_camera_set_gain(camera, 2, 0.5), BAT_OK);
        assert_true(bat_camera_gain(camera, 2) == 0.5 && bat_camera_gain(camera, 3) == 0);
        assert_int_equal(bat_camera_copy(camera, &copy), BAT_OK);
        bat_camera_pose a, b;
        for (int i = 0; i <= PLACES; i++) {
            bat_camera_at(camera, place(camera, i), &a), bat_camera_at(copy, place(camera, i), &b);
            assert_true(apart(a.rotation, b.rotation) <= 1e-14 && a.fov == b.fov && a.distance == b.distance);
        }
        /* Muted, all of it is the sweep. */
        bat_camera *plain = NULL;
        for (int l = 1; l <= 2; l++) assert_int_equal(bat_camera_set_gain(camera, l, 0), BAT_OK);
        assert_int_equal(bat_camera_turn(camera, 1, place(camera, 3), a.rotation), BAT_ARGUMENT);
        assert_int_equal(bat_camera_set_gain(camera, 1, (double)NAN), BAT_NUMBER);
        assert_int_equal(bat_camera_set_gain(camera, 3, 1), BAT_ARGUMENT);
        assert_int_equal(bat_camera_copy(camera, &plain), BAT_OK);
        size_t count = 0;
        assert_true((bat_camera_base(plain, &count) != NULL) == (mode != BAT_CAMERA_LOOK_AT));
        assert_int_equal(count, mode == BAT_CAMERA_LOOK_AT ? 0 : KEYS);
        bat_camera_free(plain), bat_camera_free(camera), bat_camera_free(copy);
    }
}

static void how_short(void **state) {
    (void)state;
    const double line[4] = {0, 0, 1, 1}, path[6] = {0, 0, 0, 5, 0, 0};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, path, &curve), BAT_OK);
    for (int i = 1; i < 60; i++) { /* two keys at half an angle: as short as its cosine */
        const double half = 0.5 * 3.14159265358979323846 * i / 60;
        const double keys[8] = {0, 0, 0, 1, 2 * sin(half), 0, 0, 2 * cos(half)};
        const bat_rotation_curve base = {
            .degree = 1, .count = 2, .points = keys, .knot_count = 4, .knots = line};
        bat_camera_options options = bat_camera_defaults();
        bat_camera *camera = NULL;
        options.base = &base;
        assert_int_equal(bat_camera_create(curve, &options, &camera), BAT_OK);
        assert_true(fabs(bat_camera_least_norm(camera) - cos(0.5 * half)) <= 1e-4);
        assert_true(bat_camera_length(camera) == 5 && bat_camera_duration(camera) == 4);
        bat_camera_free(camera);
    }
    bat_curve_free(curve);
}

static void pooling(void **state) {
    (void)state;
    random_source r = {9};
    double fallen[3] = {3, 2, 1}, up[4] = {0, 0, 1, 2}, list[60], before[60];
    assert_int_equal(bat_pool_ascending(3, fallen), BAT_OK);
    assert_true(fallen[0] == 2 && fallen[1] == 2 && fallen[2] == 2);
    assert_int_equal(bat_pool_ascending(4, up), BAT_OK);
    assert_true(up[0] == 0 && up[1] == 0 && up[2] == 1 && up[3] == 2);
    assert_int_equal(bat_pool_ascending(0, NULL), BAT_OK);
    assert_int_equal(bat_pool_ascending(1, NULL), BAT_ARGUMENT);
    for (int round = 0; round < 1000; round++) {
        const int n = random_int(&r, 1, 60);
        for (int i = 0; i < n; i++) list[i] = before[i] = random_between(&r, 0, 1);
        assert_int_equal(bat_pool_ascending((size_t)n, list), BAT_OK);
        /* The least change: what is left over is at right angles to the result, and its sums from the start are not
         * below 0, with equality where the result rises (the conditions of Kuhn and Tucker). */
        double sum = 0, across = 0;
        for (int i = 0; i < n; i++) {
            assert_true(i == 0 || list[i] >= list[i - 1]);
            sum += before[i] - list[i], across += (before[i] - list[i]) * list[i];
            assert_true(sum >= -1e-12);
            if (i + 1 == n || list[i + 1] > list[i] + 1e-12) assert_true(fabs(sum) <= 1e-12);
        }
        assert_true(fabs(across) <= 1e-12);
    }
}

static void refused(void **state) {
    (void)state;
    random_source r = {10};
    bat_camera *camera = random_camera(&r, BAT_CAMERA_LOOK_AT, false, 1), *none = NULL;
    const double q[4] = {0, 0, 0, 1}, zero[4] = {0}, odd[4] = {(double)NAN, 0, 0, 1};
    assert_int_equal(bat_camera_turn(camera, 0, 0, q), BAT_UNSUPPORTED);
    assert_int_equal(bat_camera_turn_base(camera, q), BAT_UNSUPPORTED);
    assert_int_equal(bat_camera_turn(camera, 2, 0, q), BAT_ARGUMENT);
    assert_int_equal(bat_camera_turn(camera, 1, 0, zero), BAT_SINGULAR);
    assert_int_equal(bat_camera_turn(camera, 1, 0, odd), BAT_NUMBER);
    assert_int_equal(bat_camera_turn(camera, 1, (double)NAN, q), BAT_NUMBER);
    bat_camera_pose pose;
    const double never = (double)NAN;
    assert_int_equal(bat_camera_sample(camera, 1, &never, &pose), BAT_NUMBER);
    assert_int_equal(bat_camera_sample(camera, 0, NULL, NULL), BAT_OK);
    assert_null(bat_camera_details(camera, 2));
    assert_int_equal(bat_camera_add_level(camera, 3, KNOTS, KEYS, KNOTS), BAT_KNOTS);
    bat_camera_free(camera);
    bat_curve *path = random_curve(&r, 3, 3, 0, 4);
    bat_camera_options options = bat_camera_defaults();
    options.mode = BAT_CAMERA_LOOK_AT;
    static const struct {
        double up[3], duration, constant;
        bat_status status;
    } cases[] = {{{0, 0, 0}, 4, 40, BAT_SINGULAR},  {{0, 0, (double)INFINITY}, 4, 40, BAT_NUMBER},
                 {{0, 0, 1}, 0, 40, BAT_ARGUMENT},  {{0, 0, 1}, (double)NAN, 40, BAT_ARGUMENT},
                 {{0, 0, 1}, 1e10, 40, BAT_NUMBER}, {{0, 0, 1}, 4, (double)NAN, BAT_NUMBER}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        memcpy(options.up, cases[i].up, sizeof options.up);
        options.duration = cases[i].duration, options.fov.constant = cases[i].constant;
        assert_int_equal(bat_camera_create(path, &options, &none), cases[i].status);
        assert_null(none);
    }
    options = bat_camera_defaults();
    assert_int_equal(bat_camera_create(path, &options, &none), BAT_ARGUMENT); /* no base */
    assert_int_equal(bat_camera_create(NULL, &options, &none), BAT_ARGUMENT);
    bat_curve_free(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(turns_are_exact),
        cmocka_unit_test(turns_revert),
        cmocka_unit_test(aiming_carries_details),
        cmocka_unit_test(copies_and_gains),
        cmocka_unit_test(how_short),
        cmocka_unit_test(pooling),
        cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
