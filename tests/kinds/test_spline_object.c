/*
 * Splines in the document: the curve is that of the spline, replacing it makes a path, everything survives the native
 * format bit for bit, and whatever the tangents hand refuses is refused.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/format.h>
#include <batten/refine.h>
#include <batten/document.h>
#include <batten/tangents.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include "support/objects.h"

typedef struct setup {
    double points[36], tangents[36], tension[24];
    bat_spline spline;
    bat_tangents_options options;
} setup;

static void random_setup(random_source *r, setup *s, int round) {
    int n = 2 + round % 2, count = 2 + round % 11;
    for (int i = 0; i < 36; i++) s->points[i] = random_between(r, -300, 300);
    for (int i = 0; i < 36; i++) s->tangents[i] = random_between(r, -1, 1);
    for (int i = 0; i < 24; i++) s->tension[i] = random_between(r, 0, 2);
    for (int i = 0; i < count; i++)
        if (random_between(r, 0, 1) < 0.4)
            for (int d = 0; d < n; d++) s->tangents[i * n + d] = d ? -0.0 : 0.0;
    s->spline = (bat_spline){n,
                             round / 2 % 2,
                             (size_t)count,
                             s->points,
                             round % 5 ? s->tangents : NULL,
                             round % 3 ? s->tension : NULL};
    s->options = (bat_tangents_options){sizeof(bat_tangents_options), (bat_tangents_mode)(round % 4),
                                        (bat_tangents_default)(round % 3)};
}

static bat_object *make(const setup *s, bat_id id) {
    bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    assert_int_equal(bat_object_create_spline(id, "belly", &style, &s->spline, &s->options, &object), BAT_OK);
    return object;
}

static void its_curve_is_what_the_hand_makes(void **state) {
    (void)state;
    random_source r = {1};
    for (int round = 0; round < 200; round++) {
        setup s;
        random_setup(&r, &s, round);
        bat_object *object = make(&s, 7);
        bat_curve *expected = NULL;
        assert_int_equal(bat_tangents(&s.spline, &s.options, NULL, NULL, NULL, &expected), BAT_OK);
        assert_int_equal(bat_object_kind(object), BAT_KIND_SPLINE);
        assert_int_equal(bat_object_curve_count(object), 1);
        assert_true(bat_curve_is_equal(bat_object_curve(object, 0), expected));
        const bat_spline *kept = bat_object_spline(object);
        size_t size = s.spline.count * (size_t)s.spline.dimension * sizeof(double);
        assert_memory_equal(kept->points, s.points, size);
        assert_non_null(kept->tangents);
        assert_non_null(kept->tension);
        bat_curve_free(expected);
        bat_object_release(object);
    }
}

static void another_hand_makes_it_a_path(void **state) {
    (void)state;
    random_source r = {2};
    setup s;
    random_setup(&r, &s, 6);
    bat_object *object = make(&s, 7), *path = NULL, *restyled = NULL, *freed = NULL, *same = NULL;
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_reverse(bat_object_curve(object, 0), &curve), BAT_OK);
    assert_int_equal(bat_object_with_curve(object, 0, curve, &path), BAT_OK);
    assert_int_equal(bat_object_kind(path), BAT_KIND_PATH);
    assert_null(bat_object_spline(path));
    assert_null(bat_object_spline_options(path));
    assert_int_equal(bat_object_with_spline(path, &s.spline, &same), BAT_ARGUMENT);
    assert_int_equal(bat_object_to_path(path, &same), BAT_ARGUMENT);
    bat_style style = bat_style_defaults();
    style.width = 9;
    assert_int_equal(bat_object_with_style(object, &style, &restyled), BAT_OK);
    assert_non_null(bat_object_spline(restyled));
    assert_int_equal(bat_object_to_path(object, &freed), BAT_OK);
    assert_int_equal(bat_object_kind(freed), BAT_KIND_PATH);
    assert_true(bat_curve_is_equal(bat_object_curve(freed, 0), bat_object_curve(object, 0)));
    assert_string_equal(bat_object_name(freed), "belly");
    assert_int_equal(bat_object_with_spline(object, &s.spline, &same), BAT_OK);
    assert_int_equal(bat_object_spline_options(same)->mode, s.options.mode);
    bat_object_release(object); /* the others stand on their own */
    assert_true(bat_object_spline(restyled)->points[0] == s.points[0]);
    bat_object_release(path);
    bat_object_release(restyled);
    bat_object_release(freed);
    bat_object_release(same);
}

static void round_trip(void **state) {
    (void)state;
    random_source r = {3};
    for (int round = 0; round < 200; round++) {
        setup s;
        random_setup(&r, &s, round);
        bat_document *document = of_one(make(&s, 7)), *again = NULL;
        char *text = NULL;
        size_t size = 0;
        bat_problem problem;
        assert_null(bat_document_check(document));
        assert_int_equal(bat_document_write(document, &text, &size), BAT_OK);
        assert_null(strstr(text, "curves"));
        assert_non_null(strstr(text, "\"mode\":"));
        assert_int_equal(bat_document_read(text, size, &again, &problem), BAT_OK);
        assert_true(bat_document_digest(document) == bat_document_digest(again));
        assert_int_equal(bat_object_kind(bat_document_at(again, 0)), BAT_KIND_SPLINE);
        assert_null(bat_document_check(again));
        bat_free(text);
        bat_document_free(document);
        bat_document_free(again);
    }
}

