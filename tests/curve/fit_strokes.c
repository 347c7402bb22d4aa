/* Prints one of the three benchmark strokes and the size of its fit, for fit_economy.py. */
#include <batten/fit.h>

#include <stdio.h>
#include <stdlib.h>

#include "../bench/strokes.h"

int main(int argc, char **argv) {
    enum { COUNT = 1000 };
    static double x[2 * COUNT];
    stroke_make(argc > 1 ? atoi(argv[1]) : 0, COUNT, 0.25, x);
    bat_fit_options options = bat_fit_defaults();
    options.tolerance = 0.5;
    bat_curve *curve = NULL;
    if (bat_fit(2, COUNT, x, &options, &curve, NULL) != BAT_OK) return 1;
    for (int i = 0; i < COUNT; i++) printf("%.17g %.17g\n", x[2 * i], x[2 * i + 1]);
    printf("fit %d %g\n", (int)bat_curve_count(curve), options.tolerance);
    bat_curve_free(curve);
    return 0;
}
