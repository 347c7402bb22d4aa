/*
 * Batten: the tangents hand. Points, and a direction at each: an interpolating G1 spline of cubic segments.
 * Source: tangents-1994 Eqs. 4, 5, 7, as docs/math/tangents.md (math 1) corrects and completes them.
 */
#ifndef BATTEN_TANGENTS_H
#define BATTEN_TANGENTS_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum bat_tangents_mode {
    BAT_TANGENTS_FAITHFUL, /* the paper's formula; any direction is honoured exactly */
    BAT_TANGENTS_PAPER, /* directions are clamped to the wedge that the formula reaches, k to [0.02, 0.98] */
    BAT_TANGENTS_EVEN, /* even curvature: directions and tension stay unused; curvature is continuous but for its sign,
                        * and is greatest at the points. Source: kappa-Curves, Yan et al. 2017; math 1.5 */
    BAT_TANGENTS_ROUND /* any direction is honoured exactly, and handles are as round as their two directions allow;
                        * where no direction is given, curvature is continuous, and nothing beyond the next given
                        * direction matters. Source: Hobby 1986; math 1.6 */
} bat_tangents_mode;

/* What stands in for a direction that the user did not give, in FAITHFUL and PAPER. */
typedef enum bat_tangents_default {
    BAT_TANGENTS_CENTRIPETAL, /* k = sqrt(d0) / (sqrt(d0) + sqrt(d1)): the bisector of the chords */
    BAT_TANGENTS_UNIFORM,     /* k = 1/2: Catmull-Rom */
    BAT_TANGENTS_CHORDAL      /* k = d0 / (d0 + d1) */
} bat_tangents_default;

typedef struct bat_tangents_options {
    size_t size; /* of this struct, as base.h says */
    bat_tangents_mode mode;
    bat_tangents_default missing;
} bat_tangents_options;

/* What the user specifies of a G1 spline; the arrays are borrowed. */
typedef struct bat_spline {
    int dimension;
    bool closed;
    size_t count;
    const double *points;   /* count * dimension */
    const double *tangents; /* count * dimension, any length; a zero vector: none given. NULL: none at all */
    const double *tension; /* count * 2: factors on the incoming and the outgoing handle, >= 0. NULL: all 1 */
} bat_spline;

/* What became of one point. */
typedef struct bat_joint {
    double k;       /* shape parameter; NaN where the formula does not apply (open ends, outside the wedge) */
    double left[3]; /* D_L, D_R: derivatives of the segments before and after, each over [0, 1]; the Bézier */
    double right[3]; /* handles are a third of them. Zero on the missing side of an open end */
    double
        angle_in; /* radians between the tangent and the incoming chord, and the outgoing one; NaN at ends */
    double angle_out;
    bool inside;  /* the direction lies in the wedge */
    bool dropped; /* the point repeats the one before it and was left out */
} bat_joint;

/* The defaults: round, centripetal. */
BAT_API void bat_tangents_options_init(bat_tangents_options *options, size_t size);
static inline bat_tangents_options bat_tangents_defaults(void) {
    bat_tangents_options options;
    bat_tangents_options_init(&options, sizeof options);
    return options;
}

/* k of a direction at a joint between chords c0 (incoming) and c1 (outgoing); math 1.2. NaN outside the wedge
 * or when the chords are parallel. Cost O(1), no trigonometry. */
BAT_API double bat_tangents_k(int dimension, const double *c0, const double *c1, const double *direction);

/*
 * options may be NULL: the defaults, here and below. Builds the spline. joints: count of them, or NULL. *bezier:
 * *segments * 4 * dimension doubles, which the caller frees by bat_free; or bezier and segments are both NULL. *out
 * (out may be NULL): the same as one B-spline (math 1.3), cubic, with knots of multiplicity 4 at the ends, 2 inside,
 * and 3 where C1 is out of reach (width ratio above 1e5, or the seam of a loop whose widths do not close). BAT_COUNT:
 * fewer than two distinct points. Cost O(count).
 * EVEN: each piece between two joints is a quadratic that passes through one of the points (of open curves through one
 * of the inner points; two points are a line), so *segments is count - 2, or count when closed, k is NaN, and *out is
 * quadratic, with single knots inside, double where C1 is out of reach. Cost O(count) a step, some 40 steps, at most
 * 1,000; the points are met to rounding however many are taken. Two points, closed, are the oval of FAITHFUL.
 * ROUND: cost O(count) a step, some ten steps, at most 40. Where the points are too wild for continuous curvature,
 * Hobby's mock curvature is continuous; directions and points are met all the same.
 */
BAT_API bat_status bat_tangents(const bat_spline *spline, const bat_tangents_options *options,
                                bat_joint *joints, int *segments, double **bezier, bat_curve **out);

/*
 * Puts a point on the curve: on cubic segment `segment` (as bat_tangents numbers them) at t, 0 < t < 1. The points
 * beside it are given the directions that the curve has there and tensions that keep the shape; in ROUND and FAITHFUL
 * it is kept to rounding; in EVEN mode a point more is a place more of greatest curvature, and the curve moves. *out: the
 * new spline, all its arrays in *block (bat_free); *index: the new point. *deviation (may be NULL): a bound on how far
 * the curve has moved; EVEN: how far, to 1e-6 of its size. BAT_ARGUMENT: no such segment or t.
 */
BAT_API bat_status bat_tangents_insert(const bat_spline *spline, int segment, double t,
                                       const bat_tangents_options *options, bat_spline *out, void **block,
                                       int *index, double *deviation);

#ifdef __cplusplus
}
#endif
#endif
