/* From a plan to the fit's problem, and from the fit back into the curve (docs/math sketch 5.6). Kept control
 * points are copied; those that reach into the new interval are blossoms of the kept piece. */
#include "hands/sketch/plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Stored span of the kept piece next to a cut, and the cut reduced into the domain; open curves: the same. */
static int kept_span(const bat_curve *curve, int side, double cut, double *reduced) {
    const double *t = curve->knots;
    *reduced = side == 0 ? bat_curve_reduce_left(curve, cut) : bat_curve_reduce(curve, cut);
    int span = bat_span(curve, *reduced, -1);
    if (curve->closed) { /* a cut at a knot must stay at it when a period is taken off */
        const double slack = 1e-13 * (fabs(cut) + fabs(*reduced) + t[curve->spread] - t[curve->degree]);
        if (*reduced - t[span] <= slack)
            *reduced = t[span];
        else if (t[span + 1] - *reduced <= slack)
            *reduced = t[span + 1];
        *reduced = side == 0 ? bat_curve_reduce_left(curve, *reduced) : bat_curve_reduce(curve, *reduced);
        span = bat_span(curve, *reduced, -1);
    }
    return side == 0 ? bat_span_left(curve, *reduced, -1) : span;
}

/* Knots kept of a closed curve: strictly inside (cut of end 1, cut of end 0 + period), ascending and unrolled
 * from cut 1 on; *first is the stored index of the first. Returns how many. */
static int kept_closed(const bat_plan *plan, const bat_curve *curve, double *knots, int room) {
    const int p = curve->degree, n = curve->count;
    const double period = curve->knots[curve->spread] - curve->knots[p];
    const double from = plan->end[1].cut, to = plan->end[0].cut + period;
    double reduced;
    const int span = kept_span(curve, 1, from, &reduced);
    int count = 0;
    for (int j = span + 1; count < room; j++) {
        const int turns = (j - p) / n;
        const double knot = curve->knots[j - turns * n] + turns * period + (from - reduced);
        if (!(knot < to - 1e-12 * period)) break;
        knots[count++] = knot;
    }
    return count;
}

void bat_plan_problem(const bat_plan *plan, bat_local_problem *q) {
    const bat_target *t = &plan->target;
    const int p = plan->degree;
    memset(q, 0, sizeof *q);
    q->degree = p, q->dimension = plan->dimension, q->closed = plan->periodic;
    q->end = t->end, q->count = t->count;
    q->w = t->w, q->x = t->x, q->weight = t->weight, q->allowed = t->allowed, q->law = t->law;
    q->first = t->first, q->last = t->last;
    q->fixed_count = plan->fixed_count, q->fixed = plan->fixed;
    q->span = fmax(8 * plan->tolerance, 2);
    q->wavelength = 18;
    q->remove = true;
    if (plan->periodic) return;
    for (int side = 0; side < 2; side++) {
        const bat_end *e = &plan->end[side];
        bat_local_side *s = &q->side[side];
        const double at = side == 0 ? 0 : t->end;
        for (int i = 0; i < p; i++) s->outer[i] = at;
        if (e->kind ==
            BAT_END_FREE) { /* the curve ends where the stroke does, neither short of it nor beyond */
            const size_t m = (size_t)plan->dimension;
            s->pins = 1;
            memcpy(s->point, t->x + (side == 0 ? 0 : (t->count - 1) * m), m * sizeof *s->point);
            continue;
        }
        if (e->kind == BAT_END_POINT) {
            s->pins = 1;
            bat_curve_eval(e->curve, e->cut, 0, s->point);
            continue;
        }
        s->pins = plan->pins;
        s->curve = e->curve;
        s->span = kept_span(e->curve, side, e->cut, &s->base);
        s->rate = t->rate, s->at = at;
        const double *knots = e->curve->knots;
        if (!plan->closed) {
            for (int i = 1; i < p; i++) {
                if (side == 0)
                    s->outer[p - 1 - i] = (knots[s->span + 1 - i] - s->base) * t->rate;
                else
                    s->outer[i] = at + (knots[s->span + i] - s->base) * t->rate;
            }
            continue;
        }
        /* Closed: the outer knots are those of the kept arc, and beyond it the other cut. */
        double kept[2 * BAT_DEGREE_MAX];
        if (side == 1) {
            const int count = kept_closed(plan, e->curve, kept, p - 1);
            const double far = plan->end[0].cut + e->track->end - e->track->start;
            for (int i = 1; i < p; i++)
                s->outer[i] = at + ((i <= count ? kept[i - 1] : far) - e->cut) * t->rate;
        } else {
            const double period = e->track->end - e->track->start;
            const double *stored = knots;
            int index = s->span, filled = 0;
            for (; filled < p - 1; filled++, index--) {
                const int n = e->curve->count;
                int j = index, turns = 0;
                while (j < 0) j += n, turns--;
                const double knot = stored[j] + turns * period + (e->cut - s->base);
                if (knot <= plan->end[1].cut - period + 1e-12 * period) break;
                s->outer[p - 2 - filled] = (knot - e->cut) * t->rate;
            }
            for (; filled < p - 1; filled++)
                s->outer[p - 2 - filled] = (plan->end[1].cut - period - e->cut) * t->rate;
        }
    }
}

