/* One drawing, written in two ways: shorthands, units, containers and references beside the plain paths that they stand
 * for, and what is lost on the way. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "format/json/losses.h"
#include "support/pictures.h"
#include "support/xml.h"
#include "text/base64.h"
#include "text/text.h"
#include <batten/bezier.h>

enum { ROOM = 40000 };

/* A whole file, or what stands in a plain svg element. */
static bat_document *read_svg(const char *text, bat_svg_report *report) {
    static char whole[ROOM];
    bat_document *document = NULL;
    bat_problem problem = {"", ""};
    const char *form = strncmp(text, "<?xml?>", 7) ? "<svg viewBox='0 0 100 100'>%s</svg>" : "%s";
    const int size = snprintf(whole, ROOM, form, text);
    assert_true(size > 0 && size < ROOM);
    if (xml_read(whole, NULL, &document, report, &problem) != BAT_OK)
        fail_msg("%s: %s: %s", problem.place, problem.message, text);
    assert_null(bat_document_check(document));
    return document;
}

/* As it is written without the native document: all that can be seen, and nothing else. */
static char *seen(const char *text, bat_svg_report *report) {
    bat_document *document = read_svg(text, report);
    char *out = NULL;
    for (int i = 0; i < bat_document_count(document); i++) { /* shapes as the curves that they are */
        bat_object *path = NULL;
        if (bat_object_to_path(bat_document_at(document, i), &path) != BAT_OK) continue;
        assert_int_equal(bat_document_replace(document, i, path), BAT_OK);
        bat_object_release(path);
    }
    size_t size;
    assert_int_equal(bat_svg_write(document, false, &out, &size), BAT_OK);
    bat_document_free(document);
    return out;
}

static int wrong;

static void same(const char *a, const char *b, const char *lost) {
    bat_svg_report report, plain;
    bat_text found = {0};
    char *x = seen(a, &report), *y = seen(b, &plain);
    bat_losses_to_json(&report.lost, &found);
    bat_text_add(&found, "", 1);
    if (strcmp(x, y)) wrong++, print_message("%s\nis\n%s\nand not\n%s", a, x, y);
    if (strcmp(found.data, lost)) wrong++, print_message("%s: lost %s and not %s\n", a, found.data, lost);
    if (bat_losses_total(&plain.lost)) wrong++, print_message("%s is not plain\n", b);
    bat_text_free(&found);
    bat_free(x);
    bat_free(y);
}

typedef struct pair {
    const char *a, *b, *lost;
} pair;

static void all(const pair *pairs, size_t count) {
    wrong = 0;
    for (size_t i = 0; i < count; i++) same(pairs[i].a, pairs[i].b, pairs[i].lost);
    assert_int_equal(wrong, 0);
}
#define ALL(pairs) all(pairs, sizeof(pairs) / sizeof *(pairs))

#define NOTHING "<g/>"
#define BROKEN "{\"broken\":1}"
#define UNKNOWN "{\"unknown\":1}"
#define BOX "<rect width='6' height='3'/>"
#define BOX_AT "M0 0L6 0L6 3L0 3Z"

static void paths_and_shapes(void **state) {
    (void)state;
    static const pair pairs[] = {
        {"<path d='M0 0C1 2 3 4 5 6S9 8 10 10S12 14 16 16'/>",
         "<path d='M0 0C1 2 3 4 5 6C7 8 9 8 10 10C11 12 12 14 16 16'/>", "{}"},
        {"<path d='M0 0Q2 3 4 0T8 0T12 0'/>", "<path d='M0 0Q2 3 4 0Q6 -3 8 0Q10 3 12 0'/>", "{}"},
        {"<path d='&#10;M\t0 0 L 5 5 H 8\n'/>", "<path d='M0 0L5 5L8 5'/>", "{}"},
        {"<path d='M0 0L5 5L8 5{'/>", "<path d='M0 0L5 5L8 5'/>", UNKNOWN},
        {"<path d='M0 0L5 5L8 5A2 2 0 0'/>", "<path d='M0 0L5 5L8 5'/>", UNKNOWN},
        {"<path d='M0 0L5 5L8 5A2 2 0 0 2 1 1'/>", "<path d='M0 0L5 5L8 5'/>", UNKNOWN},
        {"<rect width='-1' height='2'/>", NOTHING, UNKNOWN},
        {"<rect width='1' height='-2'/>", NOTHING, UNKNOWN},
        {"<rect width='1'/>", NOTHING, "{}"},
        {"<ellipse rx='3'/>", "<circle r='3'/>", "{}"},
        {"<ellipse ry='3'/>", "<circle r='3'/>", "{}"},
        {"<ellipse cx='3'/>", NOTHING, "{}"},
        {"<ellipse rx='3' ry='-2'/>", "<circle r='3'/>", UNKNOWN},
        {"<circle r='-3'/>", NOTHING, UNKNOWN},
        {"<polygon points=' 0,0 6,0 6,3 0,3 '/>", "<path d='" BOX_AT "'/>", "{}"},
        {"<polygon points='0,0 6,0 6,3 0,3 7'/>", "<path d='" BOX_AT "'/>", BROKEN},
        {"<polyline points='0,0 6,0 1e76,2'/>", "<path d='M0 0L6 0'/>", BROKEN},
    };
    ALL(pairs);
}

