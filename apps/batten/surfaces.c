#include "surfaces.h"

#include "text/number.h"

#include "results.h"

#include <math.h>
#include <stdlib.h>

int line_of(const cli_arguments *arguments, bat_direction *direction, double *at) {
    const char *u = arguments_value(arguments, "--u"), *v = arguments_value(arguments, "--v");
    if (!u == !v) return fail_usage(arguments->command, "either --u or --v is needed");
    *direction = u ? BAT_U : BAT_V;
    return arguments_number(arguments, u ? "--u" : "--v", -INFINITY, INFINITY, at);
}

int check_parameter(const cli_arguments *arguments, const char *option, const bat_surface *surface,
                    bat_direction direction, double at) {
    double domain[2];
    bat_surface_domain(surface, direction, domain);
    if (bat_surface_is_closed(surface, direction) || (at >= domain[0] && at <= domain[1])) return EXIT_DONE;
    char found[BAT_NUMBER_ROOM], low[BAT_NUMBER_ROOM], high[BAT_NUMBER_ROOM];
    bat_number_print(at, found);
    bat_number_print(domain[0], low);
    bat_number_print(domain[1], high);
    return fail_data(arguments->operands[0], option, "expected %s in the domain [%s, %s], found %s",
                     direction == BAT_U ? "u" : "v", low, high, found);
}

int check_line(const cli_arguments *arguments, const bat_surface *surface, bat_direction direction,
               double at) {
    return check_parameter(arguments, direction == BAT_U ? "--u" : "--v", surface, direction, at);
}

void put_surface_point(bat_text *text, const bat_surface_point *point) {
    bat_text_string(text, "{\"u\":");
    bat_text_number(text, point->u);
    bat_text_string(text, ",\"v\":");
    bat_text_number(text, point->v);
    bat_text_string(text, ",\"distance\":");
    bat_text_number(text, point->distance);
    bat_text_string(text, ",\"point\":");
    put_numbers(text, point->point, 3);
    bat_text_string(text, "}");
}

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

int read_wish(const cli_arguments *arguments, wish *out) {
    out->options = bat_surface_redraw_defaults();
    int failed = line_of(arguments, &out->direction, &out->at);
    if (!failed) failed = arguments_number(arguments, "--reach", 1e-30, 1e30, &out->options.reach);
    return failed ? failed : read_hold(arguments, out);
}

int fail_redraw(const cli_arguments *arguments, bat_status status, const bat_surface *surface, const wish *w,
                const bat_surface_redraw_report *report) {
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

void put_redraw_report(bat_text *text, const bat_surface *surface, const wish *w,
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
