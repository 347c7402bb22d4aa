/* What paints an object beyond its style: checks, copies, changes of style, files, SVG and back. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "support/alloc_fail.h"
#include "support/xml.h"
#include <batten/bezier.h>
#include <batten/curve.h>
#include <batten/format.h>
#include <batten/paint.h>

#include <math.h>
#include <stdlib.h>

static const bat_stop STOPS[] = {{0, 0xff0000ff}, {0.5, 0x00ff0080}, {1, 0x0000ffff}};
static const double DASHES[] = {4, 1.5, 0.25};

static bat_paint rich(void) {
    return (bat_paint){
        .fill = {true, BAT_SPREAD_REFLECT, {3, 4, 0}, {5, 5, 6}, {2, 0.5, -0.25, 1, 7, -9}, 3, STOPS, NULL},
        .stroke = {false, BAT_SPREAD_REPEAT, {0, 0, 0}, {1, 0.1, 0}, {9, 0, 0, 9, 1, 2}, 2, STOPS, NULL},
        .dash_count = 3,
        .dashes = DASHES,
        .dash_offset = -2,
        .pen = {2, 0, 0, 0.5}};
}

static bat_object *shape(void) {
    const double knots[] = {0, 0, 1, 2, 3, 3}, points[] = {0, 0, 10, 0, 10, 8, 0, 0};
    bat_curve *curve = NULL;
    bat_object *object = NULL;
    bat_style style = bat_style_defaults();
    style.filled = true;
    assert_int_equal(bat_curve_create(2, 1, false, 4, points, 6, knots, &curve), BAT_OK);
    assert_int_equal(bat_object_create_path(1, "s", &style, 1, &curve, &object), BAT_OK);
    return object;
}

static bat_object *painted(void) {
    bat_object *plain = shape(), *made = NULL;
    const bat_paint paint = rich();
    assert_int_equal(bat_object_with_paint(plain, &paint, &made), BAT_OK);
    assert_null(bat_object_paint(plain));
    bat_object_release(plain);
    return made;
}

static bat_document *drawing(void) {
    bat_document *document = NULL;
    bat_object *object = painted();
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    return document;
}

static void refuse(bat_paint paint, bat_status expected) {
    bat_object *plain = shape(), *made = NULL;
    assert_int_equal(bat_object_with_paint(plain, &paint, &made), expected);
    assert_null(made);
    bat_object_release(plain);
}

static void bad_paints_are_refused(void **state) {
    (void)state;
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e80};
    for (int i = 0; i < 4; i++) {
        bat_paint p = rich();
        p.fill.matrix[2] = bad[i];
        refuse(p, BAT_NUMBER);
        p = rich(), p.stroke.to[1] = bad[i];
        refuse(p, BAT_NUMBER);
        p = rich(), p.dash_offset = bad[i];
        refuse(p, BAT_NUMBER);
        p = rich(), p.pen[3] = bad[i];
        refuse(p, BAT_NUMBER);
    }
    bat_paint p = rich();
    p.fill.matrix[0] = p.fill.matrix[1] = 0; /* singular */
    refuse(p, BAT_NUMBER);
    p = rich(), p.fill.to[2] = 0;
    refuse(p, BAT_NUMBER);
    p = rich(), p.stroke.from[2] = 1; /* a line has no radius */
    refuse(p, BAT_NUMBER);
    p = rich(), p.fill.count = 1;
    refuse(p, BAT_COUNT);
    p = rich(), p.fill.count = SIZE_MAX;
    refuse(p, BAT_COUNT);
    p = rich(), p.dash_count = BAT_DASHES_MAX + 1;
    refuse(p, BAT_COUNT);
    p = rich(), p.stroke.spread = (bat_spread)3;
    refuse(p, BAT_ARGUMENT);
    const bat_stop back[] = {{0.5, 1}, {0.4, 1}};
    p = rich(), p.stroke.stops = back;
    refuse(p, BAT_NUMBER);
    const double none[] = {0, 0}, less[] = {1, -1};
    p = rich(), p.dashes = none, p.dash_count = 2;
    refuse(p, BAT_NUMBER);
    p.dashes = less;
    refuse(p, BAT_NUMBER);
    bat_object *group = NULL, *made = NULL;
    assert_int_equal(bat_object_create_group(2, "", false, &group), BAT_OK);
    p = rich();
    assert_int_equal(bat_object_with_paint(group, &p, &made), BAT_ARGUMENT);
    bat_object_release(group);
}