static void transforms(void **state) {
    (void)state;
#define MOVED(by) "<rect width='6' height='3' transform='" by "'/>"
    static const pair pairs[] = {
        {MOVED(" scale ( 2 ) "), "<path d='M0 0L12 0L12 6L0 6Z'/>", "{}"},
        {MOVED("translate(0 5)"), "<path d='M0 5L6 5L6 8L0 8Z'/>", "{}"},
        {MOVED("translate(3)"), "<path d='M3 0L9 0L9 3L3 3Z'/>", "{}"},
        {MOVED("matrix(1 0 .5 1 0 0)"), "<path d='M0 0L6 0L7.5 3L1.5 3Z'/>", "{}"},
        {MOVED("matrix(1 .5 0 1 0 0)"), "<path d='M0 0L6 3L6 6L0 3Z'/>", "{}"},
        {MOVED("matrix(1 0 0 2 0 0)"), "<path d='M0 0L6 0L6 6L0 6Z'/>", "{}"},
        {MOVED("none"), "<path d='" BOX_AT "'/>", "{}"},
        {MOVED("scale"), "<path d='" BOX_AT "'/>", UNKNOWN},
        {MOVED("scale "), "<path d='" BOX_AT "'/>", UNKNOWN},
        {MOVED("scale("), "<path d='" BOX_AT "'/>", UNKNOWN},
        {MOVED("scale( "), "<path d='" BOX_AT "'/>", UNKNOWN},
        {MOVED("scale(2"), "<path d='" BOX_AT "'/>", UNKNOWN},
        {MOVED("scale(2) rotate"), "<path d='" BOX_AT "'/>", UNKNOWN},
        {MOVED("scale{2}"), "<path d='" BOX_AT "'/>", UNKNOWN},
        {MOVED("sca_le(2)"), "<path d='" BOX_AT "'/>", UNKNOWN},
        {MOVED("matrix(1 2 3 4 5 6 7)"), "<path d='" BOX_AT "'/>", UNKNOWN},
        {MOVED("translate(1e999)"), "<path d='" BOX_AT "'/>", UNKNOWN},
        {"<?xml?><svg viewBox='0 0 100 100' transform='scale(2)'>" BOX "</svg>",
         "<path d='M0 0L12 0L12 6L0 6Z'/>", "{}"},
        {"<?xml?><svg viewBox='0 0 100 100' transform='scale'>" BOX "</svg>", "<path d='" BOX_AT "'/>",
         BROKEN},
    };
    ALL(pairs);
}

static void colours(void **state) {
    (void)state;
#define FILLED(by) "<path d='" BOX_AT "' fill='" by "'/>"
    static const pair pairs[] = {
        {FILLED("&#9;&#10;red&#13;&#12; "), FILLED("#f00"), "{}"},
        {FILLED("#F00"), FILLED("#ff0000"), "{}"},
        {FILLED("#0000ff icc-color(x)"), FILLED("blue"), "{}"},
        {FILLED("RGB( 0%, 100%&#9;, 0% )"), FILLED("lime"), "{}"},
        {FILLED("rgb(300 -4 0)"), FILLED("red"), "{}"},
        {FILLED("hsl(-120, 100%, 50%)"), FILLED("blue"), "{}"},
        {FILLED("hsl(480deg 100% 50%)"), FILLED("lime"), "{}"},
        {FILLED("hsla(0,0%,100%,1)"), FILLED("white"), "{}"},
        {FILLED("#12g"), FILLED("black"), UNKNOWN},
        {FILLED("#1-3"), FILLED("black"), UNKNOWN},
        {FILLED("#1:3"), FILLED("black"), UNKNOWN},
        {FILLED("#12345"), FILLED("black"), UNKNOWN},
        {FILLED("rgb(1,2"), FILLED("black"), UNKNOWN},
        {FILLED("rgb( "), FILLED("black"), UNKNOWN},
        {FILLED("rgb(1,2)"), FILLED("black"), UNKNOWN},
        {FILLED("rgb(1e999,0,0)"), FILLED("black"), UNKNOWN},
        {FILLED("rgb(1,2,3,1,1)"), FILLED("black"), UNKNOWN},
        {FILLED(
             "rgb(0,0,0,0."
             "000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000)"),
         FILLED("black"), UNKNOWN}, /* longer than any colour */
    };
    ALL(pairs);
}

