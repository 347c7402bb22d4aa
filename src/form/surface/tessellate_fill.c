/* The vertices of triangles: evaluated on a grid; then normals at creases, collapsed edges and other places where the
 * surface has none. */
#include "form/surface/tessellate.h"
#include "base/vec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct part {
    bat_tessellation *t;
    const bat_surface *surface;
    size_t count[2];
    const size_t *index[2]; /* the rows and the columns to be evaluated */
} part;

static size_t vertex(const part *p, size_t i, size_t j) {
    return 3 * (p->index[0][i] * p->t->count[1] + p->index[1][j]);
}

static bat_status evaluate(const part *p) {
    const size_t m = p->count[0], n = p->count[1];
    const bat_tessellation *t = p->t;
    if (m == t->count[0] && n == t->count[1])
        return bat_surface_normal_grid(p->surface, m, t->at[0], n, t->at[1], t->points, t->normals);
    double *work = calloc(m + n + 6 * m * n, sizeof *work);
    if (!work) return BAT_MEMORY;
    double *u = work, *v = u + m, *points = v + n, *normals = points + 3 * m * n;
    for (size_t i = 0; i < m; i++) u[i] = t->at[0][p->index[0][i]];
    for (size_t j = 0; j < n; j++) v[j] = t->at[1][p->index[1][j]];
    bat_status status = bat_surface_normal_grid(p->surface, m, u, n, v, points, normals);
    for (size_t i = 0; status == BAT_OK && i < m; i++)
        for (size_t j = 0; j < n; j++) {
            const size_t to = vertex(p, i, j), from = 3 * (i * n + j);
            memcpy(t->points + to, points + from, 3 * sizeof *points);
            memcpy(t->normals + to, normals + from, 3 * sizeof *normals);
        }
    free(work);
    return status;
}

static bool is_zero(const double *n) { return n[0] == 0 && n[1] == 0 && n[2] == 0; }

/* A parameter a little inside the triangles beside a stop. */
static double inside_of(const bat_tessellation *t, int d, size_t k) {
    const size_t last = t->count[d] - 1;
    const size_t other = k < last ? k + 1 : k - 1;
    return t->at[d][k] + 1e-3 * (t->at[d][other] - t->at[d][k]);
}

/* Normals of creases, before which they are those of the span that ends there; and of places without a normal: those
 * just inside along u, along v, or both. */
static void beside_normals(const part *p) {
    const bat_tessellation *t = p->t;
    for (size_t i = 0; i < p->count[0]; i++)
        for (size_t j = 0; j < p->count[1]; j++) {
            const size_t r = p->index[0][i], c = p->index[1][j];
            double *normal = t->normals + vertex(p, i, j);
            const double u = t->stop[0][r].beside, v = t->stop[1][c].beside;
            const bool moved = u != t->at[0][r] || v != t->at[1][c];
            if (moved && bat_surface_normal(p->surface, u, v, normal) == BAT_OK) continue;
            if (!moved && !is_zero(normal)) continue;
            const double x = inside_of(t, 0, r), y = inside_of(t, 1, c);
            if (bat_surface_normal(p->surface, x, v, normal) != BAT_OK &&
                bat_surface_normal(p->surface, u, y, normal) != BAT_OK &&
                bat_surface_normal(p->surface, x, y, normal) != BAT_OK)
                memset(normal, 0, 3 * sizeof *normal);
        }
}

/* What still has no normal takes one from a vertex before it, or after it, or any. */
static void last_normals(const part *p) {
    const double up[3] = {0, 0, 1}, *known = up;
    for (int pass = 0; pass < 2; pass++)
        for (size_t i = 0; i < p->count[0]; i++)
            for (size_t j = 0; j < p->count[1]; j++) {
                double *normal = p->t->normals + vertex(p, i, j);
                if (!is_zero(normal))
                    known = normal;
                else if (known != up || pass == 1)
                    memcpy(normal, known, sizeof up);
            }
}

