/*
 * The last transform repeated, by closed forms: moved, turned, scaled, by hand, by keys and by numbers; on the same objects and on
 * others; with copies, and with what moved them since; after undo. What was shown or failed is not repeated.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/matrix.h"
#include "editor/edit/arrange.h"
#include "editor/edit/repeat.h"
#include "editor/editor.h"
#include "support/selecting.h"
#include <math.h>

static void runs(bat_editor *editor, const char *command) {
    const bat_status status = bat_editor_command(editor, command);
    if (status != BAT_OK) fail_msg("%s: %d", command, (int)status);
    check(editor);
}

static void enters(bat_editor *editor, const char *number, const char *text) {
    assert_int_equal(bat_editor_enter(editor, number, text), BAT_OK);
    check(editor);
}

static bat_id newest(const bat_editor *editor) {
    assert_int_equal(selected(editor), 1);
    return editor->choice.selection.ids[0];
}

static void near(const bat_editor *editor, bat_id id, double x0, double y0, double x1, double y1) {
    const double expected[4] = {x0, y0, x1, y1};
    double box[4];
    box_of(editor, id, box);
    for (int k = 0; k < 4; k++)
        if (!(fabs(box[k] - expected[k]) < 1e-6))
            fail_msg("%g %g %g %g, not %g %g %g %g", box[0], box[1], box[2], box[3], x0, y0, x1, y1);
}

/* A square of side 100 at 100, 100 (1), one of side 50 at 600, 600 (2). */
static bat_editor *squares(void) {
    bat_curve *curves[2];
    for (int i = 0; i < 2; i++) {
        const double side = i ? 50 : 100, at = i ? 600 : 100, knots[5] = {0, 1, 2, 3, 4};
        const double points[8] = {at, at, at + side, at, at + side, at + side, at, at + side};
        assert_int_equal(bat_curve_create(2, 1, true, 4, points, 5, knots, &curves[i]), BAT_OK);
    }
    bat_editor *editor = editor_with(2, curves);
    runs(editor, "tool-select");
    return editor;
}

