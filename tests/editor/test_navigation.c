/* Panning and zooming by every kind of input; which contacts may draw. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/editing.h"

static void expect_view(bat_editor *editor, double x, double y, double zoom) {
    const bat_frame *frame = bat_editor_frame(editor);
    if (fabs(frame->view[0] - x) > 1e-9 || fabs(frame->view[1] - y) > 1e-9 ||
        fabs(frame->view[2] - zoom) > 1e-9)
        fail_msg("view %g %g %g, expected %g %g %g", frame->view[0], frame->view[1], frame->view[2], x, y,
                 zoom);
    const char *wrong = bat_editor_check(editor);
    if (wrong) fail_msg("%s", wrong);
}

/* A click brings what is under it twice as near, Alt takes it back; a rectangle comes to fill the window, also in a
 * view that is turned; Escape drops it; the document stays. */
static void the_zoom_tool(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t before = digest(editor);
    assert_true(bat_editor_key(editor, "z", true, 0, 0));
    assert_int_equal(bat_editor_frame(editor)->cursor, BAT_CURSOR_ZOOM_IN);
    pen p = pen_for(editor);
    drag(&p, 300, 200, 301, 201);
    expect_view(editor, 301 - 301 / 2.0, 201 - 201 / 2.0, 2);
    p.modifiers = BAT_ALT;
    pen_event(&p, BAT_POINTER_HOVER, 301, 201);
    assert_int_equal(bat_editor_frame(editor)->cursor, BAT_CURSOR_ZOOM_OUT);
    drag(&p, 301, 201, 301, 201);
    expect_view(editor, 0, 0, 1);
    p.modifiers = 0;
    /* 100 x 80 in a window of 1000 x 800, drawn from any corner */
    drag(&p, 300, 280, 200, 200);
    expect_view(editor, 200, 200, 10);
    bat_editor_command(editor, "zoom-100");
    bat_editor_command(editor, "view-left");
    double middle[2] = {400, 300}, under[2], there[2];
    bat_view_to_document(&editor->stage.view, middle, under);
    drag(&p, 350, 260, 450, 340);
    assert_true(fabs(bat_editor_frame(editor)->view[2] - 10) < 1e-9);
    bat_view_to_screen(&editor->stage.view, under, there);
    assert_true(fabs(there[0] - 500) < 1e-6 && fabs(there[1] - 400) < 1e-6);
    /* dropped; and a line without width is no trap */
    pen_event(&p, BAT_POINTER_DOWN, 100, 100);
    pen_event(&p, BAT_POINTER_MOVE, 300, 300);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_MARQUEE));
    double zoom = editor->stage.view.zoom;
    bat_editor_key(editor, "Escape", true, 0, 0);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_MARQUEE));
    pen_event(&p, BAT_POINTER_UP, 300, 300);
    assert_true(editor->stage.view.zoom == zoom);
    drag(&p, 100, 100, 300, 100);
    assert_true(isfinite(editor->stage.view.x) && editor->stage.view.zoom <= BAT_ZOOM_MAX);
    assert_null(bat_editor_check(editor));
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

static void space_drag_pans(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t before = digest(editor);
    pen p = pen_for(editor);
    assert_true(bat_editor_key(editor, " ", true, 0, 0));
    assert_int_equal(bat_editor_frame(editor)->cursor, BAT_CURSOR_GRAB);
    pen_event(&p, BAT_POINTER_DOWN, 500, 200);
    assert_int_equal(bat_editor_frame(editor)->cursor, BAT_CURSOR_GRABBING);
    assert_true(bat_editor_key(editor, " ", false, 0, 0)); /* let go in mid-drag: the drag goes on */
    pen_event(&p, BAT_POINTER_MOVE, 530, 190);
    pen_event(&p, BAT_POINTER_UP, 540, 180);
    expect_view(editor, -40, 20, 1);
    assert_true(digest(editor) == before);
    pen_line(&p, 390, 220, 690, 220, 30); /* and then the pen draws again */
    assert_true(digest(editor) != before);
    bat_editor_free(editor);
}

