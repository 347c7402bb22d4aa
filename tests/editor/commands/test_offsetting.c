/*
 * The offset that is shown before it is made: where it lies, by closed forms, as it is dragged, typed and turned to other sides; the
 * drawing stays as it is to the bit until it is kept, which is one step; whatever else is done leaves nothing of it.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"
#include <batten/paint.h>
#include <batten/panels.h>
#include <math.h>
#include <string.h>

static bat_curve *box_at(double x, double y, double side) {
    const double points[8] = {x, y, x + side, y, x + side, y + side, x, y + side}, knots[5] = {0, 1, 2, 3, 4};
    bat_curve *curve;
    assert_int_equal(bat_curve_create(2, 1, true, 4, points, 5, knots, &curve), BAT_OK);
    return curve;
}

/* Boxes of 200 at 100 (1) and of 50 at 600, 100 (2); an open line at y = 700 (3). */
static bat_editor *boxes(void) {
    const double points[4] = {100, 700, 900, 700};
    bat_curve *line;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &line), BAT_OK);
    bat_curve *curves[3] = {box_at(100, 100, 200), box_at(600, 100, 50), line};
    bat_editor *editor = editor_with(3, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static void runs(bat_editor *editor, const char *command) {
    const bat_status status = bat_editor_command(editor, command);
    if (status != BAT_OK) fail_msg("%s: %d", command, (int)status);
    check(editor);
}

static void says(bat_editor *editor, const char *words) {
    const char *readings = bat_editor_readings(editor);
    if (!strstr(readings, words)) fail_msg("%s, not %s", readings, words);
}

/* The box around all that is shown, in the drawing; false: nothing is. */
static bool shown(bat_editor *editor, double box[4]) {
    const bat_frame *frame = bat_editor_frame(editor);
    const bat_item *item = pen_live(frame, BAT_ROLE_FIT);
    for (int k = 0; item && k < 4; k++) box[k] = item->bounds[k] + frame->origin[k % 2];
    return item != NULL;
}

/* The bounds of what is painted have half the width of its line, and some room. */
static void shows(bat_editor *editor, double x0, double y0, double x1, double y1) {
    const double expected[4] = {x0, y0, x1, y1};
    double box[4];
    if (!shown(editor, box)) fail_msg("nothing is shown");
    for (int k = 0; k < 4; k++)
        if (!(fabs(box[k] - expected[k]) < 3))
            fail_msg("%g %g %g %g, not %g %g %g %g", box[0], box[1], box[2], box[3], x0, y0, x1, y1);
}

static bool shows_nothing(bat_editor *editor) {
    double box[4];
    return !shown(editor, box);
}

static double distance(bat_editor *editor) {
    double value;
    assert_int_equal(bat_editor_get(editor, "offset-distance", &value), BAT_OK);
    return value;
}

static double box_off(const bat_editor *editor, bat_id id, const double expected[4]) {
    double box[4], most = 0;
    box_of(editor, id, box);
    for (int k = 0; k < 4; k++) most = fmax(most, fabs(box[k] - expected[k]));
    return most;
}

/* Dragged, typed, on each side: shown, and nothing changes. */
static void it_follows(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 1, 0);
    assert_int_equal(bat_editor_set(editor, "stroke-join", BAT_JOIN_MITER), BAT_OK);
    const uint64_t now = digest(editor);
    const int steps = editor->session.history.done;
    runs(editor, "curve-offset");
    assert_int_not_equal(bat_editor_frame(editor)->readings, 0);
    says(editor, "\"of\":\"offset\"");
    says(editor, "\"chosen\":0,");
    says(editor, "\"typed\":\"offset-distance\",\"ways\":3,\"said\":\"\"");
    shows(editor, 90, 90, 310, 310); /* 10 to begin with */
    static const double amounts[] = {1, 0.5, 0.2, 0.7};
    for (size_t i = 0; i < sizeof amounts / sizeof *amounts; i++) {
        const double d = 100 * amounts[i] * amounts[i]; /* half the side at the slider's end */
        assert_int_equal(bat_editor_refit(editor, amounts[i], i % 2 == 0), BAT_OK);
        if (!(fabs(distance(editor) - d) < 1e-9)) fail_msg("%g, not %g", distance(editor), d);
        shows(editor, 100 - d, 100 - d, 300 + d, 300 + d);
    }
    assert_int_equal(bat_editor_enter(editor, "offset-distance", "25"), BAT_OK);
    shows(editor, 75, 75, 325, 325);
    says(editor, "\"amount\":0.5,");
    assert_int_equal(bat_editor_enter(editor, "offset-distance", "150"), BAT_OK); /* beyond the slider */
    shows(editor, -50, -50, 450, 450);
    says(editor, "\"amount\":1,");
    assert_int_equal(bat_editor_set(editor, "offset-distance", 40), BAT_OK);
    assert_int_equal(bat_editor_read_as(editor, 1), BAT_OK);
    says(editor, "\"chosen\":1,");
    shows(editor, 140, 140, 260, 260);
    runs(editor, "reading-next");
    says(editor, "\"chosen\":2,");
    shows(editor, 60, 60, 340, 340);
    runs(editor, "reading-next");
    says(editor, "\"chosen\":0,");
    assert_int_equal(bat_editor_set(editor, "offset-side", 1), BAT_OK);
    says(editor, "\"chosen\":1,");
    shows(editor, 140, 140, 260, 260);
    assert_true(digest(editor) == now);
    assert_int_equal(editor->session.history.done, steps);
    runs(editor, "cancel");
    assert_true(digest(editor) == now && shows_nothing(editor));
    assert_int_equal(editor->session.history.done, steps);
    assert_int_equal(bat_editor_frame(editor)->readings, 0);
    assert_int_equal(selected(editor), 1);
    bat_editor_free(editor);
}

