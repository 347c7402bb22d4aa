/* Another size of the page: what is drawn is scaled with it, or keeps its size; the unit alone changes nothing. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <cmocka.h>
#include "document/document.h"
#include "support/alloc_fail.h"
#include "support/svg_kept.h"
#include "support/editing.h"
#include "support/precision.h"
#include <batten/format.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double A4[4] = {0, 0, 210, 297};

/* A page in millimetres with two curves. */
static bat_editor *page_of(const double page[4]) {
    bat_curve *curves[] = {segment(20, 30, 80, 30), segment(20, 60, 80, 90)};
    bat_editor *editor = editor_with(2, curves);
    bat_document *document = NULL;
    assert_int_equal(bat_document_copy(bat_editor_document(editor), &document), BAT_OK);
    assert_int_equal(bat_document_set_page(document, page), BAT_OK);
    assert_int_equal(bat_document_set_scale(document, 1, BAT_UNIT_MM), BAT_OK);
    assert_int_equal(bat_editor_open(editor, document, ""), BAT_OK);
    return editor;
}

static void says(bat_editor *editor, const char *name, const char *expected) {
    assert_string_equal(bat_editor_number(editor, name), expected);
}

/* How long the first curve is, and how far it is from the page's corner, in millimetres. */
static void measure(const bat_document *document, double out[3]) {
    const double scale = bat_document_scale(document);
    double page[4], box[4];
    bat_document_page(document, page);
    bat_object_bounds(bat_document_at(document, 0), box);
    out[0] = (box[2] - box[0]) * scale, out[1] = (box[0] - page[0]) * scale,
    out[2] = (box[1] - page[1]) * scale;
}

static void expect_near(const double *found, const double *wanted, int count) {
    for (int i = 0; i < count; i++)
        if (!(fabs(found[i] - wanted[i]) <= 1e-9 * fabs(wanted[i]) + 1e-12))
            fail_msg("number %d: %.17g, not %.17g", i, found[i], wanted[i]);
}

static void both_answers(void **state) {
    (void)state;
    static const struct {
        const char *way, *size, *width, *height;
        double found[3]; /* length, distances from the page's left and top */
    } cases[] = {{"page-keep", "105mm × 148.5mm", "105 mm", "148.5 mm", {60, 20, 30}},
                 {"page-scale", "105 mm × 148.5 mm", "105 mm", "148.5 mm", {30, 10, 15}},
                 {"page-scale", "42cm x 594", "420 mm", "594 mm", {120, 40, 60}},
                 {"page-scale",
                  "2in × 297",
                  "50.8 mm",
                  "297 mm", /* in its middle, as large as fits */
                  {60 * 50.8 / 210, 20 * 50.8 / 210, 30 * 50.8 / 210 + (297 - 297 * 50.8 / 210) / 2}},
                 {"page-scale", "210 × 594", "210 mm", "594 mm", {60, 20, 30 + 297.0 / 2}},
                 {"page-keep", "8.5in × 11in", "215.9 mm", "279.4 mm", {60, 20, 30}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        bat_editor *editor = page_of(A4);
        const uint64_t first = digest(editor);
        double found[3];
        size_t size;
        bat_editor_select(editor, 1, false);
        char asked[80];
        snprintf(asked, sizeof asked, "page-asks %s", cases[i].size);
        says(editor, asked, "yes");
        assert_int_equal(bat_editor_enter(editor, cases[i].way, cases[i].size), BAT_OK);
        says(editor, asked, "");
        says(editor, "page-width", cases[i].width);
        says(editor, "page-height", cases[i].height);
        measure(bat_editor_document(editor), found);
        expect_near(found, cases[i].found, 3);
        assert_int_equal(bat_editor_frame(editor)->selected, 1);
        assert_non_null(strstr(bat_editor_journal(editor, &size), "\n{\"do\":\"page\",\"page\":["));
        const uint64_t last = digest(editor);
        assert_int_equal(round_trip(editor, first), 1);
        /* So does a compacted journal, with the step. */
        assert_int_equal(bat_editor_compact(editor), BAT_OK);
        bat_editor *again = replay_of(editor, 0);
        assert_int_equal(bat_editor_command(again, "undo"), BAT_OK);
        assert_true(digest(again) == first);
        assert_int_equal(bat_editor_command(again, "redo"), BAT_OK);
        assert_true(digest(again) == last);
        bat_editor_free(again);
        bat_editor_free(editor);
    }
}

/* Of the view: the page lies in the middle of the window, and fills it one way. */
static void is_seen(bat_editor *editor) {
    double page[4], seen[2];
    const double *view = bat_editor_frame(editor)->view, window[2] = {1000, 800};
    bat_document_page(bat_editor_document(editor), page);
    for (int k = 0; k < 2; k++) {
        const double middle = (page[k] + page[2 + k] / 2 - view[k]) * view[2];
        seen[k] = page[2 + k] * view[2] / window[k];
        if (!(fabs(middle - window[k] / 2) < 1e-6)) fail_msg("in the middle: %g", middle);
    }
    const double most = fmax(seen[0], seen[1]);
    if (!(most > .5 && most < 1)) fail_msg("of the window: %g", most);
}

/* A page of another size is seen whole, undone and redone, too; another unit leaves the view. */
static void seen_whole(void **state) {
    (void)state;
    static const char *const changes[][2] = {{"page-keep", "24mm × 24mm"},
                                             {"page-keep", "3000mm × 1000mm"},
                                             {"page-scale", "10mm × 10mm"},
                                             {"page-scale", "841mm × 1189mm"}};
    bat_editor *editor = page_of(A4);
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        assert_int_equal(bat_editor_enter(editor, changes[i][0], changes[i][1]), BAT_OK);
        is_seen(editor);
        assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
        is_seen(editor);
        assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
        is_seen(editor);
    }
    assert_int_equal(bat_editor_command(editor, "zoom-in"), BAT_OK);
    const double zoom = bat_editor_frame(editor)->view[2];
    assert_int_equal(bat_editor_enter(editor, "page-unit", "in"), BAT_OK);
    assert_true(bat_editor_frame(editor)->view[2] == zoom);
    bat_editor_free(editor);
}

