#include "curve/hermite.h"

#include "curve/curve.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 14, TRIAL = 5 };

static const double SHORTEST = 0.1, LONGEST = 1; /* handles, over the length */
static const double HOPELESS = 3; /* tolerances after TRIAL rounds: no other start helps either */

bool bat_hermite_room(bat_hermite *h, size_t count) {
    if (count <= h->room) return true;
    const size_t room = count + h->room, m = (size_t)h->dimension;
    double *x = malloc(room * (m + 3) * sizeof *x);
    if (!x) return false;
    if (h->room) memcpy(x, h->x, h->count * m * sizeof *x);
    free(h->x);
    h->x = x, h->along = x + room * m, h->t = h->along + room, h->weight = h->t + room;
    h->room = room;
    return true;
}

void bat_hermite_free(bat_hermite *h) {
    free(h->x);
    h->x = NULL, h->room = h->count = 0;
}

void bat_hermite_measure(bat_hermite *h) {
    const int m = h->dimension;
    const double *last = h->end[0];
    double length = 0;
    for (size_t i = 0; i < h->count; i++) {
        const double *x = h->x + i * (size_t)m;
        length += bat_distance(last, x, m);
        h->along[i] = length;
        last = x;
    }
    h->length = length + bat_distance(last, h->end[1], m);
    for (size_t i = 0; i < h->count && h->length > 0; i++) h->along[i] /= h->length;
}

/* Point and first derivative of the cubic. */
static void at(const bat_hermite *h, const double *handle, double t, double *p, double *d) {
    const double s = 1 - t;
    const double b0 = s * s * (s + 3 * t), b1 = 3 * s * s * t, b2 = 3 * s * t * t, b3 = t * t * (t + 3 * s);
    const double e0 = 6 * s * t, e1 = 3 * s * (s - 2 * t), e2 = 3 * t * (2 * s - t);
    for (int c = 0; c < h->dimension; c++) {
        const double a = h->end[0][c], b = h->end[1][c], u = handle[0] * h->way[0][c],
                     v = handle[1] * h->way[1][c];
        p[c] = b0 * a + b3 * b + b1 * u + b2 * v;
        d[c] = e0 * (b - a) + e1 * u + e2 * v;
    }
}

static double dot(const double *a, const double *b, int m) {
    double sum = 0;
    for (int c = 0; c < m; c++) sum += a[c] * b[c];
    return sum;
}

/* Moves the samples' parameters towards their nearest points; returns the greatest distance. */
static double project(bat_hermite *h, const double *handle) {
    const int m = h->dimension;
    double worst = 0;
    for (size_t i = 0; i < h->count; i++) {
        const double *x = h->x + i * (size_t)m;
        double p[BAT_DIMENSION_MAX], d[BAT_DIMENSION_MAX];
        for (int k = 0; k < 2; k++) {
            at(h, handle, h->t[i], p, d);
            for (int c = 0; c < m; c++) p[c] = x[c] - p[c];
            const double square = dot(d, d, m);
            if (k == 0 && square > 0) h->t[i] = fmin(1, fmax(0, h->t[i] + dot(p, d, m) / square));
        }
        worst = fmax(worst, dot(p, p, m));
    }
    return sqrt(worst);
}

/* Distance of p from the line from a to b. */
static double off_line(const double *p, const double *a, const double *b, int m) {
    double x[BAT_DIMENSION_MAX] = {0}, y[BAT_DIMENSION_MAX] = {0};
    for (int c = 0; c < m; c++) x[c] = p[c] - a[c], y[c] = b[c] - a[c];
    const double square = dot(y, y, m), f = square > 0 ? fmin(1, fmax(0, dot(x, y, m) / square)) : 0;
    for (int c = 0; c < m; c++) x[c] -= f * y[c];
    return sqrt(dot(x, x, m));
}

/* How far the cubic is from the samples: it may fold between two of them. Its points half way between theirs are
 * compared with their polyline, less what the polyline bends there. */
