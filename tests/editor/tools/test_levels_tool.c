/*
 * The levels tool and the strip: a curve is decomposed exactly, and only on confirmation; when dragged at a level, the
 * point under the pen follows and no other level's detail changes; faders, mute, solo, frame rule, copies and
 * flattening are one step each; everything replays and can be undone.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "curve/curve.h"
#include "editor/editor.h"
#include "support/session.h"
#include "editor/tools/levels/state.h"
#include <batten/measure.h>
#include "support/editing.h"

static const bat_object *object_at(const bat_editor *editor, int index) {
    return bat_document_at(bat_editor_document(editor), index);
}
static const bat_shape *shape_at(const bat_editor *editor, int index) {
    return bat_object_shape(object_at(editor, index), 0);
}

/* Sixty points along y = 300, waving coarsely and finely; a plain curve along y = 600. */
static bat_editor *levels_editor(void) {
    double points[120], knots[64];
    for (int i = 0; i < 60; i++) {
        points[2 * i] = 100 + 12 * i;
        points[2 * i + 1] = 300 + 60 * sin(0.12 * i) + 6 * sin(2.1 * i);
    }
    for (int i = 0; i < 64; i++) knots[i] = i < 4 ? 0 : i > 59 ? 57 : i - 3;
    bat_curve *curve = NULL;
    bat_document *document = NULL;
    bat_editor *editor = NULL;
    bat_curve_create(2, 3, false, 60, points, 64, knots, &curve);
    bat_document_create(&document);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    pen_add(document, curve);
    pen_add(document, pen_curve(200, 600, 60, 0, 11));
    editor = editor_of(document);
    bat_editor_command(editor, "tool-levels");
    return editor;
}

static uint64_t plain_digest(void) {
    bat_editor *editor = levels_editor();
    uint64_t plain = digest(editor);
    bat_editor_free(editor);
    return plain;
}

static void on_curve(const bat_editor *editor, int index, double where, double out[2]) {
    const bat_curve *curve = bat_object_curve(object_at(editor, index), 0);
    double domain[2];
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[0] + where * (domain[1] - domain[0]), 0, out);
}

/* The first curve, taken apart into three levels over eight points, and chosen. */
static bat_editor *apart_editor(pen *p) {
    bat_editor *editor = levels_editor();
    double at[2];
    *p = pen_for(editor);
    on_curve(editor, 0, 0.5, at);
    tap(p, at[0], at[1]);
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "apart-levels", 3), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "apart-points", 8), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    check(editor);
    return editor;
}

static void taken_apart_when_accepted(void **state) {
    (void)state;
    bat_editor *editor = levels_editor();
    pen p = pen_for(editor);
    uint64_t first = digest(editor);
    double at[2];
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_STATE); /* nothing is chosen */
    assert_int_equal(bat_editor_frame(editor)->levels, 0);
    on_curve(editor, 0, 0.5, at);
    tap(&p, at[0], at[1]);
    uint32_t version = bat_editor_frame(editor)->levels;
    assert_int_not_equal(version, 0);
    assert_string_equal(bat_editor_levels(editor), "{\"rows\":[],\"points\":60,\"apart\":0,\"copying\":0}");
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    assert_int_not_equal(bat_editor_frame(editor)->levels, version);
    assert_non_null(strstr(bat_editor_levels(editor), "\"apart\":1"));
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_POLYGON));
    double value;
    assert_int_equal(bat_editor_get(editor, "apart-points", &value), BAT_OK);
    assert_true(value >= 4 && value <= 12);
    /* The other number follows the levels; the levels stay when the other is set. */
    assert_int_equal(bat_editor_set(editor, "apart-levels", 2), BAT_OK);
    assert_int_equal(bat_editor_get(editor, "apart-points", &value), BAT_OK);
    assert_true(value == 18); /* 60 points have 56 inner knots, then 28, then 14 */
    assert_int_equal(bat_editor_set(editor, "apart-points", 1000), BAT_OK); /* as many as can be */
    assert_int_equal(bat_editor_get(editor, "apart-points", &value), BAT_OK);
    assert_true(value == 58);
    assert_int_equal(bat_editor_set(editor, "apart-points", 7), BAT_OK);
    check(editor);
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_null(strstr(bat_editor_levels(editor), "\"apart\":1"));
    assert_true(digest(editor) == first && !bat_editor_frame(editor)->can_undo);
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "apart-levels", 2), BAT_OK);
    assert_int_equal(bat_editor_set(editor, "apart-points", 7), BAT_OK);
    bat_curve *before = NULL;
    bat_curve_copy(bat_object_curve(object_at(editor, 0), 0), &before);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    const bat_shape *shape = shape_at(editor, 0);
    assert_non_null(shape);
    assert_int_equal(bat_shape_levels(shape), 2);
    assert_int_equal(bat_curve_count(bat_shape_curve(shape, 0)), 7);
    for (int i = 0; i < 120; i++)
        assert_true(fabs(bat_curve_points(before)[i] - bat_curve_points(bat_shape_curve(shape, 2))[i]) <
                    1e-10);
    assert_non_null(strstr(bat_editor_levels(editor), "{\"rows\":[{\"points\":7,"));
    bat_curve_free(before);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

