/* The gizmo: what is selected in a tilted view follows the pen along an axis, in a plane, about an axis, and nowhere else. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/pose.h"
#include "base/real.h"
#include "editor/editor.h"
#include "editor/edit/arrange.h"
#include "editor/tools/select.h"
#include "support/selecting.h"
#include "support/space_wave.h"
#include <stdlib.h>
#include <string.h>

enum { VIEWS = 5 };
static const double NEAR = 0.02; /* the pen comes in hundredths of a pixel */

/* A wave that is selected: above the page, tilted to both sides, in perspective, and from below. */
static bat_editor *seen_from(int view) {
    static const int turns[VIEWS][3] = {{2, 0, 0}, {3, 2, 0}, {2, -5, 1}, {5, 3, 1}, {8, 1, 0}};
    bat_editor *editor = tilted_with(wave(40, 60, 1.3), turns[view][0], turns[view][1]);
    bat_editor_set(editor, "perspective", turns[view][2]);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    bat_editor_command(editor, "select-all");
    bat_editor_frame(editor);
    return editor;
}

static bat_gizmo gizmo_of(bat_editor *editor) {
    double low[3], high[3], middle[3];
    bat_gizmo gizmo;
    assert_true(bat_arrange_selection_space(&editor->context, low, high));
    for (int k = 0; k < 3; k++) middle[k] = (low[k] + high[k]) / 2;
    assert_true(bat_gizmo_place(&editor->stage, middle, &gizmo));
    return gizmo;
}

static void pixel_of(const bat_editor *editor, const double at[3], double pixel[2]) {
    double seen[2];
    assert_true(bat_stage_look(&editor->stage, 3, at, seen));
    bat_stage_project(&editor->stage, seen, pixel);
}

/* What the part is to do, and where its handle is then: within the window. */
static void wanted(const bat_gizmo *g, int part, double by[3], double rows[12]) {
    const int axis = part % 3;
    for (int k = 0; k < 3; k++) by[k] = 0;
    if (part >= BAT_GIZMO_ABOUT)
        by[axis] = 0.4;
    else
        for (int k = 0; k < 3; k++)
            if ((part < BAT_GIZMO_ACROSS) == (k == axis)) by[k] = 11 + 7 * k;
    bat_gizmo_rows(g, part, by, rows);
}

static void every_part_leads_where_it_says(void **state) {
    (void)state;
    for (int view = 0; view < VIEWS; view++) {
        bat_editor *editor = seen_from(view);
        const uint64_t first = digest(editor);
        pen p = pen_for(editor);
        int parts = 0;
        for (int part = 0; part < BAT_GIZMO_PARTS; part++) {
            const bat_gizmo g = gizmo_of(editor);
            double by[3], rows[12], at[3], from[2], to[2], before[3], after[3];
            if (!g.there[part]) continue;
            wanted(&g, part, by, rows);
            bat_gizmo_handle(&g, part, at);
            pixel_of(editor, at, from);
            bat_pose_apply(rows, 1, at, at);
            pixel_of(editor, at, to);
            bat_curve_eval(bat_object_curve(bat_document_at(editor->session.document, 0), 0), 2.7, 0, before);
            bat_pose_apply(rows, 1, before, before);
            drag(&p, from[0], from[1], to[0], to[1]);
            bat_curve_eval(bat_object_curve(bat_document_at(editor->session.document, 0), 0), 2.7, 0, after);
            for (int k = 0; k < 3; k++)
                if (!(fabs(after[k] - before[k]) < NEAR))
                    fail_msg("view %d, part %d: %c %g, not %g", view, part, "xyz"[k], after[k], before[k]);
            parts++;
        }
        assert_true(parts >= 5);
        assert_int_equal(round_trip(editor, first), parts);
        bat_editor_free(editor);
    }
}

static const char *label_with(const bat_frame *frame, const char *words) {
    for (uint32_t i = 0; i < frame->label_count; i++)
        if (strstr(frame->labels[i].text, words)) return frame->labels[i].text;
    return NULL;
}

