/*
 * Calming: the smoothing of smooth.c in the space of the curve's own knots. The control points whose support
 * lies in the stretch, or in the spans beside it where it fades out, move so as to minimise
 *
 *     sum |D(s_i)|^2 + lambda sum w_i |third difference of (C + D) + (h k)^2 first difference|^2,
 *
 * D being the move at places h apart, k the curvature there (sketch 9.1: what is penalised is the change of
 * curvature, so that arcs cost nothing), and w a weight, 1 in the stretch and 0 far from it. lambda is the
 * greatest at which waves longer than the stretch stay, the curve moves by no more than the limit and the
 * guards hold: no more extrema of curvature than before, no more inflections, no higher peak, less variation.
 * Corners and ends stay, smooth nodes stay smooth.
 */
#include "base/real.h"
#include "curve/banded.h"
#include "curve/curve.h"
#include "hands/sketch/track.h"
#include <batten/sketch.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DENSE = 80, PLACES = 2000, WIDTH = BAT_BAND_MAX + 1, THRESHOLDS = 12 };

static const double CORNER = 0.06; /* radians: a turn too great to come from rounding */
static const double BEND = 0.2;    /* greatest curvature that counts, per pixel */
static const double THRESHOLD[THRESHOLDS] = {
    0, 1e-6, 1e-5, 5e-5, 1e-4, 2e-4, 5e-4, 0.001, 0.002, 0.005, 0.015, 0.04}; /* of the range of curvature */

/* What a control point does. */
typedef enum role { STAYS, MOVES, FOLLOWS } role; /* FOLLOWS: a node between its handles */

typedef struct work {
    const bat_curve *curve;
    double u[2], pixel, limit, step; /* u: what may change, in whichever period */
    double core[2], wave;            /* the stretch, and its length: longer waves stay */
    int first, count;                /* stored control points in question; closed: in any period */
    role *roles;
    int *unknown;  /* of those that move */
    double *share; /* of those that follow: weight of the point before; the point after has the rest */
    int unknowns, places, band;
    int *from;      /* first unknown of a place's row; -1: none moves it */
    double *row;    /* places * WIDTH */
    double *at;     /* places * 2: the curve */
    double *bent;   /* places: (h k)^2 */
    double *weight; /* places: root weight of the difference that begins there; 1 in the stretch, 0 far off */
    double *fit, *fair, *sum, *pull, *move; /* matrices, right side, solution */
} work;

/* ---- knots and control points, closed curves unrolled for ever ---- */

static double knot(const bat_curve *c, int i) {
    if (!c->closed) return c->knots[i];
    int turns = (int)floor((double)(i - c->degree) / c->count);
    return c->knots[i - turns * c->count] + turns * (c->knots[c->spread] - c->knots[c->degree]);
}

static int point_index(const bat_curve *c, int stored) {
    return c->closed ? ((stored - c->degree) % c->count + c->count) % c->count : stored;
}

static const double *point_at(const bat_curve *c, int stored) {
    return bat_curve_points(c) + 2 * point_index(c, stored);
}

/* The span of u in any period: stored index, and u as that span has it. */
static int span_at(const bat_curve *c, double *u, int *turns) {
    double period = c->knots[c->spread] - c->knots[c->degree], start = c->knots[c->degree];
    *turns = c->closed ? (int)floor((*u - start) / period) : 0;
    *u = bat_curve_reduce(c, *u - *turns * period);
    return bat_span(c, *u, -1);
}

/* ---- who moves ---- */

static role *role_at(const work *w, int stored) {
    int i = stored - w->first;
    return i >= 0 && i < w->count ? &w->roles[i] : NULL;
}

static void hold(const work *w, int stored) {
    role *r = role_at(w, stored);
    if (r) *r = STAYS;
}

