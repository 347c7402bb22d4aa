/* What an SVG file contains that a document cannot hold: each kind is found, once per element, and nothing is reported
 * where nothing is lost. Also the paint used in place of a gradient. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "format/json/losses.h"
#include "format/svg/names.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/xml.h"
#include <batten/bezier.h>
#include <batten/document.h>

#define LINE "<path d='M0 0L5 5' stroke='red' "
#define BOX "<rect width='5' height='5' "

static bat_document *read_whole(const char *text, bat_svg_report *report) {
    bat_document *document = NULL;
    bat_problem problem = {"", ""};
    if (xml_read(text, NULL, &document, report, &problem) != BAT_OK)
        fail_msg("%s: %s: %s", problem.place, problem.message, text);
    return document;
}

/* What stands in a plain svg element. */
static bat_losses losses_of(const char *content) {
    char text[4000];
    bat_svg_report report;
    snprintf(text, sizeof text, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'>%s</svg>",
             content);
    bat_document_free(read_whole(text, &report));
    return report.lost;
}

static void expect(const char *content, const char *expected) {
    bat_losses lost = losses_of(content);
    bat_text found = {0};
    bat_losses_to_json(&lost, &found);
    bat_text_add(&found, "", 1);
    if (strcmp(found.data, expected) != 0)
        fail_msg("%s: expected %s, found %s", content, expected, found.data);
    bat_text_free(&found);
}

static void nothing_is_lost(void **state) {
    (void)state;
    static const char *const files[] = {
        "",
        LINE "fill='none' stroke-linecap='round' stroke-miterlimit='0' stroke-dasharray='none' "
             "style='stroke-width:2;opacity:.5'/>",
        "<g id='a' transform='rotate(30)scale(2)' fill='#123' class='x'>" BOX "rx='1'/></g><circle r='3'/>",
        "<g inkscape:groupmode='layer' inkscape:label='L' sodipodi:insensitive='true'>" BOX "/></g>",
        "<g opacity='.5'>" BOX "/></g><a>" BOX "/></a>",             /* one thing: its own opacity */
        "<g opacity='.5'>" BOX "/>" BOX "/></g>",                    /* the group's */
        BOX "display='none'/><g style='display:none'>" BOX "/></g>", /* kept, hidden */
        BOX "stroke-dasharray='1 2' vector-effect='non-scaling-stroke' "
            "marker-end='url(#m)'/>", /* without a stroke */
        LINE "style='font-size:12px;text-anchor:middle;-inkscape-stroke:none;line-height:1.2;"
             "--mine:3'/>",
        LINE "paint-order='stroke' fill='none'/>",
        "<metadata/><defs/><path d='M5 5z'/><g/>",
    };
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) expect(files[i], "{}");
}

