/*
 * Knot insertion: one blossom for each new point (Goldman 1990; the restricted triangle of Boehm 1980),
 * untouched points copied bitwise.
 */
#include "curve/curve.h"
#include "base/lanes.h"

#include <batten/refine.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Each level is a convex combination: t_c <= t_k <= x <= t_{k+p-m+1} <= t_{c+p-r+1}. */
BAT_INLINE void refined(const double *t, const double *points, int p, int size, int m, const double *x,
                        double *out) {
    double d[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    for (int i = 0; i < (m + 1) * size; i++) d[i] = points[i];
    for (int r = 1; r <= m; r++) {
        double w[BAT_DEGREE_MAX]; /* first, so that their divisions are made side by side */
        for (int j = 0; j <= m - r; j++) w[j] = (x[r - 1] - t[j + r]) / (t[j + p + 1] - t[j + r]);
        for (int j = 0; j <= m - r; j++) /* c = k - m + r + j */
            for (int c = 0; c < size; c++)
                d[j * size + c] = (1 - w[j]) * d[j * size + c] + w[j] * d[(j + 1) * size + c];
    }
    for (int c = 0; c < size; c++) out[c] = d[c];
}

void bat_refined_point(const bat_curve *old, int k, int m, const double *x, double *out) {
    const double *points = old->points + (size_t)(k - m) * (size_t)old->dimension;
    refined(old->knots + (k - m), points, old->degree, old->dimension, m, x, out);
}

/* Points from..to-1: j is the blossom at tau_{j+1}..tau_{j+p}; rank tells which of these are new. */
BAT_INLINE void fill(const bat_curve *old, const double *tau, const int *rank, int p, int size, int from,
                     int to, double *points) {
    for (int j = from; j < to; j++) {
        double x[BAT_DEGREE_MAX];
        int m = 0, k = rank[j] - 1;
        for (int i = j + 1; i <= j + p; i++) { /* without a branch that cannot be predicted */
            x[m < p ? m : 0] = tau[i];
            m += rank[i] == rank[i - 1];
        }
        const double *t = old->knots + (k - m), *source = old->points + (k - m) * size;
        double *out = points + j * size;
        /* Constant counts turn the loops into straight-line code. */
        switch (m) {
        case 0: refined(t, source, p, size, 0, x, out); break;
        case 1: refined(t, source, p, size, 1, x, out); break;
        case 2: refined(t, source, p, size, 2, x, out); break;
        case 3: refined(t, source, p, size, 3, x, out); break;
        default: refined(t, source, p, size, m, x, out);
        }
    }
}

void bat_refine_points(const bat_curve *old, bat_curve *fresh, const int *rank, int from, int to) {
    if (old->degree == 3 && old->dimension == 2)
        fill(old, fresh->knots, rank, 3, 2, from, to, fresh->points);
    else if (old->degree == 3)
        fill(old, fresh->knots, rank, 3, 3, from, to, fresh->points);
    else
        fill(old, fresh->knots, rank, old->degree, old->dimension, from, to, fresh->points);
}

/* rank[j]: how many stored old knots are among the merged ones up to and with j. In a closed curve the merged
 * period repeats to both sides. */
static void unroll_rank(const bat_curve *old, const bat_curve *fresh, int *rank) {
    int p = old->degree;
    for (int j = p - 1; j >= 0; j--) rank[j] = rank[j + fresh->count] - old->count;
    for (int j = fresh->spread + 1; j <= fresh->spread + p; j++)
        rank[j] = rank[j - fresh->count] + old->count;
}

bool bat_refine_rank(const bat_curve *old, const bat_curve *fresh, int *rank) {
    const double *t = bat_curve_knots(old), *tau = bat_curve_knots(fresh), end = old->knots[old->spread];
    int total = bat_curve_knot_count(old), whole = bat_curve_knot_count(fresh), i = 0;
    int lead = old->closed ? old->degree : 0;
    for (int j = 0; j < whole; j++) {
        /* Of knots equal to the end of the domain the new ones come first. */
        bool is_new = i == total || tau[j] != t[i] || (t[i] == end && whole - j > total - i);
        i += !is_new;
        rank[lead + j] = lead + i;
    }
    if (i == total && old->closed) unroll_rank(old, fresh, rank);
    return i == total;
}

/* New knots go behind equal old ones, but before those equal to the end of the domain: every blossom then
 * finds its old points. */
static void merge(const bat_curve *old, int count, const double *u, double *tau, int *rank) {
    const double *t = bat_curve_knots(old);
    int total = bat_curve_knot_count(old), seen = old->closed ? old->degree : 0;
    double end = old->knots[old->spread];
    for (int i = 0, j = 0; i < total || j < count;) {
        bool take_new = i == total || (j < count && (u[j] < t[i] || (u[j] == t[i] && u[j] == end)));
        if (take_new)
            *tau++ = u[j++];
        else
            *tau++ = t[i++], seen++;
        *rank++ = seen;
    }
}

/* An unclamped end that takes a knot lets go of its outermost knot and point, so that the domain stays. */
static bat_status trim(bat_curve *fresh, int front, int back, bat_curve **out) {
    int p = fresh->degree;
    size_t size = (size_t)fresh->dimension;
    bat_curve *less;
    bat_status status = bat_curve_allocate(p, fresh->dimension, false, fresh->count - front - back, &less);
    if (status == BAT_OK) {
        memcpy(less->knots, fresh->knots + front, (size_t)(less->count + p + 1) * sizeof(double));
        memcpy(less->points, fresh->points + (size_t)front * size,
               (size_t)less->count * size * sizeof(double));
        status = bat_curve_finish(less, out);
    }
    bat_curve_free(fresh);
    return status;
}

bat_status bat_curve_insert_knots(const bat_curve *curve, int knot_count, const double *knots,
                                  bat_curve **out) {
    if (!curve || !out || knot_count < 0 || (knot_count > 0 && !knots)) return BAT_ARGUMENT;
    if (knot_count > BAT_POINTS_MAX - curve->count) return BAT_COUNT;
    bat_status status = bat_parameters_check((size_t)knot_count, knots);
    if (status != BAT_OK) return status;
    double start = curve->knots[curve->degree], end = curve->knots[curve->spread];
    int front = 0, back = 0;
    if (knot_count > 0 && (knots[0] < start || knots[knot_count - 1] > end)) return BAT_PARAMETER;
    while (front < knot_count && knots[front] == start) front++;
    while (back < knot_count && knots[knot_count - 1 - back] == end) back++;
    if (curve->closed) front = back = 0;
    int p = curve->degree;
    if (front + back > 0 && (front + bat_knot_multiplicity(curve, start) > p + 1 ||
                             back + bat_knot_multiplicity(curve, end) > p + 1))
        return BAT_KNOTS;

    bat_curve *fresh;
    status = bat_curve_allocate(p, curve->dimension, curve->closed, curve->count + knot_count, &fresh);
    if (status != BAT_OK) return status;
    int *rank = malloc(((size_t)fresh->spread + (size_t)p + 1) * sizeof(int));
    if (!rank) {
        bat_curve_free(fresh);
        return BAT_MEMORY;
    }
    merge(curve, knot_count, knots, bat_curve_own_knots(fresh), rank + (curve->closed ? p : 0));
    if (front + back == 0) status = bat_knots_check(p, curve->closed, fresh->count, bat_curve_knots(fresh));
    if (status == BAT_OK) {
        if (curve->closed) unroll_rank(curve, fresh, rank);
        bat_curve_unroll(fresh);
        bat_refine_points(curve, fresh, rank, front, fresh->spread - back);
    }
    if (status == BAT_OK) status = bat_points_check(fresh);
    free(rank);
    if (status != BAT_OK) {
        bat_curve_free(fresh);
        return status;
    }
    if (front + back > 0) return trim(fresh, front, back, out);
    bat_curve_unroll(fresh);
    *out = fresh;
    return BAT_OK;
}

bat_status bat_curve_insert_knot(const bat_curve *curve, double u, int times, bat_curve **out) {
    if (!curve || !out || times < 0) return BAT_ARGUMENT;
    if (times > BAT_DEGREE_MAX + 1) return BAT_KNOTS;
    double many[BAT_DEGREE_MAX + 1];
    if (isnan(u)) return BAT_NUMBER;
    if (curve->closed) u = bat_curve_reduce(curve, u);
    if (isnan(u)) return BAT_NUMBER;
    for (int i = 0; i < times; i++) many[i] = u;
    return bat_curve_insert_knots(curve, times, many, out);
}

bat_status bat_curve_refine(const bat_curve *curve, int knot_count, const double *knots, bat_curve **out) {
    if (!curve || !knots || !out) return BAT_ARGUMENT;
    const int own = bat_curve_knot_count(curve);
    if (knot_count < own) return BAT_KNOTS;
    const int extra = knot_count - own;
    if (extra > BAT_POINTS_MAX - curve->count) return BAT_COUNT;
    for (int i = 0; i < knot_count; i++)
        if (isnan(knots[i])) return BAT_NUMBER;
    double *added = malloc(((size_t)extra + 1) * sizeof(double));
    if (!added) return BAT_MEMORY;
    const double *t = bat_curve_knots(curve);
    int found = 0, i = 0;
    for (int j = 0; j < knot_count && found <= extra; j++) {
        if (i < own && knots[j] == t[i])
            i++;
        else if (found < extra)
            added[found++] = knots[j];
        else
            found = extra + 1;
    }
    bat_status status = i == own && found == extra ? bat_curve_insert_knots(curve, extra, added, out)
                                                   : BAT_KNOTS;
    free(added);
    return status;
}
