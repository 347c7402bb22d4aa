/* The rotated view: closed forms of its arithmetic, the detent of a pinch, and tools that work in it as in the upright
 * view. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/pen.h"

static const double PI = 3.14159265358979323846;

static bat_view turned(double degrees) {
    bat_view view = bat_view_defaults();
    view.x = 17;
    view.y = -3;
    view.zoom = 2.5;
    view.width = 1000;
    view.height = 600;
    bat_view_turn(&view, degrees);
    return view;
}

static bool near(const double a[2], double x, double y, double within) {
    return fabs(a[0] - x) <= within && fabs(a[1] - y) <= within;
}

static void angles_have_a_range_and_steps(void **state) {
    (void)state;
    static const double cases[][2] = {{0, 0},      {-0.0, 0},       {180, 180},     {-180, 180},
                                      {181, -179}, {720, 0},        {-90.004, -90}, {12.345678, 12.35},
                                      {1e-9, 0},   {-179.999, 180}, {359.999, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_view view = turned(cases[i][0]);
        assert_true(view.angle == cases[i][1] && (view.angle != 0 || !signbit(view.angle)));
        assert_true(fabs(view.cosine - cos(view.angle * PI / 180)) < 1e-15);
        assert_true(fabs(view.sine - sin(view.angle * PI / 180)) < 1e-15);
    }
    bat_view view = turned(30);
    bat_view_turn(&view, NAN);
    bat_view_turn(&view, INFINITY);
    assert_true(view.angle == 30);
}

static void a_quarter_turns_clockwise(void **state) {
    (void)state;
    bat_view view = turned(90);
    double screen[2];
    bat_view_to_screen(&view, (double[]){17 + 10, -3}, screen); /* what lay to the right lies below */
    assert_true(near(screen, 0, 25, 1e-12));
}

static void there_and_back_and_the_point_stays(void **state) {
    (void)state;
    for (int i = -17; i <= 18; i++) {
        bat_view view = turned(10 * i);
        double about[2] = {321, 123}, document[2], screen[2];
        bat_view_to_document(&view, about, document);
        bat_view_to_screen(&view, document, screen);
        assert_true(near(screen, 321, 123, 1e-9));
        bat_view_rotate(&view, about, 77.77);
        bat_view_zoom(&view, about, 1.7);
        bat_view_to_screen(&view, document, screen);
        assert_true(near(screen, 321, 123, 1e-9));
        bat_view_pan(&view, about, (double[]){300, 140});
        bat_view_to_screen(&view, document, screen);
        assert_true(near(screen, 300, 140, 1e-9));
    }
}

/* The view as a viewpoint in space shows every point of the page, and whatever lies before or behind it, at the pixel
 * of the page's view; its rays run down onto the page. */
static void a_viewpoint_sees_the_same_pixels(void **state) {
    (void)state;
    for (int i = -17; i <= 18; i++) {
        bat_stage stage = bat_stage_defaults();
        bat_viewpoint seen;
        stage.view = turned(10.01 * i);
        assert_int_equal(bat_stage_viewpoint(&stage, &seen), BAT_OK);
        assert_int_equal(bat_viewpoint_check(&seen, NULL), BAT_OK);
        for (int k = -3; k <= 3; k++) {
            const double at[3] = {100.3 * k, 77.7 + 31 * k * k, 500.5 * k};
            double flat[2], pixel[2], from[3], along[3], depth;
            bat_stage_project(&stage, at, flat);
            assert_int_equal(bat_viewpoint_project(&seen, at, pixel, &depth), BAT_OK);
            assert_true(near(pixel, flat[0], flat[1], 1e-9) && depth > 0);
            assert_int_equal(bat_viewpoint_ray(&seen, flat, from, along), BAT_OK);
            assert_true(near(from, at[0], at[1], 1e-9) && from[2] < at[2]);
            assert_true(along[0] == 0 && along[1] == 0 && along[2] == 1);
            bat_ray ray = bat_view_ray(&stage.view, flat); /* looks the same way */
            for (int d = 0; d < 3; d++) assert_true(ray.along[d] == along[d]);
        }
    }
    bat_stage stage = bat_stage_defaults();
    bat_viewpoint seen;
    assert_int_equal(bat_stage_viewpoint(&stage, &seen), BAT_STATE);
}

/* All corners are in the room, and the tightest of them touches it. */
static void fit_shows_all_of_a_turned_box(void **state) {
    (void)state;
    const double box[4] = {100, 200, 900, 500};
    for (int i = 0; i < 36; i++) {
        bat_view view = turned(10 * i);
        double slack = INFINITY, screen[2];
        assert_true(bat_view_fit(&view, box, 32));
        assert_true(fabs(remainder(view.angle - 10 * i, 360)) < 1e-9);
        for (int k = 0; k < 4; k++) {
            bat_view_to_screen(&view, (double[]){box[k & 2], box[1 + 2 * (k & 1)]}, screen);
            slack = fmin(slack, fmin(fmin(screen[0], 1000 - screen[0]), fmin(screen[1], 600 - screen[1])));
        }
        assert_true(fabs(slack - 32) < 1e-9);
    }
}

