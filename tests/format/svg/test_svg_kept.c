/* What people bring stays as it is: a file that is opened and saved is the same file, and an edit changes what was meant
 * and nothing else. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "format/svg/write/covered.h"
#include "format/svg/write/feed.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/svg_kept.h"
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/paint.h>

#include <math.h>
#include <stdlib.h>

static const char RICH[] =
    "<?xml version=\"1.0\"?>\r\n<!DOCTYPE svg [<!ENTITY blue \"#00f\">]>\n<!-- <path/> -->\n"
    "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" viewBox=\"0 0 "
    "200 100\">\n"
    "  <title>Mine &amp; yours</title>\n"
    "  <defs><linearGradient id=\"g\"><stop stop-color=\"red\"/><stop offset=\"1\"/></linearGradient>\n"
    "    <clipPath id=\"c\"><use xlink:href=\"#leaf\"/></clipPath></defs>\n"
    "  <rect id='sky' x=\"10\" y=\"10\" width=\"50\" height=\"30\" fill=\"url(#g)\" data-mine=\"a>b\" />\n"
    "  <g transform=\"translate(20 10) scale(2)\" class=\"big\">\n"
    "    <path id=\"leaf\" d=\"M0 0h10v10\" stroke=\"&blue;\" fill=\"none\"><title>t</title></path>\n"
    "    <text x=\"5\" y=\"5\">Hello <tspan>you</tspan></text>\n"
    "    <circle cx=\"20\" cy=\"20\" r=\"5\" style=\"fill : url(#g); stroke:#000; "
    "font-family:'a;b'\"></circle>\n"
    "  </g>\n"
    "  <use xlink:href=\"#leaf\" x=\"50\"/>\n"
    "  <path d=\"M100 50c10-10 30-10 40 0\" stroke=\"#123456\" fill=\"none\" clip-path=\"url(#c)\"/>\n"
    "</svg>\n<!-- the end -->\n";
static const char SHEET[] = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 90' width='9cm' "
                            "height='90mm'><style><![CDATA[path{stroke:#f00;"
                            "stroke-width:3;fill:none}]]></style><path d='M0 0L50 50'/><g opacity='.5'><path "
                            "d='M0 50L50 0'/><path d='M9 9L9 50'/>"
                            "</g><switch><g systemLanguage='fr'/><rect width='5' height='5'/></switch></svg>";
static const char PREFIXED[] =
    "<s:svg xmlns:s='http://www.w3.org/2000/svg' viewBox='0 0 90 90'><s:g id='one'><s:rect width='8' "
    "height='9'></s:rect>"
    "<s:line x2='20' y2='30' stroke='red'/></s:g><s:symbol id='m' viewBox='0 0 2 2'><s:path d='M0 0L1 1L2 "
    "0z'/><s:circle r='1'/>"
    "</s:symbol><s:use href='#m' width='20' height='20'/><s:use href='#m' x='40' width='20' height='20'/>"
    "<s:path d='M0 70H30' stroke='#000' display='none'/></s:svg>";

static const char *const FILES[] = {RICH, SHEET, PREFIXED};
enum { FILE_COUNT = sizeof FILES / sizeof *FILES };

static bat_status read_file(const char *text, size_t size, bat_document **out, bat_svg_report *report) {
    const bat_svg_options options = bat_svg_merging();
    return svg_read_kept(&options, text, size, out, report);
}

static bat_document *opened(const char *text) {
    bat_document *document = NULL;
    assert_int_equal(read_file(text, strlen(text), &document, NULL), BAT_OK);
    return document;
}

static char *written(const bat_document *document, bool native) {
    char *text = NULL;
    size_t size = 0;
    assert_int_equal(bat_svg_write(document, native, &text, &size), BAT_OK);
    assert_int_equal(strlen(text), size);
    return text;
}

static int find_drawn(const bat_document *document, int nth) {
    for (int i = 0; i < bat_document_count(document); i++)
        if (bat_object_is_made_of_curves(bat_document_at(document, i)) && nth-- == 0) return i;
    fail_msg("%s", "no such object");
    return -1;
}

static void put(bat_document *document, int index, bat_object *made) {
    assert_non_null(made);
    assert_int_equal(bat_document_replace(document, index, made), BAT_OK);
    bat_object_release(made);
}

static void map(bat_document *document, int index, const double rows[6]) {
    const bat_object *object = bat_document_at(document, index);
    const double dx = rows[2], dy = rows[5];
    bat_curve *curves[16];
    const int count = bat_object_curve_count(object);
    bat_object *made = NULL;
    if (bat_object_picture(object)) {
        double m[6];
        memcpy(m, bat_object_matrix(object), sizeof m);
        m[4] += dx, m[5] += dy;
        assert_int_equal(bat_object_with_matrix(object, m, &made), BAT_OK);
        put(document, index, made);
        return;
    }
    assert_in_range(count, 1, 16);
    for (int i = 0; i < count; i++)
        assert_int_equal(bat_curve_transform(bat_object_curve(object, i), rows, &curves[i]), BAT_OK);
    assert_int_equal(bat_object_with_curves(object, count, curves, &made), BAT_OK);
    put(document, index, made);
}

static void shift(bat_document *document, int index, double dx, double dy) {
    map(document, index, (const double[6]){1, 0, dx, 0, 1, dy});
}

static void shear(bat_document *document, int index, double dx, double dy) {
    map(document, index, (const double[6]){1, 0, dx, 1, 1, dy});
}

static void paint(bat_document *document, int index, uint32_t stroke, double width) {
    bat_style style = *bat_object_style(bat_document_at(document, index));
    bat_object *made = NULL;
    style.stroked = true;
    style.stroke = stroke;
    style.width = width;
    assert_int_equal(bat_object_with_style(bat_document_at(document, index), &style, &made), BAT_OK);
    put(document, index, made);
}

static void untouched_files_are_the_same(void **state) {
    (void)state;
    for (int i = 0; i < FILE_COUNT; i++) {
        bat_document *document = opened(FILES[i]);
        assert_true(bat_svg_is_kept(document));
        for (int native = 0; native < 2; native++) {
            char *text = written(document, native);
            assert_string_equal(text, FILES[i]);
            bat_free(text);
        }
        /* An edit taken back is no edit. */
        const int index = find_drawn(document, 0);
        bat_object *before = bat_object_retain(bat_document_at(document, index));
        shift(document, index, 3, 4);
        put(document, index, before);
        char *text = written(document, true);
        assert_string_equal(text, FILES[i]);
        bat_free(text);
        bat_document_free(document);
    }
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

