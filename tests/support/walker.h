/* A small skeleton that walks: hips, a leg of two joints, a head that stays; frames whose swing depends on the seed. */
#ifndef BATTEN_TESTS_WALKER_H
#define BATTEN_TESTS_WALKER_H

#include <batten/motion.h>
#include "support/random_curve.h"

enum { WALKER_JOINTS = 5, WALKER_CHANNELS = 13 };

static const bat_bone WALKER_BONES[WALKER_JOINTS] = {
    {"hips",
     -1,
     false,
     {0, 0, 0},
     6,
     {BAT_X_POSITION, BAT_Y_POSITION, BAT_Z_POSITION, BAT_Z_ROTATION, BAT_X_ROTATION, BAT_Y_ROTATION}},
    {"thigh", 0, false, {1, -2, 0}, 3, {BAT_X_ROTATION, BAT_Y_ROTATION, BAT_Z_ROTATION}},
    {"knee", 1, false, {0, -40, 0}, 1, {BAT_X_ROTATION}},
    {"", 2, true, {0, -39, 3}, 0, {BAT_X_POSITION}},
    {"head", 0, false, {0, 60, 0}, 3, {BAT_Y_ROTATION, BAT_X_ROTATION, BAT_Z_ROTATION}}};

/* The caller frees it. NULL: no memory. */
static bat_take *walker(int seed, size_t frames) {
    random_source r = {(uint64_t)seed};
    double *values = malloc(frames * WALKER_CHANNELS * sizeof *values);
    double swing[WALKER_CHANNELS], phase[WALKER_CHANNELS];
    if (!values) return NULL;
    for (int k = 0; k < WALKER_CHANNELS; k++) {
        swing[k] = random_between(&r, 10, 30);
        phase[k] = random_between(&r, 0, 6);
    }
    for (size_t i = 0; i < frames; i++)
        for (int k = 0; k < WALKER_CHANNELS; k++) {
            const double noise = random_between(&r, -.2, .2);
            const double turn = swing[k] * sin(.2 * (double)i + phase[k]) + noise;
            values[i * WALKER_CHANNELS + (size_t)k] = k < 3 ? (k == 2   ? 2.0 * (double)i
                                                               : k == 1 ? 90
                                                                        : 0) +
                                                                  .1 * turn
                                                            : turn;
        }
    bat_take *take = NULL;
    if (bat_take_create(WALKER_JOINTS, WALKER_BONES, frames, 1 / 60.0, values, &take) != BAT_OK) take = NULL;
    free(values);
    return take;
}

#endif
