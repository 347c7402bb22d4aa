/*
 * A redrawn line put on the knots of the line that it replaces (docs/math/surfaces.md). The sketch hand gives the stretch
 * that changes new knots and a new length in parameters; here it is mapped back onto the old stretch, with the old speed at
 * both ends, and fitted by least squares. Control points whose supports lie outside the stretch keep every bit. Where the
 * old knots cannot meet the tolerance, knots of the redrawn line are added, or else the middles of spans.
 */
#include "form/view/reline.h"
#include "curve/banded.h"
#include "curve/lsq.h"
#include <batten/nearest.h>
#include <batten/refine.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 10, STEPS = 3 };

/* The stretch [from, to] of the old line becomes [start, start + length] of the new one. */
typedef struct stretch {
    const bat_curve *old, *fresh;
    double from, to, start, length;
    double period; /* of the old line; open: 0 */
    bool even;     /* lengths differ too much for the speed to be kept at the ends */
} stretch;

static bat_status stretch_of(const bat_curve *old, const bat_curve *fresh, const bat_sketch_report *report,
                             stretch *out) {
    double domain[2], round[2], at[3];
    bat_curve_domain(old, domain), bat_curve_domain(fresh, round);
    *out = (stretch){.old = old, .fresh = fresh, .from = report->changed[0], .to = report->changed[1]};
    out->start = report->changed_new[0], out->length = report->changed_new[1] - report->changed_new[0];
    if (old->closed) out->period = domain[1] - domain[0];
    if (old->closed && report->replaced) { /* where the redrawn line begins is arbitrary */
        bat_near near;
        out->from = domain[0], out->to = domain[1], out->length = round[1] - round[0];
        bat_curve_eval(old, domain[0], 0, at);
        bat_status status = bat_curve_nearest(fresh, at, &near);
        if (status != BAT_OK) return status;
        out->start = near.u;
    }
    while (old->closed && !(out->to > out->from)) out->to += out->period;
    while (old->closed && !(out->length > 0)) out->length += round[1] - round[0];
    out->even = out->length < 0.6 * (out->to - out->from);
    return BAT_OK;
}

/* The new line's parameter at a share x of the stretch: its slope is the old one's at both ends. */
static double mapped(const stretch *s, double x) {
    const double width = s->to - s->from, blend = x * x * x * (10 + x * (6 * x - 15));
    return s->start + (s->even ? s->length * x : width * x + (s->length - width) * blend);
}

/* Where the new line shall be at the old line's parameter u; returns whether that is in the stretch. */
static bool target(const stretch *s, double u, double out[3]) {
    const double lap = s->period > 0 ? s->period * floor((u - s->from) / s->period) : 0;
    const bool inside = u - lap >= s->from && u - lap <= s->to;
    if (inside)
        bat_curve_eval(s->fresh, mapped(s, (u - lap - s->from) / (s->to - s->from)), 0, out);
    else
        bat_curve_eval(s->old, u, 0, out);
    return inside;
}

/* ---- the fit on one set of knots ---- */

typedef struct fit {
    const bat_curve *base; /* the old line on these knots */
    int slots, each;       /* samples in each slot that is not empty */
    size_t count;
    size_t *first;             /* of each slot, and the count; as bat_lsq_ranges */
    double *block;             /* holds all that follow */
    double *u, *x, *gap, *far; /* samples: parameter, target, target minus base, squared distance */
    double *near;              /* where samples are projected to */
    double *a, *border, *move, *points, *local;
    bool *is_free; /* control points that may move */
} fit;

static bat_status fit_begin(const bat_curve *base, fit *out) {
    const size_t p = (size_t)base->degree, n = (size_t)base->count;
    *out = (fit){.base = base, .slots = bat_lsq_slots(base), .each = 2 * (base->degree + 1)};
    const size_t most = (size_t)out->slots * (size_t)out->each;
    const size_t sizes[10] = {most,
                              most,
                              3 * most,
                              3 * most,
                              most,
                              n * (p + 1),
                              bat_cyclic_room((int)n, (int)p),
                              3 * n,
                              3 * n,
                              (size_t)out->slots * (p + 1) * 3};
    double **const parts[10] = {&out->u, &out->near,   &out->x,    &out->gap,    &out->far,
                                &out->a, &out->border, &out->move, &out->points, &out->local};
    size_t whole = 0;
    for (int i = 0; i < 10; i++) whole += sizes[i];
    out->block = calloc(whole, sizeof *out->block);
    out->is_free = calloc(n, sizeof *out->is_free);
    out->first = calloc((size_t)out->slots + 1, sizeof *out->first);
    if (!out->block || !out->is_free || !out->first) return BAT_MEMORY;
    double *next = out->block;
    for (int i = 0; i < 10; i++) *parts[i] = next, next += sizes[i];
    return BAT_OK;
}

