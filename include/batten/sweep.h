/*
 * Batten: surfaces made from curves. A curve turned about an axis, four curves that bound a patch, curves side by
 * side. Curves have 2 (z = 0) or 3 coordinates. Source: docs/math/surfaces.md; Piegl and Tiller, chapter 10.
 */
#ifndef BATTEN_SWEEP_H
#define BATTEN_SWEEP_H

#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Revolution: u in [0, 1] is the fraction of the angle (radians, by the right hand about the direction; at u = 0 the
 * profile), v the profile's parameter. A circle is a cubic spline with its knots on it, as many as the tolerance needs:
 * at every (u, v) the surface is within the tolerance of the exact revolution, and *max_error (may be NULL) is how far
 * it is at most. A full turn, 2 pi or -2 pi, is closed in u; a point on the axis stays a point. BAT_ARGUMENT: the
 * direction is zero, the angle 0 or beyond a full turn, or the tolerance not above 0; BAT_SINGULAR: the whole profile is
 * on the axis; BAT_COUNT: the tolerance needs more than BAT_POINTS_MAX points; BAT_NUMBER: a number is not finite or
 * too large. O(points of the result).
 */
BAT_API bat_status bat_surface_revolve(const bat_curve *profile, const double origin[3],
                                       const double direction[3], double angle, double tolerance,
                                       bat_surface **out, double *max_error);

/* The sides of a patch: along u at v = 0 and v = 1, along v at u = 0 and u = 1. */
typedef enum bat_side { BAT_SIDE_V0 = 0, BAT_SIDE_V1 = 1, BAT_SIDE_U0 = 2, BAT_SIDE_U1 = 3 } bat_side;

/*
 * The Coons patch of four open curves (indexed by bat_side), bilinearly blended, over [0, 1] squared, exact. Degrees are
 * raised to the greater of opposite sides and their knots merged. Corners that lie apart by at most `within` meet in
 * the middle, and both sides then deviate by half of that at most. apart (may be NULL): how far the corners are apart,
 * at (u, v) = (0, 0), (1, 0), (0, 1), (1, 1); filled in whenever the curves are valid. BAT_FAR: corners are further
 * apart; BAT_ARGUMENT: a curve is closed, or `within` is negative or not finite; BAT_SINGULAR: all points would be
 * equal; else as bat_curve_refine. O(points of the result).
 */
BAT_API bat_status bat_surface_coons(const bat_curve *const sides[4], double within, bat_surface **out,
                                     double apart[4]);

/*
 * The loft through at least two sections, all open or all closed: u runs along the sections, over the first one's
 * domain, to which the others are mapped; v in [0, 1] across. Sections are brought onto one degree and one knot vector,
 * so that each is the line at its v exactly (up to rounding); v (may be NULL): room for count numbers, the parameters of
 * the sections, by mean length of chord. Across, the surface is a spline of degree 3 with its knots at the
 * sections, without one at the second and the last but one; of degree 2 with three sections; ruled with two. BAT_COUNT:
 * fewer than two sections, or the knots of all have 4 times as many points as the largest section has; BAT_ARGUMENT: some
 * sections are closed and others open; BAT_SINGULAR: two neighbouring sections are the same; else as bat_curve_refine.
 * O(points of the result).
 */
BAT_API bat_status bat_surface_loft(size_t count, const bat_curve *const *sections, bat_surface **out,
                                    double *v);

#ifdef __cplusplus
}
#endif
#endif
