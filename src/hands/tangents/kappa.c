/*
 * The kappa-curve of points: quadratic pieces whose curvature is greatest at the points, and equal on both sides of
 * every joint. Source: Yan, Schiller, Wilensky, Carr, Schaefer, kappa-Curves, 2017, Eqs. 5 to 8; how the equations are
 * solved is ours (math 1.5).
 *
 * Unknown are the parameter t of each point on its piece, and the share of each joint. When they are known, the middle
 * points solve a linear system; from the pieces that it gives follow other parameters and shares. Of this map we want
 * the fixed point: Anderson's mixing over the last few steps, in logits, so that nothing leaves (0, 1).
 */
#include "hands/tangents/kappa.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH = 8, PLAIN = 10, STEPS_MAX = 4000, STEPS_MIN = 40, STALE = 30 };
static const int WORK = 4000000;    /* points times steps */
static const double CLOSE = 1e-12;  /* of parameters and shares */
static const double T_LEAST = 1e-3; /* a point keeps so far from the ends of its piece, in its parameter */
static const double SHARE_LEAST = 1e-5; /* so that spans are comparable */
static const double STRIDE = 2;         /* the longest step, in logits */

/* Of the linear system: coefficients of the middle points before, of and after a piece, and of the last one. */
typedef struct row {
    double lower, middle, upper, border;
    vec right;
} row;

typedef struct solver {
    int n, count, depth; /* points, pieces, steps that are remembered */
    bool closed;
    double damp;       /* of plain steps: 1, or less once mixing has led nowhere */
    const vec *points; /* scaled to about 1 */
    bat_kappa_piece *pieces;
    row *rows;
    double *x, *f; /* logits of parameters and shares; by how much the map changes them */
    double *old_x, *old_f, *best;
    double *dx[DEPTH], *df[DEPTH]; /* latest first */
} solver;

static double logit(double p) { return bat_log(p / (1 - p)); }
static double share_of(double z) { return 1 / (1 + bat_exp(-z)); }
static double between(double v, double least) { return fmin(fmax(v, least), 1 - least); }
static vec mix(vec a, vec b, double t) { return vec_add(vec_scale(a, 1 - t), vec_scale(b, t)); }

/* The point that piece i passes through. */
static vec target(const solver *s, int i) {
    if (s->closed) return s->points[i];
    return s->n > 2 ? s->points[i + 1] : mix(s->points[0], s->points[1], 0.5);
}

/* Where the curvature of a quadratic through p is greatest: the one root in [0, 1] of Eq. 6. */
static double sharpest(vec start, vec p, vec end) {
    vec e = vec_sub(end, start), f = vec_sub(start, p);
    double a = vec_dot(e, e), b = 3 * vec_dot(e, f);
    double c = vec_dot(vec_sub(vec_sub(vec_scale(start, 3), vec_scale(p, 2)), end), f), d = -vec_dot(f, f);
    double low = 0, high = 1, t = 0.5;
    for (int i = 0; i < 80; i++) {
        double value = ((a * t + b) * t + c) * t + d, slope = (3 * a * t + 2 * b) * t + c;
        if (value > 0)
            high = t;
        else
            low = t;
        double next = slope != 0 ? t - value / slope : low;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (fabs(next - t) <= 1e-16) break;
        t = next;
    }
    return t;
}

static double area(vec a, vec b, vec c) { return vec_norm(vec_cross(vec_sub(b, a), vec_sub(c, a))); }

/* The joints between the middle points. */
static void join(solver *s) {
    bat_kappa_piece *p = s->pieces;
    int joints = s->closed ? s->count : s->count - 1;
    if (!s->closed) p[0].start = s->points[0], p[s->count - 1].end = s->points[s->n - 1];
    for (int i = 0; i < joints; i++) {
        bat_kappa_piece *next = &p[(i + 1) % s->count];
        p[i].end = next->start = mix(p[i].middle, next->middle, p[i].share);
    }
}

/* The row of piece i in the linear system: its point as a mean of middle points. */
static void fill_row(solver *s, int i) {
    const bat_kappa_piece *p = s->pieces;
    const int last = s->count - 1;
    const bool first = !s->closed && i == 0, final = !s->closed && i == last;
    const double t = p[i].t, from = (1 - t) * (1 - t), to = t * t;
    const double before = first ? 0 : p[(i + last) % s->count].share, after = final ? 1 : p[i].share;
    row *r = &s->rows[i];
    *r = (row){first ? 0 : from * (1 - before), 2 * t * (1 - t) + from * before + to * (1 - after),
               final ? 0 : to * after, 0, target(s, i)};
    if (first) r->right = vec_sub(r->right, vec_scale(s->points[0], from));
    if (final) r->right = vec_sub(r->right, vec_scale(s->points[s->n - 1], to));
}

/* Middle points such that every piece passes through its point. The rows are tridiagonal, their pivots at least
 * 2 t (1 - t); when the curve is closed, the last middle point stands apart, in a column of its own. */