/* Pins in document units from the original curve at exactly the new knots. knots: local vector in the new
 * curve's parameters, `shift` already taken off for end 1. */
static void exact_pins(const bat_end *e, int side, int pins, int p, int interior, const double *knots,
                       double *points) {
    const size_t m = (size_t)e->original->dimension;
    const int from = side == 0 ? 0 : interior + p + 1 - pins;
    if (e->kind == BAT_END_POINT) {
        double *target = points + (side == 0 ? 0 : (size_t)(interior + p) * m);
        if (side == 0)
            bat_curve_eval(e->original, e->cut, 0, target);
        else
            bat_curve_eval_left(e->original, e->cut, 0, target);
        return;
    }
    double reduced;
    const int span = kept_span(e->original, side, e->cut, &reduced);
    const double move = reduced - e->cut;
    for (int i = 0; i < pins; i++) {
        double arguments[BAT_DEGREE_MAX];
        for (int j = 0; j < p; j++) arguments[j] = knots[from + i + 1 + j] + move;
        bat_curve_blossom_span(e->original, span, arguments, points + (size_t)(from + i) * m);
    }
}

static bat_status splice_open(const bat_plan *plan, const bat_local_problem *q, const bat_local_result *fit,
                              const double *origin, double pixel, bat_curve **out, double changed_new[2]) {
    const int p = plan->degree, r = fit->interior, local = r + p + 1;
    const size_t m = (size_t)plan->dimension;
    const bat_end *a = &plan->end[0], *b = &plan->end[1];
    double reduced;
    /* Kept on the left: knots[0..left - 1] lie before the cut, `copied` control points do not reach it. */
    int left = 0, cut_times = p + 1, copied = 0;
    if (a->kind == BAT_END_KEPT) {
        left = kept_span(a->original, 0, a->cut, &reduced) + 1;
        cut_times = 1, copied = left - p;
    } else if (a->kind == BAT_END_POINT && a->corner) {
        left = kept_span(a->original, 0, a->cut, &reduced) + 1;
        cut_times = p, copied = left - 1;
    }
    int right = 0, right_times = p + 1, from = 0, right_copied = 0; /* knots[from..] lie after the cut */
    if (b->kind == BAT_END_KEPT || (b->kind == BAT_END_POINT && b->corner)) {
        from = kept_span(b->original, 1, b->cut, &reduced) + 1;
        right = b->original->spread + p + 1 - from;
        right_times = b->kind == BAT_END_KEPT ? 1 : p;
        /* Kept: the point whose support begins at the cut; corner: the one after the corner's own. */
        right_copied = b->original->spread - (from - 1);
        if (b->kind == BAT_END_POINT) right_copied = b->original->spread - (from - p);
    }
    const int count = copied + local + right_copied;
    bat_curve *curve;
    bat_status status = bat_curve_allocate(p, plan->dimension, false, count, &curve);
    if (status != BAT_OK) return status;
    double *t = curve->knots, *points = curve->points;
    double start = a->kind != BAT_END_FREE || left > 0 ? a->cut : 0, end;
    if (a->kind == BAT_END_FREE) {
        if (b->kind != BAT_END_FREE)
            start = b->cut - q->end / plan->target.rate;
        else
            start = a->original ? a->original->knots[p] : 0;
    }
    end = start + q->end / plan->target.rate;
    if (a->kind == BAT_END_FREE && b->kind != BAT_END_FREE)
        end = b->cut; /* what is kept keeps its parameters */
    const double shift = b->kind == BAT_END_FREE ? 0 : end - b->cut;
    int n = 0;
    for (int i = 0; i < left; i++) t[n++] = a->original->knots[i];
    for (int i = 0; i < cut_times; i++) t[n++] = start;
    for (int i = 0; i < r; i++) t[n++] = fmin(fmax(start + fit->knots[i] / plan->target.rate, start), end);
    for (int i = 0; i < right_times; i++) t[n++] = end;
    for (int i = 0; i < right; i++) t[n++] = b->original->knots[from + i] + shift;
    if (copied > 0) memcpy(points, a->original->points, (size_t)copied * m * sizeof *points);
    double *middle = points + (size_t)copied * m;
    for (size_t i = 0; i < (size_t)local; i++)
        for (size_t c = 0; c < m; c++) middle[i * m + c] = origin[c] + pixel * fit->points[i * m + c];
    double *knots = malloc((size_t)(r + 2 * p + 2) * sizeof *knots);
    if (!knots) status = BAT_MEMORY;
    for (int side = 0; side < 2 && status == BAT_OK; side++) {
        if (plan->end[side].kind == BAT_END_FREE) continue;
        memcpy(knots, t + copied, (size_t)(r + 2 * p + 2) * sizeof *knots);
        if (side == 1) /* kept knots exactly, new ones shifted back */
            for (int i = 0; i < r + 2 * p + 2; i++) {
                const int index = copied + i - (n - right);
                knots[i] = index >= 0              ? b->original->knots[from + index]
                           : index >= -right_times ? b->cut
                                                   : knots[i] - shift;
            }
        exact_pins(&plan->end[side], side, q->side[side].pins, p, r, knots, middle);
    }
    free(knots);
    if (right_copied > 0)
        memcpy(points + (size_t)(copied + local) * m,
               b->original->points + (size_t)(b->original->spread - right_copied) * m,
               (size_t)right_copied * m * sizeof *points);
    changed_new[0] = start, changed_new[1] = end;
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    return bat_curve_finish(curve, out);
}