static void middle_button_and_hand_pan(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t before = digest(editor);
    pen p = pen_for(editor);
    p.device = BAT_DEVICE_MOUSE;
    p.buttons = BAT_BUTTON_MIDDLE;
    drag(&p, 500, 200, 480, 230);
    expect_view(editor, 20, -30, 1);
    p.buttons = BAT_BUTTON_PRIMARY;
    assert_true(bat_editor_key(editor, "h", true, 0, 0));
    drag(&p, 500, 200, 520, 170);
    expect_view(editor, 0, 0, 1);
    assert_true(digest(editor) == before);
    assert_true(bat_editor_key(editor, "n", true, 0, 0));
    pen_line(&p, 350, 200, 650, 200, 30);
    assert_true(digest(editor) != before);
    bat_editor_free(editor);
}

static void wheel_pans_and_zooms(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_wheel(editor, 100, 100, 12, 30, 0, 0);
    expect_view(editor, 12, 30, 1);
    bat_editor_wheel(editor, 100, 100, 0, 8, BAT_SHIFT, 0);
    expect_view(editor, 20, 30, 1);
    bat_editor_wheel(editor, 100, 50, 0, -200 * 0.69314718055994531, BAT_CTRL, 0);
    /* the point (120, 80) stays under (100, 50) */
    const bat_frame *frame = bat_editor_frame(editor);
    assert_true(fabs(frame->view[2] - 2) < 1e-12);
    expect_view(editor, 120 - 50, 80 - 25, frame->view[2]);
    bat_editor_wheel(editor, NAN, 1, 1, 1, 0, 0);
    bat_editor_wheel(editor, 1, 1, INFINITY, 1, BAT_CTRL, 0);
    expect_view(editor, 70, 55, frame->view[2]);
    bat_editor_free(editor);
}

/* Two fingers: what lies under each stays under it, as far as pan and zoom can do that. */
static void pinch_pans_and_zooms(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_key(editor, "h", true, 0, 0);
    pen a = pen_for(editor), b;
    a.device = BAT_DEVICE_TOUCH;
    b = a;
    b.contact = 2;
    pen_event(&a, BAT_POINTER_DOWN, 300, 400);
    pen_event(&b, BAT_POINTER_DOWN, 500, 400);
    pen_event(&a, BAT_POINTER_MOVE, 200, 450);
    pen_event(&b, BAT_POINTER_MOVE, 600, 450);
    const bat_frame *frame = bat_editor_frame(editor);
    double left = (300 - frame->view[0]) * frame->view[2], right = (500 - frame->view[0]) * frame->view[2];
    double y = (400 - frame->view[1]) * frame->view[2];
    /* the first move tilts the fingers, which without rotation zooms by the distance: 100 more, then level
     * again */
    assert_true(fabs(left - 200) < 1e-9 && fabs(right - 600) < 1e-9 && fabs(y - 450) < 1e-9);
    assert_true(fabs(frame->view[2] - 2) < 1e-12);
    pen_event(&a, BAT_POINTER_UP, 200, 450);
    double x = bat_editor_frame(editor)->view[0];
    pen_event(&b, BAT_POINTER_MOVE, 610, 450); /* the one left pans on */
    assert_true(fabs(bat_editor_frame(editor)->view[0] - (x - 5)) < 1e-9);
    pen_event(&b, BAT_POINTER_UP, 610, 450);
    pen_event(&b, BAT_POINTER_MOVE, 700, 450);
    assert_true(fabs(bat_editor_frame(editor)->view[0] - (x - 5)) < 1e-9);
    bat_editor_free(editor);
}

static void a_stroke_becomes_a_pinch_only_at_once(void **state) {
    (void)state;
    for (int late = 0; late < 2; late++) {
        bat_editor *editor = pen_editor();
        uint64_t before = digest(editor);
        pen a = pen_for(editor), b;
        a.device = BAT_DEVICE_TOUCH;
        pen_event(&a, BAT_POINTER_DOWN, 400, 200);
        pen_event(&a, BAT_POINTER_MOVE, 405, 200);
        assert_true(bat_editor_frame(editor)->busy);
        if (late) a.time += 400;
        b = a;
        b.contact = 2;
        pen_event(&b, BAT_POINTER_DOWN, 600, 300);
        assert_int_equal(bat_editor_frame(editor)->busy, late);
        pen_event(&b, BAT_POINTER_MOVE, 700, 350);
        pen_event(&b, BAT_POINTER_UP, 700, 350);
        bool moved = bat_editor_frame(editor)->view[2] != 1;
        assert_int_equal(moved, !late);
        for (int i = 0; i < 30 && late; i++)
            pen_event(&a, BAT_POINTER_MOVE, 405 + 5 * i, 200 - 20 * sin(i / 9.0));
        pen_event(&a, BAT_POINTER_UP, 555, 198);
        assert_int_equal(digest(editor) != before, late);
        assert_null(bat_editor_check(editor));
        bat_editor_free(editor);
    }
}

