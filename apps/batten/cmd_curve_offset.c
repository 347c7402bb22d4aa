/* batten curve offset: the parallels of a curve. */
#include "curves.h"

#include <batten/format.h>
#include <batten/relate.h>

#include <math.h>

static const double CORNER = 0.02;          /* radians */
static const double TOLERANCE_SHARE = 1e-4; /* of the sides of the curve's box, where no tolerance is given */

static int options_of(const cli_arguments *arguments, double *distance, double *tolerance) {
    int failed = arguments_number(arguments, "--distance", -BAT_COORDINATE_MAX, BAT_COORDINATE_MAX, distance);
    if (!failed && arguments_value(arguments, "--tolerance"))
        failed = required_tolerance(arguments, "--tolerance", tolerance);
    return failed;
}

static int offset(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    double distance = 0, tolerance = TOLERANCE_SHARE * size_of_both(a, b), error = 0;
    size_t count = 0;
    bat_curve **all = NULL;
    int failed = options_of(arguments, &distance, &tolerance);
    if (failed) return failed;
    if (bat_curve_dimension(a) != 2)
        return fail_data(arguments->operands[0], "points[0]",
                         "expected 2 numbers, for a curve in the plane, found 3");
    if (!(tolerance > 0)) tolerance = fmax(TOLERANCE_SHARE * fabs(distance), 1e-12); /* a point */
    const bat_status status = bat_curve_offset(a, distance, tolerance, CORNER, &count, &all, &error);
    if (status != BAT_OK) return fail_near(arguments, status);
    return write_curves_within(count, all, error);
}

static int run_offset(const cli_arguments *arguments) {
    double distance, tolerance;
    if (!arguments_value(arguments, "--distance"))
        return fail_usage(arguments->command, "--distance is needed");
    const int failed = options_of(arguments, &distance, &tolerance); /* before any file is read */
    return failed ? failed : with_curves(arguments, offset);
}

const cli_command command_curve_offset = {
    .name = "curve offset",
    .usage = "CURVE --distance D [--tolerance T]",
    .summary = "The parallels of a planar curve at a distance.",
    .details =
        "The result is an array of CURVEs, each with a \"report\": none is further than \"max_error\" from "
        "the\ndistance. Loops are cut off, corners that open are rounded; there may be no curve at all.",
    .example = "batten curve offset curve.json --distance 2 --tolerance 0.01",
    .operands = 1,
    .options = {{"--distance", "D", "document units; above 0 to the left of the curve where y points up"},
                {"--tolerance", "T",
                 "greatest error of the distance, a ten-thousandth of the size by default"}},
    .lines = true,
    .run = run_offset,
};
