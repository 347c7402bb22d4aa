/*
 * The closest point of a surface (docs/math/surfaces.md). The squared distance f is a polynomial in Bernstein
 * form on each Bézier cell; its least coefficient is a lower bound. A cell that cannot be nearer than the best
 * point so far is dropped; others are halved. Each better point starts a descent by Newton steps within its span.
 */
#include "form/surface/finder.h"
#include "base/vec.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS_MAX = 100000, HALVINGS = 52, STEPS = 60, MOST = BAT_DEGREE_MAX + 1 };

/* f and half its derivatives at x, and in which directions x cannot move because it would leave the span. */
typedef struct place {
    double x[2], f, g[2], h[3], a[2]; /* h: uu, uv, vv; a: |S_u|^2, |S_v|^2 */
    bool held[2];
    double slope; /* half the slope of f per unit length on the surface, in the free directions */
} place;

typedef struct search {
    bat_surface *seen;                    /* with the given point as the origin */
    int degree[2], span[2], best_span[2]; /* best_span: the span of `best` */
    place best;
    double weight[2][MOST],
        share[2][2 * MOST]; /* binomials of the degree; reciprocals of those of twice it */
    int cells;
    bat_cells waiting;
} search;

/* ---- Descent ---- */

static void look(const search *s, const int span[2], const double x[2], place *out) {
    double jet[18];
    bat_surface_eval_spans(s->seen, span, x[0], x[1], 2, jet);
    const vec r = vec_load(jet, 3), du = vec_load(jet + 3, 3), dv = vec_load(jet + 6, 3);
    *out = (place){.x = {x[0], x[1]}, .f = vec_dot(r, r)};
    out->g[0] = vec_dot(r, du), out->g[1] = vec_dot(r, dv);
    out->a[0] = vec_dot(du, du), out->a[1] = vec_dot(dv, dv);
    out->h[0] = out->a[0] + vec_dot(r, vec_load(jet + 9, 3));
    out->h[1] = vec_dot(du, dv) + vec_dot(r, vec_load(jet + 12, 3));
    out->h[2] = out->a[1] + vec_dot(r, vec_load(jet + 15, 3));
    for (int d = 0; d < 2; d++) {
        const double *t = s->seen->axis[d].knots + span[d];
        out->held[d] = (x[d] <= t[0] && out->g[d] >= 0) || (x[d] >= t[1] && out->g[d] <= 0) ||
                       !(out->a[d] > 0);
        if (!out->held[d]) out->slope += fabs(out->g[d]) / sqrt(out->a[d]);
    }
}

/* Newton's step where f is convex, else a step down the slope. */
static void step_from(const place *p, double move[2]) {
    const double det = p->h[0] * p->h[2] - p->h[1] * p->h[1];
    const double second[2] = {p->h[0], p->h[2]};
    move[0] = move[1] = 0;
    if (!p->held[0] && !p->held[1] && p->h[0] > 0 && det > 1e-14 * p->h[0] * p->h[2]) {
        move[0] = (p->h[1] * p->g[1] - p->h[2] * p->g[0]) / det;
        move[1] = (p->h[1] * p->g[0] - p->h[0] * p->g[1]) / det;
        return;
    }
    for (int d = 0; d < 2; d++)
        if (!p->held[d]) move[d] = -p->g[d] / (second[d] > 1e-3 * p->a[d] ? second[d] : p->a[d]);
}

/* Whether f has decreased, or f is equal up to rounding and the slope has decreased. */
static bool is_better(const place *now, const place *before) {
    if (now->f < before->f * (1 - 1e-14)) return true;
    return now->f <= before->f * (1 + 1e-14) && now->slope < before->slope;
}

static void descend(search *s, const int span[2], double u, double v) {
    place p, next;
    look(s, span, (const double[2]){u, v}, &p);
    for (int i = 0; i < STEPS && p.slope > 0; i++) {
        double move[2], x[2], share = 1;
        step_from(&p, move);
        bool better = false;
        for (int k = 0; k < 30 && !better; k++, share *= 0.5) {
            for (int d = 0; d < 2; d++) {
                const double *t = s->seen->axis[d].knots + span[d];
                x[d] = fmin(fmax(p.x[d] + share * move[d], t[0]), t[1]);
            }
            if (x[0] == p.x[0] && x[1] == p.x[1]) break;
            look(s, span, x, &next);
            better = is_better(&next, &p);
        }
        if (!better) break;
        p = next;
    }
    if (!is_better(&p, &s->best)) return;
    s->best = p;
    memcpy(s->best_span, span, sizeof s->best_span);
}

