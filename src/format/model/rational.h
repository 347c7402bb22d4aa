/* Rational B-splines, as files of CAD programs hold them, made into cubic B-splines that are near them. */
#ifndef BATTEN_FORMAT_RATIONAL_H
#define BATTEN_FORMAT_RATIONAL_H

#include <batten/curve.h>

/* Whether all weights are the same to 1e-9 of the first: then they say nothing. */
bool bat_weights_are_equal(size_t count, const double *weights);
/* The cubic with the values and the first derivatives of the rational curve at its knots and wherever else it has to be
 * halved to stay within tolerance (> 0), measured at seven places of each piece. points: count times x y z, not multiplied by
 * the weights; knots: count + degree + 1. Planar where all points lie in z = 0; closed where the ends meet. BAT_NUMBER: a
 * weight that is not between 1e-6 and 1e6 times the first; else as bat_curve_create. O(count + pieces). */
bat_status bat_rational_curve(int degree, size_t count, const double *points, const double *weights,
                              const double *knots, double tolerance, bat_curve **out);

#endif
