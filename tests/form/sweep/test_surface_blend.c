/*
 * Surfaces between edges: every line across meets both surfaces with the continuity asked for (by arc length, as curves' jumps are measured); between
 * parts of a plane, a cylinder and a bicubic the blend is that same surface; closed edges; curves; what cannot be.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/blend.h>
#include <batten/sweep.h>
#include "support/alloc_fail.h"
#include "support/random_curve.h"

enum { N = 6, M = 5 };

/* A rough patch over [x, x + 5] x [0, 4], along u or along v, with uneven knots. */
static bat_surface *patch(random_source *r, double x, bool swap) {
    double points[N * M * 3], knots[2][N + 4];
    const size_t count[2] = {swap ? M : N, swap ? N : M};
    bat_surface *out = NULL;
    for (size_t i = 0; i < count[0]; i++)
        for (size_t j = 0; j < count[1]; j++) {
            double *p = points + 3 * (i * count[1] + j);
            p[0] = x + (double)(swap ? j : i) + 0.2 * random_unit(r);
            p[1] = (double)(swap ? i : j) + 0.2 * random_unit(r);
            p[2] = random_unit(r);
        }
    int size[2];
    for (int k = 0; k < 2; k++) {
        size[k] = (int)count[k] + 4;
        for (int i = 0; i < size[k]; i++)
            knots[k][i] = i < 4 ? 0 : i >= size[k] - 4 ? 1 : (i - 3 + 0.3 * random_unit(r)) / (size[k] - 7);
    }
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){false, false}, count, points,
                                        size, knots[0], knots[1], &out),
                     BAT_OK);
    return out;
}

/* The line across an edge at a share of it. */
static bat_curve *across(const bat_surface *s, bat_side side, double share) {
    const bat_direction along = side == BAT_SIDE_U0 || side == BAT_SIDE_U1 ? BAT_V : BAT_U;
    bat_curve *line = NULL;
    double domain[2];
    bat_surface_domain(s, along, domain);
    assert_int_equal(bat_surface_isocurve(s, along, domain[0] + share * (domain[1] - domain[0]), &line),
                     BAT_OK);
    return line;
}

static bool is_last(bat_side side) { return side == BAT_SIDE_U1 || side == BAT_SIDE_V1; }

/* The joint at the start (or the end) of the blend: none of the jumps up to the continuity is there, and the next one is. */
static void joins(const bat_surface *s, bat_side side, bool turned, const bat_surface *made, bool end,
                  int continuity) {
    static const double none[4] = {1e-11, 1e-9, 1e-9, 1e-7};
    double most[4] = {0};
    for (int i = 0; i <= 20; i++) {
        const double share = i / 20.0;
        double jump[4];
        bat_curve *a = across(s, side, turned ? 1 - share : share), *b = across(made, BAT_SIDE_V0, share);
        assert_int_equal(end ? bat_curve_jump(b, true, a, is_last(side), jump)
                             : bat_curve_jump(a, is_last(side), b, false, jump),
                         BAT_OK);
        for (int k = 0; k < 4; k++) most[k] = fmax(most[k], jump[k]);
        bat_curve_free(a), bat_curve_free(b);
    }
    for (int k = 0; k < 4; k++) assert_int_equal(most[k] <= none[k], k <= continuity);
}

static void every_line_across_is_continuous(void **state) {
    (void)state;
    random_source r = {7};
    for (int pair = 0; pair < 16; pair++)
        for (int swap = 0; swap < 4; swap++) {
            bat_surface *a = patch(&r, 0, swap & 1), *b = patch(&r, 9, swap & 2), *made = NULL;
            const bat_side from = swap & 1 ? BAT_SIDE_V1 : BAT_SIDE_U1,
                           to = swap & 2 ? BAT_SIDE_V0 : BAT_SIDE_U0;
            bat_blend_options options = bat_blend_defaults();
            options.continuity[0] = pair % 4, options.continuity[1] = pair / 4;
            options.tension[0] = 0.7;
            assert_int_equal(bat_surface_blend(a, from, b, to, &options, &made), BAT_OK);
            assert_int_equal(bat_surface_degree(made, BAT_V), pair % 4 + pair / 4 + 1);
            joins(a, from, false, made, false, pair % 4);
            joins(b, to, false, made, true, pair / 4);
            bat_surface_free(a), bat_surface_free(b), bat_surface_free(made);
        }
}

