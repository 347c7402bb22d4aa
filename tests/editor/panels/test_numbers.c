/* Numbers entered as text: positions, sizes, angles. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "editor/tools/modes/guides.h"
#include "support/precision.h"

static void expect_number(bat_editor *editor, const char *name, const char *text) {
    assert_string_equal(bat_editor_number(editor, name), text);
}

/* Each number becomes what is entered; all else of the box stays. One step each. */
static void numbers_are_entered(void **state) {
    (void)state;
    bat_curve *curves[] = {segment(100, 100, 300, 200), segment(400, 300, 600, 500)};
    bat_editor *editor = editor_with(2, curves);
    uint64_t first = digest(editor);
    double box[4];
    expect_number(editor, "x", "");
    assert_int_equal(bat_editor_enter(editor, "x", "1"), BAT_STATE);
    bat_editor_select(editor, 1, false);
    expect_number(editor, "x", "100 px");
    expect_number(editor, "width", "200 px");
    assert_int_equal(bat_editor_enter(editor, "x", "1in + 4"), BAT_OK);
    expect_number(editor, "x", "100 px"); /* it is there already: no step */
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_enter(editor, "x", "25,4mm"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "width", "50*2"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "height", "40"), BAT_OK);
    bat_object_bounds(bat_document_at(editor->session.document, 0), box);
    double expected[4] = {96, 100, 196, 140};
    for (int k = 0; k < 4; k++) assert_true(fabs(box[k] - expected[k]) < 1e-9);
    /* A quarter turn against the clock about (146, 120): the rising end comes to the upper left. */
    assert_int_equal(bat_editor_enter(editor, "turn", "90°"), BAT_OK);
    const double *p = bat_curve_points(bat_object_curve(bat_document_at(editor->session.document, 0), 0));
    assert_true(bat_hypot(p[0] - 126, p[1] - 170) < 1e-9 && bat_hypot(p[2] - 166, p[3] - 70) < 1e-9);
    static const char *const bad[] = {"", "wide", "1mm*1mm", "0"};
    uint64_t now = digest(editor);
    for (int i = 0; i < 4; i++) assert_int_not_equal(bat_editor_enter(editor, "width", bad[i]), BAT_OK);
    assert_int_not_equal(bat_editor_enter(editor, "x", "1e300"), BAT_OK);
    assert_int_not_equal(bat_editor_enter(editor, "x", "9999999999999999999999999999999999999999"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "nonsense", "1"), BAT_UNSUPPORTED);
    assert_int_equal(bat_editor_enter(editor, "snap", "1"), BAT_UNSUPPORTED); /* a switch is no number */
    assert_true(digest(editor) == now);
    /* A level line has no height to scale. */
    bat_guide_put(&editor->context, 0, 1, 77);
    bat_editor_set(editor, "unit", 2);
    assert_int_equal(bat_editor_enter(editor, "guide", "2"), BAT_OK);
    expect_number(editor, "guide", "2 in");
    double at = 0;
    assert_true(guides(editor, 1, &at) == 1 && at == 192);
    assert_int_equal(bat_editor_enter(editor, "grid-spacing", "1/4"), BAT_OK);
    assert_int_equal(bat_editor_get(editor, "grid-spacing", &at), BAT_OK);
    assert_true(at == 24);
    expect_number(editor, "grid-spacing", "0.25 in");
    bat_editor_set(editor, "unit", 0);
    /* A control point of the other line. */
    bat_editor_command(editor, "deselect");
    bat_editor_command(editor, "tool-points");
    pen m = mouse(editor);
    for (int i = 0; i < 2; i++) { /* the line, then its end */
        double x = i ? 600 : 500, y = i ? 500 : 400;
        pen_event(&m, BAT_POINTER_DOWN, x, y);
        pen_event(&m, BAT_POINTER_UP, x, y);
        m.time += 1000;
    }
    expect_number(editor, "point-x", "600 px");
    assert_int_equal(bat_editor_enter(editor, "point-x", "640.5"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "point-y", "480"), BAT_OK);
    int index = bat_document_find(editor->session.document, 2);
    p = bat_curve_points(bat_object_curve(bat_document_at(editor->session.document, index), 0));
    assert_true(p[2] == 640.5 && p[3] == 480 && p[0] == 400 && p[1] == 300);
    /* Not while something is dragged. */
    pen_event(&m, BAT_POINTER_DOWN, 640.5, 480);
    pen_event(&m, BAT_POINTER_MOVE, 700, 480);
    assert_int_equal(bat_editor_enter(editor, "point-x", "1"), BAT_STATE);
    bat_editor_command(editor, "cancel");
    pen_event(&m, BAT_POINTER_UP, 700, 480);
    /* A point of a spline. */
    bat_editor_command(editor, "tool-tangents");
    for (int i = 0; i < 3; i++) {
        pen_event(&m, BAT_POINTER_DOWN, 700 + 60 * i, 700 - 40 * (i & 1));
        pen_event(&m, BAT_POINTER_UP, 700 + 60 * i, 700 - 40 * (i & 1));
        m.time += 1000;
    }
    assert_int_equal(bat_editor_enter(editor, "point-y", "650"), BAT_OK);
    expect_number(editor, "point-y", "650 px");
    round_trip(editor, first);
    bat_editor_free(editor);
}

