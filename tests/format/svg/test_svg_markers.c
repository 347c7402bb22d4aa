/* Markers: where they are, kept by the file, by both formats and by edits. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "base/real.h"
#include "document/clip.h"
#include "document/document.h"
#include "document/markers.h"
#include "editor/edit/affine.h"
#include "format/svg/write/feed.h"
#include "support/alloc_fail.h"
#include <batten/bezier.h>
#include <batten/format.h>

#include <math.h>
#include <stdlib.h>

#define HEAD "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
/* Its tip lies at the vertex, 4 units long along the curve, 2 wide. */
#define TIP(more)                                                                                            \
    "<marker id='m' overflow='visible' refX='4' refY='1' " more "><path d='M0 0L4 1L0 2Z'/></marker>"
#define ALL "marker-start='url(#m)' marker-mid='url(#m)' marker-end='url(#m)' "

static bat_status read_as(const char *text, bool kept, bat_document **out, bat_svg_report *report) {
    bat_svg_reader *reader;
    bat_status status = bat_svg_reader_create(NULL, &reader);
    if (status != BAT_OK) return status;
    if (kept) status = bat_svg_reader_source(reader, text, strlen(text));
    if (status == BAT_OK) status = bat_svg_feed(text, strlen(text), reader);
    if (status == BAT_OK) return bat_svg_reader_finish(reader, out, report, NULL);
    bat_svg_reader_free(reader);
    return status;
}

static bat_status read_file(const char *text, bat_document **out, bat_svg_report *report) {
    return read_as(text, true, out, report);
}

static bat_document *opened(const char *content) {
    char text[4000];
    bat_document *document = NULL;
    bat_svg_report report;
    snprintf(text, sizeof text, HEAD "%s</svg>", content);
    assert_int_equal(read_file(text, &document, &report), BAT_OK);
    assert_int_equal(report.lost.count[BAT_LOSS_MARKER], 0);
    return document;
}

static char *written(const bat_document *document) {
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_svg_write(document, true, &text, &size), BAT_OK);
    return text;
}

/* The places of the tips, and the directions in which they point, of the first object: x, y, degrees each. */
static void expect(const bat_document *document, int count, const double (*tips)[3], double length) {
    bat_object **list;
    int found;
    assert_int_equal(bat_object_mark(bat_document_at(document, 0), &found, &list), BAT_OK);
    assert_int_equal(found, count);
    for (int i = 0; i < count; i++) {
        double at[2], back[2][2];
        const bat_curve *curve = bat_object_curve(list[i], 0);
        const double *points = bat_curve_points(
            curve); /* closed, of cubics: it begins behind the first corner */
        memcpy(at, points + 2 * 2, sizeof at);
        memcpy(back[0], points + 2 * 5, sizeof at);
        memcpy(back[1], points + 2 * 8, sizeof at);
        const double x = at[0] - (back[0][0] + back[1][0]) / 2, y = at[1] - (back[0][1] + back[1][1]) / 2;
        const double turn = atan2(y, x) * (180 / BAT_PI) - tips[i][2];
        if (!(fabs(at[0] - tips[i][0]) < 1e-9 && fabs(at[1] - tips[i][1]) < 1e-9) ||
            !(fabs(turn - 360 * round(turn / 360)) < 1e-6) || !(fabs(hypot(x, y) - length) < 1e-9))
            fail_msg("%d: at %g %g, turned by %g, %g long", i, at[0], at[1], atan2(y, x) * 180 / BAT_PI,
                     hypot(x, y));
        bat_object_release(list[i]);
    }
    free(list);
}

