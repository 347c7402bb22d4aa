/* A stretch of a grid: rows of the surface at the parameters v of the tile, then blended for each u. */
#include "form/surface/tile.h"
#include "base/lanes.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST = BAT_DEGREE_MAX + 1,
    WIDTH = 3 * BAT_TILE,
    ORDERS = 3,
    LINE = 8 /* numbers in a line of the cache */
};

struct bat_tile {
    const bat_surface *surface;
    int order, terms; /* terms: rows that meet in a span, degree + 1 */
    bool apart;
    size_t count;
    const double *v;
    int span;       /* of u; the steps below belong to it; -1: none */
    int held[MOST]; /* the stored row in each slot; -1: none */
    double *work;   /* a row as curves evaluate it */
    double *rows;   /* for each derivative by v: the slots, then steps[1] and steps[2], each `terms` rows */
};

/* Row j of the k-th differences by u, of the l-th derivative by v. k = 0: slots. */
static double *row_of(const bat_tile *tile, int l, int k, int j) {
    return tile->rows + (size_t)((l * ORDERS + k) * tile->terms + j) * WIDTH;
}

bat_status bat_tile_create(const bat_surface *surface, int order, bool apart, bat_tile **out) {
    const int terms = surface->axis[0].degree + 1, used = order == 0 ? terms : (order + 1) * ORDERS * terms;
    const size_t head = (sizeof(bat_tile) + sizeof(double) - 1) / sizeof(double);
    double *block = malloc((head + (size_t)(order + 1 + used) * WIDTH + LINE) * sizeof *block);
    if (!block) return BAT_MEMORY;
    bat_tile *tile = (bat_tile *)(void *)block;
    *tile = (bat_tile){.surface = surface, .order = order, .terms = terms, .apart = apart};
    tile->work = block + head;
    tile->rows = tile->work + (size_t)(order + 1) * WIDTH;
    while ((uintptr_t)tile->rows % (LINE * sizeof(double)) != 0) tile->rows++;
    bat_tile_move(tile, 0, NULL);
    *out = tile;
    return BAT_OK;
}

void bat_tile_free(bat_tile *tile) { free(tile); }

void bat_tile_move(bat_tile *tile, size_t count, const double *v) {
    tile->count = count, tile->v = v, tile->span = -1;
    for (int j = 0; j < MOST; j++) tile->held[j] = -1;
}

/* out = (add ? out : 0) + the sum of w[j] rows[j], term by term. */
BAT_INLINE void sum_of(int terms, bool add, const double *w, const double *const *rows, size_t n,
                       double *restrict out) {
    for (size_t c = 0; c < n; c++) {
        double sum = add ? out[c] + w[0] * rows[0][c] : w[0] * rows[0][c];
        for (int j = 1; j < terms; j++) sum += w[j] * rows[j][c];
        out[c] = sum;
    }
}

BAT_CLONES static void blend(int terms, const double *w, const double *const *rows, size_t n, double *out) {
    if (terms < 1) return;
    switch (terms < 4 ? terms : 4) {
    case 1: sum_of(1, false, w, rows, n, out); break;
    case 2: sum_of(2, false, w, rows, n, out); break;
    case 3: sum_of(3, false, w, rows, n, out); break;
    default: sum_of(4, false, w, rows, n, out); break;
    }
    for (int j = 4; j < terms; j++) sum_of(1, true, w + j, rows + j, n, out);
}

BAT_CLONES static void step(const double *a, const double *b, double scale, size_t n, double *restrict out) {
    for (size_t c = 0; c < n; c++) out[c] = (b[c] - a[c]) * scale;
}

/* Points of 3 numbers, `stride` apart, to rows of x, y and z. */
static void part(const double *from, size_t stride, size_t count, double *restrict to) {
    for (size_t j = 0; j < count; j++, from += stride)
        for (size_t c = 0; c < 3; c++) to[c * count + j] = from[c];
}

