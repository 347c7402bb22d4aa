/*
 * Makes the nth solve of a system of equations fail, as if it were singular: what allocations that fail are for memory
 * (alloc_fail.h), for numbers. A test program that includes this is linked with --wrap for the functions below
 * (tests/CMakeLists.txt), so not for WebAssembly. Include it in one file of a program.
 */
#ifndef BATTEN_TESTS_SOLVE_FAIL_H
#define BATTEN_TESTS_SOLVE_FAIL_H

#include "curve/banded.h"

static long solve_countdown, solve_rest; /* 0: none fails; how many fail from there on */
static bool solve_hit;

/* The nth solve from now on fails, and those that follow it, `count` in all; 0 switches this off. */
static inline void solve_fail_at(long n, long count) {
    solve_countdown = n, solve_rest = count, solve_hit = false;
}

/* Whether it has failed. Also switches this off. */
static inline bool solve_fail_reached(void) {
    solve_countdown = 0;
    return solve_hit;
}

static bool solve_fails_now(void) {
    if (solve_countdown == 0 || (solve_countdown > 1 && solve_countdown--)) return false;
    if (--solve_rest == 0) solve_countdown = 0;
    return solve_hit = true;
}

bat_status __real_bat_banded_factor(double *a, int n, int p);
bat_status __real_bat_cyclic_factor(double *a, int n, int p, double *border);
bat_status __wrap_bat_banded_factor(double *a, int n, int p);
bat_status __wrap_bat_cyclic_factor(double *a, int n, int p, double *border);

bat_status __wrap_bat_banded_factor(double *a, int n, int p) {
    return solve_fails_now() ? BAT_SINGULAR : __real_bat_banded_factor(a, n, p);
}

bat_status __wrap_bat_cyclic_factor(double *a, int n, int p, double *border) {
    return solve_fails_now() ? BAT_SINGULAR : __real_bat_cyclic_factor(a, n, p, border);
}

#endif
