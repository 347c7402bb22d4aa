/* A close fit first; then, if asked, the tolerance is spent (docs/math sketch 5.7). */
#include "hands/sketch/fit_interval.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double softer = 1.0 / 64, shortest_span = 0.5;
/* The close fit leaves the stroke by this share of the tolerance at most, if so many rounds are enough for it; beside
 * transitions, in px, by more. */
static const double closeness = 0.15, closeness_shy = 0.35, shy = 24;
enum { CLOSE_ROUNDS = 3 };

static bool set_add(bat_knot_set *set, int room, double w, bool fixed) {
    if (set->count >= room) return false;
    set->w[set->count] = w;
    set->fixed[set->count++] = fixed;
    return true;
}

/* Even spans between the ends and the corners. The last one is the shorter: where a stroke has been its knots stay. */
static void start_knots(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree;
    bat_knot_set *set = &k->best;
    set->count = 0;
    for (int c = 0; c <= q->fixed_count; c++) {
        const double from = c == 0 ? 0 : q->fixed[c - 1], to = c == q->fixed_count ? q->end : q->fixed[c];
        double step = fmax(q->span, (to - from) / ((double)q->count / 3 + 2));
        if (q->fixed_count == 0) step = fmin(step, (to - from) / (bat_local_fewest(q) + 2));
        for (int i = 1; from + step * (i + 0.5) < to; i++) set_add(set, k->room - p, from + step * i, false);
        for (int i = 0; i < p && c < q->fixed_count; i++) set_add(set, k->room, to, true);
    }
}

/* Splits every span with a failing sample into k->trial; spans finer than the wavelength get less penalty
 * too. Returns whether anything changed. */
static bool split_failing(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree, slots = bat_lsq_slots(&k->space);
    const double *t = k->space.knots + p;
    bat_knot_set *next = &k->trial;
    const bat_knot_set *now = &k->best;
    next->count = 0;
    bool changed = false;
    size_t window = 0; /* first sample that the softening of this slot reaches */
    for (int s = 0; s < slots; s++) {
        if (s >= 1) { /* knot at the start of slot s is interior knot s - 1 */
            next->w[next->count] = now->w[s - 1];
            next->fixed[next->count++] = now->fixed[s - 1];
        }
        const double h = t[s + 1] - t[s];
        if (!(h > 0)) continue;
        bool fails = false;
        for (size_t i = k->first[s]; i < k->first[s + 1] && !fails; i++) fails = bat_local_fails(k, i);
        if (!fails) continue;
        const double v = q->law[k->first[s] < q->count ? k->first[s] : q->count - 1];
        if (h * v < q->wavelength) {
            while (window < q->count && q->w[window] <= t[s] - q->wavelength) window++;
            for (size_t i = window; i < q->count && q->w[i] < t[s + 1] + q->wavelength; i++)
                if (k->soft[i] > 1e-9 && k->soft[i] <= 1) {
                    k->soft[i] *= -softer; /* negative: done in this round */
                    changed = true;
                }
        }
        if (h * v > 2 * shortest_span && k->first[s + 1] - k->first[s] > 1 &&
            next->count + slots - s + 1 < k->room) {
            next->w[next->count] = t[s] + 0.5 * h;
            next->fixed[next->count++] = 0;
            changed = true;
        }
    }
    for (size_t i = 0; i < q->count; i++) k->soft[i] = fabs(k->soft[i]);
    return changed;
}

/* Samples where the dense fit already leaves the speed law are not held to it later. */
static void mark_wild(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree, m = q->dimension;
    const double *t = k->space.knots + p;
    for (int s = 0; s < bat_lsq_slots(&k->space); s++) {
        const double half = 0.5 * (t[s + 1] - t[s]);
        if (!(half > 0)) continue;
        const double *local = k->local + (size_t)s * (size_t)((p + 1) * m);
        for (size_t i = k->first[s]; i < k->first[s + 1]; i++) {
            const double x = (q->w[i] - t[s]) / half - 1;
            double v2 = 0;
            for (int c = 0; c < m; c++) {
                double d = 0;
                for (int j = p; j >= 1; j--) d = d * x + j * local[j * m + c];
                v2 += d * d;
            }
            const double ratio = sqrt(v2) / (q->law[i] * half);
            k->wild[i] = !(ratio > BAT_SLOWEST * 1.1 && ratio < BAT_FASTEST / 1.1);
        }
    }
}

/* The share of the tolerance by which the close fit may leave a sample: more beside an open transition, which must not be
 * told the pen's direction there, for that is noise. */
static double closeness_at(const bat_local_problem *q, size_t i) {
    double away = INFINITY;
    if (q->first > 0 && !(q->weight[q->first - 1] > 0)) away = q->w[i] - q->w[q->first];
    if (q->last + 1 < q->count && !(q->weight[q->last + 1] > 0)) away = fmin(away, q->w[q->last] - q->w[i]);
    away = fmax(away * q->law[i], 0) / shy;
    return away < 1 ? closeness + (closeness_shy - closeness) * (1 - away) : closeness;
}

