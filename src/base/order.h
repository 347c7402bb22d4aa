/* The order of numbers: for qsort, and what stands in the middle of it. */
#ifndef BATTEN_BASE_ORDER_H
#define BATTEN_BASE_ORDER_H

#include <stddef.h>

/* Ascending; equal numbers cannot be told apart. */
static inline int bat_ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The median of at most 101 of them, evenly chosen; 0 of none. */
double bat_middle(const double *numbers, size_t count);

#endif
