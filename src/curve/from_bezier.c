/*
 * One B-spline from a path of Bézier segments. Every joint starts as a knot of multiplicity p, which is
 * exact. A joint is C1 when the handles beside it are collinear and in proportion to the spans beside it, so
 * at a smooth joint the next span's length is the last one's times |outgoing handle| / |incoming handle|.
 * Removal then takes out what is not needed. Runs of smooth joints start at a corner where there is one.
 */
#include "curve/curve.h"

#include <batten/bezier.h>
#include <batten/refine.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double SPEED_RANGE =
    1e5; /* a run is broken where its speed leaves 1/range..range of its first one */

static const double SPAN_LEAST = 1e-10; /* of the mean span */

static double polygon(const double *points, int degree, int size) {
    double length = 0;
    for (int i = 0; i < degree; i++) length += bat_distance(points + i * size, points + (i + 1) * size, size);
    return length;
}

/* Length of span i's parameter, when the one before (`last`, of handle length `in`) is joined smoothly. */
static void choose_spans(int degree, int size, int count, const double *points, bool closed, double corner,
                         double range, double *spans) {
    int first = 0, step = degree * size;
    double mean = 0;
    for (int i = 0; i < count; i++) mean += polygon(points + (size_t)i * (size_t)step, degree, size) / count;
    /* The joint before segment i: its handles. */
    for (int i = 1; closed && i < count; i++) {
        const double *joint = points + (size_t)i * (size_t)step;
        if (bat_turn(joint - size, joint, joint + size, size) > corner) {
            first = i;
            break;
        }
    }
    const double *end = points + (size_t)count * (size_t)step;
    if (closed && bat_turn(end - size, points, points + size, size) > corner) first = 0;
    double begun = 1;
    for (int k = 0; k < count; k++) {
        int i = (first + k) % count, before = (i + count - 1) % count;
        const double *here = points + (size_t)i * (size_t)step;
        const double *inner = points + (size_t)before * (size_t)step + (size_t)((degree - 1) * size);
        double natural = polygon(here, degree, size) / mean;
        spans[i] = natural;
        if (k > 0 && bat_turn(inner, here, here + size, size) <= corner) {
            double h = spans[before] *
                       (bat_distance(here, here + size, size) / bat_distance(inner, here, size));
            double slow = h / natural / begun;
            if (slow > 1 / range && slow < range) spans[i] = h;
        }
        if (spans[i] == natural) begun = 1;
        spans[i] = fmax(spans[i], SPAN_LEAST);
    }
}

/* Segments whose points all coincide (to 1e-12 of the mean) are left out; returns how many are left. */
static int drop_points(int degree, int size, int count, double *points, double *moved) {
    size_t step = (size_t)(degree * size);
    double mean = 0;
    for (int i = 0; i < count; i++) mean += polygon(points + (size_t)i * step, degree, size) / count;
    int kept = 0;
    for (int i = 0; i < count; i++) {
        double length = polygon(points + (size_t)i * step, degree, size);
        if (!(length > 1e-12 * mean)) {
            *moved += length;
            continue;
        }
        memmove(points + (size_t)kept * step + (size_t)size, points + (size_t)i * step + (size_t)size,
                step * sizeof(double));
        kept++;
    }
    return kept;
}

static bat_status assemble(int degree, int size, int count, const double *points, bool closed,
                           const double *spans, bat_curve **out) {
    bat_curve *curve;
    int n = count * degree + (closed ? 0 : 1);
    bat_status status = bat_curve_allocate(degree, size, closed, n, &curve);
    if (status != BAT_OK) return status;
    double *knots = bat_curve_own_knots(curve), t = 0;
    if (!closed) *knots++ = 0;
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < degree; k++) *knots++ = t;
        t += spans[i];
    }
    for (int k = 0; k < (closed ? 1 : degree + 1); k++) *knots++ = t;
    /* Closed: P_i has knots t_{i+1}..t_{i+p}, so that the list begins with the second point. */
    memcpy(bat_curve_own_points(curve), closed ? points + size : points, (size_t)(n * size) * sizeof(double));
    return bat_curve_finish(curve, out);
}

bat_status bat_curve_from_bezier(int dimension, int degree, bool closed, int segments, const double *points,
                                 double corner, double tolerance, bat_curve **out, double *error) {
    return bat_curve_from_chain(dimension, degree, closed, segments, points, corner, SPEED_RANGE, tolerance,
                                out, error);
}

bat_status bat_curve_from_chain(int dimension, int degree, bool closed, int segments, const double *points,
                                double corner, double range, double tolerance, bat_curve **out,
                                double *error) {
    if (!points || !out || !(corner >= 0) || !(tolerance >= 0)) return BAT_ARGUMENT;
    if (degree < 1 || degree > BAT_DEGREE_MAX) return BAT_DEGREE;
    if (dimension < 2 || dimension > BAT_DIMENSION_MAX) return BAT_DIMENSION;
    if (segments < 1 || segments > BAT_POINTS_MAX / degree - 1) return BAT_COUNT;
    size_t total = ((size_t)segments * (size_t)degree + 1) * (size_t)dimension;
    double greatest = 0, moved = 0, removal = 0;
    for (size_t i = 0; i < total; i++) {
        if (!(fabs(points[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
        greatest = fmax(greatest, fabs(points[i]));
    }
    for (int c = 0; closed && c < dimension; c++)
        if (points[c] != points[total - (size_t)dimension + (size_t)c]) return BAT_ARGUMENT;
    double *copy = malloc((total + (size_t)segments) * sizeof(double));
    if (!copy) return BAT_MEMORY;
    double *spans = copy + total;
    memcpy(copy, points, total * sizeof(double));
    bat_status status = BAT_OK;
    int kept = drop_points(degree, dimension, segments, copy, &moved);
    if (kept < 1 || (closed && kept * degree < 2)) status = BAT_COUNT;
    bat_curve *exact, *simple;
    if (status == BAT_OK) {
        choose_spans(degree, dimension, kept, copy, closed, corner, range, spans);
        status = assemble(degree, dimension, kept, copy, closed, spans, &exact);
    }
    free(copy);
    if (status != BAT_OK) return status;
    /* Exact means to rounding. */
    status = bat_curve_simplify(exact, fmax(tolerance, 64 * DBL_EPSILON * greatest), corner, &simple,
                                &removal);
    bat_curve_free(exact);
    if (status != BAT_OK) return status;
    if (closed) { /* the seam is a joint like any other */
        bat_curve *whole = NULL;
        double seam = simple->knots[degree], more = 0;
        int removed = 0;
        double left = fmax(tolerance - removal, 64 * DBL_EPSILON * greatest);
        if (bat_knot_multiplicity(simple, seam) == 1)
            status = bat_curve_remove_knot(simple, seam, 1, left, &whole, &removed, &more);
        if (status != BAT_OK) {
            bat_curve_free(simple);
            return status;
        }
        if (whole) {
            bat_curve_free(simple);
            simple = whole, removal += more;
        }
    }
    *out = simple;
    if (error) *error = moved + removal;
    return BAT_OK;
}
