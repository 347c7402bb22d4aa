/*
 * Shapes in the document: the curve is the finest level, everything survives the native format and SVG, copies share
 * data, replacing the curve drops the levels, affine maps keep the levels and act on each; invalid shapes are refused.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/refine.h>
#include "curve/curve.h"
#include "base/matrix.h"
#include "editor/edit/affine.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/xml.h"
#include "support/shapes.h"
#include "support/objects.h"

static bat_curve *wavy(random_source *r, int dimension, bool closed, double middle) {
    double points[90], knots[40];
    for (int i = 0; i < 30; i++) {
        points[i * dimension] = middle + (closed ? 100 * cos(i * 0.2094) : 10.0 * i);
        points[i * dimension + 1] = closed ? 100 * sin(i * 0.2094) : 0;
        if (dimension == 3) points[i * dimension + 2] = 0;
        for (int d = 0; d < dimension; d++) points[i * dimension + d] += random_between(r, -4, 4);
    }
    for (int i = 0; i < 34; i++) knots[i] = closed ? i : i < 4 ? 0 : i > 29 ? 27 : i - 3;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(dimension, 3, closed, 30, points, closed ? 31 : 34, knots, &curve),
                     BAT_OK);
    return curve;
}

static bat_shape *levels_of(const bat_curve *curve, int levels, bat_frame_rule rule) {
    bat_shape_options options = bat_shape_defaults();
    options.frame = rule;
    bat_shape *shape = NULL;
    assert_int_equal(bat_shape_decompose(curve, levels, &options, &shape), BAT_OK);
    return shape;
}

/* Two curves, of which the second has levels. */
static bat_object *make(random_source *r, int round) {
    bat_style style = bat_style_defaults();
    int dimension = 2 + round % 2;
    bat_curve *curves[2] = {wavy(r, dimension, true, 0), wavy(r, dimension, round % 3 == 0, 300)};
    bat_shape *shape = levels_of(curves[1], 1 + round % 3, (bat_frame_rule)(round / 2 % 3));
    if (round % 4 == 1) assert_int_equal(bat_shape_set_gain(shape, 1, 1.5), BAT_OK);
    if (round % 4 == 2) assert_int_equal(bat_shape_set_muted(shape, 1, true), BAT_OK);
    bat_object *path = NULL, *object = NULL;
    assert_int_equal(bat_object_create_path(5, "fin", &style, 2, curves, &path), BAT_OK);
    assert_int_equal(bat_object_with_shape(path, 1, shape, &object), BAT_OK);
    bat_object_release(path);
    return object;
}

static void its_curve_is_the_finest(void **state) {
    (void)state;
    random_source r = {1};
    for (int round = 0; round < 24; round++) {
        bat_object *object = make(&r, round), *copy = NULL, *path = NULL, *other = NULL, *third = NULL;
        assert_int_equal(bat_object_kind(object), BAT_KIND_SHAPE);
        assert_null(bat_object_shape(object, 0));
        assert_null(bat_object_shape(object, 2));
        assert_ptr_equal(bat_object_curve(object, 1), shape_finest(bat_object_shape(object, 1)));
        bat_style style = bat_style_defaults();
        assert_int_equal(bat_object_with_style(object, &style, &copy), BAT_OK);
        assert_ptr_equal(bat_object_shape(copy, 1), bat_object_shape(object, 1));
        /* The curve beside it can change; another in its place is plain. */
        bat_curve *curve = wavy(&r, 2 + round % 2, true, 0);
        assert_int_equal(bat_object_with_curve(object, 0, curve, &other), BAT_OK);
        assert_int_equal(bat_object_kind(other), BAT_KIND_SHAPE);
        curve = wavy(&r, 2 + round % 2, true, 0);
        assert_int_equal(bat_object_with_curve(object, 1, curve, &third), BAT_OK);
        assert_int_equal(bat_object_kind(third), BAT_KIND_PATH);
        assert_int_equal(bat_object_to_path(object, &path), BAT_OK);
        assert_int_equal(bat_object_kind(path), BAT_KIND_PATH);
        assert_true(bat_curve_is_equal(bat_object_curve(path, 1), bat_object_curve(object, 1)));
        assert_string_equal(bat_object_name(path), "fin");
        assert_int_equal(bat_object_to_path(path, &third), BAT_ARGUMENT);
        assert_int_equal(bat_object_with_shape(path, 2, NULL, &third), BAT_ARGUMENT);
        bat_object_release(object); /* the others stand on their own */
        assert_true(bat_shape_levels(bat_object_shape(copy, 1)) >= 1);
        bat_object_release(copy);
        bat_object_release(path);
        bat_object_release(other);
        bat_object_release(third);
    }
}