/* A node's handles stay in line, its corner stays, and what reaches beyond the stretch stays. */
static void tie(work *w, int stored) {
    const bat_curve *c = w->curve;
    int p = c->degree;
    if (p < 2 || knot(c, stored + 1) != knot(c, stored + p)) return;
    role *r = role_at(w, stored);
    const double *in = point_at(c, stored - 1), *on = point_at(c, stored), *out = point_at(c, stored + 1);
    bool smooth = bat_turn(in, on, out, 2) <= CORNER;
    if (r && *r == MOVES && smooth) {
        double a = bat_distance(in, on, 2), b = bat_distance(on, out, 2);
        *r = FOLLOWS;
        w->share[stored - w->first] = b / (a + b);
        return;
    }
    for (int k = -1; k <= 1; k++) hold(w, stored + k);
}

/* Decides for all control points that reach the stretch; returns how many move. */
static int assign(work *w) {
    const bat_curve *c = w->curve;
    int p = c->degree, n = c->count;
    double slack = 1e-9 * (w->u[1] - w->u[0]);
    for (int i = 0; i < w->count; i++) {
        int s = w->first + i;
        bool inside = knot(c, s) >= w->u[0] - slack && knot(c, s + p + 1) <= w->u[1] + slack;
        bool end = !c->closed && (s < 2 || s > n - 3); /* place and direction of ends */
        w->roles[i] = inside && !end ? MOVES : STAYS;
    }
    for (int s = w->first - 1; s <= w->first + w->count; s++)
        if (c->closed || (s > 0 && s < n - 1)) tie(w, s);
    w->unknowns = 0;
    for (int i = 0; i < w->count; i++)
        if (w->roles[i] == MOVES) w->unknown[i] = w->unknowns++;
    return w->unknowns;
}

/* ---- rows ---- */

static void add(const work *w, int stored, double weight, int *from, double *row, int *last) {
    role *r = role_at(w, stored);
    if (!r || *r != MOVES || weight == 0) return;
    int unknown = w->unknown[stored - w->first];
    if (*from < 0) *from = unknown;
    if (unknown < *from || unknown - *from >= WIDTH) return; /* ascending, and measured before */
    row[unknown - *from] += weight;
    if (unknown > *last) *last = unknown;
}

/* The row of a place; ascending in the unknowns. */
static void make_row(const work *w, double u, int *from, double *row, double *at) {
    const bat_curve *c = w->curve;
    double weights[BAT_DEGREE_MAX + 1];
    int turns, span = span_at(c, &u, &turns), p = c->degree, last = -1;
    bat_basis(c, span, u, 0, weights);
    bat_curve_eval_span(c, span, u, 0, at);
    memset(row, 0, WIDTH * sizeof *row);
    *from = -1;
    int first = span - p + turns * c->count;
    /* A node that follows gives its weight to both handles: the one before it may come first. */
    role *before = role_at(w, first);
    if (before && *before == FOLLOWS)
        add(w, first - 1, weights[0] * w->share[first - w->first], from, row, &last);
    for (int k = 0; k <= p; k++) {
        double weight = weights[k];
        for (int side = -1; side <= 1; side += 2) {
            role *next = k + side >= 0 && k + side <= p ? role_at(w, first + k + side) : NULL;
            if (!next || *next != FOLLOWS) continue;
            double share = w->share[first + k + side - w->first];
            weight += weights[k + side] * (side > 0 ? share : 1 - share);
        }
        add(w, first + k, weight, from, row, &last);
    }
    role *after = role_at(w, first + p);
    if (after && *after == FOLLOWS)
        add(w, first + p + 1, weights[p] * (1 - w->share[first + p - w->first]), from, row, &last);
}

/* ---- the system ---- */

/* Third difference and bent first difference at four places, in the unknowns and of the curve. */
static int difference(const work *w, int i, int *from, double *row, double value[2]) {
    static const double third[4] = {-1, 3, -3, 1};
    double first[4] = {0, -w->bent[i + 1], w->bent[i + 1], 0};
    int low = w->unknowns, high = -1;
    for (int k = 0; k < 4; k++)
        if (w->from[i + k] >= 0 && w->from[i + k] < low) low = w->from[i + k];
    memset(row, 0, 2 * WIDTH * sizeof *row);
    value[0] = value[1] = 0;
    for (int k = 0; k < 4; k++) {
        double weight = (third[k] + first[k]) * w->weight[i];
        const double *place = w->row + (size_t)(i + k) * WIDTH;
        int shift = w->from[i + k] - low;
        for (int a = 0; a < WIDTH && w->from[i + k] >= 0 && shift + a < 2 * WIDTH; a++)
            if (place[a] != 0) {
                row[shift + a] += weight * place[a];
                if (shift + a > high) high = shift + a;
            }
        for (int d = 0; d < 2; d++) value[d] += weight * w->at[2 * (size_t)(i + k) + (size_t)d];
    }
    *from = low;
    return high + 1;
}

