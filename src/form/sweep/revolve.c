/* Surfaces of revolution. The circle is a cubic spline in the plane, each control point of the profile runs on it. */
#include "base/vec.h"
#include "form/surface/surface.h"

#include <batten/refine.h>
#include <batten/sweep.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double widest = 2 * BAT_PI / 3; /* span of an arc */
static const double on_axis = 1e-14; /* of the profile's size: points this close to the axis lie on it */

/* ---- the unit circle as a uniform cubic whose knots lie on it ---- */

/* The radius of the control points, a the angle of a span. */
static double control_radius(double a) { return 3 / (2 + bat_cos(a)); }

/* The greatest distance of a span from the circle at the same parameter: all spans are alike. */
static double arc_error(double a) {
    enum { SAMPLES = 64 };
    const double r = control_radius(a);
    double worst = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        const double t = (double)i / SAMPLES, s = 1 - t;
        const double weight[4] = {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                                  (3 * s * s * s - 6 * s * s + 4) / 6, t * t * t / 6};
        double x = -bat_cos(a * t), y = -bat_sin(a * t);
        for (int k = 0; k < 4; k++) {
            x += weight[k] * r * bat_cos(a * (k - 1));
            y += weight[k] * r * bat_sin(a * (k - 1));
        }
        worst = fmax(worst, bat_hypot(x, y));
    }
    return worst;
}

/* The least number of spans within the tolerance; 0: more than `limit` of them. */
static int count_spans(double angle, double tolerance, int limit) {
    int high = (int)ceil(fabs(angle) / widest - 1e-9), low = high - 1;
    if (high < 1) high = 1;
    while (high <= limit && !(arc_error(angle / high) <= tolerance)) {
        low = high;
        high *= 2;
    }
    if (high > limit) {
        if (low >= limit || !(arc_error(angle / limit) <= tolerance)) return 0;
        high = limit;
    }
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (arc_error(angle / middle) <= tolerance)
            high = middle;
        else
            low = middle;
    }
    return high;
}

/* The arc from angle 0, closed when it is the whole circle, over [0, 1]. */
static bat_status make_arc(double angle, int spans, bool closed, bat_curve **out) {
    const double a = angle / spans, r = control_radius(a);
    const int lead = closed ? 0 : 3, count = closed ? spans : spans + 3;
    bat_curve *arc;
    bat_status status = bat_curve_allocate(3, 2, closed, count, &arc);
    if (status != BAT_OK) return status;
    const int knots = bat_curve_knot_count(arc);
    for (int i = 0; i < knots; i++) bat_curve_own_knots(arc)[i] = (double)(i - lead) / spans;
    for (int i = 0; i < count; i++) {
        bat_curve_own_points(arc)[2 * i] = r * bat_cos(a * (i + 2 - lead));
        bat_curve_own_points(arc)[2 * i + 1] = r * bat_sin(a * (i + 2 - lead));
    }
    bat_curve *loose = NULL;
    status = bat_curve_finish(arc, &loose);
    if (status != BAT_OK || closed) {
        *out = loose;
        return status;
    }
    status = bat_curve_clamp(loose, out);
    bat_curve_free(loose);
    return status;
}

/* ---- the profile about the axis ---- */

typedef struct spindle {
    vec origin, axis; /* axis of length 1 */
} spindle;

/* The point's foot on the axis, and the vector from there to it. */
static vec from_axis(const spindle *s, const double *point, double least, vec *foot) {
    const vec away = vec_sub(vec_load(point, 3), s->origin);
    const vec out = vec_reject(away, s->axis);
    *foot = vec_sub(vec_load(point, 3), out);
    return vec_norm(out) > least ? out : (vec){0, 0, 0};
}

static double farthest(const spindle *s, const bat_curve *profile, double least) {
    double most = 0;
    for (int j = 0; j < profile->count; j++) {
        vec foot;
        most = fmax(most, vec_norm(from_axis(s, bat_curve_points(profile) + 3 * j, least, &foot)));
    }
    return most;
}

static bat_status turn(const spindle *s, const bat_curve *profile, const bat_curve *arc, double least,
                       bat_surface **out) {
    const int degree[2] = {3, profile->degree}, count[2] = {arc->count, profile->count};
    const bool closed[2] = {arc->closed, profile->closed};
    bat_surface *made;
    bat_status status = bat_surface_allocate(degree, closed, count, &made);
    if (status != BAT_OK) return status;
    memcpy(bat_curve_own_knots(&made->axis[0]), bat_curve_knots(arc),
           (size_t)bat_curve_knot_count(arc) * sizeof(double));
    memcpy(bat_curve_own_knots(&made->axis[1]), bat_curve_knots(profile),
           (size_t)bat_curve_knot_count(profile) * sizeof(double));
    for (int i = 0; i < arc->count; i++) {
        const double *c = bat_curve_points(arc) + 2 * i;
        double *row = bat_surface_own_row(made, i);
        for (int j = 0; j < profile->count; j++) {
            vec foot;
            const vec x = from_axis(s, bat_curve_points(profile) + 3 * j, least, &foot);
            const vec y = vec_cross(s->axis, x);
            vec_store(vec_add(foot, vec_add(vec_scale(x, c[0]), vec_scale(y, c[1]))), row + 3 * j);
        }
    }
    return bat_surface_finish(made, out);
}

static bat_status revolve(const spindle *s, const bat_curve *profile, double angle, double tolerance,
                          bat_surface **out, double *max_error) {
    const bool closed = fabs(angle) >= 2 * BAT_PI * (1 - 1e-14);
    const double least = on_axis * bat_curve_size(profile), radius = farthest(s, profile, least);
    if (!(radius > 0)) return BAT_SINGULAR;
    const int limit = BAT_POINTS_MAX / profile->count - 3;
    const int spans = count_spans(angle, tolerance / radius, limit);
    if (spans == 0) return BAT_COUNT;
    bat_curve *arc = NULL;
    bat_status status = make_arc(angle, spans, closed, &arc);
    if (status == BAT_OK) status = turn(s, profile, arc, least, out);
    bat_curve_free(arc);
    if (status == BAT_OK && max_error) *max_error = arc_error(angle / spans) * radius;
    return status;
}

bat_status bat_surface_revolve(const bat_curve *profile, const double origin[3], const double direction[3],
                               double angle, double tolerance, bat_surface **out, double *max_error) {
    if (!profile || !origin || !direction || !out) return BAT_ARGUMENT;
    if (!bat_are_coordinates(origin, 3) || !bat_are_coordinates(direction, 3) || !isfinite(angle) ||
        !isfinite(tolerance))
        return BAT_NUMBER;
    const spindle s = {vec_load(origin, 3), vec_unit(vec_load(direction, 3))};
    if (!(vec_norm(s.axis) > 0) || !(angle != 0) || !(fabs(angle) <= 2 * BAT_PI * (1 + 1e-14)) ||
        !(tolerance > 0))
        return BAT_ARGUMENT;
    bat_curve *space = NULL;
    bat_status status = bat_curve_to_dimension(profile, 3, &space);
    if (status == BAT_OK) status = revolve(&s, space, angle, tolerance, out, max_error);
    bat_curve_free(space);
    return status;
}
