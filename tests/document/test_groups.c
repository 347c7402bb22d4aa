/* Groups and layers: a tree in a flat list, preserved by every reader and writer. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "document/document.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "support/pen.h"

static void put(bat_document *document, int index, bat_object *object, bat_id parent) {
    bat_object *placed = NULL;
    assert_int_equal(bat_object_with_parent(object, parent, &placed), BAT_OK);
    assert_int_equal(bat_document_insert(document, index, placed), BAT_OK);
    bat_object_release(placed);
    bat_object_release(object);
}

static bat_object *group(bat_id id, bool layer) {
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_group(id, "Gruppe \"ä\"", layer, &object), BAT_OK);
    return object;
}

static bat_object *line(bat_id id) {
    bat_object *object = NULL;
    bat_style style = bat_style_defaults();
    bat_curve *curve = pen_curve(10 * (double)id, 20, 10, 3, 6);
    assert_int_equal(bat_object_create_path(id, NULL, &style, 1, &curve, &object), BAT_OK);
    return object;
}

/* layer 1 { line 2, group 3 { line 4, group 5 {} , line 6 } }, line 7, layer 8 {} */
static bat_document *nested(void) {
    static const struct {
        bat_id parent;
        char kind;
    } rows[] = {{0, 'l'}, {1, 'p'}, {1, 'g'}, {3, 'p'}, {3, 'g'}, {3, 'p'}, {0, 'p'}, {0, 'l'}};
    bat_document *document = NULL;
    bat_document_create(&document);
    for (int i = 0; i < 8; i++) {
        bat_id id = (bat_id)i + 1;
        put(document, i, rows[i].kind == 'p' ? line(id) : group(id, rows[i].kind == 'l'), rows[i].parent);
    }
    return document;
}

static void state(bat_document *document, int index, bool hidden, bool locked) {
    bat_object *after = NULL;
    bat_object_with_state(bat_document_at(document, index), hidden, locked, &after);
    bat_document_replace(document, index, after);
    bat_object_release(after);
}

static void ends_and_invariants(void **unused) {
    (void)unused;
    static const int ends[] = {6, 2, 6, 4, 5, 6, 7, 8};
    bat_document *document = nested();
    assert_null(bat_document_check(document));
    for (int i = 0; i < 8; i++) assert_int_equal(bat_document_end(document, i), ends[i]);
    double box[4];
    bat_object_bounds(bat_document_at(document, 0), box);
    assert_true(box[0] > box[2]);
    bat_document_bounds(document, box);
    assert_true(box[0] == 20 && box[2] == 120);
    /* A line between a group and its members: they are no longer together. */
    bat_object *stranger = line(9);
    bat_document_insert(document, 3, stranger);
    assert_non_null(bat_document_check(document));
    bat_document_remove(document, 3);
    bat_object_release(stranger);
    /* Members without their group. */
    bat_document_remove(document, 2);
    assert_non_null(bat_document_check(document));
    bat_document_free(document);
    /* A layer in a group. */
    document = nested();
    bat_object *layer = group(9, true);
    put(document, 5, layer, 3);
    assert_non_null(bat_document_check(document));
    bat_document_free(document);
}

static void digest_tells_them_apart(void **unused) {
    (void)unused;
    bat_document *document = nested();
    uint64_t digest = bat_document_digest(document);
    state(document, 1, true, false);
    uint64_t hidden = bat_document_digest(document);
    state(document, 1, false, true);
    uint64_t locked = bat_document_digest(document);
    state(document, 1, false, false);
    assert_true(hidden != digest && locked != digest && hidden != locked);
    assert_true(bat_document_digest(document) == digest);
    bat_document_free(document);
}

static void native_keeps_all(void **unused) {
    (void)unused;
    bat_document *document = nested(), *again = NULL;
    state(document, 0, true, true);
    state(document, 3, false, true);
    char *text = NULL;
    size_t size;
    bat_problem problem;
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    assert_int_equal(bat_document_read(text, size, &again, &problem), BAT_OK);
    assert_true(bat_document_digest(again) == bat_document_digest(document));
    assert_null(bat_document_check(again));
    bat_document_free(again);
    bat_free(text);
    bat_document_free(document);
    static const char *const broken[] = {
        "{\"batten\":1,\"objects\":[{\"id\":2,\"kind\":\"group\",\"parent\":1}]}",
        "{\"batten\":1,\"objects\":[{\"id\":2,\"kind\":\"group\",\"parent\":2}]}",
        "{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"group\"},{\"id\":2,\"kind\":\"group\"},"
        "{\"id\":3,\"kind\":\"group\",\"parent\":1}]}",
        "{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"group\"},{\"id\":2,\"kind\":\"layer\",\"parent\":1}]"
        "}",
        "{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"group\",\"parent\":1.5}]}",
        "{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"group\",\"hidden\":1}]}",
    };
    for (size_t i = 0; i < sizeof broken / sizeof *broken; i++)
        assert_int_not_equal(bat_document_read(broken[i], strlen(broken[i]), &again, &problem), BAT_OK);
}

/* A hundred groups in one another are more than the walk carries: refused, not crashed. */
static void too_deep(void **unused) {
    (void)unused;
    bat_document *document = NULL;
    bat_document_create(&document);
    for (int i = 0; i < 100; i++) put(document, i, group((bat_id)i + 1, false), (bat_id)i);
    assert_non_null(bat_document_check(document));
    bat_document_free(document);
}

