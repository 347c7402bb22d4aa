/* What is not edited is seen where it lies: texts, filters and pictures of other formats become foreign
 * content, which can be moved, ordered and deleted, and is written back as the element that it was. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "format/svg/write/feed.h"
#include "support/alloc_fail.h"
#include <batten/bezier.h>
#include <batten/format.h>

#include <math.h>
#include <stdlib.h>

#define HEAD "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 200 100\">"
#define TAIL "<path d=\"M0 90H50\" stroke=\"#000\"/></svg>"

static bat_status read_file(const char *text, bool whole, bat_document **out, bat_svg_report *report) {
    bat_svg_reader *reader;
    bat_status status = bat_svg_reader_create(NULL, &reader);
    if (status != BAT_OK) return status;
    if (whole) status = bat_svg_reader_source(reader, text, strlen(text));
    if (status == BAT_OK) status = bat_svg_feed(text, strlen(text), reader);
    if (status == BAT_OK) return bat_svg_reader_finish(reader, out, report, NULL);
    bat_svg_reader_free(reader);
    return status;
}

static bat_document *opened(const char *text, bat_svg_report *report) {
    bat_document *document = NULL;
    assert_int_equal(read_file(text, true, &document, report), BAT_OK);
    assert_null(bat_document_check(document));
    return document;
}

static char *written(const bat_document *document, bool native) {
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_svg_write(document, native, &text, &size), BAT_OK);
    return text;
}

static int find_foreign(const bat_document *document, int nth) {
    for (int i = 0; i < bat_document_count(document); i++)
        if (bat_object_is_foreign(bat_document_at(document, i)) && nth-- == 0) return i;
    return -1;
}

static int count_foreign(const bat_document *document) {
    int count = 0;
    for (int i = 0; i < bat_document_count(document); i++)
        count += bat_object_is_foreign(bat_document_at(document, i));
    return count;
}

static const char *content(const bat_document *document, int nth) {
    size_t size;
    static char text[20000];
    const int index = find_foreign(document, nth);
    assert_true(index >= 0);
    const char *bytes = bat_picture_bytes(bat_object_picture(bat_document_at(document, index)), &size);
    assert_true(size < sizeof text);
    memcpy(text, bytes, size);
    text[size] = '\0';
    return text;
}

static void box_of(const bat_document *document, int nth, double box[4]) {
    bat_object_bounds(bat_document_at(document, find_foreign(document, nth)), box);
}

/* Each becomes one foreign object with nothing lost, and the file stays what it is. */
static void what_is_shown(void **unused) {
    (void)unused;
    static const struct {
        const char *text;
        double inside[2]; /* a point that its box must hold */
    } cases[] = {
        {HEAD "<text x=\"20\" y=\"50\" font-size=\"20\">Hello</text>" TAIL, {40, 45}},
        {HEAD "<g transform=\"translate(20 10) scale(2)\"><text x=\"5\" y=\"20\">Hello <tspan "
              "x=\"50\">you</tspan></text></g>" TAIL,
         {125, 45}},
        {HEAD "<style>.b{font:bold 40px serif;text-anchor:end}</style><text class=\"b\" x=\"190\" "
              "y=\"60\">Hello</text>" TAIL,
         {110, 50}},
        {HEAD
         "<text style=\"font-size:2em;text-anchor:middle\" x=\"100\" y=\"50\"><![CDATA[a<b]]></text>" TAIL,
         {80, 45}},
        {HEAD
         "<defs><path id=\"p\" d=\"M10 80C60 0 120 0 190 80\"/></defs><text><textPath href=\"#p\">round and "
         "round</textPath></text>" TAIL,
         {100, 15}},
        {HEAD "<filter id=\"f\"><feGaussianBlur stdDeviation=\"2\"/></filter><g filter=\"url(#f)\"><path "
              "d=\"M10 10H90V60Z\"/><text "
              "x=\"9\" y=\"9\">t</text></g>" TAIL,
         {6, 6}},
        {HEAD "<image x=\"10\" y=\"20\" width=\"30\" height=\"30\" "
              "href=\"data:image/gif;base64,R0lGODlhAQABAAAAACw=\"/>" TAIL,
         {12, 22}},
        {HEAD "<switch><text systemLanguage=\"fr\" y=\"9\">non</text><text x=\"20\" "
              "y=\"30\">yes</text></switch>" TAIL,
         {25, 28}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_svg_report report = {0};
        bat_document *document = opened(cases[i].text, &report);
        const bat_losses *lost = &report.lost;
        double box[4];
        assert_int_equal(count_foreign(document), 1);
        assert_int_equal(lost->count[BAT_LOSS_TEXT] + lost->count[BAT_LOSS_FILTER] +
                             lost->count[BAT_LOSS_MASK] + lost->count[BAT_LOSS_PATTERN] +
                             lost->count[BAT_LOSS_IMAGE],
                         0);
        assert_int_equal(report.paths, 1);
        box_of(document, 0, box);
        assert_true(box[0] <= cases[i].inside[0] && cases[i].inside[0] <= box[2]);
        assert_true(box[1] <= cases[i].inside[1] && cases[i].inside[1] <= box[3]);
        char *text = written(document, true);
        assert_string_equal(text, cases[i].text);
        bat_free(text);
        /* The native format holds it, too. */
        size_t size;
        bat_document *again = NULL;
        assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
        assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
        assert_true(bat_document_digest(again) == bat_document_digest(document));
        bat_free(text);
        bat_document_free(again);
        bat_document_free(document);
    }
}

/* How anything blends with what is below it is not shown, and named, whatever else it has; the file keeps it. */
static void how_it_blends_is_named(void **unused) {
    (void)unused;
    static const char *const cases[] = {
        "<path d=\"M0 0H9V9Z\" style=\"mix-blend-mode:multiply\"/>",
        "<text y=\"20\" style=\"mix-blend-mode:multiply\">a</text>",
        "<g style=\"mix-blend-mode:screen\"><path d=\"M0 0H9V9Z\"/><path d=\"M0 0H9V8Z\"/></g>",
        "<filter id=\"f\"/><path d=\"M0 0H9V9Z\" filter=\"url(#f)\" style=\"mix-blend-mode:darken\"/>",
        "<mask id=\"m\"/><path id=\"p\" d=\"M0 0H9V9Z\"/><use href=\"#p\" mask=\"url(#m)\" "
        "style=\"mix-blend-mode:hue\"/>",
        "<style>.a{mix-blend-mode:exclusion}</style><image class=\"a\" width=\"30\" height=\"30\" "
        "href=\"data:image/gif;base64,R0lGODlhAQABAAAAACw=\"/>",
        "<svg style=\"mix-blend-mode:multiply\"><path d=\"M0 0H9V9Z\"/></svg>",
        "<switch style=\"mix-blend-mode:multiply\"><path d=\"M0 0H9V9Z\"/></switch>",
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char file[1000];
        bat_svg_report report = {0};
        snprintf(file, sizeof file, "%s<path d=\"M0 0H90V90H0Z\"/>%s%s", HEAD, cases[i], TAIL);
        bat_document *document = opened(file, &report);
        if (report.lost.count[BAT_LOSS_BLEND] != 1)
            fail_msg("%s: %d", cases[i], report.lost.count[BAT_LOSS_BLEND]);
        char *text = written(document, true);
        assert_string_equal(text, file);
        bat_free(text);
        bat_document_free(document);
    }
}

/* It stands alone: with what is around it and what it refers to, and nothing else; scripts of the root are left out. */
static void what_it_holds(void **unused) {
    (void)unused;
    static const char file[] = "<s:svg xmlns:s=\"http://www.w3.org/2000/svg\" xmlns=\"urn:other\" "
                               "onload=\"alert(1)\" class=\"k\" viewBox=\"5 6 70 80\" "
                               "width=\"7cm\"><s:style>s|text{fill:url(#g2)}</"
                               "s:style><s:defs><s:linearGradient id=\"g\" href=\"#g2\"/><s:linearGradient "
                               "id=\"g2\"><s:stop id=\"a-stop\"/></s:linearGradient><s:clipPath "
                               "id=\"unneeded\"/></s:defs><s:g id=\"around\" "
                               "transform=\"scale(2)\"><s:rect id=\"sibling\" width=\"5\" "
                               "height=\"5\"/><s:text y=\"20\" fill=\"url(#g)\">A &amp; "
                               "&#98;</s:text></s:g></s:svg>";
    bat_document *document = opened(file, NULL);
    const char *text = content(document, 0);
    static const char *const holds[] = {"id=\"g\"",
                                        "id=\"g2\"",
                                        "a-stop",
                                        "id=\"around\"",
                                        "A &amp; &#98;</s:text></s:g></svg></svg>",
                                        "<s:style>",
                                        "class=\"k\"",
                                        "xmlns:s=",
                                        "viewBox=\"5 6 70 80\""};
    static const char *const lacks[] = {"unneeded", "sibling", "alert", "7cm"};
    for (size_t i = 0; i < sizeof holds / sizeof *holds; i++) assert_non_null(strstr(text, holds[i]));
    for (size_t i = 0; i < sizeof lacks / sizeof *lacks; i++) assert_null(strstr(text, lacks[i]));
    bat_svg_reader *reader; /* it is well formed */
    assert_int_equal(bat_svg_reader_create(NULL, &reader), BAT_OK);
    assert_int_equal(bat_svg_feed(text, strlen(text), reader), BAT_OK);
    bat_svg_reader_free(reader);
    bat_document_free(document);
}

/* What cannot stand alone, or is drawn from another place, is counted as what is not shown. */
static void what_is_not_shown(void **unused) {
    (void)unused;
    static const char *const files[] = {
        "<!DOCTYPE svg [<!ENTITY who \"you\">]>" HEAD "<text y=\"20\">&who;</text>" TAIL,
        HEAD "<symbol id=\"s\"><text y=\"20\">a</text></symbol><use href=\"#s\"/>" TAIL,
        HEAD "<flowRoot>a</flowRoot>" TAIL,
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        bat_svg_report report = {0};
        bat_document *document = opened(files[i], &report);
        assert_int_equal(count_foreign(document), 0);
        assert_true(report.lost.count[BAT_LOSS_TEXT] > 0);
        bat_document_free(document);
    }
    bat_svg_report blank = {0};
    bat_document_free(opened(HEAD "<text y=\"20\"> <tspan/></text>" TAIL, &blank));
    assert_int_equal(blank.lost.count[BAT_LOSS_TEXT], 0);
    bat_svg_report report = {0};
    bat_document *document = NULL; /* without the file's text */
    assert_int_equal(read_file(HEAD "<text y=\"20\">a</text>" TAIL, false, &document, &report), BAT_OK);
    assert_int_equal(report.lost.count[BAT_LOSS_TEXT], 1);
    assert_int_equal(count_foreign(document), 0);
    bat_document_free(document);
}

static void move(bat_document *document, int nth, const double m[6]) {
    const int index = find_foreign(document, nth);
    const double *was = bat_object_matrix(bat_document_at(document, index));
    double now[6];
    bat_object *made = NULL;
    for (int k = 0; k < 2; k++) {
        now[k] = m[k] * was[0] + m[2 + k] * was[1];
        now[2 + k] = m[k] * was[2] + m[2 + k] * was[3];
        now[4 + k] = m[k] * was[4] + m[2 + k] * was[5] + m[4 + k];
    }
    assert_int_equal(bat_object_with_matrix(bat_document_at(document, index), now, &made), BAT_OK);
    assert_int_equal(bat_document_replace(document, index, made), BAT_OK);
    bat_object_release(made);
}

/* What is hidden is there, and can be shown: its picture is not hidden. */
static void hidden_content(void **unused) {
    (void)unused;
    static const char *const files[] = {
        HEAD "<text y=\"20\" display=\"none\">a</text>" TAIL,
        HEAD "<g style=\"fill:red;display:none\"><text y=\"20\">a</text></g>" TAIL,
        HEAD "<filter id=\"f\"/><g display='none' filter=\"url(#f)\"><text y=\"20\">a</text></g>" TAIL,
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        bat_svg_report report = {0};
        bat_document *document = opened(files[i], &report);
        assert_int_equal(count_foreign(document), 1);
        assert_int_equal(report.hidden, 1);
        assert_int_equal(report.paths, 1);
        const bat_object *object = bat_document_at(document, find_foreign(document, 0)), *around;
        around = bat_document_at(document, bat_document_find(document, bat_object_parent(object)));
        assert_true(bat_object_is_hidden(around ? around : object));
        assert_null(strstr(content(document, 0), "none"));
        bat_object *shown = NULL;
        assert_int_equal(bat_object_with_state(around ? around : object, false, false, &shown), BAT_OK);
        assert_int_equal(
            bat_document_replace(document, bat_document_find(document, bat_object_id(shown)), shown), BAT_OK);
        bat_object_release(shown);
        char *text = written(document, false);
        assert_non_null(strstr(text, "<text y=\"20\""));
        assert_null(strstr(text, "none"));
        bat_free(text);
        bat_document_free(document);
    }
}

static const char MOVED[] = HEAD
    "<g transform=\"translate(10 5) scale(2)\"><text x=\"5\" y=\"20\" transform=\"rotate(10)\">Hello"
    "</text></g>" TAIL;

/* Moved, saved with and without the native document, and moved again: the element's transform says so, and the box that is
 * read has moved as far. */
static void moved_content(void **unused) {
    (void)unused;
    for (int native = 0; native < 2; native++) {
        bat_document *document = opened(MOVED, NULL);
        double before[4], after[4];
        box_of(document, 0, before);
        for (int times = 0; times < 3; times++) {
            move(document, 0, (double[]){1, 0, 0, 1, 20, 3});
            char *text = written(document, native);
            assert_non_null(strstr(text, ">Hello</text></g><path d=\"M0 90H50\""));
            assert_non_null(strstr(
                text,
                "<g transform=\"translate(10 5) scale(2)\"><text x=\"5\" y=\"20\" transform=\"matrix("));
            bat_document_free(document);
            bat_svg_report report = {0};
            document = opened(text, &report);
            assert_true(report.native == (native == 1));
            bat_free(text);
        }
        box_of(document, 0, after);
        for (int k = 0; k < 4; k++) assert_true(fabs(after[k] - before[k] - (k % 2 ? 9 : 60)) < 1e-6);
        bat_document_free(document);
    }
}

/* Deleted, it is gone; ordered behind the path, its element is; written anew, it is a picture that is read back as it was. */
static void other_edits(void **unused) {
    (void)unused;
    bat_document *document = opened(MOVED, NULL), *again;
    bat_object *kept = bat_object_retain(bat_document_at(document, find_foreign(document, 0)));
    assert_int_equal(bat_document_remove(document, find_foreign(document, 0)), BAT_OK);
    char *text = written(document, false);
    assert_null(strstr(text, "Hello"));
    bat_free(text);
    bat_object *freed = NULL;
    assert_int_equal(bat_object_with_parent(kept, 0, &freed), BAT_OK);
    assert_int_equal(bat_document_insert(document, bat_document_count(document), freed), BAT_OK);
    text = written(document, true);
    again = opened(text, NULL);
    assert_true(bat_object_is_foreign(bat_document_at(again, bat_document_count(again) - 1)));
    bat_free(text);
    bat_document_free(again);
    bat_document_set_origin(document, NULL);
    for (int native = 0; native < 2; native++) {
        bat_svg_report report = {0};
        text = written(document, native);
        assert_non_null(strstr(text, "data:image/svg+xml;base64,"));
        again = opened(text, &report);
        assert_true(report.native == (native == 1) && !report.edited);
        const bat_object *object = bat_document_at(again, find_foreign(again, 0));
        assert_true(bat_picture_digest(bat_object_picture(object)) ==
                    bat_picture_digest(bat_object_picture(kept)));
        assert_memory_equal(bat_object_matrix(object), bat_object_matrix(freed), 6 * sizeof(double));
        move(again, 0, (double[]){1, 0, 0, 1, 7, 0});
        double was[4], now[4];
        box_of(again, 0, was);
        bat_free(text);
        text = written(again, native);
        bat_document_free(again);
        again = opened(text, NULL);
        box_of(again, 0, now);
        for (int k = 0; k < 4; k++) assert_true(fabs(was[k] - now[k]) < 1e-9);
        bat_free(text);
        bat_document_free(again);
    }
    bat_object_release(freed);
    bat_object_release(kept);
    bat_document_free(document);
}

static void allocations(void **unused) {
    (void)unused;
    static const char file[] = HEAD
        "<style>text{fill:red}</style><filter id=\"f\"/><text y=\"20\">a</text><g filter=\"url(#f)\"><path "
        "d=\"M0 0H9V9\"/><text y=\"9\">b</text></g>" TAIL;
    const long before = alloc_live();
    bool failed = true;
    for (long n = 0; failed; n++) {
        bat_document *document = NULL;
        char *text = NULL;
        size_t size;
        alloc_fail_at(n);
        bat_status status = read_file(file, true, &document, NULL);
        if (status == BAT_OK && find_foreign(document, 0) >= 0) {
            bat_object *made = NULL;
            const int index = find_foreign(document, 0);
            status = bat_object_with_matrix(bat_document_at(document, index), (double[]){1, 0, 0, 1, 0, 0},
                                            &made);
            if (status == BAT_OK) status = bat_document_replace(document, index, made);
            bat_object_release(made);
            if (status == BAT_OK) status = bat_svg_write(document, true, &text, &size);
        }
        failed = alloc_fail_reached();
        assert_true(status == BAT_OK || (failed && status == BAT_MEMORY));
        bat_free(text);
        bat_document_free(document);
    }
    alloc_fail_at(-1);
    assert_int_equal(alloc_live(), before);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_is_shown),
                                       cmocka_unit_test(what_it_holds),
                                       cmocka_unit_test(how_it_blends_is_named),
                                       cmocka_unit_test(what_is_not_shown),
                                       cmocka_unit_test(hidden_content),
                                       cmocka_unit_test(moved_content),
                                       cmocka_unit_test(other_edits),
                                       cmocka_unit_test(allocations)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