static void fit_sample(fit *f, const stretch *s) {
    const int p = f->base->degree;
    for (int k = 0; k < f->slots; k++) {
        const double a = f->base->knots[p + k], b = f->base->knots[p + k + 1];
        f->first[k + 1] = f->count;
        if (!(a < b)) continue;
        bool inside = false;
        for (int i = 0; i < f->each; i++, f->count++) {
            double at[3], *x = f->x + 3 * f->count;
            f->u[f->count] = a + (b - a) * (i + 0.5) / f->each;
            inside |= target(s, f->u[f->count], x);
            bat_curve_eval(f->base, f->u[f->count], 0, at);
            for (int c = 0; c < 3; c++) f->gap[3 * f->count + (size_t)c] = x[c] - at[c];
        }
        f->first[k + 1] = f->count;
        for (int i = 0; inside && i <= p; i++) f->is_free[bat_lsq_unknown(f->base, k + i)] = true;
    }
}

/* Clamped ends that the stroke did not move stay. */
static void fit_hold_ends(fit *f, const bat_sketch_report *report) {
    const bat_curve *b = f->base;
    const int p = b->degree, last = b->count - 1;
    if (b->closed || report->replaced) return;
    if (!report->extended[0] && b->knots[0] == b->knots[p]) f->is_free[0] = false;
    if (!report->extended[1] && b->knots[b->spread] == b->knots[b->spread + p]) f->is_free[last] = false;
}

static bat_status fit_solve(fit *f) {
    const bat_curve *b = f->base;
    const int p = b->degree, n = b->count;
    bat_lsq_assemble(b, 3, f->count, f->u, f->gap, NULL, f->a, f->move);
    for (int i = 0; i < n; i++) {
        double *row = f->a + i * (p + 1);
        for (int d = 0; d <= p; d++) {
            const int j = b->closed ? ((i - d) % n + n) % n : i - d;
            if (j >= 0 && (!f->is_free[i] || !f->is_free[j])) row[d] = 0;
        }
        if (f->is_free[i]) continue;
        row[0] = 1;
        memset(f->move + 3 * i, 0, 3 * sizeof *f->move);
    }
    bat_status status = b->closed ? bat_cyclic_factor(f->a, n, p, f->border) : bat_banded_factor(f->a, n, p);
    if (status != BAT_OK) return status;
    if (b->closed)
        bat_cyclic_solve(f->a, n, p, f->border, f->move, 3);
    else
        bat_banded_solve(f->a, n, p, f->move, 3);
    for (int i = 0; i < n; i++)
        for (int c = 0; c < 3; c++) {
            const double old = bat_curve_points(b)[3 * i + c];
            f->points[3 * i + c] = f->is_free[i] ? old + f->move[3 * i + c] : old;
        }
    return BAT_OK;
}

/* ---- more knots ---- */

/* The share of the stretch at which the new line's parameter is w; it rises with x. */
static double share_at(const stretch *s, double w) {
    double low = 0, high = 1;
    for (int i = 0; i < 60; i++) {
        const double x = 0.5 * (low + high);
        *(mapped(s, x) < w ? &low : &high) = x;
    }
    return 0.5 * (low + high);
}

/* Knots for the slot [a, b]: those of the redrawn line well inside it, or else its middle. Ascending. */
static int knots_in(const stretch *s, double a, double b, int room, double *out) {
    double round[2];
    int count = 0;
    bat_curve_domain(s->fresh, round);
    const double *t = s->fresh->knots;
    for (int lap = 0; lap < (s->period > 0 ? 3 : 1); lap++)
        for (int i = s->fresh->degree; i < s->fresh->spread && count < room; i++) {
            const double w = t[i] + (s->period > 0 ? (lap - 1) * (round[1] - round[0]) : 0);
            if (!(t[i] < t[i + 1]) || w <= s->start || w >= s->start + s->length) continue;
            double u = s->from + share_at(s, w) * (s->to - s->from);
            if (s->period > 0) u -= s->period * floor((u - a) / s->period);
            if (u > a + 0.2 * (b - a) && u < b - 0.2 * (b - a) &&
                (count == 0 || u > out[count - 1] + 0.1 * (b - a)))
                out[count++] = u;
        }
    if (count == 0) out[count++] = 0.5 * (a + b);
    return count;
}

/* Refines the base where samples are further than the limit (squared) from the fit; NULL: nowhere. */
static bat_status refined(const fit *f, const stretch *s, double limit, bat_curve **out) {
    const int p = f->base->degree, room = 4 * f->slots;
    double *knots = malloc((size_t)room * sizeof *knots);
    int count = 0;
    size_t sample = 0;
    if (!knots) return BAT_MEMORY;
    for (int k = 0; k < f->slots; k++) {
        const double a = f->base->knots[p + k], b = f->base->knots[p + k + 1];
        double most = 0;
        if (!(a < b)) continue;
        for (int i = 0; i < f->each; i++) most = fmax(most, f->far[sample++]);
        if (most > limit) count += knots_in(s, a, b, 4, knots + count);
    }
    bat_status status = count > 0 ? bat_curve_insert_knots(f->base, count, knots, out) : BAT_OK;
    free(knots);
    return status;
}

