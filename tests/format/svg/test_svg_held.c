/* Beside the drawing of a kept file stands only what SVG cannot hold: it is light, it comes back bit for bit, and what another
 * program has changed is read from its element while all else keeps its knots. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/svg_kept.h"
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/levels.h>
#include <batten/tangents.h>
#include <batten/view.h>

#include <math.h>
#include <stdlib.h>

static const char FILE_OF_FOUR[] =
    "<?xml version='1.0'?>\r\n<!DOCTYPE svg [<!ENTITY red '#f00'>]>\n<s:svg "
    "xmlns:s='http://www.w3.org/2000/svg' viewBox='0 0 "
    "90 90'>\r\n"
    "<s:path id='a' d='M0 0C10 20 30 20 40 0' fill='none' stroke='&red;'/>\r\n"
    "<s:g id='both'><s:path id='b' d='M0 30C10 50 30 50 40 30' fill='none' stroke='#0f0'/>\r\n"
    "<s:path id='c' d='M0 60C10 80 30 80 40 60' fill='none' stroke='#00f'/></s:g>\r\n"
    "<s:path id='d' d='M50 0C60 20 80 20 90 0M50 40H90V80' fill='none' stroke='#000' display='none'/>\r\n"
    "</s:svg>\n";

static bat_svg_report report;

static bat_document *opened(const char *text) {
    const bat_svg_options options = bat_svg_merging();
    bat_document *document = NULL;
    assert_int_equal(svg_read_kept(&options, text, strlen(text), &document, &report), BAT_OK);
    assert_null(bat_document_check(document));
    return document;
}

static char *written(const bat_document *document, bool native) {
    char *text = NULL;
    size_t size = 0;
    assert_int_equal(bat_svg_write(document, native, &text, &size), BAT_OK);
    return text;
}

static const bat_object *named(const bat_document *document, const char *name) {
    for (int i = 0; i < bat_document_count(document); i++)
        if (strcmp(bat_object_name(bat_document_at(document, i)), name) == 0)
            return bat_document_at(document, i);
    return NULL;
}

static void put(bat_document *document, bat_object *made) {
    assert_non_null(made);
    assert_int_equal(bat_document_replace(document, bat_document_find(document, bat_object_id(made)), made),
                     BAT_OK);
    bat_object_release(made);
}

/* A curve with knots that no path can hold, near where the object is. */
static void redraw(bat_document *document, const char *name, random_source *r) {
    const bat_object *object = named(document, name);
    bat_curve *curves[8];
    bat_object *made = NULL;
    double box[4];
    const int count = bat_object_curve_count(object);
    assert_in_range(count, 1, 8);
    for (int k = 0; k < count; k++) {
        enum { POINTS = 9 };
        double points[2 * POINTS], knots[POINTS + 4] = {0};
        bat_object_bounds(object, box);
        for (int i = 0; i < POINTS; i++) {
            points[2 * i] = box[0] + (box[2] - box[0]) * i / (POINTS - 1);
            points[2 * i + 1] = random_between(r, box[1], box[3]);
        }
        for (int i = 4; i < POINTS; i++) knots[i] = knots[i - 1] + random_between(r, 0.1, 2);
        for (int i = POINTS; i < POINTS + 4; i++) knots[i] = knots[POINTS - 1] + 1;
        assert_int_equal(bat_curve_create(2, 3, false, POINTS, points, POINTS + 4, knots, &curves[k]),
                         BAT_OK);
    }
    assert_int_equal(bat_object_with_curves(object, count, curves, &made), BAT_OK);
    put(document, made);
}

static bat_document *redrawn(uint64_t seed) {
    static const char *const names[] = {"a", "b", "c", "d"};
    random_source r = {seed};
    bat_document *document = opened(FILE_OF_FOUR);
    for (int i = 0; i < 4; i++) redraw(document, names[i], &r);
    return document;
}

static bool has_same_curves(const bat_document *one, const bat_document *other, const char *name) {
    const bat_object *a = named(one, name), *b = named(other, name);
    if (!a || !b || bat_object_curve_count(a) != bat_object_curve_count(b)) return false;
    for (int i = 0; i < bat_object_curve_count(a); i++)
        if (!bat_curve_is_equal(bat_object_curve(a, i), bat_object_curve(b, i))) return false;
    return true;
}

