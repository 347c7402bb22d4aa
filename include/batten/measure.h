/* Batten: lengths, boxes, curvature. */
#ifndef BATTEN_MEASURE_H
#define BATTEN_MEASURE_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Arc length of u0..u1 (signed; closed curves may run over the seam), adaptive Gauss-Legendre quadrature on each
 * span. relative: the relative error asked for, 1e-15 to 1. A NaN gives NaN. Cost: O(spans between), more where
 * the speed changes fast. */
BAT_API double bat_curve_length(const bat_curve *curve, double u0, double u1, double relative);
/* The parameter at arc length s from u0 (negative: backwards). Open curves clamp to the domain. Cost: that of a
 * length, and of a few more within one span. */
BAT_API double bat_curve_at_length(const bat_curve *curve, double u0, double s, double relative);
/* Exact bounding box (extrema by root finding): low[dimension], high[dimension].
 * O(count * p^2). */
BAT_API void bat_curve_bounds(const bat_curve *curve, double *low, double *high);
/* The area that a closed planar curve runs round, above 0 anticlockwise where y points up; parts that it runs round twice
 * count twice. Exact but for rounding (Gauss). 0 for an open curve, one in space or NULL. O(count). */
BAT_API double bat_curve_area(const bat_curve *curve);
/* Signed curvature in the plane, non-negative in space; 0 where the first derivative vanishes. */
BAT_API double bat_curve_curvature(const bat_curve *curve, double u);
/* Inflections of a planar curve: parameters ascending, at most `room` written; returns how many there are, 0 in space.
 * u may be NULL when room is 0. O(count * p^3). */
BAT_API size_t bat_curve_inflections(const bat_curve *curve, size_t room, double *u);
/* Extremes of a planar curve along an axis: where it turns back in x (0) or in y (1), also at corners, not at the ends of an
 * open one. Parameters ascending, as above; 0 in space. O(count * p^2). */
BAT_API size_t bat_curve_extremes(const bat_curve *curve, int axis, size_t room, double *u);
/* The greatest distance from each curve to the other, document units: the greatest over `per_span` points per span
 * (1 to 2^20), refined around that point. It is a lower bound of the true distance. BAT_DIMENSION: the dimensions
 * differ; BAT_ARGUMENT: per_span is out of range. Cost: one closest-point search per point. */
BAT_API bat_status bat_curve_distance(const bat_curve *a, const bat_curve *b, int per_span, double *a_to_b,
                                      double *b_to_a);

#ifdef __cplusplus
}
#endif
#endif
