/* Rational B-splines, as files of CAD programs hold them, made into cubic B-splines that are near them. */
#ifndef BATTEN_FORMAT_RATIONAL_H
#define BATTEN_FORMAT_RATIONAL_H

#include <batten/surface.h>

/* Whether all weights are the same to 1e-9 of the first: then they say nothing. */
bool bat_weights_are_equal(size_t count, const double *weights);
/* over: the points, 3 numbers each, times the weights; under: the weights, `size` numbers each, of which all but the first are
 * 0; both in shares of the first weight. BAT_NUMBER: a weight that is not between 1e-6 and 1e6 times the first, or the first is
 * not above 0. */
bat_status bat_weigh(size_t count, const double *points, const double *weights, double *over, size_t size,
                     double *under);
/* The cubic with the values and the first derivatives of the rational curve at its knots and wherever else it has to be
 * halved to stay within tolerance (> 0), measured at seven places of each piece. points: count times x y z, not multiplied by
 * the weights; knots: count + degree + 1; range: of the parameters, of which the curve is made (NULL: all). Planar where all
 * points lie in z = 0; closed where the ends meet. BAT_NUMBER: a weight that is not between 1e-6 and 1e6 times the first;
 * BAT_PARAMETER: the range is empty; else as bat_curve_create. O(count + pieces). */
bat_status bat_rational_curve(int degree, size_t count, const double *points, const double *weights,
                              const double *knots, const double range[2], double tolerance, bat_curve **out);
/* The same for a surface, with the parameters it has, measured at 49 places of each patch; points and weights: count[0] rows
 * of count[1]. Closed in a direction whose ends meet smoothly. BAT_COUNT also: more than 16,384 patches, and four times as
 * many as the file has, would not be near enough. O(points + patches). */
bat_status bat_rational_surface(const int degree[2], const size_t count[2], const double *points,
                                const double *weights, const double *const knots[2], double tolerance,
                                bat_surface **out);

/* As a file has it: exactly, where there are no weights (NULL) or equal ones; else within a millionth of its size. points
 * may be changed. range as above; for the surface that it is the whole is left to the caller. */
bat_status bat_weighted_curve(int degree, size_t count, double *points, const double *weights,
                              const double *knots, const double range[2], bat_curve **out);
bat_status bat_weighted_surface(const int degree[2], const size_t count[2], double *points,
                                const double *weights, const double *const knots[2], bat_surface **out);
/* What is wrong with weights that gave BAT_NUMBER. */
#define BAT_WEIGHTS_EXPECTED "expected weights above 0, none a million times another, found others"

#endif
