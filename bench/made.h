/* What is swept, cut and set off, for Batten and its peers alike. Valid as both C and C++. */
#ifndef BATTEN_BENCH_MADE_H
#define BATTEN_BENCH_MADE_H

#include <math.h>

enum { BENCH_PATH = 12, BENCH_RING = 8, BENCH_TUBE = 16 };
static const double BENCH_OFFSET = 0.5, BENCH_OFFSET_FAR = 15, BENCH_OFFSET_TOLERANCE = 0.01;
static const double BENCH_SWEEP_TOLERANCE = 1e-3, BENCH_MEET_TOLERANCE = 1e-4;

/* Control points of a bent path, a clamped cubic with even knots, 200 long. */
static inline void bench_path(double points[3 * BENCH_PATH]) {
    for (int i = 0; i < BENCH_PATH; i++) {
        points[3 * i] = 18.0 * i;
        points[3 * i + 1] = 25 * sin(0.9 * i);
        points[3 * i + 2] = 15 * cos(0.7 * i);
    }
}

/* Control points of a round profile, a closed cubic with even knots, of radius 5. */
static inline void bench_ring(double points[2 * BENCH_RING]) {
    const double turn = 6.283185307179586 / BENCH_RING, radius = 5 * 3 / (2 + cos(turn));
    for (int i = 0; i < BENCH_RING; i++)
        points[2 * i] = radius * cos(turn * i), points[2 * i + 1] = radius * sin(turn * i);
}

/* Control points of a tube along x (which 0, radius 5) or y (1, radius 4, 1 above): a clamped line of two points by a closed
 * cubic with even knots, row by row; they cross in two loops. */
static inline void bench_tube(int which, double points[6 * BENCH_TUBE]) {
    const double turn = 6.283185307179586 / BENCH_TUBE, size = which ? 4 : 5,
                 radius = size * 3 / (2 + cos(turn));
    for (int i = 0; i < 2 * BENCH_TUBE; i++) {
        const double along = i < BENCH_TUBE ? -12 : 12, across = radius * cos(turn * i),
                     up = radius * sin(turn * i) + which;
        points[3 * i] = which ? across : along;
        points[3 * i + 1] = which ? along : across;
        points[3 * i + 2] = up;
    }
}

#endif
