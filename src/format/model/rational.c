#include "format/model/rational.h"

#include "base/real.h"
#include "format/model/full.h"

#include <batten/bezier.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PLACES = 8, HALVINGS = 16 };
static const double WEIGHTS = 1e6, CORNER = 0.05;

typedef struct rational {
    bat_curve *over, *under; /* the sum of weights times points; the sum of weights, with a 0 beside it */
    double tolerance;
    bat_numbers points; /* of Bézier segments, x y z each, shared ends given once */
    int segments;
} rational;

bool bat_weights_are_equal(size_t count, const double *weights) {
    for (size_t i = 1; i < count; i++)
        if (!(fabs(weights[i] - weights[0]) <= 1e-9 * fabs(weights[0]))) return false;
    return true;
}

bat_status bat_weigh(size_t count, const double *points, const double *weights, double *over, size_t size,
                     double *under) {
    if (!(weights[0] > 0)) return BAT_NUMBER;
    for (size_t i = 0; i < count; i++) {
        const double share = weights[i] / weights[0];
        if (!(share >= 1 / WEIGHTS && share <= WEIGHTS)) return BAT_NUMBER;
        for (size_t k = 0; k < 3; k++) over[3 * i + k] = share * points[3 * i + k];
        for (size_t k = 0; k < size; k++) under[size * i + k] = k == 0 ? share : 0;
    }
    return BAT_OK;
}

/* Point and derivative, 3 numbers each; left: as the span before u has them. */
static void evaluate(const rational *r, double u, bool left, double out[6]) {
    double over[6], under[4];
    (left ? bat_curve_eval_left : bat_curve_eval)(r->over, u, 1, over);
    (left ? bat_curve_eval_left : bat_curve_eval)(r->under, u, 1, under);
    for (int k = 0; k < 3; k++) {
        out[k] = over[k] / under[0];
        out[3 + k] = (over[3 + k] - out[k] * under[2]) / under[0];
    }
}

static void cubic_at(const double bezier[12], double t, double out[3]) {
    const double s = 1 - t;
    for (int k = 0; k < 3; k++)
        out[k] = s * s * (s * bezier[k] + 3 * t * bezier[3 + k]) +
                 t * t * (3 * s * bezier[6 + k] + t * bezier[9 + k]);
}

static bool is_near(const rational *r, double a, double b, const double bezier[12]) {
    for (int i = 1; i < PLACES; i++) {
        const double t = i / (double)PLACES;
        double there[6], here[3];
        evaluate(r, a + t * (b - a), false, there);
        cubic_at(bezier, t, here);
        if (!(bat_hypot(bat_hypot(here[0] - there[0], here[1] - there[1]), here[2] - there[2]) <=
              r->tolerance))
            return false;
    }
    return true;
}

static bool put(rational *r, const double *numbers, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (!bat_numbers_add(&r->points, numbers[i])) return false;
    return true;
}

/* The piece over [a, b], in as many cubics as it takes. */
static bat_status follow(rational *r, double a, double b, int halvings) {
    double from[6], to[6], bezier[12];
    const double third = (b - a) / 3, middle = a + (b - a) / 2;
    evaluate(r, a, false, from);
    evaluate(r, b, true, to);
    for (int k = 0; k < 3; k++) {
        bezier[k] = from[k], bezier[3 + k] = from[k] + third * from[3 + k];
        bezier[6 + k] = to[k] - third * to[3 + k], bezier[9 + k] = to[k];
    }
    if (halvings > 0 && a < middle && middle < b && !is_near(r, a, b, bezier)) {
        const bat_status status = follow(r, a, middle, halvings - 1);
        return status == BAT_OK ? follow(r, middle, b, halvings - 1) : status;
    }
    if (r->points.count >= 9 * (size_t)BAT_POINTS_MAX) return BAT_COUNT;
    if (r->segments == 0 && !put(r, bezier, 3)) return BAT_MEMORY;
    r->segments++;
    return put(r, bezier + 3, 9) ? BAT_OK : BAT_MEMORY;
}

static bat_status create(int degree, size_t count, const double *points, const double *weights,
                         const double *knots, rational *out) {
    double *over = malloc(5 * count * sizeof *over), *under = over ? over + 3 * count : NULL;
    bat_status status = over ? bat_weigh(count, points, weights, over, 2, under) : BAT_MEMORY;
    const int knot_count = (int)count + degree + 1;
    if (status == BAT_OK)
        status = bat_curve_create(3, degree, false, count, over, knot_count, knots, &out->over);
    if (status == BAT_OK)
        status = bat_curve_create(2, degree, false, count, under, knot_count, knots, &out->under);
    free(over);
    return status;
}

/* All segments as one curve. */
static bat_status assemble(rational *r, bat_curve **out) {
    double *p = r->points.list;
    const size_t count = 3 * (size_t)r->segments + 1, last = 3 * (count - 1);
    const double slack = 1e-9 * bat_curve_size(r->over);
    bool meets = true;
    for (size_t k = 0; k < 3; k++) meets = meets && fabs(p[last + k] - p[k]) <= slack;
    if (meets) memcpy(p + last, p, 3 * sizeof *p);
    const int dimension = bat_full_pack(count, p);
    return bat_curve_from_bezier(dimension, 3, meets, r->segments, p, CORNER, 0, out, NULL);
}

bat_status bat_rational_curve(int degree, size_t count, const double *points, const double *weights,
                              const double *knots, const double range[2], double tolerance, bat_curve **out) {
    rational r = {.tolerance = tolerance};
    if (count <= (size_t)degree || count > BAT_POINTS_MAX) return BAT_COUNT;
    if (!(tolerance > 0)) return BAT_NUMBER;
    bat_status status = create(degree, count, points, weights, knots, &r);
    for (size_t i = (size_t)degree; i < count && status == BAT_OK; i++) {
        const double from = range ? fmax(knots[i], range[0]) : knots[i];
        const double to = range ? fmin(knots[i + 1], range[1]) : knots[i + 1];
        if (from < to) status = follow(&r, from, to, HALVINGS);
    }
    if (status == BAT_OK && r.segments == 0) status = BAT_PARAMETER;
    if (status == BAT_OK) status = assemble(&r, out);
    bat_curve_free(r.over), bat_curve_free(r.under);
    bat_numbers_clear(&r.points);
    return status;
}
