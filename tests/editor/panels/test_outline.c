/* The outline for screen readers agrees with the document; each event is announced once. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/pen.h"

static void key(bat_editor *editor, const char *name, uint32_t modifiers) {
    bat_editor_key(editor, name, true, modifiers, 0);
    bat_editor_key(editor, name, false, modifiers, 0);
    bat_editor_frame(editor);
    const char *wrong = bat_editor_check(editor);
    if (wrong) fail_msg("%s", wrong);
}

static int occurrences(const char *text, const char *part) {
    int count = 0;
    for (; (text = strstr(text, part)); text += strlen(part)) count++;
    return count;
}

static void has(const char *text, const char *part) {
    if (!text || !strstr(text, part)) fail_msg("%s lacks %s", text ? text : "(nothing)", part);
}

static void the_outline_is_the_document(void **state) {
    (void)state;
    bat_editor *editor = pen_editor(); /* two open lines of eleven points */
    const char *text = bat_editor_outline(editor, 0, 100);
    has(text, "{\"total\":2,\"at\":-1,");
    assert_int_equal(
        occurrences(
            text, "\"level\":1,\"points\":11,\"selected\":false,\"words\":\"line, curve, open, 11 points\""),
        2);
    bat_editor_select(editor, 2, false);
    text = bat_editor_outline(editor, 0, 100);
    has(text, "\"at\":1,");
    assert_int_equal(occurrences(text, "\"selected\":true"), 1);
    key(editor, "a", BAT_CTRL);
    key(editor, "g", BAT_CTRL);
    bat_editor_set_state(editor, 1, true, false);
    text = bat_editor_outline(editor, 0, 100);
    has(text, "{\"total\":3,");
    has(text, "\"level\":1,\"points\":0,\"selected\":true,\"words\":\"group 3\"");
    assert_int_equal(occurrences(text, "\"level\":2"), 2);
    assert_int_equal(occurrences(text, "hidden"), 1);
    text = bat_editor_outline(editor, 1, 1); /* a window of it */
    assert_int_equal(occurrences(text, "\"id\""), 1);
    has(text, "{\"id\":1,");
    assert_int_equal(occurrences(bat_editor_outline(editor, 7, 3), "\"id\""), 0);
    assert_int_equal(occurrences(bat_editor_outline(editor, -5, -3), "\"id\""), 0);
    assert_int_equal(occurrences(bat_editor_outline(editor, -2147483647, 2147483647), "\"id\""), 3);
    bat_editor_command(editor, "guide-level");
    has(bat_editor_outline(editor, 0, 9), "guide 4");
    bat_editor_free(editor);
}

/* Tab and Shift+Tab in the tools that move points find no curve that is locked, hidden or not isolated, and let go of
 * one that becomes so. */
static void keys_reach_no_locked_curve(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-points", "tool-levels"};
    for (int which = 0; which < 2; which++)
        for (int hidden = 0; hidden < 2; hidden++)
            for (int back = 0; back < 2; back++) {
                const char *next = back ? "point-previous" : "point-next";
                bat_editor *editor = pen_editor();
                bat_editor_set_state(editor, 1, hidden, !hidden);
                bat_editor_set_state(editor, 2, !hidden, hidden);
                bat_editor_command(editor, tools[which]);
                assert_int_equal(bat_editor_command(editor, next), BAT_STATE);
                assert_null(bat_editor_check(editor));
                bat_editor_set_state(editor, 2, false, false);
                if (which == 0) assert_int_equal(bat_editor_command(editor, next), BAT_OK);
                if (which == 1) bat_editor_command(editor, next);
                assert_true(editor->choice.selection.count == 1 && editor->choice.selection.ids[0] == 2);
                bat_editor_set_state(editor, 2, hidden, !hidden);
                bat_editor_frame(editor);
                uint64_t before = bat_document_digest(editor->session.document);
                assert_int_equal(bat_editor_command(editor, next), BAT_STATE);
                bat_editor_command(editor, "nudge-up");
                assert_true(bat_document_digest(editor->session.document) == before);
                assert_null(bat_editor_check(editor));
                bat_editor_free(editor);
            }
}

static void points_are_chosen_from_the_outline_and_told_to_it(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    const char *text = bat_editor_outline_points(editor, 1);
    has(text, "{\"at\":-1,\"points\":[\"Point 1 of 11: 200, 200\",\"Point 2 of 11: 260, 200\",");
    assert_int_equal(occurrences(text, "Point "), 11);
    assert_int_equal(bat_editor_choose(editor, 1, 2), BAT_OK);
    assert_string_equal(bat_editor_said(editor), ""); /* what was before is not news */
    has(bat_editor_outline_points(editor, 1), "{\"at\":2,");
    key(editor, "ArrowDown", BAT_SHIFT); /* that point moves by ten units */
    has(bat_editor_outline_points(editor, 1), "\"Point 3 of 11: 320, 210\"");
    assert_string_equal(bat_editor_said(editor), "Move a control point. Point 3 of 11: 320, 210");
    key(editor, "Tab", 0);
    has(bat_editor_outline_points(editor, 1), "{\"at\":3,");
    assert_string_equal(bat_editor_said(editor), "Point 4 of 11: 380, 200");
    assert_int_equal(bat_editor_choose(editor, 1, 11), BAT_ARGUMENT);
    assert_int_equal(bat_editor_choose(editor, 1, -1), BAT_ARGUMENT);
    assert_int_equal(bat_editor_choose(editor, 9, 0), BAT_ARGUMENT);
    bat_editor_set_state(editor, 2, false, true);
    assert_int_equal(bat_editor_choose(editor, 2, 0), BAT_STATE);
    has(bat_editor_outline_points(editor, 99), "{\"at\":-1,\"points\":[]}");
    bat_editor_free(editor);
}