/* The line and the numbers stand there while the pen is down; Escape takes the drag back, and a tap does nothing. */
static void a_drag_is_shown_and_cancelled(void **state) {
    (void)state;
    bat_editor *editor = seen_from(1);
    const uint64_t first = digest(editor);
    const bat_gizmo g = gizmo_of(editor);
    double at[3], from[2], to[2];
    pen p = pen_for(editor);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_non_null(pen_live(frame, BAT_ROLE_AXIS_X));
    assert_non_null(pen_live(frame, BAT_ROLE_AXIS_Z));
    bat_gizmo_handle(&g, BAT_GIZMO_ALONG + 2, at);
    pixel_of(editor, at, from);
    at[2] += 25;
    pixel_of(editor, at, to);
    drag_to(&p, from[0], from[1], to[0], to[1]);
    frame = bat_editor_frame(editor);
    assert_null(pen_live(frame, BAT_ROLE_AXIS_X));
    assert_non_null(pen_live(frame, BAT_ROLE_AXIS_Z));
    const char *said = label_with(frame, "along z: ");
    assert_true(said && fabs(strtod(said + 9, NULL) - 25) < NEAR && strstr(said, " px"));
    assert_true(digest(editor) != first);
    bat_editor_key(editor, "Escape", true, 0, p.time);
    assert_true(digest(editor) == first);
    pen_event(&p, BAT_POINTER_UP, to[0], to[1]);
    click(&p, from[0], from[1], 0);
    assert_true(digest(editor) == first && selected(editor) == 1);
    /* Shift turns by steps. */
    double rows[12];
    bat_gizmo_handle(&g, BAT_GIZMO_ABOUT + 2, at);
    pixel_of(editor, at, from);
    bat_pose_rotation(BAT_PI / 6 + 0.04, (double[]){0, 0, 1}, g.middle, rows);
    bat_pose_apply(rows, 1, at, at);
    pixel_of(editor, at, to);
    p.modifiers = BAT_SHIFT;
    drag_to(&p, from[0], from[1], to[0], to[1]);
    assert_non_null(label_with(bat_editor_frame(editor), "about z: 30°"));
    bat_editor_key(editor, "Escape", true, 0, p.time);
    pen_event(&p, BAT_POINTER_UP, to[0], to[1]);
    p.modifiers = 0;
    /* A finger reaches further. */
    double handle[2];
    bat_gizmo_handle(&g, BAT_GIZMO_ALONG + 2, at);
    pixel_of(editor, at, handle);
    assert_int_equal(bat_gizmo_find(&g, &editor->stage, (double[]){handle[0] - 18, handle[1]}, 8),
                     BAT_GIZMO_NONE);
    assert_int_equal(bat_gizmo_find(&g, &editor->stage, (double[]){handle[0] - 18, handle[1]}, 22), 2);
    /* Face-on there is nothing of it. */
    bat_editor_command(editor, "view-upright");
    frame = bat_editor_frame(editor);
    for (int role = BAT_ROLE_AXIS_X; role <= BAT_ROLE_AXIS_Z; role++)
        assert_null(pen_live(frame, (bat_role)role));
    bat_editor_free(editor);
}

/* A line of the page lies in space once it is lifted; one that is moved along x and y stays on it. */
static void what_stays_on_the_page(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    bat_editor_select(editor, 1, false);
    for (int i = 0; i < 3; i++) bat_editor_command(editor, "orbit-up");
    for (int axis = 0; axis < 3; axis += 2) {
        bat_editor_frame(editor);
        const bat_gizmo g = gizmo_of(editor);
        double at[3], from[2], to[2];
        bat_gizmo_handle(&g, BAT_GIZMO_ALONG + axis, at);
        pixel_of(editor, at, from);
        at[axis] += 20;
        pixel_of(editor, at, to);
        drag(&p, from[0], from[1], to[0], to[1]);
        assert_int_equal(bat_curve_dimension(curve(editor, 1)), axis ? 3 : 2);
    }
    expect_box(editor, 1, 220, 200, 820, 200);
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

/* Along z a line comes to the height of another's end where the two are seen to meet. */
static void a_drag_snaps_in_space(void **state) {
    (void)state;
    const double ends[6] = {400, 300, -60, 700, 300, -60};
    bat_curve *curves[2] = {pen_curve(200, 300, 50, 0, 5), NULL};
    assert_int_equal(bat_curve_create(3, 1, false, 2, ends, 4, (double[]){0, 0, 1, 1}, &curves[1]), BAT_OK);
    bat_editor *editor = editor_with(2, curves);
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    double at[3], from[2], to[2], end[BAT_DIMENSION_MAX];
    bat_editor_command(editor, "tool-select");
    bat_editor_select(editor, 1, false);
    for (int i = 0; i < 4; i++) bat_editor_command(editor, "orbit-up");
    bat_editor_frame(editor);
    const bat_curve *line = bat_object_curve(bat_document_at(editor->session.document, 0), 0);
    double domain[2];
    bat_curve_domain(line, domain);
    bat_curve_eval(line, domain[1], 0, end);
    assert_true(fabs(end[0] - 400) < 1e-9 && fabs(end[1] - 300) < 1e-9);
    const bat_gizmo g = gizmo_of(editor);
    bat_gizmo_handle(&g, BAT_GIZMO_ALONG + 2, at);
    pixel_of(editor, at, from);
    at[2] -= 57;
    pixel_of(editor, at, to);
    drag(&p, from[0], from[1], to[0], to[1]);
    bat_curve_eval(bat_object_curve(bat_document_at(editor->session.document, 0), 0), domain[1], 0, end);
    for (int k = 0; k < 3; k++) assert_true(fabs(end[k] - ends[k]) < 1e-9);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_part_leads_where_it_says),
        cmocka_unit_test(a_drag_is_shown_and_cancelled),
        cmocka_unit_test(what_stays_on_the_page),
        cmocka_unit_test(a_drag_snaps_in_space),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
