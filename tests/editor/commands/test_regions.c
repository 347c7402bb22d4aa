/* Unite, subtract, intersect and exclude in the editor. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"
#include <batten/panels.h>
#include <batten/measure.h>
#include <batten/region.h>

#include <math.h>
#include <string.h>

static bat_curve *box_at(double x, double y, double side) {
    const double points[8] = {x, y, x + side, y, x + side, y + side, x, y + side}, knots[5] = {0, 1, 2, 3, 4};
    bat_curve *curve;
    assert_int_equal(bat_curve_create(2, 1, true, 4, points, 5, knots, &curve), BAT_OK);
    return curve;
}

static bat_curve *line(void) {
    const double points[4] = {0, 700, 900, 700};
    bat_curve *curve;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &curve), BAT_OK);
    return curve;
}

/* Boxes of 200 at 100 (1) and 200 (2), one within the first (3), one far away (4), an open line (5). */
static bat_editor *boxes(void) {
    bat_curve *curves[5] = {box_at(100, 100, 200), box_at(200, 200, 200), box_at(120, 120, 40),
                            box_at(600, 100, 50), line()};
    bat_editor *editor = editor_with(5, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static double area(const bat_object *object) {
    double sum = 0;
    for (int i = 0; i < bat_object_curve_count(object); i++)
        sum += bat_curve_area(bat_object_curve(object, i));
    return sum;
}

static void four_operations(void **state) {
    (void)state;
    static const struct {
        const char *name;
        double area;
        int curves;
    } cases[] = {{"region-unite", 70000, 1},
                 {"region-subtract", 30000, 1},
                 {"region-intersect", 10000, 1},
                 {"region-exclude", 60000, 2}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_editor *editor = boxes();
        const uint64_t first = digest(editor);
        only(editor, 2, 1); /* the order of choosing does not matter: the lowest is first */
        assert_int_equal(bat_editor_command(editor, cases[i].name), BAT_OK);
        assert_string_equal(order(editor), "1 3 4 5");
        assert_true(has(editor, 1) && selected(editor) == 1);
        assert_true(fabs(area(object(editor, 1)) - cases[i].area) < 1e-6);
        assert_int_equal(bat_object_curve_count(object(editor, 1)), cases[i].curves);
        assert_null(bat_editor_check(editor));
        goes_back_and_replays(editor, first);
        bat_editor_free(editor);
    }
}

static void holes_and_three(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 1, 3);
    assert_int_equal(bat_editor_command(editor, "region-subtract"), BAT_OK);
    assert_int_equal(bat_object_curve_count(object(editor, 1)), 2);
    assert_true(fabs(area(object(editor, 1)) - 38400) < 1e-6);
    bat_editor_select(editor, 2, true);
    bat_editor_select(editor, 4, true);
    assert_int_equal(bat_editor_command(editor, "region-unite"), BAT_OK);
    assert_string_equal(order(editor), "1 5");
    assert_true(fabs(area(object(editor, 1)) - 38400 - 30000 - 2500) < 1e-6);
    bat_editor_free(editor);
}

/* What cannot be done says so and changes nothing. */
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
    bat_editor_command(editor, "deselect");
    refused(editor, "region-unite", BAT_STRING_NOTICE_SELECT_REGIONS);
    only(editor, 1, 0);
    refused(editor, "region-unite", BAT_STRING_NOTICE_SELECT_REGIONS);
    only(editor, 1, 5);
    refused(editor, "region-subtract", BAT_STRING_NOTICE_SELECT_REGIONS);
    only(editor, 1, 4);
    refused(editor, "region-intersect", BAT_STRING_NOTICE_REGION_EMPTY);
    bat_editor_free(editor);
}

static void offered_where_they_fit(void **state) {
    (void)state;
    bat_editor *editor = boxes();
    only(editor, 1, 2);
    assert_non_null(strstr(bat_editor_actions(editor), "region-unite"));
    only(editor, 1, 5);
    assert_null(strstr(bat_editor_actions(editor), "region-unite"));
    only(editor, 1, 0);
    assert_null(strstr(bat_editor_actions(editor), "region-unite"));
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(four_operations),
        cmocka_unit_test(holes_and_three),
        cmocka_unit_test(what_cannot_be_done),
        cmocka_unit_test(offered_where_they_fit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
