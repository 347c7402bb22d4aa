/* Batten: lengths, boxes, curvature. */
#ifndef BATTEN_MEASURE_H
#define BATTEN_MEASURE_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Arc length of u0..u1 (signed; closed curves may run over the seam), adaptive Gauss-Legendre a span.
 * relative: the asked relative error, 1e-15 to 1. */
BAT_API double bat_curve_length(const bat_curve *curve, double u0, double u1, double relative);
/* The parameter at arc length s from u0 (negative: backwards). Open curves clamp to the domain. */
BAT_API double bat_curve_at_length(const bat_curve *curve, double u0, double s, double relative);
/* Exact bounding box (extrema by root finding): low[dimension], high[dimension]. */
BAT_API void bat_curve_bounds(const bat_curve *curve, double *low, double *high);
/* Signed curvature in the plane, non-negative in space; 0 where the curve stops. */
BAT_API double bat_curve_curvature(const bat_curve *curve, double u);
/* Inflections of a planar curve: parameters ascending, at most `room` written; returns how many there are. */
BAT_API size_t bat_curve_inflections(const bat_curve *curve, size_t room, double *u);
/* Greatest distance from each curve to the other is bounded by sampling `per_span` points and refining. */
BAT_API bat_status bat_curve_distance(const bat_curve *a, const bat_curve *b, int per_span, double *a_to_b,
                                      double *b_to_a);

#ifdef __cplusplus
}
#endif
#endif
