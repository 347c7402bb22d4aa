/*
 * Closest points, certified by signs of Bernstein coefficients.
 *
 * On a span, with q = C - P, the squared distance f = q . q and its half derivative g = q . q' are
 * polynomials in Bernstein form. The least coefficient of f bounds the distance from below; the sign changes
 * of the coefficients of g bound the number of stationary points (Descartes; Lane & Riesenfeld 1981). No sign
 * change: the minimum is at an end. One: Newton between brackets finds the one stationary point. More: halve
 * the span. So nothing is sampled and nothing is missed, up to rounding: a piece is dropped when no point on
 * it is nearer by more than some ten units in the last place of its own distance.
 *
 * Spans hang in a tree of boxes, eight children a node, nearest child first.
 */
#include <batten/nearest.h>

#include "curve/lsq.h"
#include "base/lanes.h"
#include "base/real.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FAN = 8, LEVELS = 12, DEPTH = 50, MOST = BAT_DEGREE_MAX + 1 };

/* Boxes of the eight children, coordinate by coordinate; absent children are boxes inside out. */
typedef struct node {
    double low[BAT_DIMENSION_MAX][FAN];
    double high[BAT_DIMENSION_MAX][FAN];
} node;

/* A non-empty span: Bezier points first, then the local polynomial of lsq.h, (p + 1) * dimension each. */
typedef struct span {
    double middle, half;
    double data[];
} span;

struct bat_finder {
    int degree, dimension;
    bool closed;
    double start, end; /* the domain */
    int spans;
    int levels;          /* level 0 holds the spans' boxes, the last level one node */
    size_t stride;       /* bytes per span */
    size_t base[LEVELS]; /* first node of a level */
    node *nodes;
    char *records;
};

static const span *span_of(const bat_finder *finder, int i) {
    return (const span *)(const void *)(finder->records + (size_t)i * finder->stride);
}

static const double binomial[15][15] = {
    {1},
    {1, 1},
    {1, 2, 1},
    {1, 3, 3, 1},
    {1, 4, 6, 4, 1},
    {1, 5, 10, 10, 5, 1},
    {1, 6, 15, 20, 15, 6, 1},
    {1, 7, 21, 35, 35, 21, 7, 1},
    {1, 8, 28, 56, 70, 56, 28, 8, 1},
    {1, 9, 36, 84, 126, 126, 84, 36, 9, 1},
    {1, 10, 45, 120, 210, 252, 210, 120, 45, 10, 1},
    {1, 11, 55, 165, 330, 462, 462, 330, 165, 55, 11, 1},
    {1, 12, 66, 220, 495, 792, 924, 792, 495, 220, 66, 12, 1},
    {1, 13, 78, 286, 715, 1287, 1716, 1716, 1287, 715, 286, 78, 13, 1},
    {1, 14, 91, 364, 1001, 2002, 3003, 3432, 3003, 2002, 1001, 364, 91, 14, 1},
};

/* ---- Building ---- */

static void clear(node *n) {
    for (int c = 0; c < BAT_DIMENSION_MAX; c++)
        for (int k = 0; k < FAN; k++) n->low[c][k] = INFINITY, n->high[c][k] = -INFINITY;
}

static void fill_spans(bat_finder *finder, const bat_curve *curve) {
    const int p = curve->degree, m = curve->dimension, size = (p + 1) * m;
    const double *t = curve->knots;
    char *record = finder->records;
    int index = 0;
    for (int i = p; i < curve->spread; i++) {
        if (!(t[i + 1] > t[i])) continue;
        span *s = (span *)(void *)record;
        double T[MOST * MOST];
        s->middle = t[i] + 0.5 * (t[i + 1] - t[i]), s->half = 0.5 * (t[i + 1] - t[i]);
        bat_span_bezier(curve, i, s->data);
        bat_lsq_transform(curve, i - p, T);
        for (int k = 0; k <= p; k++)
            for (int c = 0; c < m; c++) {
                double sum = 0;
                for (int j = 0; j <= p; j++)
                    sum += T[k * (p + 1) + j] * curve->points[(size_t)(i - p + j) * (size_t)m + (size_t)c];
                s->data[size + k * m + c] = sum;
            }
        node *n = finder->nodes + index / FAN;
        for (int j = 0; j <= p; j++)
            for (int c = 0; c < m; c++) {
                const double x = s->data[j * m + c];
                if (x < n->low[c][index % FAN]) n->low[c][index % FAN] = x;
                if (x > n->high[c][index % FAN]) n->high[c][index % FAN] = x;
            }
        index++, record += finder->stride;
    }
}

