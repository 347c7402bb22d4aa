/* Grounds: the pen's position on the page and on a plane in space, and the sketch tool on both. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/editing.h"
#include <batten/batten.h>
#include <math.h>
#include <stdio.h>

/* Through (40, 20, -70), turned about all three axes. */
static const double ORIGIN[3] = {40, 20, -70};
static double axes[6], normal[3];

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void tilt(void) {
    const double a = 0.6, b = 0.5;
    const double x[3] = {cos(b), sin(a) * sin(b), cos(a) * sin(b)}, y[3] = {0, cos(a), -sin(a)};
    memcpy(axes, x, sizeof x);
    memcpy(axes + 3, y, sizeof y);
    for (int k = 0; k < 3; k++) normal[k] = x[(k + 1) % 3] * y[(k + 2) % 3] - x[(k + 2) % 3] * y[(k + 1) % 3];
}

/* How far a place lies off the plane. */
static double off(const double at[3]) {
    double from[3] = {at[0] - ORIGIN[0], at[1] - ORIGIN[1], at[2] - ORIGIN[2]};
    return dot(from, normal);
}

/* The z that the plane has over x y. */
static double height(double x, double y) { return ORIGIN[2] - off((double[]){x, y, ORIGIN[2]}) / normal[2]; }

/* The curve on the plane that looks like a planar one. */
static bat_curve *lifted(bat_curve *flat) {
    size_t count = bat_curve_count(flat);
    double points[3 * 32];
    bat_curve *curve = NULL;
    for (size_t i = 0; i < count; i++) {
        const double *p = bat_curve_points(flat) + 2 * i;
        memcpy(points + 3 * i, (double[]){p[0], p[1], height(p[0], p[1])}, 3 * sizeof *points);
    }
    bat_curve_to_dimension(flat, 3, &curve);
    bat_curve_free(flat);
    bat_curve *made = NULL;
    assert_int_equal(bat_curve_create(3, 3, false, count, points, bat_curve_knot_count(curve),
                                      bat_curve_knots(curve), &made),
                     BAT_OK);
    bat_curve_free(curve);
    return made;
}

enum { FLAT, HIGH, LOW, PLANE }; /* of the document's objects */

/* A curve of the page at y = 100, two on the plane that look like y = 300 and y = 600, and the plane. */
static bat_editor *in_space(void) {
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    bat_object *plane = NULL;
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, pen_curve(200, 100, 60, 0, 11));
    pen_add(document, lifted(pen_curve(200, 300, 60, 0, 11)));
    pen_add(document, lifted(pen_curve(200, 600, 60, 0, 11)));
    assert_int_equal(bat_object_create_plane(bat_document_new_id(document), "Slope", ORIGIN, axes, &plane),
                     BAT_OK);
    assert_int_equal(bat_document_insert(document, PLANE, plane), BAT_OK);
    bat_object_release(plane);
    editor = editor_of(document);
    bat_editor_command(editor, "tool-sketch");
    return editor;
}

static const bat_object *object(const bat_editor *editor, int at) {
    return bat_document_at(bat_editor_document(editor), at);
}

static void onto_plane(bat_editor *editor) {
    assert_int_equal(bat_editor_command(editor, "draw-on-plane"), BAT_OK);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "Slope"));
}

/* All of the curve lies on the plane. */
static void expect_on_plane(const bat_curve *curve) {
    assert_int_equal(bat_curve_dimension(curve), 3);
    for (int i = 0; i < (int)bat_curve_count(curve); i++)
        assert_true(fabs(off(bat_curve_points(curve) + 3 * i)) < 1e-9 * bat_curve_size(curve));
}

static void a_pixel_is_a_place(void **state) {
    (void)state;
    bat_stage stage = bat_stage_defaults();
    double frame[9];
    bat_hit hit;
    bat_view_turn(&stage.view, 33);
    stage.view.zoom = 2.5;
    stage.view.x = -12;
    for (int i = 0; i < 50; i++) {
        double pixel[2] = {37.25 * i - 300, 611 - 29.5 * i}, at[2], back[2];
        stage.ground = bat_ground_page();
        bat_stage_seen(&stage, pixel, at);
        assert_int_equal(bat_stage_place(&stage, pixel, NULL, &hit), BAT_OK);
        assert_true(hit.at[0] == at[0] && hit.at[1] == at[1] && hit.at[2] == 0 && hit.pixel == 0.4);
        memcpy(frame, ORIGIN, sizeof ORIGIN);
        memcpy(frame + 3, axes, sizeof axes);
        assert_true(bat_ground_named("plane", 9, frame, &stage.ground));
        assert_int_equal(bat_stage_dimension(&stage), 3);
        assert_int_equal(bat_stage_place(&stage, pixel, NULL, &hit), BAT_OK);
        assert_true(fabs(hit.at[2] - height(at[0], at[1])) < 1e-9 && hit.at[0] == at[0]);
        for (int k = 0; k < 3; k++) /* its own coordinates say the same place */
            assert_true(fabs(ORIGIN[k] + hit.own[0] * axes[k] + hit.own[1] * axes[3 + k] - hit.at[k]) < 1e-9);
        bat_stage_project(&stage, hit.at, back);
        assert_true(hypot(back[0] - pixel[0], back[1] - pixel[1]) < 1e-9);
    }
}

