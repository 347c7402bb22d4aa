/*
 * Refits a curve with as few knots as keep it within a tolerance, by fitting its samples. Removal alone
 * (simplify) keeps the parameters and can only choose among the knots there are; its result is kept where the
 * fit has no fewer points.
 */
#include "curve/fit.h"
#include "curve/curve.h"

#include <batten/fit.h>
#include <batten/measure.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>

enum { SPARSE = 8, DENSE = 64, TRIES = 4, CHECKED = 12 };

typedef struct sampling {
    int dimension;
    size_t count, room;
    double *points;
    int *corners;
    size_t corner_count;
} sampling;

/* How many samples a span needs so that the polyline stays within a tenth of the tolerance, from its second
 * differences. */
static int samples_of(const bat_curve *curve, double a, double b, double tolerance) {
    const int m = curve->dimension;
    double jet[3 * BAT_DIMENSION_MAX], bend = 0;
    for (int i = 0; i < 3; i++) {
        double sum = 0;
        bat_curve_eval(curve, a + (b - a) * (0.05 + 0.45 * i), 2, jet);
        for (int c = 0; c < m; c++) sum += jet[2 * m + c] * jet[2 * m + c];
        bend = fmax(bend, sqrt(sum));
    }
    const double wanted = (b - a) * sqrt(bend / (0.8 * tolerance));
    return !(wanted > SPARSE) ? SPARSE : wanted > DENSE ? DENSE : (int)wanted;
}

static bool sample_span(sampling *s, const bat_curve *curve, double a, double b, int pieces) {
    const size_t m = (size_t)s->dimension;
    if (s->count + (size_t)pieces + 1 > s->room) {
        const size_t room = 2 * (s->count + (size_t)pieces) + 256;
        double *more = realloc(s->points, room * m * sizeof *more);
        if (!more) return false;
        s->points = more, s->room = room;
    }
    for (int i = 0; i < pieces; i++)
        bat_curve_eval(curve, a + (b - a) * i / pieces, 0, s->points + s->count++ * m);
    return true;
}

/* The samples of all spans; the first of each span that begins at a corner is one. */
static bat_status sample(const bat_curve *curve, double tolerance, double corner, sampling *s) {
    const int p = curve->degree;
    const double *t = curve->knots;
    *s = (sampling){.dimension = curve->dimension};
    s->corners = malloc((size_t)(curve->spread + 1) * sizeof *s->corners);
    if (!s->corners) return BAT_MEMORY;
    for (int i = p; i < curve->spread; i++) {
        if (!(t[i + 1] > t[i])) continue;
        const bool full = i >= p && t[i] == t[i - p + 1] && (curve->closed || i > p);
        if (full && bat_curve_corner_at(curve, i, corner)) s->corners[s->corner_count++] = (int)s->count;
        if (!sample_span(s, curve, t[i], t[i + 1], samples_of(curve, t[i], t[i + 1], tolerance)))
            return BAT_MEMORY;
    }
    if (!curve->closed) {
        if (!sample_span(s, curve, t[curve->spread], t[curve->spread], 1)) return BAT_MEMORY;
        bat_curve_eval_left(curve, t[curve->spread], 0, s->points + (s->count - 1) * (size_t)s->dimension);
    }
    return BAT_OK;
}

static bat_status fitted(const bat_curve *curve, const sampling *s, double tolerance, bat_curve **out,
                         double *error) {
    bat_fit_options options = bat_fit_defaults();
    options.degree = curve->degree, options.closed = curve->closed, options.hold_ends = true;
    options.corners = s->corners, options.corner_count = s->corner_count;
    double within = 0.97 * tolerance; /* between the samples it may be a little more */
    for (int i = 0; i < TRIES; i++, within *= 0.85) {
        bat_curve *fit = NULL;
        double there, back;
        options.tolerance = within;
        bat_status status = bat_fit_plain(curve->dimension, s->count, s->points, &options, &fit, NULL);
        if (status == BAT_OK) status = bat_curve_distance(curve, fit, CHECKED, &there, &back);
        if (status == BAT_OK && fmax(there, back) <= tolerance) {
            *out = fit, *error = fmax(there, back);
            return BAT_OK;
        }
        bat_curve_free(fit);
        if (status != BAT_OK) return status;
    }
    return BAT_TOLERANCE;
}

bat_status bat_curve_refit(const bat_curve *curve, double tolerance, double corner, bat_curve **out,
                           double *error) {
    if (!curve || !out || !(tolerance >= 0) || !isfinite(tolerance) || !(corner >= 0)) return BAT_ARGUMENT;
    if (tolerance == 0) return bat_curve_simplify(curve, 0, corner, out, error); /* nothing to fit */
    bat_curve *fewer = NULL, *again = NULL;
    double kept = 0, worst = 0;
    bat_status status = bat_curve_simplify(curve, tolerance, corner, &fewer, &kept);
    if (status != BAT_OK) return status;
    sampling s;
    status = sample(curve, tolerance, corner, &s);
    if (status == BAT_OK) status = fitted(curve, &s, tolerance, &again, &worst);
    free(s.points), free(s.corners);
    if (status == BAT_MEMORY) {
        bat_curve_free(fewer);
        return status;
    }
    const bool better = again && bat_curve_count(again) < bat_curve_count(fewer);
    *out = better ? again : fewer;
    if (error) *error = better ? worst : kept;
    bat_curve_free(better ? fewer : again);
    return BAT_OK;
}
