/* Inside the room: the outline of a stroke far wider than its curve is large. */
#ifndef BATTEN_SRC_RELATE_DISKS_H
#define BATTEN_SRC_RELATE_DISKS_H

#include <batten/relate.h>

/* Whether the outline is that of disks: a curve with size, tiny beside the stroke's width, whose ends and corners are round. */
bool bat_is_spot(const bat_curve *curve, const bat_nib *nib, double corner);
/* The outline of such a curve, one closed curve; *error: a bound. BAT_COUNT: more disks than there may be. O(n log n) in the
 * disks, which are as many as pieces of sqrt(width * tolerance) along the curve. */
bat_status bat_spot_outline(const bat_curve *curve, double half, double tolerance, double corner,
                            bat_curve **out, double *error);

#endif