/* Several changes, in between a curve is moved: each is a step of its own. */
static void steps_in_order(void **state) {
    (void)state;
    bat_editor *editor = page_of(A4);
    const uint64_t first = digest(editor);
    bat_editor_select(editor, 1, false);
    assert_int_equal(bat_editor_enter(editor, "page-scale", "420 × 594"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "width", "60"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "page-keep", "600 × 600"), BAT_OK);
    assert_int_equal(bat_editor_enter(editor, "page-keep", "600 × 600"), BAT_OK); /* no step */
    assert_int_equal(bat_editor_enter(editor, "page-unit", "in"), BAT_OK);
    assert_int_equal(round_trip(editor, first), 4);
    bat_editor_free(editor);
}

static void unit_alone(void **state) {
    (void)state;
    bat_editor *editor = page_of(A4);
    double before[3], after[3];
    const uint64_t first = digest(editor);
    measure(bat_editor_document(editor), before);
    says(editor, "page-unit", "mm");
    assert_int_equal(bat_editor_enter(editor, "page-unit", "in"), BAT_OK);
    says(editor, "page-unit", "in");
    says(editor, "page-width", "8.268 in");
    assert_true(bat_document_unit(bat_editor_document(editor)) == BAT_UNIT_IN);
    measure(bat_editor_document(editor), after);
    assert_memory_equal(before, after, sizeof before);
    says(editor, "page-asks 8.268 in × 11.693 in", ""); /* as it reads */
    assert_int_equal(bat_editor_command(editor, "undo"), BAT_OK);
    says(editor, "page-width", "210 mm");
    assert_true(digest(editor) == first);
    assert_int_equal(bat_editor_command(editor, "redo"), BAT_OK);
    says(editor, "page-width", "8.268 in");
    assert_int_equal(bat_editor_enter(editor, "page-unit", "ell"), BAT_SYNTAX);
    assert_int_equal(bat_editor_enter(editor, "page-unit", ""), BAT_SYNTAX);
    assert_int_equal(bat_editor_enter(editor, "page-other", "1"), BAT_UNSUPPORTED);
    bat_editor_free(editor);
}

