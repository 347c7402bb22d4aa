/* Surfaces in the levels tool and the strip: one is taken apart exactly, and only on confirmation; dragged at a level, the
 * place under the pen follows and the details of other levels stay; faders, mute, solo, copies of detail and flattening are
 * one step each; a line is redrawn at the active level; everything replays and can be undone. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "editor/editor.h"
#include "editor/tools/levels/state.h"
#include "support/editing.h"
#include "support/sheet.h"

enum { SIDE = 23, CARVED = 7, PLAIN = 8 };

/* A sheet over a square of the page, with fine waves of this height over a coarse one. */
static bat_surface *wavy(double x, double y, double side, double height) {
    double points[SIDE * SIDE * 3], knots[SIDE + 4];
    for (int i = 0; i < SIDE + 4; i++) knots[i] = fmin(fmax(i - 3, 0), SIDE - 3);
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            double *p = points + 3 * (i * SIDE + j);
            p[0] = x + side * i / (SIDE - 1), p[1] = y + side * j / (SIDE - 1);
            p[2] = 40 * sin(i / 8.0) + height * ((i + j) % 2 ? 1 : -1);
        }
    bat_surface *surface = NULL;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false},
                                        (const size_t[2]){SIDE, SIDE}, points,
                                        (const int[2]){SIDE + 4, SIDE + 4}, knots, knots, &surface),
                     BAT_OK);
    return surface;
}

/* Two sheets side by side, and a curve below them. */
static bat_editor *sheets(void) {
    bat_document *document = NULL;
    bat_surface *one = wavy(100, 100, 300, 6), *two = wavy(550, 100, 300, 0);
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){0, 0, 1000, 800});
    assert_int_equal(sheet_add(document, CARVED, one), BAT_OK);
    assert_int_equal(sheet_add(document, PLAIN, two), BAT_OK);
    bat_surface_free(one), bat_surface_free(two);
    pen_add(document, pen_curve(200, 700, 60, 0, 11));
    bat_editor *editor = editor_of(document);
    bat_editor_command(editor, "tool-levels");
    return editor;
}

static const bat_object *object_at(const bat_editor *editor, int index) {
    return bat_document_at(bat_editor_document(editor), index);
}
static const bat_relief *relief_at(const bat_editor *editor, int index) {
    return bat_object_relief(object_at(editor, index));
}
static const char *strip(bat_editor *editor) { return bat_editor_levels(editor); }

static double apart(const bat_surface *a, const bat_surface *b) {
    double most = 0;
    assert_int_equal(bat_surface_count(a, BAT_U), bat_surface_count(b, BAT_U));
    for (int i = 0; i < (int)bat_surface_count(a, BAT_U); i++)
        for (size_t k = 0; k < 3 * bat_surface_count(a, BAT_V); k++)
            most = fmax(most, fabs(bat_surface_row(a, i)[k] - bat_surface_row(b, i)[k]));
    return most;
}

/* The first sheet, taken apart into two levels, and chosen. */
static bat_editor *taken_apart(void) {
    bat_editor *editor = sheets();
    bat_editor_select(editor, CARVED, false);
    bat_editor_frame(editor);
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    bat_editor_set(editor, "apart-levels", 2);
    bat_editor_set(editor, "apart-points", 8);
    bat_editor_command(editor, "accept");
    bat_editor_frame(editor);
    check(editor);
    return editor;
}

