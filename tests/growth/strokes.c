/* Careless strokes over one line: the work of bat_converge grows as they do (twice as many, twice the work). */
#include "growth.h"
#include "hands/sketch/converge.h"
#include "support/random_curve.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

enum { MIDDLE = 32, MOST_STROKES = 4 * MIDDLE, PLACES = 120 };

/* Beside a wave that is 600 px long, by an offset, a tilt and a tremor of their own; some drawn backwards. */
static void tangle(int count, double *places, bat_stroke *strokes) {
    random_source r = {41};
    for (int j = 0; j < count; j++) {
        double *at = places + 2 * PLACES * j;
        const double from = j == 0 ? 0 : random_between(&r, 0, 0.45),
                     to = j < 2 ? 1 : from + random_between(&r, 0.4, 0.55);
        const double off = random_between(&r, -5, 5), tilt = random_between(&r, -3, 3);
        const bool back = random_unit(&r) < 0.5;
        for (int i = 0; i < PLACES; i++) {
            const double g = i / (PLACES - 1.0), f = from + (to - from) * (back ? 1 - g : g);
            at[2 * i] = 600 * f;
            at[2 * i + 1] = 70 * sin(5 * f) + off + tilt * (2 * g - 1) + random_between(&r, -0.4, 0.4);
        }
        strokes[j] = (bat_stroke){.dimension = 2, .count = PLACES, .points = at};
    }
}

int main(void) {
    static double places[MOST_STROKES * PLACES * 2];
    static bat_stroke strokes[MOST_STROKES];
    uint64_t work[GROWTH_SIZES];
    int count = MIDDLE / 4;
    for (int i = 0; i < GROWTH_SIZES; i++, count *= 4) {
        bat_average line;
        tangle(count, places, strokes);
        const uint64_t before = growth_work;
        if (bat_converge((size_t)count, strokes, 1, &line) != BAT_OK) abort();
        work[i] = growth_work - before;
        free(line.points);
    }
    printf("strokes over one line: n^%.2f, %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", growth_exponent(work),
           work[0], work[1], work[2]);
    return growth_judge("sketching", "strokes over one line", work, MIDDLE, 1.15);
}
