/* The document: objects are shared and reference-counted, changes keep the invariants, the digest tells documents
 * apart. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/document.h>
#include "document/document.h"
#include "support/random_curve.h"

static bat_object *make_object(random_source *r, bat_id id, const char *name, int curves) {
    bat_curve *list[8];
    bat_style style = bat_style_defaults();
    for (int i = 0; i < curves; i++) list[i] = random_curve(r, 3, 2, i % 3, 4);
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_path(id, name, &style, curves, list, &object), BAT_OK);
    return object;
}

static void object_keeps_what_it_was_given(void **state) {
    (void)state;
    random_source r = {1};
    bat_curve *curve = random_curve(&r, 5, 3, 0, 3);
    bat_style style = bat_style_defaults();
    style.width = 7;
    bat_object *object;
    assert_int_equal(bat_object_create_path(9, "r\xc3\xb6hre", &style, 1, &curve, &object), BAT_OK);
    assert_true(bat_object_id(object) == 9);
    assert_string_equal(bat_object_name(object), "r\xc3\xb6hre");
    assert_true(bat_object_style(object)->width == 7);
    assert_ptr_equal(bat_object_curve(object, 0), curve);
    assert_null(bat_object_curve(object, 1));
    bat_object_release(object);
}

static void bad_objects_are_refused(void **state) {
    (void)state;
    random_source r = {2};
    bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    bat_curve *none = NULL;
    assert_int_equal(
        bat_object_create_path(0, "", &style, 1, (bat_curve *[]){random_curve(&r, 3, 2, 0, 0)}, &object),
        BAT_ARGUMENT);
    assert_int_equal(bat_object_create_path(BAT_ID_MAX + 1, "", &style, 1,
                                            (bat_curve *[]){random_curve(&r, 3, 2, 0, 0)}, &object),
                     BAT_ARGUMENT);
    assert_int_equal(
        bat_object_create_path(1, "", &style, 2,
                               (bat_curve *[]){random_curve(&r, 3, 2, 0, 0), random_curve(&r, 3, 3, 0, 0)},
                               &object),
        BAT_DIMENSION);
    assert_int_equal(bat_object_create_path(1, "", &style, 0, &none, &object), BAT_COUNT);
    assert_int_equal(
        bat_object_create_path(1, "\xc3(", &style, 1, (bat_curve *[]){random_curve(&r, 3, 2, 0, 0)}, &object),
        BAT_ARGUMENT);
    style.opacity = NAN;
    assert_int_equal(
        bat_object_create_path(1, "", &style, 1, (bat_curve *[]){random_curve(&r, 3, 2, 0, 0)}, &object),
        BAT_ARGUMENT);
    style = bat_style_defaults();
    style.width = -1;
    assert_int_equal(
        bat_object_create_path(1, "", &style, 1, (bat_curve *[]){random_curve(&r, 3, 2, 0, 0)}, &object),
        BAT_ARGUMENT);
    assert_null(object);
    /* What they were given is freed: nothing is left over. */
}

/* The box holds a thousand points of the curve and is touched by the curve (degree 1: the corners). */
static void bounds_hold_the_curve(void **state) {
    (void)state;
    random_source r = {3};
    for (int round = 0; round < 50; round++) {
        bat_object *object = make_object(&r, 1, "", 1 + round % 3);
        double box[4], p[2];
        bat_object_bounds(object, box);
        for (int i = 0; i < bat_object_curve_count(object); i++)
            for (int k = 0; k <= 300; k++) {
                const bat_curve *curve = bat_object_curve(object, i);
                double domain[2];
                bat_curve_domain(curve, domain);
                bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * k / 300, 0, p);
                for (int d = 0; d < 2; d++) assert_true(p[d] >= box[d] - 1e-12 && p[d] <= box[d + 2] + 1e-12);
            }
        bat_object_release(object);
    }
    double knots[] = {0, 0, 1, 2, 2}, points[] = {3, -1, -4, 8, 2, 2};
    bat_curve *line;
    assert_int_equal(bat_curve_create(2, 1, false, 3, points, 5, knots, &line), BAT_OK);
    bat_style style = bat_style_defaults();
    bat_object *object;
    assert_int_equal(bat_object_create_path(1, NULL, &style, 1, &line, &object), BAT_OK);
    double box[4], expected[4] = {-4, -1, 3, 8};
    bat_object_bounds(object, box);
    assert_memory_equal(box, expected, sizeof box);
    bat_object_release(object);
}

