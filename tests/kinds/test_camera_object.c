/* Camera moves as objects: what they keep, how they move with the page, that they follow a curve of the drawing and go with
 * it in one step, and that both formats give them back bit for bit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "document/document.h"
#include "editor/edit/affine.h"
#include "support/alloc_fail.h"
#include "support/editing.h"
#include "support/objects.h"
#include "support/random_curve.h"
#include "support/xml.h"

enum { KEYS = 5, CAMERA = 9 };
static const double KNOTS[KEYS + 4] = {0, 0, 0, 0, .4, 1, 1, 1, 1};
static const double PERIOD[KEYS + 1] = {0, 1, 2.5, 3, 4, 5.5};

/* One of many: every mode, with and without base, target, first frame, functions and levels, open and closed. */
static bat_camera *some_camera(const bat_curve *path, int number) {
    random_source r = {(uint64_t)number + 3};
    const bool closed = number % 2 == 1;
    double keys[4 * KEYS] = {0}, details[3 * KEYS];
    for (int i = 0; i < 4 * KEYS; i++) keys[i] = i % 4 == 3 ? 1 : random_between(&r, -.5, .5);
    for (int i = 0; i < 3 * KEYS; i++) details[i] = random_between(&r, -.3, .3);
    const bat_rotation_curve base = {.degree = 3,
                                     .closed = closed,
                                     .count = KEYS,
                                     .points = keys,
                                     .knot_count = closed ? KEYS + 1 : KEYS + 4,
                                     .knots = closed ? PERIOD : KNOTS};
    const double rise[8] = {0, 0, .1, 0, .8, 0, 1, 0};
    bat_curve *timing = NULL;
    assert_int_equal(bat_curve_create(2, 3, false, 4, rise, 8, (double[]){0, 0, 0, 0, 1, 1, 1, 1}, &timing),
                     BAT_OK);
    bat_camera_options options = bat_camera_defaults();
    options.mode = (bat_camera_mode)(number % 3);
    options.base = number % 3 == 1 && number % 4 < 2 ? NULL : &base;
    options.has_first = number % 5 > 2;
    options.first[0] = .3, options.first[2] = 1;
    options.target[0] = 900, options.target[2] = -77;
    options.up[0] = .2, options.up[1] = .1;
    bat_curve *target = random_curve(&r, 2 + number % 2, 2, 0, 5);
    if (number % 4 > 1) options.target_curve = target;
    options.fov = bat_function_of(20 + number);
    if (number % 2 == 0) options.timing.curve = timing;
    options.duration = 1.5 + number;
    bat_camera *camera = NULL;
    assert_int_equal(bat_camera_create(path, &options, &camera), BAT_OK);
    const bool based = bat_camera_base(camera, NULL) != NULL;
    for (int l = 0; l < number % 4; l++) {
        const bool round = based ? closed : bat_curve_is_closed(path);
        assert_int_equal(
            bat_camera_add_level(camera, round ? KEYS + 1 : KEYS + 4, round ? PERIOD : KNOTS, KEYS, details),
            BAT_OK);
        if (l == 1) assert_int_equal(bat_camera_set_gain(camera, 2, .25), BAT_OK);
    }
    if (number % 5 == 4) assert_int_equal(bat_camera_add_shake(camera, 7 + (uint64_t)number, .1, 3), BAT_OK);
    bat_curve_free(timing), bat_curve_free(target);
    return camera;
}

static bat_curve *some_path(int number) {
    random_source r = {(uint64_t)number + 40};
    return random_curve(&r, 3, number % 3 == 0 ? 2 : 3, number % 4 == 3 ? 2 : 0, 7);
}

static bat_object *object_of(const bat_camera *camera, bat_id follows) {
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_camera(CAMERA, "Fly", &style, camera, follows, &object), BAT_OK);
    return object;
}

/* The same poses, bit for bit. */
static void same(const bat_camera *a, const bat_camera *b) {
    double domain[2];
    assert_int_equal(bat_camera_mode_of(a), bat_camera_mode_of(b));
    bat_camera_domain(a, domain);
    for (int i = 0; i <= 20; i++) {
        bat_camera_pose p, q;
        bat_camera_at_time(a, bat_camera_duration(a) * i / 20, &p);
        bat_camera_at_time(b, bat_camera_duration(b) * i / 20, &q);
        assert_true(p.u == q.u && p.distance == q.distance && p.fov == q.fov);
        for (int k = 0; k < 3; k++) assert_true(p.position[k] == q.position[k]);
        for (int k = 0; k < 4; k++) assert_true(p.rotation[k] == q.rotation[k]);
    }
}

