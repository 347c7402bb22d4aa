/* Knots for the fair curve (docs/math sketch 5.7): few, dense where the change of curvature changes, and as many as it
 * takes for the result to have no extremum of curvature, and no inflection, that the fair curve does not have. */
#include "hands/sketch/fit_interval.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

enum { FEWER = 2, MORE = 3, MORE_KEPT = 2, MOST = 24, SWEEPS = 2, CALM_SWEEPS = 1, CALMER = 2 };
/* Density of knots: (1 - even) |F''''|^power / its mean + even. */
static const struct {
    double power, even;
} laws[BAT_LOCAL_DENSITIES] = {{0.5, 0.1}, {0.25, 0.25}, {0.67, 0.1}};
static const double of_range = 0.04, of_mean = 0.05; /* what counts as an extremum */
static const double near = 1.6;       /* times what is allowed: then moving the knots is tried */
static const double shift = 0.3;      /* of the gap to the next knot, that a knot is moved by */
static const double work_few = 1.5e5; /* some 3 ms */
/* Of the fair curve's change of curvature; over the first a knot more is tried, over the second one more than that. */
static const double most_change = 1.05, much_change = 1.26;
static const double even = 0.2; /* of the greatest curvature, that an arc's may differ by */
static const double not_fair = 1.01, each_bump = 0.5; /* off, of what is near enough but less fair */

/* Extrema that stand out by more than `least`. */
static int extrema(const double *x, size_t count, double least) {
    double low = x[0], high = x[0];
    int way = 0, found = 0;
    for (size_t i = 1; i < count; i++) {
        low = x[i] < low ? x[i] : low, high = x[i] > high ? x[i] : high; /* fmin and fmax are calls */
        if (!(way >= 0 && x[i] < high - least) && !(way <= 0 && x[i] > low + least)) continue;
        found += way != 0;
        way = x[i] < high - least && way >= 0 ? -1 : 1;
        low = high = x[i];
    }
    return found;
}

/* Changes of sign between values farther than `least` from zero. */
static int inflections(const double *x, size_t count, double least) {
    int way = 0, found = 0;
    for (size_t i = 0; i < count; i++) {
        const int now = x[i] > least ? 1 : x[i] < -least ? -1 : 0;
        found += now != 0 && way == -now;
        if (now != 0) way = now;
    }
    return found;
}

/* The integral of the squared change of curvature, from sample to sample. */
static double change_of(const bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    double sum = 0;
    for (size_t i = 1; i < q->count; i++) {
        const double d = k->curvature[i] - k->curvature[i - 1], h = q->w[i] - q->w[i - 1];
        if (h > 0) sum += d * d / h;
    }
    return sum;
}

/* Of the last solve. least: what stands out. */
static bat_local_bumps bumps_of(bat_local_machine *k, double least) {
    const size_t count = k->problem->count;
    bat_local_curvature(k);
    return (bat_local_bumps){least, extrema(k->curvature, count, least),
                             inflections(k->curvature, count, 0.25 * least), change_of(k)};
}

static double what_stands_out(const double *curvature, size_t count) {
    double low = curvature[0], high = low, mean = 0;
    for (size_t i = 0; i < count; i++) {
        low = curvature[i] < low ? curvature[i] : low, high = curvature[i] > high ? curvature[i] : high;
        mean += fabs(curvature[i]) / (double)count;
    }
    return fmax(of_range * (high - low), of_mean * mean);
}

/* As good as constant: an arc or a line, whose change is noise. */
static bool is_even(const double *curvature, size_t count) {
    double low = curvature[0], high = low;
    for (size_t i = 0; i < count; i++) low = fmin(low, curvature[i]), high = fmax(high, curvature[i]);
    return high - low <= even * fmax(fabs(low), fabs(high));
}

/* |F''''| at the samples, its mean 1: the jump of the third derivative from one slot to the next over the way between
 * their middles. */
