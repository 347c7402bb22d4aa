/* Curves pulled and control points dragged: the pulled point goes where it should, ends stay, smooth nodes stay smooth.
 * */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "curve/curve.h"
#include "editor/edit/pull.h"
#include "editor/edit/smooth_node.h"
#include "support/editing.h"
#include "support/random_curve.h"

static double apart(const double *a, const double *b) { return hypot(a[0] - b[0], a[1] - b[1]); }

static void place(const bat_curve *curve, double u, double out[2]) { bat_curve_eval(curve, u, 0, out); }

/* A pull of one or two places of random curves of every degree, clamped, with free ends, closed: the places come to
 * where they are to, the ends of open curves stay; what the places do not hang on, and no node beside it, is the same
 * to the bit. */
static void ends_stay(void **state) {
    (void)state;
    random_source r = {11};
    int pulled = 0;
    for (int round = 0; round < 6000; round++) {
        int p = 1 + round % 7, kind = round / 7 % 3;
        bat_curve *curve = random_curve(&r, p, 2, kind, 2 * p + round % 5), *moved = NULL;
        double domain[2], u[2], delta[4] = {3, -4, 0, 0}, before[2], after[2];
        bat_curve_domain(curve, domain);
        int count = p > 1 ? 1 + round % 2 : 1; /* two places of a polygon may leave nothing free */
        for (int k = 0; k < 2; k++) u[k] = random_between(&r, domain[0], domain[1]);
        if (bat_pull(curve, count, u, delta, &moved) == BAT_OK) {
            double worst = 0;
            for (int i = 0; i < bat_point_count(curve); i++)
                worst = fmax(worst, apart(bat_curve_points(curve) + 2 * i, bat_curve_points(moved) + 2 * i));
            double near = 1e-11 * (10 + worst);
            for (int k = 0; k < count; k++) {
                place(curve, u[k], before);
                place(moved, u[k], after);
                for (int c = 0; c < 2; c++) assert_true(fabs(after[c] - before[c] - delta[2 * k + c]) < near);
            }
            for (int side = 0; side < 2 && kind != 2; side++) {
                place(curve, domain[side], before);
                place(moved, domain[side], after);
                assert_true(apart(before, after) < near);
                int end = side ? bat_point_count(curve) - 1 : 0;
                if (kind == 0)
                    assert_memory_equal(bat_curve_points(moved) + 2 * end, bat_curve_points(curve) + 2 * end,
                                        2 * sizeof(double));
            }
            assert_memory_equal(bat_curve_knots(moved), bat_curve_knots(curve),
                                (size_t)bat_curve_knot_count(curve) * sizeof(double));
            pulled++;
        }
        bat_curve_free(moved);
        bat_curve_free(curve);
    }
    assert_true(pulled > 5800);
}

/* An end that is pulled goes along, and the other one stays; a line has nothing else to give. */
static void an_end_that_is_pulled_moves(void **state) {
    (void)state;
    bat_curve *curve = pen_curve(0, 0, 10, 5, 9), *moved = NULL;
    double domain[2], delta[2] = {2, 7};
    bat_curve_domain(curve, domain);
    for (int side = 0; side < 2; side++) {
        assert_int_equal(bat_pull(curve, 1, &domain[side], delta, &moved), BAT_OK);
        for (int i = 0; i < 9; i++) {
            bool end = i == (side ? 8 : 0);
            assert_true(fabs(bat_curve_points(moved)[2 * i] - bat_curve_points(curve)[2 * i] - 2 * end) <
                        1e-12);
        }
        bat_curve_free(moved);
    }
    bat_curve_free(curve);
    const double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 10, 0};
    double middle = 0.5, after[2];
    assert_int_equal(bat_curve_create(2, 1, false, 2, points, 4, knots, &curve), BAT_OK);
    assert_int_equal(bat_pull(curve, 1, &middle, delta, &moved), BAT_OK);
    place(moved, 0.5, after);
    assert_true(fabs(after[0] - 7) < 1e-12 && fabs(after[1] - 7) < 1e-12);
    bat_curve_free(moved);
    bat_curve_free(curve);
}

