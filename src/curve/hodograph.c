/* The derivative of a span as a polynomial, and arc lengths from it. */
#include "curve/hodograph.h"

#include "curve/lsq.h"
#include "base/gauss.h"
#include "base/real.h"

#include <float.h>
#include <math.h>

enum { ORDERS = BAT_DEGREE_MAX + 1 };

static void rescale(bat_hodograph *h, double density) {
    double greatest = 0, sum = 0, slope = 0;
    int exponent = 0;
    const int count = h->terms * h->dimension;
    for (int i = 0; i < count; i++) greatest = fmax(greatest, fabs(h->c[i]));
    if (isfinite(greatest)) frexp(greatest, &exponent);
    h->scale = ldexp(1, exponent);
    for (int i = 0; i < count; i++) {
        h->c[i] = ldexp(h->c[i], -exponent);
        sum += fabs(h->c[i]);
        slope += (double)(i / h->dimension) * fabs(h->c[i]);
    }
    /* From the sum, and from u: in a span that is narrow for where it lies, few digits of the place in it are
     * left. */
    h->noise = DBL_EPSILON * (4 * sum + (1 + fabs(h->middle) / h->half) * slope);
    h->density = density / h->scale;
}

void bat_hodograph_of(const bat_curve *curve, int slot, double density, bat_hodograph *out) {
    const int p = curve->degree, m = curve->dimension, w = p + 1;
    const double *t = curve->knots + p + slot;
    const double *P = curve->points + (size_t)slot * (size_t)m;
    double T[ORDERS * ORDERS];
    bat_lsq_transform(curve, slot, T);
    out->terms = p, out->dimension = m, out->middle = t[0] + 0.5 * (t[1] - t[0]),
    out->half = 0.5 * (t[1] - t[0]);
    for (int k = 1; k <= p; k++)
        for (int c = 0; c < m; c++) {
            double sum = 0; /* relative to the first point: far from the origin no digits are lost */
            for (int j = 1; j < w; j++) sum += T[k * w + j] * (P[j * m + c] - P[c]);
            out->c[(k - 1) * m + c] = sum * k / out->half;
        }
    rescale(out, density);
}

double bat_hodograph_speed(const bat_hodograph *h, double u) {
    const double s = (u - h->middle) / h->half;
    double sum = 0;
    for (int c = 0; c < h->dimension; c++) {
        double d = 0;
        for (int k = h->terms - 1; k >= 0; k--) d = d * s + h->c[k * h->dimension + c];
        sum += d * d;
    }
    return sqrt(sum);
}

static double speed_of(const void *context, double u) { return bat_hodograph_speed(context, u); }

double bat_hodograph_gauss(const bat_hodograph *h, double a, double b) {
    return bat_gauss(speed_of, h, a, b);
}

/* Adaptive: accepted when two halves agree with the whole to `relative` of it, or to what is allowed per unit
 * of u, or as well as rounding lets them. At a cusp only one branch goes deep, and the depth is limited. */
static double adapt(const bat_hodograph *h, double a, double b, double whole, double relative, int depth) {
    const double middle = 0.5 * (a + b);
    const double left = bat_hodograph_gauss(h, a, middle), right = bat_hodograph_gauss(h, middle, b),
                 sum = left + right;
    const double gap = fabs(sum - whole);
    if (depth == 0 || !(gap > relative * sum && gap > (h->density + h->noise) * (b - a)) ||
        !(middle > a && middle < b))
        return sum;
    return adapt(h, a, middle, left, relative, depth - 1) + adapt(h, middle, b, right, relative, depth - 1);
}

/* In units of the scale. */
double bat_hodograph_length(const bat_hodograph *h, double a, double b, double relative) {
    return b > a ? adapt(h, a, b, bat_hodograph_gauss(h, a, b), relative, 40) : 0;
}

/* Error allowed per unit of u, from the length of the control polygon. */
double bat_hodograph_density(const bat_curve *curve, double relative) {
    double sum = 0;
    const int m = curve->dimension;
    for (int i = 1; i < curve->spread; i++) {
        double d = 0;
        for (int c = 0; c < m; c++)
            d = bat_hypot(d, curve->points[(size_t)i * (size_t)m + (size_t)c] -
                                 curve->points[(size_t)(i - 1) * (size_t)m + (size_t)c]);
        sum += d;
    }
    return 0.1 * relative * sum / (curve->knots[curve->spread] - curve->knots[curve->degree]);
}

/* Where the length from a reaches s, forwards, a <= u <= b in one slot; total: the length of a..b. Both in units of the
 * scale. */
double bat_hodograph_at_length(const bat_hodograph *h, double a, double b, double s, double total,
                               double relative) {
    const double near = fmax(0.1 * relative, 4 * DBL_EPSILON) * total + h->noise * (b - a);
    double low = a, high = b, before = 0, u = a + (b - a) * (s / total);
    for (int step = 0; step < 100; step++) {
        if (!(u > low && u < high)) u = 0.5 * (low + high);
        if (!(u > low && u < high)) break;
        const double at = before + bat_hodograph_length(h, low, u, relative), miss = s - at;
        if (fabs(miss) <= near) return u;
        const double v = bat_hodograph_speed(h, u);
        if (miss > 0)
            low = u, before = at;
        else
            high = u;
        u = v > 0 ? u + miss / v : high;
    }
    return u;
}
