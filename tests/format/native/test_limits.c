/* Documents at the limits: everything that the library accepts is written and read back the same; anything beyond a
 * limit is refused by both the call and the reader. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/levels.h>
#include "document/nesting.h"
#include "support/pictures.h"

/* Takes the object over. */
static void put(bat_document *document, bat_object *object) {
    assert_int_equal(bat_document_insert(document, bat_document_count(document), object), BAT_OK);
    bat_object_release(object);
}

static bat_curve *line(double from, double to, double knot) {
    const double knots[] = {-knot, -knot, knot, knot}, points[] = {from, from, to, to};
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_create(2, 1, false, 2, points, 4, knots, &curve), BAT_OK);
    return curve;
}

static bat_object *path(bat_id id, const char *name, const bat_style *style, bat_curve *curve) {
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_path(id, name, style, 1, &curve, &object), BAT_OK);
    return object;
}

static bat_object *guide(bat_id id) {
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_guide(id, 0, 1, &object), BAT_OK);
    return object;
}

/* The same after writing and reading, in the native format and in the SVG that holds it. */
static void assert_survives(const bat_document *document) {
    bat_problem problem = {"", ""};
    bat_document *back = NULL;
    char *text, *again;
    size_t size, size_again;
    assert_null(bat_document_check(document));
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    if (bat_document_read(text, size, &back, &problem) != BAT_OK)
        fail_msg("%s: %s", problem.place, problem.message);
    assert_null(bat_document_check(back));
    assert_true(bat_document_digest(back) == bat_document_digest(document));
    assert_int_equal(bat_document_write(back, &again, &size_again), BAT_OK);
    assert_string_equal(text, again); /* the next id, too */
    bat_document_free(back);
    bat_free(text);
    bat_free(again);
}

static void ids_up_to_the_limit(void **state) {
    (void)state;
    static const bat_id ids[] = {1, 1u << 30, BAT_ID_MAX - 1, BAT_ID_MAX};
    for (size_t i = 0; i < sizeof ids / sizeof *ids; i++) {
        bat_document *document;
        bat_object *object = NULL, *in = NULL;
        assert_int_equal(bat_document_create(&document), BAT_OK);
        assert_int_equal(bat_object_create_group(ids[i], "g", false, &object), BAT_OK);
        put(document, object);
        object = guide(ids[i] == 1 ? 2 : ids[i] - 1);
        assert_int_equal(bat_object_with_parent(object, ids[i], &in), BAT_OK);
        bat_object_release(object);
        put(document, in);
        assert_survives(document);
        bat_document_free(document);
    }
}

static void ids_beyond_are_refused_everywhere(void **state) {
    (void)state;
    static const bat_id ids[] = {BAT_ID_MAX + 1,  3000000000u, (bat_id)1 << 32,
                                 (bat_id)1 << 53, UINT64_MAX,  0};
    bat_style style = bat_style_defaults();
    bat_object *small = guide(1);
    for (size_t i = 0; i < sizeof ids / sizeof *ids; i++) {
        bat_object *object = NULL;
        bat_document *document = NULL;
        bat_problem problem;
        char text[160];
        assert_int_equal(
            bat_object_create_path(ids[i], "", &style, 1, (bat_curve *[]){line(0, 1, 1)}, &object),
            BAT_ARGUMENT);
        assert_int_equal(bat_object_create_group(ids[i], "", true, &object), BAT_ARGUMENT);
        assert_int_equal(bat_object_create_guide(ids[i], 0, 1, &object), BAT_ARGUMENT);
        assert_int_equal(bat_object_with_id(small, ids[i], &object), BAT_ARGUMENT);
        if (ids[i]) assert_int_equal(bat_object_with_parent(small, ids[i], &object), BAT_ARGUMENT);
        snprintf(text, sizeof text, "{\"batten\":1,\"objects\":[{\"id\":%llu,\"kind\":\"guide\",\"x\":1}]}",
                 (unsigned long long)ids[i]);
        assert_int_equal(bat_document_read(text, strlen(text), &document, &problem), BAT_SYNTAX);
        snprintf(text, sizeof text, "{\"batten\":1,\"next\":%llu,\"objects\":[]}",
                 (unsigned long long)(ids[i] ? ids[i] + 1 : 0));
        if (ids[i] != UINT64_MAX && ids[i] != BAT_ID_MAX)
            assert_int_equal(bat_document_read(text, strlen(text), &document, &problem), BAT_SYNTAX);
        assert_null(object);
        assert_null(document);
    }
    bat_object_release(small);
}

