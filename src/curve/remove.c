/*
 * Knot removal with a bound. One copy of u (multiplicity s, last copy t_r) can go when p - s + 1 equations
 *   P_i = a_i Q_i + (1 - a_i) Q_{i-1},   i = r-p..r-s,   a_i = (u - t_i) / (t_{i+p+1} - t_i)
 * hold for p - s unknown Q (Boehm's insertion read backwards; P&T A5.8). They have one condition w . P = 0;
 * when it fails, the residual is spread so that its largest entry is least: |w . P| / sum |w|, the same in
 * every equation. Inserting u again gives control points that differ from the old ones by that residual, so
 * it bounds the distance of the curves at every parameter.
 */
#include "curve/remove.h"

#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double *point_at(const bat_curve *curve, int i) {
    if (curve->closed) i = (i % curve->count + curve->count) % curve->count;
    return bat_curve_points(curve) + (size_t)i * (size_t)curve->dimension;
}

void bat_removal_plan(const bat_curve *curve, int r, int s, bat_removal *out) {
    int p = curve->degree, size = curve->dimension, rows = p - s + 1, first = r - p;
    const double *t = bat_curve_knots(curve);
    double u = t[r], a[BAT_DEGREE_MAX + 1], w[BAT_DEGREE_MAX + 1], residual[BAT_DIMENSION_MAX], sum = 0;
    for (int i = 0; i < rows; i++) a[i] = (u - t[first + i]) / (t[first + i + p + 1] - t[first + i]);
    w[0] = 1;
    int pivot = 0;
    for (int i = 1; i < rows; i++) {
        w[i] = -w[i - 1] * a[i - 1] / (1 - a[i]);
        if (fabs(w[i]) > fabs(w[pivot])) pivot = i;
        if (fabs(w[i]) > 1e60) /* only ratios count */
            for (int j = 0; j <= i; j++) w[j] *= 1e-60;
    }
    for (int i = 0; i < rows; i++) sum += fabs(w[i]);
    const double *left = point_at(curve, first - 1), *right = point_at(curve, r - s + 1);
    for (int c = 0; c < size; c++) {
        double d = -w[0] * (1 - a[0]) * left[c] - w[rows - 1] * a[rows - 1] * right[c];
        for (int i = 0; i < rows; i++) d += w[i] * point_at(curve, first + i)[c];
        residual[c] = d / sum;
    }
    /* From both sides up to the equation that weighs most: neither recurrence grows. q[0] and q[rows] are the
     * fixed neighbours. */
    double all[(BAT_DEGREE_MAX + 2) * BAT_DIMENSION_MAX];
    memcpy(all, left, (size_t)size * sizeof(double));
    memcpy(all + rows * size, right, (size_t)size * sizeof(double));
    for (int c = 0; c < size; c++) {
        for (int i = 0; i < pivot; i++) {
            double p_i = point_at(curve, first + i)[c] - (w[i] < 0 ? -residual[c] : residual[c]);
            all[(i + 1) * size + c] = (p_i - (1 - a[i]) * all[i * size + c]) / a[i];
        }
        for (int i = rows - 1; i > pivot; i--) {
            double p_i = point_at(curve, first + i)[c] - (w[i] < 0 ? -residual[c] : residual[c]);
            all[i * size + c] = (p_i - a[i] * all[(i + 1) * size + c]) / (1 - a[i]);
        }
    }
    out->r = r, out->s = s;
    memcpy(out->q, all + size, (size_t)((rows - 1) * size) * sizeof(double));
    /* The bound is measured on what is handed over, rounding and all. */
    double worst = 0;
    for (int i = 0; i < rows; i++) {
        double again[BAT_DIMENSION_MAX];
        for (int c = 0; c < size; c++)
            again[c] = a[i] * all[(i + 1) * size + c] + (1 - a[i]) * all[i * size + c];
        worst = fmax(worst, bat_distance(point_at(curve, first + i), again, size));
    }
    out->bound = isfinite(worst) ? worst : INFINITY;
}

bool bat_removal_fits(const bat_curve *curve, int s) {
    return !curve->closed || (curve->count > curve->degree - s + 2 && curve->count > 2);
}

