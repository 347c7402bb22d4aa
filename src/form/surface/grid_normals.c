/* Unit normals on a grid. Those of ordinary points are computed side by side; where tangents nearly vanish or are nearly
 * parallel, bat_surface_normal decides. */
#include "base/lanes.h"
#include "form/surface/grid.h"
#include "form/surface/tile.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

enum { PLANE = 3 * BAT_TILE, LANES = 8 };

/* Bounds on squares under which a point is left to bat_surface_normal. */
static const double ordinary_length = 1e-16, ordinary_sine = 1e-12, least = 1e-200, most = 1e200;

static int64_t bits_of(double x) {
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* A unit vector along S_u x S_v, of which a to c and d to f are the coordinates. Negative when the square of its length is
 * not between the bounds, which are given as their bits: positive numbers have the order of their bits. */
BAT_INLINE int64_t unit(double a, double b, double c, double d, double e, double f, int64_t low, int64_t high,
                        double *out) {
    const double x = b * f - c * e, y = c * d - a * f, z = a * e - b * d;
    const double square = x * x + y * y + z * z, scale = 1 / sqrt(square);
    int64_t bits;
    memcpy(&bits, &square, sizeof bits);
    out[0] = x * scale, out[1] = y * scale, out[2] = z * scale;
    return (bits - low) | (high - bits);
}

BAT_INLINE double sum(int terms, const bat_tile_sum *s, size_t j) {
    double value = s->weights[0] * s->rows[0][j];
    for (int k = 1; k < terms; k++) value += s->weights[k] * s->rows[k][j];
    return value;
}

BAT_INLINE bool row_of(int u_terms, int v_terms, size_t n, const bat_tile_sum sums[2], double low,
                       double *restrict out) {
    const bat_tile_sum u = sums[0], v = sums[1];
    const int64_t from = bits_of(low), to = bits_of(most);
    int64_t fault = 0;
    for (size_t j = 0; j < n; j++)
        fault |= unit(sum(u_terms, &u, j), sum(u_terms, &u, j + n), sum(u_terms, &u, j + 2 * n),
                      sum(v_terms, &v, j), sum(v_terms, &v, j + n), sum(v_terms, &v, j + 2 * n), from, to,
                      out + 3 * j);
    return fault >= 0;
}

/* A row of normals of a surface that is cubic in u, and of tangents that are there. low: squares of lengths above it are
 * those of ordinary points. False when a point is not ordinary. */
BAT_CLONES static bool row_of_cubics(size_t n, const bat_tile_sum sums[2], double low, double *restrict out) {
    return row_of(3, 4, n, sums, low, out);
}

BAT_CLONES static bool row_of_tangents(size_t n, const bat_tile_sum sums[2], double low,
                                       double *restrict out) {
    return row_of(1, 1, n, sums, low, out);
}

/* The sum of the squares of all vectors in the planes of several rows: no blend of the rows has a greater square. */
BAT_CLONES static double greatest(int terms, const double *const *rows, size_t count) {
    double lanes[LANES] = {0}, all = 0;
    for (int k = 0; k < terms; k++) {
        const double *x = rows[k];
        size_t j = 0;
        for (; j + LANES <= 3 * count; j += LANES)
            for (size_t lane = 0; lane < LANES; lane++) lanes[lane] += x[j + lane] * x[j + lane];
        for (; j < 3 * count; j++) all += x[j] * x[j];
    }
    for (int lane = 0; lane < LANES; lane++) all += lanes[lane];
    return all;
}

/* The least square of a tangent's length at a parameter: so long that over the span it is a share of the size. */
static double reach_at(const bat_surface *surface, const bat_curve *axis, double at, int *span) {
    *span = bat_span(axis, bat_curve_reduce(axis, at), *span);
    const double width = axis->knots[*span + 1] - axis->knots[*span];
    return ordinary_length * (surface->size / width) * (surface->size / width);
}

typedef struct strip {
    const bat_surface *surface;
    bat_tile *tile;
    size_t count;
    const double *v;
    double v_reach[BAT_TILE], v_most; /* the least squares of S_v at each v, and the greatest of them */
    double low;                       /* of quick_row, for the rows that are blended now */
} strip;

static bool is_ordinary(const double a[3], const double b[3], double u_reach, double v_reach) {
    const double n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const double u2 = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], v2 = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
    return u2 > u_reach && v2 > v_reach && square > ordinary_sine * u2 * v2 && square > least &&
           square < most;
}

