/* batten loft: a surface through sections. */
#include "program.h"
#include "results.h"

#include <batten/sweep.h>
#include <stdlib.h>

enum { LEAST = 2 };

typedef struct sections {
    int count;
    bat_curve *curves[OPERANDS_MAX];
} sections;

/* Names the first section that is open where the first is closed, or the reverse. */
static int fail_loft(const cli_arguments *arguments, const sections *s, bat_status status) {
    const char *first = arguments->operands[0];
    const bool closed = bat_curve_is_closed(s->curves[0]);
    for (int k = 1; k < s->count; k++)
        if (bat_curve_is_closed(s->curves[k]) != closed)
            return fail_data(arguments->operands[k], "closed",
                             "expected %s curve as the first section is, found %s one",
                             closed ? "a closed" : "an open", closed ? "an open" : "a closed");
    switch (status) {
    case BAT_MEMORY: return fail_memory();
    case BAT_COUNT:
        return fail_data(first, "knots",
                         "expected sections that share knots, found knots that together are over 4 "
                         "times those of the largest section");
    case BAT_SINGULAR:
        return fail_data(first, NULL,
                         "expected sections that differ, found two neighbours that are the same");
    default: return fail_data(first, NULL, "%s", bat_status_message(status));
    }
}

static int loft(const cli_arguments *arguments, const sections *s) {
    const bat_curve *given[OPERANDS_MAX];
    double v[OPERANDS_MAX];
    bat_surface *made = NULL;
    for (int k = 0; k < s->count; k++) given[k] = s->curves[k];
    bat_status status = bat_surface_loft((size_t)s->count, given, &made, v);
    if (status != BAT_OK) return fail_loft(arguments, s, status);
    bat_text report = {0};
    bat_text_string(&report, "{\"v\":");
    put_numbers(&report, v, (size_t)s->count);
    bat_text_string(&report, "}");
    int failed = write_surface(made, &report);
    bat_surface_free(made);
    return failed;
}

static int run(const cli_arguments *arguments) {
    sections s = {.count = LEAST};
    while (s.count < OPERANDS_MAX && arguments->operands[s.count]) s.count++;
    int failed = arguments_one_input(arguments, s.count, "the curves");
    for (int k = 0; k < s.count && !failed; k++) failed = read_curve(arguments->operands[k], &s.curves[k]);
    if (!failed) failed = loft(arguments, &s);
    for (int k = 0; k < s.count; k++) bat_curve_free(s.curves[k]);
    return failed;
}

const cli_command command_loft = {
    .name = "loft",
    .usage = "CURVE CURVE [CURVE ...]",
    .summary = "A surface through curves side by side.",
    .details = "The result is a SURFACE with a \"report\": u runs along the curves, over the first one's "
               "domain, and v "
               "in 0 to 1\n"
               "across; \"v\" lists the parameter of each curve, which the surface contains exactly. Two "
               "curves give a "
               "ruled\n"
               "surface. All are open, or all closed.",
    .example = "batten loft rib1.json rib2.json rib3.json",
    .operands = LEAST,
    .more = OPERANDS_MAX - LEAST,
    .run = run,
};
