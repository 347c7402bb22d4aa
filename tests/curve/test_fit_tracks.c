/*
 * Noisy tracks: a fit finds a curve within the tolerance, however far noise throws the samples and however densely they lie; a
 * greater tolerance takes no more points (of spikes, in 1 of 1,000 it does). tests/curve/fit_tracks.c does the same for
 * thousands of long ones.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <batten/fit.h>
#include <batten/nearest.h>
#include "support/noisy_track.h"

enum { MOST = 5000 };

static const double STEPS[4] = {2, 1, 0.3, 0.03};

static double greatest(const bat_curve *curve, int count, const double *x) {
    const int m = bat_curve_dimension(curve);
    bat_finder *finder;
    double worst = 0;
    assert_int_equal(bat_finder_create(curve, &finder), BAT_OK);
    for (int i = 0; i < count; i++) {
        bat_near near;
        bat_finder_nearest(finder, x + m * i, &near);
        worst = fmax(worst, near.distance);
    }
    bat_finder_free(finder);
    return worst;
}

static size_t points_of(int m, int count, const double *x, const bat_fit_options *options) {
    bat_curve *curve = NULL;
    assert_int_equal(bat_fit(m, (size_t)count, x, options, &curve, NULL), BAT_OK);
    assert_true(greatest(curve, count, x) <= options->tolerance * (1 + 1e-9));
    const size_t points = bat_curve_count(curve);
    bat_curve_free(curve);
    return points;
}

/* Every fourth one with its ends held. */
static void tracks(track_kind kind, int number, int count, double scale) {
    static double x[3 * MOST];
    static const double tolerances[] = {0.7, 1, 2, 4};
    for (int i = 0; i < number; i++) {
        random_source r = {1000 * (uint64_t)kind + (uint64_t)i + 1};
        noisy_track(&r, kind, count, STEPS[i % 4], scale, x);
        size_t before = SIZE_MAX / 2;
        for (int k = 0; k < 4; k++) {
            bat_fit_options options = bat_fit_defaults();
            options.tolerance = scale * tolerances[k], options.closed = kind == RING;
            options.hold_ends = i % 4 == 3 && kind != RING;
            const size_t points = points_of(track_dimension(kind), count, x, &options);
            if (kind != SPIKES) assert_true((double)points <= 1.05 * (double)before + 1);
            before = points;
        }
    }
}

static void tracks_are_fitted(void **state) {
    (void)state;
    for (int kind = 0; kind < TRACK_KINDS; kind++) tracks((track_kind)kind, 12, 600, 1);
    tracks(WHITE, 2, MOST, 1);
}

static void tracks_of_any_size_are_fitted(void **state) {
    (void)state;
    tracks(WHITE, 8, 600, 1e-6);
    tracks(SPIKES, 8, 600, 1e6);
}

/* A tolerance far below the noise takes a knot for nearly each sample, of whatever degree, and between corners. */
static void what_is_only_noise_is_fitted(void **state) {
    (void)state;
    static double x[3 * MOST];
    for (int i = 0; i < 42; i++) {
        const track_kind kind = i % 3 == 0 ? RING : i % 3 == 1 ? WHITE : SPACE;
        const int corners[2] = {100, 200};
        random_source r = {(uint64_t)i + 7};
        bat_fit_options options = bat_fit_defaults();
        noisy_track(&r, kind, 300, STEPS[i % 4], 1, x);
        options.tolerance = 0.02, options.degree = 1 + i % BAT_DEGREE_MAX, options.closed = kind == RING;
        if (i % 2) options.corners = corners, options.corner_count = 2;
        assert_true(points_of(track_dimension(kind), 300, x, &options) <= 320);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tracks_are_fitted),
        cmocka_unit_test(tracks_of_any_size_are_fitted),
        cmocka_unit_test(what_is_only_noise_is_fitted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
