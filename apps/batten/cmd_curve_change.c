/* batten curve split, join, reverse, elevate, insert. */
#include "curves.h"

#include <batten/format.h>
#include <batten/refine.h>

#include <stdlib.h>

/* Closed curves are opened at the first place, so that they come as two when there are two places; open ones are cut at
 * one. */
static int split(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    (void)b;
    double at;
    const int failed = arguments_vector(arguments, "--at", 1, &at);
    if (failed) return failed;
    bat_curve *parts[2] = {NULL};
    if (bat_curve_is_closed(a))
        return fail_data(arguments->operands[0], "closed",
                         "expected an open curve, which can be cut in two, found a closed one");
    const bat_status status = bat_curve_split(a, at, &parts[0], &parts[1]);
    if (status == BAT_PARAMETER)
        return fail_data(arguments->operands[0], "--at", "expected a parameter inside the domain, found %g",
                         at);
    if (status != BAT_OK) return fail_curve(arguments, status);
    const int written = write_curves(2, parts, NULL);
    bat_curve_free(parts[0]), bat_curve_free(parts[1]);
    return written;
}

static int join(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    static const char *const words[] = {"C0", "C1", "C2"};
    int continuity = 0;
    double gap = 1e-6 * size_of_both(a, b);
    int failed = arguments_choice(arguments, "--continuity", words, 3, &continuity);
    if (!failed) failed = arguments_number(arguments, "--gap", 0, BAT_COORDINATE_MAX, &gap);
    if (failed) return failed;
    for (int i = 0; i < 2; i++)
        if (bat_curve_is_closed(i ? b : a))
            return fail_data(arguments->operands[i], "closed", "expected an open curve, found a closed one");
    bat_curve *made = NULL;
    const bat_status status = bat_curve_join(a, b, continuity, gap, &made, NULL);
    if (status == BAT_ARGUMENT)
        return fail_data(arguments->operands[1], NULL,
                         "expected to begin within %g of where the other ends, found otherwise", gap);
    return write_made(arguments, status, made);
}

static int reverse(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    (void)b;
    bat_curve *made = NULL;
    const bat_status status = bat_curve_reverse(a, &made);
    return write_made(arguments, status, made);
}

static int elevate(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    (void)b;
    long degree = 0;
    const int failed = arguments_integer(arguments, "--degree", 1, BAT_DEGREE_MAX, &degree);
    if (failed) return failed;
    if (degree < bat_curve_degree(a))
        return fail_data(arguments->operands[0], "degree", "expected %ld at most, found %d", degree,
                         bat_curve_degree(a));
    bat_curve *made = NULL;
    const bat_status status = bat_curve_elevate(a, (int)degree, &made);
    return write_made(arguments, status, made);
}

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int insert(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    (void)b;
    double *knots;
    size_t count;
    const int failed = arguments_numbers(arguments, "--at", &knots, &count);
    if (failed) return failed;
    qsort(knots, count, sizeof *knots, ascending);
    bat_curve *made = NULL;
    const bat_status status = bat_curve_insert_knots(a, (int)count, knots, &made);
    free(knots);
    if (status == BAT_PARAMETER)
        return fail_data(arguments->operands[0], "--at", "expected parameters in the domain, found others");
    if (status == BAT_KNOTS)
        return fail_data(arguments->operands[0], "--at",
                         "expected no knot more often than the degree, found one");
    return write_made(arguments, status, made);
}

static int needs(const cli_arguments *arguments, const char *name, curve_work *work) {
    if (!arguments_value(arguments, name)) return fail_usage(arguments->command, "%s is needed", name);
    return with_curves(arguments, work);
}

static int run_split(const cli_arguments *arguments) { return needs(arguments, "--at", split); }
static int run_join(const cli_arguments *arguments) { return with_curves(arguments, join); }
static int run_reverse(const cli_arguments *arguments) { return with_curves(arguments, reverse); }
static int run_elevate(const cli_arguments *arguments) { return needs(arguments, "--degree", elevate); }
static int run_insert(const cli_arguments *arguments) { return needs(arguments, "--at", insert); }

const cli_command command_curve_split = {
    .name = "curve split",
    .usage = "CURVE --at U",
    .summary = "Cuts an open curve in two.",
    .details = "The result is an array of two CURVEs, which keep their parameters.",
    .example = "batten curve split curve.json --at 0.5",
    .operands = 1,
    .options = {{"--at", "U", "a parameter inside the domain"}},
    .lines = true,
    .run = run_split,
};

const cli_command command_curve_join = {
    .name = "curve join",
    .usage = "CURVE CURVE [--continuity C0|C1|C2] [--gap G]",
    .summary = "One curve from two that follow each other.",
    .details = "The second begins where the first ends; degrees are raised to the greater. With -o the "
               "result takes the "
               "place of\nthe first in its drawing, where everything else stays, the second curve, too.",
    .example = "batten curve join first.json second.json --continuity C2",
    .operands = 2,
    .options = {{"--continuity", "C0|C1|C2",
                 "C0, by default: only the ends move; C1, C2: smooth, points next to them move, too"},
                {"--gap", "G", "how far apart the ends may be, a millionth of the size by default"}},
    .puts_back = true,
    .run = run_join,
};

const cli_command command_curve_reverse = {
    .name = "curve reverse",
    .usage = "CURVE",
    .summary = "The same curve, run the other way.",
    .example = "batten curve reverse curve.json",
    .operands = 1,
    .lines = true,
    .puts_back = true,
    .run = run_reverse,
};

const cli_command command_curve_elevate = {
    .name = "curve elevate",
    .usage = "CURVE --degree P",
    .summary = "The same curve, with a higher degree.",
    .example = "batten curve elevate curve.json --degree 5",
    .operands = 1,
    .options = {{"--degree", "P", "the degree of the result, up to 7"}},
    .lines = true,
    .puts_back = true,
    .run = run_elevate,
};

const cli_command command_curve_insert = {
    .name = "curve insert",
    .usage = "CURVE --at U,U,...",
    .summary = "The same curve, with more knots.",
    .example = "batten curve insert curve.json --at 0.5,0.5,1.25",
    .operands = 1,
    .options = {{"--at", "U,U,...", "the new knots, in any order; one may be given several times"}},
    .lines = true,
    .puts_back = true,
    .run = run_insert,
};
