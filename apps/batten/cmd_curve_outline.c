/* batten curve outline: the outline of a stroke along a curve. */
#include "curves.h"
#include "widths.h"

#include <batten/format.h>
#include <batten/width.h>

#include <math.h>

static const double CORNER = 0.02;          /* radians */
static const double TOLERANCE_SHARE = 1e-4; /* of the sides of the curve's box, where no tolerance is given */
static const double LIMIT_MAX = 1e6;        /* of mitres */
static const char *const CAPS[] = {"butt", "round", "square"};
static const char *const JOINS[] = {"miter", "round", "bevel"};

static int options_of(const cli_arguments *arguments, bat_nib *nib, widths *w, double *tolerance) {
    int cap = BAT_CAP_ROUND, join = BAT_JOIN_ROUND;
    int failed = widths_of(arguments, w);
    nib->width = w->width;
    if (!failed && !w->count) failed = required_tolerance(arguments, "--width", &nib->width);
    if (!failed) failed = arguments_choice(arguments, "--cap", CAPS, 3, &cap);
    if (!failed) failed = arguments_choice(arguments, "--join", JOINS, 3, &join);
    nib->cap = (bat_cap)cap, nib->join = (bat_join)join, nib->miter_limit = 4;
    if (!failed && arguments_value(arguments, "--miter-limit"))
        failed = arguments_number(arguments, "--miter-limit", 1, LIMIT_MAX, &nib->miter_limit);
    if (!failed && arguments_value(arguments, "--tolerance"))
        failed = required_tolerance(arguments, "--tolerance", tolerance);
    return failed;
}

static int outline(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    bat_nib nib;
    widths w;
    double tolerance = TOLERANCE_SHARE * size_of_both(a, b), error = 0;
    size_t count = 0;
    bat_curve **all = NULL;
    int failed = options_of(arguments, &nib, &w, &tolerance);
    if (failed) return failed;
    if (bat_curve_dimension(a) != 2)
        return fail_data(arguments->operands[0], "points[0]",
                         "expected 2 numbers, for a curve in the plane, found 3");
    if (!(tolerance > 0)) tolerance = fmax(TOLERANCE_SHARE * nib.width, 1e-12); /* a point */
    const bat_width_profile profile = {w.count, w.stops};
    const bat_status status = bat_curve_outline_width(a, &nib, &profile, tolerance, CORNER, &count, &all,
                                                      &error);
    if (status == BAT_SINGULAR)
        return fail_data(arguments->operands[0], NULL,
                         "the outline does not close with this tolerance: another --tolerance may do");
    if (status != BAT_OK) return fail_curve(arguments, status);
    return write_curves_within(count, all, error);
}

static int run_outline(const cli_arguments *arguments) {
    bat_nib nib;
    widths w;
    double tolerance;
    const bool even = arguments_value(arguments, "--width"), uneven = arguments_value(arguments, "--widths");
    if (even == uneven)
        return fail_usage(arguments->command, even ? "--width or --widths" : "--width is needed");
    const int failed = options_of(arguments, &nib, &w, &tolerance); /* before any file is read */
    return failed ? failed : with_curves(arguments, outline);
}

const cli_command command_curve_outline = {
    .name = "curve outline",
    .usage = "CURVE --width W|--widths S,W... [--cap KIND] [--join KIND] [--miter-limit R] [--tolerance T]",
    .summary = "The outline of a stroke along a planar curve.",
    .details = "The result is an array of closed CURVEs that do not cross, each with a \"report\": none is "
               "further than\n\"max_error\" from where the stroke ends; outer ones run anticlockwise where y "
               "points up, holes clockwise.",
    .example = "batten curve outline curve.json --width 4 --cap butt --join miter",
    .operands = 1,
    .options = {{"--width", "W", "of the stroke, document units"},
                {"--widths", "S,W...",
                 "places from 0 to 1 along the length, and the widths there; monotone between them"},
                {"--cap", "KIND", "butt, round or square, at the ends of an open curve; round by default"},
                {"--join", "KIND", "miter, round or bevel, at corners; round by default"},
                {"--miter-limit", "R", "miters longer than so many widths are bevelled; 4 by default"},
                {"--tolerance", "T", "greatest error, a ten-thousandth of the size by default"}},
    .lines = true,
    .run = run_outline,
};
