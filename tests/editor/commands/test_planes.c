/* Planes to draw on: along two axes through the selection, and through three picked points. One is active at a time, and an
 * equal one is not made again. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/view/room.h"
#include "support/editing.h"
#include "support/sheet.h"
#include <stdio.h>

static bat_editor *drawing(void) {
    bat_document *document = NULL;
    bat_surface *sheet = sheet_create();
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, pen_curve(100, 700, 60, 10, 8));
    assert_int_equal(sheet_add(document, 7, sheet), BAT_OK);
    bat_surface_free(sheet);
    return editor_of(document);
}

static void select_sheet(bat_editor *editor) {
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "select-all");
}

static void along_two_axes_through_the_selection(void **state) {
    (void)state;
    static const char *const commands[] = {"plane-level", "plane-front", "plane-side"};
    bat_editor *editor = drawing();
    const uint64_t first = digest(editor);
    select_sheet(editor);
    bat_editor_command(editor, "orbit-up");
    const int before = bat_document_count(bat_editor_document(editor));
    for (int i = 0; i < 3; i++) {
        assert_int_equal(bat_editor_command(editor, commands[i]), BAT_OK);
        bat_editor_frame(editor);
        check(editor);
        const bat_ground *ground = &editor->stage.ground;
        const int axis = 2 - i; /* the normal's: level z, front y, side x */
        const double *x = ground->numbers + 3, *y = ground->numbers + 6, *pivot = editor->stage.view.pivot;
        assert_true(x[axis] == 0 && y[axis] == 0);
        for (int k = 0; k < 3; k++) assert_true(ground->numbers[k] == pivot[k]);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), before + i + 1);
    }
    for (int i = 0; i < 3; i++) { /* they are there now */
        const bat_id was = editor->stage.ground.object;
        assert_int_equal(bat_editor_command(editor, commands[i]), BAT_OK);
        assert_true(editor->stage.ground.object != was);
        assert_int_equal(bat_document_count(bat_editor_document(editor)), before + 3);
    }
    assert_int_equal(round_trip(editor, first), 3);
    bat_editor_free(editor);
}

/* The page stands up and lies down by a step, which the file and the journal have; the view then has its top up, and the named
 * views and planes are those of the room. */
