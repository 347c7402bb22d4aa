/* Numbers of SVG are rounded so that no point moves by more than was asked. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "format/svg/outline.h"
#include "format/svg/write/feed.h"
#include "format/svg/svg.h"
#include "support/random_curve.h"
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/document.h>

#include <math.h>

static bat_document *drawing_of(bat_curve *curve) {
    bat_document *document;
    bat_object *object;
    const bat_style style = bat_style_defaults();
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_object_create_path(1, "c", &style, 1, &curve, &object), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    bat_object_release(object);
    return document;
}

static bat_curve *scaled(random_source *r, int degree, bool closed, double scale) {
    bat_curve *small = random_curve(r, degree, 2, closed, 6), *large;
    const double rows[6] = {scale, 0, 0.3 * scale, 0, scale, -0.1 * scale};
    assert_int_equal(bat_curve_transform(small, rows, &large), BAT_OK);
    bat_curve_free(small);
    return large;
}

/* The numbers of the first path. */
static const char *data_of(const char *text, size_t *size) {
    const char *data = strstr(text, " d=\"");
    assert_non_null(data);
    data += 4;
    *size = (size_t)(strchr(data, '"') - data);
    return data;
}

static int most_decimals(const char *data, size_t size) {
    int most = 0;
    for (size_t i = 0; i < size; i++) {
        if (data[i] != '.') continue;
        int count = 0;
        while (i + 1 < size && data[i + 1] >= '0' && data[i + 1] <= '9') count++, i++;
        if (count > most) most = count;
    }
    return most;
}

/* The furthest that a point of the cubics is from where the text has it. */
static double furthest(const bat_curve *curve, const char *data, size_t size) {
    bat_outline outline = {0};
    double *points, most = 0;
    int count;
    assert_int_equal(bat_curve_to_cubics(curve, 1, &count, &points), BAT_OK);
    assert_true(bat_svg_path(data, size, &outline));
    assert_int_equal(outline.subpath_count, 1);
    assert_int_equal(outline.subpaths[0].segments, count);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 4; k++) {
            const double *p = points + 8 * i + 2 * k, *q = outline.points + 2 * (3 * i + k);
            most = fmax(most, hypot(p[0] - q[0], p[1] - q[1]));
        }
    bat_outline_free(&outline);
    bat_free(points);
    return most;
}

static void no_point_moves_by_more(void **state) {
    (void)state;
    static const double asked[] = {0.5, 0.01, 1e-3, 1e-7};
    static const int decimals[] = {1, 2, 3, 7}; /* 0.707 of a step is the furthest that rounding moves */
    random_source r = {71};
    for (int i = 0; i < 120; i++) {
        bat_curve *curve = scaled(&r, 1 + i % 3, i % 2, i % 5 == 0 ? 1e5 : 10);
        bat_document *document = drawing_of(curve);
        for (size_t k = 0; k < 4; k++) {
            char *text;
            size_t size;
            assert_int_equal(bat_svg_write_within(document, false, asked[k], &text, &size), BAT_OK);
            const char *data = data_of(text, &size);
            assert_true(furthest(curve, data, size) <= asked[k] * (1 + 1e-9));
            assert_in_range(most_decimals(data, size), 0, decimals[k]);
            bat_free(text);
        }
        bat_document_free(document);
    }
}

static void nothing_is_rounded_at_0(void **state) {
    (void)state;
    random_source r = {72};
    for (int i = 0; i < 60; i++) {
        bat_curve *curve = scaled(&r, 1 + i % 3, i % 2, 1);
        bat_document *document = drawing_of(curve);
        char *text;
        size_t size;
        assert_int_equal(bat_svg_write_within(document, false, 0, &text, &size), BAT_OK);
        const char *data = data_of(text, &size);
        assert_true(furthest(curve, data, size) <= 1e-15 * bat_curve_size(curve));
        bat_free(text);
        bat_document_free(document);
    }
    char *text;
    size_t size;
    bat_document *document = drawing_of(scaled(&r, 3, false, 1));
    assert_int_equal(bat_svg_write_within(document, false, NAN, &text, &size), BAT_ARGUMENT);
    assert_int_equal(bat_svg_write_within(document, false, INFINITY, &text, &size), BAT_OK);
    bat_free(text);
    bat_document_free(document);
}

