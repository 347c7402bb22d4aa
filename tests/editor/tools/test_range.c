/* The range and the waypoints: every edit without a pen. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/editing.h"
#include <batten/editor.h>
#include <batten/measure.h>
#include <batten/nearest.h>

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

static const bat_curve *curve_at(const bat_editor *editor, int index) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), index), 0);
}

/* Presses a key some times, as a keyboard does; the last answer. */
static bool keys(bat_editor *editor, const char *key, uint32_t modifiers, int times) {
    bool used = false;
    for (int i = 0; i < times; i++) {
        used = bat_editor_key(editor, key, true, modifiers, 1000);
        bat_editor_key(editor, key, false, modifiers, 1000);
        bat_editor_frame(editor);
        check(editor);
    }
    return used;
}

/* The value that the range shows: its length, to four figures. */
static double shown_length(bat_editor *editor) {
    const bat_frame *frame = bat_editor_frame(editor);
    for (uint32_t i = 0; i < frame->label_count; i++)
        if (frame->labels[i].role == BAT_ROLE_VALUE) return strtod(frame->labels[i].text, NULL);
    return NAN;
}

static double nearest(const bat_curve *curve, double x, double y) {
    bat_near near;
    assert_int_equal(bat_curve_nearest(curve, (double[]){x, y}, &near), BAT_OK);
    return near.distance;
}

/* A circle of radius 150 to a thousandth, as twelve cubic spans. */
static bat_curve *ring(void) {
    double points[24], knots[13], r = 150 * 3 / (2 + cos(0.5235987755982988));
    for (int i = 0; i < 12; i++) {
        points[2 * i] = 500 + r * cos(6.283185307179586 * i / 12);
        points[2 * i + 1] = 400 + r * sin(6.283185307179586 * i / 12);
    }
    for (int i = 0; i <= 12; i++) knots[i] = i;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 3, true, 12, points, 13, knots, &curve), BAT_OK);
    return curve;
}

static bat_editor *ring_editor(void) {
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, ring());
    editor = editor_of(document);
    return editor;
}

/* On a straight line from x = 200 to 800 every length is known. */
static void ends_go_along_the_curve_and_not_past_each_other(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    assert_true(keys(editor, "T", BAT_SHIFT, 1));
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_CHOSEN));
    assert_float_equal(shown_length(editor), 200, 1e-9); /* the middle third */
    keys(editor, "ArrowLeft", 0, 5);
    assert_float_equal(shown_length(editor), 220, 1e-9);
    keys(editor, "ArrowLeft", BAT_SHIFT, 2);
    assert_float_equal(shown_length(editor), 300, 1e-9);
    keys(editor, "ArrowUp", 0, 1); /* the other end */
    keys(editor, "ArrowRight", BAT_SHIFT, 1);
    assert_float_equal(shown_length(editor), 340, 1e-9);
    keys(editor, "ArrowRight", BAT_SHIFT, 20); /* to the curve's end: from x = 300 to 800 */
    assert_float_equal(shown_length(editor), 500, 1e-9);
    keys(editor, "ArrowLeft", BAT_SHIFT, 30);
    assert_float_equal(shown_length(editor), 2, 1e-6);
    keys(editor, "ArrowDown", 0, 1);
    keys(editor, "ArrowRight", BAT_SHIFT, 3);
    assert_float_equal(shown_length(editor), 2, 1e-6);
    assert_true(digest(editor) == first);
    assert_true(keys(editor, "Escape", 0, 1));
    assert_false(keys(editor, "Escape", 0, 1));
    bat_editor_free(editor);
}

static void an_end_stops_at_knots(void **state) {
    (void)state;
    bat_editor *editor = pen_editor(); /* knots 0 to 8; the spans within are 60 long */
    keys(editor, "T", BAT_SHIFT, 1);
    keys(editor, ",", 0, 40);
    assert_float_equal(shown_length(editor), 400, 1e-3);
    keys(editor, "ArrowUp", 0, 1);
    keys(editor, ".", 0, 40);
    assert_float_equal(shown_length(editor), 600, 1e-3);
    bat_editor_free(editor);
}

