/*
 * A level that is dragged holds its curve's length and area by their switches, and places and directions by pins; each drag is one step that
 * can be undone and replayed; where it cannot go on, the curve goes as far as it can.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include "support/selecting.h"
#include <batten/levels.h>
#include <batten/measure.h>
#include <batten/nearest.h>

static const double TURN = 6.283185307179586;

static bat_curve *oval(double x, double y, double radius, double rough) {
    enum { N = 24 };
    double points[2 * N], knots[N + 1];
    bat_curve *out;
    for (int i = 0; i < N; i++) {
        const double r = radius + (i % 2 ? rough : 0);
        points[2 * i] = x + r * cos(TURN * i / N), points[2 * i + 1] = y + 0.6 * r * sin(TURN * i / N);
    }
    for (int i = 0; i <= N; i++) knots[i] = i;
    assert_int_equal(bat_curve_create(2, 3, true, N, points, N + 1, knots, &out), BAT_OK);
    return out;
}

/* A ring of 24 points around (400, 400), taken apart; others beside it, the first of which may be a part of it. */
static bat_editor *ring_with(int others, bool one) {
    bat_curve *curves[3] = {oval(400, 400, 200, 8), oval(540, 400, 25, 0), oval(680, 400, 40, 0)};
    for (int k = others + 1; k < 3; k++) bat_curve_free(curves[k]);
    bat_editor *editor = editor_with(others + 1, curves);
    if (one) {
        only(editor, 1, 2);
        assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
        assert_int_equal(bat_editor_command(editor, "combine"), BAT_OK);
    }
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "tool-levels"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    assert_non_null(bat_object_shape(object(editor, 1), 0));
    return editor;
}

static bat_editor *ring(void) { return ring_with(0, false); }

static double length(const bat_editor *editor) {
    double domain[2];
    bat_curve_domain(curve(editor, 1), domain);
    return bat_curve_length(curve(editor, 1), domain[0], domain[1], 1e-13);
}

static double area(const bat_editor *editor) { return bat_curve_area(curve(editor, 1)); }

/* Drags the place at that share of the ring by (x, y). */
static void pull(bat_editor *editor, pen *p, double share, double x, double y) {
    double domain[2], at[2];
    bat_curve_domain(curve(editor, 1), domain);
    bat_curve_eval(curve(editor, 1), domain[0] + share * (domain[1] - domain[0]), 0, at);
    drag(p, at[0], at[1], at[0] + x, at[1] + y);
    check(editor);
}

static void lengths_and_areas_stay(void **state) {
    (void)state;
    for (int way = 0; way < 4; way++) { /* neither, length, area, both */
        bat_editor *editor = ring();
        pen p = mouse(editor);
        const double before[2] = {length(editor), area(editor)};
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_set(editor, "hold-length", way & 1), BAT_OK);
        assert_int_equal(bat_editor_set(editor, "hold-area", way >> 1), BAT_OK);
        pull(editor, &p, 0.13, 15, 8);
        assert_true(digest(editor) != first);
        assert_int_equal(fabs(length(editor) - before[0]) <= 1e-9 * 400, way & 1);
        assert_int_equal(fabs(area(editor) - before[1]) <= 1e-9 * 160000, way >> 1);
        replays(editor, 0);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
}

static double lopsided(const bat_editor *editor) {
    const bat_curve *ring_now = curve(editor, 1);
    double worst = 0;
    for (size_t i = 0; i < bat_curve_count(ring_now); i++) {
        bat_near near;
        double at[2];
        bat_curve_eval(ring_now, (double)i, 0, at);
        at[0] = 800 - at[0];
        assert_int_equal(bat_curve_nearest(ring_now, at, &near), BAT_OK);
        worst = fmax(worst, near.distance);
    }
    return worst;
}

/* About the upright axis of the ring, at every level; what lies on the axis moves along it. */
static void symmetry_stays(void **state) {
    (void)state;
    for (int held = 0; held < 2; held++) {
        bat_editor *editor = ring();
        pen p = mouse(editor);
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_set(editor, "hold-symmetry", held), BAT_OK);
        for (int level = 0; level < 3; level++) {
            pull(editor, &p, 0.05 + 0.07 * level, 12, 9 - 5 * level);
            assert_int_equal(lopsided(editor) <= 1e-9 * 400, held);
            assert_int_equal(bat_editor_command(editor, "level-up"), BAT_OK);
        }
        replays(editor, 0);
        for (int level = 0; level < 3; level++) assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
}

/* A curve that has no symmetry is dragged as ever, and that is said when it is to be held. */
static void what_is_not_symmetric(void **state) {
    (void)state;
    bat_editor *editor = ring();
    pen p = mouse(editor);
    pull(editor, &p, 0.13, 15, 8);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_set(editor, "hold-symmetry", 1), BAT_OK);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "Symmetry"));
    pull(editor, &p, 0.4, 5, 8);
    assert_true(digest(editor) != first);
    bat_editor_free(editor);
}

