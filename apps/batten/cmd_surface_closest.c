/* batten surface closest: the closest point of a surface. */
#include "program.h"
#include "results.h"
#include "surfaces.h"

static int run(const cli_arguments *arguments) {
    double point[3];
    if (!arguments_value(arguments, "--point")) return fail_usage(arguments->command, "--point is needed");
    int failed = arguments_vector(arguments, "--point", 3, point);
    if (failed) return failed;
    bat_surface *surface = NULL;
    failed = read_surface(arguments->operands[0], &surface);
    if (failed) return failed;
    bat_surface_point near;
    bat_status status = bat_surface_nearest(surface, point, &near);
    bat_surface_free(surface);
    if (status == BAT_MEMORY) return fail_memory();
    if (status != BAT_OK)
        return fail_data(arguments->operands[0], "--point", "%s", bat_status_message(status));
    bat_text text = {0};
    put_surface_point(&text, &near);
    return write_text(&text);
}

const cli_command command_surface_closest = {
    .name = "surface closest",
    .usage = "SURFACE --point X,Y,Z",
    .summary = "The point of a surface that is closest to a point.",
    .details = "The result is {\"u\", \"v\", \"distance\", \"point\"}.",
    .example = "batten surface closest sheet.json --point 3,4,5",
    .operands = 1,
    .options = {{"--point", "X,Y,Z", "the point"}},
    .run = run,
};
