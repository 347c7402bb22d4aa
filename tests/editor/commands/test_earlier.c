/*
 * One curve as it was: each shape of the history along the slider, shown and never put into the drawing until it is kept; kept, it
 * is one step that changes this curve alone, with the name, the place and the look that it has now; Esc leaves nothing.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"

static void says(bat_editor *editor, const char *words) {
    const char *readings = bat_editor_readings(editor);
    if (!strstr(readings, words)) fail_msg("%s, not %s", readings, words);
}

static void move(bat_editor *editor, const char *x) {
    assert_int_equal(bat_editor_enter(editor, "x", x), BAT_OK);
}

/* Line 1 at x = 200, 300, 250, between changes of its colour and of line 2, which moves in its second step, too. */
static bat_editor *changed(void) {
    bat_editor *editor = select_editor();
    only(editor, 1, 0);
    move(editor, "300");
    assert_int_equal(bat_editor_set(editor, "stroke-width", 7), BAT_OK);
    only(editor, 2, 0);
    move(editor, "220");
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "curve-reverse"), BAT_OK);
    only(editor, 1, 0);
    return editor;
}

static double shown_from(bat_editor *editor) {
    const bat_item *item = pen_live(bat_editor_frame(editor), BAT_ROLE_FIT);
    return item ? item->bounds[0] + bat_editor_frame(editor)->origin[0] : -1;
}

static void each_shape_is_shown(void **state) {
    (void)state;
    bat_editor *editor = changed();
    const uint64_t now = digest(editor);
    const int steps = editor->session.history.done;
    assert_int_equal(bat_editor_command(editor, "curve-earlier"), BAT_OK);
    assert_int_not_equal(bat_editor_frame(editor)->readings, 0);
    says(editor, "\"amount\":1,");
    says(editor, "\"step\":0.5,");
    says(editor, "\"said\":\"Reverse curve\"");
    assert_true(shown_from(editor) < 0);
    static const struct {
        double amount, from;
        const char *said;
    } shapes[] = {{0, 200, "\"said\":\"Opened\""}, {0.5, 300, "\"said\":\"Move\""}, {0.2, 200, "Opened"}};
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        assert_int_equal(bat_editor_refit(editor, shapes[i].amount, i % 2 == 0), BAT_OK);
        says(editor, shapes[i].said);
        if (!(fabs(shown_from(editor) - shapes[i].from) < 4))
            fail_msg("%g at %g", shown_from(editor), shapes[i].amount);
        assert_true(digest(editor) == now);
        assert_int_equal(editor->session.history.done, steps);
        check(editor);
    }
    assert_int_equal(bat_editor_refit(editor, 1, true), BAT_OK);
    assert_true(shown_from(editor) < 0);
    assert_int_equal(bat_editor_refit(editor, NAN, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_refit(editor, 1.1, false), BAT_ARGUMENT);
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_true(digest(editor) == now && shown_from(editor) < 0);
    assert_int_equal(bat_editor_frame(editor)->readings, 0);
    assert_int_equal(selected(editor), 1);
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_STATE);
    bat_editor_free(editor);
}

static void what_is_kept_is_one_step(void **state) {
    (void)state;
    for (int way = 0; way < 2; way++) {
        bat_editor *editor = changed();
        const uint64_t now = digest(editor), other = bat_object_curve_digest(object(editor, 2), 0);
        const int steps = editor->session.history.done;
        assert_int_equal(bat_editor_rename(editor, 1, "roof"), BAT_OK);
        only(editor, 1, 0);
        assert_int_equal(bat_editor_command(editor, "curve-earlier"), BAT_OK);
        assert_int_equal(bat_editor_read_as(editor, 1), BAT_ARGUMENT);
        assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK);
        assert_int_equal(way ? bat_editor_read_as(editor, 0) : bat_editor_command(editor, "accept"), BAT_OK);
        expect_box(editor, 1, 200, 200, 800, 200);
        assert_true(bat_object_style(object(editor, 1))->width == 7);
        assert_string_equal(bat_object_name(object(editor, 1)), "roof");
        assert_true(bat_object_curve_digest(object(editor, 2), 0) == other);
        assert_int_equal(editor->session.history.done, steps + 2);
        assert_int_equal(bat_editor_frame(editor)->readings, 0);
        assert_int_equal(selected(editor), 1);
        check(editor);
        replays(editor, 0);
        bat_editor_command(editor, "undo");
        bat_editor_command(editor, "undo");
        assert_true(digest(editor) == now);
        /* as it is now: nothing to keep */
        only(editor, 1, 0);
        assert_int_equal(bat_editor_command(editor, "curve-earlier"), BAT_OK);
        bat_editor_command(editor, "accept");
        assert_true(digest(editor) == now);
        bat_editor_free(editor);
    }
}