static void tips_are_at_the_vertices(void **state) {
    (void)state;
    static const struct {
        const char *file;
        int count;
        double tips[6][3], length;
    } cases[] = {
        {TIP("orient='auto'") "<path stroke-width='2' d='M10 10H50V30' " ALL "/>",
         3,
         {{10, 10, 0}, {50, 10, 45}, {50, 30, 90}},
         8},
        {TIP("orient='auto-start-reverse' markerUnits='userSpaceOnUse'") "<path stroke-width='2' d='M10 "
                                                                         "10H50V30' " ALL "/>",
         3,
         {{10, 10, 180}, {50, 10, 45}, {50, 30, 90}},
         4},
        {TIP("orient='30'") "<polyline points='10,10 50,10 50,30' style='marker:url(#m)'/>",
         3,
         {{10, 10, 30}, {50, 10, 30}, {50, 30, 30}},
         4},
        {TIP("orient='0.5rad'") "<line x1='5' y1='6' x2='7' y2='6' marker-end='url(#m)'/>",
         1,
         {{7, 6, 0.5 * 180 / BAT_PI}},
         4},
        /* vertices that bend nothing stay; so does where a closed path begins */
        {TIP("orient='auto'") "<path d='M0 0L10 0L20 0L50 0' marker-mid='url(#m)'/>",
         2,
         {{10, 0, 0}, {20, 0, 0}},
         4},
        {TIP("orient='auto'") "<path d='M50 20C61.04 20 70 28.96 70 40S61.04 60 50 60S30 51.04 30 40S38.96 "
                              "20 50 20Z' marker-start='url(#m)'/>",
         1,
         {{50, 20, 0}},
         4},
        {TIP("orient='auto'") "<polygon points='0,0 40,0 40,40 0,40' " ALL "/>",
         5,
         {{0, 0, 0}, {40, 0, 45}, {40, 40, 135}, {0, 40, 225}, {0, 0, -45}},
         4},
        /* handles without length */
        {TIP("orient='auto'") "<path d='M10 10C10 10 10 20 20 20C20 20 30 20 30 10' marker-start='url(#m)'/>",
         1,
         {{10, 10, 90}},
         4},
        /* the first of all and the last of all */
        {TIP("orient='auto'") "<path d='M0 0H10M0 20V30' " ALL "/>",
         4,
         {{0, 0, 0}, {10, 0, 0}, {0, 20, 90}, {0, 30, 90}},
         4},
        /* turned and mirrored with the element */
        {TIP("orient='auto'") "<path transform='rotate(90)' d='M10 0H50' marker-end='url(#m)'/>",
         1,
         {{0, 50, 90}},
         4},
        {TIP("orient='30'") "<path transform='rotate(90)' d='M10 0H50' marker-end='url(#m)'/>",
         1,
         {{0, 50, 120}},
         4},
        {TIP("orient='30'") "<g transform='scale(-1 1)'><path d='M10 0H50' marker-end='url(#m)'/></g>",
         1,
         {{-50, 0, 150}},
         4},
        {TIP("orient='auto' markerUnits='userSpaceOnUse'") "<path transform='scale(3)' d='M10 0H30' "
                                                           "marker-end='url(#m)'/>",
         1,
         {{90, 0, 0}},
         12},
        {"<marker id='m' viewBox='0 0 8 4' refX='8' refY='2' markerWidth='4' markerHeight='4' "
         "overflow='visible'>"
         "<g transform='scale(2)'><path d='M0 0L4 1L0 2Z'/></g></marker><path d='M10 0H30' "
         "marker-end='url(#m)'/>",
         1,
         {{30, 0, 0}},
         4},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_document *document = opened(cases[i].file);
        expect(document, cases[i].count, cases[i].tips, cases[i].length);
        bat_document_free(document);
    }
}

static const char *const files[] = {
    TIP("orient='auto'") "<path fill='none' stroke='red' d='M10 10H50V30' " ALL "/>",
    TIP("") "<g transform='scale(-2 2)'><path stroke='red' stroke-width='3' d='M10 10C20 90 30 0 40 20' "
            "paint-order='markers' " ALL "/></g>",
    TIP("orient='75'") "<path transform='skewX(20)' stroke='blue' d='M10 10C20 90 30 0 40 20' "
                       "paint-order='stroke markers' " ALL "/>",
    TIP("markerUnits='userSpaceOnUse'") "<path transform='skewX(20)' fill='none' d='M10 10C20 90 30 0 40 "
                                        "20' " ALL "/>",
    "<linearGradient id='l'><stop stop-color='red'/><stop offset='1' stop-color='blue'/></linearGradient>"
    "<marker id='m' orient='auto' refX='2'><g opacity='.5'><path fill='context-stroke' stroke='context-fill' "
    "d='M0 0L4 1L0 2Z'/>"
    "</g><circle r='3' fill='url(#l)' stroke='red' stroke-dasharray='1 2'/></marker><path fill='url(#l)' "
    "stroke='red' d='M10 10H50V30' " ALL "/>",
};