static void expect_change(bat_document *document, const char *file, const char *old, const char *with) {
    char *text = written(document, false), *expected = replaced(file, old, with);
    assert_string_equal(text, expected);
    free(expected);
    bat_free(text);
    bat_document_free(document);
}

static void an_edit_changes_its_element_alone(void **state) {
    (void)state;
    bat_document *document = opened(RICH);
    paint(document, find_drawn(document, 2), 0xff0000ff,
          4); /* the circle, whose units are twice the page's */
    expect_change(document, RICH, "fill : url(#g); stroke:#000; font-family:'a;b'",
                  "fill : url(#g); stroke:#ff0000; font-family:'a;b';stroke-width:2");

    document = opened(RICH);
    bat_object *made = NULL;
    const int sky = find_drawn(document, 0);
    assert_int_equal(bat_object_with_name(bat_document_at(document, sky), "the \"sky\"", &made), BAT_OK);
    put(document, sky, made);
    expect_change(document, RICH, "data-mine=\"a>b\" />",
                  "data-mine=\"a>b\" data-name=\"the &quot;sky&quot;\" />");

    document = opened(RICH);
    assert_int_equal(bat_object_with_state(bat_document_at(document, sky), true, true, &made), BAT_OK);
    put(document, sky, made);
    expect_change(document, RICH, "data-mine=\"a>b\" />",
                  "data-mine=\"a>b\" display=\"none\" data-locked=\"true\" />");

    document = opened(RICH);
    assert_int_equal(bat_document_remove(document, sky), BAT_OK);
    expect_change(document, RICH,
                  "\n  <rect id='sky' x=\"10\" y=\"10\" width=\"50\" height=\"30\" fill=\"url(#g)\" "
                  "data-mine=\"a>b\" />",
                  "");

    document = opened(SHEET); /* only a style attribute is stronger than a sheet */
    paint(document, find_drawn(document, 0), 0x00ff00ff, 3);
    expect_change(document, SHEET, "<path d='M0 0L50 50'/>",
                  "<path d='M0 0L50 50' style=\"stroke:#00ff00\"/>");

    document = opened(SHEET);
    const double page[4] = {0, 0, 180, 90};
    assert_int_equal(bat_document_set_page(document, page), BAT_OK);
    expect_change(document, SHEET, "viewBox='0 0 90 90' width='9cm' height='90mm'",
                  "viewBox=\"0 0 180 90\" width=\"18cm\" height=\"90mm\"");
}

/* A rectangle that is a rectangle no longer is a path from then on, with all that it had besides. */
static void a_shape_becomes_a_path(void **state) {
    (void)state;
    bat_document *document = opened(PREFIXED);
    shear(document, find_drawn(document, 0), 1, 2);
    char *text = written(document, false);
    const char *at = strstr(text, "<s:path d=\"M1 2");
    assert_non_null(at);
    assert_non_null(strstr(at, "L9 10L9 19L1 11Z\"></s:path><s:line")); /* what was straight is written so */
    assert_null(strstr(text, "s:rect"));
    bat_free(text);
    bat_document_free(document);
}

/* What refers to a shape that was edited shows what it showed. */
static void copies_stay_as_they_were(void **state) {
    (void)state;
    bat_document *document = opened(RICH), *again;
    double before[4], after[4];
    bat_object_bounds(bat_document_at(document, find_drawn(document, 3)), before); /* drawn by `use` */
    shift(document, find_drawn(document, 1), 7, 0);                                /* the leaf itself */
    char *text = written(document, false);
    assert_non_null(
        strstr(text, "<defs><path id=\"leaf\" d=\"M0 0h10v10\""));         /* the clip path still has it */
    assert_non_null(strstr(text, "<use xlink:href=\"#leaf\" x=\"50\"/>")); /* and what is a copy stays one */
    again = opened(text);
    bat_object_bounds(bat_document_at(again, find_drawn(again, 3)), after);
    for (int i = 0; i < 4; i++) assert_true(fabs(before[i] - after[i]) < 1e-9);
    bat_free(text);
    bat_document_free(again);
    bat_document_free(document);

    document = opened(PREFIXED); /* one copy of a symbol is edited; the other stays a copy */
    shift(document, find_drawn(document, 2), 1, 1);
    text = written(document, false);
    assert_null(strstr(text, "<s:use href='#m' width"));
    assert_non_null(strstr(text, "<s:use href='#m' x='40' width='20' height='20'/>"));
    assert_non_null(strstr(text, "<s:symbol id='m' viewBox='0 0 2 2'><s:path d='M0 0L1 1L2 0z'/>"));
    bat_free(text);
    bat_document_free(document);
}