bat_status bat_finder_create(const bat_curve *curve, bat_finder **out) {
    if (!curve || !out) return BAT_ARGUMENT;
    const int p = curve->degree, m = curve->dimension;
    size_t spans = 0, nodes = 0, base[LEVELS];
    for (int i = p; i < curve->spread; i++) spans += curve->knots[i + 1] > curve->knots[i];
    int levels = 0;
    for (size_t n = spans;;) {
        n = (n + FAN - 1) / FAN;
        base[levels++] = nodes;
        nodes += n;
        if (n == 1) break;
    }
    const size_t stride = sizeof(span) + 2 * (size_t)((p + 1) * m) * sizeof(double);
    bat_finder *finder = malloc(sizeof *finder + nodes * sizeof(node) + spans * stride);
    if (!finder) return BAT_MEMORY;
    finder->degree = p, finder->dimension = m, finder->spans = (int)spans, finder->levels = levels;
    finder->stride = stride;
    finder->nodes = (node *)(void *)(finder + 1);
    finder->records = (char *)(finder->nodes + nodes);
    finder->closed = curve->closed, finder->start = curve->knots[p],
    finder->end = curve->knots[curve->spread];
    memcpy(finder->base, base, sizeof base);
    for (size_t i = 0; i < nodes; i++) clear(finder->nodes + i);
    fill_spans(finder, curve);
    for (int level = 1; level < levels; level++) {
        const size_t below = base[level] - base[level - 1];
        for (size_t i = 0; i < below; i++) {
            const node *child = finder->nodes + base[level - 1] + i;
            node *n = finder->nodes + base[level] + i / FAN;
            for (int c = 0; c < m; c++)
                for (int k = 0; k < FAN; k++) {
                    if (child->low[c][k] < n->low[c][i % FAN]) n->low[c][i % FAN] = child->low[c][k];
                    if (child->high[c][k] > n->high[c][i % FAN]) n->high[c][i % FAN] = child->high[c][k];
                }
        }
    }
    *out = finder;
    return BAT_OK;
}

void bat_finder_free(bat_finder *finder) { free(finder); }

/* ---- One span ---- */

/* What is being looked for: the nearest point so far. */
typedef struct search {
    double squared;
    double s; /* local coordinate */
    const span *on;
} search;

static inline void offer(search *best, double squared, const span *on, double s) {
    if (squared < best->squared ||
        (squared == best->squared && (on < best->on || (on == best->on && s < best->s))))
        best->squared = squared, best->on = on, best->s = s;
}

/* Bernstein coefficients of f (out[2p + 1]) from q[(p + 1) * m]; also the greatest |q|^2. */
static inline double square(const int p, const int m, const double *q, double *out) {
    double greatest = 0;
    for (int k = 0; k <= 2 * p; k++) out[k] = 0;
    for (int i = 0; i <= p; i++)
        for (int j = i; j <= p; j++) {
            double dot = 0;
            for (int c = 0; c < m; c++) dot += q[i * m + c] * q[j * m + c];
            if (i == j && dot > greatest) greatest = dot;
            out[i + j] += (i == j ? 1 : 2) * binomial[p][i] * binomial[p][j] / binomial[2 * p][i + j] * dot;
        }
    return greatest;
}

