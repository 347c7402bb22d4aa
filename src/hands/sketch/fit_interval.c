#include "hands/sketch/fit_interval.h"
#include "curve/banded.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double softer = 1.0 / 64, shortest_span = 0.5;
static const double work_dense = 3e5; /* some 8 ms: what is not met by then counts as missed */

static const double finest = 0.4; /* spans shorter than this share of the waves followed are not split */

static bool set_add(bat_knot_set *set, int room, double w, bool fixed) {
    if (set->count >= room) return false;
    set->w[set->count] = w;
    set->fixed[set->count++] = fixed;
    return true;
}

/* Even spans between the ends and the corners, no more than there are samples for. */
static void start_knots(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree;
    bat_knot_set *set = &k->best;
    set->count = 0;
    for (int c = 0; c <= q->fixed_count; c++) {
        const double from = c == 0 ? 0 : q->fixed[c - 1], to = c == q->fixed_count ? q->end : q->fixed[c];
        const double samples = (double)q->count * (to - from) / q->end; /* about */
        int pieces = (int)fmin(ceil((to - from) / q->span),
                               q->fixed_count > 0 ? samples + 2 : samples / 3 + 2);
        if (pieces < 1) pieces = 1;
        if (q->fixed_count == 0 && pieces < bat_local_fewest(q) + 2) pieces = bat_local_fewest(q) + 2;
        for (int i = 1; i < pieces; i++) set_add(set, k->room - p, from + (to - from) * i / pieces, false);
        for (int i = 0; i < p && c < q->fixed_count; i++) set_add(set, k->room, to, true);
    }
}

/* The first sample beyond w. */
static size_t first_after(const bat_local_problem *q, double w) {
    size_t low = 0, high = q->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (q->w[middle] <= w)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The shortest wave that is followed where the penalty has this factor, px. */
static double wave_for(const bat_local_machine *k, double soft) {
    return k->problem->wavelength * bat_exp(bat_log(soft) / 6);
}

/* Softens the penalty near a slot that fails: the waves followed there become half as long. */
static bool soften(bat_local_machine *k, double from, double to, double reach) {
    const bat_local_problem *q = k->problem;
    bool changed = false;
    size_t i = first_after(q, from - reach);
    for (; i < q->count && q->w[i] < to + reach; i++)
        if (k->soft[i] > 1e-9) {
            k->soft[i] *= -softer; /* negative: done in this round */
            changed = true;
        }
    return changed;
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
    double soft = 1, followed = q->wavelength; /* of the last failing sample: few values occur */
    for (int s = 0; s < slots; s++) {
        if (s >= 1) { /* knot at the start of slot s is interior knot s - 1 */
            next->w[next->count] = now->w[s - 1];
            next->fixed[next->count++] = now->fixed[s - 1];
        }
        const double h = t[s + 1] - t[s];
        if (!(h > 0)) continue;
        size_t i = k->first[s];
        while (i < k->first[s + 1] && !bat_local_fails(k, i)) i++;
        if (i == k->first[s + 1]) continue;
        const double v = q->law[i];
        if (fabs(k->soft[i]) != soft) soft = fabs(k->soft[i]), followed = wave_for(k, soft);
        double wave = followed;
        if (h * v < wave) changed |= soften(k, t[s], t[s + 1], wave / v), wave /= 2;
        if (h * v > finest * wave && h * v > 2 * shortest_span && k->first[s + 1] - k->first[s] > 1 &&
            next->count + slots - s + 1 < k->room) {
            next->w[next->count] = t[s] + 0.5 * h;
            next->fixed[next->count++] = 0;
            changed = true;
        }
    }
    for (size_t i = 0; i < q->count; i++) k->soft[i] = fabs(k->soft[i]);
    return changed;
}

static double worst_ratio(const bat_local_machine *k) {
    double worst = 0;
    for (size_t i = 0; i < k->problem->count; i++) {
        const double ratio = k->distance[i] / k->limit[i];
        if (ratio > worst) worst = ratio;
    }
    return worst;
}

static bool misses(const bat_local_machine *k) {
    const double *allowed = k->problem->allowed;
    for (size_t i = 0; i < k->problem->count; i++)
        if (!(k->distance[i] <= allowed[i] * allowed[i])) return true;
    return false;
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
            k->wild[i] = !(ratio > BAT_LOCAL_SLOWEST * 1.1 && ratio < BAT_LOCAL_FASTEST / 1.1);
        }
    }
}

