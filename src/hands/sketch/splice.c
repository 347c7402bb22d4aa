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

/* The p - 1 knots beyond the cut of an open curve are those of the kept piece. */
static void outer_open(bat_local_side *s, int side, int p) {
    const double *knots = s->curve->knots;
    for (int i = 1; i < p; i++) {
        if (side == 0)
            s->outer[p - 1 - i] = (knots[s->span + 1 - i] - s->base) * s->rate;
        else
            s->outer[i] = s->at + (knots[s->span + i] - s->base) * s->rate;
    }
}

/* Of a closed curve they are those of the kept arc, and beyond it the other cut. */
static void outer_closed(const bat_plan *plan, bat_local_side *s, int side) {
    const bat_end *e = &plan->end[side];
    const int p = plan->degree, n = e->curve->count;
    const double period = e->track->end - e->track->start;
    if (side == 1) {
        double kept[2 * BAT_DEGREE_MAX];
        const int count = kept_closed(plan, e->curve, kept, p - 1);
        const double far = plan->end[0].cut + e->track->end - e->track->start;
        for (int i = 1; i < p; i++)
            s->outer[i] = s->at + ((i <= count ? kept[i - 1] : far) - e->cut) * s->rate;
        return;
    }
    int filled = 0;
    for (int index = s->span; filled < p - 1; filled++, index--) {
        int j = index, turns = 0;
        while (j < 0) j += n, turns--;
        const double knot = e->curve->knots[j] + turns * period + (e->cut - s->base);
        if (knot <= plan->end[1].cut - period + 1e-12 * period) break;
        s->outer[p - 2 - filled] = (knot - e->cut) * s->rate;
    }
    for (; filled < p - 1; filled++)
        s->outer[p - 2 - filled] = (plan->end[1].cut - period - e->cut) * s->rate;
}

static void problem_side(const bat_plan *plan, int side, bat_local_side *s) {
    const bat_target *t = &plan->target;
    const bat_end *e = &plan->end[side];
    const double at = side == 0 ? 0 : t->end;
    for (int i = 0; i < plan->degree; i++) s->outer[i] = at;
    if (e->kind == BAT_END_FREE) { /* the curve ends where the stroke does, neither short of it nor beyond */
        const size_t m = (size_t)plan->dimension;
        s->pins = 1;
        memcpy(s->point, t->x + (side == 0 ? 0 : (t->count - 1) * m), m * sizeof *s->point);
        return;
    }
    if (e->kind == BAT_END_POINT) {
        s->pins = 1;
        bat_curve_eval(e->curve, e->cut, 0, s->point);
        return;
    }
    s->pins = plan->pins;
    s->curve = e->curve;
    s->span = kept_span(e->curve, side, e->cut, &s->base);
    s->rate = t->rate, s->at = at;
    if (plan->closed)
        outer_closed(plan, s, side);
    else
        outer_open(s, side, plan->degree);
}

void bat_plan_problem(const bat_plan *plan, bat_local_problem *q) {
    const bat_target *t = &plan->target;
    memset(q, 0, sizeof *q);
    q->degree = plan->degree, q->dimension = plan->dimension, q->closed = plan->periodic;
    q->end = t->end, q->count = t->count;
    q->w = t->w, q->x = t->x, q->weight = t->weight, q->allowed = t->allowed, q->law = t->law;
    q->first = t->first, q->last = t->last;
    q->fixed_count = plan->fixed_count, q->fixed = plan->fixed;
    q->tolerance = plan->tolerance, q->fairness = plan->fairness;
    q->span = fmax(8 * plan->tolerance, 2);
    q->wavelength = 18;
    if (plan->stroke) /* waves that belong to what was drawn are shorter than this */
        q->wavelength = fmin(fmax(0.6 * plan->stroke->grain, 18), 75);
    q->remove = true;
    for (int side = 0; side < 2 && !plan->periodic; side++) problem_side(plan, side, &q->side[side]);
}

static void to_document(const double *x, size_t count, size_t m, const double *origin, double pixel,
                        double *out) {
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < m; c++) out[i * m + c] = origin[c] + pixel * x[i * m + c];
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

/* ---- open curves ---- */

/* What of the old curve is kept on either side of the new piece, and where that lies. Knots are those of the stored
 * curve; points are copied where they do not reach the cut. */
typedef struct open_parts {
    int left, left_times, left_points; /* knots[0..left - 1] lie before the cut, a left_times-fold knot */
    int right_from, right, right_times, right_points; /* knots[right_from..] lie after it */
    double start, end, shift;                         /* of the new piece; what the right side is moved by */
} open_parts;