static void copies_share_what_stays(void **state) {
    (void)state;
    random_source r = {4};
    bat_object *object = make_object(&r, 5, "five", 3), *copy, *styled;
    bat_curve *other = random_curve(&r, 2, 2, 0, 5);
    assert_int_equal(bat_object_with_curve(object, 1, random_curve(&r, 2, 3, 0, 5), &copy), BAT_DIMENSION);
    assert_int_equal(bat_object_with_curve(object, 3, random_curve(&r, 2, 2, 0, 5), &copy), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_curve(object, 1, other, &copy), BAT_OK);
    assert_ptr_equal(bat_object_curve(copy, 0), bat_object_curve(object, 0));
    assert_ptr_equal(bat_object_curve(copy, 1), other);
    assert_ptr_not_equal(bat_object_curve(object, 1), other);
    bat_style style = bat_style_defaults();
    style.stroke = 0x123456ff;
    assert_int_equal(bat_object_with_style(copy, &style, &styled), BAT_OK);
    assert_ptr_equal(bat_object_curve(styled, 1), other);
    assert_true(bat_object_style(copy)->stroke == 0x000000ff);
    bat_object_release(object);
    bat_object_release(copy);
    assert_string_equal(bat_object_name(styled), "five"); /* still whole, with its curves */
    assert_int_equal(bat_curve_degree(bat_object_curve(styled, 1)), 2);
    bat_object_release(styled);
}

static void changes_and_refusals(void **state) {
    (void)state;
    random_source r = {5};
    bat_document *document;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_object *a = make_object(&r, bat_document_new_id(document), "a", 1);
    bat_object *b = make_object(&r, bat_document_new_id(document), "b", 2);
    bat_object *b2 = make_object(&r, bat_object_id(b), "b2", 1);
    uint64_t empty = bat_document_digest(document);
    assert_int_equal(bat_document_insert(document, 1, a), BAT_ARGUMENT);
    assert_int_equal(bat_document_insert(document, 0, a), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, a), BAT_ARGUMENT); /* the id is there */
    assert_int_equal(bat_document_insert(document, 0, b), BAT_OK);
    uint64_t two = bat_document_digest(document);
    assert_int_equal(bat_document_find(document, bat_object_id(a)), 1);
    assert_int_equal(bat_document_find(document, 77), -1);
    assert_int_equal(bat_document_replace(document, 1, b2), BAT_ARGUMENT); /* another id */
    assert_int_equal(bat_document_replace(document, 0, b2), BAT_OK);
    assert_true(bat_document_digest(document) != two);
    assert_null(bat_document_check(document));
    assert_int_equal(bat_document_replace(document, 0, b), BAT_OK);
    assert_true(bat_document_digest(document) == two);
    assert_int_equal(bat_document_remove(document, 0), BAT_OK);
    assert_int_equal(bat_document_remove(document, 1), BAT_ARGUMENT);
    assert_int_equal(bat_document_remove(document, 0), BAT_OK);
    assert_true(bat_document_digest(document) == empty);
    assert_true(bat_document_new_id(document) == 3); /* never given again */
    bat_object_release(a);
    bat_object_release(b);
    bat_object_release(b2);
    bat_document_free(document);
}

static void a_foreign_id_raises_the_next(void **state) {
    (void)state;
    random_source r = {6};
    bat_document *document;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_object *object = make_object(&r, 41, "", 1);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    assert_true(bat_document_new_id(document) == 42);
    assert_null(bat_document_check(document));
    bat_object_release(object);
    bat_document_free(document);
}

static void copy_is_apart(void **state) {
    (void)state;
    random_source r = {7};
    bat_document *document, *copy;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    for (int i = 0; i < 20; i++) {
        bat_object *object = make_object(&r, bat_document_new_id(document), "", 1);
        assert_int_equal(bat_document_insert(document, i / 2, object), BAT_OK);
        bat_object_release(object);
    }
    assert_int_equal(bat_document_copy(document, &copy), BAT_OK);
    uint64_t digest = bat_document_digest(copy);
    assert_true(digest == bat_document_digest(document));
    double page[4] = {0, 0, 100, 50}, bad[4] = {0, 0, -1, 5}, worse[4] = {NAN, 0, 1, 1};
    assert_int_equal(bat_document_set_page(document, bad), BAT_NUMBER);
    assert_int_equal(bat_document_set_page(document, worse), BAT_NUMBER);
    assert_int_equal(bat_document_set_page(document, page), BAT_OK);
    assert_true(bat_document_digest(document) != digest);
    bat_document_free(document);
    assert_true(bat_document_digest(copy) == digest);
    assert_null(bat_document_check(copy));
    assert_int_equal(bat_document_count(copy), 20);
    bat_document_free(copy);
}

