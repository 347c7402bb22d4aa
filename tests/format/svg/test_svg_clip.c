/* What of a drawing is seen: clip paths as they are read, kept, moved and written. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/clip.h"
#include "document/document.h"
#include "editor/edit/affine.h"
#include "format/svg/tags.h"
#include "support/alloc_fail.h"
#include "support/svg_kept.h"
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/measure.h>

#include <math.h>

#define HEAD "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>"
#define CIRCLE "<clipPath id='c'><circle cx='40' cy='30' r='20'/></clipPath>"
#define BOX "<path d='M10 10H90V70H10Z'"

static bat_status read_file(const char *text, bat_document **out, bat_svg_report *report) {
    return svg_read_kept(NULL, text, strlen(text), out, report);
}

static bat_document *opened(const char *text, int losses) {
    bat_document *document = NULL;
    bat_svg_report report;
    assert_int_equal(read_file(text, &document, &report), BAT_OK);
    if (report.lost.count[BAT_LOSS_CLIP] != losses || report.lost.count[BAT_LOSS_NATIVE])
        fail_msg("%d clips lost, %d native: %s", report.lost.count[BAT_LOSS_CLIP],
                 report.lost.count[BAT_LOSS_NATIVE], text);
    return document;
}

static char *written(const bat_document *document, bool native) {
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_svg_write(document, native, &text, &size), BAT_OK);
    return text;
}

/* The box of a region. */
static void expect_box(const bat_clip *clip, const double box[4], double slack) {
    double found[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
    assert_non_null(clip);
    for (int i = 0; i < bat_clip_curve_count(clip); i++) {
        double low[2], high[2];
        bat_curve_bounds(bat_clip_curve(clip, i), low, high);
        for (int k = 0; k < 2; k++) {
            found[k] = fmin(found[k], low[k]);
            found[k + 2] = fmax(found[k + 2], high[k]);
        }
    }
    for (int k = 0; k < 4; k++)
        if (!(fabs(found[k] - box[k]) <= slack))
            fail_msg("%g %g %g %g, not %g %g %g %g", found[0], found[1], found[2], found[3], box[0], box[1],
                     box[2], box[3]);
}

static const struct {
    const char *file;
    int object, curves;
    bool even_odd;
    double box[4]; /* of the innermost region */
} cases[] = {
    {CIRCLE BOX " clip-path='url(#c)'/>", 0, 1, false, {20, 10, 60, 50}},
    {CIRCLE BOX " style='clip-path:url(#c)' transform='translate(5 6) scale(2 .5)'/>",
     0,
     1,
     false,
     {45, 11, 125, 31}},
    {"<clipPath id='c' transform='translate(1 2)'><rect width='5' height='6' "
     "transform='scale(3)'/></clipPath>" BOX " clip-path='url(#c)'/>",
     0,
     1,
     false,
     {1, 2, 16, 20}},
    {"<clipPath id='c' clipPathUnits='objectBoundingBox'><rect x='.25' width='.5' height='1'/></clipPath>" BOX
     " clip-path='url(#c)'/>",
     0,
     1,
     false,
     {30, 10, 70, 70}},
    {"<clipPath id='c' clipPathUnits='objectBoundingBox'><rect x='10%' width='.5' height='1'/></clipPath><g "
     "transform='scale(.5)' "
     "clip-path='url(#c)'>" BOX "/><path d='M90 10H110V20Z'/></g>",
     0,
     1,
     false,
     {10, 5, 35, 35}},
    {"<style>.r{clip-rule:evenodd}</style><clipPath id='c'><path class='r' d='M0 0H9V9H0ZM2 "
     "2H4V4H2Z'/></clipPath>" BOX " clip-path='url(#c)'/>",
     0,
     2,
     true,
     {0, 0, 9, 9}},
    {"<clipPath id='c'><rect width='5' height='5'/><rect x='3' width='5' height='7' "
     "style='display:none'/><rect x='9' width='5' "
     "height='7' clip-rule='evenodd'/></clipPath>" BOX " clip-path='url(#c)'/>",
     0,
     2,
     false,
     {0, 0, 14, 7}},
    {"<rect id='r' width='5' height='5'/><clipPath id='c'><use href='#r' x='7' "
     "transform='scale(2)'/></clipPath>" BOX " clip-path='url(#c)'/>",
     1,
     1,
     false,
     {14, 0, 24, 10}},
    {CIRCLE "<g clip-path='url(#c)'>" BOX "/></g>",
     0,
     1,
     false,
     {20, 10, 60, 50}}, /* of the group, though it has one member */
    {"<defs><g id='s'>" BOX "/></g></defs>" CIRCLE "<use href='#s' x='3' clip-path='url(#c)'/>",
     0,
     1,
     false,
     {20, 10, 60, 50}},
};

/* Regions are where closed forms say, whatever the units, rules and places from which they come. */
static void regions_are_where_they_are(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[700];
        snprintf(text, sizeof text, HEAD "%s</svg>", cases[i].file);
        bat_document *document = opened(text, 0);
        const bat_clip *clip = bat_object_clip(bat_document_at(document, cases[i].object));
        assert_int_equal(bat_clip_count(clip), 1);
        assert_int_equal(bat_clip_curve_count(clip), cases[i].curves);
        assert_int_equal(bat_clip_is_even_odd(clip), cases[i].even_odd);
        expect_box(clip, cases[i].box, 1e-5);
        bat_document_free(document);
    }
}

