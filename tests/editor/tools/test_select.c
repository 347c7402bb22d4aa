/* The select tool and what is done with a selection: state by state, undo, replay, transforms as properties. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "curve/curve.h"
#include "document/nesting.h"
#include "base/matrix.h"
#include "editor/edit/affine.h"
#include "editor/edit/arrange.h"
#include "editor/edit/curves_of.h"
#include "editor/editor.h"
#include "editor/session/transaction.h"
#include "support/editing.h"
#include <batten/measure.h>
#include <batten/refine.h>

static void drag_holding(pen *p, double x0, double y0, double x1, double y1, uint32_t modifiers) {
    p->modifiers = modifiers;
    drag(p, x0, y0, x1, y1);
    p->modifiers = 0;
}

static bat_editor *select_editor(void) {
    bat_editor *editor = pen_editor(); /* lines 1 (y = 200) and 2 (y = 600), x 200 to 800 */
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static pen mouse(bat_editor *editor) {
    pen p = pen_for(editor);
    p.device = BAT_DEVICE_MOUSE;
    return p;
}

static void click(pen *p, double x, double y, uint32_t modifiers) {
    p->modifiers = modifiers;
    pen_event(p, BAT_POINTER_HOVER, x, y);
    pen_event(p, BAT_POINTER_DOWN, x, y);
    pen_event(p, BAT_POINTER_UP, x, y);
    p->modifiers = 0;
    assert_null(bat_editor_check(p->editor));
}

static int selected(const bat_editor *editor) { return editor->choice.selection.count; }
static bool has(const bat_editor *editor, bat_id id) {
    return bat_selection_has(&editor->choice.selection, id);
}

static const bat_object *object(const bat_editor *editor, bat_id id) {
    return bat_document_at(editor->session.document, bat_document_find(editor->session.document, id));
}

static void box_of(const bat_editor *editor, bat_id id, double box[4]) {
    assert_non_null(object(editor, id));
    bat_object_bounds(object(editor, id), box);
}

static void expect_box(const bat_editor *editor, bat_id id, double x0, double y0, double x1, double y1) {
    double box[4], expected[4] = {x0, y0, x1, y1};
    box_of(editor, id, box);
    for (int k = 0; k < 4; k++)
        if (fabs(box[k] - expected[k]) > 1e-9)
            fail_msg("box %g %g %g %g, not %g %g %g %g", box[0], box[1], box[2], box[3], x0, y0, x1, y1);
}

/* Undoes all, redoes all, replays: the digests agree at both ends. */
static void goes_back_and_replays(bat_editor *editor, uint64_t first) {
    uint64_t last = digest(editor);
    int steps = 0;
    while (bat_editor_command(editor, "undo") == BAT_OK) {
        steps++;
        assert_null(bat_editor_check(editor));
    }
    assert_true(digest(editor) == first);
    for (; steps > 0; steps--) assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    assert_true(digest(editor) == last);
    replays(editor, 0);
}

static void clicks_select(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    click(&p, 500, 205, 0);
    assert_true(selected(editor) == 1 && has(editor, 1));
    click(&p, 500, 597, 0);
    assert_true(selected(editor) == 1 && has(editor, 2));
    click(&p, 500, 200, BAT_SHIFT);
    assert_int_equal(selected(editor), 2);
    click(&p, 600, 200, BAT_SHIFT);
    assert_true(selected(editor) == 1 && has(editor, 2));
    click(&p, 500, 400, BAT_SHIFT);
    assert_int_equal(selected(editor), 1);
    click(&p, 500, 350, 0);
    assert_int_equal(selected(editor), 0);
    bat_editor_key(editor, "a", true, BAT_CTRL, p.time);
    assert_int_equal(selected(editor), 2);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_int_equal(frame->selected, 2);
    assert_non_null(pen_live(frame, BAT_ROLE_HANDLE));
    assert_true(bat_editor_key(editor, "Escape", true, 0, p.time));
    assert_int_equal(selected(editor), 0);
    assert_false(bat_editor_key(editor, "Escape", true, 0, p.time));
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_SELECTION));
    bat_editor_free(editor);
}

static void marquee_selects_what_it_touches(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    drag_holding(&p, 300, 100, 350, 300, 0); /* crosses the first */
    assert_true(selected(editor) == 1 && has(editor, 1));
    drag_holding(&p, 810, 700, 100, 500, BAT_SHIFT); /* holds the second */
    assert_int_equal(selected(editor), 2);
    drag_holding(&p, 300, 300, 350, 500, 0); /* in between */
    assert_int_equal(selected(editor), 0);
    pen_event(&p, BAT_POINTER_DOWN, 300, 100);
    pen_event(&p, BAT_POINTER_MOVE, 350, 300);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_MARQUEE));
    bat_editor_command(editor, "cancel");
    assert_int_equal(selected(editor), 0);
    pen_event(&p, BAT_POINTER_UP, 350, 300);
    assert_int_equal(selected(editor), 0);
    bat_editor_free(editor);
}

