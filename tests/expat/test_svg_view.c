/* SVG files of drawings in space with a saved view: the picture is that of the view, as the library draws it; the drawing
 * comes back bit for bit; a changed picture is noticed; drawings that lie in their page are written as ever. */
#include <batten/sight.h>
#include <batten/svg_read.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "support/alloc_fail.h"
#include "support/pen.h"
#include "support/pictures.h"
#include "support/solids.h"
#include "support/views.h"

static const bat_viewpoint oblique = {
    .eye = {300, 400, -300}, .target = {0, 0, 5}, .up = {0, 0, -1}, .size = {640, 480}, .height = 200};

static void put(bat_document *document, bat_object *object) {
    assert_int_equal(bat_document_insert(document, bat_document_count(document), object), BAT_OK);
    bat_object_release(object);
}

static void put_view(bat_document *document, const bat_viewpoint *view) {
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_view(bat_document_new_id(document), "v", view, &object), BAT_OK);
    put(document, object);
}

/* A torus, a line through it, and a picture, on a page. */
static bat_document *scene(bool surface) {
    bat_document *document = NULL;
    bat_object *object = NULL;
    const double ends[] = {-90, 0, -40, 90, 10, 40}, knots[] = {0, 0, 1, 1};
    bat_style style = bat_style_defaults();
    bat_curve *line = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_document_set_page(document, (double[]){-100, -100, 300, 200});
    if (surface) {
        bat_surface *torus = solid_torus(60, 25, 12, 8);
        assert_int_equal(
            bat_object_create_surface(bat_document_new_id(document), "t", &style, torus, &object), BAT_OK);
        bat_surface_free(torus);
        put(document, object);
    }
    style.stroke = 0xc0203080, style.width = 3;
    assert_int_equal(bat_curve_create(surface ? 3 : 2, 1, false, 2, ends, 4, knots, &line), BAT_OK);
    assert_int_equal(bat_object_create_path(bat_document_new_id(document), "line", &style, 1, &line, &object),
                     BAT_OK);
    put(document, object);
    bat_picture *picture = make_picture(30, 20, 5);
    assert_int_equal(bat_object_create_image(bat_document_new_id(document), "image", picture,
                                             (double[]){1, 0, 0, 1, 5, 5}, 0.5, &object),
                     BAT_OK);
    bat_picture_release(picture);
    put(document, object);
    return document;
}

static char *svg_of(const bat_document *document, bool native) {
    char *text = NULL;
    size_t size = 0;
    assert_int_equal(bat_svg_write(document, native, &text, &size), BAT_OK);
    assert_int_equal(strlen(text), size);
    return text;
}

static bat_document *read_of(const char *text, bat_svg_report *report) {
    bat_document *document = NULL;
    bat_problem problem;
    assert_int_equal(bat_svg_read(text, strlen(text), NULL, &document, report, &problem), BAT_OK);
    return document;
}

static int losses(const bat_svg_report *report) {
    int sum = 0;
    for (int k = 0; k < BAT_LOSS_COUNT; k++) sum += report->lost.count[k];
    return sum;
}

static int count_of(const char *text, const char *word) {
    int count = 0;
    for (; (text = strstr(text, word)); text++) count++;
    return count;
}

/* Shorter than what the file can say. */
static bool is_short(const bat_seen_line *line) {
    for (int k = 2; k < 2 * (3 * line->segments + 1); k++)
        if (fabs(line->points[k] - line->points[k % 2]) > 0.01) return false;
    return true;
}

/* The paths are the lines of bat_line_drawing, within half a hundredth of a pixel. */
static void the_picture_is_that_of_the_view(void **unused) {
    (void)unused;
    bat_document *document = scene(true);
    put_view(document, &oblique);
    char *text = svg_of(document, false), *at = text;
    assert_non_null(strstr(text, "width=\"640\" height=\"480\" viewBox=\"0 0 640 480\""));
    const bat_surface *torus = bat_object_surface(bat_document_at(document, 0));
    const bat_curve *line = bat_object_curve(bat_document_at(document, 1), 0);
    bat_line_drawing *drawing = NULL;
    const bat_line_scene lines = {1, &torus, 1, &line};
    assert_int_equal(bat_line_drawing_create(&oblique, &lines, &drawing), BAT_OK);
    const size_t count = bat_line_drawing_count(drawing);
    int hidden = 0, drawn = 0;
    for (int pass = 0; pass < 2; pass++) /* hidden ones below the others */
        for (size_t i = 0; i < count; i++) {
            bat_seen_line seen;
            bat_line_drawing_at(drawing, i, &seen);
            if (seen.hidden != (pass == 0) || is_short(&seen)) continue;
            drawn++;
            hidden += seen.hidden;
            at = strstr(at, "<path");
            const char *d = strstr(at, " d=\"M") + 5, *dashes = strstr(at, "stroke-dasharray=\"4 3\"");
            assert_true((dashes && dashes < d) == seen.hidden);
            for (int k = 0; k < 2 * (3 * seen.segments + 1); k++) {
                char *end;
                assert_true(fabs(strtod(d, &end) - seen.points[k]) <= 0.00501);
                d = end + (*end == 'C' || *end == ' ');
            }
            assert_true(*d == '"');
            at += 5;
        }
    assert_int_equal(count_of(text, "<path"), drawn);
    assert_true(hidden > 3 && hidden < drawn && drawn + 4 > (int)count);
    assert_int_equal(count_of(text, "stroke=\"#c02030\""),
                     count_of(text, "stroke-opacity=\"0.502\"") + count_of(text, "stroke-opacity=\"0.251\""));
    bat_line_drawing_free(drawing);
    bat_free(text);
    bat_document_free(document);
}

