/* Offset and Outline the stroke in the editor: areas of closed forms, holes, sides, many at once, what cannot be done; dashes,
 * the fill rule, what is mixed, what looks the same, zoom to the selection. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"
#include <batten/measure.h>
#include <batten/paint.h>
#include <batten/panels.h>

#include <math.h>
#include <string.h>

static bat_curve *box_at(double x, double y, double side) {
    const double points[8] = {x, y, x + side, y, x + side, y + side, x, y + side}, knots[5] = {0, 1, 2, 3, 4};
    bat_curve *curve;
    assert_int_equal(bat_curve_create(2, 1, true, 4, points, 5, knots, &curve), BAT_OK);
    return curve;
}

static bat_curve *line(void) {
    const double points[4] = {100, 700, 900, 700};
    bat_curve *curve;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &curve), BAT_OK);
    return curve;
}

/* Boxes of 200 at 100 (1), of 40 within it (2), far away (3: of 50), an open line (4). */
static bat_editor *boxes(void) {
    bat_curve *curves[4] = {box_at(100, 100, 200), box_at(180, 180, 40), box_at(600, 100, 50), line()};
    bat_editor *editor = editor_with(4, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static double area(const bat_object *object) {
    double sum = 0;
    for (int i = 0; i < bat_object_curve_count(object); i++)
        sum += bat_curve_area(bat_object_curve(object, i));
    return sum;
}

static void set(bat_editor *editor, const char *property, double value) {
    assert_int_equal(bat_editor_set(editor, property, value), BAT_OK);
    assert_null(bat_editor_check(editor));
}

static double got(bat_editor *editor, const char *property) {
    double value;
    assert_int_equal(bat_editor_get(editor, property, &value), BAT_OK);
    return value;
}

static void runs(bat_editor *editor, const char *command) {
    assert_int_equal(bat_editor_command(editor, command), BAT_OK);
    assert_null(bat_editor_check(editor));
}

static void offset(bat_editor *editor) {
    runs(editor, "curve-offset");
    runs(editor, "accept");
}

static void offsets_of_closed_curves(void **state) {
    (void)state;
    static const struct {
        double side, join, area;
        const char *order;
    } cases[] = {{0, BAT_JOIN_MITER, 220.0 * 220, "5 1 2 3 4"},
                 {1, BAT_JOIN_MITER, 180.0 * 180, "1 5 2 3 4"},
                 {0, BAT_JOIN_BEVEL, 220.0 * 220 - 200, "5 1 2 3 4"},
                 {0, BAT_JOIN_ROUND, 200.0 * 200 + 8000 + 3.14159265358979 * 100, "5 1 2 3 4"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_editor *editor = boxes();
        only(editor, 1, 0);
        set(editor, "stroke-join", cases[i].join);
        const uint64_t first = digest(editor);
        set(editor, "offset-side", cases[i].side);
        offset(editor);
        assert_string_equal(order(editor), cases[i].order);
        assert_true(has(editor, 5) && selected(editor) == 1);
        assert_true(fabs(area(object(editor, 5)) - cases[i].area) < 0.5);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        assert_true(digest(editor) == first);
        bat_editor_free(editor);
    }
}

/* A frame: its hole shrinks as it grows, and closes. */
static void holes_go_along(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 1, 2);
    runs(editor, "combine");
    set(editor, "stroke-join", BAT_JOIN_MITER);
    const uint64_t first = digest(editor);
    offset(editor);
    assert_true(fabs(area(object(editor, 5)) - (220.0 * 220 - 20.0 * 20)) < 0.5);
    only(editor, 1, 0);
    set(editor, "offset-distance", 25);
    offset(editor); /* no hole of 40 is left */
    assert_int_equal(bat_object_curve_count(object(editor, 6)), 1);
    assert_true(fabs(area(object(editor, 6)) - 250.0 * 250) < 0.5);
    while (bat_editor_command(editor, "undo") == BAT_OK && digest(editor) != first) {
    }
    assert_true(digest(editor) == first);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void many_and_open_ones(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    const uint64_t first = digest(editor);
    runs(editor, "select-all");
    set(editor, "offset-side", 2);
    offset(editor);
    assert_int_equal(bat_document_count(editor->session.document), 8);
    assert_int_equal(selected(editor), 4);
    int curves = 0;
    for (bat_id id = 5; id <= 8; id++) curves += bat_object_curve_count(object(editor, id));
    assert_int_equal(curves, 8);
    goes_back_and_replays(editor, first);
    only(editor, 4, 0);
    set(editor, "offset-side", 0); /* left of a line that runs to the right is above it */
    offset(editor);
    double box[4];
    box_of(editor, 9, box);
    assert_true(fabs(box[1] - 690) < 1e-6 && fabs(box[3] - 690) < 1e-6);
    bat_editor_free(editor);
}

static void strokes_become_shapes(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 4, 0);
    set(editor, "stroke-width", 20);
    set(editor, "stroke-colour", 0x336699FF);
    const uint64_t first = digest(editor);
    static const struct {
        double cap, area;
    } cases[] = {{BAT_CAP_BUTT, 16000}, {BAT_CAP_SQUARE, 16400}, {BAT_CAP_ROUND, 16000 + 314.159265358979}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        set(editor, "stroke-cap", cases[i].cap);
        runs(editor, "curve-outline");
        const bat_style *style = bat_object_style(object(editor, 4));
        assert_true(!style->stroked && style->filled && style->fill == 0x336699FF);
        assert_true(fabs(area(object(editor, 4)) - cases[i].area) < 0.5);
        assert_true(has(editor, 4) && selected(editor) == 1);
        runs(editor, "undo");
    }
    set(editor, "stroke-cap", BAT_CAP_ROUND);
    assert_true(digest(editor) == first);
    only(editor, 1, 0); /* what is filled keeps its fill, below */
    set(editor, "filled", 1);
    set(editor, "stroke-join", BAT_JOIN_MITER);
    set(editor, "stroke-width", 20);
    runs(editor, "curve-outline");
    assert_string_equal(order(editor), "1 5 2 3 4");
    assert_true(!bat_object_style(object(editor, 1))->stroked && bat_object_style(object(editor, 1))->filled);
    assert_true(fabs(area(object(editor, 5)) - (220.0 * 220 - 180.0 * 180)) < 0.5);
    replays(editor, 0);
    bat_editor_free(editor);
}

/* Chosen while nothing is selected, they are those of what is made next: by a stroke, by a shape, by a spline. */
static void new_curves_are_dashed(void **state) {
    (void)state;
    bat_editor *editor = select_editor();
    pen p = mouse(editor);
    bat_editor_command(editor, "deselect");
    set(editor, "dashes", 4); /* no pattern by name */
    assert_true(got(editor, "dashes") == 0);
    set(editor, "stroke-width", 5);
    set(editor, "dashes", 1);
    assert_true(got(editor, "dashes") == 1);
    static const char *const tools[] = {"tool-sketch", "tool-line", "tool-rectangle", "tool-tangents"};
    for (size_t i = 0; i < sizeof tools / sizeof *tools; i++) {
        const int count = bat_document_count(bat_editor_document(editor));
        bat_editor_command(editor, tools[i]);
        bat_editor_command(editor, "deselect");
        drag(&p, 250, 300 + 60 * (double)i, 700, 330 + 60 * (double)i);
        if (i == 3) drag(&p, 600, 520, 620, 500);
        bat_editor_command(editor, "accept");
        check(editor);
        if (bat_document_count(bat_editor_document(editor)) != count + 1) fail_msg("%s", tools[i]);
        const bat_paint *paint = bat_object_paint(bat_document_at(bat_editor_document(editor), count));
        if (!paint || paint->dash_count != 2) fail_msg("%s", tools[i]);
        assert_true(paint->dashes[0] == 15);
    }
    replays(editor, 0);
    bat_editor_command(editor, "tool-select");
    bat_editor_command(editor, "deselect");
    set(editor, "dashes", 0);
    bat_editor_command(editor, "tool-line");
    drag(&p, 250, 700, 700, 720);
    const bat_document *document = bat_editor_document(editor);
    const bat_paint *paint = bat_object_paint(bat_document_at(document, bat_document_count(document) - 1));
    assert_true(!paint || !paint->dash_count);
    bat_editor_free(editor);
}

static void dashes_have_names(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 4, 0);
    set(editor, "stroke-width", 10);
    set(editor, "stroke-cap", BAT_CAP_BUTT);
    const uint64_t first = digest(editor);
    assert_true(got(editor, "dashes") == 0);
    set(editor, "dashes", 1);
    assert_true(got(editor, "dashes") == 1);
    const bat_paint *paint = bat_object_paint(object(editor, 4));
    assert_true(paint->dash_count == 2 && paint->dashes[0] == 40 && paint->dashes[1] == 20);
    set(editor, "stroke-width", 20); /* the dashes grow with it */
    assert_true(got(editor, "dashes") == 1 && bat_object_paint(object(editor, 4))->dashes[0] == 80);
    runs(editor, "curve-outline"); /* 800 long: dashes of 80, gaps of 40: seven, the last of 80 */
    assert_int_equal(bat_object_curve_count(object(editor, 4)), 7);
    assert_true(fabs(area(object(editor, 4)) - 7 * 80 * 20) < 1);
    assert_null(bat_object_paint(object(editor, 4)));
    for (int i = 0; i < 3; i++) runs(editor, "undo");
    assert_true(digest(editor) == first);
    set(editor, "dashes", 4); /* as they are: none */
    assert_true(digest(editor) == first && got(editor, "dashes") == 0);
    set(editor, "dashes", 3);
    set(editor, "dashes", 0);
    assert_true(digest(editor) == first);
    replays(editor, 0);
    bat_editor_free(editor);
}

static void fill_rules(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 1, 2);
    runs(editor, "combine");
    assert_true(got(editor, "fill-rule") == 1);
    const uint64_t first = digest(editor);
    set(editor, "fill-rule", 0);
    assert_false(bat_object_style(object(editor, 1))->even_odd);
    runs(editor, "undo");
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

static void mixed_and_same(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    assert_string_equal(bat_editor_mixed(editor), "");
    only(editor, 1, 0);
    set(editor, "stroke-colour", 0xFF0000FF);
    assert_string_equal(bat_editor_mixed(editor), "");
    only(editor, 1, 2);
    assert_string_equal(bat_editor_mixed(editor), "stroke-colour");
    only(editor, 2, 0);
    set(editor, "filled", 1);
    only(editor, 1, 2);
    assert_string_equal(bat_editor_mixed(editor), "stroke-colour filled");
    only(editor, 3, 0);
    runs(editor, "select-same-stroke");
    assert_true(selected(editor) == 3 && has(editor, 2) && has(editor, 4));
    only(editor, 3, 0);
    runs(editor, "select-same-fill");
    assert_true(selected(editor) == 3 && has(editor, 1) && !has(editor, 2));
    only(editor, 3, 0);
    runs(editor, "select-same-style");
    assert_true(selected(editor) == 2 && has(editor, 3) && has(editor, 4));
    bat_editor_set_state(editor, 4, true, false); /* what is hidden is left out */
    only(editor, 3, 0);
    runs(editor, "select-same-style");
    assert_int_equal(selected(editor), 1);
    runs(editor, "deselect");
    assert_int_equal(bat_editor_command(editor, "select-same-style"), BAT_STATE);
    bat_editor_free(editor);
}

static void same_width_kind_and_name(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    const int all = bat_document_count(bat_editor_document(editor));
    only(editor, 1, 3);
    set(editor, "stroke-width", 7);
    set(editor, "stroke-colour", 0xFF0000FF);
    only(editor, 3, 0);
    set(editor, "stroke-colour", 255); /* another colour, as wide */
    runs(editor, "select-same-width");
    assert_true(selected(editor) == 2 && has(editor, 1) && has(editor, 3));
    runs(editor, "group");
    const bat_id group = bat_object_parent(object(editor, 1));
    runs(editor, "select-same-kind");
    assert_true(selected(editor) == 1 && has(editor, group));
    only(editor, 2, 0);
    runs(editor, "select-same-kind");
    assert_int_equal(selected(editor), all);
    assert_false(has(editor, group));
    only(editor, 2, 0);
    assert_int_equal(bat_editor_rename(editor, 2, ""), BAT_OK);
    assert_int_equal(bat_editor_command(editor, "select-same-name"), BAT_STATE);
    assert_string_equal(bat_editor_frame(editor)->notice, bat_string_english(BAT_STRING_NOTICE_NO_NAME));
    static const char *const names[] = {"leaf", "leaf 12", "leaf-3", "leaflet 1"};
    for (bat_id id = 1; id <= 4; id++) assert_int_equal(bat_editor_rename(editor, id, names[id - 1]), BAT_OK);
    only(editor, 2, 0);
    runs(editor, "select-same-name");
    assert_true(selected(editor) == 3 && !has(editor, 4));
    assert_int_equal(bat_editor_rename(editor, 4, "12"), BAT_OK); /* a number alone is a name */
    assert_int_equal(bat_editor_rename(editor, 1, "13"), BAT_OK);
    only(editor, 4, 0);
    runs(editor, "select-same-name");
    assert_int_equal(selected(editor), 1);
    only(editor, 2, 0);
    assert_int_equal(bat_editor_set_state(editor, 3, false, true), BAT_OK); /* what is locked is left out */
    runs(editor, "select-same-name");
    assert_int_equal(selected(editor), 1);
    bat_editor_free(editor);
}

static void zoom_to_selection(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 3, 0);
    runs(editor, "view-selection");
    bat_editor_frame(editor);
    const bat_view *view = &editor->stage.view;
    double at[2];
    bat_view_to_document(view, (double[]){view->width / 2, view->height / 2}, at);
    assert_true(fabs(at[0] - 625) < 1e-6 && fabs(at[1] - 125) < 1e-6);
    assert_true(50 * view->zoom > 0.5 * fmin(view->width, view->height));
    runs(editor, "deselect");
    assert_int_equal(bat_editor_command(editor, "view-selection"), BAT_STATE);
    bat_editor_free(editor);
}