/* A file that says no mode means the paper's, as it did before there was another default. */
static void no_mode_is_faithful(void **state) {
    (void)state;
    const char *const texts[] = {"", ",\"mode\":\"faithful\"", ",\"mode\":\"round\""};
    uint64_t digests[3];
    for (int i = 0; i < 3; i++) {
        char text[400];
        snprintf(text, sizeof text,
                 "{\"batten\":1,\"objects\":[{\"id\":1,\"kind\":\"spline\",\"spline\":{\"points\":"
                 "[[0,0],[40,30],[90,0]]%s}}]}",
                 texts[i]);
        bat_document *document = NULL;
        bat_problem problem;
        assert_int_equal(bat_document_read(text, strlen(text), &document, &problem), BAT_OK);
        assert_int_equal(bat_object_spline_options(bat_document_at(document, 0))->mode,
                         i < 2 ? BAT_TANGENTS_FAITHFUL : BAT_TANGENTS_ROUND);
        digests[i] = bat_document_digest(document);
        bat_document_free(document);
    }
    assert_true(digests[0] == digests[1] && digests[1] != digests[2]);
}

/* Each of a spline's parts counts for the digest: no two of these are the same document. */
static void digest_tells_apart(void **state) {
    (void)state;
    double points[] = {0, 0, 100, 50, 200, 0}, tangents[] = {0, 0, 1, 0.1, 0, 0};
    double longer[] = {0, 0, 2, 0.2, 0, 0}, tension[] = {1, 1, 1, 1, 1, 1.5};
    const bat_spline splines[] = {{2, false, 3, points, NULL, NULL},     {2, true, 3, points, NULL, NULL},
                                  {2, false, 3, points, tangents, NULL}, {2, false, 3, points, longer, NULL},
                                  {2, false, 3, points, NULL, tension},  {2, false, 2, points, NULL, NULL}};
    enum { COUNT = sizeof splines / sizeof *splines };
    uint64_t digests[COUNT + 2];
    for (int i = 0; i < COUNT + 2; i++) {
        setup s = {.spline = splines[i < COUNT ? i : 5],
                   .options = {sizeof s.options, BAT_TANGENTS_FAITHFUL,
                               i == COUNT ? BAT_TANGENTS_UNIFORM : BAT_TANGENTS_CENTRIPETAL}};
        bat_object *object = make(&s, 1), *path = NULL;
        if (i == COUNT + 1) { /* the same curve, but free */
            assert_int_equal(bat_object_to_path(object, &path), BAT_OK);
            bat_object_release(object);
            object = path;
        }
        bat_document *document = of_one(object);
        digests[i] = bat_document_digest(document);
        for (int j = 0; j < i; j++) assert_true(digests[i] != digests[j]);
        bat_document_free(document);
    }
}

static void bad_splines_are_refused(void **state) {
    (void)state;
    double same[] = {5, 5, 5, 5}, bad[] = {0, 0, NAN, 1}, good[] = {0, 0, 4, 1}, slack[] = {1, -1, 1, 1};
    bat_style style = bat_style_defaults();
    bat_object *object = NULL;
    bat_spline s = {2, false, 2, same, NULL, NULL};
    assert_int_equal(bat_object_create_spline(1, NULL, &style, &s, NULL, &object), BAT_COUNT);
    s.points = bad;
    assert_int_equal(bat_object_create_spline(1, NULL, &style, &s, NULL, &object), BAT_NUMBER);
    s.points = good, s.tension = slack;
    assert_int_equal(bat_object_create_spline(1, NULL, &style, &s, NULL, &object), BAT_NUMBER);
    s.tension = NULL;
    assert_int_equal(bat_object_create_spline(0, NULL, &style, &s, NULL, &object), BAT_ARGUMENT);
    assert_null(object);
    static const char *const texts[] = {
        "{\"id\":1,\"kind\":\"spline\"}",
        "{\"id\":1,\"kind\":\"spline\",\"spline\":[]}",
        "{\"id\":1,\"kind\":\"spline\",\"spline\":{\"points\":[[0,0]]}}",
        "{\"id\":1,\"kind\":\"spline\",\"spline\":{\"points\":[[0,0],[1,1]],\"mode\":\"any\"}}",
        "{\"id\":1,\"kind\":\"spline\",\"spline\":{\"points\":[[0,0],[1,1]],\"tangents\":[null]}}",
        "{\"id\":1,\"kind\":\"spline\",\"spline\":{\"points\":[[0,0],[1,1]],\"tension\":[-1,null]}}",
        "{\"id\":1,\"kind\":\"shape\",\"spline\":{\"points\":[[0,0],[1,1]]}}",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) object_refused(texts[i]);
}

static void memory_may_end_anywhere(void **state) {
    (void)state;
    random_source r = {4};
    setup s;
    random_setup(&r, &s, 8);
    long before = alloc_live();
    for (int n = 1;; n++) {
        bat_style style = bat_style_defaults();
        bat_object *object = NULL;
        alloc_fail_at(n);
        bat_status status = bat_object_create_spline(1, "a", &style, &s.spline, &s.options, &object);
        if (!alloc_fail_reached()) {
            assert_int_equal(status, BAT_OK);
            bat_object_release(object);
            break;
        }
        assert_int_equal(status, BAT_MEMORY);
        assert_null(object);
        assert_int_equal(alloc_live(), before);
    }
    assert_int_equal(alloc_live(), before);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(its_curve_is_what_the_hand_makes),
        cmocka_unit_test(another_hand_makes_it_a_path),
        cmocka_unit_test(round_trip),
        cmocka_unit_test(no_mode_is_faithful),
        cmocka_unit_test(digest_tells_apart),
        cmocka_unit_test(bad_splines_are_refused),
        cmocka_unit_test(memory_may_end_anywhere),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
