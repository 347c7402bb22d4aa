/*
 * The closest point of a surface (docs/math/surfaces.md). The squared distance f is a polynomial in Bernstein
 * form on each Bézier cell; its least coefficient is a lower bound. Of all cells of all spans the one with the least
 * bound is halved next, until no cell can be nearer than the best point so far by more than rounding. Each better
 * point starts a descent by Newton steps within its span.
 */
#include "form/surface/finder.h"
#include "base/vec.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double NEED = 1 - 1e-12;
static const double TIE =
    1 - 1e-6; /* of squares: cells with bounds above this are nearly as close as the best point */
enum { CELLS_MAX = 100000, TIES_MAX = 20000, HALVINGS = 104, STEPS = 60, MOST = BAT_DEGREE_MAX + 1 };

/* f and half its derivatives at x, and in which directions x cannot move because it would leave the span. */
typedef struct place {
    double x[2], f, g[2], h[3], a[2]; /* h: uu, uv, vv; a: |S_u|^2, |S_v|^2 */
    bool held[2];
    double slope; /* half the slope of f per unit length on the surface, in the free directions */
} place;

/* A cell that waits. */
typedef struct queued {
    double bound;
    int cell, span[2]; /* its number in the pool */
} queued;

typedef struct search {
    bat_surface *seen;           /* with the given point as the origin */
    int degree[2], best_span[2]; /* best_span: the span of `best` */
    place best;
    double weight[2][MOST],
        share[2][2 * MOST]; /* binomials of the degree; reciprocals of those of twice it */
    double need;            /* a point must be nearer by so much to be sought: 1, or a bit less; of squares */
    double rounding;        /* and by so much as distance */
    const bat_near_hints *hints;
    bat_cells pool;
    queued *heap; /* those that wait, the one with the least bound first; then those that are free */
    int waiting, room;
    int cells, ties;
} search;

/* Whether a point with this f, or a bound on it, would be nearer than the best one by more than rounding. */
static bool is_worth(const search *s, double f) {
    return f < s->best.f * s->need && sqrt(fmax(f, 0)) + s->rounding < sqrt(s->best.f);
}

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

