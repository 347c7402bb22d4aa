/* Eraser, smooth brush and calming; the display of comb, knots and lengths. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/editing.h"
#include <batten/editor.h>
#include <batten/measure.h>

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

static const bat_curve *curve_at(const bat_editor *editor, int index) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), index), 0);
}

static bat_curve *ring(void) {
    double points[24], knots[13];
    for (int i = 0; i < 12; i++) {
        points[2 * i] = 500 + 150 * cos(6.283185307179586 * i / 12);
        points[2 * i + 1] = 400 + 150 * sin(6.283185307179586 * i / 12);
    }
    for (int i = 0; i <= 12; i++) knots[i] = i;
    bat_curve *curve = NULL;
    bat_curve_create(2, 3, true, 12, points, 13, knots, &curve);
    return curve;
}

/* A curve, and a ring about (500, 400). */
static bat_editor *brush_with(bat_curve *curve, const char *tool) {
    bat_editor *editor = editor_with(2, (bat_curve *[]){curve, ring()});
    bat_editor_set(editor, "pressure",
                   0); /* all of the reach, always: tests/editor/input/test_pressure.c has the rest */
    bat_editor_command(editor, tool);
    return editor;
}

/* A wave through y = 150, with knots 0 to 8. */
static bat_editor *brush_editor(const char *tool) {
    return brush_with(pen_curve(200, 150, 60, 30, 11), tool);
}

/* A trembling line through y = 150. */
static bat_editor *trembling_editor(const char *tool) {
    return brush_with(pen_curve(200, 150, 20, 2.5, 31), tool);
}

/* Every piece is the old curve, point for point, and keeps out of the eraser's way. */
static void is_what_remains(const bat_curve *piece, const bat_curve *old, double x0, double y0, double x1,
                            double y1, double radius) {
    double domain[2], p[2], q[2];
    bat_curve_domain(piece, domain);
    for (int i = 0; i <= 400; i++) {
        double u = domain[0] + (domain[1] - domain[0]) * i / 400;
        bat_curve_eval(piece, u, 0, p);
        bat_curve_eval(old, u, 0, q);
        assert_true(fabs(p[0] - q[0]) < 1e-9 && fabs(p[1] - q[1]) < 1e-9);
        assert_true(fabs(p[0] - q[0]) <= 1e-12 * 1000 && fabs(p[1] - q[1]) <= 1e-12 * 1000);
        double dx = x1 - x0, dy = y1 - y0, square = dx * dx + dy * dy;
        double t = fmin(fmax(((p[0] - x0) * dx + (p[1] - y0) * dy) / square, 0), 1);
        assert_true(hypot(p[0] - x0 - t * dx, p[1] - y0 - t * dy) > radius - 1e-6);
    }
}

static void eraser_parts_an_open_curve(void **state) {
    (void)state;
    bat_editor *editor = brush_editor("tool-eraser");
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    bat_curve *old = NULL;
    bat_curve_copy(curve_at(editor, 0), &old);
    pen_event(&p, BAT_POINTER_HOVER, 480, 100);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_REACH));
    pen_event(&p, BAT_POINTER_DOWN, 480, 100);
    pen_event(&p, BAT_POINTER_MOVE, 480, 200);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_ERASED));
    assert_true(digest(editor) == first);
    check(editor);
    pen_event(&p, BAT_POINTER_UP, 480, 200);
    check(editor);
    assert_int_equal(count(editor), 3); /* two pieces beside each other, then the ring */
    double left[2], right[2];
    bat_curve_domain(curve_at(editor, 0), left);
    bat_curve_domain(curve_at(editor, 1), right);
    assert_true(left[0] == 0 && right[1] == 8 && left[1] < right[0]);
    for (int i = 0; i < 2; i++) is_what_remains(curve_at(editor, i), old, 480, 100, 480, 200, 10);
    /* the gap is no wider than the eraser: its borders are on its rim */
    double a[2];
    bat_curve_eval(old, left[1], 0, a);
    assert_true(fabs(fabs(a[0] - 480) - 10) < 1e-6);
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    assert_true(digest(editor) == first);
    bat_editor_command(editor, "redo");
    bat_curve_free(old);
    round_trip(editor, first);
    bat_editor_free(editor);
}