static void fills_are_picked(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    click(&p, 500, 200, 0);
    bat_editor_command(editor, "curve-close");
    bat_editor_set(editor, "filled", 1);
    bat_editor_free(editor);
    /* A square with a hole: even-odd. */
    double square[10] = {300, 300, 500, 300, 500, 500, 300, 500, 300, 300};
    double hole[10] = {350, 350, 450, 350, 450, 450, 350, 450, 350, 350};
    double knots[7] = {0, 0, 1, 2, 3, 4, 4};
    for (int even_odd = 0; even_odd < 2; even_odd++) {
        editor = select_editor();
        p = mouse(editor);
        bat_curve *curves[2] = {NULL, NULL};
        bat_curve_create(2, 1, false, 5, square, 7, knots, &curves[0]);
        bat_curve_create(2, 1, false, 5, hole, 7, knots, &curves[1]);
        bat_style style = bat_style_defaults();
        style.filled = true;
        style.even_odd = even_odd;
        bat_object *made = NULL;
        assert_int_equal(bat_object_create_path(bat_document_new_id(editor->session.document), NULL, &style,
                                                2, curves, &made),
                         BAT_OK);
        bat_transaction_begin(&editor->context);
        bat_transaction_insert(&editor->context, 2, made);
        bat_transaction_commit(&editor->context, BAT_STRING_STEP_CHANGE, NULL);
        bat_object_release(made);
        click(&p, 325, 420, 0);
        assert_true(selected(editor) == 1 && has(editor, 3));
        click(&p, 700, 420, 0);
        assert_int_equal(selected(editor), 0);
        click(&p, 400, 400, 0);
        assert_int_equal(selected(editor), even_odd ? 0 : 1);
        bat_editor_free(editor);
    }
}