/* ---- Cells ---- */

static double binomial(int n, int k) {
    double c = 1;
    for (int i = 1; i <= k; i++) c = c * (n - k + i) / i;
    return c;
}

/* The least Bernstein coefficient of f, minus a bound on the rounding error. */
static double bound_of(const search *s, const double *net) {
    const int p = s->degree[0], q = s->degree[1];
    double f[4 * MOST * MOST] = {0}, greatest = 0, least = INFINITY, scaled[3 * BAT_CELL_POINTS];
    for (int i = 0, n = 0; i <= p; i++)
        for (int j = 0; j <= q; j++, n++) {
            const vec a = vec_load(net + 3 * n, 3);
            greatest = fmax(greatest, vec_dot(a, a));
            vec_store(vec_scale(a, s->weight[0][i] * s->weight[1][j]), scaled + 3 * n);
        }
    for (int i = 0, n = 0; i <= p; i++)
        for (int j = 0; j <= q; j++, n++)
            for (int k = 0, m = 0; k <= p; k++)
                for (int l = 0; l <= q; l++, m++) {
                    const double *a = scaled + 3 * n, *b = scaled + 3 * m;
                    f[(i + k) * (2 * q + 1) + j + l] += a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                }
    for (int k = 0; k <= 2 * p; k++)
        for (int l = 0; l <= 2 * q; l++)
            least = fmin(least, f[k * (2 * q + 1) + l] * s->share[0][k] * s->share[1][l]);
    return least + 16 * DBL_EPSILON * greatest;
}

/* Starts a descent from each corner that is better than the best point so far. */
static void try_corners(search *s, const bat_cell *cell) {
    const int p = s->degree[0], q = s->degree[1];
    for (int k = 0; k < 4; k++) {
        const double *a = cell->net + 3 * ((k & 2 ? p * (q + 1) : 0) + (k & 1 ? q : 0));
        if (!(a[0] * a[0] + a[1] * a[1] + a[2] * a[2] < s->best.f)) continue;
        descend(s, s->span, bat_span_parameter(s->seen, 0, s->span[0], (k & 2 ? cell->high : cell->low)[0]),
                bat_span_parameter(s->seen, 1, s->span[1], (k & 1 ? cell->high : cell->low)[1]));
    }
}

/* The direction in which the cell's net is longer. */
static int longer(const search *s, const double *net) {
    const int p = s->degree[0], q = s->degree[1];
    double way[2] = {0, 0};
    for (int i = 0; i <= p; i++)
        for (int j = 0; j <= q; j++) {
            const double *a = net + 3 * (i * (q + 1) + j);
            if (i < p) way[0] = fmax(way[0], bat_distance(a, a + 3 * (q + 1), 3) * p);
            if (j < q) way[1] = fmax(way[1], bat_distance(a, a + 3, 3) * q);
        }
    return way[0] < way[1];
}

/* Whether there was memory. */
static bool search_span(search *s) {
    int top = 0;
    if (!bat_cells_hold(&s->waiting, 1)) return false;
    bat_cell_of(s->seen, s->span, s->waiting.at);
    descend(s, s->span, bat_span_parameter(s->seen, 0, s->span[0], 0.5),
            bat_span_parameter(s->seen, 1, s->span[1], 0.5));
    while (top >= 0 && s->cells++ < CELLS_MAX) {
        if (!bat_cells_hold(&s->waiting, top + 2)) return false;
        bat_cell *cell = s->waiting.at + top--;
        try_corners(s, cell);
        if (cell->halvings == HALVINGS || !(bound_of(s, cell->net) < s->best.f)) continue;
        bat_cell_halve(s->degree, longer(s, cell->net), cell, cell + 1);
        top += 2;
    }
    return true;
}

/* ---- All spans, those with the nearest boxes first ---- */

typedef struct patch {
    double bound;
    int span[2];
} patch;

