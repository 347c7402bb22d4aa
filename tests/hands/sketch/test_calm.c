/* Calming: ten times on many curves, it adds no extremum, inflection, knot or curvature peak, never moves the curve
 * farther than the limit, and keeps ends and corners in place and smooth nodes smooth. label: slow */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <string.h>
#include <cmocka.h>
#include <batten/batten.h>
#include "curve/curve.h"
#include "support/random_curve.h"

enum { PLACES = 1500 };

typedef struct comb {
    int extrema, inflections;
    double peak, variation;
} comb;

/* By plain sampling. Extrema: those deeper than a share of the range. */
static comb comb_of(const bat_curve *curve, double share) {
    double domain[2], k[PLACES + 1], low, high, depth;
    comb out = {0, 0, 0, 0};
    bat_curve_domain(curve, domain);
    for (int i = 0; i <= PLACES; i++)
        k[i] = bat_curve_curvature(curve, domain[0] + (domain[1] - domain[0]) * i / PLACES);
    low = high = k[0];
    for (int i = 0; i <= PLACES; i++) {
        low = fmin(low, k[i]), high = fmax(high, k[i]);
        out.peak = fmax(out.peak, fabs(k[i]));
        if (i) out.variation += fabs(k[i] - k[i - 1]);
        if (i) out.inflections += k[i] * k[i - 1] < 0;
    }
    depth = (high - low) * share;
    low = high = k[0];
    for (int i = 1, way = 0; i <= PLACES; i++) {
        low = fmin(low, k[i]), high = fmax(high, k[i]);
        if (way >= 0 && k[i] < high - depth)
            out.extrema += way > 0, way = -1, low = high = k[i];
        else if (way <= 0 && k[i] > low + depth)
            out.extrema += way < 0, way = 1, low = high = k[i];
    }
    return out;
}

/* 0: an S; 1: one that trembles; 2: a wild line; 3: a closed one. */
static bat_curve *curve_of(random_source *r, int kind, int round) {
    int p = round % 5 == 4 ? 4 : round % 7 == 6 ? 2 : 3, n = 6 + round % 14;
    double points[80], knots[40];
    for (int i = 0; i < n; i++) {
        double t = (double)i / (n - 1), w = 6.283185307179586 * (kind == 3 ? (double)i / n : t);
        points[2 * i] = kind == 3 ? 400 + 200 * cos(w) : 100 + 600 * t;
        points[2 * i + 1] = kind == 2 ? 300 + random_between(r, -60, 60)
                                      : 300 + (kind == 3 ? 200 : 120) * sin(w);
        for (int c = 0; c < 2 && kind; c++) points[2 * i + c] += random_between(r, -4, 4);
    }
    double t = 0;
    for (int i = 0; i < n + p + 1; i++) {
        bool inside = kind == 3 || (i > p && i <= n);
        knots[i] = i &&inside ? t += random_between(r, 0.6, 1.4) : t;
    }
    bat_curve *curve = NULL;
    assert_int_equal(
        bat_curve_create(2, p, kind == 3, (size_t)n, points, (kind == 3) ? n + 1 : n + p + 1, knots, &curve),
        BAT_OK);
    return curve;
}

