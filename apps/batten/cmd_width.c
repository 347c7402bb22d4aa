/* batten width: how wide the strokes of a drawing are along their length. */
#include "drawing.h"
#include "program.h"
#include "widths.h"

#include <batten/paint.h>

/* A stroke in the plane gets the profile, and its width; the rest stays. */
static bat_status widen(bat_document *document, int index, const widths *w) {
    const bat_object *object = bat_document_at(document, index);
    bat_style style = *bat_object_style(object);
    bat_object *wide = NULL, *made = NULL;
    if (!bat_object_is_made_of_curves(object) || !style.stroked ||
        bat_curve_dimension(bat_object_curve(object, 0)) != 2)
        return BAT_OK;
    const bat_paint *before = bat_object_paint(object);
    bat_paint paint = before ? *before : (bat_paint){0};
    paint.width_count = w->count, paint.widths = w->stops;
    style.width = w->width;
    bat_status status = bat_object_with_style(object, &style, &wide);
    if (status == BAT_OK) status = bat_object_with_paint(wide, &paint, &made);
    if (status == BAT_OK) status = bat_document_replace(document, index, made);
    bat_object_release(wide);
    bat_object_release(made);
    return status;
}

static int run(const cli_arguments *arguments) {
    const char *name = arguments->operands[0];
    const bat_svg_options options = bat_svg_merging();
    drawing_file drawing;
    widths w;
    if (!arguments_value(arguments, "--widths")) return fail_usage(arguments->command, "--widths is needed");
    int failed = widths_of(arguments, &w);
    if (!failed) failed = drawing_read(name, &options, &drawing);
    if (failed) return failed;
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(drawing.document) && status == BAT_OK; i++)
        status = widen(drawing.document, i, &w);
    if (status == BAT_MEMORY)
        failed = fail_memory();
    else if (status != BAT_OK)
        failed = fail_data(name, NULL, "%s", bat_status_message(status));
    else
        failed = drawing_put(arguments, &drawing);
    drawing_free(&drawing);
    return failed;
}

const cli_command command_width = {
    .name = "width",
    .usage = "DRAWING --widths S,W[;S,W...]",
    .summary = "A drawing whose strokes are as wide along their length as a list says.",
    .details = "Between the places the width is a monotone cubic. Every stroke in the plane gets it, but for "
               "those with "
               "dashes\nor an uneven pen, which keep it unseen. The result has the format of the input; in "
               "an SVG such a "
               "stroke is a\nfilled path, beside the drawing itself. -o FILE writes it there.",
    .example = "batten width drawing.svg --widths '0,0;0.5,4;1,0' -o brushed.svg",
    .operands = 1,
    .options = {{"--widths", "S,W...",
                 "places from 0 to 1 along the length, and the widths there, document units"}},
    .puts_back = true,
    .run = run,
};