/* A clip path within another, of the path or of its only shape, lies in it. */
static void clips_lie_in_others(void **state) {
    (void)state;
    static const char *const files[] = {
        CIRCLE "<clipPath id='d' clip-path='url(#c)'><rect width='9' height='8'/></clipPath>" BOX
               " clip-path='url(#d)'/>",
        CIRCLE "<clipPath id='d'><rect width='9' height='8' clip-path='url(#c)'/></clipPath>" BOX
               " clip-path='url(#d)'/>",
        CIRCLE "<clipPath id='d'><rect width='9' height='8'/></clipPath><defs>" BOX
               " id='s' clip-path='url(#d)'/></defs><use href='#s' clip-path='url(#c)'/>"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char text[700];
        snprintf(text, sizeof text, HEAD "%s</svg>", files[i]);
        bat_document *document = opened(text, 0);
        const bat_clip *clip = bat_object_clip(bat_document_at(document, 0));
        assert_int_equal(bat_clip_count(clip), 2);
        expect_box(clip, (double[4]){0, 0, 9, 8}, 1e-9);
        expect_box(bat_clip_within(clip), (double[4]){20, 10, 60, 50}, 1e-5);
        bat_document_free(document);
    }
}

/* Some that are not clip paths, or hold what cannot be one; and one that holds itself. */
static void what_cannot_clip_is_noted(void **state) {
    (void)state;
    static const struct {
        const char *file;
        int losses, regions;
    } some[] = {{BOX " clip-path='url(#c)'/>", 0, 0}, /* there is none */
                {BOX " style='clip-path:circle(50%)'/>", 1, 0},
                {BOX " clip-path='none'/>", 0, 0},
                {"<clipPath id='c'/>" BOX " clip-path='url(#c)'/>", 0, 1},
                {"<clipPath id='c'><text>a</text></clipPath>" BOX " clip-path='url(#c)'/>", 1, 1},
                {"<clipPath id='c'><path clip-rule='evenodd' d='M0 0H9V9ZM1 1H5V5Z'/><rect width='5' "
                 "height='5'/></clipPath>" BOX " clip-path='url(#c)'/>",
                 1, 1},
                {"<clipPath id='c' clip-path='url(#c)'><rect width='5' height='5'/></clipPath>" BOX
                 " clip-path='url(#c)'/>",
                 1, 9}};
    for (size_t i = 0; i < sizeof some / sizeof *some; i++) {
        char text[700];
        snprintf(text, sizeof text, HEAD "%s</svg>", some[i].file);
        bat_document *document = opened(text, some[i].losses);
        assert_int_equal(bat_clip_count(bat_object_clip(bat_document_at(document, 0))), some[i].regions);
        bat_document_free(document);
    }
}

