/*
 * Batten: surfaces made from curves. A profile swept along a path, a curve turned about an axis, four curves that bound
 * a patch, curves side by side. Curves have 2 (z = 0) or 3 coordinates. Source: docs/math/surfaces.md; Piegl and Tiller, chapter 10.
 */
#ifndef BATTEN_SWEEP_H
#define BATTEN_SWEEP_H

#include <batten/blend.h>
#include <batten/frames.h>
#include <batten/function.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How a profile goes along a path. options may be NULL: the defaults. */
typedef struct bat_sweep_options {
    size_t size; /* of this struct, as base.h says */
    bat_frame_rule frame;
    bool has_first; /* first: the frame's s at the start, projected on the normal plane there */
    double first[3];
    bat_function twist; /* radians, about the tangent */
    bat_function scale;
} bat_sweep_options;

/* The defaults: rotation-minimising frames, no twist, scale 1. */
BAT_API void bat_sweep_options_init(bat_sweep_options *options, size_t size);
static inline bat_sweep_options bat_sweep_defaults(void) {
    bat_sweep_options options;
    bat_sweep_options_init(&options, sizeof options);
    return options;
}

/*
 * A sweep, ready for evaluation: S(u, v) = C(u) + g(u) (x(v) s(u) + y(v) r(u)), with C the path, (x, y) the profile
 * (of 2 coordinates), g the scale and s, r the frame turned by the twist. Rotation-minimising frames are converged to
 * 1e-8 radians; round a closed path what is left of a turn is spread along it. At a corner between straight stretches of the
 * path both sides are cut by the plane that halves it; frames that are fixed go round every corner. Copies what it needs.
 * BAT_DIMENSION: the profile does not have 2 coordinates; BAT_UNSUPPORTED: the path has another corner, turns back in one, or
 * has one and the frames are Frenet's; BAT_SINGULAR: the path has no length;
 * BAT_NUMBER: first, twist or scale are not finite; BAT_PARAMETER: as bat_function_check. Source: multilevel-2016,
 * section 5; docs/math/surfaces.md.
 */
typedef struct bat_sweep bat_sweep;
BAT_API bat_status bat_sweep_create(const bat_curve *path, const bat_curve *profile,
                                    const bat_sweep_options *options, bat_sweep **out);
BAT_API void bat_sweep_free(bat_sweep *sweep); /* NULL is fine */
/* The domains of u and v: those of the path and the profile. */
BAT_API void bat_sweep_domain(const bat_sweep *sweep, bat_direction direction, double domain[2]);
/* The angle in radians by which the path's frames fail to close, which is spread over it; 0 on open paths. */
BAT_API double bat_sweep_holonomy(const bat_sweep *sweep);

typedef struct bat_sweep_point {
    double point[3];
    double normal[3]; /* S_u x S_v of length 1; zeros where that vanishes */
    double factor;    /* S_u . t / |C'|: below 0 the surface is folded over */
} bat_sweep_point;
/* Parameters are treated as in bat_curve_eval. No allocation. */
BAT_API void bat_sweep_at(const bat_sweep *sweep, double u, double v, bat_sweep_point *out);
/* The intervals of u in which the factor is below 0 somewhere, ascending. At most `room` are written, 2 numbers each;
 * *count says how many there are; out may be NULL when room is 0. O(spans). */
BAT_API bat_status bat_sweep_folds(const bat_sweep *sweep, size_t room, double *out, size_t *count);

typedef struct bat_sweep_report {
    double max_error; /* greatest distance from the sweep, measured at many places */
    bool seam;        /* the path is closed, and the surface is open along u */
} bat_sweep_report;
/*
 * The sweep as a surface, within the tolerance of it at every (u, v). Along v it has the profile's knots; along u degree 3
 * at least, the path's knots and as many more as are needed. A closed path gives a surface closed in u, unless the twist
 * does not end a whole number of turns from where it began, or the scale as it began: then a seam is left. BAT_ARGUMENT:
 * the tolerance is not above 0; BAT_TOLERANCE: it cannot be met with BAT_POINTS_MAX points, and nothing is handed
 * over; BAT_NUMBER: points lie too far out. report may be NULL.
 */
BAT_API bat_status bat_sweep_surface(const bat_sweep *sweep, double tolerance, bat_surface **out,
                                     bat_sweep_report *report);

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
 * fewer than two sections, or the knots of all have over 4 times as many points as the largest section has; BAT_ARGUMENT: some
 * sections are closed and others open; BAT_SINGULAR: two neighbouring sections are the same; else as bat_curve_refine.
 * O(points of the result).
 */
BAT_API bat_status bat_surface_loft(size_t count, const bat_curve *const *sections, bat_surface **out,
                                    double *v);

/*
 * The surface between two edges, both open or both closed: u in [0, 1] along them, the second turned round where its ends are nearer so; v in
 * [0, 1] from the first to the second, a Bézier segment whose degree is the sum of both continuities and 1. It meets each edge with
 * the continuity of the options (G0 to G3) along all of it, exactly but for rounding: across the edge its derivatives are the
 * surface's own, times one factor, with which it leaves the edge in the mean as fast as the straight way across, times the tension.
 * options may be NULL: G2 and 1. BAT_ARGUMENT: one edge is closed and the other open, a surface is closed across its edge, or an
 * option is out of its range; BAT_SINGULAR: the edges are one, or a surface stands still at its; else as bat_curve_refine. O(points of the
 * result). Source: docs/math/blend.md 4.
 */
BAT_API bat_status bat_surface_blend(const bat_surface *a, bat_side a_side, const bat_surface *b,
                                     bat_side b_side, const bat_blend_options *options, bat_surface **out);
/* The same to a curve, planar ones in z = 0, which it meets with G0. */
BAT_API bat_status bat_surface_blend_curve(const bat_surface *a, bat_side a_side, const bat_curve *curve,
                                           const bat_blend_options *options, bat_surface **out);

/*
 * Surface a with an edge moved onto an edge of b, which it then meets with a continuity of 0 to 3 along all of it; b stays. The edge becomes b's, run through
 * backwards where its ends are nearer so; every line across goes on with b's derivatives, times one factor, with which it leaves the
 * edge in the mean as fast as before, times `tension` (1e-3 to 1e3). Only continuity + 1 rows of control points beside the edge change, after a
 * has got the degrees and the knots, which do not change it; domains stay. *moved (may be NULL): how far control points moved at most, document units.
 * BAT_ARGUMENT: one edge is closed and the other open, a surface is closed across its edge, or a number is out of its range;
 * BAT_SINGULAR: an edge is a point, or a surface stands still at its; else as bat_curve_refine. O(points of the result). Source: docs/math/blend.md 5.
 */
BAT_API bat_status bat_surface_match(const bat_surface *a, bat_side a_side, const bat_surface *b,
                                     bat_side b_side, int continuity, double tension, bat_surface **out,
                                     double *moved);

#ifdef __cplusplus
}
#endif
#endif
