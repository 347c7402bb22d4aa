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
#include <batten/nearest.h>

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

static bat_id id_of(const bat_editor *editor, int object) {
    return bat_object_id(bat_document_at(bat_editor_document(editor), object));
}

static bool offers(bat_editor *editor, const char *amount) {
    bat_editor_frame(editor);
    return strstr(bat_editor_readings(editor), amount) != NULL;
}

/* Selecting a line that was drawn earlier offers its stroke again; refitting it is one step of its own, however often the
 * slider is let go, and touches nothing else. */
static void kept_while_others_are_drawn(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_stroke(&p, rippled, (double[]){300, 330, 400}, 200);
    pen_stroke(&p, rippled, (double[]){300, 470, 400}, 200);
    assert_int_equal(count(editor), 4);
    const uint64_t drawn = digest(editor);
    const int middle = points(editor, 2), last = points(editor, 3);
    assert_int_equal(bat_editor_select(editor, id_of(editor, 0), false), BAT_OK);
    assert_true(offers(editor, "\"amount\":0.5")); /* of the last stroke: this line was not drawn */
    assert_int_equal(bat_editor_select(editor, id_of(editor, 2), false), BAT_OK);
    assert_true(offers(editor, "\"chosen\":-1,\"amount\":0.5"));
    assert_int_equal(bat_editor_refit(editor, NAN, false), BAT_ARGUMENT);
    assert_int_equal(bat_editor_refit(editor, 0, false), BAT_OK);
    assert_int_equal(fits(editor), 1);
    assert_true(digest(editor) == drawn);
    assert_int_equal(bat_editor_refit(editor, 1, true), BAT_OK);
    assert_int_equal(fits(editor), 0);
    assert_true(offers(editor, "\"amount\":1,"));
    const int fair = points(editor, 2);
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK);
    const int raw = points(editor, 2);
    if (!(raw >= middle && middle >= fair && raw > fair + 2)) fail_msg("%d %d %d", raw, middle, fair);
    assert_int_equal(points(editor, 3), last);
    replays(editor, 0);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == drawn);
    assert_true(offers(editor, "\"amount\":0.5")); /* as it was drawn */
    assert_int_equal(bat_editor_refit(editor, 0.5, true), BAT_OK);
    assert_true(digest(editor) == drawn); /* as it is already */
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_true(offers(editor, "\"amount\":0,"));
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    for (int i = 0; i < 2; i++) assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == first);
    assert_true(offers(editor, "\"amount\":-1"));
    assert_int_equal(bat_editor_refit(editor, 0.5, true), BAT_STATE);
    bat_editor_free(editor);
}

/* It ends when the object moves and comes back with undo; what happens elsewhere on the curve does not end it, and stays;
 * another document has nothing of it. */
static void kept_until_the_stretch_changes(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    pen_stroke(&p, rippled, (double[]){250, 206, 250}, 200);
    pen_stroke(&p, rippled, (double[]){300, 450, 400}, 100);
    const int drawn = points(editor, 0);
    assert_int_equal(bat_editor_select(editor, id_of(editor, 0), false), BAT_OK);
    assert_true(offers(editor, "\"chosen\":-1,\"amount\":0.5"));
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "nudge-right"), BAT_OK);
    assert_true(offers(editor, "\"amount\":-1"));
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(offers(editor, "\"amount\":0.5"));
    assert_int_equal(bat_editor_command(editor, "tool-eraser"), BAT_OK);
    drag(&p, 790, 160, 790, 240);
    const bat_curve *curve = bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0);
    bat_near near;
    assert_int_equal(bat_curve_nearest(curve, (double[]){790, 200}, &near), BAT_OK);
    const double gap = near.distance;
    assert_true(gap > 1);
    assert_int_equal(bat_editor_select(editor, id_of(editor, 0), false), BAT_OK);
    assert_true(offers(editor, "\"amount\":0.5"));
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK);
    assert_true(points(editor, 0) > drawn);
    assert_int_equal(bat_editor_refit(editor, 0.1, true), BAT_OK);
    curve = bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0);
    assert_int_equal(bat_curve_nearest(curve, (double[]){790, 200}, &near), BAT_OK);
    assert_true(fabs(near.distance - gap) < 1e-6);
    replays(editor, 0);
    bat_document *other = NULL;
    assert_int_equal(bat_document_copy(bat_editor_document(editor), &other), BAT_OK);
    assert_int_equal(bat_editor_open(editor, other, "test"), BAT_OK);
    assert_int_equal(bat_editor_select(editor, id_of(editor, 0), false), BAT_OK);
    assert_true(offers(editor, "\"amount\":-1"));
    bat_editor_free(editor);
}

/* Joins and several curves: each as it was before, and one step for all. */
static void kept_over_a_join_and_several_curves(void **state) {
    (void)state;
    for (int several = 0; several < 2; several++) {
        bat_editor *editor = several ? editor_with(2, (bat_curve *[]){pen_curve(200, 300, 30, 0, 11),
                                                                      pen_curve(500, 300, 30, 0, 11)})
                                     : pen_editor();
        pen p = pen_for(editor);
        if (several)
            pen_stroke(&p, rippled, (double[]){350, 308, 300}, 200);
        else
            pen_stroke(&p, pen_arch, (double[]){800, 200, 800, 600, 120}, 80);
        const int objects = count(editor);
        pen_stroke(&p, rippled, (double[]){300, 720, 400}, 100);
        const uint64_t drawn = digest(editor);
        assert_int_equal(count(editor), objects + 1);
        assert_int_equal(bat_editor_select(editor, id_of(editor, objects - 1), false), BAT_OK);
        assert_true(offers(editor, "\"chosen\":-1,\"amount\":0.5"));
        assert_int_equal(bat_editor_refit(editor, 0.1, false), BAT_OK);
        assert_int_equal(fits(editor), several + 1);
        assert_int_equal(bat_editor_refit(editor, 0.1, true), BAT_OK);
        assert_int_equal(count(editor), objects + 1);
        assert_true(digest(editor) != drawn);
        replays(editor, 0);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == drawn);
        check(editor);
        bat_editor_free(editor);
    }
}

/* More strokes than are kept: the oldest is settled. */
static void not_all_are_kept(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    for (int i = 0; i < 40; i++) {
        pen_stroke(&p, pen_arch, (double[]){20 + 24 * i, 260, 20 + 24 * i, 520, 0}, 30);
        assert_int_equal(count(editor), 3 + i);
    }
    pen_stroke(&p, pen_arch, (double[]){100, 700, 500, 700, 30}, 30);
    assert_int_equal(bat_editor_select(editor, id_of(editor, 2), false), BAT_OK);
    bat_editor_frame(editor);
    assert_null(strstr(bat_editor_readings(editor), "\"chosen\":-1,\"amount\":0.5"));
    assert_int_equal(bat_editor_select(editor, id_of(editor, 41), false), BAT_OK);
    assert_true(offers(editor, "\"chosen\":-1,\"amount\":0.5"));
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(from_raw_to_fair),
                                       cmocka_unit_test(more_or_less_is_spent_on_fairness),
                                       cmocka_unit_test(not_for_ever),
                                       cmocka_unit_test(live_over_a_join_and_several_curves),
                                       cmocka_unit_test(kept_while_others_are_drawn),
                                       cmocka_unit_test(kept_until_the_stretch_changes),
                                       cmocka_unit_test(kept_over_a_join_and_several_curves),
                                       cmocka_unit_test(not_all_are_kept)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
