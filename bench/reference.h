/* What the right answer is, slowly: for what is said of correctness beside the times. Valid as both C and C++. */
#ifndef BATTEN_BENCH_REFERENCE_H
#define BATTEN_BENCH_REFERENCE_H

#include <math.h>

/* A point of a clamped cubic with n points over 0..1, by de Boor's triangle. */
static inline void bench_point(int n, int dimension, const double *knots, const double *points, double u,
                               double *out) {
    int k = 3;
    while (k < n - 1 && u >= knots[k + 1]) k++;
    for (int c = 0; c < dimension; c++) {
        double d[4];
        for (int i = 0; i < 4; i++) d[i] = points[(k - 3 + i) * dimension + c];
        for (int r = 1; r < 4; r++)
            for (int i = 3; i >= r; i--) {
                const double a = knots[k - 3 + i], w = (u - a) / (knots[k + 1 + i - r] - a);
                d[i] = (1 - w) * d[i - 1] + w * d[i];
            }
        out[c] = d[3];
    }
}

/* The distance of x from what `at` draws over 0..1: the best of `steps` samples, then ever closer around it. */
static inline double bench_distance(void (*at)(const void *curve, double u, double *out), const void *curve,
                                    int steps, const double *x) {
    double p[2], best = 0, least = HUGE_VAL;
    for (int i = 0; i <= steps; i++) {
        at(curve, (double)i / steps, p);
        const double d = hypot(p[0] - x[0], p[1] - x[1]);
        if (d < least) least = d, best = (double)i / steps;
    }
    for (double reach = 1.0 / steps; reach > 1e-13; reach *= 0.7)
        for (int side = -1; side <= 1; side += 2) {
            const double u = fmin(fmax(best + side * reach / 2, 0), 1);
            at(curve, u, p);
            const double d = hypot(p[0] - x[0], p[1] - x[1]);
            if (d < least) least = d, best = u;
        }
    return least;
}

/* Random places near the wave of bench_curve, for the closest point. x: 2 * count. */
static inline void bench_queries(int n, int count, double *x) {
    unsigned long long state = 5;
    for (int i = 0; i < 2 * count; i++) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        const double r = (double)(state >> 11) / 9007199254740992.0;
        x[i] = i % 2 ? 100 * r - 20 : 10.0 * n * r;
    }
}

#endif