static void fit_end(fit *f) { free(f->block), free(f->is_free), free(f->first); }

/* The fit on the knots of base, in f, which fit_end frees also after a failure. */
static bat_status fit_on(const bat_curve *base, const stretch *s, const bat_sketch_report *report, fit *f) {
    bat_status status = fit_begin(base, f);
    if (status != BAT_OK) return status;
    fit_sample(f, s);
    fit_hold_ends(f, report);
    status = fit_solve(f);
    if (status == BAT_OK) bat_lsq_local(base, 3, f->points, f->local);
    return status;
}

/* One fit; *out: the line, and *finer (finer may be NULL): a base with more knots where it fails, or NULL. */
static bat_status one_round(const bat_curve *base, const stretch *s, const bat_sketch_report *report,
                            double tolerance, bat_curve **out, bat_curve **finer, double *error) {
    fit f;
    bat_status status = fit_on(base, s, report, &f);
    if (status == BAT_OK) {
        const double most = bat_lsq_error(base, 3, f.local, f.count, f.u, f.x, STEPS, NULL, f.far);
        *error = sqrt(most);
        status = bat_curve_create(3, base->degree, base->closed, bat_curve_count(base), f.points,
                                  bat_curve_knot_count(base), bat_curve_knots(base), out);
        if (status == BAT_OK && finer && most > tolerance * tolerance) {
            status = refined(&f, s, tolerance * tolerance, finer);
            if (status != BAT_OK) bat_curve_free(*out), *out = NULL;
        }
    }
    fit_end(&f);
    return status;
}

/* ---- fewer knots ---- */

static bool is_inside(const stretch *s, double u) {
    const double lap = s->period > 0 ? s->period * floor((u - s->from) / s->period) : 0;
    return u - lap > s->from && u - lap < s->to;
}

/* Tries the fit without one copy of the knot u; replaces the base when it is as good as it must be. */
static bat_status try_without(double u, const stretch *s, const bat_sketch_report *report, double tolerance,
                              bat_curve **base) {
    bat_curve *fewer = NULL;
    int removed = 0;
    bat_status status = bat_curve_remove_knot(*base, u, 1, BAT_COORDINATE_MAX, &fewer, &removed, NULL);
    if (status == BAT_OK && removed > 0) {
        fit f;
        const double limit = tolerance * tolerance;
        status = fit_on(fewer, s, report, &f);
        if (status == BAT_OK &&
            bat_lsq_measure(fewer, 3, f.local, f.first, f.u, f.x, limit, f.near, f.far, f.gap) <= limit) {
            bat_curve *other = *base;
            *base = fewer, fewer = other;
        }
        fit_end(&f);
    }
    bat_curve_free(fewer);
    return status == BAT_MEMORY ? status : BAT_OK;
}

/* Knots within the stretch go when the line meets the tolerance without them, also those of the old line. */
static bat_status thin(const stretch *s, const bat_sketch_report *report, double tolerance,
                       bat_curve **base) {
    bat_status status = BAT_OK;
    double domain[2];
    bat_curve_domain(*base, domain);
    for (int k = bat_curve_knot_count(*base) - 1; k > 0 && status == BAT_OK; k--) {
        if (k >= bat_curve_knot_count(*base)) continue;
        const double u = bat_curve_knots(*base)[k];
        if (u > domain[0] && u < domain[1] && is_inside(s, u))
            status = try_without(u, s, report, tolerance, base);
    }
    return status;
}

bat_status bat_reline(const bat_curve *old, const bat_curve *redrawn, const bat_sketch_report *report,
                      double tolerance, bat_curve **out, double *error) {
    stretch s;
    bat_curve *base = NULL, *line = NULL;
    bat_status status = stretch_of(old, redrawn, report, &s);
    if (status == BAT_OK) status = bat_curve_copy(old, &base);
    for (int i = 0; status == BAT_OK; i++) {
        bat_curve *finer = NULL;
        bat_curve_free(line);
        line = NULL;
        status = one_round(base, &s, report, tolerance, &line, i < ROUNDS ? &finer : NULL, error);
        if (status != BAT_OK || !finer) break;
        bat_curve_free(base);
        base = finer;
    }
    if (status == BAT_OK && *error <= tolerance) {
        const int knots = bat_curve_knot_count(base);
        status = thin(&s, report, tolerance, &base);
        if (status == BAT_OK && bat_curve_knot_count(base) < knots) {
            bat_curve_free(line);
            line = NULL;
            status = one_round(base, &s, report, tolerance, &line, NULL, error);
        }
    }
    bat_curve_free(base);
    if (status == BAT_OK)
        *out = line;
    else
        bat_curve_free(line);
    return status;
}