static void edge_on_is_refused(void **state) {
    (void)state;
    bat_stage stage = bat_stage_defaults();
    bat_hit hit = {.pixel = -1};
    for (int degrees = 0; degrees <= 90; degrees++) { /* from lying on the page to standing on it */
        double a = degrees * 3.14159265358979323846 / 180;
        assert_true(
            bat_ground_named("plane", 9, (double[]){0, 0, 0, 1, 0, 0, 0, cos(a), sin(a)}, &stage.ground));
        bat_status status = bat_stage_place(&stage, (double[]){10, 20}, NULL, &hit);
        if (degrees == 85) continue; /* just there */
        assert_int_equal(status, degrees < 85 ? BAT_OK : BAT_SINGULAR);
        if (degrees < 85) assert_true(fabs(hit.at[2] - 20 * tan(a)) < 1e-9);
    }
    bat_ground ground;
    assert_false(bat_ground_named("plane", 9, (double[]){0, 0, 0, 1, 0, 0, 1, 0, 0}, &ground));
    assert_false(bat_ground_named("plane", 9, (double[]){0, 0, NAN, 1, 0, 0, 0, 1, 0}, &ground));
    assert_false(bat_ground_named("plane", 8, (double[]){0, 0, 0, 1, 0, 0, 0, 1}, &ground));
    assert_false(bat_ground_named("sphere", 0, NULL, &ground));
    assert_true(bat_ground_named("page", 0, (double[]){0}, &ground) && !bat_ground_name(5));
}

/* The whole promise: a stroke over the picture of a space curve redraws it where the pen passed, on the plane, and
 * nowhere else. */
static void a_stroke_redraws_a_space_curve(void **state) {
    (void)state;
    bat_editor *editor = in_space();
    pen p = pen_for(editor);
    bat_curve *before = NULL;
    bat_finder *finder = NULL;
    assert_int_equal(bat_curve_copy(bat_object_curve(object(editor, HIGH), 0), &before), BAT_OK);
    onto_plane(editor);
    pen_line(&p, 400, 300, 600, 300, 30);
    assert_null(bat_editor_check(editor));
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 4);
    const bat_curve *after = bat_object_curve(object(editor, HIGH), 0);
    expect_on_plane(after);
    assert_int_equal(bat_finder_create(after, &finder), BAT_OK);
    for (int i = 0; i <= 60; i++) {
        double at[3];
        bat_near near;
        pen_arch(i / 60.0, (double[]){400, 300, 600, 300, 30}, at);
        at[2] = height(at[0], at[1]);
        bat_finder_nearest(finder, at, &near);
        if (i > 6 && i < 54) assert_true(near.distance < 1.25);
        /* Its ends, far from the stroke, are where they were. */
        bat_curve_eval(before, 0.02 * i, 0, at);
        bat_finder_nearest(finder, at, &near);
        assert_true(near.distance < 1e-9);
    }
    bat_finder_free(finder);
    bat_curve_free(before);
    replays(editor, 0);
    uint64_t digest = bat_document_digest(bat_editor_document(editor));
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_true(bat_document_digest(bat_editor_document(editor)) == digest);
    bat_editor_free(editor);
}

static void what_is_new_lies_on_the_plane(void **state) {
    (void)state;
    bat_editor *editor = in_space();
    pen p = pen_for(editor);
    onto_plane(editor);
    pen_line(&p, 500, 302, 520, 470, 20); /* down from the one, short of the other */
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 5);
    const bat_curve *curve = bat_object_curve(object(editor, 4), 0);
    double domain[2], end[3];
    expect_on_plane(curve);
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0], 0, end);
    assert_true(fabs(end[1] - 300) < 1e-6); /* it begins on the line that it was drawn from */
    /* A curve of the page under the pen is redrawn on the page. */
    bat_curve *before = NULL;
    bat_curve_copy(bat_object_curve(object(editor, FLAT), 0), &before);
    pen_line(&p, 300, 100, 600, 104, 10);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 5);
    assert_int_equal(bat_curve_dimension(bat_object_curve(object(editor, FLAT), 0)), 2);
    assert_false(bat_curve_is_equal(before, bat_object_curve(object(editor, FLAT), 0)));
    bat_curve_free(before);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* What is new lies on the page; a curve in space is redrawn where it is, also then. */