static void what_is_refused(void **state) {
    (void)state;
    static const char *const bad[] = {"0 × 10",
                                      "10 × 0",
                                      "-5 × 10",
                                      "10",
                                      "",
                                      "× 10",
                                      "10 ×",
                                      "a × b",
                                      "nan × 10",
                                      "1/0 × 10",
                                      "1e9in × 1",
                                      "0.0001 × 10",
                                      "10 × 10000000000000",
                                      "10 × 10 × 10"};
    bat_editor *editor = page_of(A4);
    const uint64_t first = digest(editor);
    for (size_t i = 0; i < 2 * (sizeof bad / sizeof *bad); i++) {
        const char *way = i % 2 ? "page-keep" : "page-scale";
        if (bat_editor_enter(editor, way, bad[i / 2]) == BAT_OK) fail_msg("%s", bad[i / 2]);
        assert_string_equal(bat_editor_frame(editor)->notice, "That is not a valid page size");
        assert_true(digest(editor) == first);
    }
    /* Within what numbers can say a page may be as small or as large as one likes. */
    assert_int_equal(bat_editor_enter(editor, "page-scale", "0.01 × 0.01"), BAT_OK);
    says(editor, "page-height", "0.01 mm");
    assert_int_equal(bat_editor_enter(editor, "page-scale", "100000 × 200000"), BAT_OK);
    assert_int_equal(round_trip(editor, first), 2);
    /* Not while something is drawn, and not what may only be read. */
    pen p = pen_for(editor);
    drag_to(&p, 100, 100, 200, 150);
    assert_int_equal(bat_editor_enter(editor, "page-keep", "10 × 10"), BAT_STATE);
    pen_event(&p, BAT_POINTER_UP, 200, 150);
    bat_editor_command(editor, "undo");
    bat_editor_set_read_only(editor, true);
    assert_int_equal(bat_editor_enter(editor, "page-keep", "10 × 10"), BAT_STATE);
    bat_editor_free(editor);
}

/* Nothing is asked where nothing is drawn; where there was no page one begins at the drawing. */
static void empty_and_endless(void **state) {
    (void)state;
    bat_editor *editor = editor_with(0, NULL);
    says(editor, "page-asks 10 × 10", "");
    assert_int_equal(bat_editor_enter(editor, "page-keep", "10in × 5in"), BAT_OK);
    says(editor, "page-width", "960 px");
    bat_editor_free(editor);
    editor = page_of((double[]){0, 0, 0, 0});
    const uint64_t first = digest(editor);
    double page[4];
    says(editor, "page-width", "");
    says(editor, "page-asks 10 × 10", "");
    assert_int_equal(bat_editor_enter(editor, "page-scale", "100 × 50"), BAT_OK);
    bat_document_page(bat_editor_document(editor), page);
    expect_near(page, (double[]){20, 30, 100, 50}, 4);
    assert_int_equal(round_trip(editor, first), 1);
    bat_editor_free(editor);
}

/* ---- files ---- */

#define ROOT "<svg xmlns=\"http://www.w3.org/2000/svg\" "
#define REST                                                                                                 \
    "<!-- mine --><style>path{stroke:#000}</style>\n  <path d='M10 20 H 60' fill=\"none\"/>\n"               \
    "<text x='5'>Hello</text></svg>\n"

static bat_document *opened(const char *text) {
    bat_document *document = NULL;
    assert_int_equal(svg_read_kept(NULL, text, strlen(text), &document, NULL), BAT_OK);
    return document;
}

