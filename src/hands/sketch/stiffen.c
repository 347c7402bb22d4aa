/* The calmest curve with the knots found (docs/math sketch 5.7, step 3): what the tolerance still allows is
 * spent on less change of curvature. */
#include "hands/sketch/fit_interval.h"
#include "base/real.h"

#include <math.h>

static const double longest = 190; /* waves that are stiffened, px; none longer than the interval */

bat_status bat_local_stiffen(bat_local_machine *k) {
    enum { STEPS = 3 };
    const bat_local_problem *q = k->problem;
    const double length = q->end * q->law[q->count / 2];
    const double most = 6 * bat_log(fmin(longest, length) / q->wavelength);
    double low = 0, high = most, next = most;
    bat_status status = BAT_OK;
    for (int step = 0; step <= STEPS && low < high; step++) {
        k->stiffness = bat_exp(next);
        const bool fine = bat_local_try(k, &k->best, &status);
        if (status == BAT_SINGULAR) status = BAT_OK;
        if (status != BAT_OK) return status;
        if (fine)
            low = next;
        else
            high = next;
        next = 0.5 * (low + high);
    }
    k->stiffness = bat_exp(low);
    return BAT_OK;
}