static void drags_move(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    drag_holding(&p, 500, 200, 530, 260, 0); /* a drag selects what it takes hold of */
    assert_true(selected(editor) == 1 && has(editor, 1));
    expect_box(editor, 1, 230, 260, 830, 260);
    drag_holding(&p, 500, 260, 502, 290, BAT_SHIFT);
    expect_box(editor, 1, 230, 290, 830, 290);
    assert_false(editor->session.transaction.open);
    assert_int_equal(editor->session.history.done, 2);
    /* cancelled: nothing has happened */
    uint64_t before = digest(editor);
    pen_event(&p, BAT_POINTER_DOWN, 500, 290);
    pen_event(&p, BAT_POINTER_MOVE, 600, 400);
    bat_editor_frame(editor);
    assert_true(digest(editor) != before);
    bat_editor_key(editor, "Escape", true, 0, p.time);
    assert_true(digest(editor) == before);
    pen_event(&p, BAT_POINTER_UP, 600, 400);
    assert_true(digest(editor) == before && editor->session.history.done == 2);
    /* keys */
    bat_editor_key(editor, "ArrowRight", true, 0, p.time);
    expect_box(editor, 1, 231, 290, 831, 290);
    bat_editor_key(editor, "ArrowUp", true, BAT_SHIFT, p.time);
    expect_box(editor, 1, 231, 280, 831, 280);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static void handles_scale_and_rotate(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    bat_editor_command(editor, "select-all"); /* box 200 200 800 600 */
    drag_holding(&p, 800, 600, 500, 400, 0);
    expect_box(editor, 1, 200, 200, 500, 200);
    expect_box(editor, 2, 200, 400, 500, 400);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    drag_holding(&p, 800, 600, 500, 580, BAT_SHIFT); /* the greater factor leads: y, 0.95 */
    expect_box(editor, 1, 200, 200, 770, 200);
    expect_box(editor, 2, 200, 580, 770, 580);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    drag_holding(&p, 800, 600, 650, 500, BAT_ALT);
    expect_box(editor, 1, 350, 300, 650, 300);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    drag_holding(&p, 800, 400, 500, 450, 0); /* the right side: x alone */
    expect_box(editor, 2, 200, 600, 500, 600);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    drag_holding(&p, 200, 200, 1000, 200, 0); /* through the other side: mirrored */
    expect_box(editor, 1, 800, 200, 1000, 200);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    /* The rotation handle is above the middle of the top; about the middle (500, 400). */
    drag_holding(&p, 500, 174, 730, 400, BAT_SHIFT);
    expect_box(editor, 1, 700, 100, 700, 700);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "select-all");
    double away = 226, angle = 0.3; /* 17.2 degrees snap to 15 */
    drag_holding(&p, 500, 174, 500 + away * sin(angle), 400 - away * cos(angle), BAT_SHIFT);
    double c = cos(acos(-1) / 12), s = sin(acos(-1) / 12), box[4];
    box_of(editor, 1, box);
    assert_true(fabs(box[2] - box[0] - 600 * c) < 1e-9 && fabs(box[3] - box[1] - 600 * s) < 1e-9);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

/* Whatever the matrix, a group's transform is the transform of its curves. */
static void transforms_are_of_the_curves(void **state) {
    (void)state;
    uint32_t seed = 11;
    for (int round = 0; round < 40; round++) {
        double m[6];
        for (int k = 0; k < 6; k++) {
            seed = seed * 1664525u + 1013904223u;
            m[k] = (double)(seed >> 8) / 4e6 - 2;
        }
        bat_editor *editor = select_editor();
        bat_object *before[2];
        for (int i = 0; i < 2; i++)
            before[i] = bat_object_retain(bat_document_at(editor->session.document, i));
        bat_editor_command(editor, "select-all");
        assert_int_equal(bat_editor_command(editor, "group"), BAT_OK);
        assert_int_equal(selected(editor), 1);
        assert_int_equal(bat_arrange_transform(&editor->context, m, BAT_STRING_STEP_MOVE), BAT_OK);
        for (int i = 0; i < 2; i++) {
            bat_curve *expected = NULL;
            assert_int_equal(bat_curve_transform(bat_object_curve(before[i], 0),
                                                 (double[]){m[0], m[2], m[4], m[1], m[3], m[5]}, &expected),
                             BAT_OK);
            const bat_object *after = object(editor, bat_object_id(before[i]));
            assert_true(bat_curve_is_equal(bat_object_curve(after, 0), expected));
            assert_int_equal(bat_object_parent(after), 3);
            bat_curve_free(expected);
            bat_object_release(before[i]);
        }
        bat_editor_free(editor);
    }
}

static void splines_stay_splines(void **state) {
    (void)state;
    double points[8] = {0, 0, 100, 50, 200, -30, 300, 40}, turn[6], skew[6] = {1, 0.3, 0.7, 1.2, 5, 6};
    bat_spline spline = {.dimension = 2, .count = 4, .points = points};
    bat_style style = bat_style_defaults();
    bat_object *made = NULL, *turned = NULL, *skewed = NULL;
    assert_int_equal(bat_object_create_spline(1, NULL, &style, &spline, NULL, &made), BAT_OK);
    bat_matrix_rotation(1, (double[]){50, 60}, turn);
    assert_int_equal(bat_affine_object(made, turn, false, &turned), BAT_OK);
    assert_non_null(bat_object_spline(turned));
    assert_int_equal(bat_affine_object(made, skew, false, &skewed), BAT_OK);
    bat_curve *expected = NULL;
    bat_curve_transform(bat_object_curve(made, 0),
                        (double[]){skew[0], skew[2], skew[4], skew[1], skew[3], skew[5]}, &expected);
    double near = 1e-8 * bat_curve_size(expected);
    for (int i = 0; i < 2 * bat_point_count(expected); i++)
        assert_true(fabs(bat_curve_points(expected)[i] - bat_curve_points(bat_object_curve(skewed, 0))[i]) <
                    near);
    bat_curve_free(expected);
    bat_object_release(made);
    bat_object_release(turned);
    bat_object_release(skewed);
}

/* The ids of the list, in order, as text. */
static const char *order(const bat_editor *editor) {
    static char text[200];
    size_t used = 0;
    text[0] = 0;
    for (int i = 0; i < bat_document_count(editor->session.document); i++)
        used += (size_t)snprintf(text + used, sizeof text - used, i ? " %d" : "%d",
                                 (int)bat_object_id(bat_document_at(editor->session.document, i)));
    return text;
}

static void only(bat_editor *editor, bat_id a, bat_id b) {
    bat_editor_select(editor, a, false);
    if (b) bat_editor_select(editor, b, true);
}

static void groups_and_order(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    uint64_t first = digest(editor);
    for (int i = 0; i < 2; i++) { /* 3 and 4 are copies of 1 and 2 */
        only(editor, (bat_id)i + 1, 0);
        bat_editor_command(editor, "duplicate");
    }
    assert_string_equal(order(editor), "1 3 2 4");
    expect_box(editor, 3, 210, 210, 810, 210);
    only(editor, 1, 2);
    bat_editor_command(editor, "group"); /* 5, where 2 was */
    assert_string_equal(order(editor), "3 5 1 2 4");
    assert_true(selected(editor) == 1 && has(editor, 5));
    bat_editor_command(editor, "order-front");
    assert_string_equal(order(editor), "3 4 5 1 2");
    assert_int_equal(bat_editor_command(editor, "order-front"), BAT_STATE);
    bat_editor_command(editor, "order-backward");
    assert_string_equal(order(editor), "3 5 1 2 4");
    bat_editor_command(editor, "order-back");
    assert_string_equal(order(editor), "5 1 2 3 4");
    bat_editor_command(editor, "order-forward");
    assert_string_equal(order(editor), "3 5 1 2 4");
    only(editor, 1, 0); /* inside the group: among its own */
    bat_editor_command(editor, "order-front");
    assert_string_equal(order(editor), "3 5 2 1 4");
    only(editor, 5, 0);
    bat_editor_command(editor, "duplicate"); /* 6 with 7 and 8 in it */
    assert_string_equal(order(editor), "3 5 2 1 6 7 8 4");
    assert_int_equal(bat_object_parent(object(editor, 8)), 6);
    bat_editor_command(editor, "ungroup");
    assert_string_equal(order(editor), "3 5 2 1 7 8 4");
    assert_true(selected(editor) == 2 && has(editor, 7) && has(editor, 8));
    only(editor, 2, 1); /* all of a group: the group goes too */
    bat_editor_key(editor, "Delete", true, 0, 0);
    assert_string_equal(order(editor), "3 7 8 4");
    assert_int_equal(selected(editor), 0);
    bat_editor_command(editor, "undo");
    assert_string_equal(order(editor), "3 5 2 1 7 8 4");
    assert_true(has(editor, 5));
    goes_back_and_replays(editor, first);
    /* A click means the group, with Ctrl what is in it. */
    pen p = mouse(editor);
    only(editor, 0, 0);
    click(&p, 500, 200, 0);
    assert_true(has(editor, 5) && !has(editor, 1));
    click(&p, 350, 200, BAT_CTRL); /* beside the handles */
    assert_true(has(editor, 1) && !has(editor, 5));
    bat_editor_free(editor);
}

static void aligns_and_distributes(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    uint64_t first = digest(editor);
    only(editor, 2, 0);
    for (int i = 0; i < 30; i++) bat_editor_key(editor, "ArrowRight", true, BAT_SHIFT, 0); /* 500 to 1100 */
    const struct {
        const char *name;
        double x, y; /* of line 1's box, then, the other one's */
        double other_x, other_y;
    } cases[] = {{"align-left", 200, 200, 200, 600},   {"align-centre", 350, 200, 350, 600},
                 {"align-right", 500, 200, 500, 600},  {"align-top", 200, 200, 500, 200},
                 {"align-middle", 200, 400, 500, 400}, {"align-bottom", 200, 600, 500, 600}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_editor_command(editor, "select-all");
        assert_int_equal(bat_editor_command(editor, cases[i].name), BAT_OK);
        expect_box(editor, 1, cases[i].x, cases[i].y, cases[i].x + 600, cases[i].y);
        expect_box(editor, 2, cases[i].other_x, cases[i].other_y, cases[i].other_x + 600, cases[i].other_y);
        bat_editor_command(editor, "undo");
    }
    only(editor, 1, 0); /* alone: to the page, 1000 wide */
    bat_editor_command(editor, "align-right");
    expect_box(editor, 1, 400, 200, 1000, 200);
    bat_editor_command(editor, "undo");
    bat_editor_command(editor, "duplicate"); /* 3, at y 210 */
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "distribute-down"), BAT_OK);
    expect_box(editor, 3, 210, 400, 810, 400);
    expect_box(editor, 1, 200, 200, 800, 200);
    assert_int_equal(bat_editor_command(editor, "distribute-across"), BAT_OK);
    expect_box(editor, 3, 350, 400, 950, 400);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static const bat_curve *curve(const bat_editor *editor, bat_id id) {
    return bat_object_curve(object(editor, id), 0);
}