/* A control point of the curve would be taken instead. */
static bool near_point(const bat_curve *curve, const double at[2]) {
    for (int i = 0; i < bat_point_count(curve); i++)
        if (hypot(bat_curve_points(curve)[2 * i] - at[0], bat_curve_points(curve)[2 * i + 1] - at[1]) < 12)
            return true;
    return false;
}

static void a_level_is_dragged(void **state) {
    (void)state;
    for (int level = 0; level <= 3; level++) {
        pen p;
        bat_editor *editor = apart_editor(&p);
        uint64_t first = digest(editor), plain = plain_digest();
        bat_shape *before = NULL;
        bat_shape_copy(shape_at(editor, 0), &before);
        for (int i = 0; i < level; i++) assert_true(bat_editor_key(editor, "]", true, 0, p.time));
        double at[2], now[2], where = 0.3;
        while (where < 0.6 &&
               near_point(bat_shape_curve(before, level), (on_curve(editor, 0, where, at), at)))
            where += 0.01;
        drag_to(&p, at[0], at[1], at[0] + 20, at[1] + 60);
        assert_true(digest(editor) != first);
        on_curve(editor, 0, where, now); /* within the pick's reach of where it was grabbed */
        if (level < 2) assert_true(where < 0.6);
        if (where < 0.6) /* at fine levels a control point lies under the pen wherever it is */
            assert_true(hypot(now[0] - at[0] - 20, now[1] - at[1] - 60) < 0.05);
        assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
        assert_true(digest(editor) == first);
        pen_event(&p, BAT_POINTER_UP, 0, 0);
        drag(&p, at[0], at[1], at[0] + 20, at[1] + 60);
        const bat_shape *after = shape_at(editor, 0);
        for (int l = 1; l <= 3; l++) { /* the details of the other levels ride along as they are */
            int n = 3 * bat_point_count(bat_shape_curve(after, l)), changed = 0;
            for (int i = 0; i < n; i++)
                changed += bat_shape_details(before, l)[i] != bat_shape_details(after, l)[i];
            if (l == level)
                assert_in_range(changed, 1, 8);
            else
                assert_int_equal(changed, 0);
        }
        assert_int_equal(bat_curve_is_equal(bat_shape_curve(before, 0), bat_shape_curve(after, 0)),
                         level > 0);
        bat_shape_free(before);
        assert_int_equal(round_trip(editor, plain), 2);
        bat_editor_free(editor);
    }
}