/* The last id given, no other one is: 0 is no id, and no object can be made with it. */
static void ids_run_out(void **state) {
    (void)state;
    bat_document *document, *back = NULL;
    bat_object *object = NULL;
    bat_problem problem;
    static const char text[] = "{\"batten\":1,\"next\":2147483647,\"objects\":[]}";
    assert_int_equal(bat_document_read(text, sizeof text - 1, &document, &problem), BAT_OK);
    assert_true(bat_document_new_id(document) == BAT_ID_MAX);
    put(document, guide(BAT_ID_MAX));
    for (int i = 0; i < 3; i++) assert_true(bat_document_new_id(document) == 0);
    assert_int_equal(bat_object_create_guide(bat_document_new_id(document), 0, 1, &object), BAT_ARGUMENT);
    assert_survives(document);
    assert_int_equal(bat_document_copy(document, &back), BAT_OK);
    assert_true(bat_document_new_id(back) == 0);
    bat_document_free(back);
    bat_document_free(document);
}

static void numbers_at_the_limits(void **state) {
    (void)state;
    static const double corner[4] = {-BAT_COORDINATE_MAX, BAT_COORDINATE_MAX, BAT_COORDINATE_MAX,
                                     BAT_COORDINATE_MAX};
    bat_style style = bat_style_defaults(), none = {.miter_limit = 1};
    style.width = style.miter_limit = BAT_COORDINATE_MAX;
    style.stroke = style.fill = UINT32_MAX;
    style.cap = BAT_CAP_SQUARE, style.join = BAT_JOIN_BEVEL;
    style.filled = style.even_odd = true;
    bat_document *document;
    bat_object *object = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_document_set_page(document, corner), BAT_OK);
    put(document, path(1, "", &style, line(-BAT_COORDINATE_MAX, BAT_COORDINATE_MAX, BAT_KNOT_MAX)));
    put(document, path(2, "", &none, line(0, 5e-324, BAT_SPAN_MIN)));
    assert_int_equal(bat_object_create_guide(3, 1, -BAT_COORDINATE_MAX, &object), BAT_OK);
    put(document, object);
    const double points[] = {0, 0, 1e75, -1e75, 0, 1}, tension[] = {0, 1e6, 1e6, 0, 1, 1};
    bat_spline spline = {.dimension = 2, .count = 3, .points = points, .tension = tension};
    bat_status status = bat_object_create_spline(4, "", &style, &spline, NULL, &object);
    if (status == BAT_OK) put(document, object); /* its curve may overflow: that is refused at once */
    bat_picture *picture = make_picture(BAT_PICTURE_SIDE, 1, 7);
    const double matrix[6] = {1e70, 0, 0, 1e70, -1e75, 0};
    assert_int_equal(bat_object_create_image(5, "", picture, matrix, 0, &object), BAT_OK);
    put(document, object);
    bat_picture_release(picture);
    assert_survives(document);
    bat_document_free(document);
}

/* 64 groups in each other, and levels up to their limit. */
static void depth_at_the_limit(void **state) {
    (void)state;
    bat_document *document;
    bat_object *object = NULL, *in = NULL;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    for (bat_id id = 1; id <= BAT_NESTING_MAX; id++) {
        assert_int_equal(bat_object_create_group(id, "", false, &object), BAT_OK);
        if (id > 1) {
            assert_int_equal(bat_object_with_parent(object, id - 1, &in), BAT_OK);
            bat_object_release(object);
            object = in;
        }
        put(document, object);
    }
    bat_shape *shape = NULL;
    bat_curve *base = line(0, 1, 1);
    assert_int_equal(bat_shape_create(base, NULL, &shape), BAT_OK);
    int levels = 0;
    while (levels < 12 && bat_shape_add_level(shape, 0, NULL, NULL, NULL) == BAT_OK) levels++;
    assert_int_equal(bat_shape_set_gain(shape, 1, -1e6), BAT_OK);
    bat_style style = bat_style_defaults();
    bat_object *plain = path(BAT_NESTING_MAX + 1, "", &style, base);
    assert_int_equal(bat_object_with_shape(plain, 0, shape, &object), BAT_OK);
    bat_object_release(plain);
    assert_int_equal(bat_object_with_parent(object, BAT_NESTING_MAX, &in), BAT_OK);
    bat_object_release(object);
    put(document, in);
    assert_survives(document);
    bat_document_free(document);
}

static void names_of_any_kind(void **state) {
    (void)state;
    enum { LONG = 1 << 20 };
    char *name = malloc(LONG + 1);
    memset(name, '"', LONG);
    name[LONG] = 0;
    static const char *const names[] = {"\x01\x1f\x7f", "\xf4\x8f\xbf\xbf\xef\xbf\xbf", "]]>&<!--\\u0000",
                                        "\n\r\t"};
    bat_document *document;
    bat_style style = bat_style_defaults();
    assert_int_equal(bat_document_create(&document), BAT_OK);
    put(document, path(1, name, &style, line(0, 1, 1)));
    for (bat_id i = 0; i < 4; i++) put(document, path(2 + i, names[i], &style, line(0, 1, 1)));
    assert_survives(document);
    bat_document_free(document);
    free(name);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ids_up_to_the_limit), cmocka_unit_test(ids_beyond_are_refused_everywhere),
        cmocka_unit_test(ids_run_out),         cmocka_unit_test(numbers_at_the_limits),
        cmocka_unit_test(depth_at_the_limit),  cmocka_unit_test(names_of_any_kind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
