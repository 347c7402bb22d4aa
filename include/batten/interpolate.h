/* Batten: curves through points. */
#ifndef BATTEN_INTERPOLATE_H
#define BATTEN_INTERPOLATE_H

#include <batten/fit.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The C2 cubic through count points in order, document units; parameters are centripetal (Lee 1989), and the points' are
 * its knots. Points that repeat the one before are left out. ends: NULL, a natural spline (no curvature at the ends); else
 * 2 * dimension numbers, the directions in which the curve begins and ends, taken at the length of the mean speed there.
 * closed: back to the first point, with no seam; ends is not looked at. Two points, not closed, give a line. BAT_COUNT: fewer
 * than two different points (closed: three), or too many; BAT_NUMBER: a number that is not finite or too large. O(count).
 * De Boor, A Practical Guide to Splines, IV; docs/math/sketch.md 5.7.
 */
BAT_API bat_status bat_interpolate(int dimension, bool closed, size_t count, const double *points,
                                   const double *ends, bat_curve **out);

/*
 * As bat_fit, for points that have to be met whatever they are: where bat_fit does not reach the tolerance, or only by a
 * curve over four times as long as the row of points or by one that leaves the row between them, the result is the curve of
 * bat_interpolate, from corner to corner where there are some, with as few knots as keep it within tolerance. That holds for
 * cubics; others end as bat_fit does. options may be NULL.
 */
BAT_API bat_status bat_fit_within(int dimension, size_t count, const double *points,
                                  const bat_fit_options *options, bat_curve **out, bat_fit_report *report);

#ifdef __cplusplus
}
#endif
#endif