static double fold(const bat_hermite *h, const double *handle) {
    const size_t m = (size_t)h->dimension, n = h->count;
    double worst = 0;
    for (size_t i = 0; i <= n; i++) {
        const double *a = i > 0 ? h->x + (i - 1) * m : h->end[0], *b = i < n ? h->x + i * m : h->end[1];
        const double *before = i > 1 ? h->x + (i - 2) * m : h->end[0],
                     *after = i + 1 < n ? h->x + (i + 1) * m : h->end[1];
        double p[BAT_DIMENSION_MAX], d[BAT_DIMENSION_MAX];
        at(h, handle, 0.5 * ((i > 0 ? h->t[i - 1] : 0) + (i < n ? h->t[i] : 1)), p, d);
        worst = fmax(worst, off_line(p, a, b, h->dimension) - off_line(a, before, b, h->dimension) -
                                off_line(b, a, after, h->dimension));
    }
    return worst;
}

/* One Gauss-Newton step for both handles, on the weighted distances across the cubic. */
static void step(const bat_hermite *h, double *handle) {
    const int m = h->dimension;
    double a = 0, b = 0, c = 0, f = 0, g = 0;
    for (size_t i = 0; i < h->count; i++) {
        const double *x = h->x + i * (size_t)m, t = h->t[i], s = 1 - t, w = h->weight[i];
        const double b1 = 3 * s * s * t, b2 = 3 * s * t * t;
        double p[BAT_DIMENSION_MAX], d[BAT_DIMENSION_MAX];
        at(h, handle, t, p, d);
        const double square = dot(d, d, m);
        if (!(square > 0)) continue;
        for (int k = 0; k < m; k++) p[k] = x[k] - p[k];
        const double *u = h->way[0], *v = h->way[1];
        const double ud = dot(u, d, m), vd = dot(v, d, m), pd = dot(p, d, m) / square;
        a += w * b1 * b1 * (dot(u, u, m) - ud * ud / square);
        b += w * b1 * b2 * (dot(u, v, m) - ud * vd / square);
        c += w * b2 * b2 * (dot(v, v, m) - vd * vd / square);
        f += w * b1 * (dot(u, p, m) - ud * pd);
        g += w * b2 * (dot(v, p, m) - vd * pd);
    }
    const double det = a * c - b * b;
    if (!(fabs(det) > 1e-14 * a * c)) return; /* straight: any lengths will do */
    const double move[2] = {(c * f - b * g) / det, (a * g - b * f) / det};
    for (int k = 0; k < 2; k++)
        handle[k] = fmin(LONGEST * h->length, fmax(SHORTEST * h->length, handle[k] + move[k]));
}

/* Lawson's weights: the further a sample, the more it counts in the next round. */
static void weigh(bat_hermite *h, const double *handle, double worst) {
    const int m = h->dimension;
    for (size_t i = 0; i < h->count; i++) {
        double p[BAT_DIMENSION_MAX], d[BAT_DIMENSION_MAX];
        at(h, handle, h->t[i], p, d);
        h->weight[i] *= 0.2 + bat_distance(p, h->x + i * (size_t)m, m) / worst;
    }
}

double bat_hermite_fit(bat_hermite *h, double tolerance, double handle[2]) {
    static const double starts[][2] = {{0.33, 0.33}, {0.5, 0.5}, {0.2, 0.5}, {0.5, 0.2}, {0.8, 0.8}};
    double best = INFINITY;
    for (size_t n = 0; n < sizeof starts / sizeof *starts; n++) {
        double now[2] = {starts[n][0] * h->length, starts[n][1] * h->length};
        memcpy(h->t, h->along, h->count * sizeof *h->t);
        for (size_t i = 0; i < h->count; i++) h->weight[i] = 1;
        for (int k = 0; k < ROUNDS; k++) {
            double worst = project(h, now);
            if (worst <= tolerance) worst = fmax(worst, fold(h, now));
            if (worst < best) best = worst, handle[0] = now[0], handle[1] = now[1];
            if (worst <= tolerance) return worst;
            if (k == TRIAL && best > HOPELESS * tolerance) break;
            if (k > 2) weigh(h, now, worst);
            step(h, now);
        }
    }
    return best;
}

void bat_hermite_points(const bat_hermite *h, const double handle[2], double *points) {
    const int m = h->dimension;
    for (int c = 0; c < m; c++) {
        points[c] = h->end[0][c], points[3 * m + c] = h->end[1][c];
        points[m + c] = h->end[0][c] + handle[0] * h->way[0][c];
        points[2 * m + c] = h->end[1][c] + handle[1] * h->way[1][c];
    }
}