static void keep_left(const bat_end *a, int p, open_parts *o) {
    double reduced;
    o->left = 0, o->left_times = p + 1, o->left_points = 0;
    if (a->kind == BAT_END_FREE || (a->kind == BAT_END_POINT && !a->corner)) return;
    o->left = kept_span(a->original, 0, a->cut, &reduced) + 1;
    o->left_times = a->kind == BAT_END_KEPT ? 1 : p;
    o->left_points = a->kind == BAT_END_KEPT ? o->left - p : o->left - 1;
}

static void keep_right(const bat_end *b, int p, open_parts *o) {
    double reduced;
    o->right_from = o->right = o->right_points = 0, o->right_times = p + 1;
    if (b->kind == BAT_END_FREE || (b->kind == BAT_END_POINT && !b->corner)) return;
    o->right_from = kept_span(b->original, 1, b->cut, &reduced) + 1;
    o->right = b->original->spread + p + 1 - o->right_from;
    o->right_times = b->kind == BAT_END_KEPT ? 1 : p;
    /* Kept: the point whose support begins at the cut; corner: the one after the corner's own. */
    o->right_points = b->original->spread - (b->kind == BAT_END_KEPT ? o->right_from - 1 : o->right_from - p);
}

/* The kept left side keeps its parameters; without one, the right side does. */
static void place_piece(const bat_plan *plan, double length, open_parts *o) {
    const bat_end *a = &plan->end[0], *b = &plan->end[1];
    o->start = a->cut;
    if (a->kind == BAT_END_FREE) {
        if (b->kind != BAT_END_FREE)
            o->start = b->cut - length;
        else
            o->start = a->original ? a->original->knots[plan->degree] : 0;
    }
    o->end = o->start + length;
    if (a->kind == BAT_END_FREE && b->kind != BAT_END_FREE) o->end = b->cut;
    o->shift = b->kind == BAT_END_FREE ? 0 : o->end - b->cut;
}

/* Returns how many. */
static int open_knots(const bat_plan *plan, const bat_local_result *fit, const open_parts *o, double *t) {
    int n = 0;
    for (int i = 0; i < o->left; i++) t[n++] = plan->end[0].original->knots[i];
    for (int i = 0; i < o->left_times; i++) t[n++] = o->start;
    for (int i = 0; i < fit->interior; i++)
        t[n++] = fmin(fmax(o->start + fit->knots[i] / plan->target.rate, o->start), o->end);
    for (int i = 0; i < o->right_times; i++) t[n++] = o->end;
    for (int i = 0; i < o->right; i++) t[n++] = plan->end[1].original->knots[o->right_from + i] + o->shift;
    return n;
}

/* t: the new curve's n knots; points: those of the new piece. */
static bat_status open_pins(const bat_plan *plan, const bat_local_problem *q, int interior,
                            const open_parts *o, const double *t, int n, double *points) {
    const int p = plan->degree, count = interior + 2 * p + 2;
    const bat_end *b = &plan->end[1];
    double *knots = malloc((size_t)count * sizeof *knots);
    if (!knots) return BAT_MEMORY;
    for (int side = 0; side < 2; side++) {
        if (plan->end[side].kind == BAT_END_FREE) continue;
        memcpy(knots, t + o->left_points, (size_t)count * sizeof *knots);
        for (int i = 0; i < count && side == 1; i++) { /* kept knots exactly, new ones shifted back */
            const int index = o->left_points + i - (n - o->right);
            knots[i] = index >= 0                 ? b->original->knots[o->right_from + index]
                       : index >= -o->right_times ? b->cut
                                                  : knots[i] - o->shift;
        }
        exact_pins(&plan->end[side], side, q->side[side].pins, p, interior, knots, points);
    }
    free(knots);
    return BAT_OK;
}

static bat_status splice_open(const bat_plan *plan, const bat_local_problem *q, const bat_local_result *fit,
                              const double *origin, double pixel, bat_curve **out, double changed_new[2]) {
    const int p = plan->degree, local = fit->interior + p + 1;
    const size_t m = (size_t)plan->dimension;
    const bat_curve *before = plan->end[0].original, *behind = plan->end[1].original;
    open_parts o;
    keep_left(&plan->end[0], p, &o);
    keep_right(&plan->end[1], p, &o);
    place_piece(plan, q->end / plan->target.rate, &o);
    bat_curve *curve;
    bat_status status = bat_curve_allocate(p, plan->dimension, false, o.left_points + local + o.right_points,
                                           &curve);
    if (status != BAT_OK) return status;
    double *points = curve->points, *middle = points + (size_t)o.left_points * m;
    const int n = open_knots(plan, fit, &o, curve->knots);
    if (o.left_points > 0) memcpy(points, before->points, (size_t)o.left_points * m * sizeof *points);
    to_document(fit->points, (size_t)local, m, origin, pixel, middle);
    status = open_pins(plan, q, fit->interior, &o, curve->knots, n, middle);
    if (o.right_points > 0)
        memcpy(middle + (size_t)local * m, behind->points + (size_t)(behind->spread - o.right_points) * m,
               (size_t)o.right_points * m * sizeof *points);
    changed_new[0] = o.start, changed_new[1] = o.end;
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    return bat_curve_finish(curve, out);
}