static void the_page_is_a_wall_or_a_floor(void **state) {
    (void)state;
    static const char *const views[] = {"view-front", "view-side", "view-top"};
    static const double looks[2][3][3] = {{{0, -1, 0}, {-1, 0, 0}, {0, 0, 1}},
                                          {{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}}};
    bat_editor *editor = drawing();
    const uint64_t first = digest(editor);
    double right[3], down[3], ahead[3];
    for (int wall = 0; wall < 2; wall++) {
        if (wall) assert_int_equal(bat_editor_command(editor, "page-stand"), BAT_OK);
        bat_editor_glide(editor, 1);
        for (int i = 0; i < 3; i++) {
            assert_int_equal(bat_editor_command(editor, views[i]), BAT_OK);
            bat_editor_glide(editor, 1);
            bat_view_axes(&editor->stage.view, right, down, ahead);
            for (int k = 0; k < 3; k++) assert_true(fabs(ahead[k] - looks[wall][i][k]) < 1e-9);
            assert_true(i == 2 || fabs(down[wall ? 1 : 2] - 1) < 1e-9);
            assert_true(right[i == 1 ? (wall ? 2 : 1) : 0] * (i == 1 && !wall ? -1 : 1) > 0.99);
        }
        check(editor);
    }
    assert_true(bat_document_stand(bat_editor_document(editor)) == BAT_STAND_WALL);
    assert_int_equal(bat_editor_command(editor, "plane-front"), BAT_OK);
    const double *plane = editor->stage.ground.numbers;
    assert_true(plane[5] == 0 && plane[8] == 0); /* as the wall stands */
    assert_string_equal(bat_editor_number(editor, "room"), "0 0 0");
    assert_int_equal(bat_editor_command(editor, "view-quarter"), BAT_OK);
    bat_editor_glide(editor, 1);
    char view[400];
    snprintf(view, sizeof view, "%s", bat_editor_number(editor, "view"));
    const bat_attitude pose = bat_room_attitude(&editor->stage.view, true);
    assert_true(fabs(pose.turn - 30) < 0.02 && fabs(pose.tilt - 65) < 0.02 && pose.roll == 0);
    assert_int_equal(bat_editor_command(editor, "view-upright"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "view", view), BAT_OK);
    bat_editor_glide(editor, 1);
    assert_string_equal(bat_editor_number(editor, "view"), view);
    assert_int_equal(bat_editor_enter(editor, "view", "{\"view\":[1,2]}"), BAT_SYNTAX);
    assert_int_equal(bat_editor_enter(editor, "view", ""), BAT_OK);
    char *bytes = NULL;
    size_t size = 0;
    bat_document *read = NULL;
    assert_int_equal(bat_document_write(bat_editor_document(editor), &bytes, &size), BAT_OK);
    assert_int_equal(bat_document_read(bytes, size, &read, NULL), BAT_OK);
    assert_true(bat_document_digest(read) == digest(editor));
    bat_document_free(read);
    free(bytes);
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

/* The page itself is not made again. */
static void level_with_the_page_is_the_page(void **state) {
    (void)state;
    bat_curve *curve = pen_curve(100, 700, 60, 10, 8);
    bat_editor *editor = editor_with(1, &curve);
    const uint64_t first = digest(editor);
    bat_editor_command(editor, "orbit-up");
    assert_int_equal(bat_editor_command(editor, "plane-level"), BAT_OK);
    assert_int_equal(bat_stage_dimension(&editor->stage), 2);
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* Where a point is seen. */
static void pixel_of(bat_editor *editor, const double at[3], double pixel[2]) {
    double seen[2];
    bat_stage_look(&editor->stage, 3, at, seen);
    bat_stage_project(&editor->stage, seen, pixel);
}

static void through_three_points(void **state) {
    (void)state;
    for (int deep = 0; deep < 2; deep++) {
        bat_editor *editor = drawing();
        const uint64_t first = digest(editor);
        const bat_surface *sheet = bat_object_surface(bat_document_at(bat_editor_document(editor), 1));
        double points[3][3] = {{150, 150, 0}}, pixel[2];
        bat_editor_set(editor, "perspective", deep);
        for (int i = 0; i < 2; i++) bat_editor_command(editor, "orbit-up");
        bat_surface_eval(sheet, 0, 1, 0, points[1]); /* on an edge, which is a curve */
        bat_surface_eval(sheet, 2.5, 1.5, 0, points[2]);
        assert_int_equal(bat_editor_command(editor, "plane-of-points"), BAT_OK);
        assert_non_null(strstr(bat_editor_frame(editor)->hint, "three points"));
        pen p = pen_for(editor);
        for (int i = 0; i < 3; i++) {
            pixel_of(editor, points[i], pixel);
            assert_int_equal(bat_stage_dimension(&editor->stage), 2);
            tap(&p, pixel[0], pixel[1]);
            assert_true((pen_live(bat_editor_frame(editor), BAT_ROLE_PIVOT) != NULL) == (i < 2));
        }
        const bat_ground *ground = &editor->stage.ground;
        const double *o = ground->numbers, *x = o + 3, *y = o + 6;
        const double n[3] = {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
        assert_int_equal(bat_stage_dimension(&editor->stage), 3);
        for (int i = 0; i < 3; i++) {
            double off = 0;
            for (int k = 0; k < 3; k++) off += n[k] * (points[i][k] - o[k]);
            assert_true(fabs(off) < 6); /* a tap on a curve picks a place on it, within its reach of 24 px */
        }
        assert_int_equal(round_trip(editor, first), 1);
        bat_editor_free(editor);
    }
}

static void what_cannot_be_picked_is_said(void **state) {
    (void)state;
    bat_curve *curve = pen_curve(100, 700, 60, 10, 8);
    bat_editor *editor = editor_with(1, &curve);
    const uint64_t first = digest(editor);
    bat_editor_command(editor, "orbit-up");
    bat_editor_command(editor, "plane-of-points");
    pen p = pen_for(editor);
    double pixel[2];
    for (int i = 0; i < 3; i++) { /* on a line */
        pixel_of(editor, (double[]){200 + 100 * i, 200, 0}, pixel);
        tap(&p, round(pixel[0]), pixel[1]);
    }
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "on one line"));
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_null(strstr(bat_editor_frame(editor)->hint, "three points"));
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_PIVOT));
    bat_editor_command(editor, "view-front");
    bat_editor_command(editor, "draw-on-page"); /* nothing can be hit on it */
    bat_editor_command(editor, "plane-of-points");
    tap(&p, 900, 100);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "nothing to pick"));
    assert_true(digest(editor) == first);
    check(editor);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(along_two_axes_through_the_selection),
        cmocka_unit_test(the_page_is_a_wall_or_a_floor),
        cmocka_unit_test(level_with_the_page_is_the_page),
        cmocka_unit_test(through_three_points),
        cmocka_unit_test(what_cannot_be_picked_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
