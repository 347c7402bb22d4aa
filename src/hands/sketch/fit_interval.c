#include "hands/sketch/fit_interval.h"
#include "curve/banded.h"
#include "base/real.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double softer = 1.0 / 64, shortest_span = 0.5, slowest = 0.6, fastest = 1.7;

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

/* The penalty's factor a slot: v^-5, so that a wavelength in pixels means the same at every speed. */
static void factors(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int slots = bat_lsq_slots(&k->space);
    for (int s = 0; s < slots; s++) {
        size_t from = k->first[s], to = k->first[s + 1];
        if (from >= q->count) from = q->count - 1;
        if (to <= from) to = from + 1;
        double soft = 1;
        for (size_t i = from; i < to; i++) soft = fmin(soft, k->soft[i]);
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
            if (v2 < slowest * slowest * want * want || v2 > fastest * fastest * want * want) {
                k->slow[k->slow_count++] = q->w[i];
                break; /* one place a span says enough */
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
    bat_lsq_memo_fill(&k->space, m, k->first, q->w, q->x, q->weight, &k->memo[1], true, &k->memo[0]);
    bat_lsq_memo_add(&k->space, m, &k->memo[0], k->a, k->b);
    const double omega = q->wavelength / (2 * BAT_PI), mu = omega * omega * omega;
    bat_lsq_memo_penalty(&k->space, 3, mu * mu, k->factor, &k->memo[0], k->a);
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

/* Whether all samples are near enough. Most are at their own parameter; only the others are projected. */
static bool near_enough(bat_local_machine *k, bat_status *status) {
    const bat_local_problem *q = k->problem;
    const int m = q->dimension;
    if (k->exact)
        bat_lsq_error(&k->space, m, k->local, q->count, q->w, q->x, 2, NULL, k->distance);
    else
        bat_lsq_plain(&k->space, m, k->local, k->first, q->w, q->x, k->distance);
    bool fine = true;
    for (size_t i = 0; i < q->count;) {
        if (!bat_local_fails(k, i)) {
            i++;
            continue;
        }
        const size_t from = i;
        while (i < q->count && bat_local_fails(k, i)) i++;
        if (!k->exact)
            bat_lsq_error(&k->space, m, k->local, i - from, q->w + from, q->x + from * (size_t)m, 2, NULL,
                          k->distance + from);
        for (size_t j = from; j < i; j++) {
            fine = fine && !bat_local_fails(k, j);
            if (!(k->distance[j] < INFINITY)) *status = BAT_NUMBER;
        }
    }
    return fine;
}

bool bat_local_try(bat_local_machine *k, const bat_knot_set *set, bat_status *status) {
    const bat_local_problem *q = k->problem;
    const int m = q->dimension;
    k->slow_count = 0;
    assemble(k, set);
    k->solves++;
    k->work += (double)q->count + 8.0 * k->space.count;
    *status = solve(k, set);
    if (*status != BAT_OK) return false;
    memcpy(k->points, k->b, (size_t)k->space.count * (size_t)m * sizeof *k->points);
    bat_lsq_memo_local(&k->space, m, &k->memo[0], k->points, k->local);
    k->holds_best = false;
    const bool fine = near_enough(k, status);
    return *status == BAT_OK && fine && speed_kept(k);
}

static void set_copy(bat_knot_set *to, const bat_knot_set *from) {
    to->count = from->count;
    memcpy(to->w, from->w, (size_t)from->count * sizeof *to->w);
    memcpy(to->fixed, from->fixed, (size_t)from->count);
}

static bool set_add(bat_knot_set *set, int room, double w, bool fixed) {
    if (set->count >= room) return false;
    set->w[set->count] = w;
    set->fixed[set->count++] = fixed;
    return true;
}

/* Even spans between the ends and the corners, or the warm knots. */
static void start_knots(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree;
    bat_knot_set *set = &k->best;
    set->count = 0;
    int warm = 0;
    for (int c = 0; c <= q->fixed_count; c++) {
        const double from = c == 0 ? 0 : q->fixed[c - 1], to = c == q->fixed_count ? q->end : q->fixed[c];
        if (q->warm_count > 0) {
            while (warm < q->warm_count && q->warm[warm] <= from) warm++;
            for (; warm < q->warm_count && q->warm[warm] < to; warm++)
                set_add(set, k->room - p, q->warm[warm], false);
        } else {
            int pieces = (int)fmin(ceil((to - from) / q->span), (double)q->count / 3 + 2);
            if (pieces < 1) pieces = 1;
            if (q->fixed_count == 0 && pieces < bat_local_fewest(q) + 2) pieces = bat_local_fewest(q) + 2;
            for (int i = 1; i < pieces; i++)
                set_add(set, k->room - p, from + (to - from) * i / pieces, false);
        }
        for (int i = 0; i < p && c < q->fixed_count; i++) set_add(set, k->room, to, true);
    }
    /* Warm knots can be too few for the pins: halve the longest spans. */
    while (set->count < bat_local_fewest(q) + 1 && set->count < k->room) {
        int widest = 0;
        double width = 0;
        for (int i = 0; i <= set->count; i++) {
            const double a = i == 0 ? 0 : set->w[i - 1], b = i == set->count ? q->end : set->w[i];
            if (b - a > width) width = b - a, widest = i;
        }
        const double a = widest == 0 ? 0 : set->w[widest - 1];
        memmove(set->w + widest + 1, set->w + widest, (size_t)(set->count - widest) * sizeof *set->w);
        memmove(set->fixed + widest + 1, set->fixed + widest, (size_t)(set->count - widest));
        set->w[widest] = a + 0.5 * width;
        set->fixed[widest] = 0;
        set->count++;
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

static double worst_ratio(const bat_local_machine *k) {
    double worst = 0;
    for (size_t i = 0; i < k->problem->count; i++) {
        const double ratio = k->distance[i] / k->limit[i];
        if (ratio > worst) worst = ratio;
    }
    return worst;
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
            k->wild[i] = !(ratio > slowest * 1.1 && ratio < fastest / 1.1);
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
    k->problem = q;
    const int p = q->degree;
    k->room = (int)fmin(2 * (double)q->count + 32, 1 << 22) + q->fixed_count * p + q->warm_count;
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
    k->limit = malloc(q->count * sizeof(double));
    k->distance = malloc(q->count * sizeof(double));
    k->soft = malloc(q->count * sizeof(double));
    k->wild = calloc(q->count, 1);
    bool fine = k->space.knots && k->remembered && k->a && k->b && k->points && k->local && k->factor &&
                k->rank && k->slow && k->first && k->limit && k->distance && k->soft && k->wild &&
                (!q->closed || k->border);
    bat_knot_set *sets[3] = {&k->best, &k->trial, &k->spare};
    for (int i = 0; i < 3; i++) {
        sets[i]->w = malloc(n * sizeof(double));
        sets[i]->fixed = malloc(n);
        fine = fine && sets[i]->w && sets[i]->fixed;
    }
    if (!fine) return false;
    for (size_t i = 0; i < q->count; i++) k->limit[i] = q->allowed[i] * q->allowed[i], k->soft[i] = 1;
    return true;
}

bat_status bat_local_fit(const bat_local_problem *q, bat_local_result *out) {
    memset(out, 0, sizeof *out);
    bat_local_machine machine, *k = &machine;
    if (!machine_make(k, q)) {
        machine_free(k);
        return BAT_MEMORY;
    }
    start_knots(k);
    bat_status status = BAT_OK;
    bool far = true;
    double least = INFINITY;
    set_copy(&k->spare, &k->best);
    for (int round = 0; round < 24; round++) {
        bat_local_try(k, &k->best, &status);
        if (status == BAT_SINGULAR && k->ridge == 0) { /* too few samples somewhere: hold still there */
            k->ridge = 1e-10;
            bat_local_try(k, &k->best, &status);
        }
        if (status != BAT_OK) break;
        const double ratio = worst_ratio(k);
        const bool met = ratio <= 1; /* the speed law binds the removal only */
        if (ratio < least) least = ratio, set_copy(&k->spare, &k->best);
        if (met || !split_failing(k)) break;
        set_copy(&k->best, &k->trial);
    }
    if (status == BAT_OK || least < INFINITY) { /* a later round may fail where an earlier one did not */
        set_copy(&k->best, &k->spare);
        bat_local_try(k, &k->best, &status);
        far = worst_ratio(k) > 1;
    }
    if (status == BAT_OK) {
        for (size_t i = 0; i < q->count; i++)
            if (bat_local_fails(k, i)) k->limit[i] = 1.05 * k->distance[i];
        mark_wild(k);
        if (q->remove) status = bat_local_reduce(k);
    }
    k->exact = true;
    if (status == BAT_OK) bat_local_try(k, &k->best, &status);
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
            out->met = !far;
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
