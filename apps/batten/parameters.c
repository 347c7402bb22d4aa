/* --at and --samples. */
#include "parameters.h"

#include "text/number.h"

#include <stdlib.h>

enum { SAMPLES_MAX = 1 << 24 };

int parameters_check(const cli_arguments *arguments) {
    bool at = arguments_value(arguments, "--at"), samples = arguments_value(arguments, "--samples");
    if (at == samples) return fail_usage(arguments->command, "either --at or --samples is needed");
    long ignored = 0;
    return arguments_integer(arguments, "--samples", 1, SAMPLES_MAX, &ignored);
}

int parameters_read(const cli_arguments *arguments, const bat_curve *curve, double **u, size_t *count) {
    int failed = arguments_numbers(arguments, "--at", u, count);
    if (failed) return failed;
    if (*u) {
        double domain[2];
        bat_curve_domain(curve, domain);
        for (size_t i = 0; i < *count && !bat_curve_is_closed(curve); i++) {
            if ((*u)[i] >= domain[0] && (*u)[i] <= domain[1]) continue;
            char found[BAT_NUMBER_ROOM], low[BAT_NUMBER_ROOM], high[BAT_NUMBER_ROOM];
            bat_number_print((*u)[i], found);
            bat_number_print(domain[0], low);
            bat_number_print(domain[1], high);
            free(*u);
            return fail_data(arguments->operands[0], "--at",
                             "expected a parameter in the domain [%s, %s], found %s", low, high, found);
        }
        return EXIT_DONE;
    }
    long samples = 0;
    failed = arguments_integer(arguments, "--samples", 1, SAMPLES_MAX, &samples);
    if (failed) return failed;
    *count = (size_t)samples;
    *u = malloc(*count * sizeof **u);
    if (!*u) return fail_memory();
    bat_curve_spread(curve, *count, *u);
    return EXIT_DONE;
}