static void round_trip(void **state) {
    (void)state;
    random_source r = {2};
    for (int round = 0; round < 24; round++) {
        bat_document *document = of_one(make(&r, round)), *again = NULL;
        char *text = NULL;
        size_t size = 0;
        bat_problem problem;
        assert_null(bat_document_check(document));
        assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
        assert_int_equal(bat_document_read(text, size, &again, &problem), BAT_OK);
        bat_free(text);
        assert_null(bat_document_check(again));
        assert_true(bat_document_digest(document) == bat_document_digest(again));
        const bat_object *a = bat_document_at(document, 0), *b = bat_document_at(again, 0);
        assert_true(bat_curve_is_equal(bat_object_curve(a, 1), bat_object_curve(b, 1)));
        bat_document_free(again);
        again = NULL;
        bat_svg_report report;
        assert_int_equal(bat_svg_write(document, true, &text, &size), BAT_OK);
        assert_int_equal(xml_read(text, NULL, &again, &report, &problem), BAT_OK);
        assert_true(bat_document_digest(document) == bat_document_digest(again));
        bat_free(text);
        bat_document_free(document);
        bat_document_free(again);
    }
}

/* Each of a shape's parts counts for the digest. */
static void digest_tells_apart(void **state) {
    (void)state;
    random_source r = {3};
    bat_curve *curve = wavy(&r, 2, false, 0);
    uint64_t digests[7];
    for (int i = 0; i < 7; i++) {
        bat_shape *shape = levels_of(curve, i == 1 ? 1 : 2, i == 2 ? BAT_FRAMES_FIXED : BAT_FRAMES_RMF);
        if (i == 3) assert_int_equal(bat_shape_set_gain(shape, 2, 0.5), BAT_OK);
        if (i == 4) assert_int_equal(bat_shape_set_muted(shape, 2, true), BAT_OK);
        if (i == 5) assert_int_equal(bat_shape_move(shape, 2, 3, (double[]){1, 0}), BAT_OK);
        bat_curve *copy = NULL;
        bat_style style = bat_style_defaults();
        bat_object *path = NULL, *object = NULL;
        assert_int_equal(bat_curve_copy(curve, &copy), BAT_OK);
        assert_int_equal(bat_object_create_path(5, "", &style, 1, &copy, &path), BAT_OK);
        assert_int_equal(bat_object_with_shape(path, 0, shape, &object), BAT_OK);
        bat_document *document = of_one(i == 6 ? path : object);
        digests[i] = bat_document_digest(document);
        for (int j = 0; j < i; j++) assert_true(digests[i] != digests[j]);
        bat_object_release(i == 6 ? object : path);
        bat_document_free(document);
    }
    bat_curve_free(curve);
}

static void images_keep_levels(void **state) {
    (void)state;
    random_source r = {4};
    for (int round = 0; round < 24; round++) {
        bat_object *object = make(&r, round), *image = NULL;
        double matrix[6], about[2] = {10, 20};
        switch (round % 5) {
        case 0: bat_matrix_translation(31, -7, matrix); break;
        case 1: bat_matrix_rotation(0.7, about, matrix); break;
        case 2: bat_matrix_scaling(-2, 2, about, matrix); break;
        case 3: bat_matrix_scaling(3, 0.5, about, matrix); break;
        default: memcpy(matrix, (double[]){1, 0.3, 0.9, -1, 4, 5}, sizeof matrix);
        }
        assert_int_equal(bat_affine_object(object, matrix, false, &image), BAT_OK);
        const bat_shape *before = bat_object_shape(object, 1), *after = bat_object_shape(image, 1);
        assert_non_null(after);
        assert_int_equal(bat_shape_levels(before), bat_shape_levels(after));
        for (int l = 0; l <= bat_shape_levels(before); l++) {
            const bat_curve *a = bat_shape_curve(before, l), *b = bat_shape_curve(after, l);
            int n = bat_curve_dimension(a);
            for (int i = 0; i < bat_point_count(a); i++) {
                const double *p = bat_curve_points(a) + i * n, *q = bat_curve_points(b) + i * n;
                assert_true(fabs(matrix[0] * p[0] + matrix[2] * p[1] + matrix[4] - q[0]) < 1e-9);
                assert_true(fabs(matrix[1] * p[0] + matrix[3] * p[1] + matrix[5] - q[1]) < 1e-9);
                if (n == 3) assert_true(fabs(p[2] - q[2]) < 1e-9);
            }
        }
        bat_object_release(image);
        image = NULL;
        memcpy(matrix, (double[]){1, 1, 1, 1, 0, 0},
               sizeof matrix); /* flattened: a plain curve, or no image */
        if (bat_affine_object(object, matrix, false, &image) == BAT_OK) {
            bat_document *document = of_one(image);
            assert_null(bat_document_check(document));
            bat_document_free(document);
        }
        bat_object_release(object);
    }
}

