/* The curve as a value: made, checked, read, copied, compared, transformed. */
#include "curve/curve.h"

#include "base/matrix.h"
#include "base/pose.h"
#include "base/lanes.h"
#include "base/real.h"
#include "text/json.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bat_status bat_curve_allocate(int degree, int dimension, bool closed, int count, bat_curve **out) {
    if (degree < 1 || degree > BAT_DEGREE_MAX) return BAT_DEGREE;
    if (dimension < 2 || dimension > BAT_DIMENSION_MAX) return BAT_DIMENSION;
    if (count < (closed ? 2 : degree + 1) || count > BAT_POINTS_MAX) return BAT_COUNT;
    int spread = closed ? count + degree : count;
    size_t knots = (size_t)spread + (size_t)degree + 1, points = (size_t)spread * (size_t)dimension;
    size_t head = (sizeof(bat_curve) + sizeof(double) - 1) / sizeof(double);
    double *block = malloc((head + knots + points) * sizeof(double));
    if (!block) return BAT_MEMORY;
    bat_curve *curve = (bat_curve *)(void *)block;
    *curve = (bat_curve){.degree = degree,
                         .dimension = dimension,
                         .closed = closed,
                         .count = count,
                         .spread = spread,
                         .knots = block + head,
                         .points = block + head + knots};
    *out = curve;
    return BAT_OK;
}

void bat_curve_unroll(bat_curve *curve) {
    if (!curve->closed) return;
    int p = curve->degree, n = curve->count;
    double *t = curve->knots + p; /* t[j] is t_j */
    /* Differences from the seam, not the period: equal knots then have equal copies. */
    for (int j = -1; j >= -p; j--) t[j] = t[0] + (t[j + n] - t[n]);
    for (int j = n + 1; j <= n + p; j++) t[j] = t[n] + (t[j - n] - t[0]);
    size_t size = (size_t)curve->dimension;
    for (int i = p - 1; i >= 0; i--)
        memcpy(curve->points + (size_t)i * size, curve->points + (size_t)(i + n) * size,
               size * sizeof(double));
}

/* Apart from the function that others call: gcc shows clones to linkers, whatever their visibility. */
BAT_CLONES static bool are_coordinates(const double *numbers, size_t count) {
    long long fault = 0;
    for (size_t i = 0; i < count; i++) fault |= !(fabs(numbers[i]) <= BAT_COORDINATE_MAX);
    return !fault;
}

bool bat_are_coordinates(const double *numbers, size_t count) { return are_coordinates(numbers, count); }

bat_status bat_points_check(const bat_curve *curve) {
    const size_t total = (size_t)curve->count * (size_t)curve->dimension;
    return bat_are_coordinates(bat_curve_points(curve), total) ? BAT_OK : BAT_NUMBER;
}

bat_status bat_coordinates_check(bat_problem *problem, const char *place, size_t count,
                                 const double *numbers) {
    for (size_t i = 0; i < count; i++)
        if (bat_problem_outside(problem, place, i, -BAT_COORDINATE_MAX, BAT_COORDINATE_MAX, numbers[i]))
            return BAT_NUMBER;
    return BAT_OK;
}

bat_status bat_curve_validate(const bat_curve *curve) {
    bat_status status = bat_knots_check(curve->degree, curve->closed, curve->count, bat_curve_knots(curve));
    return status == BAT_OK ? bat_points_check(curve) : status;
}

bat_status bat_curve_finish(bat_curve *curve, bat_curve **out) {
    bat_status status = bat_curve_validate(curve);
    if (status != BAT_OK) {
        free(curve);
        return status;
    }
    bat_curve_unroll(curve);
    *out = curve;
    return BAT_OK;
}

double *bat_curve_own_knots(bat_curve *curve) { return curve->knots + (curve->closed ? curve->degree : 0); }

double *bat_curve_own_points(bat_curve *curve) {
    return curve->points + (curve->closed ? (size_t)curve->degree * (size_t)curve->dimension : 0);
}

bat_status bat_curve_create(int dimension, int degree, bool closed, size_t count, const double *points,
                            int knot_count, const double *knots, bat_curve **out) {
    if (!knots || !points || !out) return BAT_ARGUMENT;
    bat_curve *curve;
    bat_status status = bat_curve_allocate(degree, dimension, closed, bat_count_inside(count), &curve);
    if (status != BAT_OK) return status;
    if (knot_count != bat_curve_knot_count(curve)) {
        free(curve);
        return BAT_KNOTS;
    }
    memcpy(bat_curve_own_knots(curve), knots, (size_t)knot_count * sizeof(double));
    memcpy(bat_curve_own_points(curve), points, count * (size_t)dimension * sizeof(double));
    return bat_curve_finish(curve, out);
}

bat_status bat_curve_create_clamped(int dimension, int degree, size_t count, const double *points,
                                    bat_curve **out) {
    if (!points || !out) return BAT_ARGUMENT;
    bat_curve *curve;
    bat_status status = bat_curve_allocate(degree, dimension, false, bat_count_inside(count), &curve);
    if (status != BAT_OK) return status;
    int n = curve->count;
    for (int i = 0; i <= n + degree; i++) curve->knots[i] = i <= degree ? 0 : i < n ? i - degree : n - degree;
    memcpy(curve->points, points, count * (size_t)dimension * sizeof(double));
    return bat_curve_finish(curve, out);
}

