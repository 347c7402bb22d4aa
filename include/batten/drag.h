/* Batten: direct manipulation: points of the curve are moved, and the control points follow. */
#ifndef BATTEN_DRAG_H
#define BATTEN_DRAG_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { BAT_DRAG_MAX = 32 };

/*
 * Moves C(u_k) by delta_k (count * dimension doubles), k < count <= BAT_DRAG_MAX, with the least sum of squares of
 * the control points' displacements: dP = N^T (N N^T)^-1 delta; one point: dP_i = N_i(u) delta / sum N^2 (math 3.5).
 * A zero delta holds its point. Knots stay; control points whose basis functions vanish at every u stay bit for bit.
 * BAT_PARAMETER: a u outside an open domain; BAT_SINGULAR: the points cannot be moved independently (two have the
 * same parameter). Cost O(n + count^3).
 */
BAT_API bat_status bat_curve_drag(const bat_curve *curve, size_t count, const double *u, const double *delta,
                                  bat_curve **out);
/* Moves control point `index` by delta (dimension doubles). BAT_ARGUMENT: no such point; BAT_NUMBER. O(count). */
BAT_API bat_status bat_curve_move_point(const bat_curve *curve, int index, const double *delta,
                                        bat_curve **out);

#ifdef __cplusplus
}
#endif
#endif
