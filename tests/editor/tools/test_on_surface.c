/* A surface as the ground: strokes land on it, and go on in its tangent plane where they leave it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/editing.h"
#include "support/sheet.h"
#include <batten/batten.h>
#include <math.h>
#include <stdlib.h>

/* Over the sheet, in a view tilted so often by 15 degrees. Takes the sheet over. */
static bat_editor *over(bat_surface *sheet, int tilts) {
    bat_document *document = NULL;
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(sheet_add(document, bat_document_new_id(document), sheet), BAT_OK);
    bat_surface_free(sheet);
    bat_editor *editor = editor_of(document);
    bat_editor_command(editor, "tool-sketch");
    for (int i = 0; i < tilts; i++) assert_int_equal(bat_editor_command(editor, "orbit-up"), BAT_OK);
    bat_editor_frame(editor);
    return editor;
}

/* A sheet over 300..700 x 200..600 with hills. */
static bat_editor *over_sheet(int tilts) { return over(sheet_create(), tilts); }

/* A flat one, whose parameters run as those of the other. */
static bat_editor *over_flat(int tilts) {
    const double points[12] = {300, 200, -20, 300, 600, -20, 700, 200, -20, 700, 600, -20};
    const double u[4] = {0, 0, 4, 4}, v[4] = {0, 0, 3, 3};
    bat_surface *sheet = NULL;
    assert_int_equal(bat_surface_create((const int[2]){1, 1}, (const bool[2]){false, false},
                                        (const size_t[2]){2, 2}, points, (const int[2]){4, 4}, u, v, &sheet),
                     BAT_OK);
    return over(sheet, tilts);
}

static const bat_surface *sheet_of(const bat_editor *editor) {
    return bat_object_surface(bat_document_at(bat_editor_document(editor), 0));
}

/* The pixel of a point. */
static void seen(const bat_editor *editor, const double point[3], double pixel[2]) {
    double at[2];
    bat_stage_look(&editor->stage, 3, point, at);
    bat_stage_project(&editor->stage, at, pixel);
}

static void seen_at(const bat_editor *editor, double u, double v, double pixel[2]) {
    double point[3];
    bat_surface_eval(sheet_of(editor), u, v, 0, point);
    seen(editor, point, pixel);
}

static void onto_sheet(bat_editor *editor, pen *p) {
    double at[2];
    seen_at(editor, 2, 1.5, at);
    pen_event(p, BAT_POINTER_HOVER, at[0], at[1]);
    bat_editor_frame(editor);
    assert_int_equal(bat_editor_command(editor, "draw-on-plane"), BAT_OK);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "Drawing on"));
}

/* The greatest distance of the curve from the sheet over a share of its domain. */
static double off_sheet(const bat_editor *editor, const bat_curve *curve, double from, double to) {
    double domain[2], most = 0;
    bat_curve_domain(curve, domain);
    for (int i = 0; i <= 40; i++) {
        double point[3], share = from + (to - from) * i / 40;
        bat_surface_point near;
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * share, 0, point);
        assert_int_equal(bat_surface_nearest(sheet_of(editor), point, &near), BAT_OK);
        most = fmax(most, near.distance);
    }
    return most;
}

static void a_stroke_lies_on_the_surface(void **state) {
    (void)state;
    for (int tilts = 0; tilts <= 4; tilts += 2) {
        bat_editor *editor = over_sheet(tilts);
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        double a[2], b[2];
        onto_sheet(editor, &p);
        seen_at(editor, 0.8, 1, a);
        seen_at(editor, 3.2, 2, b);
        pen_line(&p, a[0], a[1], b[0], b[1], 20);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), 2);
        const bat_curve *made = bat_object_curve(bat_document_at(bat_editor_document(editor), 1), 0);
        assert_int_equal(bat_curve_dimension(made), 3);
        assert_true(off_sheet(editor, made, 0, 1) < 1.5);
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
}

