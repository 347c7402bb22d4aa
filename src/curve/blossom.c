/* The blossom (polar form): Ramshaw 1987, P&T 5; de Boor's triangle with one argument per level. */
#include "curve/curve.h"

#include "base/lanes.h"

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

/* One level r of the triangle, with argument x; where x is one of the knots that a point lies between, it stays. */
BAT_INLINE void level(const double *t, int p, int r, double x, int size, double *d) {
    for (int j = 0; j <= p - r; j++) {
        const double left = t[j + r - p], right = t[j + 1];
        double *a = d + j * size, *b = a + size;
        if (x == left) continue;
        const double w = (x - left) / (right - left), v = (right - x) / (right - left);
        for (int c = 0; c < size; c++) a[c] = x == right ? b[c] : v * a[c] + w * b[c];
    }
}

/* d: p + 1 points of that size; used up. */
BAT_INLINE void bezier(const double *t, int p, int size, double *d, double *out) {
    for (int j = p;; j--) { /* p - j levels at the start are done; j at the end follow */
        double own[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
        memcpy(own, d, (size_t)((j + 1) * size) * sizeof *own);
        for (int r = p - j + 1; r <= p; r++) level(t, p, r, t[1], size, own);
        for (int c = 0; c < size; c++) out[j * size + c] = own[c];
        if (j == 0) return;
        level(t, p, p - j + 1, t[0], size, d);
    }
}

void bat_span_bezier(const bat_curve *curve, int span, double *out) {
    const int p = curve->degree, size = curve->dimension;
    const double *t = curve->knots + span;
    double d[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    memcpy(d, curve->points + (size_t)(span - p) * (size_t)size, (size_t)((p + 1) * size) * sizeof(double));
    if (p == 3 && size == 2) /* the usual case, unrolled */
        bezier(t, 3, 2, d, out);
    else
        bezier(t, p, size, d, out);
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
