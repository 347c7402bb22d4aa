/* batten surface redraw: an iso-curve is replaced by another curve, and the surface follows. */
#include "program.h"
#include "results.h"
#include "surfaces.h"

#include <batten/bezier.h>
#include <stdlib.h>

static int redraw(const cli_arguments *arguments, const bat_surface *surface, const wish *w) {
    bat_curve *read = NULL, *line = NULL;
    bat_surface *made = NULL;
    bat_surface_redraw_report report;
    int failed = read_curve(arguments->operands[1], &read);
    if (failed) return failed;
    double *weights = malloc(bat_surface_count(surface, w->direction) * sizeof *weights);
    bat_status status = weights ? bat_curve_to_dimension(read, 3, &line) : BAT_MEMORY; /* 2 numbers: z = 0 */
    if (status == BAT_OK)
        status = bat_surface_redraw(surface, w->direction, w->at, line, &w->options, &made, weights, &report);
    if (status == BAT_OK) {
        bat_text text = {0};
        put_redraw_report(&text, made, w, &report, weights);
        failed = write_surface(made, &text);
    } else {
        failed = fail_redraw(arguments, status, surface, w, &report);
    }
    free(weights);
    bat_surface_free(made);
    bat_curve_free(line);
    bat_curve_free(read);
    return failed;
}

static int run(const cli_arguments *arguments) {
    wish w = {.hold = NULL};
    bat_surface *surface = NULL;
    int failed = read_wish(arguments, &w);
    if (!failed) failed = arguments_one_input(arguments, 2, "SURFACE and LINE");
    if (!failed) failed = read_surface(arguments->operands[0], &surface);
    if (!failed) failed = check_line(arguments, surface, w.direction, w.at);
    if (!failed) failed = redraw(arguments, surface, &w);
    bat_surface_free(surface);
    free(w.hold);
    return failed;
}

const cli_command command_surface_redraw = {
    .name = "surface redraw",
    .usage = "SURFACE LINE (--u U | --v V) [--reach R] [--hold I,I,...]",
    .summary = "Redraws a parameter line of a surface, which comes along.",
    .details = "LINE is the line as it shall be: a CURVE on the surface's knots along it, or a superset, to "
               "which the\n"
               "surface is then refined. The result is a SURFACE with a \"report\": what moved and how far. "
               "A line that\n"
               "can not move (its rows are held, or would have to move over 4 times as far) is bad data.",
    .example = "batten surface redraw sheet.json line.json --u 0.5 --hold 0,1",
    .operands = 2,
    .options = {OPTION_U, OPTION_V, OPTION_REACH, OPTION_HOLD},
    .run = run,
};