static int count_of(const char *text, const char *what) {
    int count = 0;
    while ((text = strstr(text, what))) count++, text++;
    return count;
}

/* The text in which `old`, which is there once, is replaced. */
static char *replaced(const char *text, const char *old, const char *with) {
    const char *at = strstr(text, old);
    assert_non_null(at);
    assert_null(strstr(at + 1, old));
    const size_t size = strlen(text) - strlen(old) + strlen(with) + 1;
    char *made = malloc(size);
    assert_non_null(made);
    snprintf(made, size, "%.*s%s%s", (int)(at - text), text, with, at + strlen(old));
    return made;
}

static void comes_back(bat_document *document) {
    char *text = written(document, true), *again;
    assert_non_null(strstr(text, " drawing=\"")); /* not the whole document */
    bat_document *back = opened(text);
    assert_true(report.native && !report.edited);
    assert_int_equal(report.lost.count[BAT_LOSS_NATIVE], 0);
    assert_true(bat_svg_is_kept(back));
    assert_true(bat_document_digest(back) == bat_document_digest(document));
    assert_true(bat_document_next(back) == bat_document_next(document));
    again = written(back, true);
    assert_string_equal(again, text);
    bat_free(again);
    bat_free(text);
    bat_document_free(back);
}

static void an_edit_lists_its_object_alone(void **state) {
    (void)state;
    for (int which = 0; which < 5; which++) {
        static const char *const names[] = {"a", "b", "c", "d"};
        random_source r = {3};
        bat_document *document = opened(FILE_OF_FOUR);
        if (which < 4)
            redraw(document, names[which], &r);
        else
            assert_int_equal(bat_document_remove(document, 0), BAT_OK); /* others have other ids when read */
        char *text = written(document, true), *plain = written(document, false);
        assert_int_equal(count_of(text, "\n[") == 1, which < 4);
        assert_true(strlen(text) <= strlen(plain) + 200 + 2 * 13 * 40);
        if (which == 4) assert_true(strlen(text) < strlen(plain) + 200);
        bat_free(text);
        bat_free(plain);
        comes_back(document);
        bat_document_free(document);
    }
    bat_document *document = redrawn(5);
    comes_back(document);
    bat_document_free(document);
}

/* Read exactly, it comes back as it was read, whatever a reader asks for. */
static void nodes_are_read_as_they_were(void **state) {
    (void)state;
    const char *file =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 90'><path id='a' d='M0 0L10 0L20 0L30 0'/>"
        "<path id='b' d='M0 9C5 9 10 9 15 9C20 9 25 9 30 9'/></svg>";
    for (int merged = 0; merged < 2; merged++) {
        const bat_svg_options options = merged ? bat_svg_merging() : bat_svg_defaults(),
                              others = merged ? bat_svg_defaults() : bat_svg_merging();
        random_source r = {9};
        bat_document *document, *back;
        assert_int_equal(svg_read_kept(&options, file, strlen(file), &document, NULL), BAT_OK);
        redraw(document, "b", &r);
        char *text = written(document, true);
        assert_non_null(strstr(text, " drawing=\""));
        assert_int_equal(svg_read_kept(&others, text, strlen(text), &back, &report), BAT_OK);
        assert_true(report.native && bat_document_digest(back) == bat_document_digest(document));
        bat_free(text);
        bat_document_free(back);
        bat_document_free(document);
    }
}

/* Another program edits the text: `with` in the place of `old`. Of the objects a, b, c and d those that are listed in `kept` have
 * every knot, and of the others as many as `lost` are said to be changed. */
