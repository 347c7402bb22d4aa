/* The blossom (polar form): Ramshaw 1987, P&T 5; de Boor's triangle with one argument per level. */
#include "curve/curve.h"

#include <math.h>
#include <string.h>

/* The farthest argument from the span first: knots then cancel exactly before anything is extrapolated, and
 * the result is the same to the bit in whatever order the arguments come. */
static void farthest_first(const double *arguments, int count, double middle, double *sorted) {
    for (int i = 0; i < count; i++) {
        double x = arguments[i], far = fabs(x - middle);
        int j = i;
        for (; j > 0; j--) {
            double before = fabs(sorted[j - 1] - middle);
            if (before > far || (before == far && sorted[j - 1] <= x)) break;
            sorted[j] = sorted[j - 1];
        }
        sorted[j] = x;
    }
}

void bat_curve_blossom_span(const bat_curve *curve, int span, const double *arguments, double *out) {
    int p = curve->degree, size = curve->dimension;
    const double *t = curve->knots + span;
    double d[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX], x[BAT_DEGREE_MAX];
    farthest_first(arguments, p, 0.5 * t[0] + 0.5 * t[1], x);
    memcpy(d, curve->points + (size_t)(span - p) * (size_t)size, (size_t)((p + 1) * size) * sizeof(double));
    for (int r = 1; r <= p; r++)
        for (int j = 0; j <= p - r; j++) {
            double left = t[j + r - p], right = t[j + 1];
            double w = (x[r - 1] - left) / (right - left), v = (right - x[r - 1]) / (right - left);
            for (int c = 0; c < size; c++) d[j * size + c] = v * d[j * size + c] + w * d[(j + 1) * size + c];
        }
    memcpy(out, d, (size_t)size * sizeof(double));
}

void bat_curve_blossom(const bat_curve *curve, double u, const double *arguments, bool left, double *out) {
    double v = left ? bat_curve_reduce_left(curve, u) : bat_curve_reduce(curve, u);
    if (isnan(v)) {
        for (int c = 0; c < curve->dimension; c++) out[c] = v;
        return;
    }
    int span = left ? bat_span_left(curve, v, -1) : bat_span(curve, v, -1);
    double moved[BAT_DEGREE_MAX];
    /* On a closed curve the arguments belong to the period of u. */
    for (int i = 0; i < curve->degree; i++) moved[i] = u == v ? arguments[i] : arguments[i] - (u - v);
    bat_curve_blossom_span(curve, span, curve->closed ? moved : arguments, out);
}
