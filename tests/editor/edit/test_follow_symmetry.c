/* Symmetry and what follows: a curve is redrawn on one side, its twin on the other becomes its image, and what both lead follows
 * on both sides, in the preview as in the end; bound curves whose images are bound as well stay bound. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "support/editing.h"
#include "support/bound.h"

enum { LED_LEFT = 10, LED_RIGHT = 11, LEFT = 12, RIGHT = 13 }; /* of curves alone, the one drawn last leads */

/* The sheet or mesh in the middle of the page, with lines at 300 and 500; the axis is at 400. */
static bat_editor *begun(what thing) {
    const bat_style style = bat_style_defaults();
    bat_document *document = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){-100, 0, 1000, 800});
    if (thing == A_SHEET) {
        bat_surface *sheet = sheet_of();
        assert_int_equal(bat_object_create_surface(SHEET, "", &style, sheet, &object), BAT_OK);
        bat_surface_free(sheet);
    } else {
        bat_polymesh *mesh = mesh_of();
        assert_int_equal(bat_object_create_mesh(SHEET, "", &style, mesh, &object), BAT_OK);
        bat_polymesh_free(mesh);
    }
    add(document, object);
    add_line(document, LEFT, 300), add_line(document, RIGHT, 500);
    bat_editor *editor = editor_of(document);
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
    assert_int_equal(bat_editor_command(editor, "wire-bind"), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "symmetry", 1), BAT_OK);
    return editor;
}

/* In the window the page begins 100 further to the left. */
static void pen_at(pen *p, bat_pointer_phase phase, double x, double y) { pen_event(p, phase, x + 100, y); }

/* The most by which a point is off the image of its fellow. */
static double unlike(const bat_editor *editor) {
    double most = 0, a[3], b[3];
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            point_at(editor, i * SIDE + j, a), point_at(editor, (SIDE - 1 - i) * SIDE + j, b);
            most = fmax(most, fmax(fabs(a[0] + b[0] - 800), fmax(fabs(a[1] - b[1]), fabs(a[2] - b[2]))));
        }
    return most;
}

/* What moves more than a thousandth as far as what moves farthest: as the hint counts. */
static size_t moved(const bat_editor *editor, const double *rest) {
    const double least = 1e-3 * farthest(editor, rest);
    size_t count = 0;
    double now[3];
    for (size_t i = 0; i < points_of(editor); i++) {
        point_at(editor, (int)i, now);
        const double *from = rest + 3 * i;
        count += hypot(hypot(now[0] - from[0], now[1] - from[1]), now[2] - from[2]) > least;
    }
    return count;
}

static void both_sides_follow_a_stroke(void **state) {
    (void)state;
    for (int thing = A_SHEET; thing <= A_MESH; thing++) {
        bat_editor *editor = begun((what)thing);
        double *rest = rest_of(editor);
        char hint[256] = "";
        const uint64_t bound = digest(editor);
        assert_true(unlike(editor) < 1e-9);
        pen p = pen_for(editor);
        bat_editor_command(editor, "tool-sketch");
        p.time += 1000;
        pen_at(&p, BAT_POINTER_HOVER, 300, 290);
        bat_editor_frame(editor);
        pen_at(&p, BAT_POINTER_DOWN, 300, 290);
        for (int i = 1; i <= 40; i++) {
            const double t = i / 40.0;
            pen_at(&p, BAT_POINTER_MOVE, 300 - 28 * 16 * t * t * (1 - t) * (1 - t), 290 + 220 * t);
            snprintf(hint, sizeof hint, "%s", bat_editor_frame(editor)->hint);
        }
        pen_at(&p, BAT_POINTER_UP, 300, 510);
        bat_editor_frame(editor);
        check(editor);
        assert_true(digest(editor) != bound);
        is_fresh(editor, rest);
        assert_true(farthest(editor, rest) > 10);
        assert_true(unlike(editor) < 1e-6);
        const char *told = strstr(hint,
                                  "\xc2\xb7 "); /* of both sides; the hand fits a little closer at the end */
        assert_non_null(told);
        const double count = strtod(told + 3, NULL), wanted = (double)moved(editor, rest);
        if (!(fabs(count - wanted) < 0.1 * wanted)) fail_msg("%s: not %g", hint, wanted);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == bound);
        free(rest);
        bat_editor_free(editor);
    }
}