static void curves_are_cut_and_mended(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    double at[2], domain[2];
    bat_curve *old = NULL;
    bat_curve_copy(curve(editor, 1), &old);
    /* reverse */
    only(editor, 1, 0);
    bat_editor_command(editor, "curve-reverse");
    bat_curve_domain(curve(editor, 1), domain);
    for (int i = 0; i <= 10; i++) {
        double expected[2], u = i / 10.0;
        bat_curve_eval(old, domain[0] + u * (domain[1] - domain[0]), 0, expected);
        bat_curve_eval(curve(editor, 1), domain[1] - u * (domain[1] - domain[0]), 0, at);
        assert_true(fabs(at[0] - expected[0]) < 1e-9 && fabs(at[1] - expected[1]) < 1e-9);
    }
    bat_editor_command(editor, "undo");
    /* split where it was clicked */
    click(&p, 400, 200, 0);
    assert_int_equal(bat_editor_command(editor, "curve-split"), BAT_OK);
    assert_int_equal(bat_document_count(editor->session.document), 3);
    expect_box(editor, 1, 200, 200, 400, 200);
    expect_box(editor, 3, 400, 200, 800, 200);
    /* and joined again: the very same way */
    only(editor, 1, 3);
    assert_int_equal(bat_editor_command(editor, "curve-join"), BAT_OK);
    assert_int_equal(bat_document_count(editor->session.document), 2);
    expect_box(editor, 1, 200, 200, 800, 200);
    /* joined to the other line: by a straight one between the nearest ends */
    only(editor, 1, 2);
    assert_int_equal(bat_editor_command(editor, "curve-join"), BAT_OK);
    assert_int_equal(bat_document_count(editor->session.document), 1);
    expect_box(editor, 1, 200, 200, 800, 600);
    assert_false(bat_curve_is_closed(curve(editor, 1)));
    /* one curve: joining closes it */
    assert_int_equal(bat_editor_command(editor, "curve-join"), BAT_OK);
    assert_true(bat_curve_is_closed(curve(editor, 1)));
    expect_box(editor, 1, 200, 200, 800, 600);
    assert_int_equal(bat_editor_command(editor, "curve-close"), BAT_STATE);
    /* a closed curve is opened at the place that was clicked */
    click(&p, 700, 200, 0);
    assert_int_equal(bat_editor_command(editor, "curve-split"), BAT_OK);
    assert_false(bat_curve_is_closed(curve(editor, 1)));
    bat_curve_domain(curve(editor, 1), domain);
    for (int k = 0; k < 2; k++) {
        bat_curve_eval(curve(editor, 1), domain[k], 0, at);
        assert_true(fabs(at[0] - 700) < 1e-6 && fabs(at[1] - 200) < 1e-6);
    }
    assert_int_equal(bat_editor_command(editor, "curve-open"), BAT_STATE);
    bat_editor_command(editor, "undo");
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "curve-open"), BAT_OK);
    assert_false(bat_curve_is_closed(curve(editor, 1)));
    only(editor, 0, 0);
    assert_int_equal(bat_editor_command(editor, "curve-join"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "curve-split"), BAT_STATE);
    goes_back_and_replays(editor, first);
    bat_curve_free(old);
    bat_editor_free(editor);
}

