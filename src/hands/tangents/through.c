/* A cubic curve as a G1 spline that is the same: a point at each knot, its direction there, and tensions that make the handles as long as the
 * curve's own. Heights over a plane curve of continuous direction may have corners, whose two slopes become their mean. */
#include "base/real.h"
#include "curve/curve.h"
#include "hands/tangents/spline.h"

#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double CORNER = 1e-6; /* radians: smaller turns are rounding */

/* The derivatives before and after a knot, each over the span on that side as [0, 1]; zero where there is none. */
static void sides(const bat_curve *curve, const double *at, int i, int count, vec *left, vec *right) {
    const int n = curve->dimension;
    const bool closed = curve->closed;
    double jet[2 * BAT_DIMENSION_MAX];
    *left = *right = (vec){0, 0, 0};
    if (i < count - 1 || closed) {
        bat_curve_eval(curve, at[i], 1, jet);
        *right = vec_scale(vec_load(jet + n, n), at[i + 1] - at[i]);
    }
    if (i > 0 || closed) {
        const int k = i > 0 ? i : count;
        bat_curve_eval_left(curve, at[k], 1, jet);
        *left = vec_scale(vec_load(jet + n, n), at[k] - at[k - 1]);
    }
}

/* Distinct knots of the domain, with its end; how many. */
static int places(const bat_curve *curve, double *out) {
    double domain[2];
    int count = 0;
    const double *t = bat_curve_knots(curve);
    bat_curve_domain(curve, domain);
    for (int i = 0; i < bat_curve_knot_count(curve); i++)
        if (t[i] >= domain[0] && t[i] <= domain[1] && (count == 0 || t[i] > out[count - 1]))
            out[count++] = t[i];
    return count;
}

static void put(vec v, int size, double *out) {
    double all[3];
    vec_store(v, all);
    memcpy(out, all, (size_t)size * sizeof(double));
}

static bool bends(vec left, vec right) {
    return vec_norm(left) > 0 && vec_norm(right) > 0 &&
           vec_norm(vec_sub(vec_unit(left), vec_unit(right))) > CORNER;
}

/* One slope for both sides of a joint that is smooth as seen from above. False: it is not. */
static bool smooth_slope(vec *left, vec *right) {
    const double before = bat_hypot(left->x, left->y), after = bat_hypot(right->x, right->y);
    if (bends((vec){left->x, left->y, 0}, (vec){right->x, right->y, 0}) || !(before > 0) || !(after > 0))
        return false;
    const double slope = (left->z / before + right->z / after) / 2;
    left->z = slope * before, right->z = slope * after;
    return true;
}

/* Points, directions and, as tensions, the wanted lengths of the derivatives. */
static bat_status fill(const bat_curve *curve, const double *at, int count, double *points, double *tangents,
                       double *tension) {
    const int n = curve->dimension;
    for (int i = 0; i < count; i++) {
        vec left, right;
        bat_curve_eval(curve, at[i], 0, points + i * n);
        sides(curve, at, i, count, &left, &right);
        if (bends(left, right) && !smooth_slope(&left, &right)) return BAT_TOLERANCE;
        const double before = vec_norm(left), after = vec_norm(right);
        put(vec_unit(before > after ? left : right), n, tangents + i * n);
        tension[2 * i] = before, tension[2 * i + 1] = after;
    }
    return BAT_OK;
}

bat_status bat_spline_through(const bat_curve *cubic, const bat_tangents_options *options, bat_spline *out,
                              void **block) {
    const int n = cubic->dimension, knots = bat_curve_knot_count(cubic);
    if (cubic->degree != 3) return BAT_DEGREE;
    const size_t room = (size_t)knots, each = 2 * (size_t)n + 3;
    double *all = malloc(room * each * sizeof *all);
    bat_joint *joints = malloc(room * sizeof *joints);
    bat_status status = all && joints ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) {
        double *points = all, *tangents = points + room * (size_t)n, *tension = tangents + room * (size_t)n,
               *at = tension + 2 * room;
        const int distinct = places(cubic, at), count = distinct - (cubic->closed ? 1 : 0);
        bat_spline made = {n, cubic->closed, (size_t)count, points, tangents, NULL};
        status = fill(cubic, at, count, points, tangents, tension);
        if (status == BAT_OK) status = bat_tangents(&made, options, joints, NULL, NULL, NULL);
        for (int i = 0; i < count && status == BAT_OK; i++) {
            const double own[2] = {vec_norm(vec_load(joints[i].left, 3)),
                                   vec_norm(vec_load(joints[i].right, 3))};
            if (joints[i].dropped) status = BAT_TOLERANCE;
            for (int k = 0; k < 2; k++) tension[2 * i + k] = own[k] > 0 ? tension[2 * i + k] / own[k] : 1;
        }
        made.tension = tension;
        if (status == BAT_OK) *out = made, *block = all;
    }
    free(joints);
    if (status != BAT_OK) free(all);
    return status;
}
