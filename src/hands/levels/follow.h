/* What lies beside a curve goes along when that is bent. */
#ifndef BATTEN_HANDS_LEVELS_FOLLOW_H
#define BATTEN_HANDS_LEVELS_FOLLOW_H

#include <batten/curve.h>

/*
 * The planar curve with its control points moved as the bent one beside them has: each by the mean of the rigid moves (shift and turn of the
 * tangent) of all its places, weighted by length over the fourth power of the distance, so that what is near decides (math
 * 3.12). before and after: the bent curve, with the same domain. A curve that is only moved and turned takes the other along exactly.
 * BAT_DIMENSION: one is in space. O(count of both).
 */
bat_status bat_curve_follow(const bat_curve *curve, const bat_curve *before, const bat_curve *after,
                            bat_curve **out);
/* Whether the curve's first point lies inside the closed planar outline (odd number of times around). */
bool bat_curve_is_inside(const bat_curve *curve, const bat_curve *outline);

#endif
