/* Whole SVG files read by expat: drawings, and malicious files. */
#include <batten/svg_read.h>
#include <batten/document.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "support/alloc_fail.h"

static const char DRAWING[] =
    "<?xml version='1.0'?>\n"
    "<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' 'http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd' "
    "[<!ENTITY ns 'http://www.w3.org/2000/svg'><!ENTITY line 'M0 0L30 40'>]>\n"
    "<svg xmlns='&ns;' width='100' height='50'><path id='a&amp;b' d='&line;'/><text>no</text></svg>\n";

static void a_drawing(void **state) {
    (void)state;
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem;
    assert_int_equal(bat_svg_read(DRAWING, sizeof DRAWING - 1, NULL, &document, &report, &problem), BAT_OK);
    assert_int_equal(report.paths, 1);
    assert_int_equal(report.lost.count[BAT_LOSS_TEXT], 0);
    assert_int_equal(bat_document_count(document), 2);
    assert_true(bat_object_is_foreign(bat_document_at(document, 1)));
    assert_string_equal(bat_object_name(bat_document_at(document, 0)), "a&b");
    bat_document_free(document);
    document = NULL;
    assert_int_equal(bat_svg_read(DRAWING, sizeof DRAWING - 1, NULL, &document, NULL, NULL), BAT_OK);
    bat_document_free(document);
}

static void refused(const char *text, size_t size, bat_status want, const char *place, const char *message) {
    bat_document *mark = (bat_document *)(void *)&size, *document = mark;
    bat_svg_report report = {.paths = 77};
    bat_problem problem;
    assert_int_equal(bat_svg_read(text, size, NULL, &document, &report, &problem), want);
    assert_string_equal(problem.place, place);
    if (!strstr(problem.message, message)) fail_msg("'%s' is not in '%s'", message, problem.message);
    assert_null(strchr(problem.message, '\n'));
    assert_ptr_equal(document, mark);
    assert_int_equal(report.paths, 77);
    assert_int_equal(bat_svg_read(text, size, NULL, &document, NULL, NULL), want);
}

#define REFUSED(text, want, place, message) refused(text, sizeof text - 1, want, place, message)

static void no_drawings(void **state) {
    (void)state;
    REFUSED("", BAT_SYNTAX, "line 1, column 1", "an empty file");
    refused(NULL, 0, BAT_SYNTAX, "line 1, column 1", "an empty file");
    refused(NULL, 1, BAT_ARGUMENT, "", "missing");
    REFUSED("<svg", BAT_SYNTAX, "line 1, column 1", "unclosed token");
    REFUSED("<svg>\n</sgv>", BAT_SYNTAX, "line 2, column 3", "mismatched tag");
    REFUSED("<svg>\0</svg>", BAT_SYNTAX, "line 1, column 6", "not well-formed");
    REFUSED("\0\0\0\0", BAT_SYNTAX, "line 1, column 1", "not well-formed");
    REFUSED("{\"batten\":1}", BAT_SYNTAX, "line 1, column 1", "not well-formed");
    bat_problem problem;
    assert_int_equal(bat_svg_read(DRAWING, sizeof DRAWING - 1, NULL, NULL, NULL, &problem), BAT_ARGUMENT);
    bat_document *document = NULL;
    bat_svg_options options = bat_svg_defaults();
    options.size = 0;
    assert_int_equal(bat_svg_read(DRAWING, sizeof DRAWING - 1, &options, &document, NULL, &problem),
                     BAT_ARGUMENT);
    assert_true(problem.message[0]);
    /* The bytes are not even looked at. */
    refused(DRAWING, (size_t)1 << 30, BAT_COUNT, "", "found 1073741824");
    refused(DRAWING, BAT_SVG_SIZE + 1, BAT_COUNT, "", "at most 268435456 bytes");
    refused(DRAWING, SIZE_MAX, BAT_COUNT, "", "at most");
}

static void entities_that_mean_harm(void **state) {
    (void)state;
    char bomb[4096] = "<!DOCTYPE svg [<!ENTITY a 'xxxxxxxxxxxxxxxx'>";
    for (char c = 'b'; c <= 'i'; c++) {
        size_t at = strlen(bomb);
        at += (size_t)snprintf(bomb + at, sizeof bomb - at, "<!ENTITY %c '", c);
        for (int i = 0; i < 16; i++) at += (size_t)snprintf(bomb + at, sizeof bomb - at, "&%c;", c - 1);
        snprintf(bomb + at, sizeof bomb - at, "'>");
    }
    char whole[4200];
    for (int way = 0; way < 2; way++) { /* as text, and as an attribute */
        bat_document *document = NULL;
        bat_problem problem;
        snprintf(whole, sizeof whole,
                 way ? "%s]><svg><path id='&i;'/></svg>" : "%s]><svg><title>&i;</title></svg>", bomb);
        assert_int_equal(bat_svg_read(whole, strlen(whole), NULL, &document, NULL, &problem), BAT_SYNTAX);
        assert_non_null(strstr(problem.message, "amplification"));
    }
    REFUSED("<!DOCTYPE svg [<!ENTITY a '&b;'><!ENTITY b '&a;'>]><svg>&a;</svg>", BAT_SYNTAX,
            "line 1, column 57", "recursive entity");
    REFUSED("<!DOCTYPE svg [<!ENTITY x SYSTEM 'file:///etc/passwd'>]>\n<svg><title>&x;</title></svg>",
            BAT_SYNTAX, "line 2, column 13", "an external entity");
    REFUSED("<svg>&x;</svg>", BAT_SYNTAX, "line 1, column 6", "undefined entity");
}

static void scarce_memory(void **state) {
    (void)state;
    for (long n = 1, done = 0; !done; n++) {
        const long held = alloc_live();
        bat_document *document = NULL;
        alloc_fail_at(n);
        bat_status status = bat_svg_read(DRAWING, sizeof DRAWING - 1, NULL, &document, NULL, NULL);
        done = !alloc_fail_reached();
        assert_int_equal(status, done ? BAT_OK : BAT_MEMORY);
        bat_document_free(document);
        assert_int_equal(alloc_live(), held);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_drawing), cmocka_unit_test(no_drawings),
                                       cmocka_unit_test(entities_that_mean_harm),
                                       cmocka_unit_test(scarce_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
