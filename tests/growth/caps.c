/*
 * Cubics with a retracted handle at one end or both: what their outlines with butt caps cost beside those with round caps, by
 * counted work. Usage: growth_caps [COUNT]
 */
#include <batten/batten.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "growth.h"

static const double SIZE = 100, MOST = 10;
static uint64_t state = 1;

static double chance(void) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) / 9007199254740992.0;
}

static uint64_t work_of(const bat_curve *curve, double width, bat_cap cap) {
    const bat_nib nib = {width, cap, BAT_JOIN_MITER, 4};
    bat_curve **out = NULL;
    size_t count = 0;
    const uint64_t before = growth_work;
    const bat_status status = bat_curve_outline(curve, &nib, fmin(width / 200, 0.05), 0.05, &count, &out,
                                                NULL);
    const uint64_t work = growth_work - before;
    if (status != BAT_OK) {
        printf("width %g: %s\n", width, bat_status_message(status));
        exit(1);
    }
    bat_curves_free(count, out);
    return work;
}

int main(int argc, char **argv) {
    const int all = argc > 1 ? atoi(argv[1]) : 1000;
    double most = 0;
    int over = 0;
    for (int i = 0; i < all; i++) {
        double p[8];
        bat_curve *curve = NULL;
        for (int k = 0; k < 8; k++) p[k] = SIZE * chance();
        if (i % 3 != 1) memcpy(p + 2, p, 2 * sizeof *p);
        if (i % 3 != 0) memcpy(p + 4, p + 6, 2 * sizeof *p);
        const double size = chance(), width = SIZE * size * size * size + 0.3;
        if (bat_curve_from_bezier(2, 3, false, 1, p, 0.05, 0, &curve, NULL) != BAT_OK) return 1;
        const uint64_t round = work_of(curve, width, BAT_CAP_ROUND),
                       butt = work_of(curve, width, BAT_CAP_BUTT);
        most = fmax(most, (double)butt / (double)round);
        over += (double)butt > MOST * (double)round;
        bat_curve_free(curve);
    }
    printf("%d cubics: butt caps cost up to %.1f times as much as round ones, %d of them over %g times\n",
           all, most, over, MOST);
    return over > 0;
}