/* A chain of segments whose inner nodes are exactly smooth but for rounding, or turn by `turn`; handles of every ratio,
 * spans of any length. Closed: a knot of full multiplicity at the seam too. */
static bat_curve *chain(random_source *r, int degree, bool closed, int segments, double turn) {
    double points[160], knots[100];
    int n = closed ? segments * degree : segments * degree + 1;
    for (int i = 0; i < n; i++) {
        double angle = 6.283185307179586 * i / n;
        points[2 * i] = closed ? 300 * cos(angle) : 40.0 * i;
        points[2 * i + 1] = closed ? 300 * sin(angle) : 0;
        for (int c = 0; c < 2; c++) points[2 * i + c] += random_between(r, -12, 12);
    }
    int on = closed ? degree - 1 : degree; /* closed: P_i has knots t_{i+1}..t_{i+p} */
    for (int k = 0; k < (closed ? segments : segments - 1); k++) {
        double *at = points + 2 * (on + degree * k), *in = at - 2,
               *out = points + 2 * ((on + degree * k + 1) % n);
        double length = hypot(at[0] - in[0], at[1] - in[1]), ratio = exp(random_between(r, -1.5, 1.5));
        double x = (at[0] - in[0]) / length * ratio * 20, y = (at[1] - in[1]) / length * ratio * 20;
        out[0] = at[0] + x * cos(turn) - y * sin(turn);
        out[1] = at[1] + x * sin(turn) + y * cos(turn);
    }
    double t = 0;
    int knot = 0;
    if (!closed) knots[knot++] = 0;
    for (int k = 0; k < segments; k++) {
        for (int i = 0; i < degree; i++) knots[knot++] = t;
        t += random_between(r, 0.3, 2);
    }
    for (int i = 0; i < (closed ? 1 : degree + 1); i++) knots[knot++] = t;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, degree, closed, (size_t)n, points, closed ? n + 1 : n + degree + 1,
                                      knots, &curve),
                     BAT_OK);
    return curve;
}

/* The sine of the greatest turn at a node; 2 when a handle has turned back. */
static double greatest_turn(const bat_curve *curve, int segments) {
    int p = bat_curve_degree(curve), n = bat_point_count(curve);
    bool closed = bat_curve_is_closed(curve);
    double worst = 0;
    for (int k = 0; k < (closed ? segments : segments - 1); k++) {
        int on = (closed ? p - 1 : p) + p * k;
        const double *points = bat_curve_points(curve), *at = points + 2 * on, *in = at - 2,
                     *out = points + 2 * ((on + 1) % n);
        double a[2] = {at[0] - in[0], at[1] - in[1]}, b[2] = {out[0] - at[0], out[1] - at[1]};
        double size = hypot(a[0], a[1]) * hypot(b[0], b[1]);
        if (!(size > 1e-9)) continue;
        worst = fmax(worst, a[0] * b[0] + a[1] * b[1] > 0 ? fabs(a[0] * b[1] - a[1] * b[0]) / size : 2);
    }
    return worst;
}

/* Pulled at any place, dragged at any point, again and again: nodes that were smooth are. */
static void smooth_nodes_stay_smooth(void **state) {
    (void)state;
    random_source r = {5};
    for (int round = 0; round < 1500; round++) {
        bool closed = round % 2;
        int degree = 3 + round / 2 % 3, segments = (closed ? 1 : 2) + round / 6 % 5;
        bat_curve *curve = chain(&r, degree, closed, segments, 0), *next = NULL;
        assert_true(greatest_turn(curve, segments) < 1e-9);
        for (int i = 0; i < 12; i++) {
            double domain[2], u, delta[2] = {random_between(&r, -9, 9), random_between(&r, -9, 9)};
            bat_curve_domain(curve, domain);
            u = random_between(&r, domain[0] + 0.03, domain[1] - 0.03);
            int point = random_int(&r, 0, bat_point_count(curve) - 1);
            bat_status status = i % 2 ? bat_pull(curve, 1, &u, delta, &next)
                                      : bat_pull_point(curve, point, delta, false, &next);
            assert_int_equal(status, BAT_OK);
            if (greatest_turn(next, segments) > 1e-7)
                fail_msg("round %d, step %d: turns by %g", round, i, greatest_turn(next, segments));
            bat_curve_free(curve);
            curve = next;
        }
        bat_curve_free(curve);
    }
}

