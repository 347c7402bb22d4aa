/*
 * Spans that are walked side by side have bit for bit the frames that they have when they are walked one at a time. Eight spans are walked
 * side by side; the same spans at the start of a curve that has only seven are not. Some of them are so bent that they
 * need more steps, and some are not regular.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <batten/frames.h>

enum { MANY = 40, FEW = 10, SAMPLES = 400 }; /* control points of cubics; FEW have seven spans */

static uint64_t seed;
static double uniform(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 11) / 9007199254740992.0;
}

/* Knots that are not clamped, so that a curve of fewer points has the same spans. */
static bat_curve *first_of(const double *points, const double *knots, size_t count) {
    bat_curve *curve;
    assert_int_equal(bat_curve_create(3, 3, false, count, points, (int)count + 4, knots, &curve), BAT_OK);
    return curve;
}

static void frames_of(const bat_curve *curve, int substeps, const double *u, double *point, double *t,
                      double *s) {
    bat_frame_options options = bat_frame_defaults();
    bat_frame_chain *chain;
    const bat_frame_arrays out = {point, t, s, NULL};
    options.substeps = substeps;
    assert_int_equal(bat_frame_chain_create(curve, &options, &chain), BAT_OK);
    assert_int_equal(bat_frame_chain_many(chain, SAMPLES, u, &out), BAT_OK);
    bat_frame_chain_free(chain);
}

/* jagged: how far points lie off a line, in units of their distance; same: a run of equal points. */
static void compare(double jagged, bool same, int substeps) {
    static double u[SAMPLES], whole[3][3 * SAMPLES], part[3][3 * SAMPLES];
    double points[3 * MANY], knots[MANY + 4], domain[2], at = 0;
    for (int i = 0; i < 3 * MANY; i++) {
        const double off = uniform(-jagged, jagged);
        points[i] = i % 3 == 0 ? i / 3 + off : off;
    }
    for (int i = 12; i < 27 && same; i++)
        points[i] = points[i % 3 + 9]; /* four spans that are a point, or start at one */
    for (int i = 0; i < MANY + 4; i++) knots[i] = at += uniform(0.3, 1);
    bat_curve *many = first_of(points, knots, MANY), *few = first_of(points, knots, FEW);
    bat_curve_domain(few, domain);
    for (int i = 0; i < SAMPLES; i++) u[i] = domain[0] + (domain[1] - domain[0]) * i / SAMPLES;
    frames_of(many, substeps, u, whole[0], whole[1], whole[2]);
    frames_of(few, substeps, u, part[0], part[1], part[2]);
    assert_memory_equal(whole, part, sizeof whole);
    bat_curve_free(many);
    bat_curve_free(few);
}

static void side_by_side_or_alone(void **state) {
    (void)state;
    seed = 1;
    for (int round = 0; round < 200; round++) {
        static const double jagged[4] = {0.05, 0.5, 2, 20};
        compare(jagged[round % 4], round % 5 == 0, round % 3 == 0 ? 8 : 0);
    }
}

/* With 64 steps everywhere, taken one span at a time, frames are where 8 steps bring them. */
static void as_close_as_more_steps(void **state) {
    (void)state;
    seed = 2;
    double points[3 * MANY], knots[MANY + 4];
    for (int i = 0; i < 3 * MANY; i++) {
        const double off = uniform(-0.2, 0.2);
        points[i] = i % 3 == 0 ? i / 3 + off : off;
    }
    for (int i = 0; i < MANY + 4; i++) knots[i] = i;
    bat_curve *curve = first_of(points, knots, MANY);
    static double u[SAMPLES], coarse[3][3 * SAMPLES], fine[3][3 * SAMPLES];
    bat_curve_spread(curve, SAMPLES, u);
    frames_of(curve, 8, u, coarse[0], coarse[1], coarse[2]);
    frames_of(curve, 64, u, fine[0], fine[1], fine[2]);
    for (int i = 0; i < 3 * SAMPLES; i++) {
        assert_true(fabs(coarse[0][i] - fine[0][i]) < 1e-12 && fabs(coarse[1][i] - fine[1][i]) < 1e-12);
        assert_true(fabs(coarse[2][i] - fine[2][i]) < 1e-5); /* of fourth order in the steps */
    }
    bat_curve_free(curve);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(side_by_side_or_alone),
        cmocka_unit_test(as_close_as_more_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