static void odd_numbers(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 1, 0);
    runs(editor, "curve-offset");
    static const double amounts[] = {NAN, -0.01, 1.01, INFINITY};
    for (size_t i = 0; i < sizeof amounts / sizeof *amounts; i++)
        assert_int_equal(bat_editor_refit(editor, amounts[i], true), BAT_ARGUMENT);
    assert_int_not_equal(bat_editor_set(editor, "offset-distance", NAN), BAT_OK);
    static const char *const texts[] = {"", "0", "-3", "ten", "nan", "1e9", "inf"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        if (bat_editor_enter(editor, "offset-distance", texts[i]) == BAT_OK) fail_msg("%s", texts[i]);
    assert_int_equal(bat_editor_read_as(editor, 4), BAT_ARGUMENT);
    assert_true(distance(editor) == 10);
    shows(editor, 90, 90, 310, 310);
    assert_int_equal(bat_editor_refit(editor, 0, true), BAT_OK); /* the least there is */
    assert_true(distance(editor) == 0.001);
    shows(editor, 100, 100, 300, 300);
    check(editor);
    bat_editor_free(editor);
}

/* Kept by Enter, or by the button: one step, and what was made is selected. */
static void what_is_kept_is_one_step(void **state) {
    (void)state;
    for (int way = 0; way < 2; way++) {
        bat_editor *editor = boxes();
        const uint64_t first = digest(editor);
        bat_editor_command(editor, "select-all");
        assert_int_equal(bat_editor_set(editor, "stroke-join", BAT_JOIN_MITER), BAT_OK);
        const uint64_t now = digest(editor);
        const int steps = editor->session.history.done;
        runs(editor, "curve-offset");
        assert_int_equal(bat_editor_refit(editor, 0.5, true), BAT_OK); /* of the box 800 x 600 */
        assert_true(distance(editor) == 100);
        if (way)
            assert_int_equal(bat_editor_read_as(editor, 3), BAT_OK);
        else
            runs(editor, "accept");
        assert_int_equal(editor->session.history.done, steps + 1);
        assert_int_equal(bat_editor_frame(editor)->readings, 0);
        assert_true(shows_nothing(editor));
        assert_int_equal(selected(editor), 3);
        assert_true(has(editor, 4) && has(editor, 5) && has(editor, 6));
        assert_true(box_off(editor, 6, (double[]){0, 0, 400, 400}) < 0.1);
        assert_true(box_off(editor, 5, (double[]){500, 0, 750, 250}) < 0.1);
        assert_true(box_off(editor, 4, (double[]){100, 600, 900, 600}) < 1e-6);
        runs(editor, "undo");
        assert_true(digest(editor) == now);
        runs(editor, "redo");
        goes_back_and_replays(editor, first);
        bat_editor_free(editor);
    }
}

