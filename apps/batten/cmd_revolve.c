/* batten revolve: a surface of revolution. */
#include "program.h"
#include "results.h"

#include <batten/sweep.h>

static const double RADIANS = 0.017453292519943295769; /* of a degree */

typedef struct turn {
    double axis[6], angle, tolerance;
} turn;

/* Reports what cannot be revolved. */
static int fail_revolve(const char *file, const turn *t, bat_status status) {
    switch (status) {
    case BAT_MEMORY: return fail_memory();
    case BAT_SINGULAR:
        return fail_data(file, "points", "expected a profile beside the axis, found it all on the axis");
    case BAT_COUNT:
        return fail_data(file, NULL, "a tolerance of %g takes more than %d points", t->tolerance,
                         BAT_POINTS_MAX);
    default: return fail_data(file, NULL, "%s", bat_status_message(status));
    }
}

static int run(const cli_arguments *arguments) {
    turn t = {.angle = 360};
    if (!arguments_value(arguments, "--axis")) return fail_usage(arguments->command, "--axis is needed");
    int failed = arguments_vector(arguments, "--axis", 6, t.axis);
    if (!failed) failed = arguments_number(arguments, "--angle", -360, 360, &t.angle);
    if (!failed) failed = arguments_number(arguments, "--tolerance", 1e-30, 1e30, &t.tolerance);
    if (failed) return failed;
    if (t.axis[3] == 0 && t.axis[4] == 0 && t.axis[5] == 0)
        return fail_usage(arguments->command, "--axis: its direction is zero");
    if (t.angle == 0) return fail_usage(arguments->command, "--angle: expected a turn, found 0");
    bat_curve *profile = NULL;
    bat_surface *made = NULL;
    failed = read_curve(arguments->operands[0], &profile);
    if (failed) return failed;
    if (!(t.tolerance > 0)) t.tolerance = 1e-4 * bat_curve_size(profile);
    double max_error = 0;
    bat_status status = bat_surface_revolve(profile, t.axis, t.axis + 3, t.angle * RADIANS, t.tolerance,
                                            &made, &max_error);
    bat_curve_free(profile);
    if (status != BAT_OK) return fail_revolve(arguments->operands[0], &t, status);
    bat_text report = {0};
    bat_text_string(&report, "{\"max_error\":");
    bat_text_number(&report, max_error);
    bat_text_string(&report, "}");
    failed = write_surface(made, &report);
    bat_surface_free(made);
    return failed;
}

const cli_command command_revolve = {
    .name = "revolve",
    .usage = "PROFILE --axis PX,PY,PZ,DX,DY,DZ [--angle A] [--tolerance T]",
    .summary = "The surface that a curve makes when it turns about an axis.",
    .details =
        "The result is a SURFACE with a \"report\", within the tolerance at every place: u in 0 to 1 is "
        "the fraction\n"
        "of the angle, from the profile on, and v the profile's parameter. A full turn is closed in u.",
    .example = "batten revolve jug.json --axis 0,0,0,0,0,1 --angle 270",
    .operands = 1,
    .options = {{"--axis", "PX,PY,PZ,DX,DY,DZ", "a point on the axis, and its direction"},
                {"--angle", "A",
                 "degrees, -360 to 360, by the right hand about the direction; 360 by default"},
                {"--tolerance", "T",
                 "distance from the exact surface; 1e-4 of the profile's size by default"}},
    .run = run,
};