/* ---- closed curves ---- */

/* One period [cut, cut + period) written from the left cut on. Corner copies at the cuts are among the knots: some local
 * points then lie before index 0. */
typedef struct closed_parts {
    const bat_curve *old;
    int p, interior, local;     /* of the new piece: knots inside, points */
    int kept_count;             /* knots of the kept arc */
    int start_times, end_times; /* copies of the cuts */
    int n;                      /* points of the new curve */
    double period, new_period;
    double start, end, shift;                   /* of the new piece; what the kept arc is moved by */
    double *kept, *t, *points, *knots, *middle; /* kept owns them all; middle: points of the new piece */
} closed_parts;

static bat_status closed_parts_make(const bat_plan *plan, const bat_local_problem *q,
                                    const bat_local_result *fit, closed_parts *c) {
    const bat_end *a = &plan->end[0], *b = &plan->end[1];
    const bat_curve *old = a->original;
    const int p = plan->degree;
    const size_t m = (size_t)plan->dimension, room = (size_t)old->count * 2 + 2;
    *c = (closed_parts){.old = old, .p = p, .interior = fit->interior, .local = fit->interior + p + 1};
    c->period = old->knots[old->spread] - old->knots[p];
    c->start = a->cut, c->end = c->start + q->end / plan->target.rate, c->shift = c->end - b->cut;
    c->new_period = c->period + c->shift;
    c->start_times = a->kind == BAT_END_POINT ? p : 1, c->end_times = b->kind == BAT_END_POINT ? p : 1;
    const size_t most = (size_t)(c->start_times + c->interior + c->end_times + old->count * 2);
    const size_t window = (size_t)(c->interior + 2 * p + 2);
    c->kept = malloc((room + most + 1 + most * m + window + (size_t)c->local * m) * sizeof *c->kept);
    if (!c->kept) return BAT_MEMORY;
    c->t = c->kept + room, c->points = c->t + most + 1, c->knots = c->points + most * m;
    c->middle = c->knots + window;
    c->kept_count = kept_closed(plan, old, c->kept, old->count * 2);
    c->n = c->start_times + c->interior + c->end_times + c->kept_count;
    return c->kept_count + 1 < p ? BAT_COUNT : BAT_OK; /* the caller refines the kept arc first */
}

static void closed_knots(const bat_plan *plan, const bat_local_result *fit, closed_parts *c) {
    int n = 0;
    for (int i = 0; i < c->start_times; i++) c->t[n++] = c->start;
    for (int i = 0; i < c->interior; i++)
        c->t[n++] = fmin(fmax(c->start + fit->knots[i] / plan->target.rate, c->start), c->end);
    for (int i = 0; i < c->end_times; i++) c->t[n++] = c->end;
    for (int i = 0; i < c->kept_count; i++) c->t[n++] = c->kept[i] + c->shift;
    c->t[n] = c->start + c->new_period;
}

/* The new piece's knots as a side sees them: p outer ones and the cut, the interior, the cut and p outer ones. Beyond a
 * cut are the kept knots, then the other cut. */
static void closed_window(const bat_plan *plan, int side, closed_parts *c) {
    const bat_end *a = &plan->end[0], *b = &plan->end[1];
    const int p = c->p, r = c->interior, k = c->kept_count;
    const double base = side == 0 ? 0 : c->shift;
    double *front = c->knots, *back = c->knots + p + 1 + r;
    for (int i = 0; i <= p; i++) {
        const int before = p - i;
        const double at = before == 0 || a->kind == BAT_END_POINT ? c->start
                          : before <= k                           ? c->kept[k - before] - c->period
                                                                  : b->cut - c->period;
        front[i] = at - base;
        back[i] = i == 0 || b->kind == BAT_END_POINT ? b->cut + c->shift - base
                  : i <= k                           ? c->kept[i - 1] + c->shift - base
                                                     : c->start + c->period + c->shift - base;
        if (side == 0 && (i == 0 || b->kind == BAT_END_POINT))
            back[i] = c->end; /* as the curve will have it */
    }
    for (int i = 0; i < r; i++) front[p + 1 + i] = c->t[c->start_times + i] - base;
}

