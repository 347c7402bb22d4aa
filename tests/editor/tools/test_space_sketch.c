/* The sketch tool over curves in space: what their redraws land on, and samples that do not land. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/tools/sketch/parts.h"
#include "editor/view/casters.h"
#include "support/space_wave.h"
#include <batten/batten.h>
#include <math.h>

static bat_editor *with(bat_curve *curve, int tilts, int turns) {
    bat_editor *editor = tilted_with(curve, tilts, turns);
    bat_editor_command(editor, "tool-sketch");
    bat_editor_frame(editor);
    return editor;
}

static const bat_curve *curve_of(const bat_editor *editor, int at) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), at), 0);
}

/* Where a point of the curve is seen, in pixels. */
static void seen(const bat_editor *editor, const bat_curve *curve, double u, double pixel[2]) {
    double point[3], at[2];
    bat_curve_eval(curve, u, 0, point);
    bat_stage_look(&editor->stage, 3, point, at);
    bat_stage_project(&editor->stage, at, pixel);
}

/* A stroke in pixels, `by` above the picture of the curve from u to v in its middle; kept: its pixels. */
enum { STROKE = 60 };
static void redraw(bat_editor *editor, const bat_curve *was, double u, double v, double by,
                   double kept[2 * (STROKE + 1)]) {
    pen p = pen_for(editor);
    for (int i = 0; i <= STROKE; i++) {
        const double t = (double)i / STROKE;
        double *at = kept + 2 * i;
        seen(editor, was, u + t * (v - u), at);
        at[1] -= by * 16 * t * t * (1 - t) * (1 - t);
        if (i == 0) pen_event(&p, BAT_POINTER_HOVER, at[0], at[1]);
        if (i == 0) bat_editor_frame(editor);
        pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, at[0], at[1]);
        if (i % 8 == 0) bat_editor_frame(editor);
    }
    pen_event(&p, BAT_POINTER_UP, kept[2 * STROKE], kept[2 * STROKE + 1]);
    bat_editor_frame(editor);
    check(editor);
}

/* How far the picture of the curve is from a pixel. */
static double apart(const bat_editor *editor, const bat_curve *curve, const double pixel[2]) {
    double domain[2], best = INFINITY;
    bat_curve_domain(curve, domain);
    for (int i = 0; i <= 4000; i++) {
        double at[2];
        seen(editor, curve, domain[0] + (domain[1] - domain[0]) * i / 4000, at);
        best = fmin(best, hypot(at[0] - pixel[0], at[1] - pixel[1]));
    }
    return best;
}

/* The picture follows the stroke, the ends stay, and the journal tells the same. */
static void expect_redrawn(bat_editor *editor, const bat_curve *was, const double *stroke) {
    double a[3], b[3];
    assert_int_equal(bat_document_count(bat_editor_document(editor)), 1);
    const bat_curve *now = curve_of(editor, 0);
    assert_false(bat_curve_is_equal(was, now));
    for (int i = 8; i <= STROKE - 8; i += 4) assert_true(apart(editor, now, stroke + 2 * i) < 1.5);
    double before[2], after[2];
    bat_curve_domain(was, before);
    bat_curve_domain(now, after);
    for (int k = 0; k < 2; k++) {
        bat_curve_eval(was, before[k], 0, a);
        bat_curve_eval(now, after[k], 0, b);
        for (int i = 0; i < 3; i++) assert_true(fabs(a[i] - b[i]) < 1e-9);
    }
}

static void a_space_curve_is_redrawn_in_any_view(void **state) {
    (void)state;
    static const int views[][2] = {{0, 0}, {2, 0}, {3, 2}, {5, -1}, {6, 1}, {8, 3}};
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        double stroke[2 * (STROKE + 1)];
        bat_curve *was = NULL;
        bat_editor *editor = with(wave(40, 60, 1.3), views[i][0], views[i][1]);
        const uint64_t first = digest(editor);
        bat_curve_copy(curve_of(editor, 0), &was);
        redraw(editor, was, 2, 5.5, 25, stroke);
        expect_redrawn(editor, was, stroke);
        assert_int_equal(round_trip(editor, first), 1);
        bat_curve_free(was);
        bat_editor_free(editor);
    }
}

