/*
 * Simplifying the selection: one step; until something else is done the tolerance can be chosen anew, which is shown
 * and then takes the step's place; Esc gives the objects back, Enter keeps them. Corners and ends stay, closed curves
 * stay closed; what is locked or has no curves is left alone. C2 has fewest points, G1 fewest cubics.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/random_surface.h"
#include "support/selecting.h"
#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>

enum { KNOTS = 40 };

/* The same curve with 40 knots more. */
static bat_curve *finer(bat_curve *curve) {
    double knots[KNOTS], domain[2];
    bat_curve *out = NULL;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < KNOTS; i++) knots[i] = domain[0] + (domain[1] - domain[0]) * (i + 0.5) / KNOTS;
    assert_int_equal(bat_curve_insert_knots(curve, KNOTS, knots, &out), BAT_OK);
    bat_curve_free(curve);
    return out;
}

/* A wave of many points, along which closer fits have more points. */
static bat_curve *wave(double y) {
    enum { N = 60 };
    double points[2 * N];
    bat_curve *out = NULL;
    for (int i = 0; i < N; i++) {
        const double t = i / (N - 1.0);
        points[2 * i] = 200 + 500 * t;
        points[2 * i + 1] = y + 40 * sin(6 * t) + 2 * sin(40 * t);
    }
    assert_int_equal(bat_curve_create_clamped(2, 3, N, points, &out), BAT_OK);
    return out;
}

/* A closed curve with two corners: a half circle, roughly, on its diameter. */
static bat_curve *closed_with_corners(void) {
    const double points[] = {300, 600, 300, 500, 500, 500, 500, 600, 433, 600, 367, 600, 300, 600};
    bat_curve *out = NULL;
    assert_int_equal(bat_curve_from_bezier(2, 3, true, 2, points, 0.05, 0, &out, NULL), BAT_OK);
    return finer(out);
}