static void accumulate(double *matrix, int band, int from, int width, const double *row) {
    for (int a = 0; a < width; a++)
        for (int b = 0; b <= a; b++)
            if (row[a] != 0 && row[b] != 0)
                matrix[(size_t)(from + a) * (size_t)(band + 1) + (size_t)(a - b)] += row[a] * row[b];
}

/* The width of the widest row of differences; more than WIDTH: too many knots in a step. */
static int widest(const work *w) {
    double row[2 * WIDTH], value[2];
    int most = 1, from;
    for (int i = 0; i + 3 < w->places; i++) {
        int width = difference(w, i, &from, row, value);
        if (width > most) most = width;
    }
    return most;
}

static void assemble(work *w) {
    double row[2 * WIDTH], value[2];
    size_t size = (size_t)w->unknowns * (size_t)(w->band + 1);
    memset(w->fit, 0, size * sizeof *w->fit);
    memset(w->fair, 0, size * sizeof *w->fair);
    memset(w->pull, 0, 2 * (size_t)w->unknowns * sizeof *w->pull);
    for (int i = 0; i < w->places; i++) {
        if (w->from[i] < 0) continue;
        int width = w->unknowns - w->from[i] < w->band + 1 ? w->unknowns - w->from[i] : w->band + 1;
        accumulate(w->fit, w->band, w->from[i], width, w->row + (size_t)i * WIDTH);
    }
    for (int i = 0; i + 3 < w->places; i++) {
        int from, width = difference(w, i, &from, row, value);
        accumulate(w->fair, w->band, from, width, row);
        for (int a = 0; a < width; a++)
            for (int d = 0; d < 2; d++) w->pull[2 * (from + a) + d] -= row[a] * value[d];
    }
    for (int i = 0; i < w->unknowns; i++) w->fit[(size_t)i * (size_t)(w->band + 1)] += 1e-9;
}

/* The greatest move of a place. */
static double furthest(const work *w) {
    double worst = 0;
    for (int i = 0; i < w->places; i++) {
        double d[2] = {0, 0};
        for (int a = 0; a < WIDTH && w->from[i] >= 0 && w->from[i] + a < w->unknowns; a++)
            for (int k = 0; k < 2; k++)
                d[k] += w->row[(size_t)i * WIDTH + (size_t)a] * w->move[2 * (w->from[i] + a) + k];
        worst = fmax(worst, bat_hypot(d[0], d[1]));
    }
    return isfinite(worst) ? worst : INFINITY;
}

/* Finds the moves for lambda. Returns the greatest move of a place, infinite when there is no solution. */
static double solve(work *w, double lambda) {
    size_t size = (size_t)w->unknowns * (size_t)(w->band + 1);
    for (size_t i = 0; i < size; i++) w->sum[i] = w->fit[i] + lambda * w->fair[i];
    for (int i = 0; i < 2 * w->unknowns; i++) w->move[i] = lambda * w->pull[i];
    if (bat_banded_factor(w->sum, w->unknowns, w->band) != BAT_OK) return INFINITY;
    bat_banded_solve(w->sum, w->unknowns, w->band, w->move, 2);
    return furthest(w);
}

