/*
 * Position and derivatives at many parameters: a span becomes its Taylor polynomial about the middle once,
 * and the run of parameters in that span goes through Horner's rule. About the middle |s| <= h / 2, so
 * coefficients are no larger than Chebyshev's bound allows and no digits are lost.
 */
#include "curve/piece.h"

#include <math.h>

/* Derivatives are written as cubics too, with zeros in front: one rule for the whole block, which compilers
 * vectorise across the block, or across the points when there are no derivatives. */
BAT_INLINE void cubic_run(const bat_piece *f, size_t count, const double *restrict u, double *restrict out,
                          int size, int order) {
    double m = f->middle, a[4][3 * BAT_DIMENSION_MAX];
    int block = size * (order + 1);
    for (int k = 0; k <= order; k++)
        for (int c = 0; c < size; c++)
            for (int j = 0; j < 4; j++) {
                double factor = k == 0 ? 1 : k == 1 ? j + 1 : (j + 1) * (j + 2);
                a[j][k * size + c] = j + k > 3 ? 0 : factor * f->c[(j + k) * size + c];
            }
    for (size_t i = 0; i < count; i++, out += block) {
        double s = u[i] - m;
        for (int j = 0; j < block; j++) out[j] = ((a[3][j] * s + a[2][j]) * s + a[1][j]) * s + a[0][j];
    }
}

static void any_run(const bat_piece *f, int p, int size, size_t count, const double *u, int order,
                    double *out) {
    for (size_t i = 0; i < count; i++) {
        double s = u[i] - f->middle;
        for (int k = 0; k <= order; k++, out += size) {
            for (int c = 0; c < size; c++) {
                double value = 0;
                for (int j = p; j >= k; j--) {
                    double factor = 1; /* j (j-1) .. (j-k+1) */
                    for (int n = 0; n < k; n++) factor *= j - n;
                    value = value * s + factor * f->c[j * size + c];
                }
                out[c] = value;
            }
        }
    }
}

/* How many of u[0..count) are below `end` (or equal to it, when `with` says so); u[0] is known to be. */
static size_t run_length(const double *u, size_t count, double end, bool with) {
    size_t low = 0, step = 1;
    while (low + step < count && (u[low + step] < end || (with && u[low + step] == end)))
        low += step, step *= 2;
    size_t high = low + step < count ? low + step : count; /* u[low] is in, u[high] is out */
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (u[middle] < end || (with && u[middle] == end))
            low = middle;
        else
            high = middle;
    }
    return high;
}

BAT_INLINE void cubic_spans(const bat_curve *curve, size_t count, const double *u, double *out, int size,
                            int order) {
    int span = -1, last = bat_span(curve, curve->knots[curve->spread], -1);
    bat_piece f;
    for (size_t i = 0; i < count;) {
        span = bat_span(curve, u[i], span);
        size_t n = run_length(u + i, count - i, curve->knots[span + 1], span == last);
        bat_piece_cubic(curve->knots + span, curve->points + (span - 3) * size, &f, size);
        cubic_run(&f, n, u + i, out + i * (size_t)(size * (order + 1)), size, order);
        i += n;
    }
}

#define CUBIC(name, size, order)                                                                             \
    BAT_CLONES static void name(const bat_curve *curve, size_t count, const double *u, double *out) {        \
        cubic_spans(curve, count, u, out, size, order);                                                      \
    }
CUBIC(cubic_2_0, 2, 0)
CUBIC(cubic_2_1, 2, 1)
CUBIC(cubic_2_2, 2, 2)
CUBIC(cubic_3_0, 3, 0)
CUBIC(cubic_3_1, 3, 1)
CUBIC(cubic_3_2, 3, 2)

static void any_spans(const bat_curve *curve, size_t count, const double *u, int order, double *out) {
    int span = -1, last = bat_span(curve, curve->knots[curve->spread], -1);
    size_t block = ((size_t)order + 1) * (size_t)curve->dimension;
    for (size_t i = 0; i < count;) {
        bat_piece f;
        span = bat_span(curve, u[i], span);
        size_t n = run_length(u + i, count - i, curve->knots[span + 1], span == last);
        bat_piece_any(curve, span, &f);
        any_run(&f, curve->degree, curve->dimension, n, u + i, order, out + i * block);
        i += n;
    }
}

/* No NaN, and ascending: one pass without branches. */
BAT_CLONES static bool ascending(const double *u, size_t count) {
    long long fault = 0;
    for (size_t i = 1; i < count; i++) fault |= !(u[i - 1] <= u[i]);
    return !fault;
}

bat_status bat_parameters_check(size_t count, const double *u) {
    if (count == 0 || (!isnan(u[0]) && ascending(u, count))) return BAT_OK;
    for (size_t i = 0; i < count; i++)
        if (isnan(u[i])) return BAT_NUMBER;
    return BAT_PARAMETER;
}

void bat_curve_eval_sorted(const bat_curve *curve, size_t count, const double *u, int order, double *out) {
    typedef void cubic(const bat_curve *, size_t, const double *, double *);
    static cubic *const cubics[2][3] = {{cubic_2_0, cubic_2_1, cubic_2_2}, {cubic_3_0, cubic_3_1, cubic_3_2}};
    size_t block = ((size_t)order + 1) * (size_t)curve->dimension, first = 0, last;
    double start = curve->knots[curve->degree], end = curve->knots[curve->spread];
    /* Parameters outside the domain are clamped or taken modulo the period one by one. */
    for (; first < count && u[first] < start; first++)
        bat_curve_eval(curve, u[first], order, out + first * block);
    bool with = !curve->closed;
    last = first;
    if (first < count && (u[first] < end || (with && u[first] == end)))
        last += run_length(u + first, count - first, end, with);
    if (last > first) {
        if (curve->degree == 3 && order <= 2)
            cubics[curve->dimension - 2][order](curve, last - first, u + first, out + first * block);
        else
            any_spans(curve, last - first, u + first, order, out + first * block);
    }
    for (; last < count; last++) bat_curve_eval(curve, u[last], order, out + last * block);
}

bat_status bat_curve_eval_many(const bat_curve *curve, size_t count, const double *u, int order,
                               double *out) {
    if (!curve || order < 0 || (count > 0 && (!u || !out))) return BAT_ARGUMENT;
    bat_status status = bat_parameters_check(count, u);
    if (status == BAT_OK) bat_curve_eval_sorted(curve, count, u, order, out);
    return status;
}

void bat_curve_spread(const bat_curve *curve, size_t count, double *u) {
    double start = curve->knots[curve->degree], end = curve->knots[curve->spread];
    size_t steps = curve->closed ? count : count - 1;
    for (size_t i = 0; i < count; i++) {
        double w = steps > 0 ? (double)i / (double)steps : 0;
        u[i] = fmin(start + w * (end - start), end);
    }
    if (!curve->closed && count > 1) u[count - 1] = end;
}