static void nothing_is_lost_on_the_way(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        bat_document *document = opened(files[i]), *back = NULL;
        char whole[4000], *text = written(document), *native;
        size_t size;
        snprintf(whole, sizeof whole, HEAD "%s</svg>", files[i]);
        assert_non_null(
            strstr(text, files[i] + strlen(files[i]) - 40)); /* as it was, with the native document */
        bat_free(text);
        assert_int_equal(bat_document_write(document, &native, &size), BAT_OK);
        assert_non_null(strstr(native, "{\"batten\":8"));
        assert_int_equal(bat_document_read(native, size, &back, NULL), BAT_OK);
        assert_true(bat_document_digest(document) == bat_document_digest(back));
        bat_document_free(back);
        bat_free(native);
        /* written anew, with elements of its own */
        bat_document_set_origin(document, NULL);
        text = written(document);
        bat_svg_report report;
        assert_int_equal(read_file(text, &back, &report), BAT_OK);
        if (!report.native || report.edited) fail_msg("file %zu: %s", i, text);
        bat_document_free(back);
        /* what is drawn there is the same without the native document */
        bat_free(text);
        assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
        assert_int_equal(read_file(text, &back, &report), BAT_OK);
        bat_object **one, **other;
        int count, again;
        assert_int_equal(bat_object_mark(bat_document_at(document, 0), &count, &one), BAT_OK);
        assert_int_equal(bat_object_mark(bat_document_at(back, 0), &again, &other), BAT_OK);
        assert_true(count == again && count > 0);
        for (int k = 0; k < count; k++) {
            double a[4], b[4];
            bat_object_bounds(one[k], a);
            bat_object_bounds(other[k], b);
            for (int j = 0; j < 4; j++) assert_true(fabs(a[j] - b[j]) < 0.01);
            bat_object_release(one[k]);
            bat_object_release(other[k]);
        }
        free(one);
        free(other);
        bat_document_free(back);
        bat_free(text);
        bat_document_free(document);
    }
}

/* An edit of the curve takes the markers along, and changes nothing of them in the file. */
static void edits_keep_the_markers(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        bat_document *document = opened(files[i]);
        bat_object *moved = NULL;
        bat_document *again = NULL;
        bat_svg_report report;
        const double matrix[6] = {1, 0, 0, 1, 7, 5};
        assert_int_equal(bat_affine_object(bat_document_at(document, 0), matrix, true, &moved), BAT_OK);
        assert_true(bat_markers_digest(bat_object_markers(moved)) ==
                    bat_markers_digest(bat_object_markers(bat_document_at(document, 0))));
        assert_int_equal(bat_document_replace(document, 0, moved), BAT_OK);
        bat_object_release(moved);
        char *text = written(document);
        assert_non_null(strstr(text, "<marker id='m'"));
        assert_non_null(strstr(text, "marker-mid='url(#m)'"));
        assert_null(strstr(text, "<marker id=\"batten"));
        assert_int_equal(read_file(text, &again, &report), BAT_OK);
        assert_true(report.native && !report.edited);
        bat_document_free(again);
        bat_free(text);
        bat_document_free(document);
    }
}

/* A copy of an object is written with markers of its own; a new line within a group that marks its lines has none. */
static void what_is_new_has_its_own(void **state) {
    (void)state;
    bat_document *document = opened(
        TIP("orient='auto'") "<g " ALL "><path stroke='red' fill='none' d='M10 10H50V30'/></g>");
    bat_object *copy = NULL, *bare = NULL;
    bat_svg_report report;
    bat_document *again = NULL;
    const bat_object *first = bat_document_at(document, 0);
    assert_int_equal(bat_object_with_id(first, bat_document_new_id(document), &copy), BAT_OK);
    assert_int_equal(bat_document_insert(document, 1, copy), BAT_OK);
    bat_object_release(copy);
    assert_int_equal(bat_object_with_markers(first, NULL, &bare), BAT_OK);
    assert_int_equal(bat_object_with_id(bare, bat_document_new_id(document), &copy), BAT_OK);
    assert_int_equal(bat_document_insert(document, 2, copy), BAT_OK);
    bat_object_release(copy);
    bat_object_release(bare);
    char *text = written(document);
    assert_non_null(strstr(text, "<marker id='m'"));
    assert_non_null(strstr(text, "<marker id=\"batten-paint-"));
    assert_int_equal(read_file(text, &again, &report), BAT_OK);
    assert_true(report.native && !report.edited);
    assert_true(bat_object_markers(bat_document_at(again, 1)) &&
                !bat_object_markers(bat_document_at(again, 2)));
    bat_document_free(again);
    bat_free(text);
    bat_document_free(document);
}

