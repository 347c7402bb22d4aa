/* The line tool: straight lines by dragging, in angle steps with Shift, continued from their end by clicks, one step
 * each. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/real.h"
#include "editor/editor.h"
#include "support/editing.h"
#include <batten/curve.h>
#include <math.h>

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

/* The curve runs straight from corner to corner, at even speed, with three knots at each. */
static void expect_corners(const bat_editor *editor, int corners, const double *at) {
    const bat_document *document = bat_editor_document(editor);
    const bat_curve *curve = bat_object_curve(bat_document_at(document, count(editor) - 1), 0);
    assert_int_equal(bat_curve_count(curve), 3 * (corners - 1) + 1);
    const double *knots = bat_curve_knots(curve);
    for (int i = 0; i + 1 < corners; i++) {
        const double *a = at + 2 * i, *b = a + 2;
        double length = bat_hypot(b[0] - a[0], b[1] - a[1]), u0 = knots[3 + 3 * i], u1 = knots[6 + 3 * i],
               d[4];
        assert_true(fabs(u1 - u0 - length) < 1e-9 * length);
        for (int k = 0; k <= 8; k++) {
            bat_curve_eval_left(curve, u0 + (u1 - u0) * k / 8, 0, d);
            for (int axis = 0; axis < 2 && k; axis++)
                assert_true(fabs(d[axis] - a[axis] - (b[axis] - a[axis]) * k / 8) < 1e-9 * length);
        }
    }
}

static bat_editor *with_lines(void) {
    bat_editor *editor = pen_editor();
    assert_true(bat_editor_key(editor, "l", true, 0, 0));
    bat_editor_set(editor, "snap", 0);
    return editor;
}

static void drags_and_goes_on(void **state) {
    (void)state;
    bat_editor *editor = with_lines();
    pen p = pen_for(editor);
    int before = count(editor);
    drag(&p, 100, 100, 300, 140);
    assert_int_equal(count(editor), before + 1);
    expect_corners(editor, 2, (double[]){100, 100, 300, 140});
    tap(&p, 320, 300);
    drag(&p, 500, 310, 480, 90); /* wherever the press begins: the line goes on from its end */
    expect_corners(editor, 4, (double[]){100, 100, 300, 140, 320, 300, 480, 90});
    assert_int_equal(count(editor), before + 1);
    /* Each was a step; after undo it goes on from nowhere. */
    bat_editor_command(editor, "undo");
    expect_corners(editor, 3, (double[]){100, 100, 300, 140, 320, 300});
    drag(&p, 10, 10, 60, 60);
    assert_int_equal(count(editor), before + 2);
    bat_editor_key(editor, "Escape", true, 0, 0);
    assert_int_equal(count(editor), before + 2);
    drag(&p, 200, 10, 260, 60);
    assert_int_equal(count(editor), before + 3);
    expect_corners(editor, 2, (double[]){200, 10, 260, 60});
    bat_editor_free(editor);
}

/* A click puts the first point, another the end; one on the end ends it; Escape takes a press back. */
static void clicks(void **state) {
    (void)state;
    bat_editor *editor = with_lines();
    pen p = pen_for(editor);
    int before = count(editor);
    tap(&p, 100, 100);
    assert_int_equal(count(editor), before);
    tap(&p, 200, 100);
    assert_int_equal(count(editor), before + 1);
    tap(&p, 201, 100);
    tap(&p, 400, 400);
    assert_int_equal(count(editor), before + 1); /* a new first point */
    bat_editor_key(editor, "Escape", true, 0, 0);
    tap(&p, 400, 200);
    assert_int_equal(count(editor), before + 1);
    pen_event(&p, BAT_POINTER_DOWN, 500, 200);
    bat_editor_key(editor, "Escape", true, 0, 0);
    pen_event(&p, BAT_POINTER_UP, 500, 200);
    assert_int_equal(count(editor), before + 1);
    assert_null(bat_editor_check(editor));
    tap(&p, 400, 300);
    assert_int_equal(count(editor), before + 2);
    expect_corners(editor, 2, (double[]){400, 200, 400, 300});
    bat_editor_free(editor);
}

static void done_ends_it(void **state) {
    (void)state;
    bat_editor *editor = with_lines();
    pen p = pen_for(editor);
    const int before = count(editor);
    assert_int_equal(bat_editor_frame(editor)->pending, 0);
    tap(&p, 100, 100);
    assert_int_equal(bat_editor_frame(editor)->pending, 2);
    tap(&p, 200, 100);
    assert_int_equal(bat_editor_frame(editor)->pending, 2);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    assert_int_equal(bat_editor_frame(editor)->pending, 0);
    drag(&p, 300, 300, 400, 300);
    assert_int_equal(count(editor), before + 2);
    bat_editor_free(editor);
}

static void shift_keeps_to_steps(void **state) {
    (void)state;
    bat_editor *editor = with_lines();
    pen p = pen_for(editor);
    for (int i = 0; i < 24; i++) {
        double angle = (15 * i + 4) * BAT_PI / 180, d[4];
        p.modifiers = BAT_SHIFT;
        drag(&p, 500, 400, 500 + 200 * bat_cos(angle), 400 + 200 * bat_sin(angle));
        const bat_document *document = bat_editor_document(editor);
        const bat_curve *curve = bat_object_curve(bat_document_at(document, count(editor) - 1), 0);
        double domain[2];
        bat_curve_domain(curve, domain);
        bat_curve_eval(curve, domain[1], 0, d);
        double turn = bat_atan2(d[1] - 400, d[0] - 500) * 180 / BAT_PI / 15;
        assert_true(fabs(turn - round(turn)) < 1e-6);
        p.modifiers = 0;
        bat_editor_key(editor, "Escape", true, 0, 0);
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(drags_and_goes_on), cmocka_unit_test(clicks),
                                       cmocka_unit_test(done_ends_it),
                                       cmocka_unit_test(shift_keeps_to_steps)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