static void every_kind_is_found(void **state) {
    (void)state;
    static const char *const cases[][2] = {
        {"<text>a<tspan>b</tspan></text><flowRoot><p/></flowRoot><text display='none'/>",
         "{\"texts\":2,\"hidden\":1}"},
        {"<image href='x.png'/><image href='data:image/gif;base64,AAAA'/>", "{\"images\":2}"},
        {BOX "clip-path='url(#c)'/><g style='clip-path:circle()'/>" BOX "clip-path='none'/>",
         "{\"clips\":1}"},
        {"<mask id='k'><rect width='9' height='9'/></mask>" BOX "mask='url(#k)'/>" BOX "mask='url(#no)'/>",
         "{\"masks\":1}"},
        {"<g filter='blur(2px)'>" BOX "filter='url(#f)'/></g>", "{\"filters\":2}"},
        {"<marker id='m'><text>a</text></marker><g marker-mid='url(#m)'>" LINE "/>" BOX "stroke='red'/>" LINE
         "marker='none'/></g>",
         "{\"texts\":1,\"markers\":1}"},
        {"<g stroke-dasharray='1 2'>" LINE "/>" LINE "stroke-dasharray='none'/>" LINE "stroke='none'/></g>",
         "{}"},
        {"<g stroke-dasharray='1 bad'>" LINE "/>" LINE "stroke-dasharray='none'/></g>", "{\"dashes\":1}"},
        {LINE "paint-order='markers' marker-end='url(#m)'/>", "{}"}, /* there is no such marker */
        {"<marker id='m'><path d='M0 0L1 1L2 0'/></marker>" LINE
         "paint-order='markers' marker-end='url(#m)'/>",
         "{}"},
        {LINE "vector-effect='non-scaling-stroke' transform='scale(2,3)'/>", "{\"effects\":1}"},
        {LINE "transform='scale(1,3)'/>" BOX "transform='scale(1,3)'/>", "{}"},
        {BOX "/>" BOX "style='mix-blend-mode:multiply'/><g style='isolation:isolate'/>",
         "{\"blends\":1,\"unknown\":1}"},
        {"<symbol id='s'>" BOX "/>" BOX "/></symbol><use href='#s' opacity='.5'/>",
         "{\"opacities\":1,\"copies\":1}"},
        {"<g shape-rendering='crispEdges'>" BOX "/>" BOX "shape-rendering='auto'/></g>", "{\"hints\":1}"},
        {BOX "id='a'/><use href='#a'/><use xlink:href='#a' x='9'/>", "{\"copies\":2}"},
        {"<svg width='5' height='5'>" BOX "/></svg><svg width='4' height='5'>" BOX "/></svg>",
         "{\"nested\":1}"}, /* where something is cut off */
        {BOX "style='mix-blend-mode:multiply'/>" BOX "transform='translate(9)' opacity='.5'/>", "{}"},
        {"<g id='a'>" BOX "/>" BOX "x='9'/></g><use href='#a' opacity='.5' y='9'/>", "{\"copies\":1}"},
        {BOX "color-rendering='optimizeSpeed' color-interpolation='linearRGB'/>", "{}"},
        {"<linearGradient id='l' color-interpolation='linearRGB'><stop/><stop offset='1' "
         "stop-color='red'/></linearGradient>" BOX "fill='url(#l)'/>",
         "{\"hints\":1}"},
        {"<image width='0'/>" BOX "clip-path='url(#no)'/>" LINE "stroke-dasharray='0 0'/>", "{\"hidden\":1}"},
        {"<switch><text/><g/></switch>", "{\"texts\":1,\"switches\":1}"},
        {BOX "visibility='hidden'/>" BOX "fill='none'/><svg display='none'/>", "{\"hidden\":3}"},
        {"<path d='M0 0L1 1X'/>" BOX
         "transform='turn(3)'/><use href='#no'/><path stroke-linecap='round' d='M5 5L5 5' stroke='red'/>",
         "{\"copies\":1,\"unknown\":3}"},
        {BOX "frobnicate='1'/><blob/>" BOX "style='fill:oklch(1 2 3)'/>" BOX
             "style='transform:rotateX(9deg)'/>" BOX "stroke-width='x'/>",
         "{\"broken\":2,\"unknown\":3}"},
        {"<title>t</title>" BOX "><desc>d</desc></rect>" BOX "role='img' aria-label='x'/>", "{\"titles\":3}"},
        {"<a href='https://example.org'>" BOX "/></a>", "{\"links\":1}"},
        {BOX "><animate attributeName='x'/><set/></rect><animateMotion><mpath/></animateMotion>",
         "{\"animations\":3}"},
        {"<script>1</script>" BOX "onclick='x()'/>", "{\"scripts\":2}"},
        {"<foreignObject><p/></foreignObject><video/>", "{\"embedded\":2}"},
        {"<defs><linearGradient id='l'/><g><path/></g><clipPath id='c'>" BOX "/></clipPath></defs><symbol/>",
         "{\"unused\":4}"},
        {"<metadata><rdf:RDF><x/></rdf:RDF></metadata>", "{\"metadata\":1}"},
        {"<sodipodi:namedview><inkscape:grid/></sodipodi:namedview>" BOX "inkscape:x='1' data-y='2'/>"
         "<defs><inkscape:path-effect/></defs>",
         "{\"foreign\":3}"},
        {"<style>.a,.b{fill:red} rect>g{fill:blue} @media print{g{fill:red}}</style>" BOX "class='a'/>",
         "{\"rules\":3}"},
        /* what may hold is said of each that it may hold for; what never does at rest is not */
        {"<style>g:has(x) rect,rect:empty{fill:red} .a:not(:lang(en)){stroke:red} circle:has(g){fill:red} "
         "@media (min-width:1px){path{fill:red}} @supports (x:y){.b{fill:red}}</style>" BOX
         "class='a'/><path d='M0 0h1'/>" BOX "class='b'/><line x2='9'/>",
         "{\"broken\":3,\"rules\":7}"},
        {"<style>rect:hover,rect::before,rect:frob{fill:red} @media "
         "(prefers-color-scheme:dark){rect{fill:red}} "
         "@font-face{src:x}</style>" BOX "/>",
         "{\"rules\":3}"},
        /* drawn often, counted once */
        {"<defs><g id='a'>" LINE
         "stroke-dasharray='1'><title>t</title></path></g></defs><use href='#a'/><use href='#a'/>",
         "{\"copies\":2,\"titles\":1}"},
        /* hidden things are lost, too */
        {"<g display='none'><text/>" LINE "stroke-dasharray='1'/></g>", "{\"hidden\":1}"},
        /* what is referred to is not unused */
        {"<defs><filter id='f'/><path id='p'/><marker id='m'/></defs><text><textPath href='#p'/></text>" BOX
         "filter='url(#f)' style='marker:url(\"#m\")'/>",
         "{\"texts\":1,\"filters\":1}"},
    };
    bool found[BAT_LOSS_COUNT] = {false};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        expect(cases[i][0], cases[i][1]);
        bat_losses lost = losses_of(cases[i][0]);
        for (int k = 0; k < BAT_LOSS_COUNT; k++) found[k] = found[k] || lost.count[k];
    }
    found[BAT_LOSS_UNEVEN] = found[BAT_LOSS_ORDER] = found[BAT_LOSS_GRADIENT] = found[BAT_LOSS_PATTERN] =
        found[BAT_LOSS_PAGE] = found[BAT_LOSS_NATIVE] =
            true; /* below; uneven strokes and orders are kept, and none is lost any longer */
    for (int k = 0; k < BAT_LOSS_COUNT; k++)
        if (!found[k]) fail_msg("no case for %s", bat_loss_key((bat_loss)k));
}