/* The vertices of a collapsed edge are one point to the bit, so that the triangles between them are left out. */
static void join_points(const part *p, int d) {
    const bat_tessellation *t = p->t;
    const double slack = 1e-13 * bat_surface_size(p->surface);
    const int other = 1 - d;
    if (p->count[other] != t->count[other])
        return; /* not the whole edge moves: it is no point, or stays one */
    for (size_t k = 0; k < p->count[d]; k++) {
        const double *first = t->points + (d == 0 ? vertex(p, k, 0) : vertex(p, 0, k));
        bool point = true;
        for (size_t l = 0; l < p->count[other] && point; l++) {
            const double *x = t->points + (d == 0 ? vertex(p, k, l) : vertex(p, l, k));
            for (int c = 0; c < 3; c++) point = point && fabs(x[c] - first[c]) <= slack;
        }
        for (size_t l = 0; l < p->count[other] && point; l++)
            memmove(t->points + (d == 0 ? vertex(p, k, l) : vertex(p, l, k)), first, 3 * sizeof *first);
    }
}

bat_status bat_tessellation_fill(bat_tessellation *t, const bat_surface *surface, size_t row_count,
                                 const size_t *rows, size_t column_count, const size_t *columns) {
    const part p = {t, surface, {row_count, column_count}, {rows, columns}};
    bat_status status = evaluate(&p);
    if (status != BAT_OK) return status;
    join_points(&p, 0);
    join_points(&p, 1);
    beside_normals(&p);
    last_normals(&p);
    return BAT_OK;
}

/* ---- Updates ---- */

/* Whether a stop lies within the interval, which may be unwrapped. */
static bool is_moved(const bat_tessellation *t, int d, bool closed, size_t k, const double moved[2]) {
    const double at = t->at[d][k], period = t->domain[d][1] - t->domain[d][0];
    if (!closed) return at >= moved[0] && at <= moved[1];
    if (moved[1] - moved[0] >= period) return true;
    const double low = moved[0] - floor((moved[0] - t->domain[d][0]) / period) * period;
    const double high = low + (moved[1] - moved[0]);
    return (at >= low && at <= high) || at + period <= high;
}

bat_status bat_tessellation_update(bat_tessellation *t, const bat_surface *surface, bat_direction direction,
                                   const double moved[2], size_t range[2]) {
    if (!t || !surface || !moved) return BAT_ARGUMENT;
    if (!isfinite(moved[0]) || !isfinite(moved[1])) return BAT_NUMBER;
    for (int d = 0; d < 2; d++) {
        double domain[2];
        bat_surface_domain(surface, d == 0 ? BAT_U : BAT_V, domain);
        if (domain[0] != t->domain[d][0] || domain[1] != t->domain[d][1]) return BAT_ARGUMENT;
    }
    const int d = direction == BAT_V;
    const size_t most = t->count[0] > t->count[1] ? t->count[0] : t->count[1];
    size_t *chosen = malloc(2 * most * sizeof *chosen), count = 0;
    if (!chosen) return BAT_MEMORY;
    size_t *all = chosen + most;
    for (size_t k = 0; k < most; k++) all[k] = k;
    for (size_t k = 0; k < t->count[d]; k++)
        if (is_moved(t, d, surface->axis[d].closed, k, moved)) chosen[count++] = k;
    bat_status status = BAT_OK;
    size_t found[2] = {0, 0};
    if (count > 0) {
        status = d == 0 ? bat_tessellation_fill(t, surface, count, chosen, t->count[1], all)
                        : bat_tessellation_fill(t, surface, t->count[0], all, count, chosen);
        const size_t n = t->count[1], first = chosen[0], last = chosen[count - 1];
        found[0] = d == 0 ? first * n : first;
        found[1] = d == 0 ? (last + 1) * n : (t->count[0] - 1) * n + last + 1;
    }
    free(chosen);
    if (status == BAT_OK && range) memcpy(range, found, sizeof found);
    return status;
}
