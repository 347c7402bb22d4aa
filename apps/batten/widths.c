#include "widths.h"

#include <math.h>
#include <stdlib.h>

int widths_of(const cli_arguments *arguments, widths *out) {
    double *places = NULL;
    size_t count = 0;
    *out = (widths){0};
    int failed = arguments_places(arguments, "--widths", 2, &places, &count);
    if (!failed && count > BAT_WIDTHS_MAX)
        failed = fail_usage(arguments->command, "--widths: more than %d stops", BAT_WIDTHS_MAX);
    for (size_t i = 0; i < count && !failed; i++) {
        const double at = places[2 * i], width = places[2 * i + 1];
        if (!(at >= 0 && at <= 1) || (i > 0 && !(at > places[2 * i - 2])))
            failed = fail_usage(arguments->command, "--widths: places ascend from 0 to 1");
        else if (!(width >= 0 && width <= BAT_COORDINATE_MAX))
            failed = fail_usage(arguments->command, "--widths: a width is at least 0");
        out->width = fmax(out->width, width);
    }
    if (!failed && count && !(out->width > 0))
        failed = fail_usage(arguments->command, "--widths: the greatest is above 0");
    for (size_t i = 0; i < count && !failed; i++)
        out->stops[i] = (bat_width_stop){places[2 * i], places[2 * i + 1] / out->width};
    if (!failed) out->count = count;
    free(places);
    return failed;
}
