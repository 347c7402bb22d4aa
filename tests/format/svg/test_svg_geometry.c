/* Where style says where elements are (SVG 2, geometry properties; CSS Transforms): each is where attributes that mean the same
 * put it, what browsers do not obey is not obeyed, and what is edited is where it was put, the file being kept. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "editor/edit/affine.h"
#include <batten/bezier.h>
#include "document/document.h"
#include "support/svg_kept.h"
#include <batten/format.h>
#include <math.h>

#define HEAD "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 200 100'><title>T</title>"
#define RECT "<rect x='10' y='20' width='30' height='10' "

static bat_document *opened(const char *body, int *broken) {
    char text[2000];
    bat_document *document = NULL;
    bat_svg_report report;
    snprintf(text, sizeof text, "%s%s</svg>", HEAD, body);
    assert_int_equal(svg_read_kept(NULL, text, strlen(text), &document, &report), BAT_OK);
    if (broken) *broken = report.lost.count[BAT_LOSS_BROKEN];
    return document;
}

static void expect_places(const bat_document *one, const bat_document *other, double slack,
                          const char *what) {
    assert_int_equal(bat_document_count(one), bat_document_count(other));
    for (int i = 0; i < bat_document_count(one); i++) {
        double a[4], b[4];
        bat_object_bounds(bat_document_at(one, i), a);
        bat_object_bounds(bat_document_at(other, i), b);
        for (int k = 0; k < 4; k++)
            if (!(fabs(a[k] - b[k]) <= slack)) fail_msg("%s: object %d: %g, not %g", what, i, a[k], b[k]);
    }
}

static const struct {
    const char *styled, *plain;
} PAIRS[] = {
    {"<style>rect{x:10px;y:20px;width:30px;height:10%}</style><rect/>", RECT "/>"},
    {"<style>#a{x:10px!important}</style><rect id='a' y='20' width='30' height='10' style='x:7px'/>",
     RECT "/>"},
    {RECT "style='rx:20%;ry:auto'/>", RECT "rx='40'/>"},
    {RECT "style='width:-5px;x:calc();rx:-1px'/>", RECT "/>"},
    {RECT "style='x:initial;width:auto'/><path d='M0 0H9V9z'/>", "<path d='M0 0H9V9z'/>"},
    {"<circle style='cx:10%;cy:30px;r:5px'/>", "<circle cx='20' cy='30' r='5'/>"},
    {"<ellipse style='cx:9px;cy:30px;rx:5px'/>", "<ellipse cx='9' cy='30' rx='5' ry='5'/>"},
    {"<path d='M0 0H5V5z' style='d:path( \"M1 1H9V9z\" )'/>", "<path d='M1 1H9V9z'/>"},
    {"<path d='M0 0H5V5z' style='d:path(\"M1 1H\")'/>", "<path d='M0 0H5V5z'/>"},
    {"<path d='M0 0H5V5z' style='d:none'/><path d='M0 0H5V5z'/>", "<path d='M0 0H5V5z'/>"},
    {"<line x2='9' y2='9' stroke='red' style='x:3px;x2:5px'/>", "<line x2='9' y2='9' stroke='red'/>"},
    {"<rect id='u' width='9' height='9'/><use href='#u' style='x:5px;y:6px;width:3px'/>",
     "<rect id='u' width='9' height='9'/><use href='#u' x='5' y='6'/>"},
    {"<svg width='50' height='50' style='x:9px'><rect width='9' height='9'/></svg>",
     "<svg width='50' height='50'><rect width='9' height='9'/></svg>"},
    {"<rect style='--w:30px;x:10px;y:20px;width:var(--w);height:var(--h, 10px)'/>", RECT "/>"},
    {RECT "transform='scale(3)' style='transform:translate(5px, 10%) scale(50%) rotate(.25turn)'/>",
     RECT "transform='translate(5 10) scale(.5) rotate(90)'/>"},
    {RECT "style='transform:translate(5,5)'/>", RECT "/>"}, /* has no units */
    {RECT "style='translate:5px 1px;rotate:90deg;scale:2 3;transform:translateX(1px)'/>",
     RECT "transform='translate(5 1) rotate(90) scale(2 3) translate(1)'/>"},
    {RECT "style='transform:translate3d(1px,2px,0) skew(10deg) scaleY(2)'/>",
     RECT "transform='translate(1 2) skewX(10) scale(1 2)'/>"},
    {RECT "style='transform:matrix(1,0,0,1,4,5)rotatez(100grad)'/>",
     RECT "transform='matrix(1 0 0 1 4 5) rotate(90)'/>"},
    {RECT "transform='rotate(90)' transform-origin='9 8'/>", RECT "transform='rotate(90 9 8)'/>"},
    {RECT "style='transform:rotate(90deg);transform-origin:bottom left'/>",
     RECT "transform='rotate(90 0 100)'/>"},
    {RECT "style='transform:rotate(90deg);transform-origin:center;transform-box:fill-box'/>",
     RECT "transform='rotate(90 25 25)'/>"},
    {RECT "style='transform:rotate(90deg);transform-box:content-box'/>",
     RECT "transform='rotate(90 10 20)'/>"},
    {RECT "style='transform:translate(10%,10%);transform-box:fill-box'/>",
     RECT "transform='translate(3 1)'/>"},
    {"<g style='transform-box:fill-box;transform-origin:center;transform:translate(4px)'>" RECT "/></g>",
     "<g transform='translate(4)'>" RECT "/></g>"},
};

