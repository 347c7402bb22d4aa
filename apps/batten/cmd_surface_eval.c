/* batten surface eval: points, derivatives, normals and curvatures. */
#include "program.h"
#include "results.h"
#include "surfaces.h"

#include <math.h>
#include <stdlib.h>

enum { SAMPLES_MAX = 1 << 24, JET = 18 };

static int samples(const cli_arguments *arguments, long size[2]) {
    int failed = arguments_product(arguments, "--samples", SAMPLES_MAX, size);
    if (failed || size[0] <= SAMPLES_MAX / size[1]) return failed;
    return fail_usage(arguments->command, "--samples: expected %d places at most, found %ldx%ld", SAMPLES_MAX,
                      size[0], size[1]);
}

/* The parameters: those of --at, or a grid with u slowest. */
static int places(const cli_arguments *arguments, const bat_surface *surface, double **uv, size_t *count) {
    int failed = arguments_places(arguments, "--at", 2, uv, count);
    if (failed) return failed;
    for (size_t i = 0; *uv && i < 2 * *count && !failed; i++)
        failed = check_parameter(arguments, "--at", surface, i % 2 ? BAT_V : BAT_U, (*uv)[i]);
    if (failed) free(*uv);
    if (failed || *uv) return failed;
    long size[2] = {1, 1};
    failed = samples(arguments, size);
    if (failed) return failed;
    const size_t m = (size_t)size[0], n = (size_t)size[1];
    *count = m * n;
    *uv = malloc((2 * m * n + m + n) * sizeof **uv);
    if (!*uv) return fail_memory();
    double *u = *uv + 2 * m * n, *v = u + m;
    bat_surface_spread(surface, BAT_U, m, u);
    bat_surface_spread(surface, BAT_V, n, v);
    for (size_t i = 0; i < m * n; i++) (*uv)[2 * i] = u[i / n], (*uv)[2 * i + 1] = v[i % n];
    return EXIT_DONE;
}

static void put_normals(bat_text *text, const bat_surface *surface, const double *uv, size_t count) {
    bat_text_string(text, ",\n\"normals\":[");
    for (size_t i = 0; i < count; i++) {
        double normal[3];
        if (i) bat_text_string(text, ",");
        if (bat_surface_normal(surface, uv[2 * i], uv[2 * i + 1], normal) == BAT_OK)
            put_numbers(text, normal, 3);
        else
            bat_text_string(text, "null");
    }
    bat_text_string(text, "]");
}

/* values: room for 2 * count. */
static void put_curvatures(bat_text *text, const bat_surface *surface, const double *uv, size_t count,
                           double *values) {
    double *gauss = values, *mean = values + count;
    for (size_t i = 0; i < count; i++)
        if (bat_surface_curvature(surface, uv[2 * i], uv[2 * i + 1], &gauss[i], &mean[i]) != BAT_OK)
            gauss[i] = mean[i] = NAN; /* printed as null */
    bat_text_string(text, ",\n\"gauss\":");
    put_numbers(text, gauss, count);
    bat_text_string(text, ",\n\"mean\":");
    put_numbers(text, mean, count);
}

static int print(const cli_arguments *arguments, const bat_surface *surface, const double *uv, size_t count,
                 int order) {
    static const char *const names[] = {"points", "du", "dv", "duu", "duv", "dvv"};
    double *jets = malloc(count * JET * sizeof *jets);
    if (!jets) return fail_memory();
    for (size_t i = 0; i < count; i++)
        bat_surface_eval(surface, uv[2 * i], uv[2 * i + 1], order, jets + i * JET);
    bat_text text = {0};
    bat_text_string(&text, "{\"uv\":");
    put_points(&text, uv, count, 2, 2);
    for (int k = 0; k < (order + 1) * (order + 2) / 2; k++) {
        bat_text_string(&text, ",\n\"");
        bat_text_string(&text, names[k]);
        bat_text_string(&text, "\":");
        put_points(&text, jets + 3 * k, count, 3, JET);
    }
    if (arguments_value(arguments, "--normals")) put_normals(&text, surface, uv, count);
    if (arguments_value(arguments, "--curvature")) put_curvatures(&text, surface, uv, count, jets);
    bat_text_string(&text, "}");
    free(jets);
    return write_text(&text);
}

static int run(const cli_arguments *arguments) {
    long order = 0, size[2] = {1, 1};
    if (!arguments_value(arguments, "--at") == !arguments_value(arguments, "--samples"))
        return fail_usage(arguments->command, "either --at or --samples is needed");
    double *uv;
    size_t count;
    int failed = arguments_integer(arguments, "--derivatives", 0, 2, &order);
    if (!failed) failed = samples(arguments, size);
    if (!failed) failed = arguments_places(arguments, "--at", 2, &uv, &count);
    if (failed) return failed;
    free(uv);
    bat_surface *surface = NULL;
    failed = read_surface(arguments->operands[0], &surface);
    if (failed) return failed;
    failed = places(arguments, surface, &uv, &count);
    if (!failed) {
        failed = print(arguments, surface, uv, count, (int)order);
        free(uv);
    }
    bat_surface_free(surface);
    return failed;
}

const cli_command command_surface_eval = {
    .name = "surface eval",
    .usage = "SURFACE (--at U,V;U,V;... | --samples NxM) [--derivatives 0|1|2] [--normals] [--curvature]",
    .summary = "Points, derivatives, normals and curvatures of a surface.",
    .details =
        "The result is {\"uv\", \"points\"} and, as asked, \"du\", \"dv\", \"duu\", \"duv\", \"dvv\", "
        "\"normals\", \"gauss\",\n\"mean\". A normal is the unit vector of du x dv, and null where that "
        "vanishes; the mean curvature is\npositive where the surface bends towards the normal.",
    .example = "batten surface eval sheet.json --samples 5x3 --normals\nbatten surface eval sheet.json --at "
               "\"0,0;0.5,1\"",
    .operands = 1,
    .options = {{"--at", "U,V;...", "places, in any order; in a closed direction in any period"},
                {"--samples", "NxM", "N times M places spread evenly over the domain, u slowest"},
                {"--derivatives", "0|1|2", "derivatives up to this order, 0 by default"},
                {"--normals", NULL, "the normals, too"},
                {"--curvature", NULL, "Gauss and mean curvature, too"}},
    .run = run,
};