/* Whatever the view, short of one from its edge, a planar curve stays in its plane. */
static void a_planar_curve_stays_planar(void **state) {
    (void)state;
    for (int tilts = 0; tilts < 5; tilts++) {
        double stroke[2 * (STROKE + 1)];
        bat_curve *was = NULL;
        bat_editor *editor = with(wave(40, 60, 0), tilts, 0);
        bat_curve_copy(curve_of(editor, 0), &was);
        redraw(editor, was, 2, 5.5, 25, stroke);
        const bat_curve *now = curve_of(editor, 0);
        expect_redrawn(editor, was, stroke);
        for (int i = 0; i < (int)bat_curve_count(now); i++) { /* z = 60 / 40 (y - 400) */
            const double *p = bat_curve_points(now) + 3 * i;
            assert_true(fabs(p[2] - 1.5 * (p[1] - 400)) < 1e-6);
        }
        bat_curve_free(was);
        bat_editor_free(editor);
    }
}

/* While the pen hovers its surface is shown and named. */
static void what_it_lands_on_is_shown(void **state) {
    (void)state;
    double at[2];
    bat_editor *editor = with(wave(40, 60, 1.3), 3, 0);
    pen p = pen_for(editor);
    seen(editor, curve_of(editor, 0), 4, at);
    pen_event(&p, BAT_POINTER_HOVER, at[0], at[1]);
    const bat_frame *frame = bat_editor_frame(editor);
    assert_non_null(pen_live(frame, BAT_ROLE_MARQUEE));
    assert_non_null(strstr(frame->hint, "the surface over the curve"));
    pen_event(&p, BAT_POINTER_HOVER, at[0], at[1] + 200);
    frame = bat_editor_frame(editor);
    assert_null(pen_live(frame, BAT_ROLE_MARQUEE));
    assert_non_null(strstr(frame->hint, "the page"));
    bat_editor_free(editor);
}

/* A stroke along the curve that goes on by so many samples beyond its end, where there is no surface. */
static void beyond(bat_editor *editor, int samples) {
    pen p = pen_for(editor);
    double at[2];
    for (int i = 0; i <= 40 + samples; i++) {
        seen(editor, curve_of(editor, 0), 4 + fmin(i, 40) * 0.1, at);
        if (i > 40) at[0] += 3 * (i - 40);
        pen_event(&p, i ? BAT_POINTER_MOVE : BAT_POINTER_DOWN, at[0], at[1]);
    }
    pen_event(&p, BAT_POINTER_UP, at[0], at[1]);
    check(editor);
}

static void samples_that_miss_are_counted(void **state) {
    (void)state;
    bat_editor *editor = with(wave(40, 60, 1.3), 3, 0);
    const uint64_t first = digest(editor);
    beyond(editor, 40);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "Too much of the stroke missed the surface"));
    assert_true(digest(editor) == first);
    beyond(editor, 12);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "were left out"));
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

static void select_curve(bat_editor *editor) {
    assert_int_equal(
        bat_editor_select(editor, bat_object_id(bat_document_at(bat_editor_document(editor), 0)), false),
        BAT_OK);
}

/* The way back of a lift: what is left is the first view, to the bit. */
static void a_curve_is_flattened(void **state) {
    (void)state;
    bat_curve *was = NULL;
    bat_editor *editor = with(wave(40, 60, 1.3), 3, 0);
    const uint64_t first = digest(editor);
    bat_curve_copy(curve_of(editor, 0), &was);
    assert_int_equal(bat_editor_command(editor, "to-page"), BAT_STATE);
    select_curve(editor);
    assert_int_equal(bat_editor_command(editor, "to-page"), BAT_OK);
    const bat_curve *now = curve_of(editor, 0);
    assert_int_equal(bat_curve_dimension(now), 2);
    for (int i = 0; i < POINTS; i++)
        assert_memory_equal(bat_curve_points(now) + 2 * i, bat_curve_points(was) + 3 * i, 2 * sizeof(double));
    assert_int_equal(bat_editor_command(editor, "to-page"), BAT_STATE);
    assert_int_equal(round_trip(editor, first), 1);
    bat_curve_free(was);
    bat_editor_free(editor);
}

