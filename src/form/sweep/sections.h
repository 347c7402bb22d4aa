/* Internal: curves brought onto one degree, one domain and one knot vector, so that they can be lines of one surface. */
#ifndef BATTEN_FORM_SECTIONS_H
#define BATTEN_FORM_SECTIONS_H

#include "curve/curve.h"

/* out: count new curves in space of the same shapes (bat_sections_free); open ones are clamped. Knots closer than 1e-10 of
 * the domain become one. *most (may be NULL): the points of the largest curve before knots were merged. On failure
 * nothing is left in out. */
bat_status bat_sections_match(int count, const bat_curve *const *curves, const double domain[2],
                              bat_curve **out, int *most);
/* The mean distance of two lines in space at so many even shares of their domains, the second run through backwards or not. */
double bat_sections_apart(const bat_curve *a, const bat_curve *b, int shares, bool turned);
void bat_sections_free(int count, bat_curve **curves);

#endif
