/* batten coons: a patch between four curves. */
#include "program.h"
#include "results.h"

#include <batten/sweep.h>
#include <math.h>

enum { SIDES = 4 };
static const char *const NAMES[SIDES] = {"C0", "C1", "D0", "D1"};

/* The diagonal of the box around all control points. */
static double size_of(bat_curve *const *sides) {
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int k = 0; k < SIDES; k++) {
        const int dimension = bat_curve_dimension(sides[k]);
        for (size_t i = 0; i < bat_curve_count(sides[k]); i++)
            for (int c = 0; c < 3; c++) {
                const double x = c < dimension ? bat_curve_points(sides[k])[i * (size_t)dimension + (size_t)c]
                                               : 0;
                low[c] = fmin(low[c], x), high[c] = fmax(high[c], x);
            }
    }
    return sqrt((high[0] - low[0]) * (high[0] - low[0]) + (high[1] - low[1]) * (high[1] - low[1]) +
                (high[2] - low[2]) * (high[2] - low[2]));
}

/* Names the first corner whose sides do not meet. */
static int fail_corner(const cli_arguments *arguments, const double *apart, double within) {
    for (int k = 0; k < SIDES; k++) {
        const int u = k % 2, v = k / 2;
        if (apart[k] <= within) continue;
        return fail_data(
            arguments->operands[v], NULL,
            "corner u = %d, v = %d: expected the %s of %s and the %s of %s to meet within %g, found "
            "them %g apart",
            u, v, u ? "end" : "start", NAMES[v], v ? "end" : "start", NAMES[2 + u], within, apart[k]);
    }
    return fail_data(arguments->operands[0], NULL, "%s", bat_status_message(BAT_FAR));
}

static int patch(const cli_arguments *arguments, bat_curve *const *sides, double within) {
    const bat_curve *given[SIDES] = {sides[0], sides[1], sides[2], sides[3]};
    double apart[SIDES];
    bat_surface *made = NULL;
    for (int k = 0; k < SIDES; k++)
        if (bat_curve_is_closed(given[k]))
            return fail_data(arguments->operands[k], "closed", "expected an open curve, found a closed one");
    bat_status status = bat_surface_coons(given, within, &made, apart);
    if (status == BAT_MEMORY) return fail_memory();
    if (status == BAT_FAR) return fail_corner(arguments, apart, within);
    if (status != BAT_OK) return fail_data(arguments->operands[0], NULL, "%s", bat_status_message(status));
    int failed = write_surface(made, NULL);
    bat_surface_free(made);
    return failed;
}

static int run(const cli_arguments *arguments) {
    double tolerance = 0;
    bat_curve *sides[SIDES] = {NULL};
    int failed = arguments_number(arguments, "--tolerance", 1e-30, 1e30, &tolerance);
    if (!failed) failed = arguments_one_input(arguments, SIDES, "the four curves");
    for (int k = 0; k < SIDES && !failed; k++) failed = read_curve(arguments->operands[k], &sides[k]);
    if (!failed) failed = patch(arguments, sides, tolerance > 0 ? tolerance : 1e-6 * size_of(sides));
    for (int k = 0; k < SIDES; k++) bat_curve_free(sides[k]);
    return failed;
}

const cli_command command_coons = {
    .name = "coons",
    .usage = "C0 C1 D0 D1 [--tolerance T]",
    .summary = "The patch between four curves.",
    .details =
        "C0 and C1 run along u at v = 0 and v = 1, D0 and D1 along v at u = 0 and u = 1. The result is a "
        "SURFACE\n"
        "over [0,1] x [0,1], bilinearly blended, exact. Ends that should meet in a corner and do not are bad "
        "data.",
    .example = "batten coons front.json back.json left.json right.json",
    .operands = SIDES,
    .options = {{"--tolerance", "T", "how far apart ends may be in a corner; 1e-6 of the size by default"}},
    .run = run,
};
