/* Bytes become a curve and a series of public calls on it. Whatever the numbers, each call returns a status
 * and never crashes, and every result is a valid curve. */
#include "bytes.h"
#include <batten/bezier.h>

#include "curve/curve.h"
#include <batten/drag.h>
#include <batten/fit.h>
#include <batten/refine.h>

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Mostly tame numbers, sometimes any eight bytes: NaN, infinities, denormals. */
static double number(bytes *in) {
    int kind = small(in, 255);
    if (kind < 224) return (kind - 112) / 8.0;
    if (kind < 240) return ldexp(kind - 231.5, small(in, 200) - 100);
    return any_number(in);
}

static bat_curve *read_curve(bytes *in) {
    enum { ROOM = 40 };
    double knots[2 * ROOM], points[ROOM * 3], t = number(in);
    int degree = small(in, 8), dimension = 2 + small(in, 1), n = small(in, ROOM - 1);
    bool closed = small(in, 1), sorted = small(in, 7) > 0;
    int knot_count = closed ? n + 1 : n + degree + 1, start = small(in, 2) * degree;
    for (int i = 0; i < knot_count; i++) {
        knots[i] = sorted ? t : number(in);
        bool run = !closed && (i < start || (start > 0 && i >= n));
        if (!run) t += fabs(small(in, 3) == 0 ? 0 : number(in));
    }
    for (int i = 0; i < n * dimension; i++) points[i] = number(in);
    bat_curve *curve = NULL;
    if (small(in, 15) == 0) {
        if (bat_curve_create_clamped(dimension, degree, (size_t)n, points, &curve) != BAT_OK && curve)
            abort();
    } else if (bat_curve_create(dimension, degree, closed, (size_t)n, points, knot_count, knots, &curve) !=
                   BAT_OK &&
               curve)
        abort();
    return curve;
}

/* The result of an operation passes validation again and evaluates to finite numbers. */
static void check(const bat_curve *curve) {
    bat_curve *again = NULL;
    if (bat_curve_create(bat_curve_dimension(curve), bat_curve_degree(curve), bat_curve_is_closed(curve),
                         bat_curve_count(curve), bat_curve_points(curve), bat_curve_knot_count(curve),
                         bat_curve_knots(curve), &again) != BAT_OK)
        abort();
    if (!bat_curve_is_equal(curve, again)) abort();
    double u[9], out[9 * 3];
    bat_curve_spread(curve, 9, u);
    if (bat_curve_eval_many(curve, 9, u, 0, out) != BAT_OK) abort();
    for (int i = 0; i < 9 * bat_curve_dimension(curve); i++)
        if (!isfinite(out[i])) abort();
    bat_curve_free(again);
}

static void evaluate(bytes *in, const bat_curve *curve) {
    double out[9 * 3], u[16], values[8], arguments[8];
    int order = small(in, 8), first, count = small(in, 16), size = bat_curve_dimension(curve);
    bat_curve_eval(curve, number(in), order, out);
    bat_curve_eval_left(curve, number(in), order, out);
    for (int i = 0; i < count; i++) u[i] = number(in);
    double *many = malloc((size_t)(count * (order + 1) * size + 1) * sizeof(double));
    if (many) bat_curve_eval_many(curve, (size_t)count, u, order, many);
    free(many);
    for (int i = 0; i < 8; i++) arguments[i] = number(in);
    u[0] = number(in);
    bat_curve_blossom(curve, u[0], arguments, small(in, 1), out);
    bat_curve_basis(curve, number(in), &first, values);
    if (first < 0 || first >= bat_point_count(curve)) abort();
    double *greville = malloc((size_t)bat_point_count(curve) * sizeof(double));
    if (greville) bat_curve_greville(curve, greville);
    free(greville);
}

/* Checks all segments: there are as many as the curve says, and all are finite. */
static bat_status segments(const bat_curve *curve) {
    int count = bat_curve_segment_count(curve), size = bat_curve_dimension(curve);
    int numbers = count * (bat_curve_degree(curve) + 1) * size;
    double *points = malloc((size_t)numbers * sizeof *points),
           *breaks = malloc((size_t)(count + 1) * sizeof *breaks);
    if (points && breaks && bat_curve_to_bezier(curve, points, breaks) == BAT_OK) {
        for (int i = 0; i < numbers; i++)
            if (!isfinite(points[i])) abort();
        for (int i = 0; i < count; i++)
            if (!(breaks[i] < breaks[i + 1])) abort();
    }
    free(points);
    free(breaks);
    return BAT_ARGUMENT;
}

