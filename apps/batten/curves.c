#include "curves.h"

#include <float.h>
#include <math.h>

int with_curves(const cli_arguments *arguments, curve_work *work) {
    bat_curve *a = NULL, *b = NULL;
    int failed = arguments_one_input(arguments, arguments->operands[1] ? 2 : 1, "the curves");
    if (!failed) failed = read_curve(arguments->operands[0], &a);
    if (!failed && arguments->operands[1]) failed = read_curve(arguments->operands[1], &b);
    if (!failed && b && bat_curve_dimension(a) != bat_curve_dimension(b))
        failed = fail_data(arguments->operands[1], "points[0]",
                           "expected %d numbers, as in the other curve, found %d", bat_curve_dimension(a),
                           bat_curve_dimension(b));
    if (!failed) failed = work(arguments, a, b);
    bat_curve_free(a), bat_curve_free(b);
    return failed;
}

int fail_curve(const cli_arguments *arguments, bat_status status) {
    if (status == BAT_MEMORY) return fail_memory();
    return fail_data(arguments->operands[0], NULL, "%s", bat_status_message(status));
}

int fail_near(const cli_arguments *arguments, bat_status status) {
    if (status == BAT_TOLERANCE)
        return fail_data(arguments->operands[0], "--tolerance",
                         "expected one that rounding does not hide at these coordinates, found too small a "
                         "one");
    if (status == BAT_COUNT)
        return fail_data(arguments->operands[0], "--tolerance",
                         "expected one for which 16777216 pieces are enough, found too small a one");
    return fail_curve(arguments, status);
}

int write_made(const cli_arguments *arguments, bat_status status, bat_curve *curve) {
    if (status != BAT_OK) return fail_curve(arguments, status);
    const int failed = write_curve(curve);
    bat_curve_free(curve);
    return failed;
}

int required_tolerance(const cli_arguments *arguments, const char *name, double *out) {
    if (!arguments_value(arguments, name)) return fail_usage(arguments->command, "%s is needed", name);
    return arguments_number(arguments, name, DBL_MIN, BAT_COORDINATE_MAX, out);
}

double size_of_both(const bat_curve *a, const bat_curve *b) {
    return fmax(bat_curve_size(a), b ? bat_curve_size(b) : 0);
}