/* New index i has its support begin at t[i]; local points run from index start_times - 1 - p on. */
static void closed_points(const bat_plan *plan, closed_parts *c) {
    const bat_end *b = &plan->end[1];
    const size_t m = (size_t)plan->dimension;
    const int p = c->p, first_local = c->start_times - 1 - p;
    double reduced;
    /* Stored control point of the old curve whose support begins at the cut of end 1. */
    const int first = kept_span(c->old, 1, b->cut, &reduced) + (b->kind == BAT_END_POINT ? 1 - p : 0);
    for (int i = 0; i < c->n; i++) {
        int j = i;
        if (j - first_local >= c->local && i - c->n >= first_local)
            j = i - c->n; /* before the period's start */
        double *target = c->points + (size_t)i * m;
        if (j - first_local < c->local) {
            memcpy(target, c->middle + (size_t)(j - first_local) * m, m * sizeof *target);
            continue;
        }
        const int place = j - (first_local + c->local); /* 0: the first copied point */
        const int stored = first + place;
        const int wrapped = ((stored - p) % c->old->count + c->old->count) % c->old->count;
        memcpy(target, c->old->points + (size_t)(wrapped + p) * m, m * sizeof *target);
    }
}

/* The index at which the old period began, if that knot is still there. */
static int closed_turn(const closed_parts *c) {
    const double seam = c->old->knots[c->p];
    int turn = 0;
    for (int i = 0; i < c->kept_count; i++) {
        const double laps = floor((c->kept[i] - seam) / c->period + 0.5);
        if (fabs(c->kept[i] - seam - laps * c->period) <= 1e-13 * (fabs(seam) + c->period) &&
            (i == 0 || c->kept[i - 1] != c->kept[i]))
            turn = c->n - c->kept_count + i;
    }
    return turn;
}

/* Turned so that it begins where the old one did; what comes before the cut keeps its old parameters. */
static bat_status closed_write(const closed_parts *c, int dimension, bat_curve **out) {
    const int n = c->n, turn = closed_turn(c);
    const size_t m = (size_t)dimension;
    bat_curve *curve;
    bat_status status = bat_curve_allocate(c->p, dimension, true, n, &curve);
    if (status != BAT_OK) return status;
    double *t = bat_curve_own_knots(curve), *points = bat_curve_own_points(curve);
    for (int i = 0; i < n; i++) {
        const int j = (turn + i) % n;
        t[i] = turn == 0      ? c->t[j]
               : turn + i < n ? c->kept[turn + i - (n - c->kept_count)] - c->period
                              : c->t[j];
        memcpy(points + (size_t)i * m, c->points + (size_t)j * m, m * sizeof *points);
    }
    t[n] = t[0] + c->new_period;
    return bat_curve_finish(curve, out);
}

static bat_status splice_closed(const bat_plan *plan, const bat_local_problem *q, const bat_local_result *fit,
                                const double *origin, double pixel, bat_curve **out, double changed_new[2]) {
    closed_parts c;
    bat_status status = closed_parts_make(plan, q, fit, &c);
    if (status == BAT_OK) {
        closed_knots(plan, fit, &c);
        to_document(fit->points, (size_t)c.local, (size_t)plan->dimension, origin, pixel, c.middle);
        for (int side = 0; side < 2; side++) {
            closed_window(plan, side, &c);
            exact_pins(&plan->end[side], side, q->side[side].pins, c.p, c.interior, c.knots, c.middle);
        }
        closed_points(plan, &c);
        changed_new[0] = c.start, changed_new[1] = c.end;
        status = closed_write(&c, plan->dimension, out);
    }
    free(c.kept);
    return status;
}

/* ---- all of it ---- */

static bat_status splice_periodic(const bat_plan *plan, const bat_local_problem *q,
                                  const bat_local_result *fit, const double *origin, double pixel,
                                  bat_curve **out, double changed_new[2]) {
    const int p = plan->degree, n = fit->interior + 1;
    const double start = plan->end[0].original ? plan->end[0].original->knots[p] : 0;
    bat_curve *curve;
    bat_status status = bat_curve_allocate(p, plan->dimension, true, n, &curve);
    if (status != BAT_OK) return status;
    double *t = bat_curve_own_knots(curve), *points = bat_curve_own_points(curve);
    t[0] = start;
    for (int i = 1; i < n; i++) t[i] = start + fit->knots[i - 1] / plan->target.rate;
    t[n] = start + q->end / plan->target.rate;
    to_document(fit->points, (size_t)n, (size_t)plan->dimension, origin, pixel, points);
    changed_new[0] = start, changed_new[1] = t[n];
    return bat_curve_finish(curve, out);
}

bat_status bat_splice(const bat_plan *plan, const bat_local_problem *q, const bat_local_result *fit,
                      const double *origin, double pixel, bat_curve **out, double changed_new[2]) {
    if (plan->periodic) return splice_periodic(plan, q, fit, origin, pixel, out, changed_new);
    if (plan->closed) return splice_closed(plan, q, fit, origin, pixel, out, changed_new);
    return splice_open(plan, q, fit, origin, pixel, out, changed_new);
}