/* A row in which a point may have no normal, one by one. */
static void careful_row(const strip *s, double u, double u_reach, const bat_tile_sum sums[2], double *out) {
    const int p = s->surface->axis[0].degree;
    for (size_t j = 0; j < s->count; j++) {
        double a[3], b[3], *to = out + 3 * j;
        for (size_t c = 0; c < 3; c++)
            a[c] = sum(p, &sums[0], j + c * s->count), b[c] = sum(p + 1, &sums[1], j + c * s->count);
        if (is_ordinary(a, b, u_reach, s->v_reach[j]))
            unit(a[0], a[1], a[2], b[0], b[1], b[2], 0, 0, to);
        else if (bat_surface_normal(s->surface, u, s->v[j], to) != BAT_OK)
            memset(to, 0, 3 * sizeof *to);
    }
}

static void row_of_normals(strip *s, double u, double u_reach, double *points, double *out) {
    const int p = s->surface->axis[0].degree;
    bat_tile_sum sums[2];
    if (bat_tile_tangents(s->tile, u, points, sums)) {
        /* The square is at most u2 v2, so above this u2 and v2 are above their bounds, too. */
        const double u2 = greatest(p, sums[0].rows, s->count), v2 = greatest(p + 1, sums[1].rows, s->count);
        s->low = fmax(fmax(ordinary_sine * u2 * v2, least), fmax(u_reach * v2, s->v_most * u2));
    }
    bool done = s->low < most;
    if (done && p == 3)
        done = row_of_cubics(s->count, sums, s->low, out);
    else if (done) {
        double block[2][PLANE], *const planes[BAT_TILE_PLANES] = {NULL, block[0], block[1]};
        const bat_tile_sum there[2] = {{{1}, {block[0]}}, {{1}, {block[1]}}};
        bat_tile_at(s->tile, u, planes);
        done = row_of_tangents(s->count, there, s->low, out);
    }
    if (!done) careful_row(s, u, u_reach, sums, out);
}

static void move(strip *s, size_t count, const double *v, int *span) {
    s->count = count, s->v = v, s->v_most = 0;
    bat_tile_move(s->tile, count, v);
    for (size_t j = 0; j < count; j++) {
        s->v_reach[j] = reach_at(s->surface, &s->surface->axis[1], v[j], span);
        s->v_most = fmax(s->v_most, s->v_reach[j]);
    }
}

bat_status bat_surface_normal_grid(const bat_surface *surface, size_t u_count, const double *u,
                                   size_t v_count, const double *v, double *points, double *normals) {
    bat_status status = bat_grid_check(surface, u_count, u, v_count, v, normals);
    if (status != BAT_OK || u_count == 0 || v_count == 0) return status;
    strip s = {.surface = surface};
    status = bat_tile_create(surface, 1, true, &s.tile);
    if (status != BAT_OK) return status;
    int u_span = -1, v_span = -1;
    for (size_t start = 0; start < v_count; start += BAT_TILE) {
        move(&s, v_count - start < BAT_TILE ? v_count - start : BAT_TILE, v + start, &v_span);
        for (size_t i = 0; i < u_count; i++) {
            const size_t at = 3 * (i * v_count + start);
            const double u_reach = reach_at(surface, &surface->axis[0], u[i], &u_span);
            row_of_normals(&s, u[i], u_reach, points ? points + at : NULL, normals + at);
        }
    }
    bat_tile_free(s.tile);
    return BAT_OK;
}
