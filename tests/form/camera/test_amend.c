/* Keys of a base: adding one changes nothing that is seen, taking that one away gives back what was; the change that is
 * reported is the largest; fields of view; what is looked at. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/camera.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { KEYS = 7, PLACES = 200 };
static const double KNOTS[KEYS + 4] = {0, 0, 0, 0, .2, .5, .8, 1, 1, 1, 1},
                                 PERIOD[KEYS + 1] = {0, 1, 2.5, 3, 4, 5.5, 6, 7};

/* How far two unit quaternions are apart as rotations, in radians. */
static double apart(const double *a, const double *b) {
    double minus = 0, plus = 0;
    for (int k = 0; k < 4; k++) minus += (a[k] - b[k]) * (a[k] - b[k]), plus += (a[k] + b[k]) * (a[k] + b[k]);
    return 4 * asin(fmin(0.5 * sqrt(fmin(minus, plus)), 1));
}

/* round: the keys turn once about an axis on the way. */
static bat_camera *some_camera(random_source *r, bat_camera_mode mode, bool closed, bool round, int levels) {
    double keys[4 * KEYS], details[3 * KEYS];
    bat_curve *path = random_curve(r, 3, 3, closed ? 2 : 0, 8);
    bat_camera *camera = NULL;
    for (int i = 0; i < KEYS; i++) {
        const double half = round ? 3.14159265358979 * i / KEYS : 0;
        for (int k = 0; k < 4; k++) keys[4 * i + k] = random_between(r, -0.2, 0.2);
        keys[4 * i + 2] += sin(half), keys[4 * i + 3] += cos(half);
    }
    const bat_rotation_curve base = {.degree = 3,
                                     .closed = closed,
                                     .count = KEYS,
                                     .points = keys,
                                     .knot_count = closed ? KEYS + 1 : KEYS + 4,
                                     .knots = closed ? PERIOD : KNOTS};
    bat_camera_options options = bat_camera_defaults();
    options.mode = mode;
    options.base = &base;
    options.target[0] = 50;
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    for (int l = 0; l < levels; l++) {
        for (int i = 0; i < 3 * KEYS; i++) details[i] = random_between(r, -0.5, 0.5);
        assert_int_equal(bat_camera_add_level(camera, (int)base.knot_count, base.knots, KEYS, details),
                         BAT_OK);
    }
    bat_curve_free(path);
    return camera;
}

static double between(const bat_camera *camera, double share) {
    double domain[2];
    bat_camera_domain(camera, domain);
    return domain[0] + (domain[1] - domain[0]) * share;
}

/* How far two moves turn apart, at most. */
static double difference(const bat_camera *a, const bat_camera *b) {
    double most = 0;
    for (int i = 0; i <= PLACES; i++) {
        bat_camera_pose one, other;
        bat_camera_at(a, between(a, (double)i / PLACES), &one);
        bat_camera_at(b, between(b, (double)i / PLACES), &other);
        most = fmax(most, apart(one.rotation, other.rotation));
    }
    return most;
}

static size_t keys_of(const bat_camera *camera) {
    size_t count = 0;
    bat_camera_base(camera, &count);
    return count;
}