static void layers_hold_hide_and_lock(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "layer-add"), BAT_OK); /* 3 */
    assert_int_equal(editor->choice.layer, 3);
    bat_editor_command(editor, "tool-sketch");
    pen_line(&p, 200, 400, 800, 400, 60); /* 4, into the layer */
    assert_string_equal(order(editor), "1 2 3 4");
    assert_int_equal(bat_object_parent(object(editor, 4)), 3);
    bat_editor_command(editor, "tool-select");
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "layer-take"), BAT_OK);
    assert_string_equal(order(editor), "2 3 4 1");
    bat_editor_command(editor, "layer-add"); /* 5 */
    bat_editor_activate_layer(editor, 3);
    assert_int_equal(bat_editor_command(editor, "layer-up"), BAT_OK);
    assert_string_equal(order(editor), "2 5 3 4 1");
    assert_int_equal(bat_editor_command(editor, "layer-up"), BAT_STATE);
    bat_editor_command(editor, "layer-down");
    bat_editor_command(editor, "layer-down");
    assert_string_equal(order(editor), "3 4 1 2 5");
    assert_int_equal(bat_editor_rename(editor, 3, "T\xc3\xbcr"), BAT_OK);
    assert_int_equal(bat_editor_rename(editor, 3, "\xff"), BAT_ARGUMENT);
    assert_string_equal(
        bat_editor_layers(editor),
        "{\"layers\":[{\"id\":3,\"name\":\"T\xc3\xbcr\",\"hidden\":false,\"locked\":false,\"depth\":0,"
        "\"members\":2},{\"id\":5,\"name\":\"Layer 2\",\"hidden\":false,\"locked\":false,\"depth\":0,"
        "\"members\":0}],\"active\":3,\"loose\":1,\"pictures\":0}");
    /* A layer's contents are taken one by one. */
    click(&p, 500, 200, 0);
    assert_true(selected(editor) == 1 && has(editor, 1));
    /* Locked: seen, not selected, not picked, not redrawn. */
    assert_int_equal(bat_editor_set_state(editor, 3, false, true), BAT_OK);
    assert_int_equal(selected(editor), 0);
    click(&p, 500, 200, 0);
    assert_int_equal(selected(editor), 0);
    bat_editor_command(editor, "select-all");
    assert_true(selected(editor) == 1 && has(editor, 2));
    assert_int_equal(bat_editor_frame(editor)->still_count, 1 + 3);
    bat_editor_command(editor, "tool-sketch");
    bat_editor_activate_layer(editor, 5);
    pen_line(&p, 300, 200, 600, 205, 10);
    assert_int_equal(bat_document_count(editor->session.document), 6); /* new, not redrawn */
    /* Hidden: not there. */
    bat_editor_set_state(editor, 3, true, false);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_int_equal(frame->still_count, 1 + 2);
    assert_true(frame->dirty[0] <= frame->dirty[2]);
    assert_null(bat_editor_check(editor));
    bat_editor_set_state(editor, 3, false, false);
    assert_int_equal(bat_editor_frame(editor)->still_count, 1 + 4);
    /* New curves do not vanish in a hidden layer. */
    bat_editor_set_state(editor, 5, true, false);
    pen_line(&p, 300, 700, 600, 705, 10);
    assert_int_equal(bat_object_parent(bat_document_at(editor->session.document, 6)), 0);
    bat_editor_activate_layer(editor, 3);
    assert_int_equal(bat_editor_command(editor, "layer-delete"), BAT_OK);
    assert_int_equal(editor->choice.layer, 0);
    assert_int_equal(bat_editor_command(editor, "layer-delete"), BAT_STATE);
    assert_int_equal(bat_editor_activate_layer(editor, 3), BAT_ARGUMENT);
    assert_int_equal(bat_document_count(editor->session.document), 4);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static double value(const bat_editor *editor, const char *name) {
    double out = -1;
    bat_editor_get(editor, name, &out);
    return out;
}

