/* batten motion: a recorded walk with few knots, its levels, its path. */
#include "io.h"
#include "program.h"
#include "results.h"

#include "text/text.h"

#include <batten/bezier.h>
#include <batten/motion.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { LEVELS_MOST = 12 };

typedef struct wanted {
    bat_motion_options options;
    double gains[LEVELS_MOST + 1];
    bool scaled; /* any gain was given */
    bool json;
} wanted;

static bool ends_in(const char *name, const char *ending) {
    const size_t a = strlen(name), b = strlen(ending);
    return a >= b && strcmp(name + a - b, ending) == 0;
}

static int gains_of(const cli_arguments *arguments, wanted *w) {
    bool given[LEVELS_MOST + 1];
    for (int l = 0; l <= LEVELS_MOST; l++) w->gains[l] = 1;
    w->scaled = arguments_value(arguments, "--gain") != NULL;
    return arguments_gains(arguments, "--gain", w->options.levels, w->gains, given);
}

static int wanted_of(const cli_arguments *arguments, wanted *out) {
    const char *file = arguments_value(arguments, "--out"), *path = arguments_value(arguments, "--path");
    double levels = 3;
    *out = (wanted){.options = bat_motion_defaults()};
    out->options.tolerance = 0;
    if (!file) return fail_usage(arguments->command, "--out is needed");
    out->json = ends_in(file, ".json");
    if (!out->json && !ends_in(file, ".bvh"))
        return fail_usage(arguments->command, "--out: expected a file that ends in .bvh or .json, found %s",
                          file);
    if (path && strcmp(path, "-") == 0 && strcmp(arguments->operands[0], "-") == 0)
        return fail_usage(arguments->command, "only one of IN and CURVE can be standard input");
    int failed = arguments_number(arguments, "--tolerance", 1e-9, 180, &out->options.tolerance);
    if (!failed) failed = arguments_number(arguments, "--levels", 0, LEVELS_MOST, &levels);
    if (!failed && levels != (int)levels)
        failed = fail_usage(arguments->command, "--levels: expected a whole number, found %g", levels);
    out->options.levels = (int)levels;
    return failed ? failed : gains_of(arguments, out);
}

static bat_status take_of(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_bvh_read(data, size, out, problem);
}

/* What was measured is said of the fit, before gains and another path. */
static int print(const char *in, const char *file, const wanted *w, const bat_motion *motion,
                 const bat_motion_report *report) {
    char *bytes = NULL;
    size_t size = 0;
    bat_take *frames = NULL;
    bat_status status = w->json ? bat_motion_write(motion, report, &bytes, &size)
                                : bat_motion_sample(motion, &frames);
    if (status == BAT_OK && !w->json) status = bat_bvh_write(frames, &bytes, &size);
    bat_take_free(frames);
    if (status == BAT_MEMORY) return fail_memory();
    if (status != BAT_OK) return fail_data(in, NULL, "%s", bat_status_message(status));
    const int failed = io_write(file, bytes, size);
    bat_free(bytes);
    return failed;
}

static int bend(const char *in, const char *name, bat_motion *motion) {
    bat_curve *path = NULL;
    int failed = read_curve(name, &path);
    if (failed) return failed;
    const bool closed = bat_curve_is_closed(path);
    const bat_status status = closed ? BAT_OK : bat_motion_bend(motion, path);
    bat_curve_free(path);
    if (closed) return fail_data(name, NULL, "expected an open curve, found a closed one");
    if (status == BAT_UNSUPPORTED)
        return fail_data(in, NULL,
                         "expected a root that moves, and turns about three axes, to go along another path");
    if (status == BAT_MEMORY) return fail_memory();
    return status == BAT_OK ? EXIT_DONE : fail_data(name, NULL, "%s", bat_status_message(status));
}

static int run(const cli_arguments *arguments) {
    const char *in = arguments->operands[0], *path = arguments_value(arguments, "--path");
    wanted w;
    bat_take *take = NULL;
    bat_motion *motion = NULL;
    bat_motion_report report;
    bat_problem problem;
    int failed = wanted_of(arguments, &w);
    if (!failed) failed = read_data(in, take_of, &take, &problem);
    if (!failed) {
        const bat_status status = bat_motion_fit(take, &w.options, &motion, &report);
        if (status == BAT_MEMORY)
            failed = fail_memory();
        else if (status != BAT_OK)
            failed = fail_data(in, NULL, "%s", bat_status_message(status));
    }
    for (int l = 1; l <= w.options.levels && !failed && w.scaled; l++)
        bat_motion_set_gain(motion, -1, l, w.gains[l]);
    if (!failed && path) failed = bend(in, path, motion);
    if (!failed) failed = print(in, arguments_value(arguments, "--out"), &w, motion, &report);
    bat_motion_free(motion);
    bat_take_free(take);
    return failed;
}

const cli_command command_motion = {
    .name = "motion",
    .usage = "IN.bvh [--tolerance D] [--levels N] [--gain J=G,...] [--path CURVE] --out OUT.(bvh|json)",
    .summary = "Takes a recorded motion apart into levels: few knots, more or less of a level, another path.",
    .details =
        "Each joint's rotation becomes a spline of quaternions with levels of detail in its own axes, the "
        "place\n"
        "of the root a curve with levels. As BVH the result has the skeleton, channels and frame time of IN.",
    .example = "batten motion walk.bvh --tolerance 0.5 --gain 3=0 --out calm.bvh",
    .operands = 1,
    .options = {{"--tolerance", "D",
                 "degrees that a rotation may be off; without it, every frame is kept exactly"},
                {"--levels", "N", "levels of detail, 0 to 12; 3 by default"},
                {"--gain", "J=G,...",
                 "scales the details of levels, 1 to N from coarse to fine: 0 mutes one"},
                {"--path", "CURVE",
                 "where the root goes instead; its details and the body ride in the curve's frames"},
                {"--out", "OUT.(bvh|json)", "where the result is written"}},
    .run = run,
};
