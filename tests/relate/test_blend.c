/* Blends and matched ends meet with the continuity asked for, at any scale, in the plane and in space; a match changes only its end;
 * no neighbour of a blend varies less; lines and circles go on as they are. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <cmocka.h>
#include <batten/blend.h>
#include <batten/measure.h>
#include <batten/refine.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { ROUNDS = 24 };

/* A smooth arch of five points, begun at `from`, about `scale` long. */
static bat_curve *arch(random_source *r, int dimension, int degree, double from, double scale) {
    double points[5 * 3];
    bat_curve *out = NULL;
    for (int i = 0; i < 5; i++)
        for (int c = 0; c < dimension; c++)
            points[i * dimension + c] = scale * (c ? 0.5 * random_unit(r) : from + i + 0.3 * random_unit(r));
    assert_int_equal(bat_curve_create_clamped(dimension, degree, 5, points, &out), BAT_OK);
    return out;
}

static bat_curve *line(const double points[4]) {
    bat_curve *out = NULL;
    assert_int_equal(bat_curve_create_clamped(2, 1, 2, points, &out), BAT_OK);
    return out;
}

static double bend_at(const bat_curve *curve, bool end) {
    double domain[2];
    bat_curve_domain(curve, domain);
    return fabs(bat_curve_curvature(curve, domain[end]));
}

static void check_joint(const bat_curve *a, bool a_end, const bat_curve *b, bool b_end, int continuity,
                        double scale) {
    double jump[4];
    assert_int_equal(bat_curve_jump(a, a_end, b, b_end, jump), BAT_OK);
    const double bend = bend_at(a, a_end) * scale + 1; /* without a unit */
    const double bound[4] = {1e-12 * scale, 1e-11, 1e-9 * bend / scale, 1e-7 * bend * bend / (scale * scale)};
    for (int k = 0; k <= continuity; k++) assert_true(jump[k] <= bound[k]);
}

static void joints_of_blends(void **state) {
    (void)state;
    static const double SCALES[] = {1, 1e-6, 1e6};
    random_source r = {7};
    for (int i = 0; i < ROUNDS; i++) {
        const int dimension = 2 + i % 2, degree = random_int(&r, 1, 4);
        const double scale = SCALES[i % 3];
        const bool a_end = random_unit(&r) < 0.7, b_end = random_unit(&r) < 0.3;
        bat_curve *a = arch(&r, dimension, degree, 0, scale), *b = arch(&r, dimension, 4, 5, scale),
                  *made = NULL;
        bat_blend_options o = bat_blend_defaults();
        double variation;
        for (int e = 0; e < 2; e++) {
            o.continuity[e] = random_int(&r, 0, 3);
            if (i % 4 == 0) o.tension[e] = random_between(&r, 0.5, 2);
        }
        assert_int_equal(bat_curve_blend(a, a_end, b, b_end, &o, &made, &variation), BAT_OK);
        assert_int_equal(bat_curve_degree(made), o.continuity[0] + o.continuity[1] + 1);
        assert_true(variation >= 0);
        check_joint(a, a_end, made, false, o.continuity[0], scale);
        check_joint(b, b_end, made, true, o.continuity[1], scale); /* as if b went on backwards along it */
        bat_curve_free(made), bat_curve_free(a), bat_curve_free(b);
    }
}

/* The same pair larger and the other way round: the same blend. */
static void blends_follow_the_ends(void **state) {
    (void)state;
    random_source one = {3}, two = {3};
    bat_curve *a = arch(&one, 2, 3, 0, 1), *b = arch(&one, 2, 3, 5, 1), *p = arch(&two, 2, 3, 0, 1e4),
              *q = arch(&two, 2, 3, 5, 1e4), *small = NULL, *large = NULL;
    assert_int_equal(bat_curve_blend(a, true, b, false, NULL, &small, NULL), BAT_OK);
    assert_int_equal(bat_curve_blend(q, false, p, true, NULL, &large, NULL), BAT_OK);
    const size_t n = bat_curve_count(small);
    for (size_t i = 0; i < n; i++)
        for (size_t c = 0; c < 2; c++)
            assert_true(fabs(bat_curve_points(small)[2 * i + c] -
                             bat_curve_points(large)[2 * (n - 1 - i) + c] / 1e4) < 1e-3);
    bat_curve_free(a), bat_curve_free(b), bat_curve_free(p), bat_curve_free(q);
    bat_curve_free(small), bat_curve_free(large);
}

