/* The curve used by most rows. */
#ifndef BATTEN_BENCH_WAVE_H
#define BATTEN_BENCH_WAVE_H

#include "timing.h"

#include <batten/curve.h>
#include <stdlib.h>

/* A curve with n control points; NULL: out of memory. */
static inline bat_curve *bench_wave(int n, int dimension) {
    double *knots = malloc(sizeof(double) * (size_t)(n + 4)),
           *points = malloc(sizeof(double) * (size_t)(n * dimension));
    bat_curve *curve = NULL;
    if (knots && points) {
        bench_curve(n, dimension, knots, points);
        if (bat_curve_create(dimension, 3, false, (size_t)n, points, n + 4, knots, &curve) != BAT_OK)
            curve = NULL;
    }
    free(knots), free(points);
    return curve;
}

#endif