static void never_worse(void **state) {
    (void)state;
    random_source r = {21};
    int done = 0;
    for (int round = 0; round < 24; round++) {
        int kind = round % 4;
        bat_curve *curve = curve_of(&r, kind, round), *next = NULL;
        double domain[2], range[2], there, back;
        bat_curve_domain(curve, domain);
        for (int press = 0; press < 10; press++) {
            double u = press % 2 ? random_between(&r, domain[0], domain[1]) : (domain[0] + domain[1]) / 2;
            double half = (domain[1] - domain[0]) * (round % 3 ? 0.2 : 0.5);
            range[0] = u - half, range[1] = u + half;
            bat_status status = bat_sketch_calm(curve, range, 1, 1, &next);
            if (status == BAT_STATE) continue;
            assert_int_equal(status, BAT_OK);
            done++;
            assert_int_equal(bat_curve_distance(curve, next, 8, &there, &back), BAT_OK);
            assert_true(fmax(there, back) <= 1.02);
            assert_memory_equal(bat_curve_knots(next), bat_curve_knots(curve),
                                (size_t)bat_curve_knot_count(curve) * sizeof(double));
            /* What is deeper than a thousandth now was a third of that before, at least. */
            comb before = comb_of(curve, 3e-4), after = comb_of(next, 1e-3);
            /* A closed curve is cut where sampling begins, which may hide an extremum. */
            if (after.extrema > before.extrema + (kind == 3) || after.inflections > before.inflections ||
                after.peak > before.peak * 1.002 || after.variation > before.variation * 1.001)
                fail_msg("round %d, press %d: extrema %d to %d, inflections %d to %d, peak %g to %g", round,
                         press, before.extrema, after.extrema, before.inflections, after.inflections,
                         before.peak, after.peak);
            if (kind != 3)
                for (int i = 0; i < 4; i++) { /* ends, and the points that hold their directions */
                    int point = i < 2 ? i : bat_point_count(curve) - 1 - (i - 2);
                    assert_memory_equal(bat_curve_points(next) + 2 * point,
                                        bat_curve_points(curve) + 2 * point, 2 * sizeof(double));
                }
            bat_curve_free(curve);
            curve = next;
        }
        bat_curve_free(curve);
    }
    assert_true(done > 60);
}

/* A trembling line comes to rest, and its sweep stays. */
static void trembling_goes(void **state) {
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        double points[120], knots[70];
        int n = 60;
        for (int i = 0; i < n; i++) {
            points[2 * i] = 10.0 * i;
            points[2 * i + 1] = (kind ? 80 * sin(i * 0.08) : 0) + 1.5 * sin(i * 2.1);
        }
        for (int i = 0; i < n + 4; i++) knots[i] = i < 4 ? 0 : i >= n ? n - 3 : i - 3;
        bat_curve *curve = NULL, *next = NULL;
        assert_int_equal(bat_curve_create(2, 3, false, (size_t)n, points, n + 4, knots, &curve), BAT_OK);
        double range[2] = {0, 57};
        comb before = comb_of(curve, 1e-4);
        for (int press = 0; press < 10; press++) {
            if (bat_sketch_calm(curve, range, 1, 1, &next) != BAT_OK) break;
            bat_curve_free(curve);
            curve = next;
        }
        comb after = comb_of(curve, 1e-4);
        assert_true(after.variation < before.variation / 2 && after.extrema <= before.extrema);
        double worst = 0;
        for (int i = 0; i <= 200; i++) { /* the middle; the sweep, as far as cubics of its points go */
            double at[2], u = 12 + 33.0 * i / 200;
            bat_curve_eval(curve, u, 0, at);
            worst = fmax(worst, fabs(at[1] - (kind ? 80 * sin(at[0] * 0.008) : 0)));
        }
        assert_true(worst < 2.5);
        bat_curve_free(curve);
    }
}

/* A corner and a smooth node of full multiplicity, in the middle of what trembles. */
static void nodes_stay_what_they_are(void **state) {
    (void)state;
    random_source r = {9};
    for (int round = 0; round < 60; round++) {
        bool corner = round % 2;
        double points[38];
        double knots[24] = {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 7, 8, 9, 10, 11, 12, 12, 12, 12};
        for (int i = 0; i < 17; i++) {
            points[2 * i] = 40.0 * i;
            points[2 * i + 1] = random_between(&r, -4, 4) + (corner && i > 8 ? 30.0 * (i - 8) : 0);
        }
        double *on = points + 16, ratio = random_between(&r, 0.4, 2); /* point 8 lies on the knot 6 */
        for (int c = 0; c < 2 && !corner; c++) on[2 + c] = on[c] + ratio * (on[c] - on[c - 2]);
        bat_curve *curve = NULL, *next = NULL;
        assert_int_equal(bat_curve_create(2, 3, false, 17, points, 21, knots, &curve), BAT_OK);
        const double range[2] = {1, 11};
        if (bat_sketch_calm(curve, range, 2, 1, &next) == BAT_OK) {
            const double *now = bat_curve_points(next);
            if (corner) assert_memory_equal(now + 14, points + 14, 6 * sizeof(double));
            double a[2] = {now[16] - now[14], now[17] - now[15]},
                   b[2] = {now[18] - now[16], now[19] - now[17]};
            if (!corner)
                assert_true(fabs(a[0] * b[1] - a[1] * b[0]) < 1e-9 * hypot(a[0], a[1]) * hypot(b[0], b[1]));
            bat_curve_free(next);
        }
        bat_curve_free(curve);
    }
}

