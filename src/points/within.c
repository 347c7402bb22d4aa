/* Fits that keep their tolerance whatever the points are. */
#include <batten/interpolate.h>

#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>

#include "base/real.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

static const double LONG = 4, CORNER = 4; /* rows of points; radians: more than any corner */
enum { PLAIN_POWER = 60 };                /* of two: what is larger, or smaller, is fitted in other units */

static double row_length(int m, size_t count, const double *points, bool closed) {
    double sum = 0;
    for (size_t i = 0; i + !closed < count; i++) {
        const double *a = points + i * (size_t)m, *b = points + (i + 1) % count * (size_t)m;
        const double plane = bat_hypot(b[0] - a[0], b[1] - a[1]);
        sum += m == 3 ? bat_hypot(plane, b[2] - a[2]) : plane;
    }
    return sum;
}

static double length_of(const bat_curve *curve) {
    double domain[2];
    bat_curve_domain(curve, domain);
    return bat_curve_length(curve, domain[0], domain[1], 1e-3);
}

static bat_status furthest(const bat_curve *curve, int m, size_t count, const double *points, double *out) {
    bat_finder *finder;
    const bat_status status = bat_finder_create(curve, &finder);
    if (status != BAT_OK) return status;
    *out = 0;
    for (size_t i = 0; i < count; i++) {
        bat_near near;
        bat_finder_nearest(finder, points + i * (size_t)m, &near);
        *out = fmax(*out, near.distance);
    }
    bat_finder_free(finder);
    return BAT_OK;
}

/* Through all points, then with as few knots as keep it near. */
static bat_status through(int m, size_t count, const double *points, const bat_fit_options *options,
                          bat_curve **out, bat_fit_report *report) {
    bat_curve *whole = NULL, *few = NULL;
    bat_status status = bat_interpolate(m, options->closed, count, points, NULL, &whole);
    if (status == BAT_OK) status = bat_curve_simplify(whole, 0.99 * options->tolerance, CORNER, &few, NULL);
    bat_curve_free(whole);
    double error = 0;
    if (status == BAT_OK) status = furthest(few, m, count, points, &error);
    if (status != BAT_OK) {
        bat_curve_free(few);
        return status;
    }
    report->max_error = error;
    report->knots = bat_curve_knot_count(few) - (options->closed ? 1 : 8);
    *out = few;
    return error <= options->tolerance ? BAT_OK : BAT_TOLERANCE;
}

static bat_status fit_near(int dimension, size_t count, const double *points, const bat_fit_options *asked,
                           bat_curve **out, bat_fit_report *report) {
    bat_curve *curve = NULL;
    bat_fit_report own = {0};
    bat_status status = bat_fit(dimension, count, points, asked, &curve, &own);
    const bool met = status == BAT_OK && own.max_error <= asked->tolerance;
    const bool made = status == BAT_OK || status == BAT_TOLERANCE;
    const bool wild = made && length_of(curve) > LONG * row_length(dimension, count, points, asked->closed);
    if (made && (!met || wild) && asked->degree == 3 && asked->corner_count == 0) {
        bat_curve *other = NULL;
        bat_fit_report its = own;
        const bat_status second = through(dimension, count, points, asked, &other, &its);
        if (second == BAT_MEMORY) {
            bat_curve_free(curve);
            return second;
        }
        if (second == BAT_OK || (wild && second == BAT_TOLERANCE)) {
            bat_curve_free(curve);
            curve = other, own = its, status = second;
        } else {
            bat_curve_free(other);
        }
    }
    if (!made) return status;
    *out = curve;
    if (report) *report = own;
    return status;
}

/* The power of two of the points' extent; 0 where there are none, or none that can be fitted. */
static int power_of(int dimension, size_t count, const double *points) {
    double most = 0;
    int power = 0;
    if (!points || dimension < 1) return 0;
    for (size_t i = 0; i < count * (size_t)dimension; i++)
        most = fmax(most, fabs(points[i] - points[i % (size_t)dimension]));
    if (most > 0 && isfinite(most)) frexp(most, &power);
    return power;
}

/* The curve 2^power times as large, with the knots that it has. */
static bat_status magnified(const bat_curve *curve, int power, bat_curve **out) {
    const int m = bat_curve_dimension(curve), knots = bat_curve_knot_count(curve);
    const size_t n = bat_curve_count(curve), size = n * (size_t)m;
    double *points = malloc(size * sizeof *points);
    if (!points) return BAT_MEMORY;
    for (size_t i = 0; i < size; i++) points[i] = ldexp(bat_curve_points(curve)[i], power);
    const bat_status status = bat_curve_create(m, bat_curve_degree(curve), bat_curve_is_closed(curve), n,
                                               points, knots, bat_curve_knots(curve), out);
    free(points);
    return status;
}

/* Points as large or as small as that are fitted in units of 2^power, which rounds nothing. */
static bat_status fit_scaled(int dimension, size_t count, const double *points, const bat_fit_options *asked,
                             int power, bat_curve **out, bat_fit_report *report) {
    const size_t size = count * (size_t)dimension;
    if (size == 0) return BAT_ARGUMENT;
    double *scaled = malloc(size * sizeof *scaled);
    if (!scaled) return BAT_MEMORY;
    for (size_t i = 0; i < size; i++) scaled[i] = ldexp(points[i], -power);
    bat_fit_options options = *asked;
    options.tolerance = options.tolerance > 0 ? fmax(ldexp(options.tolerance, -power), DBL_MIN) : 0;
    options.smoothing = ldexp(options.smoothing, -power);
    bat_curve *curve = NULL;
    bat_fit_report own = {0};
    bat_status status = fit_near(dimension, count, scaled, &options, &curve, &own);
    free(scaled);
    if (status != BAT_OK && status != BAT_TOLERANCE) return status;
    const bat_status made = magnified(curve, power, out);
    bat_curve_free(curve);
    own.max_error = ldexp(own.max_error, power);
    if (made == BAT_OK && report) *report = own;
    return made == BAT_OK ? status : made;
}

bat_status bat_fit_within(int dimension, size_t count, const double *points, const bat_fit_options *options,
                          bat_curve **out, bat_fit_report *report) {
    const bat_fit_options plain = bat_fit_defaults();
    const bat_fit_options *asked = options ? options : &plain;
    if (!out) return BAT_ARGUMENT;
    const int power = count > BAT_POINTS_MAX ? 0 : power_of(dimension, count, points);
    if (power >= -PLAIN_POWER && power <= PLAIN_POWER)
        return fit_near(dimension, count, points, asked, out, report);
    return fit_scaled(dimension, count, points, asked, power, out, report);
}
