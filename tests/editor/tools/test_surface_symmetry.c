/* The surface tool with symmetry: a line redrawn on one side of the upright plane through the axis is redrawn on the
 * other, on the same surface or on its twin, in one step that the journal repeats. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "editor/editor.h"
#include "editor/tools/surface/state.h"
#include "editor/tools/toolbox.h"
#include "support/editing.h"
#include "support/sheet.h"

enum { SHEET = 7, TWIN = 9, U = 9, V = 6 };

/* A sheet over x from -200 to 200 (or from `low` to `high`) and y from 200 to 600, with hills that mirror each other in
 * x = 0. */
static bat_surface *hills(double low, double high) {
    double points[U * V * 3], u[U + 4], v[V + 4];
    for (int i = 0; i < U + 4; i++) u[i] = fmin(fmax(i - 3, 0), U - 3);
    for (int i = 0; i < V + 4; i++) v[i] = fmin(fmax(i - 3, 0), V - 3);
    for (int i = 0; i < U; i++)
        for (int j = 0; j < V; j++) {
            double *p = points + 3 * (i * V + j);
            const int k = i < U / 2 ? i : U - 1 - i;
            p[0] = low + (high - low) * i / (U - 1), p[1] = 200 + 400.0 * j / (V - 1),
            p[2] = 6.0 * ((3 * k + 5 * j) % 9 - 4);
        }
    bat_surface *surface = NULL;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false},
                                        (const size_t[2]){U, V}, points, (const int[2]){U + 4, V + 4}, u, v,
                                        &surface),
                     BAT_OK);
    return surface;
}

static const bat_surface *surface_in(const bat_editor *editor, bat_id id) {
    const bat_document *document = bat_editor_document(editor);
    return bat_object_surface(bat_document_at(document, bat_document_find(document, id)));
}

static bat_surfacing *state_of(bat_editor *editor) {
    return bat_toolbox_state(&editor->context, bat_tool_surface());
}

/* The page is as wide to the left of x = 0 as to the right. */
static bat_editor *with(const bat_surface *one, const bat_surface *two) {
    bat_document *document = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){-500, 0, 1000, 800});
    assert_int_equal(sheet_add(document, SHEET, one), BAT_OK);
    if (two) assert_int_equal(sheet_add(document, TWIN, two), BAT_OK);
    bat_editor *editor = editor_of(document);
    assert_int_equal(bat_editor_command(editor, "tool-surface"), BAT_OK);
    return editor;
}

static bat_surface *mirrored(const bat_surface *surface) {
    const double rows[12] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    bat_surface *image = NULL;
    assert_int_equal(bat_surface_transform(surface, rows, &image), BAT_OK);
    return image;
}

static void pixel_of(bat_editor *editor, const double point[3], double pixel[2]) {
    double drawn[2];
    bat_stage_look(editor->context.stage, 3, point, drawn);
    bat_stage_project(editor->context.stage, drawn, pixel);
}

static void light(bat_editor *editor, bat_direction direction, double u, double v) {
    state_of(editor)->lit = (bat_line){SHEET, direction, {u, v}};
    bat_editor_frame(editor);
}

/* A stroke over the stretch from..to of the lit line, bulging by so many pixels. */
static void bulge(pen *p, double from, double to, double height, bool lift) {
    bat_editor *editor = p->editor;
    const bat_line line = state_of(editor)->lit;
    const bool at_u = line.direction == BAT_U;
    double point[3], a[2], b[2];
    bat_surface_eval(surface_in(editor, SHEET), at_u ? line.at[0] : from, at_u ? from : line.at[1], 0, point);
    pixel_of(editor, point, a);
    bat_surface_eval(surface_in(editor, SHEET), at_u ? line.at[0] : to, at_u ? to : line.at[1], 0, point);
    pixel_of(editor, point, b);
    const double way[2] = {b[0] - a[0], b[1] - a[1]}, length = hypot(way[0], way[1]);
    p->time += 1000;
    pen_event(p, BAT_POINTER_HOVER, a[0], a[1]);
    bat_editor_frame(editor);
    pen_event(p, BAT_POINTER_DOWN, a[0], a[1]);
    for (int i = 1; i <= 30; i++) {
        const double t = i / 30.0, w = 16 * t * t * (1 - t) * (1 - t) * height / length;
        pen_event(p, BAT_POINTER_MOVE, a[0] + t * way[0] - w * way[1], a[1] + t * way[1] + w * way[0]);
        if (i % 5 == 0) bat_editor_frame(editor);
        check(editor);
    }
    bat_editor_frame(editor);
    if (!lift) return;
    pen_event(p, BAT_POINTER_UP, b[0], b[1]);
    bat_editor_frame(editor);
    check(editor);
}

