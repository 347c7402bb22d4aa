/* Texts: what they say and how they look goes through the native format and through SVG, where other programs read them as text;
 * what another program has changed about one becomes foreign content; every allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>
#include "document/document.h"
#include "document/kind.h"
#include "document/lettering.h"
#include "document/source.h"
#include "format/svg/write/feed.h"
#include "support/alloc_fail.h"
#include <batten/bezier.h>
#include <batten/format.h>
#include <stdlib.h>

static const double PLACE[6] = {2, 0.5, -0.25, 2, 30, 40};

static bat_lettering lettering(const char *content) {
    bat_lettering l = bat_lettering_defaults();
    l.content = content;
    l.family = "\"Noto Sans\", sans-serif";
    l.size = 17.3;
    l.weight = 650;
    l.italic = true;
    l.spacing = 0.7;
    l.line = 1.35;
    l.align = BAT_ALIGN_MIDDLE;
    l.box[0] = -40.1, l.box[1] = -15, l.box[2] = 41.7, l.box[3] = 36.9;
    return l;
}

static bat_document *document_of(const bat_lettering *l) {
    bat_document *document = NULL;
    bat_object *object = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(
        bat_object_create_text(bat_document_new_id(document), "title", l, PLACE, 0x204060ff, 0.5, &object),
        BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    assert_null(bat_document_check(document));
    return document;
}

static bat_document *read_svg(const char *text, bat_svg_report *report) {
    bat_document *document = NULL;
    bat_svg_reader *reader = NULL;
    assert_int_equal(bat_svg_reader_create(NULL, &reader), BAT_OK);
    assert_int_equal(bat_svg_reader_source(reader, text, strlen(text)), BAT_OK);
    assert_int_equal(bat_svg_feed(text, strlen(text), reader), BAT_OK);
    assert_int_equal(bat_svg_reader_finish(reader, &document, report, NULL), BAT_OK);
    assert_null(bat_document_check(document));
    return document;
}

static char *written(const bat_document *document, bool native) {
    char *text = NULL;
    size_t size;
    assert_int_equal(bat_svg_write(document, native, &text, &size), BAT_OK);
    return text;
}

static const char *const contents[] = {"Hello",           "  two  spaces ",
                                       "a < b & \"c\"",   "\xed\x95\x9c\xea\xb8\x80 \xf0\x9f\x8c\xb1",
                                       "first\n\nthird ", "\nend\n"};

/* As a native document and as SVG, with and without the native one in it, it comes back bit for bit, at any size. */
static void what_is_said_comes_back(void **unused) {
    (void)unused;
    static const double scales[] = {1, 1e-12, 1e6};
    for (size_t i = 0; i < sizeof contents / sizeof *contents; i++) {
        bat_lettering l = lettering(contents[i]);
        l.size *= scales[i % 3];
        for (int k = 0; k < 4; k++) l.box[k] *= scales[i % 3];
        bat_document *document = document_of(&l), *again = NULL;
        char *text;
        size_t size;
        assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
        assert_non_null(strstr(text, "{\"batten\":12,"));
        assert_null(strstr(text, "\"pictures\""));
        assert_int_equal(bat_document_read(text, size, &again, NULL), BAT_OK);
        assert_true(bat_document_digest(again) == bat_document_digest(document));
        bat_free(text);
        bat_document_free(again);
        for (int native = 0; native < 2; native++) {
            bat_svg_report report = {0};
            text = written(document, native);
            assert_non_null(strstr(text, "<text "));
            assert_null(strstr(text, "<image"));
            again = read_svg(text, &report);
            assert_int_equal(bat_losses_total(&report.lost), 0);
            const bat_object *object = bat_document_at(again, 0);
            assert_non_null(bat_object_lettering(object));
            assert_true(bat_lettering_same(bat_object_lettering(object), &l));
            assert_memory_equal(bat_object_place(object), PLACE, sizeof PLACE);
            assert_true(bat_object_style(object)->fill == 0x204060ff &&
                        bat_object_style(object)->opacity == 0.5);
            bat_free(text);
            bat_document_free(again);
        }
        bat_document_free(document);
    }
}

/* Moved, recoloured and named anew in a file that is kept, it changes nothing else of it, and comes back. */
static void edits_in_a_kept_file(void **unused) {
    (void)unused;
    const bat_lettering l = lettering("one\ntwo"), other = lettering("three");
    bat_document *document = document_of(&l);
    char *text = written(document, false);
    for (int edit = 0; edit < 4; edit++) {
        bat_svg_report report = {0};
        bat_document *kept = read_svg(text, &report);
        const bat_object *object = bat_document_at(kept, 0);
        bat_object *after = NULL;
        bat_style style = *bat_object_style(object);
        const double by[12] = {1, 0, 0, 3, 0, 1, 0, 4, 0, 0, 1, 0};
        style.fill = 0xff000080, style.opacity = 0.25;
        bat_status status = edit == 0   ? bat_object_with_lettering(object, &other, &after)
                            : edit == 1 ? bat_object_with_style(object, &style, &after)
                            : edit == 2 ? bat_object_with_state(object, true, true, &after)
                                        : bat_object_type(object)->transform(object, by, &after);
        assert_int_equal(status, BAT_OK);
        assert_int_equal(bat_document_replace(kept, 0, after), BAT_OK);
        assert_null(bat_document_check(kept));
        char *saved = written(kept, true);
        bat_document *again = read_svg(saved, &report);
        const bat_object *read = bat_document_at(again, 0);
        assert_int_equal(bat_document_count(again), 1);
        assert_true(bat_document_digest(again) == bat_document_digest(kept));
        assert_non_null(bat_object_lettering(read));
        assert_null(strstr(saved, "<image"));
        bat_free(saved);
        bat_object_release(after);
        bat_document_free(kept);
        bat_document_free(again);
    }
    bat_free(text);
    bat_document_free(document);
}

