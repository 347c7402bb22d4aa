/* Pulling a curve at points of it, as a hand means it: ends and smooth nodes stay what they are. */
#ifndef BATTEN_EDITOR_EDIT_PULL_H
#define BATTEN_EDITOR_EDIT_PULL_H

#include <batten/curve.h>

enum { BAT_PULLS_MAX = 2 };

/*
 * Moves C(u_k) by delta_k, k < count, as bat_curve_drag does, by the least sum of squares of the control points'
 * moves, under two conditions: an end of an open curve stays where it is unless u is that end, and of a smooth node
 * (smooth_node.h) the handles stay in line and in proportion. The points move by exactly their deltas. Planar curves.
 * BAT_SINGULAR: the points can not move apart. Cost: O(n) for the copy.
 */
bat_status bat_pull(const bat_curve *curve, int count, const double *u, const double *delta, bat_curve **out);
/*
 * Moves a control point by delta. A smooth node takes its handles along; of two handles of one the other turns with
 * it, as long as it was, and lies in line then. alone: nothing else moves.
 */
bat_status bat_pull_point(const bat_curve *curve, int index, const double delta[2], bool alone,
                          bat_curve **out);

#endif