/* With Alt the place under the pen, or a control point, goes along the curve's normal there, however the pen goes. */
static void alt_drags_along_the_normal(void **state) {
    (void)state;
    for (int point = 0; point < 2; point++) {
        pen p;
        bat_editor *editor = apart_editor(&p);
        const bat_curve *curve = bat_shape_curve(shape_at(editor, 0), point ? 1 : 3);
        double domain[2], at[2], there[4], after[2], all[64];
        if (point) assert_true(bat_editor_key(editor, "]", true, 0, p.time));
        const int index = 3;
        bat_curve_domain(curve, domain);
        bat_curve_greville(curve, all);
        const double u = point ? all[index] : domain[0] + 0.37 * (domain[1] - domain[0]);
        bat_curve_eval(curve, u, 1, there);
        const double *tangent = there + 2;
        if (point)
            memcpy(at, bat_curve_points(curve) + 2 * index, sizeof at);
        else
            bat_curve_eval(curve, u, 0, at);
        p.modifiers = BAT_ALT;
        drag(&p, at[0], at[1], at[0] + 31, at[1] - 44);
        const bat_curve *now = bat_shape_curve(shape_at(editor, 0), point ? 1 : 3);
        if (point)
            memcpy(after, bat_curve_points(now) + 2 * index, sizeof after);
        else
            bat_curve_eval(now, u, 0, after);
        const double length = hypot(tangent[0], tangent[1]);
        const double along = ((after[0] - at[0]) * tangent[0] + (after[1] - at[1]) * tangent[1]) / length;
        const double across = (-(after[0] - at[0]) * tangent[1] + (after[1] - at[1]) * tangent[0]) / length;
        assert_true(fabs(along) < 0.5);
        assert_true(fabs(across - (-31 * tangent[1] - 44 * tangent[0]) / length) < 0.5);
        assert_int_equal(round_trip(editor, plain_digest()), 2);
        bat_editor_free(editor);
    }
}

static void points_of_a_level(void **state) {
    (void)state;
    pen p;
    bat_editor *editor = apart_editor(&p);
    const bat_curve *base = bat_shape_curve(shape_at(editor, 0), 0);
    double x = bat_curve_points(base)[6], y = bat_curve_points(base)[7];
    pen_event(&p, BAT_POINTER_HOVER, x, y);
    assert_string_equal(bat_editor_frame(editor)->hint, "Drag the control point. Shift: steps of 15°");
    drag(&p, x, y, x + 31, y - 17);
    base = bat_shape_curve(shape_at(editor, 0), 0);
    assert_true(fabs(bat_curve_points(base)[6] - x - 31) < 0.02 &&
                fabs(bat_curve_points(base)[7] - y + 17) < 0.02);
    /* With the keyboard: the same point is chosen now; the next one, ten pixels down. */
    assert_true(bat_editor_key(editor, "Tab", true, 0, p.time));
    y = bat_curve_points(base)[9];
    assert_true(bat_editor_key(editor, "ArrowDown", true, BAT_SHIFT, p.time));
    base = bat_shape_curve(shape_at(editor, 0), 0);
    assert_true(fabs(bat_curve_points(base)[9] - y - 10) < 1e-9);
    bat_editor_key(editor, "Shift", false, 0, p.time);
    /* A silent level does not move, and says so. */
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_CHOOSE, 2, 0, true), BAT_OK);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_MUTE, 2, 1, true), BAT_OK);
    uint64_t silent = digest(editor);
    const double *at = bat_curve_points(bat_shape_curve(shape_at(editor, 0), 2)) + 20;
    drag(&p, at[0], at[1], at[0] + 30, at[1] + 30);
    assert_string_equal(bat_editor_frame(editor)->notice, "This level is hidden. Show it to edit it");
    assert_true(digest(editor) == silent);
    bat_editor_free(editor);
}

static void faders(void **state) {
    (void)state;
    pen p;
    bat_editor *editor = apart_editor(&p);
    uint64_t first = digest(editor);
    for (int i = 0; i <= 10; i++) { /* live, one step */
        assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 2, 1 + 0.1 * i, false), BAT_OK);
        bat_editor_frame(editor);
        check(editor);
    }
    assert_true(bat_shape_gain(shape_at(editor, 0), 2) == 2);
    assert_int_equal(bat_editor_command(editor, "level-up"), BAT_STATE); /* while it is held */
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_SOLO, 1, 1, true), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_true(digest(editor) == first);
    check(editor);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 2, 0.25, false), BAT_OK);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 2, 0.5, true), BAT_OK);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 2, 0.5, true), BAT_OK); /* no step */
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 4, 1, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 0, 1, true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 1, NAN, true), BAT_NUMBER);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_GAIN, 1, 1e7, true), BAT_ARGUMENT);
    check(editor);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_SOLO, 1, 1, true), BAT_OK);
    const bat_shape *shape = shape_at(editor, 0);
    assert_true(!bat_shape_is_muted(shape, 1) && bat_shape_is_muted(shape, 2) &&
                bat_shape_is_muted(shape, 3));
    assert_true(bat_shape_gain(shape, 2) == 0.5);
    assert_non_null(strstr(bat_editor_levels(editor), "\"solo\":1"));
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_SOLO, 1, 1, true), BAT_OK); /* again: all sound */
    assert_null(strstr(bat_editor_levels(editor), "\"muted\":1"));
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_MUTE, 3, 1, true), BAT_OK);
    assert_true(bat_shape_is_muted(shape_at(editor, 0), 3));
    assert_int_equal(round_trip(editor, plain_digest()), 5);
    bat_editor_free(editor); /* apart, gain, solo, all, mute */
}