static void machine_free(bat_local_machine *k) {
    free(k->space.knots);
    free(k->remembered);
    free(k->a);
    free(k->b);
    free(k->local);
    free(k->factor);
    free(k->border);
    free(k->rank);
    free(k->slow);
    free(k->first);
    free(k->shape);
    free(k->aim);
    free(k->bend);
    free(k->pull);
    free(k->need);
    free(k->spread);
    free(k->curvature);
    free(k->limit);
    free(k->distance);
    free(k->soft);
    free(k->wild);
    free(k->points);
    bat_knot_set *sets[3] = {&k->best, &k->trial, &k->spare};
    for (int i = 0; i < 3; i++) {
        free(sets[i]->w);
        free(sets[i]->fixed);
    }
}

static bool machine_make(bat_local_machine *k, const bat_local_problem *q) {
    memset(k, 0, sizeof *k);
    k->problem = q, k->stiffness = 1, k->hope = INFINITY, k->x = k->data = q->x;
    const int p = q->degree;
    k->room = (int)fmin(2 * (double)q->count + 32, 1 << 22) + q->fixed_count * p;
    const size_t n = (size_t)(k->room + 2 * p + 4), m = (size_t)q->dimension;
    k->space.degree = p, k->space.dimension = q->dimension, k->space.closed = q->closed;
    k->space.knots = calloc(n + (size_t)(2 * p), sizeof(double));
    const size_t memo = bat_lsq_memo_size(p, q->dimension, n);
    k->remembered = malloc(2 * memo * sizeof(double));
    for (size_t i = 0; i < 2 && k->remembered; i++)
        bat_lsq_memo_place(&k->memo[i], p, q->dimension, n, k->remembered + i * memo);
    k->a = malloc(n * (size_t)(p + 1) * sizeof(double));
    k->b = malloc(n * m * sizeof(double));
    k->points = malloc(n * m * sizeof(double));
    k->local = malloc(n * (size_t)(p + 1) * m * sizeof(double));
    k->factor = malloc(n * sizeof(double));
    k->rank = malloc((n + 1) * sizeof(double));
    k->slow = malloc((n + 1) * sizeof(double));
    k->border = q->closed ? malloc((n * (size_t)p + BAT_CYCLIC_DENSE) * sizeof(double)) : NULL;
    k->first = malloc((n + 1) * sizeof *k->first);
    k->shape = malloc(q->count * m * sizeof(double));
    k->aim = malloc(q->count * m * sizeof(double));
    k->pull = malloc(q->count * m * sizeof(double));
    k->bend = malloc(q->count * sizeof(double));
    k->need = malloc(q->count * sizeof(double));
    k->spread = malloc(BAT_LOCAL_DENSITIES * q->count * sizeof(double));
    k->curvature = malloc(q->count * sizeof(double));
    k->limit = malloc(q->count * sizeof(double));
    k->distance = malloc(q->count * sizeof(double));
    k->soft = malloc(q->count * sizeof(double));
    k->wild = calloc(q->count, 1);
    bool fine = k->space.knots && k->remembered && k->a && k->b && k->points && k->local && k->factor &&
                k->rank && k->slow && k->first && k->shape && k->aim && k->bend && k->pull && k->need &&
                k->spread && k->curvature && k->limit && k->distance && k->soft && k->wild &&
                (!q->closed || k->border);
    bat_knot_set *sets[3] = {&k->best, &k->trial, &k->spare};
    for (int i = 0; i < 3; i++) {
        sets[i]->w = malloc(n * sizeof(double));
        sets[i]->fixed = malloc(n);
        fine = fine && sets[i]->w && sets[i]->fixed;
    }
    if (!fine) return false;
    for (size_t i = 0; i < q->count; i++) {
        const double tight = q->allowed[i] - bat_local_spare(q, i);
        k->limit[i] = tight * tight;
        k->soft[i] = 1;
    }
    return true;
}

