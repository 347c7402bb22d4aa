/* Snapping: ends, crossings and other points known in closed form; a dragged object snaps as a whole. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "base/vec.h"
#include "editor/editor.h"
#include "editor/pick/isometric.h"
#include "editor/tools/modes/guides.h"
#include "support/precision.h"

/* Ends, crossings of two lines, of a line and a parabola, of a curve with itself: all known. */
static void snaps_to_known_places(void **state) {
    (void)state;
    /* y = 300 - (x - 500)^2 / 100 for x in 400..600: the control points of a parabola in Bézier form. */
    bat_curve *parabola = NULL, *loop = NULL;
    bat_curve_create(2, 2, false, 3, (double[]){400, 200, 500, 400, 600, 200}, 6,
                     (double[]){0, 0, 0, 1, 1, 1}, &parabola);
    /* Symmetric about x = 800, so it meets itself there: x(t) - 800 = 600 (t - 1/2) (1 - 6 t (1 - t)) ... solved
     * below by halving. */
    bat_curve_create(2, 3, false, 4, (double[]){700, 600, 1000, 300, 600, 300, 900, 600}, 8,
                     (double[]){0, 0, 0, 0, 1, 1, 1, 1}, &loop);
    bat_curve *curves[] = {segment(100, 100, 300, 300), segment(100, 300, 300, 100), parabola,
                           segment(350, 250, 650, 250), loop};
    bat_editor *editor = editor_with(5, curves);
    bat_snap found = snap(editor, 103, 96);
    at_once(&found, BAT_SNAP_END, 100, 100);
    found = snap(editor, 203, 204);
    at_once(&found, BAT_SNAP_CROSSING, 200, 200);
    /* y = 400 t (1 - t) + 200 = 250: t = (1 - sqrt(1/2)) / 2, x = 400 + 200 t */
    found = snap(editor, 432, 253);
    at_once(&found, BAT_SNAP_CROSSING, 500 - 100 * sqrt(0.5), 250);
    found = snap(editor, 567, 248);
    at_once(&found, BAT_SNAP_CROSSING, 500 + 100 * sqrt(0.5), 250);
    double low = 0, high = 0.4; /* the parameter of the crossing with itself */
    const bat_curve *own = bat_object_curve(bat_document_at(editor->session.document, 4), 0);
    for (int i = 0; i < 60; i++) {
        double t = (low + high) / 2, at[2];
        bat_curve_eval(own, t, 0, at);
        if (at[0] < 800)
            low = t;
        else
            high = t;
    }
    double at[2];
    bat_curve_eval(own, low, 0, at);
    found = snap(editor, at[0] + 3, at[1] - 2);
    at_once(&found, BAT_SNAP_CROSSING, 800, at[1]);
    /* An end within reach comes before a crossing that is nearer. */
    found = snap(editor, 296, 298);
    at_once(&found, BAT_SNAP_END, 300, 300);
    /* Out of reach, switched off, held off. */
    assert_int_equal(snap(editor, 320, 300).kind, BAT_SNAP_NONE);
    bat_editor_set(editor, "snap-ends", 0);
    assert_int_equal(snap(editor, 103, 96).kind, BAT_SNAP_NONE);
    bat_editor_set(editor, "snap-curves", 1);
    found = snap(editor, 153, 147);
    at_once(&found, BAT_SNAP_CURVE, 150, 150);
    editor->context.modifiers = BAT_CTRL;
    assert_int_equal(snap(editor, 153, 147).kind, BAT_SNAP_NONE);
    editor->context.modifiers = 0;
    bat_editor_command(editor, "snap");
    assert_int_equal(snap(editor, 203, 204).kind, BAT_SNAP_NONE);
    bat_editor_command(editor, "snap");
    bat_editor_set(editor, "snap-curves", 0);
    /* The reach is in pixels. */
    bat_editor_command(editor, "zoom-in");
    bat_editor_command(editor, "zoom-in");
    assert_int_equal(snap(editor, 205, 204.5).kind, BAT_SNAP_NONE);
    found = snap(editor, 202, 201);
    at_once(&found, BAT_SNAP_CROSSING, 200, 200);
    bat_editor_free(editor);
}

