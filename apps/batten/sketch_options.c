#include "sketch_options.h"

/* Options of the sketch hand, given in pixels. */
static const double TOLERANCE_LEAST = 1e-3, TOLERANCE_MOST = 1e6;

int sketch_options(const cli_arguments *arguments, bat_sketch_options *out) {
    const double least = 1e-30, most = 1e30;
    *out = bat_sketch_defaults();
    out->tolerance = 0; /* 0 means one pixel, whatever its size */
    long pins = out->pins;
    int failed = arguments_number(arguments, "--tolerance", least, most, &out->tolerance);
    if (!failed) failed = arguments_number(arguments, "--pixel", least, most, &out->pixel);
    if (!failed) failed = arguments_integer(arguments, "--pins", 2, 3, &pins);
    out->pins = (int)pins;
    if (failed) return failed;
    double pixels = out->tolerance > 0 ? out->tolerance / out->pixel : 1;
    if (pixels < TOLERANCE_LEAST || pixels > TOLERANCE_MOST) {
        return fail_usage(arguments->command, "--tolerance: expected %g to %g pixels of --pixel, found %g",
                          TOLERANCE_LEAST, TOLERANCE_MOST, pixels);
    }
    return EXIT_DONE;
}
