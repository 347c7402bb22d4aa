/* batten nearest: the closest point of a curve. */
#include "program.h"
#include "results.h"

#include <stdlib.h>

static int nearest(const char *name, const bat_curve *curve, const double *point, size_t count) {
    int dimension = bat_curve_dimension(curve);
    if (count != (size_t)dimension) {
        return fail_data(name, "--point", "expected %d coordinates, as the curve has, found %zu", dimension,
                         count);
    }
    bat_near near;
    bat_status status = bat_curve_nearest(curve, point, &near);
    if (status == BAT_MEMORY) return fail_memory();
    if (status != BAT_OK) return fail_data(name, "--point", "%s", bat_status_message(status));
    bat_text text = {0};
    bat_text_string(&text, "{\"u\":");
    bat_text_number(&text, near.u);
    bat_text_string(&text, ",\"point\":");
    put_numbers(&text, near.point, (size_t)dimension);
    bat_text_string(&text, ",\"distance\":");
    bat_text_number(&text, near.distance);
    bat_text_string(&text, "}");
    return write_text(&text);
}

static int run(const cli_arguments *arguments) {
    double *point;
    size_t count;
    int failed = arguments_numbers(arguments, "--point", &point, &count);
    if (failed) return failed;
    if (count != 2 && count != 3) {
        free(point);
        return fail_usage(arguments->command, "--point X,Y or --point X,Y,Z is needed");
    }
    bat_curve *curve = NULL;
    failed = read_curve(arguments->operands[0], &curve);
    if (!failed) failed = nearest(arguments->operands[0], curve, point, count);
    bat_curve_free(curve);
    free(point);
    return failed;
}

const cli_command command_nearest = {
    .name = "nearest",
    .usage = "CURVE --point X,Y[,Z]",
    .summary = "The point of a curve that is closest to a point.",
    .details =
        "The result is {\"u\", \"point\", \"distance\"}. Of points equally close the one with the smaller\n"
        "parameter is taken.",
    .example = "batten nearest curve.json --point 3,4",
    .operands = 1,
    .options = {{"--point", "X,Y[,Z]", "the point, with as many coordinates as the curve has"}},
    .lines = true,
    .run = run,
};
