/* Styles of SVG according to CSS: inheritance, the cascade, what a style sheet may contain, invalid values; and the
 * basic shapes at the limits of SVG. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "support/xml.h"
#include <batten/document.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define PATH "d='M0 0L10 0L10 10'"

static bat_document *read_svg(const char *inner) {
    char text[2000];
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem = {"", ""};
    const int size = snprintf(text, sizeof text, "<svg xmlns='http://www.w3.org/2000/svg'>%s</svg>", inner);
    assert_true(size > 0 && (size_t)size < sizeof text);
    if (xml_read(text, NULL, &document, &report, &problem) != BAT_OK)
        fail_msg("%s: %s: %s", inner, problem.place, problem.message);
    assert_null(bat_document_check(document));
    return document;
}

/* Of the only path, or of the last one: its digest, without names and groups. */
typedef struct look {
    bat_style style;
    bool there, hidden;
    double box[4];
} look;

static look look_at(const char *inner) {
    bat_document *document = read_svg(inner);
    look seen;
    memset(&seen, 0, sizeof seen);
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        if (bat_object_is_group(object)) continue;
        seen.there = true;
        seen.hidden = bat_object_is_hidden(object);
        seen.style = *bat_object_style(object);
        bat_object_bounds(object, seen.box);
    }
    bat_document_free(document);
    return seen;
}

static bool alike(const look *a, const look *b) {
    const bat_style *s = &a->style, *t = &b->style;
    return a->there == b->there && a->hidden == b->hidden && s->stroked == t->stroked &&
           s->filled == t->filled && s->even_odd == t->even_odd && (!s->stroked || s->stroke == t->stroke) &&
           (!s->filled || s->fill == t->fill) && s->width == t->width && s->opacity == t->opacity &&
           s->cap == t->cap && s->join == t->join && s->miter_limit == t->miter_limit;
}

static void must_look_alike(const char *a, const char *b, bool alike_they_are) {
    const look x = look_at(a), y = look_at(b);
    if (alike(&x, &y) != alike_they_are) fail_msg("%s\n%s\n%s", a, alike_they_are ? "is not" : "is", b);
}

/* What a group says holds for its path, unless a rule says otherwise, unless the path says "inherit". */
static void properties_are_inherited(void **state) {
    (void)state;
    static const struct {
        const char *name, *value, *other;
    } rows[] = {{"fill", "red", "lime"},
                {"stroke", "#0000ff", "none"},
                {"fill-opacity", "0.25", "75%"},
                {"stroke-opacity", "0.25", "0.5"},
                {"stroke-width", "3", "5"},
                {"stroke-miterlimit", "7", "2"},
                {"stroke-linecap", "square", "round"},
                {"stroke-linejoin", "bevel", "round"},
                {"fill-rule", "evenodd", "nonzero"},
                {"visibility", "hidden", "visible"},
                {"color", "blue", "lime"}};
    static const char always[] = "fill:currentColor;stroke:currentColor;";
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const char *name = rows[i].name, *value = rows[i].value, *other = rows[i].other;
        char own[300], group[300], ruled[400], again[400];
        snprintf(own, sizeof own, "<path style='%s%s:%s' " PATH "/>", always, name, value);
        snprintf(group, sizeof group, "<g style='%s%s:%s'><path " PATH "/></g>", always, name, value);
        snprintf(ruled, sizeof ruled, "<style>path{%s:%s}</style>%s", name, other, group);
        snprintf(again, sizeof again,
                 "<style>path{%s:%s}</style><g style='%s%s:%s'><path style='%s: inherit' " PATH "/></g>",
                 name, other, always, name, value, name);
        must_look_alike(own, group, true);
        must_look_alike(own, ruled, false);
        must_look_alike(own, again, true);
    }
}

/* Opacity and display are not inherited; "inherit" takes them all the same. */
static void others_are_not(void **state) {
    (void)state;
    must_look_alike("<path style='opacity:0.5' " PATH "/>", "<path opacity='50%' " PATH "/>", true);
    must_look_alike("<g display='none'><path display='inherit' " PATH "/></g>",
                    "<path display='none' " PATH "/>", true);
    const look twice = look_at("<g opacity='0.5'><path opacity='inherit' " PATH "/></g>");
    assert_true(fabs(twice.style.opacity - 0.25) < 1e-12);
    static const char gradient[] = "<linearGradient id='a'%s><stop offset='0' %s/></linearGradient>"
                                   "<path fill='url(#a)' " PATH "/>";
    char by_parent[300], by_itself[300];
    snprintf(by_parent, sizeof by_parent, gradient, " stop-color='red' stop-opacity='0.5'",
             "stop-color='inherit' stop-opacity='inherit'");
    snprintf(by_itself, sizeof by_itself, gradient, "", "stop-color='red' stop-opacity='0.5'");
    must_look_alike(by_parent, by_itself, true);
}

