/*
 * Long noisy tracks: a fit finds a curve within the tolerance, as far as noise of a third of it or of more than half of it
 * throws the samples, and however densely they lie; a greater tolerance takes no more points.
 * label: slow
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <batten/fit.h>
#include <batten/nearest.h>
#include "support/random_curve.h"

#include <math.h>
#include <stdlib.h>

enum { MOST = 5000 };

static double normal(random_source *r) {
    double sum = 0; /* of twelve even ones: variance 1 */
    for (int i = 0; i < 12; i++) sum += random_between(r, -0.5, 0.5);
    return sum;
}

/* A way that bends this way and that, a sample each `step`, and noise of .3. */
static void walk(random_source *r, int count, double step, double scale, double *x) {
    double way = 0, turn = 0, at[2] = {0, 0};
    for (int i = 0; i < count; i++) {
        turn = 0.97 * turn + 0.01 * normal(r), way += turn;
        at[0] += step * cos(way), at[1] += step * sin(way);
        for (int c = 0; c < 2; c++) x[2 * i + c] = scale * (at[c] + 0.3 * normal(r));
    }
}

static double greatest(const bat_curve *curve, int count, const double *x) {
    bat_finder *finder;
    double worst = 0;
    assert_int_equal(bat_finder_create(curve, &finder), BAT_OK);
    for (int i = 0; i < count; i++) {
        bat_near near;
        bat_finder_nearest(finder, x + 2 * i, &near);
        worst = fmax(worst, near.distance);
    }
    bat_finder_free(finder);
    return worst;
}

static size_t points_of(int count, const double *x, double tolerance, bool closed) {
    bat_fit_options options = bat_fit_defaults();
    bat_curve *curve = NULL;
    options.tolerance = tolerance, options.closed = closed;
    assert_int_equal(bat_fit(2, (size_t)count, x, &options, &curve, NULL), BAT_OK);
    assert_true(greatest(curve, count, x) <= tolerance * (1 + 1e-9));
    const size_t points = bat_curve_count(curve);
    bat_curve_free(curve);
    return points;
}

static void tracks(uint64_t seed, int tracks, int count, double scale, bool closed) {
    static double x[2 * MOST];
    static const double steps[] = {2, 1, 0.3, 0.03}, tolerances[] = {0.5, 0.7, 1, 2, 4};
    random_source r = {seed};
    for (int i = 0; i < tracks; i++) {
        walk(&r, count, steps[i % 4], scale, x);
        size_t before = SIZE_MAX;
        for (int k = 0; k < 5; k++) {
            const size_t points = points_of(count, x, scale * tolerances[k], closed);
            if (k > 0) assert_true((double)points <= 1.05 * (double)before + 1);
            before = points;
        }
    }
}

static void long_tracks_are_fitted(void **state) {
    (void)state;
    tracks(1, 24, MOST, 1, false);
}

static void short_tracks_are_fitted(void **state) {
    (void)state;
    tracks(2, 300, 200, 1, false);
}

static void closed_tracks_are_fitted(void **state) {
    (void)state;
    tracks(3, 40, 1000, 1, true);
}

static void tracks_of_any_size_are_fitted(void **state) {
    (void)state;
    tracks(4, 20, 1000, 1e-6, false);
    tracks(5, 20, 1000, 1e6, false);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(long_tracks_are_fitted),
        cmocka_unit_test(short_tracks_are_fitted),
        cmocka_unit_test(closed_tracks_are_fitted),
        cmocka_unit_test(tracks_of_any_size_are_fitted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