typedef struct svg {
    bat_svg_reader *reader;
} svg;

static void start(svg *s, const char *name, const char *const *attributes) {
    static const char *const none[] = {NULL};
    assert_int_equal(bat_svg_reader_start(s->reader, name, attributes ? attributes : none), BAT_OK);
}

static void path(svg *s, const char *d) {
    start(s, "path", (const char *const[]){"d", d, "stroke", "#000", NULL});
    bat_svg_reader_end(s->reader);
}

static void svg_groups_come_in(void **unused) {
    (void)unused;
    svg s;
    bat_svg_reader_create(NULL, &s.reader);
    start(&s, "svg", (const char *const[]){"xmlns", "http://www.w3.org/2000/svg", NULL});
    start(&s, "g",
          (const char *const[]){"inkscape:groupmode", "layer", "inkscape:label", "Ink", "display", "none",
                                NULL});
    start(&s, "g", NULL); /* holds two: stays */
    path(&s, "M0 0L10 10");
    path(&s, "M0 0L20 10");
    bat_svg_reader_end(s.reader);
    bat_svg_reader_end(s.reader);
    start(&s, "g",
          (const char *const[]){"transform", "translate(100 0)", NULL}); /* one without a name: goes */
    path(&s, "M0 0L30 10");
    bat_svg_reader_end(s.reader);
    start(&s, "g", NULL); /* empty: goes */
    bat_svg_reader_end(s.reader);
    bat_svg_reader_end(s.reader);
    bat_document *document = NULL;
    bat_svg_report report;
    bat_problem problem;
    assert_int_equal(bat_svg_reader_finish(s.reader, &document, &report, &problem), BAT_OK);
    assert_null(bat_document_check(document));
    assert_int_equal(bat_document_count(document), 5);
    assert_int_equal(report.paths, 1);
    assert_int_equal(report.hidden, 2);
    const bat_object *layer = bat_document_at(document, 0), *inner = bat_document_at(document, 1);
    assert_int_equal(bat_object_kind(layer), BAT_KIND_LAYER);
    assert_string_equal(bat_object_name(layer), "Ink");
    assert_true(bat_object_is_hidden(layer) && !bat_object_is_hidden(inner));
    assert_int_equal(bat_object_parent(inner), bat_object_id(layer));
    assert_int_equal(bat_object_parent(bat_document_at(document, 3)), bat_object_id(inner));
    assert_int_equal(bat_object_parent(bat_document_at(document, 4)), 0);
    double box[4];
    bat_object_bounds(bat_document_at(document, 4), box);
    assert_true(box[0] == 100 && box[2] == 130);
    bat_document_free(document);
}

/* How often the text holds the word. */
static int count(const char *text, const char *word) {
    int found = 0;
    for (const char *at = text; (at = strstr(at, word)); at++) found++;
    return found;
}

static void svg_groups_go_out(void **unused) {
    (void)unused;
    bat_document *document = nested();
    state(document, 2, true, false);
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
    assert_int_equal(count(text, "<g"), 4);
    assert_int_equal(count(text, "</g>"), 4);
    assert_int_equal(count(text, "inkscape:groupmode=\"layer\""), 2);
    assert_int_equal(count(text, "display=\"none\""), 1);
    assert_int_equal(count(text, "<path"), 4);
    /* each where it belongs: the fourth path after three groups have closed */
    const char *last = text;
    for (int i = 0; i < 4; i++) last = strstr(last + 1, "<path");
    int closed = 0;
    for (const char *at = text; (at = strstr(at, "</g>")) && at < last; at++) closed++;
    assert_int_equal(closed, 3);
    bat_free(text);
    bat_document_free(document);
}

/* A group's opacity: in files of the newest version only, in the digest, for all that is in it. */
static void opacity_is_of_the_whole(void **unused) {
    (void)unused;
    bat_document *document = nested(), *back = NULL;
    const uint64_t before = bat_document_digest(document);
    char *text;
    size_t size;
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    assert_memory_equal(text, "{\"batten\":1", 11);
    bat_free(text);
    const bat_object *group = bat_document_at(document, 0);
    bat_style style = *bat_object_style(group);
    bat_object *faded;
    style.opacity = 0.25;
    assert_int_equal(bat_object_with_style(group, &style, &faded), BAT_OK);
    bat_document_replace(document, 0, faded);
    bat_object_release(faded);
    assert_true(bat_document_digest(document) != before);
    assert_true(bat_document_level(document, 1).around == 0.25);
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    assert_memory_equal(text, "{\"batten\":6", 11);
    assert_int_equal(bat_document_read(text, size, &back, NULL), BAT_OK);
    assert_true(bat_document_digest(back) == bat_document_digest(document));
    assert_true(bat_object_style(bat_document_at(back, 0))->opacity == 0.25);
    bat_document_free(back);
    char *wrong = strstr(text, "\"opacity\":0.25");
    wrong[strlen("\"opacity\":")] = '7';
    assert_int_equal(bat_document_read(text, size, &back, NULL), BAT_SYNTAX);
    bat_free(text);
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ends_and_invariants),     cmocka_unit_test(digest_tells_them_apart),
        cmocka_unit_test(native_keeps_all),        cmocka_unit_test(too_deep),
        cmocka_unit_test(svg_groups_come_in),      cmocka_unit_test(svg_groups_go_out),
        cmocka_unit_test(opacity_is_of_the_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
