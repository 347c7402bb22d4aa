/*
 * What lies below what: Alt and a click go through the stack at the place, one after the other, and begin again at the front; with Shift
 * they add; Alt and a drag copy what is selected there though it is covered; the command does the same at the last place.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"

/* Filled squares of side 300, 200 and 100 about 500, 500 (1, 2, 3), the smallest in front. */
static bat_editor *stack(void) {
    bat_curve *curves[3];
    for (int i = 0; i < 3; i++) {
        const double half = 150 - 50 * i, a = 500 - half, b = 500 + half, knots[5] = {0, 1, 2, 3, 4};
        assert_int_equal(
            bat_curve_create(2, 1, true, 4, (double[]){a, a, b, a, b, b, a, b}, 5, knots, &curves[i]),
            BAT_OK);
    }
    bat_editor *editor = editor_with(3, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_set(editor, "filled", 1), BAT_OK);
    bat_editor_command(editor, "deselect");
    return editor;
}

static void chosen(bat_editor *editor, bat_id id) {
    if (selected(editor) != 1 || !has(editor, id)) fail_msg("%d selected, %d not", selected(editor), (int)id);
}

/* Away from the handles and from the lines, at 520, 510; the presses are too far apart in time for a double click. */
static void press(pen *p, double x, double y, uint32_t modifiers) {
    p->time += 1000;
    click(p, x, y, modifiers);
}

static void one_below_the_other(void **state) {
    (void)state;
    bat_editor *editor = stack();
    const uint64_t now = digest(editor);
    pen p = mouse(editor);
    static const bat_id expected[] = {3, 2, 1, 3, 2};
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        press(&p, 520, 510, BAT_ALT);
        chosen(editor, expected[i]);
    }
    press(&p, 520, 510, 0); /* without it the front one */
    chosen(editor, 3);
    press(&p, 570, 570, BAT_ALT); /* two lie there, of which none is selected */
    chosen(editor, 2);
    press(&p, 570, 570, BAT_ALT | BAT_SHIFT);
    assert_true(selected(editor) == 2 && has(editor, 1) && has(editor, 2));
    press(&p, 900, 900, BAT_ALT); /* nothing lies there */
    assert_int_equal(selected(editor), 0);
    assert_true(digest(editor) == now);
    bat_editor_free(editor);
}

static void locked_and_hidden_are_passed_over(void **state) {
    (void)state;
    bat_editor *editor = stack();
    pen p = mouse(editor);
    assert_int_equal(bat_editor_set_state(editor, 2, false, true), BAT_OK);
    press(&p, 520, 510, BAT_ALT);
    press(&p, 520, 510, BAT_ALT);
    chosen(editor, 1);
    assert_int_equal(bat_editor_set_state(editor, 2, true, false), BAT_OK);
    press(&p, 520, 510, BAT_ALT);
    chosen(editor, 3);
    press(&p, 520, 510, BAT_ALT);
    chosen(editor, 1);
    bat_editor_free(editor);
}

/* A group is one of the stack, however much of it lies there; with Ctrl its members are. */
static void groups(void **state) {
    (void)state;
    bat_editor *editor = stack();
    pen p = mouse(editor);
    only(editor, 2, 3);
    assert_int_equal(bat_editor_command(editor, "group"), BAT_OK);
    const bat_id group = bat_object_parent(object(editor, 2));
    bat_editor_command(editor, "deselect");
    static const bat_id expected[] = {0, 1, 0};
    for (size_t i = 0; i < 3; i++) {
        press(&p, 520, 510, BAT_ALT);
        chosen(editor, expected[i] ? expected[i] : group);
    }
    bat_editor_command(editor, "deselect");
    static const bat_id members[] = {3, 2, 1, 3};
    for (size_t i = 0; i < 4; i++) {
        press(&p, 520, 510, BAT_ALT | BAT_CTRL);
        chosen(editor, members[i]);
    }
    bat_editor_free(editor);
}

/* What is selected is copied, though the press is on what covers it. */
static void alt_drags_what_is_below(void **state) {
    (void)state;
    bat_editor *editor = stack();
    bat_editor_set(editor, "snap", 0);
    const uint64_t first = digest(editor);
    pen p = mouse(editor);
    for (int i = 0; i < 3; i++) press(&p, 520, 510, BAT_ALT);
    chosen(editor, 1);
    p.time += 1000;
    drag_holding(&p, 520, 510, 540, 610, BAT_ALT);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 4);
    expect_box(editor, 4, 370, 450, 670, 750);
    expect_box(editor, 1, 350, 350, 650, 650);
    chosen(editor, 4);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

static void by_the_command(void **state) {
    (void)state;
    bat_editor *editor = stack();
    assert_int_equal(bat_editor_command(editor, "select-below"), BAT_STATE);
    assert_string_equal(bat_editor_frame(editor)->notice,
                        bat_string_english(BAT_STRING_NOTICE_NOTHING_BELOW));
    pen p = mouse(editor);
    press(&p, 520, 510, 0);
    static const bat_id expected[] = {2, 1, 3};
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(bat_editor_command(editor, "select-below"), BAT_OK);
        chosen(editor, expected[i]);
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_below_the_other),
        cmocka_unit_test(locked_and_hidden_are_passed_over),
        cmocka_unit_test(groups),
        cmocka_unit_test(alt_drags_what_is_below),
        cmocka_unit_test(by_the_command),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
