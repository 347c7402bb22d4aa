/* Offsets: every point of them is at the distance, and every point at the distance opposite the curve is on them; areas of
 * closed forms; loops, cusps and what vanishes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <cmocka.h>
#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/relate.h>
#include "support/random_curve.h"
#include "support/rounds.h"

enum { ROUNDS = ROUNDS_OF(800) };
static const double CORNER = 0.02;

/* Twice the area inside a closed curve, by 64 chords a span and Richardson's step. */
static double area_of(const bat_curve *curve) {
    double sums[2] = {0};
    for (int pass = 0; pass < 2; pass++) {
        const int n = (32 << pass) * bat_curve_segment_count(curve);
        double domain[2], x[2], y[2];
        bat_curve_domain(curve, domain);
        bat_curve_eval(curve, domain[0], 0, x);
        for (int k = 1; k <= n; k++) {
            bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * (k % n) / n, 0, y);
            sums[pass] += x[0] * y[1] - x[1] * y[0];
            x[0] = y[0], x[1] = y[1];
        }
    }
    return (4 * sums[1] - sums[0]) / 6;
}

/* Each point of the curve's parallel that is nowhere nearer to it lies on what was handed over, but for specks of a few
 * tolerances; and the other way. */
static void check(const bat_curve *curve, double distance, double tolerance, size_t count, bat_curve **out,
                  double error) {
    enum { SAMPLES = 500, CURVES = 200 };
    const double size = bat_curve_size(curve) + fabs(distance), hidden = 1e-12 * size;
    bat_finder *finder, *found[CURVES];
    assert_int_equal(bat_finder_create(curve, &finder), BAT_OK);
    bat_near near;
    double u[SAMPLES], first[2] = {0};
    bool missing = false;
    assert_true(error <= tolerance * 1.06 + hidden);
    assert_true(count <= CURVES);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(bat_finder_create(out[i], &found[i]), BAT_OK);
        bat_curve_spread(out[i], SAMPLES, u);
        for (int k = 0; k < SAMPLES; k++) {
            double x[2];
            bat_curve_eval(out[i], u[k], 0, x);
            bat_finder_nearest(finder, x, &near);
            assert_true(fabs(near.distance - fabs(distance)) <= 1.2 * tolerance + hidden);
        }
    }
    bat_curve_spread(curve, SAMPLES, u);
    for (int k = 0; k < SAMPLES; k++) {
        double x[4], best = INFINITY;
        bat_curve_eval(curve, u[k], 1, x);
        const double v = hypot(x[2], x[3]);
        if (!(v > 0)) continue;
        const double at[2] = {x[0] - distance * x[3] / v, x[1] + distance * x[2] / v};
        bat_finder_nearest(finder, at, &near);
        const bool asked = near.distance >= fabs(distance) * (1 - 1e-9);
        for (size_t i = 0; i < count && asked; i++) {
            bat_finder_nearest(found[i], at, &near);
            best = fmin(best, near.distance);
        }
        const bool misses = asked && !(best <= 2 * tolerance + hidden);
        if (misses && !missing) memcpy(first, at, sizeof first);
        missing = misses;
        assert_true(!misses || hypot(at[0] - first[0], at[1] - first[1]) <= 6 * tolerance + hidden);
    }
    for (size_t i = 0; i < count; i++) bat_finder_free(found[i]);
    bat_finder_free(finder);
}

typedef struct asked {
    bat_curve *curve;
    double distance, tolerance;
} asked;

static asked next_asked(random_source *r) {
    asked a;
    const int p = random_int(r, 1, 6), kind = random_int(r, 0, 2);
    a.curve = random_curve(r, p, 2, kind, random_int(r, 0, 7));
    const double size = bat_curve_size(a.curve);
    a.tolerance = size * pow(10, -random_between(r, 2.5, 5));
    const double side = random_int(r, 0, 1) ? 1 : -1;
    a.distance = side * size * pow(10, -random_between(r, 0.3, 2));
    return a;
}

