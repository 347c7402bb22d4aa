/* Batten: curves between the ends of others, and ends moved to meet others, with continuity of position to third order. */
#ifndef BATTEN_BLEND_H
#define BATTEN_BLEND_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { BAT_CONTINUITY_MAX = 3 };

/*
 * Geometric continuity k, 0 to 3, of two curves that meet: G0 their ends are one point, G1 they have one tangent there,
 * G2 one curvature vector, G3 one rate of change of it along the length. Parameters do not matter.
 *
 * An end of an open curve is named by a truth: false its start, true its end. The blend leaves a at the end given,
 * and arrives at b: its start is on a.
 */
typedef struct bat_blend_options {
    size_t size;
    int continuity[2]; /* with a, with b: 0 to 3; 2 by default */
    double tension
        [2]; /* factors on the speed with which it leaves a and arrives at b; 1e-3 to 1e3; 1 by default */
} bat_blend_options;

/* G2, as its ends are best by themselves. */
BAT_API void bat_blend_options_init(bat_blend_options *options, size_t size);
static inline bat_blend_options bat_blend_defaults(void) {
    bat_blend_options options;
    bat_blend_options_init(&options, sizeof options);
    return options;
}

/*
 * The blend between two ends, a Bézier segment over [0, 1] whose degree is the sum of both continuities and 1. What they
 * leave free (a speed at each end, and its first and second derivative with G2 and G3) makes the variation of curvature
 * least: the integral of the squared derivative of curvature along the length, times the cubed length, found by
 * damped least squares from several starts (docs/math/blend.md 2). Speeds are then multiplied by the tensions, and the rest is
 * found anew. Jumps at the joints are rounding only: below 1e-9 of the size of tangent, curvature and its rate where
 * coordinates are not far from the origin for the blend's size. a and b may be one curve. *variation
 * (may be NULL): of the result, without a unit; 0 for lines and circles, infinite with a cusp. options may be NULL.
 * BAT_ARGUMENT: a closed curve, or an option out of its range; BAT_DIMENSION: the dimensions differ; BAT_SINGULAR: the ends are
 * one point, or one has no tangent, or no curvature where it is needed. Cost: 1 ms (G1) to 10 ms (G3).
 */
BAT_API bat_status bat_curve_blend(const bat_curve *a, bool a_end, const bat_curve *b, bool b_end,
                                   const bat_blend_options *options, bat_curve **out, double *variation);

/*
 * Curve a with an end moved to meet an end of b with a continuity of 0 to 3; b stays. Only continuity + 1 control
 * points at that end of a change: the end moves, its direction and curvature are b's, its speed, times `tension`
 * (1e-3 to 1e3), and the derivatives of speed stay. Before that a gets the degree and the knots, which do not change it, so that
 * its other end keeps its continuity of the same order (docs/math/blend.md 3). *moved (may be NULL): how
 * far the control points moved at most, document units. The same curve with nothing to change gives the same up to rounding.
 * BAT_ARGUMENT: a closed curve, or a number out of its range; BAT_DIMENSION, BAT_SINGULAR: as above. O(count).
 */
BAT_API bat_status bat_curve_match(const bat_curve *a, bool a_end, const bat_curve *b, bool b_end,
                                   int continuity, double tension, bat_curve **out, double *moved);

/* How far an end of a and one of b are from each continuity, as if a went on along b: jump[0] the distance, document units; [1] the angle between
 * their directions, radians; [2] the length of the difference of their curvature vectors, 1 / unit; [3] that of the
 * normal parts of their rates, 1 / unit^2. Infinite from 1 where an end has no tangent. BAT_ARGUMENT, BAT_DIMENSION: as above. */
BAT_API bat_status bat_curve_jump(const bat_curve *a, bool a_end, const bat_curve *b, bool b_end,
                                  double jump[4]);

#ifdef __cplusplus
}
#endif
#endif
