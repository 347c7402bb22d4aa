/* C2 cubics through points: slopes from a tridiagonal system that is diagonally dominant, then control points as blossoms of
 * the pieces. */
#include "points/interpolate.h"

#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Rows lower[i] s[i-1] + diagonal[i] s[i] + upper[i] s[i+1] = right[i]; cyclic: lower[0] is with the last, upper[n-1] with
 * the first. */
typedef struct work {
    int m;            /* numbers of a point */
    size_t n;         /* different points */
    double *points;   /* n, and the first again when closed */
    double *t;        /* their parameters */
    double *slopes;   /* per point */
    double *diagonal; /* being eliminated */
    double *upper, *corner;
} work;

static double chord(const double *a, const double *b, int m) {
    const double plane = bat_hypot(b[0] - a[0], b[1] - a[1]);
    return m == 3 ? bat_hypot(plane, b[2] - a[2]) : plane;
}

/* Different neighbours only. Returns how many there are. */
static size_t take(int m, size_t count, const double *points, bool closed, double *out) {
    size_t n = 0;
    for (size_t i = 0; i < count; i++) {
        const double *x = points + i * (size_t)m;
        if (n && !(chord(out + (n - 1) * (size_t)m, x, m) > 0)) continue;
        memcpy(out + n++ * (size_t)m, x, (size_t)m * sizeof *x);
    }
    while (closed && n > 1 && !(chord(out, out + (n - 1) * (size_t)m, m) > 0)) n--;
    return n;
}

static double step(const work *w, size_t i) { return w->t[i + 1] - w->t[i]; }

/* 3 (x[i+1] - x[i]) / h^2 */
static double pull(const work *w, size_t i, int c) {
    const double h = step(w, i);
    const size_t m = (size_t)w->m;
    return 3 * (w->points[(i + 1) * m + (size_t)c] - w->points[i * m + (size_t)c]) / h / h;
}

/* Open: one pass down, one up. */
static void solve_open(work *w, const double *ends) {
    const size_t m = (size_t)w->m, last = w->n - 1;
    for (size_t i = 0; i <= last; i++) {
        const double before = i ? 1 / step(w, i - 1) : 0, behind = i < last ? 1 / step(w, i) : 0;
        const bool held = ends && (i == 0 || i == last);
        const double lower = held ? 0 : before;
        w->diagonal[i] = held ? 1 : 2 * (before + behind);
        w->upper[i] = held ? 0 : behind;
        const double factor = i ? lower / w->diagonal[i - 1] : 0;
        if (i) w->diagonal[i] -= factor * w->upper[i - 1];
        for (int c = 0; c < w->m; c++) {
            double right = (i ? pull(w, i - 1, c) : 0) + (i < last ? pull(w, i, c) : 0);
            if (held) right = ends[(i ? m : 0) + (size_t)c];
            w->slopes[i * m + (size_t)c] = right - (i ? factor * w->slopes[(i - 1) * m + (size_t)c] : 0);
        }
    }
    for (size_t i = last + 1; i-- > 0;)
        for (size_t c = 0; c < m; c++) {
            const double next = i < last ? w->upper[i] * w->slopes[(i + 1) * m + c] : 0;
            w->slopes[i * m + c] = (w->slopes[i * m + c] - next) / w->diagonal[i];
        }
}

/* Closed: the last column is eliminated along (corner), and the last row at the end. */
static void solve_closed(work *w) {
    const size_t m = (size_t)w->m, n = w->n, last = n - 1;
    double row = 1 / step(w, last),
           final = 2 * (1 / step(w, last - 1) + row); /* the last row: its first entry, its diagonal */
    double right[BAT_DIMENSION_MAX];
    for (int c = 0; c < w->m; c++) right[c] = pull(w, last - 1, c) + pull(w, last, c);
    for (size_t i = 0; i < last; i++) {
        const double before = 1 / step(w, i ? i - 1 : last), behind = 1 / step(w, i);
        w->diagonal[i] = 2 * (before + behind), w->upper[i] = behind, w->corner[i] = i ? 0 : before;
        for (int c = 0; c < w->m; c++)
            w->slopes[i * m + (size_t)c] = pull(w, i ? i - 1 : last, c) + pull(w, i, c);
        if (i) {
            const double factor = before / w->diagonal[i - 1];
            w->diagonal[i] -= factor * w->upper[i - 1], w->corner[i] -= factor * w->corner[i - 1];
            for (size_t c = 0; c < m; c++) w->slopes[i * m + c] -= factor * w->slopes[(i - 1) * m + c];
        }
        if (i + 1 == last) w->corner[i] += w->upper[i], w->upper[i] = 0, row += 1 / step(w, last - 1);
        const double factor = row / w->diagonal[i];
        final -= factor * w->corner[i];
        for (size_t c = 0; c < m; c++) right[c] -= factor * w->slopes[i * m + c];
        row = -factor * w->upper[i];
    }
    for (size_t c = 0; c < m; c++) w->slopes[last * m + c] = right[c] / final;
    for (size_t i = last; i-- > 0;)
        for (size_t c = 0; c < m; c++) {
            const double next = i + 1 < last ? w->upper[i] * w->slopes[(i + 1) * m + c] : 0;
            const double far = w->corner[i] * w->slopes[last * m + c];
            w->slopes[i * m + c] = (w->slopes[i * m + c] - next - far) / w->diagonal[i];
        }
    memcpy(w->slopes + n * m, w->slopes, m * sizeof *w->slopes);
}

