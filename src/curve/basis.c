/* Spans, parameters and the B-spline basis functions (de Boor 1972, P&T 2.5). */
#include "curve/curve.h"
#include "base/lanes.h"

#include <math.h>

int bat_span(const bat_curve *curve, double u, int hint) {
    const double *t = curve->knots;
    int low = curve->degree, high = curve->spread;
    if (hint >= low && hint < high && t[hint] <= u) {
        if (u < t[hint + 1]) return hint;
        low = hint;
        if (hint + 2 <= high && u < t[hint + 2]) return hint + 1;
    }
    if (u >= t[high]) {
        while (t[high - 1] == t[high]) high--; /* closed curves may have an empty last span */
        return high - 1;
    }
    while (high - low > 1) { /* t[low] <= u < t[high] */
        int middle = low + (high - low) / 2;
        if (t[middle] <= u)
            low = middle;
        else
            high = middle;
    }
    return low;
}

int bat_span_left(const bat_curve *curve, double u, int hint) {
    const double *t = curve->knots;
    int i = bat_span(curve, u, hint), first = curve->degree;
    if (t[i] < u) return i;
    while (i > first && t[i] == u) i--;
    while (t[i] == t[i + 1]) i++; /* u is the start of the domain */
    return i;
}

double bat_curve_reduce(const bat_curve *curve, double u) {
    double start = curve->knots[curve->degree], end = curve->knots[curve->spread];
    if (u >= start && u < end) return u;
    if (!curve->closed) return u < start ? start : u > end ? end : u;
    double period = end - start, r = fmod(u - start, period);
    if (r < 0) r += period;
    r += start;
    return r >= end ? start : r;
}

/* All rows of the Cox-de Boor triangle: row q holds the q + 1 functions of degree q that do not vanish on the
 * span. Every denominator straddles the span, so none is zero. */
BAT_INLINE void triangle(const double *t, int degree, double u, double rows[][BAT_DEGREE_MAX + 1]) {
    rows[0][0] = 1;
    for (int q = 1; q <= degree; q++) {
        double saved = 0;
        for (int j = 0; j < q; j++) {
            double right = t[j + 1], left = t[j + 1 - q];
            double w = rows[q - 1][j] / (right - left);
            rows[q][j] = saved + (right - u) * w;
            saved = (u - left) * w;
        }
        rows[q][q] = saved;
    }
}

void bat_basis_rows(const bat_curve *curve, int span, double u, double rows[][BAT_DEGREE_MAX + 1]) {
    if (curve->degree == 3) /* known degree: straight code, the same operations */
        triangle(curve->knots + span, 3, u, rows);
    else
        triangle(curve->knots + span, curve->degree, u, rows);
}

void bat_basis(const bat_curve *curve, int span, double u, int order, double *out) {
    int p = curve->degree;
    const double *t = curve->knots + span;
    double rows[BAT_DEGREE_MAX + 1][BAT_DEGREE_MAX + 1];
    triangle(t, p, u, rows);
    for (int k = 0; k <= order; k++, out += p + 1) {
        if (k > p) {
            for (int j = 0; j <= p; j++) out[j] = 0;
            continue;
        }
        for (int j = 0; j <= p - k; j++) out[j] = rows[p - k][j];
        /* N'_{g,q+1} = (q+1) (N_{g,q} / (t_{g+q+1} - t_g) - N_{g+1,q} / (t_{g+q+2} - t_{g+1})), k times. */
        for (int q = p - k; q < p; q++) {
            double before = 0;
            for (int j = 0; j <= q; j++) {
                double w = (q + 1) * out[j] / (t[j + 1] - t[j - q]);
                out[j] = before - w;
                before = w;
            }
            out[q + 1] = before;
        }
    }
}

void bat_curve_basis(const bat_curve *curve, double u, int *first, double *values) {
    u = bat_curve_reduce(curve, u);
    int p = curve->degree, n = curve->count;
    if (isnan(u)) {
        *first = 0;
        for (int j = 0; j <= p; j++) values[j] = u;
        return;
    }
    int span = bat_span(curve, u, -1);
    bat_basis(curve, span, u, 0, values);
    *first = span - p;
    if (curve->closed) *first = ((span - 2 * p) % n + n) % n;
}

void bat_curve_greville(const bat_curve *curve, double *out) {
    int p = curve->degree;
    const double *t = bat_curve_knots(curve); /* closed: reaches into the next period, which is stored */
    for (int i = 0; i < curve->count; i++) {
        double sum = 0;
        for (int j = 2; j <= p; j++) sum += t[i + j] - t[i + 1];
        out[i] = t[i + 1] + sum / p;
    }
}