/* Levels are flattened with their curve: each level's curve is its first view, and they are still there to be changed. */
static void a_curve_with_levels_is_flattened(void **state) {
    (void)state;
    bat_editor *editor = with(wave(40, 60, 1.3), 3, 0);
    const uint64_t first = digest(editor);
    select_curve(editor);
    assert_int_equal(bat_editor_command(editor, "tool-levels"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "apart-levels", 2), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    const bat_object *object = bat_object_retain(bat_document_at(bat_editor_document(editor), 0));
    const bat_shape *was = bat_object_shape(object, 0);
    assert_non_null(was);
    select_curve(editor);
    assert_int_equal(bat_editor_command(editor, "to-page"), BAT_OK);
    const bat_shape *now = bat_object_shape(bat_document_at(bat_editor_document(editor), 0), 0);
    assert_non_null(now);
    assert_int_equal(bat_shape_levels(now), bat_shape_levels(was));
    for (int l = 0; l <= bat_shape_levels(was); l++) {
        const bat_curve *a = bat_shape_curve(was, l), *b = bat_shape_curve(now, l);
        assert_int_equal(bat_curve_dimension(b), 2);
        for (size_t i = 0; i < bat_curve_count(a); i++)
            for (size_t d = 0; d < 2; d++)
                assert_true(fabs(bat_curve_points(b)[2 * i + d] - bat_curve_points(a)[3 * i + d]) < 1e-9);
    }
    assert_int_equal(bat_editor_command(editor, "to-page"), BAT_STATE);
    check(editor);
    assert_int_equal(round_trip(editor, first), 2);
    bat_object_release((bat_object *)object);
    bat_editor_free(editor);
}

static void the_plane_of_a_curve_is_drawn_on(void **state) {
    (void)state;
    bat_editor *editor = with(wave(40, 60, 0), 3, 0);
    pen p = pen_for(editor);
    select_curve(editor);
    assert_int_equal(bat_editor_command(editor, "plane-of-curve"), BAT_OK);
    bat_editor_command(editor, "select-none");
    drag(&p, 300, 100, 700, 180);
    const bat_curve *made = curve_of(editor, 2);
    assert_int_equal(bat_curve_dimension(made), 3);
    for (int i = 0; i < (int)bat_curve_count(made); i++) { /* z = 60 / 40 (y - 400) */
        const double *at = bat_curve_points(made) + 3 * i;
        assert_true(fabs(at[2] - 1.5 * (at[1] - 400)) < 1e-6);
    }
    replays(editor, 0);
    bat_editor_free(editor);
    editor = with(wave(40, 60, 1.3), 3, 0); /* one that has none */
    select_curve(editor);
    assert_int_equal(bat_editor_command(editor, "plane-of-curve"), BAT_STATE);
    assert_non_null(strstr(bat_editor_frame(editor)->notice, "lies in a plane"));
    bat_editor_free(editor);
}

/* What is under the pen may have gone: the ground is then as it was. */
static void what_has_gone(void **state) {
    (void)state;
    const double at[2] = {300, 300};
    bat_editor *editor = with(wave(40, 60, 1.3), 2, 1);
    const bat_pick gone[] = {{.object = 99}, {.object = 1, .curve = -1}, {.object = 1, .curve = 5}};
    for (size_t i = 0; i < sizeof gone / sizeof *gone; i++) {
        const bat_stage stage = bat_sketching_stage(&editor->context, &gone[i], at);
        assert_true(bat_ground_same(&stage.ground, &editor->stage.ground));
    }
    bat_casters *casters = &editor->casters;
    const double up[3] = {0, 0, 1}, aside[3] = {0, 0.6, 0.8};
    bat_casting *one = NULL, *other = NULL;
    assert_int_equal(bat_casters_find(NULL, 1, 0, up, &one), BAT_STATE);
    assert_int_equal(bat_casters_find(casters, 99, 0, up, &one), BAT_STATE);
    assert_int_equal(bat_casters_find(casters, 1, 5, up, &one), BAT_STATE);
    assert_int_equal(bat_casters_find(casters, 1, 0, up, &one), BAT_OK);
    const bat_caster *made = one->caster;
    assert_int_equal(bat_casters_find(casters, 1, 0, up, &other), BAT_OK);
    assert_ptr_equal(other->caster, made);
    assert_int_equal(bat_casters_find(casters, 1, 0, aside, &other), BAT_OK);
    assert_true(other->along[1] == 0.6);
    assert_int_not_equal(bat_casters_find(casters, 1, -1, up, &one), BAT_OK); /* it has no surface */
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_has_gone),
        cmocka_unit_test(a_space_curve_is_redrawn_in_any_view),
        cmocka_unit_test(a_planar_curve_stays_planar),
        cmocka_unit_test(what_it_lands_on_is_shown),
        cmocka_unit_test(a_curve_is_flattened),
        cmocka_unit_test(a_curve_with_levels_is_flattened),
        cmocka_unit_test(the_plane_of_a_curve_is_drawn_on),
        cmocka_unit_test(samples_that_miss_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
