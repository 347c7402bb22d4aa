/* Saved views: what is no view is refused, a view goes where the drawing goes, files keep every bit; a view is neither drawn
 * nor selectable. */
#include "editor/edit/affine.h"

#include <batten/bezier.h>
#include <batten/format.h>

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support/alloc_fail.h"
#include "support/views.h"

static bat_object *object_of(const bat_viewpoint *view) {
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_view(4, "from the left", view, &object), BAT_OK);
    return object;
}

static void assert_same(const bat_viewpoint *a, const bat_viewpoint *b) {
    assert_memory_equal(a->eye, b->eye, sizeof a->eye);
    assert_memory_equal(a->target, b->target, sizeof a->target);
    assert_memory_equal(a->up, b->up, sizeof a->up);
    assert_memory_equal(a->size, b->size, sizeof a->size);
    assert_true(a->fov == b->fov && a->height == b->height);
}

static void refusals(void **unused) {
    (void)unused;
    const bat_viewpoint good = {.eye = {0, 0, -5}, .up = {0, -1, 0}, .size = {40, 30}, .height = 9};
    bat_object *object = NULL;
    bat_viewpoint bad = good;
    bad.eye[2] = 0;
    assert_int_equal(bat_object_create_view(1, "", &bad, &object), BAT_SINGULAR);
    bad = good, bad.up[1] = 0, bad.up[2] = 3;
    assert_int_equal(bat_object_create_view(1, "", &bad, &object), BAT_SINGULAR);
    bad = good, bad.fov = 40;
    assert_int_equal(bat_object_create_view(1, "", &bad, &object), BAT_ARGUMENT);
    bad = good, bad.size[0] = 0;
    assert_int_equal(bat_object_create_view(1, "", &bad, &object), BAT_ARGUMENT);
    bad = good, bad.target[1] = NAN;
    assert_int_equal(bat_object_create_view(1, "", &bad, &object), BAT_NUMBER);
    assert_int_equal(bat_object_create_view(0, "", &good, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_view(1, "", NULL, &object), BAT_ARGUMENT);
    assert_int_equal(bat_object_create_view(1, "", &good, NULL), BAT_ARGUMENT);
    assert_null(object);
}

/* By a similarity of the page, with z unchanged only where it is neither larger nor smaller: what was seen at a pixel is
 * seen there. */
static void goes_with_the_page(void **unused) {
    (void)unused;
    random_source r = {11};
    for (int run = 0; run < 200; run++) {
        const bat_viewpoint view = some_view(&r, run, (double[]){10, 20, 5}, 100);
        const double a = random_between(&r, -3, 3), x = random_between(&r, -50, 50),
                     y = random_between(&r, -50, 50);
        const double m[6] = {cos(a), sin(a), -sin(a), cos(a), x, y};
        bat_object *object = object_of(&view), *moved = NULL;
        assert_false(bat_object_is_drawn(object) || bat_object_is_group(object));
        assert_int_equal(bat_affine_object(object, m, true, &moved), BAT_OK);
        const bat_viewpoint *image = bat_object_view(moved);
        for (int k = 0; k < 20; k++) {
            double at[3], was[2], is[2];
            for (int c = 0; c < 3; c++) at[c] = random_between(&r, -10, 10);
            const double to[3] = {m[0] * at[0] + m[2] * at[1] + x, m[1] * at[0] + m[3] * at[1] + y, at[2]};
            assert_int_equal(bat_viewpoint_project(&view, at, was, NULL),
                             bat_viewpoint_project(image, to, is, NULL));
            assert_true(hypot(was[0] - is[0], was[1] - is[1]) < 1e-8);
        }
        bat_object_release(moved);
        bat_object_release(object);
    }
    const bat_viewpoint above = {.eye = {0, 0, -5}, .up = {0, -1, 0}, .size = {40, 30}, .height = 9};
    bat_object *object = object_of(&above), *moved = NULL;
    assert_int_equal(bat_affine_object(object, (double[]){2, 0, 0, 2, 0, 0}, true, &moved), BAT_OK);
    assert_true(bat_object_view(moved)->height == 18); /* it shows as much as it did */
    bat_object_release(moved);
    moved = NULL;
    assert_int_equal(bat_affine_object(object, (double[]){0, 0, 0, 0, 0, 0}, true, &moved), BAT_ARGUMENT);
    assert_null(moved);
    bat_object_release(object);
}

static void files(void **unused) {
    (void)unused;
    static const char wrong[] =
        "{\"batten\":2,\"objects\":[{\"id\":1,\"kind\":\"view\",\"view\":{\"eye\":[0,0,1],"
        "\"target\":[0,0,0],\"up\":[0,0,1],\"size\":[4,3],\"fov\":40}}]}",
                      none[] = "{\"batten\":2,\"objects\":[{\"id\":1,\"kind\":\"view\"}]}";
    random_source r = {5};
    bat_document *back = NULL;
    bat_problem problem;
    for (int run = 0; run < 40; run++) {
        bat_document *document = NULL;
        char *text;
        size_t size;
        const bat_viewpoint view = some_view(&r, run, (double[]){1, -2, 1e-30}, 0.1);
        bat_object *object = object_of(&view);
        assert_int_equal(bat_document_create(&document), BAT_OK);
        assert_int_equal(bat_document_insert(document, 0, object), BAT_OK);
        assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
        assert_non_null(strstr(text, "{\"batten\":2,")); /* older programs refuse it */
        assert_int_equal(bat_document_read(text, size, &back, &problem), BAT_OK);
        assert_same(bat_object_view(bat_document_at(back, 0)), &view);
        assert_string_equal(bat_object_name(bat_document_at(back, 0)), "from the left");
        assert_true(bat_document_digest(back) == bat_document_digest(document));
        assert_null(bat_document_check(back));
        bat_free(text);
        bat_object_release(object);
        bat_document_free(document);
        bat_document_free(back);
        back = NULL;
    }
    assert_int_equal(bat_document_read(wrong, sizeof wrong - 1, &back, &problem), BAT_SINGULAR);
    assert_non_null(strstr(problem.message, "up: expected a direction at an angle to the gaze"));
    assert_int_equal(bat_document_read(none, sizeof none - 1, &back, &problem), BAT_SYNTAX);
    assert_non_null(strstr(problem.message, "view: expected an object"));
    assert_null(back);
}

/* Every number counts for the digest. */
static void digests(void **unused) {
    (void)unused;
    const bat_viewpoint view = {
        .eye = {3, 4, -5}, .target = {1, 1, 1}, .up = {0, -1, 0.5}, .size = {40, 30}, .height = 9};
    bat_object *plain = object_of(&view);
    for (int k = 0; k < 12; k++) {
        bat_viewpoint other = view;
        double *const numbers[] = {other.eye, other.target, other.up, other.size};
        if (k < 11) numbers[k / 3][k % 3] += 0.25;
        if (k == 11) other.height = 0, other.fov = 9;
        bat_object *object = object_of(&other);
        bat_document *a = NULL, *b = NULL;
        bat_document_create(&a), bat_document_create(&b);
        bat_document_insert(a, 0, plain), bat_document_insert(b, 0, object);
        assert_true(bat_document_digest(a) != bat_document_digest(b));
        bat_document_free(a), bat_document_free(b);
        bat_object_release(object);
    }
    bat_object_release(plain);
}

static void no_memory(void **unused) {
    (void)unused;
    const bat_viewpoint view = {.eye = {0, 0, -5}, .up = {0, -1, 0}, .size = {40, 30}, .height = 9};
    const long before = alloc_live();
    bool reached = true;
    for (long n = 1; reached; n++) {
        bat_object *object = NULL, *moved = NULL;
        alloc_fail_at(n);
        bat_status status = bat_object_create_view(1, "name", &view, &object);
        if (status == BAT_OK) status = bat_affine_object(object, (double[]){1, 0, 0, 1, 5, 5}, true, &moved);
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        bat_object_release(object);
        bat_object_release(moved);
        assert_int_equal(alloc_live(), before);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(refusals), cmocka_unit_test(goes_with_the_page),
                                       cmocka_unit_test(files), cmocka_unit_test(digests),
                                       cmocka_unit_test(no_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