/* Bernstein coefficients of q . q' up to a factor: out[2p]. */
static inline void slope(const int p, const int m, const double *q, double *out) {
    for (int k = 0; k < 2 * p; k++) out[k] = 0;
    for (int j = 0; j < p; j++) {
        double d[BAT_DIMENSION_MAX];
        for (int c = 0; c < m; c++) d[c] = q[(j + 1) * m + c] - q[j * m + c];
        for (int i = 0; i <= p; i++) {
            double dot = 0;
            for (int c = 0; c < m; c++) dot += q[i * m + c] * d[c];
            out[i + j] += binomial[p][i] * binomial[p - 1][j] / binomial[2 * p - 1][i + j] * dot;
        }
    }
}

/* Sign changes among n numbers, those within `zero` of zero skipped; at, next: where the last change is;
 * first, final: the outermost signs, 0 when there are none. */
typedef struct signs {
    int count, at, next, first, final;
} signs;

static inline signs signs_of(int n, const double *a, double zero) {
    signs out = {0, 0, 0, 0, 0};
    int where = 0;
    for (int i = 0; i < n; i++) {
        const int sign = (a[i] > zero) - (a[i] < -zero);
        if (sign == 0) continue;
        if (!out.first) out.first = sign;
        if (out.final && sign != out.final) out.count++, out.at = where, out.next = i;
        out.final = sign, where = i;
    }
    return out;
}

/* Root of g between s0 and s1, where g goes from minus to plus: Newton, bisection where it leaves the
 * bracket. local is relative to the query point. Offers what it finds. */
static inline double polish(const int p, const int m, const double *local, double s0, double s1, double s,
                            double *squared) {
    for (int step = 0;; step++) {
        double f = 0, g = 0, h = 0;
        for (int c = 0; c < m; c++) {
            double a = local[p * m + c], b = 0, d = 0;
            for (int k = p - 1; k >= 0; k--) {
                d = d * s + b;
                b = b * s + a;
                a = a * s + local[k * m + c];
            }
            f += a * a, g += a * b, h += b * b + 2 * a * d;
        }
        *squared = f;
        if (step >= 80 || g == 0) return s;
        if (g < 0)
            s0 = s;
        else
            s1 = s;
        const double move = h > 0 ? -g / h : 2 * (s1 - s0);
        if (fabs(move) < 2 * DBL_EPSILON) return s;
        if (s + move > s0 && s + move < s1) {
            s += move;
            /* Quadratic: from here a step leaves less than rounding. Evaluate where it landed, and be done.
             */
            if (fabs(move) < 1e-9) step = 79;
        } else {
            const double middle = 0.5 * (s0 + s1);
            if (!(middle > s0 && middle < s1)) return s;
            s = middle;
        }
    }
}

/* Where the control polygon of g crosses zero: near its root. */
static inline double crossing(int n, const double *g, signs found, double s0, double s1) {
    const double x = (found.at + (found.next - found.at) * g[found.at] / (g[found.at] - g[found.next])) /
                     (n - 1);
    return s0 + (s1 - s0) * x;
}

typedef struct piece {
    double q[MOST * BAT_DIMENSION_MAX]; /* Bezier points minus the query point */
    double s0, s1;                      /* of the span's -1..1 */
    int depth;
} piece;

/* De Casteljau at the middle: left half in place, right half out. */
static inline void halve(const int p, const int m, piece *left, piece *right) {
    double *q = left->q;
    memcpy(right->q + p * m, q + p * m, (size_t)m * sizeof *q);
    for (int r = 1; r <= p; r++) {
        for (int j = p; j >= r; j--)
            for (int c = 0; c < m; c++) q[j * m + c] = 0.5 * (q[(j - 1) * m + c] + q[j * m + c]);
        memcpy(right->q + (p - r) * m, q + p * m, (size_t)m * sizeof *q);
    }
    const double middle = 0.5 * (left->s0 + left->s1);
    right->s0 = middle, right->s1 = left->s1, left->s1 = middle;
    right->depth = ++left->depth;
}