static void added_keys_change_nothing(void **state) {
    (void)state;
    random_source r = {7};
    for (int n = 0; n < 80; n++) {
        const bool closed = n & 1, round = n & 2;
        bat_camera *camera = some_camera(&r, n & 4 ? BAT_CAMERA_ALONG : BAT_CAMERA_FREE, closed, round,
                                         n % 3);
        bat_camera *before = NULL, *read = NULL;
        assert_int_equal(bat_camera_copy(camera, &before), BAT_OK);
        for (int more = 1; more <= 4; more++) {
            const double u = between(camera, random_between(&r, 0.02, 0.98));
            size_t key = 1000;
            assert_int_equal(bat_camera_add_key(camera, u, &key), BAT_OK);
            assert_int_equal(keys_of(camera), KEYS + more);
            assert_true(difference(camera, before) < 1e-12);
            double least = INFINITY;
            for (size_t i = 0; i < keys_of(camera); i++) {
                double away = fabs(bat_camera_key_place(camera, i) - u);
                if (closed) away = fmin(away, between(camera, 1) - between(camera, 0) - away);
                least = fmin(least, away);
            }
            double away = fabs(bat_camera_key_place(camera, key) - u);
            if (closed) away = fmin(away, between(camera, 1) - between(camera, 0) - away);
            assert_true(away == least);
        }
        /* They are kept in a file, with their weights. */
        char *text = NULL;
        size_t size = 0;
        assert_int_equal(bat_camera_write(camera, &text, &size), BAT_OK);
        assert_non_null(strstr(text, "\"weights\":["));
        assert_int_equal(bat_camera_read(text, size, &read, NULL), BAT_OK);
        assert_true(difference(read, camera) == 0);
        bat_free(text);
        bat_camera_free(camera), bat_camera_free(before), bat_camera_free(read);
    }
}

static void what_was_added_can_go(void **state) {
    (void)state;
    random_source r = {11};
    for (int n = 0; n < 80; n++) {
        bat_camera *camera = some_camera(&r, BAT_CAMERA_FREE, n & 1, n & 2, 1), *before = NULL;
        size_t key = 0;
        double change = -1;
        assert_int_equal(bat_camera_copy(camera, &before), BAT_OK);
        /* In the middle of a wide span, so that the knot is the one nearest to its key's place. */
        const double u = between(camera, n & 1 ? (1 + 0.75) / 7 : 0.35);
        assert_int_equal(bat_camera_add_key(camera, u, &key), BAT_OK);
        assert_int_equal(bat_camera_remove_key(camera, key, &change), BAT_OK);
        assert_int_equal(keys_of(camera), KEYS);
        assert_true(change >= 0 && change < 1e-9);
        assert_true(difference(camera, before) < 1e-9);
        bat_camera_free(camera), bat_camera_free(before);
    }
}

/* Of the base alone the change is what is seen; the places where it was looked for lie close. */
static void the_change_is_reported(void **state) {
    (void)state;
    random_source r = {13};
    for (int n = 0; n < 60; n++) {
        bat_camera *camera = some_camera(&r, BAT_CAMERA_FREE, n & 1, n & 2, 0), *before = NULL;
        double change = 0;
        assert_int_equal(bat_camera_copy(camera, &before), BAT_OK);
        const bat_status status = bat_camera_remove_key(camera, (size_t)(n % KEYS), &change);
        if (status == BAT_OK) {
            const double seen = difference(camera, before);
            assert_true(change > 0 && fabs(seen - change) < 0.02 * change + 1e-9);
        } else {
            assert_int_equal(status, BAT_SINGULAR);
            assert_true(difference(camera, before) == 0);
        }
        bat_camera_free(camera), bat_camera_free(before);
    }
}

/* All keys but those that a span needs can go; then none. */
static void the_last_keys_stay(void **state) {
    (void)state;
    random_source r = {17};
    for (int closed = 0; closed < 2; closed++) {
        bat_camera *camera = some_camera(&r, BAT_CAMERA_FREE, closed, false, 0);
        while (bat_camera_remove_key(camera, keys_of(camera) / 2, NULL) == BAT_OK) {
        }
        assert_int_equal(keys_of(camera), 4);
        assert_int_equal(bat_camera_remove_key(camera, 1, NULL), BAT_COUNT);
        bat_camera_free(camera);
    }
}

