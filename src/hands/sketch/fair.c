/* The tolerance is spent on fairness (docs/math sketch 5.7): the close fit gives way to the curve of least change of
 * curvature that still keeps the tolerance. */
#include "hands/sketch/fit_interval.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

static const double heaviest = 1e14; /* weight of the change of curvature, px^6 */
static const double inner = 0.7;  /* of the tolerance goes to the fair curve, the rest to few knots for it */
static const double faint = 1e-3; /* of their weight, samples of transitions have */

static double spacing(const bat_local_problem *q, size_t i) {
    const double before = i > 0 ? q->w[i - 1] : q->w[i], after = i + 1 < q->count ? q->w[i + 1] : q->w[i];
    return 0.5 * (after - before) * q->law[i];
}

/* Where the curve leaves the tube samples weigh more, before the whole gets less fair: needed at free ends. */
static bool try_weight(bat_local_machine *k, double lambda, bat_status *status) {
    enum { ROUNDS = 4 };
    const bat_local_problem *q = k->problem;
    bat_fairing *fair = &k->fairing;
    fair->lambda = lambda;
    for (int round = 0; round < ROUNDS; round++) {
        if (bat_local_try(k, &k->best, status)) return true;
        if (*status != BAT_OK || bat_local_worst(k) > 25) return false;
        for (size_t i = 0; i < q->count; i++) {
            const double over = k->distance[i] / (0.72 * k->limit[i]);
            if (over > 1) fair->weight[i] = fmin(fair->weight[i] * over * sqrt(over), 1e4 * spacing(q, i));
        }
        fair->fresh = true;
    }
    return false;
}

/* From here on the fair curve is what solves aim at, and its change of curvature what they are compared with. Longer waves
 * than a quarter of the whole are its ends' business. */
static void aim(bat_local_machine *k, double lambda) {
    const bat_local_problem *q = k->problem;
    bat_fairing *fair = &k->fairing;
    const double wave = fmax(0.25 * q->end * q->law[q->count / 2], q->wavelength) / (2 * BAT_PI);
    const double cube = wave * wave * wave;
    fair->lambda = fmin(lambda, cube * cube);
    for (size_t i = 0; i < q->count; i++) fair->weight[i] = spacing(q, i);
    fair->aimed = fair->fresh = true;
}

bool bat_fair_find(bat_local_machine *k, bat_status *status) {
    enum { STEPS = 8 };
    const bat_local_problem *q = k->problem;
    bat_fairing *fair = &k->fairing;
    const double omega = q->wavelength / (2 * BAT_PI);
    double low = 6 * bat_log(omega), high = bat_log(heaviest), best = 0;
    double *kept = fair->curvature;
    for (size_t i = 0; i < q->count; i++) {
        k->limit[i] *= inner * inner;
        if (!(q->weight[i] > 0)) fair->weight[i] = faint * spacing(q, i);
    }
    fair->fresh = true;
    for (int step = 0; step < STEPS && high - low > 0.9; step++) {
        const double middle = 0.5 * (low + high);
        memcpy(kept, fair->weight, q->count * sizeof *kept);
        if (try_weight(k, bat_exp(middle), status)) {
            low = middle, best = fair->lambda;
            bat_energy_look(k);
        } else {
            if (*status == BAT_SINGULAR) *status = BAT_OK;
            if (*status != BAT_OK) break;
            high = middle;
            memcpy(fair->weight, kept, q->count * sizeof *kept);
            fair->fresh = true;
        }
    }
    fair->lambda = best;
    bool fine = best > 0 && *status == BAT_OK && bat_local_try(k, &k->best, status);
    for (size_t i = 0; i < q->count; i++) k->limit[i] /= inner * inner;
    if (*status == BAT_SINGULAR) *status = BAT_OK;
    if (!fine) {
        fair->lambda = 0, fair->fresh = true;
        return false;
    }
    bat_energy_look(k);
    bat_energy_keep(k);
    aim(k, best);
    return true;
}
