/*
 * Local and live edits of shapes: against the whole-curve formula computed independently; untouched control points are
 * the same bit for bit; an edit that asks for nothing moves nothing; and the result is independent of the path of the
 * drag.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>

#include "curve/curve.h"
#include "support/alloc_fail.h"
#include "support/shapes.h"

static uint64_t seed;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) / 9007199254740992.0;
}
static int pick(int n) { return (int)uniform(0, n - 1e-9); }

static bat_curve *random_curve(int degree, int dimension, bool closed, int count) {
    double points[600], knots[220], t = 0, even = uniform(0, 1) < 0.4; /* nodes then lie on knots */
    int total = closed ? count + 1 : count + degree + 1;
    for (int i = 0; i < count; i++) {
        points[i * dimension] = closed ? 200 * cos(6.2831853 * i / count) : 60.0 * i;
        points[i * dimension + 1] = closed ? 200 * sin(6.2831853 * i / count) : 0;
        if (dimension == 3) points[i * dimension + 2] = 0;
        for (int d = 0; d < dimension; d++) points[i * dimension + d] += uniform(-50, 50);
    }
    for (int i = 0; i < total; i++) {
        knots[i] = t;
        if (closed || (i >= degree && i < count)) t += even > 0 ? 1 : uniform(0.5, 2);
    }
    bat_curve *curve;
    assert_int_equal(bat_curve_create(dimension, degree, closed, (size_t)count, points, total, knots, &curve),
                     BAT_OK);
    return curve;
}

/* Details are read off a wrinkled curve or, made up, stand on midpoint refinements. */
static bat_shape *random_shape(int round, int degree, bat_frame_rule rule, bat_propagation propagation) {
    bool closed = (round / 2) % 2, taken = (round / 4) % 2;
    bat_shape_options options = bat_shape_defaults();
    options.frame = rule, options.propagation = propagation;
    options.nodes = (bat_node_rule)((round / 8) % 2);
    bat_curve *base = random_curve(degree, 2 + round % 2, closed, taken ? 100 : 24 + round % 5);
    bat_shape *shape;
    if (taken) {
        assert_int_equal(bat_shape_decompose(base, 2, &options, &shape), BAT_OK);
    } else {
        assert_int_equal(bat_shape_create(base, &options, &shape), BAT_OK);
        for (int j = 1; j <= 3; j++) {
            assert_int_equal(bat_shape_add_level(shape, 0, NULL, NULL, NULL), BAT_OK);
            int n = bat_point_count(bat_shape_curve(shape, j));
            for (int i = 0; i < n; i++) {
                double delta[3] = {uniform(-8, 8) / j, uniform(-8, 8) / j, uniform(-8, 8) / j};
                assert_int_equal(bat_shape_move(shape, j, i, delta), BAT_OK);
            }
        }
        assert_int_equal(bat_shape_set_gain(shape, 2, 1.5), BAT_OK);
    }
    bat_curve_free(base);
    assert_int_equal(bat_shape_commit(shape), BAT_OK);
    return shape;
}

static double apart(const bat_curve *a, const bat_curve *b) {
    double worst = 0;
    assert_int_equal(bat_curve_count(a), bat_point_count(b));
    for (int i = 0; i < bat_point_count(a) * bat_curve_dimension(a); i++)
        worst = fmax(worst, fabs(bat_curve_points(a)[i] - bat_curve_points(b)[i]));
    return worst;
}

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* The bookkeeping of math 3.4 over whole open curves: frames of the chain, turned back by the smoothstep of the
 * angle by which the chain comes out of the stretch; then the next level from below. `touched`: the knots of the
 * level below between which its curve has changed. */