/* A camera along its path gets keys that turn nothing. */
static void along_gets_its_first_keys(void **state) {
    (void)state;
    random_source r = {19};
    for (int closed = 0; closed < 2; closed++) {
        bat_curve *path = random_curve(&r, 3, 3, closed ? 2 : 0, 8);
        bat_camera *camera = NULL, *before = NULL;
        bat_camera_options options = bat_camera_defaults();
        options.mode = BAT_CAMERA_ALONG;
        assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
        assert_int_equal(bat_camera_copy(camera, &before), BAT_OK);
        assert_true(isnan(bat_camera_key_place(camera, 0)));
        size_t key = 0;
        assert_int_equal(bat_camera_add_key(camera, between(camera, 0.45), &key), BAT_OK);
        assert_int_equal(keys_of(camera), closed ? 7 : 5);
        assert_true(difference(camera, before) < 1e-12);
        bat_camera_pose pose;
        const double u = bat_camera_key_place(camera, key), aside[4] = {0.1, 0, 0, 1};
        assert_true(u >= between(camera, 0) && u <= between(camera, 1));
        assert_int_equal(bat_camera_turn(camera, 0, u, aside), BAT_OK);
        bat_camera_at(camera, u, &pose);
        assert_true(fabs(pose.rotation[0] - 0.1 / sqrt(1.01)) < 1e-9 ||
                    fabs(pose.rotation[0] + 0.1 / sqrt(1.01)) < 1e-9);
        bat_camera_free(camera), bat_camera_free(before);
        bat_curve_free(path);
    }
}

static void fields_of_view(void **state) {
    (void)state;
    random_source r = {23};
    bat_camera *camera = some_camera(&r, BAT_CAMERA_FREE, false, false, 0);
    bat_camera_pose pose;
    assert_int_equal(bat_camera_set_fov(camera, between(camera, 0.3), 65), BAT_OK);
    bat_camera_at(camera, between(camera, 0.9), &pose);
    assert_true(pose.fov == 65);
    assert_int_equal(bat_camera_set_fov(camera, 0, 1e9), BAT_OK);
    bat_camera_at(camera, between(camera, 0.9), &pose);
    assert_true(pose.fov == 170);
    assert_int_equal(bat_camera_set_fov(camera, NAN, 40), BAT_NUMBER);
    assert_int_equal(bat_camera_set_fov(camera, 0, NAN), BAT_NUMBER);
    /* One that moves is met where it is asked for, and stays at the other end. */
    static const double knots[11] = {0, 0, 0, 0, .3, .5, .8, 1, 1, 1, 1};
    bat_curve *values = NULL, *path = NULL;
    double points[14] = {40, 0, 42, 0, 44, 0, 50, 0, 60, 0, 70, 0, 72, 0};
    assert_int_equal(bat_curve_create(2, 3, false, 7, points, 11, knots, &values), BAT_OK);
    assert_int_equal(bat_curve_copy(bat_camera_path(camera), &path), BAT_OK);
    bat_camera_free(camera), camera = NULL;
    bat_camera_options options = bat_camera_defaults();
    options.mode = BAT_CAMERA_ALONG;
    options.fov = (bat_function){0, values};
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    assert_int_equal(bat_camera_set_fov(camera, between(camera, 0.2), 55), BAT_OK);
    bat_camera_at(camera, between(camera, 0.2), &pose);
    assert_true(fabs(pose.fov - 55) < 1e-12);
    bat_camera_at(camera, between(camera, 1), &pose);
    assert_true(pose.fov == 72);
    bat_camera_free(camera), bat_curve_free(values), bat_curve_free(path);
}

