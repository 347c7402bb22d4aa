/* The select tool: what clicks, drags and handles do, state by state; undo and replay. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"

static void clicks_select(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    click(&p, 500, 205, 0);
    assert_true(selected(editor) == 1 && has(editor, 1));
    click(&p, 500, 597, 0);
    assert_true(selected(editor) == 1 && has(editor, 2));
    click(&p, 500, 200, BAT_SHIFT);
    assert_int_equal(selected(editor), 2);
    click(&p, 600, 200, BAT_SHIFT);
    assert_true(selected(editor) == 1 && has(editor, 2));
    click(&p, 500, 400, BAT_SHIFT);
    assert_int_equal(selected(editor), 1);
    click(&p, 500, 350, 0);
    assert_int_equal(selected(editor), 0);
    bat_editor_key(editor, "a", true, BAT_CTRL, p.time);
    assert_int_equal(selected(editor), 2);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_int_equal(frame->selected, 2);
    assert_non_null(pen_live(frame, BAT_ROLE_HANDLE));
    assert_true(bat_editor_key(editor, "Escape", true, 0, p.time));
    assert_int_equal(selected(editor), 0);
    assert_false(bat_editor_key(editor, "Escape", true, 0, p.time));
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_SELECTION));
    bat_editor_free(editor);
}

static void marquee_selects_what_it_touches(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    drag_holding(&p, 300, 100, 350, 300, 0); /* crosses the first */
    assert_true(selected(editor) == 1 && has(editor, 1));
    drag_holding(&p, 810, 700, 100, 500, BAT_SHIFT); /* holds the second */
    assert_int_equal(selected(editor), 2);
    drag_holding(&p, 300, 300, 350, 500, 0); /* in between */
    assert_int_equal(selected(editor), 0);
    pen_event(&p, BAT_POINTER_DOWN, 300, 100);
    pen_event(&p, BAT_POINTER_MOVE, 350, 300);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_MARQUEE));
    bat_editor_command(editor, "cancel");
    assert_int_equal(selected(editor), 0);
    pen_event(&p, BAT_POINTER_UP, 350, 300);
    assert_int_equal(selected(editor), 0);
    bat_editor_free(editor);
}

static void fills_are_picked(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    click(&p, 500, 200, 0);
    bat_editor_command(editor, "curve-close");
    bat_editor_set(editor, "filled", 1);
    bat_editor_free(editor);
    /* A square with a hole: even-odd. */
    double square[10] = {300, 300, 500, 300, 500, 500, 300, 500, 300, 300};
    double hole[10] = {350, 350, 450, 350, 450, 450, 350, 450, 350, 350};
    double knots[7] = {0, 0, 1, 2, 3, 4, 4};
    for (int even_odd = 0; even_odd < 2; even_odd++) {
        editor = select_editor();
        p = mouse(editor);
        bat_curve *curves[2] = {NULL, NULL};
        bat_curve_create(2, 1, false, 5, square, 7, knots, &curves[0]);
        bat_curve_create(2, 1, false, 5, hole, 7, knots, &curves[1]);
        bat_style style = bat_style_defaults();
        style.filled = true;
        style.even_odd = even_odd;
        bat_object *made = NULL;
        assert_int_equal(bat_object_create_path(bat_document_new_id(editor->session.document), NULL, &style,
                                                2, curves, &made),
                         BAT_OK);
        bat_transaction_begin(&editor->context);
        bat_transaction_insert(&editor->context, 2, made);
        bat_transaction_commit(&editor->context, BAT_STRING_STEP_CHANGE, NULL);
        bat_object_release(made);
        click(&p, 325, 420, 0);
        assert_true(selected(editor) == 1 && has(editor, 3));
        click(&p, 700, 420, 0);
        assert_int_equal(selected(editor), 0);
        click(&p, 400, 400, 0);
        assert_int_equal(selected(editor), even_odd ? 0 : 1);
        bat_editor_free(editor);
    }
}