/* Whatever on this span is nearer than best. */
static inline void search_span(const span *s, const int p, const int m, const double *point, search *best) {
    piece stack[DEPTH + 2];
    double local[MOST * BAT_DIMENSION_MAX];
    bool shifted = false;
    int top = 0;
    for (int j = 0; j <= p; j++)
        for (int c = 0; c < m; c++) stack[0].q[j * m + c] = s->data[j * m + c] - point[c];
    stack[0].s0 = -1, stack[0].s1 = 1, stack[0].depth = 0;
    while (top >= 0) {
        piece *now = stack + top;
        double f[2 * BAT_DEGREE_MAX + 1], g[2 * BAT_DEGREE_MAX];
        const double greatest = square(p, m, now->q, f);
        offer(best, f[0], s, now->s0);
        offer(best, f[2 * p], s, now->s1);
        double least = f[0];
        for (int k = 1; k <= 2 * p; k++) least = f[k] < least ? f[k] : least;
        if (!(least < best->squared - 16 * DBL_EPSILON * greatest)) {
            top--;
            continue;
        }
        slope(p, m, now->q, g);
        const signs found = signs_of(2 * p, g, 0);
        if (found.count <= 1) {
            if (found.count == 1 && found.final > 0) {
                if (!shifted) {
                    memcpy(local, s->data + (p + 1) * m, (size_t)((p + 1) * m) * sizeof *local);
                    for (int c = 0; c < m; c++) local[c] -= point[c];
                    shifted = true;
                }
                double squared;
                const double start = crossing(2 * p, g, found, now->s0, now->s1);
                const double root = polish(p, m, local, now->s0, now->s1, start, &squared);
                offer(best, squared, s, root);
            }
            top--;
        } else if (now->depth >= DEPTH) {
            top--; /* 2^-50 of a span: its ends have been offered */
        } else {
            halve(p, m, now, now + 1);
            /* The half with the nearer hull first: its find may prove the other one empty. */
            top++;
        }
    }
}

/* ---- The tree ---- */

typedef struct branch {
    double bound;
    int level, index; /* level -1: a span */
} branch;

/* How far x lies outside of an interval, squared. */
BAT_INLINE double outside(double low, double high, double x) {
    const double below = low - x, above = x - high;
    double d = below > above ? below : above;
    d = d > 0 ? d : 0;
    return d * d;
}

/* Squared distances of a point from the eight boxes of a node; INFINITY for those that are absent. */
BAT_INLINE void find_bounds(const node *restrict n, const int m, const double *restrict point,
                            double *restrict bound) {
    for (int k = 0; k < FAN; k++) {
        double sum = 0;
        for (int c = 0; c < m; c++) sum += outside(n->low[c][k], n->high[c][k], point[c]);
        bound[k] = sum;
    }
}

BAT_CLONES static void bounds_of(const node *n, int m, const double *point, double *bound) {
#ifdef __OPTIMIZE_SIZE__
    find_bounds(n, m, point, bound);
#else
    if (m == 2)
        find_bounds(n, 2, point, bound);
    else
        find_bounds(n, 3, point, bound);
#endif
}

static inline void search_tree(const bat_finder *finder, const int p, const int m, const double *point,
                               search *best) {
    branch stack[LEVELS * FAN + 1];
    int top = 0;
    stack[top++] = (branch){0, finder->levels - 1, 0};
    while (top > 0) {
        const branch b = stack[--top];
        if (b.bound > best->squared) continue;
        if (b.level < 0) {
            search_span(span_of(finder, b.index), p, m, point, best);
            continue;
        }
        const node *n = finder->nodes + finder->base[b.level] + b.index;
        double bound[FAN];
        bounds_of(n, m, point, bound);
        /* Nearest on top; of equals the first. */
        const int floor = top;
        for (int k = FAN - 1; k >= 0; k--) {
            if (bound[k] > best->squared || bound[k] == INFINITY) continue;
            int at = top++;
            for (; at > floor && stack[at - 1].bound < bound[k]; at--) stack[at] = stack[at - 1];
            stack[at] = (branch){bound[k], b.level - 1, b.index * FAN + k};
        }
    }
}

static bool finite_point(const double *point, int m) {
    for (int c = 0; c < m; c++)
        if (!isfinite(point[c])) return false;
    return true;
}