static void style_of_selection_and_of_new(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    uint64_t first = digest(editor);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_set(editor, "stroke-colour", (double)0xff0000ffu), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "stroke-width", 7), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "fill-colour", (double)0x00ff0080u), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "opacity", 0.5), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "stroke-cap", BAT_CAP_SQUARE), BAT_OK);
    const bat_style *style = bat_object_style(object(editor, 1));
    assert_true(style->stroke == 0xff0000ffu && style->width == 7 && style->filled &&
                style->fill == 0x00ff0080u && style->opacity == 0.5 && style->cap == BAT_CAP_SQUARE);
    assert_true(bat_object_style(object(editor, 2))->width == 2);
    assert_int_equal(editor->session.history.done, 5);
    bat_editor_set(editor, "opacity", 0.5); /* no change, no step */
    assert_int_equal(editor->session.history.done, 5);
    only(editor, 2, 0);
    assert_true(value(editor, "stroke-width") == 2); /* the selection's */
    only(editor, 0, 0);
    assert_true(value(editor, "stroke-width") == 7); /* of new curves */
    bat_editor_command(editor, "tool-sketch");
    pen_line(&p, 200, 400, 800, 400, 60);
    style = bat_object_style(object(editor, 3));
    assert_true(style->stroke == 0xff0000ffu && style->width == 7 && style->filled && style->opacity == 0.5 &&
                style->cap == BAT_CAP_SQUARE);
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "style-marker");
    for (bat_id id = 1; id <= 3; id++) assert_true(bat_object_style(object(editor, id))->width == 12);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

static uint32_t roll(uint32_t *seed, uint32_t below) {
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 8) % below;
}

/* Long random sessions: every invariant after every event, then all the way back, forth, and replayed. */
static void random_sessions(void **state) {
    (void)state;
    static const char *const commands[] = {
        "select-all",      "delete",      "duplicate",     "group",        "ungroup",
        "order-front",     "order-back",  "order-forward", "align-left",   "align-middle",
        "distribute-down", "curve-close", "curve-join",    "curve-split",  "curve-open",
        "curve-reverse",   "layer-add",   "layer-up",      "layer-down",   "layer-take",
        "layer-delete",    "undo",        "redo",          "style-marker", "tool-sketch",
        "tool-select",     "nudge-left",  "cancel",        "duplicate",    "undo"};
    for (uint32_t seed = 1; seed <= 4; seed++) {
        uint32_t s = seed * 7919;
#define ROLL(n) roll(&s, (uint32_t)(n))
        bat_editor *editor = select_editor();
        uint64_t first = digest(editor);
        pen p = mouse(editor);
        bool down = false;
        for (int i = 0; i < 400; i++) {
            uint32_t kind = ROLL(10);
            double x = 100 + ROLL(800), y = 100 + ROLL(600);
            p.modifiers = ROLL(4) ? 0 : ROLL(8);
            if (kind < 2) {
                bat_editor_command(editor, commands[ROLL(sizeof commands / sizeof *commands)]);
            } else if (kind < 5) {
                pen_event(&p, down ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, x, ROLL(2) ? 200 : y);
                down = true;
            } else if (kind < 7) {
                pen_event(&p, down ? BAT_POINTER_UP : BAT_POINTER_HOVER, x, y);
                down = false;
            } else if (kind == 7) {
                bat_id id = 1 + ROLL(20);
                bool hidden = !ROLL(4), locked = !ROLL(4);
                bat_editor_set_state(editor, id, hidden, locked);
                bat_editor_activate_layer(editor, id);
            } else if (kind == 8) {
                bat_id id = ROLL(20);
                bat_editor_select(editor, id, ROLL(2));
            } else {
                bat_editor_frame(editor);
            }
            const char *wrong = bat_editor_check(editor);
            if (wrong) fail_msg("seed %u, event %d: %s", seed, i, wrong);
            if (bat_document_count(editor->session.document) > 60) bat_editor_command(editor, "undo");
        }
        if (down) pen_event(&p, BAT_POINTER_UP, 500, 500);
        goes_back_and_replays(editor, first);
        bat_editor_free(editor);
    }
}

/* A drag with Alt leaves the originals and moves copies, as one step; cancelled, nothing is left of it. */
static void alt_drags_a_copy(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    uint64_t fresh = digest(editor);
    bat_id id = bat_object_id(bat_document_at(editor->session.document, 0));
    bat_editor_command(editor, "tool-select");
    double box[4], moved[4];
    bat_object_bounds(bat_document_at(editor->session.document, 0), box);
    double from[2];
    bat_view_to_screen(&editor->stage.view, (double[]){400, 200}, from);
    for (int round = 0; round < 3; round++) { /* cancelled, cancelled of what was selected, let go */
        bool cancelled = round < 2, chosen = round == 1;
        p.time += 1000;
        if (chosen)
            bat_selection_add(&editor->choice.selection, id);
        else
            bat_selection_clear(&editor->choice.selection);
        p.modifiers = BAT_ALT;
        pen_event(&p, BAT_POINTER_DOWN, from[0], from[1]);
        pen_event(&p, BAT_POINTER_MOVE, from[0] + 20, from[1]);
        bat_editor_frame(editor);
        pen_event(&p, BAT_POINTER_MOVE, from[0] + 30, from[1] + 50);
        bat_editor_frame(editor);
        assert_int_equal(bat_document_count(editor->session.document), 3);
        assert_null(bat_editor_check(editor));
        pen_event(&p, cancelled ? BAT_POINTER_CANCEL : BAT_POINTER_UP, from[0] + 30, from[1] + 50);
        p.modifiers = 0;
        assert_int_equal(editor->choice.selection.count, cancelled ? chosen : 1);
        assert_true(bat_selection_has(&editor->choice.selection, id) == chosen);
        assert_true((digest(editor) == fresh) == cancelled);
    }
    double pixel = bat_view_pixel(&editor->stage.view);
    bat_object_bounds(bat_document_at(editor->session.document, 0), moved);
    assert_memory_equal(box, moved, sizeof box);
    bat_object_bounds(bat_document_at(editor->session.document, 1), moved);
    assert_true(fabs(moved[0] - box[0] - 30 * pixel) < 1e-9 && fabs(moved[1] - box[1] - 50 * pixel) < 1e-9);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == fresh);
    bat_editor_free(editor);
}