static void keys_step_levels(void **state) {
    (void)state;
    pen p;
    bat_editor *editor = apart_editor(&p);
    double before, after, at[2];
    bat_editor_get(editor, "tolerance", &before);
    assert_true(bat_editor_key(editor, "]", true, 0, 1));
    assert_string_equal(bat_editor_frame(editor)->notice, "Level 1 / 3");
    for (int i = 0; i < 5; i++) assert_true(bat_editor_key(editor, "]", true, 0, 1));
    assert_string_equal(bat_editor_frame(editor)->notice, "Level 3 / 3");
    bat_editor_get(editor, "tolerance", &after);
    assert_true(after == before);
    /* In the sketch tool the keys mean the levels over the chosen curve, elsewhere the tolerance. */
    bat_editor_command(editor, "tool-sketch");
    on_curve(editor, 0, 0.4, at);
    pen_event(&p, BAT_POINTER_HOVER, at[0], at[1]);
    bat_editor_frame(editor);
    assert_true(bat_editor_key(editor, "[", true, 0, 1));
    assert_string_equal(bat_editor_frame(editor)->notice, "Level 2 / 3");
    pen_event(&p, BAT_POINTER_HOVER, 500, 700);
    bat_editor_frame(editor);
    assert_true(bat_editor_key(editor, "[", true, 0, 1));
    bat_editor_get(editor, "tolerance", &after);
    assert_true(after < before);
    bat_editor_free(editor);
}

/* A stroke over the chosen curve redraws the active level; the others keep their details. Over another curve with
 * levels the coarsest level that can follow the stroke does. */
static void a_level_is_redrawn(void **state) {
    (void)state;
    for (int other = 0; other < 2; other++) {
        pen p;
        bat_editor *editor = apart_editor(&p);
        bat_shape *before = NULL;
        bat_shape_copy(shape_at(editor, 0), &before);
        if (other) bat_editor_command(editor, "deselect");
        bat_editor_command(editor, "tool-sketch");
        double from[2], to[2], now[2], middle[2];
        on_curve(editor, 0, 0.3, from);
        on_curve(editor, 0, 0.7, to);
        pen_event(&p, BAT_POINTER_HOVER, from[0], from[1]);
        assert_string_equal(
            bat_editor_frame(editor)->hint,
            other ? "Draw over to redraw this curve"
                  : "Draw over to redraw the active level of this curve. [ and ] change the level");
        pen_begin(&p, pen_arch, (double[]){from[0], from[1], to[0], to[1], 30}, 60);
        check(editor);
        assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
        pen_event(&p, BAT_POINTER_UP, to[0], to[1]);
        check(editor);
        const bat_shape *after = shape_at(editor, 0);
        assert_non_null(after);
        int changed[4] = {!bat_curve_is_equal(bat_shape_curve(before, 0), bat_shape_curve(after, 0))},
            all = 0;
        for (int l = 1; l <= 3; l++)
            for (int i = 0; i < 3 * bat_point_count(bat_shape_curve(after, l)); i++)
                changed[l] |= bat_shape_details(before, l)[i] != bat_shape_details(after, l)[i];
        for (int l = 0; l <= 3; l++) all += changed[l];
        assert_int_equal(all, 1);
        if (!other) assert_int_equal(changed[0], 1);
        pen_arch(0.5, (double[]){from[0], from[1], to[0], to[1], 30}, middle);
        on_curve(editor, 0, 0.5, now);
        assert_true(fabs(now[1] - middle[1]) < 20); /* the sweep went there; the waves are six high */
        const uint64_t swept = digest(editor);
        assert_int_equal(bat_editor_refit(editor, 0.1, false), BAT_OK); /* shown before it is let go */
        assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_FIT));
        assert_true(digest(editor) == swept);
        bat_shape_free(before);
        assert_int_equal(round_trip(editor, plain_digest()), 2);
        bat_editor_free(editor);
    }
    /* The base with its knots, details kept or dropped under the stroke: it goes where the pen went, all levels stay. */
    for (int way = 1; way <= 2; way++) {
        pen p;
        bat_editor *editor = apart_editor(&p);
        assert_int_equal(bat_editor_set(editor, "level-sketch", way), BAT_OK);
        bat_editor_command(editor, "tool-sketch");
        double from[2], to[2], middle[2];
        bat_near near;
        on_curve(editor, 0, 0.3, from);
        on_curve(editor, 0, 0.7, to);
        pen_line(&p, from[0], from[1], to[0], to[1], 30);
        if (bat_editor_frame(editor)->pending) bat_editor_command(editor, "accept");
        check(editor);
        const bat_shape *after = shape_at(editor, 0);
        assert_non_null(after);
        assert_int_equal(bat_shape_levels(after), 3);
        pen_arch(0.5, (double[]){from[0], from[1], to[0], to[1], 30}, middle);
        assert_int_equal(bat_curve_nearest(bat_shape_curve(after, 0), middle, &near), BAT_OK);
        assert_true(near.distance < 2);
        bat_curve_nearest(bat_shape_curve(after, 3), middle, &near);
        assert_true(way == 1 || near.distance < 2); /* bare: nothing is left on it */
        assert_int_equal(round_trip(editor, plain_digest()), 2);
        bat_editor_free(editor);
    }
    /* A silent level is not redrawn, and says so. */
    pen p;
    bat_editor *editor = apart_editor(&p);
    double from[2], to[2];
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_CHOOSE, 3, 0, true), BAT_OK);
    assert_int_equal(bat_editor_level(editor, BAT_LEVEL_MUTE, 3, 1, true), BAT_OK);
    uint64_t silent = digest(editor);
    bat_editor_command(editor, "tool-sketch");
    on_curve(editor, 0, 0.3, from);
    on_curve(editor, 0, 0.7, to);
    pen_line(&p, from[0], from[1], to[0], to[1], 10);
    check(editor);
    assert_string_equal(bat_editor_frame(editor)->notice, "This level is hidden. Show it to edit it");
    assert_true(digest(editor) == silent);
    bat_editor_free(editor);
}