/* ---- random edits ---- */

static void duplicate(bat_document *document, int index) {
    bat_object *made = NULL;
    assert_int_equal(
        bat_object_with_id(bat_document_at(document, index), bat_document_new_id(document), &made), BAT_OK);
    assert_int_equal(bat_document_insert(document, index + 1, made), BAT_OK);
    bat_object_release(made);
}

static void to_front(bat_document *document, int index) {
    bat_object *made = NULL;
    assert_int_equal(bat_object_with_parent(bat_document_at(document, index), 0, &made), BAT_OK);
    assert_int_equal(bat_document_remove(document, index), BAT_OK);
    assert_int_equal(bat_document_insert(document, bat_document_count(document), made), BAT_OK);
    bat_object_release(made);
}

static void group_last(bat_document *document) {
    bat_object *group = NULL, *made = NULL;
    const bat_id id = bat_document_new_id(document);
    const int last = bat_document_count(document) - 1;
    assert_int_equal(bat_object_create_group(id, "new", false, &group), BAT_OK);
    assert_int_equal(bat_object_with_parent(bat_document_at(document, last), id, &made), BAT_OK);
    assert_int_equal(bat_document_replace(document, last, made), BAT_OK);
    assert_int_equal(bat_document_insert(document, last, group), BAT_OK);
    bat_object_release(group);
    bat_object_release(made);
}

static void flip(bat_document *document, int index) {
    const bat_object *object = bat_document_at(document, index);
    bat_object *made = NULL;
    assert_int_equal(bat_object_with_state(object, !bat_object_is_hidden(object), false, &made), BAT_OK);
    put(document, index, made);
}

/* A stroke gets a width that changes along it, or loses it. */
static void widen(bat_document *document, int index, double share, bool filled) {
    const bat_object *object = bat_document_at(document, index);
    const bat_width_stop stops[2] = {{0.1, 0.25}, {0.8, share}};
    if (!bat_object_is_made_of_curves(object)) return;
    bat_paint made = bat_object_paint(object) ? *bat_object_paint(object) : (bat_paint){0};
    bat_style style = *bat_object_style(object);
    made.width_count = made.width_count ? 0 : 2;
    made.widths = made.width_count ? stops : NULL;
    made.stroke_first = share > 1;
    style.stroked = true, style.filled = filled;
    bat_object *styled = NULL, *painted = NULL;
    assert_int_equal(bat_object_with_style(object, &style, &styled), BAT_OK);
    assert_int_equal(bat_object_with_paint(styled, &made, &painted), BAT_OK);
    bat_object_release(styled);
    put(document, index, painted);
}

static void widen_some(bat_document *document, random_source *r) {
    const int index = random_int(r, 0, bat_document_count(document) - 1);
    const double share = random_between(r, 0.5, 1.5);
    widen(document, index, share, random_int(r, 0, 1) == 1);
}

static void edit(bat_document *document, random_source *r) {
    int drawn = 0;
    for (int i = 0; i < bat_document_count(document); i++)
        drawn += bat_object_is_drawn(bat_document_at(document, i));
    if (drawn < 2) return;
    const int which = random_int(r, 0, 7);
    int nth = random_int(r, 0, drawn - 1), index = -1;
    for (int i = 0; index < 0; i++)
        if (bat_object_is_drawn(bat_document_at(document, i)) && nth-- == 0) index = i;
    const double dx = random_between(r, -5, 5);
    const double dy = random_between(r, -5, 5);
    const uint32_t colour = (uint32_t)random_int(r, 0, 0xffffff) << 8 | 0xff;
    if (which == 0) assert_int_equal(bat_document_remove(document, index), BAT_OK);
    if (which == 1 || which == 2) shift(document, index, dx, dy);
    if (which == 3) paint(document, index, colour, 1 + fabs(dx));
    if (which == 4) duplicate(document, index);
    if (which == 5) to_front(document, index);
    if (which == 6) flip(document, index);
    if (which == 7 && !bat_object_parent(bat_document_at(document, bat_document_count(document) - 1)) &&
        bat_object_is_drawn(bat_document_at(document, bat_document_count(document) - 1)))
        group_last(document);
}

static bool is_hidden(const bat_document *document, const bat_object *object) {
    for (int depth = 0; object && depth < 64; depth++) {
        if (bat_object_is_hidden(object)) return true;
        object = bat_document_at(document, bat_document_find(document, bat_object_parent(object)));
    }
    return false;
}

static const bat_object *next_painted(const bat_document *document, int *at) {
    for (const bat_object *object; (object = bat_document_at(document, (*at)++));)
        if (bat_object_is_drawn(object) &&
            (bat_object_style(object)->stroked || bat_object_style(object)->filled))
            return object;
    return NULL;
}