/* The heavier selector wins, then the later; style over rules; important over all. */
static void rules_cascade(void **state) {
    (void)state;
    static const struct {
        const char *sheet, *attributes;
        uint32_t fill; /* 0: black, as if there were no rule */
    } rows[] = {
        {"path{fill:red} *{fill:lime}", "", 0xff0000ffu},
        {"*{fill:lime}", "", 0x00ff00ffu},
        {"#i{fill:red} .c{fill:lime} path{fill:blue}", "id='i' class='c'", 0xff0000ffu},
        {".c{fill:red} path{fill:blue}", "class='b c'", 0xff0000ffu},
        {"path.c{fill:red} .c{fill:blue}", "class='c'", 0xff0000ffu},
        {"path.c#i{fill:red} .c.d{fill:blue}", "id='i' class='c d'", 0xff0000ffu},
        {".c{fill:blue} .c{fill:red}", "class='c'", 0xff0000ffu},
        {".c , #other,path{fill:red}", "", 0xff0000ffu},
        {"path{fill:blue}", "style='fill:red'", 0xff0000ffu},
        {"path{fill:red}", "fill='blue'", 0xff0000ffu},
        {"path{fill:red !important} #i{fill:blue}", "id='i' style='fill:lime'", 0xff0000ffu},
        {"path{fill:red}", "style='fill:lime;fill:blue!important'", 0x0000ffffu},
        {"/* path{fill:lime} */path{fill:red}", "", 0xff0000ffu},
        {"path{fill:/* no */red}/* open", "", 0xff0000ffu},
        {"path{fill:red}/* lone *", "", 0xff0000ffu},
        {"a / b{} path{fill:red}", "", 0xff0000ffu},
        {"&lt;!-- path{fill:red} --&gt;", "", 0xff0000ffu},
        {"\t\r\f\npath\t{\tfill\r:\fred\n}", "", 0xff0000ffu},
        {"@import url(x.css); path{fill:red}", "", 0xff0000ffu},
        {"@media print{path{fill:blue} rect{fill:lime}} path{fill:red}", "", 0xff0000ffu},
        {"path{fill:red} @media print{path{fill:blue}", "", 0xff0000ffu},
        {"path{fill:red} @charset", "", 0xff0000ffu},
        {"} ; path{fill:red}", "", 0xff0000ffu},
        {"path{fill:red", "", 0xff0000ffu},
        {"path{fill:red} path", "", 0xff0000ffu},
        {"{fill:lime} ,{fill:lime} path{fill:red}", "", 0xff0000ffu},
        {".{fill:lime} path.{fill:lime} #{fill:lime} path{fill:red}", "", 0xff0000ffu},
        {"path:hover{fill:lime} path~path{fill:lime} g path{fill:lime} path{fill:red}", "", 0xff0000ffu},
        {"PATH{fill:lime} _x-9\xc3\xa9{fill:lime} path{fill:red}", "", 0xff0000ffu},
        {"", "", 0},
        {"path", "", 0},
        {"#i{fill:red}", "id='j'", 0},
        {"rect{fill:red}", "", 0},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char inner[500];
        snprintf(inner, sizeof inner, "<style>%s</style><path %s " PATH "/>", rows[i].sheet,
                 rows[i].attributes);
        const look seen = look_at(inner);
        const uint32_t wanted = rows[i].fill ? rows[i].fill : 0x000000ffu;
        if (!seen.there || !seen.style.filled || seen.style.fill != wanted)
            fail_msg("%s: %08x, not %08x", inner, (unsigned)seen.style.fill, (unsigned)wanted);
    }
}

/* More rules than a first block holds, and a selector of more classes than anybody writes. */
static void long_sheets(void **state) {
    (void)state;
    char inner[2000];
    size_t used = (size_t)snprintf(inner, sizeof inner, "<style>");
    for (int i = 0; i < 100; i++)
        used += (size_t)snprintf(inner + used, sizeof inner - used, ".c%d{fill:#0000%02x}", i, i);
    snprintf(inner + used, sizeof inner - used, "</style><path class='c77' " PATH "/>");
    assert_int_equal((int)look_at(inner).style.fill, 77 << 8 | 255);
    used = (size_t)snprintf(inner, sizeof inner, "<style>path");
    for (int i = 0; i < 101; i++) used += (size_t)snprintf(inner + used, sizeof inner - used, ".c");
    snprintf(inner + used, sizeof inner - used, "{fill:red}</style><path class='c' " PATH "/>");
    assert_int_equal((int)look_at(inner).style.fill, 255);
}