/* In every view; the pictures, too, come back, and the page is not that of the view. */
static void the_drawing_comes_back(void **unused) {
    (void)unused;
    random_source r = {21};
    for (int run = 0; run < 12; run++) {
        bat_document *document = scene(true);
        bat_viewpoint view = some_view(&r, run, (double[]){0, 0, 0}, 300);
        view.size[0] += run / 3.0;
        put_view(document, &view);
        char *text = svg_of(document, true);
        bat_svg_report report;
        bat_document *back = read_of(text, &report);
        assert_true(report.native && !report.edited);
        assert_int_equal(losses(&report), 0);
        assert_true(bat_document_digest(back) == bat_document_digest(document));
        double page[4], own[4];
        bat_document_page(back, page), bat_document_page(document, own);
        assert_memory_equal(page, own, sizeof page);
        char *again = svg_of(back, true);
        assert_string_equal(again, text);
        bat_free(again);
        bat_free(text);
        bat_document_free(back);
        bat_document_free(document);
    }
}

/* Changed by another program: the picture is what is there. */
static void what_was_changed_is_noticed(void **unused) {
    (void)unused;
    static const char *const changes[][2] = {{"stroke-width=\"0.6\"", "stroke-width=\"0.7\""},
                                             {"stroke-dasharray=\"4 3\"", "stroke-dasharray=\"4 4\""},
                                             {"stroke=\"#1c2126\"", "stroke=\"#1c2127\""}};
    bat_document *document = scene(true);
    put_view(document, &oblique);
    for (int k = 0; k < 3; k++) {
        char *text = svg_of(document, true), *at = strstr(text, changes[k][0]);
        assert_non_null(at);
        memcpy(at, changes[k][1], strlen(changes[k][1]));
        bat_svg_report report;
        bat_document *back = read_of(text, &report);
        assert_true(!report.native && report.edited);
        assert_int_equal(report.lost.count[BAT_LOSS_NATIVE], 1);
        bat_free(text);
        bat_document_free(back);
    }
    bat_document_free(document);
}

/* The last view that is not hidden counts; a drawing in its page, or without a view, is written as ever. */
static void which_view(void **unused) {
    (void)unused;
    bat_document *document = scene(true), *flat = scene(false);
    char *without = svg_of(document, false), *page = svg_of(flat, false);
    bat_viewpoint other = oblique;
    other.size[0] = 333;
    put_view(document, &oblique);
    put_view(document, &other);
    char *last = svg_of(document, false);
    assert_non_null(strstr(last, "viewBox=\"0 0 333 480\""));
    for (int k = 0; k < 2; k++) {
        const int at = bat_document_count(document) - 1 - k;
        bat_object *hidden = NULL;
        assert_int_equal(bat_object_with_state(bat_document_at(document, at), true, false, &hidden), BAT_OK);
        assert_int_equal(bat_document_remove(document, at), BAT_OK);
        assert_int_equal(bat_document_insert(document, at, hidden), BAT_OK);
        bat_object_release(hidden);
        char *text = svg_of(document, false);
        if (k)
            assert_string_equal(text, without);
        else
            assert_non_null(strstr(text, "viewBox=\"0 0 640 480\""));
        bat_free(text);
    }
    put_view(flat, &oblique);
    char *again = svg_of(flat, false);
    assert_string_equal(again, page);
    bat_free(again), bat_free(page), bat_free(last), bat_free(without);
    bat_document_free(document), bat_document_free(flat);
}

static void no_memory(void **unused) {
    (void)unused;
    bat_document *document = scene(true);
    put_view(document, &oblique);
    const long before = alloc_live();
    bool reached = true;
    for (long n = 1; reached; n += 1 + n / 8) {
        char *text = NULL;
        size_t size = 0;
        alloc_fail_at(n);
        const bat_status status = bat_svg_write(document, true, &text, &size);
        reached = alloc_fail_reached();
        assert_true(status == BAT_OK || (reached && status == BAT_MEMORY && !text));
        if (text) assert_int_equal(count_of(text, "viewBox=\"0 0 640 480\""), 1);
        bat_free(text);
        assert_int_equal(alloc_live(), before);
    }
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_picture_is_that_of_the_view),
                                       cmocka_unit_test(the_drawing_comes_back),
                                       cmocka_unit_test(what_was_changed_is_noticed),
                                       cmocka_unit_test(which_view), cmocka_unit_test(no_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
