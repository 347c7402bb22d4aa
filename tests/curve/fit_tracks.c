/* Fits noisy tracks of every kind at rising tolerances: fit_tracks [TRACKS [SAMPLES]], of each kind 1,000 tracks of 5,000
 * samples. Prints how many miss their tolerance, and at how many a greater tolerance takes over 5 % and one more points; status
 * 1: some do. */
#include <batten/fit.h>
#include "support/noisy_track.h"

#include <stdio.h>
#include <stdlib.h>

static const double STEPS[4] = {2, 1, 0.3, 0.03}, TOLERANCES[4] = {0.7, 1, 2, 4};

static void fit_one(track_kind kind, int seed, int count, double *x, int *missed, int *risen) {
    random_source r = {100000 * (uint64_t)kind + (uint64_t)seed + 1};
    double before = INFINITY;
    noisy_track(&r, kind, count, STEPS[seed % 4], 1, x);
    for (int k = 0; k < 4; k++) {
        bat_fit_options options = bat_fit_defaults();
        bat_curve *curve = NULL;
        options.tolerance = TOLERANCES[k], options.closed = kind == RING;
        *missed += bat_fit(track_dimension(kind), (size_t)count, x, &options, &curve, NULL) != BAT_OK;
        const double points = curve ? (double)bat_curve_count(curve) : INFINITY;
        *risen += points > 1.05 * before + 1;
        before = points;
        bat_curve_free(curve);
    }
}

int main(int argc, char **argv) {
    const int tracks = argc > 1 ? atoi(argv[1]) : 1000, count = argc > 2 ? atoi(argv[2]) : 5000;
    double *x = malloc(3 * (size_t)count * sizeof *x);
    int wrong = 0; /* of spikes a few take more points */
    for (int kind = 0; kind < TRACK_KINDS && x; kind++) {
        int missed = 0, risen = 0;
        for (int i = 0; i < tracks; i++) fit_one((track_kind)kind, i, count, x, &missed, &risen);
        printf("%s: %d tracks of %d samples, %d of %d fits missed, %d took more points\n", track_names[kind],
               tracks, count, missed, 4 * tracks, risen);
        fflush(stdout), wrong += missed + (kind == SPIKES ? 0 : risen);
    }
    free(x);
    return wrong > 0 || !x;
}
