/* batten frames: moving frames along a curve. */
#include "parameters.h"
#include "results.h"

#include <batten/frames.h>

#include <stdlib.h>
#include <string.h>

static int print(const bat_curve *curve, const bat_frame3 *frames, size_t count, double holonomy) {
    enum { STRIDE = sizeof(bat_frame3) / sizeof(double) };
    bat_text text = {0};
    bat_text_string(&text, "{\"u\":[");
    for (size_t i = 0; i < count; i++) {
        if (i > 0) bat_text_string(&text, ",");
        bat_text_number(&text, frames[i].u);
    }
    bat_text_string(&text, "],\n\"points\":");
    put_points(&text, frames[0].point, count, bat_curve_dimension(curve), STRIDE);
    bat_text_string(&text, ",\n\"t\":");
    put_points(&text, frames[0].t, count, 3, STRIDE);
    bat_text_string(&text, ",\n\"s\":");
    put_points(&text, frames[0].s, count, 3, STRIDE);
    bat_text_string(&text, ",\n\"r\":");
    put_points(&text, frames[0].r, count, 3, STRIDE);
    if (bat_curve_is_closed(curve)) {
        bat_text_string(&text, ",\n\"holonomy\":");
        bat_text_number(&text, holonomy);
    }
    bat_text_string(&text, "}");
    return write_text(&text);
}

static int read_options(const cli_arguments *arguments, bat_frame_options *out) {
    static const char *const kinds[] = {"rmf", "frenet", "fixed"};
    *out = bat_frame_defaults();
    const char *kind = arguments_value(arguments, "--kind");
    int found = kind ? -1 : 0;
    for (int i = 0; i < 3 && kind; i++)
        if (strcmp(kind, kinds[i]) == 0) found = i;
    if (found < 0)
        return fail_usage(arguments->command, "--kind: expected rmf, frenet or fixed, found '%s'", kind);
    out->rule = (bat_frame_rule)found;
    long substeps = 0;
    int failed = arguments_integer(arguments, "--substeps", 1, 1024, &substeps);
    if (failed) return failed;
    out->substeps = arguments_value(arguments, "--substeps") ? (int)substeps : 0;
    double *first;
    size_t count;
    failed = arguments_numbers(arguments, "--first", &first, &count);
    if (failed || !first) return failed;
    if (count == 3) {
        out->has_first = true;
        memcpy(out->first, first, sizeof out->first);
    }
    free(first);
    return count == 3 ? EXIT_DONE : fail_usage(arguments->command, "--first: expected three numbers");
}

static int run(const cli_arguments *arguments) {
    bat_frame_options options;
    int failed = parameters_check(arguments);
    if (!failed) failed = read_options(arguments, &options);
    if (failed) return failed;
    bat_curve *curve = NULL;
    failed = read_curve(arguments->operands[0], &curve);
    if (failed) return failed;
    double *u = NULL, holonomy = 0;
    size_t count = 0;
    failed = parameters_read(arguments, curve, &u, &count);
    if (!failed) {
        bat_frame3 *frames = malloc(count * sizeof *frames);
        bat_status status = frames ? bat_frames(curve, count, u, &options, frames, &holonomy) : BAT_MEMORY;
        if (status == BAT_OK)
            failed = print(curve, frames, count, holonomy);
        else
            failed = status == BAT_MEMORY
                         ? fail_memory()
                         : fail_data(arguments->operands[0], NULL, "%s", bat_status_message(status));
        free(frames);
        free(u);
    }
    bat_curve_free(curve);
    return failed;
}

const cli_command command_frames = {
    .name = "frames",
    .usage = "CURVE (--at U,U,... | --samples N) [--kind rmf|frenet|fixed] [--first SX,SY,SZ] [--substeps N]",
    .summary = "Frames along a curve, rotation-minimising or other.",
    .details = "The result is {\"u\", \"points\", \"t\", \"s\", \"r\"}; vectors have three numbers. Closed "
               "curves add\n"
               "\"holonomy\": the angle, signed about t(0), by which s comes round, before it is spread.",
    .example = "batten frames path.json --samples 100 --kind rmf",
    .operands = 1,
    .options = {{"--at", "U,U,...", "parameters, in any order; of a closed curve in any period"},
                {"--samples", "N", "N parameters spread evenly over the domain"},
                {"--kind", "KIND", "rmf (the default), frenet or fixed"},
                {"--first", "SX,SY,SZ", "s at the start, projected on the normal plane there"},
                {"--substeps", "N", "steps of the chain a span; at least 8 by default"}},
    .lines = true,
    .run = run,
};
