/*
 * Arrays: where each copy lies, by closed forms, in a row, a grid and on a circle; the drawing stays as it is to the bit until they are
 * kept, which is one step; what can not be made says why.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "editor/editor.h"
#include "support/selecting.h"
#include <batten/panels.h>
#include <math.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

static bat_curve *box_at(double x, double y, double width, double height) {
    const double points[8] = {x, y, x + width, y, x + width, y + height, x, y + height};
    const double knots[5] = {0, 1, 2, 3, 4};
    bat_curve *curve;
    assert_int_equal(bat_curve_create(2, 1, true, 4, points, 5, knots, &curve), BAT_OK);
    return curve;
}

/* 100 x 40 at 100, 200 (1), 20 x 20 at 400, 500 (2), and an upright line at x = 700 (3). */
static bat_editor *things(void) {
    const double points[4] = {700, 300, 700, 350};
    bat_curve *line;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &line), BAT_OK);
    bat_curve *curves[3] = {box_at(100, 200, 100, 40), box_at(400, 500, 20, 20), line};
    bat_editor *editor = editor_with(3, curves);
    assert_int_equal(bat_editor_command(editor, "tool-select"), BAT_OK);
    return editor;
}

static void runs(bat_editor *editor, const char *command) {
    const bat_status status = bat_editor_command(editor, command);
    if (status != BAT_OK) fail_msg("%s: %d", command, (int)status);
    check(editor);
}

static void set(bat_editor *editor, const char *property, double value) {
    if (bat_editor_set(editor, property, value) != BAT_OK) fail_msg("%s %g", property, value);
    check(editor);
}

static void says(bat_editor *editor, const char *words) {
    const char *readings = bat_editor_readings(editor);
    if (!strstr(readings, words)) fail_msg("%s, not %s", readings, words);
}

static bool shows(bat_editor *editor) { return pen_live(bat_editor_frame(editor), BAT_ROLE_FIT) != NULL; }

static int count(const bat_editor *editor) { return bat_document_count(bat_editor_document(editor)); }

/* The point k of the curve that is `after` the object in the list. */
static const double *point(const bat_editor *editor, bat_id id, int after, int k) {
    const bat_document *document = bat_editor_document(editor);
    const bat_object *made = bat_document_at(document, bat_document_find(document, id) + after);
    return bat_curve_points(bat_object_curve(made, 0)) + (ptrdiff_t)2 * k;
}

static void lies(const bat_editor *editor, bat_id id, int after, int k, double x, double y) {
    const double *p = point(editor, id, after, k);
    if (!(hypot(p[0] - x, p[1] - y) < 1e-9))
        fail_msg("copy %d, point %d: %.12g %.12g, not %.12g %.12g", after, k, p[0], p[1], x, y);
}

static void a_row(void **state) {
    (void)state;
    bat_editor *editor = things();
    const uint64_t first = digest(editor);
    only(editor, 1, 0);
    runs(editor, "array");
    says(editor, "\"of\":\"array\"");
    says(editor, "\"chosen\":0,");
    says(editor, "\"typed\":\"array-count array-gap array-direction\",\"ways\":3,\"said\":\"\"");
    assert_true(shows(editor));
    assert_int_equal(bat_editor_enter(editor, "array-count", "5"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "array-gap", "12.5"), BAT_OK);
    assert_true(digest(editor) == first && count(editor) == 3);
    runs(editor, "accept");
    assert_int_equal(editor->session.history.done, 1);
    assert_int_equal(count(editor), 7);
    assert_int_equal(selected(editor), 5);
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 4; k++)
            lies(editor, 1, i, k, point(editor, 1, 0, k)[0] + 112.5 * i, point(editor, 1, 0, k)[1]);
    assert_false(shows(editor));
    goes_back_and_replays(editor, first);
    /* at no distance they touch, at a negative one they overlap */
    only(editor, 2, 0);
    set(editor, "array-gap", 0);
    runs(editor, "array");
    assert_int_equal(bat_editor_read_as(editor, 3), BAT_OK);
    lies(editor, 2, 4, 0, 480, 500);
    runs(editor, "undo");
    set(editor, "array-gap", -35);
    runs(editor, "array");
    runs(editor, "accept");
    lies(editor, 2, 4, 0, 340, 500);
    bat_editor_free(editor);
}

