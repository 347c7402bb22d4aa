/* batten eval: points and derivatives. */
#include "program.h"
#include "parameters.h"
#include "results.h"

#include <stdlib.h>

enum { ORDER_MAX = 16 };

static int print(const bat_curve *curve, const double *u, size_t count, int order) {
    int dimension = bat_curve_dimension(curve);
    size_t stride = (size_t)(order + 1) * (size_t)dimension;
    double *values = malloc(count * stride * sizeof *values);
    if (!values) return fail_memory();
    for (size_t i = 0; i < count; i++) bat_curve_eval(curve, u[i], order, values + i * stride);
    bat_text text = {0};
    bat_text_string(&text, "{\"u\":");
    put_numbers(&text, u, count);
    bat_text_string(&text, ",\n\"points\":");
    put_points(&text, values, count, dimension, stride);
    bat_text_string(&text, ",\n\"derivatives\":[");
    for (int k = 1; k <= order; k++) {
        bat_text_string(&text, k > 1 ? ",\n" : "");
        put_points(&text, values + k * dimension, count, dimension, stride);
    }
    bat_text_string(&text, "]}");
    free(values);
    return write_text(&text);
}

static int run(const cli_arguments *arguments) {
    long order = 0;
    int failed = parameters_check(arguments);
    if (!failed) failed = arguments_integer(arguments, "--derivatives", 0, ORDER_MAX, &order);
    if (failed) return failed;
    bat_curve *curve = NULL;
    failed = read_curve(arguments->operands[0], &curve);
    if (failed) return failed;
    double *u = NULL;
    size_t count = 0;
    failed = parameters_read(arguments, curve, &u, &count);
    if (!failed) {
        failed = print(curve, u, count, (int)order);
        free(u);
    }
    bat_curve_free(curve);
    return failed;
}

const cli_command command_eval = {
    .name = "eval",
    .usage = "CURVE (--at U,U,... | --samples N) [--derivatives K]",
    .summary = "Points and derivatives of a curve.",
    .details = "CURVE is a JSON file. The result is {\"u\", \"points\", \"derivatives\"}: "
               "derivatives[k-1][i] is the\n"
               "k-th derivative at u[i].",
    .example = "batten eval curve.json --samples 5 --derivatives 1",
    .operands = 1,
    .options = {{"--at", "U,U,...", "parameters, in any order; of a closed curve in any period"},
                {"--samples", "N", "N parameters spread evenly over the domain"},
                {"--derivatives", "K", "derivatives up to the K-th, 0 by default"}},
    .lines = true,
    .run = run,
};
