#include "surfaces.h"

#include "text/number.h"

#include "results.h"

#include <math.h>

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