static bat_status moved(const work *w, bat_curve **out) {
    const bat_curve *c = w->curve;
    bat_curve *made;
    bat_status status = bat_curve_allocate(c->degree, 2, c->closed, c->count, &made);
    if (status != BAT_OK) return status;
    memcpy(bat_curve_own_knots(made), bat_curve_knots(c), (size_t)bat_curve_knot_count(c) * sizeof(double));
    double *points = bat_curve_own_points(made);
    memcpy(points, bat_curve_points(c), 2 * (size_t)c->count * sizeof(double));
    for (int i = 0; i < w->count; i++) {
        double *to = points + 2 * point_index(c, w->first + i);
        for (int d = 0; d < 2 && w->roles[i] == MOVES; d++) to[d] += w->move[2 * w->unknown[i] + d];
    }
    for (int i = 0; i < w->count; i++) { /* by as much as keeps its handles in line and in proportion */
        if (w->roles[i] != FOLLOWS) continue;
        int s = w->first + i;
        double *to = points + 2 * point_index(c, s);
        for (int side = -1; side <= 1; side += 2) {
            const double *now = points + 2 * point_index(c, s + side), *old = point_at(c, s + side);
            double share = side < 0 ? w->share[i] : 1 - w->share[i];
            for (int d = 0; d < 2; d++) to[d] += share * (now[d] - old[d]);
        }
    }
    return bat_curve_finish(made, out);
}

/* ---- the guards ---- */

typedef struct comb {
    double low, high, peak, variation;
    int inflections, changes; /* changes of the sign of curvature, and of that of its slope */
    int extrema[THRESHOLDS];  /* by prominence */
} comb;

/* Counts the turns of a sequence that are deeper than the threshold, value by value. */
typedef struct zigzag {
    double low, high;
    int way, turns;
    bool begun;
} zigzag;

static void follow(zigzag *z, double value, double depth) {
    if (!z->begun) *z = (zigzag){value, value, 0, 0, true};
    z->low = fmin(z->low, value);
    z->high = fmax(z->high, value);
    if (z->way >= 0 && value < z->high - depth) {
        z->turns += z->way > 0;
        z->way = -1;
        z->low = value;
        z->high = value;
    } else if (z->way <= 0 && value > z->low + depth) {
        z->turns += z->way < 0;
        z->way = 1;
        z->low = value;
        z->high = value;
    }
}

/* Curvature at a place of a span, and the sign of its slope. */
static double curvature(const bat_curve *curve, int span, double u, double *slope) {
    double d[8];
    bat_curve_eval_span(curve, span, u, 3, d);
    double speed = bat_hypot(d[2], d[3]), along = d[2] * d[4] + d[3] * d[5];
    double cross = d[2] * d[5] - d[3] * d[4], rise = d[2] * d[7] - d[3] * d[6];
    *slope = rise * speed * speed - 3 * cross * along;
    return speed > 0 ? cross / (speed * speed * speed) : 0;
}

static bool opposite(double a, double b) { return (a > 0 && b < 0) || (a < 0 && b > 0); }

typedef struct walk {
    comb *comb;
    const double *depths;
    zigzag turns[THRESHOLDS];
    double last, sign, slope; /* curvature; the last that was not zero; the last slope that was not */
    bool any;
} walk;

static void step(walk *w, double k, double slope) {
    comb *c = w->comb;
    c->low = fmin(c->low, k);
    c->high = fmax(c->high, k);
    c->peak = fmax(c->peak, fabs(k));
    if (w->any) c->variation += fabs(k - w->last);
    w->any = true;
    w->last = k;
    c->changes += opposite(w->slope, slope);
    if (slope != 0) w->slope = slope;
    for (int j = 0; j < THRESHOLDS && w->depths; j++) follow(&w->turns[j], k, w->depths[j]);
    if (fabs(k) <= 1e-6 * c->peak) return;
    c->inflections += opposite(w->sign, k);
    w->sign = k;
}

/* Visits the places of a span, and where curvature is greatest or least between two of them. */
static void walk_span(walk *w, const bat_curve *curve, int span, double u0, double u1) {
    double before = 0;
    for (int k = 0; k <= DENSE; k++) {
        double u = u0 + (u1 - u0) * k / DENSE, slope, k0 = curvature(curve, span, u, &slope);
        if (k > 0 && opposite(before, slope)) {
            double low = u0 + (u1 - u0) * (k - 1) / DENSE, high = u, middle_slope;
            for (int round = 0; round < 12; round++) {
                double middle = (low + high) / 2;
                curvature(curve, span, middle, &middle_slope);
                if (opposite(before, middle_slope))
                    high = middle;
                else
                    low = middle;
            }
            step(w, curvature(curve, span, low, &middle_slope), 0);
        }
        step(w, k0, slope);
        before = slope;
    }
}

