/* Splines of quaternions (docs/math/camera.md, math 4). */
#include "form/camera/rotation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double rounding = 2e-15; /* of the square of a length */
static const double cancelled = 1e-6; /* a spline that becomes shorter has no direction there */
static const double lightest = 1e-6;  /* of all weights; its inverse is the heaviest */
enum { TERMS = 2 * BAT_DEGREE_MAX + 1, DEPTH = 48 };

void bat_rotation_clear(bat_rotation *rotation) {
    bat_curve_free(rotation->xyz), bat_curve_free(rotation->w);
    free(rotation->keys), free(rotation->weights);
    *rotation = (bat_rotation){.least = 1};
}

/* ---- how short it becomes ---- */

/* The Bernstein coefficients on [0, 1] of the square of a polynomial, added. */
static void add_square(int p, const double *b, double *sum) {
    double choose[BAT_DEGREE_MAX + 1] = {1}, whole[TERMS] = {1};
    for (int k = 1; k <= p; k++) choose[k] = choose[k - 1] * (p - k + 1) / k;
    for (int k = 1; k <= 2 * p; k++) whole[k] = whole[k - 1] * (2 * p - k + 1) / k;
    for (int i = 0; i <= p; i++)
        for (int j = 0; j <= p; j++) sum[i + j] += choose[i] * choose[j] / whole[i + j] * b[i] * b[j];
}

/* The least value on [0, 1], to 1e-4 of it: halves are left out that lie above the best one so far. */
static void lower(int degree, const double *b, int depth, double *best) {
    double least = b[0], left[TERMS], right[TERMS];
    for (int i = 1; i <= degree; i++) least = fmin(least, b[i]);
    *best = fmin(*best, fmin(b[0], b[degree]));
    if (depth == 0 || !(least < *best * (1 - 1e-4))) return;
    memcpy(right, b, ((size_t)degree + 1) * sizeof *b);
    for (int k = 0; k <= degree; k++) {
        left[k] = right[0];
        for (int i = 0; i < degree - k; i++) right[i] = 0.5 * (right[i] + right[i + 1]);
    }
    lower(degree, left, depth - 1, best);
    lower(degree, right, depth - 1, best);
}

static void square_of_piece(const bat_curve *curve, double a, double b, double *sum) {
    const int p = curve->degree, m = curve->dimension;
    double arguments[BAT_DEGREE_MAX], at[BAT_DIMENSION_MAX], net[BAT_DIMENSION_MAX][BAT_DEGREE_MAX + 1];
    for (int k = 0; k <= p; k++) {
        for (int i = 0; i < p; i++) arguments[i] = i < p - k ? a : b;
        bat_curve_blossom(curve, a, arguments, false, at);
        for (int c = 0; c < m; c++) net[c][k] = at[c];
    }
    for (int c = 0; c < m; c++) add_square(p, net[c], sum);
}

static double least_norm(const bat_rotation *r) {
    const bat_curve *curve = r->xyz;
    double best = 1e300;
    for (int i = curve->degree; i < curve->spread; i++) {
        const double a = curve->knots[i], b = curve->knots[i + 1];
        double sum[TERMS] = {0};
        if (!(b > a) || a >= r->domain[1]) continue;
        square_of_piece(curve, a, b, sum), square_of_piece(r->w, a, b, sum);
        lower(2 * curve->degree, sum, DEPTH, &best);
    }
    return sqrt(fmax(best, 0));
}

/* ---- making one ---- */

static void align(bat_rotation *r, bool closed) {
    for (size_t i = 1; i < r->count && !r->weights; i++)
        quat_store(quat_near(quat_load(r->keys + 4 * i), quat_load(r->keys + 4 * (i - 1))), r->keys + 4 * i);
    r->antiperiodic = closed && quat_dot(quat_load(r->keys), quat_load(r->keys + 4 * (r->count - 1))) < 0;
}

/* One of the two curves: coordinates first.. of the keys, `size` of them; over two periods, the second one opposed. */
static bat_status make_curve(const bat_rotation *r, int degree, bool closed, int knot_count,
                             const double *knots, int first, int size, bat_curve **out) {
    const size_t times = r->antiperiodic ? 2 : 1, count = times * r->count, m = size == 1 ? 2 : (size_t)size;
    const size_t all = (size_t)knot_count + (times - 1) * r->count;
    double *points = calloc(count * m, sizeof *points), *t = malloc(all * sizeof *t);
    bat_status status = points && t ? BAT_OK : BAT_MEMORY;
    for (size_t i = 0; i < count && status == BAT_OK; i++)
        for (int c = 0; c < size; c++) {
            const size_t at = i % r->count;
            const double key = r->keys[4 * at + (size_t)(first + c)] * (r->weights ? r->weights[at] : 1);
            points[i * m + (size_t)c] = i < r->count ? key : -key;
        }
    for (size_t i = 0; i < all && status == BAT_OK; i++)
        t[i] = i < (size_t)knot_count ? knots[i] : knots[i - r->count] + (knots[knot_count - 1] - knots[0]);
    if (status == BAT_OK) status = bat_curve_create((int)m, degree, closed, count, points, (int)all, t, out);
    free(points), free(t);
    return status;
}

static bat_status make_curves(bat_rotation *r, int degree, bool closed, int knot_count, const double *knots) {
    bat_status status = make_curve(r, degree, closed, knot_count, knots, 0, 3, &r->xyz);
    if (status == BAT_OK) status = make_curve(r, degree, closed, knot_count, knots, 3, 1, &r->w);
    return status;
}

bat_status bat_rotation_measure(bat_rotation *r) {
    if (!r->xyz || !r->w) return BAT_ARGUMENT;
    r->least = least_norm(r);
    return r->least >= cancelled ? BAT_OK : BAT_SINGULAR;
}