/* Once round a ring and a bit: the end stops where the other one is. */
static void a_range_on_a_ring_is_at_most_all_of_it(void **state) {
    (void)state;
    bat_editor *editor = ring_editor();
    double whole = bat_curve_length(curve_at(editor, 0), 0, 12, 1e-9);
    keys(editor, "T", BAT_SHIFT, 1);
    assert_float_equal(shown_length(editor), whole / 3, 0.05);
    keys(editor, "ArrowUp", 0, 1);
    keys(editor, "ArrowRight", BAT_SHIFT, 10);
    assert_float_equal(shown_length(editor), whole / 3 + 400, 0.05);
    keys(editor, "ArrowRight", BAT_SHIFT, 30);
    assert_float_equal(shown_length(editor), whole, 0.1);
    keys(editor, "ArrowDown", 0, 1);
    keys(editor, "ArrowRight", BAT_SHIFT, 60);
    assert_float_equal(shown_length(editor), 2, 0.01);
    keys(editor, ".", 0, 3);
    keys(editor, ",", 0, 5);
    bat_editor_free(editor);
}

/* The height of the end that is held. */
static double held_at(bat_editor *editor) {
    const bat_frame *frame = bat_editor_frame(editor);
    const bat_item *item = pen_live(frame, BAT_ROLE_CHOSEN);
    return item ? ((double)item->bounds[1] + (double)item->bounds[3]) / 2 + frame->origin[1] : NAN;
}

static void tab_goes_through_the_curves_and_on(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    assert_false(keys(editor, "Tab", 0, 1)); /* it belongs to the page */
    keys(editor, "T", BAT_SHIFT, 1);         /* of two that are as near, the one in front */
    assert_float_equal(held_at(editor), 600, 1e-3);
    assert_true(keys(editor, "Tab", BAT_SHIFT, 1));
    assert_float_equal(held_at(editor), 200, 1e-3);
    assert_true(keys(editor, "Tab", 0, 1));
    assert_float_equal(held_at(editor), 600, 1e-3);
    assert_false(keys(editor, "Tab", 0, 1));
    assert_true(isnan(held_at(editor)));
    keys(editor, "v", 0, 1);
    keys(editor, "Tab", 0, 1); /* selects the one behind, which the range then begins on */
    keys(editor, "T", BAT_SHIFT, 1);
    assert_float_equal(held_at(editor), 200, 1e-3);
    bat_editor_free(editor);
}

/* A stretch is lifted over one point: the curve goes there, and is as it was elsewhere. */
static void redraws_a_range(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    bat_editor_select(editor, 1, false);
    keys(editor, "T", BAT_SHIFT, 1); /* x = 400 to 600 of the line y = 200 */
    keys(editor, "Enter", 0, 1);
    assert_true(digest(editor) == first);
    keys(editor, "ArrowUp", BAT_SHIFT, 4); /* the middle one of five: to (500, 160) */
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_STRETCH));
    assert_true(bat_editor_frame(editor)->knots_after > 0);
    keys(editor, "Enter", 0, 1);
    assert_true(digest(editor) != first);
    assert_int_equal(count(editor), 2);
    const bat_curve *now = curve_at(editor, 0);
    assert_true(nearest(now, 500, 160) < 1.5);
    for (int i = 0; i <= 200; i++) { /* well outside: to the bit of rounding */
        double x = i <= 100 ? 200 + 1.2 * i : 680 + 1.2 * (i - 100);
        assert_true(nearest(now, x, 200) < 1e-9);
    }
    assert_true(nearest(now, 500, 200) > 30);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_CHOSEN)); /* done */
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* Waypoints that nobody has moved redraw the stretch as it is. */
static void unmoved_waypoints_leave_the_line(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    keys(editor, "T", BAT_SHIFT, 1);
    keys(editor, "Enter", 0, 2);
    for (int i = 0; i <= 100; i++) {
        assert_true(nearest(curve_at(editor, 0), 200 + 6 * i, 200) < 0.1);
        assert_true(nearest(curve_at(editor, 1), 200 + 6 * i, 600) < 0.1);
    }
    bat_editor_free(editor);
}

