#include "form/surface/finder.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const bat_box NOTHING = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

/* No NaN: plain comparisons, which are faster than fmin. */
static void join(bat_box *box, const bat_box *with) {
    for (int c = 0; c < 3; c++) {
        box->low[c] = with->low[c] < box->low[c] ? with->low[c] : box->low[c];
        box->high[c] = with->high[c] > box->high[c] ? with->high[c] : box->high[c];
    }
}

/* The boxes of q + 1 points in a row, from each point on. */
static void join_row(const bat_surface *surface, int i, int spans, bat_box *out) {
    const int q = surface->axis[1].degree;
    const double *point = bat_surface_stored_row(surface, i).points;
    for (int j = 0; j < spans; j++, point += 3) {
        bat_box box = NOTHING;
        for (int l = 0; l <= q; l++) {
            const double *p = point + 3 * l;
            const bat_box one = {{p[0], p[1], p[2]}, {p[0], p[1], p[2]}};
            join(&box, &one);
        }
        out[j] = box;
    }
}

static void fill(bat_surface_finder *finder, bat_box *rows) {
    const bat_surface *s = finder->surface;
    const int p = s->axis[0].degree, m = finder->spans[0], n = finder->spans[1];
    for (int i = 0; i < s->axis[0].spread; i++) join_row(s, i, n, rows + (size_t)i * (size_t)n);
    for (int i = 0; i < m; i++)
        for (int j = 0; j < n; j++) {
            bat_box box = NOTHING;
            for (int k = 0; k <= p; k++) join(&box, &rows[(size_t)(i + k) * (size_t)n + (size_t)j]);
            finder->span[i * n + j] = box;
            join(&finder->block[i / BAT_FINDER_BLOCK * finder->blocks[1] + j / BAT_FINDER_BLOCK], &box);
            join(&finder->whole, &box);
        }
}

static size_t shares_of(const bat_curve *axis) { return (size_t)((axis->degree + 1) * (axis->degree + 1)); }

static void fill_shares(bat_surface_finder *finder) {
    for (int d = 0; d < 2; d++) {
        const bat_curve *axis = &finder->surface->axis[d];
        for (int i = 0; i < finder->spans[d]; i++) {
            const int span = axis->degree + i;
            if (axis->knots[span] < axis->knots[span + 1])
                bat_cell_shares(axis, span, finder->shares[d] + (size_t)i * shares_of(axis));
        }
    }
}

bat_status bat_surface_finder_create(const bat_surface *surface, bat_surface_finder **out) {
    if (!surface || !out) return BAT_ARGUMENT;
    bat_surface_finder finder = {.surface = surface, .whole = NOTHING};
    for (int d = 0; d < 2; d++) {
        finder.spans[d] = surface->axis[d].spread - surface->axis[d].degree;
        finder.blocks[d] = (finder.spans[d] + BAT_FINDER_BLOCK - 1) / BAT_FINDER_BLOCK;
    }
    const size_t spans = (size_t)finder.spans[0] * (size_t)finder.spans[1];
    const size_t blocks = (size_t)finder.blocks[0] * (size_t)finder.blocks[1];
    size_t shares[2];
    for (int d = 0; d < 2; d++) shares[d] = (size_t)finder.spans[d] * shares_of(&surface->axis[d]);
    bat_surface_finder *made = malloc(sizeof *made + (spans + blocks) * sizeof(bat_box) +
                                      (shares[0] + shares[1]) * sizeof(double));
    bat_box *rows = malloc((size_t)surface->axis[0].spread * (size_t)finder.spans[1] * sizeof *rows);
    if (!made || !rows) {
        free(made), free(rows);
        return BAT_MEMORY;
    }
    finder.span = (bat_box *)(void *)(made + 1), finder.block = finder.span + spans;
    for (size_t i = 0; i < blocks; i++) finder.block[i] = NOTHING;
    finder.shares[0] = (double *)(void *)(finder.block + blocks),
    finder.shares[1] = finder.shares[0] + shares[0];
    *made = finder;
    fill(made, rows);
    fill_shares(made);
    free(rows);
    *out = made;
    return BAT_OK;
}

void bat_surface_finder_free(bat_surface_finder *finder) { free(finder); }

bool bat_finder_span(const bat_surface_finder *finder, int i, int j, int span[2]) {
    const bat_curve *axis = finder->surface->axis;
    span[0] = axis[0].degree + i, span[1] = axis[1].degree + j;
    return axis[0].knots[span[0]] < axis[0].knots[span[0] + 1] &&
           axis[1].knots[span[1]] < axis[1].knots[span[1] + 1];
}

bat_status bat_finder_seen(const bat_surface_finder *finder, bat_surface **out) {
    const bat_curve *axis = finder->surface->axis;
    const int degree[2] = {axis[0].degree, axis[1].degree}, count[2] = {axis[0].count, axis[1].count};
    const bool closed[2] = {axis[0].closed, axis[1].closed};
    bat_status status = bat_surface_allocate(degree, closed, count, out);
    if (status != BAT_OK) return status;
    for (int d = 0; d < 2; d++)
        memcpy((*out)->axis[d].knots, axis[d].knots,
               ((size_t)axis[d].spread + (size_t)axis[d].degree + 1) * sizeof(double));
    (*out)->size = finder->surface->size;
    return BAT_OK;
}

void bat_finder_share(const bat_surface_finder *finder, const int span[2], double *net) {
    const bat_curve *axis = finder->surface->axis;
    const int degree[2] = {axis[0].degree, axis[1].degree};
    const double *shares[2];
    for (int d = 0; d < 2; d++)
        shares[d] = finder->shares[d] + (size_t)(span[d] - degree[d]) * shares_of(&axis[d]);
    bat_cell_share(degree, shares, net);
}

void bat_finder_see(const bat_surface_finder *finder, const int span[2], const double *origin,
                    const double *axes, bat_surface *seen) {
    const bat_surface *s = finder->surface;
    const size_t p = (size_t)s->axis[0].degree, q = (size_t)s->axis[1].degree, n = (size_t)s->axis[1].spread;
    for (size_t i = (size_t)span[0] - p; i <= (size_t)span[0]; i++)
        for (size_t j = (size_t)span[1] - q; j <= (size_t)span[1]; j++) {
            const double *from = s->points + (i * n + j) * 3;
            double *to = seen->points + (i * n + j) * 3;
            const double d[3] = {from[0] - origin[0], from[1] - origin[1], from[2] - origin[2]};
            for (int c = 0; c < 3; c++)
                to[c] = axes ? axes[3 * c] * d[0] + axes[3 * c + 1] * d[1] + axes[3 * c + 2] * d[2] : d[c];
        }
}
