/* Guides and the grid: shown, dragged out of the rulers, moved with their layer. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/edit/affine.h"
#include "editor/editor.h"
#include "editor/tools/modes/guides.h"
#include "support/precision.h"

static void guides_and_grid_draw(void **state) {
    (void)state;
    bat_curve *curves[] = {segment(100, 500, 500, 700)};
    bat_editor *editor = editor_with(1, curves);
    uint64_t first = digest(editor);
    assert_int_equal(bat_guide_put(&editor->context, 0, 0, 320.5), BAT_OK);
    assert_int_equal(bat_guide_put(&editor->context, 0, 1, 150.25), BAT_OK);
    bat_snap found = snap(editor, 323, 400);
    at_once(&found, BAT_SNAP_GUIDE, 320.5, 400);
    found = snap(editor, 325, 147);
    at_once(&found, BAT_SNAP_CROSSING, 320.5, 150.25);
    found = snap(editor, 317, 612); /* the line is at y = 500 + 220.5 / 2 there */
    at_once(&found, BAT_SNAP_CROSSING, 320.5, 610.25);
    /* The grid draws while it is shown; a guide keeps its coordinate. */
    bat_editor_set(editor, "grid-spacing", 25);
    assert_int_equal(snap(editor, 402, 277).kind, BAT_SNAP_NONE);
    bat_editor_command(editor, "show-grid");
    found = snap(editor, 402, 277);
    at_once(&found, BAT_SNAP_GRID, 400, 275);
    found = snap(editor, 322, 277);
    at_once(&found, BAT_SNAP_GUIDE, 320.5, 275);
    /* Never nearer than 8 px, always a part of the finer one, never finer than asked. */
    double spacings[] = {0.001, 1, 3.7, 10, 1000}, before = 0;
    for (int i = 0; i < 5; i++) {
        bat_editor_set(editor, "grid-spacing", spacings[i]);
        before = 0;
        for (int k = 0; k < 60; k++) {
            double step = bat_grid_shown(&editor->context).step, whole = step / spacings[i];
            assert_true(step * editor->stage.view.zoom >= 8 && fabs(whole - round(whole)) < 1e-9 * whole);
            if (before > 0) {
                double times = step / before;
                assert_true(fabs(times - round(times)) < 1e-9 * times);
                assert_true(step == before || before * editor->stage.view.zoom < 8);
            }
            before = step;
            bat_view_zoom(&editor->stage.view, (double[]){0, 0}, 0.8);
        }
        bat_editor_command(editor, "zoom-100");
    }
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_GRID));
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_GUIDELINE));
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_GUIDELINE));
    bat_editor_free(editor);
}

/* Out of the rulers, moved, dragged back, deleted by the key; each one step. */
static void guides_by_hand(void **state) {
    (void)state;
    bat_editor *editor = editor_with(0, NULL);
    uint64_t first = digest(editor);
    pen p = mouse(editor);
    double at = 0;
    drag(&p, 500, 10, 500, 233); /* no rulers: this is a stroke of the tool */
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    bat_editor_command(editor, "show-rulers");
    drag(&p, 500, 10, 500, 233);
    assert_true(guides(editor, 1, &at) == 1 && at == 233);
    drag(&p, 8, 400, 340, 400);
    assert_true(guides(editor, 0, &at) == 1 && at == 340);
    drag(&p, 8, 400, 12, 500); /* not out of it */
    assert_int_equal(bat_document_count(editor->session.document), 2);
    drag(&p, 10, 10, 300, 300); /* the corner is nobody's */
    bat_editor_command(editor, "tool-select");
    drag(&p, 340, 600, 355, 610);
    assert_true(guides(editor, 0, &at) == 1 && at == 355);
    pen_event(&p, BAT_POINTER_DOWN, 355, 600);
    pen_event(&p, BAT_POINTER_MOVE, 500, 600);
    assert_true(bat_editor_key(editor, "Escape", true, 0, p.time));
    pen_event(&p, BAT_POINTER_UP, 500, 600);
    assert_true(guides(editor, 0, &at) == 1 && at == 355);
    drag(&p, 700, 233, 700, 9); /* back into the ruler */
    assert_int_equal(guides(editor, 1, &at), 0);
    bat_editor_command(editor, "undo");
    assert_true(guides(editor, 1, &at) == 1 && at == 233);
    drag(&p, 355, 600, 355, 600); /* a tap chooses */
    assert_int_equal(guides(editor, 0, &at), 1);
    assert_true(bat_editor_key(editor, "Delete", true, 0, p.time));
    assert_int_equal(guides(editor, 0, &at), 0);
    assert_int_equal(bat_editor_command(editor, "guide-upright"), BAT_OK);
    assert_true(guides(editor, 0, &at) == 1 && at == 500); /* the middle of the window */
    replays(editor, 0);
    /* A drawing with guides survives both formats. */
    char *text = NULL;
    size_t size = 0;
    bat_document *again = NULL;
    assert_int_equal(bat_document_write(editor->session.document, &text, &size), BAT_OK);
    assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
    assert_true(bat_document_digest(again) == digest(editor));
    bat_document_free(again);
    bat_free(text);
    while (bat_editor_command(editor, "undo") == BAT_OK) assert_null(bat_editor_check(editor));
    assert_true(digest(editor) == first);
    bat_object *none = NULL, *guide = NULL, *moved = NULL;
    assert_int_equal(bat_object_create_guide(5, 1, 40, &guide), BAT_OK);
    assert_int_equal(bat_affine_object(guide, (double[]){2, 0, 0, 3, 10, -7}, false, &moved), BAT_OK);
    assert_true(bat_object_guide(moved, &at) == 1 && at == 113);
    bat_object_release(guide);
    bat_object_release(moved);
    /* A guide is never selected: not by what undo brings back, nor by its id. */
    bat_editor_command(editor, "tool-select");
    bat_guide_put(&editor->context, 0, 0, 10);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "redo");
    bat_editor_select(editor, bat_guiding_of(&editor->context)->chosen, false);
    assert_int_equal(editor->choice.selection.count, 0);
    assert_null(bat_editor_check(editor));
    assert_int_equal(bat_object_create_guide(1, 0, NAN, &none), BAT_NUMBER);
    assert_int_equal(bat_object_create_guide(1, 2, 0, &none), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_guide(0, 0, 0, &none), BAT_ARGUMENT);
    bat_editor_free(editor);
}

