/*
 * Several control points of one curve: chosen by Shift or by a box, moved by the pen, by keys and by numbers, each by exactly the same;
 * all else stays to the bit. Undo, other curves, other numbers of points.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/tools/points/state.h"
#include "support/editing.h"
#include <batten/base.h>
#include <batten/editor.h>
#include <batten/panels.h>
#include <math.h>
#include <string.h>

enum { POINTS = 9 };

static double place_of(int i, int k) { return k ? 400 + (i % 2 ? 60 : -60) : 100 + 80 * i; }

static const bat_curve *curve_of(const bat_editor *editor, int index) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), index), 0);
}

/* A zigzag of nine points, 80 apart, whose second curve lies below it; the first one is chosen. */
static bat_editor *zigzag(void) {
    double points[2][2 * POINTS];
    bat_curve *curves[2];
    for (int i = 0; i < 2 * POINTS; i++) {
        points[0][i] = place_of(i / 2, i % 2);
        points[1][i] = points[0][i] + (i % 2 ? 250 : 0);
    }
    for (int j = 0; j < 2; j++)
        assert_int_equal(bat_curve_create_clamped(2, 3, POINTS, points[j], &curves[j]), BAT_OK);
    bat_editor *editor = editor_with(2, curves);
    bat_editor_select(editor, 1, false);
    assert_int_equal(bat_editor_command(editor, "tool-points"), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "snap", 0), BAT_OK);
    bat_editor_frame(editor);
    return editor;
}

static bat_pointing *pointing(const bat_editor *editor) { return bat_pointing_of(&editor->context); }

/* Bit i: point i is chosen. */
static void expect_marked(const bat_editor *editor, unsigned expected) {
    unsigned marked = 0;
    for (int i = 0; i < POINTS; i++)
        if (bat_pointing_is_marked(pointing(editor), i)) marked |= 1U << i;
    if (marked != expected) fail_msg("points %x are chosen, not %x", marked, expected);
}

static void expect_moved(const bat_editor *editor, unsigned which, double dx, double dy) {
    for (int i = 0; i < POINTS; i++)
        for (int k = 0; k < 2; k++) {
            const double by = which >> i & 1 ? (k ? dy : dx) : 0,
                         now = bat_curve_points(curve_of(editor, 0))[2 * i + k];
            if (by == 0 ? now != place_of(i, k) : fabs(now - place_of(i, k) - by) > 1e-9)
                fail_msg("point %d at %.12g, not %.12g", i, now, place_of(i, k) + by);
        }
}

static void tap_point(pen *p, int i, uint32_t modifiers) {
    p->modifiers = modifiers;
    p->time += 1000;
    tap(p, place_of(i, 0), place_of(i, 1));
    p->modifiers = 0;
    check(p->editor);
}

static void box(pen *p, double x0, double y0, double x1, double y1, uint32_t modifiers) {
    p->modifiers = modifiers;
    p->time += 1000;
    drag(p, x0, y0, x1, y1);
    p->modifiers = 0;
    check(p->editor);
}

static void with_shift(void **state) {
    (void)state;
    bat_editor *editor = zigzag();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    tap_point(&p, 2, 0);
    expect_marked(editor, 0); /* one alone */
    tap_point(&p, 5, BAT_SHIFT);
    tap_point(&p, 6, BAT_SHIFT);
    expect_marked(editor, 1U << 2 | 1U << 5 | 1U << 6);
    tap_point(&p, 5, BAT_SHIFT);
    expect_marked(editor, 1U << 2 | 1U << 6);
    assert_true(digest(editor) == first);
    p.time += 1000;
    drag(&p, place_of(6, 0), place_of(6, 1), place_of(6, 0) + 31, place_of(6, 1) - 12);
    expect_moved(editor, 1U << 2 | 1U << 6, 31, -12);
    assert_int_equal(editor->session.history.done, 1);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    expect_marked(editor, 1U << 2 | 1U << 6); /* still chosen */
    bat_editor_key(editor, "ArrowRight", true, BAT_SHIFT, p.time);
    expect_moved(editor, 1U << 2 | 1U << 6, 10, 0);
    bat_editor_command(editor, "undo");
    tap_point(&p, 4, 0); /* without Shift it is chosen alone */
    expect_marked(editor, 0);
    bat_editor_command(editor, "redo");
    round_trip(editor, first);
    bat_editor_free(editor);
}