static void same(const bat_gradient *a, const bat_gradient *b) {
    assert_true(a->radial == b->radial && a->spread == b->spread && a->count == b->count);
    for (int i = 0; i < 3; i++) assert_true(a->from[i] == b->from[i] && a->to[i] == b->to[i]);
    for (int i = 0; i < 6; i++) assert_true(fabs(a->matrix[i] - b->matrix[i]) <= 1e-12);
    for (size_t i = 0; i < a->count; i++)
        assert_true(a->stops[i].at == b->stops[i].at && a->stops[i].colour == b->stops[i].colour);
}

static void check_rich(const bat_object *object) {
    const bat_paint *p = bat_object_paint(object), r = rich();
    assert_non_null(p);
    same(&p->fill, &r.fill);
    same(&p->stroke, &r.stroke);
    assert_int_equal(p->dash_count, 3);
    for (int i = 0; i < 3; i++) assert_true(fabs(p->dashes[i] - DASHES[i]) <= 1e-12);
    assert_true(fabs(p->dash_offset + 2) <= 1e-12);
    for (int i = 0; i < 4; i++) assert_true(fabs(p->pen[i] - r.pen[i]) <= 1e-12);
}

/* Copies keep it; a gradient goes with the colour that it stands for, and only that one. */
static void copies_keep_it(void **state) {
    (void)state;
    bat_object *object = painted(), *made[4] = {0};
    check_rich(object);
    assert_int_equal(bat_object_with_name(object, "other", &made[0]), BAT_OK);
    check_rich(made[0]);
    bat_style style = *bat_object_style(object);
    style.width = 7;
    assert_int_equal(bat_object_with_style(object, &style, &made[1]), BAT_OK);
    check_rich(made[1]);
    style.fill = 0x123456ff;
    assert_int_equal(bat_object_with_style(object, &style, &made[2]), BAT_OK);
    assert_int_equal(bat_object_paint(made[2])->fill.count, 0);
    assert_int_equal(bat_object_paint(made[2])->stroke.count, 2);
    assert_int_equal(bat_object_paint(made[2])->dash_count, 3);
    assert_int_equal(bat_object_with_paint(made[2], NULL, &made[3]), BAT_OK);
    assert_null(bat_object_paint(made[3]));
    for (int i = 0; i < 4; i++) bat_object_release(made[i]);
    bat_object_release(object);
}

static void files_keep_it(void **state) {
    (void)state;
    bat_document *document = drawing(), *back = NULL;
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    assert_memory_equal(text, "{\"batten\":4", 11);
    assert_int_equal(bat_document_read(text, size, &back, NULL), BAT_OK);
    check_rich(bat_document_at(back, 0));
    assert_true(bat_document_digest(back) == bat_document_digest(document));
    bat_document_free(back);
    bat_document_free(document);
    bat_free(text);
}

/* With the native document and without: the drawing alone says it all. */
static void svg_keeps_it(void **state) {
    (void)state;
    for (int native = 0; native < 2; native++) {
        bat_document *document = drawing(), *back = NULL;
        char *text = NULL;
        size_t size;
        bat_svg_report report;
        assert_int_equal(bat_svg_write(document, native, &text, &size), BAT_OK);
        assert_int_equal(xml_read(text, NULL, &back, &report, NULL), BAT_OK);
        assert_int_equal(report.native, native);
        assert_false(report.edited);
        check_rich(bat_document_at(back, 0));
        assert_true(fabs(bat_object_style(bat_document_at(back, 0))->width - 2) <= 1e-12);
        bat_document_free(back);
        bat_document_free(document);
        bat_free(text);
    }
}

