/* The other hands on curves in space, in tilted views: points, levels and the smooth brush. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/view/way.h"
#include "support/space_wave.h"
#include <batten/batten.h>
#include <math.h>

/* The curve selected, in a view that is tilted and turned so often by 15 degrees, with a tool. */
static bat_editor *with(bat_curve *curve, int tilts, int turns, const char *tool) {
    bat_editor *editor = tilted_with(curve, tilts, turns);
    assert_int_equal(bat_editor_select(editor, 1, false), BAT_OK);
    assert_int_equal(bat_editor_command(editor, tool), BAT_OK);
    bat_editor_frame(editor);
    return editor;
}

static const bat_curve *curve_of(const bat_editor *editor) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), 0), 0);
}

static void seen(const bat_editor *editor, const bat_curve *curve, const double *point, double pixel[2]) {
    double at[2];
    bat_stage_look(&editor->stage, bat_curve_dimension(curve), point, at);
    bat_stage_project(&editor->stage, at, pixel);
}

/* A control point is dragged: it is seen under the pen, and a planar curve stays planar; the others stay. */
static void a_point_is_dragged(void **state) {
    (void)state;
    static const int views[][2] = {{0, 0}, {3, 0}, {4, 2}, {8, 1}};
    for (size_t v = 0; v < sizeof views / sizeof *views; v++)
        for (int planar = 0; planar < 2; planar++) {
            bat_curve *was = NULL;
            double from[2], now[2];
            bat_editor *editor = with(wave(40, 60, planar ? 0 : 1.3), views[v][0], views[v][1],
                                      "tool-points");
            const uint64_t first = digest(editor);
            pen p = pen_for(editor);
            bat_curve_copy(curve_of(editor), &was);
            seen(editor, was, bat_curve_points(was) + 3 * 5, from);
            drag(&p, from[0], from[1], from[0] + 40, from[1] - 30);
            const double *points = bat_curve_points(curve_of(editor));
            seen(editor, was, points + 3 * 5, now);
            assert_true(hypot(now[0] - from[0] - 40, now[1] - from[1] + 30) < 1e-6);
            if (planar && v < 3) assert_true(fabs(points[17] - 1.5 * (points[16] - 400)) < 1e-6);
            for (int i = 0; i < POINTS; i++)
                if (i != 5) assert_memory_equal(points + 3 * i, bat_curve_points(was) + 3 * i, 24);
            assert_int_equal(round_trip(editor, first), 1);
            bat_curve_free(was);
            bat_editor_free(editor);
        }
}

/* The curve is pulled anywhere: the place grabbed follows the pen. A curve of the page moves on the page. */
static void a_curve_is_pulled(void **state) {
    (void)state;
    for (int flat = 0; flat < 2; flat++) {
        double place[3] = {0}, from[2], now[2];
        bat_editor *editor = with(flat ? pen_curve(200, 400, 60, 20, 11) : wave(40, 60, 1.3), 3, 1,
                                  "tool-points");
        pen p = pen_for(editor);
        bat_curve_eval(curve_of(editor), 3.6, 0, place);
        seen(editor, curve_of(editor), place, from);
        drag(&p, from[0], from[1], from[0] - 20, from[1] + 35);
        bat_curve_eval(curve_of(editor), 3.6, 0, place);
        seen(editor, curve_of(editor), place, now);
        assert_true(hypot(now[0] - from[0] + 20, now[1] - from[1] - 35) < 1);
        assert_int_equal(bat_curve_dimension(curve_of(editor)), flat ? 2 : 3);
        replays(editor, 0);
        bat_editor_free(editor);
    }
}

