/* batten tangents: a G1 spline through points, with the directions asked for. */
#include "io.h"
#include "program.h"
#include "results.h"

#include "format/json/curve.h"
#include "format/json/spline.h"

#include <batten/bezier.h>
#include <batten/tangents.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int print(const bat_curve *curve, const bat_joint *joints, int count, const double *bezier,
                 int segments) {
    int dimension = bat_curve_dimension(curve);
    bat_text body = {0}, text = {0};
    bat_curve_to_json(curve, 0, &body);
    char *data;
    size_t size;
    if (bat_text_finish(&body, &data, &size) != BAT_OK) return fail_memory();
    bat_text_add(&text, data, size - 1); /* without the closing brace */
    bat_free(data);
    bat_text_string(&text, ",\n\"k\":[");
    for (int i = 0; i < count; i++) {
        if (i > 0) bat_text_string(&text, ",");
        if (isnan(joints[i].k))
            bat_text_string(&text, "null");
        else
            bat_text_number(&text, joints[i].k);
    }
    bat_text_string(&text, "],\n\"bezier\":[");
    for (int i = 0; i < segments; i++) {
        bat_text_string(&text, i > 0 ? ",\n" : "");
        put_points(&text, bezier + 4 * dimension * i, 4, dimension, (size_t)dimension);
    }
    bat_text_string(&text, "]}");
    return write_text(&text);
}

static int run(const cli_arguments *arguments) {
    static const char *const modes[] = {"faithful", "paper", "even", "round"};
    static const char *const defaults[] = {"centripetal", "uniform", "chordal"};
    int mode = -1, missing = -1;
    int failed = arguments_choice(arguments, "--mode", modes, 4, &mode);
    if (!failed) failed = arguments_choice(arguments, "--default", defaults, 3, &missing);
    char *data;
    size_t size;
    const char *name = arguments->operands[0];
    if (!failed) failed = io_read(name, &data, &size);
    if (failed) return failed;
    bat_spline spline;
    void *block;
    bat_problem problem = {.place = ""};
    bat_tangents_options options = bat_tangents_defaults();
    bat_status status = bat_spline_read_as(data, size, &spline, &block, &options, &problem);
    free(data);
    if (status != BAT_OK) return fail_problem(name, status, &problem);
    if (missing >= 0) options.mode = BAT_TANGENTS_FAITHFUL; /* whose rule it is */
    if (mode >= 0) options.mode = (bat_tangents_mode)mode;
    if (missing >= 0) options.missing = (bat_tangents_default)missing;
    bat_joint *joints = malloc((spline.count + 1) * sizeof *joints);
    double *bezier = NULL;
    int segments = 0;
    bat_curve *curve = NULL;
    status = joints ? bat_tangents(&spline, &options, joints, &segments, &bezier, &curve) : BAT_MEMORY;
    if (status == BAT_OK)
        failed = print(curve, joints, (int)spline.count, bezier, segments);
    else if (status == BAT_MEMORY)
        failed = fail_memory();
    else
        failed = fail_data(name, "points", "%s",
                           status == BAT_COUNT ? "expected two different points at least, found fewer"
                                               : bat_status_message(status));
    bat_curve_free(curve);
    bat_free(bezier);
    free(joints);
    bat_free(block);
    return failed;
}

const cli_command command_tangents = {
    .name = "tangents",
    .usage = "SPLINE [--mode round|faithful|paper|even] [--default centripetal|uniform|chordal]",
    .summary = "A spline through points: G1 in the directions given at them, or of even curvature.",
    .details = "SPLINE is {\"points\", \"tangents\", \"closed\", \"tension\", \"mode\", \"default\"}, all "
               "but points "
               "optional. The\n"
               "result is a CURVE with \"k\" (null where the formula does not apply) and \"bezier\", the "
               "cubic segments.\n"
               "Of even curvature it is quadratic, one segment around each point but the ends.",
    .example = "batten tangents spline.json --default chordal > curve.json",
    .operands = 1,
    .options = {{"--mode", "MODE",
                 "round (the default), faithful (to the paper), paper (within the wedge), even (curvature)"},
                {"--default", "RULE",
                 "where no direction is given: centripetal, uniform or chordal (faithful and paper)"}},
    .run = run,
};