/* The file stays to the byte behind its root's start tag, and says the size that was asked for. */
static void kept_files(void **state) {
    (void)state;
    static const struct {
        const char *root;
        double mm[2]; /* of the page */
    } cases[] = {
        {"width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\">", {210, 297}},
        {"width=\"21cm\" height='29.7cm' viewBox='0 0 21000 29700' id=\"a\">", {210, 297}},
        {"viewBox=\"-10 -20 96 192\">", {25.4, 50.8}},
        {"width=\"96\" height=\"192\">", {25.4, 50.8}},
        {"width=\"100%\" height=\"100%\" viewBox=\"0 0 96 192\">", {25.4, 50.8}},
        {"width=\"1in\" height=\"1in\" viewBox=\"0 0 100 200\" preserveAspectRatio=\"none\">", {25.4, 25.4}},
        {"width=\"72pt\" viewBox=\"0 0 96 192\" preserveAspectRatio='xMinYMin slice'>", {25.4, 50.8}}};
    for (size_t i = 0; i < 3 * (sizeof cases / sizeof *cases); i++) {
        const double *mm = cases[i / 3].mm, factor = i % 3 == 1 ? .5 : 1;
        char file[1000], size[80], *text = NULL;
        double before[3], after[3], again[3], page[4], wide[4];
        size_t length = 0;
        snprintf(file, sizeof file, "%s", ROOT);
        strcat(file, cases[i / 3].root), strcat(file, REST);
        bat_editor *editor = editor_of(opened(file));
        const uint64_t first = digest(editor);
        measure(bat_editor_document(editor), before);
        snprintf(size, sizeof size, "%.17gmm × %.17gmm", mm[0] * (i % 3 ? .5 : 2), mm[1] * (i % 3 ? .5 : 3));
        assert_int_equal(bat_editor_enter(editor, i % 3 == 1 ? "page-scale" : "page-keep", size), BAT_OK);
        if (i % 3 == 2) assert_int_equal(bat_editor_enter(editor, "page-unit", "mm"), BAT_OK);
        measure(bat_editor_document(editor), after);
        for (int k = 0; k < 3; k++) before[k] *= factor;
        expect_near(after, before, 3);
        assert_int_equal(bat_svg_write(bat_editor_document(editor), false, &text, &length), BAT_OK);
        const char *rest = strstr(text, "<!-- mine");
        if (!rest || strcmp(rest, REST) != 0) fail_msg("%s\nbecame\n%s", file, text);
        bat_document *back = opened(text);
        measure(back, again);
        for (int k = 0; k < 3; k++)
            if (!(fabs(again[k] - after[k]) < 1e-8 * after[0])) fail_msg("%s\nbecame\n%s", file, text);
        bat_document_page(back, page), bat_document_page(bat_editor_document(editor), wide);
        for (int k = 0; k < 2; k++)
            if (!(fabs(page[2 + k] * bat_document_scale(back) - mm[k] * (i % 3 ? .5 : 2 + k)) < 1e-8 * mm[k]))
                fail_msg("%s\nbecame\n%s", file, text);
        assert_true(bat_document_unit(back) == bat_document_unit(bat_editor_document(editor)));
        bat_document_free(back);
        free(text);
        /* With it undone the file is what it was. */
        while (bat_editor_command(editor, "undo") == BAT_OK) continue;
        assert_true(digest(editor) == first);
        assert_int_equal(bat_svg_write(bat_editor_document(editor), true, &text, &length), BAT_OK);
        assert_string_equal(text, file);
        free(text);
        bat_editor_free(editor);
    }
}

/* Upright and on its side, exactly, and no page: the drawing is where it was; a kept file says so, too. */
static void turned_and_none(void **state) {
    (void)state;
    bat_editor *editor = page_of((double[]){-10, 5, 1. / 3, 297});
    const uint64_t first = digest(editor);
    double page[4], before[4], box[4];
    bat_object_bounds(bat_document_at(bat_editor_document(editor), 0), before);
    assert_int_equal(bat_editor_command(editor, "page-turn"), BAT_OK);
    bat_document_page(bat_editor_document(editor), page);
    assert_memory_equal(page, ((double[]){-10, 5, 297, 1. / 3}), sizeof page);
    assert_int_equal(bat_editor_command(editor, "page-turn"), BAT_OK);
    assert_true(digest(editor) == first);
    const double zoom = bat_editor_frame(editor)->view[2];
    assert_int_equal(bat_editor_command(editor, "page-none"), BAT_OK);
    assert_true(bat_editor_frame(editor)->view[2] == zoom);
    says(editor, "page-width", "");
    assert_int_equal(bat_editor_command(editor, "page-none"), BAT_STATE);
    assert_int_equal(bat_editor_command(editor, "page-turn"), BAT_STATE);
    bat_object_bounds(bat_document_at(bat_editor_document(editor), 0), box);
    assert_memory_equal(box, before, sizeof box);
    assert_int_equal(round_trip(editor, first), 3);
    bat_editor_free(editor);
    editor = editor_of(opened(ROOT "width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\">" REST));
    assert_int_equal(bat_editor_command(editor, "page-none"), BAT_OK);
    char *text = NULL;
    size_t length = 0;
    assert_int_equal(bat_svg_write(bat_editor_document(editor), true, &text, &length), BAT_OK);
    bat_document *back = opened(text);
    bat_document_page(back, page);
    assert_true(page[2] == 0 && page[3] == 0);
    assert_true(bat_document_scale(back) == 1);
    bat_document_free(back);
    free(text);
    bat_editor_free(editor);
}

