/*
 * The blend between two ends: one Bézier segment. In units in which the ends are 1 apart, speeds and their derivatives at
 * the ends are found by Levenberg's and Marquardt's method: least squares of the derivative of curvature along the
 * length. docs/math/blend.md 2.
 */
#include "base/options.h"
#include "base/real.h"
#include "curve/banded.h"
#include "relate/end.h"
#include <batten/blend.h>
#include <float.h>
#include <stddef.h>
#include <string.h>

enum {
    ORDERS = BAT_CONTINUITY_MAX,
    UNKNOWNS = 2 * ORDERS,
    SAMPLES = 32,
    ROWS = 3 * SAMPLES,
    ROUNDS = 40,
    POINTS = BAT_DEGREE_MAX + 1
};

/* Speeds and their derivatives: s[end][order - 1]. */
typedef struct speeds {
    double s[2][ORDERS];
} speeds;

typedef struct task {
    bat_curve_end end[2]; /* leaving the first, arriving at the second; 1 apart */
    int order[2];
    int degree;
    int first; /* 0: the speeds are free, too; 1: they are given */
} task;

void bat_blend_options_init(bat_blend_options *options, size_t size) {
    const bat_blend_options defaults = {sizeof defaults, {2, 2}, {1, 1}};
    bat_options_give(&defaults, sizeof defaults, size, options);
}

/* The control points: differences at each end are the derivatives there over n, n(n-1), ... */
static void points_of(const task *t, const speeds *x, vec p[POINTS]) {
    for (int e = 0; e < 2; e++) {
        vec d[ORDERS + 1];
        double factor = 1;
        d[0] = t->end[e].at;
        bat_curve_end_derive(&t->end[e], x->s[e], d + 1);
        for (int j = 1; j <= t->order[e]; j++) {
            factor *= (e ? -1.0 : 1.0) / (t->degree - j + 1);
            d[j] = vec_scale(d[j], factor);
        }
        for (int j = 0; j <= t->order[e]; j++) {
            vec *at = p + (e ? t->degree - j : j);
            double choose = 1;
            *at = d[0];
            for (int i = 1; i <= j; i++) {
                choose = choose * (j - i + 1) / i;
                *at = vec_add(*at, vec_scale(d[i], choose));
            }
        }
    }
}

static vec bezier(int degree, const vec *points, double u) {
    vec p[POINTS];
    memcpy(p, points, (size_t)(degree + 1) * sizeof *p);
    for (int k = degree; k > 0; k--)
        for (int i = 0; i < k; i++) p[i] = vec_add(vec_scale(p[i], 1 - u), vec_scale(p[i + 1], u));
    return p[0];
}

/* The root of the variation's integrand at each sample, a vector in the normal plane, and their sum of squares. cusp: whether samples
 * are too few to tell how it turns somewhere. */
static double vary(const task *t, const speeds *x, double rows[ROWS], bool *cusp) {
    vec d[4][POINTS];
    double length = 0, sum = 0;
    points_of(t, x, d[0]);
    for (int k = 1; k < 4; k++)
        for (int i = 0; i <= t->degree - k; i++)
            d[k][i] = vec_scale(vec_sub(d[k - 1][i + 1], d[k - 1][i]), t->degree - k + 1);
    vec before = t->end[0].tangent;
    *cusp = false;
    for (int i = 0; i < SAMPLES; i++) {
        const double angle = BAT_PI * (i + 0.5) / SAMPLES; /* close to each other at the ends */
        vec at[4] = {{0}};
        for (int k = 1; k < 4 && k <= t->degree; k++)
            at[k] = bezier(t->degree - k, d[k], 0.5 - 0.5 * bat_cos(angle));
        const bat_curve_end here = bat_curve_end_of(at[0], at[1], at[2], at[3]);
        const double speed = vec_norm(at[1]) * bat_sin(angle) * (0.5 * BAT_PI / SAMPLES);
        if ((i || t->order[0]) && !(vec_dot(before, here.tangent) > 0)) *cusp = true;
        vec_store(vec_scale(vec_reject(here.rate, here.tangent), sqrt(speed)), rows + 3 * i);
        length += speed;
        before = here.tangent;
    }
    for (int i = 0; i < ROWS; i++) {
        rows[i] *= length * sqrt(length);
        sum += rows[i] * rows[i];
    }
    return isfinite(sum) ? sum : (double)INFINITY;
}