bat_status bat_removal_apply(const bat_curve *curve, int count, const bat_removal *removals,
                             bat_curve **out) {
    enum { KNOT = 1, POINT = 2 };
    int p = curve->degree, n = curve->count, knots = bat_curve_knot_count(curve);
    size_t size = (size_t)curve->dimension;
    bat_curve *changed = NULL, *less = NULL;
    unsigned char *gone = calloc((size_t)knots, 1);
    bat_status status = gone ? bat_curve_copy(curve, &changed) : BAT_MEMORY;
    if (status == BAT_OK) status = bat_curve_allocate(p, curve->dimension, curve->closed, n - count, &less);
    if (status == BAT_OK) {
        double *t = bat_curve_own_knots(changed), *points = bat_curve_own_points(changed);
        bool turn = false;
        for (int k = 0; k < count; k++) {
            int r = removals[k].r, last = r - removals[k].s;
            for (int i = r - p; i < last; i++)
                memcpy(points + (size_t)((i + n) % n) * size, removals[k].q + (size_t)(i - (r - p)) * size,
                       size * sizeof(double));
            gone[r] |= KNOT;
            gone[(last + n) % n] |= POINT;
            /* A copy of the seam takes the last point; P_1 then starts the period. */
            if (last < 0) turn = true;
        }
        double *to_knots = bat_curve_own_knots(less), *to = bat_curve_own_points(less), *first = to;
        for (int i = 0; i < knots; i++)
            if (!(gone[i] & KNOT)) *to_knots++ = t[i];
        for (int i = 0; i < n; i++)
            if (!(gone[i] & POINT)) memcpy(to, points + (size_t)i * size, size * sizeof(double)), to += size;
        if (turn) {
            double kept[BAT_DIMENSION_MAX];
            memcpy(kept, first, size * sizeof(double));
            memmove(first, first + size, (size_t)(n - count - 1) * size * sizeof(double));
            memcpy(to - size, kept, size * sizeof(double));
        }
        status = bat_curve_finish(less, out);
    }
    bat_curve_free(changed);
    free(gone);
    return status;
}

/* The last copy of u among the user's knots of a curve whose seam is gathered. */
static int last_copy(const bat_curve *curve, double u) {
    int i = bat_span(curve, u, -1);
    return curve->closed ? i - curve->degree : i;
}

static bat_status step(bat_curve **now, bat_status status, bat_curve *next) {
    if (status != BAT_OK) return status;
    bat_curve_free(*now);
    *now = next;
    return BAT_OK;
}

bat_status bat_curve_remove_knot(const bat_curve *curve, double u, int times, double tolerance,
                                 bat_curve **out, int *removed, double *error) {
    if (!curve || !out || times < 0 || !(tolerance >= 0)) return BAT_ARGUMENT;
    if (isnan(u)) return BAT_NUMBER;
    double start = curve->knots[curve->degree], end = curve->knots[curve->spread];
    if (u < start || u > end) return BAT_PARAMETER;
    if (curve->closed && u == end) u = start;
    int s = bat_knot_multiplicity(curve, u), done = 0;
    if (!curve->closed && (u == start || u == end)) s = 0;
    double total = 0;
    bat_curve *now;
    bat_status status = s > 0 && times > 0 ? bat_curve_gather_seam(curve, &now) : bat_curve_copy(curve, &now);
    if (status != BAT_OK) return status;
    for (; status == BAT_OK && s > 0 && done < times && bat_removal_fits(now, s); s--) {
        bat_curve *next = NULL;
        if (now->closed && s == 1 && bat_curve_knots(now)[0] == u) {
            /* The seam goes altogether: the period starts at the next knot instead. */
            bat_removal trial;
            bat_removal_plan(now, 0, 1, &trial);
            if (!(total + trial.bound <= tolerance)) break;
            status = bat_curve_rotate(now, 1, &next);
            status = step(&now, status, next);
            if (status != BAT_OK) break;
        }
        int r = now->closed && bat_curve_knots(now)[0] > u ? now->count - 1 : last_copy(now, u);
        bat_removal removal;
        bat_removal_plan(now, r, s, &removal);
        if (!(total + removal.bound <= tolerance)) break;
        status = bat_removal_apply(now, 1, &removal, &next);
        status = step(&now, status, next);
        total += removal.bound, done++;
    }
    if (status != BAT_OK) {
        bat_curve_free(now);
        return status;
    }
    *out = now;
    if (removed) *removed = done;
    if (error) *error = total;
    return BAT_OK;
}
