/*
 * Two open curves made one. The joint is at a's end. For C1 and C2, b's parameter is scaled so that the
 * speeds at the joint agree, and the points A2 A1 J B1 B2 around the joint take the least change (sum of
 * squares) that makes the derivatives agree; the joint's knot then has multiplicity p - continuity.
 */
#include "curve/curve.h"

#include <batten/refine.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Puts a curve behind the first `count` points of another, over whose end its knots go on, scaled. Both are clamped, of one degree
 * and dimension; there is room. */
static void put_behind(bat_curve *both, int count, const bat_curve *b, double scale) {
    const int p = both->degree;
    const size_t size = (size_t)both->dimension;
    const double end = both->knots[count], start = b->knots[p];
    for (int i = 0; i < b->count; i++) {
        const double t = b->knots[p + 1 + i];
        both->knots[count + p + i] = start == end && scale == 1 ? t : end + (t - start) * scale;
    }
    double *joint = both->points + (size_t)(count - 1) * size;
    memcpy(joint + size, b->points + size, (size_t)(b->count - 1) * size * sizeof(double));
    for (size_t c = 0; c < size; c++)
        if (joint[c] != b->points[c]) joint[c] = 0.5 * joint[c] + 0.5 * b->points[c];
}

/* Clamped curves of one degree and dimension, one behind the other; the scale is for all but the first. */
static bat_status concatenate(size_t count, bat_curve *const *curves, double scale, bat_curve **out) {
    const bat_curve *first = curves[0];
    size_t points = 1;
    for (size_t i = 0; i < count; i++) {
        points += (size_t)curves[i]->count - 1;
        if (points > BAT_POINTS_MAX) return BAT_COUNT;
    }
    bat_curve *all;
    bat_status status = bat_curve_allocate(first->degree, first->dimension, false, (int)points, &all);
    if (status != BAT_OK) return status;
    int put = first->count;
    memcpy(all->knots, first->knots, (size_t)(put + first->degree + 1) * sizeof(double));
    memcpy(all->points, first->points, (size_t)put * (size_t)first->dimension * sizeof(double));
    for (size_t i = 1; i < count; i++) put_behind(all, put, curves[i], scale), put += curves[i]->count - 1;
    return bat_curve_finish(all, out);
}

/* How b must be slowed down: |b'| / |a'| at the joint, 1 when one of them stops there. */
static double speed_ratio(const bat_curve *a, const bat_curve *b) {
    int p = a->degree, size = a->dimension, n = a->count;
    double ha = a->knots[n] - a->knots[n - 1], hb = b->knots[p + 1] - b->knots[p];
    double va = bat_distance(a->points + (n - 2) * size, a->points + (n - 1) * size, size) / ha;
    double vb = bat_distance(b->points, b->points + size, size) / hb;
    double ratio = vb / va;
    return ratio > 1e-5 && ratio < 1e5 ? ratio : 1;
}

/* Smallest change of the five points q that satisfies the rows; r = rows . q is the fault. */
static void project(double rows[2][5], int count, double *q, int size) {
    double g00 = 0, g01 = 0, g11 = 0;
    for (int r = 0; r < count; r++) { /* unit rows: the two conditions weigh alike */
        double norm = 0;
        for (int i = 0; i < 5; i++) norm += rows[r][i] * rows[r][i];
        for (int i = 0; i < 5; i++) rows[r][i] /= sqrt(norm);
    }
    for (int i = 0; i < 5; i++)
        g00 += rows[0][i] * rows[0][i], g01 += rows[0][i] * rows[1][i], g11 += rows[1][i] * rows[1][i];
    for (int c = 0; c < size; c++) {
        double r0 = 0, r1 = 0, y0, y1 = 0;
        for (int i = 0; i < 5; i++) r0 += rows[0][i] * q[i * size + c], r1 += rows[1][i] * q[i * size + c];
        if (count == 2) {
            double det = g00 * g11 - g01 * g01;
            y0 = (r0 * g11 - r1 * g01) / det, y1 = (r1 * g00 - r0 * g01) / det;
        } else {
            y0 = r0 / g00;
        }
        for (int i = 0; i < 5; i++) q[i * size + c] -= rows[0][i] * y0 + (count == 2 ? rows[1][i] * y1 : 0);
    }
}