static void place_at(const bat_editor *editor, double u, double jet[4]) {
    bat_curve_eval(curve(editor, 1), u, 1, jet);
}

static void twice(pen *p, double x, double y) {
    tap(p, x, y);
    p->time -= 900; /* soon */
    tap(p, x, y);
}

static void pins_hold(void **state) {
    (void)state;
    bat_editor *editor = ring();
    pen p = mouse(editor);
    double domain[2], before[4], after[4];
    bat_curve_domain(curve(editor, 1), domain);
    const double u = domain[0] + 0.3 * (domain[1] - domain[0]);
    place_at(editor, u, before);
    const uint64_t first = digest(editor);
    for (int taps = 1; taps <= 3; taps++) { /* the place; its direction, too; neither */
        p.time += 2000;
        twice(&p, before[0], before[1]);
        assert_true(digest(editor) == first);
        pull(editor, &p, 0.22, -14, 22);
        place_at(editor, u, after);
        const bool held = hypot(after[0] - before[0], after[1] - before[1]) <=
                          0.5; /* of the pixel that was hit */
        const double turn = (before[2] * after[3] - before[3] * after[2]) /
                            (hypot(before[2], before[3]) * hypot(after[2], after[3]));
        assert_int_equal(held, taps < 3);
        assert_int_equal(fabs(turn) <= 0.005, taps == 2);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == first);
    }
    bat_editor_free(editor);
}

static double middle_of(const bat_curve *of) {
    double low[2], high[2];
    bat_curve_bounds(of, low, high);
    return (low[0] + high[0]) / 2;
}

/* What is selected with the outline goes along where it is near; what is not stays, and so does all in a step that is taken back. */
static void what_is_selected_with_it_goes_along(void **state) {
    (void)state;
    for (int with = 0; with < 2; with++) {
        bat_editor *editor = ring_with(2, false);
        pen p = mouse(editor);
        const double before[2] = {middle_of(curve(editor, 2)), middle_of(curve(editor, 3))};
        const uint64_t first = digest(editor);
        only(editor, 1, with ? 3 : 0);
        pull(editor, &p, 0.085, 30, 0); /* at the right */
        assert_true(digest(editor) != first && selected(editor) == 1 + with);
        assert_true(middle_of(curve(editor, 2)) == before[0]);
        assert_int_equal(middle_of(curve(editor, 3)) > before[1] + 5, with);
        if (!with) assert_true(middle_of(curve(editor, 3)) == before[1]);
        replays(editor, 0);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
}

static void islands_go_along(void **state) {
    (void)state;
    bat_editor *editor = ring_with(1, true);
    pen p = mouse(editor);
    const uint64_t first = digest(editor);
    const double before = middle_of(bat_object_curve(object(editor, 1), 1));
    pull(editor, &p, 0.085, 30, 0);
    assert_true(middle_of(bat_object_curve(object(editor, 1), 1)) > before + 1);
    assert_non_null(bat_object_shape(object(editor, 1), 0));
    replays(editor, 0);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* A drag of one jump to where the length cannot go comes as far as one of many steps: how often the pen is seen makes no difference. */
static void a_jump_goes_as_far_as_steps(void **state) {
    (void)state;
    uint64_t ends[2];
    for (int way = 0; way < 2; way++) {
        bat_editor *editor = ring();
        pen p = mouse(editor);
        const double before = length(editor);
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_set(editor, "hold-length", 1), BAT_OK);
        double domain[2], at[2];
        bat_curve_domain(curve(editor, 1), domain);
        bat_curve_eval(curve(editor, 1), domain[0] + 0.13 * (domain[1] - domain[0]), 0, at);
        pen_event(&p, BAT_POINTER_DOWN, at[0], at[1]);
        for (int i = way ? 1 : 40; i <= 40; i++) {
            pen_event(&p, BAT_POINTER_MOVE, at[0] + 20.0 * i, at[1] + 10.0 * i);
            bat_editor_frame(editor);
        }
        pen_event(&p, BAT_POINTER_UP, at[0] + 800, at[1] + 400);
        check(editor);
        ends[way] = digest(editor);
        assert_true(ends[way] != first);
        assert_true(fabs(length(editor) - before) <= 1e-9 * 400);
        replays(editor, 0);
        bat_editor_free(editor);
    }
    assert_true(ends[0] == ends[1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths_and_areas_stay),
        cmocka_unit_test(symmetry_stays),
        cmocka_unit_test(what_is_not_symmetric),
        cmocka_unit_test(pins_hold),
        cmocka_unit_test(what_is_selected_with_it_goes_along),
        cmocka_unit_test(islands_go_along),
        cmocka_unit_test(a_jump_goes_as_far_as_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