static void style_places_as_attributes_do(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof PAIRS / sizeof *PAIRS; i++) {
        bat_document *styled = opened(PAIRS[i].styled, NULL), *plain = opened(PAIRS[i].plain, NULL);
        expect_places(styled, plain, 1e-9, PAIRS[i].styled);
        bat_document_free(styled);
        bat_document_free(plain);
    }
}

static void what_is_not_understood_is_said(void **state) {
    (void)state;
    static const struct {
        const char *body;
        int broken;
    } cases[] = {
        {RECT "style='x:10px;transform:rotate(9deg)'/>", 0},
        {RECT "style='x:calc(1px + 2px)'/>", 1},
        {RECT "style='transform:rotateX(9deg)'/>", 1},
        {RECT "stroke='red' style='transform:rotate(9deg);transform-box:stroke-box'/>", 1},
        {"<g style='transform:rotate(9deg);transform-box:fill-box'>" RECT "/></g>", 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        int broken;
        bat_document_free(opened(cases[i].body, &broken));
        if (broken != cases[i].broken) fail_msg("%s: %d", cases[i].body, broken);
    }
}

static void edit(bat_document *document, int index, const double m[6]) {
    bat_object *made = NULL;
    assert_int_equal(bat_affine_object(bat_document_at(document, index), m, false, &made), BAT_OK);
    assert_int_equal(bat_document_replace(document, index, made), BAT_OK);
    bat_object_release(made);
}

static void what_is_edited_is_where_it_was_put(void **state) {
    (void)state;
    static const double maps[][6] = {{1, 0, 0, 1, 0.02, 0}, {1, .2, -.2, 1, 3, 4}, {2, 0, 0, .5, 0, 0}};
    for (size_t i = 0; i < sizeof PAIRS / sizeof *PAIRS; i++)
        for (size_t how = 0; how < sizeof maps / sizeof *maps; how++)
            for (int k = 0, count = 1; k < count; k++) {
                bat_document *document = opened(PAIRS[i].styled, NULL), *again = NULL;
                char *text = NULL;
                size_t size;
                count = bat_document_count(document);
                if (!bat_object_is_drawn(bat_document_at(document, k))) {
                    bat_document_free(document);
                    continue;
                }
                edit(document, k, maps[how]);
                assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
                if (!strstr(text, "<title>T</title>")) fail_msg("%s: written anew", PAIRS[i].styled);
                assert_int_equal(svg_read_kept(NULL, text, size, &again, NULL), BAT_OK);
                expect_places(document, again, 2e-3, text);
                bat_free(text);
                bat_document_free(again);
                bat_document_free(document);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(style_places_as_attributes_do),
        cmocka_unit_test(what_is_not_understood_is_said),
        cmocka_unit_test(what_is_edited_is_where_it_was_put),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
