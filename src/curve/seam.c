/* Where a closed curve begins: its points turned round, and all copies of the seam's knot gathered at the start. */
#include "curve/curve.h"
#include <batten/refine.h>
#include <float.h>
#include <math.h>
#include <string.h>

bat_status bat_curve_rotate(const bat_curve *curve, int shift, bat_curve **out) {
    int n = curve->count;
    size_t size = (size_t)curve->dimension;
    const double *t = bat_curve_knots(curve), *points = bat_curve_points(curve);
    bat_curve *turned;
    bat_status status = bat_curve_allocate(curve->degree, curve->dimension, true, n, &turned);
    if (status != BAT_OK) return status;
    double *knots = bat_curve_own_knots(turned), *to = bat_curve_own_points(turned);
    for (int i = 0; i <= n; i++) {
        int j = i + shift;
        knots[i] = j < 0 ? t[0] + (t[j + n] - t[n]) : j <= n ? t[j] : t[n] + (t[j - n] - t[0]);
        if (i < n)
            memcpy(to + (size_t)i * size, points + (size_t)((j + n) % n) * size, size * sizeof(double));
    }
    return bat_curve_finish(turned, out);
}

bat_status bat_curve_gather_seam(const bat_curve *curve, bat_curve **out) {
    if (!curve->closed) return bat_curve_copy(curve, out);
    const double *t = bat_curve_knots(curve);
    int back = 0;
    while (t[curve->count - 1 - back] == t[curve->count]) back++;
    return bat_curve_rotate(curve, -back, out);
}