static bat_curve *next_level(const bat_shape *before, const bat_curve *below, int level, double touched[2]) {
    const bat_curve *old_below = bat_shape_curve(before, level - 1), *old = bat_shape_curve(before, level);
    const bat_shape_options *o = bat_shape_options_of(before);
    int n = bat_point_count(old), size = bat_curve_dimension(old), p = bat_curve_degree(old);
    double domain[2], a = touched[0], b = touched[1], angle = 0;
    bat_curve_domain(old, domain);
    bat_frame_options options = bat_frame_defaults();
    options.has_reference = o->has_reference;
    memcpy(options.reference_t, o->reference_t, sizeof o->reference_t);
    memcpy(options.reference_s, o->reference_s, sizeof o->reference_s);
    bat_frame_chain *chain[2];
    assert_int_equal(bat_frame_chain_create(old_below, &options, &chain[0]), BAT_OK);
    assert_int_equal(bat_frame_chain_create(below, &options, &chain[1]), BAT_OK);
    bat_frame3 f[2];
    if (b < domain[1] && size == 3) {
        for (int k = 0; k < 2; k++) bat_frame_chain_at(chain[k], b, &f[k]);
        angle = atan2(dot(f[1].s, f[0].r), dot(f[1].s, f[0].s)); /* the new s against the old one */
    }
    const double *nodes = bat_shape_nodes(before, level), *details = bat_shape_details(before, level);
    double *points = malloc((size_t)(n * size) * sizeof(double)), low = INFINITY, high = -INFINITY;
    bat_curve *refined, *out;
    assert_int_equal(bat_curve_refine(below, bat_curve_knot_count(old), bat_curve_knots(old), &refined),
                     BAT_OK);
    for (int i = 0; i < n; i++) {
        double u = nodes[i], w = fmin(fmax((u - a) / (b - a), 0), 1);
        bool inside = (u > a || a == domain[0]) && (u < b || b == domain[1]);
        bat_frame_chain_at(chain[inside], u, &f[0]);
        double turn = !inside ? 0 : a == domain[0] ? -angle : -angle * w * w * (3 - 2 * w), s[3], r[3];
        for (int d = 0; d < 3; d++) {
            s[d] = cos(turn) * f[0].s[d] + sin(turn) * f[0].r[d];
            r[d] = cos(turn) * f[0].r[d] - sin(turn) * f[0].s[d];
        }
        const double *e = details + 3 * i;
        for (int d = 0; d < size; d++)
            points[i * size + d] = bat_curve_points(refined)[i * size + d] +
                                   bat_shape_gain(before, level) *
                                       (e[0] * f[0].t[d] + e[1] * s[d] + e[2] * r[d]);
        if (inside) {
            low = fmin(low, fmax(bat_curve_knots(old)[i], domain[0]));
            high = fmax(high, fmin(bat_curve_knots(old)[i + p + 1], domain[1]));
        }
    }
    touched[0] = low, touched[1] = high;
    assert_int_equal(bat_curve_create(size, p, false, (size_t)n, points, bat_curve_knot_count(old),
                                      bat_curve_knots(old), &out),
                     BAT_OK);
    free(points);
    bat_curve_free(refined);
    bat_frame_chain_free(chain[0]);
    bat_frame_chain_free(chain[1]);
    return out;
}

static void edits_equal_the_whole_formula(void **state) {
    (void)state;
    seed = 11;
    int checked = 0;
    for (int round = 0; round < 40; round++) {
        if ((round / 2) % 2) continue; /* open */
        int degree = 2 + round % 3;
        bat_shape *shape = random_shape(round, degree, BAT_FRAMES_RMF, BAT_PROPAGATION_LOCAL), *before;
        int usual = 1;
        for (int l = 1; l <= bat_shape_levels(shape); l++)
            for (int i = 0; i < bat_point_count(bat_shape_curve(shape, l)); i++)
                usual = usual && bat_shape_source(shape, l)[i] == l - 1;
        if (!usual) {
            bat_shape_free(shape);
            continue;
        }
        assert_int_equal(bat_shape_copy(shape, &before), BAT_OK);
        const bat_curve *base = bat_shape_curve(before, 0);
        int n = bat_point_count(base),
            first = round % 5 == 0   ? 0
                    : round % 5 == 1 ? n - 3
                                     : pick(n - 3),
            size = 2 + round % 2;
        double deltas[9], domain[2];
        for (int i = 0; i < 9; i++) deltas[i] = uniform(-20, 20);
        assert_int_equal(bat_shape_move_many(shape, 0, first, 3, deltas), BAT_OK);
        bat_curve_domain(base, domain);
        double touched[2] = {fmax(bat_curve_knots(base)[first], domain[0]),
                             fmin(bat_curve_knots(base)[first + 3 + degree], domain[1])};
        bat_curve *expected;
        double *points = malloc((size_t)(n * size) * sizeof(double));
        memcpy(points, bat_curve_points(base), (size_t)(n * size) * sizeof(double));
        for (int i = 0; i < 3 * size; i++) points[first * size + i] += deltas[i];
        assert_int_equal(bat_curve_create(size, degree, false, (size_t)n, points, bat_curve_knot_count(base),
                                          bat_curve_knots(base), &expected),
                         BAT_OK);
        free(points);
        for (int l = 1; l <= bat_shape_levels(shape); l++) {
            bat_curve *next = next_level(before, expected, l, touched);
            bat_curve_free(expected);
            expected = next;
            assert_true(apart(expected, bat_shape_curve(shape, l)) < 1e-12 * bat_curve_size(expected));
        }
        checked++;
        bat_curve_free(expected);
        bat_shape_free(before);
        bat_shape_free(shape);
    }
    assert_true(checked > 9);
}

