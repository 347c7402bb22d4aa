/* Surfaces with levels as objects: the surface is their finest; they move with the page level by level, are read from both
 * formats bit for bit, and lose their levels with another surface. */
#include "document/document.h"
#include "editor/edit/affine.h"

#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/relief.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support/alloc_fail.h"
#include "support/objects.h"
#include "support/random_surface.h"
#include "support/xml.h"

static bat_relief *carved(int number) {
    random_source r = {9};
    bat_surface *surface = NULL;
    bat_relief *relief = NULL;
    for (int k = 0; k <= number; k++) { /* with inner knots enough for two levels */
        bat_surface_free(surface);
        surface = random_surface(&r, (const int[2]){3, 2}, (const int[2]){2 * (k % 2), k % 3},
                                 (const int[2]){8, 6});
    }
    assert_int_equal(bat_relief_decompose(surface, 2, &relief), BAT_OK);
    assert_int_equal(bat_relief_set_gain(relief, 2, 1.25), BAT_OK);
    assert_int_equal(bat_relief_set_muted(relief, 1, number == 1), BAT_OK);
    bat_surface_free(surface);
    return relief;
}

static bat_object *plain_of(const bat_surface *surface) {
    const bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_surface(4, "jug", &style, surface, &object), BAT_OK);
    return object;
}

static bat_object *object_of(const bat_relief *relief) {
    bat_object *plain = plain_of(bat_relief_surface(relief, 0)), *object = NULL;
    assert_int_equal(bat_object_with_relief(plain, relief, &object), BAT_OK);
    bat_object_release(plain);
    return object;
}

static const bat_surface *finest(const bat_relief *r) { return bat_relief_surface(r, bat_relief_levels(r)); }

static void its_surface_is_the_finest(void **state) {
    (void)state;
    for (int number = 0; number < 6; number++) {
        bat_relief *relief = carved(number);
        bat_object *object = object_of(relief), *other = NULL;
        assert_true(bat_surface_is_equal(bat_object_surface(object), finest(relief)));
        assert_int_equal(bat_relief_levels(bat_object_relief(object)), 2);
        assert_string_equal(bat_object_name(object), "jug");
        assert_null(bat_object_check(object));
        assert_null(bat_object_recipe(object));
        assert_int_equal(bat_object_with_surface(object, finest(relief), &other), BAT_OK); /* flattened */
        assert_null(bat_object_relief(other));
        assert_true(bat_surface_is_equal(bat_object_surface(other), finest(relief)));
        bat_object_release(other);
        bat_object_release(object);
        bat_relief_free(relief);
    }
}

/* The digest tells levels from their surface, and one gain from another where nothing else differs. */
static void digests_differ(void **state) {
    (void)state;
    bat_relief *relief = carved(1), *louder = NULL;
    assert_int_equal(bat_relief_copy(relief, &louder), BAT_OK);
    assert_int_equal(bat_relief_set_gain(louder, 1, .5), BAT_OK); /* it is muted: the surface is the same */
    assert_true(bat_surface_is_equal(finest(relief), finest(louder)));
    bat_document *documents[3] = {of_one(object_of(relief)), of_one(object_of(louder)),
                                  of_one(plain_of(finest(relief)))};
    uint64_t digest[3];
    for (int k = 0; k < 3; k++) digest[k] = bat_document_digest(documents[k]);
    assert_true(digest[0] != digest[1] && digest[1] != digest[2] && digest[0] != digest[2]);
    for (int k = 0; k < 3; k++) bat_document_free(documents[k]);
    bat_relief_free(relief), bat_relief_free(louder);
}

static void moves_with_the_page(void **state) {
    (void)state;
    const double turn[6] = {0, 2, -2, 0, 10, 20}, rows[12] = {0, -2, 0, 10, 2, 0, 0, 20, 0, 0, 1, 0};
    bat_relief *relief = carved(0);
    bat_object *object = object_of(relief), *moved = NULL;
    assert_int_equal(bat_affine_object(object, turn, true, &moved), BAT_OK);
    const bat_relief *after = bat_object_relief(moved);
    assert_int_equal(bat_relief_levels(after), 2);
    for (int j = 0; j <= 2; j++) {
        bat_surface *image = NULL;
        assert_int_equal(bat_surface_transform(bat_relief_surface(relief, j), rows, &image), BAT_OK);
        for (int i = 0; i < (int)bat_surface_count(image, BAT_U); i++) {
            const double *p = bat_surface_row(image, i),
                         *q = bat_surface_row(bat_relief_surface(after, j), i);
            for (size_t k = 0; k < 3 * bat_surface_count(image, BAT_V); k++)
                assert_true(fabs(p[k] - q[k]) < 1e-11);
        }
        bat_surface_free(image);
    }
    assert_null(bat_object_check(moved));
    bat_object_release(moved);
    assert_int_equal(bat_affine_object(object, (const double[6]){1e300, 0, 0, 1, 0, 0}, true, &moved),
                     BAT_NUMBER);
    bat_object_release(object);
    bat_relief_free(relief);
}

