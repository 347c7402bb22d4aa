/* One solve of the interval's least-squares problem for knots that are given, and how far it is off. */
#include "hands/sketch/fit_interval.h"
#include "curve/banded.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void bat_knots_copy(bat_knot_set *to, const bat_knot_set *from) {
    to->count = from->count;
    memcpy(to->w, from->w, (size_t)from->count * sizeof *to->w);
    memcpy(to->fixed, from->fixed, (size_t)from->count);
}

int bat_local_fewest(const bat_local_problem *q) {
    const int p = q->degree;
    if (q->closed) return p;
    const int least = q->side[0].pins + q->side[1].pins - p - 1;
    return least > 0 ? least : 0;
}

/* The knots of the interval as one spline space. */
static void build(bat_local_machine *k, const bat_knot_set *set) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree;
    struct bat_curve *space = &k->space;
    double *t = space->knots;
    if (q->closed) {
        space->count = set->count + 1, space->spread = space->count + p;
        t += p;
        t[0] = 0;
        memcpy(t + 1, set->w, (size_t)set->count * sizeof *t);
        const int n = space->count;
        t[n] = q->end;
        for (int i = 1; i <= p; i++) t[n + i] = t[n + i - n] + q->end;
        for (int i = 1; i <= p; i++) t[-i] = t[n - i] - q->end;
        return;
    }
    space->count = space->spread = set->count + p + 1;
    t[0] = q->side[0].outer[0];
    memcpy(t + 1, q->side[0].outer, (size_t)p * sizeof *t);
    memcpy(t + p + 1, set->w, (size_t)set->count * sizeof *t);
    memcpy(t + p + 1 + set->count, q->side[1].outer, (size_t)p * sizeof *t);
    t[2 * p + 1 + set->count] = q->side[1].outer[p - 1];
}

void bat_local_pins(const bat_local_problem *q, int side, int interior, const double *knots, double *pins) {
    const int p = q->degree;
    const size_t m = (size_t)q->dimension;
    const bat_local_side *s = &q->side[side];
    if (s->pins == 0) return;
    if (!s->curve) {
        memcpy(pins, s->point, m * sizeof *pins);
        return;
    }
    /* knots: the whole local vector, as build lays it out. The left pins are its first control points. */
    for (int i = 0; i < s->pins; i++) {
        const int index = side == 0 ? i : interior + p + 1 - s->pins + i;
        double arguments[BAT_DEGREE_MAX];
        for (int j = 0; j < p; j++) arguments[j] = s->base + (knots[index + 1 + j] - s->at) / s->rate;
        bat_curve_blossom_span(s->curve, s->span, arguments, pins + (size_t)i * m);
    }
}

/* Moves a known unknown to the right-hand side. */
static void pin(double *a, double *b, int n, int band, size_t m, int index, const double *value) {
    const size_t w = (size_t)band + 1;
    for (int d = 1; d <= band; d++) {
        if (index + d < n) {
            double *entry = a + (size_t)(index + d) * w + (size_t)d;
            for (size_t c = 0; c < m; c++) b[(size_t)(index + d) * m + c] -= *entry * value[c];
            *entry = 0;
        }
        if (index - d >= 0) {
            double *entry = a + (size_t)index * w + (size_t)d;
            for (size_t c = 0; c < m; c++) b[(size_t)(index - d) * m + c] -= *entry * value[c];
            *entry = 0;
        }
    }
    a[(size_t)index * w] = 1;
    memcpy(b + (size_t)index * m, value, m * sizeof *b);
}

/* The penalty's factor for each slot: v^-5, so that a wavelength in pixels means the same at every speed. */
static void factors(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int slots = bat_lsq_slots(&k->space);
    for (int s = 0; s < slots; s++) {
        size_t from = k->first[s], to = k->first[s + 1];
        if (from >= q->count) from = q->count - 1;
        if (to <= from) to = from + 1;
        double soft = k->soft[from];
        for (size_t i = from; i < to; i++) soft = k->soft[i] < soft ? k->soft[i] : soft; /* fmin is a call */
        const double v = q->law[from + (to - from) / 2], v2 = v * v;
        k->factor[s] = soft / (v2 * v2 * v);
    }
}

static bool speed_kept(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree, m = q->dimension, slots = bat_lsq_slots(&k->space);
    const double *t = k->space.knots + p;
    k->slow_count = 0;
    for (int s = 0; s < slots; s++) {
        if (!(t[s + 1] > t[s])) continue;
        const double half = 0.5 * (t[s + 1] - t[s]);
        const double *local = k->local + (size_t)s * (size_t)((p + 1) * m);
        const size_t from = k->first[s], to = k->first[s + 1];
        if (to <= from) continue;
        for (int place = 0; place < 3; place++) {
            /* At a sample's own place: where it is wild, it must be found to be so. */
            const size_t i = from + (size_t)((0.125 + 0.375 * place) * (double)(to - from - 1) + 0.5);
            const double x = (q->w[i] - t[s]) / half - 1;
            if (k->wild[i]) continue;
            double v2 = 0;
            for (int c = 0; c < m; c++) {
                double d = 0;
                for (int j = p; j >= 1; j--) d = d * x + j * local[j * m + c];
                v2 += d * d;
            }
            const double want = q->law[i] * half;
            if (v2 < BAT_LOCAL_SLOWEST * BAT_LOCAL_SLOWEST * want * want ||
                v2 > BAT_LOCAL_FASTEST * BAT_LOCAL_FASTEST * want * want) {
                k->slow[k->slow_count++] = q->w[i];
                break; /* one place per span is enough */
            }
        }
    }
    return k->slow_count == 0;
}