static bat_shape *read_back(const bat_shape *shape) {
    char *text;
    size_t size;
    bat_shape *again;
    bat_problem problem;
    assert_int_equal(bat_shape_write(shape, &text, &size), BAT_OK);
    assert_int_equal(bat_shape_read(text, size, &again, &problem), BAT_OK);
    bat_free(text);
    return again;
}

/* All kinds, rules and levels: what lies outside the run that is told as touched stays bit for bit; the way there
 * does not matter; nothing asked gives the shape as it was; one shot, session and a file read back agree. */
static void sessions(void **state) {
    (void)state;
    seed = 12;
    int partly = 0;
    for (int round = 0; round < 66; round++) {
        bat_frame_rule rule = (bat_frame_rule)(round % 5 < 3 ? 0 : round % 5 - 2);
        bat_shape *shape = random_shape(round, 1 + round % 4, rule, (bat_propagation)(round % 11 == 0)),
                  *after, *way;
        int level = round % (bat_shape_levels(shape) + 1), first;
        size_t touched;
        const bat_curve *curve = bat_shape_curve(shape, level);
        double domain[2], far = round % 7 == 0 ? 400 : 30,
                          delta[3] = {uniform(-far, far), uniform(-far, far), uniform(-far, far)},
                          zero[3] = {0}, u;
        bat_curve_domain(curve, domain);
        u = uniform(domain[0], domain[1]);
        bat_shape_live *live;
        assert_int_equal(bat_shape_live_begin(shape, level, &live), BAT_OK);
        for (int i = 0; i < 5; i++) {
            double some[3] = {uniform(-60, 60), uniform(-60, 60), uniform(-60, 60)};
            assert_int_equal(bat_shape_live_drag(live, i < 3 ? u : uniform(domain[0], domain[1]), some),
                             BAT_OK);
        }
        assert_int_equal(bat_shape_live_drag(live, u, zero), BAT_OK);
        assert_true(shapes_same(shape, bat_shape_live_shape(live)));
        assert_int_equal(bat_shape_live_drag(live, u, delta), BAT_OK);
        for (int l = 0; l <= bat_shape_levels(shape); l++) {
            const bat_curve *a = bat_shape_curve(shape, l),
                            *b = bat_shape_curve(bat_shape_live_shape(live), l);
            int n = bat_point_count(a), size = bat_curve_dimension(a);
            bat_shape_live_touched(live, l, &first, &touched);
            int count = (int)touched;
            assert_true(count <= n && (l >= level || count == 0));
            partly += count > 0 && count < n / 2;
            for (int k = count; k < n; k++) {
                int i = (first + k) % n;
                assert_memory_equal(bat_curve_points(a) + i * size, bat_curve_points(b) + i * size,
                                    (size_t)size * sizeof(double));
                if (l > 0)
                    assert_memory_equal(bat_shape_details(shape, l) + 3 * i,
                                        bat_shape_details(bat_shape_live_shape(live), l) + 3 * i,
                                        3 * sizeof(double));
            }
        }
        assert_int_equal(bat_shape_live_commit(live, &after), BAT_OK);
        assert_int_equal(bat_shape_copy(shape, &way), BAT_OK);
        assert_int_equal(bat_shape_drag(way, level, u, zero), BAT_OK);
        assert_true(shapes_same(shape, way));
        assert_int_equal(bat_shape_drag(way, level, u, delta), BAT_OK);
        bat_shape *early = read_back(way); /* before the commit: the same drawing */
        const bat_curve *finest = bat_shape_curve(way, bat_shape_levels(way));
        double size = bat_curve_size(finest);
        assert_true(apart(finest, bat_shape_curve(early, bat_shape_levels(way))) < 1e-12 * size);
        bat_curve *kept;
        assert_int_equal(bat_curve_copy(finest, &kept), BAT_OK);
        assert_int_equal(bat_shape_commit(way), BAT_OK);
        assert_true(apart(kept, bat_shape_curve(way, bat_shape_levels(way))) < 1e-12 * size);
        assert_true(shapes_same(way, after));
        bat_shape *again = read_back(after);
        assert_true(shapes_same(again, after));
        /* And back, to rounding; not promised where plain propagation has wound a loop once round. */
        for (int d = 0; d < 3; d++) delta[d] = -delta[d];
        assert_int_equal(bat_shape_drag(after, level, u, delta), BAT_OK);
        if (round % 11 != 0)
            assert_true(apart(bat_shape_curve(after, bat_shape_levels(after)),
                              bat_shape_curve(shape, bat_shape_levels(shape))) < 1e-12 * size);
        bat_curve_free(kept);
        bat_shape_free(early);
        bat_shape_free(again);
        bat_shape_free(way);
        bat_shape_free(after);
        bat_shape_free(shape);
    }
    assert_true(partly > 40);
}

