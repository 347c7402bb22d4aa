/*
 * A level that is dragged holds its curve's length and area by their switches, and places and directions by pins; each drag is one step that
 * can be undone and replayed; where it cannot go on, the curve stays where it came to.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <cmocka.h>
#include "support/selecting.h"
#include <batten/levels.h>
#include <batten/measure.h>

static const double TURN = 6.283185307179586;

/* A ring of 24 points around (400, 400), taken apart. */
static bat_editor *ring(void) {
    enum { N = 24 };
    double points[2 * N], knots[N + 1];
    bat_curve *curve;
    for (int i = 0; i < N; i++) {
        const double r = 200 + (i % 2 ? 8 : 0);
        points[2 * i] = 400 + r * cos(TURN * i / N), points[2 * i + 1] = 400 + 0.6 * r * sin(TURN * i / N);
    }
    for (int i = 0; i <= N; i++) knots[i] = i;
    assert_int_equal(bat_curve_create(2, 3, true, N, points, N + 1, knots, &curve), BAT_OK);
    bat_editor *editor = editor_with(1, &curve);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "tool-levels"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    assert_non_null(bat_object_shape(object(editor, 1), 0));
    return editor;
}

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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths_and_areas_stay),
        cmocka_unit_test(pins_hold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