/* Files that hold one are of version 6. */
static void files(void **state) {
    (void)state;
    for (int number = 0; number < 6; number++) {
        bat_relief *relief = carved(number);
        bat_document *document = of_one(object_of(relief)), *back = NULL;
        for (int svg = 0; svg < 2; svg++) {
            bat_svg_report report;
            bat_problem problem;
            char *text;
            size_t size;
            assert_int_equal(svg ? bat_svg_write(document, true, &text, &size)
                                 : bat_document_write(document, &text, &size),
                             BAT_OK);
            assert_non_null(strstr(text, svg ? "{&quot;batten&quot;:6," : "{\"batten\":6,"));
            assert_int_equal(svg ? xml_read(text, NULL, &back, &report, &problem)
                                 : bat_document_read(text, size, &back, &problem),
                             BAT_OK);
            const bat_relief *read = bat_object_relief(bat_document_at(back, 0));
            assert_non_null(read);
            for (int j = 0; j <= 2; j++)
                assert_true(bat_surface_is_equal(bat_relief_surface(read, j), bat_relief_surface(relief, j)));
            assert_true(bat_document_digest(back) == bat_document_digest(document));
            bat_document_free(back);
            bat_free(text);
        }
        bat_document_free(document);
        bat_relief_free(relief);
    }
    object_refused("{\"id\":1,\"kind\":\"surface\",\"relief\":3}");
    object_refused("{\"id\":1,\"kind\":\"surface\",\"relief\":{\"base\":{}}}");
    object_refused(
        "{\"id\":1,\"kind\":\"surface\",\"surface\":{\"degree\":[1,1],\"knots\":[[0,0,1,1],[0,0,1,1]],"
        "\"points\":[[[1,1,1],[1,2,1]],[[2,1,1],[1,1,1]]]},\"relief\":{\"base\":{\"degree\":[1,1],\"knots\":["
        "[0,0,1,1],[0,0,1,1]],\"points\":[[[1,1,1],[1,2,1]],[[2,1,1],[1,1,1]]]}}}");
}

static void refusals(void **state) {
    (void)state;
    bat_relief *relief = carved(0);
    bat_object *out = NULL, *guide = NULL, *object = object_of(relief);
    assert_int_equal(bat_object_create_guide(3, 0, 1, &guide), BAT_OK);
    assert_int_equal(bat_object_with_relief(guide, relief, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_relief(NULL, relief, &out), BAT_ARGUMENT);
    assert_int_equal(bat_object_with_relief(object, NULL, &out), BAT_ARGUMENT);
    assert_null(bat_object_relief(guide));
    assert_null(out);
    bat_object_release(guide), bat_object_release(object);
    bat_relief_free(relief);
}

static bat_status make(int way, const bat_object *object, const bat_relief *relief, bat_object **out) {
    if (way == 0) return bat_object_with_relief(object, relief, out);
    return bat_affine_object(object, (const double[6]){0, 2, -2, 0, 10, 20}, true, out);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    bat_relief *relief = carved(2);
    bat_object *object = object_of(relief);
    for (int way = 0; way < 2; way++) {
        bool reached = true;
        for (long n = 1; reached; n++) {
            const long before = alloc_live();
            bat_object *out = NULL;
            alloc_fail_at(n);
            const bat_status status = make(way, object, relief, &out);
            reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            assert_true(reached == !out);
            if (out) assert_null(bat_object_check(out));
            bat_object_release(out);
            assert_int_equal(alloc_live(), before);
        }
    }
    bat_object_release(object);
    bat_relief_free(relief);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(its_surface_is_the_finest),
                                       cmocka_unit_test(digests_differ),
                                       cmocka_unit_test(moves_with_the_page),
                                       cmocka_unit_test(files),
                                       cmocka_unit_test(refusals),
                                       cmocka_unit_test(every_allocation_may_fail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
