/* batten fit: a curve through points as they are, or from what a pen meant. */
#include "program.h"
#include "results.h"
#include "sketch_options.h"

#include <batten/interpolate.h>

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- points as they are ---- */

typedef struct points {
    int dimension;
    size_t count;
    double *all;
} points;

static bat_status points_of(const char *data, size_t size, void *out, bat_problem *problem) {
    points *p = out;
    return bat_points_read(data, size, &p->dimension, &p->count, &p->all, problem);
}

static double extent(const points *p) {
    double sum = 0;
    for (int c = 0; c < p->dimension; c++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < p->count; i++) {
            low = fmin(low, p->all[i * (size_t)p->dimension + (size_t)c]);
            high = fmax(high, p->all[i * (size_t)p->dimension + (size_t)c]);
        }
        sum += (high - low) * (high - low);
    }
    return sqrt(sum);
}

/* By how much, in radians, a row of points turns at point i; 0 at the ends, and where a side has no length. */
static double turn_at(const points *p, size_t i) {
    const int m = p->dimension;
    if (i == 0 || i + 1 >= p->count) return 0;
    double aa = 0, bb = 0, ab = 0;
    for (int c = 0; c < m; c++) {
        const double *x = p->all + i * (size_t)m + c, a = x[0] - x[-m], b = x[m] - x[0];
        aa += a * a, bb += b * b, ab += a * b;
    }
    return aa > 0 && bb > 0 ? acos(fmin(fmax(ab / sqrt(aa) / sqrt(bb), -1), 1)) : 0;
}

/* A corner turns by over 30 degrees, and three times as much as the points beside it. */
static int find_corners(const points *p, int **out, size_t *count) {
    *count = 0;
    *out = malloc((p->count + 1) * sizeof **out);
    if (!*out) return fail_memory();
    for (size_t i = 1; i + 1 < p->count; i++) {
        const double turn = turn_at(p, i), beside = fmax(turn_at(p, i - 1), turn_at(p, i + 1));
        if (turn > 0.5236 && turn > 3 * beside) (*out)[(*count)++] = (int)i;
    }
    return EXIT_DONE;
}

/* --corners auto|I,I,... */
static int read_corners(const cli_arguments *arguments, const points *p, int **out, size_t *count) {
    const char *text = arguments_value(arguments, "--corners");
    *out = NULL, *count = 0;
    if (!text) return EXIT_DONE;
    if (strcmp(text, "auto") == 0) return find_corners(p, out, count);
    double *numbers;
    int failed = arguments_numbers(arguments, "--corners", &numbers, count);
    if (failed) return failed;
    *out = calloc(*count + 1, sizeof **out);
    if (!*out) failed = fail_memory();
    for (size_t i = 0; *out && i < *count && !failed; i++) {
        const double least = i ? numbers[i - 1] + 1 : 0;
        if (numbers[i] != floor(numbers[i]) || numbers[i] < least || numbers[i] >= (double)p->count)
            failed = fail_data(arguments->operands[0], "--corners",
                               "expected ascending whole numbers from 0 to %zu, found %g",
                               p->count ? p->count - 1 : 0, numbers[i]);
        else
            (*out)[i] = (int)numbers[i];
    }
    free(numbers);
    return failed;
}

static int write_fit(const bat_curve *curve, const bat_fit_report *report) {
    bat_text text = {0};
    bat_text_string(&text, "{\"max_error\":");
    bat_text_number(&text, report->max_error);
    bat_text_string(&text, ",\"knots_after\":");
    bat_text_integer(&text, (uint64_t)bat_curve_knot_count(curve));
    bat_text_string(&text, ",\"solves\":");
    bat_text_integer(&text, (uint64_t)report->solves);
    bat_text_string(&text, "}");
    return write_curve_reported(curve, &text);
}

static int fit(const char *name, const points *p, const bat_fit_options *options) {
    bat_curve *curve = NULL;
    bat_fit_report report = {0};
    const bat_status status = bat_fit_within(p->dimension, p->count, p->all, options, &curve, &report);
    int failed;
    if (status == BAT_OK && report.max_error <= options->tolerance)
        failed = write_fit(curve, &report);
    else if (status == BAT_OK || status == BAT_TOLERANCE)
        failed = fail_data(name, "points", "expected a fit within %g, the best found reaches %g",
                           options->tolerance, report.max_error);
    else if (status == BAT_COUNT)
        failed = fail_data(name, "points", "expected two different points at least, found fewer");
    else
        failed = status == BAT_MEMORY ? fail_memory()
                                      : fail_data(name, "points", "%s", bat_status_message(status));
    bat_curve_free(curve);
    return failed;
}

