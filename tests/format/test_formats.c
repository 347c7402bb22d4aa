/* Recognising a file's format: by its name, and by its content, after whatever editors prepend to it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "format/formats.h"
#include "support/pen.h"

static const char *const good[][2] = {
    {"batten", "{\"batten\":1,\"page\":[0,0,1,1],\"next\":1,\"objects\":[]}"},
    {"svg", "<svg xmlns='http://www.w3.org/2000/svg'/>"},
    {"json", "{\"degree\":1,\"closed\":false,\"knots\":[0,0,1,1],\"points\":[[0,0],[1,1]]}"},
    {"jsonl", "{\"degree\":1,\"closed\":false,\"knots\":[0,0,1,1],\"points\":[[0,0],[1,1]]}\n"
              "{\"degree\":1,\"closed\":false,\"knots\":[0,0,1,1],\"points\":[[0,0],[1,1]]}\n"},
    {"csv", "x,y\n0,0\n1,1\n"},
    {"geojson", "{\"type\":\"LineString\",\"coordinates\":[[0,0],[1,1]]}"},
    {"dxf", "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n1\n0\nENDSEC\n0\nEOF\n"},
    {"stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
            "endfacet\nendsolid a\n"},
    {"obj", "v 0 0 0\nv 1 0 0\ncstype bspline\ndeg 1\ncurv 0 1 1 2\nparm u 0 0 1 1\nend\n"},
};
enum { GOOD = sizeof good / sizeof *good };

static void by_what_stands_in_it(void **state) {
    (void)state;
    static const char *const before[] = {"", " ", "\xEF\xBB\xBF", "\xEF\xBB\xBF \t\r\n", "\n\n", "\r\n\t "};
    for (int i = 0; i < GOOD; i++)
        for (size_t k = 0; k < sizeof before / sizeof *before; k++) {
            char text[200];
            int size = snprintf(text, sizeof text, "%s%s", before[k], good[i][1]);
            const bat_format *found = bat_format_sniffed(text, (size_t)size);
            if (!found || strcmp(found->name, good[i][0]) != 0)
                fail_msg("%s behind %zu is %s", good[i][0], k, found ? found->name : "nothing");
        }
    static const char *const none[] = {"",           " \t\r\n",   "\xEF\xBB\xBF", "\xEF",
                                       "\xEF\xBB",   "\xEF\xBB{", "\xEFx\xBF{",   "x",
                                       "hello <svg", "\x89PNG"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        const bat_format *found = bat_format_sniffed(none[i], strlen(none[i]));
        if (found) fail_msg("%s is %s", none[i], found->name);
    }
}

static void by_its_name(void **state) {
    (void)state;
    for (int i = 0; i < GOOD; i++) {
        char name[40];
        snprintf(name, sizeof name, "a.b/c.%s", good[i][0]);
        const bat_format *format = bat_format_named(good[i][0]);
        assert_non_null(format);
        assert_ptr_equal(bat_format_called(name), format);
        for (char *c = name + 6; *c; c++) *c = (char)(*c & ~32);
        assert_ptr_equal(bat_format_called(name), format);
    }
    static const char *const none[] = {"",    "a",       "a.",    "a.sv",  "a.svgx",
                                       "svg", "a.svg/b", "a.@vg", "a.[vg", "a.s\x16g"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++)
        if (bat_format_called(none[i])) fail_msg("%s is a name", none[i]);
}

/* Whatever is read is sound; whatever is not, is refused with a reason. A name of parts may be that of a whole document. */
static void reading(void **state) {
    (void)state;
    bat_reading how = {0};
    for (int named = -1; named < GOOD; named++)
        for (int i = 0; i <= GOOD; i++) {
            const char *text = i < GOOD ? good[i][1] : "";
            const bat_format *format = named < 0 ? NULL : bat_format_named(good[named][0]);
            bat_document *document = NULL;
            bat_svg_report report;
            bat_problem problem = {"", ""};
            bat_status status = bat_formats_read(&how, text, strlen(text), &format, &document, &report,
                                                 &problem);
            assert_true((status == BAT_OK) == (document != NULL));
            if (document)
                assert_null(bat_document_check(document));
            else
                assert_true(problem.message[0]);
            if (i < GOOD && (named < 0 || named == i) && strcmp(good[i][0], "svg") != 0)
                assert_string_equal(status == BAT_OK ? format->name : problem.message, good[i][0]);
            bat_document_free(document);
        }
    const bat_format *json = bat_format_named("json");
    bat_document *document = NULL;
    bat_svg_report report;
    assert_int_equal(bat_formats_read(&how, good[0][1], strlen(good[0][1]), &json, &document, &report, NULL),
                     BAT_OK);
    assert_string_equal(json->name, "batten");
    bat_document_free(document);
}

static void in_words(void **state) {
    (void)state;
    char all[BAT_FORMATS_WORDS], whole[BAT_FORMATS_WORDS];
    bat_formats_words(".", false, all);
    bat_formats_words(".", true, whole);
    for (int i = 0; i < GOOD; i++) {
        char name[20];
        snprintf(name, sizeof name, ".%s", good[i][0]);
        assert_non_null(strstr(all, name));
        assert_true((strstr(whole, name) != NULL) == bat_format_named(good[i][0])->keeps);
    }
    assert_non_null(strstr(all, " or "));
    char far[BAT_FORMATS_WORDS]; /* what does not fit is left out, and what is there ends */
    char before[100];
    memset(before, 'x', sizeof before - 1);
    before[sizeof before - 1] = 0;
    bat_formats_words(before, false, far);
    assert_true(strlen(far) < sizeof far);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(by_what_stands_in_it), cmocka_unit_test(by_its_name),
                                       cmocka_unit_test(reading), cmocka_unit_test(in_words)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
