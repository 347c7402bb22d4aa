/* Curves as Bézier segments: the blossom of each span at its ends (Ramshaw 1987). */
#include "curve/curve.h"

#include <batten/bezier.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

void bat_free(void *memory) { free(memory); }

int bat_curve_segment_count(const bat_curve *curve) {
    int count = 0;
    for (int i = curve->degree; i < curve->spread; i++) count += curve->knots[i] < curve->knots[i + 1];
    return count;
}

bat_status bat_curve_to_bezier(const bat_curve *curve, double *points, double *breaks) {
    if (!curve) return BAT_ARGUMENT;
    int p = curve->degree, found = 0;
    size_t block = (size_t)((p + 1) * curve->dimension);
    for (int i = p; i < curve->spread; i++) {
        if (!(curve->knots[i] < curve->knots[i + 1])) continue;
        if (points) bat_span_bezier(curve, i, points + (size_t)found * block);
        if (breaks) breaks[found] = curve->knots[i];
        found++;
    }
    if (breaks) breaks[found] = curve->knots[curve->spread];
    return BAT_OK;
}

/* Raises the degree of Bézier points by one. In place; room for degree + 2 points. */
static void raise_degree(double *b, int degree, int size) {
    for (int c = 0; c < size; c++) b[(degree + 1) * size + c] = b[degree * size + c];
    for (int i = degree; i >= 1; i--) {
        double w = (double)i / (degree + 1);
        for (int c = 0; c < size; c++)
            b[i * size + c] = w * b[(i - 1) * size + c] + (1 - w) * b[i * size + c];
    }
}

/* The cubic with the same ends and end tangents; returns a bound on its distance: the greatest distance
 * between control points, both at the higher degree. */
static double hermite_cubic(const double *b, int p, int size, double *cubic) {
    double raised[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX], worst = 0;
    for (int c = 0; c < size; c++) {
        cubic[c] = b[c], cubic[3 * size + c] = b[p * size + c];
        cubic[size + c] = b[c] + (b[size + c] - b[c]) * p / 3;
        cubic[2 * size + c] = b[p * size + c] + (b[(p - 1) * size + c] - b[p * size + c]) * p / 3;
    }
    memcpy(raised, cubic, (size_t)(4 * size) * sizeof(double));
    for (int q = 3; q < p; q++) raise_degree(raised, q, size);
    for (int i = 0; i <= p; i++) {
        worst = fmax(worst, bat_distance(raised + i * size, b + i * size, size));
    }
    return worst;
}

/* de Casteljau at the middle: b becomes the left half. */
static void halve(double *b, int p, int size, double *right) {
    for (int r = 0; r <= p; r++) {
        memcpy(right + (p - r) * size, b + p * size, (size_t)size * sizeof(double));
        for (int i = p; i > r; i--)
            for (int c = 0; c < size; c++)
                b[i * size + c] = 0.5 * b[(i - 1) * size + c] + 0.5 * b[i * size + c];
    }
}

typedef struct list {
    double *points;
    size_t count, room; /* cubics */
    size_t block;       /* doubles per cubic */
} list;

static bat_status append(list *cubics, const double *cubic) {
    if (cubics->count == cubics->room) {
        size_t room = cubics->room * 2;
        if (room > BAT_POINTS_MAX) return BAT_COUNT;
        double *more = realloc(cubics->points, room * cubics->block * sizeof(double));
        if (!more) return BAT_MEMORY;
        cubics->points = more, cubics->room = room;
    }
    memcpy(cubics->points + cubics->count++ * cubics->block, cubic, cubics->block * sizeof(double));
    return BAT_OK;
}

enum { DEPTH = 12 }; /* 4,096 cubics per span: the error falls 16-fold each time, so rounding is reached */

static bat_status reduce(const double *b, int p, int size, double tolerance, list *cubics, bool *met) {
    double stack[DEPTH + 1][(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX], cubic[4 * BAT_DIMENSION_MAX];
    int depth[DEPTH + 1], top = 0;
    memcpy(stack[0], b, (size_t)((p + 1) * size) * sizeof(double));
    depth[0] = 0;
    while (top >= 0) {
        double bound = hermite_cubic(stack[top], p, size, cubic);
        if (bound <= tolerance || depth[top] == DEPTH) {
            if (!(bound <= tolerance)) *met = false;
            bat_status status = append(cubics, cubic);
            if (status != BAT_OK) return status;
            top--;
            continue;
        }
        double right[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
        halve(stack[top], p, size, right);
        memcpy(stack[top + 1], stack[top], (size_t)((p + 1) * size) * sizeof(double));
        memcpy(stack[top], right, (size_t)((p + 1) * size) * sizeof(double));
        depth[top]++;
        depth[top + 1] = depth[top];
        top++;
    }
    return BAT_OK;
}

bat_status bat_curve_to_cubics(const bat_curve *curve, double tolerance, int *count, double **points) {
    if (!curve || !points || !count) return BAT_ARGUMENT;
    int p = curve->degree, size = curve->dimension;
    if (p > 3 && !(tolerance > 0)) return BAT_ARGUMENT;
    list cubics = {.room = (size_t)bat_curve_segment_count(curve), .block = (size_t)(4 * size)};
    cubics.points = malloc(cubics.room * cubics.block * sizeof(double));
    if (!cubics.points) return BAT_MEMORY;
    bool met = true;
    bat_status status = BAT_OK;
    double b[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    for (int i = p; i < curve->spread && status == BAT_OK; i++) {
        if (!(curve->knots[i] < curve->knots[i + 1])) continue;
        bat_span_bezier(curve, i, b);
        if (p <= 3) {
            for (int q = p; q < 3; q++) raise_degree(b, q, size);
            status = append(&cubics, b);
        } else {
            status = reduce(b, p, size, tolerance, &cubics, &met);
        }
    }
    if (status != BAT_OK) {
        free(cubics.points);
        return status;
    }
    *points = cubics.points, *count = (int)cubics.count;
    return met ? BAT_OK : BAT_TOLERANCE;
}