static void eraser_opens_a_closed_curve_and_takes_all(void **state) {
    (void)state;
    bat_editor *editor = brush_editor("tool-eraser");
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    bat_curve *old = NULL;
    bat_curve_copy(curve_at(editor, 1), &old);
    pen_line(&p, 640, 420, 660, 420, 0);
    assert_int_equal(count(editor), 2);
    assert_false(bat_curve_is_closed(curve_at(editor, 1)));
    is_what_remains(curve_at(editor, 1), old, 640, 420, 660, 420, 10);
    bat_editor_set(editor, "eraser-size", 200);
    pen_line(&p, 480, 390, 520, 410, 0); /* all of the ring */
    assert_int_equal(count(editor), 1);
    check(editor);
    bat_curve_free(old);
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* The seam is no border: a gap over it leaves one piece. */
static void eraser_over_the_seam(void **state) {
    (void)state;
    bat_editor *editor = brush_editor("tool-eraser");
    pen p = pen_for(editor);
    double at[2], length = 0, domain[2];
    bat_curve *old = NULL;
    bat_curve_copy(curve_at(editor, 1), &old);
    bat_curve_eval(old, 0, 0, at);
    length = bat_curve_length(old, 0, 12, 1e-9);
    pen_line(&p, at[0] - 1, at[1], at[0] + 1, at[1], 0);
    assert_int_equal(count(editor), 2);
    assert_false(bat_curve_is_closed(curve_at(editor, 1)));
    bat_curve_domain(curve_at(editor, 1), domain);
    double rest = bat_curve_length(curve_at(editor, 1), domain[0], domain[1], 1e-9);
    assert_true(rest < length - 18 && rest > length - 26);
    bat_curve_free(old);
    bat_editor_free(editor);
}

/* The other end of the pen erases from any tool, and the tool is the same again afterwards. */
static void eraser_end_of_the_pen(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-sketch", "tool-points", "tool-tangents", "tool-smooth",
                                        "tool-pan"};
    for (size_t i = 0; i < sizeof tools / sizeof *tools; i++) {
        bat_editor *editor = brush_editor(tools[i]);
        pen p = pen_for(editor);
        uint64_t first = digest(editor);
        uint32_t tool = bat_editor_frame(editor)->tool;
        p.buttons = BAT_BUTTON_ERASER;
        pen_event(&p, BAT_POINTER_DOWN, 480, 100);
        pen_event(&p, BAT_POINTER_MOVE, 480, 200);
        assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_ERASED));
        check(editor);
        pen_event(&p, BAT_POINTER_UP, 480, 200);
        check(editor);
        assert_int_equal(count(editor), 3);
        assert_int_equal(bat_editor_frame(editor)->tool, tool);
        assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_ERASED));
        p.buttons = BAT_BUTTON_ERASER;
        pen_event(&p, BAT_POINTER_DOWN, 500, 200);
        pen_event(&p, BAT_POINTER_CANCEL, 500, 200);
        check(editor);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
}

/* The button on its barrel, held as it comes down, smooths with any tool that does not navigate, or moves the view, does nothing, or
 * tilts the view. */
static void barrel_of_the_pen(void **state) {
    (void)state;
    for (uint32_t tip = 0; tip <= BAT_BUTTON_PRIMARY; tip++) /* some tablets tell of the tip besides */
        for (int way = 0; way < 4; way++) {
            bat_editor *editor = brush_editor("tool-points");
            pen p = pen_for(editor);
            uint64_t first = digest(editor);
            double x = bat_editor_frame(editor)->view[0];
            uint32_t tool = bat_editor_frame(editor)->tool;
            assert_int_equal(bat_editor_set(editor, "barrel-button", way), BAT_OK);
            p.buttons = BAT_BUTTON_SECONDARY | tip;
            pen_event(&p, BAT_POINTER_DOWN, 480, 100);
            for (int i = 0; i <= 20; i++) pen_event(&p, BAT_POINTER_MOVE, 440 + 4 * i, 200);
            assert_int_equal(pen_live(bat_editor_frame(editor), BAT_ROLE_REACH) != NULL, way == 0);
            check(editor);
            if (way == 3) pen_event(&p, BAT_POINTER_MOVE, 520, 40); /* upwards, as the page faces the eye */
            pen_event(&p, BAT_POINTER_UP, 520, way == 3 ? 40 : 200);
            check(editor);
            const bat_frame *frame = bat_editor_frame(editor);
            assert_int_equal(frame->tool, tool);
            if (way == 0) assert_true(frame->view[0] == x);
            if (way == 1) assert_true(fabs(frame->view[0] - x) > 30 && digest(editor) == first);
            if (way == 2) assert_true(frame->view[0] == x && (tip || digest(editor) == first));
            assert_true((frame->tilt > 1) == (way == 3));
            if (way == 3) assert_true(digest(editor) == first);
            bat_editor_free(editor);
        }
    /* A mouse's second button is none of it. */
    bat_editor *editor = brush_editor("tool-sketch");
    pen p = pen_for(editor);
    p.device = BAT_DEVICE_MOUSE, p.buttons = BAT_BUTTON_SECONDARY;
    pen_event(&p, BAT_POINTER_DOWN, 480, 200);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_REACH));
    pen_event(&p, BAT_POINTER_UP, 480, 200);
    bat_editor_free(editor);
}

