/* Shapes that style sheets speak of by type, class, id, attribute and neighbours: what is edited keeps its look, and so does all
 * else; what still is a rectangle, a circle, an ellipse or a line stays one. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "editor/edit/affine.h"
#include "document/document.h"
#include "document/markers.h"
#include "support/svg_kept.h"
#include <batten/bezier.h>
#include <batten/curve.h>
#include <batten/format.h>

#define HEAD "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 200 100'><title>T</title>"
#define MARKER                                                                                               \
    "<marker id='m' markerWidth='4' markerHeight='4' orient='auto'><path d='M0 0L4 2L0 4' "                  \
    "style='marker-end:none'/></marker>"

static const char *const RULED[] = {
    "<style>rect{fill:green;stroke:red;stroke-width:4}</style><rect x='10' y='10' width='30' height='30' "
    "fill='none' "
    "stroke='blue'/>",
    "<style>[width='30']{fill:green} rect{opacity:.5}</style><rect x='10' y='10' width='30' height='30'/>",
    "<style>.b{fill:green} rect.b{stroke:blue} path.b{fill:red}</style><rect class='b' width='30' "
    "height='30'/>"
    "<circle class='b' cx='100' cy='50' r='20'/>",
    "<style>#a{fill:green} path#a{stroke:blue}</style><rect id='a' width='30' height='30'/>",
    "<style>rect{fill:green!important} path{fill:red!important;stroke:blue!important}</style>"
    "<rect width='30' height='30' style='fill:blue'/>",
    "<style>rect+circle{fill:green} rect~ellipse{stroke:red}</style><rect width='30' height='30'/>"
    "<circle cx='100' cy='50' r='20'/><ellipse cx='160' cy='50' rx='20' ry='10'/>",
    "<style>g{fill:green;stroke:red} g path{fill:blue}</style><g><rect width='30' height='30'/></g>",
    "<style>rect{visibility:visible} path{display:none}</style><rect width='30' height='30'/>",
    "<style>rect{fill-opacity:.5;fill:#0f0} path{stroke-opacity:.2}</style><rect style='fill:red' width='30' "
    "height='30'/>",
    "<style>path,line{marker-end:url(#m)} .box{fill:#eef}</style>" MARKER
    "<rect class='box' width='30' height='30'/><line x1='60' y1='10' x2='100' y2='50' stroke='red'/>",
    "<style>rect:nth-of-type(2){fill:red} rect:last-of-type{stroke:blue} "
    "path:first-of-type{fill:lime}</style>"
    "<rect width='30' height='30'/><rect x='60' width='30' height='30'/><path d='M150 50h20v20z'/>",
    "<style>g rect:only-child{fill:red} circle:only-of-type{fill:blue} :is(rect,x){stroke:red}</style>"
    "<g><rect width='30' height='30'/></g><circle cx='100' cy='50' r='20'/>",
    "<style>svg :not(rect,path){fill:blue} rect:nth-last-child(2){opacity:.5}</style>"
    "<rect width='30' height='30'/><circle cx='100' cy='50' r='20'/>",
    MARKER "<g marker-end='url(#m)' stroke='black'><rect width='30' height='30'/></g>",
};

static bat_document *opened(const char *body) {
    char text[2000];
    bat_document *document = NULL;
    snprintf(text, sizeof text, "%s%s</svg>", HEAD, body);
    assert_int_equal(svg_read_kept(NULL, text, strlen(text), &document, NULL), BAT_OK);
    return document;
}

static void map(bat_document *document, int index, const double rows[6]) {
    bat_object *made = NULL;
    const bat_object *object = bat_document_at(document, index);
    const double m[6] = {rows[0], rows[3], rows[1], rows[4], rows[2], rows[5]};
    assert_int_equal(bat_object_curve_count(object), 1);
    assert_int_equal(bat_affine_object(object, m, false, &made), BAT_OK);
    assert_int_equal(bat_document_replace(document, index, made), BAT_OK);
    bat_object_release(made);
}

/* The drawn objects look as they do in the document. */
static void expect_looks(const bat_document *document, const char *text) {
    bat_document *seen = NULL;
    assert_int_equal(svg_read_kept(NULL, text, strlen(text), &seen, NULL), BAT_OK);
    assert_int_equal(bat_document_count(seen), bat_document_count(document));
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i), *other = bat_document_at(seen, i);
        const bat_style *a = bat_object_style(object), *b = bat_object_style(other);
        assert_int_equal(bat_object_is_hidden(object), bat_object_is_hidden(other));
        assert_int_equal(a->filled, b->filled);
        assert_int_equal(a->stroked, b->stroked);
        if (a->filled) assert_int_equal(a->fill, b->fill);
        if (a->stroked) assert_int_equal(a->stroke, b->stroke);
        if (a->stroked) assert_true(a->width == b->width);
        assert_true(a->opacity == b->opacity);
        assert_int_equal(bat_object_markers(object) != NULL, bat_object_markers(other) != NULL);
    }
    bat_document_free(seen);
}