/* How far b at (u', v') is from being the image of a, where u' = 6 - u and v' = v, or as u. */
static double image_error(const bat_surface *a, const bat_surface *b, bool back) {
    double worst = 0, p[3], q[3];
    for (int i = 0; i <= 30; i++)
        for (int j = 0; j <= 15; j++) {
            const double u = 0.2 * i, v = 0.2 * j;
            bat_surface_eval(a, u, v, 0, p);
            bat_surface_eval(b, back ? 6 - u : u, v, 0, q);
            worst = fmax(worst, fmax(fabs(p[0] + q[0]), fmax(fabs(p[1] - q[1]), fabs(p[2] - q[2]))));
        }
    return worst;
}

/* The handle of the sheet is shown at the image, too, and turns with the one that is held. */
static void the_handle_is_mirrored(void **state) {
    (void)state;
    bat_surface *sheet = hills(-200, 200);
    for (int tilted = 0; tilted < 2; tilted++) {
        bat_editor *editor = with(sheet, NULL);
        pen p = pen_for(editor);
        double grip[2], at[2], other[2], end[2], point[3], place[2];
        for (int k = 0; k < 4 * tilted; k++) bat_editor_command(editor, "orbit-up");
        light(editor, BAT_U, 1.6, 1.5);
        assert_false(bat_surfacing_image_handle(&editor->context, state_of(editor), other, end));
        assert_int_equal(bat_editor_command(editor, "symmetry-origin"), BAT_OK);
        for (int turned = 0; turned < 2; turned++) {
            assert_true(bat_surfacing_handle(&editor->context, state_of(editor), grip, at));
            assert_true(bat_surfacing_image_handle(&editor->context, state_of(editor), other, end));
            bat_surface_eval(surface_in(editor, SHEET), 1.6, 1.5, 0, point);
            point[0] = -point[0];
            pixel_of(editor, point, place);
            assert_true(hypot(place[0] - other[0], place[1] - other[1]) < 1e-6);
            /* x = 0 is seen upright in both views. */
            assert_true(fabs((at[0] - grip[0]) + (end[0] - other[0])) < 1e-6);
            assert_true(fabs((at[1] - grip[1]) - (end[1] - other[1])) < 1e-6);
            if (!turned) drag(&p, at[0], at[1], at[0] + 40, at[1] - 25);
        }
        bat_editor_frame(editor);
        bat_editor_free(editor);
    }
    bat_surface_free(sheet);
}

static double most_apart(const bat_surface *a, const bat_surface *b, double u) {
    double worst = 0, p[3], q[3];
    for (int j = 0; j <= 30; j++) {
        bat_surface_eval(a, u, 0.1 * j, 0, p);
        bat_surface_eval(b, u, 0.1 * j, 0, q);
        for (int k = 0; k < 3; k++) worst = fmax(worst, fabs(p[k] - q[k]));
    }
    return worst;
}