static void pass_through(solver *s) {
    row *r = s->rows;
    const int last = s->count - 1, n = s->closed ? last : s->count;
    for (int i = 0; i <= last; i++) fill_row(s, i);
    if (s->closed) r[0].border = r[0].lower, r[n - 1].border += r[n - 1].upper;
    for (int i = 1; i < n; i++) {
        const double w = r[i].lower / r[i - 1].middle;
        r[i].middle -= w * r[i - 1].upper;
        r[i].border -= w * r[i - 1].border;
        r[i].right = vec_sub(r[i].right, vec_scale(r[i - 1].right, w));
    }
    for (int i = n - 1; i >= 0; i--) {
        if (i < n - 1) {
            r[i].border -= r[i].upper * r[i + 1].border;
            r[i].right = vec_sub(r[i].right, vec_scale(r[i + 1].right, r[i].upper));
        }
        r[i].border /= r[i].middle;
        r[i].right = vec_scale(r[i].right, 1 / r[i].middle);
    }
    if (s->closed) {
        const row *a = &r[last], *b = &r[n - 1];
        const double pivot = a->middle - a->lower * b->border - a->upper * r[0].border;
        const vec rest = vec_sub(a->right,
                                 vec_add(vec_scale(b->right, a->lower), vec_scale(r[0].right, a->upper)));
        const double least = 1e-9; /* an even number of points in wild disorder: never met so far */
        s->pieces[last].middle = vec_scale(rest, 1 / (fabs(pivot) > least ? pivot
                                                      : pivot < 0         ? -least
                                                                          : least));
    }
    for (int i = 0; i < n; i++)
        s->pieces[i].middle = s->closed ? vec_sub(r[i].right, vec_scale(s->pieces[last].middle, r[i].border))
                                        : r[i].right;
}

/* The pieces for the logits x. */
static void make_pieces(solver *s, const double *x) {
    for (int i = 0; i < s->count; i++)
        s->pieces[i].share = share_of(x[i]), s->pieces[i].t = share_of(x[s->count + i]);
    pass_through(s);
    join(s);
}

/* Eq. 8: the share of joint i with which curvature is equal on both sides of it. */
static double even_share(const solver *s, int i) {
    const bat_kappa_piece *a = &s->pieces[i], *b = &s->pieces[(i + 1) % s->count];
    const double before = sqrt(area(a->start, a->middle, b->middle)),
                 after = sqrt(area(a->middle, b->middle, b->end));
    return before + after > 0 ? before / (before + after) : 0.5;
}

/* s->f: by how much the map changes s->x. Returns by how much it changes parameters and shares at most. */
static double change(solver *s) {
    const int n = s->count, joints = s->closed ? n : n - 1;
    double most = 0;
    for (int i = 0; i < n; i++) {
        const bat_kappa_piece *p = &s->pieces[i];
        const double t = between(sharpest(p->start, target(s, i), p->end), T_LEAST);
        const double share = i < joints ? between(even_share(s, i), SHARE_LEAST) : p->share;
        most = fmax(most, fmax(fabs(t - p->t), fabs(share - p->share)));
        s->f[i] = i < joints ? logit(share) - s->x[i] : 0;
        s->f[n + i] = logit(t) - s->x[n + i];
    }
    return most;
}

static double product(const double *a, const double *b, int n) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

/* Anderson's weights of the last steps: those that leave the least of the change. False: they are no help. */
static bool weigh(const solver *s, int steps, double *weights) {
    double m[DEPTH][DEPTH + 1];
    const int n = 2 * s->count;
    for (int a = 0; a < steps; a++) {
        for (int b = 0; b < steps; b++) m[a][b] = product(s->df[a], s->df[b], n);
        m[a][a] *= 1 + 1e-12;
        m[a][steps] = product(s->df[a], s->f, n);
    }
    for (int a = 0; a < steps; a++) { /* positive definite up to rounding: no rows are exchanged */
        if (!(m[a][a] > 0)) return false;
        for (int b = a + 1; b < steps; b++) {
            const double w = m[b][a] / m[a][a];
            for (int k = a; k <= steps; k++) m[b][k] -= w * m[a][k];
        }
    }
    for (int a = steps - 1; a >= 0; a--) {
        double sum = m[a][steps];
        for (int k = a + 1; k < steps; k++) sum -= m[a][k] * weights[k];
        weights[a] = sum / m[a][a];
        if (!isfinite(weights[a])) return false;
    }
    return true;
}

/* Keeps what the last step has changed; the oldest is forgotten. */
static void remember(solver *s, int n) {
    double *x = s->dx[s->depth - 1], *f = s->df[s->depth - 1];
    for (int k = s->depth - 1; k > 0; k--) s->dx[k] = s->dx[k - 1], s->df[k] = s->df[k - 1];
    s->dx[0] = x, s->df[0] = f;
    for (int i = 0; i < n; i++) x[i] = s->x[i] - s->old_x[i], f[i] = s->f[i] - s->old_f[i];
}