/* Splits spans until the fit is close; *far: it is not even within the tolerance. */
static bat_status fit_close(bat_local_machine *k, bool *far) {
    const bat_local_problem *q = k->problem;
    bat_status status = BAT_OK;
    double least = INFINITY;
    for (size_t i = 0; i < q->count; i++) {
        const double limit = closeness_at(q, i) * q->allowed[i];
        k->limit[i] = q->weight[i] > 0 ? limit * limit : INFINITY;
    }
    start_knots(k);
    bat_knot_set_copy(&k->spare, &k->best);
    for (int round = 0; round < 24; round++) {
        bat_local_try(k, &k->best, &status);
        if (status == BAT_SINGULAR && k->ridge == 0) { /* too few samples somewhere: hold still there */
            k->ridge = 1e-10;
            bat_local_try(k, &k->best, &status);
        }
        if (status != BAT_OK) break;
        const double ratio = bat_local_worst(k); /* the speed law binds only what follows */
        if (ratio < least) least = ratio, bat_knot_set_copy(&k->spare, &k->best);
        const bool enough = round >= CLOSE_ROUNDS && ratio * closeness * closeness <= 1;
        if (ratio <= 1 || enough || !split_failing(k)) break;
        bat_knot_set_copy(&k->best, &k->trial);
    }
    if (status == BAT_OK || least < INFINITY) { /* a later round may fail where an earlier one did not */
        bat_knot_set_copy(&k->best, &k->spare);
        bat_local_try(k, &k->best, &status);
        *far = bat_local_worst(k) * closeness * closeness > 1;
    }
    return status;
}

/* What the tolerance allows goes into fairness, and into fewer knots. */
static bat_status spend(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    bat_status status = BAT_OK;
    for (size_t i = 0; i < q->count; i++) {
        const double limit = q->tube * q->allowed[i];
        k->limit[i] = fmax(limit * limit, 1.1 * k->distance[i]);
    }
    mark_wild(k);
    if (bat_fair_find(k, &status) && bat_fair_few(k, &status)) return BAT_OK;
    if (status != BAT_OK) return status;
    bat_local_try(k, &k->best, &status);
    k->holds_best = true;
    return status == BAT_OK ? bat_local_reduce(k) : status;
}

/* Samples without weight lie where the close fit went. */
static void fill_open(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree, m = q->dimension;
    const double *t = k->space.knots + p;
    for (int s = 0; s < bat_lsq_slots(&k->space); s++)
        for (size_t i = k->first[s]; i < k->first[s + 1]; i++) {
            if (q->weight[i] > 0) continue;
            const double half = 0.5 * (t[s + 1] - t[s]), x = half > 0 ? (q->w[i] - t[s]) / half - 1 : 0;
            const double *local = k->local + (size_t)s * (size_t)((p + 1) * m);
            for (int c = 0; c < m; c++) {
                double value = 0;
                for (int j = p; j >= 0; j--) value = value * x + local[j * m + c];
                q->x[i * (size_t)m + (size_t)c] = value;
            }
            k->distance[i] = 0;
        }
}

static bat_status hand_over(bat_local_machine *k, bool far, bat_local_result *out) {
    const bat_local_problem *q = k->problem;
    const size_t knots = (size_t)k->best.count * sizeof(double);
    const size_t points = (size_t)k->space.count * (size_t)q->dimension * sizeof(double);
    out->interior = k->best.count;
    out->knots = malloc(knots + sizeof(double));
    out->points = malloc(points);
    if (!out->knots || !out->points) {
        bat_local_result_free(out);
        return BAT_MEMORY;
    }
    memcpy(out->knots, k->best.w, knots);
    memcpy(out->points, k->points, points);
    for (size_t i = q->first; i <= q->last && i < q->count; i++)
        out->max_error = fmax(out->max_error, sqrt(k->distance[i]));
    out->solves = k->solves;
    out->met = !far;
    return BAT_OK;
}

bat_status bat_local_fit(const bat_local_problem *q, bat_local_result *out) {
    memset(out, 0, sizeof *out);
    bat_local_machine machine, *k = &machine;
    if (!bat_local_machine_make(k, q)) {
        bat_local_machine_free(k);
        return BAT_MEMORY;
    }
    bool far = true;
    bat_status status = fit_close(k, &far);
    if (status == BAT_OK) fill_open(k);
    if (status == BAT_OK && q->spend) status = spend(k);
    k->exact = true;
    if (status == BAT_OK) bat_local_try(k, &k->best, &status);
    if (status == BAT_OK) status = hand_over(k, far, out);
    bat_local_machine_free(k);
    return status;
}

void bat_local_result_free(bat_local_result *result) {
    free(result->knots);
    free(result->points);
    memset(result, 0, sizeof *result);
}