/* Lengths are those of the drawing's own scale, in the unit that it says: however many millimetres a unit is, 2 in are 50.8. */
static void real_sizes(void **state) {
    (void)state;
    static const struct {
        bat_unit unit;
        double scale;
        const char *whole, *typed;
    } cases[] = {{BAT_UNIT_MM, 1, "200 mm", "50.8 mm"},
                 {BAT_UNIT_CM, 1 / 3.78, "52.91 mm", "50.8 mm"},
                 {BAT_UNIT_IN, 25.4, "200 in", "2 in"},
                 {BAT_UNIT_PT, 25.4 / 72, "70.556 mm", "50.8 mm"},
                 {BAT_UNIT_PX, 25.4 / 96 / 2, "100 px", "192 px"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_curve *curves[] = {segment(100, 100, 300, 200)};
        bat_editor *editor = editor_with(1, curves);
        bat_document *document = NULL;
        double box[4];
        assert_int_equal(bat_document_copy(editor->session.document, &document), BAT_OK);
        assert_int_equal(bat_document_set_scale(document, cases[i].scale, cases[i].unit), BAT_OK);
        assert_int_equal(bat_editor_open(editor, document, ""), BAT_OK);
        bat_editor_select(editor, 1, false);
        expect_number(editor, "width", cases[i].whole);
        assert_int_equal(bat_editor_enter(editor, "width", "1in + 2.54cm"), BAT_OK);
        bat_object_bounds(bat_document_at(editor->session.document, 0), box);
        assert_true(fabs((box[2] - box[0]) * cases[i].scale - 50.8) < 1e-9);
        expect_number(editor, "width", cases[i].typed);
        assert_int_equal(bat_editor_enter(editor, "width", "6pc"), BAT_OK);
        bat_object_bounds(bat_document_at(editor->session.document, 0), box);
        assert_true(fabs((box[2] - box[0]) * cases[i].scale - 25.4) < 1e-9);
        expect_number(editor, "missed", "");
        assert_true(bat_document_unit(editor->session.document) == cases[i].unit);
        bat_editor_free(editor);
    }
}

/* Heights are numbers once the view is tilted or the drawing has space, in the unit of the drawing; each is a step. */
static void heights_are_entered(void **state) {
    (void)state;
    bat_curve *curves[] = {segment(100, 100, 300, 200), segment(400, 300, 600, 500)};
    bat_editor *editor = editor_with(2, curves);
    const uint64_t first = digest(editor);
    bat_editor_set(editor, "unit", 1);
    bat_editor_select(editor, 1, false);
    expect_number(editor, "z", "");
    expect_number(editor, "depth", "");
    assert_int_equal(bat_editor_enter(editor, "z", "1"), BAT_STATE);
    bat_editor_command(editor, "orbit-up");
    expect_number(editor, "z", "0 mm");
    assert_int_equal(bat_editor_enter(editor, "depth", "2"), BAT_STATE); /* it is flat */
    assert_int_equal(bat_editor_enter(editor, "z", "-25.4"), BAT_OK);
    expect_number(editor, "z", "-25.4 mm");
    expect_number(editor, "depth", "0 mm");
    bat_editor_command(editor, "view-upright");
    bat_editor_select(editor, 2, true); /* on the page: the two are as deep as they are apart */
    expect_number(editor, "z", "-25.4 mm");
    expect_number(editor, "depth", "25.4 mm");
    const uint64_t now = digest(editor);
    static const char *const bad[] = {"", "deep", "-3", "0", "1e300"};
    for (int i = 0; i < 5; i++) assert_int_not_equal(bat_editor_enter(editor, "depth", bad[i]), BAT_OK);
    assert_true(digest(editor) == now);
    assert_int_equal(bat_editor_enter(editor, "depth", "1in * 2"), BAT_OK); /* from its lowest z on */
    expect_number(editor, "z", "-25.4 mm");
    expect_number(editor, "depth", "50.8 mm");
    const bat_curve *page = bat_object_curve(bat_document_at(editor->session.document, 1), 0);
    const double *p = bat_curve_points(page);
    assert_int_equal(bat_curve_dimension(page), 3);
    assert_true(fabs(p[2] - 96) < 1e-9 && p[0] == 400 && p[1] == 300);
    assert_int_equal(round_trip(editor, first), 2);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(real_sizes),
        cmocka_unit_test(numbers_are_entered),
        cmocka_unit_test(heights_are_entered),
    };
    return cmocka_run_group_tests_name("numbers", tests, NULL, NULL);
}