/* The blossom of piece i at three parameters. */
static void blossom(const work *w, size_t i, double a, double b, double c, double *out) {
    const double h = step(w, i), x[3] = {(a - w->t[i]) / h, (b - w->t[i]) / h, (c - w->t[i]) / h};
    const size_t m = (size_t)w->m;
    for (size_t k = 0; k < m; k++) {
        const double p0 = w->points[i * m + k], p3 = w->points[(i + 1) * m + k];
        double d[4] = {p0, p0 + w->slopes[i * m + k] * h / 3, p3 - w->slopes[(i + 1) * m + k] * h / 3, p3};
        for (int r = 0; r < 3; r++)
            for (int j = 0; j < 3 - r; j++) d[j] += x[r] * (d[j + 1] - d[j]);
        out[k] = d[0];
    }
}

static bat_status open_curve(const work *w, bat_curve **out) {
    const size_t n = w->n, m = (size_t)w->m;
    double *points = malloc((n + 2) * m * sizeof *points), *knots = malloc((n + 6) * sizeof *knots);
    bat_status status = points && knots ? BAT_OK : BAT_MEMORY;
    for (size_t j = 0; status == BAT_OK && j < n + 6; j++)
        knots[j] = w->t[j < 3 ? 0 : j - 3 < n ? j - 3 : n - 1];
    for (size_t j = 0; status == BAT_OK && j < n + 2; j++) {
        const size_t piece = j < 2 ? 0 : j - 2 < n - 1 ? j - 2 : n - 2;
        blossom(w, piece, knots[j + 1], knots[j + 2], knots[j + 3], points + j * m);
    }
    if (status == BAT_OK) status = bat_curve_create(w->m, 3, false, n + 2, points, (int)n + 6, knots, out);
    free(points), free(knots);
    return status;
}

static bat_status closed_curve(const work *w, bat_curve **out) {
    const size_t n = w->n, m = (size_t)w->m;
    const double period = w->t[n] - w->t[0];
    double *points = malloc(n * m * sizeof *points);
    if (!points) return BAT_MEMORY;
    for (size_t j = 0; j < n; j++) { /* about the middle one of its three knots */
        const size_t middle = (j + 2) % n, piece = middle;
        const double a = middle ? w->t[middle - 1] : w->t[n - 1] - period;
        blossom(w, piece, a, w->t[middle], w->t[middle + 1], points + j * m);
    }
    const bat_status status = bat_curve_create(w->m, 3, true, n, points, (int)n + 1, w->t, out);
    free(points);
    return status;
}

static bat_status interpolate(work *w, bool closed, const double *ends, bat_curve **out) {
    const size_t m = (size_t)w->m;
    if (closed) memcpy(w->points + w->n * m, w->points, m * sizeof *w->points);
    w->t[0] = 0;
    for (size_t i = 1; i < w->n + closed; i++)
        w->t[i] = w->t[i - 1] + sqrt(chord(w->points + (i - 1) * m, w->points + i * m, w->m));
    double scaled[2 * BAT_DIMENSION_MAX];
    for (size_t e = 0; ends && e < 2; e++) {
        const size_t i = e ? w->n - 2 : 0;
        const double *d = ends + e * m, length = chord((const double[]){0, 0, 0}, d, w->m);
        const double speed = chord(w->points + i * m, w->points + (i + 1) * m, w->m) / step(w, i);
        if (!(length > 0) || !isfinite(length)) return BAT_NUMBER;
        for (size_t c = 0; c < m; c++) scaled[e * m + c] = d[c] / length * speed;
    }
    if (closed)
        solve_closed(w);
    else
        solve_open(w, ends ? scaled : NULL);
    return closed ? closed_curve(w, out) : open_curve(w, out);
}

bat_status bat_interpolate(int dimension, bool closed, size_t count, const double *points, const double *ends,
                           bat_curve **out) {
    if (!points || !out) return BAT_ARGUMENT;
    if (dimension != 2 && dimension != 3) return BAT_DIMENSION;
    if (count < 2 || count > BAT_POINTS_MAX - 8) return BAT_COUNT;
    for (size_t i = 0; i < count * (size_t)dimension; i++)
        if (!(fabs(points[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    const size_t room = count + 1, m = (size_t)dimension;
    double *block = malloc(room * (2 * m + 4) * sizeof *block);
    if (!block) return BAT_MEMORY;
    work w = {.m = dimension, .points = block, .slopes = block + room * m, .t = block + 2 * room * m};
    w.diagonal = w.t + room, w.upper = w.diagonal + room, w.corner = w.upper + room;
    w.n = take(dimension, count, points, closed, w.points);
    const bat_status status = w.n < (closed ? 3 : 2) ? BAT_COUNT
                                                     : interpolate(&w, closed, closed ? NULL : ends, out);
    free(block);
    return status;
}

bat_status bat_interpolate_at(int dimension, size_t n, const double *points, const double *t,
                              bat_curve **out) {
    const size_t m = (size_t)dimension;
    double *block = malloc(n * (2 * m + 3) * sizeof *block);
    if (!block) return BAT_MEMORY;
    work w = {.m = dimension, .n = n, .points = block, .slopes = block + n * m, .t = block + 2 * n * m};
    w.diagonal = w.t + n, w.upper = w.diagonal + n;
    memcpy(w.points, points, n * m * sizeof *points);
    memcpy(w.t, t, n * sizeof *t);
    solve_open(&w, NULL);
    const bat_status status = open_curve(&w, out);
    free(block);
    return status;
}
