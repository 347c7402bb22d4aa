/* batten levels: shapes made of sweep and detail levels, edited and decomposed. */
#include "program.h"
#include "results.h"

#include "format/json/curve.h"
#include "format/json/shape.h"

#include <batten/levels.h>

#include <string.h>

static int print(const bat_shape *shape) {
    bat_text text = {0};
    bat_text_string(&text, "{\"shape\":");
    bat_shape_to_json(shape, &text);
    bat_text_string(&text, ",\n\"curves\":[");
    for (int l = 0; l <= bat_shape_levels(shape); l++) {
        bat_text_string(&text, l > 0 ? ",\n" : "\n");
        bat_curve_to_json(bat_shape_curve(shape, l), 1, &text);
    }
    bat_text_string(&text, "]}");
    return write_text(&text);
}

static int decompose(const cli_arguments *arguments, int levels) {
    const char *name = arguments->operands[0];
    bat_curve *curve = NULL;
    bat_shape *shape;
    int failed = read_curve(name, &curve);
    if (failed) return failed;
    bat_status status = bat_shape_decompose(curve, levels, NULL, &shape);
    bat_curve_free(curve);
    if (status == BAT_MEMORY) return fail_memory();
    if (status == BAT_COUNT)
        return fail_data(name, "knots", "expected enough interior knots for %d levels, found too few",
                         levels);
    if (status != BAT_OK) return fail_data(name, NULL, "%s", bat_status_message(status));
    failed = print(shape);
    bat_shape_free(shape);
    return failed;
}

static bat_status shape_of(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_shape_read(data, size, out, problem);
}

static bat_status edited(const char *data, size_t size, void *shape, bat_problem *problem) {
    return bat_shape_edit(shape, data, size, problem);
}

static int edit(const char *name, bat_shape *shape) {
    bat_problem problem;
    int failed = read_data(name, edited, shape, &problem);
    if (!failed && problem.message[0])
        remark("%s: %s: %s", strcmp(name, "-") ? name : "standard input", problem.place, problem.message);
    return failed;
}

static int run(const cli_arguments *arguments) {
    long levels = 0;
    int failed = arguments_integer(arguments, "--decompose", 0, BAT_LEVELS_MAX, &levels);
    if (failed) return failed;
    if (arguments_value(arguments, "--decompose")) {
        if (arguments->operands[1])
            return fail_usage(arguments->command, "--decompose takes one CURVE and no EDITS");
        return decompose(arguments, (int)levels);
    }
    bat_shape *shape = NULL;
    bat_problem problem;
    failed = read_data(arguments->operands[0], shape_of, &shape, &problem);
    if (failed) return failed;
    if (arguments->operands[1]) failed = edit(arguments->operands[1], shape);
    if (!failed) failed = print(shape);
    bat_shape_free(shape);
    return failed;
}

const cli_command command_levels = {
    .name = "levels",
    .usage = "SHAPE [EDITS] | --decompose N CURVE",
    .summary = "Edits sweep and detail apart, or takes a curve apart into them.",
    .details =
        "SHAPE is a base curve and levels of detail in the frames below. The result is {\"shape\", "
        "\"curves\"}:\n"
        "the shape after the edits, and the curves of all its levels, base first. EDITS is a list such as\n"
        "[{\"type\":\"drag\", \"level\":0, \"u\":0.5, \"delta\":[0,-40]}]; docs/levels.md has all kinds.",
    .example = "batten levels --decompose 3 outline.json > shape.json",
    .operands = 1,
    .more = 1,
    .options = {{"--decompose", "N", "takes CURVE apart into N levels, exactly"}},
    .lines = true,
    .run = run,
};
