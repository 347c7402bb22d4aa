/* The width tool: strokes pulled wider and narrower, stops that are moved along the curve and taken out, numbers, keys; each a
 * step, undone and replayed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/real.h"
#include "editor/editor.h"
#include "editor/edit/breadths.h"
#include "support/selecting.h"
#include <batten/paint.h>

#include <math.h>
#include <string.h>

enum { WIDTH = 20, RADIUS = 100 };

static bat_curve *line(double x0, double x1, double y) {
    const double points[4] = {x0, y, x1, y};
    bat_curve *made;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &made), BAT_OK);
    return made;
}

/* About 500, 500, from its right on; y grows downwards, and the angle with it. */
static bat_curve *circle(void) {
    double points[2 * 16], knots[17];
    for (int i = 0; i < 16; i++) {
        const double angle = BAT_PI * (i - 1) / 8; /* the first place lies at the second point */
        points[2 * i] = 500 + RADIUS * bat_cos(angle), points[2 * i + 1] = 500 + RADIUS * bat_sin(angle);
        knots[i] = i;
    }
    knots[16] = 16;
    bat_curve *made;
    assert_int_equal(bat_curve_create(2, 3, true, 16, points, 17, knots, &made), BAT_OK);
    return made;
}

/* A line along y = 300 from 100 to 500, a short one behind it, and a circle; strokes 20 wide. */
static bat_editor *strokes(void) {
    bat_curve *curves[3] = {line(100, 500, 300), line(600, 800, 300), circle()};
    bat_editor *editor = editor_with(3, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "select-all"), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "stroke-width", WIDTH), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "deselect"), BAT_OK);
    assert_true(bat_editor_key(editor, "W", true, BAT_SHIFT, 0));
    assert_int_equal(bat_editor_frame(editor)->tool, bat_tool_that(BAT_EDITS_WIDTHS));
    return editor;
}

static double width_at(bat_editor *editor, int id, double at) {
    const bat_object *object = bat_document_at(bat_editor_document(editor), id - 1);
    const bat_width_profile profile = bat_object_widths(object);
    double value[2];
    bat_width_eval(&profile, bat_curve_is_closed(bat_object_curve(object, 0)), at, value);
    return value[0] * bat_object_style(object)->width;
}

static size_t stops_of(bat_editor *editor, int id) {
    return bat_object_widths(bat_document_at(bat_editor_document(editor), id - 1)).count;
}

static void is_about(double found, double wanted) {
    if (!(fabs(found - wanted) < 1e-2)) fail_msg("%.9g is not %.9g", found, wanted);
}

static void key(bat_editor *editor, const char *key, uint32_t modifiers) {
    bat_editor_key(editor, key, true, modifiers, 0);
    bat_editor_frame(editor);
    check(editor);
}

