/* Patterns: what a curve is painted with, kept by the file, by both formats and by edits. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "document/object.h"
#include "document/paint.h"
#include "editor/edit/affine.h"
#include "format/svg/write/feed.h"
#include "support/alloc_fail.h"
#include "support/svg_kept.h"
#include <batten/bezier.h>
#include <batten/format.h>

#include <math.h>
#include <stdlib.h>

#define HEAD "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
#define DOTS(more) "<pattern id='p' " more "><circle cx='1' cy='1' r='1' fill='red'/></pattern>"
#define TILE "width='8' height='4' patternUnits='userSpaceOnUse'"

static bat_svg_report report;

static bat_status read_file(const char *text, bat_document **out) {
    return svg_read_kept(NULL, text, strlen(text), out, &report);
}

/* By a reader that has not got the file's text. */
static bat_document *read_parts(const char *text) {
    bat_svg_reader *reader;
    bat_document *document = NULL;
    assert_int_equal(bat_svg_reader_create(NULL, &reader), BAT_OK);
    assert_int_equal(bat_svg_feed(text, strlen(text), reader), BAT_OK);
    assert_int_equal(bat_svg_reader_finish(reader, &document, &report, NULL), BAT_OK);
    return document;
}

static bat_document *opened(const char *content) {
    char text[6000];
    bat_document *document = NULL;
    snprintf(text, sizeof text, HEAD "%s</svg>", content);
    assert_int_equal(read_file(text, &document), BAT_OK);
    return document;
}

static const bat_gradient *fill_of(const bat_document *document) {
    const bat_paint *paint = bat_object_paint(bat_document_at(document, 0));
    assert_non_null(paint);
    assert_non_null(paint->fill.tile);
    return &paint->fill;
}

static const char *text_of(const bat_picture *tile) {
    static char text[6000];
    size_t size;
    const void *bytes = bat_picture_bytes(tile, &size);
    assert_true(size < sizeof text);
    memcpy(text, bytes, size);
    text[size] = '\0';
    return text;
}