static void native_files(void **state) {
    (void)state;
    bat_editor *editor = page_of(A4);
    char *text = NULL;
    size_t size = 0;
    bat_document *back = NULL;
    assert_int_equal(bat_editor_enter(editor, "page-scale", "4in × 7in"), BAT_OK);
    assert_int_equal(bat_document_write(bat_editor_document(editor), &text, &size), BAT_OK);
    assert_int_equal(bat_document_read(text, size, &back, NULL), BAT_OK);
    assert_true(bat_document_digest(back) == digest(editor));
    bat_document_free(back);
    free(text);
    assert_int_equal(bat_svg_write(bat_editor_document(editor), true, &text, &size), BAT_OK);
    back = opened(text);
    assert_true(bat_document_digest(back) == digest(editor));
    bat_document_free(back);
    free(text);
    bat_editor_free(editor);
}

/* Out of memory anywhere, the page stays as it was, or it is changed whole. */
static void any_memory(void **state) {
    (void)state;
    for (long at = 1; at < 200; at++) {
        bat_editor *editor = page_of(A4);
        const uint64_t first = digest(editor);
        alloc_fail_at(at);
        const bat_status status = bat_editor_enter(editor, "page-scale", "100 × 100");
        const bool failed = alloc_fail_reached();
        assert_int_equal(status, failed ? BAT_MEMORY : BAT_OK);
        assert_true((digest(editor) == first) == failed);
        check(editor);
        replays(editor, (uint64_t)at);
        bat_editor_free(editor);
        if (!failed) return;
    }
    fail_msg("%s", "never enough memory");
}

/* A line that is no page is refused, and changes nothing. */
static void bad_lines(void **state) {
    (void)state;
    static const char *const bad[] = {"{\"do\":\"page\"}",
                                      "{\"do\":\"page\",\"page\":[0,0,1],\"unit\":\"mm\",\"scale\":1}",
                                      "{\"do\":\"page\",\"page\":[0,0,-1,1],\"unit\":\"mm\",\"scale\":1}",
                                      "{\"do\":\"page\",\"page\":[0,0,1,\"1\"],\"unit\":\"mm\",\"scale\":1}",
                                      "{\"do\":\"page\",\"page\":[0,0,1,1],\"unit\":\"ell\",\"scale\":1}",
                                      "{\"do\":\"page\",\"page\":[0,0,1,1],\"scale\":1}",
                                      "{\"do\":\"page\",\"page\":[0,0,1,1],\"unit\":\"mm\",\"scale\":0}",
                                      "{\"do\":\"page\",\"page\":[0,0,1,1],\"unit\":\"mm\"}"};
    bat_editor *editor = page_of(A4);
    const uint64_t first = digest(editor);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        bat_problem problem = {"", ""};
        assert_true(bat_editor_replay_line(editor, bad[i], strlen(bad[i]), &problem) != BAT_OK);
        assert_true(problem.message[0] != 0 && digest(editor) == first);
    }
    bat_editor_free(editor);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_answers),      cmocka_unit_test(steps_in_order),
        cmocka_unit_test(unit_alone),        cmocka_unit_test(what_is_refused),
        cmocka_unit_test(kept_files),        cmocka_unit_test(native_files),
        cmocka_unit_test(empty_and_endless), cmocka_unit_test(any_memory),
        cmocka_unit_test(bad_lines),         cmocka_unit_test(seen_whole),
        cmocka_unit_test(turned_and_none),
    };
    return cmocka_run_group_tests_name("page", tests, NULL, NULL);
}