/* In any direction: as far as the box of 100 reaches there, and the gap; level and upright exactly. */
static void a_row_aslant(void **state) {
    (void)state;
    static const double degrees[] = {0, 30, 45, 90, 135, 180, -60, 270, -360};
    for (size_t n = 0; n < sizeof degrees / sizeof *degrees; n++) {
        bat_editor *editor = things();
        const uint64_t first = digest(editor);
        const double angle = degrees[n] * acos(-1) / 180, c = cos(angle), s = sin(angle);
        double box[4];
        bat_object_bounds(bat_document_at(bat_editor_document(editor), 0), box);
        const double far = fabs(c) * (box[2] - box[0]) + fabs(s) * (box[3] - box[1]) + 7;
        only(editor, 1, 0);
        runs(editor, "array");
        set(editor, "array-count", 4);
        set(editor, "array-gap", 7);
        set(editor, "array-direction", degrees[n]);
        runs(editor, "accept");
        const double from[2] = {point(editor, 1, 0, 0)[0], point(editor, 1, 0, 0)[1]};
        for (int i = 1; i < 4; i++) lies(editor, 1, i, 0, from[0] + i * far * c, from[1] + i * far * s);
        if (n == 0 || n == 5) assert_true(point(editor, 1, 3, 0)[1] == from[1]);
        if (n == 3 || n == 7) assert_true(point(editor, 1, 3, 0)[0] == from[0]);
        goes_back_and_replays(editor, first);
        bat_editor_free(editor);
    }
}

static void a_grid(void **state) {
    (void)state;
    bat_editor *editor = things();
    const uint64_t first = digest(editor);
    only(editor, 1, 2); /* the box around both: 100, 200 to 420, 520 */
    runs(editor, "array");
    runs(editor, "reading-next");
    says(editor, "\"chosen\":1,");
    says(editor, "\"typed\":\"array-count array-rows array-gap array-gap-down\"");
    set(editor, "array-count", 3);
    set(editor, "array-rows", 2);
    set(editor, "array-gap", 30);
    set(editor, "array-gap-down", 7);
    runs(editor, "accept");
    assert_int_equal(count(editor), 13);
    assert_int_equal(selected(editor), 12);
    for (int i = 0; i < 6; i++)
        for (int of = 0; of < 2; of++)
            lies(editor, (bat_id)of + 1, i, 0, (of ? 400 : 100) + 350 * (i % 3),
                 (of ? 500 : 200) + 327 * (i / 3));
    runs(editor, "group"); /* all are one group then, if one wants */
    assert_int_equal(selected(editor), 1);
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

/* The centre of the box is at 150, 220: that of the circle the radius below it. */
static void a_circle(void **state) {
    (void)state;
    static const struct {
        double angle;
        int count, parts;
    } cases[] = {{360, 8, 8}, {90, 4, 3}, {-360, 5, -5}, {-60, 3, -2 * 3}};
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++)
        for (int turns = 0; turns < 2; turns++) {
            bat_editor *editor = things();
            const uint64_t first = digest(editor);
            only(editor, 1, 0);
            runs(editor, "array");
            assert_int_equal(bat_editor_read_as(editor, 2), BAT_OK);
            says(editor, "\"typed\":\"array-count array-radius array-angle\"");
            set(editor, "array-count", cases[n].count);
            set(editor, "array-radius", 150);
            set(editor, "array-angle", cases[n].angle);
            says(editor, "\"Keep upright\"");
            if (!turns) {
                assert_int_equal(bat_editor_read_as(editor, 3), BAT_OK);
                says(editor, "\"Turn along\"");
            }
            assert_int_equal(bat_editor_read_as(editor, 4), BAT_OK);
            assert_int_equal(count(editor), cases[n].count + 2);
            const double whole = fabs(cases[n].angle) == 360 ? cases[n].count : cases[n].count - 1;
            for (int i = 0; i < cases[n].count; i++)
                for (int k = 0; k < 4; k++) {
                    const double t = cases[n].angle * PI / 180 * i / whole;
                    const double x = k == 0 || k == 3 ? -50 : 50, y = k < 2 ? -20 : 20; /* of the middle */
                    const double mx = 150 + 150 * sin(t), my = 370 - 150 * cos(t);
                    lies(editor, 1, i, k, mx + (turns ? cos(t) * x - sin(t) * y : x),
                         my + (turns ? sin(t) * x + cos(t) * y : y));
                }
            goes_back_and_replays(editor, first);
            bat_editor_free(editor);
        }
}