static void tap_place(pen *p, double x, double y) {
    double at[2];
    bat_view_to_screen(&p->editor->stage.view, (double[]){x, y}, at);
    pen_event(p, BAT_POINTER_DOWN, at[0], at[1]);
    pen_event(p, BAT_POINTER_UP, at[0], at[1]);
}

/* A double click enters a group: clicks, boxes and "select all" mean what is in it then; Esc leaves, one group at a
 * time, and so does a click outside. */
static void double_click_enters(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    pen p = pen_for(editor);
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "group");
    bat_id group = editor->choice.selection.ids[0];
    bat_editor_command(editor, "deselect");
    tap_place(&p, 400, 200);
    assert_true(bat_selection_has(&editor->choice.selection, group) && !editor->choice.entered);
    p.time += 1000;
    tap_place(&p, 400, 200); /* too late to be a double click */
    assert_true(!editor->choice.entered);
    tap_place(&p, 400, 200);
    assert_true(editor->choice.entered == group && editor->choice.selection.count == 1);
    bat_id first = editor->choice.selection.ids[0];
    assert_true(first != group);
    assert_true(bat_object_parent(bat_document_at(
                    editor->session.document, bat_document_find(editor->session.document, first))) == group);
    p.time += 1000;
    tap_place(&p, 400, 600);
    assert_true(editor->choice.selection.count == 1 && editor->choice.selection.ids[0] != first &&
                editor->choice.entered == group);
    bat_editor_command(editor, "select-all");
    assert_int_equal(editor->choice.selection.count, 2);
    assert_non_null(strstr(bat_editor_frame(editor)->labels[0].text, "Group"));
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_true(!editor->choice.entered && bat_selection_has(&editor->choice.selection, group));
    p.time += 1000;
    bat_editor_command(editor, "deselect");
    tap_place(&p, 400, 200);
    tap_place(&p, 400, 200);
    assert_true(editor->choice.entered == group);
    p.time += 1000;
    tap_place(&p, 400, 400); /* nothing there */
    assert_true(!editor->choice.entered && !editor->choice.selection.count);
    /* What is gone cannot be in force. */
    tap_place(&p, 400, 200);
    p.time += 1000;
    tap_place(&p, 400, 200);
    tap_place(&p, 400, 200);
    assert_true(editor->choice.entered == group);
    bat_editor_command(editor, "undo");
    assert_true(!editor->choice.entered);
    assert_null(bat_editor_check(editor));
    bat_editor_free(editor);
}

/* The selected curves with fewer points, one step; a second time there is nothing left to do. */
static void simplify(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    bat_editor_command(editor, "deselect");
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_STATE); /* nothing is selected */
    bat_curve *finer = NULL, *old = NULL;
    double knots[40], domain[2];
    bat_curve_copy(curve(editor, 1), &old);
    bat_curve_domain(old, domain);
    for (int i = 0; i < 40; i++) knots[i] = domain[0] + (domain[1] - domain[0]) * (i + 0.5) / 40;
    assert_int_equal(bat_curve_insert_knots(old, 40, knots, &finer), BAT_OK);
    assert_int_equal(bat_transaction_begin(&editor->context), BAT_OK);
    assert_int_equal(bat_put_curve(&editor->context, 1, 0, finer), BAT_OK);
    assert_int_equal(bat_transaction_commit(&editor->context, BAT_STRING_STEP_CHANGE, NULL), BAT_OK);
    const size_t many = bat_curve_count(curve(editor, 1));
    uint64_t before = digest(editor);
    only(editor, 1, 0);
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_OK);
    assert_true(bat_curve_count(curve(editor, 1)) + 38 <= many);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "Simplified: "));
    double there, back;
    assert_int_equal(bat_curve_distance(old, curve(editor, 1), 20, &there, &back), BAT_OK);
    assert_true(fmax(there, back) <= 1.001);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == before);
    bat_editor_command(editor, "redo");
    assert_int_equal(bat_editor_command(editor, "curve-simplify"), BAT_STATE);
    bat_curve_free(old);
    bat_editor_free(editor);
}

static bool offered(bat_editor *editor, const char *name) {
    const char *list = bat_editor_actions(editor), *at = strstr(list, name);
    return at && (at == list || at[-1] == ' ') && (at[strlen(name)] == ' ' || !at[strlen(name)]);
}