static bat_document *read_svg(const char *content, bat_svg_report *report) {
    char text[2000];
    bat_document *document = NULL;
    snprintf(text, sizeof text, "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 200 100'>%s</svg>",
             content);
    assert_int_equal(xml_read(text, NULL, &document, report, NULL), BAT_OK);
    return document;
}

/* Units, chains of href, percentages, transforms: where the ends come to lie, in the drawing's units. */
static void svg_says_where(void **state) {
    (void)state;
    static const struct {
        const char *attributes;
        double from[2], to[2];
    } cases[] = {
        {"", {20, 10}, {80, 10}},
        {"x2='0' y2='1'", {20, 10}, {20, 50}},
        {"gradientUnits='userSpaceOnUse'", {0, 0}, {400, 0}},
        {"gradientUnits='userSpaceOnUse' x1='5' y1='6' x2='25%' y2='10'", {10, 6}, {100, 10}},
        {"gradientTransform='translate(.5,.25)'", {50, 20}, {110, 20}},
        {"href='#c'", {20, 30}, {80, 50}},
        {"href='#c' y1='0'", {20, 10}, {80, 50}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1000];
        snprintf(
            text, sizeof text,
            "<linearGradient id='c' y1='.5' y2='1'><stop stop-color='red'/><stop offset='1'/>"
            "</linearGradient><linearGradient id='a' %s><stop stop-color='red'/><stop offset='50%%' "
            "stop-opacity='.5'/></linearGradient><g transform='scale(2,1)'><rect x='10' y='10' width='30' "
            "height='40' fill='url(#a)' fill-opacity='.5'/></g>",
            cases[i].attributes);
        bat_document *d = read_svg(text, NULL);
        const bat_gradient *g = &bat_object_paint(bat_document_at(d, 0))->fill;
        const double *m = g->matrix, *ends[2] = {g->from, g->to}, *expected[2] = {cases[i].from, cases[i].to};
        for (int k = 0; k < 2; k++) {
            const double x = m[0] * ends[k][0] + m[2] * ends[k][1] + m[4];
            const double y = m[1] * ends[k][0] + m[3] * ends[k][1] + m[5];
            if (!(fabs(x - expected[k][0]) + fabs(y - expected[k][1]) <= 1e-9)) fail_msg("%s", text);
        }
        assert_true(g->count == 2 && g->stops[1].at == 0.5);
        assert_int_equal(g->stops[0].colour, 0xff000080);
        assert_int_equal(g->stops[1].colour, 0x00000040);
        bat_document_free(d);
    }
}

/* SVG 2, 14.2: one stop, or no extent, is one colour; no stops, or a box without an area, nothing. */
static void svg_degenerates(void **state) {
    (void)state;
    bat_svg_report report;
    bat_document *d = read_svg(
        "<linearGradient id='a'><stop stop-color='#00ff00'/></linearGradient>"
        "<linearGradient id='b' x2='0'><stop stop-color='red'/><stop offset='1' stop-color='blue'/>"
        "</linearGradient><radialGradient id='c' href='#b' r='0'/><linearGradient id='d'/>"
        "<g stroke='black'><rect width='9' height='9' fill='url(#a)'/><rect width='9' height='9' "
        "fill='url(#b)'/>"
        "<rect width='9' height='9' fill='url(#c)'/><rect width='9' height='9' fill='url(#d)'/>"
        "<path d='M0 0H9' fill='url(#b)'/></g>",
        &report);
    static const uint32_t fills[] = {0x00ff00ff, 0x0000ffff, 0x0000ffff};
    for (int i = 0; i < 5; i++) {
        const bat_object *object = bat_document_at(d, bat_document_count(d) - 5 + i);
        assert_null(bat_object_paint(object));
        assert_int_equal(bat_object_style(object)->filled, i < 3);
        if (i < 3) assert_int_equal(bat_object_style(object)->fill, fills[i]);
    }
    assert_int_equal(report.lost.count[BAT_LOSS_GRADIENT], 0);
    bat_document_free(d);
}