static void others_are_refused(void **state) {
    (void)state;
#define BASE "{\"base\":{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0],[9,0]]}"
    static const char *const texts[] = {
        "{\"id\":1,\"kind\":\"shape\"}",
        "{\"id\":1,\"kind\":\"shape\",\"curves\":[]}",
        "{\"id\":1,\"kind\":\"shape\",\"curves\":[{\"base\":7}]}",
        "{\"id\":1,\"kind\":\"path\",\"curves\":[" BASE "}]}",
        "{\"id\":1,\"kind\":\"shape\",\"curves\":[{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0],[9,0]]}"
        "]}",
        "{\"id\":1,\"kind\":\"shape\",\"curves\":[" BASE ",\"levels\":[{\"knots\":[0,0,2,2]}]}]}",
        "{\"id\":1,\"kind\":\"shape\",\"curves\":[" BASE ",\"levels\":[{\"muted\":1}]}]}",
        "{\"id\":1,\"kind\":\"shape\",\"curves\":[" BASE ",\"levels\":[{\"gain\":1e9}]}]}",
        "{\"id\":1,\"kind\":\"shape\",\"curves\":[" BASE
        "},{\"degree\":1,\"knots\":[0,0,1,1],\"points\":[[0,0,0],[9,0,0]]}]}",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) object_refused(texts[i]);
}

static void memory_may_end_anywhere(void **state) {
    (void)state;
    random_source r = {5};
    bat_object *object = make(&r, 2);
    bat_document *document = of_one(bat_object_retain(object));
    char *text = NULL;
    size_t size = 0;
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    double matrix[6] = {1, 0.25, 0, 2, 3, 4};
    long before = alloc_live();
    for (int n = 1;; n++) {
        bat_document *again = NULL;
        bat_object *image = NULL, *path = NULL;
        alloc_fail_at(n);
        bat_status status = bat_document_read(text, size, &again, NULL);
        if (status == BAT_OK) status = bat_affine_object(object, matrix, false, &image);
        if (status == BAT_OK) status = bat_object_to_path(object, &path);
        alloc_fail_at(0);
        bat_document_free(again);
        bat_object_release(image);
        bat_object_release(path);
        assert_int_equal(alloc_live(), before);
        if (status == BAT_OK) break;
        assert_int_equal(status, BAT_MEMORY);
    }
    bat_free(text);
    bat_document_free(document);
    bat_object_release(object);
}

/* What takes curves or levels over takes them whatever it returns: nothing is left, whichever allocation fails. */
static void taken_over_in_any_case(void **state) {
    (void)state;
    random_source r = {8};
    const bat_style style = bat_style_defaults();
    bat_curve *first = wavy(&r, 2, true, 0);
    bat_object *path = NULL;
    assert_int_equal(bat_object_create_path(5, "fin", &style, 1, &first, &path), BAT_OK);
    for (int what = 0; what < 4; what++)
        for (int n = 1, done = 0; !done; n++) {
            const long before = alloc_live();
            bat_curve *curves[2] = {wavy(&r, 2, true, 0), wavy(&r, 2, true, 0)};
            bat_shape *shape = NULL;
            bat_object *made = NULL;
            assert_int_equal(bat_shape_decompose(curves[1], 1, NULL, &shape), BAT_OK);
            alloc_fail_at(n);
            bat_status status = what == 0   ? bat_object_create_path(7, "two", &style, 2, curves, &made)
                                : what == 1 ? bat_object_with_curves(path, 2, curves, &made)
                                : what == 2 ? bat_object_with_curve(path, 0, curves[0], &made)
                                            : bat_object_with_shape(path, 0, shape, &made);
            done = !alloc_fail_reached();
            assert_int_equal(status, done ? BAT_OK : BAT_MEMORY);
            if (what != 3) bat_shape_free(shape);
            if (what == 3) bat_curve_free(curves[0]);
            if (what >= 2) bat_curve_free(curves[1]);
            bat_object_release(made);
            assert_true(alloc_live() == before);
        }
    bat_object_release(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(taken_over_in_any_case),
        cmocka_unit_test(its_curve_is_the_finest),
        cmocka_unit_test(round_trip),
        cmocka_unit_test(digest_tells_apart),
        cmocka_unit_test(images_keep_levels),
        cmocka_unit_test(others_are_refused),
        cmocka_unit_test(memory_may_end_anywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