/* One period [cut, cut + period) written from the left cut on, then turned so that it begins where the old
 * one did if that knot is still there. */
static bat_status splice_closed(const bat_plan *plan, const bat_local_problem *q, const bat_local_result *fit,
                                const double *origin, double pixel, bat_curve **out, double changed_new[2]) {
    const int p = plan->degree, r = fit->interior, local = r + p + 1;
    const size_t m = (size_t)plan->dimension;
    const bat_end *a = &plan->end[0], *b = &plan->end[1];
    const bat_curve *old = a->original;
    const double period = old->knots[old->spread] - old->knots[p];
    const double start = a->cut, end = start + q->end / plan->target.rate, shift = end - b->cut;
    const double new_period = period + shift;
    double *kept = malloc((size_t)(old->count * 2 + 2) * sizeof *kept);
    if (!kept) return BAT_MEMORY;
    const int k = kept_closed(plan, old, kept, old->count * 2);
    const int n_cut = a->kind == BAT_END_POINT ? p : 1, n_end = b->kind == BAT_END_POINT ? p : 1;
    /* Corner copies at the cuts are among the knots: `ahead` local points lie before index 0. */
    const int n = n_cut + r + n_end + k;
    bat_curve *curve = NULL;
    double *t = malloc((size_t)(n + 1) * sizeof *t), *points = malloc((size_t)n * m * sizeof *points);
    double *knots = malloc((size_t)(r + 2 * p + 2) * sizeof *knots);
    double *middle = malloc((size_t)local * m * sizeof *middle);
    bat_status status = t && points && knots && middle ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK && k + 1 < p) status = BAT_COUNT; /* the caller refines the kept arc first */
    if (status == BAT_OK) {
        int c = 0;
        for (int i = 0; i < n_cut; i++) t[c++] = start;
        for (int i = 0; i < r; i++)
            t[c++] = fmin(fmax(start + fit->knots[i] / plan->target.rate, start), end);
        for (int i = 0; i < n_end; i++) t[c++] = end;
        for (int i = 0; i < k; i++) t[c++] = kept[i] + shift;
        t[c] = start + new_period;
        for (size_t i = 0; i < (size_t)local; i++)
            for (size_t d = 0; d < m; d++) middle[i * m + d] = origin[d] + pixel * fit->points[i * m + d];
        for (int side = 0; side < 2; side++) {
            const bat_end *e = &plan->end[side];
            /* Local vector: p outer knots and the cut, interior, the cut and p outer knots. */
            const double base = side == 0 ? 0 : shift;
            for (int i = 0; i <= p; i++) {
                const int back = p - i; /* knots before the cut: kept ones, then the other cut */
                knots[i] = back == 0 || a->kind == BAT_END_POINT ? start
                           : back <= k                           ? kept[k - back] - period
                                                                 : b->cut - period;
                const int ahead = i;
                knots[p + 1 + r + i] = ahead == 0 || b->kind == BAT_END_POINT ? b->cut + shift - base
                                       : ahead <= k                           ? kept[ahead - 1] + shift - base
                                                                              : start + period + shift - base;
            }
            for (int i = 0; i < r; i++) knots[p + 1 + i] = t[n_cut + i] - base;
            if (side == 0) /* as the curve will have them */
                for (int i = 0; i <= p; i++)
                    knots[p + 1 + r + i] = i == 0 || b->kind == BAT_END_POINT ? end : knots[p + 1 + r + i];
            exact_pins(e, side, q->side[side].pins, p, r, knots, middle);
        }
        /* Stored control point of the old curve whose support begins at the cut of end 1. */
        double reduced;
        const int first = kept_span(old, 1, b->cut, &reduced) + (b->kind == BAT_END_POINT ? 1 - p : 0);
        for (int i = 0; i < n; i++) {
            /* New index i has its support begin at t[i]. Local points run from index n_cut - 1 - p on. */
            const int first_local = n_cut - 1 - p;
            int j = i;
            if (j - first_local >= local && i - n >= first_local) j = i - n; /* before the period's start */
            double *target = points + (size_t)i * m;
            if (j - first_local < local) {
                memcpy(target, middle + (size_t)(j - first_local) * m, m * sizeof *target);
                continue;
            }
            const int place = j - (first_local + local); /* 0: the first copied point */
            const int stored = first + place;
            const int wrapped = ((stored - p) % old->count + old->count) % old->count;
            memcpy(target, old->points + (size_t)(wrapped + p) * m, m * sizeof *target);
        }
        /* Begin where the old period began. */
        int turn = 0;
        const double seam = old->knots[p];
        for (int i = 0; i < k; i++) {
            const double laps = floor((kept[i] - seam) / period + 0.5);
            if (fabs(kept[i] - seam - laps * period) <= 1e-13 * (fabs(seam) + period) &&
                (i == 0 || kept[i - 1] != kept[i]))
                turn = n - k + i;
        }
        status = bat_curve_allocate(p, plan->dimension, true, n, &curve);
        if (status == BAT_OK) {
            double *nt = bat_curve_own_knots(curve), *np = bat_curve_own_points(curve);
            for (int i = 0; i < n; i++) {
                const int j = (turn + i) % n;
                /* Turned: what comes before the cut keeps its old parameters. */
                nt[i] = turn == 0 ? t[j] : turn + i < n ? kept[turn + i - (n - k)] - period : t[j];
                memcpy(np + (size_t)i * m, points + (size_t)j * m, m * sizeof *np);
            }
            nt[n] = nt[0] + new_period;
            changed_new[0] = start, changed_new[1] = end;
            status = bat_curve_finish(curve, out);
        }
    }
    free(kept);
    free(t);
    free(points);
    free(knots);
    free(middle);
    return status;
}