/* Returns of how many curves the offset is. */
static size_t try_out(const asked *a) {
    bat_curve **out;
    size_t count;
    double error;
    assert_int_equal(bat_curve_offset(a->curve, a->distance, a->tolerance, CORNER, &count, &out, &error),
                     BAT_OK);
    check(a->curve, a->distance, a->tolerance, count, out, error);
    bat_curves_free(count, out);
    return count;
}

/* One round in a thousand needs a rare way through the code: of these seeds the second has an island whose curve has a cusp
 * within, the third a stretch that a cubic with a handle as long as the drawing seems to fit, the fourth a cusp that takes most
 * of the parameters. */
static void offsets_are_at_the_distance(void **state) {
    (void)state;
    const uint64_t seeds[] = {61, 8, 12, 13};
    random_source r;
    int several = 0;
    for (size_t i = 0; i < sizeof seeds / sizeof *seeds; i++) {
        r = (random_source){seeds[i]};
        for (int round = 0; round < ROUNDS; round++) {
            const asked a = next_asked(&r);
            several += try_out(&a) > 1;
            bat_curve_free(a.curve);
        }
    }
    assert_true(several > 0);
}

/* Two of twenty thousand have a tip that lies between two samples of a span. */
static void turns_between_samples_are_seen(void **state) {
    (void)state;
    const struct {
        uint64_t seed;
        int round;
    } rare[] = {{9, 1077}, {20, 319}};
    for (size_t i = 0; i < sizeof rare / sizeof *rare; i++) {
        random_source r = {rare[i].seed};
        for (int round = 0; round <= rare[i].round; round++) {
            const asked a = next_asked(&r);
            if (round == rare[i].round) try_out(&a);
            bat_curve_free(a.curve);
        }
    }
}

static bat_curve *square(double side) {
    const double points[] = {0, 0, side, 0, side, side, 0, side};
    bat_curve *curve;
    assert_int_equal(bat_curve_create(2, 1, true, 4, points, 5, (const double[]){0, 1, 2, 3, 4}, &curve),
                     BAT_OK);
    return curve;
}

static void squares_have_closed_forms(void **state) {
    (void)state;
    bat_curve *curve = square(10), **out;
    size_t count;
    for (int i = 1; i <= 6; i++) { /* inwards: a smaller square, until nothing is left */
        assert_int_equal(bat_curve_offset(curve, i, 1e-6, CORNER, &count, &out, NULL), BAT_OK);
        assert_int_equal(count, i < 5 ? 1 : 0);
        if (count) {
            const double side = 10 - 2 * i;
            assert_true(bat_curve_is_closed(out[0]) && fabs(area_of(out[0]) - side * side) <= 1e-5);
        }
        bat_curves_free(count, out);
    }
    for (int i = 1; i <= 20; i += 3) { /* outwards: sides and quarters of a circle */
        double error;
        assert_int_equal(bat_curve_offset(curve, -i, 1e-6, CORNER, &count, &out, &error), BAT_OK);
        assert_int_equal(count, 1);
        assert_true(error <= 1e-6);
        assert_true(fabs(area_of(out[0]) - (100 + 40 * i + acos(-1) * i * i)) <=
                    1e-5 * (40 + 2 * acos(-1) * i));
        bat_curves_free(count, out);
    }
    bat_curve_free(curve);
}

