/* batten surface pick: the parameter line of a surface that a marking means. */
#include "program.h"
#include "results.h"
#include "views.h"

static int pick(const cli_arguments *arguments, const bat_surface *surface, const bat_viewpoint *view) {
    const char *name = arguments->operands[1];
    bat_stroke marking;
    void *block;
    int failed = read_pixels(name, &marking, &block);
    if (failed) return failed;
    bat_surface_pick found;
    bat_status status = bat_surface_pick_line(view, &marking, surface, &found);
    bat_free(block);
    if (status == BAT_MEMORY) return fail_memory();
    if (status == BAT_FAR)
        return fail_data(name, "points", "expected samples on the surface, found none of %zu", marking.count);
    if (status != BAT_OK) return fail_data(name, NULL, "%s", bat_status_message(status));
    bat_text text = {0};
    bat_text_string(&text, found.direction == BAT_U ? "{\"direction\":\"u\",\"value\":"
                                                    : "{\"direction\":\"v\",\"value\":");
    bat_text_number(&text, found.value);
    bat_text_string(&text, found.boundary ? ",\"boundary\":true,\"used\":" : ",\"boundary\":false,\"used\":");
    bat_text_integer(&text, found.used);
    bat_text_string(&text, ",\"dropped\":");
    bat_text_integer(&text, found.dropped);
    bat_text_string(&text, ",\"residuals\":{\"u\":");
    bat_text_number(&text, found.residual[BAT_U]);
    bat_text_string(&text, ",\"v\":");
    bat_text_number(&text, found.residual[BAT_V]);
    bat_text_string(&text, "}}");
    return write_text(&text);
}

static int run(const cli_arguments *arguments) {
    bat_surface *surface = NULL;
    bat_viewpoint view;
    int failed = arguments_one_input(arguments, 3, "the files");
    if (!failed) failed = read_surface(arguments->operands[0], &surface);
    if (!failed) failed = read_view(arguments->operands[2], &view);
    if (!failed) failed = pick(arguments, surface, &view);
    bat_surface_free(surface);
    return failed;
}

const cli_command command_surface_pick = {
    .name = "surface pick",
    .usage = "SURFACE MARKING VIEW",
    .summary = "Finds the parameter line of a surface that a marking means.",
    .details =
        "MARKING is a STROKE in pixels of VIEW. The result is {\"direction\", \"value\", \"boundary\", "
        "\"used\",\n\"dropped\", \"residuals\"}: the line from which the marking deviates less, of those at "
        "constant u and at\nconstant v; within 2 % of an edge the edge. A marking beside the surface is bad "
        "data.",
    .example = "batten surface pick sheet.json marking.json view.json",
    .operands = 3,
    .run = run,
};