/* The same stroke with the switch off and on: the line becomes the same, and its image comes along. */
static void both_lines_of_a_surface(void **state) {
    (void)state;
    bat_surface *sheet = hills(-200, 200);
    for (int tilted = 0; tilted < 2; tilted++)
        for (int place = 0; place < 3; place++) {
            const double at = 1.2 + 0.4 * place;
            bat_surface *alone = NULL;
            for (int on = 0; on < 2; on++) {
                bat_editor *editor = with(sheet, NULL);
                const uint64_t first = digest(editor);
                if (on) assert_int_equal(bat_editor_command(editor, "symmetry-origin"), BAT_OK);
                for (int k = 0; k < 2 * tilted; k++) bat_editor_command(editor, "orbit-up");
                pen p = pen_for(editor);
                light(editor, BAT_U, at, 1.5);
                bulge(&p, 0.6, 2.4, 30, true);
                const bat_surface *now = surface_in(editor, SHEET);
                assert_true(digest(editor) != first);
                assert_true((image_error(now, now, true) < 1e-9) == on);
                if (on) assert_true(most_apart(sheet, now, 6 - at) > 10);
                if (!on) bat_surface_copy(now, &alone);
                if (on && most_apart(now, alone, at) > 0.4)
                    fail_msg("the line is %g elsewhere", most_apart(now, alone, at));
                assert_int_equal(round_trip(editor, first), 1);
                bat_editor_free(editor);
            }
            bat_surface_free(alone);
        }
    bat_surface_free(sheet);
}

/* The stroke crosses the rim on one side; the other side gets its image. */
static void a_line_across_the_plane(void **state) {
    (void)state;
    bat_surface *sheet = hills(-200, 200);
    for (int side = 0; side < 2; side++) {
        bat_editor *editor = with(sheet, NULL);
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_command(editor, "symmetry-origin"), BAT_OK);
        pen p = pen_for(editor);
        light(editor, BAT_V, side ? 2.5 : 5.5, 1.4);
        bulge(&p, side ? 0.5 : 3.5, side ? 2.5 : 5.5, 30, true);
        const bat_surface *now = surface_in(editor, SHEET);
        assert_true(image_error(now, now, true) < 1e-9);
        assert_true(most_apart(sheet, now, 1.5) > 25 && most_apart(sheet, now, 4.5) > 25);
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
    bat_surface_free(sheet);
}

/* What is locked at one edge is locked at its image. */
static void locks_hold_on_both_sides(void **state) {
    (void)state;
    bat_surface *sheet = hills(-200, 200);
    bat_editor *editor = with(sheet, NULL);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "symmetry-origin"), BAT_OK);
    bat_editor_set(editor, "lock-u-high", 1);
    pen p = pen_for(editor);
    light(editor, BAT_U, 1, 1.5);
    bulge(&p, 0.6, 2.4, 20, true);
    const bat_surface *now = surface_in(editor, SHEET);
    assert_true(most_apart(sheet, now, 1) > 5);
    assert_true(most_apart(sheet, now, 0) < 1e-9 && most_apart(sheet, now, 6) < 1e-9);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
    bat_surface_free(sheet);
}

/* Two surfaces: while the pen is down both are shown as they will be, and one step changes both. A twin that is locked,
 * or no image, stays. */
static void a_twin_is_redrawn(void **state) {
    (void)state;
    for (int way = 0; way < 4; way++) {
        bat_surface *one = hills(50, 250), *two = mirrored(one), *moved = NULL, *shown[2] = {NULL, NULL};
        const double rows[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, way == 2 ? 0.2 : 0};
        assert_int_equal(bat_surface_transform(two, rows, &moved), BAT_OK);
        bat_editor *editor = with(one, moved);
        if (way == 1) { /* locked */
            bat_document *document = NULL;
            bat_object *object = NULL;
            bat_document_copy(bat_editor_document(editor), &document);
            bat_object_with_state(bat_document_at(document, 1), false, true, &object);
            bat_document_replace(document, 1, object);
            bat_object_release(object);
            bat_editor_free(editor);
            editor = editor_of(document);
            bat_editor_command(editor, "tool-surface");
        }
        const uint64_t first = digest(editor);
        if (way != 3) assert_int_equal(bat_editor_command(editor, "symmetry-origin"), BAT_OK);
        for (int k = 0; k < 3; k++) bat_editor_command(editor, "orbit-up");
        bat_editor_set(editor, "look", 0);
        pen p = pen_for(editor);
        light(editor, BAT_U, 2, 1.5);
        bulge(&p, 0.6, 2.4, 30, false);
        const bat_line_made *made = &state_of(editor)->made;
        assert_true((made->image != NULL) == (way == 0));
        assert_non_null(bat_editor_space(editor));
        bat_surface_copy(made->surface, &shown[0]);
        if (way == 0) bat_surface_copy(made->image, &shown[1]);
        pen_event(&p, BAT_POINTER_UP, 0, 0);
        bat_editor_frame(editor);
        check(editor);
        const bat_surface *a = surface_in(editor, SHEET), *b = surface_in(editor, TWIN);
        assert_true(most_apart(one, a, 2) > 5);
        if (way == 0) {
            assert_true(image_error(a, b, false) < 1e-9);
            assert_true(bat_surface_is_equal(b, shown[1]));
        } else {
            assert_true(bat_surface_is_equal(b, moved));
        }
        assert_int_equal(round_trip(editor, first), 1);
        for (int k = 0; k < 2; k++) bat_surface_free(shown[k]);
        bat_surface_free(one), bat_surface_free(two), bat_surface_free(moved);
        bat_editor_free(editor);
    }
}