/* An edit, small or many times the size of the curve, committed, and the same one back: every level is as it was, also
 * where frames have wound round on the way. */
static void there_and_back(void **state) {
    (void)state;
    seed = 14;
    const double reach[4] = {30, 200, 600, 3000};
    int wide = 0;
    for (int round = 0; round < 320; round++) {
        bat_shape *shape = random_shape(round, 1 + round / 4 % 5, (bat_frame_rule)(round % 9 == 0),
                                        BAT_PROPAGATION_LOCAL),
                  *after;
        int level = round / 3 % (bat_shape_levels(shape) + 1);
        double domain[2], far = reach[round / 2 % 4], u,
                          delta[3] = {uniform(-far, far), uniform(-far, far), uniform(-far, far)};
        bat_curve_domain(bat_shape_curve(shape, level), domain);
        u = uniform(domain[0], domain[1]);
        assert_int_equal(bat_shape_copy(shape, &after), BAT_OK);
        assert_int_equal(bat_shape_drag(after, level, u, delta), BAT_OK);
        assert_int_equal(bat_shape_commit(after), BAT_OK);
        wide += bat_curve_dimension(bat_shape_curve(after, 0)) == 3 && far > 100;
        for (int d = 0; d < 3; d++) delta[d] = -delta[d];
        assert_int_equal(bat_shape_drag(after, level, u, delta), BAT_OK);
        assert_int_equal(bat_shape_commit(after), BAT_OK);
        for (int l = 0; l <= bat_shape_levels(shape); l++)
            assert_true(apart(bat_shape_curve(after, l), bat_shape_curve(shape, l)) <
                        1e-12 * bat_curve_size(bat_shape_curve(shape, l)));
        bat_shape_free(after);
        bat_shape_free(shape);
    }
    assert_true(wide > 100);
}