/* The isometric grid: triangles of equal sides. Corners come before lines, and lie on a line of every family. */
static void snaps_to_triangles(void **state) {
    (void)state;
    bat_curve *curves[] = {segment(1000, 900, 1100, 900)};
    bat_editor *editor = editor_with(1, curves);
    bat_editor_set(editor, "show-grid", 1);
    bat_editor_set(editor, "grid-spacing", 60);
    bat_editor_set(editor, "grid-kind", 1);
    double zero[2], corner[2], foot[2];
    bat_unit_origin(&editor->context, zero);
    const double gap = 30 * sqrt(3); /* the height of a triangle */
    bat_snap found = snap(editor, zero[0] + 3 * gap + 3, zero[1] + 270 - 4);
    at_once(&found, BAT_SNAP_GRID, zero[0] + 3 * gap, zero[1] + 270); /* odd columns are half a step lower */
    found = snap(editor, zero[0] + 2 * gap - 5, zero[1] + 235);
    at_once(&found, BAT_SNAP_GRID, zero[0] + 2 * gap, zero[1] + 240);
    /* Halfway along a side there is only the line: y falls by 30 over a gap. */
    found = snap(editor, zero[0] + 2.5 * gap + 1, zero[1] + 255 + 3);
    assert_int_equal(found.kind, BAT_SNAP_GRID);
    assert_true(fabs((found.point[1] - zero[1] - 240) - (found.point[0] - zero[0] - 2 * gap) / sqrt(3)) <
                1e-9);
    assert_int_equal(snap(editor, zero[0] + 2 * gap + gap / 3, zero[1] + 210).kind,
                     BAT_SNAP_NONE); /* its middle */
    /* The corner is the nearest of all, and the foot of a corner is the corner itself. */
    for (int i = 0; i < 400; i++) {
        const double point[2] = {zero[0] + fmod(i * 97.31, 500), zero[1] + fmod(i * 61.7, 400)};
        double least = INFINITY;
        for (int column = -1; column < 12; column++)
            for (int row = -8; row < 9; row++)
                least = fmin(least, hypot(zero[0] + column * gap - point[0],
                                          zero[1] + 60 * (row + column / 2.0) - point[1]));
        bat_isometric_corner(zero, 60, point, corner);
        assert_true(hypot(corner[0] - point[0], corner[1] - point[1]) < least + 1e-9);
        for (int family = 0; family < BAT_ISOMETRIC_FAMILIES; family++) {
            bat_isometric_foot(zero, 60, family, corner, foot);
            assert_true(hypot(corner[0] - foot[0], corner[1] - foot[1]) < 1e-9);
        }
    }
    bat_editor_set(editor, "grid-kind", 0);
    assert_false(snap(editor, zero[0] + 3 * gap + 3, zero[1] + 266).point[1] == zero[1] + 270);
    bat_editor_free(editor);
}

/* A moved line's end lands on the end of another to the last bit; the picture says so while it is held. */
static void moves_snap(void **state) {
    (void)state;
    bat_curve *curves[] = {segment(100, 100, 200, 150), segment(400, 333.25, 600, 500)};
    bat_editor *editor = editor_with(2, curves);
    pen p = mouse(editor);
    bat_editor_command(editor, "tool-select");
    pen_event(&p, BAT_POINTER_DOWN, 150, 125);
    pen_event(&p, BAT_POINTER_MOVE, 300, 300);
    pen_event(&p, BAT_POINTER_MOVE, 352, 306); /* its right end comes to 402, 331 */
    const bat_frame *frame = bat_editor_frame(editor);
    assert_non_null(pen_live(frame, BAT_ROLE_GUIDE));
    assert_string_equal(frame->labels[0].text, "end");
    pen_event(&p, BAT_POINTER_UP, 352, 306);
    double box[4];
    bat_object_bounds(bat_document_at(editor->session.document, 0), box);
    assert_true(box[2] == 400 && box[3] == 333.25);
    assert_null(pen_live(bat_editor_frame(editor), BAT_ROLE_GUIDE));
    replays(editor, 0);
    bat_editor_command(editor, "undo");
    p.modifiers = BAT_CTRL;
    pen_event(&p, BAT_POINTER_DOWN, 150, 125);
    pen_event(&p, BAT_POINTER_MOVE, 352, 306);
    pen_event(&p, BAT_POINTER_UP, 352, 306);
    p.modifiers = 0;
    bat_object_bounds(bat_document_at(editor->session.document, 0), box);
    assert_true(fabs(box[2] - 402) < 1e-9);
    bat_editor_command(editor, "undo");
    /* Shift: 15 degrees. The pen goes 100, -30 (16.7 degrees); what moves goes along 15. */
    p.modifiers = BAT_SHIFT;
    pen_event(&p, BAT_POINTER_DOWN, 150, 125);
    pen_event(&p, BAT_POINTER_MOVE, 250, 95);
    frame = bat_editor_frame(editor);
    assert_string_equal(frame->labels[0].text, "15°");
    pen_event(&p, BAT_POINTER_UP, 250, 95);
    p.modifiers = 0;
    bat_object_bounds(bat_document_at(editor->session.document, 0), box);
    double c = cos(BAT_PI / 12), s = sin(BAT_PI / 12), along = 100 * c + 30 * s;
    assert_true(fabs(box[0] - 100 - along * c) < 1e-9 && fabs(box[1] - 100 + along * s) < 1e-9);
    /* A control point goes to the crossing of guides. */
    bat_guide_put(&editor->context, 0, 0, 700);
    bat_guide_put(&editor->context, 0, 1, 600);
    bat_editor_command(editor, "deselect");
    bat_editor_command(editor, "tool-points");
    pen_event(&p, BAT_POINTER_HOVER, 500, 416.6);
    pen_event(&p, BAT_POINTER_DOWN, 500, 416.6);
    pen_event(&p, BAT_POINTER_UP, 500, 416.6);
    drag(&p, 600, 500, 703, 605);
    const bat_object *moved = bat_document_at(editor->session.document,
                                              bat_document_find(editor->session.document, 2));
    const double *points = bat_curve_points(bat_object_curve(moved, 0));
    assert_true(fabs(points[2] - 700) < 1e-12 && fabs(points[3] - 600) < 1e-12);
    replays(editor, 0);
    bat_editor_free(editor);
}