static void a_splines_points_are_its_own(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_editor_command(editor, "tool-tangents");
    key(editor, "Enter", 0);
    key(editor, "Enter", 0);
    key(editor, "ArrowRight", BAT_CTRL);
    key(editor, "Enter", 0);
    key(editor, "Enter", 0);
    bat_editor_command(editor, "tool-select");
    has(bat_editor_outline(editor, 2, 1), "spline 3, open, 2 points");
    has(bat_editor_outline_points(editor, 3), "\"Point 1 of 2: 500, 400\",\"Point 2 of 2: 600, 400\"");
    assert_int_equal(bat_editor_choose(editor, 3, 1), BAT_OK);
    key(editor, "ArrowUp", 0);
    has(bat_editor_outline_points(editor, 3),
        "{\"at\":1,\"points\":[\"Point 1 of 2: 500, 400\",\"Point 2 of 2: 600, 399\"");
    bat_editor_free(editor);
}

static void what_happens_is_said_once(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    assert_string_equal(bat_editor_said(editor), "");
    pen_begin(&p, pen_arch, (double[]){300, 400, 600, 380, 30}, 40);
    assert_string_equal(bat_editor_said(editor), ""); /* not while the pen is down */
    pen_event(&p, BAT_POINTER_UP, 600, 380);
    assert_string_equal(bat_editor_said(editor), "New curve");
    assert_string_equal(bat_editor_said(editor), "");
    key(editor, "v", 0);
    assert_string_equal(bat_editor_said(editor), "Select");
    key(editor, "Tab", 0);
    assert_string_equal(bat_editor_said(editor), "Selected: line, curve, open, 11 points");
    key(editor, "ArrowLeft", 0);
    assert_string_equal(bat_editor_said(editor), "Move");
    key(editor, "z", BAT_CTRL); /* a notice tells */
    assert_string_equal(bat_editor_said(editor), "");
    assert_string_equal(bat_editor_frame(editor)->notice, "Undone: Move");
    key(editor, "y", BAT_CTRL);
    assert_string_equal(bat_editor_said(editor), "");
    assert_string_equal(bat_editor_frame(editor)->notice, "Redone: Move");
    key(editor, "a", BAT_CTRL);
    assert_string_equal(bat_editor_said(editor), "3 objects selected");
    key(editor, "Escape", 0);
    assert_string_equal(bat_editor_said(editor), "Nothing selected");
    bat_editor_select(editor, 2, false);
    bat_editor_said(editor);
    key(editor, "T", BAT_SHIFT);
    assert_string_equal(bat_editor_said(editor),
                        "line, curve, open, 11 points. Start of the range: 400, 600");
    key(editor, "ArrowRight", BAT_SHIFT);
    assert_string_equal(bat_editor_said(editor), "Start of the range: 440, 600");
    key(editor, "ArrowUp", 0);
    assert_string_equal(bat_editor_said(editor), "End of the range: 600, 600");
    key(editor, "n", 0);
    bat_editor_said(editor);
    key(editor, "Enter", 0);
    assert_string_equal(bat_editor_said(editor), "Point 3 of 5: 520, 600");
    key(editor, "ArrowUp", BAT_CTRL);
    assert_string_equal(bat_editor_said(editor), "Point 3 of 5: 520, 500");
    bat_editor_free(editor);
}

/* A name as long as it likes: what is said is cut between letters and stays UTF-8. */
static void long_names_are_cut(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    char name[1001];
    for (int i = 0; i < 500; i++) memcpy(name + 2 * i, "\xc3\xa9", 2);
    name[1000] = 0;
    bat_editor_said(editor);
    assert_int_equal(bat_editor_rename(editor, 1, name), BAT_OK);
    bat_editor_said(editor);
    bat_editor_select(editor, 1, false);
    const char *said = bat_editor_said(editor);
    size_t size = strlen(said), lead = strlen("Selected: ");
    assert_true(size > 200 && size < 260);
    assert_int_equal((size - lead) % 2, 0);
    assert_memory_equal(said + size - 2, "\xc3\xa9", 2);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_outline_is_the_document),
        cmocka_unit_test(keys_reach_no_locked_curve),
        cmocka_unit_test(points_are_chosen_from_the_outline_and_told_to_it),
        cmocka_unit_test(a_splines_points_are_its_own),
        cmocka_unit_test(what_happens_is_said_once),
        cmocka_unit_test(long_names_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