/* A line beside the plane could only part from its image: it is refused in words, and in the plane it stays there. */
static void beside_the_plane(void **state) {
    (void)state;
    bat_surface *sheet = hills(-200, 200);
    bat_editor *editor = with(sheet, NULL);
    const uint64_t first = digest(editor);
    assert_int_equal(bat_editor_command(editor, "symmetry-origin"), BAT_OK);
    pen p = pen_for(editor);
    light(editor, BAT_U, 2.9, 1.5);
    bulge(&p, 0.6, 2.4, 30, true); /* away from the plane, along x */
    assert_true(digest(editor) == first);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "4 times"));
    light(editor, BAT_U, 3, 1.5);
    bulge(&p, 0.6, 2.4, 30, true);
    assert_true(most_apart(sheet, surface_in(editor, SHEET), 3) < 3); /* at most along y and z */
    for (int k = 0; k < 4; k++) bat_editor_command(editor, "orbit-up");
    light(editor, BAT_U, 3, 1.5);
    bulge(&p, 0.6, 2.4, 30, true);
    const bat_surface *now = surface_in(editor, SHEET);
    double point[3];
    for (int k = 0; k <= 30; k++) {
        bat_surface_eval(now, 3, 0.1 * k, 0, point);
        assert_true(fabs(point[0]) < 1e-9);
    }
    assert_true(image_error(now, now, true) < 1e-9);
    assert_true(round_trip(editor, first) >= 1);
    bat_editor_free(editor);
    bat_surface_free(sheet);
}

/* Twenty redraws add no more knots than one does, by half. */
static void many_redraws_do_not_add_up(void **state) {
    (void)state;
    bat_surface *sheet = hills(-200, 200);
    for (int d = 0; d < 2; d++) {
        bat_editor *editor = with(sheet, NULL);
        const uint64_t first = digest(editor);
        assert_int_equal(bat_editor_command(editor, "symmetry-origin"), BAT_OK);
        pen p = pen_for(editor);
        const bat_direction other = d ? BAT_U : BAT_V;
        size_t after_first = 0;
        for (int i = 0; i < 20; i++) {
            light(editor, d ? BAT_V : BAT_U, d ? 5.5 : 1.6, 1.5);
            bulge(&p, d ? 3.7 : 0.6, d ? 5.5 : 2.4, 30 * cos(1.7 * i), true);
            const size_t points = bat_surface_count(surface_in(editor, SHEET), other);
            if (i == 0) after_first = points;
            if (2 * points > 3 * after_first)
                fail_msg("%d points after %d, %d at first", (int)points, i + 1, (int)after_first);
        }
        assert_int_equal(round_trip(editor, first), 20);
        bat_editor_free(editor);
    }
    bat_surface_free(sheet);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_lines_of_a_surface),    cmocka_unit_test(a_line_across_the_plane),
        cmocka_unit_test(locks_hold_on_both_sides),   cmocka_unit_test(a_twin_is_redrawn),
        cmocka_unit_test(beside_the_plane),           cmocka_unit_test(the_handle_is_mirrored),
        cmocka_unit_test(many_redraws_do_not_add_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
