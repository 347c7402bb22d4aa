/* batten sketch: a curve redrawn by a stroke. */
#include "program.h"
#include "results.h"
#include "sketch_options.h"

#include <string.h>

static int sketch(const cli_arguments *arguments, const bat_curve *curve, const bat_sketch_options *options) {
    const char *name = arguments->operands[1];
    bat_stroke stroke;
    void *block = NULL;
    int failed = read_stroke(name, &stroke, &block);
    if (failed) return failed;
    bat_curve *redrawn = NULL;
    bat_sketch_report report = {0};
    bat_status status = bat_sketch(curve, &stroke, options, &redrawn, &report);
    failed = status == BAT_OK ? write_sketch(redrawn, &report) : fail_sketch(name, status, &report, options);
    bat_curve_free(redrawn);
    bat_free(block);
    return failed;
}

static int run(const cli_arguments *arguments) {
    bat_sketch_options options;
    int failed = sketch_options(arguments, &options);
    if (!failed) failed = arguments_one_input(arguments, 2, "CURVE and STROKE");
    if (failed) return failed;
    bat_curve *curve = NULL;
    failed = read_curve(arguments->operands[0], &curve);
    if (!failed) failed = sketch(arguments, curve, &options);
    bat_curve_free(curve);
    return failed;
}

const cli_command command_sketch = {
    .name = "sketch",
    .usage = "CURVE STROKE [--tolerance T] [--pixel P] [--pins 2|3]",
    .summary = "Redraws a curve with a stroke: it follows there, and stays as it was elsewhere.",
    .details = "The result is a CURVE with a \"report\": the greatest distance from the stroke, knots before "
               "and after,\n"
               "the interval that changed. A stroke that is a dot, or too far from the curve, is bad data.",
    .example = "batten sketch roof.json stroke.json > redrawn.json",
    .operands = 2,
    .options = {OPTION_TOLERANCE,
                OPTION_PIXEL,
                {"--pins", "2|3", "control points kept on either side, 3 by default"}},
    .puts_back = true,
    .run = run,
};