static void text_gives_them_back(void **state) {
    (void)state;
    for (int number = 0; number < 60; number++) {
        bat_curve *path = some_path(number);
        bat_camera *camera = some_camera(path, number), *back = NULL, *copy = NULL;
        char *text = NULL, *again = NULL;
        size_t size, next;
        bat_problem problem = {"", ""};
        assert_int_equal(bat_camera_write(camera, &text, &size), BAT_OK);
        assert_int_equal(bat_camera_read(text, size, &back, &problem), BAT_OK);
        assert_int_equal(bat_camera_write(back, &again, &next), BAT_OK);
        assert_string_equal(text, again);
        same(camera, back);
        assert_int_equal(bat_camera_copy(camera, &copy), BAT_OK);
        same(camera, copy);
        bat_free(text), bat_free(again);
        bat_camera_free(camera), bat_camera_free(back), bat_camera_free(copy);
        bat_curve_free(path);
    }
}

static void both_formats_give_them_back(void **state) {
    (void)state;
    for (int number = 0; number < 60; number++) {
        bat_curve *path = some_path(number);
        bat_camera *camera = some_camera(path, number);
        bat_document *document = of_one(object_of(camera, 0));
        assert_null(bat_document_check(document));
        for (int svg = 0; svg < 2; svg++) {
            bat_document *back = NULL;
            bat_svg_report report;
            bat_problem problem;
            char *text;
            size_t size;
            assert_int_equal(svg ? bat_svg_write(document, true, &text, &size)
                                 : bat_document_write(document, &text, &size),
                             BAT_OK);
            assert_non_null(strstr(text, svg ? "{&quot;batten&quot;:2," : "{\"batten\":2,"));
            if (svg) assert_null(strstr(text, "<path")); /* it is in no picture */
            assert_int_equal(svg ? xml_read(text, NULL, &back, &report, &problem)
                                 : bat_document_read(text, size, &back, &problem),
                             BAT_OK);
            assert_true(bat_document_digest(back) == bat_document_digest(document));
            same(bat_object_camera(bat_document_at(back, 0)), camera);
            bat_document_free(back);
            bat_free(text);
        }
        bat_document_free(document);
        bat_camera_free(camera);
        bat_curve_free(path);
    }
}

static void text_refused(void **state) {
    (void)state;
    object_refused("{\"id\":1,\"kind\":\"camera\"}");
    object_refused("{\"id\":1,\"kind\":\"camera\",\"move\":3}");
    object_refused("{\"id\":1,\"kind\":\"camera\",\"move\":{}}");
    static const char move[] =
        "\"move\":{\"path\":{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0],[9,0]]},"
        "\"orientation\":{\"mode\":\"along\"}}";
    static const char *const follows[] = {"1", "2", "0", "-1", "\"a\"", "1.5", NULL};
    char text[400];
    for (int i = 0; follows[i]; i++) {
        snprintf(text, sizeof text, "{\"id\":1,\"kind\":\"camera\",\"follows\":%s,%s}", follows[i], move);
        object_refused(text);
    }
}

/* What a shake is drawn from: three numbers, all there and in range, and not so many vectors that a short text takes long. */
static void shakes_refused(void **state) {
    (void)state;
    static const char *const bad[] = {"3",
                                      "{}",
                                      "{\"amount\":1,\"rate\":1}",
                                      "{\"seed\":1,\"rate\":1}",
                                      "{\"seed\":1,\"amount\":1}",
                                      "{\"seed\":1.5,\"amount\":1,\"rate\":1}",
                                      "{\"seed\":-1,\"amount\":1,\"rate\":1}",
                                      "{\"seed\":1e17,\"amount\":1,\"rate\":1}",
                                      "{\"seed\":1,\"amount\":0,\"rate\":1}",
                                      "{\"seed\":1,\"amount\":4,\"rate\":1}",
                                      "{\"seed\":1,\"amount\":1,\"rate\":0}",
                                      "{\"seed\":1,\"amount\":1,\"rate\":\"a\"}",
                                      "{\"seed\":1,\"amount\":1,\"rate\":1e9}"};
    static const char move[] = "{\"path\":{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0],[9,0]]},"
                               "\"orientation\":{\"mode\":\"along\",\"levels\":[{\"shake\":%s}]}}";
    char text[400];
    bat_camera *camera = NULL;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        const int size = snprintf(text, sizeof text, move, bad[i]);
        assert_int_equal(bat_camera_read(text, (size_t)size, &camera, NULL), BAT_SYNTAX);
    }
    const int size = snprintf(text, sizeof text, move, "{\"seed\":1,\"amount\":1,\"rate\":8}");
    assert_int_equal(bat_camera_read(text, (size_t)size, &camera, NULL), BAT_OK);
    assert_int_equal(bat_camera_levels(camera), 1);
    bat_camera_free(camera);
}

