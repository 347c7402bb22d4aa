/* batten surface isocurve: an iso-curve, exact. */
#include "program.h"
#include "results.h"
#include "surfaces.h"

static int run(const cli_arguments *arguments) {
    bat_direction direction;
    double at;
    int failed = line_of(arguments, &direction, &at);
    if (failed) return failed;
    bat_surface *surface = NULL;
    failed = read_surface(arguments->operands[0], &surface);
    if (!failed) failed = check_line(arguments, surface, direction, at);
    if (!failed) {
        bat_curve *line = NULL;
        bat_status status = bat_surface_isocurve(surface, direction, at, &line);
        failed = status == BAT_OK ? write_curve(line) : fail_memory();
        bat_curve_free(line);
    }
    bat_surface_free(surface);
    return failed;
}

const cli_command command_surface_isocurve = {
    .name = "surface isocurve",
    .usage = "SURFACE (--u U | --v V)",
    .summary = "A parameter line of a surface, as a curve.",
    .details =
        "The line at u is S(u, .) and runs along v. The result is a CURVE with the surface's knots of that\n"
        "direction; it is exact.",
    .example = "batten surface isocurve sheet.json --u 0.5",
    .operands = 1,
    .options = {OPTION_U, OPTION_V},
    .run = run,
};