/* What the outermost element says of all. */
static void roots(void **state) {
    (void)state;
    static const pair pairs[] = {
        {"<?xml?><svg viewBox='0 0 100 100' display='none'>" BOX "</svg>", NOTHING, "{\"hidden\":1}"},
        {"<?xml?><svg viewBox='0 0 100 100' opacity='.5'>" BOX BOX "</svg>",
         "<path opacity='.5' d='" BOX_AT "'/><path opacity='.5' d='" BOX_AT "'/>", "{\"opacities\":1}"},
        {"<?xml?><svg viewBox='0 0 100 100' opacity='.5'>" BOX "</svg>",
         "<path opacity='.5' d='" BOX_AT "'/>", "{}"},
        {"<?xml?><svg width=' 100 ' height='100' viewBox='0 0 100 100'>" BOX "</svg>", BOX, "{}"},
        {"<?xml?><svg width=' 100px ' height='100' viewBox='0 0 100 100 '>" BOX "</svg>", BOX, "{}"},
        {"<?xml?><svg viewBox='0 0 10 0'>" BOX "</svg>", "<?xml?><svg>" BOX "</svg>", "{}"},
        {"<?xml?><svg viewBox='0 0 10 10 x'>" BOX "</svg>", "<?xml?><svg>" BOX "</svg>", "{}"},
        {"<?xml?><svg viewBox='0 0 -10 10'>" BOX "</svg>", "<?xml?><svg>" BOX "</svg>", "{}"},
        {"<?xml?><svg viewBox='0 0 10 -10'>" BOX "</svg>", "<?xml?><svg>" BOX "</svg>", "{}"},
    };
    ALL(pairs);
}

static void containers(void **state) {
    (void)state;
    static const pair pairs[] = {
        {"<switch><blob/><foreignObject/><title/>" BOX "<circle r='9'/></switch>", BOX, "{\"switches\":1}"},
        {"<switch><rect width='9' height='9' systemLanguage='es'/>" BOX "</switch>", BOX, "{\"switches\":1}"},
        {"<switch><rect width='9' height='9' systemLanguage='e'/></switch>", NOTHING, "{\"switches\":1}"},
        {"<foreignObject display='none'/><text display='none'/>", NOTHING, "{\"hidden\":2}"},
        {"<g data-locked='true'>" BOX "</g>", "<g sodipodi:insensitive='true'>" BOX "</g>", "{}"},
        {"<g sodipodi:insensitive='false'>" BOX "</g>", BOX, "{}"},
        {"<g data-name='x'><g data-name='y' inkscape:groupmode='layer'>" BOX "</g></g>",
         "<g data-name='x'><g data-name='y'>" BOX "</g></g>", "{}"}, /* no layer in a group */
        {"<a name='x'>" BOX "</a>", BOX, UNKNOWN},
        {"<svg width='10' height='10' viewBox='0 0 5 5'>" BOX "</svg>", "<path d='M0 0L12 0L12 6L0 6Z'/>",
         "{\"nested\":1}"},
        {"<svg width='10' height='20' viewBox='0 0 5 5' preserveAspectRatio='defer xMidYMax'>" BOX "</svg>",
         "<path d='M0 10L12 10L12 16L0 16Z'/>", "{\"nested\":1}"},
        {"<svg width='10' height='10' viewBox='0 0 5 0'>" BOX "</svg>", NOTHING, "{}"},
        {"<svg width='10' height='10' viewBox='0 0 0 5'>" BOX "</svg>", NOTHING, "{}"},
    };
    ALL(pairs);
}