/* The free ones, in order. */
static int unknowns(const task *t, speeds *x, double *out[UNKNOWNS]) {
    int count = 0;
    for (int e = 0; e < 2; e++)
        for (int k = t->first; k < t->order[e]; k++) out[count++] = &x->s[e][k];
    return count;
}

/* The normal equations of the rows linearised by differences: m x = y, for the step downwards. m: as bat_banded_factor wants a
 * matrix whose band is all of it. */
static void linearise(const task *t, const speeds *x, const double rows[ROWS], int count,
                      double m[UNKNOWNS * UNKNOWNS], double y[UNKNOWNS]) {
    double slopes[UNKNOWNS][ROWS];
    for (int i = 0; i < count; i++) {
        speeds near = *x;
        double *at[UNKNOWNS];
        unknowns(t, &near, at);
        const double step = 1e-7 * (1 + fabs(*at[i])), before = *at[i];
        *at[i] += step;
        vary(t, &near, slopes[i], &(bool){false});
        for (int k = 0; k < ROWS; k++) slopes[i][k] = (slopes[i][k] - rows[k]) / (*at[i] - before);
    }
    for (int i = 0; i < count; i++) {
        y[i] = 0;
        for (int k = 0; k < ROWS; k++) y[i] -= slopes[i][k] * rows[k];
        for (int j = 0; j <= i; j++) {
            double *to = m + i * count + i - j;
            *to = 0;
            for (int k = 0; k < ROWS; k++) *to += slopes[i][k] * slopes[j][k];
        }
    }
}

/* A speed at which neither curvature nor its rate throws the control points far. */
static double calm_speed(const bat_curve_end *end) {
    return 1 / (1 + 0.5 * vec_norm(end->bend) + sqrt(vec_norm(end->rate)) / 3);
}

/* Whether speeds are neither so small that rounding would show in the curvature, nor absurd. */
static bool are_sound(const task *t, const speeds *x) {
    for (int e = 0; e < 2; e++)
        if (t->order[e] > 0 && t->first == 0 &&
            !(x->s[e][0] > calm_speed(&t->end[e]) / 16 && x->s[e][0] < 64))
            return false;
    return true;
}

/* Downhill from x; returns the variation there, infinite if there is a cusp. */
static double improve(const task *t, speeds *x) {
    bool cusp, next_cusp;
    double rows[ROWS], best = vary(t, x, rows, &cusp), damping = 1e-3, *at[UNKNOWNS];
    const int count = unknowns(t, x, at);
    for (int round = 0; round < ROUNDS && best > DBL_EPSILON && best < INFINITY && count; round++) {
        double m[UNKNOWNS * UNKNOWNS], y[UNKNOWNS], before = best;
        linearise(t, x, rows, count, m, y);
        for (; damping < 1e12; damping *= 8) {
            double damped[UNKNOWNS * UNKNOWNS], step[UNKNOWNS], tried[ROWS];
            speeds next = *x;
            memcpy(damped, m, (size_t)(count * count) * sizeof *m);
            memcpy(step, y, (size_t)count * sizeof *y);
            for (int i = 0; i < count; i++) damped[i * count] += damping * (1e-6 + m[i * count]);
            if (bat_banded_factor(damped, count, count - 1) != BAT_OK) continue;
            bat_banded_solve(damped, count, count - 1, step, 1);
            unknowns(t, &next, at);
            for (int i = 0; i < count; i++) *at[i] += step[i];
            const double sum = are_sound(t, &next) ? vary(t, &next, tried, &next_cusp) : (double)INFINITY;
            if (!(sum < best)) continue;
            best = sum, *x = next, cusp = next_cusp;
            memcpy(rows, tried, sizeof rows);
            damping /= 16;
            break;
        }
        if (!(best < before * (1 - 1e-7))) break;
    }
    return cusp ? (double)INFINITY : best;
}

/* The part along the tangent of the derivative of that order at an end. */
static double along(const task *t, const speeds *x, int e, int order) {
    vec p[POINTS];
    points_of(t, x, p);
    double factor = 1;
    for (int k = 0; k < order; k++) {
        for (int i = 0; i < t->degree - k; i++) p[i] = vec_sub(p[i + 1], p[i]);
        factor *= t->degree - k;
    }
    return t->degree < order ? 0 : factor * vec_dot(p[e ? t->degree - order : 0], t->end[e].tangent);
}

