#include "sketch_options.h"

int sketch_options(const cli_arguments *arguments, bat_sketch_options *out) {
    const double least = 1e-30, most = 1e30;
    *out = bat_sketch_defaults();
    out->tolerance = 0; /* one pixel, whatever a pixel is */
    long pins = out->pins;
    int failed = arguments_number(arguments, "--tolerance", least, most, &out->tolerance);
    if (!failed) failed = arguments_number(arguments, "--pixel", least, most, &out->pixel);
    if (!failed) failed = arguments_integer(arguments, "--pins", 2, 3, &pins);
    out->pins = (int)pins;
    return failed;
}
