/* Inside the room: the raw offset of a curve, as cubics one after another, before its loops are trimmed. */
#ifndef BATTEN_SRC_RELATE_OFFSET_H
#define BATTEN_SRC_RELATE_OFFSET_H

#include <batten/curve.h>

typedef struct bat_chain {
    int count, room; /* cubics */
    double *points;  /* 3 * count + 1 points of 2 numbers */
} bat_chain;

/* The parallel of a planar curve at a distance, left positive, within tolerance as measured: corners that open are rounded,
 * others are bridged by a straight line, as the trimming removes it. */
bat_status bat_offset_raw(const bat_curve *curve, double distance, double tolerance, double corner,
                          bat_chain *out);
bat_status bat_chain_add(bat_chain *chain, const double cubic[8]);

#endif
