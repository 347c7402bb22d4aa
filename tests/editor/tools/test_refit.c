/*
 * Refitting the last stroke, from raw to fair: previewed while the amount is being chosen, and one step with the
 * stroke; the fairer, the fewer points and the farther from the stroke; unchanged at the middle value; no longer
 * possible once the next stroke begins or anything else is done.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "support/editing.h"

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

static int points(const bat_editor *editor, int object) {
    return (int)bat_curve_count(bat_object_curve(bat_document_at(bat_editor_document(editor), object), 0));
}

/* x y length: with ripples that a close fit follows and a fair one does not. */
static void rippled(double t, const double *n, double out[2]) {
    out[0] = n[0] + n[2] * t;
    out[1] = n[1] - 60 * t * (1 - t) + 1.6 * sin(28 * t);
}

static void from_raw_to_fair(void **state) {
    (void)state;
    for (int over = 0; over < 2; over++) {
        bat_editor *editor = pen_editor();
        pen p = pen_for(editor);
        const uint64_t first = digest(editor);
        const int object = over ? 0 : 2;
        pen_stroke(&p, rippled, (double[]){300, over ? 206 : 400, 400}, 200);
        assert_int_equal(count(editor), over ? 2 : 3);
        const uint64_t drawn = digest(editor);
        const int middle = points(editor, object);
        assert_non_null(strstr(bat_editor_readings(editor), "\"amount\":0.5"));
        assert_int_equal(bat_editor_refit(editor, 0, false), BAT_OK);
        assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
        assert_true(digest(editor) == drawn); /* only shown */
        check(editor);
        assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK);
        assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
        assert_non_null(strstr(bat_editor_readings(editor), "\"amount\":0,"));
        const int raw = points(editor, object);
        assert_int_equal(bat_editor_refit(editor, 1, true), BAT_OK);
        const int fair = points(editor, object);
        if (!(raw >= middle && middle >= fair && raw > fair + 2)) fail_msg("%d %d %d", raw, middle, fair);
        check(editor);
        assert_int_equal(bat_editor_refit(editor, 0.5, true), BAT_OK);
        assert_int_equal(points(editor, object), middle);
        assert_int_equal(bat_editor_refit(editor, 0.75, true), BAT_OK);
        replays(editor, 0);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == first);
        assert_int_equal(bat_editor_refit(editor, 0.2, true), BAT_STATE);
        bat_editor_free(editor);
    }
}

static const bat_curve *last_curve(const bat_editor *editor) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), count(editor) - 1), 0);
}

/* The last line of the journal has the text. */
static bool recorded(const bat_editor *editor, const char *text) {
    const char *journal = bat_editor_journal(editor, NULL), *last = strrchr(journal, '{');
    for (const char *at = journal; (at = strstr(at, "\n{")) != NULL; at++) last = at;
    return strstr(last, text) != NULL;
}

static void more_or_less_is_spent_on_fairness(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_stroke(&p, rippled, (double[]){300, 400, 400}, 200);
    bat_curve *drawn = NULL;
    assert_int_equal(bat_curve_copy(last_curve(editor), &drawn), BAT_OK);
    assert_false(recorded(editor, "\"fairness\""));
    assert_int_equal(bat_editor_refit(editor, 1, true), BAT_OK);
    assert_true(recorded(editor, "\"fairness\":0.6,"));
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK);
    assert_true(recorded(editor, "\"fairness\":0.2,"));
    replays(editor, 0);
    assert_int_equal(bat_editor_refit(editor, 0.5, true), BAT_OK);
    assert_false(recorded(editor, "\"fairness\""));
    assert_true(bat_curve_is_equal(last_curve(editor), drawn));
    bat_curve_free(drawn);
    bat_editor_free(editor);
}

static void not_for_ever(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    assert_int_equal(bat_editor_refit(editor, 0.5, true), BAT_STATE);
    assert_non_null(strstr(bat_editor_readings(editor), "\"amount\":-1"));
    pen_stroke(&p, rippled, (double[]){300, 400, 400}, 200);
    assert_int_equal(bat_editor_refit(editor, NAN, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_refit(editor, 1.1, false), BAT_ARGUMENT);
    assert_int_equal(bat_editor_refit(editor, 1, false), BAT_OK);
    const uint64_t drawn = digest(editor);
    pen_begin(&p, rippled, (double[]){300, 480, 300},
              60); /* the next stroke: what was only shown is dropped */
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_STATE);
    check(editor);
    pen_event(&p, BAT_POINTER_CANCEL, 600, 480);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
    assert_true(digest(editor) == drawn);
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_STATE);
    check(editor);
    bat_editor_free(editor);
}

static int fits(const bat_editor *editor) {
    const bat_frame *frame = bat_editor_frame((bat_editor *)editor);
    int found = 0;
    for (uint32_t i = 0; i < frame->live_count; i++) found += frame->live[i].role == (uint32_t)BAT_ROLE_FIT;
    return found;
}

/* The slider shows every curve that the stroke changes, and changes nothing until it is let go; then there is still one
 * step for the stroke. */
static void check_live(bat_editor *editor, int curves, uint64_t first) {
    const uint64_t drawn = digest(editor);
    assert_int_equal(fits(editor), 0);
    for (double amount = 0; amount <= 1; amount += 0.25) {
        assert_int_equal(bat_editor_refit(editor, amount, false), BAT_OK);
        assert_int_equal(fits(editor), curves);
        assert_true(digest(editor) == drawn);
        check(editor);
    }
    assert_int_equal(bat_editor_refit(editor, 0.1, true), BAT_OK);
    assert_int_equal(fits(editor), 0);
    replays(editor, 0);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

static void live_over_a_join_and_several_curves(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_stroke(&p, pen_arch, (double[]){800, 200, 800, 600, 120}, 80);
    assert_int_equal(count(editor), 1);
    check_live(editor, 1, first);
    editor = editor_with(2, (bat_curve *[]){pen_curve(200, 300, 30, 0, 11), pen_curve(500, 300, 30, 0, 11)});
    first = digest(editor), p = pen_for(editor);
    pen_stroke(&p, rippled, (double[]){350, 308, 300}, 200);
    assert_int_equal(count(editor), 2);
    check_live(editor, 2, first);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(from_raw_to_fair), cmocka_unit_test(more_or_less_is_spent_on_fairness),
        cmocka_unit_test(not_for_ever), cmocka_unit_test(live_over_a_join_and_several_curves)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
