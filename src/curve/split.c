/* Pieces of curves, and closed curves opened. New ends are blossoms at the cut; all other points are copied.
 */
#include "curve/curve.h"

#include <batten/refine.h>
#include <float.h>
#include <math.h>
#include <string.h>

/* Clamped piece of the stored open spline over [a, b], t_p <= a < b <= t_n. Its knots start at `start`. */
static bat_status cut(const bat_curve *curve, double a, double b, double start, double end, bat_curve **out) {
    int p = curve->degree, size = curve->dimension;
    int first = bat_span(curve, a, -1), last = bat_span_left(curve, b, -1), inner = last - first;
    bat_curve *piece;
    bat_status status = bat_curve_allocate(p, size, false, p + 1 + inner, &piece);
    if (status != BAT_OK) return status;
    for (int i = 0; i <= p; i++) {
        piece->knots[i] = start;
        piece->knots[p + 1 + inner + i] = end;
    }
    for (int i = 1; i <= inner; i++) {
        double t = curve->knots[first + i];
        piece->knots[p + i] = start == a ? t : start + (t - a);
    }
    for (int j = 0; j < piece->count; j++) {
        /* The window j+1..j+p holds some copies of a, then inner knots, then some of b. */
        int as = p - j > 0 ? p - j : 0, bs = j - inner > 0 ? j - inner : 0;
        int k = as > 0 ? first : first + j - p;
        double x[BAT_DEGREE_MAX];
        for (int i = 0; i < as; i++) x[i] = a;
        for (int i = 0; i < bs; i++) x[as + i] = b;
        bat_refined_point(curve, k, as + bs, x, piece->points + (size_t)j * (size_t)size);
    }
    return bat_curve_finish(piece, out);
}

bat_status bat_curve_unwind(const bat_curve *curve, int first, int last, bat_curve **out) {
    int p = curve->degree, n = curve->count;
    size_t size = (size_t)curve->dimension;
    const double *t = bat_curve_knots(curve), *points = bat_curve_points(curve);
    bat_curve *open;
    bat_status status = bat_curve_allocate(p, curve->dimension, false, last - first, &open);
    if (status != BAT_OK) return status;
    for (int j = first; j <= last + p; j++) {
        int turn = j >= 0 ? j / n : -((n - 1 - j) / n), i = j - turn * n;
        /* As bat_curve_unroll computes them, so that copies of one knot are equal. */
        double base = turn > 0 ? t[n] + (turn - 1) * (t[n] - t[0]) : t[0] + (turn + 1) * (t[n] - t[0]);
        open->knots[j - first] = turn == 0 ? t[i] : turn > 0 ? base + (t[i] - t[0]) : base + (t[i] - t[n]);
        if (j < last)
            memcpy(open->points + (size_t)(j - first) * size, points + (size_t)i * size,
                   size * sizeof(double));
    }
    *out = open;
    return BAT_OK;
}

/* A stretch of a closed curve that begins at a in the domain and is `length` long. */
static bat_status cut_closed(const bat_curve *curve, double a, double length, double start, double end,
                             bat_curve **out) {
    int n = curve->count, p = curve->degree;
    double t0 = curve->knots[p], t1 = curve->knots[curve->spread], b = a + length;
    if (length >= t1 - t0) b = t1 + (a - t0);
    if (b <= t1) return cut(curve, a, b, start, end, out);
    bat_curve *two;
    bat_status status = bat_curve_unwind(curve, -p, 2 * n, &two);
    if (status != BAT_OK) return status;
    status = cut(two, a, b, start, end, out);
    bat_curve_free(two);
    return status;
}

bat_status bat_curve_piece(const bat_curve *curve, double start, double end, bat_curve **out) {
    if (!curve || !out) return BAT_ARGUMENT;
    if (!(fabs(start) <= BAT_KNOT_MAX) || !(fabs(end) <= BAT_KNOT_MAX)) return BAT_NUMBER;
    double t0 = curve->knots[curve->degree], t1 = curve->knots[curve->spread], period = t1 - t0;
    if (!(start < end)) return BAT_PARAMETER;
    if (!curve->closed) {
        if (start < t0 || end > t1) return BAT_PARAMETER;
        return cut(curve, start, end, start, end, out);
    }
    double rounding = 4 * DBL_EPSILON * fmax(fabs(start), fabs(end));
    if (end - start > period + rounding) return BAT_PARAMETER;
    return cut_closed(curve, bat_curve_reduce(curve, start), fmin(end - start, period), start, end, out);
}

bat_status bat_curve_clamp(const bat_curve *curve, bat_curve **out) {
    if (!curve || !out || curve->closed) return BAT_ARGUMENT;
    return bat_curve_piece(curve, curve->knots[curve->degree], curve->knots[curve->spread], out);
}

bat_status bat_curve_split(const bat_curve *curve, double u, bat_curve **left, bat_curve **right) {
    if (!curve || !left || !right || curve->closed) return BAT_ARGUMENT;
    if (isnan(u)) return BAT_NUMBER;
    double t0 = curve->knots[curve->degree], t1 = curve->knots[curve->spread];
    if (!(u > t0 && u < t1)) return BAT_PARAMETER;
    bat_curve *a, *b;
    bat_status status = bat_curve_piece(curve, t0, u, &a);
    if (status != BAT_OK) return status;
    status = bat_curve_piece(curve, u, t1, &b);
    if (status != BAT_OK) {
        bat_curve_free(a);
        return status;
    }
    *left = a, *right = b;
    return BAT_OK;
}

bat_status bat_curve_open_at(const bat_curve *curve, double u, bat_curve **out) {
    if (!curve || !out || !curve->closed) return BAT_ARGUMENT;
    if (!isfinite(u)) return BAT_NUMBER;
    double t0 = curve->knots[curve->degree], t1 = curve->knots[curve->spread];
    double a = bat_curve_reduce(curve, u);
    return cut_closed(curve, a, t1 - t0, a, t1 + (a - t0), out);
}