static void find_need(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree, m = q->dimension;
    const double *t = k->space.knots + p;
    double last[BAT_DIMENSION_MAX], at = 0, jump = 0, mean = 0;
    size_t done = 0;
    int found = 0;
    for (int s = 0; s < bat_lsq_slots(&k->space); s++) {
        const double half = 0.5 * (t[s + 1] - t[s]), middle = t[s] + half;
        if (!(half > 0)) continue;
        const double *local = k->local + (size_t)s * (size_t)((p + 1) * m);
        double third[BAT_DIMENSION_MAX], sum = 0;
        for (int c = 0; c < m; c++) {
            third[c] = local[3 * m + c] / (half * half * half);
            if (found > 0) sum += (third[c] - last[c]) * (third[c] - last[c]);
        }
        if (found > 0) jump = sqrt(sum) / (middle - at);
        if (found > 0)
            for (; done < q->count && q->w[done] < middle; done++) k->need[done] = jump;
        memcpy(last, third, sizeof third);
        at = middle, found++;
    }
    for (; done < q->count; done++) k->need[done] = jump;
    for (size_t i = 0; i < q->count; i++) mean += k->need[i] / (double)q->count;
    for (size_t i = 0; i < q->count; i++) k->need[i] = mean > 0 ? k->need[i] / mean : 1;
}

void bat_local_note(bat_local_machine *k) {
    bat_local_curvature(k);
    k->fair = bumps_of(k, what_stands_out(k->curvature, k->problem->count));
    if (k->problem->degree > 3 || is_even(k->curvature, k->problem->count)) k->fair.change = INFINITY;
    find_need(k);
    k->spread_count = 0;
}

/* The integral of a density. */
static void spread(bat_local_machine *k, int law, double *sum) {
    const bat_local_problem *q = k->problem;
    double mean = 0;
    for (size_t i = 0; i < q->count; i++) {
        sum[i] = k->need[i] > 1e-12 ? bat_exp(laws[law].power * bat_log(k->need[i])) : 0;
        mean += sum[i] / (double)q->count;
    }
    for (size_t i = 0; i < q->count; i++) {
        const double density = (1 - laws[law].even) * (mean > 0 ? sum[i] / mean : 1) + laws[law].even;
        sum[i] = i > 0 ? sum[i - 1] + density * (q->w[i] - q->w[i - 1]) : 0;
    }
}

/* `count` knots into k->trial, where the integral of the density is even. */
static void place(bat_local_machine *k, int count, int law) {
    const bat_local_problem *q = k->problem;
    double *sum = k->spread + (size_t)law * q->count;
    for (; k->spread_count <= law; k->spread_count++)
        spread(k, k->spread_count, k->spread + (size_t)k->spread_count * q->count);
    k->trial.count = count;
    size_t i = 1;
    for (int n = 0; n < count; n++) {
        const double want = sum[q->count - 1] * (n + 1) / (count + 1);
        while (i + 1 < q->count && sum[i] < want) i++;
        const double h = sum[i] - sum[i - 1], f = h > 0 ? (want - sum[i - 1]) / h : 0;
        k->trial.w[n] = q->w[i - 1] + f * (q->w[i] - q->w[i - 1]);
        k->trial.fixed[n] = 0;
    }
}

/* Whether the curve ends where the stroke does. */
static bool is_free(const bat_local_problem *q) { return q->side[0].pins + q->side[1].pins <= 2; }

/* How far a curve is off whose change of curvature alone is too great. */
static double change_off(double change) { return 1 + (not_fair - 1) * (1 - most_change / change); }

/* How far the last solve is from what is allowed; 1: just within, and as fair as can be; up to not_fair: within, and its
 * curvature changes too much. INFINITY: no less than most. */