/* Integral of the squared curvature: what fairing lowers. */
static double roughness(const bat_curve *curve, double x0, double x1) {
    double domain[2], sum = 0;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < 2000; i++) {
        double u = domain[0] + (domain[1] - domain[0]) * (i + 0.5) / 2000, d[4];
        bat_curve_eval(curve, u, 1, d);
        double k = bat_curve_curvature(curve, u);
        if (d[0] > x0 && d[0] < x1) sum += k * k * hypot(d[2], d[3]);
    }
    return sum;
}

static double apart(const bat_curve *a, const bat_curve *b) {
    double ab = 0, ba = 0;
    bat_curve_distance(a, b, 40, &ab, &ba);
    return fmax(ab, ba);
}

static void brush_fairs_within_its_limit(void **state) {
    (void)state;
    bat_editor *editor = trembling_editor("tool-smooth");
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    bat_curve *old = NULL;
    bat_curve_copy(curve_at(editor, 0), &old);
    pen_event(&p, BAT_POINTER_HOVER, 400, 150);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_non_null(pen_live(frame, BAT_ROLE_REACH));
    assert_non_null(pen_live(frame, BAT_ROLE_STRETCH));
    pen_begin(&p, pen_arch, (double[]){350, 150, 650, 150, 0}, 40);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
    check(editor);
    assert_true(digest(editor) == first);
    pen_event(&p, BAT_POINTER_UP, 650, 150);
    check(editor);
    assert_true(digest(editor) != first);
    assert_true(roughness(curve_at(editor, 0), 340, 660) < roughness(old, 340, 660));
    assert_true(apart(old, curve_at(editor, 0)) <= 5 + 1e-6);
    /* beyond the stretch and its transitions nothing moves */
    double end[2], was[2];
    bat_curve_eval(old, 0, 0, was);
    bat_curve_eval(curve_at(editor, 0), 0, 0, end);
    assert_true(fabs(end[0] - was[0]) < 1e-9 && fabs(end[1] - was[1]) < 1e-9);
    bat_curve_free(old);
    round_trip(editor, first);
    bat_editor_free(editor);
}

static void calming_keeps_the_tolerance(void **state) {
    (void)state;
    static const char *const tools[] = {"tool-sketch", "tool-points", "tool-smooth"};
    for (size_t i = 0; i < 3; i++) {
        bat_editor *editor = trembling_editor(tools[i]);
        pen p = pen_for(editor);
        uint64_t first = digest(editor);
        bat_curve *old = NULL;
        double at[2];
        bat_curve_copy(curve_at(editor, 0), &old);
        bat_curve_eval(old, 14, 0, at);
        bat_editor_set(editor, "tolerance", 2);
        bat_editor_set(editor, "brush-size", 90);
        assert_false(bat_editor_key(editor, "g", false, 0, p.time));
        pen_event(&p, BAT_POINTER_HOVER, at[0], at[1] + 3);
        bat_editor_key(editor, "g", true, 0, p.time);
        assert_true(digest(editor) == first);
        assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_STRETCH));
        bat_editor_key(editor, "g", false, 0, p.time);
        check(editor);
        assert_true(digest(editor) != first);
        assert_non_null(strstr(bat_editor_frame(editor)->notice, "Smoothed"));
        assert_true(apart(old, curve_at(editor, 0)) <= 2 + 1e-6);
        assert_true(roughness(curve_at(editor, 0), 200, 800) < roughness(old, 200, 800));
        bat_curve_free(old);
        round_trip(editor, first);
        bat_editor_free(editor);
    }
}

/* With nothing under the pointer what is selected is calmed, a group with all that is in it, in one step; ten presses
 * add no knot, and when nothing is left that is said. Nothing selected either: nothing to do. */
