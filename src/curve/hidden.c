#include "curve/hidden.h"

#include <math.h>
#include <string.h>

enum { LONGEST = 5, CLOSE = 4 };     /* samples that one knot affects; samples per knot, where several meet */
static const double stands_out = 12; /* medians */

static void fourth(const double *x, size_t m, double *d) {
    for (size_t c = 0; c < m; c++)
        d[c] = x[c] - 4 * x[m + c] + 6 * x[2 * m + c] - 4 * x[3 * m + c] + x[4 * m + c];
}

static double size_of(const double *d, size_t m) {
    double sum = 0;
    for (size_t c = 0; c < m; c++) sum += d[c] * d[c];
    return sqrt(sum);
}

/* The median, by halving the range of exponents and then of values: the array need not be sorted. */
static double median(const double *values, size_t count) {
    double low = 0, high = 0;
    for (size_t i = 0; i < count; i++) high = fmax(high, values[i]);
    for (int round = 0; round < 80 && high > low; round++) {
        const double middle = round < 40 && low == 0 ? high * 1e-3 : 0.5 * (low + high);
        size_t under = 0;
        for (size_t i = 0; i < count; i++) under += values[i] <= middle;
        if (2 * under >= count)
            high = middle;
        else
            low = middle;
    }
    return high;
}

/* The first moment of the jump's B-spline is the knot. */
static double place(const double *points, size_t m, size_t from, size_t to, const double *size) {
    size_t top = from;
    for (size_t i = from; i < to; i++)
        if (size[i] > size[top]) top = i;
    double way[BAT_DIMENSION_MAX], d[BAT_DIMENSION_MAX], sum = 0, moment = 0;
    fourth(points + top * m, m, way);
    for (size_t i = from; i < to; i++) {
        double part = 0;
        fourth(points + i * m, m, d);
        for (size_t c = 0; c < m; c++) part += d[c] * way[c];
        sum += part, moment += part * (double)i;
    }
    return moment / sum + 2;
}

size_t bat_hidden_knots(int dimension, size_t count, const double *points, double noise, double *work,
                        double *knots) {
    const size_t m = (size_t)dimension;
    if (count < 16) return 0;
    const size_t n = count - 4;
    double d[BAT_DIMENSION_MAX];
    for (size_t i = 0; i < n; i++) {
        fourth(points + i * m, m, d);
        work[i] = size_of(d, m);
    }
    const double usual = median(work, n);
    if (!(usual <= noise)) return 0;
    size_t found = 0;
    double last = 0;
    for (size_t i = 0; i < n;) {
        if (!(work[i] > stands_out * usual)) {
            i++;
            continue;
        }
        const size_t from = i;
        while (i < n && work[i] > stands_out * usual) i++;
        const size_t parts = i - from > LONGEST ? (i - from + CLOSE - 1) / CLOSE : 1;
        for (size_t k = 0; k < parts; k++) {
            const size_t a = from + k * (i - from) / parts, b = from + (k + 1) * (i - from) / parts;
            const double knot = place(points, m, a, b, work);
            if (!(knot > last + 0.01 && knot < (double)count - 1.01)) continue;
            knots[found++] = last = knot;
        }
    }
    return found;
}
