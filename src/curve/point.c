/* Points as plain arrays: distances and angles that do not overflow. */
#include "curve/curve.h"
#include "base/real.h"

double bat_distance(const double *a, const double *b, int size) {
    double d = 0;
    for (int c = 0; c < size; c++) d = bat_hypot(d, a[c] - b[c]);
    return d;
}

bool bat_is_beside(const double at[2], const double from[2], const double to[2]) {
    return (from[1] > at[1]) != (to[1] > at[1]) &&
           at[0] < from[0] + (at[1] - from[1]) / (to[1] - from[1]) * (to[0] - from[0]);
}

double bat_turn(const double *before, const double *at, const double *after, int size) {
    double in = bat_distance(before, at, size), out = bat_distance(at, after, size), sum = 0, difference = 0;
    if (in == 0 || out == 0) return 4;
    for (int c = 0; c < size; c++) {
        double a = (at[c] - before[c]) / in, b = (after[c] - at[c]) / out;
        sum = bat_hypot(sum, a + b), difference = bat_hypot(difference, a - b);
    }
    return 2 * bat_atan2(difference, sum);
}