static void pulls_out_and_in(void **state) {
    (void)state;
    bat_editor *editor = strokes();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    drag(&p, 300, 302, 300, 317); /* away by 15: wider by 15 on either side */
    assert_int_equal(stops_of(editor, 1), 3);
    is_about(width_at(editor, 1, 0.5), WIDTH + 30);
    is_about(width_at(editor, 1, 0), WIDTH);
    is_about(width_at(editor, 1, 1), WIDTH);
    for (int i = 0; i < 20; i++) /* it falls off evenly on both sides, and never again rises */
        assert_true(width_at(editor, 1, i / 40.0) <= width_at(editor, 1, (i + 1) / 40.0) &&
                    fabs(width_at(editor, 1, i / 40.0) - width_at(editor, 1, 1 - i / 40.0)) < 1e-6);
    assert_int_equal(stops_of(editor, 2), 0);
    drag(&p, 300, 325, 300, 310); /* its handle, towards the curve */
    is_about(width_at(editor, 1, 0.5), WIDTH);
    assert_int_equal(stops_of(editor, 1), 0); /* what is flat needs no stops */
    drag(&p, 500, 290, 500, 250);             /* the end: on the other side, to nothing */
    is_about(width_at(editor, 1, 1), WIDTH + 80);
    drag(&p, 500, 350, 500, 220);
    is_about(width_at(editor, 1, 1), 0);
    for (int i = 0; i < 4; i++) bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    for (int i = 0; i < 4; i++) bat_editor_command(editor, "redo");
    is_about(width_at(editor, 1, 1), 0);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void is_seen_while_it_is_dragged(void **state) {
    (void)state;
    bat_editor *editor = strokes();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_HOVER, 200, 301);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_non_null(pen_live(frame, BAT_ROLE_HANDLE));
    bool said = false;
    for (uint32_t i = 0; i < frame->label_count; i++) said = said || strstr(frame->labels[i].text, "20");
    assert_true(said);
    drag_to(&p, 200, 301, 200, 321);
    assert_true(digest(editor) != first);
    is_about(width_at(editor, 1, 0.25), WIDTH + 40);
    bat_editor_key(editor, "Escape", true, 0, 0);
    assert_true(digest(editor) == first);
    pen_event(&p, BAT_POINTER_UP, 200, 321);
    check(editor);
    assert_true(digest(editor) == first);
    drag(&p, 200, 301, 200, 303); /* a tap changes nothing */
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

static void stops_move_along_and_go(void **state) {
    (void)state;
    bat_editor *editor = strokes();
    pen p = pen_for(editor);
    drag(&p, 300, 302, 300, 322);
    const uint64_t wide = digest(editor);
    drag(&p, 300, 300, 400, 303); /* its middle, along the curve */
    assert_int_equal(stops_of(editor, 1), 3);
    is_about(width_at(editor, 1, 0.75), WIDTH + 40);
    drag(&p, 400, 300, 900, 300); /* not past its neighbour */
    assert_int_equal(stops_of(editor, 1), 3);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == wide);
    tap(&p, 300, 300);
    key(editor, "Delete", 0);
    assert_int_equal(stops_of(editor, 1), 0); /* a flat line is flat again */
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 3);
    tap(&p, 100, 300); /* the ends are there for the hand alone */
    key(editor, "Delete", 0);
    assert_int_equal(stops_of(editor, 1), 0);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 3);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void a_closed_curve_has_no_end(void **state) {
    (void)state;
    bat_editor *editor = strokes();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    const bat_curve *curve = bat_object_curve(bat_document_at(bat_editor_document(editor), 2), 0);
    double domain[2], at[2];
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0] + 1, 0, at);
    const double out = bat_hypot(at[0] - 500, at[1] - 500), x = (at[0] - 500) / out, y = (at[1] - 500) / out;
    drag(&p, at[0] + x, at[1] + y, at[0] + 11 * x, at[1] + 11 * y);
    assert_int_equal(stops_of(editor, 3), 2);
    is_about(width_at(editor, 3, 1.0 / 16), WIDTH + 20);
    is_about(width_at(editor, 3, 9.0 / 16), WIDTH);
    assert_true(fabs(width_at(editor, 3, 0) - width_at(editor, 3, 1)) < 1e-9);
    is_about(width_at(editor, 3, 0),
             width_at(editor, 3, 2.0 / 16)); /* as much on either side, past the seam */
    double over[2];
    bat_curve_eval(curve, domain[0] + 15, 0, over);
    drag(&p, at[0], at[1], over[0], over[1]); /* over the seam */
    is_about(width_at(editor, 3, 15.0 / 16), WIDTH + 20);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void works_by_keys_and_numbers(void **state) {
    (void)state;
    bat_editor *editor = strokes();
    const uint64_t first = digest(editor);
    key(editor, "Tab", 0); /* the first curve, its start */
    assert_string_equal(bat_editor_number(editor, "width-here"), "20 px");
    assert_string_equal(bat_editor_number(editor, "width-place"), "0 px");
    key(editor, "ArrowUp", 0);
    is_about(width_at(editor, 1, 0), WIDTH + 2);
    key(editor, "ArrowDown", BAT_SHIFT);
    is_about(width_at(editor, 1, 0), WIDTH - 18);
    key(editor, "Insert", 0);
    assert_int_equal(stops_of(editor, 1), 3);
    assert_string_equal(bat_editor_number(editor, "width-place"), "200 px");
    key(editor, "ArrowRight", BAT_SHIFT);
    assert_string_equal(bat_editor_number(editor, "width-place"), "210 px");
    assert_int_equal(bat_editor_enter(editor, "width-here", "1cm"), BAT_OK);
    is_about(width_at(editor, 1, 0.525), 96 / 2.54);
    assert_int_equal(bat_editor_enter(editor, "width-place", "100"), BAT_OK);
    is_about(width_at(editor, 1, 0.25), 96 / 2.54);
    assert_int_equal(bat_editor_enter(editor, "width-here", "-1"), BAT_ARGUMENT);
    assert_int_equal(bat_editor_enter(editor, "width-here", "much"), BAT_SYNTAX);
    bat_editor_frame(editor);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    assert_int_equal(bat_editor_frame(editor)->requests, BAT_ASK_WIDTH);
    key(editor, "Shift+Tab", 0);
    key(editor, "Tab", BAT_SHIFT);
    for (int i = 0; i < 6; i++) bat_editor_command(editor, "undo");
    check(editor);
    assert_true(digest(editor) == first);
    assert_string_equal(bat_editor_number(editor, "width-here"), "20 px");
    key(editor, "Escape", 0);
    assert_string_equal(bat_editor_number(editor, "width-here"), "");
    replays(editor, 0);
    bat_editor_free(editor);
}

