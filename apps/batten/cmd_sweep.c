/* batten sweep: a profile moved along a path. */
#include "program.h"
#include "results.h"

#include <batten/sweep.h>
#include <batten/format_space.h>
#include <math.h>
#include <stdlib.h>

enum { SAMPLES_MOST = 4096 };

typedef struct request {
    double *places; /* u, v; NULL: a surface is wanted */
    size_t count;
    long samples[2]; /* or so many */
    double tolerance;
} request;

static int read_request(const cli_arguments *arguments, request *out) {
    *out = (request){.places = NULL};
    const bool at = arguments_value(arguments, "--at"), spread = arguments_value(arguments, "--samples"),
               tolerance = arguments_value(arguments, "--tolerance");
    if (at + spread + tolerance > 1)
        return fail_usage(arguments->command, "only one of --at, --samples and --tolerance is possible");
    int failed = arguments_number(arguments, "--tolerance", 1e-30, 1e30, &out->tolerance);
    if (!failed) failed = arguments_product(arguments, "--samples", SAMPLES_MOST, out->samples);
    if (!failed && at) failed = arguments_places(arguments, "--at", 2, &out->places, &out->count);
    return failed;
}

static bat_status read_source(const char *data, size_t size, void *out, bat_problem *problem) {
    return bat_sweep_read(data, size, out, problem);
}

/* count parameters over a domain, ends included; of a closed direction the end excluded. */
static double spread_at(const double *domain, bool closed, long count, long i) {
    const long steps = closed ? count : count - 1;
    return i == steps ? domain[1]
                      : domain[0] + (domain[1] - domain[0]) * (steps > 0 ? (double)i / (double)steps : 0);
}

/* Turns --samples into places. */
static int spread(const bat_sweep_source *source, request *r) {
    double u[2], v[2];
    if (r->samples[0] == 0) return EXIT_DONE;
    r->count = (size_t)r->samples[0] * (size_t)r->samples[1];
    r->places = malloc(2 * r->count * sizeof *r->places);
    if (!r->places) return fail_memory();
    bat_curve_domain(source->path, u), bat_curve_domain(source->profile, v);
    for (long i = 0; i < r->samples[0]; i++)
        for (long j = 0; j < r->samples[1]; j++) {
            double *place = r->places + 2 * (i * r->samples[1] + j);
            place[0] = spread_at(u, bat_curve_is_closed(source->path), r->samples[0], i);
            place[1] = spread_at(v, bat_curve_is_closed(source->profile), r->samples[1], j);
        }
    return EXIT_DONE;
}

static int print_places(const bat_sweep *sweep, const request *r) {
    enum { STRIDE = sizeof(bat_sweep_point) / sizeof(double) };
    bat_text text = {0};
    bat_sweep_point *at = malloc(r->count * sizeof *at);
    if (!at) return fail_memory();
    for (size_t i = 0; i < r->count; i++) bat_sweep_at(sweep, r->places[2 * i], r->places[2 * i + 1], &at[i]);
    bat_text_string(&text, "{\"uv\":");
    put_points(&text, r->places, r->count, 2, 2);
    bat_text_string(&text, ",\n\"points\":");
    put_points(&text, at[0].point, r->count, 3, STRIDE);
    bat_text_string(&text, ",\n\"normals\":[");
    for (size_t i = 0; i < r->count; i++) {
        const double *n = at[i].normal;
        if (i > 0) bat_text_string(&text, ",");
        if (n[0] == 0 && n[1] == 0 && n[2] == 0)
            bat_text_string(&text, "null");
        else
            put_numbers(&text, n, 3);
    }
    bat_text_string(&text, "],\n\"factor\":[");
    for (size_t i = 0; i < r->count; i++) {
        if (i > 0) bat_text_string(&text, ",");
        bat_text_number(&text, at[i].factor);
    }
    bat_text_string(&text, "]}");
    free(at);
    return write_text(&text);
}

static int put_folds(bat_text *text, const bat_sweep *sweep) {
    size_t count = 0;
    if (bat_sweep_folds(sweep, 0, NULL, &count) != BAT_OK) return fail_memory();
    double *folds = malloc((2 * count + 1) * sizeof *folds);
    if (!folds || bat_sweep_folds(sweep, count, folds, &count) != BAT_OK) {
        free(folds);
        return fail_memory();
    }
    put_points(text, folds, count, 2, 2);
    free(folds);
    return EXIT_DONE;
}

static int print_surface(const char *file, const bat_sweep *sweep, double tolerance) {
    bat_surface *made = NULL;
    bat_sweep_report report;
    const bat_status status = bat_sweep_surface(sweep, tolerance, &made, &report);
    if (status == BAT_MEMORY) return fail_memory();
    if (status != BAT_OK)
        return fail_data(file, NULL, "expected a sweep that a surface follows within %g, found none: %s",
                         tolerance, bat_status_message(status));
    bat_text text = {0};
    bat_text_string(&text, "{\"max_error\":");
    bat_text_number(&text, report.max_error);
    bat_text_string(&text, ",\"folds\":");
    int failed = put_folds(&text, sweep);
    bat_text_string(&text, ",\"holonomy\":");
    bat_text_number(&text, bat_sweep_holonomy(sweep));
    bat_text_string(&text, report.seam ? ",\"seam\":true}" : ",\"seam\":false}");
    if (!failed)
        failed = write_surface(made, &text);
    else
        bat_text_free(&text);
    bat_surface_free(made);
    return failed;
}

static int fail_sweep(const char *file, bat_status status) {
    switch (status) {
    case BAT_MEMORY: return fail_memory();
    case BAT_UNSUPPORTED:
        return fail_data(
            file, "path",
            "expected corners between straight stretches (and no Frenet frames), found another corner");
    case BAT_SINGULAR:
        return fail_data(file, "path", "expected a path with a length, found one that stays in place");
    default: return fail_data(file, NULL, "%s", bat_status_message(status));
    }
}

static int run(const cli_arguments *arguments) {
    const char *file = arguments->operands[0];
    request r;
    bat_sweep_source source = {.path = NULL};
    bat_problem problem;
    int failed = read_request(arguments, &r);
    if (failed) return failed;
    failed = read_data(file, read_source, &source, &problem);
    if (!failed) failed = spread(&source, &r);
    if (!failed) {
        bat_sweep *sweep = NULL;
        const bat_status status = bat_sweep_create(source.path, source.profile, &source.options, &sweep);
        const double tolerance = r.tolerance > 0 ? r.tolerance : 1e-4 * bat_curve_size(source.path);
        failed = status != BAT_OK ? fail_sweep(file, status)
                 : r.places       ? print_places(sweep, &r)
                                  : print_surface(file, sweep, tolerance);
        bat_sweep_free(sweep);
    }
    bat_sweep_source_clear(&source);
    free(r.places);
    return failed;
}

const cli_command command_sweep = {
    .name = "sweep",
    .usage = "SWEEP (--at U,V;U,V;... | --samples NxM | [--tolerance T])",
    .summary = "A profile moved along a path: a surface, or places on it.",
    .details = "SWEEP names path, profile, frame, twist and scale. The result is a SURFACE with a "
               "\"report\", or with "
               "places what\n"
               "the sweep is there: points, normals, and a factor that is below 0 where it is folded over.",
    .example = "batten sweep pipe.json --tolerance 0.01 > surface.json",
    .operands = 1,
    .options = {{"--at", "U,V;U,V;...", "places in parameters"},
                {"--samples", "NxM", "N times M places spread evenly over the domain, u slowest"},
                {"--tolerance", "T", "distance from the exact sweep; 1e-4 of the path's size by default"}},
    .run = run,
};
