#include "editor/input/stabiliser.h"
#include "base/real.h"
#include <math.h>
#include <string.h>

static const double STEP = 3;     /* px: as dense as typical pen samples */
static const double SHARE = 0.02; /* of what is drawn so far: small letters keep their shape */

bat_steady bat_steady_begin(double strength, const double at[2]) {
    const double most = strength * strength / 2;
    return (bat_steady){most, most, {at[0], at[1]}, {at[0], at[1]}};
}

void bat_steady_fit(bat_steady *steady, double extent) { steady->reach = fmin(steady->most, SHARE * extent); }

void bat_steady_move(bat_steady *steady, const double to[2]) {
    double *pen = steady->pen, *end = steady->end, reach = steady->reach;
    double d[2] = {to[0] - pen[0], to[1] - pen[1]}, length = bat_hypot(d[0], d[1]);
    if (!(reach > 0)) {
        memcpy(end, to, 2 * sizeof *end);
    } else if (length > 0) {
        double left = bat_exp(-length / reach);
        for (int k = 0; k < 2; k++) { /* behind the pen by its lag, plus what is left of the earlier lag */
            double lag = reach * d[k] / length;
            end[k] = to[k] - lag + (end[k] - pen[k] + lag) * left;
        }
    }
    memcpy(pen, to, 2 * sizeof *pen);
}

bool bat_steady_catch_up(bat_steady *steady) {
    double *pen = steady->pen, *end = steady->end, x = pen[0] - end[0], y = pen[1] - end[1];
    double away = bat_hypot(x, y);
    if (away == 0) return false;
    if (away > STEP) {
        end[0] += x / away * STEP;
        end[1] += y / away * STEP;
    } else {
        memcpy(end, pen, 2 * sizeof *end);
    }
    return true;
}