static void near_of(const bat_finder *finder, const span *on, double s, const double *point, bat_near *out) {
    const int p = finder->degree, m = finder->dimension;
    const double *local = on->data + (p + 1) * m;
    double distance = 0;
    out->u = on->middle + on->half * s;
    if (out->u > finder->end) out->u = finder->end;
    if (out->u < finder->start || (finder->closed && out->u == finder->end)) out->u = finder->start;
    for (int c = 0; c < BAT_DIMENSION_MAX; c++) out->point[c] = 0;
    for (int c = 0; c < m; c++) {
        double x = local[p * m + c];
        for (int k = p - 1; k >= 0; k--) x = x * s + local[k * m + c];
        if (s == -1) x = on->data[c]; /* ends are exact */
        if (s == 1) x = on->data[p * m + c];
        out->point[c] = x;
        distance = bat_hypot(distance, x - point[c]);
    }
    out->distance = distance;
}

void bat_finder_nearest(const bat_finder *finder, const double *point, bat_near *out) {
    const int p = finder->degree, m = finder->dimension;
    search best = {INFINITY, -1, span_of(finder, 0)};
    if (finite_point(point, m)) {
        if (p == 3 && m == 2)
            search_tree(finder, 3, 2, point, &best);
        else if (p == 3)
            search_tree(finder, 3, 3, point, &best);
        else
            search_tree(finder, p, m, point, &best);
    }
    near_of(finder, best.on, best.s, point, out);
}

bat_status bat_curve_nearest(const bat_curve *curve, const double *point, bat_near *out) {
    if (!curve || !point || !out) return BAT_ARGUMENT;
    if (!finite_point(point, curve->dimension)) return BAT_NUMBER;
    bat_finder *finder;
    const bat_status status = bat_finder_create(curve, &finder);
    if (status != BAT_OK) return status;
    bat_finder_nearest(finder, point, out);
    bat_finder_free(finder);
    return BAT_OK;
}

/* ---- All local minima ---- */

/* The nearest `room` of what comes in; a minimum that rounding shows twice, on both sides of a joint, is one.
 */
typedef struct collector {
    const bat_finder *finder;
    const double *point;
    double within;
    size_t room, count;
    bat_near *out;
    bool waiting;
    bat_near last, first; /* last waits for its twin; first is for the seam */
} collector;

static void store(collector *all, const bat_near *near) {
    if (!(near->distance <= all->within)) return;
    size_t at = all->count < all->room ? all->count : all->room;
    all->count++;
    if (at == all->room) {
        if (at == 0 || !(near->distance < all->out[at - 1].distance)) return;
        at--;
    }
    for (; at > 0 && near->distance < all->out[at - 1].distance; at--) all->out[at] = all->out[at - 1];
    all->out[at] = *near;
}

static bool twins(const collector *all, double u0, double u1) {
    return u1 - u0 < 1e-9 * (all->finder->end - all->finder->start);
}

static void collect(collector *all, const span *on, double s) {
    bat_near near;
    near_of(all->finder, on, s, all->point, &near);
    if (all->waiting && near.u >= all->last.u && twins(all, all->last.u, near.u)) {
        if (near.distance < all->last.distance) all->last = near;
        return;
    }
    if (all->waiting) store(all, &all->last);
    if (!all->waiting) all->first = near;
    all->last = near, all->waiting = true;
}

static void flush(collector *all) {
    if (!all->waiting) return;
    /* The same across the seam: the first is stored already, or is the last. */
    const double period = all->finder->end - all->finder->start;
    if (all->finder->closed && all->first.u != all->last.u && twins(all, all->last.u, all->first.u + period))
        return;
    store(all, &all->last);
}

/* Minima on one span, in order. *before: the last sign of the slope seen so far, -1 as if the curve came
 * nearer. */
