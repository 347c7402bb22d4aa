/* Inside the room: outlines by what is left of parallels. */
#ifndef BATTEN_SRC_RELATE_OUTLINE_H
#define BATTEN_SRC_RELATE_OUTLINE_H

#include <batten/relate.h>

/* What every outline of a stroke asks of its arguments: BAT_ARGUMENT, BAT_DIMENSION, or BAT_TOLERANCE where rounding decides. */
bat_status bat_outline_check(const bat_curve *curve, const bat_nib *nib, double tolerance, double corner);
/* As bat_curve_outline, but BAT_SINGULAR where the pieces of the parallels do not fit together. */
bat_status bat_outline_parallels(const bat_curve *curve, const bat_nib *nib, double tolerance, double corner,
                                 size_t *count, bat_curve ***out, double *max_error);

#endif
