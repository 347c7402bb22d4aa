/* Position and derivatives at many parameters. */
#include "curve/curve.h"

#include <math.h>

bat_status bat_curve_eval_many(const bat_curve *curve, size_t count, const double *u, int order,
                               double *out) {
    if (!curve || order < 0 || (count > 0 && (!u || !out))) return BAT_ARGUMENT;
    for (size_t i = 0; i < count; i++)
        if (isnan(u[i])) return BAT_NUMBER;
    for (size_t i = 1; i < count; i++)
        if (u[i] < u[i - 1]) return BAT_PARAMETER;
    size_t block = ((size_t)order + 1) * (size_t)curve->dimension;
    for (size_t i = 0; i < count; i++) bat_curve_eval(curve, u[i], order, out + i * block);
    return BAT_OK;
}

void bat_curve_spread(const bat_curve *curve, size_t count, double *u) {
    double start = curve->knots[curve->degree], end = curve->knots[curve->spread];
    size_t steps = curve->closed ? count : count - 1;
    for (size_t i = 0; i < count; i++) {
        double w = steps > 0 ? (double)i / (double)steps : 0;
        u[i] = fmin(start + w * (end - start), end);
    }
    if (!curve->closed && count > 1) u[count - 1] = end;
}