/* More than half of a ring over its seam: the ring stays closed, the rest stays where it was. */
static void redraws_over_the_seam(void **state) {
    (void)state;
    bat_editor *editor = ring_editor();
    uint64_t first = digest(editor);
    keys(editor, "T", BAT_SHIFT, 1);
    keys(editor, "ArrowLeft", BAT_SHIFT, 12); /* from a third of 942 back over the seam: 314 + 480 long */
    assert_true(shown_length(editor) > 780);
    keys(editor, "Enter", 0, 1);
    for (int i = 0; i < 3; i++) keys(editor, i == 1 ? "ArrowUp" : "ArrowLeft", BAT_SHIFT, 2);
    keys(editor, "Enter", 0, 1);
    assert_true(digest(editor) != first);
    assert_int_equal(count(editor), 1);
    const bat_curve *now = curve_at(editor, 0);
    assert_true(bat_curve_is_closed(now));
    double domain[2];
    bat_curve *was = ring();
    int same = 0;
    bat_curve_domain(was, domain);
    for (int i = 0; i < 120; i++) {
        double p[2];
        bat_curve_eval(was, domain[0] + (domain[1] - domain[0]) * i / 120, 0, p);
        same += nearest(now, p[0], p[1]) < 1e-9;
    }
    assert_true(same > 4 && same < 60);
    bat_curve_free(was);
    round_trip(editor, first);
    bat_editor_free(editor);
}

static void waypoints_are_added_and_taken_out(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    keys(editor, "T", BAT_SHIFT, 1);
    keys(editor, "Enter", 0, 1);
    keys(editor, "Insert", 0, 3);
    keys(editor, "Tab", 0, 9);
    keys(editor, "Tab", BAT_SHIFT, 4);
    keys(editor, "Delete", 0, 20); /* all but the ends */
    keys(editor, "Insert", 0, 300);
    keys(editor, "Escape", 0, 1); /* back to the range */
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_CHOSEN));
    keys(editor, "Escape", 0, 1);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_CHOSEN));
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* A new line through (500, 400), (600, 400), (700, 300): Enter, keys, Enter ... Enter twice at the end. */
static void draws_a_curve_by_keys(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    assert_true(keys(editor, "Enter", 0, 1));
    keys(editor, "Enter", 0, 1);
    keys(editor, "ArrowRight", BAT_CTRL, 1);
    keys(editor, "Enter", 0, 1);
    keys(editor, "ArrowRight", BAT_SHIFT, 10);
    keys(editor, "ArrowUp", BAT_CTRL, 1);
    keys(editor, "Enter", 0, 1);
    assert_int_equal(count(editor), 2);
    keys(editor, "Enter", 0, 1);
    assert_int_equal(count(editor), 3);
    const bat_curve *made = curve_at(editor, 2);
    assert_true(nearest(made, 500, 400) < 1.5);
    assert_true(nearest(made, 600, 400) < 1.5);
    assert_true(nearest(made, 700, 300) < 1.5);
    assert_false(bat_curve_is_closed(made));
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* One place is no line; Escape leaves nothing behind; the last point put is taken back. */
static void a_dot_is_told(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    keys(editor, "Enter", 0, 3);
    assert_true(digest(editor) == first);
    keys(editor, "ArrowRight", BAT_SHIFT, 2);
    keys(editor, "Enter", 0, 1);
    keys(editor, "Backspace", 0, 9);
    keys(editor, "Escape", 0, 1);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_CHOSEN));
    assert_true(digest(editor) == first);
    bat_editor_command(editor, "tool-pan");
    assert_false(keys(editor, "Enter", 0, 1));
    bat_editor_free(editor);
}

