#include "curve/curve.h"
#include <batten/drag.h>
#include <math.h>
#include <string.h>

/* One dragged point: which control points it depends on, and how much. */
typedef struct pull {
    int points[BAT_DEGREE_MAX + 1];
    double weights[BAT_DEGREE_MAX + 1];
} pull;

static pull pull_at(const bat_curve *curve, double u) {
    pull out;
    int first, n = bat_point_count(curve);
    bat_curve_basis(curve, u, &first, out.weights);
    for (int i = 0; i <= curve->degree; i++) out.points[i] = (first + i) % n;
    return out;
}

/* Inner product of two rows of N; a short closed curve has a point several times in a row, which adds up. */
static double product(const pull *a, const pull *b, int degree) {
    double sum = 0;
    for (int i = 0; i <= degree; i++)
        for (int j = 0; j <= degree; j++)
            if (a->points[i] == b->points[j]) sum += a->weights[i] * b->weights[j];
    return sum;
}

/* Solves gram * x = x in place by Cholesky; the diagonal is near one over the degree or above. */
static bat_status solve(int count, int size, double gram[][BAT_DRAG_MAX], double *x) {
    for (int j = 0; j < count; j++) {
        for (int i = j; i < count; i++) {
            double sum = gram[i][j];
            for (int k = 0; k < j; k++) sum -= gram[i][k] * gram[j][k];
            if (i == j) {
                if (!(sum > 1e-12 * gram[j][j])) return BAT_SINGULAR;
                gram[j][j] = sqrt(sum);
            } else {
                gram[i][j] = sum / gram[j][j];
            }
        }
    }
    for (int c = 0; c < size; c++) {
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < i; k++) x[i * size + c] -= gram[i][k] * x[k * size + c];
            x[i * size + c] /= gram[i][i];
        }
        for (int i = count - 1; i >= 0; i--) {
            for (int k = i + 1; k < count; k++) x[i * size + c] -= gram[k][i] * x[k * size + c];
            x[i * size + c] /= gram[i][i];
        }
    }
    return BAT_OK;
}

static bat_status check(const bat_curve *curve, int count, const double *numbers) {
    if (!curve || !numbers) return BAT_ARGUMENT;
    for (int i = 0; i < count * curve->dimension; i++)
        if (!isfinite(numbers[i])) return BAT_NUMBER;
    return BAT_OK;
}

/* A copy whose points may still be written. */
static bat_status begin(const bat_curve *curve, bat_curve **out) {
    bat_status status = bat_curve_allocate(curve->degree, curve->dimension, curve->closed, curve->count, out);
    if (status != BAT_OK) return status;
    size_t points = (size_t)curve->count * (size_t)curve->dimension;
    memcpy(bat_curve_own_knots(*out), bat_curve_knots(curve),
           (size_t)bat_curve_knot_count(curve) * sizeof(double));
    memcpy(bat_curve_own_points(*out), bat_curve_points(curve), points * sizeof(double));
    return BAT_OK;
}

bat_status bat_curve_drag(const bat_curve *curve, size_t many, const double *u, const double *delta,
                          bat_curve **out) {
    if (!u || !out || many < 1) return BAT_ARGUMENT;
    if (many > BAT_DRAG_MAX) return BAT_COUNT;
    int count = (int)many;
    bat_status status = check(curve, count, delta);
    if (status != BAT_OK) return status;
    pull pulls[BAT_DRAG_MAX];
    double gram[BAT_DRAG_MAX][BAT_DRAG_MAX], shares[BAT_DRAG_MAX * BAT_DIMENSION_MAX], domain[2];
    int size = curve->dimension;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < count; i++) {
        if (!isfinite(u[i])) return BAT_NUMBER;
        if (!curve->closed && (u[i] < domain[0] || u[i] > domain[1])) return BAT_PARAMETER;
        pulls[i] = pull_at(curve, u[i]);
        for (int j = 0; j <= i; j++) gram[i][j] = product(&pulls[i], &pulls[j], curve->degree);
    }
    memcpy(shares, delta, (size_t)(count * size) * sizeof(double));
    status = solve(count, size, gram, shares);
    bat_curve *moved = NULL;
    if (status == BAT_OK) status = begin(curve, &moved);
    if (status != BAT_OK) return status;
    double *points = bat_curve_own_points(moved);
    for (int i = 0; i < count; i++)
        for (int k = 0; k <= curve->degree; k++)
            for (int c = 0; c < size; c++)
                points[pulls[i].points[k] * size + c] += pulls[i].weights[k] * shares[i * size + c];
    return bat_curve_finish(moved, out);
}

bat_status bat_curve_move_point(const bat_curve *curve, int index, const double *delta, bat_curve **out) {
    if (!out) return BAT_ARGUMENT;
    bat_status status = check(curve, 1, delta);
    if (status != BAT_OK) return status;
    if (index < 0 || index >= curve->count) return BAT_ARGUMENT;
    bat_curve *moved = NULL;
    status = begin(curve, &moved);
    if (status != BAT_OK) return status;
    double *point = bat_curve_own_points(moved) + index * curve->dimension;
    for (int c = 0; c < curve->dimension; c++) point[c] += delta[c];
    return bat_curve_finish(moved, out);
}
