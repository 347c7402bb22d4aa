/* Inside the kernel: one knot less, and how far the curve moves for it. */
#ifndef BATTEN_SRC_REMOVE_H
#define BATTEN_SRC_REMOVE_H

#include "curve/curve.h"

typedef struct bat_removal {
    int r, s;     /* last copy of the knot among the user's knots, and its multiplicity, 1..p */
    double bound; /* no point of the curve moves farther */
    double q[BAT_DEGREE_MAX * BAT_DIMENSION_MAX]; /* the points Q_{r-p}..Q_{r-s-1} */
} bat_removal;

/* Works out the removal of one copy; the seam's copies must all be at the start of a closed curve's period.
 */
void bat_removal_plan(const bat_curve *curve, int r, int s, bat_removal *out);
/* Is a closed curve long enough for it? Its window must not meet itself. Open curves: true. */
bool bat_removal_fits(const bat_curve *curve, int s);
/* Carries out removals whose windows r-p-1..r+p+1 do not meet. On a closed curve the seam may only be
 * reduced, not removed. */
bat_status bat_removal_apply(const bat_curve *curve, int count, const bat_removal *removals, bat_curve **out);

#endif
