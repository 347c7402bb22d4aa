/* batten simplify: a curve, or every curve of a drawing, with few points. */
#include "address.h"
#include "drawing.h"
#include "io.h"
#include "program.h"
#include "progress.h"
#include "results.h"

#include <batten/bezier.h>
#include <batten/fit.h>
#include <batten/measure.h>
#include <batten/document.h>

#include <math.h>

static const double SHARE = 1e-3;  /* of the size: the tolerance when none is given */
static const double CORNER = 0.05; /* radians: larger turns stay corners, as in the editor */

/* What joins the spans of a result. */
enum continuity { C2, G1, EXTREMES };
static const char *const words[] = {"C2", "G1", "extremes"};

typedef struct tally {
    int continuity;
    double tolerance, grid, max_error;
    uint64_t before, after; /* control points */
} tally;

static const bat_curve *curve_of(const bat_document *document, int object, int index) {
    return bat_object_curve(bat_document_at(document, object), index);
}

/* The longest side of the box around all curves. */
static double size_of(const bat_document *document) {
    double low[BAT_DIMENSION_MAX] = {INFINITY, INFINITY, INFINITY}, high[BAT_DIMENSION_MAX], side = 0;
    for (int c = 0; c < BAT_DIMENSION_MAX; c++) high[c] = -low[c];
    for (int i = 0; i < bat_document_count(document); i++)
        for (int k = 0; k < bat_object_curve_count(bat_document_at(document, i)); k++) {
            const bat_curve *curve = curve_of(document, i, k);
            double from[BAT_DIMENSION_MAX], to[BAT_DIMENSION_MAX];
            bat_curve_bounds(curve, from, to);
            for (int c = 0; c < bat_curve_dimension(curve); c++)
                low[c] = fmin(low[c], from[c]), high[c] = fmax(high[c], to[c]);
        }
    for (int c = 0; c < BAT_DIMENSION_MAX; c++) side = fmax(side, high[c] - low[c]);
    return side;
}

static bat_status refit(const bat_curve *curve, const tally *sum, bat_curve **out, double *error) {
    if (sum->continuity == EXTREMES)
        return bat_curve_refit_extremes(curve, sum->tolerance, CORNER, sum->grid, out, error);
    return (sum->continuity == G1 ? bat_curve_refit_g1 : bat_curve_refit)(curve, sum->tolerance, CORNER, out,
                                                                          error);
}

/* Whether the curve has fewer points, or, for G1, fewer cubics: a curve of a degree above 3 has become cubics. On extremes
 * it is another. */
static bool is_simpler(const bat_curve *curve, const bat_curve *than, int continuity) {
    if (continuity == EXTREMES) return true;
    return continuity == G1 && (bat_curve_degree(curve) != bat_curve_degree(than) ||
                                bat_curve_segment_count(curve) != bat_curve_segment_count(than))
               ? true
               : bat_curve_count(curve) < bat_curve_count(than);
}

/* Replaces one curve by what is simpler. What is generated from other data, a spline or levels, becomes a
 * path by this. */
static bat_status simplify_curve(bat_document *document, int object, int index, tally *sum) {
    const bat_curve *curve = curve_of(document, object, index);
    const uint64_t before = (uint64_t)bat_curve_count(curve);
    bat_curve *fewer = NULL;
    double error = 0;
    bat_status status = refit(curve, sum, &fewer, &error);
    if (status == BAT_DIMENSION || status == BAT_COUNT) { /* in space, or smaller than the grid: it stays */
        sum->before += before, sum->after += before;
        return BAT_OK;
    }
    if (status != BAT_OK) return status;
    const uint64_t after = (uint64_t)bat_curve_count(fewer);
    sum->before += before;
    if (!is_simpler(fewer, curve, sum->continuity)) {
        bat_curve_free(fewer);
        sum->after += before;
        return BAT_OK;
    }
    sum->after += after;
    sum->max_error = fmax(sum->max_error, error);
    bat_object *simpler = NULL;
    status = bat_object_with_curve(bat_document_at(document, object), index, fewer, &simpler);
    if (status == BAT_OK) status = bat_document_replace(document, object, simpler);
    bat_object_release(simpler);
    return status;
}