/* In a group since then, it stays there; what was undone is no earlier shape. */
static void its_place_stays(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    only(editor, 1, 0);
    move(editor, "300");
    only(editor, 1, 2);
    assert_int_equal(bat_editor_command(editor, "group"), BAT_OK);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "curve-earlier"), BAT_OK);
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK);
    assert_int_equal(bat_editor_read_as(editor, 0), BAT_OK);
    assert_int_not_equal(bat_object_parent(object(editor, 1)), 0);
    expect_box(editor, 1, 200, 200, 800, 200);
    check(editor);
    replays(editor, 0);
    while (bat_editor_command(editor, "undo") == BAT_OK) {
    }
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "curve-earlier"), BAT_STATE);
    bat_editor_free(editor);
}

static void nothing_earlier(void **state) {
    (void)state;
    bat_editor *editor = changed();
    bat_editor_command(editor, "deselect");
    assert_int_equal(bat_editor_command(editor, "curve-earlier"), BAT_STATE);
    only(editor, 1, 2);
    assert_int_equal(bat_editor_command(editor, "curve-earlier"), BAT_STATE);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "Select one curve that was changed"));
    static const char *const ends[] = {"deselect", "tool-sketch", "curve-reverse", "undo"};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        bat_editor *one = changed();
        assert_int_equal(bat_editor_command(one, "curve-earlier"), BAT_OK);
        assert_int_equal(bat_editor_refit(one, 0, true), BAT_OK);
        assert_int_equal(bat_editor_command(one, ends[i]), BAT_OK);
        assert_true(shown_from(one) < 0);
        assert_int_equal(bat_editor_read_as(one, 0), BAT_STATE);
        check(one);
        bat_editor_free(one);
    }
    bat_editor_free(editor);
}

static bool offered(bat_editor *editor) {
    const char *all = bat_editor_actions(editor);
    assert_non_null(all);
    return strstr(all, "curve-earlier") != NULL;
}

/* Offered exactly when the command finds something, however it is asked: after each step of a session that changes shapes, looks
 * and places of two lines, is taken back in part and done again, and goes on after that. */
static void offered_when_there_is_one(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    only(editor, 1, 0);
    assert_false(offered(editor));
    assert_int_equal(bat_editor_set(editor, "stroke-width", 7), BAT_OK); /* a look is no shape */
    assert_false(offered(editor));
    only(editor, 2, 0);
    move(editor, "220");
    assert_true(offered(editor));
    only(editor, 1, 0);
    assert_false(offered(editor)); /* of the other */
    only(editor, 1, 2);
    assert_false(offered(editor)); /* of two */
    assert_int_equal(bat_editor_command(editor, "group"), BAT_OK);
    assert_false(offered(editor));
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    only(editor, 2, 0);
    assert_true(offered(editor));
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    only(editor, 2, 0);
    assert_false(offered(editor)); /* what was undone is no earlier shape */
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    only(editor, 2, 0);
    assert_true(offered(editor));
    move(editor, "200");
    assert_true(offered(editor));

    uint32_t seed = 7;
    for (int i = 0; i < 400; i++) {
        seed = seed * 1664525 + 1013904223;
        const uint32_t drawn = seed >> 16;
        if (drawn % 3 == 0) only(editor, 1 + drawn / 3 % 2, 0);
        if (drawn % 7 == 1) move(editor, drawn / 7 % 2 ? "210" : "230");
        if (drawn % 7 == 2) bat_editor_set(editor, "stroke-width", 1 + drawn / 7 % 9);
        if (drawn % 7 > 3) bat_editor_command(editor, drawn % 7 == 4 ? "redo" : "undo");
        if (bat_editor_frame(editor)->selected != 1) only(editor, 1 + drawn / 3 % 2, 0);
        const bool told = offered(editor), asked = drawn % 2 && offered(editor);
        assert_true(told == asked || drawn % 2 == 0);
        assert_int_equal(bat_editor_command(editor, "curve-earlier"), told ? BAT_OK : BAT_STATE);
        assert_true(offered(editor) == told);
        if (told) assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
        check(editor);
    }
    bat_editor_free(editor);
}

/* The oldest steps are dropped: a shape that went with them is offered no more. */
static void what_is_dropped_is_not_offered(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    only(editor, 1, 0);
    move(editor, "300");
    int seen = 0, gone = 0;
    for (int i = 0; i < BAT_HISTORY_ROOM + 2; i++) {
        assert_int_equal(bat_editor_set(editor, "stroke-width", 2 + i % 2), BAT_OK);
        const bool told = offered(editor);
        ++*(told ? &seen : &gone);
        if (i % 50 == 0 || i >= BAT_HISTORY_ROOM - 2) {
            assert_int_equal(bat_editor_command(editor, "curve-earlier"), told ? BAT_OK : BAT_STATE);
            if (told) assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
        }
    }
    assert_true(seen >= BAT_HISTORY_STEPS - 1 && gone > 0);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_shape_is_shown),       cmocka_unit_test(what_is_kept_is_one_step),
        cmocka_unit_test(its_place_stays),           cmocka_unit_test(nothing_earlier),
        cmocka_unit_test(offered_when_there_is_one), cmocka_unit_test(what_is_dropped_is_not_offered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