/* Sizes are kept: nothing is lost of them. */
static void page_sizes(void **state) {
    (void)state;
    static const double PX = 25.4 / 96;
    static const struct {
        const char *root;
        bat_unit unit;
        double scale, page[4];
    } cases[] = {
        {"<svg/>", BAT_UNIT_PX, PX, {0}},
        {"<svg viewBox='0 0 20 10'/>", BAT_UNIT_PX, PX, {0, 0, 20, 10}},
        {"<svg width='20' height='10'/>", BAT_UNIT_PX, PX, {0, 0, 20, 10}},
        {"<svg width='20px' height='10' viewBox='5 5 20 10'/>", BAT_UNIT_PX, PX, {5, 5, 20, 10}},
        {"<svg width='100%' height='100%' viewBox='0 0 20 10'/>", BAT_UNIT_PX, PX, {0, 0, 20, 10}},
        {"<svg width='40' height='20' viewBox='0 0 20 10'/>", BAT_UNIT_PX, 2 * PX, {0, 0, 20, 10}},
        {"<svg width='20mm' height='10mm' viewBox='0 0 20 10'/>", BAT_UNIT_MM, 1, {0, 0, 20, 10}},
        {"<svg width='20mm' height='10mm'/>", BAT_UNIT_MM, PX, {0, 0, 20 / PX, 10 / PX}},
        {"<svg width='50%' viewBox='0 0 20 10'/>", BAT_UNIT_PX, PX, {0, 0, 20, 10}},
        {"<svg width='50%' height='1IN' viewBox='0 0 20 10'/>", BAT_UNIT_IN, 2.54, {0, 0, 20, 10}},
        {"<svg viewBox='0 0 20 10' preserveAspectRatio='none'/>", BAT_UNIT_PX, PX, {0, 0, 20, 10}},
        {"<svg viewBox='0 0 20 10' preserveAspectRatio='xMidYMid meet'/>", BAT_UNIT_PX, PX, {0, 0, 20, 10}},
        {"<svg width='20pt' height='20pt' viewBox='0 0 20 10'/>", BAT_UNIT_PT, 25.4 / 72, {0, -5, 20, 20}},
        {"<svg width='4cm' height='1cm' viewBox='0 0 20 20' preserveAspectRatio='xMaxYMid'/>",
         BAT_UNIT_CM,
         0.5,
         {-60, 0, 80, 20}},
        {"<svg width='4cm' height='1cm' viewBox='0 0 20 20' preserveAspectRatio='none'/>",
         BAT_UNIT_CM,
         1,
         {0, 0, 40, 10}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_svg_report report;
        double page[4];
        bat_document *document = read_whole(cases[i].root, &report);
        bool same = bat_document_unit(document) == cases[i].unit &&
                    fabs(bat_document_scale(document) / cases[i].scale - 1) < 1e-12;
        bat_document_page(document, page);
        for (int k = 0; k < 4; k++) same = same && fabs(page[k] - cases[i].page[k]) < 1e-9;
        if (!same || bat_losses_total(&report.lost) != 0) fail_msg("%s", cases[i].root);
        bat_document_free(document);
    }
}

/* ---- gradients ---- */

static const bat_style *style_at(const bat_document *document, int index) {
    for (int i = 0; i < bat_document_count(document); i++)
        if (bat_object_is_drawn(bat_document_at(document, i)) && index-- == 0)
            return bat_object_style(bat_document_at(document, i));
    fail_msg("no such object");
    return NULL;
}

static void gradients_become_their_mean(void **state) {
    (void)state;
    static const char text[] = "<svg color='#00ff00'><style>.s{stop-color:#0000ff}</style><defs>"
                               "<linearGradient id='a'><stop stop-color='#ff0000'/><stop offset='1' "
                               "stop-color='#0000ff'/></linearGradient>"
                               "<radialGradient id='b' xlink:href='#a'/><linearGradient id='c' href='#b'/>"
                               "<linearGradient id='d'><stop stop-color='red'/><stop stop-color='white' "
                               "stop-opacity='0'/></linearGradient>"
                               "<linearGradient id='e'><stop class='s'/><stop "
                               "style='stop-color:#00f;stop-opacity:50%'/></linearGradient>"
                               "<linearGradient id='f'><stop stop-color='currentColor'/></linearGradient>"
                               "<linearGradient id='g' href='#h'/><linearGradient id='h' href='#g'/>"
                               "<linearGradient id='i'><stop stop-opacity='0'/></linearGradient>"
                               "<pattern id='p'>" BOX "/></pattern></defs>"
                               "<g fill='url(#a)'>" BOX "/></g>" /* 0: handed down */
        BOX "style=\"fill:url('#b')\"/>"                         /* 1: stops of another, quotes */
        BOX "fill='none' stroke='url(#c)' stroke-opacity='.5'/>" /* 2 */
        BOX "fill='url(#d)'/>"                                   /* 3: what covers counts */
        BOX "fill='url(#e) red'/>"                               /* 4: a fallback is for what is not there */
        BOX "fill='url( #f )'/>"                                 /* 5 */
        BOX "fill='url(#g)' stroke='red'/>"                      /* 6: in a circle, no stops */
        BOX "fill='url(#p)' stroke='red'/>"                      /* 7: a pattern without a size */
        BOX "fill='url(#p) #123456'/>"                           /* 8 */
        BOX "fill='url(#no) #123456'/>"                          /* 9 */
        BOX "fill='url(#i)'/></svg>";                            /* 10 */
    static const uint32_t fills[] = {0x800080ff, 0x800080ff, 0,          0xff000080, 0x0000ffbf, 0x00ff00ff,
                                     0,          0x808080ff, 0x123456ff, 0x123456ff, 0x00000000};
    bat_svg_report report;
    bat_document *d = read_whole(text, &report);
    for (int i = 0; i < 11; i++)
        if (i != 2 && i != 6 && i != 7 && style_at(d, i)->fill != fills[i])
            fail_msg("%d: %08x", i, style_at(d, i)->fill);
    assert_true(style_at(d, 2)->stroke == 0x80008080 && !style_at(d, 2)->filled);
    assert_false(style_at(d, 6)->filled || style_at(d, 7)->filled); /* SVG 2, 14.2.4, 14.3: as none */
    assert_int_equal(report.lost.count[BAT_LOSS_GRADIENT], 0);
    assert_int_equal(report.lost.count[BAT_LOSS_PATTERN], 0);
    assert_int_equal(report.lost.count[BAT_LOSS_BROKEN], 0);
    assert_int_equal(report.lost.count[BAT_LOSS_UNUSED], 0);
    bat_document_free(d);
}

/* The mean of any stops lies between them, and one colour stays what it is. */
static void means_lie_between(void **state) {
    (void)state;
    random_source r = {7};
    for (int round = 0; round < 200; round++) {
        char text[2000] = "<svg><linearGradient id='a'>";
        int low[3] = {255, 255, 255}, high[3] = {0, 0, 0}, stops = random_int(&r, 1, 9);
        double cover = 0;
        for (int i = 0; i < stops; i++) {
            int rgb[3], percent = random_int(&r, 1, 100);
            for (int k = 0; k < 3; k++) {
                rgb[k] = random_int(&r, 0, 255);
                low[k] = rgb[k] < low[k] ? rgb[k] : low[k];
                high[k] = rgb[k] > high[k] ? rgb[k] : high[k];
            }
            cover += percent * 2.55 / stops;
            sprintf(text + strlen(text), "<stop stop-color='rgb(%d,%d,%d)' stop-opacity='%d%%'/>", rgb[0],
                    rgb[1], rgb[2], percent);
        }
        strcat(text, "</linearGradient>" BOX "fill='url(#a)'/></svg>");
        bat_document *d = read_whole(text, NULL);
        uint32_t fill = style_at(d, 0)->fill;
        for (int k = 0; k < 3; k++) {
            int channel = (int)(fill >> (24 - 8 * k) & 255);
            assert_in_range(channel, low[k], high[k]);
        }
        assert_true(fabs((fill & 255) - cover) <= 0.5 + 1e-9);
        bat_document_free(d);
    }
}

/* ---- files of our own ---- */

/* Text and such beside a drawing that still agrees with its native document is lost all the same. */
static void added_to_our_own(void **state) {
    (void)state;
    bat_svg_report report;
    char *text, changed[8000];
    size_t size;
    bat_document *d = read_whole("<svg viewBox='0 0 9 9'>" LINE "/>" BOX "/></svg>", NULL);
    bat_style bare = {.width = 1, .opacity = 1, .miter_limit = 4};
    bat_object *invisible = NULL;
    assert_int_equal(bat_object_with_style(bat_document_at(d, 1), &bare, &invisible), BAT_OK);
    bat_document_replace(d, 1, invisible);
    bat_object_release(invisible);
    assert_int_equal(bat_svg_write(d, true, &text, &size), BAT_OK);
    bat_document_free(d);
    d = read_whole(text, &report);
    assert_true(report.native &&
                bat_losses_total(&report.lost) == 0); /* what paints nothing is in the native one */
    bat_document_free(d);
    snprintf(changed, sizeof changed, "%.*s<title>t</title><text>x</text>%s",
             (int)(strstr(text, "<metadata") - text), text, strstr(text, "<metadata"));
    d = read_whole(changed, &report);
    assert_true(report.native && report.lost.count[BAT_LOSS_TITLE] == 1 &&
                report.lost.count[BAT_LOSS_TEXT] == 1);
    assert_int_equal(bat_losses_total(&report.lost), 2);
    bat_document_free(d);
    bat_free(text);
}

static void words(void **state) {
    (void)state;
    bat_svg_report report = {.lost.count = {[BAT_LOSS_TEXT] = 3, [BAT_LOSS_IMAGE] = 1, [BAT_LOSS_RULE] = 2}};
    char line[1000];
    bat_svg_report_line(&report, line, sizeof line);
    assert_string_equal(line, "Left out: 3 texts, 1 image, 2 style rules.");
    bat_svg_report_line(&report, line, 12);
    assert_string_equal(line, "Left out: 3");
    report.edited = true;
    bat_svg_report_line(&report, line, sizeof line);
    assert_non_null(strstr(line, "rules. Changed by another program"));
    report = (bat_svg_report){0};
    bat_svg_report_line(&report, line, sizeof line);
    assert_string_equal(line, "");
    for (int i = 0; i < BAT_LOSS_COUNT; i++) report.lost.count[i] = INT32_MAX;
    assert_int_equal(bat_losses_total(&report.lost), INT32_MAX);
    bat_svg_report_line(&report, line, sizeof line);
    assert_int_equal(line[strlen(line) - 1], '.'); /* all of it has room */
    bat_loss_words(BAT_LOSS_COUNT, 1, line, sizeof line);
    assert_string_equal(line, "");
    assert_null(bat_loss_key(BAT_LOSS_COUNT));
    for (int i = 0; i < BAT_LOSS_COUNT; i++)
        for (int k = 0; k < i; k++)
            assert_string_not_equal(bat_loss_key((bat_loss)i), bat_loss_key((bat_loss)k));
}

static void counts_survive_as_json(void **state) {
    (void)state;
    bat_losses some = {.count = {[BAT_LOSS_CLIP] = 1, [BAT_LOSS_NATIVE] = 2147483647}}, back;
    bat_text text = {0};
    bat_json json;
    bat_losses_to_json(&some, &text);
    assert_int_equal(bat_json_parse(text.data, text.size, &json, NULL), BAT_OK);
    bat_losses_from_json(&json, 1, &back);
    assert_memory_equal(&some, &back, sizeof some);
    bat_json_free(&json);
    bat_text_free(&text);
    static const char odd[] = "{\"clips\":-1,\"masks\":1e300,\"texts\":\"3\",\"blobs\":3,\"images\":0.5}";
    assert_int_equal(bat_json_parse(odd, sizeof odd - 1, &json, NULL), BAT_OK);
    bat_losses_from_json(&json, 1, &back);
    assert_int_equal(bat_losses_total(&back), 0);
    bat_json_free(&json);
}

/* The table of names is searched by halves. */
static void names_are_found(void **state) {
    (void)state;
    assert_int_equal(bat_svg_name_of("alignment-baseline"), BAT_SVG_BASELINE);
    assert_int_equal(bat_svg_name_of("zoomAndPan"), BAT_SVG_ATTRIBUTE);
    assert_int_equal(bat_svg_name_of("stroke"), BAT_SVG_STROKE);
    assert_int_equal(bat_svg_name_of("stroke-width"), BAT_SVG_WIDTH);
    assert_int_equal(bat_svg_name_of("xmlns"), BAT_SVG_ATTRIBUTE);
    assert_int_equal(bat_svg_name_of("text-rendering"), BAT_SVG_IDLE);
    assert_int_equal(bat_svg_name_of("font-size"), BAT_SVG_FONT_SIZE);
    assert_int_equal(bat_svg_name_of("font-family"), BAT_SVG_IDLE);
    assert_int_equal(bat_svg_name_of(""), BAT_SVG_NAMELESS);
    assert_int_equal(bat_svg_name_of("~"), BAT_SVG_NAMELESS);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    static const char *const gradient[] = {"id", "a", NULL}, *const stop[] = {"stop-color", "red", NULL};
    static const char *const shape[] = {"width", "3", "height", "3", "fill", "url(#a)", "x:y", "1", NULL};
    static const struct {
        const char *name;
        const char *const *attributes;
        int ends;
    } parts[] = {{"svg", NULL, 0},   {"linearGradient", gradient, 0},
                 {"stop", stop, 2},  {"text", NULL, 1},
                 {"rect", shape, 1}, {"rect", shape, 2}};
    long before = alloc_live();
    for (long n = 1;; n++) {
        bat_document *document = NULL;
        bat_svg_reader *reader = NULL;
        assert_int_equal(bat_svg_reader_create(NULL, &reader), BAT_OK);
        alloc_fail_at(n);
        for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
            bat_svg_reader_start(reader, parts[i].name, parts[i].attributes);
            for (int k = 0; k < parts[i].ends; k++) bat_svg_reader_end(reader);
        }
        bat_status status = bat_svg_reader_finish(reader, &document, NULL, NULL);
        bool hit = alloc_fail_reached();
        assert_int_equal(status, hit ? BAT_MEMORY : BAT_OK);
        bat_document_free(document);
        assert_int_equal(alloc_live(), before);
        if (!hit) break;
    }
}

