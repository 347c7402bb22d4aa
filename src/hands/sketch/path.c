#include "hands/sketch/path.h"
#include "base/bisect.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

double bat_path_distance(const double *a, const double *b, size_t m) {
    double sum = 0;
    for (size_t c = 0; c < m; c++) sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sqrt(sum);
}

void bat_path_measure(const double *points, size_t count, size_t m, double *arc) {
    arc[0] = 0;
    for (size_t i = 1; i < count; i++)
        arc[i] = arc[i - 1] + bat_path_distance(points + i * m, points + (i - 1) * m, m);
}

/* The point at s between samples i and i + 1. */
static void between(const bat_stroke_path *path, size_t i, double s, double *out) {
    const size_t m = path->m;
    const double h = path->arc[i + 1] - path->arc[i];
    double f = h > 0 ? (s - path->arc[i]) / h : 0;
    f = f < 0 ? 0 : f > 1 ? 1 : f;
    const double *a = path->points + i * m;
    for (size_t c = 0; c < m; c++)
        out[c] = f < 1 ? a[c] + f * (a[m + c] - a[c]) : a[m + c]; /* to the last bit */
}

void bat_path_at(const bat_stroke_path *path, double s, double *out) {
    if (path->count < 2)
        memcpy(out, path->points, path->m * sizeof *out);
    else
        between(path, bat_bisect(path->arc, path->count, s), s, out);
}

void bat_path_walk(const bat_stroke_path *path, double s, size_t *at, double *out) {
    size_t i = *at;
    while (i + 2 < path->count && path->arc[i + 1] <= s) i++;
    *at = i;
    between(path, i, s, out);
}

double bat_path_turn(const double *a, const double *b, const double *c, size_t m) {
    double dot = 0, p = 0, q = 0;
    for (size_t k = 0; k < m; k++) {
        const double x = b[k] - a[k], y = c[k] - b[k];
        dot += x * y, p += x * x, q += y * y;
    }
    if (!(p > 0 && q > 0)) return 0;
    const double cosine = dot / sqrt(p * q);
    return bat_acos(cosine > 1 ? 1 : cosine < -1 ? -1 : cosine);
}