/* A handle keeps its length when its opposite turns it; a node takes both along; alone, nothing else moves; a corner is
 * none of this, nor are ends and points of knots that are simple. */
static void points_of_nodes(void **state) {
    (void)state;
    random_source r = {3};
    for (int round = 0; round < 200; round++) {
        bool corner = round % 4 == 3;
        bat_curve *curve = chain(&r, 3, false, 3, corner ? 0.2 : round % 4 * 0.02), *moved = NULL;
        const double *old = bat_curve_points(curve);
        double delta[2] = {random_between(&r, -9, 9), random_between(&r, -9, 9)};
        for (int i = 0; i < 10; i++)
            for (int alone = 0; alone < 2; alone++) {
                bat_smooth_node node;
                bool tied = bat_smooth_node_of(curve, i, &node);
                assert_int_equal(tied, !corner && i >= 2 && i <= 7);
                assert_int_equal(bat_pull_point(curve, i, delta, alone, &moved), BAT_OK);
                const double *now = bat_curve_points(moved);
                for (int k = 0; k < 10; k++) {
                    double went[2] = {now[2 * k] - old[2 * k], now[2 * k + 1] - old[2 * k + 1]};
                    bool goes = k == i || (tied && !alone && i == node.on && (k == node.in || k == node.out));
                    bool turns = tied && !alone && i != node.on && (k == node.in || k == node.out) && k != i;
                    if (goes)
                        assert_true(apart(went, delta) < 1e-10);
                    else if (turns)
                        assert_true(fabs(apart(now + 2 * k, now + 2 * node.on) -
                                         apart(old + 2 * k, old + 2 * node.on)) < 1e-9);
                    else
                        assert_true(went[0] == 0 && went[1] == 0);
                }
                bat_curve_free(moved);
            }
        bat_curve_free(curve);
    }
    bat_curve *plain = pen_curve(0, 0, 10, 5, 9);
    bat_smooth_node node;
    for (int i = 0; i < 9; i++) assert_false(bat_smooth_node_of(plain, i, &node));
    bat_curve_free(plain);
}

/* A handle that is put onto its node, and one that is huge: nothing breaks. */
static void odd_handles(void **state) {
    (void)state;
    random_source r = {4};
    bat_curve *curve = chain(&r, 3, false, 2, 0), *moved = NULL;
    const double *points = bat_curve_points(curve);
    double onto[2] = {points[6] - points[4], points[7] - points[5]}, far[2] = {1e300, 0}, u = 1e-9;
    assert_int_equal(bat_pull_point(curve, 2, onto, false, &moved), BAT_OK);
    assert_memory_equal(bat_curve_points(moved) + 8, points + 8, 2 * sizeof(double));
    bat_curve_free(moved);
    moved = NULL;
    assert_int_equal(bat_pull_point(curve, 2, far, false, &moved), BAT_NUMBER);
    assert_int_equal(bat_pull(curve, 1, &u, far, &moved), BAT_NUMBER);
    assert_int_equal(bat_pull_point(curve, 99, onto, false, &moved), BAT_ARGUMENT);
    assert_null(moved);
    /* So near to the end that it is the end. */
    assert_int_equal(bat_pull(curve, 1, &u, onto, &moved), BAT_OK);
    double before[2], after[2];
    place(curve, 0, before);
    place(moved, 0, after);
    assert_true(fabs(apart(before, after) - hypot(onto[0], onto[1])) < 1e-3);
    bat_curve_free(moved);
    bat_curve_free(curve);
}

/* ---- in the tool ---- */

static bat_editor *points_with(bat_curve *curve) {
    bat_editor *editor = editor_with(1, &curve);
    bat_editor_command(editor, "tool-points");
    return editor;
}

static const bat_curve *the_curve(const bat_editor *editor) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0);
}