/* One gradient of many stops for many shapes, uses of uses: the work is bounded. */
static void hostile_files_end(void **state) {
    (void)state;
    bat_text text = {0};
    bat_text_string(&text, "<svg><linearGradient id='a'>");
    for (int i = 0; i < 20000; i++) bat_text_string(&text, "<stop/>");
    bat_text_string(&text, "</linearGradient>");
    for (int i = 0; i < 20000; i++) bat_text_string(&text, BOX "fill='url(#a)'/>");
    bat_text_string(&text, "</svg>");
    bat_text_add(&text, "", 1);
    bat_svg_report report;
    bat_document_free(read_whole(text.data, &report));
    assert_int_equal(report.lost.count[BAT_LOSS_GRADIENT], 20000);
    bat_text_free(&text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_lost),
        cmocka_unit_test(every_kind_is_found),
        cmocka_unit_test(page_sizes),
        cmocka_unit_test(gradients_become_their_mean),
        cmocka_unit_test(means_lie_between),
        cmocka_unit_test(added_to_our_own),
        cmocka_unit_test(words),
        cmocka_unit_test(counts_survive_as_json),
        cmocka_unit_test(names_are_found),
        cmocka_unit_test(every_allocation_may_fail),
        cmocka_unit_test(hostile_files_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
