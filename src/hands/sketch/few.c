/* Few knots for the fair curve, from few upwards (docs/math sketch 5.7). It has no noise: knots belong where its fourth
 * derivative is. */
#include "hands/sketch/fit_interval.h"

#include <math.h>
#include <string.h>

static const double calm = 1.1;  /* so much more change of curvature than the fair curve's is good enough */
static const double shift = 0.3; /* of the gap to its neighbour, a knot tries */
enum { MOST = 40, MORE = 1, MOVED_MOST = 12 };

/* Fourth derivatives as a density of knots: their power, and an even share. */
typedef struct knot_law {
    int roots; /* power: 2^-roots */
    bool cubed;
    double even;
} knot_law;
static const knot_law laws[BAT_KNOT_LAWS] = {{1, false, 0.1}, {2, false, 0.25}, {2, true, 0.1}};

static void find_jumps(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    const int p = q->degree, m = q->dimension, slots = bat_lsq_slots(&k->space);
    const double *t = k->space.knots + p;
    double *jump = k->fairing.jump, mean = 0;
    for (int s = 0; s < slots; s++) {
        const int side[2] = {s > 0 ? s - 1 : s, s + 1 < slots ? s + 1 : s};
        double sum = 0;
        for (int c = 0; c < m; c++) {
            double d[2] = {0, 0}; /* third derivatives in the middle of the neighbours */
            for (int i = 0; i < 2; i++) {
                const double half = 0.5 * (t[side[i] + 1] - t[side[i]]);
                if (half > 0)
                    d[i] = k->local[(size_t)side[i] * (size_t)((p + 1) * m) + (size_t)(3 * m + c)] /
                           (half * half * half);
            }
            sum += (d[1] - d[0]) * (d[1] - d[0]);
        }
        for (size_t i = k->first[s]; i < k->first[s + 1]; i++) jump[i] = sqrt(sum), mean += jump[i];
    }
    mean /= (double)q->count;
    for (size_t i = 0; i < q->count; i++) jump[i] = mean > 0 ? jump[i] / mean : 1;
}

static double density(const knot_law *law, double jump) {
    double root = jump;
    for (int i = 0; i < law->roots; i++) root = sqrt(root);
    return (1 - law->even) * (law->cubed ? root * root * root : root) + law->even;
}

/* The laws' densities summed up to each sample, one law after the other. */
static void sum_up(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    for (int law = 0; law < BAT_KNOT_LAWS; law++) {
        double *sum = k->fairing.sums + (size_t)law * q->count, total = 0;
        for (size_t i = 0; i < q->count; i++) {
            sum[i] = total;
            if (i + 1 < q->count) total += (q->w[i + 1] - q->w[i]) * density(&laws[law], k->fairing.jump[i]);
        }
    }
}

/* So many knots into the trial, corners besides; none nearer to a corner than half a pixel. */
static void place(bat_local_machine *k, int count, int law) {
    const bat_local_problem *q = k->problem;
    const double *sum = k->fairing.sums + (size_t)law * q->count;
    bat_knot_set *to = &k->trial;
    int corner = 0;
    size_t i = 0;
    to->count = 0;
    for (int next = 1; next <= count + 1; next++) {
        const double wanted = sum[q->count - 1] * next / (count + 1);
        while (i + 2 < q->count && sum[i + 1] <= wanted) i++;
        const double f = sum[i + 1] > sum[i] ? (wanted - sum[i]) / (sum[i + 1] - sum[i]) : 0;
        const double w = next > count ? q->end : q->w[i] + f * (q->w[i + 1] - q->w[i]);
        for (; corner < q->fixed_count && q->fixed[corner] <= w; corner++)
            for (int j = 0; j < q->degree; j++)
                to->w[to->count] = q->fixed[corner], to->fixed[to->count++] = 1;
        const double before = to->count > 0 ? to->w[to->count - 1] : 0;
        const double after = corner < q->fixed_count ? q->fixed[corner] : q->end;
        if (next <= count && w > before + 0.5 && w < after - 0.5)
            to->w[to->count] = w, to->fixed[to->count++] = 0;
    }
}

static bool passes(bat_local_machine *k, const bat_knot_set *set, bat_status *status) {
    const bool fine = set->count >= bat_local_fewest(k->problem) && bat_local_try(k, set, status);
    if (*status == BAT_SINGULAR) *status = BAT_OK;
    return fine && *status == BAT_OK;
}

static void keep_trial(bat_local_machine *k) {
    const bat_knot_set swap = k->spare;
    k->spare = k->trial, k->trial = swap;
}

/* Each knot of the spare set to either side, where the change of curvature becomes less. */
static double move_knots(bat_local_machine *k, double least, bat_status *status) {
    const double end = k->problem->end;
    for (int i = 0; i < k->spare.count && *status == BAT_OK; i++) {
        if (k->spare.fixed[i]) continue;
        for (int way = -1; way <= 1; way += 2) {
            const bat_knot_set *now = &k->spare;
            const double here = now->w[i], before = i > 0 ? now->w[i - 1] : 0;
            const double after = i + 1 < now->count ? now->w[i + 1] : end;
            bat_knot_set_copy(&k->trial, now);
            k->trial.w[i] = here + shift * (way > 0 ? after - here : before - here);
            if (!passes(k, &k->trial, status) || !(k->fairing.variation < least)) continue;
            least = k->fairing.variation;
            keep_trial(k);
        }
    }
    return least;
}

bool bat_fair_few(bat_local_machine *k, bat_status *status) {
    const bat_fairing *fair = &k->fairing;
    const double enough = calm * fair->calmest;
    double least = INFINITY;
    int first = -1;
    find_jumps(k); /* the last solve was the fair curve itself */
    sum_up(k);
    for (int count = 0; count < MOST && count < k->best.count && *status == BAT_OK; count++) {
        const int tried = first < 0 ? BAT_KNOT_LAWS : 1; /* enough for a fairer one */
        for (int law = 0; law < tried && *status == BAT_OK; law++) {
            place(k, count, law);
            if (passes(k, &k->trial, status) && fair->variation < least) {
                least = fair->variation;
                if (first < 0) first = count;
                keep_trial(k);
            }
        }
        if (first < 0) continue;
        if (count <= MOVED_MOST && least > enough) least = move_knots(k, least, status);
        if (least > enough && count < first + MORE) continue;
        bat_knot_set_copy(&k->best, &k->spare);
        return *status == BAT_OK;
    }
    return false;
}
