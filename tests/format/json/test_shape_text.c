/* Shapes and edits of them as JSON: an edit has the same effect as the call of its name; errors are refused with a
 * message that gives their place, and change nothing; any allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/alloc_fail.h"
#include "support/pen.h"
#include <batten/format.h>
#include <batten/levels.h>
#include <stdio.h>

/* Two levels over a sweep in the plane, one of them weak. */
static bat_shape *two_levels(void) {
    bat_curve *curve = pen_curve(0, 0, 20, 15, 23);
    bat_shape *shape = NULL;
    assert_int_equal(bat_shape_decompose(curve, 2, NULL, &shape), BAT_OK);
    bat_curve_free(curve);
    assert_int_equal(bat_shape_levels(shape), 2);
    assert_int_equal(bat_shape_set_gain(shape, 2, 0.5), BAT_OK);
    assert_int_equal(bat_shape_commit(shape), BAT_OK);
    return shape;
}

static char *written(const bat_shape *shape) {
    char *text = NULL;
    size_t size = 0;
    assert_int_equal(bat_shape_write(shape, &text, &size), BAT_OK);
    assert_int_equal(strlen(text), size);
    return text;
}

static void must_be(const bat_shape *shape, const char *text) {
    char *now = written(shape);
    assert_string_equal(now, text);
    bat_free(now);
}

/* "words:words", at a place of the text. */
static void must_say(const bat_problem *problem, const char *words) {
    if (!strstr(problem->message, words) && !strstr(problem->place, words))
        fail_msg("\"%s: %s\" does not say \"%s\"", problem->place, problem->message, words);
}

typedef bat_status call(bat_shape *shape);
static bat_status move(bat_shape *shape) { return bat_shape_move(shape, 1, 3, (double[]){5, -7}); }
static bat_status drag(bat_shape *shape) { return bat_shape_drag(shape, 0, 2.5, (double[]){-3, 8}); }
static bat_status gain(bat_shape *shape) { return bat_shape_set_gain(shape, 1, -1.5); }
static bat_status turn(bat_shape *shape) {
    return bat_shape_transform(shape, (double[]){0, -1, 40, 1, 0, -20});
}
static bat_status sketch(bat_shape *shape) {
    double points[82];
    for (int i = 0; i <= 40; i++) points[2 * i] = 40 + 8.0 * i, points[2 * i + 1] = 60;
    const bat_stroke stroke = {.dimension = 2, .count = 41, .points = points};
    bat_sketch_report report;
    return bat_shape_redraw_level(shape, 1, &stroke, NULL, &report);
}

static const char *sketch_text(void) {
    static char text[2000];
    size_t used = (size_t)snprintf(text, sizeof text,
                                   "[{\"type\":\"sketch\",\"level\":1,\"stroke\":{\"points\":[");
    for (int i = 0; i <= 40; i++)
        used += (size_t)snprintf(text + used, sizeof text - used, "%s[%d,60]", i ? "," : "", 40 + 8 * i);
    snprintf(text + used, sizeof text - used, "]}}]");
    return text;
}

static void edits_are_calls(void **state) {
    (void)state;
    const struct {
        const char *text;
        call *same;
    } rows[] = {{"[{\"type\":\"move\",\"level\":1,\"index\":3,\"delta\":[5,-7]}]", move},
                {"[{\"type\":\"drag\",\"level\":0,\"u\":2.5,\"delta\":[-3,8]}]", drag},
                {"[{\"type\":\"gain\",\"level\":1,\"value\":-1.5}]", gain},
                {"[{\"type\":\"transform\",\"matrix\":[[0,-1,0,40],[1,0,0,-20],[0,0,1,0]]}]", turn},
                {sketch_text(), sketch}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        bat_shape *edited = two_levels(), *called = two_levels();
        bat_problem problem = {"", ""};
        if (bat_shape_edit(edited, rows[i].text, strlen(rows[i].text), &problem) != BAT_OK)
            fail_msg("edit %zu: %s: %s", i, problem.place, problem.message);
        assert_int_equal(rows[i].same(called), BAT_OK);
        assert_int_equal(bat_shape_commit(called), BAT_OK);
        char *text = written(called);
        must_be(edited, text);
        bat_free(text);
        bat_shape_free(edited);
        bat_shape_free(called);
    }
}