static void after_the_pen_touch_only_navigates(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen finger = pen_for(editor), p = pen_for(editor);
    finger.device = BAT_DEVICE_TOUCH;
    finger.contact = 7;
    uint64_t before = digest(editor);
    pen_line(&finger, 350, 200, 650, 200, 30);
    assert_true(digest(editor) != before); /* no pen so far: fingers draw */
    before = digest(editor);
    pen_event(&p, BAT_POINTER_HOVER, 10, 10);
    drag(&finger, 350, 200, 450, 210);
    expect_view(editor, -100, -10, 1);
    assert_true(digest(editor) == before);
    assert_int_equal(bat_editor_set(editor, "palm-rejection", 0), BAT_OK);
    pen_line(&finger, 450, 410, 750, 410, 30);
    assert_true(digest(editor) != before);
    bat_editor_free(editor);
}

static void fit_waits_for_a_size(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    bat_document_create(&document);
    pen_add(document, pen_curve(1000, 1000, 100, 0, 11));
    bat_editor_create(&editor);
    assert_int_equal(bat_editor_open(editor, document, "late"), BAT_OK);
    bat_editor_frame(editor);
    bat_editor_resize(editor, 0, 0, 1);
    bat_editor_resize(editor, 1064, 500, 2);
    expect_view(editor, 1000 - 32, 1000 - 250, 1);
    bat_editor_resize(editor, 864, 400, 2); /* the middle stays */
    expect_view(editor, 968 + 100, 750 + 50, 1);
    bat_editor_resize(editor, NAN, -5, INFINITY);
    assert_null(bat_editor_check(editor));
    bat_editor_free(editor);
}

static void keys_come_from_the_table(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_line(&p, 350, 200, 650, 200, 30);
    assert_false(bat_editor_key(editor, "j", true, 0, 0));
    assert_false(bat_editor_key(editor, "j", true, 0, 0));
    bat_editor_command(editor, "tool-pan");
    assert_false(bat_editor_key(editor, "Enter", true, 0, 0)); /* nothing to say yes to: the host's */
    bat_editor_command(editor, "tool-sketch");
    assert_true(bat_editor_key(editor, "z", true, BAT_META, 0));
    assert_true(bat_editor_frame(editor)->can_redo);
    assert_true(bat_editor_key(editor, "Z", true, BAT_CTRL | BAT_SHIFT, 0));
    assert_true(bat_editor_frame(editor)->can_undo);
    assert_true(bat_editor_key(editor, "s", true, BAT_CTRL, 0));
    assert_int_equal(bat_editor_frame(editor)->requests, BAT_ASK_SAVE);

    assert_int_equal(bat_editor_bind(editor, "undo", "J Alt+Backspace"), BAT_OK);
    assert_false(bat_editor_key(editor, "z", true, BAT_CTRL, 0));
    assert_true(bat_editor_key(editor, "j", true, 0, 0));
    assert_true(bat_editor_frame(editor)->can_redo);
    assert_non_null(strstr(bat_editor_tables(editor), "\"keys\":[\"J\",\"Alt+Backspace\"]"));
    assert_int_equal(bat_editor_bind(editor, "undo", NULL), BAT_OK);
    assert_non_null(strstr(bat_editor_tables(editor), "\"keys\":[\"Ctrl+Z\"]"));
    assert_int_equal(bat_editor_bind(editor, "undone", "J"), BAT_UNSUPPORTED);
    assert_int_equal(bat_editor_bind(editor, "undo", "\"quoted\""), BAT_ARGUMENT);
    assert_true(bat_editor_key(editor, "+", true, BAT_SHIFT | BAT_CTRL, 0)); /* "Ctrl++" */
    assert_true(bat_editor_frame(editor)->view[2] > 1);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_zoom_tool),
        cmocka_unit_test(space_drag_pans),
        cmocka_unit_test(middle_button_and_hand_pan),
        cmocka_unit_test(wheel_pans_and_zooms),
        cmocka_unit_test(pinch_pans_and_zooms),
        cmocka_unit_test(a_stroke_becomes_a_pinch_only_at_once),
        cmocka_unit_test(after_the_pen_touch_only_navigates),
        cmocka_unit_test(fit_waits_for_a_size),
        cmocka_unit_test(keys_come_from_the_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