bat_status bat_curve_copy(const bat_curve *curve, bat_curve **out) {
    if (!curve || !out) return BAT_ARGUMENT;
    bat_curve *copy;
    bat_status status = bat_curve_allocate(curve->degree, curve->dimension, curve->closed, curve->count,
                                           &copy);
    if (status != BAT_OK) return status;
    memcpy(copy->knots, curve->knots, ((size_t)curve->spread + (size_t)curve->degree + 1) * sizeof(double));
    memcpy(copy->points, curve->points, (size_t)curve->spread * (size_t)curve->dimension * sizeof(double));
    *out = copy;
    return BAT_OK;
}

void bat_curve_free(bat_curve *curve) { free(curve); }

int bat_curve_degree(const bat_curve *curve) { return curve->degree; }
int bat_curve_dimension(const bat_curve *curve) { return curve->dimension; }
bool bat_curve_is_closed(const bat_curve *curve) { return curve->closed; }
size_t bat_curve_count(const bat_curve *curve) { return (size_t)curve->count; }

int bat_curve_knot_count(const bat_curve *curve) {
    return bat_knot_total(curve->degree, curve->closed, curve->count);
}

const double *bat_curve_knots(const bat_curve *curve) {
    return curve->knots + (curve->closed ? curve->degree : 0);
}

const double *bat_curve_points(const bat_curve *curve) {
    return curve->points + (curve->closed ? (size_t)curve->degree * (size_t)curve->dimension : 0);
}

void bat_curve_domain(const bat_curve *curve, double domain[2]) {
    domain[0] = curve->knots[curve->degree];
    domain[1] = curve->knots[curve->spread];
}

double bat_curve_size(const bat_curve *curve) {
    const double *points = bat_curve_points(curve);
    double sum = 0;
    for (int d = 0; d < curve->dimension; d++) {
        double low = points[d], high = points[d];
        for (int i = 1; i < curve->count; i++) {
            double x = points[(size_t)i * (size_t)curve->dimension + (size_t)d];
            low = fmin(low, x), high = fmax(high, x);
        }
        sum = bat_hypot(sum, high - low);
    }
    return sum;
}

bool bat_curve_is_equal(const bat_curve *a, const bat_curve *b) {
    return a->degree == b->degree && a->dimension == b->dimension && a->closed == b->closed &&
           a->count == b->count &&
           memcmp(bat_curve_knots(a), bat_curve_knots(b), (size_t)bat_curve_knot_count(a) * sizeof(double)) ==
               0 &&
           memcmp(bat_curve_points(a), bat_curve_points(b),
                  (size_t)a->count * (size_t)a->dimension * sizeof(double)) == 0;
}

bat_status bat_curve_transform(const bat_curve *curve, const double *matrix, bat_curve **out) {
    if (!curve || !matrix || !out) return BAT_ARGUMENT;
    bat_curve *image;
    bat_status status = bat_curve_copy(curve, &image);
    if (status != BAT_OK) return status;
    int size = curve->dimension;
    const double *from = bat_curve_points(curve);
    double *to = bat_curve_own_points(image);
    for (int i = 0; i < curve->count; i++, from += size, to += size)
        for (int row = 0; row < size; row++) {
            const double *m = matrix + row * (size + 1);
            double sum = 0;
            for (int d = 0; d < size; d++) sum += m[d] * from[d];
            to[row] = sum + m[size];
        }
    return bat_curve_finish(image, out);
}

bat_status bat_curve_to_dimension(const bat_curve *curve, int dimension, bat_curve **out) {
    if (!curve || !out) return BAT_ARGUMENT;
    bat_curve *image;
    bat_status status = bat_curve_allocate(curve->degree, dimension, curve->closed, curve->count, &image);
    if (status != BAT_OK) return status;
    memcpy(image->knots, curve->knots, ((size_t)curve->spread + (size_t)curve->degree + 1) * sizeof(double));
    for (int i = 0; i < curve->spread; i++)
        for (int d = 0; d < dimension; d++)
            image->points[(size_t)i * (size_t)dimension + (size_t)d] =
                d < curve->dimension ? curve->points[(size_t)i * (size_t)curve->dimension + (size_t)d] : 0;
    *out = image;
    return BAT_OK;
}

bat_status bat_curve_posed(const bat_curve *curve, const double rows[12], bat_curve **out) {
    double m[6], plane[12];
    bat_curve *space = NULL;
    if (curve->dimension == 3) return bat_curve_transform(curve, rows, out);
    if (bat_pose_in_plane(rows, m)) {
        bat_matrix_rows(m, 2, plane);
        return bat_curve_transform(curve, plane, out);
    }
    bat_status status = bat_curve_to_dimension(curve, 3, &space);
    if (status == BAT_OK) status = bat_curve_transform(space, rows, out);
    bat_curve_free(space);
    return status;
}