/* The same keys in the tangents tool make a spline with just these points; back at the first, a closed one. */
static void begins_a_spline_by_keys(void **state) {
    (void)state;
    for (int closed = 0; closed < 2; closed++) {
        bat_editor *editor = pen_editor();
        uint64_t first = digest(editor);
        bat_editor_command(editor, "tool-tangents");
        keys(editor, "Enter", 0, 2);
        keys(editor, "ArrowRight", BAT_CTRL, 1);
        keys(editor, "Enter", 0, 1);
        keys(editor, "ArrowUp", BAT_CTRL, 1);
        keys(editor, "Enter", 0, 1);
        if (closed) {
            keys(editor, "ArrowLeft", BAT_CTRL, 1);
            keys(editor, "ArrowDown", BAT_CTRL, 1);
            keys(editor, "Enter", 0, 1);
        }
        keys(editor, "Enter", 0, 1);
        assert_int_equal(count(editor), 3);
        const bat_spline *spline = bat_object_spline(bat_document_at(bat_editor_document(editor), 2));
        const double points[] = {500, 400, 600, 400, 600, 300};
        assert_non_null(spline);
        assert_int_equal(spline->closed, closed);
        assert_int_equal(spline->count, 3);
        for (int i = 0; i < 6; i++) assert_float_equal(spline->points[i], points[i], 1e-9);
        keys(editor, "ArrowRight", 0, 1); /* the first point is chosen and goes on */
        spline = bat_object_spline(bat_document_at(bat_editor_document(editor), 2));
        assert_float_equal(spline->points[0], 501, 1e-9);
        round_trip(editor, first);
        bat_editor_free(editor);
    }
}

/* What is left is the old curve, and the gap is the range. */
static void rubs_out_a_range(void **state) {
    (void)state;
    for (int tool = 0; tool < 2; tool++) {
        bat_editor *editor = pen_editor();
        uint64_t first = digest(editor);
        bat_editor_select(editor, 1, false);
        keys(editor, "T", BAT_SHIFT, 1);
        if (tool) keys(editor, "e", 0, 1); /* the range stays while the tool changes */
        assert_true(!tool || pen_live(bat_editor_frame(editor), BAT_ROLE_ERASED));
        keys(editor, tool ? "Enter" : "Delete", 0, 1);
        assert_int_equal(count(editor), 3);
        double a[2], b[2], domain[2];
        bat_curve_domain(curve_at(editor, 0), domain);
        bat_curve_eval_left(curve_at(editor, 0), domain[1], 0, a);
        bat_curve_domain(curve_at(editor, 1), domain);
        bat_curve_eval(curve_at(editor, 1), domain[0], 0, b);
        assert_float_equal(a[0], 400, 1e-6);
        assert_float_equal(b[0], 600, 1e-6);
        assert_float_equal(a[1], 200, 1e-9);
        round_trip(editor, first);
        bat_editor_free(editor);
    }
    bat_editor *editor = ring_editor();
    uint64_t first = digest(editor);
    keys(editor, "T", BAT_SHIFT, 1);
    keys(editor, "ArrowLeft", BAT_SHIFT, 10);
    double left = bat_curve_length(curve_at(editor, 0), 0, 12, 1e-9) - shown_length(editor);
    keys(editor, "Delete", 0, 1);
    assert_int_equal(count(editor), 1);
    double domain[2];
    bat_curve_domain(curve_at(editor, 0), domain);
    assert_false(bat_curve_is_closed(curve_at(editor, 0)));
    assert_float_equal(bat_curve_length(curve_at(editor, 0), domain[0], domain[1], 1e-9), left, 0.1);
    round_trip(editor, first);
    bat_editor_free(editor);
}