/* Too far inside: it says so, is not kept, and can be chosen otherwise. */
static void what_vanishes(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 2, 0);
    const uint64_t now = digest(editor);
    runs(editor, "curve-offset");
    assert_int_equal(bat_editor_read_as(editor, 1), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "offset-distance", 25.5), BAT_OK);
    assert_true(shows_nothing(editor));
    says(editor, "\"said\":\"Nothing is left at this distance");
    bat_editor_command(editor, "accept");
    assert_string_equal(bat_editor_frame(editor)->notice, bat_string_english(BAT_STRING_NOTICE_OFFSET_EMPTY));
    assert_int_equal(bat_editor_read_as(editor, 3), BAT_STATE);
    assert_true(digest(editor) == now && has(editor, 2) && selected(editor) == 1);
    assert_int_equal(bat_editor_set(editor, "offset-distance", 20), BAT_OK);
    shows(editor, 620, 120, 630, 130);
    says(editor, "\"said\":\"\"");
    /* of two, what is left of one is kept */
    only(editor, 1, 2);
    assert_int_equal(bat_editor_set(editor, "offset-distance", 50), BAT_OK);
    runs(editor, "curve-offset");
    shows(editor, 150, 150, 250, 250);
    runs(editor, "accept");
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 4);
    expect_box(editor, 4, 150, 150, 250, 250);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* What ends it: nothing is left of it, and a late answer of the page does nothing. */
static void what_ends_it(void **state) {
    (void)state;
    static const char *const ends[] = {"deselect", "select-all", "tool-sketch", "curve-reverse",
                                       "undo",     "delete",     "cancel"};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        bat_editor *one = boxes();
        only(one, 1, 0);
        assert_int_equal(bat_editor_enter(one, "x", "120"), BAT_OK);
        const uint64_t now = digest(one);
        runs(one, "curve-offset");
        assert_int_equal(bat_editor_refit(one, 0.3, true), BAT_OK);
        assert_false(shows_nothing(one));
        runs(one, ends[i]);
        assert_true(shows_nothing(one));
        if (i < 3 || i == 6) assert_true(digest(one) == now);
        assert_int_equal(bat_editor_read_as(one, 3), BAT_STATE);
        const uint64_t then = digest(one);
        assert_int_equal(bat_editor_set(one, "offset-distance", 30), BAT_OK);
        assert_int_equal(bat_editor_set(one, "offset-side", 2), BAT_OK);
        assert_true(shows_nothing(one) && digest(one) == then);
        check(one);
        bat_editor_free(one);
    }
}

/* In a group it lies in the group; what is locked there, or hidden, has none. */
static void groups(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 1, 2);
    assert_int_equal(bat_editor_set(editor, "stroke-join", BAT_JOIN_MITER), BAT_OK);
    runs(editor, "group");
    const bat_id group = bat_object_parent(object(editor, 1));
    runs(editor, "curve-offset");
    shows(editor, 90, 90, 660, 310);
    runs(editor, "accept");
    const int count = bat_document_count(bat_editor_document(editor));
    int inside = 0;
    for (int i = 0; i < count; i++)
        inside += bat_object_parent(bat_document_at(bat_editor_document(editor), i)) == group;
    assert_int_equal(inside, 4);
    runs(editor, "undo");
    for (int hidden = 0; hidden < 2; hidden++) {
        assert_int_equal(bat_editor_set_state(editor, 1, hidden, !hidden), BAT_OK);
        only(editor, group, 0);
        runs(editor, "curve-offset");
        shows(editor, 590, 90, 660, 160);
        runs(editor, "accept");
        assert_int_equal(bat_document_count(bat_editor_document(editor)), count - 1);
        runs(editor, "undo");
        runs(editor, "undo");
    }
    replays(editor, 0);
    bat_editor_free(editor);
}

/* The distance is that of the middle line, however wide; the copy is as wide along itself. */
static void widths_go_along(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 3, 0);
    assert_int_equal(bat_editor_set(editor, "stroke-width", 30), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "widths", 3), BAT_OK);
    assert_int_equal(bat_object_widths(object(editor, 3)).count, 3);
    runs(editor, "curve-offset");
    shows(editor, 100, 690, 900, 690);
    runs(editor, "accept");
    expect_box(editor, 4, 100, 690, 900, 690);
    const bat_width_profile a = bat_object_widths(object(editor, 3)),
                            b = bat_object_widths(object(editor, 4));
    assert_int_equal(a.count, b.count);
    assert_memory_equal(a.stops, b.stops, a.count * sizeof *a.stops);
    bat_editor_free(editor);
}

static void nothing_to_offset(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    bat_editor_command(editor, "deselect");
    assert_int_equal(bat_editor_command(editor, "curve-offset"), BAT_STATE);
    assert_string_equal(bat_editor_frame(editor)->notice, bat_string_english(BAT_STRING_NOTICE_SELECT_FLAT));
    assert_int_equal(bat_editor_frame(editor)->readings, 0);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_follows),      cmocka_unit_test(odd_numbers),
        cmocka_unit_test(what_vanishes),   cmocka_unit_test(what_is_kept_is_one_step),
        cmocka_unit_test(what_ends_it),    cmocka_unit_test(groups),
        cmocka_unit_test(widths_go_along), cmocka_unit_test(nothing_to_offset),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