static void what_is_wrong_changes_nothing(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } rows[] = {
        {"{}", "a list"},
        {"[7]", "an object"},
        {"[{}]", "type"},
        {"[{\"type\":\"melt\"}]", "type"},
        {"[{\"type\":5}]", "type"},
        {"[{\"type\":\"move\"}]", "level"},
        {"[{\"type\":\"move\",\"level\":3,\"index\":0,\"delta\":[0,0]}]", "a level of the shape"},
        {"[{\"type\":\"move\",\"level\":-1,\"index\":0,\"delta\":[0,0]}]", "a level of the shape"},
        {"[{\"type\":\"move\",\"level\":0.5,\"index\":0,\"delta\":[0,0]}]", "a level of the shape"},
        {"[{\"type\":\"move\",\"level\":1,\"index\":999,\"delta\":[0,0]}]", "a control point"},
        {"[{\"type\":\"move\",\"level\":1,\"index\":0,\"delta\":[0]}]", "delta"},
        {"[{\"type\":\"drag\",\"level\":1,\"u\":\"x\",\"delta\":[0,0]}]", "a number"},
        {"[{\"type\":\"drag\",\"level\":1,\"u\":1,\"delta\":5}]", "delta"},
        {"[{\"type\":\"gain\",\"level\":1}]", "value"},
        {"[{\"type\":\"gain\",\"level\":0,\"value\":2}]", ""},
        {"[{\"type\":\"gain\",\"level\":1,\"value\":1e9}]", ""},
        {"[{\"type\":\"sketch\",\"level\":1}]", "points"},
        {"[{\"type\":\"sketch\",\"level\":1,\"stroke\":{\"points\":[[0,0],[0,0]]}}]", ""},
        {"[{\"type\":\"transform\"}]", "3 rows of 4"},
        {"[{\"type\":\"transform\",\"matrix\":[[1,0,0,0],[0,1,0,0]]}]", "3 rows of 4"},
        {"[{\"type\":\"transform\",\"matrix\":[[1,0,0],[0,1,0],[0,0,1]]}]", "3 rows of 4"},
        {"[{\"type\":\"transform\",\"matrix\":[[1,0,0,\"x\"],[0,1,0,0],[0,0,1,0]]}]", "a number"},
        {"[{\"type\":\"transform\",\"matrix\":[[0,0,0,0],[0,0,0,0],[0,0,1,0]]}]", ""},
        {"[{\"type\":\"gain\",\"level\":1,\"value\":3},{\"type\":\"melt\"}]", "type"},
        {"[", ""},
    };
    bat_shape *shape = two_levels();
    char *before = written(shape);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        bat_problem problem = {"", ""};
        if (bat_shape_edit(shape, rows[i].text, strlen(rows[i].text), &problem) == BAT_OK)
            fail_msg("%s is taken", rows[i].text);
        assert_true(problem.message[0]);
        must_say(&problem, rows[i].says);
        must_be(shape, before);
    }
    bat_problem problem;
    assert_int_equal(bat_shape_edit(NULL, "[]", 2, &problem), BAT_ARGUMENT);
    assert_int_equal(bat_shape_edit(shape, NULL, 2, &problem), BAT_ARGUMENT);
    assert_int_equal(bat_shape_edit(shape, "[]", 2, NULL), BAT_OK);
    must_be(shape, before);
    bat_free(before);
    bat_shape_free(shape);
}

/* A stroke over less than a level's spans is followed as well as can be, and problem says how well. */
static void short_sketches_are_told(void **state) {
    (void)state;
    static const char text[] = "[{\"type\":\"sketch\",\"level\":0,\"stroke\":{\"points\":"
                               "[[200,0],[203,20],[206,0],[209,20],[212,0],[215,20],[218,0]]}}]";
    bat_shape *shape = two_levels();
    bat_problem problem = {"", ""};
    assert_int_equal(bat_shape_edit(shape, text, strlen(text), &problem), BAT_OK);
    must_say(&problem, "the stroke is short for level 0");
    bat_shape_free(shape);
}

#define BASE                                                                                                 \
    "{\"base\":{\"degree\":3,\"closed\":false,\"knots\":[0,0,0,0,1,1,1,1],"                                  \
    "\"points\":[[0,0],[40,60],[110,60],[150,0]]}"
#define KNOTS "\"knots\":[0,0,0,0,0.5,1,1,1,1]"
#define DETAILS "\"details\":[[0,0,0],[0,0,0],[0,9,0],[0,0,0],[0,0,0]]"

static void shapes_are_read(void **state) {
    (void)state;
    static const char *const good[] = {
        BASE "}",
        "{\"shape\":" BASE "}}",
        BASE ",\"levels\":[{" KNOTS "}]}",
        BASE ",\"levels\":[{" KNOTS "," DETAILS "}]}",
        BASE ",\"levels\":[{" KNOTS "," DETAILS ",\"gain\":0.25,\"muted\":true}]}",
        BASE ",\"levels\":[{" KNOTS "," DETAILS ",\"gain\":2,\"muted\":false}]}",
        BASE ",\"levels\":[{" KNOTS "," DETAILS "},{" KNOTS "," DETAILS ",\"source\":[1,0,0,1,1]}]}",
        BASE ",\"frame\":\"frenet\",\"nodes\":\"argmax\",\"propagation\":\"plain\"}",
        BASE ",\"frame\":\"fixed\",\"first\":{\"s\":[0,0,1]}}",
        BASE ",\"first\":{\"t\":[1,0,0],\"s\":[0,0,1]}}",
    };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        bat_shape *shape = NULL, *again = NULL;
        bat_problem problem = {"", ""};
        if (bat_shape_read(good[i], strlen(good[i]), &shape, &problem) != BAT_OK)
            fail_msg("%s: %s: %s", good[i], problem.place, problem.message);
        char *text = written(shape);
        assert_int_equal(bat_shape_read(text, strlen(text), &again, &problem), BAT_OK);
        must_be(again, text);
        bat_free(text);
        bat_shape_free(shape);
        bat_shape_free(again);
    }
}