static void looks_at_a_target(void **state) {
    (void)state;
    static const double target[3] = {1e3, -200, 70}, up[3] = {0, 0, -1};
    random_source r = {29};
    bat_camera *camera = some_camera(&r, BAT_CAMERA_ALONG, false, false, 2), *aimed = NULL, *free = NULL;
    assert_int_equal(bat_camera_aim(camera, target, up, &aimed), BAT_OK);
    assert_int_equal(bat_camera_mode_of(aimed), BAT_CAMERA_LOOK_AT);
    assert_int_equal(bat_camera_levels(aimed), 2);
    for (int l = 1; l <= 2; l++) assert_int_equal(bat_camera_set_gain(aimed, l, 0), BAT_OK);
    for (int i = 0; i <= 20; i++) {
        bat_camera_pose pose;
        double way[3], length = 0, off = 0;
        bat_camera_at(aimed, between(aimed, i / 20.0), &pose);
        const double *q = pose.rotation;
        const double z[3] = {2 * (q[0] * q[2] + q[1] * q[3]), 2 * (q[1] * q[2] - q[0] * q[3]),
                             1 - 2 * (q[0] * q[0] + q[1] * q[1])};
        for (int k = 0; k < 3; k++) way[k] = pose.position[k] - target[k], length += way[k] * way[k];
        for (int k = 0; k < 3; k++) off = fmax(off, fabs(way[k] / sqrt(length) - z[k]));
        assert_true(off < 1e-12);
    }
    assert_int_equal(bat_camera_add_key(aimed, 0, NULL), BAT_UNSUPPORTED);
    assert_int_equal(bat_camera_let_go(aimed, up, &free), BAT_OK);
    assert_int_equal(bat_camera_mode_of(free), BAT_CAMERA_ALONG);
    assert_int_equal(keys_of(free), 0);
    bat_camera_free(camera), bat_camera_free(aimed), bat_camera_free(free);
}

static void refused(void **state) {
    (void)state;
    random_source r = {31};
    bat_camera *camera = some_camera(&r, BAT_CAMERA_FREE, false, false, 0), *out = NULL;
    assert_int_equal(bat_camera_add_key(NULL, 0, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_camera_add_key(camera, NAN, NULL), BAT_NUMBER);
    assert_int_equal(bat_camera_add_key(camera, -INFINITY, NULL), BAT_COUNT); /* the start has its knots */
    assert_int_equal(bat_camera_add_key(camera, between(camera, 0.3), NULL), BAT_OK);
    assert_int_equal(bat_camera_add_key(camera, between(camera, 0.3), NULL), BAT_COUNT);
    assert_int_equal(bat_camera_remove_key(camera, 100, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_camera_remove_key(NULL, 0, NULL), BAT_ARGUMENT);
    const double bad[3] = {NAN, 0, 0}, up[3] = {0, 0, 1}, none[3] = {0, 0, 0};
    assert_int_not_equal(bat_camera_aim(camera, bad, up, &out), BAT_OK);
    assert_int_equal(bat_camera_aim(camera, up, none, &out), BAT_SINGULAR);
    assert_int_equal(bat_camera_aim(camera, up, NULL, &out), BAT_ARGUMENT);
    assert_int_equal(bat_camera_let_go(NULL, up, &out), BAT_ARGUMENT);
    assert_int_equal(bat_camera_let_go(camera, bad, &out), BAT_NUMBER);
    assert_null(out);
    bat_camera_free(camera);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    random_source r = {37};
    const double up[3] = {0, 0, 1};
    bat_camera *kept = some_camera(&r, BAT_CAMERA_ALONG, true, true, 1);
    for (int which = 0; which < 4; which++) {
        bool reached = true;
        for (long n = 1; reached; n++) {
            bat_camera *camera = NULL, *out = NULL;
            assert_int_equal(bat_camera_copy(kept, &camera), BAT_OK);
            alloc_fail_at(n);
            const bat_status status = which == 0   ? bat_camera_add_key(camera, between(camera, 0.21), NULL)
                                      : which == 1 ? bat_camera_remove_key(camera, 3, NULL)
                                      : which == 2 ? bat_camera_aim(camera, up, up, &out)
                                                   : bat_camera_let_go(camera, up, &out);
            reached = alloc_fail_reached();
            alloc_fail_at(0);
            assert_true(status == BAT_OK || (reached && status == BAT_MEMORY));
            if (status != BAT_OK) assert_true(difference(camera, kept) == 0 && !out);
            bat_camera_free(camera), bat_camera_free(out);
        }
    }
    bat_camera_free(kept);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(added_keys_change_nothing), cmocka_unit_test(what_was_added_can_go),
        cmocka_unit_test(the_change_is_reported),    cmocka_unit_test(the_last_keys_stay),
        cmocka_unit_test(along_gets_its_first_keys), cmocka_unit_test(fields_of_view),
        cmocka_unit_test(looks_at_a_target),         cmocka_unit_test(refused),
        cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