static void bad_data(void **state) {
    (void)state;
    random_source r = {2};
    bat_curve *curve = curve_of(&r, 1, 3), *out = NULL, *space = random_curve(&r, 3, 3, 0, 8);
    const double good[2] = {0, 5}, turned[2] = {5, 0}, none[2] = {NAN, 5}, far[2] = {1e9, 2e9},
                 endless[2] = {0, INFINITY};
    assert_int_equal(bat_sketch_calm(NULL, good, 1, 1, &out), BAT_ARGUMENT);
    assert_int_equal(bat_sketch_calm(curve, good, 1, 1, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_sketch_calm(curve, turned, 1, 1, &out), BAT_ARGUMENT);
    assert_int_equal(bat_sketch_calm(curve, none, 1, 1, &out), BAT_ARGUMENT);
    assert_int_equal(bat_sketch_calm(curve, good, 0, 1, &out), BAT_ARGUMENT);
    assert_int_equal(bat_sketch_calm(curve, good, 1, NAN, &out), BAT_ARGUMENT);
    assert_int_equal(bat_sketch_calm(curve, endless, 1, 1, &out), BAT_NUMBER);
    assert_int_equal(bat_sketch_calm(curve, far, 1, 1, &out), BAT_PARAMETER);
    assert_int_equal(bat_sketch_calm(space, good, 1, 1, &out), BAT_DIMENSION);
    const double knots[] = {0, 0, 1, 1}, line[] = {0, 0, 300, 0}, dot[] = {5, 5, 5, 5, 5, 5, 5, 5};
    const double cubic[] = {0, 0, 0, 0, 1, 1, 1, 1}, unit[2] = {0, 1};
    bat_curve *flat = NULL, *point = NULL;
    bat_curve_create(2, 1, false, 2, line, 4, knots, &flat);
    assert_int_equal(bat_sketch_calm(flat, unit, 1, 1, &out), BAT_STATE);
    if (bat_curve_create(2, 3, false, 4, dot, 8, cubic, &point) == BAT_OK)
        assert_int_equal(bat_sketch_calm(point, unit, 1, 1, &out), BAT_STATE);
    assert_null(out);
    bat_curve_free(curve);
    bat_curve_free(space);
    bat_curve_free(flat);
    bat_curve_free(point);
}

/* Random curves of every kind, a stretch anywhere, a limit of any size: a status or a curve. */
static void anything_goes(void **state) {
    (void)state;
    random_source r = {77};
    for (int round = 0; round < 600; round++) {
        bat_curve *curve = random_curve(&r, 1 + round % 7, 2, round % 3, 1 + round % 23), *out = NULL;
        double domain[2], range[2];
        bat_curve_domain(curve, domain);
        range[0] = random_between(&r, domain[0] - 1, domain[1]);
        range[1] = range[0] + exp(random_between(&r, -9, 3));
        const double limit = exp(random_between(&r, -6, 3)), pixel = exp(random_between(&r, -6, 0));
        bat_status status = bat_sketch_calm(curve, range, limit, pixel, &out);
        assert_true(status == BAT_OK || status == BAT_STATE || status == BAT_PARAMETER);
        assert_true((status == BAT_OK) == (out != NULL));
        bat_curve_free(out);
        bat_curve_free(curve);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(never_worse),
        cmocka_unit_test(trembling_goes),
        cmocka_unit_test(nodes_stay_what_they_are),
        cmocka_unit_test(anything_goes),
        cmocka_unit_test(bad_data),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
