/* Tracks as recorders give them: a way that bends this way and that, and noise of .3 on its samples. */
#ifndef BATTEN_TESTS_NOISY_TRACK_H
#define BATTEN_TESTS_NOISY_TRACK_H

#include "random_curve.h"

#include <math.h>
#include <string.h>

typedef enum track_kind { WHITE, DRIFTING, REPEATED, UNEVEN, SPIKES, RING, SPACE, TRACK_KINDS } track_kind;

static const char *const track_names[TRACK_KINDS] = {
    "white noise", "drifting noise", "repeated samples", "uneven spacing", "spikes", "closed", "in space"};

static inline int track_dimension(track_kind kind) { return kind == SPACE ? 3 : 2; }

static inline double random_normal(random_source *r) {
    double sum = 0; /* of twelve even ones: variance 1 */
    for (int i = 0; i < 12; i++) sum += random_between(r, -0.5, 0.5);
    return sum;
}

/* count samples, one each `step` on the average. */
static inline void noisy_track(random_source *r, track_kind kind, int count, double step, double scale,
                               double *x) {
    const int m = track_dimension(kind);
    double way = 0, turn = 0, climb = 0, at[3] = {0, 0, 0}, drift[3] = {0, 0, 0};
    for (int i = 0; i < count; i++) {
        double *sample = x + m * i;
        const double go = kind == UNEVEN ? step * pow(10, random_between(r, -2, 0.5)) : step,
                     round = 6.283185307179586 * i / count, radius = step * count / 6;
        turn = 0.97 * turn + 0.01 * random_normal(r), way += turn;
        climb = 0.99 * climb + 0.02 * random_normal(r);
        at[0] += go * cos(way), at[1] += go * sin(way), at[2] += go * sin(climb);
        if (kind == RING) {
            at[0] = radius * cos(round) * (1 + 0.3 * cos(3 * round));
            at[1] = radius * sin(round) * (1 + 0.3 * sin(5 * round));
        }
        for (int c = 0; c < m; c++) {
            drift[c] = 0.9 * drift[c] + 0.13 * random_normal(r); /* variance of .3 in the long run */
            sample[c] = at[c] + (kind == DRIFTING ? drift[c] : 0.3 * random_normal(r));
        }
        if (kind == SPIKES && random_between(r, 0, 1) < 0.01) sample[0] += 20 * random_normal(r);
        for (int c = 0; c < m; c++) sample[c] *= scale;
        if (kind == REPEATED && i > 0 && random_between(r, 0, 1) < 0.3)
            memcpy(sample, sample - m, (size_t)m * sizeof *sample);
    }
}

#endif