static int run_points(const cli_arguments *arguments) {
    bat_fit_options options = bat_fit_defaults();
    long degree = 3;
    double tolerance = 0;
    if (arguments_value(arguments, "--pixel"))
        return fail_usage(arguments->command, "--pixel is for --pen; points are fitted as they are");
    int failed = arguments_integer(arguments, "--degree", 1, BAT_DEGREE_MAX, &degree);
    if (!failed) failed = arguments_number(arguments, "--tolerance", DBL_MIN, BAT_COORDINATE_MAX, &tolerance);
    if (!failed) failed = arguments_number(arguments, "--smooth", 0, BAT_COORDINATE_MAX, &options.smoothing);
    if (failed) return failed;
    options.degree = (int)degree;
    options.closed = arguments_value(arguments, "--closed");
    options.hold_ends = !options.closed && !arguments_value(arguments, "--free-ends");
    points p = {0};
    bat_problem problem;
    failed = read_data(arguments->operands[0], points_of, &p, &problem);
    if (failed) return failed;
    const double size = extent(&p);
    options.tolerance = tolerance > 0 ? tolerance : size > 0 ? 1e-3 * size : 1;
    int *corners;
    failed = read_corners(arguments, &p, &corners, &options.corner_count);
    options.corners = corners;
    if (!failed) failed = fit(arguments->operands[0], &p, &options);
    free(corners);
    bat_free(p.all);
    return failed;
}

/* ---- a pen's stroke ---- */

/* The greatest distance of a sample from the curve, as it was drawn, hooks and all. */
static bat_status raw_error(const bat_curve *curve, const bat_stroke *stroke, double *out) {
    bat_finder *finder;
    const bat_status status = bat_finder_create(curve, &finder);
    if (status != BAT_OK) return status;
    *out = 0;
    for (size_t i = 0; i < stroke->count; i++) {
        bat_near near;
        bat_finder_nearest(finder, stroke->points + i * (size_t)stroke->dimension, &near);
        *out = fmax(*out, near.distance);
    }
    bat_finder_free(finder);
    return BAT_OK;
}

static int run_pen(const cli_arguments *arguments) {
    static const char *const others[] = {"--smooth", "--corners", "--free-ends"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (arguments_value(arguments, others[i]))
            return fail_usage(arguments->command, "%s is for points as they are, not for --pen", others[i]);
    const char *name = arguments->operands[0];
    bat_sketch_options options;
    int failed = sketch_options(arguments, &options);
    long degree = options.degree;
    if (!failed) failed = arguments_integer(arguments, "--degree", 3, BAT_DEGREE_MAX, &degree);
    if (failed) return failed;
    options.degree = (int)degree;
    bat_stroke stroke;
    void *block = NULL;
    failed = read_stroke(name, &stroke, &block);
    if (failed) return failed;
    bat_curve *curve = NULL;
    bat_sketch_report report = {0};
    const bool closed = arguments_value(arguments, "--closed");
    double raw = 0;
    bat_status status = bat_sketch_new(&stroke, closed, &options, &curve, &report);
    if (status == BAT_OK) status = raw_error(curve, &stroke, &raw);
    failed = status == BAT_OK ? write_pen(curve, &report, raw) : fail_sketch(name, status, &report, &options);
    bat_curve_free(curve);
    bat_free(block);
    return failed;
}

static int run(const cli_arguments *arguments) {
    return arguments_value(arguments, "--pen") ? run_pen(arguments) : run_points(arguments);
}

const cli_command command_fit = {
    .name = "fit",
    .usage =
        "POINTS [--pen] [--tolerance T] [--degree P] [--smooth W] [--corners C] [--closed] [--free-ends]",
    .summary = "A new curve from points, or from a stroke.",
    .details = "POINTS is JSON ({\"points\"}, or a GeoJSON LineString) or columns of numbers, with a header "
               "or without. The\n"
               "result is a CURVE with a \"report\": no point is further from it than \"max_error\", at most "
               "T. With --pen\n"
               "the points are a stroke, {\"points\", \"pressure\", \"time\"} or x,y[,pressure][,time], "
               "which is cleaned first:\n"
               "\"raw_error\" says how far the samples are that were left out, too.",
    .example = "batten fit --pen stroke.csv --tolerance 0.5 > curve.json\nbatten fit track.csv --tolerance "
               "0.1 --corners auto",
    .operands = 1,
    .options = {{"--tolerance", "T",
                 "greatest distance, document units; 1/1000 of the size by default, with --pen 1 pixel"},
                {"--degree", "P", "3 by default; 1 to 7, with --pen 3 to 7; the curve is C^(P - 1)"},
                {"--smooth", "W", "no bend is shorter than W, document units"},
                {"--corners", "C",
                 "I,I,...: which points are corners of the curve, from 0; auto: those that turn sharply"},
                {"--closed", NULL, "closed, even when the ends do not meet"},
                {"--free-ends", NULL, "the ends of an open curve need not be those of the points"},
                {"--pen", NULL, "the points are what a pen drew: hooks and noise are no part of it"},
                {"--pixel", "P", "with --pen: a pen pixel in document units, 1 by default"}},
    .lines = true,
    .run = run,
};