static void refused(bat_editor *editor, const char *command, bat_string why) {
    const uint64_t before = digest(editor);
    assert_int_equal(bat_editor_command(editor, command), BAT_STATE);
    assert_string_equal(bat_editor_frame(editor)->notice, bat_string_english(why));
    assert_true(digest(editor) == before);
    assert_null(bat_editor_check(editor));
}

static void what_cannot_be_done(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    refused(editor, "curve-offset", BAT_STRING_NOTICE_SELECT_FLAT);
    refused(editor, "curve-outline", BAT_STRING_NOTICE_SELECT_STROKED);
    only(editor, 3, 0);
    assert_true(has(editor, 3) && selected(editor) == 1);
    set(editor, "stroked", 0);
    refused(editor, "curve-outline", BAT_STRING_NOTICE_SELECT_STROKED);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(offsets_of_closed_curves),
        cmocka_unit_test(holes_go_along),
        cmocka_unit_test(many_and_open_ones),
        cmocka_unit_test(strokes_become_shapes),
        cmocka_unit_test(dashes_have_names),
        cmocka_unit_test(new_curves_are_dashed),
        cmocka_unit_test(fill_rules),
        cmocka_unit_test(mixed_and_same),
        cmocka_unit_test(same_width_kind_and_name),
        cmocka_unit_test(zoom_to_selection),
        cmocka_unit_test(what_cannot_be_done),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