static double trembling(const bat_curve *curve, double from, double to) {
    double sum = 0, p[2];
    for (int i = 0; i <= 400; i++) {
        bat_curve_eval(curve, from + (to - from) * i / 400, 0, p);
        sum += fabs(p[1] - 150);
    }
    return sum / 401;
}

/* The middle third trembles less, the ends as before, to the bit. */
static void smooths_a_range(void **state) {
    (void)state;
    for (int calm = 0; calm < 2; calm++) {
        bat_document *document = NULL;
        bat_editor *editor = NULL;
        bat_document_create(&document);
        pen_add(document, pen_curve(200, 150, 20, 2.5, 31));
        bat_editor_create(&editor);
        bat_editor_resize(editor, 1000, 800, 1);
        bat_editor_open(editor, document, "test");
        bat_editor_command(editor, "zoom-100");
        bat_editor_set(editor, "tolerance", 5);
        uint64_t first = digest(editor);
        double before = trembling(curve_at(editor, 0), 11, 17);
        keys(editor, "T", BAT_SHIFT, 1);
        if (!calm) keys(editor, "s", 0, 1);
        keys(editor, calm ? "g" : "Enter", 0, 1);
        assert_true(digest(editor) != first);
        bat_curve *old = pen_curve(200, 150, 20, 2.5, 31);
        for (int i = 0; i < 100; i++) {
            double p[2];
            bat_curve_eval(old, i < 50 ? 0.1 * i : 23 + 0.1 * (i - 50), 0, p);
            assert_true(nearest(curve_at(editor, 0), p[0], p[1]) < 1e-9);
        }
        double moved = 0;
        for (int i = 0; i < 100; i++) {
            double p[2];
            bat_near near;
            bat_curve_eval(old, 11 + 0.06 * i, 0, p);
            bat_curve_nearest(curve_at(editor, 0), (double[]){p[0], 150}, &near);
            moved += near.distance;
        }
        assert_true(moved / 100 < before / 2);
        bat_curve_free(old);
        round_trip(editor, first);
        bat_editor_free(editor);
    }
}

/* Rotation and scale about the middle: the box has them in closed form. */
static void scales_and_turns_the_selection(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    double box[4];
    bat_editor_command(editor, "tool-select");
    assert_true(keys(editor, "Tab", 0, 1));
    keys(editor, "ArrowUp", BAT_CTRL | BAT_SHIFT, 1);
    bat_object_bounds(bat_document_at(bat_editor_document(editor), 0), box);
    assert_float_equal(box[0], 500 - 330, 1e-9);
    assert_float_equal(box[2], 500 + 330, 1e-9);
    keys(editor, "ArrowDown", BAT_CTRL | BAT_SHIFT, 1);
    keys(editor, "ArrowRight", BAT_CTRL | BAT_SHIFT, 6);
    bat_object_bounds(bat_document_at(bat_editor_document(editor), 0), box);
    assert_float_equal(box[0], 500, 1e-9);
    assert_float_equal(box[1], -100, 1e-9);
    assert_float_equal(box[3], 500, 1e-9);
    keys(editor, "ArrowLeft", BAT_CTRL, 90);
    bat_object_bounds(bat_document_at(bat_editor_document(editor), 0), box);
    assert_float_equal(box[1], 200, 1e-9);
    assert_float_equal(box[3], 200, 1e-9);
    assert_true(keys(editor, "Tab", 0, 1));
    assert_false(keys(editor, "Tab", 0, 1)); /* no trap */
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* A pen that comes down takes over; undo takes the curve from under the range. */
static void the_pen_takes_over(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    uint64_t first = digest(editor);
    pen p = pen_for(editor);
    keys(editor, "T", BAT_SHIFT, 1);
    keys(editor, "Enter", 0, 1);
    pen_line(&p, 300, 400, 500, 380, 20);
    bat_editor_frame(editor);
    check(editor);
    assert_int_equal(count(editor), 3);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_CHOSEN));
    keys(editor, "T", BAT_SHIFT, 1); /* on the new curve: the pen is near */
    keys(editor, "Enter", 0, 1);
    keys(editor, "z", BAT_CTRL, 2);
    assert_true(digest(editor) == first);
    bat_editor_frame(editor);
    check(editor);
    keys(editor, "T", BAT_SHIFT, 1);
    bat_editor_key(editor, "+", true, 0, 0);
    bat_editor_frame(editor);
    check(editor);
    keys(editor, "Enter", 0, 1);
    bat_editor_key(editor, "+", true, 0, 0); /* another view: the stroke is another */
    keys(editor, "ArrowUp", BAT_SHIFT, 2);
    bat_document *empty = NULL;
    bat_document_create(&empty);
    bat_editor_open(editor, empty, "");
    bat_editor_frame(editor);
    check(editor);
    assert_false(keys(editor, "T", BAT_SHIFT, 1));
    bat_editor_free(editor);
}

