/* First-use hints: each disappears when it was followed, in whatever order, and does not come back. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/pen.h"
#include <batten/base.h>
#include <batten/editor.h>

enum { DRAW = 1, UNDO = 2, POINTS = 4 };

static uint32_t shown(bat_editor *editor) {
    assert_null(bat_editor_check(editor));
    return bat_editor_frame(editor)->first;
}

static double kept(const bat_editor *editor) {
    double value = -1;
    assert_int_equal(bat_editor_get(editor, "first-hints", &value), BAT_OK);
    return value;
}

static void redraw(bat_editor *editor) {
    pen p = pen_for(editor);
    pen_line(&p, 350, 200, 650, 200, 30);
}

static void one_after_the_other(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    assert_int_equal(shown(editor), DRAW | UNDO | POINTS);
    pen p = pen_for(editor);
    pen_line(&p, 350, 400, 650, 400, 30); /* a new curve is not drawn over a line */
    assert_int_equal(shown(editor), DRAW | UNDO | POINTS);
    redraw(editor);
    assert_int_equal(shown(editor), UNDO | POINTS);
    assert_true(kept(editor) == 1);
    bat_editor_command(editor, "undo");
    assert_int_equal(shown(editor), POINTS);
    bat_editor_key(editor, "a", true, 0, 0);
    assert_int_equal(shown(editor), 0);
    assert_true(kept(editor) == 3);
    bat_editor_free(editor);
}

static void in_another_order(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_STATE); /* nothing to undo: not followed */
    bat_editor_command(editor, "tool-points");
    assert_int_equal(shown(editor), DRAW | UNDO);
    assert_true(kept(editor) == 0);
    bat_editor_command(editor, "tool-sketch");
    redraw(editor);
    assert_int_equal(shown(editor), UNDO);
    bat_editor_command(editor, "undo");
    assert_int_equal(shown(editor), 0);
    assert_true(kept(editor) == 3);
    bat_editor_free(editor);
}

/* The host keeps one number: set again, the rest are shown; the last value shows none; the first brings all back. */
static void the_host_keeps_how_far(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    static const uint32_t expected[] = {DRAW | UNDO | POINTS, UNDO | POINTS, POINTS, 0};
    bat_editor_command(editor, "tool-points");
    for (int i = 3; i >= 0; i--) {
        assert_int_equal(bat_editor_set(editor, "first-hints", i), BAT_OK);
        assert_int_equal(shown(editor), expected[i]);
    }
    assert_int_equal(bat_editor_set(editor, "first-hints", 4), BAT_ARGUMENT);
    bat_editor_free(editor);
}

static void an_empty_drawing_has_none(void **state) {
    (void)state;
    bat_editor *editor = NULL;
    assert_int_equal(bat_editor_create(&editor), BAT_OK);
    bat_editor_resize(editor, 1000, 800, 1);
    assert_int_equal(shown(editor), 0);
    pen p = pen_for(editor);
    pen_line(&p, 350, 400, 650, 400, 30);
    assert_int_equal(shown(editor), DRAW | UNDO | POINTS);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_after_the_other),
        cmocka_unit_test(in_another_order),
        cmocka_unit_test(the_host_keeps_how_far),
        cmocka_unit_test(an_empty_drawing_has_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