static bat_status splice_periodic(const bat_plan *plan, const bat_local_problem *q,
                                  const bat_local_result *fit, const double *origin, double pixel,
                                  bat_curve **out, double changed_new[2]) {
    const int p = plan->degree, n = fit->interior + 1;
    const size_t m = (size_t)plan->dimension;
    const double start = plan->end[0].original ? plan->end[0].original->knots[p] : 0;
    bat_curve *curve;
    bat_status status = bat_curve_allocate(p, plan->dimension, true, n, &curve);
    if (status != BAT_OK) return status;
    double *t = bat_curve_own_knots(curve), *points = bat_curve_own_points(curve);
    t[0] = start;
    for (int i = 1; i < n; i++) t[i] = start + fit->knots[i - 1] / plan->target.rate;
    t[n] = start + q->end / plan->target.rate;
    for (size_t i = 0; i < (size_t)n; i++)
        for (size_t c = 0; c < m; c++) points[i * m + c] = origin[c] + pixel * fit->points[i * m + c];
    changed_new[0] = start, changed_new[1] = t[n];
    return bat_curve_finish(curve, out);
}

bat_status bat_splice(const bat_plan *plan, const bat_local_problem *q, const bat_local_result *fit,
                      const double *origin, double pixel, bat_curve **out, double changed_new[2]) {
    if (plan->periodic) return splice_periodic(plan, q, fit, origin, pixel, out, changed_new);
    if (plan->closed) return splice_closed(plan, q, fit, origin, pixel, out, changed_new);
    return splice_open(plan, q, fit, origin, pixel, out, changed_new);
}