/* In a file that is kept it is foreign content, which whoever shows the file paints; else it is noted. */
static void what_cannot_be_shown_is_noted(void **state) {
    (void)state;
    static const struct {
        const char *file;
        int lost;
    } cases[] = {
        {"<marker id='m'><text>a</text></marker><path d='M0 0H9' marker-end='url(#m)'/>", 1},
        {"<marker id='m'><path mask='url(#x)' d='M0 0H1V1Z'/></marker><path d='M0 0H9' "
         "marker-end='url(#m)'/>",
         1},
        {"<marker id='m'><g opacity='.5'><path d='M0 0H1V1Z'/><path d='M0 0H1V1Z'/></g></marker><path d='M0 "
         "0H9' marker-end='url(#m)'/>",
         1},
        {"<marker id='m'><path d='M0 0H1V1Z'/></marker><path d='M0 0A5 5 0 0 1 9 9' marker-mid='url(#m)'/>",
         1},
        {"<marker id='m'><path d='M0 0H1V1Z'/></marker><path d='M0 0A5 5 0 0 1 9 9' marker-end='url(#m)'/>",
         0},
        {"<marker id='m'><path d='M0 0H1V1Z' marker-end='url(#m)'/></marker><path d='M0 0H9' "
         "marker-end='url(#m)'/>",
         2},
        {"<marker id='m' markerWidth='0'><text>a</text></marker><path d='M0 0H9' marker-end='url(#m)'/>", 0},
        {"<path d='M0 0H9' marker-end='url(#none)'/><rect width='9' height='9' marker-end='url(#m)'/>", 0},
        {"<marker id='m'/><path d='M0 0H9' fill='none' marker-end='url(#m)'/>", 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1000];
        bat_document *document = NULL;
        bat_svg_report report;
        snprintf(text, sizeof text, HEAD "%s</svg>", cases[i].file);
        assert_int_equal(read_as(text, false, &document, &report), BAT_OK);
        if (report.lost.count[BAT_LOSS_MARKER] != cases[i].lost)
            fail_msg("%s: %d", cases[i].file, report.lost.count[BAT_LOSS_MARKER]);
        bat_document_free(document);
        assert_int_equal(read_as(text, true, &document, &report), BAT_OK);
        assert_int_equal(report.lost.count[BAT_LOSS_MARKER], 0);
        if (bat_object_is_foreign(bat_document_at(document, 0)) != (cases[i].lost > 0))
            fail_msg("%s", cases[i].file);
        bat_document_free(document);
    }
}

/* In groups as deep as a file may be. */
static void markers_of_the_deepest(void **state) {
    (void)state;
    for (int groups = 252; groups <= 256; groups++) {
        char text[8000] = HEAD "<marker id='m'><path d='M0 0H1V1Z'/></marker>";
        bat_document *document = NULL;
        bat_svg_report report;
        for (int i = 0; i < groups; i++) strcat(text, "<g>");
        strcat(text, "<path d='M0 0H9' marker-end='url(#m)'/>");
        for (int i = 0; i < groups; i++) strcat(text, "</g>");
        strcat(text, "</svg>");
        const bat_status status = read_file(text, &document, &report);
        assert_true((status == BAT_OK) == (groups <= 254));
        if (status == BAT_OK) /* where there is no room for what is in the marker */
            assert_true(bat_object_is_foreign(bat_document_at(document, bat_document_count(document) - 1)) ==
                        (groups >= 253));
        bat_document_free(document);
    }
}