static bool no_worse(const comb *now, const comb *old) {
    bool good = now->inflections <= old->inflections && now->changes <= old->changes &&
                now->peak <= old->peak * (1 + 1e-9) && now->variation <= old->variation * (1 - 1e-4);
    for (int j = 0; j < THRESHOLDS; j++) good = good && now->extrema[j] <= old->extrema[j];
    return good;
}

/* Curvature along the spans that the stretch reaches and one on either side, on both sides of every knot.
 * depths: of the thresholds; NULL: only the range is wanted. old (may be NULL): a curve worse than it is not
 * looked at further. */
static void look(const work *w, const bat_curve *curve, const double *depths, const comb *old, comb *out) {
    walk along = {.comb = out, .depths = depths};
    *out = (comb){.low = INFINITY, .high = -INFINITY};
    int p = curve->degree, from = w->first - 1, to = w->first + w->count + p + 1;
    if (!curve->closed) from = p, to = curve->spread;
    for (int i = from; i < to; i++) {
        double u0 = knot(curve, i), u1 = knot(curve, i + 1), u = u0 / 2 + u1 / 2;
        if (!(u1 > u0) || u1 < w->u[0] - (u1 - u0) || u0 > w->u[1] + (u1 - u0)) continue;
        int turns, span = span_at(curve, &u, &turns);
        walk_span(&along, curve, span, u - (u1 - u0) / 2, u + (u1 - u0) / 2);
        for (int j = 0; j < THRESHOLDS; j++) out->extrema[j] = along.turns[j].turns;
        if (old && !no_worse(out, old)) return;
    }
}

/* ---- the search ---- */

/* (h k)^2 at the places, of the curve as it is expected to become. */
static void bend(work *w, const bat_curve *curve, const double *u) {
    for (int i = 0; i < w->places && curve; i++) {
        double d[8], at = u[i];
        int t, span = span_at(curve, &at, &t);
        bat_curve_eval_span(curve, span, at, 2, d);
        double speed = bat_hypot(d[2], d[3]);
        double k = speed > 0 ? fabs(d[2] * d[5] - d[3] * d[4]) / (speed * speed * speed) : 0;
        k = fmin(k, BEND / w->pixel) * w->step;
        w->bent[i] = k * k;
    }
}

/* Judges the present moves: *best is replaced when the curve they make is no worse than the old one and
 * calmer than *least. */
static bat_status judge(const work *w, const double *depths, const comb *old, double *least, bat_curve **best,
                        bool *better) {
    bat_curve *made = NULL;
    comb now;
    *better = false;
    bat_status status = moved(w, &made);
    if (status != BAT_OK) return status == BAT_MEMORY ? status : BAT_OK; /* out of range: no candidate */
    look(w, made, depths, old, &now);
    *better = no_worse(&now, old) && now.variation < *least;
    bat_curve_free(*better ? *best : made);
    if (!*better) return BAT_OK;
    *best = made;
    *least = now.variation;
    return BAT_OK;
}

/* Searches lambda for the calmest curve; *best is replaced when one is calmer than *least. */
static bat_status search(work *w, const double *depths, const comb *old, double *least, bat_curve **best) {
    double reach = 1.4 * w->wave / (2 * BAT_PI * w->step);
    double high = bat_log(fmin(reach * reach * reach * reach * reach * reach, 1e13)), low = bat_log(1e-3),
           at = high;
    assemble(w);
    for (int round = 0; round < 24; round++) {
        double worst = solve(w, bat_exp(at));
        if (worst > w->limit)
            high = at;
        else if (round == 0 || worst > 0.95 * w->limit)
            break;
        else
            low = at;
        at = (low + high) / 2;
    }
    for (int round = 0; round < 24; round++, at -= bat_log(2)) {
        double worst = solve(w, bat_exp(at));
        if (worst > w->limit) continue;
        if (worst < 1e-3 * w->limit) break;
        bool better;
        bat_status status = judge(w, depths, old, least, best, &better);
        if (status != BAT_OK || better) return status;
    }
    return BAT_OK;
}

