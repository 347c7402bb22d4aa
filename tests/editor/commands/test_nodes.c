/*
 * Points at extremes and inflections leave the shape as it is and are full knots there, by one step; where there are some already nothing
 * happens, and curves with levels keep them. A line drawn or redrawn on extremes is in whole numbers, with level and upright handles, and
 * so it is when it is replayed.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <math.h>
#include <cmocka.h>
#include "support/selecting.h"
#include <batten/measure.h>

static const double TURN = 6.283185307179586;

/* An oval, turned; and a wave that is open. */
static bat_editor *shapes(void) {
    enum { N = 10 };
    double points[2 * N], knots[N + 1];
    const double wave[16] = {100, 600, 200, 500, 300, 500, 400, 600, 500, 700, 600, 700, 700, 600, 800, 650};
    bat_curve *curves[2];
    for (int i = 0; i < N; i++) {
        const double x = 200 * cos(TURN * i / N), y = 120 * sin(TURN * i / N);
        points[2 * i] = 400 + x * 0.8 - y * 0.6, points[2 * i + 1] = 250 + x * 0.6 + y * 0.8;
    }
    for (int i = 0; i <= N; i++) knots[i] = i;
    assert_int_equal(bat_curve_create(2, 3, true, N, points, N + 1, knots, &curves[0]), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(2, 3, 8, wave, &curves[1]), BAT_OK);
    bat_editor *editor = editor_with(2, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static int full_knots(const bat_curve *curve) {
    const double *t = bat_curve_knots(curve);
    int full = 0;
    for (int i = 0; i + 2 < bat_curve_knot_count(curve); i++) full += t[i] == t[i + 1] && t[i] == t[i + 2];
    return full;
}

static void points_are_added(void **state) {
    (void)state;
    static const char *const commands[2] = {"points-at-extremes", "points-at-inflections"};
    for (int k = 0; k < 2; k++) {
        bat_editor *editor = shapes();
        const uint64_t first = digest(editor);
        bat_curve *before;
        double there, back, u[16];
        const bat_id id = k ? 2 : 1;
        only(editor, id, 0);
        assert_int_equal(bat_curve_copy(curve(editor, id), &before), BAT_OK);
        const size_t wanted = k ? bat_curve_inflections(before, 16, u)
                                : bat_curve_extremes(before, 0, 16, u) + bat_curve_extremes(before, 1, 16, u);
        assert_true(wanted >= (k ? 1 : 4));
        assert_non_null(strstr(bat_editor_actions(editor), commands[k]));
        assert_int_equal(bat_editor_command(editor, commands[k]), BAT_OK);
        const bat_curve *after = curve(editor, id);
        assert_int_equal(full_knots(after),
                         (int)wanted + (k ? 4 : 0)); /* an open curve's ends: twice four alike */
        assert_int_equal(bat_curve_distance(before, after, 20, &there, &back), BAT_OK);
        assert_true(fmax(there, back) < 1e-10 * 400);
        const uint64_t once = digest(editor);
        assert_int_equal(bat_editor_command(editor, commands[k]), BAT_STATE);
        assert_true(digest(editor) == once);
        bat_curve_free(before);
        goes_back_and_replays(editor, first);
        bat_editor_free(editor);
    }
}

static void levels_stay(void **state) {
    (void)state;
    bat_editor *editor = shapes();
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "tool-levels"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    assert_non_null(bat_object_shape(object(editor, 1), 0));
    const uint64_t before = digest(editor);
    assert_int_equal(bat_editor_command(editor, "points-at-extremes"), BAT_STATE);
    assert_true(digest(editor) == before);
    bat_editor_free(editor);
}

/* x y radius, once around. */
static void round_and_round(double t, const double *n, double out[2]) {
    out[0] = n[0] + n[2] * cos(TURN * t * 1.01), out[1] = n[1] + 1.3 * n[2] * sin(TURN * t * 1.01);
}

/* x y height: over the top of that oval, bulging. */
static void over_the_top(double t, const double *n, double out[2]) {
    const double w = TURN * (0.58 + 0.34 * t);
    out[0] = n[0] + 100 * cos(w), out[1] = n[1] + 130 * sin(w) - n[2] * sin(TURN * t / 2);
}

/* All of its points whole, and four of them or more on extremes. */
static void is_whole(const bat_curve *curve) {
    const double *p = bat_curve_points(curve);
    const int n = (int)bat_curve_count(curve);
    int level = 0;
    for (int i = 0; i < 2 * n; i++) assert_true(p[i] == round(p[i]));
    for (int i = 2; i < n; i += 3)
        for (int c = 0; c < 2; c++)
            level += p[2 * i - 2 + c] == p[2 * i + c] && p[2 * i + c] == p[2 * ((i + 1) % n) + c];
    assert_true(bat_curve_is_closed(curve) && level >= 4 && n % 3 == 0 && n <= 24);
}

static void strokes_come_on_extremes(void **state) {
    (void)state;
    bat_editor *editor = shapes();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    assert_int_equal(bat_editor_command(editor, "tool-sketch"), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "on-extremes", 1), BAT_OK);
    pen_stroke(&p, round_and_round, (double[]){1000.3, 300.4, 100}, 160);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 3);
    is_whole(curve(editor, 3));
    assert_int_equal(bat_curve_count(curve(editor, 3)), 12); /* an oval is four cubics */
    pen_stroke(&p, over_the_top, (double[]){1000.3, 300.4, 12}, 90);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 3);
    is_whole(curve(editor, 3));
    check(editor);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