/* Drags some points of the curve, or a control point. */
static bat_status drag(bytes *in, const bat_curve *curve, bat_curve **out) {
    double u[4], delta[12];
    int count = small(in, 4);
    for (int i = 0; i < 12; i++) delta[i] = number(in);
    if (count == 0) return bat_curve_move_point(curve, small(in, 40) - 1, delta, out);
    for (int i = 0; i < count; i++) u[i] = number(in);
    return bat_curve_drag(curve, (size_t)count, u, delta, out);
}

static bat_status change(bytes *in, const bat_curve *curve, const bat_curve *other, bat_curve **out,
                         bat_curve **second) {
    double u[12], error = 0, matrix[12], *cubics = NULL;
    int removed, count;
    bat_status status;
    switch (small(in, 22)) {
    case 0: u[0] = number(in); return bat_curve_insert_knot(curve, u[0], small(in, 9), out);
    case 1:
        count = small(in, 12);
        for (int i = 0; i < count; i++) u[i] = number(in);
        return bat_curve_insert_knots(curve, count, u, out);
    case 2:
        u[0] = number(in);
        count = small(in, 8);
        status = bat_curve_remove_knot(curve, u[0], count, number(in), out, &removed, &error);
        if (status == BAT_OK && !(error >= 0 && removed >= 0)) abort();
        return status;
    case 3: u[0] = number(in); return bat_curve_simplify(curve, u[0], number(in), out, &error);
    case 4: return bat_curve_elevate(curve, small(in, 8), out);
    case 5: return bat_curve_clamp(curve, out);
    case 6: return bat_curve_reverse(curve, out);
    case 7: u[0] = number(in); return bat_curve_reparametrise(curve, u[0], number(in), out);
    case 8: return bat_curve_split(curve, number(in), out, second);
    case 9: u[0] = number(in); return bat_curve_piece(curve, u[0], number(in), out);
    case 10: return bat_curve_open_at(curve, number(in), out);
    case 11: return bat_curve_close(curve, number(in), out);
    case 12: return bat_curve_move_seam(curve, number(in), out);
    case 13:
        if (!other) return BAT_ARGUMENT;
        count = small(in, 3);
        return bat_curve_join(curve, other, count, number(in), out, &error);
    case 14:
        for (int i = 0; i < 12; i++) matrix[i] = number(in);
        return bat_curve_transform(curve, matrix, out);
    case 15:
        status = bat_curve_to_cubics(curve, number(in), &count, &cubics);
        if (status == BAT_OK || status == BAT_TOLERANCE) bat_free(cubics);
        return BAT_ARGUMENT;
    case 17: return segments(curve);
    case 18: return drag(in, curve, out);
    case 19: u[0] = number(in); return bat_curve_refit(curve, u[0], number(in), out, &error);
    case 20: u[0] = number(in); return bat_curve_refit_g1(curve, u[0], number(in), out, &error);
    case 21:
        u[0] = number(in), u[1] = number(in);
        return bat_curve_refit_extremes(curve, u[0], u[1], number(in), out, &error);
    case 16:
        return bat_curve_refine(curve, bat_curve_knot_count(other ? other : curve),
                                bat_curve_knots(other ? other : curve), out);
    default: return bat_curve_to_dimension(curve, 1 + small(in, 3), out);
    }
}

static void path(bytes *in) {
    double points[3 * 7 * 8 + 3];
    int degree = small(in, 8), dimension = 2 + small(in, 1), count = small(in, 8);
    bool closed = small(in, 1);
    int total = (count * degree + 1) * dimension;
    if (total > (int)(sizeof points / sizeof points[0])) return;
    for (int i = 0; i < total; i++) points[i] = number(in);
    if (closed && total > 3) memcpy(points + total - dimension, points, (size_t)dimension * sizeof(double));
    bat_curve *curve = NULL;
    double corner = number(in), error;
    if (bat_curve_from_bezier(dimension, degree, closed, count, points, corner, number(in), &curve, &error) ==
        BAT_OK)
        check(curve);
    bat_curve_free(curve);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    bytes in = {data, size};
    if (small(&in, 3) == 0) {
        path(&in);
        return 0;
    }
    bat_curve *curve = read_curve(&in), *other = small(&in, 1) ? read_curve(&in) : NULL;
    for (int step = 0; curve && in.left > 0 && step < 12; step++) {
        evaluate(&in, curve);
        bat_curve *next = NULL, *second = NULL;
        bat_status status = change(&in, curve, other, &next, &second);
        if (!bat_status_message(status)) abort();
        if (status != BAT_OK) {
            if (next || second) abort();
            continue;
        }
        check(next);
        if (second) check(second);
        bat_curve_free(curve), bat_curve_free(second);
        curve = next;
    }
    bat_curve_free(curve), bat_curve_free(other);
    return 0;
}