/* Eight points span five spans, so a tenth of the curve is half a span of the base. Where the base was chosen it follows
 * as well as it can, and how well is said; else a level is meant whose spans are shorter. */
static void short_strokes_mean_finer_levels(void **state) {
    (void)state;
    for (int chosen = 0; chosen < 2; chosen++) {
        pen p;
        bat_editor *editor = apart_editor(&p);
        bat_shape *before = NULL;
        double from[2], to[2];
        bat_shape_copy(shape_at(editor, 0), &before);
        if (chosen)
            assert_int_equal(bat_editor_level(editor, BAT_LEVEL_CHOOSE, 0, 0, true), BAT_OK);
        else
            bat_editor_command(editor, "deselect");
        bat_editor_command(editor, "tool-sketch");
        on_curve(editor, 0, 0.45, from);
        on_curve(editor, 0, 0.55, to);
        pen_line(&p, from[0], from[1], to[0], to[1], -25);
        check(editor);
        const bat_shape *after = shape_at(editor, 0);
        bool base_stays = bat_curve_is_equal(bat_shape_curve(before, 0), bat_shape_curve(after, 0));
        assert_true(base_stays != (bool)chosen);
        const char *notice = bat_editor_frame(editor)->notice;
        assert_true(!strncmp(notice, "A short stroke for this level: it follows within ", 49) ==
                    (bool)chosen);
        if (chosen) {
            double px = strtod(notice + 49, NULL);
            assert_true(px > 2 && px < 30);
        }
        bat_shape_free(before);
        assert_int_equal(round_trip(editor, plain_digest()), 2);
        bat_editor_free(editor);
    }
}