static void apart_on_confirmation(void **state) {
    (void)state;
    bat_editor *editor = sheets();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    tap(&p, 250.3, 243.7); /* within the sheet, beside its lines */
    assert_non_null(strstr(strip(editor), "\"rows\":[],\"points\":529"));
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    bat_editor_frame(editor);
    assert_non_null(strstr(strip(editor), "\"apart\":1"));
    assert_non_null(strstr(strip(editor), "{\"points\":144,")); /* 12 by 12 */
    assert_true(digest(editor) == first);
    bat_editor_set(editor, "apart-levels", 2);
    bat_editor_set(editor, "apart-points", 8);
    bat_editor_frame(editor);
    assert_non_null(strstr(strip(editor), "{\"points\":64,"));
    assert_true(digest(editor) == first);
    bat_editor_command(editor, "cancel");
    assert_true(digest(editor) == first && !relief_at(editor, 0));
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    bat_editor_command(editor, "accept");
    bat_surface *wanted = wavy(100, 100, 300, 6);
    assert_non_null(relief_at(editor, 0));
    assert_true(apart(bat_object_surface(object_at(editor, 0)), wanted) < 1e-10);
    bat_surface_free(wanted);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

static void the_strip(void **state) {
    (void)state;
    bat_editor *editor = taken_apart();
    const uint64_t first = digest(editor);
    assert_non_null(strstr(strip(editor), "{\"points\":64,\"gain\":1,\"muted\":0,\"solo\":0,\"active\":1}"));
    bat_editor_level(editor, BAT_LEVEL_GAIN, 2, 1.2, false);
    check(editor);
    bat_editor_level(editor, BAT_LEVEL_GAIN, 2, 1.5, true);
    assert_true(bat_relief_gain(relief_at(editor, 0), 2) == 1.5);
    bat_editor_level(editor, BAT_LEVEL_MUTE, 1, 1, true);
    assert_true(bat_relief_is_muted(relief_at(editor, 0), 1));
    bat_editor_level(editor, BAT_LEVEL_MUTE, 1, 0, true);
    bat_editor_level(editor, BAT_LEVEL_SOLO, 1, 1, true);
    assert_true(bat_relief_is_muted(relief_at(editor, 0), 2) &&
                !bat_relief_is_muted(relief_at(editor, 0), 1));
    bat_editor_level(editor, BAT_LEVEL_SOLO, 1, 1, true);
    assert_true(!bat_relief_is_muted(relief_at(editor, 0), 2));
    bat_editor_level(editor, BAT_LEVEL_GAIN, 1, 0.3, false); /* let go */
    bat_editor_command(editor, "cancel");
    assert_true(bat_relief_gain(relief_at(editor, 0), 1) == 1);
    assert_int_equal(bat_editor_command(editor, "level-up"), BAT_OK);
    assert_non_null(strstr(strip(editor), "\"active\":1},{"));
    assert_int_equal(bat_editor_command(editor, "level-add"), BAT_OK);
    assert_int_equal(bat_relief_levels(relief_at(editor, 0)), 3);
    assert_int_equal(bat_editor_command(editor, "levels-flatten"), BAT_OK);
    assert_null(relief_at(editor, 0));
    check(editor);
    int steps = 0;
    while (digest(editor) != first && bat_editor_command(editor, "undo") == BAT_OK) steps++;
    assert_int_equal(steps, 7);
    bat_editor_free(editor);
}

/* The place under the pen follows, at the base and at a level; the details are those that they were. */
static void dragged(void **state) {
    (void)state;
    for (int level = 0; level < 2; level++) {
        bat_editor *editor = taken_apart();
        const uint64_t first = digest(editor);
        bat_relief *before = NULL;
        assert_int_equal(bat_relief_copy(relief_at(editor, 0), &before), BAT_OK);
        bat_editor_level(editor, BAT_LEVEL_CHOOSE, level, 0, true);
        pen p = pen_for(editor);
        double at[3], there[3];
        bat_surface_eval(bat_object_surface(object_at(editor, 0)), 9.6, 11.3, 0, at);
        drag(&p, at[0], at[1], at[0] + 42, at[1] - 33);
        const bat_relief *after = relief_at(editor, 0);
        assert_true(digest(editor) != first);
        bat_surface_eval(bat_object_surface(object_at(editor, 0)), 9.6, 11.3, 0, there);
        assert_true(fabs(there[0] - at[0] - 42) < 0.1 && fabs(there[1] - at[1] + 33) < 0.1);
        assert_true(fabs(there[2] - at[2]) < 0.1);
        for (int j = 1; j <= 2; j++) {
            const bat_surface *s = bat_relief_surface(before, j);
            const size_t n = 3 * bat_surface_count(s, BAT_U) * bat_surface_count(s, BAT_V);
            const bool same = !memcmp(bat_relief_details(before, j), bat_relief_details(after, j),
                                      n * sizeof(double));
            assert_true(same == (j != level));
        }
        assert_true(bat_surface_is_equal(bat_relief_surface(before, 0), bat_relief_surface(after, 0)) ==
                    (level > 0));
        drag_to(&p, at[0], at[1], at[0] - 60, at[1]); /* let go */
        bat_editor_command(editor, "cancel");
        pen_event(&p, BAT_POINTER_UP, at[0], at[1]);
        check(editor);
        bat_editor_command(editor, "undo");
        assert_true(digest(editor) == first);
        bat_relief_free(before);
        bat_editor_free(editor);
    }
}

static void detail_is_copied(void **state) {
    (void)state;
    bat_editor *editor = taken_apart();
    const uint64_t first = digest(editor);
    pen p = pen_for(editor);
    assert_int_equal(bat_editor_command(editor, "levels-copy"), BAT_OK);
    tap(&p, 200, 700); /* a curve takes none */
    assert_true(strstr(bat_editor_frame(editor)->notice, "surface to a surface") != NULL);
    assert_true(digest(editor) == first);
    bat_editor_select(editor, CARVED, false);
    assert_int_equal(bat_editor_command(editor, "levels-copy"), BAT_OK);
    tap(&p, 700.3, 243.3);
    assert_int_equal(bat_relief_levels(relief_at(editor, 1)), 2);
    /* Over a base of the same shape: the first sheet, put there, as both bases are nearly the same plane wave. */
    const bat_surface *copy = bat_object_surface(object_at(editor, 1));
    double most = 0;
    for (int i = 0; i < SIDE; i++)
        for (int j = 0; j < SIDE; j++) {
            double at[3], flat[3];
            bat_surface_eval(copy, i * 20.0 / 22, j * 20.0 / 22, 0, at);
            bat_surface_eval(bat_relief_surface(relief_at(editor, 1), 0), i * 20.0 / 22, j * 20.0 / 22, 0,
                             flat);
            most = fmax(most, fabs(at[2] - flat[2]));
        }
    assert_true(most > 1);
    bat_editor_command(editor, "undo");
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* The surface tool redraws the lit line at the level that is chosen in the strip. */
static void a_line_at_a_level(void **state) {
    (void)state;
    for (int level = 0; level < 2; level++) {
        bat_editor *editor = taken_apart();
        const uint64_t first = digest(editor);
        bat_relief *before = NULL;
        assert_int_equal(bat_relief_copy(relief_at(editor, 0), &before), BAT_OK);
        bat_editor_level(editor, BAT_LEVEL_CHOOSE, level, 0, true);
        assert_int_equal(bat_editor_command(editor, "tool-surface"), BAT_OK);
        bat_editor_frame(editor);
        assert_non_null(strstr(strip(editor), "{\"points\":64,"));
        bat_editor_set(editor, "line-ruling", 1); /* along x */
        pen p = pen_for(editor);
        drag(&p, 250, 160, 250, 340); /* lights the line */
        double at[3];
        bat_surface_eval(bat_relief_surface(before, level), 10, 10, 0, at);
        p.time += 1000;
        for (int i = 0; i <= 60; i++) {
            const double share = i / 60.0, y = 110 + 280 * share;
            pen_event(&p, i == 0 ? BAT_POINTER_DOWN : BAT_POINTER_MOVE,
                      250 + 30 * pow(sin(3.14159 * share), 3), y);
        }
        bat_editor_frame(editor);
        check(editor);
        pen_event(&p, BAT_POINTER_UP, 250, 390);
        bat_editor_frame(editor);
        check(editor);
        const bat_relief *after = relief_at(editor, 0);
        assert_non_null(after);
        if (digest(editor) == first) fail_msg("%s", bat_editor_frame(editor)->notice);
        double there[3];
        bat_surface_eval(bat_relief_surface(after, level), 10, 10, 0, there);
        assert_true(there[0] - at[0] > 20 && fabs(there[2] - at[2]) < 5);
        for (int j = 1; j <= 2; j++) {
            const bat_surface *s = bat_relief_surface(before, j);
            const size_t n = 3 * bat_surface_count(s, BAT_U) * bat_surface_count(s, BAT_V);
            const bool same = !memcmp(bat_relief_details(before, j), bat_relief_details(after, j),
                                      n * sizeof(double));
            assert_true(same == (j != level));
        }
        replays(editor, (uint64_t)level);
        bat_editor_command(editor, "undo");
        assert_true(digest(editor) == first);
        bat_relief_free(before);
        bat_editor_free(editor);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(apart_on_confirmation), cmocka_unit_test(the_strip),
                                       cmocka_unit_test(dragged), cmocka_unit_test(detail_is_copied),
                                       cmocka_unit_test(a_line_at_a_level)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
