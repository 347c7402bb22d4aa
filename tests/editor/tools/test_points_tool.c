/* The points tool: what it shows, and that its edits are exact. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/editing.h"
#include <batten/base.h>
#include <batten/editor.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>

static const bat_curve *curve_at(const bat_editor *editor, int index) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), index), 0);
}

/* A wavy curve, and one with points and knots that are not even. */
static bat_editor *points_editor(void) {
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, pen_curve(200, 200, 60, 70, 11));
    pen_add(document, pen_curve(200, 600, 60, 0, 11));
    editor = editor_of(document);
    bat_editor_command(editor, "tool-points");
    return editor;
}

/* Grabbed a little beside: the point moves by the drag, not to the pen. All else stays bitwise. */
static void control_point_moves_by_the_drag(void **state) {
    (void)state;
    bat_editor *editor = points_editor();
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    bat_curve *before = NULL;
    bat_curve_copy(curve_at(editor, 0), &before);
    const double *old = bat_curve_points(before);
    double x, y;
    bat_curve_eval(before, 2, 0, (double[2]){0});
    double on[2];
    bat_curve_eval(before, 2.5, 0, on);
    tap(&p, on[0], on[1]); /* the curve is chosen, so that its points can be taken */
    x = old[8] + 2, y = old[9] - 3;
    pen_event(&p, BAT_POINTER_HOVER, x, y);
    assert_string_equal(bat_editor_frame(editor)->hint, "Drag the control point. Shift: steps of 15°");
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_POLYGON));
    drag(&p, x, y, x + 33, y + 21);
    const double *now = bat_curve_points(curve_at(editor, 0));
    for (int i = 0; i < 22; i++)
        if (i / 2 == 4)
            assert_true(fabs(now[i] - old[i] - (i % 2 ? 21 : 33)) < 1e-12);
        else
            assert_true(now[i] == old[i]);
    /* along one axis with Shift */
    p.modifiers = BAT_SHIFT;
    x = now[8], y = now[9];
    drag(&p, x, y, x - 40, y + 4);
    now = bat_curve_points(curve_at(editor, 0));
    assert_true(fabs(now[8] - x + 40) < 0.011 && now[9] == y);
    bat_curve_free(before);
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* The place of the curve that was grabbed is moved by exactly the drag; nothing beyond its reach moves. */
static void curve_is_pulled(void **state) {
    (void)state;
    bat_editor *editor = points_editor();
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    bat_curve *before = NULL;
    bat_curve_copy(curve_at(editor, 1), &before);
    double grabbed[2] = {470, 600}, after[2];
    bat_near near;
    bat_curve_nearest(before, grabbed, &near);
    pen_event(&p, BAT_POINTER_HOVER, grabbed[0], grabbed[1] + 4);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_STRETCH));
    drag(&p, grabbed[0], grabbed[1], grabbed[0] + 30, grabbed[1] - 80);
    const bat_curve *now = curve_at(editor, 1);
    bat_curve_eval(now, near.u, 0, after);
    assert_true(fabs(after[0] - near.point[0] - 30) < 1e-9 && fabs(after[1] - near.point[1] + 80) < 1e-9);
    int changed = 0;
    for (int i = 0; i < 11; i++)
        changed += bat_curve_points(now)[2 * i + 1] != bat_curve_points(before)[2 * i + 1];
    assert_in_range(changed, 2, 4);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK); /* one step */
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    bat_curve_free(before);
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* An outline of cubics whose joints turn by a tenth of a degree, as rounded files have them: pulled near a joint, the
 * turn there stays what it was. */
static void joints_that_look_smooth_stay_so(void **state) {
    (void)state;
    const double points[] = {200, 300, 240, 260, 300, 240, 400, 240.2, 500, 240, 560, 280, 600, 330};
    const double knots[] = {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2};
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    bat_curve *curve = NULL;
    bat_curve_create(2, 3, false, 7, points, 11, knots, &curve);
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, curve);
    editor = editor_of(document);
    bat_editor_command(editor, "tool-points");
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    double left[4], right[4], at[2], after[2];
    bat_curve_eval_left(curve_at(editor, 0), 1, 1, left);
    bat_curve_eval(curve_at(editor, 0), 1, 1, right);
    double jump[2] = {right[2] - left[2], right[3] - left[3]};
    bat_near near;
    bat_curve_eval(curve_at(editor, 0), 1.15, 0, at);
    double rounded[2] = {floor(at[0] * 100 + 0.5) / 100, floor(at[1] * 100 + 0.5) / 100};
    bat_curve_nearest(curve_at(editor, 0), rounded, &near);
    drag(&p, rounded[0], rounded[1], rounded[0] + 5, rounded[1] - 60);
    assert_true(digest(editor) != first);
    bat_curve_eval(curve_at(editor, 0), near.u, 0, after);
    assert_true(fabs(after[0] - near.point[0] - 5) < 1e-9 && fabs(after[1] - near.point[1] + 60) < 1e-9);
    bat_curve_eval_left(curve_at(editor, 0), 1, 1, left);
    bat_curve_eval(curve_at(editor, 0), 1, 1, right);
    for (int c = 0; c < 2; c++) assert_true(fabs(right[2 + c] - left[2 + c] - jump[c]) < 1e-9);
    assert_int_equal(bat_curve_knot_count(curve_at(editor, 0)), 11);
    round_trip(editor, first);
    bat_editor_free(editor);
}

