/* batten curve region: what is made of the regions that two closed curves bound. */
#include "curves.h"

#include <batten/format.h>
#include <batten/region.h>

static const double TOLERANCE_SHARE = 1e-6; /* of the sides of both boxes, where no tolerance is given */
static const char *const OPERATIONS[] = {"union", "difference", "intersection", "exclusion"};

static int region(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    const bat_curve *const curves[2] = {a, b};
    const bool even_odd = arguments_value(arguments, "--even-odd") != NULL;
    int operation = BAT_REGION_UNION;
    double tolerance = TOLERANCE_SHARE * size_of_both(a, b);
    int failed = arguments_choice(arguments, "--operation", OPERATIONS, BAT_REGION_OPERATION_COUNT,
                                  &operation);
    if (!failed && arguments_value(arguments, "--tolerance"))
        failed = required_tolerance(arguments, "--tolerance", &tolerance);
    for (int i = 0; i < 2 && !failed; i++) {
        if (bat_curve_dimension(curves[i]) != 2)
            failed = fail_data(arguments->operands[i], "points[0]",
                               "expected 2 numbers, for a curve in the plane, found 3");
        else if (!bat_curve_is_closed(curves[i]))
            failed = fail_data(arguments->operands[i], "closed",
                               "expected a closed curve, found an open one");
    }
    if (failed) return failed;
    if (!(tolerance > 0)) tolerance = 1; /* two points, which bound nothing */
    const bat_region both[2] = {{1, curves, even_odd}, {1, curves + 1, even_odd}};
    size_t count = 0;
    bat_curve **all = NULL;
    const bat_status status = bat_regions_combine((bat_region_operation)operation, 2, both, tolerance, &count,
                                                  &all);
    if (status != BAT_OK) return fail_curve(arguments, status);
    failed = write_curves(count, all, NULL);
    bat_curves_free(count, all);
    return failed;
}

static int run_region(const cli_arguments *arguments) {
    int operation;
    double tolerance;
    int failed = arguments_choice(arguments, "--operation", OPERATIONS, BAT_REGION_OPERATION_COUNT,
                                  &operation);
    if (!failed && arguments_value(arguments, "--tolerance"))
        failed = required_tolerance(arguments, "--tolerance", &tolerance); /* before any file is read */
    return failed ? failed : with_curves(arguments, region);
}

const cli_command command_curve_region = {
    .name = "curve region",
    .usage = "A B [--operation KIND] [--even-odd] [--tolerance T]",
    .summary = "What is made of what two closed curves bound: union, difference and others.",
    .details = "The result is an array of closed CURVEs that do not cross, outer ones anticlockwise where y "
               "points up,\n"
               "holes clockwise. What no cut touches keeps its control points; there may be no curve at all.",
    .example = "batten curve region drawing.svg#disc drawing.svg#slot --operation difference",
    .operands = 2,
    .options = {{"--operation", "KIND",
                 "union (the default), difference (A without B), intersection or exclusion"},
                {"--even-odd", NULL, "where a curve runs round twice is outside"},
                {"--tolerance", "T", "what is nearer is the same, a millionth of the size by default"}},
    .run = run_region,
};
