/* Seeded random curves of every kind, for property tests. */
#ifndef BATTEN_TESTS_RANDOM_CURVE_H
#define BATTEN_TESTS_RANDOM_CURVE_H

#include <batten/curve.h>

#include <math.h>
#include <stdlib.h>

typedef struct random_source {
    uint64_t state;
} random_source;

/* Uniform in [0, 1): a 64-bit linear congruential generator, upper bits. */
static inline double random_unit(random_source *r) {
    r->state = r->state * 6364136223846793005u + 1442695040888963407u;
    return (double)(r->state >> 11) / 9007199254740992.0;
}

static inline double random_between(random_source *r, double low, double high) {
    return low + (high - low) * random_unit(r);
}

static inline int random_int(random_source *r, int low, int high) {
    return low + (int)(random_unit(r) * (high - low + 1));
}

/* Random knots: steps of very different length, with multiplicities up to `most`. */
static inline void random_knots(random_source *r, int count, int most, double start, double *knots) {
    double t = start;
    for (int i = 0; i < count;) {
        int n = random_unit(r) < 0.7 ? 1 : random_int(r, 1, most);
        for (; n > 0 && i < count; n--) knots[i++] = t;
        t += random_unit(r) < 0.2 ? random_between(r, 0.001, 0.01) : random_between(r, 0.1, 2.0);
    }
}

/* A random curve, with `extra` points more than needed: kind 0 clamped, 1 open with free ends, 2 closed. Exits on
 * failure. */
static inline bat_curve *random_curve(random_source *r, int degree, int dimension, int kind, int extra) {
    enum { ROOM = 256 };
    double knots[ROOM], points[ROOM * BAT_DIMENSION_MAX], t = random_between(r, -3, 3);
    int p = degree, n = kind == 2 ? 2 + extra : p + 1 + extra, inner = n - p - 1;
    if (kind == 0) {
        for (int i = 0; i <= p; i++) knots[i] = t;
        random_knots(r, inner, p, t + random_between(r, 0.1, 2), knots + p + 1);
        double end = (inner > 0 ? knots[p + inner] : t) + random_between(r, 0.1, 2);
        for (int i = 0; i <= p; i++) knots[n + i] = end;
    } else if (kind == 1) {
        for (int i = 0; i <= p; i++) knots[i] = t, t += random_unit(r) < 0.3 && i < p ? 0 : random_unit(r);
        random_knots(r, inner, p, t + 0.1, knots + p + 1);
        t = inner > 0 ? knots[p + inner] : t;
        t += random_between(r, 0.1, 1);
        for (int i = 0; i <= p; i++) knots[n + i] = t, t += random_unit(r) < 0.3 ? 0 : random_unit(r);
    } else {
        int seam = random_int(r, 1, p < n ? p : n);
        for (int i = 0; i < seam; i++) knots[i] = t;
        random_knots(r, n - seam, p, t + random_between(r, 0.1, 1), knots + seam);
        knots[n] = (n > seam ? knots[n - 1] : t) + random_between(r, 0.1, 1);
    }
    for (int i = 0; i < n * dimension; i++) points[i] = random_between(r, -10, 10);
    bat_curve *curve = NULL;
    if (bat_curve_create(dimension, degree, kind == 2, (size_t)n, points,
                         (kind == 2) ? n + 1 : n + degree + 1, knots, &curve) != BAT_OK)
        abort();
    return curve;
}

/* Largest distance of two curves over `count` parameters spread over the domain of a, with b evaluated at scale * u +
 * shift. Both are evaluated from the right and from the left. */
static inline double curve_gap(const bat_curve *a, const bat_curve *b, double scale, double shift,
                               int count) {
    double domain[2], pa[BAT_DIMENSION_MAX], pb[BAT_DIMENSION_MAX], worst = 0;
    bat_curve_domain(a, domain);
    for (int i = 0; i <= count; i++) {
        double u = domain[0] + (domain[1] - domain[0]) * i / count, sum = 0;
        if (i == count) u = domain[1];
        bat_curve_eval(a, u, 0, pa);
        bat_curve_eval(b, scale * u + shift, 0, pb);
        for (int c = 0; c < bat_curve_dimension(a); c++) sum = hypot(sum, pa[c] - pb[c]);
        worst = fmax(worst, sum);
    }
    return worst;
}

#endif
