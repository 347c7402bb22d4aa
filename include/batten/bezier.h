/* Batten: exact conversion between B-splines and Bézier segments. */
#ifndef BATTEN_BEZIER_H
#define BATTEN_BEZIER_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Number of polynomial segments (non-empty spans of the domain). O(count). */
BAT_API int bat_curve_segment_count(const bat_curve *curve);
/* All segments: points has segment_count * (p + 1) * dimension doubles, breaks segment_count + 1; either may
 * be NULL. Exact to rounding. O(count). P&T A5.6. */
BAT_API bat_status bat_curve_to_bezier(const bat_curve *curve, double *points, double *breaks);
/* Cubic segments for drawing: exact up to degree 3 (lower degrees are raised), for higher degrees split until they
 * are within tolerance. tolerance: document units, above 0 where the degree is above 3. BAT_COUNT: there would be
 * more than BAT_POINTS_MAX of them. BAT_TOLERANCE with the best cubics after twelve halvings. Their number goes to
 * *segments and their points to *points, which the caller frees by bat_free: *segments * 4 * dimension doubles,
 * shared ends repeated. */
BAT_API bat_status bat_curve_to_cubics(const bat_curve *curve, double tolerance, int *segments,
                                       double **points);

/* Releases an array that the library handed over; NULL is fine. */
BAT_API void bat_free(void *memory);

/*
 * One B-spline from `segments` Bézier segments of one degree that follow each other (each starts where the one before
 * ends; points: segments * degree + 1 points, shared ends given once; closed: the last point equals the first). Knot
 * spacing is chosen so that joints that are G1 (tangents within `corner` radians) become C1; joints that are not are
 * corners: knots of multiplicity p. Closed paths become periodic. Zero-length segments are dropped. Then knots are
 * removed within `tolerance` (0: only exact removals), and corners are kept. *error (may be NULL) bounds the
 * deviation. A smooth closed path whose product of handle ratios all the way round is not one keeps multiplicity p at
 * one joint; so do joints with a handle of zero length, and joints where the speed would leave the range of 1e-5 to
 * 1e5 times that of the run. corner: radians; tolerance: document units. BAT_ARGUMENT when a closed path does not end
 * where it starts; BAT_COUNT: no segment of any length, or too many. Cost: that of bat_curve_simplify.
 */
BAT_API bat_status bat_curve_from_bezier(int dimension, int degree, bool closed, int segments,
                                         const double *points, double corner, double tolerance,
                                         bat_curve **out, double *error);

#ifdef __cplusplus
}
#endif
#endif
