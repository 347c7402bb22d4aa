#include "hands/figures/trace.h"
#include "base/real.h"

#include <math.h>
#include <string.h>

static const double APART = 1.5; /* px between two samples that count: trembling within it adds no length */
static const double LEAST = 12;  /* px: anything shorter is a dab */
static const double ROUND = 5.2,
                    GAP = 0.15; /* radians all round; share of the length left open by a closed stroke */

/* The next sample from *i on that lies away from `from`; false: there is none. */
static bool next(size_t count, const double *pixels, size_t *i, const double from[2], double to[2]) {
    for (; *i < count; ++*i) {
        const double *p = pixels + 2 * *i;
        if (!(fabs(p[0]) < 1e9 && fabs(p[1]) < 1e9) || bat_hypot(p[0] - from[0], p[1] - from[1]) < APART)
            continue;
        to[0] = p[0], to[1] = p[1];
        return true;
    }
    return false;
}

static bool first(size_t count, const double *pixels, size_t *i, double at[2]) {
    return next(count, pixels, i, (double[]){1e12, 1e12}, at);
}

static double length_of(size_t count, const double *pixels) {
    double at[2], to[2], length = 0;
    size_t i = 0;
    if (!first(count, pixels, &i, at)) return 0;
    while (next(count, pixels, &i, at, to)) {
        length += bat_hypot(to[0] - at[0], to[1] - at[1]);
        at[0] = to[0], at[1] = to[1];
    }
    return length;
}

static void spread(size_t count, const double *pixels, double length, double *out) {
    const double step = length / (BAT_TRACE_POINTS - 1);
    double at[2], to[2], gone = 0;
    size_t i = 0, made = 0;
    first(count, pixels, &i, at);
    while (made < BAT_TRACE_POINTS && next(count, pixels, &i, at, to)) {
        const double piece = bat_hypot(to[0] - at[0], to[1] - at[1]);
        for (; made < BAT_TRACE_POINTS && (double)made * step <= gone + piece; made++) {
            const double f = fmax(((double)made * step - gone) / piece, 0);
            for (int k = 0; k < 2; k++) out[2 * made + (size_t)k] = at[k] + f * (to[k] - at[k]);
        }
        gone += piece;
        at[0] = to[0], at[1] = to[1];
    }
    /* Rounding may have left out the last place. */
    for (; made < BAT_TRACE_POINTS; made++) memcpy(out + 2 * made, at, sizeof at);
}

static void measure_winding(bat_trace *trace) {
    const double *p = trace->at, *last = p + 2 * (BAT_TRACE_POINTS - 1);
    trace->winding = 0;
    for (size_t i = 0; i + 1 < BAT_TRACE_POINTS; i++, p += 2)
        trace->winding += bat_atan2(p[0] * p[3] - p[1] * p[2], p[0] * p[2] + p[1] * p[3]);
    const double gap = bat_hypot(last[0] - trace->at[0], last[1] - trace->at[1]);
    trace->closed = fabs(trace->winding) >= ROUND && (gap <= fmax(GAP * trace->length, LEAST / trace->size) ||
                                                      fabs(trace->winding) >= 2 * BAT_PI);
}

bool bat_trace_make(size_t count, const double *pixels, bat_trace *out) {
    const double length = length_of(count, pixels);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    if (!(length >= LEAST)) return false;
    spread(count, pixels, length, out->at);
    out->middle[0] = out->middle[1] = 0;
    for (size_t i = 0; i < 2 * BAT_TRACE_POINTS; i++) {
        out->middle[i & 1] += out->at[i] / BAT_TRACE_POINTS;
        low[i & 1] = fmin(low[i & 1], out->at[i]);
        high[i & 1] = fmax(high[i & 1], out->at[i]);
    }
    out->size = bat_hypot(high[0] - low[0], high[1] - low[1]);
    for (size_t i = 0; i < 2 * BAT_TRACE_POINTS; i++)
        out->at[i] = (out->at[i] - out->middle[i & 1]) / out->size;
    out->length = length / out->size;
    measure_winding(out);
    return true;
}

void bat_small_add(int n, const double *row, double value, double weight, double *a, double *b) {
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) a[i * n + j] += weight * row[i] * row[j];
        b[i] += weight * row[i] * value;
    }
}

bool bat_small_solve(int n, double *a, double *b) {
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(a[i * n + k]) > fabs(a[best * n + k])) best = i;
        if (!(fabs(a[best * n + k]) > 1e-300)) return false;
        for (int j = 0; j < n && best != k; j++) {
            const double swap = a[k * n + j];
            a[k * n + j] = a[best * n + j], a[best * n + j] = swap;
        }
        const double swap = b[k];
        b[k] = b[best], b[best] = swap;
        for (int i = k + 1; i < n; i++) {
            const double f = a[i * n + k] / a[k * n + k];
            for (int j = k; j < n; j++) a[i * n + j] -= f * a[k * n + j];
            b[i] -= f * b[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++) b[k] -= a[k * n + j] * b[j];
        b[k] /= a[k * n + k];
    }
    return true;
}
