#include "support/solve_fail.h"

#include "curve/banded.h"

static long countdown, rest; /* 0: none fails; how many fail from there on */
static long count_of_all;
static bool hit;

long solve_count(void) { return count_of_all; }

void solve_fail_at(long n, long count) { countdown = n, rest = count, hit = false; }

bool solve_fail_reached(void) {
    countdown = 0;
    return hit;
}

static bool fails_now(void) {
    count_of_all++;
    if (countdown == 0 || (countdown > 1 && countdown--)) return false;
    if (--rest == 0) countdown = 0;
    return hit = true;
}

bat_status __real_bat_banded_factor(double *a, int n, int p);
bat_status __real_bat_cyclic_factor(double *a, int n, int p, double *border);
bat_status __wrap_bat_banded_factor(double *a, int n, int p);
bat_status __wrap_bat_cyclic_factor(double *a, int n, int p, double *border);

bat_status __wrap_bat_banded_factor(double *a, int n, int p) {
    return fails_now() ? BAT_SINGULAR : __real_bat_banded_factor(a, n, p);
}

bat_status __wrap_bat_cyclic_factor(double *a, int n, int p, double *border) {
    return fails_now() ? BAT_SINGULAR : __real_bat_cyclic_factor(a, n, p, border);
}
