/* Curves in few letters: every curve comes back bit for bit, whatever its size; a chain of straight spans takes a small part of what
 * its numbers take; damaged text gives an error or a curve, never anything else; any allocation may fail. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "format/json/curve.h"
#include "format/json/pack.h"
#include "support/alloc_fail.h"
#include "support/random_curve.h"
#include <batten/bezier.h>
#include <batten/format.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* As JSON, zero-terminated; freed by the caller. */
static char *written(const bat_curve *curve, bool packed) {
    bat_text text = {.packed = packed};
    char *data = NULL;
    size_t size = 0;
    bat_curve_to_json(curve, 0, &text);
    assert_int_equal(bat_text_finish(&text, &data, &size), BAT_OK);
    assert_int_equal(strlen(data), size);
    return data;
}

static bat_curve *read_back(const char *text) {
    bat_curve *curve = NULL;
    bat_problem problem = {0};
    if (bat_curve_read(text, strlen(text), &curve, &problem) != BAT_OK)
        fail_msg("%s: %s", text, problem.message);
    return curve;
}

static void same_bits(const bat_curve *a, const bat_curve *b) {
    const size_t count = bat_curve_count(a), dimension = (size_t)bat_curve_dimension(a);
    const int knots = bat_curve_knot_count(a);
    assert_true(count == bat_curve_count(b) && bat_curve_dimension(b) == (int)dimension);
    assert_true(bat_curve_degree(a) == bat_curve_degree(b) &&
                bat_curve_is_closed(a) == bat_curve_is_closed(b));
    assert_int_equal(knots, bat_curve_knot_count(b));
    assert_memory_equal(bat_curve_points(a), bat_curve_points(b), count * dimension * sizeof(double));
    assert_memory_equal(bat_curve_knots(a), bat_curve_knots(b), (size_t)knots * sizeof(double));
}

static void comes_back(const bat_curve *curve) {
    char *text = written(curve, true);
    if (bat_curve_count(curve) >= BAT_PACK_LEAST) assert_non_null(strstr(text, "\"packed\""));
    bat_curve *again = read_back(text);
    same_bits(curve, again);
    bat_curve_free(again);
    free(text);
}

static void every_curve_comes_back(void **state) {
    (void)state;
    random_source r = {11};
    for (int i = 0; i < 2000; i++) {
        const int degree = random_int(&r, 1, 7), dimension = random_int(&r, 2, 3),
                  kind = random_int(&r, 0, 2);
        bat_curve *curve = random_curve(&r, degree, dimension, kind, random_int(&r, 8, 60)), *scaled = NULL;
        const double size = pow(10, random_int(&r, -9, 9));
        comes_back(curve);
        double rows[12] = {0};
        for (int k = 0; k < dimension; k++) rows[k * (dimension + 1) + k] = size;
        assert_int_equal(bat_curve_transform(curve, rows, &scaled), BAT_OK);
        comes_back(scaled);
        bat_curve_free(scaled);
        bat_curve_free(curve);
    }
}

/* Zeros of both signs, the smallest and the greatest numbers, points that coincide, runs of one direction. */
static void odd_numbers_come_back(void **state) {
    (void)state;
    static const double odd[] = {0,
                                 -0.0,
                                 5e-324,
                                 -5e-324,
                                 2.2250738585072014e-308,
                                 1e75,
                                 -1e75,
                                 0.1,
                                 -0.1,
                                 1.0 / 3,
                                 9007199254740993.0,
                                 1e-7,
                                 123456.654321,
                                 4503599627370495.5,
                                 -1,
                                 1};
    enum { ODD = sizeof odd / sizeof *odd, COUNT = 40 };
    random_source r = {5};
    for (int i = 0; i < 500; i++) {
        const int degree = random_int(&r, 1, 7), closed = random_int(&r, 0, 1);
        double points[2 * COUNT], knots[COUNT + 8];
        const int count = closed ? COUNT + 1 : COUNT + degree + 1;
        for (int k = 0; k < 2 * COUNT; k++) points[k] = odd[random_int(&r, 0, ODD - 1)];
        for (int k = 0; k < count; k++) knots[k] = closed ? k : fmin(fmax(k - degree, 0), COUNT - degree);
        bat_curve *curve = NULL;
        assert_int_equal(bat_curve_create(2, degree, closed, COUNT, points, count, knots, &curve), BAT_OK);
        comes_back(curve);
        bat_curve_free(curve);
    }
}

