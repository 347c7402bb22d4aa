/* Pulling a curve at points of it, as a hand means it: joints that look smooth stay so. */
#ifndef BATTEN_EDITOR_EDIT_PULL_H
#define BATTEN_EDITOR_EDIT_PULL_H

#include <batten/curve.h>

/*
 * As bat_curve_drag, but what is added to the curve is C1 at knots of multiplicity p where the curve turns by less
 * than 3.4 degrees: such joints come with imported outlines, smooth to the eye and corners by their rounding. The
 * points move by exactly their deltas.
 */
bat_status bat_pull(const bat_curve *curve, int count, const double *u, const double *delta, bat_curve **out);

#endif