static void rings_have_closed_forms(void **state) {
    (void)state;
    /* A smooth closed curve without cusps: Steiner's formula, area + length d + pi d^2. */
    const double points[] = {10, 0, 7, 7, 0, 9, -7, 7, -10, 0, -7, -7, 0, -9, 7, -7},
                 knots[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    for (int p = 3; p <= 5; p++) {
        bat_curve *ring, **out;
        assert_int_equal(bat_curve_create(2, p, true, 8, points, 9, knots, &ring), BAT_OK);
        const double length = bat_curve_length(ring, 0, 8, 1e-12), area = area_of(ring);
        for (double d = -3; d <= 3; d += 1.5) {
            size_t count;
            double error;
            assert_int_equal(bat_curve_offset(ring, d, 1e-5, CORNER, &count, &out, &error), BAT_OK);
            assert_int_equal(count, 1);
            assert_true(bat_curve_is_closed(out[0]) && error <= 1e-5);
            assert_true(fabs(area_of(out[0]) - (area - length * d + acos(-1) * d * d)) <= 1e-5 * length);
            assert_true(bat_curve_count(out[0]) <= 80);
            bat_curves_free(count, out);
        }
        bat_curve_free(ring);
    }
}

static void a_waist_comes_apart(void **state) {
    (void)state;
    const double points[] = {10, -6, 10, 6, 0, 1, -10, 6, -10, -6, 0, -1}, knots[] = {0, 1, 2, 3, 4, 5, 6};
    bat_curve *waist, **out;
    assert_int_equal(bat_curve_create(2, 2, true, 6, points, 7, knots, &waist), BAT_OK);
    size_t count;
    double error;
    assert_int_equal(bat_curve_offset(waist, 3, 1e-5, CORNER, &count, &out, &error), BAT_OK);
    assert_int_equal(count, 2);
    for (size_t i = 0; i < count; i++) assert_true(bat_curve_is_closed(out[i]) && area_of(out[i]) > 0);
    check(waist, 3, 1e-5, count, out, error);
    bat_curves_free(count, out), bat_curve_free(waist);
}

static void cusps_end(void **state) {
    (void)state;
    /* tight bends, cusps, handles without length, a curve that runs back: at distances around their radii */
    const double cases[][8] = {
        {0, 0, 10, 10, 0, 10, 10, 0},      {0, 0, 10, 0, -5, 0, 5, 0},
        {0, 0, 0, 0, 10, 10, 10, 10},      {0, 0, 10, 0, 10, 0, 10, 10},
        {0, 0, 11, 10, -1, 10, 10, 0},     {0, 0, 9.9, 10, 0.1, 10, 10, 0},
        {0, 0, 1e-9, 1, 10, 1e-9, 10, 10}, {51, 0, -0.0859375, 161.640625, 0, 164, 0, 164},
        {3, 3, 3, 3, 3, 3, 3, 3}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        for (double d = -4; d <= 4; d += 0.77)
            for (double tolerance = 1e-1; tolerance > 1e-8; tolerance /= 100) {
                bat_curve *curve, **out;
                assert_int_equal(bat_curve_create_clamped(2, 3, 4, cases[i], &curve), BAT_OK);
                size_t count;
                double error;
                assert_int_equal(bat_curve_offset(curve, d, tolerance, CORNER, &count, &out, &error), BAT_OK);
                size_t all = 0;
                for (size_t k = 0; k < count; k++) all += bat_curve_count(out[k]);
                assert_true(all <= 3000);
                if (i != 8) check(curve, d, tolerance, count, out, error);
                bat_curves_free(count, out), bat_curve_free(curve);
            }
}

static void bad_arguments(void **state) {
    (void)state;
    bat_curve *space, *curve = square(1), **out;
    size_t count;
    assert_int_equal(bat_curve_create_clamped(3, 1, 2, (const double[]){0, 0, 0, 1, 1, 1}, &space), BAT_OK);
    assert_int_equal(bat_curve_offset(space, 1, 1, 0, &count, &out, NULL), BAT_DIMENSION);
    assert_int_equal(bat_curve_offset(curve, (double)NAN, 1, 0, &count, &out, NULL), BAT_NUMBER);
    assert_int_equal(bat_curve_offset(curve, 1e200, 1, 0, &count, &out, NULL), BAT_NUMBER);
    assert_int_equal(bat_curve_offset(curve, 1, 0, 0, &count, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_offset(NULL, 1, 1, 0, &count, &out, NULL), BAT_ARGUMENT);
    assert_int_equal(bat_curve_offset(curve, 1e70, 1, 0, &count, &out, NULL), BAT_TOLERANCE);
    assert_int_equal(bat_curve_offset(curve, 1, 1e-30, 0, &count, &out, NULL), BAT_TOLERANCE);
    assert_int_equal(bat_curve_offset(curve, 0, 1, 0, &count, &out, NULL), BAT_OK);
    assert_true(count == 1 && bat_curve_is_equal(out[0], curve));
    bat_curves_free(count, out), bat_curves_free(0, NULL);
    bat_curve_free(space), bat_curve_free(curve);
}

/* A tolerance that no curve needs gives what any other such tolerance gives, up to those whose squares are infinite. */
static void tolerances_beyond_all_sizes(void **state) {
    (void)state;
    double points[2 * 24];
    for (int i = 0; i < 24; i++) points[2 * i] = i, points[2 * i + 1] = i % 4 - 1.5;
    static const double tolerances[] = {1e30, 1e100, 1e154, 1e200, 1e300, (double)INFINITY};
    bat_curve *curve, **all[6];
    size_t counts[6];
    assert_int_equal(bat_curve_create_clamped(2, 3, 24, points, &curve), BAT_OK);
    for (int k = 0; k < 6; k++) {
        assert_int_equal(bat_curve_offset(curve, 0.1, tolerances[k], 0.05, &counts[k], &all[k], NULL),
                         BAT_OK);
        assert_int_equal(counts[k], counts[0]);
        for (size_t i = 0; i < counts[k]; i++) assert_true(bat_curve_is_equal(all[k][i], all[0][i]));
    }
    for (int k = 0; k < 6; k++) bat_curves_free(counts[k], all[k]);
    bat_curve_free(curve);
}

/* A curve times a power of two has the offset and the outline times it, down to sizes whose squares vanish. */
static void sizes_do_not_matter(void **state) {
    (void)state;
    random_source r = {300};
    static const int powers[] = {-20, 20, -500, -1000};
    for (int round = 0; round < 6; round++) {
        bat_curve *curve = random_curve(&r, 3, 2, round % 3, 6), **plain[2];
        size_t count[2];
        const bat_nib nib = {2, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4};
        assert_int_equal(bat_curve_offset(curve, 0.5, 1e-3, 0.05, &count[0], &plain[0], NULL), BAT_OK);
        assert_int_equal(bat_curve_outline(curve, &nib, 1e-3, 0.05, &count[1], &plain[1], NULL), BAT_OK);
        for (size_t k = 0; k < sizeof powers / sizeof *powers; k++) {
            const double f = ldexp(1, powers[k]), rows[6] = {f, 0, 0, 0, f, 0};
            const bat_nib same = {2 * f, BAT_CAP_ROUND, BAT_JOIN_ROUND, 4};
            bat_curve *scaled, **out[2];
            size_t n[2];
            assert_int_equal(bat_curve_transform(curve, rows, &scaled), BAT_OK);
            assert_int_equal(bat_curve_offset(scaled, 0.5 * f, 1e-3 * f, 0.05, &n[0], &out[0], NULL), BAT_OK);
            assert_int_equal(bat_curve_outline(scaled, &same, 1e-3 * f, 0.05, &n[1], &out[1], NULL), BAT_OK);
            for (int w = 0; w < 2; w++) {
                assert_int_equal(n[w], count[w]);
                for (size_t i = 0; i < n[w]; i++) {
                    assert_int_equal(bat_curve_count(out[w][i]), bat_curve_count(plain[w][i]));
                    for (size_t j = 0; j < 2 * bat_curve_count(out[w][i]); j++)
                        assert_true(fabs(bat_curve_points(out[w][i])[j] / f -
                                         bat_curve_points(plain[w][i])[j]) < 1e-6);
                }
                bat_curves_free(n[w], out[w]);
            }
            bat_curve_free(scaled);
        }
        for (int w = 0; w < 2; w++) bat_curves_free(count[w], plain[w]);
        bat_curve_free(curve);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(offsets_are_at_the_distance),
        cmocka_unit_test(squares_have_closed_forms),
        cmocka_unit_test(rings_have_closed_forms),
        cmocka_unit_test(a_waist_comes_apart),
        cmocka_unit_test(cusps_end),
        cmocka_unit_test(turns_between_samples_are_seen),
        cmocka_unit_test(bad_arguments),
        cmocka_unit_test(tolerances_beyond_all_sizes),
        cmocka_unit_test(sizes_do_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
