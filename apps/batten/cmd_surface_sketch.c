/* batten surface sketch: a parameter line is redrawn by a stroke in the pixels of a view, and the surface comes along. */
#include "program.h"
#include "results.h"
#include "surfaces.h"
#include "views.h"

#include "text/number.h"

#include <math.h>
#include <stdlib.h>

/* Says why the stroke redraws nothing. */
static int fail_stroke(const cli_arguments *arguments, bat_status status, const bat_surface *surface,
                       const bat_surface_sketch_options *options, const wish *w,
                       const bat_surface_sketch_report *report) {
    const char *name = arguments->operands[1];
    const size_t all = report->landed + report->dropped;
    const bat_sketch_options hand = {.tolerance = options->tolerance > 0 ? options->tolerance
                                                                         : 1e-4 * bat_surface_size(surface)};
    const bat_sketch_report drawn = {.max_error = report->max_error};
    if (status == BAT_FAR && (3 * report->dropped > all || report->landed == 0))
        return fail_data(name, "points", "expected at most a third of the samples dropped, found %zu of %zu",
                         report->dropped, all);
    if (status == BAT_DOT && report->landed > 0) return fail_sketch(name, status, &drawn, &hand);
    if (status == BAT_TOLERANCE || (status == BAT_FAR && report->redraw.gain == 0))
        return fail_sketch(name, status, &drawn, &hand);
    return fail_redraw(arguments, status, surface, w, &report->redraw);
}

static int sketch(const cli_arguments *arguments, const bat_surface *surface, const bat_viewpoint *view,
                  bat_surface_sketch_options *options, const wish *w) {
    bat_stroke stroke;
    void *block;
    int failed = read_pixels(arguments->operands[1], &stroke, &block);
    if (failed) return failed;
    bat_surface *made = NULL;
    bat_surface_sketch_report report = {.landed = 0};
    double *weights = malloc(bat_surface_count(surface, w->direction) * sizeof *weights);
    options->redraw = &w->options;
    bat_status status = weights ? bat_surface_sketch(surface, w->direction, w->at, view, &stroke, options,
                                                     &made, weights, &report)
                                : BAT_MEMORY;
    bat_free(block);
    if (status == BAT_OK) {
        bat_text text = {0};
        if (report.turned)
            remark("batten surface sketch: the ruled surface runs across the gaze, along %.4g,%.4g,%.4g",
                   report.along[0], report.along[1], report.along[2]);
        put_redraw_report(&text, made, w, &report.redraw, weights);
        failed = write_surface(made, &text);
    } else {
        failed = fail_stroke(arguments, status, surface, options, w, &report);
    }
    free(weights);
    bat_surface_free(made);
    return failed;
}

static int read_options(const cli_arguments *arguments, bat_surface_sketch_options *out) {
    *out = bat_surface_sketch_defaults();
    int failed = arguments_vector(arguments, "--along", 3, out->along);
    if (!failed && arguments_value(arguments, "--along") && out->along[0] == 0 && out->along[1] == 0 &&
        out->along[2] == 0)
        failed = fail_usage(arguments->command, "--along: expected a direction other than 0");
    if (!failed) failed = arguments_number(arguments, "--tolerance", 1e-30, 1e30, &out->tolerance);
    return failed;
}

static int run(const cli_arguments *arguments) {
    wish w = {.hold = NULL};
    bat_surface_sketch_options options;
    bat_surface *surface = NULL;
    bat_viewpoint view;
    int failed = read_wish(arguments, &w);
    if (!failed) failed = read_options(arguments, &options);
    if (!failed) failed = arguments_one_input(arguments, 3, "the files");
    if (!failed) failed = read_surface(arguments->operands[0], &surface);
    if (!failed) failed = check_line(arguments, surface, w.direction, w.at);
    if (!failed) failed = read_view(arguments->operands[2], &view);
    if (!failed) failed = sketch(arguments, surface, &view, &options, &w);
    bat_surface_free(surface);
    free(w.hold);
    return failed;
}

const cli_command command_surface_sketch = {
    .name = "surface sketch",
    .usage = "SURFACE STROKE VIEW (--u U | --v V) [--along D] [--reach R] [--hold I,...] [--tolerance T]",
    .summary = "Redraws a parameter line of a surface with a stroke; the surface comes along.",
    .details =
        "STROKE is in pixels of VIEW. It is cast on the ruled surface of the line, the line is redrawn as by "
        "sketch,\nand the surface follows as by surface redraw. The result is a SURFACE with a \"report\". A "
        "stroke of which\nmore than a third cannot be cast is bad data.",
    .example = "batten surface sketch sheet.json stroke.json view.json --u 0.5",
    .operands = 3,
    .options = {OPTION_U,
                OPTION_V,
                {"--along", "X,Y,Z", "direction of the ruled surface; the surface's normal by default"},
                OPTION_REACH,
                OPTION_HOLD,
                {"--tolerance", "T",
                 "greatest distance from the stroke; 1e-4 of the surface's size by default"}},
    .run = run,
};
