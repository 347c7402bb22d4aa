/* Widths along strokes in the editor: by name, as items, as outlines; turned, cut and joined with the curve; undone and replayed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/edit/profile.h"
#include "support/selecting.h"
#include <batten/format.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/paint.h>

#include <math.h>
#include <string.h>

static bat_curve *line(double x0, double x1, double y) {
    const double points[4] = {x0, y, x1, y};
    bat_curve *made;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &made), BAT_OK);
    return made;
}

static bat_editor *lines(void) {
    bat_curve *curves[2] = {line(100, 500, 300), line(500, 600, 300)};
    bat_editor *editor = editor_with(2, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static void set(bat_editor *editor, const char *property, double value) {
    assert_int_equal(bat_editor_set(editor, property, value), BAT_OK);
    assert_null(bat_editor_check(editor));
}

static double got(bat_editor *editor, const char *property) {
    double value;
    assert_int_equal(bat_editor_get(editor, property, &value), BAT_OK);
    return value;
}

static void runs(bat_editor *editor, const char *command) {
    assert_int_equal(bat_editor_command(editor, command), BAT_OK);
    assert_null(bat_editor_check(editor));
}

static double area(const bat_object *object) {
    double sum = 0;
    for (int i = 0; i < bat_object_curve_count(object); i++)
        sum += fabs(bat_curve_area(bat_object_curve(object, i)));
    return sum;
}

static void have_names(void **state) {
    (void)state;
    bat_editor *editor = lines();
    only(editor, 1, 0);
    set(editor, "stroke-width", 20);
    set(editor, "stroke-cap", BAT_CAP_BUTT);
    const uint64_t first = digest(editor);
    assert_true(got(editor, "widths") == 0);
    static const double areas[] = {400 * 20, 400 * 10, 400 * 10, 400 * 12.5,
                                   400 * 20 * (0.65 - 1.5 * 1.4 / 24)};
    for (int k = 1; k < 5; k++) {
        set(editor, "widths", k);
        assert_true(got(editor, "widths") == k);
        runs(editor, "curve-outline");
        const bat_style *style = bat_object_style(object(editor, 1));
        assert_true(!style->stroked && style->filled && !bat_object_paint(object(editor, 1)));
        assert_true(fabs(area(object(editor, 1)) - areas[k]) < 0.01 * areas[k]);
        runs(editor, "undo");
    }
    set(editor, "widths", 5); /* as they are */
    assert_true(got(editor, "widths") == 4);
    set(editor, "stroke-width", 30); /* they grow with it */
    assert_true(got(editor, "widths") == 4);
    set(editor, "stroke-width", 20);
    set(editor, "widths", 0);
    assert_true(digest(editor) == first);
    only(editor, 0, 0);
    set(editor, "widths", 1); /* nothing is selected */
    assert_true(digest(editor) == first);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* How many items paint the object, and the flags of the last. */
static int items_of(bat_editor *editor, uint32_t id, uint32_t *flags) {
    const bat_frame *frame = bat_editor_frame(editor);
    int count = 0;
    for (size_t i = 0; i < frame->still_count; i++)
        if (frame->still[i].id == id || frame->still[i].id == 0) count++, *flags = frame->still[i].flags;
    return count;
}

static void are_painted_as_what_they_cover(void **state) {
    (void)state;
    bat_editor *editor = lines();
    uint32_t flags = 0;
    only(editor, 1, 0);
    assert_int_equal(items_of(editor, 1, &flags), 1);
    assert_int_equal(flags, BAT_ITEM_STROKED);
    set(editor, "widths", 3);
    assert_int_equal(items_of(editor, 1, &flags), 1);
    assert_int_equal(flags, BAT_ITEM_FILLED);
    set(editor, "filled", 1); /* the fill, and the stroke over it */
    assert_int_equal(items_of(editor, 1, &flags), 2);
    set(editor, "opacity", 0.5); /* as one picture */
    assert_int_equal(items_of(editor, 1, &flags), 3);
    set(editor, "outline", 1);
    assert_int_equal(items_of(editor, 1, &flags), 1);
    assert_int_equal(flags, BAT_ITEM_STROKED | BAT_ITEM_SCREEN_WIDTH);
    bat_editor_free(editor);
}

