/* batten fit: a new curve from a stroke. */
#include "program.h"
#include "results.h"
#include "sketch_options.h"

static int run(const cli_arguments *arguments) {
    const char *name = arguments->operands[0];
    bat_sketch_options options;
    int failed = sketch_options(arguments, &options);
    long degree = options.degree;
    if (!failed) failed = arguments_integer(arguments, "--degree", 3, BAT_DEGREE_MAX, &degree);
    if (failed) return failed;
    options.degree = (int)degree;
    bat_stroke stroke;
    void *block = NULL;
    failed = read_stroke(name, &stroke, &block);
    if (failed) return failed;
    bat_curve *curve = NULL;
    bat_sketch_report report = {0};
    bool closed = arguments_value(arguments, "--closed");
    bat_status status = bat_sketch_new(&stroke, closed, &options, &curve, &report);
    failed = status == BAT_OK ? write_sketch(curve, &report) : fail_sketch(name, status, &report, &options);
    bat_curve_free(curve);
    bat_free(block);
    return failed;
}

const cli_command command_fit = {
    .name = "fit",
    .usage = "STROKE [--tolerance T] [--pixel P] [--degree P] [--closed]",
    .summary = "A new curve from a stroke.",
    .details = "STROKE is JSON ({\"points\", \"pressure\", \"time\"}) or CSV with a header line x,y. The "
               "result is a CURVE\n"
               "with a \"report\".",
    .example = "batten fit stroke.csv --tolerance 0.5 > curve.json",
    .operands = 1,
    .options = {OPTION_TOLERANCE,
                OPTION_PIXEL,
                {"--degree", "P", "3 (default) to 7; the curve is C^(P - 1)"},
                {"--closed", NULL, "closed, even when the stroke's ends do not meet"}},
    .run = run,
};