/* ---- moved and written ---- */

static const char ALL[] = HEAD CIRCLE
    "<clipPath id='b' clipPathUnits='objectBoundingBox'><rect width='.5' height='1'/></clipPath><clipPath "
    "id='n' "
    "clip-path='url(#c)'><rect width='60' height='40'/></clipPath>" BOX " clip-path='url(#c)'/>" BOX
    " clip-path='url(#b)' transform='scale(.5 .7)' stroke='red'/><g clip-path='url(#n)' "
    "transform='translate(3 4)' opacity='.5'>" BOX
    "/><text>a</text><circle cx='9' cy='9' r='5' clip-path='url(#c)'/></g><g clip-path='url(#b)'>" BOX
    "/></g><image width='10' height='10' clip-path='url(#b)' transform='rotate(9)' "
    "href='data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+"
    "M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=='/></svg>";

/* Every object and group, with what of it is seen. */
static void move_all(bat_document *document, const double matrix[6]) {
    for (int i = 0; i < bat_document_count(document); i++) {
        bat_object *moved = NULL;
        assert_int_equal(bat_affine_object(bat_document_at(document, i), matrix, true, &moved), BAT_OK);
        assert_int_equal(bat_document_replace(document, i, moved), BAT_OK);
        bat_object_release(moved);
    }
}

static const bat_clip *drawn_clip(const bat_document *document, int *at) {
    const bat_object *object;
    while ((object = bat_document_at(document, (*at)++)))
        if (bat_object_clip(object)) return bat_object_clip(object);
    return NULL;
}

/* The same regions in the same order, to rounding. */
static void expect_same(const bat_document *one, const bat_document *other) {
    int i = 0, k = 0;
    for (;;) {
        const bat_clip *a = drawn_clip(one, &i), *b = drawn_clip(other, &k);
        assert_int_equal(a != NULL, b != NULL);
        if (!a) return;
        assert_int_equal(bat_clip_count(a), bat_clip_count(b));
        for (; a; a = bat_clip_within(a), b = bat_clip_within(b)) {
            assert_int_equal(bat_clip_is_even_odd(a), bat_clip_is_even_odd(b));
            assert_int_equal(bat_clip_curve_count(a), bat_clip_curve_count(b));
            for (int c = 0; c < bat_clip_curve_count(a); c++) {
                double low[2], high[2], there[4];
                bat_curve_bounds(bat_clip_curve(a, c), low, high);
                bat_curve_bounds(bat_clip_curve(b, c), there, there + 2);
                for (int d = 0; d < 2; d++)
                    assert_true(fabs(low[d] - there[d]) < 1e-6 && fabs(high[d] - there[2 + d]) < 1e-6);
            }
        }
    }
}

/* Moved as a whole, by each of the ways to write: with what was kept of the file, made anew, with and without the native
 * document, and that alone. */