/* The slider: gaps, or the radius, and nothing else. */
static void the_slider(void **state) {
    (void)state;
    bat_editor *editor = things();
    double gap[2], radius;
    only(editor, 1, 0);
    runs(editor, "array");
    assert_int_equal(bat_editor_refit(editor, 0.5, false), BAT_OK); /* 200 at its end */
    assert_int_equal(bat_editor_get(editor, "array-gap", &gap[0]), BAT_OK);
    assert_int_equal(bat_editor_get(editor, "array-gap-down", &gap[1]), BAT_OK);
    assert_true(gap[0] == 50 && gap[1] == 50);
    says(editor, "\"amount\":0.5,");
    assert_int_equal(bat_editor_read_as(editor, 2), BAT_OK);
    assert_int_equal(bat_editor_refit(editor, 1, true), BAT_OK);
    assert_int_equal(bat_editor_get(editor, "array-radius", &radius), BAT_OK);
    assert_int_equal(bat_editor_get(editor, "array-gap", &gap[0]), BAT_OK);
    assert_true(radius == 200 && gap[0] == 50);
    static const double amounts[] = {NAN, -0.01, 1.01, INFINITY};
    for (size_t i = 0; i < sizeof amounts / sizeof *amounts; i++)
        assert_int_equal(bat_editor_refit(editor, amounts[i], true), BAT_ARGUMENT);
    assert_int_equal(bat_editor_read_as(editor, 5), BAT_ARGUMENT);
    static const char *const texts[] = {"", "0", "-3", "ten", "nan", "1e9"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        if (bat_editor_enter(editor, "array-count", texts[i]) == BAT_OK) fail_msg("%s", texts[i]);
    assert_int_equal(bat_editor_enter(editor, "array-gap", "1in"), BAT_OK); /* with its unit */
    assert_int_equal(bat_editor_get(editor, "array-gap", &gap[0]), BAT_OK);
    assert_true(gap[0] == 96);
    runs(editor, "cancel");
    assert_int_equal(count(editor), 3);
    bat_editor_free(editor);
}

static void refused(bat_editor *editor, bat_string why) {
    char said[200];
    snprintf(said, sizeof said, "\"said\":\"%s\"", bat_string_english(why));
    says(editor, said);
    assert_false(shows(editor));
    const uint64_t now = digest(editor);
    bat_editor_command(editor, "accept");
    assert_string_equal(bat_editor_frame(editor)->notice, bat_string_english(why));
    assert_true(digest(editor) == now);
    says(editor, "\"of\":\"array\""); /* it can still be chosen otherwise */
}

static void what_can_not_be(void **state) {
    (void)state;
    bat_editor *editor = things();
    bat_editor_command(editor, "deselect");
    assert_int_equal(bat_editor_command(editor, "array"), BAT_STATE);
    assert_string_equal(bat_editor_frame(editor)->notice, bat_string_english(BAT_STRING_NOTICE_SELECT_FIRST));
    assert_int_equal(bat_editor_frame(editor)->readings, 0);
    only(editor, 3, 0); /* of no width */
    set(editor, "array-gap", 0);
    runs(editor, "array");
    refused(editor, BAT_STRING_NOTICE_ARRAY_HEAP);
    set(editor, "array-gap", 1);
    assert_true(shows(editor));
    set(editor, "array-count", 1);
    refused(editor, BAT_STRING_NOTICE_ARRAY_ONE);
    assert_int_equal(bat_editor_read_as(editor, 1), BAT_OK); /* one column of three is something */
    assert_true(shows(editor));
    set(editor, "array-gap-down", -50);
    refused(editor, BAT_STRING_NOTICE_ARRAY_HEAP);
    set(editor, "array-count", 10000);
    set(editor, "array-rows", 10000);
    refused(editor, BAT_STRING_NOTICE_ARRAY_MANY);
    assert_int_equal(bat_editor_read_as(editor, 2), BAT_OK);
    set(editor, "array-count", 6);
    set(editor, "array-angle", 0);
    refused(editor, BAT_STRING_NOTICE_ARRAY_HEAP);
    set(editor, "array-angle", 360);
    set(editor, "array-radius", 0); /* about its own middle */
    assert_true(shows(editor));
    assert_int_equal(bat_editor_read_as(editor, 3), BAT_OK);
    refused(editor, BAT_STRING_NOTICE_ARRAY_HEAP);
    runs(editor, "cancel");
    bat_editor_free(editor);
}

/* As many as there may be, with more than one thing each. */
static void many(void **state) {
    (void)state;
    bat_editor *editor = things();
    const uint64_t first = digest(editor);
    only(editor, 1, 2);
    set(editor, "array-count", 5001);
    runs(editor, "array");
    assert_true(shows(editor));
    set(editor, "array-count", 5002);
    refused(editor, BAT_STRING_NOTICE_ARRAY_MANY);
    set(editor, "array-count", 1200);
    runs(editor, "accept");
    assert_int_equal(count(editor), 2401);
    lies(editor, 2, 1199, 0, 400 + 330.0 * 1199, 500);
    runs(editor, "undo");
    assert_true(digest(editor) == first);
    bat_editor_free(editor);
}

/* A group is one thing; what is locked or hidden in it goes along, with other ids; symmetry makes nothing more. */
static void groups(void **state) {
    (void)state;
    bat_editor *editor = things();
    const uint64_t first = digest(editor);
    only(editor, 1, 2);
    runs(editor, "group");
    const bat_id group = bat_object_parent(object(editor, 1));
    assert_int_equal(bat_editor_set_state(editor, 1, false, true), BAT_OK);
    assert_int_equal(bat_editor_set_state(editor, 2, true, false), BAT_OK);
    set(editor, "symmetry", 1);
    only(editor, group, 0);
    set(editor, "array-count", 3);
    runs(editor, "array");
    runs(editor, "accept");
    assert_int_equal(count(editor), 4 + 2 * 3);
    assert_int_equal(selected(editor), 3);
    const bat_document *document = bat_editor_document(editor);
    const int at = bat_document_find(document, group);
    for (int i = 0; i < 3; i++) {
        const bat_id head = bat_object_id(bat_document_at(document, at + 3 * i));
        for (int k = 1; k < 3; k++) {
            const bat_object *member = bat_document_at(document, at + 3 * i + k);
            assert_int_equal(bat_object_parent(member), head);
            lies(editor, group, 3 * i + k, 0, (k > 1 ? 400 : 100) + 330.0 * i, k > 1 ? 500 : 200);
        }
    }
    goes_back_and_replays(editor, first);
    bat_editor_free(editor);
}

/* Whatever else is done ends it, and nothing of it is left. */
static void what_ends_it(void **state) {
    (void)state;
    static const char *const ends[] = {"deselect", "select-all", "tool-sketch", "undo", "delete", "cancel"};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        bat_editor *one = things();
        only(one, 1, 0);
        assert_int_equal(bat_editor_enter(one, "x", "120"), BAT_OK);
        runs(one, "array");
        assert_true(shows(one));
        runs(one, ends[i]);
        assert_false(shows(one));
        assert_int_equal(bat_editor_read_as(one, 3), BAT_STATE);
        const uint64_t then = digest(one);
        set(one, "array-count", 7);
        set(one, "array-shape", 2);
        assert_true(!shows(one) && digest(one) == then);
        bat_editor_free(one);
    }
    bat_editor *editor = things();
    only(editor, 1, 0);
    bat_editor_set_read_only(editor, true);
    const uint64_t now = digest(editor);
    bat_editor_command(editor, "array");
    bat_editor_command(editor, "accept");
    assert_true(digest(editor) == now);
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_row),    cmocka_unit_test(a_row_aslant),    cmocka_unit_test(a_grid),
        cmocka_unit_test(a_circle), cmocka_unit_test(the_slider),      cmocka_unit_test(many),
        cmocka_unit_test(groups),   cmocka_unit_test(what_can_not_be), cmocka_unit_test(what_ends_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
