/*
 * With "Class A" on, new lines have degree 5 and everything else takes them as they are: redraws keep the degree, with
 * the setting on or off; careless strokes converge to such a line; points and levels act on it; files and the journal
 * bring it back, and the path of an SVG file lies on it.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include "support/editing.h"

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

static const bat_curve *line(const bat_editor *editor, int object) {
    return bat_object_curve(bat_document_at(bat_editor_document(editor), object), 0);
}

static bool journal_has(const bat_editor *editor, const char *text) {
    return strstr(bat_editor_journal(editor, NULL), text) != NULL;
}

static bat_editor *class_a(pen *p) {
    bat_editor *editor = editor_with(0, NULL);
    *p = pen_for(editor);
    assert_int_equal(bat_editor_set(editor, "class-a", 1), BAT_OK);
    pen_line(p, 200, 400, 800, 400, 60);
    check(editor);
    assert_int_equal(count(editor), 1);
    return editor;
}

static void new_lines_only(void **state) {
    (void)state;
    pen p;
    bat_editor *editor = class_a(&p);
    assert_int_equal(bat_curve_degree(line(editor, 0)), 5);
    assert_true(journal_has(editor, "\"degree\":5"));
    assert_int_equal(bat_editor_set(editor, "class-a", 0), BAT_OK);
    p.time += 5000;
    pen_line(&p, 380, 372, 620, 372, 40); /* redraws its middle */
    assert_int_equal(count(editor), 1);
    assert_int_equal(bat_curve_degree(line(editor, 0)), 5);
    p.time += 5000;
    pen_line(&p, 200, 700, 800, 700, 30);
    assert_int_equal(count(editor), 2);
    assert_int_equal(bat_curve_degree(line(editor, 1)), 3);
    assert_int_equal(bat_editor_set(editor, "class-a", 1), BAT_OK);
    p.time += 5000;
    pen_line(&p, 380, 675, 620, 675, 20);
    assert_int_equal(count(editor), 2);
    assert_int_equal(bat_curve_degree(line(editor, 1)), 3);
    bat_editor *again = replay_of(editor, 0);
    assert_int_equal(bat_curve_degree(line(again, 0)), 5);
    bat_editor_free(again);
    bat_editor_free(editor);
}

static void careless_strokes_too(void **state) {
    (void)state;
    pen p;
    bat_editor *editor = class_a(&p);
    for (int i = 0; i < 3; i++) pen_line(&p, 210 + 5 * i, 396 + 3 * i, 790, 404 - 3 * i, 60);
    assert_int_equal(count(editor), 1);
    assert_true(journal_has(editor, "converge"));
    assert_int_equal(bat_curve_degree(line(editor, 0)), 5);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void wavy(double t, const double *n, double out[2]) {
    (void)n;
    out[0] = 100 + 800 * t;
    out[1] = 200 + 25 * sin(30 * t) + 40 * sin(4 * t);
}

static void points_and_levels_act_on_it(void **state) {
    (void)state;
    bat_editor *editor = editor_with(0, NULL);
    pen p = pen_for(editor);
    assert_int_equal(bat_editor_set(editor, "class-a", 1), BAT_OK);
    pen_stroke(&p, wavy, NULL, 300);
    check(editor);
    const uint64_t drawn = digest(editor);
    bat_editor_command(editor, "select-all");
    bat_editor_command(editor, "tool-points");
    bat_editor_command(editor, "point-next");
    bat_editor_command(editor, "point-next");
    assert_int_equal(bat_editor_command(editor, "nudge-up"), BAT_OK);
    assert_true(digest(editor) != drawn);
    assert_int_equal(bat_curve_degree(line(editor, 0)), 5);
    bat_editor_command(editor, "undo");
    assert_int_equal(bat_editor_command(editor, "take-apart"), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "accept"), BAT_OK);
    check(editor);
    assert_true(digest(editor) != drawn);
    assert_int_equal(bat_curve_degree(line(editor, 0)), 5);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void files_bring_it_back(void **state) {
    (void)state;
    pen p;
    bat_editor *editor = class_a(&p);
    const bat_document *document = bat_editor_document(editor);
    const bat_curve *curve = line(editor, 0);
    char *text = NULL;
    size_t size = 0;
    bat_problem problem = {"", ""};
    bat_document *read = NULL;
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    assert_int_equal(bat_document_read(text, size, &read, &problem), BAT_OK);
    assert_true(bat_document_digest(read) == bat_document_digest(document));
    bat_document_free(read);
    bat_free(text);
    /* The path in SVG: cubics that stay by it, end to end, within what the writer allows. */
    int cubics = 0;
    double *points = NULL, worst = 0;
    const double allowed = 1e-5;
    assert_int_equal(bat_curve_to_cubics(curve, allowed, &cubics, &points), BAT_OK);
    for (int i = 0; i < cubics; i++)
        for (int j = 0; j <= 20; j++) {
            const double t = j / 20.0, s = 1 - t, *b = points + (size_t)(8 * i);
            double x[2];
            bat_near near;
            for (int k = 0; k < 2; k++)
                x[k] = s * s * s * b[k] + 3 * s * s * t * b[2 + k] + 3 * s * t * t * b[4 + k] +
                       t * t * t * b[6 + k];
            assert_int_equal(bat_curve_nearest(curve, x, &near), BAT_OK);
            worst = fmax(worst, near.distance);
        }
    assert_true(worst <= allowed);
    bat_free(points);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(new_lines_only), cmocka_unit_test(careless_strokes_too),
        cmocka_unit_test(points_and_levels_act_on_it), cmocka_unit_test(files_bring_it_back)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