static bat_editor *selecting(int count, bat_curve **curves) {
    bat_editor *editor = editor_with(count, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static int total(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    int points = 0;
    for (int i = 0; i < bat_document_count(document); i++)
        for (int k = 0; k < bat_object_curve_count(bat_document_at(document, i)); k++)
            points += (int)bat_curve_count(bat_object_curve(bat_document_at(document, i), k));
    return points;
}

static void says(bat_editor *editor, const char *words) {
    const char *said = bat_editor_frame(editor)->notice;
    if (!strstr(said, words)) fail_msg("%s", said);
}

static void counts(bat_editor *editor, int before, int after) {
    char wanted[64];
    const char *readings = bat_editor_readings(editor);
    snprintf(wanted, sizeof wanted, "\"points\":[%d,%d]", before, after);
    if (!strstr(readings, wanted)) fail_msg("%s, not %s", readings, wanted);
}

static void stays_near(const bat_curve *a, const bat_curve *b, double tolerance) {
    double there, back;
    assert_int_equal(bat_curve_distance(a, b, 20, &there, &back), BAT_OK);
    assert_true(fmax(there, back) <= tolerance * 1.001);
}

static void the_slider_shows_and_replaces(void **state) {
    (void)state;
    bat_editor *editor = selecting(2, (bat_curve *[]){wave(200), wave(500)});
    const uint64_t first = digest(editor);
    const int before = total(editor), steps = editor->session.history.done;
    assert_int_equal(bat_editor_refit(editor, 0.5, true), BAT_STATE);
    bat_curve *old = NULL;
    bat_curve_copy(curve(editor, 1), &old);
    only(editor, 1, 2);
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
    const uint64_t simplified = digest(editor);
    const int middle = total(editor);
    counts(editor, before, middle);
    assert_int_not_equal(bat_editor_frame(editor)->readings, 0);
    says(editor, "Simplified: ");
    stays_near(old, curve(editor, 1), 1);
    /* shown only */
    assert_int_equal(bat_editor_refit(editor, 1, false), BAT_OK);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
    assert_true(digest(editor) == simplified);
    check(editor);
    /* in place of the step */
    assert_int_equal(bat_editor_refit(editor, 1, true), BAT_OK);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
    const int few = total(editor);
    counts(editor, before, few);
    stays_near(old, curve(editor, 1), 16);
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK);
    const int many = total(editor);
    stays_near(old, curve(editor, 1), 1 / 16.0);
    if (!(few < middle && middle < many && many < before)) fail_msg("%d %d %d %d", before, many, middle, few);
    assert_int_equal(bat_editor_refit(editor, 0.5, true), BAT_OK);
    assert_true(digest(editor) == simplified);
    assert_int_equal(editor->session.history.done, steps + 1);
    assert_int_equal(bat_editor_refit(editor, NAN, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_refit(editor, -0.1, false), BAT_ARGUMENT);
    assert_int_equal(round_trip(editor, first), 1);
    assert_int_equal(bat_editor_refit(editor, 0.7, true), BAT_STATE); /* something else was done */
    bat_curve_free(old);
    bat_editor_free(editor);
}

static void esc_gives_back_and_enter_keeps(void **state) {
    (void)state;
    bat_editor *editor = selecting(1, (bat_curve *[]){wave(300)});
    const uint64_t first = digest(editor);
    only(editor, 1, 0);
    for (int shown = 0; shown < 3; shown++) {
        assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
        if (shown) assert_int_equal(bat_editor_refit(editor, 0.9, shown > 1), BAT_OK);
        assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
        assert_true(digest(editor) == first);
        assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
        assert_int_equal(bat_editor_frame(editor)->readings, 0);
        assert_int_equal(selected(editor), 1);
        assert_int_equal(editor->session.history.done, 0);
        check(editor);
    }
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
    const uint64_t simplified = digest(editor);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    assert_int_equal(bat_editor_frame(editor)->readings, 0);
    assert_int_equal(bat_editor_refit(editor, 0.9, true), BAT_STATE);
    bat_editor_command(editor, "cancel");
    assert_true(digest(editor) == simplified);
    round_trip(editor, first);
    bat_editor_free(editor);
}

static int cubics(const bat_editor *editor) {
    const bat_document *document = bat_editor_document(editor);
    int sum = 0;
    for (int i = 0; i < bat_document_count(document); i++)
        for (int k = 0; k < bat_object_curve_count(bat_document_at(document, i)); k++)
            sum += (int)bat_curve_segment_count(bat_object_curve(bat_document_at(document, i), k));
    return sum;
}

static void counts_cubics(bat_editor *editor, int joints, int before, int after) {
    char wanted[64];
    const char *readings = bat_editor_readings(editor);
    snprintf(wanted, sizeof wanted, "\"cubics\":[%d,%d]", before, after);
    if (!strstr(readings, wanted)) fail_msg("%s, not %s", readings, wanted);
    snprintf(wanted, sizeof wanted, "\"chosen\":%d", joints);
    if (!strstr(readings, wanted)) fail_msg("%s, not %s", readings, wanted);
}

/* With G1 joints the result is that of bat_curve_refit_g1: fewer cubics than C2 has, in the same step; the slider goes on
 * with them, the keys change between the two, and the choice is kept. */
static void joints_can_be_chosen(void **state) {
    (void)state;
    bat_editor *editor = selecting(1, (bat_curve *[]){wave(300)});
    const uint64_t first = digest(editor);
    const int before = cubics(editor), steps = editor->session.history.done;
    bat_curve *old = NULL, *fewest = NULL;
    bat_curve_copy(curve(editor, 1), &old);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
    const uint64_t c2 = digest(editor);
    const int c2_cubics = cubics(editor);
    counts_cubics(editor, 0, before, c2_cubics);
    assert_int_equal(bat_editor_read_as(editor, 2), BAT_ARGUMENT);
    assert_int_equal(bat_editor_read_as(editor, 1), BAT_OK);
    says(editor, "cubics");
    counts_cubics(editor, 1, before, cubics(editor));
    assert_true(cubics(editor) < c2_cubics);
    assert_int_equal(bat_curve_refit_g1(old, 1, 0.05, &fewest, NULL), BAT_OK);
    assert_true(bat_curve_is_equal(curve(editor, 1), fewest));
    stays_near(old, curve(editor, 1), 1);
    assert_int_equal(editor->session.history.done, steps + 1);
    const uint64_t g1 = digest(editor);
    check(editor);
    /* the slider and the keys */
    const int shown_before = cubics(editor);
    assert_int_equal(bat_editor_refit(editor, 1, false), BAT_OK);
    assert_true(digest(editor) == g1);
    assert_int_equal(bat_editor_refit(editor, 1, true), BAT_OK);
    assert_true(cubics(editor) < shown_before);
    assert_int_equal(bat_editor_refit(editor, 0.5, true), BAT_OK);
    assert_true(digest(editor) == g1);
    assert_true(bat_editor_key(editor, "Tab", true, 0, 0));
    assert_true(digest(editor) == c2);
    assert_true(bat_editor_key(editor, "Tab", true, BAT_SHIFT, 0));
    assert_true(digest(editor) == g1);
    assert_int_equal(editor->session.history.done, steps + 1);
    replays(editor, 0);
    /* kept */
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_read_as(editor, 0), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
    assert_true(digest(editor) == g1);
    round_trip(editor, first);
    bat_curve_free(old);
    bat_curve_free(fewest);
    bat_editor_free(editor);
}

/* The slider goes with the selection, the tool and the next change. */
static void not_for_ever(void **state) {
    (void)state;
    static const char *const ends[] = {"deselect", "tool-sketch", "curve-reverse", "undo"};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        bat_editor *editor = selecting(1, (bat_curve *[]){wave(300)});
        only(editor, 1, 0);
        assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
        assert_int_equal(bat_editor_refit(editor, 0.9, false), BAT_OK);
        assert_int_equal(bat_editor_command(editor, ends[i]), BAT_OK);
        assert_int_equal(bat_editor_refit(editor, 0.2, true), BAT_STATE);
        assert_int_equal(bat_editor_frame(editor)->readings, 0);
        assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
        check(editor);
        bat_editor_free(editor);
    }
}

static void corners_and_closed_curves(void **state) {
    (void)state;
    bat_editor *editor = selecting(1, (bat_curve *[]){closed_with_corners()});
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
    for (int i = 0; i <= 4; i++) {
        assert_int_equal(bat_editor_refit(editor, i / 4.0, true), BAT_OK);
        const bat_curve *now = curve(editor, 1);
        assert_true(bat_curve_is_closed(now));
        for (int k = 0; k < 2; k++) {
            const double corner[2] = {k ? 500 : 300, 600};
            bat_near near;
            assert_int_equal(bat_curve_nearest(now, corner, &near), BAT_OK);
            assert_true(near.distance < 1e-6);
        }
    }
    check(editor);
    bat_editor_free(editor);
}

/* Nothing selected; nothing with curves; nothing that has fewer points, with the slider all the same. */
static void what_cannot_be_simplified(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    const uint64_t first = digest(editor);
    bat_editor_command(editor, "deselect");
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_STATE);
    says(editor, "Select something first");
    only(editor, 1, 2);
    assert_int_equal(bat_editor_command(editor, "group"), BAT_OK);
    const bat_id group = editor->choice.selection.ids[0];
    for (bat_id id = 1; id <= 2; id++)
        assert_int_equal(bat_editor_set_state(editor, id, false, true), BAT_OK);
    only(editor, group, 0);
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_STATE);
    says(editor, "Not possible");
    assert_int_equal(bat_editor_frame(editor)->readings, 0);
    assert_int_equal(round_trip(editor, first), 3);
    bat_editor_free(editor);

    editor = selecting(1, (bat_curve *[]){wave(300)});
    only(editor, 1, 0);
    bat_editor_command(editor, "curve-simplify");
    bat_editor_command(editor, "accept");
    const uint64_t simple = digest(editor);
    const int points = total(editor), steps = editor->session.history.done;
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_STATE);
    says(editor, "as few points");
    counts(editor, points, points);
    assert_int_equal(bat_editor_refit(editor, 1, true), BAT_OK);
    assert_true(total(editor) < points);
    assert_int_equal(editor->session.history.done, steps + 1);
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK);
    assert_true(digest(editor) == simple);
    assert_int_equal(editor->session.history.done, steps);
    check(editor);
    bat_editor_free(editor);
}