static void expect_after(const char *old, const char *with, const char *kept, int lost) {
    bat_document *document = redrawn(7);
    char *text = written(document, true), *other = replaced(text, old, with), line[300];
    bat_document *back = opened(other);
    for (const char *name = "abcd"; *name; name++) {
        const char one[2] = {*name, 0};
        if (has_same_curves(document, back, one) != (strchr(kept, *name) != NULL))
            fail_msg("%s: %s", one, with);
    }
    assert_int_equal(report.lost.count[BAT_LOSS_NATIVE], lost);
    assert_int_equal(report.edited, lost > 0);
    assert_true(report.native && bat_svg_is_kept(back));
    bat_svg_report_line(&report, line, sizeof line);
    assert_int_equal(strstr(line, "changed by another program") != NULL, lost > 0);
    char *again = written(back, true); /* untouched */
    assert_string_equal(again, other);
    random_source r = {11};
    redraw(back, "b", &r); /* and edited: all that came back comes back again */
    comes_back(back);
    bat_free(again);
    free(other);
    bat_free(text);
    bat_document_free(back);
    bat_document_free(document);
}

static void what_others_changed_is_read(void **state) {
    (void)state;
    expect_after("stroke='#0f0'", "stroke='#0e0'", "acd", 1);
    expect_after("<s:path id='c'", "<s:path transform='translate(1)' id='c'", "abd", 1);
    expect_after("<s:g id='both'>", "<s:g id='both' transform='scale(2)'>", "ad", 2);
    expect_after("<s:path id='a'", "<s:path opacity='.5' id='a'", "bcd", 1);
    /* What does not change a picture changes nothing. */
    expect_after("<s:g id='both'>", "<s:g id='both'\n\tclass='x'>", "abcd", 0);
    expect_after("stroke='&red;'", "style='stroke:red'", "abcd", 0);
    expect_after("<s:path id='a'", "<s:path id='a' display='none'", "abcd", 0);
    expect_after("<s:path id='d'", "<s:path id='d' data-locked='true'", "abcd", 0);
}

static void others_may_add_move_and_delete(void **state) {
    (void)state;
    expect_after("<s:path id='a'", "<s:rect width='3' height='3'/><s:path id='a'", "abcd", 0);
    expect_after("<s:path id='a'", "<s:defs><s:path id='x' d='M0 0h9'/></s:defs><s:path id='a'", "abcd", 0);
    expect_after("<s:path id='a'",
                 "<s:path d='M0 0h9v9z'/><s:g><s:circle r='3'/><s:circle r='4'/></s:g><s:path id='a'", "abcd",
                 0);
    expect_after("<s:g id='both'>", "<s:g>", "abcd", 0);
    expect_after("</s:g>", "<s:path d='M0 0h9'/></s:g>", "abcd", 0);
    /* Elements are deleted, doubled, and in another order. */
    bat_document *document = redrawn(7);
    char *text = written(document, true);
    char *from = strstr(text, "<s:path id='a'"), *to = strchr(from, '>') + 1, element[600] = "";
    assert_true((size_t)(to - from) < sizeof element);
    memcpy(element, from, (size_t)(to - from));
    for (int way = 0; way < 3; way++) {
        char *without = way == 2 ? replaced(text, "</s:svg>", "</s:svg>") : replaced(text, element, "");
        char last[640];
        snprintf(last, sizeof last, "%s</s:svg>", way == 0 ? "" : element);
        char *other = replaced(without, "</s:svg>", last);
        bat_document *back = opened(other);
        assert_int_equal(has_same_curves(document, back, "a"), way > 0);
        assert_true(has_same_curves(document, back, "b") && has_same_curves(document, back, "c") &&
                    has_same_curves(document, back, "d"));
        assert_int_equal(report.lost.count[BAT_LOSS_NATIVE], way == 0);
        random_source r = {11};
        redraw(back, "b", &r);
        comes_back(back);
        free(without);
        free(other);
        bat_document_free(back);
    }
    bat_free(text);
    bat_document_free(document);
}