/* Its opacity with that of all that it is in. */
static double seen_through(const bat_document *document, int index) {
    return bat_object_style(bat_document_at(document, index))->opacity *
           bat_document_level(document, index).around;
}

static void expect_same_look(const bat_object *a, const bat_object *b) {
    double box[4], there[4];
    bat_object_bounds(a, box);
    bat_object_bounds(b, there);
    for (int j = 0; j < 4; j++) assert_true(fabs(box[j] - there[j]) < 2e-3);
    const bat_style *s = bat_object_style(a), *t = bat_object_style(b);
    assert_int_equal(s->stroked, t->stroked);
    assert_int_equal(s->filled, t->filled);
    if (s->stroked) assert_int_equal(s->stroke, t->stroke);
    if (s->filled) assert_int_equal(s->fill, t->fill);
    if (s->stroked) assert_true(fabs(s->width - t->width) < 1e-9 * s->width);
}

static void expect_same_picture(const bat_document *one, const bat_document *other) {
    int i = 0, k = 0;
    for (const bat_object *a; (a = next_painted(one, &i));) {
        bat_object *parts[2] = {bat_object_retain(a), NULL};
        bool group = false;
        if (bat_object_widths(a).count) {
            bat_object_release(parts[0]);
            assert_int_equal(bat_object_parts(a, parts, &group), BAT_OK);
        }
        for (int j = 0; j < 2; j++) {
            const bat_object *b = parts[j] ? next_painted(other, &k) : NULL;
            if (!parts[j]) continue;
            assert_non_null(b);
            const bool guessed = bat_object_is_foreign(a) && bat_object_is_foreign(b); /* its box is */
            if (!guessed) {
                expect_same_look(parts[j], b);
                assert_true(fabs(seen_through(one, i - 1) - seen_through(other, k - 1)) < 1e-9);
                assert_int_equal(is_hidden(one, a), is_hidden(other, b));
            }
            bat_object_release(parts[j]);
        }
    }
    assert_null(next_painted(other, &k));
}

/* A translucent group keeps its element and attribute whatever is edited in it; taken apart, its members have the opacity. */
static void groups_keep_their_opacity(void **state) {
    (void)state;
    const char *file =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 90'><g opacity='.5'><text>a</text>"
        "<path d='M0 0L9 9'/><path d='M9 0L0 9' opacity='.4'/></g></svg>";
    bat_document *document = opened(file);
    const int first = bat_document_count(document) - 2;
    assert_true(bat_object_is_group(bat_document_at(document, 0)));
    paint(document, first, 0xff0000ff, 3);
    char *text = written(document, false);
    assert_non_null(strstr(text, "<g opacity='.5'><text>"));
    assert_non_null(strstr(text, "<path d='M9 0L0 9' opacity='.4'/>"));
    bat_free(text);
    bat_style style = *bat_object_style(bat_document_at(document, 0));
    bat_object *made;
    style.opacity = 0.75;
    assert_int_equal(bat_object_with_style(bat_document_at(document, 0), &style, &made), BAT_OK);
    bat_document_replace(document, 0, made);
    bat_object_release(made);
    text = written(document, false);
    assert_non_null(strstr(text, "<g opacity=\"0.75\"><text>"));
    bat_free(text);
    for (int i = 1; i < bat_document_count(document); i++) {
        bat_object *free_one;
        style = *bat_object_style(bat_document_at(document, i));
        style.opacity *= 0.75;
        assert_int_equal(bat_object_with_parent(bat_document_at(document, i), 0, &free_one), BAT_OK);
        assert_int_equal(bat_object_with_style(free_one, &style, &made), BAT_OK);
        bat_document_replace(document, i, made);
        bat_object_release(made);
        bat_object_release(free_one);
    }
    bat_document_remove(document, 0);
    text = written(document, false);
    bat_document *seen = opened(text);
    expect_same_picture(document, seen);
    bat_document_free(seen);
    bat_free(text);
    bat_document_free(document);
}

static void fade(bat_document *document, int index, double share) {
    bat_style style = *bat_object_style(bat_document_at(document, index));
    bat_object *made;
    style.opacity *= share;
    assert_int_equal(bat_object_with_style(bat_document_at(document, index), &style, &made), BAT_OK);
    bat_document_replace(document, index, made);
    bat_object_release(made);
}

/* A text has an opacity of its own: what it gets besides is multiplied with it, as often as the file is saved, by SVG and by
 * the native format. */
