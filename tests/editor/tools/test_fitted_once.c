/* Work is done once at pen-up: what a stroke makes is fitted, and that is what is committed, whatever the stroke was taken
 * to mean. Counted in systems of equations that are solved. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/edit/stroke.h"
#include "editor/edit/stroke_record.h"
#include "support/editing.h"
#include "support/solve_fail.h"
#include "text/json.h"

/* The last line of the journal as an edit. */
static bat_edit last_edit(const bat_editor *editor) {
    const char *journal = bat_editor_journal(editor, NULL), *last = NULL;
    for (const char *at = journal; (at = strstr(at, "\n{\"do\":\"sketch")) != NULL; at++) last = at + 1;
    bat_json json;
    bat_edit edit = {0};
    assert_non_null(last);
    assert_int_equal(bat_json_parse(last, strcspn(last, "\n"), &json, NULL), BAT_OK);
    assert_int_equal(bat_edit_read(&json, NULL, &edit, NULL), BAT_OK);
    bat_json_free(&json);
    return edit;
}

/* Lifts the pen. The stroke means that kind of edit, and costs no more than computing it does. */
static void lifted(pen *p, double x, double y, bat_edit_kind kind) {
    bat_document *before = NULL;
    bat_edit_result result;
    bat_sketch_report report;
    assert_int_equal(bat_document_copy(bat_editor_document(p->editor), &before), BAT_OK);
    bat_editor_frame(p->editor);
    const long begun = solve_count();
    pen_event(p, BAT_POINTER_UP, x, y);
    const long done = solve_count() - begun;
    bat_edit edit = last_edit(p->editor);
    assert_int_equal(edit.kind, kind);
    const long again = solve_count();
    assert_int_equal(bat_edit_compute(before, &edit, NULL, &result, &report), BAT_OK);
    const long once = solve_count() - again;
    if (!(once > 0 && done <= once)) fail_msg("%ld solves at pen-up, %ld for one fit", done, once);
    check(p->editor);
    bat_edit_result_clear(&result);
    bat_samples_free(&edit.samples);
    bat_document_free(before);
}

static void several_curves(void **state) {
    (void)state;
    bat_editor *editor = editor_with(
        2, (bat_curve *[]){pen_curve(200, 300, 30, 0, 11), pen_curve(500, 300, 30, 0, 11)});
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, (double[]){350, 306, 650, 306, 12}, 200);
    lifted(&p, 650, 306, BAT_EDIT_SEVERAL);
    bat_editor_free(editor);
}

static void a_level(void **state) {
    (void)state;
    bat_editor *editor = editor_with(1, (bat_curve *[]){pen_curve(200, 300, 20, 8, 31)});
    pen p = pen_for(editor);
    assert_int_equal(bat_editor_select(editor, 1, false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "tool-levels"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    assert_non_null(bat_object_shape(bat_document_at(bat_editor_document(editor), 0), 0));
    assert_int_equal(bat_editor_command(editor, "tool-sketch"), BAT_OK);
    pen_begin(&p, pen_arch, (double[]){300, 300, 700, 300, 25}, 200);
    lifted(&p, 700, 300, BAT_EDIT_LEVEL);
    bat_editor_free(editor);
}

static void one_curve(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_begin(&p, pen_arch, (double[]){300, 203, 600, 203, 20}, 200);
    lifted(&p, 600, 203, BAT_EDIT_REDRAW);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_curve), cmocka_unit_test(several_curves),
                                       cmocka_unit_test(a_level)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