/* In a group that is selected, what is locked or hidden stays as it is. */
static void locked_and_hidden_stay(void **state) {
    (void)state;
    bat_editor *editor = selecting(3, (bat_curve *[]){wave(200), wave(400), wave(600)});
    const int points = (int)bat_curve_count(curve(editor, 1));
    only(editor, 1, 2);
    bat_editor_select(editor, 3, true);
    assert_int_equal(bat_editor_command(editor, "group"), BAT_OK);
    const bat_id group = editor->choice.selection.ids[0];
    assert_int_equal(bat_editor_set_state(editor, 2, false, true), BAT_OK);
    assert_int_equal(bat_editor_set_state(editor, 3, true, false), BAT_OK);
    only(editor, group, 0);
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
    const int fewer = (int)bat_curve_count(curve(editor, 1));
    assert_true(fewer < points);
    assert_int_equal(bat_curve_count(curve(editor, 2)), points);
    assert_int_equal(bat_curve_count(curve(editor, 3)), points);
    counts(editor, points, fewer);
    check(editor);
    bat_editor_free(editor);
}

/* A surface is more than the curves that show it: those stay, and what is selected with it is simplified. */
static void surfaces_stay(void **state) {
    (void)state;
    random_source r = {5};
    bat_surface *surface = random_surface(&r, (const int[2]){3, 3}, (const int[2]){0, 0},
                                          (const int[2]){2, 2});
    bat_editor *editor = selecting(1, (bat_curve *[]){wave(300)});
    const bat_style style = bat_style_defaults();
    bat_object *added = NULL;
    assert_int_equal(bat_object_create_surface(7, "sheet", &style, surface, &added), BAT_OK);
    assert_int_equal(bat_transaction_begin(&editor->context), BAT_OK);
    assert_int_equal(bat_transaction_insert(&editor->context, 1, added), BAT_OK);
    assert_int_equal(bat_transaction_commit(&editor->context, BAT_STRING_STEP_CHANGE, NULL), BAT_OK);
    bat_object_release(added);
    only(editor, 7, 0);
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_STATE);
    says(editor, "Not possible");
    const int points = (int)bat_curve_count(curve(editor, 1));
    only(editor, 1, 7);
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
    assert_int_equal(bat_editor_refit(editor, 0.8, true), BAT_OK);
    assert_true((int)bat_curve_count(curve(editor, 1)) < points);
    assert_true(bat_surface_is_equal(bat_object_surface(object(editor, 7)), surface));
    check(editor);
    bat_surface_free(surface);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_slider_shows_and_replaces), cmocka_unit_test(esc_gives_back_and_enter_keeps),
        cmocka_unit_test(joints_can_be_chosen),          cmocka_unit_test(not_for_ever),
        cmocka_unit_test(corners_and_closed_curves),     cmocka_unit_test(what_cannot_be_simplified),
        cmocka_unit_test(locked_and_hidden_stay),        cmocka_unit_test(surfaces_stay)};
    return cmocka_run_group_tests_name("simplify", tests, NULL, NULL);
}