static void turn_and_are_cut_and_joined(void **state) {
    (void)state;
    bat_editor *editor = lines();
    const uint64_t first = digest(editor);
    only(editor, 1, 0);
    set(editor, "widths", 1);
    runs(editor, "curve-reverse");
    assert_true(got(editor, "widths") == 2);
    runs(editor, "curve-reverse");
    assert_true(got(editor, "widths") == 1);
    only(editor, 1, 2);
    runs(editor, "curve-join"); /* 400 of 500 narrow to a point; then the even one begins */
    bat_width_profile profile = bat_object_widths(object(editor, 1));
    double value[2];
    const double shares[][2] = {{0, 1}, {0.4, 0.5}, {0.79999, 0}, {0.81, 1}, {1, 1}};
    for (int i = 0; i < 5; i++) {
        bat_width_eval(&profile, false, shares[i][0], value);
        assert_true(fabs(value[0] - shares[i][1]) < 0.15);
    }
    runs(editor, "undo");
    only(editor, 1, 0);
    pen p = mouse(editor);
    click(&p, 300, 300, 0);
    runs(editor, "curve-split"); /* in the middle */
    profile = bat_object_widths(object(editor, 1));
    assert_true(profile.count == 2 && profile.stops[0].share == 1 &&
                fabs(profile.stops[1].share - 0.5) < 0.01);
    profile = bat_object_widths(object(editor, 3));
    assert_true(profile.count == 2 && fabs(profile.stops[0].share - 0.5) < 0.01 &&
                profile.stops[1].share == 0);
    for (int i = 0; i < 4; i++) runs(editor, "undo");
    assert_true(digest(editor) == first);
    replays(editor, 0);
    bat_editor_free(editor);
}

static double share_at(const bat_object *object, double at) {
    const bat_width_profile profile = bat_object_widths(object);
    double value[2];
    bat_width_eval(&profile, bat_curve_is_closed(bat_object_curve(object, 0)), at, value);
    return value[0];
}

/* Each piece is as wide everywhere as the whole was there. */
static void is_as_wide(const bat_object *piece, const bat_object *whole) {
    const bat_curve *curve = bat_object_curve(piece, 0), *old = bat_object_curve(whole, 0);
    double part[2], all[2];
    bat_curve_domain(curve, part);
    bat_curve_domain(old, all);
    const double length = bat_curve_length(old, all[0], all[1], 1e-9),
                 own = bat_curve_length(curve, part[0], part[1], 1e-9);
    for (int i = 0; i <= 20; i++) {
        const double u = bat_curve_at_length(curve, part[0], own * i / 20, 1e-9);
        double point[2];
        bat_near near;
        bat_curve_eval(curve, u, 0, point);
        assert_int_equal(bat_curve_nearest(old, point, &near), BAT_OK);
        const double place = bat_curve_length(old, all[0], near.u, 1e-9) / length;
        const double away = fabs(share_at(piece, i / 20.0) - share_at(whole, place));
        if (!(away < 0.06)) fail_msg("%g at %d of %g", away, i, place);
    }
}

static void pieces_keep_their_part(void **state) {
    (void)state;
    double points[24], knots[13];
    for (int i = 0; i < 12; i++) {
        points[2 * i] = 500 + 150 * cos(6.283185307179586 * i / 12);
        points[2 * i + 1] = 400 + 150 * sin(6.283185307179586 * i / 12);
    }
    for (int i = 0; i <= 12; i++) knots[i] = i;
    for (int closed = 0; closed < 2; closed++) {
        bat_curve *curve = NULL;
        if (closed)
            assert_int_equal(bat_curve_create(2, 3, true, 12, points, 13, knots, &curve), BAT_OK);
        else
            curve = line(100, 500, 300);
        bat_editor *editor = editor_with(1, &curve);
        bat_editor_command(editor, "tool-select");
        only(editor, 1, 0);
        const bat_width_stop stops[] = {{0.2, 0.5}, {0.4, 2}, {0.7, 1}};
        bat_object *wide = NULL, *whole = bat_object_retain(object(editor, 1));
        assert_int_equal(bat_profile_set(whole, 3, stops, &wide), BAT_OK);
        bat_object_release(whole);
        bat_document *document = NULL;
        assert_int_equal(bat_document_create(&document), BAT_OK);
        bat_document_set_page(document, (double[]){0, 0, 1000, 800});
        assert_int_equal(bat_document_insert(document, 0, wide), BAT_OK);
        bat_editor_free(editor);
        editor = editor_of(document);
        const uint64_t first = digest(editor);
        runs(editor, "tool-eraser");
        pen p = pen_for(editor);
        if (closed) {
            pen_line(&p, 640, 395, 660, 395, 0); /* its right */
            pen_line(&p, 340, 395, 360, 395, 0); /* and its left */
        } else
            pen_line(&p, 290, 300, 310, 300, 0);
        assert_int_equal(bat_document_count(editor->session.document), 2);
        for (int i = 0; i < 2; i++) is_as_wide(bat_document_at(editor->session.document, i), wide);
        for (int i = 0; i <= closed; i++) runs(editor, "undo");
        assert_true(digest(editor) == first);
        replays(editor, 0);
        bat_editor_free(editor);
        bat_object_release(wide);
    }
}