static void ruled_shapes_keep_their_look(void **state) {
    (void)state;
    static const double maps[][6] = {{1, 0, 5, 0, 1, 3}, {1, 0, 5, .5, 1, 3}};
    for (size_t i = 0; i < sizeof RULED / sizeof *RULED; i++)
        for (int how = 0; how < 2; how++)
            for (int k = 0;; k++) {
                bat_document *document = opened(RULED[i]);
                char *text = NULL;
                size_t size;
                while (k < bat_document_count(document) &&
                       bat_object_curve_count(bat_document_at(document, k)) == 0)
                    k++;
                const bool done = k >= bat_document_count(document);
                if (!done) {
                    map(document, k, maps[how]);
                    assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
                    if (!strstr(text, "<title>T</title>")) fail_msg("%s is written anew: %s", RULED[i], text);
                    expect_looks(document, text);
                }
                bat_free(text);
                bat_document_free(document);
                if (done) break;
            }
}

static void shapes_stay_what_they_are(void **state) {
    (void)state;
    static const struct {
        const char *before;
        double map[6];
        const char *after;
    } cases[] = {
        {"<rect x='1' y='2' width='30' height='10' rx='3'/>",
         {1, 0, 4, 0, 1, 5},
         "<rect x=\"5\" y=\"7\" width='30' height='10' rx='3'/>"},
        {"<rect width='30' height='10' rx='3'/>",
         {2, 0, 0, 0, 1, 0},
         "<rect width=\"60\" height='10' rx=\"6\" ry=\"3\"/>"},
        {"<g transform='scale(2)'><rect width='5mm' height='10'/></g>", {2, 0, 0, 0, 1, 0}, "height='10'/>"},
        {"<circle cx='9' cy='9' r='5'/>", {2, 0, 1, 0, 2, 0}, "<circle cx=\"19\" cy=\"18\" r=\"10\"/>"},
        {"<circle cx='9' cy='9' r='5'/>", {2, 0, 0, 0, 1, 0}, "<path "},
        {"<ellipse cx='9' cy='9' rx='5' ry='3'/>",
         {2, 0, 0, 0, 1, 0},
         "<ellipse cx=\"18\" cy='9' rx=\"10\" ry='3'/>"},
        {"<line x2='9' y2='4' stroke='red'/>",
         {1, 0, 2, 0, 1, 3},
         "<line x2=\"11\" y2=\"7\" stroke='red' x1=\"2\" y1=\"3\"/>"},
        {"<rect width='30' height='10' x='0'/>",
         {0, -1, 0, 1, 0, 0},
         "<rect width=\"10\" height=\"30\" x=\"-10\"/>"},
        {"<rect width='30' height='10' stroke='red' stroke-dasharray='2 3'/>",
         {0, -1, 0, 1, 0, 0},
         "<path "}, /* they would begin elsewhere */
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_document *document = opened(cases[i].before);
        char *text = NULL;
        size_t size;
        map(document, bat_document_count(document) - 1, cases[i].map);
        assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
        if (!strstr(text, cases[i].after)) fail_msg("%s: %s", cases[i].before, text);
        expect_looks(document, text);
        bat_free(text);
        bat_document_free(document);
    }
}

/* What a transform lays flat can leave its line only in a file that is written anew. */
static void what_the_file_cannot_say_is_told(void **state) {
    (void)state;
    static const double slide[6] = {1, 0, 5, 0, 1, 0}, rise[6] = {1, 0, 0, .5, 1, 0};
    static const char flat[] = "<g transform='matrix(1 0 0 0 0 60)'><path d='M60 0C140 20 220 100 320 60' "
                               "stroke='red'/></g>";
    char *text = NULL;
    size_t size;
    bat_document *document = opened("<rect width='30' height='10'/>"), *plain = NULL;
    map(document, 0, slide);
    assert_int_equal(bat_svg_write_kept(document, true, BAT_SVG_UNSEEN, &text, &size), BAT_OK);
    assert_non_null(strstr(text, "<title>T</title>"));
    bat_free(text), text = NULL;
    bat_document_free(document);
    document = opened(flat);
    map(document, bat_document_count(document) - 1, rise);
    assert_int_equal(bat_svg_write_kept(document, true, BAT_SVG_UNSEEN, &text, &size), BAT_UNSUPPORTED);
    assert_null(text);
    assert_int_equal(bat_svg_write(document, true, &text, &size), BAT_OK);
    assert_null(strstr(text, "<title>T</title>"));
    bat_free(text), text = NULL;
    bat_document_free(document);
    assert_int_equal(bat_document_create(&plain), BAT_OK);
    assert_int_equal(bat_svg_write_kept(plain, true, BAT_SVG_UNSEEN, &text, &size), BAT_STATE);
    bat_document_free(plain);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ruled_shapes_keep_their_look),
        cmocka_unit_test(shapes_stay_what_they_are),
        cmocka_unit_test(what_the_file_cannot_say_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
