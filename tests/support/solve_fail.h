/*
 * Makes the nth solve of a system of equations fail, as if it were singular: what allocations that fail are for memory
 * (alloc_fail.h), for numbers. All native test programs are linked with --wrap for the two functions that solve
 * (tests/CMakeLists.txt); solve_fail.c stands in for them. Not for WebAssembly.
 */
#ifndef BATTEN_TESTS_SOLVE_FAIL_H
#define BATTEN_TESTS_SOLVE_FAIL_H

#include <stdbool.h>

/* The nth solve from now on fails, and those that follow it, `count` in all; 0 switches this off. */
void solve_fail_at(long n, long count);
/* How many there were since the program began: what fitting costs. */
long solve_count(void);
/* Whether it has failed. Also switches this off. */
bool solve_fail_reached(void);

#endif