/* What is offered can be done, and what is not cannot. */
static void actions_of_the_selection(void **state) {
    (void)state;
    static const char *const names[] = {
        "align-left", "distribute-across", "group",         "ungroup",     "curve-close",
        "curve-open", "curve-join",        "curve-reverse", "curve-split", "delete"};
    bat_editor *editor = pen_editor();
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "tool-points");
    assert_string_equal(bat_editor_actions(editor), ""); /* the select tool is not in force */
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "deselect");
    assert_string_equal(bat_editor_actions(editor), "");
    bat_editor_select(editor, bat_object_id(bat_document_at(editor->session.document, 0)), false);
    assert_true(offered(editor, "order-front") && offered(editor, "align-left") &&
                offered(editor, "curve-close"));
    assert_false(offered(editor, "group") || offered(editor, "curve-open") || offered(editor, "curve-join"));
    for (int round = 0; round < 4; round++) {
        if (round == 1) bat_editor_command(editor, "select-all");
        if (round == 2) bat_editor_command(editor, "group");
        if (round == 3) bat_editor_command(editor, "curve-close");
        for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
            bool said = offered(editor, names[i]);
            uint64_t before = digest(editor);
            bat_status status = bat_editor_command(editor, names[i]);
            /* One open curve alone is joined with itself: closed, which has its own button. */
            bool closes = round == 0 && !strcmp(names[i], "curve-join");
            if (said != (status == BAT_OK) && !closes) fail_msg("%d: %s", round, names[i]);
            if (digest(editor) != before) bat_editor_command(editor, "undo");
            bat_editor_command(editor, "deselect");
            if (round == 0)
                bat_editor_select(editor, bat_object_id(bat_document_at(editor->session.document, 0)), false);
            else
                bat_editor_command(editor, "select-all");
        }
    }
    bat_editor_free(editor);
}

/* Any layer to the place of any other: the order is as when it is taken out and put in there, whatever else lies
 * between; undo brings the old one back. */
static void layers_are_placed(void **state) {
    (void)state;
    bat_editor *editor = pen_editor();
    bat_id order[5],
        ids[4]; /* of the topmost objects in front of the loose one: layers, and a curve among them */
    for (int i = 0; i < 4; i++) {
        bat_editor_command(editor, "layer-add");
        ids[i] = editor->choice.layer;
        bat_editor_select(editor, bat_object_id(bat_document_at(editor->session.document, 0)), false);
        if (i == 1) bat_editor_command(editor, "layer-take");
        if (i == 2) bat_editor_command(editor, "order-front");
    }
    for (int i = 0, k = 0; i < bat_document_count(editor->session.document); i++)
        if (!bat_object_parent(bat_document_at(editor->session.document, i)))
            order[k++] = bat_object_id(bat_document_at(editor->session.document, i));
    uint64_t before = digest(editor);
    for (int from = 0; from < 4; from++)
        for (int to = 0; to < 4; to++) {
            bat_id expected[5], kept[5];
            int place = 0, k = 0;
            for (int i = 0; i < 5; i++) {
                if (order[i] == ids[to]) place = i;
                if (order[i] != ids[from]) kept[k++] = order[i];
            }
            for (int i = 0; i < 5; i++) expected[i] = i == place ? ids[from] : kept[i - (i > place)];
            bat_status status = bat_editor_place_layer(editor, ids[from], ids[to]);
            assert_int_equal(status, from == to ? BAT_STATE : BAT_OK);
            k = 0;
            for (int i = 0; i < bat_document_count(editor->session.document); i++) {
                const bat_object *object = bat_document_at(editor->session.document, i);
                if (!bat_object_parent(object)) assert_true(bat_object_id(object) == expected[k++]);
            }
            assert_int_equal(k, 5);
            assert_null(bat_editor_check(editor));
            if (status == BAT_OK) bat_editor_command(editor, "undo");
            assert_true(digest(editor) == before);
        }
    assert_int_equal(bat_editor_place_layer(editor, ids[0], 999), BAT_ARGUMENT);
    assert_int_equal(bat_editor_place_layer(editor, 999, ids[0]), BAT_ARGUMENT);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clicks_select),
        cmocka_unit_test(marquee_selects_what_it_touches),
        cmocka_unit_test(fills_are_picked),
        cmocka_unit_test(drags_move),
        cmocka_unit_test(handles_scale_and_rotate),
        cmocka_unit_test(transforms_are_of_the_curves),
        cmocka_unit_test(splines_stay_splines),
        cmocka_unit_test(groups_and_order),
        cmocka_unit_test(aligns_and_distributes),
        cmocka_unit_test(curves_are_cut_and_mended),
        cmocka_unit_test(layers_hold_hide_and_lock),
        cmocka_unit_test(style_of_selection_and_of_new),
        cmocka_unit_test(random_sessions),
        cmocka_unit_test(alt_drags_a_copy),
        cmocka_unit_test(double_click_enters),
        cmocka_unit_test(simplify),
        cmocka_unit_test(actions_of_the_selection),
        cmocka_unit_test(layers_are_placed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