static void refusals(void **state) {
    (void)state;
    const bat_style style = bat_style_defaults();
    bat_curve *path = some_path(1);
    bat_camera *camera = some_camera(path, 1);
    bat_object *object = NULL, *guide = NULL;
    assert_int_equal(bat_object_create_camera(1, "", NULL, camera, 0, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_camera(1, "", &style, NULL, 0, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_camera(1, "", &style, camera, 1, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_camera(1, "", &style, camera, BAT_ID_MAX + 1, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_camera(0, "", &style, camera, 0, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_camera(1, "\xff", &style, camera, 0, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_camera(1, "", &style, camera, 0, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_guide(3, 0, 1, &guide), BAT_OK);
    assert_int_equal(bat_object_with_camera(guide, camera, 0, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_camera(NULL, camera, 0, &object), BAT_ARGUMENT);
    assert_null(bat_object_camera(guide));
    assert_true(bat_object_followed(guide) == 0);
    assert_null(object);
    assert_int_equal(bat_camera_with_path(NULL, path, &camera), BAT_ARGUMENT);
    assert_int_equal(bat_camera_write(NULL, NULL, NULL), BAT_ARGUMENT);
    bat_object_release(guide);
    bat_camera_free(camera);
    bat_curve_free(path);
}

/* M as a matrix of three by four that turns and mirrors the page about its origin, and moves it. */
static void map(const double m[6], const double from[3], double to[3]) {
    to[0] = m[0] * from[0] + m[2] * from[1] + m[4], to[1] = m[1] * from[0] + m[3] * from[1] + m[5],
    to[2] = from[2];
}

/* A direction of the camera in the world: along x (0), y or z. */
static void axis(const bat_camera_pose *pose, int k, double out[3]) {
    const double *q = pose->rotation, x = q[0], y = q[1], z = q[2], w = q[3];
    const double rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                               {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                               {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    for (int i = 0; i < 3; i++) out[i] = rows[i][k];
}

/* Turned, scaled, moved and mirrored on the page it sees the image of what it saw: its gaze and its up are the images of
 * those it had, and its right is, too, but for mirrors, where it is opposed. */
static void moves_with_the_page(void **state) {
    (void)state;
    static const double maps[3][6] = {
        {.6, .8, -.8, .6, 10, 20}, {-1, 0, 0, 1, 7, 0}, {1.2, 1.6, 1.6, -1.2, -5, 3}};
    for (int number = 0; number < 72; number++) {
        const double *m = maps[number % 3];
        const double scale = hypot(m[0], m[1]), side = m[0] * m[3] - m[1] * m[2] < 0 ? -1 : 1;
        bat_curve *path = some_path(number);
        bat_camera *camera = some_camera(path, number / 3);
        bat_object *object = object_of(camera, 0), *moved = NULL;
        assert_int_equal(bat_affine_object(object, m, false, &moved), BAT_OK);
        assert_null(bat_object_check(moved));
        const bat_camera *image = bat_object_camera(moved);
        for (int i = 0; i <= 10; i++) {
            bat_camera_pose p, q;
            double at[3];
            bat_camera_at_time(camera, bat_camera_duration(camera) * i / 10, &p);
            bat_camera_at_time(image, bat_camera_duration(camera) * i / 10, &q);
            map(m, p.position, at);
            for (int k = 0; k < 3; k++) /* z is kept: only a map that does not scale is one of space */
                assert_true(scale > 1.5 || fabs(q.position[k] - at[k]) < 1e-7);
            for (int k = 0; k < 3 && scale < 1.5; k++) {
                double before[3], after[3], wanted[3];
                const double linear[6] = {m[0], m[1], m[2], m[3], 0, 0};
                axis(&p, k, before), axis(&q, k, after);
                map(linear, before, wanted);
                for (int d = 0; d < 3; d++)
                    assert_true(fabs(after[d] - (k == 0 ? side : 1) * wanted[d]) < 1e-7);
            }
        }
        bat_object_release(moved), bat_object_release(object);
        bat_camera_free(camera);
        bat_curve_free(path);
    }
}

/* ---- following ---- */

/* A curve (1), and a camera (CAMERA) that follows it. */
static bat_document *with_follower(void) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    bat_curve *path = pen_curve(200, 400, 60, 5, 11);
    bat_camera *camera = some_camera(path, 4);
    pen_add(document, path);
    bat_object *object = object_of(camera, bat_object_id(bat_document_at(document, 0)));
    assert_int_equal(bat_document_insert(document, 1, object), BAT_OK);
    bat_object_release(object);
    bat_camera_free(camera);
    assert_null(bat_document_check(document));
    return document;
}

static const bat_object *camera_in(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    return bat_document_at(document, bat_document_find(document, CAMERA));
}

static void same_path(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    const bat_object *camera = camera_in(editor), *source = NULL;
    assert_non_null(camera);
    source = bat_document_at(document, bat_document_find(document, bat_object_followed(camera)));
    assert_non_null(source);
    bat_curve *space = NULL;
    assert_int_equal(bat_curve_to_dimension(bat_object_curve(source, 0), 3, &space), BAT_OK);
    assert_true(bat_curve_is_equal(space, bat_camera_path(bat_object_camera(camera))));
    bat_curve_free(space);
}

/* Whatever hand changes the curve, the camera's path is that curve, and undo takes both back. */
static void goes_where_the_curve_goes(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-sketch", "tool-smooth", "tool-points", "tool-levels"};
    for (size_t i = 0; i < sizeof tools / sizeof *tools; i++) {
        bat_editor *editor = editor_of(with_follower());
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        bat_editor_command(editor, tools[i]);
        if (i == 0) {
            pen_begin(&p, pen_arch, (double[]){300, 430, 500, 430, -60}, 30);
            pen_event(&p, BAT_POINTER_UP, 500, 430);
        }
        bat_editor_command(editor, "tool-select");
        tap(&p, 640, 460); /* nothing */
        bat_editor_command(editor, "select-all");
        bat_editor_command(editor, "nudge-right");
        check(editor);
        assert_true(digest(editor) != first);
        same_path(editor);
        replays(editor, i);
        round_trip(editor, first);
        bat_editor_free(editor);
    }
}

static void goes_with_the_curve(void **state) {
    (void)state;
    bat_editor *editor = editor_of(with_follower());
    const uint64_t first = digest(editor);
    const bat_id curve = bat_object_followed(camera_in(editor));
    bat_editor_command(editor, "tool-select");
    assert_int_equal(bat_editor_select(editor, curve, false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "delete"), BAT_OK);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 0);
    replays(editor, 1);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK); /* one step brings both back */
    assert_true(digest(editor) == first);
    same_path(editor);
    bat_editor_free(editor);
}

/* Alone it takes its path along; with its curve it follows the copy. */
static void is_copied(void **state) {
    (void)state;
    for (int both = 0; both < 2; both++) {
        bat_editor *editor = editor_of(with_follower());
        const uint64_t first = digest(editor);
        if (both)
            bat_editor_command(editor, "select-all");
        else
            assert_int_equal(bat_editor_select(editor, CAMERA, false), BAT_OK);
        char *text = NULL;
        size_t size;
        bat_document *part = NULL;
        bat_svg_report report;
        bat_problem problem;
        assert_int_equal(bat_editor_copy(editor, false, &text, &size), BAT_OK);
        assert_int_equal(xml_read(text, NULL, &part, &report, &problem), BAT_OK);
        assert_int_equal(bat_editor_paste(editor, part, true), BAT_OK);
        const bat_document *document = bat_editor_document(editor);
        const int count = bat_document_count(document);
        assert_int_equal(count, both ? 4 : 3);
        const bat_object *copy = bat_document_at(document, count - 1);
        assert_non_null(bat_object_camera(copy));
        assert_true(bat_object_followed(copy) ==
                    (both ? bat_object_id(bat_document_at(document, count - 2)) : (bat_id)0));
        check(editor);
        replays(editor, (uint64_t)both);
        round_trip(editor, first);
        bat_free(text);
        bat_document_free(part);
        bat_editor_free(editor);
    }
}

/* Duplicated together, the camera's copy follows the curve's copy, before it and after it; alone it follows the curve. */
static void is_duplicated(void **state) {
    (void)state;
    for (int both = 0; both < 2; both++) {
        bat_editor *editor = editor_of(with_follower());
        const uint64_t first = digest(editor);
        const bat_id curve = bat_object_followed(camera_in(editor));
        if (both)
            bat_editor_command(editor, "select-all");
        else
            assert_int_equal(bat_editor_select(editor, CAMERA, false), BAT_OK);
        assert_int_equal(bat_editor_command(editor, "duplicate"), BAT_OK);
        const bat_document *document = bat_editor_document(editor);
        assert_int_equal(bat_document_count(document), both ? 4 : 3);
        int cameras = 0;
        for (int i = 0; i < bat_document_count(document); i++) {
            const bat_object *object = bat_document_at(document, i);
            const bat_id source = bat_object_followed(object);
            if (!bat_object_camera(object)) continue;
            cameras++;
            if (bat_object_id(object) == CAMERA || !both) {
                assert_int_equal(source, curve);
                continue;
            }
            assert_int_not_equal(source, curve);
            const bat_object *led = bat_document_at(document, bat_document_find(document, source));
            const bat_camera *camera = bat_object_camera(object);
            bat_camera_pose pose;
            double domain[2], at[3] = {0};
            bat_camera_domain(camera, domain);
            bat_camera_at(camera, domain[1], &pose);
            bat_curve_eval(bat_object_curve(led, 0), domain[1], 0, at);
            for (int d = 0; d < 2; d++) assert_true(fabs(pose.position[d] - at[d]) < 1e-12);
        }
        assert_int_equal(cameras, 2);
        check(editor);
        replays(editor, (uint64_t)(2 + both));
        round_trip(editor, first);
        bat_editor_free(editor);
    }
}

/* A file whose camera has another path than its curve, as after an edit by hand: the curve counts. */
static void the_curve_counts(void **state) {
    (void)state;
    bat_document *document = with_follower(), *back = NULL;
    bat_problem problem;
    char *text;
    size_t size;
    bat_object *moved = NULL;
    const double shift[6] = {1, 0, 0, 1, 30, 0};
    assert_int_equal(bat_affine_object(bat_document_at(document, 0), shift, false, &moved), BAT_OK);
    assert_int_equal(bat_document_replace(document, 0, moved), BAT_OK); /* the camera is behind */
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    assert_int_equal(bat_document_read(text, size, &back, &problem), BAT_OK);
    bat_editor *editor = editor_of(back);
    same_path(editor);
    bat_editor_free(editor);
    bat_object_release(moved);
    bat_free(text);
    bat_document_remove(document, 0);
    assert_non_null(bat_document_check(document));
    bat_document_free(document);
}

/* ---- memory ---- */

static bat_status make(int way, const bat_object *object, bat_object **out) {
    const bat_style style = bat_style_defaults();
    const bat_camera *camera = bat_object_camera(object);
    if (way == 0) return bat_object_create_camera(4, "fly", &style, camera, 0, out);
    if (way == 1) return bat_object_with_camera(object, camera, 3, out);
    return bat_affine_object(object, (const double[6]){0, 1, 1, 0, 10, 20}, true, out);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    for (int number = 0; number < 12; number++) {
        bat_curve *path = some_path(number);
        bat_camera *camera = some_camera(path, number);
        bat_object *object = object_of(camera, 0);
        for (int way = 0; way < 3; way++) {
            bool reached = true;
            for (long n = 1; reached; n++) {
                const long before = alloc_live();
                bat_object *out = NULL;
                alloc_fail_at(n);
                const bat_status status = make(way, object, &out);
                reached = alloc_fail_reached();
                assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
                assert_true(reached == !out);
                bat_object_release(out);
                assert_int_equal(alloc_live(), before);
            }
        }
        bat_object_release(object);
        bat_camera_free(camera);
        bat_curve_free(path);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(text_gives_them_back),
                                       cmocka_unit_test(both_formats_give_them_back),
                                       cmocka_unit_test(text_refused),
                                       cmocka_unit_test(shakes_refused),
                                       cmocka_unit_test(refusals),
                                       cmocka_unit_test(moves_with_the_page),
                                       cmocka_unit_test(goes_where_the_curve_goes),
                                       cmocka_unit_test(goes_with_the_curve),
                                       cmocka_unit_test(is_copied),
                                       cmocka_unit_test(is_duplicated),
                                       cmocka_unit_test(the_curve_counts),
                                       cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