/* Where the other edge runs the other way it is turned round. */
static void edges_are_turned(void **state) {
    (void)state;
    random_source r = {9};
    bat_surface *a = patch(&r, 0, false), *b = patch(&r, 9, false), *back = NULL, *made = NULL;
    const double turn[12] = {-1, 0, 0, 23, 0, -1, 0, 4, 0, 0, 1, 0}; /* half a turn about (11.5, 2) */
    assert_int_equal(bat_surface_transform(b, turn, &back), BAT_OK);
    assert_int_equal(bat_surface_blend(a, BAT_SIDE_U1, back, BAT_SIDE_U1, NULL, &made), BAT_OK);
    joins(a, BAT_SIDE_U1, false, made, false, 2);
    joins(back, BAT_SIDE_U1, true, made, true, 2);
    bat_surface_free(a), bat_surface_free(b), bat_surface_free(back), bat_surface_free(made);
}

/* A plane goes on as a plane; a curve is met, and nothing more is asked of it. */
static void planes_and_curves(void **state) {
    (void)state;
    const double left[12] = {0, 0, 1, 0, 4, 1, 3, 0, 1, 3, 4, 1}, knots[4] = {0, 0, 1, 1};
    const double rail[12] = {8, 0, 1, 9, 1, 3, 9, 3, 5, 8, 4, 1};
    const int degree[2] = {1, 1}, size[2] = {4, 4};
    bat_surface *plane = NULL, *made = NULL;
    bat_curve *curve = NULL;
    double at[3], there[3];
    assert_int_equal(bat_surface_create(degree, (const bool[2]){false, false}, (const size_t[2]){2, 2}, left,
                                        size, knots, knots, &plane),
                     BAT_OK);
    assert_int_equal(bat_surface_blend(plane, BAT_SIDE_U1, plane, BAT_SIDE_U0,
                                       &(bat_blend_options){sizeof(bat_blend_options), {1, 0}, {1, 1}},
                                       &made),
                     BAT_OK);
    for (int i = 0; i <= 10; i++) {
        bat_surface_eval(made, i / 10.0, 0.37, 0, at);
        assert_true(fabs(at[2] - 1) < 1e-12 && fabs(at[1] - 0.4 * i) < 1e-12);
    }
    bat_surface_free(made);
    assert_int_equal(bat_curve_create_clamped(3, 3, 4, rail, &curve), BAT_OK);
    assert_int_equal(bat_surface_blend_curve(plane, BAT_SIDE_U1, curve, NULL, &made), BAT_OK);
    joins(plane, BAT_SIDE_U1, false, made, false, 2);
    for (int i = 0; i <= 10; i++) {
        double domain[2];
        bat_curve_domain(curve, domain);
        bat_surface_eval(made, i / 10.0, 1, 0, at);
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / 10, 0, there);
        for (int d = 0; d < 3; d++) assert_true(fabs(at[d] - there[d]) < 1e-12);
    }
    bat_surface_free(made), bat_surface_free(plane), bat_curve_free(curve);
}

