/*
 * Counted work: how a call grows with what it is given, without a clock. The library is compiled once more so that it
 * counts every basic block it enters (-fsanitize-coverage=trace-pc); libc's loops over memory and text are counted by
 * the eight bytes. The same on every machine.
 */
#ifndef BATTEN_TESTS_GROWTH_H
#define BATTEN_TESTS_GROWTH_H

#include <stdbool.h>
#include <stdint.h>

enum { GROWTH_SIZES = 3 }; /* each four times the one before */

extern uint64_t growth_work;

/* How the work of three sizes grows: x of n^x, by the differences, so that what costs the same every time is left out. */
double growth_exponent(const uint64_t work[GROWTH_SIZES]);
/* Whether it grows faster than n, and by its differences faster than n^most, but for 48 blocks a thing and a quarter of the
 * work, which rooms that double and places of chance explain. n: the middle size. */
bool growth_exceeds(const uint64_t work[GROWTH_SIZES], int n, double most);
/* The same, and says so. */
bool growth_judge(const char *where, const char *what, const uint64_t work[GROWTH_SIZES], int n, double most);

#endif