/* Keys at random, in all tools: the invariants hold, undo leads back, the journal replays. */
static void wild_keys(void **state) {
    (void)state;
    static const struct {
        const char *key;
        uint32_t modifiers;
    } all[] = {{"T", BAT_SHIFT},
               {"Enter", 0},
               {"Enter", 0},
               {"ArrowLeft", BAT_SHIFT},
               {"ArrowUp", 0},
               {"ArrowRight", BAT_CTRL},
               {"ArrowDown", BAT_CTRL},
               {"Tab", 0},
               {"Delete", 0},
               {"Insert", 0},
               {"Escape", 0},
               {"n", 0},
               {"s", 0},
               {"e", 0},
               {"p", 0},
               {"v", 0},
               {"a", 0},
               {"g", 0},
               {".", 0},
               {",", 0},
               {"z", BAT_CTRL},
               {"y", BAT_CTRL},
               {"+", 0},
               {"f", 0},
               {"ArrowUp", BAT_SHIFT},
               {"ArrowUp", BAT_SHIFT},
               {"Tab", BAT_SHIFT},
               {"a", BAT_CTRL}};
    uint64_t mix = 99;
    for (int session = 0; session < 12; session++) {
        bat_editor *editor = session % 2 ? pen_editor() : ring_editor();
        uint64_t first = digest(editor);
        for (int i = 0; i < 300; i++) {
            mix = mix * 6364136223846793005u + 1442695040888963407u;
            size_t k = (size_t)(mix >> 33) % (sizeof all / sizeof *all);
            keys(editor, all[k].key, all[k].modifiers, 1);
        }
        keys(editor, "Escape", 0, 3);
        while (bat_editor_command(editor, "redo") == BAT_OK) bat_editor_frame(editor);
        check(editor);
        round_trip(editor, first);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_go_along_the_curve_and_not_past_each_other),
        cmocka_unit_test(an_end_stops_at_knots),
        cmocka_unit_test(a_range_on_a_ring_is_at_most_all_of_it),
        cmocka_unit_test(tab_goes_through_the_curves_and_on),
        cmocka_unit_test(redraws_a_range),
        cmocka_unit_test(unmoved_waypoints_leave_the_line),
        cmocka_unit_test(redraws_over_the_seam),
        cmocka_unit_test(waypoints_are_added_and_taken_out),
        cmocka_unit_test(draws_a_curve_by_keys),
        cmocka_unit_test(a_dot_is_told),
        cmocka_unit_test(begins_a_spline_by_keys),
        cmocka_unit_test(rubs_out_a_range),
        cmocka_unit_test(smooths_a_range),
        cmocka_unit_test(scales_and_turns_the_selection),
        cmocka_unit_test(the_pen_takes_over),
        cmocka_unit_test(wild_keys),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