/* What is no value leaves what was there. */
static void no_values(void **state) {
    (void)state;
    static const char *const rows[] = {"fill:url(#x",
                                       "fill:reddish",
                                       "fill-opacity:x",
                                       "fill-opacity:0.5em",
                                       "fill-opacity:1e999",
                                       "stroke-width:x",
                                       "stroke-width:-3",
                                       "stroke-miterlimit:0.5",
                                       "stroke-linecap:thin",
                                       "stroke-linejoin:glue",
                                       "fill-rule:some",
                                       "fill:",
                                       ":red",
                                       "fill",
                                       ";;;",
                                       "-webkit-x:1",
                                       "fill:'a;b",
                                       "fill:rgb(1,2;3)",
                                       "opacity:",
                                       "color:nothing",
                                       "stroke-width",
                                       "  ",
                                       "fill  :  !important"};
    static const char plain[] = "<path style='stroke:blue;stroke-width:4' " PATH "/>";
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char inner[300];
        snprintf(inner, sizeof inner, "<path style=\"stroke:blue;stroke-width:4;%s\" " PATH "/>", rows[i]);
        must_look_alike(inner, plain, true);
    }
    must_look_alike("<path style='\tfill :\tlime ; ' " PATH "/>", "<path fill='lime' " PATH "/>", true);
    must_look_alike("<path color='lime' fill='currentcolor' " PATH "/>", "<path fill='lime' " PATH "/>",
                    true);
    must_look_alike("<path fill='url(#none)' stroke='red' " PATH "/>",
                    "<path fill='none' stroke='red' " PATH "/>", true);
    must_look_alike("<path fill='url(#none) lime' " PATH "/>", "<path fill='lime' " PATH "/>", true);
    must_look_alike("<path d='M5 7h0M1 1h0' stroke='red' stroke-width='20' stroke-linecap='square'/>",
                    "<path d='M4.9 7H5.1M.9 1H1.1' stroke='red' stroke-width='20' stroke-linecap='square'/>",
                    true);
    must_look_alike("<path fill-opacity='150%' " PATH "/>", "<path " PATH "/>", true);
}

/* Rectangles with corners, ellipses, lines: boxes as SVG 2, 10 has them; sides of nothing draw nothing. */
static void shapes(void **state) {
    (void)state;
    static const struct {
        const char *element;
        double box[4]; /* all 0: nothing is drawn */
    } rows[] = {
        {"<rect x='1' y='2' width='30' height='20'/>", {1, 2, 31, 22}},
        {"<rect width='30' height='20' rx='5'/>", {0, 0, 30, 20}},
        {"<rect width='30' height='20' ry='5'/>", {0, 0, 30, 20}},
        {"<rect width='30' height='20' rx='99' ry='99'/>", {0, 0, 30, 20}},
        {"<rect width='30' height='20' rx='15' ry='2'/>", {0, 0, 30, 20}},
        {"<rect width='30' height='20' rx='2' ry='10'/>", {0, 0, 30, 20}},
        {"<rect width='30' height='20' rx='auto' ry='auto'/>", {0, 0, 30, 20}},
        {"<rect width='30' height='20' rx='0' ry='4'/>", {0, 0, 30, 20}},
        {"<rect width='30' height='20' rx='4' ry='0'/>", {0, 0, 30, 20}},
        {"<rect width='0' height='20'/>", {0}},
        {"<rect width='30' height='0'/>", {0}},
        {"<rect height='20'/>", {0}},
        {"<circle cx='5' cy='6' r='4'/>", {1, 2, 9, 10}},
        {"<circle cx='5' cy='6'/>", {0}},
        {"<ellipse cx='5' cy='6' rx='4' ry='2'/>", {1, 4, 9, 8}},
        {"<ellipse cx='5' cy='6' rx='4'/>", {1, 2, 9, 10}},
        {"<ellipse cx='5' cy='6' rx='0' ry='2'/>", {0}},
        {"<ellipse cx='5' cy='6' rx='4' ry='0'/>", {0}},
        {"<line x1='1' y1='2' x2='9' y2='4'/>", {1, 2, 9, 4}},
        {"<polyline points=' 1,2 9 4\t5,8 '/>", {1, 2, 9, 8}},
        {"<polygon points='1,2 9 4 5,8'/>", {1, 2, 9, 8}},
        {"<polygon/>", {0}},
        {"<path/>", {0}},
        {"<path d='none'/>", {0}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const look seen = look_at(rows[i].element);
        const bool drawn = rows[i].box[2] > rows[i].box[0];
        if (seen.there != drawn) fail_msg("%s: %s", rows[i].element, drawn ? "is not drawn" : "is drawn");
        for (int k = 0; k < 4 && drawn; k++)
            if (fabs(seen.box[k] - rows[i].box[k]) > 0.006) /* a quarter of a circle by a cubic: 0.03 % */
                fail_msg("%s: side %d at %g, not %g", rows[i].element, k, seen.box[k], rows[i].box[k]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(properties_are_inherited),
                                       cmocka_unit_test(others_are_not),
                                       cmocka_unit_test(rules_cascade),
                                       cmocka_unit_test(long_sheets),
                                       cmocka_unit_test(no_values),
                                       cmocka_unit_test(shapes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