static void chosen_knot_stays_while_the_curve_is_pulled(void **state) {
    (void)state;
    bat_editor *editor = points_editor();
    pen p = pen_for(editor);
    double knot[2], place[2], held[2], pulled[2];
    bat_curve_eval(curve_at(editor, 0), 4, 0, knot);
    bat_curve_eval(curve_at(editor, 0), 4.5, 0, place);
    tap(&p, knot[0], knot[1]);
    bat_near near;
    double rounded[2] = {floor(place[0] * 100 + 0.5) / 100, floor(place[1] * 100 + 0.5) / 100};
    bat_curve_nearest(curve_at(editor, 0), rounded, &near);
    drag(&p, rounded[0], rounded[1], rounded[0], rounded[1] + 25);
    bat_curve_eval(curve_at(editor, 0), 4, 0, held);
    bat_curve_eval(curve_at(editor, 0), near.u, 0, pulled);
    assert_true(fabs(held[0] - knot[0]) < 1e-9 && fabs(held[1] - knot[1]) < 1e-9);
    assert_true(fabs(pulled[0] - near.point[0]) < 1e-9 && fabs(pulled[1] - near.point[1] - 25) < 1e-9);
    bat_editor_free(editor);
}

static double apart(const bat_curve *a, const bat_curve *b) {
    double ab = 0, ba = 0;
    bat_curve_distance(a, b, 40, &ab, &ba);
    return fmax(ab, ba);
}

static void double_tap_inserts_a_knot_and_delete_takes_it_out(void **state) {
    (void)state;
    bat_editor *editor = points_editor();
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    bat_curve *before = NULL;
    bat_curve_copy(curve_at(editor, 0), &before);
    int knots = bat_curve_knot_count(before);
    double at[2];
    bat_curve_eval(before, 3.4, 0, at);
    for (int i = 0; i < 2; i++) {
        pen_event(&p, BAT_POINTER_DOWN, at[0], at[1]);
        pen_event(&p, BAT_POINTER_UP, at[0], at[1]);
    }
    p.time += 1000;
    assert_int_equal(bat_curve_knot_count(curve_at(editor, 0)), knots + 1);
    assert_true(apart(before, curve_at(editor, 0)) < 1e-10);
    check(editor);
    assert_true(bat_editor_key(editor, "Delete", true, 0, p.time)); /* it is chosen */
    assert_int_equal(bat_curve_knot_count(curve_at(editor, 0)), knots);
    assert_true(apart(before, curve_at(editor, 0)) < 1e-8);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "moved by at most"));
    /* a knot that the shape needs stays, with the number */
    bat_curve_eval(curve_at(editor, 0), 4, 0, at);
    tap(&p, at[0], at[1]);
    uint64_t kept = digest(editor);
    bat_editor_key(editor, "Delete", true, 0, p.time);
    assert_true(digest(editor) == kept);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "would move by up to"));
    double said = atof(strstr(bat_editor_frame(editor)->notice, "up to") + 5);
    bat_curve *without = NULL;
    bat_curve_remove_knot(curve_at(editor, 0), 4, 1, 1e9, &without, NULL, NULL);
    assert_true(said > 1 && apart(without, curve_at(editor, 0)) <= said * 1.01);
    /* a looser tolerance lets it go */
    bat_curve_free(without);
    bat_editor_set(editor, "tolerance", 20);
    if (said < 20) {
        bat_editor_key(editor, "Delete", true, 0, p.time);
        assert_int_equal(bat_curve_knot_count(curve_at(editor, 0)), knots - 1);
    }
    bat_curve_free(before);
    round_trip(editor, first);
    bat_editor_free(editor);
}

static int multiplicity(const bat_curve *curve, double u) {
    int count = 0;
    for (int i = 0; i < bat_curve_knot_count(curve); i++) count += bat_curve_knots(curve)[i] == u;
    return count;
}