static bat_status take_weights(const bat_rotation_curve *given, bat_rotation *out) {
    for (size_t i = 0; i < given->count; i++)
        if (!(given->weights[i] >= lightest && given->weights[i] <= 1 / lightest)) return BAT_NUMBER;
    out->weights = malloc(given->count * sizeof *out->weights);
    if (!out->weights) return BAT_MEMORY;
    memcpy(out->weights, given->weights, given->count * sizeof *out->weights);
    return BAT_OK;
}

static bat_status take_keys(const bat_rotation_curve *given, bat_rotation *out) {
    if (!given->points || !given->knots || given->count < 1) return BAT_ARGUMENT;
    if (given->count > BAT_POINTS_MAX / 2) return BAT_COUNT;
    out->keys = malloc(4 * given->count * sizeof *out->keys);
    if (!out->keys) return BAT_MEMORY;
    out->count = given->count;
    for (size_t i = 0; i < given->count; i++) {
        const quat q = quat_load(given->points + 4 * i);
        const double length = quat_norm(q);
        if (!(length <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
        if (!(length > 0)) return BAT_SINGULAR;
        const bool unit = fabs(quat_dot(q, q) - 1) <=
                          rounding; /* so that what was made unit keeps its bits */
        quat_store(unit ? q : quat_unit(q), out->keys + 4 * i);
    }
    const bat_status status = given->weights ? take_weights(given, out) : BAT_OK;
    if (status == BAT_OK) align(out, given->closed);
    return status;
}

bat_status bat_rotation_make(const bat_rotation_curve *given, bat_rotation *out) {
    *out = (bat_rotation){.least = 1};
    bat_status status = take_keys(given, out);
    if (status == BAT_OK && (given->degree < 1 || given->degree > BAT_DEGREE_MAX)) status = BAT_DEGREE;
    if (status == BAT_OK &&
        given->knot_count != given->count + (given->closed ? 1 : (size_t)given->degree + 1))
        status = BAT_KNOTS;
    if (status == BAT_OK)
        status = bat_knots_check(given->degree, given->closed, (int)given->count, given->knots);
    if (status != BAT_OK) return status;
    out->domain[0] = given->knots[given->closed ? 0 : given->degree];
    out->domain[1] = given->knots[given->count];
    status = make_curves(out, given->degree, given->closed, (int)given->knot_count, given->knots);
    return status == BAT_OK ? bat_rotation_measure(out) : status;
}

/* A key whose sign is no longer the nearer one keeps it by weights, as it does in files. *out: NULL where none are needed. */
static bat_status keep_signs(const bat_rotation *r, double **out) {
    bool near = true;
    *out = NULL;
    for (size_t i = 1; i < r->count && !r->weights; i++)
        near = near && !(quat_dot(quat_load(r->keys + 4 * i), quat_load(r->keys + 4 * (i - 1))) < 0);
    if (near) return BAT_OK;
    *out = malloc(r->count * sizeof **out);
    for (size_t i = 0; i < r->count && *out; i++) (*out)[i] = 1;
    return *out ? BAT_OK : BAT_MEMORY;
}

bat_status bat_rotation_rebuild(bat_rotation *r) {
    bat_rotation made = *r;
    double *weights;
    if (!r->xyz || !r->w) return BAT_ARGUMENT;
    const int all = bat_curve_knot_count(r->xyz);
    made.xyz = made.w = NULL;
    bat_status status = keep_signs(r, &weights);
    if (weights) made.weights = weights;
    if (status == BAT_OK)
        status = make_curves(&made, r->xyz->degree, r->xyz->closed,
                             r->antiperiodic ? all - (int)r->count : all, bat_curve_knots(r->xyz));
    if (status != BAT_OK) {
        bat_curve_free(made.xyz), bat_curve_free(made.w);
        free(weights);
        return status;
    }
    bat_curve_free(r->xyz), bat_curve_free(r->w);
    *r = made;
    return BAT_OK;
}

bat_status bat_rotation_remake(bat_rotation *r) {
    bat_rotation made = *r;
    bat_status status = bat_rotation_copy(r, &made);
    if (status == BAT_OK) status = bat_rotation_rebuild(&made);
    if (status == BAT_OK) status = bat_rotation_measure(&made);
    if (status == BAT_OK) {
        const bat_rotation old = *r;
        *r = made, made = old;
    }
    bat_rotation_clear(&made);
    return status;
}

bat_status bat_rotation_copy(const bat_rotation *from, bat_rotation *out) {
    *out = *from;
    out->xyz = out->w = NULL, out->keys = out->weights = NULL;
    if (!from->keys) return BAT_OK;
    out->keys = malloc(4 * from->count * sizeof *out->keys);
    if (!out->keys) return BAT_MEMORY;
    memcpy(out->keys, from->keys, 4 * from->count * sizeof *out->keys);
    if (from->weights) {
        out->weights = malloc(from->count * sizeof *out->weights);
        if (!out->weights) return BAT_MEMORY;
        memcpy(out->weights, from->weights, from->count * sizeof *out->weights);
    }
    const bat_status status = bat_curve_copy(from->xyz, &out->xyz);
    return status == BAT_OK ? bat_curve_copy(from->w, &out->w) : status;
}

quat bat_rotation_spline(const bat_rotation *r, double share) {
    double v[3], w[2];
    const double u = r->domain[0] + (r->domain[1] - r->domain[0]) * share;
    bat_curve_eval(r->xyz, u, 0, v), bat_curve_eval(r->w, u, 0, w);
    return (quat){v[0], v[1], v[2], w[0]};
}

quat bat_rotation_at(const bat_rotation *r, double share) { return quat_unit(bat_rotation_spline(r, share)); }