static void minima_of_span(collector *all, const span *on, int *before, int *opening) {
    const int p = all->finder->degree, m = all->finder->dimension;
    piece stack[DEPTH + 2];
    double local[MOST * BAT_DIMENSION_MAX];
    int top = 0;
    for (int k = 0; k <= p; k++)
        for (int c = 0; c < m; c++) {
            stack[0].q[k * m + c] = on->data[k * m + c] - all->point[c];
            local[k * m + c] = on->data[(p + 1 + k) * m + c] - (k == 0 ? all->point[c] : 0);
        }
    stack[0].s0 = -1, stack[0].s1 = 1, stack[0].depth = 0;
    while (top >= 0) {
        piece *now = stack + top;
        double g[2 * BAT_DEGREE_MAX], greatest = 0, step = 0;
        for (int k = 0; k <= p; k++) {
            double q = 0, d = 0;
            for (int c = 0; c < m; c++) {
                q += fabs(now->q[k * m + c]);
                if (k) d += fabs(now->q[k * m + c] - now->q[(k - 1) * m + c]);
            }
            if (q > greatest) greatest = q;
            if (d > step) step = d;
        }
        slope(p, m, now->q, g);
        /* The differences carry the rounding of the points, hence greatest in both factors. */
        const double zero = 8 * DBL_EPSILON * greatest * (step + DBL_EPSILON * greatest);
        const signs found = signs_of(2 * p, g, zero);
        if (found.count > 1 && now->depth < DEPTH) {
            piece left = *now;
            halve(p, m, &left, now);
            stack[++top] = left;
            continue;
        }
        top--;
        if (!found.first) continue;
        if (!*opening) *opening = found.first;
        if (*before < 0 && found.first > 0) collect(all, on, now->s0);
        if (found.first < 0 && found.final > 0) {
            double squared;
            collect(
                all, on,
                polish(p, m, local, now->s0, now->s1, crossing(2 * p, g, found, now->s0, now->s1), &squared));
        }
        *before = found.final;
    }
}

bat_status bat_curve_nearest_all(const bat_curve *curve, const double *point, double within, size_t room,
                                 bat_near *out, size_t *count) {
    if (!curve || !point || !count || (room > 0 && !out) || !(within >= 0)) return BAT_ARGUMENT;
    if (!finite_point(point, curve->dimension)) return BAT_NUMBER;
    bat_finder *finder;
    const bat_status status = bat_finder_create(curve, &finder);
    if (status != BAT_OK) return status;
    collector all = {.finder = finder, .point = point, .within = within, .room = room, .out = out};
    int before = curve->closed ? 0 : -1, opening = 0;
    for (int i = 0; i < finder->spans; i++) minima_of_span(&all, span_of(finder, i), &before, &opening);
    if (opening == 0) /* the distance is the same everywhere */
        collect(&all, span_of(finder, 0), -1);
    else if (curve->closed ? before < 0 && opening > 0 : before < 0)
        collect(&all, span_of(finder, finder->spans - 1), 1);
    flush(&all);
    *count = all.count;
    bat_finder_free(finder);
    return BAT_OK;
}

/* ---- Local ---- */

double bat_curve_project_near(const bat_curve *curve, const double *point, double u, int steps) {
    const int m = curve->dimension;
    const double start = curve->knots[curve->degree], end = curve->knots[curve->spread];
    double best = INFINITY, best_u = bat_curve_reduce(curve, u);
    int at = -1;
    u = best_u;
    if (isnan(u) || !finite_point(point, m)) return u;
    for (int step = 0;; step++) {
        double d[3 * BAT_DIMENSION_MAX], f = 0, g = 0, speed = 0, bend = 0;
        at = bat_span(curve, u, at);
        bat_curve_eval_span(curve, at, u, 2, d);
        for (int c = 0; c < m; c++) {
            const double r = d[c] - point[c];
            f += r * r, g += r * d[m + c], speed += d[m + c] * d[m + c], bend += r * d[2 * m + c];
        }
        double move;
        if (f <= best) {
            best = f, best_u = u;
            const double h = speed + bend;
            move = -g / (h > 0.25 * speed ? h : speed);
        } else {
            move = 0.5 * (best_u - u); /* too far: back half the way */
        }
        if (step >= steps || !(fabs(move) < end - start) || move == 0) return best_u;
        const double next = bat_curve_reduce(curve, u + move);
        if (next == u || next == best_u) return best_u; /* from there it would go on as it has */
        u = next;
    }
}
