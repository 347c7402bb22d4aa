/* Inside: the fourth mode of the tangents hand, round handles and directions. docs/math/tangents.md, math 1.6. */
#ifndef BATTEN_SRC_ROUND_H
#define BATTEN_SRC_ROUND_H

#include <batten/tangents.h>

/* keep: indices of the count points. Finds the directions that are not given, and fills the joints' derivatives, without
 * tension. */
bat_status bat_round(const bat_spline *spline, const int *keep, int count, bat_joint *joints);

#endif