/* The least Bernstein coefficient of f. */
static double bound_of(const search *s, const double *net) {
    const int p = s->degree[0], q = s->degree[1];
    double f[4 * MOST * MOST] = {0}, least = INFINITY, scaled[3 * BAT_CELL_POINTS];
    for (int i = 0, n = 0; i <= p; i++)
        for (int j = 0; j <= q; j++, n++) {
            const vec a = vec_load(net + 3 * n, 3);
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
    return least;
}

/* Starts a descent from each corner that is better than the best point so far. */
static void try_corners(search *s, const int span[2], const bat_cell *cell) {
    const int p = s->degree[0], q = s->degree[1];
    for (int k = 0; k < 4; k++) {
        const double *a = cell->net + 3 * ((k & 2 ? p * (q + 1) : 0) + (k & 1 ? q : 0));
        if (!is_worth(s, a[0] * a[0] + a[1] * a[1] + a[2] * a[2])) continue;
        descend(s, span, bat_span_parameter(s->seen, 0, span[0], (k & 2 ? cell->high : cell->low)[0]),
                bat_span_parameter(s->seen, 1, span[1], (k & 1 ? cell->high : cell->low)[1]));
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

/* ---- Cells that wait: a heap; behind it, the numbers of those that are free ---- */

/* Room for two more; false without memory. */
static bool hold(search *s) {
    if (s->waiting + 2 <= s->room) return true;
    if (!bat_cells_hold(&s->pool, s->waiting + 2)) return false;
    queued *heap = realloc(s->heap, (size_t)s->pool.room * sizeof *heap);
    if (!heap) return false;
    for (s->heap = heap; s->room < s->pool.room; s->room++) heap[s->room].cell = s->room;
    return true;
}

/* Puts the free cell that stands at `from` into the heap, unless it need not be looked at. */
static void wait(search *s, int from, const int span[2]) {
    const int cell = s->heap[from].cell;
    const double bound = bound_of(s, s->pool.at[cell].net);
    if (!is_worth(s, bound)) return;
    int at = s->waiting++;
    s->heap[from].cell = s->heap[at].cell;
    for (; at > 0 && bound < s->heap[(at - 1) / 2].bound; at = (at - 1) / 2)
        s->heap[at] = s->heap[(at - 1) / 2];
    s->heap[at] = (queued){bound, cell, {span[0], span[1]}};
}

/* The first cell becomes the first free one. */
static queued next_cell(search *s) {
    const queued first = s->heap[0], last = s->heap[--s->waiting];
    int at = 0;
    for (int below; (below = 2 * at + 1) < s->waiting; at = below) {
        if (below + 1 < s->waiting && s->heap[below + 1].bound < s->heap[below].bound) below++;
        if (!(s->heap[below].bound < last.bound)) break;
        s->heap[at] = s->heap[below];
    }
    s->heap[at] = last;
    s->heap[s->waiting].cell = first.cell;
    return first;
}

/* Both return whether there was memory. */
static bool begin_span(search *s, const int span[2]) {
    if (!hold(s)) return false;
    bat_cell *cell = &s->pool.at[s->heap[s->waiting].cell];
    bat_cell_of(s->seen, span, cell);
    if (s->hints && !is_worth(s, bound_of(s, cell->net))) return true;
    descend(s, span, bat_span_parameter(s->seen, 0, span[0], 0.5),
            bat_span_parameter(s->seen, 1, span[1], 0.5));
    wait(s, s->waiting, span);
    return true;
}

static bool halve_next(search *s) {
    const queued next = next_cell(s);
    if (!hold(s)) return false;
    bat_cell *lower = s->pool.at + next.cell, *upper = s->pool.at + s->heap[s->waiting + 1].cell;
    try_corners(s, next.span, lower);
    if (lower->halvings == HALVINGS || !is_worth(s, next.bound)) return true;
    bat_cell_halve(s->degree, longer(s, lower->net), lower, upper);
    const int other = s->waiting + 1;
    wait(s, s->waiting, next.span);
    wait(s, other, next.span);
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

typedef struct gathering {
    const double *point;
    double least; /* no closest point is further away */
    size_t count;
    patch *patches;
} gathering;

static void collect_block(const bat_surface_finder *f, int block, gathering *g) {
    const int first[2] = {block / f->blocks[1] * BAT_FINDER_BLOCK, block % f->blocks[1] * BAT_FINDER_BLOCK};
    double far;
    int span[2];
    for (int i = first[0]; i < first[0] + BAT_FINDER_BLOCK && i < f->spans[0]; i++)
        for (int j = first[1]; j < first[1] + BAT_FINDER_BLOCK && j < f->spans[1]; j++) {
            const double bound = near_and_far(&f->span[i * f->spans[1] + j], g->point, &far);
            if (!(bound <= g->least) || !bat_finder_span(f, i, j, span)) continue;
            g->least = fmin(g->least, far * (1 + 1e-14));
            g->patches[g->count++] = (patch){bound, {span[0], span[1]}};
        }
}

/* Spans that can hold the closest point: none is nearer than the farthest point of another's box, nor than `least`. */
static size_t collect(const bat_surface_finder *f, const double point[3], double least, patch *patches) {
    gathering g = {point, least, 0, patches};
    const int count = f->blocks[0] * f->blocks[1];
    double nearest = INFINITY, far;
    int first = 0;
    for (int b = 0; b < count && count > 1; b++) {
        const double bound = near_and_far(&f->block[b], point, &far);
        if (bound < nearest) nearest = bound, first = b;
    }
    collect_block(f, first, &g);
    for (int b = 0; b < count; b++)
        if (b != first && near_and_far(&f->block[b], point, &far) <= g.least) collect_block(f, b, &g);
    size_t kept = 0;
    for (size_t i = 0; i < g.count; i++)
        if (patches[i].bound <= g.least) patches[kept++] = patches[i];
    return kept;
}

/* From where the closest point is expected. */
static void try_hint(search *s, const bat_surface_finder *f, const double point[3]) {
    int span[2];
    for (int d = 0; d < 2; d++) span[d] = bat_span(&f->surface->axis[d], s->hints->at[d], -1);
    bat_finder_see(f, span, point, NULL, s->seen);
    descend(s, span, s->hints->at[0], s->hints->at[1]);
}

/* Whether the search goes on with a cell of this bound: cells that are nearly as close as the best point, and all together,
 * are counted. */
static bool goes_on(search *s, double bound) {
    if (!is_worth(s, bound)) return false;
    if (bound >= s->best.f * TIE) s->ties++;
    return s->ties <= (s->hints ? BAT_NEAR_CELLS : TIES_MAX) && s->cells++ < CELLS_MAX;
}

static bat_status search_all(search *s, const bat_surface_finder *f, const double point[3]) {
    patch *patches = malloc((size_t)f->spans[0] * (size_t)f->spans[1] * sizeof *patches);
    if (!patches) return BAT_MEMORY;
    bool held = true;
    if (s->hints && s->hints->at) try_hint(s, f, point);
    const size_t count = collect(f, point, s->best.f, patches);
    qsort(patches, count, sizeof *patches, by_bound); /* no ties */
    for (size_t i = 0; held;) {
        const double box = i < count ? patches[i].bound : INFINITY;
        const double cell = s->waiting ? s->heap[0].bound : INFINITY;
        if (!(fmin(box, cell) < INFINITY) || !goes_on(s, fmin(box, cell))) break;
        if (box <= cell) {
            bat_finder_see(f, patches[i].span, point, NULL, s->seen);
            held = begin_span(s, patches[i++].span);
        } else {
            held = halve_next(s);
        }
    }
    free(patches);
    return held ? BAT_OK : BAT_MEMORY;
}

/* What rounding does to distances from the point. */
static double rounding_of(const bat_surface_finder *f, const double point[3]) {
    double most = 0;
    for (int c = 0; c < 3; c++)
        most = fmax(fmax(most, fabs(point[c])), fmax(fabs(f->whole.low[c]), fabs(f->whole.high[c])));
    return 32 * DBL_EPSILON * most;
}

bat_status bat_finder_near(const bat_surface_finder *finder, const double point[3],
                           const bat_near_hints *hints, bat_surface_point *out, bool *found) {
    for (int c = 0; c < 3; c++)
        if (!(fabs(point[c]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    const bat_surface *surface = finder->surface;
    bat_surface *seen;
    bat_status status = bat_finder_seen(finder, &seen);
    if (status != BAT_OK) return status;
    search s = {.seen = seen, .best = {.f = INFINITY, .slope = INFINITY}, .best_span = {-1, -1}, .need = 1};
    s.rounding = rounding_of(finder, point);
    if (hints) s.hints = hints, s.need = NEED, s.best.f = hints->within * hints->within;
    for (int d = 0; d < 2; d++) {
        const int p = s.degree[d] = surface->axis[d].degree;
        for (int i = 0; i <= p; i++) s.weight[d][i] = binomial(p, i);
        for (int i = 0; i <= 2 * p; i++) s.share[d][i] = 1 / binomial(2 * p, i);
    }
    status = search_all(&s, finder, point);
    if (hints && hints->pieces) *hints->pieces += (size_t)s.cells;
    *found = s.best_span[0] >= 0;
    if (status == BAT_OK && *found) {
        bat_surface_eval_spans(surface, s.best_span, s.best.x[0], s.best.x[1], 0, out->point);
        out->u = bat_curve_reduce(&surface->axis[0], s.best.x[0]),
        out->v = bat_curve_reduce(&surface->axis[1], s.best.x[1]);
        out->distance = bat_distance(out->point, point, 3);
    }
    free(s.pool.at), free(s.heap);
    bat_surface_free(seen);
    return status;
}

bat_status bat_surface_finder_nearest(const bat_surface_finder *finder, const double point[3],
                                      bat_surface_point *out) {
    bool found;
    return finder && point && out ? bat_finder_near(finder, point, NULL, out, &found) : BAT_ARGUMENT;
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