/* Copies keep the size; the digest is that of before where none was said, and sees the scale and the unit where one was. */
static void sizes(void **state) {
    (void)state;
    bat_document *document, *copy;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    const double px = bat_document_scale(document), wrong[] = {0, -1, NAN, INFINITY, 1e13, 1e-13};
    const uint64_t none = bat_document_digest(document);
    assert_true(fabs(96 * px - 25.4) < 1e-12 && bat_document_unit(document) == BAT_UNIT_PX);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_int_equal(bat_document_set_scale(document, wrong[i], BAT_UNIT_MM), BAT_NUMBER);
    assert_int_equal(bat_document_set_scale(document, 1, (bat_unit)(BAT_UNIT_NONE + 1)), BAT_NUMBER);
    assert_int_equal(bat_document_set_scale(NULL, 1, BAT_UNIT_MM), BAT_ARGUMENT);
    assert_true(bat_document_digest(document) == none);
    assert_int_equal(bat_document_set_scale(document, 1, BAT_UNIT_NONE), BAT_OK); /* files do not say it */
    assert_true(bat_document_digest(document) == none);
    assert_int_equal(bat_document_set_scale(document, 1, BAT_UNIT_MM), BAT_OK);
    const uint64_t metric = bat_document_digest(document);
    assert_int_equal(bat_document_set_scale(document, 1, BAT_UNIT_CM), BAT_OK);
    assert_true(metric != none && bat_document_digest(document) != metric);
    assert_int_equal(bat_document_copy(document, &copy), BAT_OK);
    assert_true(bat_document_scale(copy) == 1 && bat_document_unit(copy) == BAT_UNIT_CM);
    assert_int_equal(bat_document_set_scale(document, px, BAT_UNIT_PX), BAT_OK);
    assert_true(bat_document_digest(document) == none);
    assert_null(bat_document_check(copy));
    bat_document_free(copy);
    bat_document_free(document);
}

static void fill_refuses_twins(void **state) {
    (void)state;
    random_source r = {8};
    bat_document *document;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    bat_object *list[3] = {make_object(&r, 9, "", 1), make_object(&r, 3, "", 1), make_object(&r, 9, "", 1)};
    assert_int_equal(bat_document_fill(document, 3, list), BAT_ARGUMENT);
    assert_int_equal(bat_document_count(document), 0);
    assert_int_equal(bat_document_fill(document, 2, list), BAT_OK);
    assert_int_equal(bat_document_find(document, 3), 1);
    assert_null(bat_document_check(document));
    bat_object_release(list[2]);
    bat_document_free(document);
}

/* One bit of one number, or a zero's sign, changes the digest. */
static void digest_sees_every_bit(void **state) {
    (void)state;
    double knots[] = {0, 0, 1, 1}, points[] = {0, 0, 1, 1};
    uint64_t seen[5];
    for (int i = 0; i < 5; i++) {
        double p[4], k[4];
        memcpy(p, points, sizeof p);
        memcpy(k, knots, sizeof k);
        if (i == 1) p[2] = nextafter(1, 2);
        if (i == 2) p[0] = -0.0;
        if (i == 3) k[0] = nextafter(0, -1) * 1e300 * 1e20;
        bat_curve *curve;
        assert_int_equal(bat_curve_create(2, 1, false, 2, p, 4, k, &curve), BAT_OK);
        bat_document *document;
        bat_object *object;
        bat_style style = bat_style_defaults();
        assert_int_equal(bat_document_create(&document), BAT_OK);
        assert_int_equal(bat_object_create_path(1, i == 4 ? "x" : "", &style, 1, &curve, &object), BAT_OK);
        assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
        bat_object_release(object);
        seen[i] = bat_document_digest(document);
        bat_document_free(document);
        for (int j = 0; j < i; j++) assert_true(seen[i] != seen[j]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(object_keeps_what_it_was_given),
        cmocka_unit_test(bad_objects_are_refused),
        cmocka_unit_test(bounds_hold_the_curve),
        cmocka_unit_test(copies_share_what_stays),
        cmocka_unit_test(changes_and_refusals),
        cmocka_unit_test(a_foreign_id_raises_the_next),
        cmocka_unit_test(copy_is_apart),
        cmocka_unit_test(sizes),
        cmocka_unit_test(fill_refuses_twins),
        cmocka_unit_test(digest_sees_every_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
