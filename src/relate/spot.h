/* Inside the room: the outline of a stroke far wider than its curve is large. */
#ifndef BATTEN_SRC_RELATE_SPOT_H
#define BATTEN_SRC_RELATE_SPOT_H

#include <batten/relate.h>

/* Whether the curve is tiny beside the stroke's width. */
bool bat_is_spot(const bat_curve *curve, const bat_nib *nib);
/* The outline of such a stroke, as bat_curve_outline gives it; *error: a bound. BAT_SINGULAR: it has to be made in another way. BAT_COUNT: too many places. O(n log n) in the places, which are as many as pieces of sqrt(width * tolerance) along
 * the curve. */
bat_status bat_spot_outline(const bat_curve *curve, const bat_nib *nib, double tolerance, double corner,
                            size_t *count, bat_curve ***out, double *error);

#endif
