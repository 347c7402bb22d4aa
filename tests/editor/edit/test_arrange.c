/* Transforms as properties, groups, stacking order, aligning and distributing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/matrix.h"
#include "curve/curve.h"
#include "document/clip.h"
#include "editor/edit/affine.h"
#include "editor/edit/arrange.h"
#include "editor/editor.h"
#include "support/selecting.h"
#include <batten/measure.h>
#include <batten/refine.h>

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

/* ---- clips ---- */

static bat_curve *line_through(size_t count, const double *points) {
    bat_curve *made = NULL;
    assert_int_equal(bat_curve_create_clamped(2, 1, count, points, &made), BAT_OK);
    return made;
}

/* The group 3, seen in a square from 100 to 700, of the lines 1 and 2. */
static bat_editor *clipped_editor(void) {
    static const double square[] = {100, 100, 700, 100, 700, 700, 100, 700, 100, 100};
    static const double lines[2][4] = {{200, 200, 800, 200}, {200, 600, 800, 600}};
    bat_document *document = NULL;
    bat_curve *around = line_through(5, square);
    bat_clip *clip = NULL;
    bat_object *plain = NULL, *group = NULL;
    const bat_style style = bat_style_defaults();
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(bat_clip_create(1, &around, false, NULL, &clip), BAT_OK);
    assert_int_equal(bat_object_create_group(3, NULL, false, &plain), BAT_OK);
    assert_int_equal(bat_object_with_clip(plain, clip, &group), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, group), BAT_OK);
    for (int i = 0; i < 2; i++) {
        bat_curve *line = line_through(2, lines[i]);
        bat_object *path = NULL, *placed = NULL;
        assert_int_equal(bat_object_create_path((bat_id)i + 1, NULL, &style, 1, &line, &path), BAT_OK);
        assert_int_equal(bat_object_with_parent(path, 3, &placed), BAT_OK);
        assert_int_equal(bat_document_insert(document, i + 1, placed), BAT_OK);
        bat_object_release(path);
        bat_object_release(placed);
    }
    bat_object_release(plain);
    bat_object_release(group);
    bat_clip_release(clip);
    bat_curve_free(around);
    bat_editor *editor = editor_of(document);
    bat_editor_command(editor, "tool-select");
    return editor;
}

/* Where the only region of what is seen of the object begins. */
static void expect_clip(const bat_editor *editor, bat_id id, double x, double y) {
    double low[2], high[2];
    const bat_clip *clip = bat_object_clip(object(editor, id));
    assert_int_equal(bat_clip_count(clip), 1);
    bat_curve_bounds(bat_clip_curve(clip, 0), low, high);
    if (fabs(low[0] - x) > 1e-9 || fabs(low[1] - y) > 1e-9)
        fail_msg("%g %g, not %g %g", low[0], low[1], x, y);
}

/* What is seen of a group moves with it, by key, by drag and as a copy, and becomes what is seen of its members when it is
 * taken apart; a member that is moved by itself moves within it. */
static void clips_go_along(void **state) {
    (void)state;
    bat_editor *editor = clipped_editor();
    uint64_t first = digest(editor);
    pen p = mouse(editor);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_int_equal(frame->still_count, 4); /* the page, the clip, the two lines */
    assert_true(frame->still[1].role == BAT_ROLE_CLIP && frame->still[1].picture == 2);
    only(editor, 3, 0);
    bat_editor_key(editor, "ArrowRight", true, BAT_SHIFT, 0);
    expect_clip(editor, 3, 110, 100);
    drag(&p, 400, 200, 420, 230);
    expect_clip(editor, 3, 130, 130);
    expect_box(editor, 1, 230, 230, 830, 230);
    bat_editor_command(editor, "duplicate");
    expect_clip(editor, 4, 140, 140);
    expect_clip(editor, 3, 130, 130);
    bat_editor_command(editor, "undo");
    only(editor, 2, 0);
    bat_editor_key(editor, "ArrowRight", true, BAT_SHIFT, 0);
    expect_clip(editor, 3, 130, 130);
    assert_null(bat_object_clip(object(editor, 2)));
    only(editor, 3, 0);
    bat_editor_command(editor, "ungroup");
    expect_clip(editor, 1, 130, 130);
    expect_clip(editor, 2, 130, 130);
    only(editor, 2, 0);
    bat_editor_key(editor, "ArrowRight", true, BAT_SHIFT, 0);
    expect_clip(editor, 1, 130, 130);
    expect_clip(editor, 2, 140, 130);
    frame = bat_editor_frame(editor);
    assert_int_equal(frame->still_count, 5);
    assert_true(frame->still[1].role == BAT_ROLE_CLIP && frame->still[3].role == BAT_ROLE_CLIP);
    assert_true(frame->still[1].picture == 1 && frame->still[3].picture == 1);
    goes_back_and_replays(editor, first);
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(transforms_are_of_the_curves),
        cmocka_unit_test(splines_stay_splines),
        cmocka_unit_test(groups_and_order),
        cmocka_unit_test(clips_go_along),
        cmocka_unit_test(aligns_and_distributes),
    };
    return cmocka_run_group_tests_name("arrange", tests, NULL, NULL);
}