/* What paints nothing, what is made by other hands than the pen, and what is made from other objects. */
static void all_kinds_come_back(void **state) {
    (void)state;
    const double points[8] = {0, 0, 20, 9, 40, 0, 60, 9}, tangents[8] = {0, 0, 1, 0, 0, 0, 0, 0};
    const double origin[3] = {1, 2, 3}, axes[6] = {1, 0, 0, 0, 0, 1};
    const bat_viewpoint view = {.eye = {0, -40, 20}, .up = {0, 0, 1}, .size = {640, 480}, .fov = 40};
    bat_document *document = redrawn(13), *back;
    bat_style style = bat_style_defaults();
    bat_object *made[4] = {NULL};
    bat_shape *shape = NULL;
    const bat_spline spline = {.dimension = 2, .count = 4, .points = points, .tangents = tangents};
    assert_int_equal(bat_object_create_spline(20, "spline", &style, &spline, NULL, &made[0]), BAT_OK);
    assert_int_equal(bat_object_create_guide(21, 1, 1.0 / 3, &made[1]), BAT_OK);
    assert_int_equal(bat_object_create_plane(22, "plane", origin, axes, &made[2]), BAT_OK);
    assert_int_equal(bat_object_create_view(23, "view", &view, &made[3]), BAT_OK);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(bat_document_insert(document, i == 3 ? bat_document_count(document) : 1, made[i]),
                         BAT_OK);
        bat_object_release(made[i]);
    }
    const bat_object *object = named(document, "c");
    assert_int_equal(bat_shape_create(bat_object_curve(object, 0), NULL, &shape), BAT_OK);
    assert_int_equal(bat_object_with_shape(object, 0, shape, &made[0]), BAT_OK);
    put(document, made[0]);
    assert_null(bat_document_check(document));
    comes_back(document);
    char *text = written(document, true), *other = replaced(text, "stroke='#0f0'", "stroke='#0e0'");
    back = opened(other);
    assert_int_equal(report.lost.count[BAT_LOSS_NATIVE], 1);
    assert_int_equal(bat_object_kind(named(back, "spline")), BAT_KIND_SPLINE);
    assert_int_equal(bat_object_kind(named(back, "plane")), BAT_KIND_PLANE);
    assert_int_equal(bat_object_kind(named(back, "view")), BAT_KIND_VIEW);
    assert_int_equal(bat_object_kind(named(back, "c")), BAT_KIND_SHAPE);
    assert_true(has_same_curves(document, back, "a") && !has_same_curves(document, back, "b"));
    random_source r = {29};
    redraw(back, "b", &r);
    comes_back(back);
    bat_free(text);
    free(other);
    bat_document_free(back);
    bat_document_free(document);
}

