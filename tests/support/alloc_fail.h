/*
 * Makes the Nth allocation fail. All test programs are linked with --wrap for malloc, calloc, realloc and free
 * (tests/CMakeLists.txt), which reaches into the static library; alloc_fail.c has the functions.
 *
 *     for (int n = 1; ; n++) {
 *         alloc_fail_at(n);
 *         status = work();
 *         if (!alloc_fail_reached()) break;   // work needs fewer than n allocations: done
 *         assert status == BAT_MEMORY, outputs untouched
 *     }
 *     assert status == BAT_OK
 *
 * alloc_live() counts the blocks that the program holds: if it is the same before and after, nothing leaked.
 */
#ifndef BATTEN_TESTS_ALLOC_FAIL_H
#define BATTEN_TESTS_ALLOC_FAIL_H

#include <stdbool.h>

extern long alloc_countdown; /* 0: none fails; -1: alloc_decides says which */
extern bool alloc_hit;
extern long alloc_blocks;
extern bool (*alloc_decides)(void); /* alloc_paths.h */

/* Makes the nth allocation from now on fail, once; 0 switches this off. */
static inline void alloc_fail_at(long n) { alloc_countdown = n, alloc_hit = false; }

/* Whether that allocation has failed. Also switches it off. */
static inline bool alloc_fail_reached(void) {
    alloc_countdown = 0;
    return alloc_hit;
}

static inline long alloc_live(void) { return alloc_blocks; }

#endif
