/* batten surface hit: where a ray meets a surface. */
#include "program.h"
#include "results.h"
#include "surfaces.h"

#include <stdlib.h>

static int print(const bat_surface *surface, const double ray[6], size_t count) {
    bat_surface_point *hits = malloc((count + 1) * sizeof *hits);
    if (!hits) return fail_memory();
    bat_text text = {0};
    text.failed = bat_surface_hits(surface, ray, ray + 3, count, hits, &count) != BAT_OK;
    bat_text_string(&text, "{\"hits\":[");
    for (size_t i = 0; i < count; i++) {
        if (i) bat_text_string(&text, ",\n");
        put_surface_point(&text, &hits[i]);
    }
    bat_text_string(&text, "]}");
    free(hits);
    return write_text(&text);
}

static int run(const cli_arguments *arguments) {
    double ray[6];
    if (!arguments_value(arguments, "--ray")) return fail_usage(arguments->command, "--ray is needed");
    int failed = arguments_vector(arguments, "--ray", 6, ray);
    if (failed) return failed;
    if (ray[3] == 0 && ray[4] == 0 && ray[5] == 0)
        return fail_usage(arguments->command, "--ray: expected a direction, found 0,0,0");
    bat_surface *surface = NULL;
    failed = read_surface(arguments->operands[0], &surface);
    if (failed) return failed;
    size_t count = 0;
    bat_status status = bat_surface_hits(surface, ray, ray + 3, 0, NULL, &count);
    if (status == BAT_OK)
        failed = print(surface, ray, count);
    else if (status == BAT_MEMORY)
        failed = fail_memory();
    else
        failed = fail_data(arguments->operands[0], "--ray", "%s", bat_status_message(status));
    bat_surface_free(surface);
    return failed;
}

const cli_command command_surface_hit = {
    .name = "surface hit",
    .usage = "SURFACE --ray OX,OY,OZ,DX,DY,DZ",
    .summary = "Where a ray meets a surface.",
    .details =
        "The result is {\"hits\":[{\"u\", \"v\", \"distance\", \"point\"}, ...]}, from near to far; "
        "distances are "
        "those\nfrom O. A hit on an edge of patches counts once. A ray that misses gives an empty list.",
    .example = "batten surface hit sheet.json --ray 0,0,10,0,0,-1",
    .operands = 1,
    .options = {{"--ray", "OX,OY,OZ,DX,DY,DZ", "where the ray begins, and its direction"}},
    .run = run,
};