/* Each allocation that an edit makes fails once: the shape is as it was, nothing leaks. */
static void failing_allocations(void **state) {
    (void)state;
    seed = 13;
    for (int round = 0; round < 6; round++) {
        bat_frame_rule rule = (bat_frame_rule)(round / 2 % 3);
        bat_shape *shape = random_shape(round, 3, rule, BAT_PROPAGATION_LOCAL), *copy = NULL, *none;
        assert_int_equal(bat_shape_copy(shape, &copy), BAT_OK);
        double delta[3] = {3, -4, 5}, left;
        for (int call = 0; call < 5; call++)
            for (int n = 1;; n++) {
                long live_blocks = alloc_live();
                bat_shape_live *live = NULL;
                none = NULL;
                alloc_fail_at(n);
                bat_status status = BAT_OK;
                switch (call) {
                case 0: status = bat_shape_drag(shape, 0, 1, delta); break;
                case 1: status = bat_shape_drag_finest(shape, 1, 1, delta, 1e-6, &left); break;
                case 2: status = bat_shape_set_gain(shape, 1, 0.5); break;
                case 3: status = bat_shape_copy(shape, &none); break;
                case 4:
                    status = bat_shape_live_begin(shape, 0, &live);
                    if (status == BAT_OK) status = bat_shape_live_drag(live, 1, delta);
                    if (status == BAT_OK) status = bat_shape_live_drag(live, 6, delta);
                    if (status == BAT_OK)
                        status = bat_shape_live_commit(live, &none);
                    else
                        bat_shape_live_cancel(live);
                    break;
                default: break;
                }
                bool reached = alloc_fail_reached();
                if (reached) {
                    assert_int_equal(status, BAT_MEMORY);
                    assert_true(shapes_same(shape, copy));
                    assert_true(alloc_live() == live_blocks);
                    continue;
                }
                assert_int_equal(status, BAT_OK);
                bat_shape_free(none);
                bat_shape *fresh;
                assert_int_equal(bat_shape_copy(copy, &fresh), BAT_OK);
                bat_shape_free(shape);
                shape = fresh;
                break;
            }
        bat_shape_free(copy);
        bat_shape_free(shape);
    }
}

static void bad_live_arguments(void **state) {
    (void)state;
    seed = 14;
    bat_shape *shape = random_shape(1, 3, BAT_FRAMES_RMF, BAT_PROPAGATION_LOCAL), *out = NULL;
    bat_shape_live *live = NULL;
    double delta[3] = {1, 2, 3}, nan[3] = {NAN, 0, 0}, huge[3] = {1e75, 1e75, 1e75}, left;
    assert_int_equal(bat_shape_live_begin(shape, 9, &live), BAT_ARGUMENT);
    assert_int_equal(bat_shape_live_begin(NULL, 0, &live), BAT_ARGUMENT);
    assert_int_equal(bat_shape_live_begin(shape, 0, &live), BAT_OK);
    assert_int_equal(bat_shape_live_drag(live, 1, delta), BAT_OK);
    assert_int_equal(bat_shape_live_drag(live, NAN, delta), BAT_NUMBER);
    assert_int_equal(bat_shape_live_drag(live, 1, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_shape_live_drag_finest(live, 1, nan, 1, &left), BAT_NUMBER);
    assert_int_equal(bat_shape_live_drag_finest(live, 1, delta, 0, &left), BAT_ARGUMENT);
    assert_int_equal(bat_shape_live_move(live, -1, 1, delta), BAT_ARGUMENT);
    assert_int_equal(bat_shape_live_move(live, 0, 1000, delta), BAT_ARGUMENT);
    assert_int_equal(bat_shape_live_move(live, 2, 1, nan), BAT_NUMBER);
    assert_true(shapes_same(shape, bat_shape_live_shape(live)));
    assert_int_equal(bat_shape_live_drag(live, 1, huge), BAT_NUMBER);
    assert_true(shapes_same(shape, bat_shape_live_shape(live)));
    assert_int_equal(bat_shape_live_commit(live, NULL), BAT_ARGUMENT);
    bat_shape_live_cancel(NULL);
    assert_int_equal(bat_shape_live_commit(NULL, &out), BAT_ARGUMENT);
    bat_shape_free(shape);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(edits_equal_the_whole_formula),
        cmocka_unit_test(sessions),
        cmocka_unit_test(there_and_back),
        cmocka_unit_test(failing_allocations),
        cmocka_unit_test(bad_live_arguments),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