static void what_is_moved_takes_its_clip_along(void **state) {
    (void)state;
    static const double matrices[][6] = {
        {1, 0, 0, 1, 0, 0}, {1, 0, 0, 1, 7, -3}, {0.5, 0.2, -0.3, 0.8, 4, 5}};
    for (size_t m = 0; m < sizeof matrices / sizeof *matrices; m++)
        for (int way = 0; way < 4; way++) { /* bits: anew, native */
            bat_document *document = opened(ALL, 0), *again = NULL;
            if (m > 0) move_all(document, matrices[m]);
            if (way & 1) bat_document_set_origin(document, NULL);
            char *text = written(document, way & 2);
            again = opened(text, 0);
            expect_same(document, again);
            if (!(way & 1))
                assert_non_null(strstr(text, "<clipPath id='c'><circle cx='40' cy='30' r='20'/></clipPath>"));
            if (way & 2) assert_true(bat_document_digest(document) == bat_document_digest(again));
            bat_free(text);
            bat_document_free(again);
            size_t size;
            assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
            assert_non_null(strstr(text, "{\"batten\":12")); /* there is a rectangle */
            assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
            assert_true(bat_document_digest(document) == bat_document_digest(again));
            bat_free(text);
            if (!(way & 1)) { /* what was kept is kept by the native format, too */
                text = written(again, false);
                bat_document *third = opened(text, 0);
                expect_same(document, third);
                bat_document_free(third);
                bat_free(text);
            }
            bat_document_free(again);
            bat_document_free(document);
        }
}

/* A clip that goes, in a file that is kept: nothing is said anew but that. */
static void a_clip_can_go(void **state) {
    (void)state;
    bat_document *document = opened(HEAD CIRCLE BOX " clip-path='url(#c)'/></svg>", 0);
    bat_object *made = NULL;
    assert_int_equal(bat_object_with_clip(bat_document_at(document, 0), NULL, &made), BAT_OK);
    bat_document_replace(document, 0, made);
    bat_object_release(made);
    char *text = written(document, false);
    assert_string_equal(text, HEAD CIRCLE BOX " clip-path=\"none\"/></svg>");
    bat_free(text);
    bat_document_free(document);
}

static void bad_native_clips_are_refused(void **state) {
    (void)state;
    static const char *const clips[] = {"1",
                                        "[]",
                                        "[1]",
                                        "[{}]",
                                        "[{\"curves\":[1]}]",
                                        "[{\"curves\":[],\"even_odd\":3}]",
                                        "[{\"curves\":[{\"degree\":1,\"points\":[[0,0,0],[1,1,1]]}]}]"};
    for (size_t i = 0; i < sizeof clips / sizeof *clips; i++) {
        char text[400];
        bat_document *document = NULL;
        bat_problem problem;
        snprintf(text, sizeof text,
                 "{\"batten\":6,\"page\":[0,0,9,9],\"objects\":[{\"id\":1,\"kind\":\"group\",\"clip\":%s}]}",
                 clips[i]);
        if (bat_document_read(text, strlen(text), &document, &problem) == BAT_OK) fail_msg("%s", text);
    }
}

static void running_out_of_memory(void **state) {
    (void)state;
    const long before = alloc_live();
    for (int n = 1;; n++) {
        bat_document *document = NULL;
        alloc_fail_at(n);
        const bat_status status = read_file(ALL, &document, NULL);
        const bool failed = alloc_fail_reached();
        bat_document_free(document);
        if (!failed) break;
        assert_int_equal(status, BAT_MEMORY);
    }
    for (int way = 0; way < 4; way++) {
        bat_document *document = opened(ALL, 0);
        move_all(document, (double[6]){1, 0, 0, 1, 7, -3});
        if (way & 1) bat_document_set_origin(document, NULL);
        for (int n = 1;; n++) {
            char *text = NULL;
            size_t size;
            alloc_fail_at(n);
            const bat_status status = way & 2 ? bat_document_write(document, &text, &size)
                                              : bat_svg_write(document, true, &text, &size);
            const bool failed = alloc_fail_reached();
            if (status == BAT_OK) bat_free(text);
            if (!failed) break;
            assert_int_equal(status, BAT_MEMORY);
        }
        bat_document_free(document);
    }
    assert_int_equal(alloc_live(), before);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(regions_are_where_they_are),
        cmocka_unit_test(clips_lie_in_others),
        cmocka_unit_test(what_cannot_clip_is_noted),
        cmocka_unit_test(what_is_moved_takes_its_clip_along),
        cmocka_unit_test(a_clip_can_go),
        cmocka_unit_test(bad_native_clips_are_refused),
        cmocka_unit_test(running_out_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