/* Anywhere along a free curve: both ends stay, until the end itself is taken. */
static void the_tool_leaves_ends_alone(void **state) {
    (void)state;
    for (int share = 1; share < 20; share++) {
        bat_editor *editor = points_with(pen_curve(200, 300, 60, 40, 8));
        pen p = pen_for(editor);
        double ends[2][2], at[2], now[2];
        for (int side = 0; side < 2; side++) place(the_curve(editor), 5.0 * side, ends[side]);
        place(the_curve(editor), share / 4.0, at);
        drag(&p, at[0], at[1], at[0] + 12, at[1] - 35);
        for (int side = 0; side < 2; side++) {
            place(the_curve(editor), 5.0 * side, now);
            assert_memory_equal(now, ends[side], sizeof now);
        }
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        drag(&p, ends[0][0] + 6, ends[0][1] + 1, ends[0][0] - 14,
             ends[0][1] + 11); /* 6 px off it is the end that is taken */
        place(the_curve(editor), 0, now);
        assert_true(fabs(now[0] - ends[0][0] + 20) < 0.02 && fabs(now[1] - ends[0][1] - 10) < 0.02);
        bat_editor_free(editor);
    }
}

/* Handle and node of an outline; with Alt the handle goes alone, changed while it is dragged too. */
static void the_tool_keeps_nodes_smooth(void **state) {
    (void)state;
    const double points[] = {200, 300, 240, 260, 300, 240, 400, 240.2, 500, 240, 560, 280, 600, 330};
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
    for (int alt = 0; alt < 3; alt++) { /* 2: let go before the end */
        bat_curve *curve = NULL;
        bat_curve_create(2, 3, false, 7, points, 11, knots, &curve);
        bat_editor *editor = points_with(curve);
        pen p = pen_for(editor);
        double on[2] = {240, 273};
        pen_event(&p, BAT_POINTER_DOWN, on[0], on[1]);
        pen_event(&p, BAT_POINTER_UP, on[0], on[1]); /* the curve is chosen */
        p.time += 1000;
        pen_event(&p, BAT_POINTER_HOVER, 300, 240);
        assert_string_equal(bat_editor_frame(editor)->hint,
                            "Drag it; the curve stays smooth here. Alt: alone. Shift: steps of 15°");
        p.modifiers = alt ? BAT_ALT : 0;
        pen_event(&p, BAT_POINTER_DOWN, 300, 240);
        for (int i = 1; i <= 6; i++) pen_event(&p, BAT_POINTER_MOVE, 300 - 3 * i, 240 + 12 * i);
        bat_editor_frame(editor);
        if (alt == 2) {
            p.modifiers = 0;
            bat_editor_key(editor, "Alt", false, 0, p.time);
        }
        bat_editor_frame(editor);
        pen_event(&p, BAT_POINTER_UP, 282, 312);
        p.time += 1000;
        p.modifiers = 0;
        const double *now = bat_curve_points(the_curve(editor));
        assert_true(now[4] == 282 && now[5] == 312 && now[6] == 400 && now[7] == 240.2);
        if (alt == 1) {
            assert_true(now[8] == 500 && now[9] == 240);
        } else {
            assert_true(greatest_turn(the_curve(editor), 2) < 1e-9);
            assert_true(fabs(hypot(now[8] - 400, now[9] - 240.2) - hypot(100, 0.2)) < 1e-9);
            drag(&p, 400, 240.2, 430, 255.2); /* the node: both handles go along */
            assert_true(greatest_turn(the_curve(editor), 2) < 1e-9);
            now = bat_curve_points(the_curve(editor));
            assert_true(fabs(now[4] - 312) < 0.02 && fabs(now[5] - 327) < 0.02);
        }
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_stay),
        cmocka_unit_test(an_end_that_is_pulled_moves),
        cmocka_unit_test(smooth_nodes_stay_smooth),
        cmocka_unit_test(points_of_nodes),
        cmocka_unit_test(odd_handles),
        cmocka_unit_test(the_tool_leaves_ends_alone),
        cmocka_unit_test(the_tool_keeps_nodes_smooth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