static void a_double_tap_asks_for_the_number(void **state) {
    (void)state;
    bat_editor *editor = strokes();
    pen p = pen_for(editor);
    for (int i = 0; i < 2; i++) {
        pen_event(&p, BAT_POINTER_DOWN, 200, 300);
        pen_event(&p, BAT_POINTER_UP, 200, 300);
    }
    assert_int_equal(bat_editor_frame(editor)->requests, BAT_ASK_WIDTH);
    assert_string_equal(bat_editor_number(editor, "width-place"), "100 px");
    assert_int_equal(bat_editor_enter(editor, "width-here", "60"), BAT_OK);
    is_about(width_at(editor, 1, 0.25), 60);
    check(editor);
    bat_editor_free(editor);
}

static void leaves_alone_what_stays_as_wide(void **state) {
    (void)state;
    bat_editor *editor = strokes();
    only(editor, 1, 0);
    assert_int_equal(bat_editor_set(editor, "dashes", 1), BAT_OK);
    bat_editor_command(editor, "deselect");
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    drag(&p, 300, 302, 300, 322);
    tap(&p, 300, 302);
    assert_true(digest(editor) == first);
    key(editor, "Tab", 0); /* the first that can */
    assert_int_equal(bat_editor_enter(editor, "width-here", "40"), BAT_OK);
    is_about(width_at(editor, 2, 0), 40);
    bat_editor_free(editor);
}

/* Any pulls, slides and removals keep a profile. */
static void stay_profiles(void **state) {
    (void)state;
    uint64_t seed = 7;
    for (int closed = 0; closed < 2; closed++) {
        bat_breadths b = {.closed = closed};
        if (!closed) b.count = 2, b.stops[0] = (bat_width_stop){0, 1}, b.stops[1] = (bat_width_stop){1, 1};
        for (int i = 0; i < 2000; i++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            const double at = (double)(seed >> 33) / 2147483648.0;
            const int index = b.count ? (int)((seed >> 20) % b.count) : 0;
            if (i % 3 == 0) {
                const double share = bat_breadths_at(&b, at);
                const int added = bat_breadths_add(&b, at);
                assert_true(added < 0 || fabs(b.stops[added].share - share) < 1e-2);
                if (added >= 0) b.stops[added].share = at * 3;
            } else if (i % 3 == 1 && b.count) {
                const double share = b.stops[index].share;
                const int now = bat_breadths_slide(&b, index, at);
                assert_true(b.stops[now].share == share);
            } else if (i % 7 == 0 && b.count)
                bat_width_remove(&b.count, b.stops, index);
            assert_int_equal(bat_width_check(&(bat_width_profile){b.count, b.stops}, NULL), BAT_OK);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pulls_out_and_in),
        cmocka_unit_test(is_seen_while_it_is_dragged),
        cmocka_unit_test(stops_move_along_and_go),
        cmocka_unit_test(a_closed_curve_has_no_end),
        cmocka_unit_test(works_by_keys_and_numbers),
        cmocka_unit_test(a_double_tap_asks_for_the_number),
        cmocka_unit_test(leaves_alone_what_stays_as_wide),
        cmocka_unit_test(stay_profiles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
