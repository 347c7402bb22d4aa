/* Internal: curves through points at parameters that are given. */
#ifndef BATTEN_POINTS_INTERPOLATE_H
#define BATTEN_POINTS_INTERPOLATE_H

#include <batten/interpolate.h>

/* The natural C2 cubic through n points, two at least, at ascending parameters t, its knots. Neighbours may be the same. O(n). */
bat_status bat_interpolate_at(int dimension, size_t n, const double *points, const double *t,
                              bat_curve **out);

#endif