static void drags_move(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    drag_holding(&p, 500, 200, 530, 260, 0); /* a drag selects what it takes hold of */
    assert_true(selected(editor) == 1 && has(editor, 1));
    expect_box(editor, 1, 230, 260, 830, 260);
    drag_holding(&p, 500, 260, 502, 290, BAT_SHIFT);
    expect_box(editor, 1, 230, 290, 830, 290);
    assert_false(editor->session.transaction.open);
    assert_int_equal(editor->session.history.done, 2);
    /* cancelled: nothing has happened */
    uint64_t before = digest(editor);
    pen_event(&p, BAT_POINTER_DOWN, 500, 290);
    pen_event(&p, BAT_POINTER_MOVE, 600, 400);
    bat_editor_frame(editor);
    assert_true(digest(editor) != before);
    bat_editor_key(editor, "Escape", true, 0, p.time);
    assert_true(digest(editor) == before);
    pen_event(&p, BAT_POINTER_UP, 600, 400);
    assert_true(digest(editor) == before && editor->session.history.done == 2);
    /* keys */
    bat_editor_key(editor, "ArrowRight", true, 0, p.time);
    expect_box(editor, 1, 231, 290, 831, 290);
    bat_editor_key(editor, "ArrowUp", true, BAT_SHIFT, p.time);
    expect_box(editor, 1, 231, 280, 831, 280);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static void handles_scale_and_rotate(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    bat_editor_command(editor, "select-all"); /* box 200 200 800 600 */
    drag_holding(&p, 800, 600, 500, 400, 0);
    expect_box(editor, 1, 200, 200, 500, 200);
    expect_box(editor, 2, 200, 400, 500, 400);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    drag_holding(&p, 800, 600, 500, 580, BAT_SHIFT); /* the greater factor leads: y, 0.95 */
    expect_box(editor, 1, 200, 200, 770, 200);
    expect_box(editor, 2, 200, 580, 770, 580);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    drag_holding(&p, 800, 600, 650, 500, BAT_ALT);
    expect_box(editor, 1, 350, 300, 650, 300);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    drag_holding(&p, 800, 400, 500, 450, 0); /* the right side: x alone */
    expect_box(editor, 2, 200, 600, 500, 600);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    drag_holding(&p, 200, 200, 1000, 200, 0); /* through the other side: mirrored */
    expect_box(editor, 1, 800, 200, 1000, 200);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    /* The rotation handle is above the middle of the top; about the middle (500, 400). */
    drag_holding(&p, 500, 174, 730, 400, BAT_SHIFT);
    expect_box(editor, 1, 700, 100, 700, 700);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    double away = 226, angle = 0.3; /* 17.2 degrees snap to 15 */
    drag_holding(&p, 500, 174, 500 + away * sin(angle), 400 - away * cos(angle), BAT_SHIFT);
    double c = cos(acos(-1) / 12), s = sin(acos(-1) / 12), box[4];
    box_of(editor, 1, box);
    assert_true(fabs(box[2] - box[0] - 600 * c) < 1e-9 && fabs(box[3] - box[1] - 600 * s) < 1e-9);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static uint32_t roll(uint32_t *seed, uint32_t below) {
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) % below;
}

/* Long random sessions: every invariant after every event, then all the way back, forth, and replayed. */
static void random_sessions(void **state) {
    (void)state;
    static const char *const commands[] = {
        "select-all",      "delete",      "duplicate",     "group",        "ungroup",
        "order-front",     "order-back",  "order-forward", "align-left",   "align-middle",
        "distribute-down", "curve-close", "curve-join",    "curve-split",  "curve-open",
        "curve-reverse",   "layer-add",   "layer-up",      "layer-down",   "layer-take",
        "layer-delete",    "undo",        "redo",          "style-marker", "tool-sketch",
        "tool-select",     "nudge-left",  "cancel",        "duplicate",    "undo"};
    for (uint32_t seed = 1; seed <= 4; seed++) {
        uint32_t s = seed * 7919;
#define ROLL(n) roll(&s, (uint32_t)(n))
        bat_editor *editor = select_editor();
        uint64_t first = digest(editor);
        pen p = mouse(editor);
        bool down = false;
        for (int i = 0; i < 400; i++) {
            uint32_t kind = ROLL(10);
            double x = 100 + ROLL(800), y = 100 + ROLL(600);
            p.modifiers = ROLL(4) ? 0 : ROLL(8);
            if (kind < 2) {
                bat_editor_command(editor, commands[ROLL(sizeof commands / sizeof *commands)]);
            } else if (kind < 5) {
                pen_event(&p, down ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, x, ROLL(2) ? 200 : y);
                down = true;
            } else if (kind < 7) {
                pen_event(&p, down ? BAT_POINTER_UP : BAT_POINTER_HOVER, x, y);
                down = false;
            } else if (kind == 7) {
                bat_id id = 1 + ROLL(20);
                bool hidden = !ROLL(4), locked = !ROLL(4);
                bat_editor_set_state(editor, id, hidden, locked);
                bat_editor_activate_layer(editor, id);
            } else if (kind == 8) {
                bat_id id = ROLL(20);
                bat_editor_select(editor, id, ROLL(2));
            } else {
                bat_editor_frame(editor);
            }
            const char *wrong = bat_editor_check(editor);
            if (wrong) fail_msg("seed %u, event %d: %s", seed, i, wrong);
            if (bat_document_count(editor->session.document) > 60) bat_editor_command(editor, "undo");
        }
        if (down) pen_event(&p, BAT_POINTER_UP, 500, 500);
        goes_back_and_replays(editor, first);
        bat_editor_free(editor);
    }
}

/* A drag with Alt leaves the originals and moves copies, as one step; cancelled, nothing is left of it. */
static void alt_drags_a_copy(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    uint64_t fresh = digest(editor);
    bat_id id = bat_object_id(bat_document_at(editor->session.document, 0));
    bat_editor_command(editor, "tool-select");
    double box[4], moved[4];
    bat_object_bounds(bat_document_at(editor->session.document, 0), box);
    double from[2];
    bat_view_to_screen(&editor->stage.view, (double[]){400, 200}, from);
    for (int round = 0; round < 3; round++) { /* cancelled, cancelled of what was selected, let go */
        bool cancelled = round < 2, chosen = round == 1;
        p.time += 1000;
        if (chosen)
            bat_selection_add(&editor->choice.selection, id);
        else
            bat_selection_clear(&editor->choice.selection);
        p.modifiers = BAT_ALT;
        pen_event(&p, BAT_POINTER_DOWN, from[0], from[1]);
        pen_event(&p, BAT_POINTER_MOVE, from[0] + 20, from[1]);
        bat_editor_frame(editor);
        pen_event(&p, BAT_POINTER_MOVE, from[0] + 30, from[1] + 50);
        bat_editor_frame(editor);
        assert_int_equal(bat_document_count(editor->session.document), 3);
        assert_null(bat_editor_check(editor));
        pen_event(&p, cancelled ? BAT_POINTER_CANCEL : BAT_POINTER_UP, from[0] + 30, from[1] + 50);
        p.modifiers = 0;
        assert_int_equal(editor->choice.selection.count, cancelled ? chosen : 1);
        assert_true(bat_selection_has(&editor->choice.selection, id) == chosen);
        assert_true((digest(editor) == fresh) == cancelled);
    }
    double pixel = bat_view_pixel(&editor->stage.view);
    bat_object_bounds(bat_document_at(editor->session.document, 0), moved);
    assert_memory_equal(box, moved, sizeof box);
    bat_object_bounds(bat_document_at(editor->session.document, 1), moved);
    assert_true(fabs(moved[0] - box[0] - 30 * pixel) < 1e-9 && fabs(moved[1] - box[1] - 50 * pixel) < 1e-9);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == fresh);
    bat_editor_free(editor);
}