/* The derivatives at the joint, as rows over A2 A1 J B1 B2, from the knots on both sides. j: index of J. */
static void smooth_joint(bat_curve *curve, int j, int continuity) {
    int p = curve->degree, size = curve->dimension;
    const double *t = curve->knots; /* the joint is t_{j+1}..t_{j+p} */
    double e = t[j + 1], a1 = e - t[j], b1 = t[j + p + 1] - e, rows[2][5] = {{0}, {0}};
    /* Lengths in units of a1, so that rows are of order one. */
    double h = b1 / a1;
    rows[0][1] = -1, rows[0][2] = 1 + 1 / h, rows[0][3] = -1 / h;
    if (continuity == 2) {
        double a2 = (e - t[j - 1]) / a1, b2 = (t[j + p + 2] - e) / a1;
        rows[1][0] = 1 / a2, rows[1][1] = -1 - 1 / a2, rows[1][2] = 1 - 1 / (h * h);
        rows[1][3] = (1 / h + 1 / b2) / h, rows[1][4] = -1 / (b2 * h);
    }
    double *q = curve->points + (size_t)(j - (continuity == 2 ? 2 : 1)) * (size_t)size,
           five[5 * BAT_DIMENSION_MAX] = {0};
    size_t bytes = (size_t)((continuity == 2 ? 5 : 3) * size) * sizeof(double);
    double *window = continuity == 2 ? five : five + size;
    memcpy(window, q, bytes);
    project(rows, continuity, five, size);
    memcpy(q, window, bytes);
}

static bat_status joined(bat_curve *const parts[2], int continuity, bat_curve **out, double *moved) {
    const bat_curve *a = parts[0], *b = parts[1];
    bat_curve *both, *smooth;
    bat_status status = concatenate(2, parts, continuity > 0 ? speed_ratio(a, b) : 1, &both);
    if (status != BAT_OK) return status;
    int j = a->count - 1, size = a->dimension;
    double most = 0, greatest = 0;
    if (continuity > 0) {
        smooth_joint(both, j, continuity);
        for (int i = 0; i < both->count * size; i++) greatest = fmax(greatest, fabs(both->points[i]));
    }
    for (int i = j - continuity; i <= j + continuity; i++) {
        const double *old = i <= j ? a->points + i * size : b->points + (i - j) * size,
                     *now = both->points + i * size;
        most = fmax(most, bat_distance(old, now, size));
        if (i == j) most = fmax(most, bat_distance(b->points, now, size));
    }
    if (continuity > 0) {
        /* The conditions hold to rounding, so removing the knots costs nothing. */
        double error;
        int removed;
        status = bat_curve_remove_knot(both, a->knots[a->spread], continuity, 1024 * DBL_EPSILON * greatest,
                                       &smooth, &removed, &error);
        bat_curve_free(both);
        if (status != BAT_OK) return status;
        both = smooth, most += error;
    }
    status = bat_curve_validate(both);
    if (status != BAT_OK) {
        bat_curve_free(both);
        return status;
    }
    *out = both;
    if (moved) *moved = most;
    return BAT_OK;
}

/* A clamped copy of that degree. */
static bat_status prepare(const bat_curve *curve, int degree, bat_curve **out) {
    bat_curve *clamped;
    bat_status status = bat_curve_clamp(curve, &clamped);
    if (status != BAT_OK) return status;
    status = bat_curve_elevate(clamped, degree, out);
    bat_curve_free(clamped);
    return status;
}

/* How far the end of one is from the beginning of the other. */
static double gap_between(const bat_curve *a, const bat_curve *b) {
    return bat_distance(a->points + (size_t)(a->count - 1) * (size_t)a->dimension, b->points, a->dimension);
}

bat_status bat_curve_join(const bat_curve *a, const bat_curve *b, int continuity, double gap, bat_curve **out,
                          double *moved) {
    if (!a || !b || !out || a->closed || b->closed || continuity < 0 || continuity > 2 || !(gap >= 0))
        return BAT_ARGUMENT;
    if (a->dimension != b->dimension) return BAT_DIMENSION;
    int degree = a->degree > b->degree ? a->degree : b->degree;
    if (degree < 2 && continuity > 0) degree = 2;
    if (continuity >= degree) degree = continuity + 1;
    bat_curve *parts[2] = {NULL, NULL};
    bat_status status = prepare(a, degree, &parts[0]);
    if (status == BAT_OK) status = prepare(b, degree, &parts[1]);
    if (status == BAT_OK)
        status = gap_between(parts[0], parts[1]) <= gap ? joined(parts, continuity, out, moved)
                                                        : BAT_ARGUMENT;
    bat_curve_free(parts[0]);
    bat_curve_free(parts[1]);
    return status;
}

bat_status bat_curve_chain(size_t count, const bat_curve *const *curves, double gap, bat_curve **out) {
    bat_curve **parts = calloc(count, sizeof *parts);
    if (!parts) return BAT_MEMORY;
    int degree = 0;
    bat_status status = BAT_OK;
    for (size_t i = 0; i < count; i++)
        if (curves[i]->degree > degree) degree = curves[i]->degree;
    for (size_t i = 0; i < count && status == BAT_OK; i++) {
        status = prepare(curves[i], degree, &parts[i]);
        if (status == BAT_OK && i > 0 && !(gap_between(parts[i - 1], parts[i]) <= gap)) status = BAT_ARGUMENT;
    }
    bat_curve *all = NULL;
    if (status == BAT_OK) status = concatenate(count, parts, 1, &all);
    for (size_t i = 0; i < count; i++) bat_curve_free(parts[i]);
    free(parts);
    if (status == BAT_OK) *out = all;
    return status;
}