/* With speeds a little off, and all else found anew, it varies no less. */
static void blends_vary_least(void **state) {
    (void)state;
    random_source r = {11};
    for (int i = 0; i < 6; i++) {
        bat_curve *a = arch(&r, 2, 3, 0, 1), *b = arch(&r, 2, 3, 5.5, 1), *made = NULL;
        bat_blend_options o = bat_blend_defaults();
        double least, other;
        o.continuity[0] = o.continuity[1] = 1 + i % 3;
        assert_int_equal(bat_curve_blend(a, true, b, false, &o, &made, &least), BAT_OK);
        bat_curve_free(made);
        for (int k = 0; k < 4; k++) {
            o.tension[0] = k & 1 ? 1.05 : 1 / 1.05, o.tension[1] = k & 2 ? 1.05 : 1 / 1.05;
            assert_int_equal(bat_curve_blend(a, true, b, false, &o, &made, &other), BAT_OK);
            assert_true(other >= least * (1 - 1e-4));
            bat_curve_free(made);
        }
        bat_curve_free(a), bat_curve_free(b);
    }
}

static void lines_and_circles_go_on(void **state) {
    (void)state;
    bat_curve *a = line((double[]){-1, 0, 0, 0}), *b = line((double[]){1, 0, 3, 0}),
              *up = line((double[]){1, 1, 1, 2}), *made = NULL;
    double variation;
    for (int k = 0; k <= 3; k++) {
        bat_blend_options o = bat_blend_defaults();
        o.continuity[0] = o.continuity[1] = k;
        assert_int_equal(bat_curve_blend(a, true, b, false, &o, &made, &variation), BAT_OK);
        assert_true(variation < 1e-12);
        double at[2];
        bat_curve_eval(made, 0.3, 0, at);
        assert_true(fabs(at[1]) < 1e-15 && fabs(at[0] - 0.3) < 1e-12);
        bat_curve_free(made);
        if (k != 1) continue;
        /* nearly a quarter of a circle */
        assert_int_equal(bat_curve_blend(a, true, up, false, &o, &made, &variation), BAT_OK);
        for (int i = 0; i <= 10; i++) {
            bat_curve_eval(made, i / 10., 0, at);
            assert_true(fabs(hypot(at[0], at[1] - 1) - 1) < 2e-3);
        }
        bat_curve_free(made);
    }
    bat_curve_free(a), bat_curve_free(b), bat_curve_free(up);
}

static void matches_meet_and_keep_the_rest(void **state) {
    (void)state;
    random_source r = {5};
    for (int i = 0; i < ROUNDS; i++) {
        const int dimension = 2 + i % 2, k = i % 4;
        const bool a_end = random_unit(&r) < 0.5, b_end = random_unit(&r) < 0.5;
        const int degree = random_int(&r, 1, 7), kind = random_int(&r, 0, 1), extra = random_int(&r, 0, 5);
        bat_curve *a = random_curve(&r, degree, dimension, kind, extra),
                  *b = arch(&r, dimension, random_int(&r, 1, 4), 0, 1), *made = NULL, *again = NULL;
        double moved;
        const bat_status status = bat_curve_match(a, a_end, b, b_end, k, random_between(&r, 0.5, 2), &made,
                                                  &moved);
        assert_int_equal(status, BAT_OK);
        check_joint(made, a_end, b, b_end, k, 1 + bat_curve_size(made));
        check_joint(a, !a_end, made, !a_end, 0, 1 + bat_curve_size(a));
        double domain[2], was[4 * 3], is[4 * 3];
        bat_curve_domain(a, domain);
        bat_curve_eval(a, domain[!a_end], k, was), bat_curve_eval(made, domain[!a_end], k, is);
        for (int c = 0; c < (k + 1) * dimension; c++) {
            const double size = 1 + fabs(was[c]) + bat_curve_size(a);
            assert_true(fabs(was[c] - is[c]) <= 1e-8 * size * pow(200, c / dimension));
        }
        /* once more: nothing to do */
        assert_int_equal(bat_curve_match(made, a_end, b, b_end, k, 1, &again, &moved), BAT_OK);
        assert_int_equal(bat_curve_count(made), bat_curve_count(again));
        assert_true(moved <= 1e-6 * (1 + bat_curve_size(made)));
        bat_curve_free(a), bat_curve_free(b), bat_curve_free(made), bat_curve_free(again);
    }
}