static double angle_of(bat_editor *editor) { return bat_editor_frame(editor)->view[3]; }

/* Two fingers 200 px apart, turned about their middle to so many degrees; they stay down. */
static void pinch_to(pen fingers[2], double degrees) {
    double x = 100 * cos(degrees * PI / 180), y = 100 * sin(degrees * PI / 180);
    pen_event(&fingers[0], BAT_POINTER_MOVE, 500 - x, 400 - y);
    pen_event(&fingers[1], BAT_POINTER_MOVE, 500 + x, 400 + y);
}

static void begin_pinch(bat_editor *editor, pen fingers[2]) {
    for (int i = 0; i < 2; i++) {
        fingers[i] = pen_for(editor);
        fingers[i].device = BAT_DEVICE_TOUCH;
        fingers[i].contact = (uint32_t)i + 1;
        pen_event(&fingers[i], BAT_POINTER_DOWN, i ? 600 : 400, 400);
    }
}

static void end_pinch(pen fingers[2]) {
    pen_event(&fingers[0], BAT_POINTER_UP, NAN, NAN); /* where they are */
    pen_event(&fingers[1], BAT_POINTER_UP, NAN, NAN);
}

static void upright_is_a_detent(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen fingers[2];
    begin_pinch(editor, fingers);
    for (int degrees = 1; degrees <= 5; degrees++) {
        pinch_to(fingers, degrees);
        assert_true(angle_of(editor) == 0);
    }
    double before = 0;
    for (int degrees = 6; degrees <= 400;
         degrees++) { /* free, without a leap, once round and into the detent again */
        pinch_to(fingers, degrees);
        double now = angle_of(editor), moved = fabs(remainder(now - before, 360));
        assert_true(moved <= 1.02);
        if (degrees == 46) assert_true(fabs(now - 40) < 0.02);
        if (degrees > 367 && degrees < 377) assert_true(now == 0);
        before = now;
        assert_null(bat_editor_check(editor));
    }
    for (int degrees = 400; degrees >= 30; degrees--) pinch_to(fingers, degrees);
    double kept = angle_of(editor);
    assert_true(fabs(kept - 24) < 0.05);
    end_pinch(fingers);
    bat_editor_command(editor, "zoom-in"); /* not a pinch: the angle stays */
    assert_true(angle_of(editor) == kept);
    begin_pinch(editor, fingers); /* the next one goes on from there, and finds upright */
    pinch_to(fingers, 10);
    assert_true(fabs(angle_of(editor) - kept - 10) < 0.02);
    pinch_to(fingers, -28);
    assert_true(angle_of(editor) == 0);
    pinch_to(fingers, -60);
    assert_true(angle_of(editor) < -20);
    end_pinch(fingers);
    assert_int_equal(bat_editor_command(editor, "view-upright"), BAT_OK);
    assert_true(angle_of(editor) == 0);
    assert_int_equal(bat_editor_command(editor, "view-upright"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "view-left"), BAT_OK);
    assert_true(angle_of(editor) == -15);
    assert_true(bat_editor_key(editor, "6", true, 0, 0) && bat_editor_key(editor, "6", true, 0, 0));
    assert_true(angle_of(editor) == 15);
    bat_editor_free(editor);
}

/* pen_editor with its page turned about the window's middle. */
static bat_editor *turned_editor(double degrees) {
    bat_editor *editor = pen_editor();
    bat_view_rotate(&editor->stage.view, (double[]){500, 400}, degrees);
    bat_editor_frame(editor);
    return editor;
}

static void screen_of(const bat_editor *editor, double x, double y, double out[2]) {
    bat_view_to_screen(&editor->stage.view, (double[]){x, y}, out);
}

static const bat_curve *line(const bat_editor *editor, int index) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), index), 0);
}

/* An arch over the first line, drawn where the line is seen: as far from it in the document as drawn upright. */
static void strokes_lie_where_the_pen_was(void **state) {
    (void)state;
    for (int degrees = -165; degrees <= 180; degrees += 69) {
        bat_editor *editor = turned_editor(degrees);
        double from[2], to[2], highest = INFINITY;
        screen_of(editor, 350, 200, from);
        screen_of(editor, 650, 200, to);
        pen p = pen_for(editor);
        pen_line(&p, from[0], from[1], to[0], to[1], 30);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 2); /* it was found and redrawn */
        const bat_curve *curve = line(editor, 0);
        double domain[2], point[2];
        bat_curve_domain(curve, domain);
        for (int i = 0; i <= 400; i++) {
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / 400, 0, point);
            highest = fmin(highest, point[1]);
        }
        assert_true(fabs(highest - 170) < 1.5);
        size_t size = 0;
        const char *journal = bat_editor_journal(editor, &size);
        bat_editor *other = NULL;
        bat_problem problem;
        assert_int_equal(bat_editor_create(&other), BAT_OK);
        assert_int_equal(bat_editor_replay(other, journal, size, true, &problem), BAT_OK);
        assert_true(bat_document_digest(bat_editor_document(other)) ==
                    bat_document_digest(bat_editor_document(editor)));
        assert_null(bat_editor_check(editor));
        bat_editor_free(other);
        bat_editor_free(editor);
    }
}

