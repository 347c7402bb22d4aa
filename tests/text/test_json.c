/* Numbers survive as text; JSON is read strictly, with errors given by line and column; documents, curves and strokes
 * are read back bit for bit. */
#include <locale.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/document.h>
#include <batten/motion.h>
#include "text/json.h"
#include "text/number.h"
#include "support/random_curve.h"

static double from_bits(uint64_t bits) {
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void read_back(double value) {
    char out[BAT_NUMBER_ROOM];
    int length = bat_number_print(value, out);
    assert_true(length > 0 && length < BAT_NUMBER_ROOM && out[length] == '\0');
    double back, other = strtod(out, NULL);
    assert_ptr_equal(bat_number_scan(out, out + length, &back), out + length);
    assert_memory_equal(&back, &value, sizeof value);
    assert_memory_equal(&other, &value, sizeof value);
    /* No text with a digit less reads back. */
    int digits = 0;
    const char *at = out;
    while (*at == '-' || *at == '0' || *at == '.') at++;
    const char *last = at;
    for (const char *c = at; *c && *c != 'e'; c++)
        if (*c >= '1' && *c <= '9') last = c;
    for (; at <= last && *at; at++) digits += *at != '.';
    if (digits > 1) {
        char shorter[40];
        snprintf(shorter, sizeof shorter, "%.*e", digits - 2, value);
        assert_true(strtod(shorter, NULL) != value);
    }
}

static void numbers_survive(void **state) {
    (void)state;
    const double edges[] = {0.0,
                            -0.0,
                            1,
                            -1,
                            0.1,
                            1e21,
                            1e22,
                            1e23,
                            123456789012345678.0,
                            5e-324,
                            2.2250738585072014e-308,
                            2.225073858507201e-308,
                            1.7976931348623157e308,
                            0.30000000000000004,
                            1e-6,
                            1e-7,
                            9007199254740993.0};
    for (size_t i = 0; i < sizeof edges / sizeof *edges; i++) read_back(edges[i]);
    random_source r = {11};
    for (int i = 0; i < 20000; i++) {
        double value = from_bits(r.state);
        random_unit(&r);
        if (isfinite(value)) read_back(value);
        read_back(random_between(&r, -1000, 1000));
        read_back(floor(random_between(&r, -100000, 100000)) / 64);
    }
    char out[BAT_NUMBER_ROOM];
    bat_number_print(0.5, out), assert_string_equal(out, "0.5");
    bat_number_print(-120, out), assert_string_equal(out, "-120");
    bat_number_print(1e-7, out), assert_string_equal(out, "1e-7");
    bat_number_print(1.5e300, out), assert_string_equal(out, "1.5e300");
    bat_number_print(0.1, out), assert_string_equal(out, "0.1");
}

/* Any text of digits reads as strtod reads it, in a program whose locale writes a comma, too. */
static void numbers_are_rounded_correctly(void **state) {
    (void)state;
    random_source r = {12};
    for (int i = 0; i < 20000; i++) {
        char text[1200];
        int n = 0, digits = random_int(&r, 1, i % 50 == 0 ? 1000 : 25), point = random_int(&r, 0, digits);
        for (int k = 0; k < digits; k++) {
            if (k == point) text[n++] = '.';
            text[n++] = (char)('0' + random_int(&r, 0, 9));
        }
        if (random_unit(&r) < 0.5) n += snprintf(text + n, 20, "e%d", random_int(&r, -340, 320));
        text[n] = '\0';
        double mine, theirs = strtod(text, NULL);
        assert_ptr_equal(bat_number_scan(text, text + n, &mine), text + n);
        assert_memory_equal(&mine, &theirs, sizeof mine);
    }
    /* Halfway between two doubles, and a hair above, far behind the point. */
    char text[1100] = "9007199254740993.";
    memset(text + 17, '0', 1000);
    double value;
    bat_number_scan(text, text + 1017, &value), assert_true(value == 9007199254740992.0);
    text[1000] = '1';
    bat_number_scan(text, text + 1017, &value), assert_true(value == 9007199254740994.0);
    if (!setlocale(LC_NUMERIC, "de_DE.UTF-8")) setlocale(LC_NUMERIC, "fr_FR.UTF-8");
    const char *long_one = "3.14159265358979311599796346854";
    assert_non_null(bat_number_scan(long_one, long_one + strlen(long_one), &value));
    assert_true(value == 3.141592653589793);
    char out[BAT_NUMBER_ROOM];
    bat_number_print(value, out), assert_string_equal(out, "3.141592653589793");
    setlocale(LC_NUMERIC, "C");
}

static void scan_stops_where_the_number_does(void **state) {
    (void)state;
    static const struct {
        const char *text;
        size_t length;
        double value;
    } cases[] = {{"1.5.5", 3, 1.5}, {"-.5-3", 3, -0.5}, {"+7e2m", 4, 700}, {"2em", 1, 2}, {"3e", 1, 3},
                 {"3e+", 1, 3},     {"1.e3x", 4, 1000}, {"00.5", 4, 0.5},  {"4,5", 1, 4}, {"1e-999", 6, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        double value = -1;
        const char *text = cases[i].text;
        assert_ptr_equal(bat_number_scan(text, text + strlen(text), &value), text + cases[i].length);
        assert_true(value == cases[i].value);
    }
    double value = 0;
    static const char *const none[] = {"", "-", ".", "+.", "e5", "x", "-e"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        assert_null(bat_number_scan(none[i], none[i] + strlen(none[i]), &value));
    static const char big[] = "1e999";
    bat_number_scan(big, big + strlen(big), &value);
    assert_true(isinf(value));
}

static void json_tree(void **state) {
    (void)state;
    const char *text =
        " {\"a\":[1,-2.5e1,true,null],\"b\":{\"\\u00e9\\ud83d\\ude00\\n\":\"x\"},\"a\":\"last\"} ";
    bat_json json;
    assert_int_equal(bat_json_parse(text, strlen(text), &json, NULL), BAT_OK);
    assert_string_equal(bat_json_text(&json, bat_json_member(&json, 1, "a")), "last");
    uint32_t b = bat_json_member(&json, 1, "b");
    assert_string_equal(bat_json_text(&json, bat_json_member(&json, b, "\xc3\xa9\xf0\x9f\x98\x80\n")), "x");
    assert_int_equal(bat_json_member(&json, b, "a"), 0);
    assert_int_equal(bat_json_member(&json, bat_json_member(&json, 1, "a"), "a"), 0);
    bat_json_free(&json);
}

static void bad_json_is_told(void **state) {
    (void)state;
    static const struct {
        const char *text, *place, *found;
        bat_status status;
    } cases[] = {
        {"", "line 1, column 1", "the end", BAT_SYNTAX},
        {"{\"a\":1,}", "line 1, column 8", "name", BAT_SYNTAX},
        {"[1,\n 2\n 3]", "line 3, column 2", "comma", BAT_SYNTAX},
        {"[01]", "line 1, column 2", "leading", BAT_SYNTAX},
        {"[.5]", "line 1, column 2", "value", BAT_SYNTAX},
        {"[1.]", "line 1, column 4", "digits", BAT_SYNTAX},
        {"[+1]", "line 1, column 2", "value", BAT_SYNTAX},
        {"[1e999]", "line 1, column 2", "double", BAT_NUMBER},
        {"[NaN]", "line 1, column 2", "value", BAT_SYNTAX},
        {"\"\\ud800\"", "line 1, column 8", "surrogate", BAT_SYNTAX},
        {"\"\\u0000\"", "line 1, column 8", "U+0000", BAT_SYNTAX},
        {"\"a\nb\"", "line 1, column 3", "control", BAT_SYNTAX},
        {"\"\xc0\x80\"", "line 1, column 2", "UTF-8", BAT_SYNTAX},
        {"[1] 2", "line 1, column 5", "nothing more", BAT_SYNTAX},
        {"[tru]", "line 1, column 2", "value", BAT_SYNTAX},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_json json;
        bat_problem problem;
        assert_int_equal(bat_json_parse(cases[i].text, strlen(cases[i].text), &json, &problem),
                         cases[i].status);
        assert_string_equal(problem.place, cases[i].place);
        if (!strstr(problem.message, cases[i].found)) fail_msg("%s", problem.message);
    }
    char deep[400];
    memset(deep, '[', sizeof deep);
    bat_json json;
    assert_int_equal(bat_json_parse(deep, sizeof deep, &json, NULL), BAT_COUNT);
}

static void curves_survive(void **state) {
    (void)state;
    random_source r = {13};
    for (int i = 0; i < 210; i++) {
        bat_curve *curve = random_curve(&r, 1 + i % 7, 2 + i % 2, i % 3, random_int(&r, 0, 12)), *back;
        char *text;
        size_t size;
        assert_int_equal(bat_curve_write(curve, &text, &size), BAT_OK);
        assert_int_equal(bat_curve_read(text, size, &back, NULL), BAT_OK);
        assert_true(bat_curve_is_equal(curve, back));
        bat_free(text);
        bat_curve_free(back);
        bat_curve_free(curve);
    }
}

static void bad_curves_are_told(void **state) {
    (void)state;
    static const struct {
        const char *text, *place, *part;
        bat_status status;
    } cases[] = {
        {"[]", "line 1, column 1", "an object, found a list", BAT_SYNTAX},
        {"{\"knots\":[],\"points\":[]}", "line 1, column 1", "degree", BAT_SYNTAX},
        {"{\"degree\":3}", "line 1, column 1", "knots: expected a list of numbers, found none", BAT_SYNTAX},
        {"{\"degree\":9,\"knots\":[0,1],\"points\":[[0,0]]}", "line 1, column 11", "1 to 7, found number 9",
         BAT_DEGREE},
        {"{\"degree\":1,\"knots\":[0,0,1,\"x\"],\n\"points\":[[0,0],[1,1]]}", "line 1, column 28",
         "a number, found text", BAT_SYNTAX},
        {"{\"degree\":1,\"knots\":[0,0,1,1],\n\"points\":[[0,0],[1,1,1]]}", "line 2, column 17", "2 numbers",
         BAT_DIMENSION},
        {"{\"degree\":1,\"knots\":[0,0,1],\n\"points\":[[0,0],[1,1]]}", "line 1, column 21",
         "expected 4 for 2 points, found 3", BAT_KNOTS},
        {"{\"degree\":1,\"knots\":[0,0,-1,1],\n\"points\":[[0,0],[1,1]]}", "line 1, column 26",
         "expected at least 0, found -1", BAT_KNOTS},
        {"{\"degree\":1,\"knots\":[0,0,1,1],\n\"points\":[[0,0],[1,1e80]]}", "line 2, column 10",
         "points: expected numbers up to 1e75", BAT_NUMBER},
        {"{\"degree\":1,\"closed\":1,\"knots\":[0,0,1,1],\"points\":[]}", "line 1, column 22",
         "true or false", BAT_SYNTAX},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_curve *curve = NULL;
        bat_problem problem;
        assert_int_equal(bat_curve_read(cases[i].text, strlen(cases[i].text), &curve, &problem),
                         cases[i].status);
        assert_string_equal(problem.place, cases[i].place);
        if (!strstr(problem.message, cases[i].part)) fail_msg("%s", problem.message);
        assert_null(curve);
    }
}

static bat_document *random_document(random_source *r, int objects) {
    static const char *const names[] = {"", "roof", "\"<&>\" \\ \x01\t\xf0\x9f\x9a\x97", "r\xc3\xb6hre"};
    bat_document *document;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    double page[4] = {random_between(r, -5, 5), -0.0, random_between(r, 1, 500), 0.1};
    assert_int_equal(bat_document_set_page(document, page), BAT_OK);
    for (int i = 0; i < objects; i++) {
        bat_curve *curves[3];
        int count = 1 + i % 3, dimension = 2 + i % 5 / 4;
        for (int k = 0; k < count; k++)
            curves[k] = random_curve(r, 1 + (i + k) % 7, dimension, i % 3, i % 11);
        bat_style style = {.stroked = i % 2,
                           .filled = i % 3 == 0,
                           .even_odd = i % 4 == 0,
                           .stroke = (uint32_t)(r->state >> 32),
                           .fill = (uint32_t)(r->state >> 20),
                           .width = random_unit(r) * 10,
                           .opacity = random_unit(r),
                           .cap = (bat_cap)(i % 3),
                           .join = (bat_join)(i / 3 % 3),
                           .miter_limit = 1 + random_unit(r)};
        bat_object *object;
        bat_id id = bat_document_new_id(document);
        if (i % 5 == 1) bat_document_new_id(document);
        assert_int_equal(bat_object_create_path(id, names[i % 4], &style, count, curves, &object), BAT_OK);
        assert_int_equal(bat_document_insert(document, i / 2, object), BAT_OK);
        bat_object_release(object);
    }
    return document;
}

static void documents_survive(void **state) {
    (void)state;
    random_source r = {14};
    for (int i = 0; i < 30; i++) {
        bat_document *document = random_document(&r, i), *back;
        char *text, *again;
        size_t size, size_again;
        assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
        bat_problem problem = {"", ""};
        if (bat_document_read(text, size, &back, &problem) != BAT_OK)
            fail_msg("%s: %s", problem.place, problem.message);
        assert_null(bat_document_check(back));
        assert_true(bat_document_digest(back) == bat_document_digest(document));
        assert_int_equal(bat_document_write(back, &again, &size_again), BAT_OK);
        assert_string_equal(text, again);
        assert_true(bat_document_new_id(back) == bat_document_new_id(document));
        /* Cut short anywhere it is refused. */
        for (size_t cut = 0; cut + 2 < size; cut += 1 + size / 50) {
            bat_document *none = NULL;
            assert_int_equal(bat_document_read(text, cut, &none, &problem), BAT_SYNTAX);
            assert_null(none);
        }
        bat_free(text);
        bat_free(again);
        bat_document_free(back);
        bat_document_free(document);
    }
}

static void bad_documents_are_told(void **state) {
    (void)state;
#define CURVE "{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0],[1,1]]}"
    static const struct {
        const char *text, *part;
        bat_status status;
    } cases[] = {
        {"{}", "version", BAT_SYNTAX},
        {"{\"batten\":11,\"objects\":[]}", "version 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 or 12, found number 11",
         BAT_UNSUPPORTED},
        {"{\"batten\":1}", "objects", BAT_SYNTAX},
        {"{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"blob\"}]}", "\"path\"", BAT_UNSUPPORTED},
        {"{\"batten\":1,\"objects\":[{\"id\":1.5,\"kind\":\"path\",\"curves\":[" CURVE "]}]}", "whole",
         BAT_SYNTAX},
        {"{\"batten\":1,\"objects\":[{\"id\":1e300,\"kind\":\"path\",\"curves\":[" CURVE "]}]}", "whole",
         BAT_SYNTAX},
        {"{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"path\",\"curves\":[]}]}", "at least one",
         BAT_SYNTAX},
        {"{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"path\",\"curves\":[" CURVE "]},"
         "{\"id\":1,\"kind\":\"path\",\"curves\":[" CURVE "]}]}",
         "different ids", BAT_ARGUMENT},
        {"{\"batten\":1,\"page\":[0,0,-1,1],\"objects\":[]}", "page", BAT_NUMBER},
        {"{\"batten\":1,\"page\":[0,0],\"objects\":[]}", "page", BAT_COUNT},
        {"{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"path\",\"style\":{\"width\":-1},\"curves\":[" CURVE
         "]}]}",
         "width: expected a number from 0, found number -1", BAT_SYNTAX},
        {"{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"path\",\"style\":{\"stroke\":\"red\"},\"curves\":"
         "[" CURVE "]}]}",
         "#rrggbbaa", BAT_SYNTAX},
    };
#undef CURVE
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_document *document = NULL;
        bat_problem problem;
        bat_status status = bat_document_read(cases[i].text, strlen(cases[i].text), &document, &problem);
        if (status != cases[i].status) fail_msg("case %zu: status %d", i, status);
        if (!strstr(problem.message, cases[i].part)) fail_msg("%s", problem.message);
        assert_null(document);
    }
}

static bat_status read_stroke(const char *text, bat_stroke *stroke, void **block, bat_problem *problem) {
    return bat_stroke_read(text, strlen(text), stroke, block, problem);
}

static void strokes_are_read(void **state) {
    (void)state;
    bat_stroke stroke;
    void *block;
    assert_int_equal(read_stroke("\xef\xbb\xbfx,y,pressure,time\r\n1,2,0.5,10\r\n 3 , 4e1,1,\t20\r\n\r\n\r\n",
                                 &stroke, &block, NULL),
                     BAT_OK);
    assert_int_equal(stroke.count, 2);
    assert_int_equal(stroke.dimension, 2);
    const double points[] = {1, 2, 3, 40}, pressure[] = {0.5, 1}, time[] = {10, 20};
    assert_memory_equal(stroke.points, points, sizeof points);
    assert_memory_equal(stroke.pressure, pressure, sizeof pressure);
    assert_memory_equal(stroke.time, time, sizeof time);
    bat_free(block);
    assert_int_equal(read_stroke("time,y,x\n5,1,2", &stroke, &block, NULL), BAT_OK);
    assert_true(stroke.points[0] == 2 && stroke.points[1] == 1 && stroke.time[0] == 5 && !stroke.pressure);
    bat_free(block);
    assert_int_equal(read_stroke("\n{\"points\":[[1,2,3],[4,5,6]],\"time\":[0,8]}\n", &stroke, &block, NULL),
                     BAT_OK);
    assert_int_equal(stroke.dimension, 3);
    assert_true(stroke.points[5] == 6 && stroke.time[1] == 8 && !stroke.pressure);
    bat_free(block);
    assert_int_equal(read_stroke("{\"points\":[]}", &stroke, &block, NULL), BAT_OK);
    assert_int_equal(stroke.count, 0);
    bat_free(block);
}

static void bad_strokes_are_told(void **state) {
    (void)state;
    static const struct {
        const char *text, *place, *part;
        bat_status status;
    } cases[] = {
        {"", "line 1", "nothing", BAT_SYNTAX},
        {"1,2\n3,4\n", "line 1, field 1", "header", BAT_SYNTAX},
        {"x,y\n1,2\n3,four\n", "line 3, field 2", "a number, found \"four\"", BAT_SYNTAX},
        {"x,y\n1,2\n3\n", "line 3, field 2", "a number, found nothing", BAT_SYNTAX},
        {"x,y\n1,2,3\n", "line 2, field 3", "end of the line", BAT_SYNTAX},
        {"x,y\n1,nan\n", "line 2, field 2", "\"nan\"", BAT_SYNTAX},
        {"x,y\n1,1e999\n", "line 2, field 2", "1e75", BAT_NUMBER},
        {"x,z\n", "line 1, field 2", "header", BAT_SYNTAX},
        {"x\n", "line 1, field 2", "x and y", BAT_SYNTAX},
        {"{\"points\":[[1,2]],\"time\":[1,2]}", "line 1, column 26", "one number a point", BAT_COUNT},
        {"{\"point\":[[1,2]]}", "line 1, column 1", "found none", BAT_SYNTAX},
        {"[[1,2]]", "line 1, column 1", "points", BAT_SYNTAX},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_stroke stroke;
        void *block = NULL;
        bat_problem problem;
        bat_status status = read_stroke(cases[i].text, &stroke, &block, &problem);
        if (status != cases[i].status) fail_msg("case %zu: status %d", i, status);
        assert_string_equal(problem.place, cases[i].place);
        if (!strstr(problem.message, cases[i].part)) fail_msg("%s", problem.message);
        assert_null(block);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_survive),
        cmocka_unit_test(numbers_are_rounded_correctly),
        cmocka_unit_test(scan_stops_where_the_number_does),
        cmocka_unit_test(json_tree),
        cmocka_unit_test(bad_json_is_told),
        cmocka_unit_test(curves_survive),
        cmocka_unit_test(bad_curves_are_told),
        cmocka_unit_test(documents_survive),
        cmocka_unit_test(bad_documents_are_told),
        cmocka_unit_test(strokes_are_read),
        cmocka_unit_test(bad_strokes_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