/* Dragging a point of one of the wires. */
static void both_sides_follow_a_point(void **state) {
    (void)state;
    for (int thing = A_SHEET; thing <= A_MESH; thing++) {
        bat_editor *editor = begun((what)thing);
        double *rest = rest_of(editor);
        const uint64_t bound = digest(editor);
        bat_editor_command(editor, "tool-points");
        pen p = pen_for(editor);
        p.time += 1000;
        pen_at(&p, BAT_POINTER_HOVER, 300, 400);
        pen_at(&p, BAT_POINTER_DOWN, 300, 400);
        pen_at(&p, BAT_POINTER_UP, 300, 400);
        p.time += 1000;
        pen_at(&p, BAT_POINTER_HOVER, 300, 350);
        pen_at(&p, BAT_POINTER_DOWN, 300, 350);
        for (int i = 1; i <= 20; i++)
            pen_at(&p, BAT_POINTER_MOVE, 300 - 2 * i, 350), bat_editor_frame(editor);
        pen_at(&p, BAT_POINTER_UP, 260, 350);
        bat_editor_frame(editor);
        check(editor);
        assert_true(digest(editor) != bound);
        is_fresh(editor, rest);
        assert_true(farthest(editor, rest) > 5);
        assert_true(unlike(editor) < 1e-6);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == bound);
        free(rest);
        bat_editor_free(editor);
    }
}

/* Curves that are led, each by the wire beside it: when one wire is dragged, both stay bound and are images of each other. */
static void led_curves_stay_bound(void **state) {
    (void)state;
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){-100, 0, 1000, 800});
    add_line(document, LED_LEFT, 280), add_line(document, LEFT, 300);
    add_line(document, LED_RIGHT, 520), add_line(document, RIGHT, 500);
    bat_editor *editor = editor_of(document);
    bat_editor_command(editor, "tool-select");
    for (int side = 0; side < 2; side++) {
        bat_editor_select(editor, side ? LED_RIGHT : LED_LEFT, false);
        bat_editor_select(editor, side ? RIGHT : LEFT, true);
        assert_int_equal(bat_editor_command(editor, "wire-bind"), BAT_OK);
    }
    assert_int_equal(bat_editor_set(editor, "symmetry", 1), BAT_OK);
    const uint64_t bound = digest(editor);
    for (int way = 0; way < 2; way++) { /* a stroke; a point */
        pen p = pen_for(editor);
        bat_editor_command(editor, way ? "tool-points" : "tool-sketch");
        bat_editor_select(editor, LEFT, false);
        p.time += 1000;
        const double from = way ? 350 : 290;
        if (way) {
            pen_at(&p, BAT_POINTER_HOVER, 300, 400), pen_at(&p, BAT_POINTER_DOWN, 300, 400);
            pen_at(&p, BAT_POINTER_UP, 300, 400);
            p.time += 1000;
        }
        pen_at(&p, BAT_POINTER_HOVER, 300, from), bat_editor_frame(editor);
        pen_at(&p, BAT_POINTER_DOWN, 300, from);
        for (int i = 1; i <= 40; i++) {
            const double t = i / 40.0;
            pen_at(&p, BAT_POINTER_MOVE, way ? 300 + i : 300 + 28 * 16 * t * t * (1 - t) * (1 - t),
                   way ? 350 : 290 + 220 * t);
            bat_editor_frame(editor);
        }
        pen_at(&p, BAT_POINTER_UP, way ? 340 : 300, way ? 350 : 510);
        bat_editor_frame(editor);
        check(editor);
        assert_true(digest(editor) != bound);
        const bat_object *left = found(editor, LED_LEFT), *right = found(editor, LED_RIGHT);
        assert_int_equal(bat_object_wires(left, NULL, NULL), 1);
        assert_int_equal(bat_object_wires(right, NULL, NULL), 1);
        const bat_curve *a = bat_object_curve(left, 0), *b = bat_object_curve(right, 0);
        assert_int_equal(bat_curve_count(a), bat_curve_count(b));
        double most = 0;
        for (size_t i = 0; i < bat_curve_count(a); i++) {
            const double *q = bat_curve_points(a) + 2 * i, *r = bat_curve_points(b) + 2 * i;
            assert_true(fabs(q[0] + r[0] - 800) < 1e-6 && fabs(q[1] - r[1]) < 1e-6);
            most = fmax(most, fabs(q[0] - 280));
        }
        assert_true(most > 5);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == bound);
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_sides_follow_a_stroke),
        cmocka_unit_test(both_sides_follow_a_point),
        cmocka_unit_test(led_curves_stay_bound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