/* ---- the whole ---- */

/* The stretch's control points, in the period that it lies in. */
static void reach(work *w) {
    const bat_curve *c = w->curve;
    double u0 = w->u[0], u1 = w->u[1];
    int turns0, turns1, span0 = span_at(c, &u0, &turns0), span1 = span_at(c, &u1, &turns1);
    w->first = span0 + turns0 * c->count - c->degree;
    w->count = span1 + turns1 * c->count - w->first + 1;
    if (c->closed && w->count > c->count + c->degree) w->count = c->count + c->degree;
}

/* A stretch too short to move two control points is extended to the next knots. */
static bat_status settle(work *w) {
    const bat_curve *c = w->curve;
    double start = c->knots[c->degree], end = c->knots[c->spread], most = 0.9 * (end - start);
    for (int round = 0; round < 4 * BAT_DEGREE_MAX; round++) {
        reach(w);
        if (assign(w) >= 2) return BAT_OK;
        int first = w->first + c->degree, last = w->first + w->count; /* knots beside the stretch */
        double u[2] = {knot(c, first), knot(c, last)};
        for (int k = 1; k <= c->degree + 1 && u[0] >= w->u[0]; k++) u[0] = knot(c, first - k);
        for (int k = 1; k <= c->degree + 1 && u[1] <= w->u[1]; k++) u[1] = knot(c, last + k);
        if (!c->closed) u[0] = fmax(u[0], start), u[1] = fmin(u[1], end);
        if ((u[0] >= w->u[0] && u[1] <= w->u[1]) || (c->closed && u[1] - u[0] > most)) break;
        w->u[0] = fmin(u[0], w->u[0]);
        w->u[1] = fmax(u[1], w->u[1]);
    }
    return w->unknowns > 0 ? BAT_OK : BAT_STATE;
}

/* Places along the stretch and three steps beyond; *u is theirs. */
static bat_status place(work *w, const bat_stroke_track *track, double *u) {
    double s0 = bat_track_s(track, w->u[0]), s1 = bat_track_s(track, w->u[1]), length = s1 - s0;
    if (!(length > 8 * w->pixel)) return BAT_STATE;
    w->step = fmax(length / PLACES, fmin(2 * w->pixel, length / 48));
    const double stretch[2] = {s0, s1},
                 core[2] = {bat_track_s(track, w->core[0]), bat_track_s(track, w->core[1])};
    s0 -= 3 * w->step, s1 += 3 * w->step;
    if (!w->curve->closed) s0 = fmax(s0, 0), s1 = fmin(s1, track->length);
    w->wave = core[1] - core[0];
    w->places = (int)floor((s1 - s0) / w->step) + 1;
    if (w->places > PLACES + 8) w->places = PLACES + 8;
    w->step = (s1 - s0) / (w->places - 1);
    for (int i = 0; i < w->places; i++) {
        double s = s0 + w->step * i;
        u[i] = bat_track_u(track, s);
        double out = s < core[0]   ? (core[0] - s) / (core[0] - stretch[0])
                     : s > core[1] ? (s - core[1]) / (stretch[1] - core[1])
                                   : 0;
        double in = fmin(fmax(1 - out, 0), 1);
        w->weight[i] = in * in * (3 - 2 * in);
        if (!w->curve->closed) u[i] = bat_curve_reduce(w->curve, u[i]);
        make_row(w, u[i], &w->from[i], w->row + (size_t)i * WIDTH, w->at + 2 * (size_t)i);
    }
    int width = widest(w);
    w->band = width - 1;
    return width <= WIDTH ? BAT_OK : BAT_STATE;
}