static void rules_copies_and_flattening(void **state) {
    (void)state;
    pen p;
    bat_editor *editor = apart_editor(&p);
    bat_curve *before = NULL;
    double at[2], value;
    bat_curve_copy(bat_object_curve(object_at(editor, 0), 0), &before);
    for (int rule = 2; rule >= 0; rule--) {
        assert_int_equal(bat_editor_set(editor, "frame-rule", rule), BAT_OK);
        assert_int_equal(bat_editor_get(editor, "frame-rule", &value), BAT_OK);
        assert_true(value == rule);
        assert_int_equal(bat_shape_options_of(shape_at(editor, 0))->frame, rule);
        const bat_curve *now = bat_object_curve(object_at(editor, 0), 0);
        for (int i = 0; i < 120; i++)
            assert_true(fabs(bat_curve_points(now)[i] - bat_curve_points(before)[i]) < 1e-9);
        check(editor);
    }
    bat_editor_set(editor, "show-frames", 1);
    bat_editor_set(editor, "show-levels", 1);
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_ARROW));
    assert_non_null(pen_live(bat_editor_frame(editor), BAT_ROLE_GHOST));
    /* Detail to the straight curve: its base stays, the levels come. */
    assert_int_equal(bat_editor_command(editor, "levels-copy"), BAT_OK);
    assert_string_equal(bat_editor_frame(editor)->hint,
                        "Tap the curve or surface that gets the detail. Esc cancels");
    tap(&p, 500, 600);
    const bat_shape *copy = shape_at(editor, 1);
    assert_non_null(copy);
    assert_int_equal(bat_shape_levels(copy), 3);
    assert_int_equal(bat_curve_count(bat_shape_curve(copy, 0)), 11);
    double low[2], high[2];
    bat_curve_bounds(bat_shape_curve(copy, 0), low, high);
    assert_true(low[1] == 600 && high[1] == 600);
    bat_curve_bounds(bat_object_curve(object_at(editor, 1), 0), low, high);
    assert_true(high[1] - low[1] > 4);
    assert_int_equal(bat_editor_command(editor, "levels-copy"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
    assert_non_null(strstr(bat_editor_levels(editor), "\"copying\":0"));
    bat_curve_free(before);
    bat_curve_copy(bat_object_curve(object_at(editor, 1), 0), &before);
    assert_int_equal(bat_editor_command(editor, "levels-flatten"), BAT_OK);
    assert_int_equal(bat_object_kind(object_at(editor, 1)), BAT_KIND_PATH);
    assert_true(bat_curve_is_equal(before, bat_object_curve(object_at(editor, 1), 0)));
    assert_int_equal(bat_editor_command(editor, "levels-flatten"), BAT_STATE);
    /* A level on a plain curve, and another on that. */
    assert_int_equal(bat_editor_command(editor, "level-add"), BAT_OK);
    assert_int_equal(bat_shape_levels(shape_at(editor, 1)), 1);
    assert_int_equal(bat_editor_command(editor, "level-add"), BAT_OK);
    assert_int_equal(bat_shape_levels(shape_at(editor, 1)), 2);
    assert_non_null(strstr(bat_editor_levels(editor), "\"active\":1}]"));
    on_curve(editor, 1, 0.5, at);
    drag(&p, at[0], at[1], at[0], at[1] + 25);
    bat_curve_free(before);
    assert_int_equal(round_trip(editor, plain_digest()), 9);
    bat_editor_free(editor);
}

/* A spline of the tangents hand is a base, too. */
static void a_spline_becomes_a_base(void **state) {
    (void)state;
    const double points[] = {200, 300, 400, 200, 600, 320, 800, 250};
    const bat_spline spline = {.dimension = 2, .count = 4, .points = points};
    bat_style style = bat_style_defaults();
    bat_document *document = NULL;
    bat_object *object = NULL;
    bat_editor *editor = NULL;
    bat_document_create(&document);
    bat_object_create_spline(bat_document_new_id(document), "s", &style, &spline, NULL, &object);
    bat_document_insert(document, 0, object);
    bat_editor_create(&editor);
    bat_editor_resize(editor, 1000, 800, 1);
    bat_editor_open(editor, document, "test");
    uint64_t first = digest(editor);
    bat_editor_select(editor, bat_object_id(object), false);
    assert_int_equal(bat_editor_command(editor, "level-add"), BAT_OK); /* from any tool */
    assert_int_equal(bat_object_kind(object_at(editor, 0)), BAT_KIND_SHAPE);
    assert_null(bat_object_spline(object_at(editor, 0)));
    assert_true(bat_curve_is_equal(bat_shape_curve(shape_at(editor, 0), 0), bat_object_curve(object, 0)));
    bat_object_release(object);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

/* A press that is taken away, by the system or for a pinch, leaves neither itself nor ends what waits for a yes. */
static void a_press_taken_away_keeps_the_choice(void **state) {
    (void)state;
    for (int pinch = 0; pinch < 2; pinch++) {
        pen p;
        bat_editor *editor = apart_editor(&p);
        assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
        int levels = bat_ladder_levels(bat_leveling_of(&editor->context)->apart);
        assert_true(levels > 0);
        pen first = p, second = p;
        first.device = second.device = BAT_DEVICE_TOUCH;
        first.contact = 8;
        second.contact = 9;
        editor->input.pen_seen = false;
        pen_event(&first, BAT_POINTER_DOWN, 500, 500);
        if (pinch) pen_event(&second, BAT_POINTER_DOWN, 600, 500);
        check(editor);
        pen_event(&first, BAT_POINTER_CANCEL, 500, 500);
        if (pinch) pen_event(&second, BAT_POINTER_CANCEL, 600, 500);
        check(editor);
        assert_true(!bat_toolbox_busy(&editor->context));
        assert_int_equal(bat_ladder_levels(bat_leveling_of(&editor->context)->apart), levels);
        assert_int_equal(bat_editor_command(editor, "cancel"), BAT_OK);
        assert_false(bat_ladder_any(bat_leveling_of(&editor->context)->apart));
        bat_editor_free(editor);
    }
}

static void wild(void **state) {
    (void)state;
    static const char *const commands[] = {"tool-levels", "take-apart",  "accept",      "level-add",
                                           "level-up",    "level-down",  "levels-copy", "levels-flatten",
                                           "point-next",  "nudge-left",  "undo",        "redo",
                                           "tool-sketch", "tool-levels", "accept",      "tool-points"};
    static const char *const properties[] = {"apart-levels", "apart-points", "frame-rule",
                                             "show-frames",  "show-levels",  "level-sketch"};
    enum { SIZE = 900 };
    static uint8_t data[SIZE];
    int steps = 0;
    for (uint64_t seed = 1; seed <= 60; seed++) {
        session_bytes bytes = session_random(data, SIZE, &(uint64_t){seed * 99991});
        bat_editor *editor = seed % 2 ? levels_editor() : pen_editor();
        uint64_t first = digest(editor);
        double time = 0;
        bat_editor_command(editor, "tool-levels");
        while (bytes.at < bytes.size) {
            uint8_t what = session_byte(&bytes);
            if (what < 110) {
                bat_editor_command(editor, commands[session_byte(&bytes) % 16]);
                bat_editor_frame(editor);
            } else if (what < 140) {
                bat_editor_set(editor, properties[what % 6], session_byte(&bytes) % 30);
            } else if (what < 180) {
                uint8_t more = session_byte(&bytes);
                bat_editor_level(editor, (bat_level_act)(more % 4), more / 4 % 5, more / 32 * 0.5, more > 80);
                assert_non_null(bat_editor_levels(editor));
            } else {
                session_event(editor, &bytes, &time);
            }
            const char *wrong = bat_editor_check(editor);
            if (wrong) fail_msg("session %d, byte %zu: %s", (int)seed, bytes.at, wrong);
        }
        for (int i = 0; i < 3; i++) bat_editor_command(editor, "cancel");
        size_t size = 0;
        const char *text = bat_editor_journal(editor, &size);
        for (const char *at = text; (at = strstr(at, "\"kind\":\"shape\"")); at++) steps++;
        replays(editor, seed);
        while (bat_editor_command(editor, "redo") == BAT_OK) {
        }
        while (bat_editor_command(editor, "undo") == BAT_OK) assert_null(bat_editor_check(editor));
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
    if (steps < 60) fail_msg("only %d steps: these sessions do nothing", steps);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(taken_apart_when_accepted),
        cmocka_unit_test(a_level_is_dragged),
        cmocka_unit_test(alt_drags_along_the_normal),
        cmocka_unit_test(points_of_a_level),
        cmocka_unit_test(faders),
        cmocka_unit_test(keys_step_levels),
        cmocka_unit_test(a_level_is_redrawn),
        cmocka_unit_test(short_strokes_mean_finer_levels),
        cmocka_unit_test(rules_copies_and_flattening),
        cmocka_unit_test(a_spline_becomes_a_base),
        cmocka_unit_test(a_press_taken_away_keeps_the_choice),
        cmocka_unit_test(wild),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
