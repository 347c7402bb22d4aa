#include "curve/hidden.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const double stands_out = 12; /* medians */

/* The difference of order degree + 1 that begins at sample i. */
static void difference(const bat_hidden *h, size_t i, double *d) {
    const size_t m = (size_t)h->dimension, order = (size_t)h->degree + 1;
    double factor = order % 2 ? -1 : 1;
    memset(d, 0, m * sizeof *d);
    for (size_t k = 0; k <= order; k++) {
        const double *x = h->points + (i + k * h->stride) % h->count * m;
        for (size_t c = 0; c < m; c++) d[c] += factor * x[c];
        factor *= -(double)(order - k) / (double)(k + 1);
    }
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

/* The first moment of the jump's B-spline is the knot. size: by difference, `n` of them. */
static double place(const bat_hidden *h, size_t from, size_t to, const double *size, size_t n) {
    const size_t m = (size_t)h->dimension;
    size_t top = from;
    for (size_t i = from; i < to; i++)
        if (size[i % n] > size[top % n]) top = i;
    double way[BAT_DIMENSION_MAX], d[BAT_DIMENSION_MAX], sum = 0, moment = 0;
    difference(h, top, way);
    for (size_t i = from; i < to; i++) {
        double part = 0;
        difference(h, i, d);
        for (size_t c = 0; c < m; c++) part += d[c] * way[c];
        sum += part, moment += part * (double)i;
    }
    return moment / sum + 0.5 * (double)(h->stride * (size_t)(h->degree + 1));
}

/* What rounding of the points makes of a difference, at most. */
static double rounding(const bat_hidden *h) {
    double most = 0;
    for (size_t i = 0; i < h->count * (size_t)h->dimension; i++) most = fmax(most, fabs(h->points[i]));
    return ldexp(32 * DBL_EPSILON * most, h->degree + 1);
}

bool bat_hidden_knots(const bat_hidden *h, double noise, double *work, double *knots, size_t *found) {
    const size_t reach = h->stride * ((size_t)h->degree + 1); /* samples that one knot affects */
    *found = 0;
    if (h->count < 4 * reach) return false;
    const size_t n = h->closed ? h->count : h->count - reach;
    double d[BAT_DIMENSION_MAX];
    size_t over = 0; /* when most are noisy, so is the median */
    for (size_t i = 0; i < n; i++) {
        difference(h, i, d);
        work[i] = size_of(d, (size_t)h->dimension);
        over += !(work[i] <= noise);
        if (2 * over > n) return false;
    }
    const double usual = median(work, n), least = fmax(stands_out * usual, rounding(h));
    if (!(usual <= noise)) return false;
    size_t start = 0;
    while (h->closed && start < n && work[start] > least) start++; /* not in the midst of a knot */
    double last = 0, end = h->closed ? INFINITY : (double)h->count - 1;
    for (size_t i = start; i < start + n;) {
        if (!(work[i % n] > least)) {
            i++;
            continue;
        }
        const size_t from = i;
        while (i < start + n && work[i % n] > least) i++;
        const size_t parts = i - from > reach + h->stride ? (i - from + reach - 1) / reach : 1;
        for (size_t k = 0; k < parts; k++) {
            const size_t a = from + k * (i - from) / parts, b = from + (k + 1) * (i - from) / parts;
            const double knot = place(h, a, b, work, n);
            if (!(knot > last + 0.01 && knot < end - 0.01)) continue;
            if (h->closed && *found == 0) end = knot + (double)h->count;
            knots[(*found)++] = last = knot;
        }
    }
    return true;
}