static bat_curve *space_segment(double x0, double y0, double x1, double y1, double z) {
    const double ends[6] = {x0, y0, z, x1, y1, z};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(3, 1, false, 2, ends, 4, (double[]){0, 0, 1, 1}, &curve), BAT_OK);
    return curve;
}

/* Snaps the place of the page that is seen so many pixels beside another. */
static bat_snap beside(bat_editor *editor, double x, double y, double right, double down) {
    double seen[2], pixel[2], at[2];
    assert_true(bat_stage_look(&editor->stage, 2, (double[]){x, y}, seen));
    bat_stage_project(&editor->stage, seen, pixel);
    assert_true(bat_stage_on_page(&editor->stage, (double[]){pixel[0] + right, pixel[1] + down}, at));
    return snap(editor, at[0], at[1]);
}

/* On a page that is tilted, eight pixels are those that are seen. */
static void a_tilted_page_snaps(void **state) {
    (void)state;
    for (int view = 0; view < 4; view++) {
        bat_curve *curves[] = {segment(300, 300, 500, 500), segment(300, 500, 500, 300)};
        bat_editor *editor = editor_with(2, curves);
        bat_editor_set(editor, "perspective", view & 1);
        for (int i = 0; i < 3 + (view & 2); i++)
            bat_editor_command(editor, i & 1 ? "orbit-left" : "orbit-up");
        bat_snap found = beside(editor, 300, 300, 4, -5);
        at_once(&found, BAT_SNAP_END, 300, 300);
        found = beside(editor, 400, 400, -3, 5);
        at_once(&found, BAT_SNAP_CROSSING, 400, 400);
        assert_int_equal(beside(editor, 300, 300, -6, -6).kind, BAT_SNAP_NONE);
        bat_editor_set(editor, "snap-curves", 1);
        found = beside(editor, 350, 350, 3, 0);
        assert_int_equal(found.kind, BAT_SNAP_CURVE);
        assert_true(fabs(found.point[0] - found.point[1]) < 1e-9);
        bat_editor_set(editor, "show-grid", 1);
        bat_editor_set(editor, "snap-grid", 1);
        bat_editor_set(editor, "grid-spacing", 100);
        found = beside(editor, 200, 600, 3, 3);
        at_once(&found, BAT_SNAP_GRID, 200, 600);
        bat_editor_free(editor);
    }
}

/* In space a point snaps to ends and crossings there, as far as it is free, and only to what is seen where it is then. */
static void a_point_in_space_snaps(void **state) {
    (void)state;
    bat_curve *curves[] = {space_segment(300, 400, 500, 400, -50), space_segment(400, 300, 400, 500, -50),
                           space_segment(350, 420, 450, 380, -52)};
    bat_editor *editor = editor_with(3, curves);
    const int but[] = {2}; /* it passes the crossing, but does not meet it */
    const double still[3] = {0, 0, 0};
    double seen[2], pixel[2], other[2];
    for (int i = 0; i < 3; i++) bat_editor_command(editor, "orbit-up");
    bat_editor_frame(editor);
    for (int what = 0; what < 4; what++) {
        /* near an end, near the crossing; then free along z alone: above the crossing, and behind it as it is seen */
        static const double near[4][3] = {{302, 401, -48}, {401, 398, -51}, {400, 400, -46}, {0}};
        bat_snap_source source = {{near[what][0], near[what][1], near[what][2]}, BAT_SNAP_ALL};
        const bool free[3] = {what < 2, what < 2, true};
        if (what == 3) { /* where the page is seen there */
            bat_stage_look(&editor->stage, 3, (double[]){400, 400, -50}, seen);
            bat_stage_project(&editor->stage, seen, pixel);
            assert_true(bat_stage_on_page(&editor->stage, pixel, other));
            source.point[0] = other[0], source.point[1] = other[1];
        }
        const bat_snap found = bat_snap_find_space(&editor->context, 1, but, 1, &source, still, free, NULL);
        if (what == 3) {
            assert_int_equal(found.kind, BAT_SNAP_NONE);
            continue;
        }
        at_once(&found, what ? BAT_SNAP_CROSSING : BAT_SNAP_END, what ? 400 : 300, 400);
        assert_true(fabs(found.point[2] + 50) < 1e-9 && found.bound[2] && found.bound[0] == free[0]);
    }
    bat_editor_free(editor);
}

