/* SVG in and out: what is drawn, in which style, what is left out and counted; the native document embedded in it;
 * every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/nesting.h"
#include "support/alloc_fail.h"
#include <batten/bezier.h>
#include "support/random_curve.h"
#include "support/xml.h"

static bat_svg_report report;

static bat_document *read_svg(const char *text) {
    bat_document *document = NULL;
    bat_problem problem = {"", ""};
    if (xml_read(text, NULL, &document, &report, &problem) != BAT_OK)
        fail_msg("%s: %s", problem.place, problem.message);
    assert_null(bat_document_check(document));
    return document;
}

/* Of the visible paths, the index-th, or how many there are: groups and what is not displayed left aside. */
static const bat_object *shown(const bat_document *document, int index, int *count) {
    const bat_object *found = NULL;
    bat_nesting nesting = {0};
    int seen = 0;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level;
        assert_true(bat_nesting_next(&nesting, object, &level));
        if (bat_object_is_group(object) || level.hidden) continue;
        if (seen++ == index) found = object;
    }
    if (count) *count = seen;
    return found;
}

static int count_shown(const bat_document *document) {
    int count;
    shown(document, -1, &count);
    return count;
}

static void expect_box(const bat_document *document, int index, double x0, double y0, double x1, double y1) {
    double box[4], expected[4] = {x0, y0, x1, y1};
    assert_non_null(shown(document, index, NULL));
    bat_object_bounds(shown(document, index, NULL), box);
    for (int i = 0; i < 4; i++)
        if (fabs(box[i] - expected[i]) > 1e-5) fail_msg("box %g %g %g %g", box[0], box[1], box[2], box[3]);
}

static const bat_style *style_of(const bat_document *document, int index) {
    assert_non_null(shown(document, index, NULL));
    return bat_object_style(shown(document, index, NULL));
}

static void paths_become_curves(void **state) {
    (void)state;
    bat_document *d = read_svg(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='1 2 30 40'>"
        "<path id='o' d='M0 0C0 5 10 5 10 0ZM20 20L30 20L30 30' stroke='red' fill='none'/>"
        "<svg:rect xmlns:svg='http://www.w3.org/2000/svg' width='3' height='4'/></svg>");
    double page[4], expected[4] = {1, 2, 30, 40};
    bat_document_page(d, page);
    assert_memory_equal(page, expected, sizeof page);
    assert_int_equal(bat_document_count(d), 2);
    const bat_object *o = bat_document_at(d, 0);
    assert_string_equal(bat_object_name(o), "o");
    assert_int_equal(bat_object_curve_count(o), 2);
    assert_true(bat_curve_is_closed(bat_object_curve(o, 0)));
    assert_false(bat_curve_is_closed(bat_object_curve(o, 1)));
    assert_int_equal(report.paths, 2);
    assert_int_equal(report.curves, 3);
    /* The curve runs through the Bézier's middle: (5, 3.75). */
    const bat_curve *curve = bat_object_curve(o, 0);
    double domain[2], p[2], nearest = 1;
    bat_curve_domain(curve, domain);
    for (int i = 0; i <= 2000; i++) {
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / 2000, 0, p);
        nearest = fmin(nearest, hypot(p[0] - 5, p[1] - 3.75));
    }
    assert_true(nearest < 0.01);
    expect_box(d, 1, 0, 0, 3, 4);
    bat_document_free(d);
}