/* A tube around the third axis from `low` to `high`, open along v. */
static bat_surface *tube(double radius, double low, double high) {
    double points[8 * 4 * 3], around[9], along[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    bat_surface *out = NULL;
    for (int i = 0; i < 8; i++)
        for (int j = 0; j < 4; j++) {
            double *p = points + 3 * (4 * i + j);
            p[0] = radius * (1 + 0.1 * j) * cos(i * 0.7853981633974483);
            p[1] = radius * (1 + 0.1 * j) * sin(i * 0.7853981633974483);
            p[2] = low + (high - low) * j / 3;
        }
    for (int i = 0; i < 9; i++) around[i] = i;
    assert_int_equal(bat_surface_create((const int[2]){3, 3}, (const bool[2]){true, false},
                                        (const size_t[2]){8, 4}, points, (const int[2]){9, 8}, around, along,
                                        &out),
                     BAT_OK);
    return out;
}

static void rings_and_refusals(void **state) {
    (void)state;
    random_source r = {2};
    bat_surface *low = tube(2, 0, 3), *high = tube(1, 6, 9), *open = patch(&r, 0, false), *made = NULL;
    assert_int_equal(bat_surface_blend(low, BAT_SIDE_V1, high, BAT_SIDE_V0, NULL, &made), BAT_OK);
    assert_true(bat_surface_is_closed(made, BAT_U));
    joins(low, BAT_SIDE_V1, false, made, false, 2);
    joins(high, BAT_SIDE_V0, false, made, true, 2);
    bat_surface_free(made);
    made = NULL;
    bat_blend_options odd = bat_blend_defaults();
    odd.continuity[1] = 4;
    assert_int_equal(bat_surface_blend(low, BAT_SIDE_V1, high, BAT_SIDE_V0, &odd, &made), BAT_ARGUMENT);
    odd = bat_blend_defaults(), odd.tension[0] = NAN;
    assert_int_equal(bat_surface_blend(low, BAT_SIDE_V1, high, BAT_SIDE_V0, &odd, &made), BAT_ARGUMENT);
    assert_int_equal(bat_surface_blend(low, BAT_SIDE_V1, open, BAT_SIDE_U0, NULL, &made), BAT_ARGUMENT);
    assert_int_equal(bat_surface_blend(low, BAT_SIDE_U0, high, BAT_SIDE_V0, NULL, &made), BAT_ARGUMENT);
    assert_int_equal(bat_surface_blend(low, BAT_SIDE_V1, NULL, BAT_SIDE_U0, NULL, &made), BAT_ARGUMENT);
    assert_int_equal(bat_surface_blend(low, BAT_SIDE_V1, low, BAT_SIDE_V1, NULL, &made), BAT_SINGULAR);
    assert_null(made);
    for (long n = 1, reached = 1; reached; n++) {
        const long live = alloc_live();
        alloc_fail_at(n);
        const bat_status status = bat_surface_blend(low, BAT_SIDE_V1, high, BAT_SIDE_V0, NULL, &made);
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        if (reached) assert_int_equal(alloc_live(), live);
    }
    bat_surface_free(made), bat_surface_free(low), bat_surface_free(high), bat_surface_free(open);
}

/* Every side of a patch meets every side of another with G0 to G3, by curves' jumps at 21 places, from any distance, at any size; its far edge stays. */
static void edges_are_matched(void **state) {
    (void)state;
    static const double sizes[] = {1, 1e-6, 1e6};
    random_source r = {11};
    for (int way = 0; way < 64; way++) {
        const bat_side from = (bat_side)(way % 4), to = (bat_side)(way / 4 % 4);
        const int continuity = way / 16;
        const double size = sizes[way % 3], by[12] = {size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0};
        bat_surface *drawn[2] = {patch(&r, 0, way & 1), patch(&r, 9, way & 2)}, *s[2], *made = NULL;
        double moved = 0, domain[2], jump[4], at[2][6];
        for (int k = 0; k < 2; k++) assert_int_equal(bat_surface_transform(drawn[k], by, &s[k]), BAT_OK);
        assert_int_equal(bat_surface_match(s[0], from, s[1], to, continuity, 0.8, &made, &moved), BAT_OK);
        assert_true(moved > 0.1 * size);
        double most[4] = {0}, best = INFINITY;
        for (int turned = 0; turned < 2; turned++) { /* the edges may run against each other */
            double all[4] = {0};
            for (int i = 0; i <= 20; i++) {
                bat_curve *a = across(made, from, i / 20.0),
                          *b = across(s[1], to, turned ? 1 - i / 20.0 : i / 20.0);
                assert_int_equal(bat_curve_jump(a, is_last(from), b, is_last(to), jump), BAT_OK);
                for (int k = 0; k < 4; k++)
                    all[k] = fmax(all[k], jump[k] * pow(size, k == 0 ? -1 : k == 1 ? 0 : k - 1));
                bat_curve_free(a), bat_curve_free(b);
            }
            if (all[0] < best) memcpy(most, all, sizeof most), best = all[0];
        }
        static const double none[4] = {1e-11, 1e-9, 1e-9, 1e-7};
        for (int k = 0; k < 4; k++)
            if ((most[k] <= none[k]) != (k <= continuity))
                fail_msg("%d: jump %d of G%d is %g", way, k, continuity, most[k]);
        for (int i = 0; i <= 20; i++) { /* at the far edge it is what it was, and so is its domain */
            bat_curve *a = across(made, from, i / 20.0), *b = across(s[0], from, i / 20.0);
            bat_curve_domain(a, domain);
            bat_curve_eval(a, domain[is_last(from) ? 0 : 1], 1, at[0]);
            bat_curve_eval(b, domain[is_last(from) ? 0 : 1], 1, at[1]);
            for (int d = 0; d < 6; d++)
                assert_true(fabs(at[0][d] - at[1][d]) <= 1e-9 * size * (continuity < 1 && d > 2 ? 1e10 : 1));
            bat_curve_free(a), bat_curve_free(b);
        }
        bat_surface *again = NULL; /* what meets already stays */
        assert_int_equal(bat_surface_match(made, from, s[1], to, continuity, 1, &again, &moved), BAT_OK);
        assert_true(moved <= 1e-9 * size);
        for (int k = 0; k < 2; k++) bat_surface_free(s[k]), bat_surface_free(drawn[k]);
        bat_surface_free(made), bat_surface_free(again);
    }
}

static void matched_rings_and_refusals(void **state) {
    (void)state;
    random_source r = {2};
    bat_surface *low = tube(2, 0, 3), *high = tube(1, 6, 9), *open = patch(&r, 0, false), *made = NULL;
    double moved;
    assert_int_equal(bat_surface_match(high, BAT_SIDE_V0, low, BAT_SIDE_V1, 2, 1, &made, &moved), BAT_OK);
    assert_true(bat_surface_is_closed(made, BAT_U));
    joins(low, BAT_SIDE_V1, false, made, false, 2);
    bat_surface_free(made);
    made = NULL;
    assert_int_equal(bat_surface_match(high, BAT_SIDE_V0, low, BAT_SIDE_V1, 4, 1, &made, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_match(high, BAT_SIDE_V0, low, BAT_SIDE_V1, 2, NAN, &made, NULL),
                     BAT_ARGUMENT);
    assert_int_equal(bat_surface_match(high, BAT_SIDE_V0, open, BAT_SIDE_V1, 2, 1, &made, NULL),
                     BAT_ARGUMENT);
    assert_int_equal(bat_surface_match(high, BAT_SIDE_U0, open, BAT_SIDE_V1, 2, 1, &made, NULL),
                     BAT_ARGUMENT);
    assert_int_equal(bat_surface_match(open, BAT_SIDE_U0, low, BAT_SIDE_U1, 2, 1, &made, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_match(NULL, BAT_SIDE_U0, low, BAT_SIDE_U1, 2, 1, &made, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_surface_match(high, (bat_side)4, low, BAT_SIDE_V1, 2, 1, &made, NULL), BAT_ARGUMENT);
    assert_null(made);
    for (long n = 1, reached = 1; reached; n++) {
        const long live = alloc_live();
        alloc_fail_at(n);
        const bat_status status = bat_surface_match(high, BAT_SIDE_V0, low, BAT_SIDE_V1, 2, 1, &made, NULL);
        reached = alloc_fail_reached();
        assert_int_equal(status, reached ? BAT_MEMORY : BAT_OK);
        if (reached) assert_int_equal(alloc_live(), live);
    }
    bat_surface_free(made), bat_surface_free(low), bat_surface_free(high), bat_surface_free(open);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_line_across_is_continuous),
        cmocka_unit_test(edges_are_turned),
        cmocka_unit_test(planes_and_curves),
        cmocka_unit_test(rings_and_refusals),
        cmocka_unit_test(edges_are_matched),
        cmocka_unit_test(matched_rings_and_refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