/* x y: from the stem over the top, around and back to the stem; a hand's tremble of half a unit. */
static void bowl(double t, const double *n, double out[2]) {
    const double w = TURN * (0.55 * t - 0.275), far = 1 + 0.003 * sin(TURN * 9 * t) * sin(TURN * 4.3 * t);
    out[0] = n[0] + 120 * far * cos(w), out[1] = n[1] + 150 * far * sin(w);
}

/* The bowl of a b takes three actions: the tool, the option, one stroke. It has four cubics at most, and the three extremes that a bowl
 * has are points of it, in whole numbers, with level and upright handles. */
static void a_bowl_takes_one_stroke(void **state) {
    (void)state;
    for (int size = 0; size < 3; size++) {
        bat_editor *editor = shapes();
        pen p = pen_for(editor);
        int actions = 0, extremes = 0;
        actions++, assert_int_equal(bat_editor_command(editor, "tool-sketch"), BAT_OK);
        actions++, assert_int_equal(bat_editor_set(editor, "on-extremes", 1), BAT_OK);
        actions++, pen_stroke(&p, bowl, (double[]){980.3 + 13.7 * size, 300.4 - 7.3 * size}, 120);
        assert_true(actions <= 4);
        const bat_curve *made = curve(editor, 3);
        const int n = (int)bat_curve_count(made);
        const double *at = bat_curve_points(made);
        assert_true(!bat_curve_is_closed(made) && n % 3 == 1 && n <= 13);
        for (int i = 0; i < 2 * n; i++) assert_true(at[i] == round(at[i]));
        for (int i = 3; i + 3 < n; i += 3)
            for (int c = 0; c < 2; c++)
                extremes += at[2 * i - 2 + c] == at[2 * i + c] && at[2 * i + c] == at[2 * i + 2 + c];
        assert_int_equal(extremes, 3);
        for (int axis = 0; axis < 2; axis++) { /* no extreme lies elsewhere */
            double u[8];
            const size_t count = bat_curve_extremes(made, axis, 8, u);
            assert_int_equal(count, axis ? 2 : 1);
            for (size_t i = 0; i < count; i++) {
                double place[2];
                int joint = 0;
                bat_curve_eval(made, u[i], 0, place);
                for (int k = 3; k + 3 < n; k += 3)
                    joint += hypot(at[2 * k] - place[0], at[2 * k + 1] - place[1]) < 1e-9;
                assert_int_equal(joint, 1);
            }
        }
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_added),
        cmocka_unit_test(levels_stay),
        cmocka_unit_test(strokes_come_on_extremes),
        cmocka_unit_test(a_bowl_takes_one_stroke),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