static void step(solver *s, int steps) {
    const int n = 2 * s->count;
    const double most[] = {logit(1 - SHARE_LEAST), logit(1 - T_LEAST)};
    double weights[DEPTH], longest = 0;
    if (steps > 0 && !weigh(s, steps, weights)) steps = 0;
    memcpy(s->old_x, s->x, (size_t)n * sizeof(double));
    memcpy(s->old_f, s->f, (size_t)n * sizeof(double));
    for (int i = 0; i < n; i++) { /* s->x: the step */
        s->x[i] = steps > 0 ? s->f[i] : s->damp * s->f[i];
        for (int k = 0; k < steps; k++) s->x[i] -= weights[k] * (s->dx[k][i] + s->df[k][i]);
        longest = fmax(longest, fabs(s->x[i]));
    }
    const double part = longest > STRIDE ? STRIDE / longest : 1;
    for (int i = 0; i < n; i++) {
        const double limit = most[i >= s->count];
        s->x[i] = fmin(fmax(s->old_x[i] + part * s->x[i], -limit), limit);
    }
}

static void iterate(solver *s) {
    const int n = 2 * s->count;
    const int limit = WORK / s->count < STEPS_MIN   ? STEPS_MIN
                      : WORK / s->count > STEPS_MAX ? STEPS_MAX
                                                    : WORK / s->count;
    int known = 0, plain = PLAIN, since = 0;
    double least = INFINITY, record = INFINITY;
    for (int k = 0; k < limit; k++) {
        make_pieces(s, s->x);
        const double changed = change(s);
        if (changed < least) {
            least = changed;
            memcpy(s->best, s->x, (size_t)n * sizeof(double));
        }
        if (changed <= CLOSE) break;
        if (changed < record)
            record = changed, since = k;
        else if (k - since > STALE) /* mixing leads nowhere: begins anew with plain steps */
            known = 0, record = changed, since = k, plain = k + PLAIN * (2 + (k / STALE) % 5), s->damp = 0.5;
        if (k > 0) {
            remember(s, n);
            if (known < s->depth) known++;
        }
        step(s, k >= plain ? known : 0);
    }
    make_pieces(s, s->best);
}

/* The first guess: middle points are the points themselves. */
static void begin(solver *s) {
    for (int i = 0; i < s->count; i++) s->pieces[i].middle = target(s, i), s->pieces[i].share = 0.5;
    join(s);
    for (int i = 0; i < s->count; i++) {
        const bat_kappa_piece *p = &s->pieces[i];
        s->x[i] = 0;
        s->x[s->count + i] = logit(between(sharpest(p->start, p->middle, p->end), T_LEAST));
    }
}

/* Points from their first, over a power of two of their extent, so that no product overflows or vanishes. */
static void scale_points(int n, const vec *points, vec *out, int *exponent) {
    double size = 0;
    *exponent = 0;
    for (int i = 0; i < n; i++) {
        out[i] = vec_sub(points[i], points[0]);
        size = fmax(size, fmax(fmax(fabs(out[i].x), fabs(out[i].y)), fabs(out[i].z)));
    }
    frexp(size, exponent);
    for (int i = 0; i < n; i++)
        out[i] = (vec){ldexp(out[i].x, -*exponent), ldexp(out[i].y, -*exponent), ldexp(out[i].z, -*exponent)};
}

static vec back(vec v, vec first, int exponent) {
    return vec_add(first, (vec){ldexp(v.x, exponent), ldexp(v.y, exponent), ldexp(v.z, exponent)});
}

bat_status bat_kappa(int n, bool closed, const vec *points, bat_kappa_piece *pieces) {
    const size_t count = (size_t)bat_kappa_count(n, closed), size = 2 * count;
    solver s = {.n = n,
                .count = (int)count,
                .depth = n > 100000 ? 2 : DEPTH,
                .damp = 1,
                .closed = closed,
                .pieces = pieces};
    vec *scaled = malloc(((size_t)n + 1) * sizeof *scaled);
    double *block = malloc((5 + 2 * (size_t)s.depth) * size * sizeof *block);
    s.rows = malloc(count * sizeof *s.rows);
    bat_status status = scaled && block && s.rows ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        int exponent;
        scale_points(n, points, scaled, &exponent);
        s.points = scaled;
        s.x = block, s.f = block + size, s.old_x = block + 2 * size, s.old_f = block + 3 * size;
        s.best = block + 4 * size;
        for (int k = 0; k < s.depth; k++) {
            s.dx[k] = block + (5 + 2 * (size_t)k) * size;
            s.df[k] = s.dx[k] + size;
        }
        begin(&s);
        iterate(&s);
        for (size_t i = 0; i < count; i++) {
            pieces[i].start = back(pieces[i].start, points[0], exponent);
            pieces[i].middle = back(pieces[i].middle, points[0], exponent);
            pieces[i].end = back(pieces[i].end, points[0], exponent);
        }
        if (!closed) pieces[0].start = points[0], pieces[count - 1].end = points[n - 1];
    }
    free(scaled);
    free(block);
    free(s.rows);
    return status;
}