static void put(bat_document *document, bat_object *object, bat_id parent, bool hidden, bool locked) {
    bat_object *made = NULL, *placed = NULL;
    assert_int_equal(bat_object_with_parent(object, parent, &made), BAT_OK);
    assert_int_equal(bat_object_with_state(made, hidden, locked, &placed), BAT_OK);
    assert_int_equal(bat_document_insert(document, bat_document_count(document), placed), BAT_OK);
    bat_object_release(object);
    bat_object_release(made);
    bat_object_release(placed);
}

/* A layer is moved with the guides in it; a guide that is dragged is the one that it was. */
static void a_layer_moves_with_its_guides(void **state) {
    (void)state;
    static const bool flags[][2] = {{false, false}, {true, false}, {false, true}};
    for (int i = 0; i < 3; i++) {
        bat_document *document = NULL;
        bat_object *layer = NULL, *guide = NULL, *named = NULL, *line = NULL;
        bat_style style = bat_style_defaults();
        bat_curve *curve = segment(400, 300, 600, 320);
        bat_document_create(&document);
        bat_document_set_page(document, (double[]){0, 0, 1000, 800});
        assert_int_equal(bat_object_create_group(1, "Roof", true, &layer), BAT_OK);
        put(document, layer, 0, false, false);
        assert_int_equal(bat_object_create_guide(2, 0, 250, &guide), BAT_OK);
        assert_int_equal(bat_object_with_name(guide, "axle", &named), BAT_OK);
        bat_object_release(guide);
        put(document, named, 1, flags[i][0], flags[i][1]);
        assert_int_equal(bat_object_create_path(3, NULL, &style, 1, &curve, &line), BAT_OK);
        put(document, line, 1, false, false);
        bat_editor *editor = NULL;
        bat_editor_create(&editor);
        bat_editor_resize(editor, 1000, 800, 1);
        assert_int_equal(bat_editor_open(editor, document, "test"), BAT_OK);
        bat_editor_command(editor, "zoom-100");
        bat_editor_command(editor, "tool-select");
        uint64_t first = digest(editor);
        double at = 0, box[4];
        bat_editor_select(editor, 1, false);
        assert_int_equal(editor->choice.selection.count, 1);
        assert_int_equal(bat_editor_command(editor, "nudge-right"), BAT_OK);
        bat_object_bounds(bat_document_at(editor->session.document, 2), box);
        assert_true(guides(editor, 0, &at) == 1 && at == 251 && box[0] == 401);
        if (!flags[i][0] && !flags[i][1]) {
            bat_editor_select(editor, 0, false);
            pen p = mouse(editor);
            drag(&p, 251, 700, 300, 700);
            assert_true(guides(editor, 0, &at) == 1 && at == 300);
        }
        const bat_object *now = bat_document_at(editor->session.document, 1);
        assert_string_equal(bat_object_name(now), "axle");
        assert_true(bat_object_id(now) == 2 && bat_object_parent(now) == 1);
        assert_true(bat_object_is_hidden(now) == flags[i][0] && bat_object_is_locked(now) == flags[i][1]);
        round_trip(editor, first);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(guides_and_grid_draw),
        cmocka_unit_test(guides_by_hand),
        cmocka_unit_test(a_layer_moves_with_its_guides),
    };
    return cmocka_run_group_tests_name("guides", tests, NULL, NULL);
}