static void references(void **state) {
    (void)state;
    static const pair pairs[] = {
        {"<use x='3'/>", NOTHING, "{\"copies\":1,\"unknown\":1}"},
        {"<use href='a.svg#b'/>", NOTHING, "{\"copies\":1,\"broken\":1}"},
        {"<symbol id='s' display='none'>" BOX "</symbol><use href='#s'/>", NOTHING, "{\"copies\":1}"},
        {"<symbol id='s' viewBox='0 0 5 5'>" BOX "</symbol><use href='#s' width='10' height='10'/>",
         "<path d='M0 0L12 0L12 6L0 6Z'/>", "{\"copies\":1,\"nested\":1}"},
        {"<defs><svg id='s' width='5' height='5' viewBox='0 0 5 5'>" BOX
         "</svg></defs><use href='#s' width='10' height='10' x='3'/>",
         "<path d='M3 0L15 0L15 6L3 6Z'/>", "{\"copies\":1,\"nested\":1}"},
        {"<defs><linearGradient id='a'><stop stop-color='red'/></linearGradient><linearGradient id='b' "
         "href='#a'><title/><stop stop-color='blue'/></linearGradient></defs><path fill='url(#b)' d='" BOX_AT
         "'/>",
         "<path fill='blue' d='" BOX_AT "'/>", "{}"},
        {"<defs><rect id='a' width='6' height='3'/><linearGradient id='b' href='#a'/></defs><path "
         "fill='url(#b)' stroke='red' d='" BOX_AT "'/>",
         "<path fill='none' stroke='red' d='" BOX_AT "'/>", "{}"},
        {"<path fill='red' marker-end='url(#m)' paint-order='markers' d='" BOX_AT "'/>",
         "<path fill='red' d='" BOX_AT "'/>", "{}"},
    };
    ALL(pairs);
}

/* Prefixes, and elements of filters, wherever they stand. */
static void names(void **state) {
    (void)state;
    static const pair pairs[] = {
        {"<svg:rect width='6' height='3'/>", BOX, "{}"},
        {"<g xmlns:s='http://www.w3.org/2000/svg'><s:rect width='6' height='3'/></g>", BOX, "{}"},
        {"<g xmlns:s='http://www.w3.org/2001/svg'><s:rect width='6' height='3'/></g>", NOTHING,
         "{\"foreign\":1}"},
        {"<g xmlns:a-prefix-of-forty-letters-or-so-in-all-and-more='http://www.w3.org/2000/svg'>"
         "<a-prefix-of-forty-letters-or-so-in-all-and-more:rect width='6' height='3'/></g>",
         NOTHING, "{\"foreign\":1}"},
        {"<feBlend/><fe/><fe1/><fea/>", NOTHING, "{\"unknown\":3}"},
        {"<g class=' a  b '>" BOX "</g>", BOX, "{}"},
    };
    ALL(pairs);
}

static void style_sheets(void **state) {
    (void)state;
    static const pair pairs[] = {
        {"<style>/* a * b / */ rect { fill: red } /* not closed *</style>" BOX, FILLED("red"),
         "{\"rules\":1}"},
        {"<style>.a{fill:red}</style><rect width='6' height='3' class=' b a '/>", FILLED("red"),
         "{\"rules\":1}"},
        {"<style>rect{fill:red}.a{}#a|b{fill:blue}</style>" BOX, FILLED("red"), "{\"rules\":3}"},
        {"<style>rect,rect{fill:red}</style>" BOX, FILLED("red"), "{\"rules\":1}"},
    };
    ALL(pairs);
    char deep[2000] = "<style>rect{fill:red}rect";
    for (int i = 0; i < 120; i++) strcat(deep, "#a");
    strcat(deep, "{fill:blue}</style><rect id='a' width='6' height='3'/>");
    same(deep, "<path id='a' d='" BOX_AT "' fill='red'/>", "{\"rules\":2}"); /* more ids than are weighed */
    char long_word[2000] = "<rect width='6' height='3' style='fill:red;stroke:";
    for (int i = 0; i < 200; i++) strcat(long_word, "x");
    strcat(long_word, "'/>");
    same(long_word, FILLED("red"), UNKNOWN);
    char long_id[2000] = "<path d='" BOX_AT "' fill='url(#";
    for (int i = 0; i < 300; i++) strcat(long_id, "x");
    strcat(long_id, ") red'/>");
    same(long_id, FILLED("red"), UNKNOWN);
    assert_int_equal(wrong, 0);
}

/* The innermost of a chain of references, each in an element of this name; how many are broken. */
static int broken_in_chain(const char *element, int links, bool deeper) {
    static char text[ROOM];
    bat_svg_report report;
    char *at = text + sprintf(text, "<defs><g id='c0'>" BOX "</g>");
    for (int i = 1; i <= links; i++)
        at += sprintf(at, "<%s id='c%d'><use href='#c%d'/></%s>", element, i, i - 1, element);
    sprintf(at, "</defs>%s<use href='#c%d'/>%s", deeper ? "<g>" : "", links, deeper ? "</g>" : "");
    bat_document *document = read_svg(text, &report);
    assert_int_equal(report.paths, report.lost.count[BAT_LOSS_BROKEN] ? 0 : 1);
    bat_document_free(document);
    return report.lost.count[BAT_LOSS_BROKEN];
}

