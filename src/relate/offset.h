/* Inside the room: the raw offset of a curve, as cubics one after another, before its loops are trimmed. */
#ifndef BATTEN_SRC_RELATE_OFFSET_H
#define BATTEN_SRC_RELATE_OFFSET_H

#include "relate/brim.h"

#include <batten/curve.h>
#include <batten/nearest.h>

typedef struct bat_chain {
    int count, room; /* cubics */
    double *points;  /* 3 * count + 1 points of 2 numbers */
} bat_chain;

/* The parallel of a planar curve at a distance, left positive, within tolerance as measured: corners that open are made as
 * the brim says, which records them (NULL: rounded), others are bridged by a straight line, as the trimming removes it. */
bat_status bat_offset_raw(const bat_curve *curve, double distance, double tolerance, double corner,
                          bat_brim *brim, bat_chain *out);
/* The same along an open curve, around its end, and back: closed. */
bat_status bat_offset_around(const bat_curve *curve, double distance, double tolerance, double corner,
                             bat_brim *brim, bat_chain *out);
bat_status bat_chain_add(bat_chain *chain, const double cubic[8]);

/* Sizes below this are brought to about 1 before anything is squared. */
#define BAT_OFFSET_LEAST 0x1p-300
/* What is to be made of a curve that was enlarged by a factor; error may be NULL. */
typedef bat_status bat_offset_work(const bat_curve *large, double factor, const void *about, size_t *count,
                                   bat_curve ***out, double *error);
/* Does the work on the curve brought to about 1 by a power of 2, and brings back what was made. size: of the curve and what is
 * made of it; *max_error (may be NULL): in the curve's own units. */
bat_status bat_offset_enlarged(const bat_curve *curve, double size, bat_offset_work *work, const void *about,
                               size_t *count, bat_curve ***out, double *max_error);

/* ---- trim.c ---- */
/* Shares of the tolerance that the raw parallel may take, and the removal of its knots. */
extern const double bat_offset_fit, bat_offset_removal;
/* Whether rounding decides: the tolerance is below 1e-12 of the greatest coordinate of what lies within `far` of the curve. */
bool bat_offset_is_rounding(const bat_curve *curve, double far, double tolerance);
/* What is left of a raw parallel of the curve, whose places the finder finds, or (brim) of its brim; *max_error (may be NULL) as
 * bat_curve_offset. */
bat_status bat_offset_trim(const bat_curve *raw, const bat_curve *curve, const bat_finder *finder,
                           double distance, double tolerance, double corner, const bat_brim *brim,
                           size_t *count, bat_curve ***out, double *max_error);

#endif