static void bad_shapes_are_not(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } rows[] = {
        {"7", "an object"},
        {"{}", "base"},
        {"{\"base\":{}}", ""},
        {BASE ",\"frame\":\"fancy\"}", "frame"},
        {BASE ",\"frame\":5}", "frame"},
        {BASE ",\"nodes\":\"\"}", "nodes"},
        {BASE ",\"propagation\":\"far\"}", "propagation"},
        {BASE ",\"first\":{\"t\":[1,0,0]}}", "first"},
        {BASE ",\"first\":{\"s\":[1,0]}}", "first.s"},
        {BASE ",\"first\":{\"t\":5,\"s\":[1,0,0]}}", "first.t"},
        {BASE ",\"levels\":5}", "a list"},
        {BASE ",\"levels\":[5]}", "an object"},
        {BASE ",\"levels\":[{\"knots\":\"x\"}]}", "knots"},
        {BASE ",\"levels\":[{\"knots\":[0,0,0,0,1,1,1]}]}", "knots"},
        {BASE ",\"levels\":[{" DETAILS "}]}", "knots"},
        {BASE ",\"levels\":[{" KNOTS ",\"details\":[[0,0,0]]}]}", "details"},
        {BASE ",\"levels\":[{" KNOTS ",\"details\":[[0]]}]}", "details"},
        {BASE ",\"levels\":[{" KNOTS "," DETAILS ",\"source\":[0]}]}", "one a detail"},
        {BASE ",\"levels\":[{" KNOTS "," DETAILS ",\"source\":[0,0,0,0,1]}]}", "levels below"},
        {BASE ",\"levels\":[{" KNOTS "," DETAILS ",\"source\":[0,0,-1,0,0]}]}", "levels below"},
        {BASE ",\"levels\":[{" KNOTS "," DETAILS ",\"source\":\"x\"}]}", "source"},
        {BASE ",\"levels\":[{" KNOTS ",\"gain\":\"x\"}]}", "gain"},
        {BASE ",\"levels\":[{" KNOTS ",\"gain\":1e7}]}", "gain"},
        {BASE ",\"levels\":[{" KNOTS ",\"muted\":0}]}", "muted"},
    };
    bat_shape *shape = NULL;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        bat_problem problem = {"", ""};
        if (bat_shape_read(rows[i].text, strlen(rows[i].text), &shape, &problem) == BAT_OK)
            fail_msg("%s is taken", rows[i].text);
        assert_null(shape);
        assert_true(problem.message[0]);
        must_say(&problem, rows[i].says);
    }
    char *text = NULL;
    size_t size = 0;
    bat_problem problem;
    assert_int_equal(bat_shape_read(NULL, 0, &shape, &problem), BAT_ARGUMENT);
    assert_int_equal(bat_shape_read("{}", 2, NULL, &problem), BAT_ARGUMENT);
    assert_int_equal(bat_shape_write(NULL, &text, &size), BAT_ARGUMENT);
}

/* Reading, editing and writing with the nth allocation failing. */
static void any_allocation_may_fail(void **state) {
    (void)state;
    static const char whole[] = BASE ",\"levels\":[{" KNOTS "," DETAILS "},{" KNOTS "," DETAILS
                                     ",\"source\":[1,0,0,1,1],\"muted\":true}]}";
    static const char edits[] =
        "[{\"type\":\"move\",\"level\":1,\"index\":2,\"delta\":[1,2]},"
        "{\"type\":\"transform\",\"matrix\":[[0,-1,0,4],[1,0,0,-2],[0,0,1,0]]},"
        "{\"type\":\"sketch\",\"level\":0,\"stroke\":{\"points\":[[0,0],[50,90],[9,0]]}}]";
    const long held = alloc_live();
    bool done = false;
    for (long n = 1; !done; n++) {
        bat_shape *shape = NULL;
        char *text = NULL;
        size_t size = 0;
        bat_problem problem = {"", ""};
        alloc_fail_at(n);
        bat_status status = bat_shape_read(whole, sizeof whole - 1, &shape, &problem);
        if (status == BAT_OK) status = bat_shape_edit(shape, edits, sizeof edits - 1, &problem);
        if (status == BAT_OK) status = bat_shape_write(shape, &text, &size);
        done = !alloc_fail_reached();
        assert_int_equal(status, done ? BAT_OK : BAT_MEMORY);
        bat_shape_free(shape);
        bat_free(text);
        assert_true(alloc_live() == held);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edits_are_calls),         cmocka_unit_test(what_is_wrong_changes_nothing),
        cmocka_unit_test(short_sketches_are_told), cmocka_unit_test(shapes_are_read),
        cmocka_unit_test(bad_shapes_are_not),      cmocka_unit_test(any_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
