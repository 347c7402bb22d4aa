/* Minimum and median of many runs, printed as one JSON object per row. Valid as both C and C++. */
#ifndef BATTEN_BENCH_TIMING_H
#define BATTEN_BENCH_TIMING_H

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static inline double bench_now(void) { /* seconds */
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static inline int bench_order(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

typedef struct bench_time {
    double best, median; /* seconds per call */
} bench_time;

/* At least five runs and 0.4 s, at most 400 runs; short calls are repeated within a run until it takes 0.2
 * ms. */
static inline bench_time bench_measure(void (*call)(void *), void *context) {
    enum { MOST = 400 };
    static double runs[MOST];
    int repeat = 1, count = 0;
    for (;; repeat *= 2) {
        const double start = bench_now();
        for (int i = 0; i < repeat; i++) call(context);
        if (bench_now() - start > 2e-4 || repeat > 1 << 20) break;
    }
    const double begin = bench_now();
    while (count < MOST && (count < 5 || bench_now() - begin < 0.4)) {
        const double start = bench_now();
        for (int i = 0; i < repeat; i++) call(context);
        runs[count++] = (bench_now() - start) / repeat;
    }
    qsort(runs, (size_t)count, sizeof runs[0], bench_order);
    bench_time out = {runs[0], runs[count / 2]};
    return out;
}

/* per: items in one call; scale: 1e9 for ns, 1e6 for us. note: facts that go with the row, JSON text or "".
 */
static inline void bench_print(const char *program, const char *name, const char *unit, bench_time t,
                               double per, double scale, const char *note) {
    printf("{\"program\":\"%s\",\"name\":\"%s\",\"unit\":\"%s\",\"best\":%.4g,\"median\":%.4g,\"note\":\"%"
           "s\"}\n",
           program, name, unit, t.best * scale / per, t.median * scale / per, note);
    fflush(stdout);
}

/* The common input: points and knots of a wavy clamped cubic with n points and parameters 0..1. */
static inline void bench_curve(int n, int dimension, double *knots, double *points) {
    unsigned long long state = 99;
    for (int i = 0; i < n + 4; i++) knots[i] = i < 4 ? 0 : i >= n ? 1 : (double)(i - 3) / (n - 3);
    for (int i = 0; i < n; i++)
        for (int c = 0; c < dimension; c++) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            const double noise = (double)(state >> 11) / 9007199254740992.0;
            points[i * dimension + c] = c == 0 ? 10.0 * i + 4 * noise : 60 * noise;
        }
}

/* A clamped surface of degree p with n x n points over [0, 1]^2: 10 apart, at heights of up to 10. */
static inline void bench_surface(int n, int p, double *knots, double *points) {
    unsigned long long state = 7;
    for (int i = 0; i < n + p + 1; i++) knots[i] = i <= p ? 0 : i >= n ? 1 : (double)(i - p) / (n - p);
    for (int i = 0; i < n * n; i++) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        points[3 * i] = 10.0 * (i / n), points[3 * i + 1] = 10.0 * (i % n);
        points[3 * i + 2] = 10 * ((double)(state >> 11) / 9007199254740992.0);
    }
}

/* The k-th of many rays that fall on that surface from above, 1 unit long. */
static inline void bench_ray(int n, int k, double origin[3], double direction[3]) {
    const double side = 10.0 * (n - 1), x = 0.5 + 0.38 * (double)(k * 37 % 101 - 50) / 50,
                 y = 0.5 + 0.38 * (double)(k * 61 % 103 - 51) / 51;
    origin[0] = x * side, origin[1] = y * side, origin[2] = 100;
    direction[0] = 0.3 * (k % 7 - 3) / 3.0, direction[1] = 0.3 * (k % 5 - 2) / 2.0, direction[2] = -0.9;
    const double length = __builtin_sqrt(direction[0] * direction[0] + direction[1] * direction[1] + 0.81);
    for (int c = 0; c < 3; c++) direction[c] /= length;
}

#endif