/* The levels tool on a planar curve in space: without Alt in the plane, with Alt along its normal. */
static void a_level_is_dragged_along_its_normal(void **state) {
    (void)state;
    static const double normal[3] = {0, 0.8320502943378437, -0.5547001962252291}; /* z = 1.5 (y - 400) */
    for (int rises = 0; rises < 2; rises++) {
        bat_editor *editor = with(wave(40, 60, 0), 5, 1, "tool-levels");
        assert_int_equal(bat_editor_command(editor, "level-add"), BAT_OK);
        assert_int_equal(bat_editor_command(editor, "level-down"), BAT_OK);
        bat_curve *was = NULL;
        double from[2], far = 0;
        pen p = pen_for(editor);
        bat_curve_copy(curve_of(editor), &was);
        const bat_shape *shape = bat_object_shape(bat_document_at(bat_editor_document(editor), 0), 0);
        assert_non_null(shape);
        seen(editor, was, bat_curve_points(bat_shape_curve(shape, 0)) + 3 * 5, from);
        p.modifiers = rises ? BAT_ALT : 0;
        drag(&p, from[0], from[1], from[0] + 5, from[1] - 40);
        p.modifiers = 0;
        const bat_curve *now = curve_of(editor);
        for (int i = 0; i < (int)bat_curve_count(now); i++) {
            const double *a = bat_curve_points(was) + 3 * i, *b = bat_curve_points(now) + 3 * i;
            double way[3], off = 0, length = 0;
            for (int k = 0; k < 3; k++) way[k] = b[k] - a[k], off += way[k] * normal[k];
            for (int k = 0; k < 3; k++) length = hypot(length, way[k]);
            far = fmax(far, length);
            if (rises)
                assert_true(fabs(fabs(off) - length) < 1e-6);
            else
                assert_true(fabs(off) < 1e-6);
        }
        assert_true(far > 10);
        replays(editor, 0);
        bat_curve_free(was);
        bat_editor_free(editor);
    }
}

/* The brush fairs what it paints, and nothing else. */
static void the_brush_fairs_in_space(void **state) {
    (void)state;
    bat_curve *was = NULL;
    double place[3], at[2], a[3], b[3];
    bat_editor *editor = with(wave(3, 4, 1.3), 4, 1, "tool-smooth");
    pen p = pen_for(editor);
    bat_curve_copy(curve_of(editor), &was);
    for (int i = 0; i <= 20; i++) {
        bat_curve_eval(was, 3 + 0.1 * i, 0, place);
        seen(editor, was, place, at);
        pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, at[0], at[1]);
        bat_editor_frame(editor);
        check(editor);
    }
    pen_event(&p, BAT_POINTER_UP, at[0], at[1]);
    assert_false(bat_curve_is_equal(was, curve_of(editor)));
    assert_int_equal(bat_curve_dimension(curve_of(editor)), 3);
    bat_curve_eval(was, 0.5, 0, a);
    bat_curve_eval(curve_of(editor), 0.5, 0, b);
    for (int k = 0; k < 3; k++) assert_true(fabs(a[k] - b[k]) < 1e-9);
    replays(editor, 0);
    bat_curve_free(was);
    bat_editor_free(editor);
}

/* Nothing can rise on the page, nor along a normal that points at the eye, nor slide on what is seen from its side. */
static void ways_that_are_not(void **state) {
    (void)state;
    const double from[2] = {300, 300}, to[2] = {320, 280};
    double way[3];
    bat_editor *editor = with(wave(40, 60, 0), 0, 0, "tool-points");
    bat_curve *flat = NULL;
    const bat_curve *curve = curve_of(editor);
    assert_int_equal(bat_curve_to_dimension(curve, 2, &flat), BAT_OK);
    assert_false(bat_stage_way(&editor->stage, flat, from, to, true, way));
    assert_true(bat_stage_way(&editor->stage, flat, from, to, false, way) && way[2] == 0);
    assert_true(bat_stage_way(&editor->stage, curve, from, to, false, way));
    const double level[9] = {0, 0, 0, 50, 0, 0, 0, 50, 0};
    bat_curve *lies = NULL;
    assert_int_equal(bat_curve_create_clamped(3, 2, 3, level, &lies), BAT_OK);
    assert_false(bat_stage_way(&editor->stage, lies, from, to, true, way)); /* seen from above */
    for (int i = 0; i < 3; i++) bat_editor_command(editor, "orbit-up");
    assert_true(bat_stage_way(&editor->stage, lies, from, to, true, way) && way[2] != 0);
    bat_curve_free(flat), bat_curve_free(lies);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ways_that_are_not),        cmocka_unit_test(a_point_is_dragged),
        cmocka_unit_test(a_curve_is_pulled),        cmocka_unit_test(a_level_is_dragged_along_its_normal),
        cmocka_unit_test(the_brush_fairs_in_space),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
