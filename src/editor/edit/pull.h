/* Pulling a curve by points on it, as a user expects: ends and smooth nodes are preserved. */
#ifndef BATTEN_EDITOR_EDIT_PULL_H
#define BATTEN_EDITOR_EDIT_PULL_H

#include <batten/curve.h>

enum { BAT_PULLS_MAX = 2 };

/*
 * Moves C(u_k) by delta_k, k < count, as bat_curve_drag does, with the least sum of squares of the control points'
 * moves, under two conditions: an end of an open curve stays where it is unless u is that end, and at a smooth node
 * (smooth_node.h) the handles stay in line and in proportion. The points move by exactly their deltas. delta: of the curve's
 * dimension, one after the other.
 * BAT_SINGULAR: the points cannot move independently. Cost: O(n) for the copy.
 */
bat_status bat_pull(const bat_curve *curve, int count, const double *u, const double *delta, bat_curve **out);
/*
 * Moves a control point by delta. A smooth node takes its handles along; when one handle of a smooth node moves, the
 * other keeps its length and turns to stay in line. alone: nothing else moves.
 */
bat_status bat_pull_point(const bat_curve *curve, int index, const double *delta, bool alone,
                          bat_curve **out);
/* Moves each control point whose mark (one for each) is not 0 by delta, and nothing else. */
bat_status bat_pull_points(const bat_curve *curve, const unsigned char *marks, const double *delta,
                           bat_curve **out);
/* Moves each control point by its own length along an axis, and nothing else. */
bat_status bat_pull_along(const bat_curve *curve, int axis, const double *by, bat_curve **out);

#endif
