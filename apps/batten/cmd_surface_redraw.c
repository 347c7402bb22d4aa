/* batten surface redraw: an iso-curve is replaced by another curve, and the surface follows. */
#include "program.h"
#include "results.h"
#include "surfaces.h"

#include "text/number.h"

#include <batten/bezier.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What was asked for, besides the surface. */
typedef struct wish {
    bat_direction direction;
    double at;
    bat_surface_redraw_options options;
    int *hold;
} wish;

static int read_hold(const cli_arguments *arguments, wish *out) {
    double *rows;
    size_t count;
    int failed = arguments_numbers(arguments, "--hold", &rows, &count);
    if (failed || !rows) return failed;
    out->hold = malloc(count * sizeof *out->hold);
    if (!out->hold) failed = fail_memory();
    for (size_t i = 0; i < count && !failed; i++) {
        if (!(rows[i] >= 0 && rows[i] < BAT_POINTS_MAX && rows[i] == floor(rows[i])))
            failed = fail_usage(arguments->command, "--hold: expected numbers of rows, found %g", rows[i]);
        else
            out->hold[i] = (int)rows[i];
    }
    out->options.hold = out->hold, out->options.hold_count = count;
    free(rows);
    return failed;
}

static int read_wish(const cli_arguments *arguments, wish *out) {
    out->options = bat_surface_redraw_defaults();
    int failed = line_of(arguments, &out->direction, &out->at);
    if (!failed) failed = arguments_number(arguments, "--reach", 1e-30, 1e30, &out->options.reach);
    return failed ? failed : read_hold(arguments, out);
}

/* Says why the line cannot be redrawn. */
static int fail_redraw(const cli_arguments *arguments, bat_status status, const bat_surface *surface,
                       const wish *w, const bat_surface_redraw_report *report) {
    const char *line = arguments->operands[1], *place = w->direction == BAT_U ? "--u" : "--v";
    const int rows = (int)bat_surface_count(surface, w->direction);
    char gain[BAT_NUMBER_ROOM];
    switch (status) {
    case BAT_MEMORY: return fail_memory();
    case BAT_DIMENSION: return fail_data(line, "points", "expected points of 3 numbers, found 2");
    case BAT_DEGREE:
        return fail_data(line, "degree", "expected %d, as the surface has along the line, found another",
                         bat_surface_degree(surface, w->direction == BAT_U ? BAT_V : BAT_U));
    case BAT_KNOTS:
        return fail_data(line, "knots",
                         "expected the surface's knots along the line, or a superset, found others");
    case BAT_DOT:
        return fail_data(arguments->operands[0], place, "expected a line, found a point (a collapsed edge)");
    case BAT_SINGULAR:
        return fail_data(
            line, "points",
            "expected a line that leaves the pole (a collapsed edge) where it is, found one that "
            "moves it");
    case BAT_ARGUMENT: /* its other causes have been ruled out already */
        for (size_t i = 0; i < w->options.hold_count; i++)
            if (w->options.hold[i] >= rows)
                return fail_data(arguments->operands[0], "--hold", "expected rows 0 to %d, found %d",
                                 rows - 1, w->options.hold[i]);
        return fail_data(line, "closed", "expected what the surface is along the line, found the opposite");
    case BAT_FAR:
        if (!isfinite(report->gain))
            return fail_data(arguments->operands[0], place,
                             "expected a line that can move, found all rows beside it held or out of reach");
        bat_number_print(report->gain, gain);
        return fail_data(arguments->operands[0], place,
                         "expected a line that can move with a gain up to 4, found %s", gain);
    default: return fail_data(line, NULL, "%s", bat_status_message(status));
    }
}

static void put_report(bat_text *text, const bat_surface *surface, const wish *w,
                       const bat_surface_redraw_report *report, const double *weights) {
    bat_text_string(text, w->direction == BAT_U ? "{\"direction\":\"u\",\"value\":"
                                                : "{\"direction\":\"v\",\"value\":");
    bat_text_number(text, report->value);
    bat_text_string(text, ",\"reach\":");
    bat_text_number(text, report->reach);
    bat_text_string(text, ",\"moved\":");
    put_numbers(text, report->moved, 2);
    bat_text_string(text, ",\"rows\":[");
    const char *separator = "";
    for (size_t i = 0; i < bat_surface_count(surface, w->direction); i++) {
        if (!(weights[i] > 0)) continue;
        bat_text_string(text, separator);
        bat_text_integer(text, i);
        separator = ",";
    }
    bat_text_string(text, "],\"gain\":");
    bat_text_number(text, report->gain);
    bat_text_string(text, ",\"line_error\":");
    bat_text_number(text, report->line_error);
    const double before[2] = {report->knots_before[0], report->knots_before[1]};
    const double after[2] = {report->knots_after[0], report->knots_after[1]};
    bat_text_string(text, ",\"knots_before\":");
    put_numbers(text, before, 2);
    bat_text_string(text, ",\"knots_after\":");
    put_numbers(text, after, 2);
    bat_text_string(text, "}");
}

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
        put_report(&text, made, w, &report, weights);
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
    if (!failed && strcmp(arguments->operands[0], "-") == 0 && strcmp(arguments->operands[1], "-") == 0)
        failed = fail_usage(arguments->command, "only one of SURFACE and LINE can be standard input");
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
    .options = {OPTION_U,
                OPTION_V,
                {"--reach", "R", "radius of what comes along, in parameters; 2.5 mean spans by default"},
                {"--hold", "I,I,...", "rows that stay, counted from 0 along the direction that is crossed"}},
    .run = run,
};