/* Where the corners of the tile lie, by SVG 2, 14.3: the origin, the end of its first row, the end of its first column. */
static void places(void **unused) {
    (void)unused;
    static const struct {
        const char *pattern, *shape;
        double corners[6];
    } cases[] = {
        {TILE, "<path d='M0 0H50V20Z' fill='url(#p)'/>", {0, 0, 8, 0, 0, 4}},
        {TILE " x='3' y='-1'", "<path d='M0 0H50V20Z' fill='url(#p)'/>", {3, -1, 11, -1, 3, 3}},
        {TILE " x='1' patternTransform='translate(5 6) rotate(90)'",
         "<path d='M0 0H50V20Z' fill='url(#p)'/>",
         {5, 7, 5, 15, 1, 7}},
        {TILE,
         "<g transform='scale(2 3)'><rect width='9' height='9' fill='url(#p)'/></g>",
         {0, 0, 16, 0, 0, 12}},
        {"width='.5' height='.25'",
         "<rect x='10' y='20' width='40' height='8' fill='url(#p)'/>",
         {10, 20, 30, 20, 10, 22}},
        {"width='50%' height='25%' x='.25'",
         "<rect x='10' y='20' width='40' height='8' fill='url(#p)'/>",
         {20, 20, 40, 20, 20, 22}},
        {"width='.5' height='.5' patternContentUnits='objectBoundingBox'",
         "<circle cx='50' cy='50' r='10' fill='url(#p)'/>",
         {40, 40, 50, 40, 40, 50}},
        {TILE " viewBox='0 0 2 2'", "<path d='M0 0H50V20Z' fill='url(#p)'/>", {0, 0, 8, 0, 0, 4}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char content[2000];
        snprintf(content, sizeof content,
                 "<pattern id='p' %s><circle cx='1' cy='1' r='1' fill='red'/></pattern>%s", cases[i].pattern,
                 cases[i].shape);
        bat_document *document = opened(content);
        const bat_gradient *g = fill_of(document);
        const double *m = g->matrix;
        double sides[2];
        assert_int_equal(bat_losses_total(&report.lost), 0);
        assert_int_equal(bat_object_curve_count(bat_document_at(document, 0)), 1);
        bat_picture_sides(g->tile, sides);
        const double found[6] = {m[4],
                                 m[5],
                                 m[4] + m[0] * sides[0],
                                 m[5] + m[1] * sides[0],
                                 m[4] + m[2] * sides[1],
                                 m[5] + m[3] * sides[1]};
        for (int k = 0; k < 6; k++)
            if (!(fabs(found[k] - cases[i].corners[k]) <= 1e-9))
                fail_msg("case %zu, %d: %g is %g", i, k, found[k], cases[i].corners[k]);
        bat_document_free(document);
    }
}

/* What is repeated has what it takes from around it and from elsewhere in the file, and nothing that leads out of it. */
static void tiles(void **unused) {
    (void)unused;
    bat_document *document = opened(
        "<style>.a{fill:#123}</style><linearGradient id='g'><stop offset='0'/><stop "
        "offset='1' stop-color='blue'/></linearGradient><pattern id='q' " TILE
        " stroke='lime' onload='x()'><path class='a' d='M0 0H3V3Z' "
        "stroke='url(#g)'/></pattern><pattern id='p' href='#q' x='1'/><rect "
        "width='9' height='9' fill='url(#p)' fill-opacity='.4'/>");
    const bat_gradient *g = fill_of(document);
    const char *text = text_of(g->tile);
    assert_non_null(strstr(text, "class='a'"));
    assert_non_null(strstr(text, ".a{fill:#123}"));
    assert_non_null(strstr(text, "linearGradient id='g'"));
    assert_non_null(strstr(text, "stroke=\"lime\""));
    assert_null(strstr(text, "onload"));
    assert_true(g->stops[0].colour == 0x80808066 && g->stops[1].colour == 0x80808066);
    assert_true(fabs(g->matrix[4] - 1) < 1e-12);
    bat_document_free(document);
}

/* Without a size or content it paints nothing, in a marker it is replaced, and one that holds itself ends. */
static void odd_ones(void **unused) {
    (void)unused;
    static const char *const nothing[] = {DOTS("width='0' height='4' patternUnits='userSpaceOnUse'"),
                                          DOTS("width='-1' height='4'"),
                                          DOTS("height='1'"),
                                          "<pattern id='p' " TILE "/>",
                                          DOTS(TILE " viewBox='0 0 0 4'"),
                                          DOTS("width='nan' height='1e999'"),
                                          DOTS(TILE " patternTransform='scale(0)'")};
    char content[2000];
    for (size_t i = 0; i < sizeof nothing / sizeof *nothing; i++) {
        snprintf(content, sizeof content, "%s<rect width='9' height='9' fill='url(#p)' stroke='red'/>",
                 nothing[i]);
        bat_document *document = opened(content);
        if (bat_object_style(bat_document_at(document, 0))->filled) fail_msg("case %zu is filled", i);
        assert_null(bat_object_paint(bat_document_at(document, 0)));
        bat_document_free(document);
    }
    bat_document *document = opened("<pattern id='p' href='#r' " TILE "><rect width='4' height='4' "
                                    "fill='url(#p)'/></pattern><pattern id='r' href='#p'/>"
                                    "<rect width='9' height='9' fill='url(#p)'/>");
    (void)fill_of(document);
    bat_document_free(document);
    document = opened(DOTS(TILE) "<marker id='m'><rect width='3' height='3' fill='url(#p)'/></marker><path "
                                 "d='M0 0H9' stroke='red' marker-end='url(#m)'/>");
    assert_int_equal(bat_document_count(document), 1);
    bat_document_free(document);
}

static char *written(const bat_document *document, bool svg) {
    char *text = NULL;
    size_t size;
    const bat_status status = svg ? bat_svg_write(document, true, &text, &size)
                                  : bat_document_write(document, &text, &size);
    assert_int_equal(status, BAT_OK);
    return text;
}

static bat_document *mapped(const bat_document *document, const double m[6]) {
    bat_document *made = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_document_create(&made), BAT_OK);
    assert_int_equal(bat_affine_object(bat_document_at(document, 0), m, true, &object), BAT_OK);
    assert_int_equal(bat_document_insert(made, 0, object), BAT_OK);
    bat_object_release(object);
    return made;
}

/* Both formats bring back the paint bit for bit, also without the native data, and after maps of the plane. */
static void is_kept(void **unused) {
    (void)unused;
    static const double maps[][6] = {{1, 0, 0, 1, 0, 0},
                                     {1, 0, 0, 1, 7.25, -3},
                                     {0.6, 0.8, -0.8, 0.6, 1, 2},
                                     {-1, 0, 0, 3, 50, 0.1},
                                     {1, 0.3, 0.2, 1.7, 0, 9}};
    bat_document *source = opened(
        DOTS(TILE " x='1'") "<path d='M10 10H60V40Z' fill='url(#p)' stroke='url(#p)' "
                            "fill-opacity='.3'/>");
    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++) {
        bat_document *document = mapped(source, maps[i]);
        const bat_gradient *was = fill_of(source), *now = fill_of(document);
        for (int k = 0; k < 2; k++) {
            const double corner = maps[i][k] * was->matrix[4] + maps[i][2 + k] * was->matrix[5] +
                                  maps[i][4 + k];
            assert_true(fabs(now->matrix[4 + k] - corner) <= 1e-12 * (1 + fabs(corner)));
        }
        char *native = written(document, false);
        bat_document *back = NULL;
        bat_problem problem;
        assert_int_equal(bat_document_read(native, strlen(native), &back, &problem), BAT_OK);
        assert_true(bat_document_digest(back) == bat_document_digest(document));
        assert_non_null(strstr(native, "{\"batten\":9"));
        bat_document_free(back);
        bat_free(native);
        char *svg = written(document, true);
        assert_int_equal(read_file(svg, &back), BAT_OK);
        assert_true(report.native && !report.edited);
        bat_document_free(back);
        char *data = strstr(svg, "<metadata"), *end = strstr(svg, "</metadata>");
        if (data && end) memset(data, ' ', (size_t)(end - data) + strlen("</metadata>"));
        assert_int_equal(read_file(svg, &back), BAT_OK);
        assert_false(report.native);
        const bat_paint *a = bat_object_paint(bat_document_at(document, 0)),
                        *b = bat_object_paint(bat_document_at(back, 0));
        assert_true(a->fill.tile != b->fill.tile &&
                    bat_picture_digest(a->fill.tile) == bat_picture_digest(b->fill.tile));
        for (int k = 0; k < 6; k++) assert_true(fabs(a->fill.matrix[k] - b->fill.matrix[k]) <= 1e-9);
        assert_true(a->fill.stops[0].colour == b->fill.stops[0].colour);
        assert_non_null(b->stroke.tile);
        bat_document_free(back);
        back = read_parts(svg);
        assert_non_null(fill_of(back));
        bat_document_free(back);
        bat_free(svg);
        bat_document_free(document);
    }
    bat_document_free(source);
}

