/* Batten: lengths, boxes, curvature. */
#ifndef BATTEN_MEASURE_H
#define BATTEN_MEASURE_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Arc length of u0..u1 (signed; closed curves may run over the seam), adaptive Gauss-Legendre a span.
 * relative: the asked relative error, 1e-15 to 1. A NaN gives NaN. Cost: O(spans between), more where the
 * speed changes fast. */
BAT_API double bat_curve_length(const bat_curve *curve, double u0, double u1, double relative);
/* The parameter at arc length s from u0 (negative: backwards). Open curves clamp to the domain.
 * Cost: that of a length, and of some more in one span. */
BAT_API double bat_curve_at_length(const bat_curve *curve, double u0, double s, double relative);
/* Exact bounding box (extrema by root finding): low[dimension], high[dimension].
 * O(count * p^2). */
BAT_API void bat_curve_bounds(const bat_curve *curve, double *low, double *high);
/* Signed curvature in the plane, non-negative in space; 0 where the curve stops. */
BAT_API double bat_curve_curvature(const bat_curve *curve, double u);
/* Inflections of a planar curve: parameters ascending, at most `room` written; returns how many there are, 0 in space.
 * u may be NULL when room is 0. O(count * p^3). */
BAT_API size_t bat_curve_inflections(const bat_curve *curve, size_t room, double *u);
/* The greatest distance from each curve to the other, document units: the greatest of `per_span` points a span (1 to
 * 2^20), refined about it. A bound from below. BAT_DIMENSION: they differ in it; BAT_ARGUMENT: per_span. Cost: a closest
 * point for each. */
BAT_API bat_status bat_curve_distance(const bat_curve *a, const bat_curve *b, int per_span, double *a_to_b,
                                      double *b_to_a);

#ifdef __cplusplus
}
#endif
#endif