/* A file of an earlier version, which holds the whole document. */
static void whole_documents_are_read(void **state) {
    (void)state;
    static const char text[] =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 90'>\n"
        "<metadata><batten:document xmlns:batten=\"urn:batten:1\" digest=\"1cdf8befb0fc947c\">"
        "{&quot;batten&quot;:1,&quot;page&quot;:[0,0,90,90],&quot;next&quot;:5,&quot;objects&quot;:["
        "{&quot;id&quot;:1,&quot;kind&quot;:&quot;path&quot;,&quot;name&quot;:&quot;&quot;,&quot;style&quot;:"
        "{"
        "&quot;stroked&quot;:true,&quot;stroke&quot;:&quot;#ff0000ff&quot;,&quot;width&quot;:1,&quot;cap&"
        "quot;:"
        "&quot;butt&quot;,&quot;join&quot;:&quot;miter&quot;,&quot;miter_limit&quot;:4,&quot;filled&quot;:"
        "false,"
        "&quot;fill&quot;:&quot;#00000000&quot;,&quot;even_odd&quot;:false,&quot;opacity&quot;:1},&quot;"
        "curves&quot;:[{"
        "&quot;degree&quot;:3,&quot;closed&quot;:false,&quot;knots&quot;:[0,0,0,0,0.5,1,1,1,1],&quot;points&"
        "quot;:[[0,0],"
        "[5,17],[20,30],[33.5,21],[40,0]]}]},{&quot;id&quot;:2,&quot;kind&quot;:&quot;group&quot;,&quot;name&"
        "quot;:"
        "&quot;two&quot;},{&quot;id&quot;:3,&quot;kind&quot;:&quot;path&quot;,&quot;name&quot;:&quot;&quot;,"
        "&quot;parent&quot;:2,&quot;style&quot;:{&quot;stroked&quot;:false,&quot;stroke&quot;:&quot;#"
        "00000000&quot;,"
        "&quot;width&quot;:1,&quot;cap&quot;:&quot;butt&quot;,&quot;join&quot;:&quot;miter&quot;,&quot;miter_"
        "limit&quot;:4,"
        "&quot;filled&quot;:true,&quot;fill&quot;:&quot;#000000ff&quot;,&quot;even_odd&quot;:false,&quot;"
        "opacity&quot;:1},"
        "&quot;curves&quot;:[{&quot;degree&quot;:3,&quot;closed&quot;:false,&quot;knots&quot;:[0,0,0,0,1,1,1,"
        "1],"
        "&quot;points&quot;:[[0,50],[16.666666666666668,33.33333333333333],[33.33333333333333,16."
        "666666666666668],"
        "[50,0]]}]},{&quot;id&quot;:4,&quot;kind&quot;:&quot;path&quot;,&quot;name&quot;:&quot;&quot;,&quot;"
        "parent&quot;:2,"
        "&quot;style&quot;:{&quot;stroked&quot;:false,&quot;stroke&quot;:&quot;#00000000&quot;,&quot;width&"
        "quot;:1,"
        "&quot;cap&quot;:&quot;butt&quot;,&quot;join&quot;:&quot;miter&quot;,&quot;miter_limit&quot;:4,&quot;"
        "filled&quot;:true,"
        "&quot;fill&quot;:&quot;#000000ff&quot;,&quot;even_odd&quot;:false,&quot;opacity&quot;:1},&quot;"
        "curves&quot;:[{"
        "&quot;degree&quot;:3,&quot;closed&quot;:true,&quot;knots&quot;:[0,0,0,1.1780479667564483,1."
        "1780479667564483,"
        "1.1780479667564483,1.70816955179685,1.70816955179685,1.70816955179685,2.9999999999999996],&quot;"
        "points&quot;:[["
        "15.666666666666668,9],[22.333333333333332,9],[29,9],[29,12],[29,15],[29,18],[22.333333333333332,15],"
        "["
        "15.666666666666668,12],[9,9]]}]}],&quot;elements&quot;:[[1,4],[2,5],[3,6],[4,7]]}"
        "</batten:document></metadata><!-- mine --><path d=\"M0 0C5 17 12.5 23.5 19.625 24.5C26.75 25.5 33.5 "
        "21 "
        "40 0\" fill='none' stroke='red'/><g id='two'><path d='M0 50L50 0'/><path d='M9 "
        "9h20v9z'/></g></svg>\n";
    static const double knots[9] = {0, 0, 0, 0, 0.5, 1, 1, 1, 1};
    bat_document *document = opened(text);
    assert_true(report.native && !report.edited && bat_svg_is_kept(document));
    const bat_curve *curve = bat_object_curve(bat_document_at(document, 0), 0);
    assert_memory_equal(bat_curve_knots(curve), knots, sizeof knots);
    bat_object *made = NULL;
    assert_int_equal(bat_object_with_name(bat_document_at(document, 1), "pair", &made), BAT_OK);
    put(document, made);
    char *light = written(document, true); /* what it holds now is less, and as much */
    assert_true(strlen(light) < strlen(text) / 2);
    bat_free(light);
    comes_back(document);
    bat_document_free(document);
}

