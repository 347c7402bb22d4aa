/* Closed curves: where the numbering starts, and open curves made periodic. */
#include "curve/curve.h"

#include <batten/refine.h>
#include <float.h>
#include <math.h>
#include <string.h>

bat_status bat_curve_move_seam(const bat_curve *curve, double u, bat_curve **out) {
    if (!curve || !out || !curve->closed) return BAT_ARGUMENT;
    if (!isfinite(u)) return BAT_NUMBER;
    double a = bat_curve_reduce(curve, u);
    bat_curve *with, *gathered;
    bat_status status = bat_curve_insert_knot(curve, a, bat_knot_multiplicity(curve, a) > 0 ? 0 : 1, &with);
    if (status != BAT_OK) return status;
    status = bat_curve_gather_seam(with, &gathered);
    bat_curve_free(with);
    if (status != BAT_OK) return status;
    const double *t = bat_curve_knots(gathered);
    int shift = bat_span_left(gathered, bat_curve_reduce_left(gathered, a), -1) - gathered->degree + 1;
    if (a == t[0]) shift = 0;
    status = bat_curve_rotate(gathered, shift, out);
    bat_curve_free(gathered);
    return status;
}

bat_status bat_curve_close(const bat_curve *curve, double tolerance, bat_curve **out) {
    if (!curve || !out || curve->closed || !(tolerance >= 0)) return BAT_ARGUMENT;
    bat_curve *clamped, *round;
    bat_status status = bat_curve_clamp(curve, &clamped);
    if (status != BAT_OK) return status;
    int p = clamped->degree, n = clamped->count, size = clamped->dimension;
    double *last = clamped->points + (size_t)(n - 1) * (size_t)size, greatest = 0;
    double gap = bat_distance(last, clamped->points, size);
    status = gap <= tolerance ? bat_curve_allocate(p, size, true, n - 1, &round) : BAT_ARGUMENT;
    if (status == BAT_OK) {
        for (int c = 0; c < size; c++) last[c] = 0.5 * clamped->points[c] + 0.5 * last[c];
        memcpy(bat_curve_own_knots(round), clamped->knots + 1, (size_t)n * sizeof(double));
        memcpy(bat_curve_own_points(round), clamped->points + size,
               (size_t)((n - 1) * size) * sizeof(double));
        for (int i = 0; i < (n - 1) * size; i++) greatest = fmax(greatest, fabs(clamped->points[size + i]));
        status = bat_curve_finish(round, &round);
    }
    bat_curve_free(clamped);
    if (status != BAT_OK) return status;
    double seam = round->knots[p], error;
    int removed;
    bat_curve *smooth;
    status = bat_curve_remove_knot(round, seam, p - 1, 64 * DBL_EPSILON * greatest, &smooth, &removed,
                                   &error);
    bat_curve_free(round);
    if (status == BAT_OK) *out = smooth;
    return status;
}
