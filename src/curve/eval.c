/* Position and derivatives at one parameter. */
#include "curve/curve.h"

#include <math.h>
#include <string.h>

/* Derivatives come from differences of control points, not from derivatives of the basis: curves far from the
 * origin then lose no digits. */
void bat_curve_eval_span(const bat_curve *curve, int span, double u, int order, double *out) {
    int p = curve->degree, size = curve->dimension;
    const double *t = curve->knots + span;
    const double *points = curve->points + (size_t)(span - p) * (size_t)size;
    double rows[BAT_DEGREE_MAX + 1][BAT_DEGREE_MAX + 1];
    double d[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    bat_basis_rows(curve, span, u, rows);
    for (int c = 0; c < size; c++) {
        double sum = 0;
        for (int j = 0; j <= p; j++) sum += rows[p][j] * points[j * size + c];
        out[c] = sum;
    }
    if (order <= 0) return;
    memcpy(d, points, (size_t)((p + 1) * size) * sizeof(double));
    for (int k = 1; k <= order; k++) {
        out += size;
        if (k > p) {
            for (int c = 0; c < size; c++) out[c] = 0;
            continue;
        }
        for (int j = 0; j <= p - k; j++) {
            double scale = (p - k + 1) / (t[j + 1] - t[j + k - p]);
            for (int c = 0; c < size; c++)
                d[j * size + c] = (d[(j + 1) * size + c] - d[j * size + c]) * scale;
        }
        for (int c = 0; c < size; c++) {
            double sum = 0;
            for (int j = 0; j <= p - k; j++) sum += rows[p - k][j] * d[j * size + c];
            out[c] = sum;
        }
    }
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
