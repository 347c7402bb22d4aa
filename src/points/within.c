/* Fits that keep their tolerance whatever the points are. */
#include <batten/interpolate.h>

#include <batten/bezier.h>
#include <batten/measure.h>
#include <batten/nearest.h>
#include <batten/refine.h>

#include "base/real.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double LONG = 4, CORNER = 4; /* rows of points; radians: more than any corner */
static const double STRAY = 2; /* tolerances beyond a chord: a curve that far from the row has left it */
static const double SCRIBBLE =
    64; /* diagonals of its box: a longer row is everywhere, and nobody can leave it */
static const double TURN = 0.05; /* radians: what is a corner between two pieces */
enum { PLACES = 16 };            /* of a span, where it is seen whether the curve has left */
enum { PLAIN_POWER = 60 };       /* of two: what is larger, or smaller, is fitted in other units */

static double row_length(int m, size_t count, const double *points, bool closed) {
    double sum = 0;
    for (size_t i = 0; i + !closed < count; i++) {
        const double *a = points + i * (size_t)m, *b = points + (i + 1) % count * (size_t)m;
        const double plane = bat_hypot(b[0] - a[0], b[1] - a[1]);
        sum += m == 3 ? bat_hypot(plane, b[2] - a[2]) : plane;
    }
    return sum;
}

/* Whether boxes around parts of the row mostly overlap, so that no tree of them finds the nearest place. */
static bool is_scribble(int m, size_t count, const double *points, bool closed) {
    double sides = 0;
    for (int c = 0; c < m; c++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < count; i++)
            low = fmin(low, points[i * (size_t)m + (size_t)c]),
            high = fmax(high, points[i * (size_t)m + (size_t)c]);
        sides = bat_hypot(sides, high - low);
    }
    return row_length(m, count, points, closed) > SCRIBBLE * sides;
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

/* The greatest chord around a place of the row's polyline. */
static double chord_at(const bat_curve *row, double place) {
    const int m = bat_curve_dimension(row), last = (int)bat_curve_count(row) - 1;
    const int at = (int)fmin(fmax(floor(place), 0), last - 1);
    double most = 0;
    for (int i = at > 0 ? at - 1 : 0; i <= at + 1 && i < last; i++)
        most = fmax(most, row_length(m, 2, bat_curve_points(row) + i * m, false));
    return most;
}

/* Whether the curve goes away from the row between the points. */
static bat_status strays(const bat_curve *curve, const bat_curve *row, double tolerance, bool *out) {
    bat_finder *finder;
    double u[2], v[2], at[BAT_DIMENSION_MAX];
    const bat_status status = bat_finder_create(row, &finder);
    if (status != BAT_OK) return status;
    bat_curve_domain(curve, u), bat_curve_domain(row, v);
    const double *knots = bat_curve_knots(curve);
    const int total = bat_curve_knot_count(curve), last = (int)bat_curve_count(row) - 1;
    *out = false;
    for (int i = 0; i + 1 < total && !*out; i++) {
        const double low = fmax(knots[i], u[0]), high = fmin(knots[i + 1], u[1]);
        for (int k = 0; k < PLACES && low < high && !*out; k++) {
            bat_near near;
            bat_curve_eval(curve, low + (high - low) * (k + 0.5) / PLACES, 0, at);
            bat_finder_nearest(finder, at, &near);
            if (near.distance <= STRAY * tolerance) continue;
            const double place = (near.u - v[0]) / (v[1] - v[0]) * last;
            *out = near.distance > STRAY * tolerance + chord_at(row, place);
        }
    }
    bat_finder_free(finder);
    return BAT_OK;
}

/* The row as a polyline, back to its first point where it is closed. */
static bat_status polyline_of(int m, size_t count, const double *points, bool closed, bat_curve **out) {
    const size_t size = count * (size_t)m, more = closed ? (size_t)m : 0;
    double *all = malloc((size + more) * sizeof *all);
    if (!all) return BAT_MEMORY;
    memcpy(all, points, size * sizeof *all);
    memcpy(all + size, points, more * sizeof *all);
    const bat_status status = bat_curve_create_clamped(m, 1, count + closed, all, out);
    free(all);
    return status;
}

/* Béziers one after another. */
typedef struct chain {
    int dimension, count, room;
    double *points;
} chain;