static void pages_and_units(void **state) {
    (void)state;
    static const struct {
        const char *root;
        double page[4];
    } cases[] = {{"<svg width='2in' height='100'/>", {0, 0, 192, 100}},
                 {"<svg width='2in' height='96' viewBox='0 0 20 10'/>", {0, 0, 20, 10}},
                 {"<svg width='100%' height='100%'/>", {0, 0, 0, 0}},
                 {"<svg viewBox='0 0 0 10'/>", {0, 0, 0, 0}},
                 {"<svg/>", {0, 0, 0, 0}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_document *d = read_svg(cases[i].root);
        double page[4];
        bat_document_page(d, page);
        assert_memory_equal(page, cases[i].page, sizeof page);
        bat_document_free(d);
    }
}

static void styles_cascade(void **state) {
    (void)state;
    bat_document *d = read_svg(
        "<svg viewBox='0 0 300 400' color='lime'><style>/* c */ path { stroke-width: 7 } .a, .b { stroke: "
        "#00f; }\n"
        "#x { stroke: teal } g ~ path { stroke: red } @media print { path { stroke: red } } .c { fill: gold "
        "!important }"
        "path.a { stroke-linecap: round }</style>"
        "<g fill='none' stroke='green' stroke-width='3' opacity='.5' stroke-opacity='50%'>"
        "<path d='M0 0H9'/>"                                                 /* 0: type rule */
        "<path class='z a' d='M0 0H9' stroke='red'/>"                        /* 1: class over attribute */
        "<path id='x' class='a' d='M0 0H9'/>"                                /* 2: id over class */
        "<path class='a' style='stroke:black;stroke-width:2px' d='M0 0H9'/>" /* 3: style over all */
        "<line x2='9' class='c' style='fill:red;stroke:inherit' opacity='.5'/>" /* 4: important over style; inherit */
        "<line x2='9' stroke='currentColor' fill='url(#g) #123' stroke-linejoin='bevel' "
        "stroke-miterlimit='9'/>"                                                                    /* 5 */
        "<line x2='9' stroke='none' fill='rgba(1,2,3,0.2)' fill-opacity='0.5' fill-rule='evenodd'/>" /* 6 */
        "<line x2='9' stroke-width='10%' transform='scale(2,8)'/>" /* 7: sqrt(2 * 8) * 10% of the diagonal */
        "</g></svg>");
    assert_int_equal(bat_document_count(d), 9); /* the group */
    assert_int_equal(count_shown(d), 8);
    assert_true(style_of(d, 0)->width == 7 && style_of(d, 0)->stroke == 0x00800080 &&
                !style_of(d, 0)->filled);
    assert_true(bat_object_style(bat_document_at(d, 0))->opacity == 0.5); /* of the group, as one picture */
    assert_true(style_of(d, 0)->opacity == 1 && style_of(d, 0)->cap == BAT_CAP_BUTT);
    assert_true(style_of(d, 1)->stroke == 0x0000ff80 && style_of(d, 1)->cap == BAT_CAP_ROUND);
    assert_true(style_of(d, 2)->stroke == 0x00808080);
    assert_true(style_of(d, 3)->stroke == 0x00000080 && style_of(d, 3)->width == 2);
    assert_true(style_of(d, 4)->fill == 0xffd700ff && style_of(d, 4)->stroke == 0x00800080);
    assert_true(style_of(d, 4)->opacity == 0.5 && style_of(d, 4)->width == 3);
    assert_true(style_of(d, 5)->stroke == 0x00ff0080 && style_of(d, 5)->fill == 0x112233ff);
    assert_true(style_of(d, 5)->join == BAT_JOIN_BEVEL && style_of(d, 5)->miter_limit == 9);
    assert_true(!style_of(d, 6)->stroked && style_of(d, 6)->fill == 0x0102031a && style_of(d, 6)->even_odd);
    assert_true(fabs(style_of(d, 7)->width - 4 * 0.1 * sqrt((300.0 * 300 + 400 * 400) / 2)) < 1e-9);
    assert_int_equal(report.lost.count[BAT_LOSS_UNKNOWN], 1); /* there is no g */
    bat_document_free(d);
}

static void use_and_viewports(void **state) {
    (void)state;
    bat_document *d = read_svg(
        "<svg viewBox='0 0 100 100' xmlns:xlink='http://www.w3.org/1999/xlink'>"
        "<use href='#later' x='10' y='20'/>"                        /* 0: forward */
        "<use xlink:href='#s' x='1' y='2' width='20' height='40'/>" /* 1: symbol, meet, centred */
        "<svg x='50' y='50' width='10' height='10' viewBox='0 0 5 5'><rect width='1' "
        "height='1'/></svg>" /* 2 */
        "<defs><rect id='later' width='3' height='4' transform='translate(1)'/>"
        "<symbol id='s' viewBox='0 0 10 10'><rect width='10' height='10'/></symbol></defs>"
        "<g id='g'><use href='#g'/></g><use id='u' href='#v'/><use id='v' href='#u'/><use "
        "href='#nothing'/>"
        "<rect id='later' width='90' height='90' transform='scale(.5)translate(2 "
        "2)rotate(90)'/></svg>");
    expect_box(d, 0, 11, 20, 14, 24);
    expect_box(d, 1, 1, 12, 21, 32);
    expect_box(d, 2, 50, 50, 52, 52);
    expect_box(d, 3, -44, 1, 1, 46); /* the second with this id is drawn where it stands */
    assert_int_equal(bat_document_count(d), 4);
    assert_int_equal(report.lost.count[BAT_LOSS_COPY], 6);
    assert_int_equal(report.lost.count[BAT_LOSS_UNKNOWN],
                     4); /* itself, each other from both sides, nothing */
    bat_document_free(d);
}

/* One tag of the list decides, whole or up to a hyphen, in either case of letters. */
static void a_switch_draws_what_is_for_english(void **state) {
    (void)state;
    static const struct {
        const char *tags;
        bool drawn;
    } rows[] = {{"en", true},     {"de, en-GB", true}, {"EN-us", true}, {" fr,\ten ", true},
                {"enm", false},   {"e", false},        {"", false},     {"de,fr", false},
                {"de-en", false}, {",,", false},       {"eng,en", true}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[300];
        snprintf(text, sizeof text,
                 "<svg viewBox='0 0 100 100'><switch><rect systemLanguage='%s' width='3' height='4'/>"
                 "<rect width='50' height='60'/></switch></svg>",
                 rows[i].tags);
        bat_document *d = read_svg(text);
        assert_int_equal(bat_document_count(d), 1);
        expect_box(d, 0, 0, 0, rows[i].drawn ? 3 : 50, rows[i].drawn ? 4 : 60);
        bat_document_free(d);
    }
}

static bat_document *random_document(random_source *r, int objects) {
    static const char *const names[] = {
        "", "roof", "roof", "\"<&>'\n\t \x01 \xf0\x9f\x9a\x97]]>", "r\xc3\xb6hre", "9x"};
    bat_document *document;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    double page[4] = {random_between(r, -5, 5), -0.0, random_between(r, 1, 500), 0.1};
    if (objects % 2) assert_int_equal(bat_document_set_page(document, page), BAT_OK);
    for (int i = 0; i < objects; i++) {
        bat_curve *curves[3];
        int count = 1 + i % 3, dimension = 2 + i % 5 / 4;
        for (int k = 0; k < count; k++)
            curves[k] = random_curve(r, 1 + (i + k) % 7, dimension, i % 3, i % 11);
        bat_style style = {.stroked = i % 4 != 0,
                           .filled = i % 3 == 0,
                           .even_odd = i % 4 == 0,
                           .stroke = (uint32_t)(r->state >> 32),
                           .fill = (uint32_t)(r->state >> 20),
                           .width = random_unit(r) * 10,
                           .opacity = i % 2 ? 1 : random_unit(r),
                           .cap = (bat_cap)(i % 3),
                           .join = (bat_join)(i / 3 % 3),
                           .miter_limit = 1 + random_unit(r)};
        bat_object *object;
        assert_int_equal(bat_object_create_path(bat_document_new_id(document), names[i % 6], &style, count,
                                                curves, &object),
                         BAT_OK);
        assert_int_equal(bat_document_insert(document, i / 2, object), BAT_OK);
        bat_object_release(object);
    }
    return document;
}

static void native_comes_back_bit_for_bit(void **state) {
    (void)state;
    random_source r = {31};
    for (int i = 0; i < 40; i++) {
        bat_document *document = random_document(&r, i), *back;
        char *text, *again;
        size_t size, size_again;
        assert_int_equal(bat_svg_write(document, true, &text, &size), BAT_OK);
        assert_int_equal(size, strlen(text));
        back = read_svg(text);
        assert_true(report.native && !report.edited);
        assert_int_equal(bat_losses_total(&report.lost), 0);
        double page[4];
        bat_document_page(document, page);
        if (page[2] == 0) bat_document_page(back, page), bat_document_set_page(back, (double[4]){0, 0, 0, 0});
        assert_true(bat_document_digest(back) == bat_document_digest(document));
        assert_int_equal(bat_svg_write(document, true, &again, &size_again), BAT_OK);
        assert_string_equal(text, again);
        bat_free(text);
        bat_free(again);
        bat_document_free(back);
        bat_document_free(document);
    }
}

/* What is read from the visible paths runs along the curves that were written. */
static void visible_paths_are_the_curves(void **state) {
    (void)state;
    random_source r = {32};
    for (int i = 0; i < 60; i++) {
        bat_document *document, *back;
        bat_curve *curve = random_curve(&r, 1 + i % 7, 2, i % 3, 1 + i % 9);
        bat_style style = bat_style_defaults();
        bat_object *object;
        assert_int_equal(bat_document_create(&document), BAT_OK);
        assert_int_equal(bat_object_create_path(1, "c", &style, 1, &curve, &object), BAT_OK);
        assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
        bat_object_release(object);
        char *text;
        size_t size;
        assert_int_equal(bat_svg_write_within(document, false, 0, &text, &size), BAT_OK);
        back = read_svg(text);
        assert_false(report.native || report.edited);
        assert_int_equal(bat_losses_total(&report.lost), 0);
        assert_int_equal(bat_document_count(back), 1);
        const bat_curve *read = bat_object_curve(bat_document_at(back, 0), 0);
        assert_int_equal(bat_curve_is_closed(read), bat_curve_is_closed(curve));
        double a_box[4], b_box[4];
        bat_object_bounds(bat_document_at(document, 0), a_box);
        bat_object_bounds(bat_document_at(back, 0), b_box);
        for (int k = 0; k < 4; k++) assert_true(fabs(a_box[k] - b_box[k]) < 1e-5);
        assert_string_equal(bat_object_name(bat_document_at(back, 0)), "c");
        bat_free(text);
        bat_document_free(back);
        bat_document_free(document);
    }
}

/* Replaces the first `from` by `to`, of the same length. */
static void change(char *text, const char *from, const char *to) {
    char *at = strstr(text, from);
    assert_non_null(at);
    memcpy(at, to, strlen(to));
}

static void an_edited_drawing_wins(void **state) {
    (void)state;
    static const char *const edits[][2] = {{"d=\"M0 0", "d=\"M1 0"},
                                           {"stroke=\"#000000", "stroke=\"#00ff00"},
                                           {"stroke-width=\"2", "stroke-width=\"9"}};
    bat_document *source = read_svg("<svg viewBox='0 0 9 9'><path fill='none' stroke='#000' stroke-width='2' "
                                    "d='M0 0C1 2 3 4 5 5'/></svg>");
    for (size_t i = 0; i < sizeof edits / sizeof *edits; i++) {
        char *text;
        size_t size;
        assert_int_equal(bat_svg_write(source, true, &text, &size), BAT_OK);
        change(text, edits[i][0], edits[i][1]);
        bat_document *back = read_svg(text);
        assert_true(report.edited && !report.native);
        assert_int_equal(bat_losses_total(&report.lost), 1); /* the knots of the native document */
        if (i == 0) expect_box(back, 0, 1, 0, 5, 5);
        if (i == 1) assert_true(style_of(back, 0)->stroke == 0x00ff00ff);
        if (i == 2) assert_true(style_of(back, 0)->width == 9);
        char line[200];
        bat_svg_report_line(&report, line, sizeof line);
        assert_non_null(strstr(line, "another program"));
        bat_free(text);
        bat_document_free(back);
    }
    /* A page of another size is taken over, the knots stay. Damaged native text: the drawing is read. */
    char *text;
    size_t size;
    assert_int_equal(bat_svg_write(source, true, &text, &size), BAT_OK);
    change(text, "viewBox=\"0 0 9 9", "viewBox=\"0 0 8 9");
    bat_document *back = read_svg(text);
    double page[4];
    bat_document_page(back, page);
    assert_true(report.native && page[2] == 8);
    bat_document_free(back);
    change(text, "{&quot;batten&quot;:1", "{&quot;batten&quot;:0");
    back = read_svg(text);
    assert_true(report.edited && bat_document_count(back) == 1);
    bat_document_free(back);
    char *from = strstr(text, "{&quot;batten&quot;"),
         *to = strstr(from ? from : text, "</"); /* nothing there */
    assert_true(from && to);
    memmove(from, to, strlen(to) + 1);
    back = read_svg(text);
    assert_true(report.edited && !report.native && bat_document_count(back) == 1);
    bat_document_free(back);
    change(text, " digest=\"", " digesz=\""); /* of no drawing */
    back = read_svg(text);
    assert_true(report.edited && !report.native && bat_document_count(back) == 1);
    bat_document_free(back);
    bat_free(text);
    bat_document_free(source);
}

static void bad_files_are_told(void **state) {
    (void)state;
    static const struct {
        const char *text;
        bat_status status;
        const char *part;
    } cases[] = {{"", BAT_SYNTAX, "nothing"},
                 {"<html></html>", BAT_UNSUPPORTED, "svg element"},
                 {"<svg><g>", BAT_SYNTAX, "ends"},
                 {"<svg></svg><svg></svg>", BAT_SYNTAX, "one element"},
                 {"<svg></svg></svg>", BAT_SYNTAX, "one element"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_document *document = NULL;
        bat_problem problem;
        assert_int_equal(xml_read(cases[i].text, NULL, &document, NULL, &problem), cases[i].status);
        if (!strstr(problem.message, cases[i].part)) fail_msg("%s", problem.message);
        assert_null(document);
    }
}

/* Nesting without end, and ten uses of ten uses of ten uses. */
static void hostile_files_end(void **state) {
    (void)state;
    bat_svg_reader *reader;
    bat_document *document = NULL;
    bat_problem problem;
    assert_int_equal(bat_svg_reader_create(NULL, &reader), BAT_OK);
    for (int i = 0; i < 100000; i++) bat_svg_reader_start(reader, i ? "g" : "svg", NULL);
    assert_int_equal(bat_svg_reader_finish(reader, &document, NULL, &problem), BAT_COUNT);
    char text[4000] = "<svg><g id='i0'/>";
    for (int i = 1; i < 9; i++) {
        sprintf(text + strlen(text), "<g id='i%d'>", i);
        for (int k = 0; k < 10; k++) sprintf(text + strlen(text), "<use href='#i%d'/>", i - 1);
        strcat(text, "</g>");
    }
    strcat(text, "</svg>");
    assert_int_equal(xml_read(text, NULL, &document, NULL, &problem), BAT_COUNT);
    assert_null(document);
    bat_document *d = read_svg(
        "<svg><path d='M1e76 0L1 1'/><path d='M0 0L1e70 1' transform='scale(1e10)'/>"
        "<rect width='1e60' height='1e60' stroke-width='1e74' stroke='red' transform='scale(1e10)'/>"
        "<path d='M0 0L1 1' transform='scale(0)'/></svg>");
    assert_true(report.lost.count[BAT_LOSS_BROKEN] + report.lost.count[BAT_LOSS_UNKNOWN] >= 3);
    bat_document_free(d);
}

static const char sample[] =
    "<svg viewBox='0 0 9 9'><style>.a{fill:red} #b{stroke:blue}</style><g id='b' class='a'>"
    "<path d='M0 0C1 2 3 4 5 5ZM1 1L2 2L3 1A1 1 0 0 1 2 2'/><use href='#b'/><rect id='r' width='3' "
    "height='3'/></g>"
    "<use href='#r'/><text/></svg>";

static void every_allocation_may_fail(void **state) {
    (void)state;
    bat_document *source = read_svg(sample);
    long before = alloc_live();
    int failures = 0;
    for (long n = 1;; n++) {
        char *text = NULL, *json = NULL;
        size_t size;
        bat_document *back = NULL;
        alloc_fail_at(n);
        bat_status status = bat_svg_write(source, true, &text, &size);
        if (status == BAT_OK) status = bat_document_write(source, &json, &size);
        if (status == BAT_OK) status = bat_document_read(json, size, &back, NULL);
        bool hit = alloc_fail_reached();
        assert_int_equal(status, hit ? BAT_MEMORY : BAT_OK);
        bat_free(text);
        bat_free(json);
        bat_document_free(back);
        assert_int_equal(alloc_live(), before);
        if (!hit) break;
        failures++;
    }
    assert_true(failures > 20);
    bat_document_free(source);
}

static const char *const sample_path[] = {
    "d", "M0 0C1 2 3 4 5 5ZM1 1L2 2L3 1A1 1 0 0 1 2 2", "id", "p", "stroke", "red", NULL};

static void every_allocation_of_the_reader_may_fail(void **state) {
    (void)state;
    long before = alloc_live();
    static const char *const use[] = {"href", "#p", NULL};
    static const char css[] = ".a{fill:red} #p{stroke:blue}";
    int failures = 0;
    for (long n = 1;; n++) {
        bat_svg_reader *reader = NULL;
        bat_document *document = NULL;
        alloc_fail_at(n);
        bat_status status = bat_svg_reader_create(NULL, &reader);
        if (status == BAT_OK) {
            bat_svg_reader_start(reader, "svg", NULL);
            bat_svg_reader_start(reader, "style", NULL);
            bat_svg_reader_text(reader, css, sizeof css - 1);
            bat_svg_reader_end(reader);
            for (int i = 0; i < 40; i++) {
                bat_svg_reader_start(reader, i % 2 ? "use" : "path", i % 2 ? use : sample_path);
                bat_svg_reader_end(reader);
            }
            bat_svg_reader_end(reader);
            status = bat_svg_reader_finish(reader, &document, NULL, NULL);
        }
        bool hit = alloc_fail_reached();
        assert_int_equal(status, hit ? BAT_MEMORY : BAT_OK);
        assert_true(hit == (document == NULL));
        bat_document_free(document);
        assert_int_equal(alloc_live(), before);
        if (!hit) break;
        failures++;
    }
    assert_true(failures > 100);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(paths_become_curves),
        cmocka_unit_test(pages_and_units),
        cmocka_unit_test(styles_cascade),
        cmocka_unit_test(use_and_viewports),
        cmocka_unit_test(a_switch_draws_what_is_for_english),
        cmocka_unit_test(native_comes_back_bit_for_bit),
        cmocka_unit_test(visible_paths_are_the_curves),
        cmocka_unit_test(an_edited_drawing_wins),
        cmocka_unit_test(bad_files_are_told),
        cmocka_unit_test(hostile_files_end),
        cmocka_unit_test(every_allocation_may_fail),
        cmocka_unit_test(every_allocation_of_the_reader_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