static void journals_refuse_odd_angles(void **state) {
    (void)state;
    static const char *const views[] = {"[0,0,1,181]", "[0,0,1,-200]", "[0,0,1,0,0]", "[0,0,1,\"a\"]",
                                        "[0,0]"};
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        char text[400];
        snprintf(text, sizeof text,
                 "{\"do\":\"sketch-new\",\"object\":1,\"tolerance\":1,\"view\":%s,"
                 "\"stroke\":{\"points\":[[0,0],[50,0],[100,9]]}}\n",
                 views[i]);
        bat_editor *editor = NULL;
        bat_problem problem;
        assert_int_equal(bat_editor_create(&editor), BAT_OK);
        assert_int_equal(bat_editor_replay(editor, text, strlen(text), true, &problem), BAT_SYNTAX);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 0);
        bat_editor_free(editor);
    }
}

/* The marquee is a box of the window: at 45 degrees one tight around a line as it is seen takes that line alone,
 * though its box in the document meets both. */
static void a_marquee_is_upright_in_the_window(void **state) {
    (void)state;
    bat_editor *editor = turned_editor(45);
    bat_editor_command(editor, "tool-select");
    double a[2], b[2];
    screen_of(editor, 200, 200, a);
    screen_of(editor, 800, 200, b);
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_DOWN, fmin(a[0], b[0]) - 12, fmin(a[1], b[1]) - 12);
    pen_event(&p, BAT_POINTER_MOVE, fmax(a[0], b[0]) + 12, fmax(a[1], b[1]) + 12);
    const bat_item *box = pen_live(bat_editor_frame(editor), BAT_ROLE_MARQUEE);
    assert_non_null(box);
    const bat_frame *frame = bat_editor_frame(editor);
    double corner[2];
    screen_of(editor, box->path[1] + frame->origin[0], box->path[2] + frame->origin[1], corner);
    assert_true(near(corner, fmin(a[0], b[0]) - 12, fmin(a[1], b[1]) - 12, 0.01));
    pen_event(&p, BAT_POINTER_UP, fmax(a[0], b[0]) + 12, fmax(a[1], b[1]) + 12);
    assert_int_equal(editor->choice.selection.count, 1);
    assert_true(bat_selection_has(&editor->choice.selection, 1));
    bat_editor_free(editor);
}

/* The handle above the box lies above it in the page's sense; arrows move along the page's axes. */
static void handles_and_nudges_follow_the_page(void **state) {
    (void)state;
    bat_editor *editor = turned_editor(90);
    bat_editor_command(editor, "tool-select");
    pen p = pen_for(editor);
    double at[2], box[4];
    screen_of(editor, 500, 200, at);
    pen_event(&p, BAT_POINTER_DOWN, at[0], at[1]);
    pen_event(&p, BAT_POINTER_UP, at[0], at[1]);
    assert_int_equal(editor->choice.selection.count, 1);
    pen_event(&p, BAT_POINTER_HOVER, at[0] + 26, at[1]); /* above on the page is to the right */
    assert_int_equal(bat_editor_frame(editor)->cursor, BAT_CURSOR_GRAB);
    bat_editor_command(editor, "select-all");
    screen_of(editor, 800, 400, at);
    pen_event(&p, BAT_POINTER_HOVER, at[0], at[1]); /* a side's handle now moves up and down */
    assert_int_equal(bat_editor_frame(editor)->cursor, BAT_CURSOR_RESIZE_NS);
    bat_editor_select(editor, 1, false);
    assert_true(bat_editor_key(editor, "ArrowRight", true, 0, 0));
    bat_object_bounds(bat_document_at(bat_editor_document(editor), 0), box);
    assert_true(fabs(box[0] - 201) < 1e-9 && fabs(box[1] - 200) < 1e-9);
    /* turned by its handle through a quarter as seen, it has turned through a quarter */
    screen_of(editor, 501, 200, at);
    pen_event(&p, BAT_POINTER_DOWN, at[0] + 26, at[1]);
    pen_event(&p, BAT_POINTER_MOVE, at[0] + 20, at[1] + 20);
    pen_event(&p, BAT_POINTER_UP, at[0], at[1] + 26);
    bat_object_bounds(bat_document_at(bat_editor_document(editor), 0), box);
    assert_true(fabs(box[2] - box[0]) < 1e-6 && fabs(box[3] - box[1] - 600) < 1e-6);
    assert_null(bat_editor_check(editor));
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angles_have_a_range_and_steps),
        cmocka_unit_test(a_quarter_turns_clockwise),
        cmocka_unit_test(there_and_back_and_the_point_stays),
        cmocka_unit_test(a_viewpoint_sees_the_same_pixels),
        cmocka_unit_test(fit_shows_all_of_a_turned_box),
        cmocka_unit_test(upright_is_a_detent),
        cmocka_unit_test(strokes_lie_where_the_pen_was),
        cmocka_unit_test(journals_refuse_odd_angles),
        cmocka_unit_test(a_marquee_is_upright_in_the_window),
        cmocka_unit_test(handles_and_nudges_follow_the_page),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