static void by_a_box(void **state) {
    (void)state;
    bat_editor *editor = zigzag();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    box(&p, 80, 300, 440, 370, 0); /* the upper points 0, 2, 4 */
    expect_marked(editor, 1U << 0 | 1U << 2 | 1U << 4);
    box(&p, 700, 500, 480, 430, BAT_SHIFT); /* drawn the other way: 5 and 7 of the lower ones, too */
    expect_marked(editor, 1U << 0 | 1U << 2 | 1U << 4 | 1U << 5 | 1U << 7);
    assert_true(digest(editor) == first && editor->session.history.done == 0);
    /* numbers: the one that is chosen goes to that place, the others as far */
    assert_int_equal(pointing(editor)->chosen.index, 0);
    assert_int_equal(bat_editor_enter(editor, "point-y", "350"), BAT_OK);
    expect_moved(editor, 1U << 0 | 1U << 2 | 1U << 4 | 1U << 5 | 1U << 7, 0, 10);
    box(&p, 20, 20, 60, 60, 0); /* around nothing: none is chosen, and the curve stays */
    expect_marked(editor, 0);
    assert_int_equal(pointing(editor)->chosen.kind, BAT_HANDLE_NONE);
    assert_int_equal(pointing(editor)->object, 1);
    box(&p, 20, 300, 900, 500, 0); /* all */
    expect_marked(editor, (1U << POINTS) - 1);
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* Cancelled, or with no curve chosen, nothing comes of it. */
static void what_ends_it(void **state) {
    (void)state;
    bat_editor *editor = zigzag();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    box(&p, 80, 300, 440, 370, 0);
    pen_event(&p, BAT_POINTER_DOWN, 20, 20);
    pen_event(&p, BAT_POINTER_MOVE, 900, 500);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_MARQUEE));
    bat_editor_command(editor, "cancel");
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_MARQUEE));
    pen_event(&p, BAT_POINTER_UP, 900, 500);
    check(editor);
    expect_marked(editor, 1U << 0 | 1U << 2 | 1U << 4);
    bat_editor_command(editor, "point-next"); /* one alone */
    expect_marked(editor, 0);
    box(&p, 80, 300, 440, 370, 0);
    bat_editor_command(editor, "knot-next");
    expect_marked(editor, 0);
    box(&p, 80, 300, 440, 370, 0);
    p.time += 1000;
    drag(&p, place_of(3, 0), place_of(3, 1), place_of(3, 0) + 9,
         place_of(3, 1)); /* one that is none of them */
    expect_marked(editor, 0);
    expect_moved(editor, 1U << 3, 9, 0);
    bat_editor_command(editor, "undo");
    box(&p, 80, 300, 440, 370, 0);
    bat_editor_select(editor, 2, false); /* another curve */
    bat_editor_frame(editor);
    expect_marked(editor, 0);
    check(editor);
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* Points that are deleted together are one step; the ends stay; where nothing can go, it is said. */
static void deleted_together(void **state) {
    (void)state;
    bat_editor *editor = zigzag();
    const uint64_t first = digest(editor);
    double ends[2][2];
    pen p = pen_for(editor);
    box(&p, 80, 300, 440, 370, 0); /* the upper points 0, 2, 4 */
    assert_int_equal(bat_editor_command(editor, "point-delete"), BAT_OK);
    check(editor);
    assert_int_equal(bat_curve_count(curve_of(editor, 0)), POINTS - 2);
    for (int e = 0; e < 2; e++) {
        bat_curve_eval(curve_of(editor, 0), e ? 6 : 0, 0, ends[e]);
        for (int k = 0; k < 2; k++) assert_true(fabs(ends[e][k] - place_of(e ? POINTS - 1 : 0, k)) < 1e-9);
    }
    assert_int_equal(editor->session.history.done, 1);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "moved by at most"));
    expect_marked(editor, 0);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    box(&p, 20, 300, 900, 500, 0); /* all but one: what is left goes from end to end */
    tap_point(&p, 0, BAT_SHIFT);
    assert_int_equal(bat_editor_command(editor, "point-delete"), BAT_OK);
    check(editor);
    assert_int_equal(bat_curve_count(curve_of(editor, 0)), 4);
    bat_editor_command(editor, "undo");
    box(&p, 20, 300, 900, 500, 0);
    bat_editor_key(editor, "Delete", true, 0, p.time); /* all: the object */
    check(editor);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
    assert_int_equal(bat_editor_frame(editor)->selected, 0);
    assert_int_equal(bat_object_id(bat_document_at(bat_editor_document(editor), 0)), 2);
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* As objects are: to the least, middle and greatest of those that are chosen, and to equal distances; the others stay. */
static void lined_up(void **state) {
    (void)state;
    static const struct {
        const char *command;
        int axis;
        double at[3]; /* of points 0, 3 and 8 */
    } cases[] = {{"align-left", 0, {100, 100, 100}},       {"align-centre", 0, {420, 420, 420}},
                 {"align-right", 0, {740, 740, 740}},      {"align-top", 1, {340, 340, 340}},
                 {"align-middle", 1, {400, 400, 400}},     {"align-bottom", 1, {460, 460, 460}},
                 {"distribute-across", 0, {100, 420, 740}}};
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        bat_editor *editor = zigzag();
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        tap_point(&p, 0, 0);
        tap_point(&p, 8, BAT_SHIFT);
        if (n > 5) assert_int_equal(bat_editor_command(editor, cases[n].command), BAT_STATE);
        tap_point(&p, 3, BAT_SHIFT);
        assert_string_equal(bat_editor_number(editor, "points"), "3");
        assert_int_equal(bat_editor_command(editor, cases[n].command), BAT_OK);
        check(editor);
        for (int i = 0, k = 0; i < POINTS; i++)
            for (int d = 0; d < 2; d++) {
                const bool chosen = d == cases[n].axis && bat_pointing_is_marked(pointing(editor), i);
                const double now = bat_curve_points(curve_of(editor, 0))[2 * i + d];
                const double wanted = chosen ? cases[n].at[k++] : place_of(i, d);
                if (fabs(now - wanted) > 1e-9) fail_msg("%s: point %d at %g", cases[n].command, i, now);
            }
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
}

/* With another number of points the marks mean nothing: after a knot is inserted, and after that is undone. */
static void other_numbers_of_points(void **state) {
    (void)state;
    bat_editor *editor = zigzag();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    box(&p, 80, 300, 440, 370, 0);
    pen_event(&p, BAT_POINTER_LEAVE, 0, 0);
    assert_int_equal(bat_editor_command(editor, "point-add"), BAT_OK);
    check(editor);
    expect_marked(editor, 0);
    box(&p, 20, 300, 900, 500, 0);
    assert_int_equal(pointing(editor)->marked, POINTS + 1);
    bat_editor_command(editor, "undo");
    bat_editor_frame(editor);
    check(editor);
    expect_marked(editor, 0);
    assert_true(digest(editor) == first);
    box(&p, 20, 300, 900, 500, 0);
    bat_editor_select(editor, 1, false);
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "delete");
    bat_editor_command(editor, "tool-points");
    bat_editor_frame(editor);
    check(editor);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(with_shift),   cmocka_unit_test(by_a_box),
        cmocka_unit_test(what_ends_it), cmocka_unit_test(deleted_together),
        cmocka_unit_test(lined_up),     cmocka_unit_test(other_numbers_of_points),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