/* The stretch fades out over the knots beside it. */
static void widen(work *w) {
    const bat_curve *c = w->curve;
    double u[2] = {w->u[0], w->u[1]}, period = c->knots[c->spread] - c->knots[c->degree];
    int turns[2], spans[2];
    memcpy(w->core, w->u, sizeof w->core);
    for (int k = 0; k < 2; k++) spans[k] = span_at(c, &u[k], &turns[k]) + turns[k] * c->count;
    double low = knot(c, spans[0] - c->degree), high = knot(c, spans[1] + 1 + c->degree);
    if (!c->closed) low = fmax(low, c->knots[c->degree]), high = fmin(high, c->knots[c->spread]);
    double spare = c->closed ? 0.9 * period - (w->u[1] - w->u[0]) : INFINITY;
    w->u[0] = fmax(fmin(low, w->u[0]), w->u[0] - spare / 2);
    w->u[1] = fmin(fmax(high, w->u[1]), w->u[1] + spare / 2);
}

static bat_status calm(work *w, const bat_stroke_track *track, double *u, bat_curve **best) {
    widen(w);
    bat_status status = settle(w);
    if (status == BAT_OK) status = place(w, track, u);
    if (status != BAT_OK) return status;
    comb old;
    double depths[THRESHOLDS];
    look(w, w->curve, NULL, NULL, &old);
    for (int j = 0; j < THRESHOLDS; j++)
        depths[j] = fmax(THRESHOLD[j] * (old.high - old.low), 1e-7 * old.peak);
    look(w, w->curve, depths, NULL, &old);
    double least = old.variation;
    memset(w->bent, 0, (size_t)w->places * sizeof *w->bent);
    assemble(w);
    for (int pass = 0; pass < 2 && status == BAT_OK && !*best; pass++) {
        if (pass) bend(w, *best ? *best : w->curve, u);
        status = search(w, depths, &old, &least, best);
    }
    return status == BAT_OK && !*best ? BAT_STATE : status;
}

bat_status bat_sketch_calm(const bat_curve *curve, const double range[2], double limit, double pixel,
                           bat_curve **out) {
    if (!curve || !range || !out || !(range[0] < range[1]) || !(limit > 0) || !(pixel > 0))
        return BAT_ARGUMENT;
    if (!isfinite(range[0]) || !isfinite(range[1]) || !isfinite(limit) || !isfinite(pixel)) return BAT_NUMBER;
    if (curve->dimension != 2) return BAT_DIMENSION;
    if (curve->degree < 2) return BAT_STATE;
    double start = curve->knots[curve->degree], end = curve->knots[curve->spread];
    work w = {.curve = curve, .u = {range[0], range[1]}, .pixel = pixel, .limit = limit};
    if (curve->closed) { /* the opposite part has to stay and hold it */
        double middle = range[0] / 2 + range[1] / 2,
               half = fmin((range[1] - range[0]) / 2, 0.45 * (end - start));
        w.u[0] = middle - half, w.u[1] = middle + half;
    } else {
        w.u[0] = fmax(range[0], start), w.u[1] = fmin(range[1], end);
        if (!(w.u[0] < w.u[1])) return BAT_PARAMETER;
    }
    size_t points = (size_t)(curve->count + 2 * curve->degree + 2), places = PLACES + 8;
    size_t doubles = points * (1 + 3 * WIDTH + 4) + places * (WIDTH + 5);
    double *block = malloc(doubles * sizeof *block);
    w.unknown = malloc((points + places) * sizeof *w.unknown);
    w.roles = malloc(points * sizeof *w.roles);
    bat_stroke_track track = {0};
    bat_curve *best = NULL;
    bat_status status = block && w.unknown && w.roles ? bat_track_create(curve, &track) : BAT_MEMORY;
    if (status == BAT_OK) {
        w.share = block;
        w.fit = w.share + points, w.fair = w.fit + points * WIDTH, w.sum = w.fair + points * WIDTH;
        w.pull = w.sum + points * WIDTH, w.move = w.pull + 2 * points, w.row = w.move + 2 * points;
        w.at = w.row + places * WIDTH, w.bent = w.at + 2 * places, w.weight = w.bent + places;
        w.from = w.unknown + points;
        status = calm(&w, &track, w.weight + places, &best);
        bat_track_free(&track);
    }
    free(block);
    free(w.unknown);
    free(w.roles);
    if (status == BAT_OK)
        *out = best;
    else
        bat_curve_free(best);
    return status;
}