static void the_page_is_a_ground(void **state) {
    (void)state;
    bat_editor *editor = in_space();
    pen p = pen_for(editor);
    assert_int_equal(bat_editor_command(editor, "draw-on-page"), BAT_STATE);
    onto_plane(editor);
    assert_int_equal(bat_editor_command(editor, "draw-on-page"), BAT_OK);
    bat_curve *before = NULL;
    bat_curve_copy(bat_object_curve(object(editor, HIGH), 0), &before);
    pen_line(&p, 400, 450, 600, 450, 30);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 5);
    assert_int_equal(bat_curve_dimension(bat_object_curve(object(editor, 4), 0)), 2);
    assert_true(bat_curve_is_equal(before, bat_object_curve(object(editor, HIGH), 0)));
    pen_line(&p, 400, 300, 600, 300, 30);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 5);
    assert_int_equal(bat_curve_dimension(bat_object_curve(object(editor, HIGH), 0)), 3);
    assert_false(bat_curve_is_equal(before, bat_object_curve(object(editor, HIGH), 0)));
    bat_curve_free(before);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* A plane that goes with its group is no ground any more; what is drawn then lies on the page. */
static void a_plane_can_go(void **state) {
    (void)state;
    bat_editor *editor = NULL;
    bat_document *document = NULL;
    bat_object *plane = NULL, *group = NULL, *within = NULL;
    bat_document_create(&document);
    bat_id id = bat_document_new_id(document);
    assert_int_equal(bat_object_create_group(id, "", false, &group), BAT_OK);
    bat_document_insert(document, 0, group);
    bat_object_create_plane(bat_document_new_id(document), "Slope", ORIGIN, axes, &plane);
    assert_int_equal(bat_object_with_parent(plane, id, &within), BAT_OK);
    assert_int_equal(bat_document_insert(document, 1, within), BAT_OK);
    bat_object_release(plane);
    bat_object_release(within);
    bat_object_release(group);
    bat_editor_create(&editor);
    bat_editor_resize(editor, 1000, 800, 1);
    bat_editor_open(editor, document, "test");
    onto_plane(editor);
    pen p = pen_for(editor);
    pen_line(&p, 400, 300, 600, 300, 30);
    expect_on_plane(bat_object_curve(object(editor, 2), 0));
    assert_int_equal(bat_editor_select(editor, id, false), BAT_OK);
    bat_editor_command(editor, "tool-select");
    assert_int_equal(bat_editor_command(editor, "delete"), BAT_OK);
    bat_editor_command(editor, "tool-sketch");
    pen_line(&p, 400, 500, 600, 520, 30);
    assert_int_equal(bat_curve_dimension(bat_object_curve(object(editor, 1), 0)), 2);
    assert_int_equal(bat_editor_command(editor, "draw-on-plane"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    onto_plane(editor);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* Seen edge-on nothing is drawn, and that is said. */
static void edge_on_is_said(void **state) {
    (void)state;
    bat_editor *editor = NULL;
    bat_document *document = NULL;
    bat_object *plane = NULL;
    bat_document_create(&document);
    bat_object_create_plane(bat_document_new_id(document), "", ORIGIN, (double[]){1, 0, 0, 0, 0.01, 1},
                            &plane);
    bat_document_insert(document, 0, plane);
    bat_object_release(plane);
    bat_editor_create(&editor);
    bat_editor_resize(editor, 1000, 800, 1);
    bat_editor_open(editor, document, "test");
    assert_int_equal(bat_editor_command(editor, "draw-on-plane"), BAT_OK);
    pen p = pen_for(editor);
    pen_line(&p, 400, 300, 600, 300, 30);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "edge-on"));
    assert_null(bat_editor_check(editor));
    bat_editor_free(editor);
}

/* Lines of a journal with grounds that are none are refused, and change nothing. */
static void bad_grounds_are_refused(void **state) {
    (void)state;
    static const char *const grounds[] = {"{\"plane\":[0,0,0,1,0,0,1,0,0]}",
                                          "{\"plane\":[0,0,0,1,0,0,0,1]}",
                                          "{\"plane\":7}",
                                          "{\"cave\":[]}",
                                          "[]",
                                          "null"};
    for (size_t i = 0; i < sizeof grounds / sizeof *grounds; i++) {
        bat_editor *editor = NULL;
        bat_problem problem = {0};
        char journal[600];
        int size = snprintf(journal, sizeof journal,
                            "{\"journal\":\"batten\",\"version\":1}\n{\"do\":\"sketch-new\",\"object\":1,"
                            "\"view\":[0,0,1],\"ground\":%s,\"stroke\":{"
                            "\"points\":[[10,10],[20,20],[40,60],[80,90]]}}\n",
                            grounds[i]);
        bat_editor_create(&editor);
        assert_int_equal(bat_editor_replay(editor, journal, (size_t)size, true, &problem), BAT_SYNTAX);
        assert_string_equal(problem.place, "line 2");
        assert_non_null(strstr(problem.message, "ground"));
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 0);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pixel_is_a_place),
        cmocka_unit_test(edge_on_is_refused),
        cmocka_unit_test(a_stroke_redraws_a_space_curve),
        cmocka_unit_test(what_is_new_lies_on_the_plane),
        cmocka_unit_test(the_page_is_a_ground),
        cmocka_unit_test(a_plane_can_go),
        cmocka_unit_test(edge_on_is_said),
        cmocka_unit_test(bad_grounds_are_refused),
    };
    tilt();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