static void corners_come_and_go(void **state) {
    (void)state;
    bat_editor *editor = points_editor();
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    double at[2], left[6], right[6];
    bat_curve *before = NULL;
    bat_curve_copy(curve_at(editor, 0), &before);
    bat_curve_eval(before, 4, 0, at);
    tap(&p, at[0], at[1]);
    assert_int_equal(bat_editor_command(editor, "corner-make"), BAT_OK);
    assert_int_equal(multiplicity(curve_at(editor, 0), 4), 3);
    assert_true(apart(before, curve_at(editor, 0)) < 1e-10);
    assert_int_equal(bat_editor_command(editor, "corner-make"), BAT_STATE);
    /* the control point on the corner is dragged: a corner that is one */
    drag(&p, at[0], at[1], at[0] + 10, at[1] - 60);
    bat_curve_eval(curve_at(editor, 0), 4, 1, right);
    bat_curve_eval_left(curve_at(editor, 0), 4, 1, left);
    assert_true(fabs(left[2] * right[3] - left[3] * right[2]) > 1);
    bat_editor_frame(editor);
    assert_int_equal(bat_editor_command(editor, "corner-smooth"), BAT_OK); /* of the point dragged */
    assert_int_equal(multiplicity(curve_at(editor, 0), 4), 1);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "moved by at most"));
    bat_curve_eval(curve_at(editor, 0), 4, 2, right);
    bat_curve_eval_left(curve_at(editor, 0), 4, 2, left);
    for (int i = 0; i < 6; i++) assert_true(fabs(left[i] - right[i]) < 1e-6);
    assert_int_equal(bat_editor_command(editor, "corner-smooth"), BAT_STATE);
    bat_curve_free(before);
    round_trip(editor, first);
    bat_editor_free(editor);
}

static void the_keyboard_does_it_all(void **state) {
    (void)state;
    bat_editor *editor = points_editor();
    uint64_t first = digest(editor);
    double old[2], time = 0;
    memcpy(old, bat_curve_points(curve_at(editor, 0)) + 4, sizeof old);
    for (int i = 0; i < 3; i++) assert_true(bat_editor_key(editor, "Tab", true, 0, time));
    assert_true(bat_editor_key(editor, "ArrowRight", true, 0, time));
    assert_true(bat_editor_key(editor, "ArrowDown", true, BAT_SHIFT, time));
    const double *now = bat_curve_points(curve_at(editor, 0)) + 4;
    assert_true(fabs(now[0] - old[0] - 1) < 1e-12 && fabs(now[1] - old[1] - 10) < 1e-12);
    assert_true(bat_editor_key(editor, "Tab", true, BAT_SHIFT, time));
    assert_true(bat_editor_key(editor, "Insert", true, 0, time));
    assert_int_equal(bat_curve_count(curve_at(editor, 0)), 12);
    assert_true(bat_editor_key(editor, "Delete", true, 0, time));
    assert_int_equal(bat_curve_count(curve_at(editor, 0)), 11);
    int steps = 0;
    while (bat_editor_key(editor, "Tab", true, 0, time) && steps < 50) steps++;
    assert_in_range(steps, 1, 12); /* the focus gets out */
    assert_true(bat_editor_key(editor, "Escape", true, 0, time));
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_POLYGON));
    /* with nothing chosen the arrows move the view */
    double x = bat_editor_frame(editor)->view[0];
    bat_editor_key(editor, "ArrowRight", true, 0, time);
    assert_true(bat_editor_frame(editor)->view[0] != x);
    round_trip(editor, first);
    bat_editor_free(editor);
}

static void escape_takes_a_drag_back(void **state) {
    (void)state;
    bat_editor *editor = points_editor();
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    pen_event(&p, BAT_POINTER_DOWN, 500, 600);
    pen_event(&p, BAT_POINTER_MOVE, 520, 660);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_true(digest(editor) != first); /* live */
    double bottom = frame->still[2].bounds[3] + frame->origin[1];
    assert_true(bottom > 630); /* the frame that the drag was made for paints it */
    bat_editor_key(editor, "Escape", true, 0, p.time);
    assert_true(digest(editor) == first);
    check(editor);
    pen_event(&p, BAT_POINTER_MOVE, 530, 690);
    pen_event(&p, BAT_POINTER_UP, 530, 690);
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_STATE);
    check(editor);
    bat_editor_free(editor);
}

static void shift_measures_a_stretch(void **state) {
    (void)state;
    bat_editor *editor = points_editor();
    pen p = pen_for(editor);
    double a[2], b[2];
    const bat_curve *curve = curve_at(editor, 0);
    bat_curve_eval(curve, 3, 0, a);
    bat_curve_eval(curve, 6, 0, b);
    tap(&p, a[0], a[1]);
    p.modifiers = BAT_SHIFT;
    tap(&p, b[0], b[1]);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_true(frame->label_count >= 1);
    double said = atof(frame->labels[0].text), length = bat_curve_length(curve, 3, 6, 1e-9);
    assert_true(fabs(said - length) < length * 1e-3);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(control_point_moves_by_the_drag),
        cmocka_unit_test(curve_is_pulled),
        cmocka_unit_test(joints_that_look_smooth_stay_so),
        cmocka_unit_test(chosen_knot_stays_while_the_curve_is_pulled),
        cmocka_unit_test(double_tap_inserts_a_knot_and_delete_takes_it_out),
        cmocka_unit_test(corners_come_and_go),
        cmocka_unit_test(the_keyboard_does_it_all),
        cmocka_unit_test(escape_takes_a_drag_back),
        cmocka_unit_test(shift_measures_a_stretch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