/* Adds the natural spline through a part of the row; nothing where that is a point. */
static bat_status add_piece(chain *c, size_t count, const double *points) {
    bat_curve *curve = NULL, *cubic = NULL;
    bat_status status = bat_interpolate(c->dimension, false, count, points, NULL, &curve);
    if (status == BAT_COUNT) return BAT_OK;
    if (status == BAT_OK) status = bat_curve_elevate(curve, 3, &cubic);
    bat_curve_free(curve);
    if (status != BAT_OK) return status;
    const int n = bat_curve_segment_count(cubic), m = c->dimension;
    double *beziers = malloc((size_t)(4 * n * m) * sizeof *beziers);
    status = beziers && c->count + n <= c->room ? bat_curve_to_bezier(cubic, beziers, NULL) : BAT_MEMORY;
    for (int i = 0; i < n && status == BAT_OK; i++, c->count++)
        memcpy(c->points + 3 * c->count * m, beziers + 4 * i * m, (size_t)(4 * m) * sizeof *beziers);
    free(beziers);
    bat_curve_free(cubic);
    return status;
}

/* Splines from corner to corner. */
static bat_status between_corners(int m, size_t count, const double *points, const bat_fit_options *options,
                                  bat_curve **out) {
    const size_t first = options->closed ? (size_t)options->corners[0] : 0, n = count + options->closed;
    chain c = {.dimension = m, .room = (int)n};
    double *row = malloc(n * (size_t)m * sizeof *row); /* from the first corner round to it */
    c.points = malloc((3 * n + 1) * (size_t)m * sizeof *c.points);
    bat_status status = row && c.points ? BAT_OK : BAT_MEMORY;
    for (size_t i = 0; i < n && status == BAT_OK; i++)
        memcpy(row + i * (size_t)m, points + (first + i) % count * (size_t)m, (size_t)m * sizeof *row);
    size_t from = 0;
    for (size_t k = 0; k <= options->corner_count && status == BAT_OK; k++) {
        const size_t to = k < options->corner_count ? (size_t)options->corners[k] - first : n - 1;
        if (to > from) status = add_piece(&c, to - from + 1, row + from * (size_t)m);
        from = to;
    }
    if (status == BAT_OK && c.count > 0) /* no gap by rounding */
        memcpy(c.points + 3 * c.count * m, row + (n - 1) * (size_t)m, (size_t)m * sizeof *row);
    if (status == BAT_OK && options->closed && c.count > 0)
        memcpy(c.points, c.points + 3 * c.count * m, (size_t)m * sizeof *row);
    if (status == BAT_OK)
        status = c.count > 0
                     ? bat_curve_from_bezier(m, 3, options->closed, c.count, c.points, TURN, 0, out, NULL)
                     : BAT_COUNT;
    free(row), free(c.points);
    return status;
}

/* Through all points, then with as few knots as keep it near. */
static bat_status through(int m, size_t count, const double *points, const bat_fit_options *options,
                          bat_curve **out, bat_fit_report *report) {
    bat_curve *whole = NULL, *few = NULL;
    const bool corners = options->corner_count > 0;
    bat_status status = corners ? between_corners(m, count, points, options, &whole)
                                : bat_interpolate(m, options->closed, count, points, NULL, &whole);
    double error = 0;
    if (status == BAT_OK)
        status = bat_curve_simplify(whole, 0.99 * options->tolerance, corners ? TURN : CORNER, &few, &error);
    bat_curve_free(whole);
    if (status == BAT_OK && is_scribble(m, count, points, options->closed))
        error += 16 * DBL_EPSILON * bat_curve_size(few); /* of the interpolation */
    else if (status == BAT_OK)
        status = furthest(few, m, count, points, &error);
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
    bool wild = made && length_of(curve) > LONG * row_length(dimension, count, points, asked->closed);
    if (made && !wild && met && asked->degree == 3 && !is_scribble(dimension, count, points, asked->closed)) {
        bat_curve *row = NULL;
        bat_status seen = polyline_of(dimension, count, points, asked->closed, &row);
        if (seen == BAT_OK) seen = strays(curve, row, asked->tolerance, &wild);
        bat_curve_free(row);
        if (seen == BAT_MEMORY) {
            bat_curve_free(curve);
            return seen;
        }
    }
    if (made && (!met || wild) && asked->degree == 3) {
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