/* The normal equations of the knots. What belongs to spans whose knots stayed is kept from the solve before. */
static void assemble(bat_local_machine *k, const bat_knot_set *set) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree, m = q->dimension;
    build(k, set);
    const int n = k->space.count;
    memset(k->a, 0, (size_t)n * (size_t)(p + 1) * sizeof *k->a);
    memset(k->b, 0, (size_t)n * (size_t)m * sizeof *k->b);
    bat_lsq_ranges(&k->space, q->count, q->w, k->first);
    factors(k);
    const bat_lsq_memo last = k->memo[1];
    k->memo[1] = k->memo[0], k->memo[0] = last;
    bat_lsq_memo_fill(&k->space, m, k->first, q->w, k->data, q->weight, &k->memo[1], true, &k->memo[0]);
    bat_lsq_memo_add(&k->space, m, &k->memo[0], k->a, k->b);
    const double omega = q->wavelength / (2 * BAT_PI), mu = omega * omega * omega;
    if (k->bent)
        bat_local_energy(k, k->stiffness * mu * mu);
    else
        bat_lsq_memo_penalty(&k->space, 3, k->stiffness * mu * mu, k->factor, &k->memo[0], k->a);
    if (k->ridge > 0)
        for (int i = 0; i < n; i++) {
            double *diagonal = k->a + (size_t)i * (size_t)(p + 1);
            *diagonal += k->ridge * (*diagonal + 1e-3);
        }
}

static bat_status solve(bat_local_machine *k, const bat_knot_set *set) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree, m = q->dimension, n = k->space.count;
    bat_status status;
    if (q->closed) {
        status = bat_cyclic_factor(k->a, n, p, k->border);
        if (status == BAT_OK) bat_cyclic_solve(k->a, n, p, k->border, k->b, m);
        return status;
    }
    double pins[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    for (int side = 0; side < 2; side++) {
        bat_local_pins(q, side, set->count, k->space.knots, pins);
        const int count = q->side[side].pins, from = side == 0 ? 0 : n - count;
        for (int i = 0; i < count; i++) pin(k->a, k->b, n, p, (size_t)m, from + i, pins + i * m);
    }
    status = bat_banded_factor(k->a, n, p);
    if (status == BAT_OK) bat_banded_solve(k->a, n, p, k->b, m);
    return status;
}

/* The worst sample by the plain distances, projected: tells soonest that there is no hope. */
static bool beyond_hope(const bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    size_t worst = 0;
    double most = 0, distance;
    for (size_t i = 0; i < q->count; i++)
        if (k->distance[i] > most * k->limit[i]) most = k->distance[i] / k->limit[i], worst = i;
    if (!(most > k->hope)) return false;
    bat_lsq_error(&k->space, q->dimension, k->local, 1, q->w + worst, k->x + worst * (size_t)q->dimension, 2,
                  NULL, &distance);
    return distance > k->hope * k->limit[worst];
}

/* Most samples are at their own parameter; only the others are projected. */
bool bat_local_measure(bat_local_machine *k, bat_status *status) {
    const bat_local_problem *q = k->problem;
    const int m = q->dimension;
    if (k->exact)
        bat_lsq_error(&k->space, m, k->local, q->count, q->w, k->x, 2, NULL, k->distance);
    else
        bat_lsq_plain(&k->space, m, k->local, k->first, q->w, k->x, k->distance);
    k->given_up = k->hope < INFINITY && beyond_hope(k);
    bool fine = !k->given_up;
    for (size_t i = 0; i < q->count && !k->given_up;) {
        if (!bat_local_fails(k, i)) {
            i++;
            continue;
        }
        const size_t from = i;
        while (i < q->count && bat_local_fails(k, i)) i++;
        k->sought += (double)(i - from);
        if (!k->exact)
            bat_lsq_error(&k->space, m, k->local, i - from, q->w + from, k->x + from * (size_t)m, 2, NULL,
                          k->distance + from);
        for (size_t j = from; j < i; j++) {
            fine = fine && !bat_local_fails(k, j);
            if (!(k->distance[j] < INFINITY)) *status = BAT_NUMBER;
            k->given_up |= k->distance[j] > k->hope * k->limit[j];
        }
    }
    return fine;
}

bool bat_local_try(bat_local_machine *k, const bat_knot_set *set, bat_status *status) {
    const bat_local_problem *q = k->problem;
    const int m = q->dimension;
    k->slow_count = 0;
    k->holds_best = false; /* also where it cannot be solved: the space is another one from here on */
    assemble(k, set);
    k->solves++;
    k->work += bat_local_cost(k, k->space.count);
    *status = solve(k, set);
    if (*status != BAT_OK) return false;
    memcpy(k->points, k->b, (size_t)k->space.count * (size_t)m * sizeof *k->points);
    bat_lsq_memo_local(&k->space, m, &k->memo[0], k->points, k->local);
    const bool fine = bat_local_measure(k, status);
    return *status == BAT_OK && fine && speed_kept(k);
}
