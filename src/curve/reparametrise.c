/* Curves run backwards, and over another interval. */
#include "curve/curve.h"

#include <batten/refine.h>
#include <math.h>
#include <string.h>

bat_status bat_curve_reverse(const bat_curve *curve, bat_curve **out) {
    if (!curve || !out) return BAT_ARGUMENT;
    int p = curve->degree, n = curve->count, last = bat_curve_knot_count(curve) - 1;
    size_t size = (size_t)curve->dimension;
    double start = curve->knots[p], end = curve->knots[curve->spread];
    bat_curve *back;
    bat_status status = bat_curve_allocate(p, curve->dimension, curve->closed, n, &back);
    if (status != BAT_OK) return status;
    const double *t = bat_curve_knots(curve), *points = bat_curve_points(curve);
    double *knots = bat_curve_own_knots(back), *to = bat_curve_own_points(back);
    for (int i = 0; i <= last; i++) {
        double u = t[last - i];
        knots[i] = u == start ? end : start + (end - u);
        if (i > 0 && knots[i] <= knots[i - 1] && t[last - i] < t[last - i + 1]) status = BAT_KNOTS;
    }
    for (int i = 0; i < n; i++) {
        /* N_i lives on [t_i, t_{i+p+1}], whose image starts at knot n - i - p - 1 of a closed curve. */
        int j = curve->closed ? (((n - i - p - 1) % n) + n) % n : n - 1 - i;
        memcpy(to + (size_t)j * size, points + (size_t)i * size, size * sizeof(double));
    }
    if (status != BAT_OK) {
        bat_curve_free(back);
        return status;
    }
    return bat_curve_finish(back, out);
}

bat_status bat_curve_reparametrise(const bat_curve *curve, double start, double end, bat_curve **out) {
    if (!curve || !out) return BAT_ARGUMENT;
    if (!(fabs(start) <= BAT_KNOT_MAX) || !(fabs(end) <= BAT_KNOT_MAX)) return BAT_NUMBER;
    if (!(start < end)) return BAT_PARAMETER;
    double a = curve->knots[curve->degree], b = curve->knots[curve->spread], scale = (end - start) / (b - a);
    bat_curve *mapped;
    bat_status status = bat_curve_copy(curve, &mapped);
    if (status != BAT_OK) return status;
    const double *t = bat_curve_knots(curve);
    double *knots = bat_curve_own_knots(mapped);
    for (int i = 0; i < bat_curve_knot_count(curve); i++) {
        knots[i] = t[i] == b ? end : start + (t[i] - a) * scale;
        if (i > 0 && knots[i] <= knots[i - 1] && t[i] > t[i - 1]) status = BAT_KNOTS;
    }
    if (status != BAT_OK) {
        bat_curve_free(mapped);
        return status;
    }
    return bat_curve_finish(mapped, out);
}
