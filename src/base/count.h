/* Counts of points are size_t in the interface and int inside. A count above BAT_POINTS_MAX stays above it
 * when converted. */
#ifndef BATTEN_SRC_COUNT_H
#define BATTEN_SRC_COUNT_H

#include <batten/base.h>

static inline int bat_count_inside(size_t count) {
    return count > BAT_POINTS_MAX ? BAT_POINTS_MAX + 1 : (int)count;
}

#endif