static double off(bat_local_machine *k, bool fine, double most) {
    double worst = 0;
    for (size_t i = 0; i < k->problem->count && !k->given_up; i++) {
        const double ratio = k->distance[i] / k->limit[i];
        worst = ratio > worst ? ratio : worst;
    }
    if (k->given_up || !(sqrt(worst) < most)) return INFINITY;
    const bat_local_bumps b = bumps_of(k, k->fair.least);
    const int more = (b.extrema > k->fair.extrema ? b.extrema - k->fair.extrema : 0) +
                     (b.inflections > k->fair.inflections ? b.inflections - k->fair.inflections : 0);
    const double base = fmax(sqrt(worst), more > 0 || !fine ? not_fair + each_bump * more : 0);
    if (base > 1 || !is_free(k->problem)) return base > 1 ? fmax(base, not_fair) : base;
    const double change = b.change / k->fair.change;
    return change > most_change ? change_off(change) : base;
}

static double try_off(bat_local_machine *k, double most, bat_status *status) {
    k->hope = most * most;
    const bool fine = bat_local_try(k, &k->trial, status);
    k->hope = INFINITY;
    if (*status == BAT_OK) return off(k, fine, most);
    if (*status == BAT_SINGULAR) *status = BAT_OK;
    return INFINITY;
}

/* Moves knots of k->spare, which are `least` off, to either side while that helps; once more where only the change of
 * curvature is too great. The last solve is of k->trial. */
static double move(bat_local_machine *k, double least, double most_work, bat_status *status) {
    const bat_local_problem *q = k->problem;
    const int n = k->spare.count;
    for (int j = 0; j < 2 * n * (least < not_fair ? SWEEPS + CALM_SWEEPS : SWEEPS); j++) {
        const int i = j / 2 % n;
        const double *w = k->spare.w;
        const double before = i > 0 ? w[i - 1] : 0, after = i + 1 < n ? w[i + 1] : q->end;
        bat_knots_copy(&k->trial, &k->spare);
        k->trial.w[i] += shift * ((j % 2 ? after : before) - w[i]);
        const double now = try_off(k, least, status);
        if (now < least) least = now, bat_knots_copy(&k->spare, &k->trial);
        if (least <= 1 || *status != BAT_OK || k->work > most_work) break;
    }
    return least;
}

/* `count` knots in the best of some places, in k->spare; how far they are off. */
static double best_places(bat_local_machine *k, int count, double most_work, bat_status *status) {
    double least = INFINITY;
    for (int law = 0; law < BAT_LOCAL_DENSITIES && *status == BAT_OK && least > 1; law++) {
        place(k, count, law);
        const double now = try_off(k, fmin(least, near), status);
        if (now < least) least = now, bat_knots_copy(&k->spare, &k->trial);
    }
    if (*status == BAT_OK && least > 1 && least < near && count > 0)
        least = move(k, least, most_work, status);
    return least;
}

bat_status bat_local_few(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int now = k->best.count, fewest = bat_local_fewest(q);
    int met = now;                                    /* the count that first came near enough */
    int most = now + (is_free(q) ? MORE : MORE_KEPT); /* a curve redrawn often must not grow */
    const double most_work = k->work + work_few;
    bat_status status = BAT_OK;
    if (q->fixed_count > 0 || now > MOST) return BAT_OK;
    double least = not_fair;
    bool found = false;
    if (bat_local_try(k, &k->best, &status)) least = fmin(least, off(k, true, INFINITY));
    if (least <= 1) return BAT_OK;
    if (least < not_fair) most = now + CALMER;
    k->pulled =
        false; /* with few knots the least change of curvature is what is wanted, not that of the fair curve */
    for (int n = now > fewest + FEWER ? now - FEWER : fewest; n <= most && least > 1; n++) {
        if (status != BAT_OK || k->work > most_work) break;
        if (n > met + 1 && least <= change_off(much_change)) break;
        const double now_off = best_places(k, n, most_work, &status);
        if (!(now_off < least)) continue;
        if (!(least < not_fair)) met = n, most = n + CALMER < most ? n + CALMER : most;
        least = now_off, found = true;
        bat_knots_copy(&k->best, &k->spare);
    }
    k->pulled = !found;
    return status;
}
