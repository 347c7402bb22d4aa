/* Fits that keep their tolerance whatever the points are. */
#include <batten/interpolate.h>

#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>

#include "base/real.h"

#include <math.h>

static const double LONG = 4, CORNER = 4; /* rows of points; radians: more than any corner */

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

bat_status bat_fit_within(int dimension, size_t count, const double *points, const bat_fit_options *options,
                          bat_curve **out, bat_fit_report *report) {
    const bat_fit_options plain = bat_fit_defaults();
    const bat_fit_options *asked = options ? options : &plain;
    if (!out) return BAT_ARGUMENT;
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