static int by_bound(const void *a, const void *b) {
    const patch *x = a, *y = b;
    if (x->bound != y->bound) return x->bound < y->bound ? -1 : 1;
    const int d = x->span[0] != y->span[0] ? 0 : 1;
    return (x->span[d] > y->span[d]) - (x->span[d] < y->span[d]);
}

/* The squared distances of a point from the nearest and the farthest point of a box. */
static double near_and_far(const bat_box *box, const double point[3], double *far) {
    double near = 0;
    *far = 0;
    for (int c = 0; c < 3; c++) {
        const double low = box->low[c] - point[c], high = box->high[c] - point[c];
        const double d = fmax(fmax(low, -high), 0), e = fmax(fabs(low), fabs(high));
        near += d * d, *far += e * e;
    }
    return near;
}

/* Spans that can hold the closest point: none is nearer than the farthest point of another's box. */
static size_t collect(const bat_surface_finder *f, const double point[3], patch *patches) {
    double least = INFINITY, far;
    size_t count = 0;
    int span[2];
    for (int i = 0; i < f->spans[0]; i++)
        for (int j = 0; j < f->spans[1]; j++) {
            const double bound = near_and_far(&f->span[i * f->spans[1] + j], point, &far);
            if (!(bound <= least) || !bat_finder_span(f, i, j, span)) continue;
            least = fmin(least, far * (1 + 1e-14));
            patches[count++] = (patch){bound, {span[0], span[1]}};
        }
    size_t kept = 0;
    for (size_t i = 0; i < count; i++)
        if (patches[i].bound <= least) patches[kept++] = patches[i];
    return kept;
}

static bat_status search_all(search *s, const bat_surface_finder *f, const double point[3]) {
    patch *patches = malloc((size_t)f->spans[0] * (size_t)f->spans[1] * sizeof *patches);
    if (!patches) return BAT_MEMORY;
    bool held = true;
    const size_t count = collect(f, point, patches);
    qsort(patches, count, sizeof *patches, by_bound); /* no ties */
    for (size_t i = 0; i < count && held && patches[i].bound < s->best.f; i++) {
        memcpy(s->span, patches[i].span, sizeof s->span);
        bat_finder_see(f, s->span, point, NULL, s->seen);
        held = search_span(s);
    }
    free(patches);
    return held ? BAT_OK : BAT_MEMORY;
}

bat_status bat_surface_finder_nearest(const bat_surface_finder *finder, const double point[3],
                                      bat_surface_point *out) {
    if (!finder || !point || !out) return BAT_ARGUMENT;
    for (int c = 0; c < 3; c++)
        if (!(fabs(point[c]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    const bat_surface *surface = finder->surface;
    bat_surface *seen;
    bat_status status = bat_finder_seen(finder, &seen);
    if (status != BAT_OK) return status;
    search s = {.seen = seen, .best = {.f = INFINITY, .slope = INFINITY}};
    for (int d = 0; d < 2; d++) {
        const int p = s.degree[d] = surface->axis[d].degree;
        for (int i = 0; i <= p; i++) s.weight[d][i] = binomial(p, i);
        for (int i = 0; i <= 2 * p; i++) s.share[d][i] = 1 / binomial(2 * p, i);
    }
    status = search_all(&s, finder, point);
    if (status == BAT_OK) {
        bat_surface_eval_spans(surface, s.best_span, s.best.x[0], s.best.x[1], 0, out->point);
        out->u = bat_curve_reduce(&surface->axis[0], s.best.x[0]),
        out->v = bat_curve_reduce(&surface->axis[1], s.best.x[1]);
        out->distance = bat_distance(out->point, point, 3);
    }
    free(s.waiting.at);
    bat_surface_free(seen);
    return status;
}

bat_status bat_surface_nearest(const bat_surface *surface, const double point[3], bat_surface_point *out) {
    bat_surface_finder *finder = NULL;
    if (!surface || !point || !out) return BAT_ARGUMENT;
    bat_status status = bat_surface_finder_create(surface, &finder);
    if (status != BAT_OK) return status;
    status = bat_surface_finder_nearest(finder, point, out);
    bat_surface_finder_free(finder);
    return status;
}