static void a_move_on_the_same_and_on_another(void **state) {
    (void)state;
    bat_editor *editor = squares();
    const uint64_t first = digest(editor);
    only(editor, 1, 0);
    enters(editor, "x", "130");
    runs(editor, "repeat");
    near(editor, 1, 160, 100, 260, 200);
    runs(editor, "repeat");
    near(editor, 1, 190, 100, 290, 200);
    only(editor, 2, 0);
    runs(editor, "repeat");
    near(editor, 2, 630, 600, 680, 650);
    only(editor, 1, 2);
    runs(editor, "repeat");
    near(editor, 1, 220, 100, 320, 200);
    near(editor, 2, 660, 600, 710, 650);
    runs(editor, "nudge-down"); /* the last is what counts */
    runs(editor, "repeat");
    near(editor, 2, 660, 602, 710, 652);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

/* Scaled about its upper left corner; the other about its own, by the same factor. */
static void a_scale_and_a_turn(void **state) {
    (void)state;
    bat_editor *editor = squares();
    only(editor, 1, 0);
    enters(editor, "width", "150");
    near(editor, 1, 100, 100, 250, 200);
    runs(editor, "repeat");
    near(editor, 1, 100, 100, 325, 200);
    only(editor, 2, 0);
    runs(editor, "repeat");
    near(editor, 2, 600, 600, 675, 650);
    enters(editor, "turn", "90");
    near(editor, 2, 612.5, 587.5, 662.5, 662.5);
    runs(editor, "repeat");
    near(editor, 2, 600, 600, 675, 650);
    only(editor, 1, 0);
    runs(editor, "repeat"); /* 225 x 100 about 212.5, 150 */
    near(editor, 1, 162.5, 37.5, 262.5, 262.5);
    runs(editor, "mirror-across"); /* symmetric, and so in its place */
    runs(editor, "repeat");
    near(editor, 1, 162.5, 37.5, 262.5, 262.5);
    bat_editor_free(editor);
}

/* Copies with all that moved them since: by the command itself, and by Duplicate. */
static void copies(void **state) {
    (void)state;
    bat_editor *editor = squares();
    const uint64_t first = digest(editor);
    only(editor, 1, 0);
    runs(editor, "duplicate"); /* 3, 10 off */
    near(editor, 3, 110, 110, 210, 210);
    enters(editor, "x", "220");
    enters(editor, "y", "100");
    runs(editor, "duplicate");
    const bat_id second = newest(editor);
    near(editor, second, 340, 100, 440, 200);
    runs(editor, "repeat");
    const bat_id third = newest(editor);
    near(editor, third, 460, 100, 560, 200);
    enters(editor, "y", "105"); /* 120, 5 from now on */
    runs(editor, "repeat");
    near(editor, newest(editor), 580, 110, 680, 210);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 6);
    only(editor, 2, 0); /* something else: a copy of it, as far */
    runs(editor, "repeat");
    near(editor, newest(editor), 720, 605, 770, 655);
    near(editor, 2, 600, 600, 650, 650);
    only(editor, 1, 0); /* what is no copy is copied beside itself */
    runs(editor, "duplicate");
    near(editor, newest(editor), 110, 110, 210, 210);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

/* A copy turned about the middle of the first one: each repetition turns by as much about it. */
static void a_wheel(void **state) {
    (void)state;
    bat_editor *editor = squares();
    double turn[6], box[4] = {100, 100, 200, 200};
    only(editor, 1, 0);
    bat_matrix_rotation(0.5, (double[]){300, 300}, turn);
    assert_int_equal(bat_arrange_duplicate(&editor->context, turn), BAT_OK);
    for (int i = 2; i < 6; i++) {
        runs(editor, "repeat");
        const bat_curve *one = curve(editor, newest(editor));
        bat_matrix_rotation(0.5 * i, (double[]){300, 300}, turn);
        for (int k = 0; k < 4; k++) {
            const double x = k == 0 || k == 3 ? box[0] : box[2], y = k < 2 ? box[1] : box[3];
            const double *p = bat_curve_points(one) + (ptrdiff_t)2 * k;
            assert_true(hypot(p[0] - (turn[0] * x + turn[2] * y + turn[4]),
                              p[1] - (turn[1] * x + turn[3] * y + turn[5])) < 1e-9);
        }
    }
    bat_editor_free(editor);
}

/* Alt-drag and then the command: as many more. */
static void by_hand(void **state) {
    (void)state;
    bat_editor *editor = squares();
    const uint64_t first = digest(editor);
    bat_editor_set(editor, "snap", 0);
    only(editor, 1, 0);
    pen p = mouse(editor);
    drag_holding(&p, 130, 100, 260, 150, BAT_ALT); /* 3 */
    near(editor, newest(editor), 230, 150, 330, 250);
    runs(editor, "repeat");
    near(editor, newest(editor), 360, 200, 460, 300);
    runs(editor, "duplicate");
    near(editor, newest(editor), 490, 250, 590, 350);
    drag(&p, 515, 250, 505, 250); /* beside the handles */
    near(editor, newest(editor), 480, 250, 580, 350);
    runs(editor, "duplicate");
    near(editor, newest(editor), 600, 300, 700, 400);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

/* What was undone is not repeated with the rest; and one too many taken back can be made elsewhere. */
static void after_undo(void **state) {
    (void)state;
    bat_editor *editor = squares();
    only(editor, 1, 0);
    runs(editor, "duplicate");
    enters(editor, "x", "230");
    enters(editor, "y", "400");
    runs(editor, "undo"); /* 130, 10 is left */
    runs(editor, "duplicate");
    near(editor, newest(editor), 360, 120, 460, 220);
    runs(editor, "undo");
    only(editor, 2, 0);
    runs(editor, "repeat");
    near(editor, newest(editor), 730, 610, 780, 660);
    for (int i = 0; i < 3; i++) runs(editor, "undo");
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 2);
    only(editor, 1, 0);
    enters(editor, "x", "107");
    runs(editor, "undo");
    runs(editor, "repeat"); /* a plain one can be repeated though it was undone */
    near(editor, 1, 107, 100, 207, 200);
    bat_editor_free(editor);
}

/* More moves of one copy than are remembered: the sum is right, and as many as are remembered can be undone. */
static void many_moves(void **state) {
    (void)state;
    bat_editor *editor = squares();
    only(editor, 1, 0);
    runs(editor, "duplicate");
    for (int i = 0; i < 100; i++) runs(editor, "nudge-right");
    for (int i = 0; i < 20; i++) runs(editor, "undo");
    runs(editor, "duplicate"); /* 10 and 80 */
    near(editor, newest(editor), 280, 120, 380, 220);
    bat_editor_free(editor);
}

static void refusals(void **state) {
    (void)state;
    bat_editor *editor = squares();
    assert_int_equal(bat_editor_command(editor, "repeat"), BAT_STATE);
    assert_string_equal(bat_editor_frame(editor)->notice, bat_string_english(BAT_STRING_NOTICE_SELECT_FIRST));
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "repeat"), BAT_STATE);
    assert_string_equal(bat_editor_frame(editor)->notice,
                        bat_string_english(BAT_STRING_NOTICE_NOTHING_TO_REPEAT));
    enters(editor, "x", "110");
    enters(editor, "x", "110"); /* moves nothing, and changes nothing of it */
    pen p = mouse(editor);
    pen_event(&p, BAT_POINTER_DOWN, 130, 100);
    pen_event(&p, BAT_POINTER_MOVE, 300, 300);
    runs(editor, "cancel");
    pen_event(&p, BAT_POINTER_UP, 300, 300);
    only(editor, 1, 0);
    runs(editor, "repeat");
    near(editor, 1, 120, 100, 220, 200);
    assert_int_equal(bat_editor_key(editor, "d", true, BAT_CTRL | BAT_SHIFT, 0) != 0, 1);
    near(editor, 1, 130, 100, 230, 200);
    bat_editor_set_read_only(editor, true);
    bat_editor_command(editor, "repeat");
    near(editor, 1, 130, 100, 230, 200);
    bat_editor_free(editor);
}

/* Groups, and what is locked or hidden in them, go along; a group among what is selected is one thing. */
static void groups(void **state) {
    (void)state;
    bat_editor *editor = squares();
    const uint64_t first = digest(editor);
    bat_editor_command(editor, "select-all");
    runs(editor, "group");
    enters(editor, "x", "90");
    runs(editor, "repeat");
    near(editor, 1, 80, 100, 180, 200);
    near(editor, 2, 580, 600, 630, 650);
    runs(editor, "duplicate");
    enters(editor, "x", "200");
    runs(editor, "repeat");
    const bat_id made = newest(editor);
    int inside = 0;
    for (int i = 0; i < bat_document_count(bat_editor_document(editor)); i++)
        inside += bat_object_parent(bat_document_at(bat_editor_document(editor), i)) == made;
    assert_int_equal(inside, 2);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_move_on_the_same_and_on_another),
        cmocka_unit_test(a_scale_and_a_turn),
        cmocka_unit_test(copies),
        cmocka_unit_test(a_wheel),
        cmocka_unit_test(by_hand),
        cmocka_unit_test(after_undo),
        cmocka_unit_test(many_moves),
        cmocka_unit_test(refusals),
        cmocka_unit_test(groups),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
