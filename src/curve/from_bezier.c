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

/* Spans so short that a period later their knots would be one: they are as long as doubles can tell. */
static void keep_apart(int count, double *spans) {
    double period = 0;
    for (int i = 0; i < count; i++) period += spans[i];
    for (int i = 0; i < count; i++) spans[i] = fmax(spans[i], 8 * DBL_EPSILON * period);
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

/* Puts knots back at the ends of spans where there are none left; takes the curve over. */
static bat_status keep_joints(int count, const double *spans, bat_curve **curve) {
    double *knots = malloc((size_t)count * sizeof *knots), t = 0;
    bat_curve *refined = NULL;
    int missing = 0;
    if (!knots) return BAT_MEMORY;
    for (int i = 0; i + 1 < count; i++) {
        t += spans[i];
        if (bat_knot_multiplicity(*curve, t) == 0) knots[missing++] = t;
    }
    const bat_status status = missing ? bat_curve_insert_knots(*curve, missing, knots, &refined) : BAT_OK;
    free(knots);
    if (!refined) return status;
    bat_curve_free(*curve);
    *curve = refined;
    return BAT_OK;
}

/* The seam of a closed curve is a joint like any other, and goes where it is not needed. */
static bat_status merge_seam(double tolerance, bat_curve **curve, double *removal) {
    bat_curve *whole = NULL;
    const double seam = (*curve)->knots[(*curve)->degree];
    double more = 0;
    int removed = 0;
    if (bat_knot_multiplicity(*curve, seam) != 1) return BAT_OK;
    const bat_status status = bat_curve_remove_knot(*curve, seam, 1, tolerance, &whole, &removed, &more);
    if (!whole) return status;
    bat_curve_free(*curve);
    *curve = whole;
    *removal += more;
    return BAT_OK;
}

static bat_status from_chain(int dimension, int degree, bool closed, int segments, const double *points,
                             double corner, double range, double tolerance, bat_seams joints, bat_curve **out,
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
        if (closed) keep_apart(kept, spans);
        status = assemble(degree, dimension, kept, copy, closed, spans, &exact);
    }
    if (status != BAT_OK) {
        free(copy);
        return status;
    }
    /* Exact means to rounding. */
    const double least = 64 * DBL_EPSILON * greatest;
    status = bat_curve_simplify(exact, fmax(tolerance, least), corner, &simple, &removal);
    bat_curve_free(exact);
    if (status == BAT_OK) {
        if (closed && joints == BAT_SEAMS_MERGED)
            status = merge_seam(fmax(tolerance - removal, least), &simple, &removal);
        if (joints == BAT_SEAMS_KEPT) status = keep_joints(kept, spans, &simple);
        if (status != BAT_OK) bat_curve_free(simple);
    }
    free(copy);
    if (status != BAT_OK) return status;
    *out = simple;
    if (error) *error = moved + removal;
    return BAT_OK;
}

bat_status bat_curve_from_chain(int dimension, int degree, bool closed, int segments, const double *points,
                                double corner, double range, double tolerance, bat_curve **out,
                                double *error) {
    return from_chain(dimension, degree, closed, segments, points, corner, range, tolerance, BAT_SEAMS_MERGED,
                      out, error);
}

bat_status bat_curve_from_seams(int dimension, int degree, bool closed, int segments, const double *points,
                                double corner, double tolerance, bat_seams joints, bat_curve **out,
                                double *error) {
    return from_chain(dimension, degree, closed, segments, points, corner, SPEED_RANGE, tolerance, joints,
                      out, error);
}

bat_status bat_curve_from_bezier(int dimension, int degree, bool closed, int segments, const double *points,
                                 double corner, double tolerance, bat_curve **out, double *error) {
    return bat_curve_from_chain(dimension, degree, closed, segments, points, corner, SPEED_RANGE, tolerance,
                                out, error);
}