static void svg_dashes(void **state) {
    (void)state;
    bat_svg_report report;
    bat_document *d = read_svg(
        "<g stroke='red' stroke-dasharray='4, 1px 10%' stroke-dashoffset='3' "
        "transform='scale(2)'><path d='M0 0H9'/><path d='M0 0H9' style='stroke-dasharray:"
        "none'/><path d='M0 0H9' stroke-dasharray='0 0'/></g>",
        &report);
    const bat_paint *p = bat_object_paint(bat_document_at(d, bat_document_count(d) - 3));
    assert_int_equal(p->dash_count, 3);
    assert_true(p->dashes[0] == 8 && p->dashes[1] == 2 && p->dash_offset == 6);
    assert_true(fabs(p->dashes[2] - 20 * sqrt((200 * 200 + 100 * 100) / 2.0) / 100) <= 1e-9);
    assert_null(bat_object_paint(bat_document_at(d, bat_document_count(d) - 2)));
    assert_null(bat_object_paint(bat_document_at(d, bat_document_count(d) - 1)));
    bat_document_free(d);
}

/* The order of SVG: what is not named comes last, the fill before the stroke; kept by SVG and by the native format. */
static void strokes_under_fills(void **state) {
    (void)state;
    static const struct {
        const char *order;
        bool first;
    } cases[] = {{"normal", false},
                 {"stroke", true},
                 {"fill", false},
                 {"markers stroke", true},
                 {"fill stroke", false},
                 {"stroke fill", true},
                 {"markers", false},
                 {"stroke markers fill", true},
                 {"markers fill stroke", false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int way = 0; way < 4; way++) {
            char content[300], *text = NULL;
            size_t size;
            bat_svg_report report;
            bat_document *back = NULL;
            snprintf(content, sizeof content,
                     way & 1 ? "<g paint-order='%s' stroke='red'><path d='M0 0H9V9'/></g>"
                             : "<path stroke='red' style='paint-order:%s' d='M0 0H9V9'/>",
                     cases[i].order);
            bat_document *d = read_svg(content, &report);
            const bat_paint *p = bat_object_paint(bat_document_at(d, bat_document_count(d) - 1));
            assert_int_equal(p && p->stroke_first, cases[i].first);
            assert_int_equal(report.lost.count[BAT_LOSS_ORDER], 0);
            if (way & 2) {
                assert_int_equal(bat_document_write(d, &text, &size), BAT_OK);
                assert_int_equal(strstr(text, "{\"batten\":6") != NULL, cases[i].first);
                assert_int_equal(bat_document_read(text, size, &back, NULL), BAT_OK);
                assert_true(bat_document_digest(back) == bat_document_digest(d));
            } else {
                bat_document_set_origin(d, NULL);
                assert_int_equal(bat_svg_write(d, false, &text, &size), BAT_OK);
                assert_int_equal(xml_read(text, NULL, &back, &report, NULL), BAT_OK);
            }
            p = bat_object_paint(bat_document_at(back, bat_document_count(back) - 1));
            assert_int_equal(p && p->stroke_first, cases[i].first);
            bat_free(text);
            bat_document_free(back);
            bat_document_free(d);
        }
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    bat_object *object = painted();
    const long before = alloc_live();
    for (int n = 1;; n++) {
        bat_object *made = NULL, *restyled = NULL;
        const bat_paint paint = rich();
        bat_style style = *bat_object_style(object);
        style.stroke ^= 0xff00;
        alloc_fail_at(n);
        const bat_status first = bat_object_with_paint(object, &paint, &made);
        const bat_status second = bat_object_with_style(object, &style, &restyled);
        const bool failed = alloc_fail_reached();
        assert_int_equal(first == BAT_MEMORY || second == BAT_MEMORY, failed);
        bat_object_release(made);
        bat_object_release(restyled);
        assert_int_equal(alloc_live(), before);
        if (!failed) break;
    }
    bat_object_release(object);
}

/* Widths along a stroke: copied with the object, checked, written to both files and found again. */
static void widths_along_strokes(void **state) {
    (void)state;
    const bat_width_stop stops[] = {{0, 0.25}, {0.5, 1}, {1, 0}}, bad[] = {{0.5, 1}, {0.5, 2}},
                         flat[] = {{0, 1}, {1, 1}};
    bat_object *plain = shape(), *wide = NULL, *other = NULL;
    bat_paint paint = {.width_count = 3, .widths = stops};
    assert_int_equal(bat_object_with_paint(plain, &paint, &wide), BAT_OK);
    assert_int_equal(bat_object_widths(plain).count, 0);
    assert_true(bat_object_widths(wide).count == 3 &&
                !memcmp(bat_object_widths(wide).stops, stops, sizeof stops));
    paint.widths = bad, paint.width_count = 2;
    assert_int_equal(bat_object_with_paint(plain, &paint, &other), BAT_NUMBER);
    paint.widths = flat; /* as without */
    assert_int_equal(bat_object_with_paint(wide, &paint, &other), BAT_OK);
    assert_null(bat_object_paint(other));
    bat_object_release(other);
    for (int filled = 0; filled < 2; filled++)
        for (int half = 0; half < 2; half++) {
            bat_style style = *bat_object_style(wide);
            style.filled = filled, style.opacity = half ? 0.5 : 1;
            bat_document *document = NULL, *again = NULL, *seen = NULL;
            char *text;
            size_t size;
            assert_int_equal(bat_object_with_style(wide, &style, &other), BAT_OK);
            assert_int_equal(bat_document_create(&document), BAT_OK);
            assert_int_equal(bat_document_insert(document, 0, other), BAT_OK);
            assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
            assert_non_null(strstr(text, "{\"batten\":7,"));
            assert_non_null(strstr(text, "\"widths\":[[0,0.25],[0.5,1],[1,0]]"));
            assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
            assert_true(bat_document_digest(again) == bat_document_digest(document));
            bat_document_free(again);
            bat_free(text);
            assert_int_equal(bat_svg_write(document, true, &text, &size), BAT_OK);
            assert_int_equal(xml_read(text, NULL, &again, NULL, NULL), BAT_OK);
            assert_true(bat_document_digest(again) ==
                        bat_document_digest(document)); /* by the drawing within */
            bat_free(text);
            assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
            assert_int_equal(xml_read(text, NULL, &seen, NULL, NULL), BAT_OK);
            int paths = 0;
            for (int i = 0; i < bat_document_count(seen); i++)
                if (!bat_object_is_group(bat_document_at(seen, i))) {
                    assert_true(bat_object_style(bat_document_at(seen, i))->filled &&
                                !bat_object_style(bat_document_at(seen, i))->stroked);
                    paths++;
                }
            assert_int_equal(paths, 1 + filled);
            bat_free(text);
            bat_document_free(seen), bat_document_free(again), bat_document_free(document);
            bat_object_release(other);
        }
    bat_object_release(wide), bat_object_release(plain);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bad_paints_are_refused),
        cmocka_unit_test(copies_keep_it),
        cmocka_unit_test(files_keep_it),
        cmocka_unit_test(svg_keeps_it),
        cmocka_unit_test(svg_says_where),
        cmocka_unit_test(svg_degenerates),
        cmocka_unit_test(svg_dashes),
        cmocka_unit_test(strokes_under_fills),
        cmocka_unit_test(widths_along_strokes),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
