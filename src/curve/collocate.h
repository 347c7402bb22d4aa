/* Inside the library: spline interpolation at given parameters. */
#ifndef BATTEN_SRC_COLLOCATE_H
#define BATTEN_SRC_COLLOCATE_H

#include "curve/curve.h"

/* The control points of the spline on an open space (only its degree, count and knots are read) that takes `columns`
 * values at each of its count parameters u, ascending: values[count * columns] becomes the control points. The i-th
 * basis function must not vanish at u[i]: the system is then totally positive and needs no pivots (de Boor, A Practical
 * Guide to Splines, XIII). BAT_MEMORY. Cost O(count * degree * columns). */
bat_status bat_collocate(const bat_curve *space, const double *u, int columns, double *values);

#endif
