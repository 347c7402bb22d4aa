/* The list of steps, the eyedropper, the circle through three points, mirrors about a line, the colours of the drawing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"
#include <batten/measure.h>
#include <batten/paint.h>
#include <batten/panels.h>

#include <math.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

static void set(bat_editor *editor, const char *property, double value) {
    assert_int_equal(bat_editor_set(editor, property, value), BAT_OK);
    assert_null(bat_editor_check(editor));
}

static void steps_have_names(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    const uint64_t first = digest(editor);
    assert_string_equal(bat_editor_history(editor), "{\"done\":0,\"steps\":[]}");
    only(editor, 1, 2);
    bat_editor_command(editor, "group");
    const uint64_t grouped = digest(editor);
    set(editor, "stroke-width", 7);
    bat_editor_command(editor, "ungroup");
    const uint64_t last = digest(editor);
    assert_string_equal(bat_editor_history(editor),
                        "{\"done\":3,\"steps\":[\"Group\",\"Style\",\"Ungroup\"]}");
    assert_int_equal(bat_editor_go(editor, 1), BAT_OK);
    assert_null(bat_editor_check(editor));
    assert_true(digest(editor) == grouped && strstr(bat_editor_history(editor), "{\"done\":1,"));
    assert_int_equal(bat_editor_go(editor, 3), BAT_OK);
    assert_true(digest(editor) == last);
    assert_int_equal(bat_editor_go(editor, 0), BAT_OK);
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_go(editor, 0), BAT_OK);
    assert_int_equal(bat_editor_go(editor, 4), BAT_ARGUMENT);
    assert_int_equal(bat_editor_go(editor, -1), BAT_ARGUMENT);
    assert_true(digest(editor) == first);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void styles_are_taken(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    only(editor, 1, 0);
    set(editor, "stroke-colour", 0x112233FF);
    set(editor, "stroke-width", 9);
    set(editor, "dashes", 1);
    only(editor, 2, 0);
    set(editor, "stroke-width", 3);
    const uint64_t before = digest(editor);
    assert_int_equal(bat_editor_command(editor, "tool-eyedropper"), BAT_OK);
    click(&p, 500, 400, 0); /* nothing is there */
    assert_true(digest(editor) == before);
    click(&p, 500, 200, 0);
    const bat_style *style = bat_object_style(object(editor, 2));
    assert_true(style->stroke == 0x112233FF && style->width == 9);
    assert_int_equal(bat_object_paint(object(editor, 2))->dash_count, 2);
    assert_true(has(editor, 2) && selected(editor) == 1);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == before);
    bat_editor_command(editor, "deselect"); /* then the pen takes it */
    click(&p, 500, 600, 0);
    double width;
    assert_int_equal(bat_editor_get(editor, "stroke-width", &width), BAT_OK);
    assert_true(width == 3 && digest(editor) == before);
    assert_string_equal(bat_editor_frame(editor)->notice, bat_string_english(BAT_STRING_NOTICE_STYLE_TAKEN));
    replays(editor, 0);
    bat_editor_free(editor);
}

static void three_points_make_a_circle(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    const uint64_t before = digest(editor);
    assert_int_equal(bat_editor_command(editor, "tool-circle"), BAT_OK);
    click(&p, 400, 400, 0);
    click(&p, 450, 350, 0);
    click(&p, 350, 450, 0); /* on a line with both */
    assert_string_equal(bat_editor_frame(editor)->notice, bat_string_english(BAT_STRING_NOTICE_CIRCLE_LINE));
    assert_true(digest(editor) == before);
    click(&p, 500, 400, 0);
    expect_box(editor, 3, 400, 350, 500, 450);
    assert_true(fabs(fabs(bat_curve_area(curve(editor, 3))) - 2500 * PI) < 3e-4 * 2500 * PI);
    assert_true(has(editor, 3));
    click(&p, 100, 100, 0);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK); /* begins again */
    click(&p, 400, 400, 0);
    click(&p, 450, 350, 0);
    assert_int_equal(bat_document_count(editor->session.document), 3);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    goes_back_and_replays(editor, before);
    bat_editor_free(editor);
}

static void mirrors_about_a_line(void **state) {
    (void)state;
    const double down[4] = {500, 100, 500, 700}, points[8] = {100, 100, 200, 100, 200, 300, 300, 300};
    bat_curve *curves[2];
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, points, &curves[0]), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, down, &curves[1]), BAT_OK);
    bat_editor *editor = editor_with(2, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    const uint64_t before = digest(editor);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "mirror-line"), BAT_STATE);
    only(editor, 1, 2);
    assert_non_null(strstr(bat_editor_actions(editor), "mirror-line"));
    assert_int_equal(bat_editor_command(editor, "mirror-line"), BAT_OK);
    assert_null(bat_editor_check(editor));
    expect_box(editor, 1, 700, 100, 900, 300);
    expect_box(editor, 2, 500, 100, 500, 700);
    assert_int_equal(selected(editor), 2);
    goes_back_and_replays(editor, before);
    bat_editor_free(editor);
}

static void colours_in_use(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    only(editor, 1, 2);
    set(editor, "stroke-colour", 0x010203FF);
    only(editor, 2, 0);
    set(editor, "fill-colour", 0x04050680);
    assert_string_equal(bat_editor_colours(editor), "16909311 67438208");
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_have_names),
        cmocka_unit_test(styles_are_taken),
        cmocka_unit_test(three_points_make_a_circle),
        cmocka_unit_test(mirrors_about_a_line),
        cmocka_unit_test(colours_in_use),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
