/* batten surface levels: surfaces taken apart into levels, made louder or softer, and their detail carried over. */
#include "program.h"
#include "results.h"

#include <batten/format.h>
#include <batten/relief.h>
#include <stdlib.h>
#include <string.h>

/* What is wanted. */
typedef struct request {
    long apart, level; /* level -1: all */
    long coarsest[2];  /* 0: half at each level */
    double gains[BAT_RELIEF_LEVELS + 1];
    bool scaled[BAT_RELIEF_LEVELS + 1];
} request;

static int request_of(const cli_arguments *arguments, request *w) {
    *w = (request){.level = -1};
    int failed = arguments_integer(arguments, "--decompose", 1, BAT_RELIEF_LEVELS, &w->apart);
    if (!failed) failed = arguments_product(arguments, "--coarsest", BAT_POINTS_MAX, w->coarsest);
    if (!failed) failed = arguments_integer(arguments, "--level", 0, BAT_RELIEF_LEVELS, &w->level);
    if (!failed && w->coarsest[0] && !w->apart)
        failed = fail_usage(arguments->command, "--coarsest: needs --decompose");
    const char *onto = arguments_value(arguments, "--onto");
    if (!failed && onto && strcmp(onto, "-") == 0 && strcmp(arguments->operands[0], "-") == 0)
        failed = fail_usage(arguments->command, "only one of IN and --onto can be standard input");
    return failed ? failed : arguments_gains(arguments, "--gain", BAT_RELIEF_LEVELS, w->gains, w->scaled);
}

/* Replaces the relief by what a call made of it. */
static int adopt(const char *name, bat_status status, bat_relief *made, bat_relief **relief) {
    if (status == BAT_MEMORY) return fail_memory();
    if (status != BAT_OK) return fail_data(name, NULL, "%s", bat_status_message(status));
    bat_relief_free(*relief);
    *relief = made;
    return EXIT_DONE;
}

static int take_apart(const char *name, const request *w, bat_relief **relief) {
    const bat_surface *finest = bat_relief_surface(*relief, bat_relief_levels(*relief));
    const size_t coarsest[2] = {(size_t)w->coarsest[0], (size_t)w->coarsest[1]};
    bat_relief *made = NULL;
    const bat_status status = w->coarsest[0] ? bat_relief_decompose_to(finest, (int)w->apart, coarsest, &made)
                                             : bat_relief_decompose(finest, (int)w->apart, &made);
    if (status == BAT_COUNT)
        return fail_data(name, "knots", "expected enough inner knots for %ld levels, found too few",
                         w->apart);
    return adopt(name, status, made, relief);
}

static int scale(const char *name, const request *w, bat_relief *relief) {
    for (int l = 1; l <= BAT_RELIEF_LEVELS; l++) {
        if (!w->scaled[l]) continue;
        if (l > bat_relief_levels(relief))
            return fail_data(name, "levels", "expected level %d, found %d levels", l,
                             bat_relief_levels(relief));
        const bat_status status = bat_relief_set_gain(relief, l, w->gains[l]);
        if (status == BAT_MEMORY) return fail_memory();
        if (status != BAT_OK) return fail_data(name, NULL, "%s", bat_status_message(status));
    }
    return EXIT_DONE;
}

/* Over the base of what the file holds. */
static int carry(const char *name, bat_relief **relief) {
    bat_relief *target = NULL, *made = NULL;
    int failed = read_relief(name, &target);
    if (failed) return failed;
    const bat_status status = bat_relief_copy_levels(*relief, bat_relief_surface(target, 0), &made);
    bat_relief_free(target);
    return adopt(name, status, made, relief);
}

static int print(const char *name, const request *w, const bat_relief *relief) {
    bat_text text = {0};
    char *bytes = NULL;
    size_t size = 0;
    if (w->level > bat_relief_levels(relief))
        return fail_data(name, "levels", "expected level %ld, found %d levels", w->level,
                         bat_relief_levels(relief));
    if (w->level >= 0) return write_surface(bat_relief_surface(relief, (int)w->level), NULL);
    if (bat_relief_write(relief, &bytes, &size) != BAT_OK) return fail_memory();
    bat_text_add(&text, bytes, size - 1); /* write_text adds the line end */
    bat_free(bytes);
    return write_text(&text);
}

static int run(const cli_arguments *arguments) {
    const char *name = arguments->operands[0], *onto = arguments_value(arguments, "--onto");
    request w;
    bat_relief *relief = NULL;
    int failed = request_of(arguments, &w);
    if (!failed) failed = read_relief(name, &relief);
    if (!failed && w.apart) failed = take_apart(name, &w, &relief);
    if (!failed) failed = scale(name, &w, relief);
    if (!failed && onto) failed = carry(onto, &relief);
    if (!failed) failed = print(name, &w, relief);
    bat_relief_free(relief);
    return failed;
}

const cli_command command_surface_levels = {
    .name = "surface levels",
    .usage = "IN [--decompose N] [--coarsest NxM] [--gain J=G,...] [--onto SURFACE] [--level J]",
    .summary = "Takes a surface apart into levels, scales them, carries them over.",
    .details =
        "IN is a SURFACE or a RELIEF, a base surface and levels of detail in the frames below. What is\n"
        "asked for is done in this order; the result is a RELIEF, with --level a SURFACE.",
    .example = "batten surface levels jug.json --decompose 2 --gain 2=1.5 > relief.json",
    .operands = 1,
    .options = {{"--decompose", "N", "takes the surface apart into N levels, exactly"},
                {"--coarsest", "NxM", "control points of the base; by default half at each level"},
                {"--gain", "J=G,...", "multiplies the detail of level J by G, within 1e6; 0: none"},
                {"--onto", "SURFACE", "carries the levels over to this surface (of a RELIEF its base)"},
                {"--level", "J", "prints the surface of level J alone; 0 is the base"}},
    .run = run,
};