static bat_status simplify_all(bat_document *document, tally *sum) {
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        if (!bat_object_is_made_of_curves(bat_document_at(document, i))) continue;
        for (int k = 0; k < bat_object_curve_count(bat_document_at(document, i)) && status == BAT_OK; k++)
            status = simplify_curve(document, i, k, sum);
    }
    return status;
}

static bat_text report_of(const tally *sum) {
    bat_text text = {0};
    bat_text_string(&text, "{\"max_error\":");
    bat_text_number(&text, sum->max_error);
    bat_text_string(&text, ",\"points_before\":");
    bat_text_integer(&text, sum->before);
    bat_text_string(&text, ",\"points_after\":");
    bat_text_integer(&text, sum->after);
    bat_text_string(&text, "}");
    return text;
}

/* A CURVE holds its report; a drawing has no place for one. */
static int print(const cli_arguments *arguments, const drawing_file *drawing, const tally *sum) {
    bat_text report = report_of(sum);
    if (!drawing->format->keeps && drawing_curve_count(drawing->document) == 1 &&
        drawing->format == bat_format_named("json"))
        return write_curve_reported(curve_of(drawing->document, 0, 0), &report);
    char *line = NULL;
    size_t size;
    if (bat_text_finish(&report, &line, &size) != BAT_OK) return fail_memory();
    const int failed = drawing_put(arguments, drawing);
    if (!failed) remark("{\"report\":%s}", line);
    bat_free(line);
    return failed;
}

static int run(const cli_arguments *arguments) {
    const char *name = arguments->operands[0];
    const bat_svg_options options = bat_svg_merging();
    drawing_file drawing;
    tally sum = {.tolerance = -1};
    int failed = arguments_number(arguments, "--tolerance", 0, 1e30, &sum.tolerance);
    if (!failed) failed = arguments_choice(arguments, "--continuity", words, 3, &sum.continuity);
    if (!failed) failed = arguments_number(arguments, "--grid", 0, 1e30, &sum.grid);
    if (!failed && sum.continuity == EXTREMES && sum.tolerance == 0)
        failed = fail_usage(arguments->command, "--tolerance must be above 0 with --continuity extremes");
    if (!failed && sum.grid > 0 && sum.continuity != EXTREMES)
        failed = fail_usage(arguments->command, "--grid needs --continuity extremes");
    if (!failed)
        failed = is_address(name) ? address_read_drawing(name, &drawing)
                                  : drawing_read(name, &options, &drawing);
    if (failed) return failed;
    if (sum.tolerance < 0) sum.tolerance = SHARE * size_of(drawing.document);
    progress_begin("simplify");
    bat_status status = simplify_all(drawing.document, &sum);
    progress_end();
    if (status == BAT_MEMORY)
        failed = fail_memory();
    else if (status != BAT_OK)
        failed = fail_data(name, NULL, "%s", bat_status_message(status));
    else
        failed = print(arguments, &drawing, &sum);
    drawing_free(&drawing);
    return failed;
}

const cli_command command_simplify = {
    .name = "simplify",
    .usage = "CURVE|DRAWING [--tolerance T] [--continuity C2|G1|extremes] [--grid G]",
    .summary = "A curve, or every curve of a drawing, with as few points as keep it within a tolerance.",
    .details = "Corners and ends stay. The result has the format of the input. A CURVE gets a \"report\":\n"
               "\"max_error\", \"points_before\", \"points_after\"; of a drawing the report is a line on "
               "standard error.\n-o FILE writes a whole drawing there, too.\n"
               "Cubics that meet with one tangent (G1) are for path editors; those that meet where a planar "
               "curve turns\n"
               "back, with level and upright handles (extremes), are for fonts.",
    .example = "batten simplify drawing.svg --tolerance 0.1 > simple.svg\n"
               "batten simplify curve.json > few.json",
    .operands = 1,
    .options =
        {{"--tolerance", "T",
          "in units of the drawing, 1/1000 of its longer side by default; 0: only what changes nothing"},
         {"--continuity", "C2|G1|extremes",
          "C2, by default: fewest points; G1: fewest cubics; extremes: cubics as fonts have"},
         {"--grid", "G", "with extremes: all points are multiples of it; 1: whole numbers"}},
    .lines = true,
    .puts_back = true,
    .run = run,
};
