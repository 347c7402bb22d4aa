/* --tolerance, --pixel and --pins, shared by fit and sketch. */
#ifndef BATTEN_APPS_SKETCH_OPTIONS_H
#define BATTEN_APPS_SKETCH_OPTIONS_H

#include "program.h"

#include <batten/sketch.h>

#define OPTION_TOLERANCE                                                                                     \
    { "--tolerance", "T", "greatest distance from the stroke, document units; 1 pixel by default" }
#define OPTION_PIXEL                                                                                         \
    { "--pixel", "P", "a pen pixel in document units, 1 by default" }

int sketch_options(const cli_arguments *arguments, bat_sketch_options *out);

#endif