/* Stored row i at the v of the tile, and its derivatives. */
static void fill_slot(bat_tile *tile, int i) {
    const bat_curve row = bat_surface_stored_row(tile->surface, i);
    const int slot = i % tile->terms, size = 3 * (tile->order + 1);
    tile->held[slot] = i;
    if (tile->order == 0) {
        bat_curve_eval_sorted(&row, tile->count, tile->v, 0, row_of(tile, 0, 0, slot));
        return;
    }
    bat_curve_eval_sorted(&row, tile->count, tile->v, tile->order, tile->work);
    for (int l = 0; l <= tile->order; l++) {
        double *to = row_of(tile, l, 0, slot);
        const double *from = tile->work + 3 * l;
        if (tile->apart && l > 0)
            part(from, (size_t)size, tile->count, to);
        else
            for (size_t j = 0; j < tile->count; j++, from += size, to += 3) memcpy(to, from, 3 * sizeof *to);
    }
}

static const double *value_row(const bat_tile *tile, int span, int l, int k, int j) {
    return row_of(tile, l, k, k == 0 ? (span - tile->terms + 1 + j) % tile->terms : j);
}

/* What all u of a span have in common: values of the rows that meet there, and their differences. */
static void enter_span(bat_tile *tile, int span) {
    const int p = tile->terms - 1;
    const double *t = tile->surface->axis[0].knots + span;
    for (int i = span - p; i <= span; i++)
        if (tile->held[i % tile->terms] != i) fill_slot(tile, i);
    for (int k = 1; k <= tile->order && k <= p; k++)
        for (int l = 0; l + k <= tile->order; l++)
            for (int j = 0; j <= p - k; j++) {
                double *out = row_of(tile, l, k, j);
                step(value_row(tile, span, l, k - 1, j), value_row(tile, span, l, k - 1, j + 1),
                     (p - k + 1) / (t[j + 1] - t[j + k - p]), 3 * tile->count,
                     tile->apart ? tile->work : out);
                if (tile->apart) part(tile->work, 3, tile->count, out);
            }
    tile->span = span;
}

/* The span of u, whose rows are then there, and its basis functions of all degrees. */
static int enter(bat_tile *tile, double u, double basis[MOST][MOST]) {
    const bat_curve *axis = &tile->surface->axis[0];
    const double at = bat_curve_reduce(axis, u);
    const int span = bat_span(axis, at, tile->span);
    if (span != tile->span) enter_span(tile, span);
    bat_basis_rows(axis, span, at, basis);
    return span;
}

/* The derivative of order k by u and l by v; k is at most the degree. Returns the number of rows. */
static int rows_at(const bat_tile *tile, int span, int k, int l, const double *rows[MOST]) {
    for (int j = 0; j < tile->terms - k; j++) rows[j] = value_row(tile, span, l, k, j);
    return tile->terms - k;
}

void bat_tile_at(bat_tile *tile, double u, double *const planes[BAT_TILE_PLANES]) {
    const int p = tile->terms - 1;
    double basis[MOST][MOST];
    const int span = enter(tile, u, basis);
    for (int k = 0; k <= tile->order; k++)
        for (int l = 0; k + l <= tile->order; l++) {
            double *out = planes[(k + l) * (k + l + 1) / 2 + l];
            const double *rows[MOST];
            if (!out) continue;
            if (k > p)
                memset(out, 0, 3 * tile->count * sizeof *out);
            else
                blend(rows_at(tile, span, k, l, rows), basis[p - k], rows, 3 * tile->count, out);
        }
}

bool bat_tile_tangents(bat_tile *tile, double u, double *points, bat_tile_sum sums[2]) {
    const int before = tile->span, p = tile->terms - 1;
    double basis[MOST][MOST];
    const double *rows[MOST];
    const int span = enter(tile, u, basis);
    if (points) blend(rows_at(tile, span, 0, 0, rows), basis[p], rows, 3 * tile->count, points);
    for (int l = 0; l < 2; l++) {
        rows_at(tile, span, 1 - l, l, sums[l].rows);
        memcpy(sums[l].weights, basis[p - 1 + l], sizeof sums[l].weights);
    }
    return span != before;
}