static void calming_the_selection(void **state) {
    (void)state;
    bat_editor *editor = trembling_editor("tool-select");
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    bat_curve *old = NULL;
    bat_curve_copy(curve_at(editor, 0), &old);
    pen_event(&p, BAT_POINTER_HOVER, 500, 700);
    bat_editor_key(editor, "g", true, 0, p.time);
    assert_true(bat_editor_key(editor, "g", false, 0, p.time) || digest(editor) == first);
    assert_true(digest(editor) == first);
    bat_editor_select(editor, bat_object_id(bat_document_at(bat_editor_document(editor), 0)), false);
    for (int press = 0; press < 10; press++) {
        bat_editor_key(editor, "g", true, 0, p.time);
        bat_editor_key(editor, "g", false, 0, p.time);
        check(editor);
        assert_int_equal(bat_curve_knot_count(curve_at(editor, 0)), bat_curve_knot_count(old));
        const char *notice = bat_editor_frame(editor)->notice;
        assert_true(strstr(notice, "Smoothed") || strstr(notice, "nothing left to smooth"));
        assert_true(press || strstr(notice, "Smoothed"));
    }
    assert_true(roughness(curve_at(editor, 0), 220, 780) < roughness(old, 220, 780) / 2);
    bat_curve_free(old);
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* The comb stands on the curve, its teeth can be read at every zoom; a ring's are all as long. */
static void comb_is_readable(void **state) {
    (void)state;
    bat_editor *editor = brush_editor("tool-sketch");
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_HOVER, 640, 400);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_COMB));
    assert_true(bat_editor_key(editor, "c", true, 0, p.time));
    for (int zoom = 0; zoom < 4; zoom++) {
        const bat_frame *frame = bat_editor_frame(editor);
        const bat_item *comb = pen_live(frame, BAT_ROLE_COMB);
        assert_non_null(comb);
        double scale = frame->view[2];
        for (uint32_t i = 0; i + 5 < comb->path_count; i += 6) {
            double length = hypot((double)comb->path[i + 4] - (double)comb->path[i + 1],
                                  (double)comb->path[i + 5] - (double)comb->path[i + 2]) *
                            scale;
            assert_true(length > 25 && length < 60);
        }
        bat_editor_wheel(editor, 640, 400, 0, -140, BAT_CTRL, p.time);
    }
    bat_editor_key(editor, "c", true, 0, p.time);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_COMB));
    /* inflections of the wave are marked: as many circles as there are */
    bat_editor_command(editor, "zoom-100");
    bat_editor_command(editor, "view-fit");
    bat_editor_command(editor, "show-comb");
    double u[64];
    int inflections = (int)bat_curve_inflections(curve_at(editor, 0), 64, u);
    assert_true(inflections > 0 && inflections < 64);
    const double *view = bat_editor_frame(editor)->view;
    double at[2];
    bat_curve_eval(curve_at(editor, 0), 4, 0, at);
    pen_event(&p, BAT_POINTER_HOVER, (at[0] - view[0]) * view[2], (at[1] - view[1]) * view[2]);
    const bat_frame *frame = bat_editor_frame(editor);
    const bat_item *marks = NULL;
    for (uint32_t i = 0; i < frame->live_count; i++)
        if (frame->live[i].role == BAT_ROLE_COMB && frame->live[i].flags & BAT_ITEM_FILLED)
            marks = &frame->live[i];
    assert_non_null(marks);
    assert_int_equal(marks->path_count, inflections * (3 + 8 * 7 + 1)); /* circles of eight arcs */
    bat_editor_free(editor);
}

static void knots_and_lengths_by_key(void **state) {
    (void)state;
    bat_editor *editor = brush_editor("tool-pan");
    pen p = pen_for(editor);
    pen_event(&p, BAT_POINTER_HOVER, 640, 400);
    bat_editor_key(editor, "k", true, 0, p.time);
    bat_editor_key(editor, "m", true, 0, p.time);
    const bat_frame *frame = bat_editor_frame(editor);
    (void)frame;
    pen_event(&p, BAT_POINTER_HOVER, 640, 401);
    frame = bat_editor_frame(editor);
    const bat_item *knots = pen_live(frame, BAT_ROLE_KNOT);
    assert_non_null(knots);
    assert_int_equal(knots->path_count, 12 * 13); /* a mark is a move, three lines, a close */
    assert_true(frame->label_count == 1);
    double length = bat_curve_length(curve_at(editor, 1), 0, 12, 1e-9);
    assert_true(fabs(atof(frame->labels[0].text) - length) < 1e-4 * length);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(eraser_parts_an_open_curve),
        cmocka_unit_test(eraser_opens_a_closed_curve_and_takes_all),
        cmocka_unit_test(eraser_over_the_seam),
        cmocka_unit_test(eraser_end_of_the_pen),
        cmocka_unit_test(barrel_of_the_pen),
        cmocka_unit_test(brush_fairs_within_its_limit),
        cmocka_unit_test(calming_keeps_the_tolerance),
        cmocka_unit_test(calming_the_selection),
        cmocka_unit_test(comb_is_readable),
        cmocka_unit_test(knots_and_lengths_by_key),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
