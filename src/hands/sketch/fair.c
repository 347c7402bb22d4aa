/* The fairest curve near the dense fit (docs/math sketch 5.7): what the tolerance still allows goes into less change of
 * curvature, and the result is what knots are sought for. */
#include "hands/sketch/fit_interval.h"
#include "base/real.h"

#include <math.h>

enum { ROUNDS = 3, FINE_STEPS = 5 };
static const double fairing = 0.8; /* of what is left goes into fairness, the rest into fewer knots */

static const double longest = 190; /* waves that are stiffened, px; none longer than the interval */

double bat_local_spare(const bat_local_problem *q, size_t i) {
    return q->fairness * fmin(q->allowed[i], q->tolerance);
}

bat_status bat_local_stiffen(bat_local_machine *k, int steps) {
    const bat_local_problem *q = k->problem;
    const double length = q->end * q->law[q->count / 2];
    const double most = 6 * bat_log(fmax(1, fmin(longest, length) / q->wavelength));
    double low = 0, high = most, next = most;
    bat_status status = BAT_OK;
    k->hope = 1;
    for (int step = 0; step <= steps && low < high; step++) {
        k->stiffness = bat_exp(next);
        const bool fine = bat_local_try(k, &k->best, &status);
        if (status == BAT_SINGULAR) status = BAT_OK;
        if (status != BAT_OK) break;
        if (fine)
            low = next;
        else
            high = next;
        next = 0.5 * (low + high);
    }
    k->stiffness = bat_exp(low), k->hope = INFINITY;
    return status;
}

/* From now on `data` is fitted; pulled: its change of curvature, too. */
static void fit_to(bat_local_machine *k, const double *data, bool pulled) {
    k->data = data, k->stiffness = 1, k->pulled = pulled, k->holds_best = false;
    k->memo[0].slots = k->memo[1].slots = 0;
}

void bat_local_take_shape(bat_local_machine *k) {
    const bat_local_problem *q = k->problem;
    bat_local_read(k, k->shape);
    for (size_t i = 0; i < q->count; i++) {
        const double d = sqrt(k->distance[i]), rest = fmax(q->allowed[i] - d, 0.05 * d);
        const double most = fmin(rest, bat_local_spare(q, i));
        k->limit[i] = most * most;
    }
    k->x = k->shape;
    fit_to(k, k->shape, true);
}

static void scale_limits(bat_local_machine *k, double factor) {
    for (size_t i = 0; i < k->problem->count; i++) k->limit[i] *= factor * factor;
}

/* The dense fit once more. */
static bat_status back_to_shape(bat_local_machine *k) {
    bat_status status;
    k->bent = false;
    fit_to(k, k->problem->x, false);
    bat_local_try(k, &k->best, &status);
    if (status == BAT_OK) bat_local_read(k, k->shape);
    fit_to(k, k->shape, true);
    return status;
}

bat_status bat_local_fair(bat_local_machine *k) {
    bat_status status = BAT_OK;
    fit_to(k, k->shape, false);
    scale_limits(k, fairing);
    for (int round = 0; round < ROUNDS && status == BAT_OK; round++) {
        status = bat_local_stiffen(k, FINE_STEPS);
        if (status == BAT_OK) bat_local_try(k, &k->best, &status);
        if (status == BAT_OK) bat_local_read(k, k->aim);
    }
    scale_limits(k, 1 / fairing);
    if (status == BAT_OK) {
        bat_local_note(k);
        fit_to(k, k->aim, true);
        if (bat_local_try(k, &k->best, &status)) return status;
    }
    if (status == BAT_OK || status == BAT_SINGULAR) status = back_to_shape(k); /* too far off */
    return status;
}
