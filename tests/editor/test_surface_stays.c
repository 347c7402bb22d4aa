/* A surface in the drawing: it is seen, chosen and moved like anything else, and no hand changes it unless it can change
 * the surface itself. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "support/editing.h"
#include "support/sheet.h"

enum { SHEET = 7 };

/* A document with the sheet, and a curve that crosses it. */
static bat_editor *editor_with_sheet(const bat_surface *surface) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, pen_curve(200, 400, 60, 5, 11));
    assert_int_equal(sheet_add(document, SHEET, surface), BAT_OK);
    return editor_of(document);
}

static const bat_surface *sheet_in(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    const bat_object *object = bat_document_at(document, bat_document_find(document, SHEET));
    return object ? bat_object_surface(object) : NULL;
}

static void no_hand_takes_its_lines(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-sketch",   "tool-points", "tool-smooth", "tool-eraser",
                                        "tool-tangents", "tool-line",   "tool-span",   "tool-levels"};
    bat_surface *surface = sheet_create();
    for (size_t i = 0; i < sizeof tools / sizeof *tools; i++)
        for (int chosen = 0; chosen < 2; chosen++) {
            bat_editor *editor = editor_with_sheet(surface);
            const uint64_t first = digest(editor);
            pen p = pen_for(editor);
            if (chosen) {
                bat_editor_command(editor, "tool-select");
                tap(&p, 300, 300);
            }
            bat_editor_command(editor, tools[i]);
            drag(&p, 303, 240, 302, 560);
            drag(&p, 320, 398, 690, 402);
            tap(&p, 500, 400);
            drag(&p, 700, 610, 300, 598);
            assert_non_null(sheet_in(editor));
            assert_true(bat_surface_is_equal(sheet_in(editor), surface));
            bat_editor_command(editor, "cancel");
            round_trip(editor, first);
            bat_editor_free(editor);
        }
    bat_surface_free(surface);
}

/* Commands for curves leave a chosen surface as it is, and are not offered for it alone. */
static void commands_for_curves_pass_it_by(void **state) {
    (void)state;
    static const char *const commands[] = {"curve-reverse", "curve-open",     "curve-close",  "curve-join",
                                           "curve-split",   "curve-simplify", "symmetry-axis"};
    bat_surface *surface = sheet_create();
    for (int all = 0; all < 2; all++) {
        bat_editor *editor = editor_with_sheet(surface);
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        bat_editor_command(editor, "tool-select");
        tap(&p, 300, 300);
        if (all) bat_editor_command(editor, "select-all");
        const char *offers = bat_editor_actions(editor);
        assert_non_null(offers);
        if (!all) assert_null(strstr(offers, "curve-"));
        for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
            bat_editor_command(editor, commands[i]);
            check(editor);
            assert_true(bat_surface_is_equal(sheet_in(editor), surface));
        }
        round_trip(editor, first);
        bat_editor_free(editor);
    }
    bat_surface_free(surface);
}

static void it_is_chosen_by_a_line_and_moved_whole(void **state) {
    (void)state;
    bat_surface *surface = sheet_create();
    bat_editor *editor = editor_with_sheet(surface);
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    bat_editor_command(editor, "tool-select");
    drag(&p, 300, 300, 340, 320);
    const bat_surface *moved = sheet_in(editor);
    const double *a = bat_surface_row(surface, 2), *b = bat_surface_row(moved, 2);
    assert_true(fabs(b[0] - a[0] - 40) < 1e-9 && fabs(b[1] - a[1] - 20) < 1e-9 && b[2] == a[2]);
    assert_int_equal(bat_editor_command(editor, "duplicate"), BAT_OK);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 3);
    assert_int_equal(bat_editor_command(editor, "delete"), BAT_OK);
    assert_int_equal(round_trip(editor, first), 3);
    bat_editor_free(editor);
    bat_surface_free(surface);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(no_hand_takes_its_lines),
                                       cmocka_unit_test(commands_for_curves_pass_it_by),
                                       cmocka_unit_test(it_is_chosen_by_a_line_and_moved_whole)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