#define PART                                                                                                 \
    "{\"object\":{\"id\":1,\"kind\":\"path\",\"curves\":[{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,"  \
    "0],[1,1]]}]}}"
static void bad_native_markers_are_refused(void **state) {
    (void)state;
    static const char *const bad[] = {
        "3",
        "{}",
        "{\"frame\":[0,0,0,0],\"end\":{\"parts\":[]}}",
        "{\"frame\":[1,0,0],\"end\":{\"parts\":[]}}",
        "{\"order\":\"middle\",\"end\":{\"parts\":[]}}",
        "{\"end\":{}}",
        "{\"end\":\"start\"}",
        "{\"start\":\"end\"}",
        "{\"end\":{\"parts\":[3]}}",
        "{\"end\":{\"parts\":[{}]}}",
        "{\"end\":{\"matrix\":[1,1,1,1,0,0],\"parts\":[]}}",
        "{\"end\":{\"clip\":[0,0,-1,1],\"parts\":[]}}",
        "{\"end\":{\"turn\":\"left\",\"parts\":[" PART "]}}",
        "{\"end\":{\"parts\":[{\"object\":{\"id\":1,\"kind\":\"group\"}}]}}",
        "{\"end\":{\"parts\":[{\"object\":{\"id\":1,\"parent\":2,\"kind\":\"path\",\"curves\":[{\"degree\":1,"
        "\"knots\":[0,0,1,1],\"points\":[[0,0],[1,1]]}]}}]}}",
        "{\"end\":{\"parts\":[{\"fill\":\"red\",\"object\":{\"id\":1,\"kind\":\"path\",\"curves\":[{"
        "\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0],[1,1]]}]}}]}}"};
    char text[1000];
    bat_problem problem;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        bat_document *document = NULL;
        snprintf(
            text, sizeof text,
            "{\"batten\":8,\"objects\":[{\"id\":1,\"kind\":\"path\",\"markers\":%s,\"curves\":[{\"degree\":1,"
            "\"knots\":[0,0,1,1],\"points\":[[0,0],[1,1]]}]}]}",
            bad[i]);
        if (bat_document_read(text, strlen(text), &document, &problem) == BAT_OK) fail_msg("%s", bad[i]);
        assert_null(document);
    }
}

static void running_out_of_memory(void **state) {
    (void)state;
    const long before = alloc_live();
    char whole[4000];
    snprintf(whole, sizeof whole, HEAD "%s</svg>", files[4]);
    for (int n = 1;; n++) {
        bat_document *document = NULL;
        alloc_fail_at(n);
        const bat_status status = read_file(whole, &document, NULL);
        const bool failed = alloc_fail_reached();
        bat_document_free(document);
        if (!failed) break;
        assert_int_equal(status, BAT_MEMORY);
    }
    for (int way = 0; way < 3; way++) {
        bat_document *document = opened(files[4]);
        bat_document_set_origin(document, NULL);
        for (int n = 1;; n++) {
            char *text = NULL;
            size_t size;
            int count = 0;
            bat_object **list = NULL;
            alloc_fail_at(n);
            const bat_status status = way == 0 ? bat_document_write(document, &text, &size)
                                      : way == 1
                                          ? bat_svg_write(document, true, &text, &size)
                                          : bat_object_mark(bat_document_at(document, 0), &count, &list);
            const bool failed = alloc_fail_reached();
            if (status == BAT_OK) bat_free(text);
            for (int i = 0; i < count; i++) bat_object_release(list[i]);
            free(list);
            if (!failed) break;
            assert_int_equal(status, BAT_MEMORY);
        }
        bat_document_free(document);
    }
    assert_int_equal(alloc_live(), before);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tips_are_at_the_vertices),      cmocka_unit_test(nothing_is_lost_on_the_way),
        cmocka_unit_test(edits_keep_the_markers),        cmocka_unit_test(what_is_new_has_its_own),
        cmocka_unit_test(what_cannot_be_shown_is_noted), cmocka_unit_test(bad_native_markers_are_refused),
        cmocka_unit_test(running_out_of_memory),         cmocka_unit_test(markers_of_the_deepest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