/* A point of a plane in space snaps to the plane's own grid, of squares or triangles, as far as pixels are seen; the page's
 * grid is not shown then and nothing snaps to it. What is moved along an axis keeps steps from the plane's origin. */
static void a_plane_has_its_own_grid(void **state) {
    (void)state;
    static const double origin[3] = {310, 420, 30}, ways[3][6] = {{1, 0, 0, 0, 0, 1},
                                                                  {0, 1, 0, 0, 0, 1},
                                                                  {0.8, 0.6, 0, -0.48, 0.64, 0.6}};
    for (int what = 0; what < 12; what++) {
        bat_curve *curves[] = {segment(1000, 900, 1100, 900)};
        bat_editor *editor = editor_with(1, curves);
        const bool triangles = what / 3 % 2, deep = what / 6;
        const double *way = ways[what % 3], root = sqrt(3) / 2;
        double at[3], pixel[2], seen[2], off;
        bat_editor_set(editor, "perspective", deep);
        for (int i = 0; i < 5; i++) bat_editor_command(editor, i & 1 ? "orbit-left" : "orbit-up");
        editor->stage.ground = bat_ground_plane(origin, way, way + 3);
        bat_editor_set(editor, "show-grid", 1);
        bat_editor_set(editor, "snap-grid", 1);
        bat_editor_set(editor, "grid-kind", triangles);
        bat_editor_set(editor, "grid-spacing", 100);
        const double step = bat_grid_shown(&editor->context).step;
        assert_true(step >= 100);
        /* a corner, the middle of a line from it to the next, and the middle of a cell */
        for (int place = 0; place < 3; place++) {
            const double own[3][2] = {{2 * step * (triangles ? root : 1), 3 * step},
                                      {2 * step * (triangles ? root : 1), 3.5 * step},
                                      {2 * step + 0.5 * step, 3.5 * step}};
            const double cell[2] = {(2 + 1.0 / 3) * root * step, 3.5 * step}, *there = own[place];
            const bat_hit *none = NULL;
            bat_hit hit;
            if (triangles && place == 2) there = cell;
            bat_ground_at(&editor->stage.ground, there, at);
            assert_true(bat_stage_look(&editor->stage, 3, at, seen));
            bat_stage_project(&editor->stage, seen, pixel);
            const double beside[2] = {pixel[0] + 2, pixel[1] + (place == 1 ? 1 : 2)};
            assert_int_equal(bat_stage_place(&editor->stage, beside, none, &hit), BAT_OK);
            double point[3] = {hit.at[0], hit.at[1], hit.at[2]};
            bat_snap_point_space(&editor->context, 0, NULL, point);
            assert_int_equal(editor->context.snap->kind, place == 2 ? BAT_SNAP_NONE : BAT_SNAP_GRID);
            off = 0;
            if (place == 0) off = vec_norm(vec_sub(vec_load(point, 3), vec_load(at, 3)));
            if (place == 1) /* anywhere on the line */
                off = vec_dot(vec_sub(vec_load(point, 3), vec_load(at, 3)), vec_load(way, 3));
            assert_true(fabs(off) < 1e-9 * step);
        }
        /* the page's grid is hidden; the lattice of an axis begins at the plane */
        assert_int_equal(snap(editor, 300, 300).kind, BAT_SNAP_NONE);
        const bat_snap_source source = {{7, 8, 30 + step + 0.01 * step}, BAT_SNAP_ALL};
        const bat_snap found = bat_snap_find_space(&editor->context, 0, NULL, 1, &source, (double[]){0, 0, 0},
                                                   (bool[]){false, false, true}, NULL);
        assert_true(found.kind == (triangles ? BAT_SNAP_NONE : BAT_SNAP_GRID));
        assert_true(triangles || fabs(found.point[2] - 30 - step) < 1e-9 * step);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_tilted_page_snaps),      cmocka_unit_test(a_point_in_space_snaps),
        cmocka_unit_test(a_plane_has_its_own_grid), cmocka_unit_test(snaps_to_known_places),
        cmocka_unit_test(snaps_to_triangles),       cmocka_unit_test(moves_snap),
    };
    return cmocka_run_group_tests_name("snap", tests, NULL, NULL);
}