/* Colour and opacity are the style's; the picture shows them; a new place keeps the picture. */
static void style_and_place(void **unused) {
    (void)unused;
    const bat_lettering l = lettering("Hello");
    bat_document *document = document_of(&l);
    const bat_object *object = bat_document_at(document, 0);
    bat_object *red = NULL, *moved = NULL;
    bat_style style = *bat_object_style(object);
    const double by[12] = {0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 0};
    double a[4], b[4];
    size_t size;
    style.fill = 0xff0000ff, style.stroked = true;
    assert_int_equal(bat_object_with_style(object, &style, &red), BAT_OK);
    assert_false(bat_object_style(red)->stroked);
    const char *bytes = bat_picture_bytes(bat_object_picture(red), &size);
    assert_non_null(strstr(bytes, "#ff0000"));
    assert_int_equal(bat_object_type(red)->transform(red, by, &moved), BAT_OK);
    assert_ptr_equal(bat_object_picture(red), bat_object_picture(moved));
    bat_object_bounds(red, a);
    bat_object_bounds(moved, b);
    assert_true(b[0] - (5 - a[3]) < 1e-9 && b[3] - (6 + a[2]) < 1e-9);
    assert_false(bat_object_is_foreign(red));
    bat_object_release(red);
    bat_object_release(moved);
    bat_document_free(document);
}

/* What this program would not have written is foreign content, of which nothing is lost. */
static void others_are_foreign(void **unused) {
    (void)unused;
    static const char *const changes[][2] = {{"<text ", "<text rotate=\"4\" "},
                                             {"data-line=\"1.35\"", ""},
                                             {"xml:space=\"preserve\"", ""},
                                             {"<tspan x=\"0\" y=\"0\">", "<tspan x=\"1\" y=\"0\">"},
                                             {"one", "o<tspan>n</tspan>e"}};
    const bat_lettering l = lettering("one\ntwo");
    bat_document *document = document_of(&l);
    char *text = written(document, false);
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        bat_svg_report report = {0};
        const char *at = strstr(text, changes[i][0]);
        char changed[4000];
        assert_non_null(at);
        snprintf(changed, sizeof changed, "%.*s%s%s", (int)(at - text), text, changes[i][1],
                 at + strlen(changes[i][0]));
        bat_document *again = read_svg(changed, &report);
        assert_true(bat_object_is_foreign(bat_document_at(again, 0)));
        bat_document_free(again);
    }
    bat_free(text);
    bat_document_free(document);
}

static void refuses(void **unused) {
    (void)unused;
    bat_object *object = NULL;
    const double flat[6] = {1, 0, 0, 0, 0, 0};
    for (int i = 0; i < 8; i++) {
        bat_lettering l = lettering(i == 0 ? "" : i == 1 ? "\xff" : "Hello");
        if (i == 2) l.size = 0;
        if (i == 3) l.weight = 1001;
        if (i == 4) l.box[2] = l.box[0];
        if (i == 5) l.family = "";
        if (i == 6) l.spacing = BAT_COORDINATE_MAX * 2;
        assert_int_not_equal(bat_object_create_text(1, "", &l, i == 7 ? flat : PLACE, 255, 1, &object),
                             BAT_OK);
    }
}

static bat_status make_and_write(void) {
    const bat_lettering l = lettering("one\ntwo");
    bat_object *object = NULL, *other = NULL;
    bat_document *document = NULL;
    char *text = NULL;
    size_t size;
    bat_status status = bat_document_create(&document);
    if (status == BAT_OK) status = bat_object_create_text(1, "a", &l, PLACE, 255, 1, &object);
    if (status == BAT_OK) status = bat_object_with_lettering(object, &l, &other);
    if (status == BAT_OK) status = bat_document_insert(document, 0, other);
    if (status == BAT_OK) status = bat_svg_write(document, true, &text, &size);
    bat_free(text);
    bat_object_release(object);
    bat_object_release(other);
    bat_document_free(document);
    return status;
}

static void memory_runs_out(void **unused) {
    (void)unused;
    for (int n = 1;; n++) {
        const long before = alloc_live();
        alloc_fail_at(n);
        const bat_status status = make_and_write();
        const bool reached = alloc_fail_reached();
        assert_int_equal(alloc_live(), before);
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        if (!reached) break;
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_is_said_comes_back),
                                       cmocka_unit_test(edits_in_a_kept_file),
                                       cmocka_unit_test(style_and_place),
                                       cmocka_unit_test(others_are_foreign),
                                       cmocka_unit_test(refuses),
                                       cmocka_unit_test(memory_runs_out)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
