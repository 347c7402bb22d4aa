/* Position and derivatives at one parameter. */
#include "curve/curve.h"
#include "base/lanes.h"

#include <math.h>
#include <string.h>

/* One derivative's value: basis functions of degree q times its control points. */
BAT_INLINE void combine(const double *basis, const double *points, int q, int size, double *out) {
    for (int c = 0; c < size; c++) {
        double sum = 0;
        for (int j = 0; j <= q; j++) sum += basis[j] * points[j * size + c];
        out[c] = sum;
    }
}

/* Derivatives come from differences of control points, not from derivatives of the basis: curves far from the
 * origin then lose no digits. */
void bat_eval_local(const double *t, int p, int size, int first, int order, double rows[][BAT_DEGREE_MAX + 1],
                    double *points, double *out) {
    for (int k = first; k <= order; k++, out += size) {
        if (k > p) {
            for (int c = 0; c < size; c++) out[c] = 0;
            continue;
        }
        for (int j = 0; k > 0 && j <= p - k; j++) {
            double scale = (p - k + 1) / (t[j + 1] - t[j + k - p]);
            for (int c = 0; c < size; c++)
                points[j * size + c] = (points[(j + 1) * size + c] - points[j * size + c]) * scale;
        }
        combine(rows[p - k], points, p - k, size, out);
    }
}

void bat_curve_eval_span(const bat_curve *curve, int span, double u, int order, double *out) {
    int p = curve->degree, size = curve->dimension;
    const double *points = curve->points + (size_t)(span - p) * (size_t)size;
    double rows[BAT_DEGREE_MAX + 1][BAT_DEGREE_MAX + 1];
    double d[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    bat_basis_rows(curve, span, u, rows);
    if (p == 3 && size == 2)
        combine(rows[3], points, 3, 2, out);
    else if (p == 3)
        combine(rows[3], points, 3, 3, out);
    else
        combine(rows[p], points, p, size, out);
    if (order <= 0) return;
    memcpy(d, points, (size_t)((p + 1) * size) * sizeof(double));
    bat_eval_local(curve->knots + span, p, size, 1, order, rows, d, out + size);
}

static void fill(const bat_curve *curve, int order, double value, double *out) {
    for (int i = 0; i < (order + 1) * curve->dimension; i++) out[i] = value;
}

void bat_curve_eval(const bat_curve *curve, double u, int order, double *out) {
    u = bat_curve_reduce(curve, u);
    if (isnan(u))
        fill(curve, order, u, out);
    else
        bat_curve_eval_span(curve, bat_span(curve, u, -1), u, order, out);
}

void bat_curve_eval_left(const bat_curve *curve, double u, int order, double *out) {
    u = bat_curve_reduce_left(curve, u);
    if (isnan(u))
        fill(curve, order, u, out);
    else
        bat_curve_eval_span(curve, bat_span_left(curve, u, -1), u, order, out);
}

double bat_curve_reduce_left(const bat_curve *curve, double u) {
    u = bat_curve_reduce(curve, u);
    return curve->closed && u == curve->knots[curve->degree] ? curve->knots[curve->spread] : u;
}