static void texts_keep_their_opacity(void **state) {
    (void)state;
    static const struct {
        const char *before, *twice;
    } cases[] = {{"<text opacity='.5'>a</text>", "<text opacity=\"0.125\">a</text>"},
                 {"<style>text{opacity:.5}</style><text>a</text>", "<text style=\"opacity:0.125\">a</text>"},
                 {"<g opacity='.5'><text style='fill:red;opacity:.5'>a</text></g>",
                  "<text style=\"fill:red;opacity:0.125\">a</text></g>"},
                 {"<text>a</text>", "<text opacity=\"0.25\">a</text>"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (int saved = 0; saved < 4;
             saved++) { /* not at all, as SVG, as SVG with the native document, as that alone */
            char file[400];
            snprintf(file, sizeof file,
                     "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 90'>%s</svg>", cases[i].before);
            bat_document *document = opened(file);
            for (int step = 0; step < 2; step++) {
                assert_int_equal(bat_document_count(document), 1);
                fade(document, 0, 0.5);
                char *text = NULL;
                size_t size;
                if (saved == 0 || step == 1) continue;
                if (saved < 3)
                    text = written(document, saved == 2);
                else
                    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
                bat_document_free(document);
                document = NULL;
                if (saved < 3)
                    document = opened(text);
                else
                    assert_int_equal(bat_document_read(text, strlen(text), &document, NULL), BAT_OK);
                bat_free(text);
            }
            char *text = written(document, false);
            if (!strstr(text, cases[i].twice)) fail_msg("%s", text);
            bat_free(text);
            bat_document_free(document);
        }
}

static int count_of(const char *text, const char *what) {
    int count = 0;
    while ((text = strstr(text, what))) count++, text++;
    return count;
}

static void expect_kept(const char *file, const char *text) {
    static const char *const foreign[] = {"<!--",        "<linearGradient", "<style",    "<clipPath",
                                          "<title>Mine", "<!ENTITY",        "<s:symbol", "class=\"big\""};
    for (size_t i = 0; i < sizeof foreign / sizeof *foreign; i++)
        if (count_of(file, foreign[i]) > count_of(text, foreign[i])) fail_msg("%s: %s", foreign[i], text);
}

/* Any edits: what is written shows what the document holds, to any reader, and still has all that Batten does not know.
 * With its own data it is read back bit for bit, keeps its file again, and can be edited again. */
static void random_edits_are_written(void **state) {
    (void)state;
    random_source r = {77}, widths = {78};
    for (int round = 0; round < 400; round++) {
        const char *file = FILES[round % FILE_COUNT];
        bat_document *document = opened(file);
        for (int again = 0; again < 3; again++) {
            const int edits = random_int(&r, 1, 5);
            for (int i = 0; i < edits; i++) edit(document, &r);
            if (round % 2) widen_some(document, &widths);
            assert_null(bat_document_check(document));
            char *plain = written(document, false), *whole = written(document, true);
            bat_document *seen = opened(plain), *back = NULL;
            bat_svg_report report;
            expect_same_picture(document, seen);
            expect_kept(file, plain);
            assert_int_equal(read_file(whole, strlen(whole), &back, &report), BAT_OK);
            assert_true(bat_svg_is_kept(back));
            if (strcmp(whole, file) != 0) {
                assert_non_null(strstr(whole, " drawing=\"")); /* it holds what SVG cannot, and no more */
                assert_true(report.native);
                assert_true(bat_document_digest(back) == bat_document_digest(document));
                bat_document_free(document);
                document = back;
            } else
                bat_document_free(back);
            bat_document_free(seen);
            bat_free(plain);
            bat_free(whole);
        }
        bat_document_free(document);
    }
}

/* The native document keeps the file, too, and journals begin with one. */
static const char *begin_of(const bat_document *document) {
    static const char *const begins[] = {"{\"batten\":3", "{\"batten\":4", "{\"batten\":6", "{\"batten\":7",
                                         "{\"batten\":12"};
    int most = 0;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        const bat_paint *paint = bat_object_paint(object);
        const bool faded = bat_object_is_group(object) && bat_object_style(object)->opacity != 1;
        const int needs = bat_object_kind(object) == BAT_KIND_PRIMITIVE ? 4
                          : paint && paint->width_count                 ? 3
                          : faded || bat_object_is_foreign(object) || (paint && paint->stroke_first)
                              ? 2
                              : paint != NULL;
        most = needs > most ? needs : most;
    }
    return begins[most];
}

/* Strokes whose width changes give way to what they cover, in their place; what else is in the file stays, and nothing gathers. */
static void widened_strokes_are_written(void **state) {
    (void)state;
    for (int filled = 0; filled < 2; filled++) {
        bat_document *document = opened(RICH), *back = NULL;
        const int index = find_drawn(document, 1);
        char *before = written(document, false);
        widen(document, index, 0.75, filled);
        bat_style style = *bat_object_style(bat_document_at(document, index));
        bat_object *faded = NULL;
        style.opacity = 0.5;
        assert_int_equal(bat_object_with_style(bat_document_at(document, index), &style, &faded), BAT_OK);
        put(document, index, faded);
        char *first = written(document, true);
        expect_kept(before, first);
        assert_non_null(strstr(first, "Hello <tspan>you</tspan>"));
        for (int round = 0; round < 3; round++) {
            assert_int_equal(read_file(first, strlen(first), &back, NULL), BAT_OK);
            assert_true(bat_svg_is_kept(back));
            assert_true(bat_document_digest(back) == bat_document_digest(document));
            shift(back, find_drawn(back, 0), round % 2 ? -1 : 1, 0);
            char *again = written(back, true);
            if (round % 2) assert_int_equal(count_of(again, "<path"), count_of(first, "<path"));
            if (round % 2) assert_int_equal(count_of(again, "<g"), count_of(first, "<g"));
            bat_free(first);
            first = again;
            bat_document_free(document);
            document = back;
        }
        widen(document, find_drawn(document, 1), 0.75, false);
        char *flat = written(document, false);
        bat_document *seen = opened(flat);
        expect_same_picture(document, seen);
        expect_kept(before, flat);
        assert_true(count_of(flat, "<path") <= count_of(first, "<path"));
        bat_document_free(seen);
        bat_document_free(document);
        bat_free(first), bat_free(before), bat_free(flat);
    }
}

static void native_documents_keep_it(void **state) {
    (void)state;
    random_source r = {5};
    for (int round = 0; round < 30; round++) {
        bat_document *document = opened(FILES[round % FILE_COUNT]), *back = NULL;
        for (int i = 0; i < round % 4; i++) edit(document, &r);
        if (round % 5 == 4) widen_some(document, &r);
        char *text, *again;
        size_t size, other;
        assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
        assert_memory_equal(text, begin_of(document), 11);
        assert_int_equal(bat_document_read(text, size, &back, NULL), BAT_OK);
        char *one = written(document, true), *two = written(back, true);
        assert_string_equal(one, two);
        assert_int_equal(bat_document_write(back, &again, &other), BAT_OK);
        assert_string_equal(text, again);
        bat_free(one);
        bat_free(two);
        bat_free(text);
        bat_free(again);
        bat_document_free(document);
        bat_document_free(back);
    }
}

static void bad_native_documents_are_refused(void **state) {
    (void)state;
    static const struct {
        const char *source, *message;
    } cases[] = {
        {"5", "text: expected a text"},
        {"{\"text\":\"<svg/>\",\"page\":[0,0,0,0],\"digest\":\"0123456789abcdef\"}",
         "elements: expected a list"},
        {"{\"text\":\"<svg/>\",\"page\":[0,0],\"digest\":\"0123456789abcdef\",\"elements\":[]}",
         "page: expected"},
        {"{\"text\":\"<svg/>\",\"page\":[0,0,0,0],\"digest\":\"x\",\"elements\":[]}", "digest: expected 16"},
        {"{\"text\":\"<svg/"
         ">\",\"page\":[0,0,0,0],\"digest\":\"0123456789abcdef\",\"elements\":[{\"element\":2},{\"element\":"
         "1}]}",
         "element: expected numbers that do not fall"},
        {"{\"text\":\"<svg/"
         ">\",\"page\":[0,0,0,0],\"digest\":\"0123456789abcdef\",\"elements\":[{\"element\":2,\"id\":1}]}",
         "shape: expected 16"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[600];
        bat_document *document = NULL;
        bat_problem problem;
        snprintf(text, sizeof text, "{\"batten\":3,\"source\":%s,\"objects\":[]}", cases[i].source);
        assert_int_not_equal(bat_document_read(text, strlen(text), &document, &problem), BAT_OK);
        if (!strstr(problem.message, cases[i].message)) fail_msg("%s: %s", cases[i].source, problem.message);
    }
    /* Elements that are not there: the drawing is written anew. */
    static const char beyond[] = "{\"batten\":3,\"source\":{\"text\":\"<svg/"
                                 ">\",\"page\":[0,0,0,0],\"digest\":\"0123456789abcdef\",\"elements\":"
                                 "[{\"element\":9}]},\"objects\":[{\"id\":1,\"kind\":\"path\",\"curves\":[{"
                                 "\"degree\":1,\"knots\":[0,0,1,1],\"points\":"
                                 "[[0,0],[1,2]]}]}]}";
    bat_document *document = NULL;
    assert_int_equal(bat_document_read(beyond, strlen(beyond), &document, NULL), BAT_OK);
    char *text = written(document, false);
    assert_non_null(strstr(text, "M0 0L1 2"));
    bat_free(text);
    bat_document_free(document);
}

static void what_cannot_be_kept_is_not(void **state) {
    (void)state;
    static const char elements[] =
        "<!DOCTYPE svg [<!ENTITY e \"<path d='M0 0L1 1'/>\">]>"
        "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0L9 9' stroke='red'/></svg>";
    static const char latin[] = "<svg xmlns='http://www.w3.org/2000/svg'><title>\xe9</title></svg>";
    const bat_svg_options options = bat_svg_defaults();
    for (int i = 0; i < 2; i++) {
        bat_svg_reader *reader;
        bat_document *document = NULL;
        const char *text = i ? latin : elements;
        assert_int_equal(bat_svg_reader_create(&options, &reader), BAT_OK);
        assert_int_equal(bat_svg_reader_source(reader, text, strlen(text)), BAT_OK);
        const char *none[] = {NULL}, *path[] = {"d", "M0 0L9 9", "stroke", "red", NULL};
        bat_svg_reader_start(reader, "svg", none);
        for (int k = 0; k < 2; k++) { /* the parser saw an element more than the text has */
            bat_svg_reader_start(reader, "path", path);
            bat_svg_reader_end(reader);
        }
        bat_svg_reader_end(reader);
        assert_int_equal(bat_svg_reader_finish(reader, &document, NULL, NULL), BAT_OK);
        assert_false(bat_svg_is_kept(document));
        bat_document_free(document);
    }
    assert_false(bat_svg_is_kept(NULL));
    assert_int_equal(bat_svg_reader_source(NULL, "", 0), BAT_ARGUMENT);
}

/* A tolerance whatever a path's size asks for other path data in the same elements. */
static void a_tolerance_asks_for_other_data(void **state) {
    (void)state;
    static const char file[] =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><!-- kept -->"
        "<path id='a' d='M0 0C1 0 2 0 3 0C4 0 5 0 6 0' stroke='red' fill='none'/></svg>";
    bat_svg_options options = bat_svg_defaults();
    options.tolerance = 0.1;
    bat_svg_reader *reader;
    bat_document *document = NULL;
    assert_int_equal(bat_svg_reader_create(&options, &reader), BAT_OK);
    assert_int_equal(bat_svg_reader_source(reader, file, strlen(file)), BAT_OK);
    assert_int_equal(bat_svg_feed(file, strlen(file), reader), BAT_OK);
    assert_int_equal(bat_svg_reader_finish(reader, &document, NULL, NULL), BAT_OK);
    char *text = written(document, false);
    assert_non_null(strstr(text, "<!-- kept --><path id='a' d=\"M0 0"));
    assert_null(strstr(text, "3 0C4 0"));
    bat_free(text);
    bat_document_free(document);
}

static void running_out_of_memory(void **state) {
    (void)state;
    const long before = alloc_live();
    for (int native = 0; native < 2; native++) {
        for (int n = 1;; n++) {
            bat_document *document = NULL;
            alloc_fail_at(n);
            const bat_status status = read_file(RICH, strlen(RICH), &document, NULL);
            const bool failed = alloc_fail_reached();
            bat_document_free(document);
            if (!failed) break;
            assert_int_equal(status, BAT_MEMORY);
        }
        bat_document *document = opened(RICH);
        random_source r = {3};
        for (int i = 0; i < 6; i++) edit(document, &r);
        widen(document, find_drawn(document, 0), 0.75, true);
        for (int n = 1;; n++) {
            char *text = NULL;
            size_t size;
            alloc_fail_at(n);
            const bat_status status = bat_svg_write(document, native, &text, &size);
            const bool failed = alloc_fail_reached();
            if (status == BAT_OK) bat_free(text);
            if (!failed) break;
            assert_int_equal(status, BAT_MEMORY);
        }
        bat_document_free(document);
    }
    assert_int_equal(alloc_live(), before);
}

/* A gradient that still paints the same stays; one that would follow the box of its shape is given to it anew. */
static void gradients_stay_where_they_are(void **state) {
    (void)state;
    static const char file[] =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 90'>"
        "<linearGradient id='b'><stop stop-color='red'/><stop offset='1'/></linearGradient>"
        "<linearGradient id='u' gradientUnits='userSpaceOnUse' href='#b' x2='40'/>"
        "<g transform='translate(5,5)'><path fill='url(#b)' d='M0 0H20V10Z'/>"
        "<path fill='none' stroke='url(#u)' stroke-dasharray='3 1' d='M0 20H20V30'/></g></svg>";
    bat_document *document = opened(file), *back = NULL;
    shift(document, find_drawn(document, 0), 10, 10);
    shift(document, find_drawn(document, 1), 10, 10);
    char *text = written(document, false);
    assert_non_null(strstr(text, "stroke='url(#u)' stroke-dasharray='3 1'"));
    assert_null(strstr(text, "fill='url(#b)'"));
    assert_int_equal(strncmp(text, file, (size_t)(strstr(file, "<path") - file)), 0);
    assert_int_equal(read_file(text, strlen(text), &back, NULL), BAT_OK);
    for (int i = 0; i < 2; i++) {
        const bat_paint *was = bat_object_paint(bat_document_at(document, find_drawn(document, i)));
        const bat_paint *now = bat_object_paint(bat_document_at(back, find_drawn(back, i)));
        const bat_gradient *a = i ? &was->stroke : &was->fill, *b = i ? &now->stroke : &now->fill;
        assert_true(a->count == 2 && b->count == 2 && was->dash_count == now->dash_count);
        for (int k = 0; k < 2; k++) { /* both ends lie where they did */
            const double *p = k ? a->to : a->from, *q = k ? b->to : b->from, *m = a->matrix, *n = b->matrix;
            assert_true(fabs(m[0] * p[0] + m[2] * p[1] + m[4] - n[0] * q[0] - n[2] * q[1] - n[4]) <= 1e-9);
            assert_true(fabs(m[1] * p[0] + m[3] * p[1] + m[5] - n[1] * q[0] - n[3] * q[1] - n[5]) <= 1e-9);
        }
    }
    bat_document_free(back);
    bat_free(text);
    paint(document, find_drawn(document, 1), 0x123456ff, 2);
    text = written(document, false);
    assert_non_null(strstr(text, "stroke=\"#123456\""));
    bat_document_free(document);
    bat_free(text);
}

/* A gradient of ours goes when its shape has another, however often the file is saved and opened; what is not ours, or is
 * referred to, stays. */
static void gradients_do_not_gather(void **state) {
    (void)state;
    static const char file[] =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 90 90'>"
        "<linearGradient id='b'><stop stop-color='red'/><stop offset='1'/></linearGradient>"
        "<radialGradient id=\"batten-paint-own\"><stop stop-color='blue'/><stop offset='1'/></radialGradient>"
        "<path fill='url(#b)' d='M0 0H20V10Z'/><path fill='url(#b)' stroke='url(#b)' d='M0 40H20V50Z'/>"
        "<path fill='url(#batten-paint-own)' d='M40 40H60V50Z'/></svg>";
    bat_document *document = opened(file);
    for (int round = 0; round < 6; round++) {
        bat_document *back = NULL;
        shift(document, find_drawn(document, round % 2), 3, 2);
        char *text = written(document, round % 3 == 0);
        /* of the first shape one gradient, of the second two when it has been moved, and the file's own */
        assert_int_equal(count_of(text, "Gradient id=\"batten-paint-"), round == 0 ? 2 : 4);
        assert_int_equal(count_of(text, "url(#batten-paint-"), round == 0 ? 2 : 4);
        assert_int_equal(count_of(text, "id='b'"), 1);
        assert_int_equal(read_file(text, strlen(text), &back, NULL), BAT_OK);
        expect_same_picture(document, back);
        bat_document_free(document);
        bat_free(text);
        document = back;
    }
    for (int i = 0; i < 2; i++) bat_document_remove(document, find_drawn(document, 0));
    char *text = written(document, false);
    assert_int_equal(count_of(text, "Gradient id=\"batten-paint-"), 1);
    bat_free(text);
    bat_document_free(document);
}

/* A stroke that does not scale is as wide as it says at the size of the file, whatever is around it, before and after an
 * edit. */
static void strokes_that_do_not_scale_keep_their_width(void **state) {
    (void)state;
    static const char file[] =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100' width='200' height='300'>"
        "<g transform='scale(4 5)'><path id='a' d='M1 1L9 2' fill='none' stroke='red' stroke-width='6' "
        "stroke-dasharray='4 2' vector-effect='non-scaling-stroke'/>"
        "<path d='M1 1L9 2' stroke='red' stroke-width='6'/></g></svg>";
    bat_document *document = opened(file);
    const bat_object *object = bat_document_at(document, find_drawn(document, 0));
    bat_object *made = NULL;
    bat_style style = *bat_object_style(object);
    assert_true(style.width == 3); /* two pixels are a unit */
    assert_true(bat_object_paint(object) && bat_object_paint(object)->dashes[1] == 1);
    char *text = written(document, false);
    assert_string_equal(text, file);
    bat_free(text);
    style.width = 5;
    assert_int_equal(bat_object_with_style(object, &style, &made), BAT_OK);
    put(document, find_drawn(document, 0), made);
    text = written(document, false);
    assert_non_null(strstr(text, "stroke-width=\"10\""));
    assert_non_null(strstr(text, "vector-effect='non-scaling-stroke'"));
    bat_document *again = opened(text);
    assert_true(bat_object_style(bat_document_at(again, find_drawn(again, 0)))->width == 5);
    assert_true(fabs(bat_object_style(bat_document_at(again, find_drawn(again, 1)))->width - 6 * sqrt(20)) <
                1e-12);
    bat_document_free(again);
    bat_free(text);
    bat_document_free(document);
}

/* Scaled with its page, a drawing keeps its look: so strokes that do not scale say fewer pixels, and nothing else does. */
static void strokes_that_do_not_scale_are_scaled_with_the_page(void **state) {
    (void)state;
    static const char *const sizes[] = {"width='200' height='200'", "width='100mm'", "", "width='100%'"};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        char file[500];
        snprintf(
            file, sizeof file,
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100' %s><style>.a { stroke-width: 6 }"
            "</style><path class='a' d='M1 1L9 2' stroke='red' stroke-dasharray='4 2' "
            "vector-effect='non-scaling-stroke'/><path d='M1 1L9 2' stroke='red' stroke-width='6'/></svg>",
            sizes[i]);
        bat_document *document = opened(file);
        const bat_object *object = bat_document_at(document, find_drawn(document, 0));
        const double width = bat_object_style(object)->width, dash = bat_object_paint(object)->dashes[0];
        assert_int_equal(
            bat_document_set_scale(document, bat_document_scale(document) / 4, bat_document_unit(document)),
            BAT_OK);
        char *text = written(document, false);
        if (!strstr(text, "stroke-width:1.5")) fail_msg("%s", text);
        assert_non_null(strstr(text, "stroke-dasharray"));
        assert_non_null(strstr(text, "<path d='M1 1L9 2' stroke='red' stroke-width='6'/></svg>"));
        bat_document *again = opened(text);
        object = bat_document_at(again, find_drawn(again, 0));
        assert_true(fabs(bat_object_style(object)->width - width) < 1e-9 * width);
        assert_true(fabs(bat_object_paint(object)->dashes[0] - dash) < 1e-9 * dash);
        assert_true(bat_object_style(bat_document_at(again, find_drawn(again, 1)))->width == 6);
        bat_document_free(again);
        bat_free(text);
        bat_document_free(document);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strokes_that_do_not_scale_are_scaled_with_the_page),
        cmocka_unit_test(groups_keep_their_opacity),
        cmocka_unit_test(texts_keep_their_opacity),
        cmocka_unit_test(untouched_files_are_the_same),
        cmocka_unit_test(an_edit_changes_its_element_alone),
        cmocka_unit_test(a_shape_becomes_a_path),
        cmocka_unit_test(copies_stay_as_they_were),
        cmocka_unit_test(random_edits_are_written),
        cmocka_unit_test(widened_strokes_are_written),
        cmocka_unit_test(native_documents_keep_it),
        cmocka_unit_test(bad_native_documents_are_refused),
        cmocka_unit_test(what_cannot_be_kept_is_not),
        cmocka_unit_test(a_tolerance_asks_for_other_data),
        cmocka_unit_test(gradients_stay_where_they_are),
        cmocka_unit_test(gradients_do_not_gather),
        cmocka_unit_test(strokes_that_do_not_scale_keep_their_width),
        cmocka_unit_test(running_out_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
