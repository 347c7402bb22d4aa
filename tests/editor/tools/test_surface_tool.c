/* The surface tool: which line a marking, a tap and the keyboard light, how it slides and how it is let go. The document
 * stays as it is. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "editor/editor.h"
#include "editor/tools/surface/state.h"
#include "editor/tools/toolbox.h"
#include "support/editing.h"
#include "support/sheet.h"

enum { SHEET = 7 };

static bat_editor *with_sheet(void) {
    bat_document *document = NULL;
    bat_surface *surface = sheet_create();
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(sheet_add(document, SHEET, surface), BAT_OK);
    bat_surface_free(surface);
    bat_editor *editor = editor_of(document);
    assert_int_equal(bat_editor_command(editor, "tool-surface"), BAT_OK);
    return editor;
}

static const bat_line *lit(bat_editor *editor) {
    return &((bat_surfacing *)bat_toolbox_state(&editor->context, bat_tool_surface()))->lit;
}

static void expect(bat_editor *editor, bat_direction direction, double value, double within) {
    const bat_line *line = lit(editor);
    check(editor);
    assert_int_equal(line->object, SHEET);
    assert_int_equal(line->direction, direction);
    if (!(fabs(line->at[direction] - value) <= within)) fail_msg("at %g, not %g", line->at[direction], value);
}

/* The sheet lies over 300..700 x 200..600; u runs along x over 0..4, v along y over 0..3, nearly evenly inside. */
static void a_marking_lights_its_line(void **state) {
    (void)state;
    for (int i = 0; i < 6; i++) { /* the view turned, too */
        bat_editor *editor = with_sheet();
        const uint64_t first = digest(editor);
        for (int k = 0; k < i; k++) bat_editor_command(editor, "view-left");
        bat_viewpoint view;
        double from[2], to[2];
        assert_int_equal(bat_stage_viewpoint(editor->context.stage, &view), BAT_OK);
        bat_viewpoint_project(&view, (double[]){500, 330, 0}, from, NULL);
        bat_viewpoint_project(&view, (double[]){500, 460, 0}, to, NULL);
        pen p = pen_for(editor);
        drag(&p, from[0], from[1], to[0], to[1]);
        expect(editor, BAT_U, 2, 0.05);
        bat_viewpoint_project(&view, (double[]){340, 400, 0}, from, NULL);
        bat_viewpoint_project(&view, (double[]){450, 400, 0}, to, NULL);
        drag(&p, to[0], to[1], from[0], from[1]);
        expect(editor, BAT_V, 1.5, 0.05);
        assert_true(digest(editor) == first);
        assert_int_equal(round_trip(editor, first), 0);
        bat_editor_free(editor);
    }
}

static void an_edge_is_meant_near_it(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    pen p = pen_for(editor);
    drag(&p, 302, 300, 302, 480);
    expect(editor, BAT_U, 0, 0);
    drag(&p, 400, 598, 560, 598);
    expect(editor, BAT_V, 3, 0);
    drag(&p, 50, 50, 200, 60); /* beside the surface */
    assert_int_equal(lit(editor)->object, 0);
    assert_true(strstr(bat_editor_frame(editor)->notice, "no surface") != NULL);
    bat_editor_free(editor);
}

static void taps_choose_flip_and_let_go(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    pen p = pen_for(editor);
    tap(&p, 503, 430); /* the line at u = 2 is seen 3 px beside, none of the other direction as near */
    expect(editor, BAT_U, 2.03, 0.05);
    const double v = lit(editor)->at[1];
    tap(&p, 640, 431); /* on the other line through that point */
    expect(editor, BAT_V, v, 0);
    tap(&p, 600, 430); /* on the lit one: nothing happens */
    expect(editor, BAT_V, v, 0);
    tap(&p, 503, 330); /* on the first again */
    expect(editor, BAT_U, 2.03, 0.05);
    tap(&p, 600, 300);
    assert_int_equal(lit(editor)->object, 0);
    tap(&p, 100, 100);
    assert_int_equal(lit(editor)->object, 0);
    bat_editor_free(editor);
}