/* Whatever stands there: the drawing is read, and it is said. */
static void what_is_damaged_is_not_read(void **state) {
    (void)state;
    static const char *const bad[] = {
        "",
        "{",
        "[]",
        "{\"batten\":10}",
        "{\"batten\":12}",
        "{\"batten\":11,\"next\":0}",
        "{\"batten\":11,\"page\":[0,1]}",
        "{\"batten\":11,\"unit\":3}",
        "{\"batten\":11,\"ids\":[[0]]}",
        "{\"batten\":11,\"ids\":[[1,1],[0,1]]}",
        "{\"batten\":11,\"pictures\":[5]}",
        "{\"batten\":11,\"objects\":[5]}",
        "{\"batten\":11,\"objects\":[[0,1,\"0123456789abcdef\"]]}",
        "{\"batten\":11,\"objects\":[[0,0,\"\",null]]}",
        "{\"batten\":11,\"objects\":[[0,2,\"0123456789abcdef\",[1,-1]]]}",
        "{\"batten\":11,\"objects\":[[0,1,\"0123456789abcdef\",[0,-1]]]}",
        "{\"batten\":11,\"objects\":[[0,1,\"0123456789abcdef\",[1]]]}",
        "{\"batten\":11,\"objects\":[[0,1,\"0123456789abcdef\",[1,-1,[0]]]]}",
        "{\"batten\":11,\"objects\":[[0,1,\"0123456789abcdef\",[1,-1,[0,\"AAAAA\"]]]]}",
        "{\"batten\":11,\"objects\":[[0,1,\"0123456789abcdef\",[1,-1,[0,\"////////////AAAA\",0,1]]]]}",
        "{\"batten\":11,\"objects\":[[0,1,\"0123456789abcdef\",[1,-1,[0,[1,2],0,9]]]]}",
        "{\"batten\":11,\"objects\":[[0,1,\"0123456789abcdef\",[1,-1,[0,3,false,[0,1],[1,2]]]]]}",
        "{\"batten\":11,\"objects\":[[0,1,\"0123456789abcdef\",[1,-1,[1,[1,2],0,1],[0,[1,2],0,1]]]]}",
        "{\"batten\":11,\"objects\":[[3,1,\"0123456789abcdef\",null],[1,1,\"0123456789abcdef\",null]]}"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char file[900];
        snprintf(file, sizeof file,
                 "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><metadata><batten:document "
                 "xmlns:batten='urn:batten:1' drawing='0123456789abcdef' "
                 "nodes='merged'>%s</batten:document></metadata>"
                 "<path d='M0 0L9 9L3 3'/></svg>",
                 bad[i]);
        bat_document *document = opened(file);
        assert_int_equal(bat_document_count(document), 1);
        if (!report.edited || report.native) fail_msg("%s", bad[i]);
        bat_document_free(document);
    }
    /* Any byte may be another one. */
    bat_document *document = redrawn(17);
    char *text = written(document, true);
    random_source r = {19};
    char *from = strstr(text, " drawing="), *to = strstr(text, "</batten:document>");
    for (int i = 0; i < 3000; i++) {
        char *at = from + random_int(&r, 0, (int)(to - from) - 1), was = *at;
        bat_document *back = NULL;
        *at = "0123456789,[]\"-x"[random_int(&r, 0, 15)];
        if (svg_read_kept(NULL, text, strlen(text), &back, &report) == BAT_OK) {
            assert_null(bat_document_check(back));
            assert_int_equal(bat_document_count(back), 5);
        }
        bat_document_free(back);
        *at = was;
    }
    bat_free(text);
    bat_document_free(document);
}

static void failing_allocations(void **state) {
    (void)state;
    bat_document *document = redrawn(23);
    char *text = written(document, true),
         *other = replaced(text, "<s:path id='a'", "<s:rect width='3' height='3'/><s:path id='a'");
    const long before = alloc_live();
    for (int way = 0; way < 2; way++) {
        const char *file = way ? other : text;
        for (int n = 1;; n++) {
            bat_document *back = NULL;
            alloc_fail_at(n);
            const bat_status status = svg_read_kept(NULL, file, strlen(file), &back, &report);
            const bool failed = alloc_fail_reached();
            bat_document_free(back);
            assert_int_equal(status, failed ? BAT_MEMORY : BAT_OK);
            if (!failed) break;
        }
        assert_true(report.native && !report.edited);
    }
    assert_int_equal(alloc_live(), before);
    bat_free(text);
    free(other);
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_edit_lists_its_object_alone),
        cmocka_unit_test(nodes_are_read_as_they_were),
        cmocka_unit_test(what_others_changed_is_read),
        cmocka_unit_test(others_may_add_move_and_delete),
        cmocka_unit_test(all_kinds_come_back),
        cmocka_unit_test(whole_documents_are_read),
        cmocka_unit_test(what_is_damaged_is_not_read),
        cmocka_unit_test(failing_allocations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