static void what_leaves_it_goes_on_in_its_tangent_plane(void **state) {
    (void)state;
    bat_editor *editor = over_sheet(3);
    pen p = pen_for(editor);
    double a[2], b[2];
    onto_sheet(editor, &p);
    seen_at(editor, 2, 1.5, a);
    seen_at(editor, 4, 1.5, b);
    pen_line(&p, a[0], a[1], b[0] + (b[0] - a[0]) * 0.5, b[1] + (b[1] - a[1]) * 0.5, 0);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "left the surface"));
    const bat_curve *made = bat_object_curve(bat_document_at(bat_editor_document(editor), 1), 0);
    double jet[9], normal[3], end[3], domain[2], off = 0;
    assert_true(off_sheet(editor, made, 0, 0.6) < 1.5);
    assert_int_equal(bat_surface_normal(sheet_of(editor), 4, 1.5, normal), BAT_OK);
    bat_surface_eval(sheet_of(editor), 4, 1.5, 0, jet);
    bat_curve_domain(made, domain);
    bat_curve_eval(made, domain[1], 0, end);
    for (int k = 0; k < 3; k++) off += (end[k] - jet[k]) * normal[k];
    assert_true(fabs(off) < 6); /* the stroke leaves it a sample before the edge, where the normal differs */
    assert_true(hypot(end[0] - jet[0], end[1] - jet[1]) > 50);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* Beside the surface the page is drawn on; a double tap changes between the two. */
static void beside_it_lies_the_page(void **state) {
    (void)state;
    bat_editor *editor = over_sheet(2);
    pen p = pen_for(editor);
    double at[2];
    onto_sheet(editor, &p);
    pen_line(&p, 60, 120, 200, 140, 10);
    const bat_curve *made = bat_object_curve(bat_document_at(bat_editor_document(editor), 1), 0);
    assert_int_equal(bat_curve_dimension(made), 2);
    seen_at(editor, 2, 1.5, at);
    for (int ground = 0; ground < 2; ground++) {
        for (int i = 0; i < 2; i++) {
            pen_event(&p, BAT_POINTER_DOWN, at[0], at[1]);
            pen_event(&p, BAT_POINTER_UP, at[0], at[1]);
            bat_editor_frame(editor);
        }
        assert_true((editor->stage.ground.object != 0) == (ground == 1));
        p.time += 2000;
    }
    assert_int_equal(bat_editor_command(editor, "draw-on-page"), BAT_OK);
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 2);
    check(editor);
    bat_editor_free(editor);
}

/* In perspective a stroke leaves the sheet away from the eye, and goes over the horizon of the plane that touches it there:
 * beyond, nothing can land. With over a third of the samples there it is refused whole, in words; with fewer they are left
 * out, and counted. */
static void a_third_that_misses_is_too_much(void **state) {
    (void)state;
    for (int high = 0; high < 2; high++) {
        bat_editor *editor = over_flat(5);
        pen p = pen_for(editor);
        double a[2];
        assert_int_equal(bat_editor_command(editor, "perspective"), BAT_OK);
        bat_editor_frame(editor);
        onto_sheet(editor, &p);
        const uint64_t first = digest(editor);
        const int count = bat_document_count(bat_editor_document(editor));
        seen_at(editor, 2, 0.6, a);
        size_t before, after;
        bat_editor_journal(editor, &before);
        enum { SAMPLES = 90 };
        const double top = high ? -a[1] : a[1] - 210;
        for (int i = 0; i <= SAMPLES; i++)
            pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, a[0], a[1] + (top - a[1]) * i / SAMPLES);
        pen_event(&p, BAT_POINTER_UP, a[0], top);
        const char *notice = bat_editor_frame(editor)->notice;
        const int dropped = atoi(notice + strcspn(notice, "0123456789"));
        if (high) {
            assert_true(3 * dropped > SAMPLES + 1);
            assert_non_null(strstr(notice, "Too much of the stroke missed the surface"));
            assert_true(digest(editor) == first);
            bat_editor_journal(editor, &after);
            assert_int_equal(after, before);
        } else {
            assert_true(dropped > 0 && 3 * dropped <= SAMPLES + 1);
            assert_non_null(strstr(notice, "were left out"));
            assert_int_equal(bat_document_count(bat_editor_document(editor)), count + 1);
            assert_int_equal(round_trip(editor, first), 1);
        }
        check(editor);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stroke_lies_on_the_surface),
        cmocka_unit_test(what_leaves_it_goes_on_in_its_tangent_plane),
        cmocka_unit_test(beside_it_lies_the_page),
        cmocka_unit_test(a_third_that_misses_is_too_much),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
