/* Planes in space: their axes are perpendicular however they are given, they move with the page, and are read from
 * files bit for bit; a plane is neither drawn nor selectable. */
#include "editor/edit/affine.h"

#include <batten/bezier.h>
#include <batten/format.h>

#include "support/random_curve.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void right_angles(void **unused) {
    (void)unused;
    random_source r = {3};
    for (int run = 0; run < 500; run++) {
        double origin[3], axes[6], scale = pow(10, random_between(&r, -60, 60));
        bat_object *object = NULL, *again = NULL;
        for (int i = 0; i < 3; i++) origin[i] = random_between(&r, -100, 100);
        for (int i = 0; i < 6; i++) axes[i] = scale * random_between(&r, -1, 1);
        assert_int_equal(bat_object_create_plane(1, "p", origin, axes, &object), BAT_OK);
        const double *f = bat_object_plane(object), *x = f + 3, *y = f + 6;
        assert_memory_equal(f, origin, sizeof origin);
        assert_true(fabs(dot(x, x) - 1) < 1e-14 && fabs(dot(y, y) - 1) < 1e-14 && fabs(dot(x, y)) < 1e-14);
        assert_true(dot(x, axes) > 0 && dot(y, axes + 3) > 0);
        assert_true(fabs(dot(x, axes) - sqrt(dot(axes, axes))) <= 1e-13 * scale); /* x keeps its direction */
        assert_int_equal(bat_object_create_plane(1, "p", f, x, &again), BAT_OK);  /* and stays what it is */
        assert_memory_equal(bat_object_plane(again), f, 9 * sizeof *f);
        bat_object_release(object);
        bat_object_release(again);
    }
}

static void refusals(void **unused) {
    (void)unused;
    const double zero[3] = {0}, good[6] = {1, 0, 0, 0, 1, 0};
    const double parallel[6] = {1, 2, 3, -2, -4, -6}, none[6] = {0, 0, 0, 0, 1, 0},
                 wild[6] = {1, 0, 0, 0, NAN, 0};
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_plane(1, "", zero, parallel, &object), BAT_SINGULAR);
    assert_int_equal(bat_object_create_plane(1, "", zero, none, &object), BAT_SINGULAR);
    assert_int_equal(bat_object_create_plane(1, "", zero, wild, &object), BAT_NUMBER);
    assert_int_equal(bat_object_create_plane(1, "", (double[]){INFINITY, 0, 0}, good, &object), BAT_NUMBER);
    assert_int_equal(bat_object_create_plane(0, "", zero, good, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_plane(1, "", NULL, good, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_plane(1, "", zero, good, NULL), BAT_ARGUMENT);
    assert_null(object);
}

static void moves_with_the_page(void **unused) {
    (void)unused;
    const double origin[3] = {1, 2, 3}, axes[6] = {1, 0, 0, 0, 0.6, 0.8}, turn[6] = {0, 2, -2, 0, 10, 20};
    bat_object *object = NULL, *moved = NULL;
    assert_int_equal(bat_object_create_plane(1, "p", origin, axes, &object), BAT_OK);
    assert_false(bat_object_is_drawn(object) || bat_object_is_group(object));
    assert_int_equal(bat_affine_object(object, turn, true, &moved), BAT_OK);
    const double *f = bat_object_plane(moved);
    assert_true(f[0] == 6 && f[1] == 22 && f[2] == 3);
    assert_true(f[3] == 0 && f[4] == 1 && f[5] == 0);
    assert_true(f[6] < 0 && f[7] == 0 && f[8] > 0);
    bat_object_release(moved);
    assert_int_equal(bat_affine_object(object, (double[]){0, 0, 0, 0, 0, 0}, true, &moved), BAT_SINGULAR);
    bat_object_release(object);
}

static void files(void **unused) {
    (void)unused;
    static const char wrong[] = "{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"plane\",\"origin\":[0,0,0],"
                                "\"axes\":[1,0,0,2,0,0]}]}";
    const double origin[3] = {0.1, -7, 1e-30}, axes[6] = {1, 2, 3, 3, 2, 1};
    bat_document *document = NULL, *back = NULL;
    bat_object *object = NULL;
    bat_problem problem;
    char *text;
    size_t size;
    assert_int_equal(bat_document_create(&document), BAT_OK);
    assert_int_equal(bat_object_create_plane(4, "tilted", origin, axes, &object), BAT_OK);
    assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
    assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
    assert_int_equal(bat_document_read(text, size, &back, &problem), BAT_OK);
    assert_memory_equal(bat_object_plane(bat_document_at(back, 0)), bat_object_plane(object),
                        9 * sizeof(double));
    assert_true(bat_document_digest(back) == bat_document_digest(document));
    assert_null(bat_document_check(back));
    assert_int_equal(bat_document_read(wrong, sizeof wrong - 1, &back, &problem), BAT_SINGULAR);
    assert_non_null(strstr(problem.message, "axes: expected two directions that span a plane"));
    bat_free(text);
    bat_object_release(object);
    bat_document_free(document);
    bat_document_free(back);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(right_angles), cmocka_unit_test(refusals),
                                       cmocka_unit_test(moves_with_the_page), cmocka_unit_test(files)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
