/* Strokes whose curvature is known, drawn by a hand that trembles, and what the curvature of a result is compared by. */
#ifndef BATTEN_TESTS_KNOWN_STROKES_H
#define BATTEN_TESTS_KNOWN_STROKES_H

#include "support/random_curve.h"
#include "support/sketch_cases.h"

#include <math.h>

static const double pi = 3.14159265358979324;
enum { ROOM = 512, PLACES = 1500, RATE = 240, SPEED = 450 };

/* ---- a stroke whose curvature is known ---- */

enum { ARC, CLOTHOID, HUMP, WAVE, BUMPS, KINDS };

typedef struct profile {
    int kind;
    double a, b, length;
} profile;

static inline double curvature_of(const profile *p, double f) {
    double sum = 0;
    switch (p->kind) {
    case ARC: return p->a;
    case CLOTHOID: return p->a + (p->b - p->a) * f;
    case HUMP: return p->a + p->b * (0.5 - 0.5 * cos(2 * pi * f));
    case WAVE: return p->a * sin(2 * pi * p->b * f);
    default:
        for (int i = 0; i < 3; i++) {
            const double d = (f - 0.2 - 0.3 * i) / 0.12;
            sum += p->a * (i == 1 ? -0.7 : 1) * exp(-d * d);
        }
        return sum;
    }
}

static inline profile random_profile(random_source *r, int kind) {
    const double length = random_between(r, 250, 700), turn = random_between(r, 0.8, 3) / length;
    profile p = {kind, turn, 0, length};
    if (kind == CLOTHOID) p.a = turn * random_between(r, -0.5, 0.3), p.b = 1.5 * turn;
    if (kind == HUMP) p.a = 0.2 * turn, p.b = 1.2 * turn;
    if (kind == WAVE) p.a = 1.5 * turn, p.b = random_between(r, 0.7, 1.5);
    if (kind == BUMPS) p.a = 1.6 * turn;
    return p;
}

typedef struct sample_set {
    size_t count;
    double points[2 * ROOM], time[ROOM];
    double variation; /* of the true curvature: the sum of its absolute changes */
    int extrema;
} sample_set;

/* Extrema that stand out by more than `least`. */
static inline int extrema(const double *x, int count, double least) {
    double low = x[0], high = x[0];
    int way = 0, found = 0;
    for (int i = 1; i < count; i++) {
        low = fmin(low, x[i]), high = fmax(high, x[i]);
        if (!(way >= 0 && x[i] < high - least) && !(way <= 0 && x[i] > low + least)) continue;
        found += way != 0;
        way = x[i] < high - least && way >= 0 ? -1 : 1;
        low = high = x[i];
    }
    return found;
}

static inline double threshold(const double *x, int count) {
    double low = x[0], high = x[0], mean = 0;
    for (int i = 0; i < count; i++)
        low = fmin(low, x[i]), high = fmax(high, x[i]), mean += fabs(x[i]) / count;
    return fmax(0.04 * (high - low), 0.05 * mean);
}

static inline void draw(random_source *r, const profile *p, double sensor, sample_set *out) {
    enum { FINE = 16 };
    static double truth[PLACES];
    const double rate[2] = {random_between(r, 8, 12), random_between(r, 8, 12)}, tremor = 0.3;
    double angle = random_between(r, 0, 6), at[2] = {200, 200};
    out->count = (size_t)(p->length / SPEED * RATE) + 1, out->variation = 0;
    for (size_t i = 0; i < out->count; i++) {
        out->time[i] = 1000.0 * (double)i / RATE;
        for (int c = 0; c < 2; c++)
            out->points[2 * i + (size_t)c] = at[c] + tremor * sin(2 * pi * rate[c] * (double)i / RATE) +
                                             sensor * random_normal(r);
        for (int j = 0; j < FINE; j++) {
            const double f = ((double)i + (j + 0.5) / FINE) / (double)(out->count - 1);
            const double h = p->length / (double)(out->count - 1) / FINE, k = curvature_of(p, f);
            angle += 0.5 * k * h, at[0] += h * cos(angle), at[1] += h * sin(angle), angle += 0.5 * k * h;
        }
    }
    for (int i = 0; i < PLACES; i++) {
        truth[i] = curvature_of(p, (double)i / (PLACES - 1));
        if (i > 0) out->variation += fabs(truth[i] - truth[i - 1]);
    }
    out->extrema = extrema(truth, PLACES, threshold(truth, PLACES));
}

static inline void curvatures(const bat_curve *curve, const double range[2], double *out) {
    for (int i = 0; i < PLACES; i++) {
        double jet[6];
        bat_curve_eval(curve, range[0] + (range[1] - range[0]) * i / (PLACES - 1), 2, jet);
        const double v = hypot(jet[2], jet[3]);
        out[i] = (jet[2] * jet[5] - jet[3] * jet[4]) / (v * v * v);
    }
}

static inline int by_count(const void *a, const void *b) {
    return *(const int *)a - *(const int *)b;
} /* ties are equal */

#endif