static speeds start(const task *t, double factor) {
    speeds x = {{{0}}};
    for (int e = 0; e < 2; e++) x.s[e][0] = factor * calm_speed(&t->end[e]);
    return x;
}

static void try_from(const task *t, speeds x, double *least, speeds *best) {
    const double sum = improve(t, &x);
    if (sum < *least) *least = sum, *best = x;
}

/* From several speeds; above G1 from one, and from the best with an order less, whose own derivatives are the next. Infinite: all
 * have cusps. */
static double best_of(const task *t, speeds *best) {
    static const double STARTS[] = {1, 2, 0.5, 4};
    const int top = t->order[0] > t->order[1] ? t->order[0] : t->order[1];
    double least = INFINITY;
    *best = start(t, 1);
    for (int i = 0; i < (top > 1 ? 1 : 4); i++) try_from(t, start(t, STARTS[i]), &least, best);
    if (top < 2) return least;
    task lower = *t;
    speeds x, more;
    lower.degree = 1;
    for (int e = 0; e < 2; e++) lower.degree += lower.order[e] = t->order[e] < top ? t->order[e] : top - 1;
    best_of(&lower, &x);
    more = x;
    for (int e = 0; e < 2; e++)
        if (t->order[e] == top) more.s[e][top - 1] = along(&lower, &x, e, top);
    try_from(t, more, &least, best);
    return least;
}

bat_status bat_blend_options_read(const bat_blend_options *given, bat_blend_options *own) {
    *own = bat_blend_defaults();
    const bat_status status = bat_options_read(given, sizeof *own, sizeof *own, own);
    for (int e = 0; e < 2 && status == BAT_OK; e++)
        if (own->continuity[e] < 0 || own->continuity[e] > BAT_CONTINUITY_MAX ||
            !bat_curve_end_is_tension(own->tension[e]))
            return BAT_ARGUMENT;
    return status;
}

/* Ends moved and scaled so that the first is at the origin and they are 1 apart. */
static void shrink(bat_curve_end *end, vec origin, double scale) {
    end->at = vec_scale(vec_sub(end->at, origin), 1 / scale);
    end->bend = vec_scale(end->bend, scale);
    end->rate = vec_scale(vec_scale(end->rate, scale), scale);
}

static bat_status make(const task *t, const speeds *x, vec origin, double scale, int dimension,
                       bat_curve **out) {
    vec p[POINTS];
    double points[POINTS * BAT_DIMENSION_MAX], knots[2 * POINTS];
    points_of(t, x, p);
    for (int i = 0; i <= t->degree; i++) {
        double at[3];
        vec_store(vec_add(origin, vec_scale(p[i], scale)), at);
        memcpy(points + i * dimension, at, (size_t)dimension * sizeof *at);
        knots[i] = 0, knots[t->degree + 1 + i] = 1;
    }
    return bat_curve_create(dimension, t->degree, false, (size_t)t->degree + 1, points, 2 * t->degree + 2,
                            knots, out);
}

bat_status bat_curve_blend(const bat_curve *a, bool a_end, const bat_curve *b, bool b_end,
                           const bat_blend_options *options, bat_curve **out, double *variation) {
    bat_blend_options o;
    bat_status status = bat_ends_check(a, b);
    if (status == BAT_OK) status = bat_blend_options_read(options, &o);
    if (status == BAT_OK && !out) status = BAT_ARGUMENT;
    if (status != BAT_OK) return status;
    task t = {.end = {bat_curve_end_at(a, a_end, !a_end), bat_curve_end_at(b, b_end, b_end)},
              .order = {o.continuity[0], o.continuity[1]},
              .degree = o.continuity[0] + o.continuity[1] + 1};
    const vec origin = t.end[0].at, last = t.end[1].at;
    const double scale = vec_norm(vec_sub(last, origin));
    for (int e = 0; e < 2; e++) {
        if (!(scale > 0) || t.order[e] > t.end[e].known) return BAT_SINGULAR;
        shrink(&t.end[e], origin, scale);
    }
    speeds x;
    double sum = best_of(&t, &x);
    if (o.tension[0] != 1 || o.tension[1] != 1) {
        for (int e = 0; e < 2; e++) x.s[e][0] *= o.tension[e];
        t.first = 1;
        sum = improve(&t, &x);
    }
    status = make(&t, &x, origin, scale, bat_curve_dimension(a), out);
    if (status == BAT_OK && variation) *variation = sum;
    return status;
}