/* What is too deep is left out, and said; groups beyond the deepest are dissolved. */
static void depths(void **state) {
    (void)state;
    for (int deeper = 0; deeper < 2; deeper++) {
        assert_int_equal(broken_in_chain("g", 100, deeper), 0);
        assert_int_equal(broken_in_chain("g", 200, deeper), 1);
        assert_int_equal(broken_in_chain("symbol", 100, deeper), 0);
        assert_int_equal(broken_in_chain("symbol", 200, deeper), 1);
    }
    char text[6000] = "";
    bat_svg_report report;
    for (int i = 0; i < 70; i++) strcat(text, "<g data-name='x'>");
    strcat(text, BOX);
    for (int i = 0; i < 70; i++) strcat(text, "</g>");
    bat_document *document = read_svg(text, &report);
    assert_int_equal(bat_document_count(document), 65); /* 64 groups at most */
    assert_int_equal(bat_losses_total(&report.lost), 0);
    bat_document_free(document);
}

/* A picture of 40 x 20 pixels: its matrix by what the element says of its size. */
static void images(void **state) {
    (void)state;
    static const struct {
        const char *attributes;
        double matrix[6];
        const char *lost;
    } cases[] = {
        {"", {1, 0, 0, 1, 0, 0}, "{}"},
        {"x='3' y='4' width='80' height='40'", {2, 0, 0, 2, 3, 4}, "{}"},
        {"width='80'", {2, 0, 0, 2, 0, 0}, "{}"},
        {"height='40'", {2, 0, 0, 2, 0, 0}, "{}"},
        {"width='auto' height='10'", {.5, 0, 0, .5, 0, 0}, "{}"},
        {"width='80' height='80'", {2, 0, 0, 2, 0, 20}, "{}"},
        {"width='80' height='80' preserveAspectRatio='none'", {2, 0, 0, 4, 0, 0}, "{}"},
        {"width='80' height='80' preserveAspectRatio='xMinYMin'", {2, 0, 0, 2, 0, 0}, "{}"},
        {"width='80' height='80' preserveAspectRatio='xMaxYMax meet'", {2, 0, 0, 2, 0, 40}, "{}"},
        {"width='80' height='80' preserveAspectRatio='xMidYMid slice'",
         {4, 0, 0, 4, -40, 0},
         "{\"clips\":1}"},
        {"transform='translate(5 7)'", {1, 0, 0, 1, 5, 7}, "{}"},
    };
    unsigned char bytes[HEAD_ROOM];
    bat_text data = {0};
    bat_base64_write(&data, bytes, head_png(bytes, 40, 20));
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1000];
        bat_svg_report report;
        bat_text found = {0};
        snprintf(text, sizeof text, "<image %s href='data:image/png;base64,%.*s'/>", cases[i].attributes,
                 (int)data.size, data.data);
        bat_document *document = read_svg(text, &report);
        assert_int_equal(bat_document_count(document), 1);
        const double *matrix = bat_object_matrix(bat_document_at(document, 0));
        for (int k = 0; k < 6; k++)
            if (matrix[k] != cases[i].matrix[k]) fail_msg("%s: %d: %g", cases[i].attributes, k, matrix[k]);
        bat_losses_to_json(&report.lost, &found);
        bat_text_add(&found, "", 1);
        assert_string_equal(found.data, cases[i].lost);
        bat_text_free(&found);
        bat_document_free(document);
    }
    bat_text_free(&data);
    static const pair pairs[] = {
        {"<image visibility='hidden' href='data:image/png;base64,AAAA'/>", NOTHING, "{\"hidden\":1}"},
        {"<image/>", NOTHING, "{\"hidden\":1}"},
        {"<image href='data:,'/>", NOTHING, "{\"images\":1}"},
        {"<image href='data:image/png,AAAA'/>", NOTHING, "{\"images\":1}"},
    };
    ALL(pairs);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(paths_and_shapes),
                                       cmocka_unit_test(transforms),
                                       cmocka_unit_test(colours),
                                       cmocka_unit_test(roots),
                                       cmocka_unit_test(containers),
                                       cmocka_unit_test(references),
                                       cmocka_unit_test(names),
                                       cmocka_unit_test(style_sheets),
                                       cmocka_unit_test(depths),
                                       cmocka_unit_test(images)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