static void the_grip_slides_the_line(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    pen p = pen_for(editor);
    tap(&p, 503, 430);
    const double u = lit(editor)->at[0];
    drag(&p, 503, 430, 560, 440);
    const double there = lit(editor)->at[0];
    if (!(there > 2.7 && there < 2.95)) fail_msg("at %g", there);
    drag(&p, 560, 430, 502, 430); /* stops at the middle, a knot */
    expect(editor, BAT_U, 2, 0);
    drag(&p, 500, 430, 305, 430); /* and at the edge */
    expect(editor, BAT_U, 0, 0);
    drag_to(&p, 300, 430, 503, 430);
    assert_true(lit(editor)->at[0] > 1);
    bat_editor_command(editor, "cancel");
    expect(editor, BAT_U, 0, 0);
    pen_event(&p, BAT_POINTER_UP, 503, 430);
    expect(editor, BAT_U, 0, 0);
    bat_editor_command(editor, "cancel");
    assert_int_equal(lit(editor)->object, 0);
    assert_true(u > 2);
    bat_editor_free(editor);
}

static void the_keyboard_does_the_same(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    bat_editor_key(editor, "Tab", true, 0, 10);
    expect(editor, BAT_U, 2, 0);
    bat_editor_key(editor, "ArrowRight", true, 0, 20);
    expect(editor, BAT_U, 2.04, 1e-12);
    bat_editor_key(editor, ".", true, 0, 30);
    expect(editor, BAT_U, 3, 0);
    bat_editor_key(editor, ",", true, 0, 40);
    expect(editor, BAT_U, 2, 0);
    bat_editor_key(editor, "Tab", true, 0, 50);
    expect(editor, BAT_V, 1.5, 0);
    for (int i = 0; i < 20; i++) bat_editor_key(editor, "ArrowLeft", true, BAT_SHIFT, 60 + i);
    expect(editor, BAT_V, 0, 0);
    bat_editor_key(editor, "Escape", true, 0, 90);
    assert_int_equal(lit(editor)->object, 0);
    bat_editor_free(editor);
}

/* The lit line is shown with its name, and goes with its surface. */
static void the_line_goes_with_its_surface(void **state) {
    (void)state;
    bat_editor *editor = with_sheet();
    pen p = pen_for(editor);
    tap(&p, 503, 430);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_int_equal(frame->label_count, 1);
    assert_non_null(strstr(frame->labels[0].text, "line at u = 2.0"));
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "duplicate"), BAT_OK);
    bat_editor_command(editor, "tool-surface");
    assert_int_equal(lit(editor)->object, 0);
    bat_editor_command(editor, "point-previous"); /* the copy, which lies in front */
    assert_true(lit(editor)->object > SHEET);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    bat_editor_frame(editor);
    check(editor);
    assert_int_equal(lit(editor)->object, 0);
    bat_editor_free(editor);
}

/* The eye is put before the whole surface, however far it reaches towards it. */
static void a_deep_surface_is_seen(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_surface *sheet = sheet_create(), *deep = NULL;
    const double rows[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -1e9};
    assert_int_equal(bat_surface_transform(sheet, rows, &deep), BAT_OK);
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(sheet_add(document, SHEET, deep), BAT_OK);
    bat_editor *editor = editor_of(document);
    bat_editor_command(editor, "tool-surface");
    pen p = pen_for(editor);
    drag(&p, 500, 330, 500, 460);
    expect(editor, BAT_U, 2, 0.05);
    bat_surface_free(sheet);
    bat_surface_free(deep);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_marking_lights_its_line),   cmocka_unit_test(an_edge_is_meant_near_it),
        cmocka_unit_test(taps_choose_flip_and_let_go), cmocka_unit_test(the_grip_slides_the_line),
        cmocka_unit_test(the_keyboard_does_the_same),  cmocka_unit_test(the_line_goes_with_its_surface),
        cmocka_unit_test(a_deep_surface_is_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
