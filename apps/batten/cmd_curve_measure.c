/* batten curve length, bounds, curvature. */
#include "curves.h"
#include "parameters.h"

#include <batten/measure.h>

#include <math.h>
#include <stdlib.h>

static int length(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    (void)arguments, (void)b;
    double domain[2];
    bat_curve_domain(a, domain);
    bat_text text = {0};
    bat_text_string(&text, "{\"length\":");
    bat_text_number(&text, bat_curve_length(a, domain[0], domain[1], 1e-14));
    bat_text_string(&text, "}");
    return write_text(&text);
}

static int bounds(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    (void)arguments, (void)b;
    const size_t size = (size_t)bat_curve_dimension(a);
    double low[BAT_DIMENSION_MAX], high[BAT_DIMENSION_MAX];
    bat_curve_bounds(a, low, high);
    bat_text text = {0};
    bat_text_string(&text, "{\"low\":");
    put_numbers(&text, low, size);
    bat_text_string(&text, ",\"high\":");
    put_numbers(&text, high, size);
    bat_text_string(&text, "}");
    return write_text(&text);
}

/* det(C', C'', C''') / |C' x C''|^2; 0 in the plane and where the curve is straight. */
static double torsion(const bat_curve *curve, double u) {
    double d[4 * BAT_DIMENSION_MAX];
    if (bat_curve_dimension(curve) != 3) return 0;
    bat_curve_eval(curve, u, 3, d);
    const double *a = d + 3, *b = d + 6, *c = d + 9;
    const double n[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const double turn = (n[0] * c[0] + n[1] * c[1] + n[2] * c[2]) / square;
    return square > 0 && isfinite(turn) ? turn : 0;
}

static int curvature(const cli_arguments *arguments, const bat_curve *a, const bat_curve *b) {
    (void)b;
    double *u = NULL;
    size_t count = 0;
    const int failed = parameters_read(arguments, a, &u, &count);
    if (failed) return failed;
    double *values = malloc(2 * count * sizeof *values);
    if (!values) {
        free(u);
        return fail_memory();
    }
    for (size_t i = 0; i < count; i++)
        values[i] = bat_curve_curvature(a, u[i]), values[count + i] = torsion(a, u[i]);
    bat_text text = {0};
    bat_text_string(&text, "{\"u\":");
    put_numbers(&text, u, count);
    bat_text_string(&text, ",\n\"curvature\":");
    put_numbers(&text, values, count);
    bat_text_string(&text, ",\n\"torsion\":");
    put_numbers(&text, values + count, count);
    bat_text_string(&text, "}");
    free(u), free(values);
    return write_text(&text);
}

static int run_length(const cli_arguments *arguments) { return with_curves(arguments, length); }
static int run_bounds(const cli_arguments *arguments) { return with_curves(arguments, bounds); }
static int run_curvature(const cli_arguments *arguments) {
    const int failed = parameters_check(arguments);
    return failed ? failed : with_curves(arguments, curvature);
}

const cli_command command_curve_length = {
    .name = "curve length",
    .usage = "CURVE",
    .summary = "The length of a curve.",
    .details = "The result is {\"length\"}, to 14 digits.",
    .example = "batten curve length curve.json",
    .operands = 1,
    .lines = true,
    .run = run_length,
};

const cli_command command_curve_bounds = {
    .name = "curve bounds",
    .usage = "CURVE",
    .summary = "The box around a curve.",
    .details = "The result is {\"low\", \"high\"}: the least and the greatest coordinates of the curve "
               "itself, not of its "
               "control\npoints.",
    .example = "batten curve bounds curve.json",
    .operands = 1,
    .lines = true,
    .run = run_bounds,
};

const cli_command command_curve_curvature = {
    .name = "curve curvature",
    .usage = "CURVE (--at U,U,... | --samples N)",
    .summary = "Curvature and torsion of a curve.",
    .details = "The result is {\"u\", \"curvature\", \"torsion\"}. In the plane the curvature has a sign, "
               "above 0 to the left;\n"
               "torsion is 0 there, and where a curve is straight.",
    .example = "batten curve curvature curve.json --samples 5",
    .operands = 1,
    .options = {{"--at", "U,U,...", "parameters, in any order; of a closed curve in any period"},
                {"--samples", "N", "N parameters spread evenly over the domain"}},
    .lines = true,
    .run = run_curvature,
};