static void tap_place(pen *p, double x, double y) {
    double at[2];
    bat_view_to_screen(&p->editor->stage.view, (double[]){x, y}, at);
    pen_event(p, BAT_POINTER_DOWN, at[0], at[1]);
    pen_event(p, BAT_POINTER_UP, at[0], at[1]);
}

/* A double click enters a group: clicks, boxes and "select all" mean what is in it then; Esc leaves, one group at a
 * time, and so does a click outside. */
static void double_click_enters(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "group");
    bat_id group = editor->choice.selection.ids[0];
    bat_editor_command(editor, "deselect");
    tap_place(&p, 400, 200);
    assert_true(bat_selection_has(&editor->choice.selection, group) && !editor->choice.entered);
    p.time += 1000;
    tap_place(&p, 400, 200); /* too late to be a double click */
    assert_true(!editor->choice.entered);
    tap_place(&p, 400, 200);
    assert_true(editor->choice.entered == group && editor->choice.selection.count == 1);
    bat_id first = editor->choice.selection.ids[0];
    assert_true(first != group);
    assert_true(bat_object_parent(bat_document_at(
                    editor->session.document, bat_document_find(editor->session.document, first))) == group);
    p.time += 1000;
    tap_place(&p, 400, 600);
    assert_true(editor->choice.selection.count == 1 && editor->choice.selection.ids[0] != first &&
                editor->choice.entered == group);
    bat_editor_command(editor, "select-all");
    assert_int_equal(editor->choice.selection.count, 2);
    assert_non_null(strstr(bat_editor_frame(editor)->labels[0].text, "Group"));
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_true(!editor->choice.entered && bat_selection_has(&editor->choice.selection, group));
    p.time += 1000;
    bat_editor_command(editor, "deselect");
    tap_place(&p, 400, 200);
    tap_place(&p, 400, 200);
    assert_true(editor->choice.entered == group);
    p.time += 1000;
    tap_place(&p, 400, 400); /* nothing there */
    assert_true(!editor->choice.entered && !editor->choice.selection.count);
    /* What is gone cannot be in force. */
    tap_place(&p, 400, 200);
    p.time += 1000;
    tap_place(&p, 400, 200);
    tap_place(&p, 400, 200);
    assert_true(editor->choice.entered == group);
    bat_editor_command(editor, "undo");
    assert_true(!editor->choice.entered);
    assert_null(bat_editor_check(editor));
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clicks_select),
        cmocka_unit_test(marquee_selects_what_it_touches),
        cmocka_unit_test(fills_are_picked),
        cmocka_unit_test(drags_move),
        cmocka_unit_test(handles_scale_and_rotate),
        cmocka_unit_test(random_sessions),
        cmocka_unit_test(alt_drags_a_copy),
        cmocka_unit_test(double_click_enters),
    };
    return cmocka_run_group_tests_name("select", tests, NULL, NULL);
}