static void what_cannot_be(void **state) {
    (void)state;
    bat_curve *a = line((double[]){-1, 0, 0, 0}), *b = line((double[]){0, 0, 1, 1}), *still = NULL,
              *ring = NULL, *space = NULL, *out = NULL;
    const double cusp[] = {2, 0, 2, 0, 2, 1, 4, 1}, round[] = {0, 0, 1, 0, 1, 1};
    const double high[] = {0, 0, 0, 1, 1, 1};
    double jump[4];
    assert_int_equal(bat_curve_create_clamped(2, 3, 4, cusp, &still), BAT_OK);
    assert_int_equal(bat_curve_create(2, 2, true, 3, round, 4, (double[]){0, 1, 2, 3}, &ring), BAT_OK);
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, high, &space), BAT_OK);
    bat_blend_options o = bat_blend_defaults();
    assert_int_equal(bat_curve_blend(a, true, b, false, NULL, &out, NULL), BAT_SINGULAR); /* they meet */
    assert_int_equal(bat_curve_blend(a, true, ring, false, NULL, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_blend(a, true, space, false, NULL, &out, NULL), BAT_DIMENSION);
    assert_int_equal(bat_curve_blend(a, true, still, false, NULL, &out, NULL),
                     BAT_SINGULAR); /* no curvature */
    assert_int_equal(bat_curve_match(a, true, still, false, 2, 1, &out, NULL), BAT_SINGULAR);
    o.continuity[1] = 1; /* but it has a direction */
    assert_int_equal(bat_curve_blend(a, true, still, false, &o, &out, NULL), BAT_OK);
    assert_int_equal(bat_curve_jump(out, true, still, false, jump), BAT_OK);
    assert_true(jump[1] < 1e-12 && isinf(jump[2]));
    bat_curve_free(out);
    out = NULL;
    o.continuity[1] = 4;
    assert_int_equal(bat_curve_blend(a, true, still, false, &o, &out, NULL), BAT_ARGUMENT);
    o.continuity[1] = 0, o.tension[0] = (double)NAN;
    assert_int_equal(bat_curve_blend(a, true, still, false, &o, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_match(a, true, still, false, 1, (double)NAN, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_match(a, true, still, false, -1, 1, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_match(a, true, NULL, false, 1, 1, &out, NULL), BAT_ARGUMENT);
    assert_null(out);
    bat_curve_free(a), bat_curve_free(b), bat_curve_free(still), bat_curve_free(ring), bat_curve_free(space);
}

static void allocations_may_fail(void **state) {
    (void)state;
    bat_curve *a = line((double[]){-1, 0, 0, 0}), *b = line((double[]){1, 1, 1, 2});
    const long live = alloc_live();
    for (int matching = 0; matching < 2; matching++) {
        bool reached = true;
        for (long n = 1; reached; n++) {
            bat_curve *out = NULL;
            alloc_fail_at(n);
            const bat_status status = matching ? bat_curve_match(a, true, b, false, 2, 1, &out, NULL)
                                               : bat_curve_blend(a, true, b, false, NULL, &out, NULL);
            reached = alloc_fail_reached();
            assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
            bat_curve_free(out);
            assert_int_equal(alloc_live(), live);
        }
    }
    bat_curve_free(a), bat_curve_free(b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(joints_of_blends),
        cmocka_unit_test(blends_follow_the_ends),
        cmocka_unit_test(blends_vary_least),
        cmocka_unit_test(lines_and_circles_go_on),
        cmocka_unit_test(matches_meet_and_keep_the_rest),
        cmocka_unit_test(what_cannot_be),
        cmocka_unit_test(allocations_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