/* A picture that fills the tile is the tile. */
static void pictures(void **unused) {
    (void)unused;
    static const char dot[] =
        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR42mNk+A8AAQUBAScY42YAAAAASUVORK5CYII=";
    char content[2000];
    for (int whole = 0; whole < 2; whole++) {
        snprintf(content, sizeof content,
                 "<pattern id='p' patternUnits='userSpaceOnUse' width='6' height='6'><image width='%d' "
                 "height='6' opacity='.5' "
                 "preserveAspectRatio='none' href='data:image/png;base64,%s'/></pattern><rect width='9' "
                 "height='9' "
                 "fill='url(#p)'/>",
                 whole ? 6 : 5, dot);
        bat_document *document = opened(content);
        const bat_gradient *g = fill_of(document);
        assert_string_equal(bat_picture_type(g->tile), whole ? "image/png" : "image/svg+xml");
        assert_true(!whole ||
                    (g->matrix[0] == 6 && g->matrix[3] == 6 && (g->stops[0].colour & 0xff) == 0x80));
        bat_document_free(document);
    }
}

/* What no pattern is, and a colour that takes its place. */
static void the_paint_is_checked(void **unused) {
    (void)unused;
    bat_document *document = opened(DOTS(TILE) "<rect width='9' height='9' fill='url(#p)'/>");
    const bat_object *object = bat_document_at(document, 0);
    const bat_paint good = *bat_object_paint(object);
    bat_object *made = NULL;
    for (int i = 0; i < 8; i++) {
        bat_paint paint = good;
        bat_stop stops[2] = {good.fill.stops[0], good.fill.stops[1]};
        paint.fill.stops = stops;
        if (i == 0) paint.fill.spread = BAT_SPREAD_PAD;
        if (i == 1) paint.fill.to[0]++;
        if (i == 2) paint.fill.from[1] = 1;
        if (i == 3) stops[0].colour ^= 0x100;
        if (i == 4) stops[0].colour ^= 1;
        if (i == 5) stops[1].at = 0.5;
        if (i == 6) paint.fill.matrix[0] = paint.fill.matrix[1] = 0;
        const bat_status status = bat_object_with_paint(object, &paint, &made);
        if (status != (i < 7 ? BAT_NUMBER : BAT_OK)) fail_msg("case %d: %d", i, status);
    }
    assert_true(bat_digest_object(0, made) == bat_digest_object(0, object));
    bat_object_release(made);
    bat_style style = *bat_object_style(object);
    style.fill = 0xff0000ff;
    assert_int_equal(bat_object_with_style(object, &style, &made), BAT_OK);
    assert_null(bat_object_paint(made));
    bat_object_release(made);
    bat_document_free(document);
}

static void memory_may_run_out(void **unused) {
    (void)unused;
    static const char text[] = HEAD DOTS(TILE) "<rect width='9' height='9' fill='url(#p)'/><circle r='9' "
                                               "fill='url(#p)' stroke='url(#p)'/></svg>";
    const long before = alloc_live();
    for (int n = 1;; n++) {
        bat_document *document = NULL;
        alloc_fail_at(n);
        const bat_status status = read_file(text, &document);
        const bool failed = alloc_fail_reached();
        alloc_fail_at(0);
        if (status != BAT_OK && status != BAT_MEMORY) fail_msg("allocation %d: %d", n, status);
        bat_document_free(document);
        assert_true(alloc_live() == before);
        if (!failed) {
            assert_true(status == BAT_OK && n > 20);
            return;
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places),
        cmocka_unit_test(tiles),
        cmocka_unit_test(odd_ones),
        cmocka_unit_test(is_kept),
        cmocka_unit_test(pictures),
        cmocka_unit_test(the_paint_is_checked),
        cmocka_unit_test(memory_may_run_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
