/* The order of numbers, for qsort. */
#ifndef BATTEN_BASE_ORDER_H
#define BATTEN_BASE_ORDER_H

/* Ascending; equal numbers cannot be told apart. */
static inline int bat_ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

#endif
