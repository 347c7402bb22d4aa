#include "growth.h"

#include <math.h>
#include <stdio.h>

double growth_exponent(const uint64_t work[GROWTH_SIZES]) {
    double first = (double)work[1] - (double)work[0], second = (double)work[2] - (double)work[1];
    return second > 0 ? log(second / fmax(first, 1)) / log(4) : 0;
}

bool growth_exceeds(const uint64_t work[GROWTH_SIZES], int n, double most) {
    double first = (double)work[1] - (double)work[0], second = (double)work[2] - (double)work[1];
    double slack = 48.0 * n + 0.25 * (double)work[1];
    if ((double)work[2] <= 4.0 * (double)work[1]) return false;
    return second > pow(4, most) * fmax(first, 0) + slack;
}

bool growth_judge(const char *where, const char *what, const uint64_t work[GROWTH_SIZES], int n,
                  double most) {
    if (!growth_exceeds(work, n, most)) return false;
    printf("%s: %s grows with n^%.2f: %llu, %llu, %llu\n", where, what, growth_exponent(work),
           (unsigned long long)work[0], (unsigned long long)work[1], (unsigned long long)work[2]);
    fflush(stdout);
    return true;
}
