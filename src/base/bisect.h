/* Bisection: finds where a number lies in an ascending array. */
#ifndef BATTEN_BASE_BISECT_H
#define BATTEN_BASE_BISECT_H

#include <stddef.h>

/* i in 0..count - 2 with ascending[i] <= at < ascending[i + 1]; the first or last such interval when `at` lies
 * outside. count: at least 2. */
static inline size_t bat_bisect(const double *ascending, size_t count, double at) {
    size_t low = 0, high = count - 1;
    while (high - low > 1) {
        const size_t middle = low + (high - low) / 2;
        if (ascending[middle] <= at)
            low = middle;
        else
            high = middle;
    }
    return low;
}

#endif