/* What plotters, cutters and font editors get of a drawing: one line for each curve, however wide it is. */
static void centre_lines(const bat_editor *editor, char *out[3]) {
    const bat_document *document = editor->session.document;
    size_t size = 0;
    const bat_gcode_options options = bat_gcode_defaults();
    assert_int_equal(bat_gcode_write(document, &options, &out[0], &size), BAT_OK);
    assert_int_equal(bat_dxf_write(document, 0, &out[1], &size), BAT_OK);
    assert_int_equal(bat_glif_write(document, false, &out[2], &size), BAT_OK);
}

static void come_from_pressure(void **state) {
    (void)state;
    char *out[2][3];
    for (int on = 0; on < 2; on++) {
        bat_editor *editor = lines();
        const uint64_t first = digest(editor);
        if (!on) set(editor, "pressure-width", 0); /* it is on at first */
        set(editor, "stroke-width", 20);
        runs(editor, "tool-sketch");
        pen p = pen_for(editor);
        pen_begin(&p, pen_arch, (const double[]){100, 600, 500, 620, 60}, 100); /* as wide as it will be */
        const bat_item *wide = pen_live(bat_editor_frame(editor), BAT_ROLE_FIT);
        if (!on) wide = wide && wide->flags & BAT_ITEM_FILLED ? wide : NULL; /* a line of one width */
        assert_true(on ? wide && wide->flags & BAT_ITEM_FILLED && wide->path_count > 100 : !wide);
        assert_true(!wide || wide->bounds[3] - wide->bounds[1] > 60);
        bat_editor_key(editor, "Escape", true, 0, 0);
        pen_event(&p, BAT_POINTER_UP, 500, 620);
        p.time = 1000;
        pen_stroke(&p, pen_arch, (const double[]){100, 600, 500, 620, 60}, 100);
        assert_int_equal(bat_document_count(editor->session.document), 3);
        const bat_width_profile profile = bat_object_widths(object(editor, 3));
        assert_true(on ? profile.count > 3 : profile.count == 0); /* flat lines stay flat lines */
        for (int i = 0; i <= 100 && on; i++) { /* the pen presses 0.5 + 0.25 sin(t / 100) */
            double value[2];
            bat_width_eval(&profile, false, i / 100.0, value);
            const double wanted = 1 + 0.5 * sin((1004 + 4 * i) / 100.0);
            const bool end = i < 12 || i > 88; /* it runs out to a point */
            assert_true(end ? value[0] < wanted + 0.1 : fabs(value[0] - wanted) < 0.1);
            if (i % 100 == 0) assert_true(value[0] == 0);
        }
        centre_lines(editor, out[on]);
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
    for (int i = 0; i < 3; i++) {
        assert_string_equal(out[0][i], out[1][i]);
        bat_free(out[0][i]), bat_free(out[1][i]);
    }
    bat_editor *editor = lines(); /* a mouse presses evenly */
    set(editor, "pressure-width", 1);
    runs(editor, "tool-sketch");
    pen p = mouse(editor);
    drag(&p, 100, 500, 500, 520);
    assert_int_equal(bat_object_widths(object(editor, 3)).count, 0);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(have_names), cmocka_unit_test(come_from_pressure),
                                       cmocka_unit_test(are_painted_as_what_they_cover),
                                       cmocka_unit_test(turn_and_are_cut_and_joined),
                                       cmocka_unit_test(pieces_keep_their_part)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