/* By itself it is rounded by so little that no size of a drawing shows it; the native document has every bit. */
static void rounding_is_not_seen(void **state) {
    (void)state;
    static const double scales[] = {1e-6, 1e-3, 0.1, 1, 24, 1000, 1e7};
    random_source r = {73};
    for (int i = 0; i < 140; i++) {
        bat_curve *curve = scaled(&r, 1 + i % 3, i % 2, scales[i % 7]);
        bat_document *document = drawing_of(curve), *again;
        char *text;
        size_t size, data_size;
        bat_svg_report report;
        bat_svg_reader *reader;
        assert_int_equal(bat_svg_write(document, true, &text, &size), BAT_OK);
        const char *data = data_of(text, &data_size);
        const double moved = furthest(curve, data, data_size);
        assert_true(moved <= 1e-3 && moved <= 1e-5 * bat_curve_size(curve));
        assert_int_equal(bat_svg_reader_create(NULL, &reader), BAT_OK);
        assert_int_equal(bat_svg_feed(text, size, reader), BAT_OK);
        assert_int_equal(bat_svg_reader_finish(reader, &again, &report, NULL), BAT_OK);
        assert_true(report.native && !report.edited);
        assert_true(bat_curve_is_equal(bat_object_curve(bat_document_at(again, 0), 0), curve));
        bat_document_free(again);
        bat_document_free(document);
        bat_free(text);
    }
}

/* A handle so short that rounding would turn it keeps its direction. */
static void short_handles_keep_their_direction(void **state) {
    (void)state;
    const double points[8] = {0, 0, 0.003, 0.004, 60, 90, 100, 100};
    bat_curve *curve;
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, points, &curve), BAT_OK);
    bat_document *document = drawing_of(curve);
    char *text;
    size_t size;
    bat_outline outline = {0};
    assert_int_equal(bat_svg_write(document, false, &text, &size), BAT_OK);
    const char *data = data_of(text, &size);
    assert_true(bat_svg_path(data, size, &outline));
    assert_true(fabs(atan2(outline.points[3], outline.points[2]) - atan2(4, 3)) < 2e-3);
    bat_outline_free(&outline);
    bat_free(text);
    bat_document_free(document);
}

/* In an element that is scaled the numbers are as fine as the scale asks for; those of other elements stay. */
static void scaled_elements_are_rounded_in_their_units(void **state) {
    (void)state;
    static const char file[] =
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 900 900'><g transform='scale(100)'>"
        "<path id='a' d='M1 1C2.123456789 3 4 5 6 7'/></g><path id='b' d='M0.123456789 0L9.987654321 "
        "7'/></svg>";
    bat_svg_reader *reader;
    bat_document *document;
    assert_int_equal(bat_svg_reader_create(NULL, &reader), BAT_OK);
    assert_int_equal(bat_svg_reader_source(reader, file, sizeof file - 1), BAT_OK);
    assert_int_equal(bat_svg_feed(file, sizeof file - 1, reader), BAT_OK);
    assert_int_equal(bat_svg_reader_finish(reader, &document, NULL, NULL), BAT_OK);
    const bat_object *object = bat_document_at(document, 0);
    const double turned[6] = {0.8, -0.6, 1.0 / 3, 0.6, 0.8, 1.0 / 7}, scale = 100;
    bat_curve *curve, *wanted;
    bat_object *made;
    assert_int_equal(bat_curve_transform(bat_object_curve(object, 0), turned, &curve), BAT_OK);
    const double own[6] = {1 / scale, 0, 0, 0, 1 / scale, 0};
    assert_int_equal(bat_curve_transform(curve, own, &wanted), BAT_OK);
    assert_int_equal(bat_object_with_curves(object, 1, &curve, &made), BAT_OK);
    assert_int_equal(bat_document_replace(document, 0, made), BAT_OK);
    bat_object_release(made);
    char *text;
    size_t size;
    assert_int_equal(bat_svg_write_within(document, false, 0.01, &text, &size), BAT_OK);
    assert_non_null(strstr(text, "d='M0.123456789 0L9.987654321 7'"));
    const char *data = data_of(text, &size);
    assert_int_equal(most_decimals(data, size), 4);
    assert_true(furthest(wanted, data, size) <= 0.01 / scale);
    bat_curve_free(wanted);
    bat_free(text);
    bat_document_free(document);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_point_moves_by_more),
        cmocka_unit_test(nothing_is_rounded_at_0),
        cmocka_unit_test(rounding_is_not_seen),
        cmocka_unit_test(short_handles_keep_their_direction),
        cmocka_unit_test(scaled_elements_are_rounded_in_their_units),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
