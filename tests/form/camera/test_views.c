/* Moves that are laid through views: each view is met, in whatever order places and gazes change; nothing else changes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/camera.h>
#include "form/camera/views.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { MOST = 40 };

static void random_rotation(random_source *r, double q[4]) {
    double length = 0;
    for (int k = 0; k < 4; k++) q[k] = random_between(r, -1, 1), length += q[k] * q[k];
    for (int k = 0; k < 4; k++) q[k] /= sqrt(length);
}

/* Radians between two unit quaternions as rotations. */
static double apart(const double *a, const double *b) {
    double minus = 0, plus = 0;
    for (int k = 0; k < 4; k++) minus += (a[k] - b[k]) * (a[k] - b[k]), plus += (a[k] + b[k]) * (a[k] + b[k]);
    return 4 * asin(fmin(0.5 * sqrt(fmin(minus, plus)), 1));
}

static double far(const double *a, const double *b) {
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

static bat_camera *tripod(const bat_camera_pose *view) {
    static const double knots[4] = {0, 0, 1, 1};
    double points[6], keys[8];
    bat_curve *path = NULL;
    bat_camera *camera = NULL;
    memcpy(points, view->position, 3 * sizeof *points),
        memcpy(points + 3, view->position, 3 * sizeof *points);
    memcpy(keys, view->rotation, 4 * sizeof *keys), memcpy(keys + 4, view->rotation, 4 * sizeof *keys);
    const bat_rotation_curve base = {
        .degree = 1, .count = 2, .points = keys, .knot_count = 4, .knots = knots};
    bat_camera_options options = bat_camera_defaults();
    options.base = &base;
    options.fov = bat_function_of(view->fov);
    assert_int_equal(bat_curve_create(3, 1, false, 2, points, 4, knots, &path), BAT_OK);
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    bat_curve_free(path);
    return camera;
}

static bat_status go(bat_camera **camera, const bat_camera_pose *view, size_t expected) {
    bat_camera *made = NULL;
    bat_view_report report = {0};
    const bat_status status = bat_camera_with_view(*camera, view, &made, &report);
    if (status != BAT_OK) {
        assert_null(made);
        return status;
    }
    assert_int_equal(report.views, expected);
    bat_camera_free(*camera);
    *camera = made;
    return BAT_OK;
}

static bat_camera *through(size_t count, const bat_camera_pose *views) {
    bat_camera *camera = tripod(&views[0]);
    for (size_t i = 1; i < count; i++) assert_int_equal(go(&camera, &views[i], i + 1), BAT_OK);
    return camera;
}

/* Every view is there, in order, where the path has its knots. */
static void meets(const bat_camera *camera, size_t count, const bat_camera_pose *views) {
    const bat_curve *path = bat_camera_path(camera);
    const double *knots = bat_curve_knots(path);
    double size = 1;
    for (size_t i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) size = fmax(size, fabs(views[i].position[k]));
    assert_int_equal(bat_curve_knot_count(path), count + 6);
    for (size_t i = 0; i < count; i++) {
        bat_camera_pose pose;
        bat_camera_at(camera, knots[3 + i], &pose);
        assert_true(far(pose.position, views[i].position) < 1e-9 * size);
        assert_true(apart(pose.rotation, views[i].rotation) < 1e-9);
        assert_true(fabs(pose.fov - views[i].fov) < 1e-9 * 180);
    }
    assert_true(bat_camera_least_norm(camera) >= 0.3);
    bat_camera_pose end;
    bat_camera_at_time(camera, bat_camera_duration(camera), &end);
    assert_true(far(end.position, views[count - 1].position) < 1e-9 * size);
    assert_true(apart(end.rotation, views[count - 1].rotation) < 1e-9);
}

static void random_view(random_source *r, bat_camera_pose *view, const bat_camera_pose *before, int kind) {
    if (before) *view = *before;
    if (!before || kind != 1)
        for (int k = 0; k < 3; k++) view->position[k] = random_between(r, -500, 500);
    if (!before || kind != 2) random_rotation(r, view->rotation);
    if (!before || kind == 3) view->fov = random_between(r, 2, 160);
}

/* Places and gazes that change together, one at a time, or not at all, with fields of view. */
static void every_view_is_met(void **state) {
    random_source r = {71};
    (void)state;
    for (int round = 0; round < 60; round++) {
        bat_camera_pose views[MOST] = {0};
        const size_t count = 2 + (size_t)(round % (MOST - 2));
        for (size_t i = 0; i < count; i++)
            random_view(&r, &views[i], i ? &views[i - 1] : NULL, (round + (int)i * (round % 5)) % 4);
        bat_camera *camera = through(count, views);
        meets(camera, count, views);
        assert_true(bat_camera_duration(camera) == 4);
        bat_camera_free(camera);
    }
}

/* Gazes alone: the camera stays where it is, and turns all the time. */
static void turns_on_the_spot(void **state) {
    random_source r = {72};
    bat_camera_pose views[6] = {0};
    (void)state;
    for (int i = 0; i < 6; i++) random_view(&r, &views[i], i ? &views[i - 1] : NULL, 1);
    bat_camera *camera = through(6, views);
    meets(camera, 6, views);
    assert_true(bat_camera_length(camera) == 0);
    bat_camera_pose a, b;
    for (int i = 0; i < 2000; i++) {
        bat_camera_at_time(camera, i / 500.0, &a), bat_camera_at_time(camera, (i + 1) / 500.0, &b);
        assert_true(far(a.position, b.position) < 1e-12 * 500);
        assert_true(apart(a.rotation, b.rotation) < 0.05);
    }
    bat_camera_free(camera);
}

/* Between two ways the camera turns in one place: it keeps its gaze before and behind, strays little, and says so. */
static void a_turn_on_the_way(void **state) {
    static const double quarter = 0.70710678118654752;
    const bat_camera_pose views[4] = {
        {.position = {0, 0, 0}, .rotation = {0, 0, 0, 1}, .fov = 40},
        {.position = {100, 0, 0}, .rotation = {0, 0, 0, 1}, .fov = 40},
        {.position = {100, 0, 0}, .rotation = {0, quarter, 0, quarter}, .fov = 40},
        {.position = {100, 100, 0}, .rotation = {0, quarter, 0, quarter}, .fov = 40}};
    bat_camera *camera = through(2, views), *made = NULL;
    bat_view_report report;
    bat_camera_pose pose;
    (void)state;
    for (int i = 2; i < 4; i++) {
        assert_int_equal(bat_camera_with_view(camera, &views[i], &made, &report), BAT_OK);
        assert_true(report.sudden);
        bat_camera_free(camera);
        camera = made;
    }
    meets(camera, 4, views);
    assert_true(bat_camera_length(camera) < 1.05 * 200);
    for (int i = 0; i <= 400; i++) {
        bat_camera_at_time(camera, i / 100.0, &pose);
        if (pose.time < 1.8) assert_true(apart(pose.rotation, views[0].rotation) < 1e-9);
        if (pose.time > 2.2) assert_true(apart(pose.rotation, views[3].rotation) < 1e-9);
        assert_true(fabs(pose.position[2]) < 1e-9);
    }
    bat_camera_free(camera);
}

/* Between neighbours the gaze turns by no more than they differ, and what stays stays. */
static void no_gaze_swings_past(void **state) {
    random_source r = {77};
    (void)state;
    for (int round = 0; round < 40; round++) {
        bat_camera_pose views[8] = {0}, pose;
        for (int i = 0; i < 8; i++)
            random_view(&r, &views[i], i ? &views[i - 1] : NULL, random_int(&r, 0, 3));
        bat_camera *camera = through(8, views);
        const double *knots = bat_curve_knots(bat_camera_path(camera));
        for (int i = 0; i < 7; i++)
            for (int k = 1; k < 20; k++) {
                bat_camera_at(camera, knots[3 + i] + (knots[4 + i] - knots[3 + i]) * k / 20, &pose);
                const double whole = apart(views[i].rotation, views[i + 1].rotation);
                assert_true(apart(pose.rotation, views[i].rotation) <= 1.1 * whole + 1e-9);
                assert_true(pose.fov >= fmin(views[i].fov, views[i + 1].fov) - 1e-9);
                assert_true(pose.fov <= fmax(views[i].fov, views[i + 1].fov) + 1e-9);
            }
        bat_camera_free(camera);
    }
}

/* Of a straight row of evenly spaced views the move is even: what a natural spline is there. */
static void straight_stays_straight(void **state) {
    bat_camera_pose views[5] = {0}, pose;
    (void)state;
    for (int i = 0; i < 5; i++) {
        views[i] = (bat_camera_pose){
            .position = {10 * i, 20 * i, -5 * i}, .rotation = {0, 0, 0, 1}, .fov = 30};
    }
    bat_camera *camera = through(5, views);
    meets(camera, 5, views);
    for (int i = 0; i <= 40; i++) {
        bat_camera_at_time(camera, i / 10.0, &pose);
        assert_true(fabs(pose.position[0] - i) < 1e-9 && fabs(pose.position[1] - 2 * i) < 1e-9);
        assert_true(apart(pose.rotation, views[0].rotation) < 1e-12 && pose.fov == 30);
    }
    bat_camera_free(camera);
}

static void the_same_view_is_none(void **state) {
    random_source r = {73};
    bat_camera_pose views[3] = {0};
    (void)state;
    for (int i = 0; i < 3; i++) random_view(&r, &views[i], NULL, 0);
    bat_camera *camera = tripod(&views[0]);
    assert_int_equal(go(&camera, &views[0], 0), BAT_STATE);
    for (size_t i = 1; i < 3; i++) {
        assert_int_equal(go(&camera, &views[i], i + 1), BAT_OK);
        bat_camera_pose opposed = views[i];
        for (int k = 0; k < 4; k++) opposed.rotation[k] = -opposed.rotation[k];
        assert_int_equal(go(&camera, &views[i], 0), BAT_STATE);
        assert_int_equal(go(&camera, &opposed, 0), BAT_STATE); /* the same rotation */
    }
    assert_int_equal(go(&camera, &views[0], 4), BAT_OK); /* back to the first */
    const bat_camera_pose round[4] = {views[0], views[1], views[2], views[0]};
    meets(camera, 4, round);
    bat_camera_free(camera);
}

/* Shake, timing and duration stay; the keys lie below the shake. */
static void what_else_it_has_stays(void **state) {
    random_source r = {74};
    bat_camera_pose views[3] = {0};
    (void)state;
    for (int i = 0; i < 3; i++) random_view(&r, &views[i], NULL, 0);
    bat_camera *camera = tripod(&views[0]);
    assert_int_equal(bat_camera_add_shake(camera, 5, 0.02, 3), BAT_OK);
    assert_int_equal(bat_camera_set_gain(camera, 1, 0.5), BAT_OK);
    assert_int_equal(bat_camera_set_timing(camera, 7, NULL), BAT_OK);
    bat_camera *before = NULL;
    assert_int_equal(bat_camera_copy(camera, &before), BAT_OK);
    for (size_t i = 1; i < 3; i++) assert_int_equal(go(&camera, &views[i], i + 1), BAT_OK);
    assert_int_equal(bat_camera_levels(camera), 1);
    assert_true(bat_camera_gain(camera, 1) == 0.5 && bat_camera_duration(camera) == 7);
    const bat_curve *was = bat_camera_details(before, 1), *is = bat_camera_details(camera, 1);
    double domain[2];
    bat_curve_domain(was, domain);
    for (int i = 0; i <= 100; i++) {
        double a[3], b[3];
        bat_curve_eval(was, domain[0] + (domain[1] - domain[0]) * i / 100, 0, a);
        bat_curve_eval(is, domain[0] + (domain[1] - domain[0]) * i / 100, 0, b);
        assert_true(far(a, b) < 1e-12);
    }
    bat_camera_set_muted(camera, 1, true);
    meets(camera, 3, views);
    bat_camera_free(camera), bat_camera_free(before);
}

static void refused(void **state) {
    random_source r = {75};
    bat_curve *path = random_curve(&r, 3, 3, 0, 8);
    const bat_camera_pose view = {.rotation = {0, 0, 0, 1}, .fov = 40};
    bat_camera_options options = bat_camera_defaults();
    bat_camera *camera = NULL, *made = NULL;
    bat_view_report report;
    (void)state;
    options.mode = BAT_CAMERA_ALONG;
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    assert_false(bat_camera_takes_views(camera));
    assert_int_equal(bat_camera_with_view(camera, &view, &made, &report), BAT_UNSUPPORTED);
    bat_camera_free(camera);
    options.mode = BAT_CAMERA_LOOK_AT;
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    assert_int_equal(bat_camera_with_view(camera, &view, &made, &report), BAT_UNSUPPORTED);
    bat_camera_free(camera);
    bat_curve_free(path);
}

static void every_allocation_may_fail(void **state) {
    random_source r = {76};
    bat_camera_pose views[3] = {0};
    bool reached = true;
    (void)state;
    for (int i = 0; i < 3; i++) random_view(&r, &views[i], NULL, 0);
    bat_camera *camera = through(2, views);
    for (long n = 1; reached; n++) {
        bat_camera *made = NULL;
        bat_view_report report = {0};
        alloc_fail_at(n);
        const bat_status status = bat_camera_with_view(camera, &views[2], &made, &report);
        reached = alloc_fail_reached();
        alloc_fail_at(0);
        assert_true(status == BAT_OK ? made != NULL && report.views == 3 : status == BAT_MEMORY && !made);
        bat_camera_free(made);
    }
    bat_camera_free(camera);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_view_is_met),        cmocka_unit_test(turns_on_the_spot),
        cmocka_unit_test(a_turn_on_the_way),        cmocka_unit_test(no_gaze_swings_past),
        cmocka_unit_test(straight_stays_straight),  cmocka_unit_test(the_same_view_is_none),
        cmocka_unit_test(what_else_it_has_stays),   cmocka_unit_test(refused),
        cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