enum { MOST_FAIRED = 300 }; /* knots of the dense fit: fairing takes a few dozen solves */

/* From the dense fit to few knots. */
static bat_status make_few(bat_local_machine *k) {
    bat_status status = BAT_OK;
    if (k->missed || k->best.count > MOST_FAIRED) { /* by the samples themselves */
        for (size_t i = 0; i < k->problem->count; i++) {
            const double allowed = k->problem->allowed[i];
            k->limit[i] = fmax(allowed * allowed, 1.05 * k->distance[i]);
        }
        return bat_local_reduce(k);
    }
    bat_local_take_shape(k);
    status = bat_local_fair(k);
    if (status == BAT_OK) status = bat_local_reduce(k);
    if (status == BAT_OK && k->data == k->aim) status = bat_local_few(k);
    if (status == BAT_OK) status = bat_local_stiffen(k, 3);
    return status;
}

/* Solves for k->best; where samples are too few, with a ridge that holds it still. */
static bat_status try_best(bat_local_machine *k) {
    bat_status status;
    bat_local_try(k, &k->best, &status);
    if (status == BAT_SINGULAR && k->ridge == 0) {
        k->ridge = 1e-10;
        bat_local_try(k, &k->best, &status);
    }
    return status;
}

/* Splits spans until every sample is within its limit or the work is done. The best of the solves stays. */
static bat_status fit_densely(bat_local_machine *k) {
    bat_status status = BAT_OK;
    double least = INFINITY;
    bool again = false; /* the last solve is not the best one */
    start_knots(k);
    bat_knots_copy(&k->spare, &k->best);
    for (int round = 0; round < 24; round++) {
        status = try_best(k);
        again = true;
        if (status != BAT_OK) break;
        const double ratio = worst_ratio(k);
        const bool met = ratio <= 1; /* the speed law binds the removal only */
        if (ratio < least) least = ratio, again = false, bat_knots_copy(&k->spare, &k->best);
        if (met || bat_local_enough(k, work_dense)) break;
        again = true; /* splitting softens the penalty */
        if (!split_failing(k) || k->work + bat_local_cost(k, k->trial.count) > work_dense) break;
        bat_knots_copy(&k->best, &k->trial);
    }
    if (status != BAT_OK && !(least < INFINITY)) return status;
    bat_knots_copy(&k->best, &k->spare); /* a later round may fail where an earlier one did not */
    if (again) bat_local_try(k, &k->best, &status);
    k->holds_best = status == BAT_OK;
    k->missed = misses(k);
    if (status == BAT_OK) mark_wild(k);
    return status;
}

bat_status bat_local_fit(const bat_local_problem *q, bat_local_result *out) {
    memset(out, 0, sizeof *out);
    bat_local_machine machine, *k = &machine;
    if (!machine_make(k, q)) {
        machine_free(k);
        return BAT_MEMORY;
    }
    bat_status status = fit_densely(k);
    if (status == BAT_OK && q->remove) status = make_few(k);
    k->exact = true, k->x = q->x;
    if (status == BAT_OK && k->holds_best)
        bat_local_measure(k, &status);
    else if (status == BAT_OK)
        bat_local_try(k, &k->best, &status);
    if (status == BAT_OK) {
        const int n = k->space.count;
        out->interior = k->best.count;
        out->knots = malloc((size_t)(k->best.count + 1) * sizeof(double));
        out->points = malloc((size_t)n * (size_t)q->dimension * sizeof(double));
        if (out->knots && out->points) {
            memcpy(out->knots, k->best.w, (size_t)k->best.count * sizeof(double));
            memcpy(out->points, k->points, (size_t)n * (size_t)q->dimension * sizeof(double));
            for (size_t i = q->first; i <= q->last && i < q->count; i++)
                out->max_error = fmax(out->max_error, sqrt(k->distance[i]));
            out->solves = k->solves;
            out->met = !k->missed;
        } else {
            bat_local_result_free(out);
            status = BAT_MEMORY;
        }
    }
    machine_free(k);
    return status;
}

void bat_local_result_free(bat_local_result *result) {
    free(result->knots);
    free(result->points);
    memset(result, 0, sizeof *result);
}