/* A chain of straight cubic spans between whole steps of 0.01, as drawings are full of. */
static bat_curve *chain(int spans, bool closed, double size) {
    random_source r = {3};
    double *points = malloc(((size_t)spans * 3 + 1) * 2 * sizeof *points);
    double at[2] = {0, 0};
    assert_non_null(points);
    points[0] = points[1] = 0;
    for (int i = 1; i <= spans; i++) {
        double next[2];
        for (int c = 0; c < 2; c++) {
            next[c] = closed && i == spans ? 0 : round(at[c] * 100 + random_int(&r, -200, 200)) / 100;
            const double part = (next[c] - at[c]) / 3;
            points[6 * i - 4 + c] = (at[c] + part) * size;
            points[6 * i - 2 + c] = (next[c] - part) * size;
            points[6 * i + c] = next[c] * size;
        }
        memcpy(at, next, sizeof at);
    }
    bat_curve *curve = NULL;
    assert_int_equal(bat_curve_from_bezier(2, 3, closed, spans, points, 1e-6, 0, &curve, NULL), BAT_OK);
    free(points);
    return curve;
}

static void chains_are_short(void **state) {
    (void)state;
    for (int closed = 0; closed < 2; closed++) {
        bat_curve *curve = chain(1000, closed, 1);
        char *packed = written(curve, true), *numbers = written(curve, false);
        comes_back(curve);
        if (strlen(packed) * 8 > strlen(numbers)) fail_msg("%zu of %zu", strlen(packed), strlen(numbers));
        assert_true(strlen(packed) < 1000 * 12); /* two numbers of two bytes and a knot, as base 64 */
        free(packed);
        free(numbers);
        bat_curve_free(curve);
        curve = chain(1000, closed, 1.0 / 3.78); /* no decimals, but thirds and knots are foreseen */
        comes_back(curve);
        bat_curve_free(curve);
    }
}

/* What is not a curve is refused, and what is one is written again. */
static void damaged_text_is_refused(void **state) {
    (void)state;
    static const char *const bad[] = {
        "", "A", "AgAA", "AgKo", "%%%%", "AgAE", "/////////////w==", "AgKAgIAIAQE="};
    bat_curve *made = NULL, *curve = chain(12, true, 1);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        for (int degree = 0; degree <= 8; degree++)
            assert_int_not_equal(bat_curve_unpack(bad[i], degree, degree % 2, &made), BAT_OK);
    bat_text text = {0};
    bat_curve_pack(curve, &text);
    char *data = NULL;
    size_t size = 0, refused = 0;
    assert_int_equal(bat_text_finish(&text, &data, &size), BAT_OK);
    data[size - 1] = 0; /* without its quotes */
    for (size_t i = 1; i + 1 < size; i++)
        for (const char *other = "A/zQ9="; *other; other++) {
            const char before = data[i];
            data[i] = *other;
            const bat_status status = bat_curve_unpack(data + 1, 3, true, &made);
            refused += status != BAT_OK;
            if (status == BAT_OK) comes_back(made), bat_curve_free(made);
            data[i] = before;
        }
    for (size_t i = 1; i + 1 < size; i++) { /* cut off */
        const char before = data[i];
        data[i] = 0;
        assert_int_not_equal(bat_curve_unpack(data + 1, 3, true, &made), BAT_OK);
        data[i] = before;
    }
    assert_true(refused > 0);
    bat_problem problem = {0};
    static const char *const json[] = {"{\"degree\":3,\"packed\":7}", "{\"degree\":2.5,\"packed\":\"AgAA\"}",
                                       "{\"degree\":3,\"packed\":\"AgAA\"}"};
    for (size_t i = 0; i < sizeof json / sizeof *json; i++) {
        assert_int_not_equal(bat_curve_read(json[i], strlen(json[i]), &made, &problem), BAT_OK);
        assert_non_null(strstr(problem.message, "packed"));
    }
    free(data);
    bat_curve_free(curve);
}

static void allocations_may_fail(void **state) {
    (void)state;
    bat_curve *curve = chain(40, true, 1), *again = NULL;
    char *text = written(curve, true);
    const long live = alloc_live();
    for (int n = 1;; n++) {
        bat_text own = {.packed = true};
        alloc_fail_at(n);
        bat_curve_to_json(curve, 0, &own);
        const bool reached = alloc_fail_reached();
        assert_true(own.failed == reached);
        bat_text_free(&own);
        assert_int_equal(alloc_live(), live);
        if (!reached) break;
    }
    for (int n = 1;; n++) {
        alloc_fail_at(n);
        const bat_status status = bat_curve_read(text, strlen(text), &again, NULL);
        if (!alloc_fail_reached()) break;
        assert_int_equal(status, BAT_MEMORY);
        assert_null(again);
        assert_int_equal(alloc_live(), live);
    }
    same_bits(curve, again);
    bat_curve_free(again);
    bat_curve_free(curve);
    free(text);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_curve_comes_back), cmocka_unit_test(odd_numbers_come_back),
        cmocka_unit_test(chains_are_short),       cmocka_unit_test(damaged_text_is_refused),
        cmocka_unit_test(allocations_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
