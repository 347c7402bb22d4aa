/* batten surface intersect: the curves in which two surfaces meet. */
#include "program.h"
#include "results.h"

#include <batten/format.h>
#include <batten/measure.h>
#include <batten/trace.h>
#include <math.h>
#include <stdlib.h>

enum { SAMPLES = 6, TRIES = 4 }; /* per control point; of finer fits */

typedef struct meeting {
    bat_surface *side[2];
    bat_surface_finder *finder[2];
    double tolerance;
} meeting;

/* The diagonal of the box of all control points. */
static double size_of(const meeting *m) {
    double low[2][3], high[2][3], size = 0;
    for (int k = 0; k < 2; k++) bat_surface_box(m->side[k], low[k], high[k]);
    for (int c = 0; c < 3; c++) size = hypot(size, fmax(high[0][c], high[1][c]) - fmin(low[0][c], low[1][c]));
    return size;
}

/* The greatest distance of samples of the curve from both surfaces. */
static bat_status measure(const meeting *m, const bat_curve *curve, double *error) {
    const size_t count = SAMPLES * bat_curve_count(curve);
    double domain[2], p[3];
    bat_surface_point near;
    bat_curve_domain(curve, domain);
    for (size_t i = 0; i <= count; i++) {
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * (double)i / (double)count, 0, p);
        for (int k = 0; k < 2; k++) {
            bat_status status = bat_surface_finder_nearest(m->finder[k], p, &near);
            if (status != BAT_OK) return status;
            *error = fmax(*error, near.distance);
        }
    }
    return BAT_OK;
}

/* Fits a track, more finely while the curve is too far from the surfaces. */
static bat_status fit(const meeting *m, const bat_tracks *tracks, size_t i, bat_curve **out, double *error) {
    double tolerance = 0.5 * m->tolerance;
    bat_status status = BAT_OK;
    *out = NULL;
    for (int k = 0; k < TRIES; k++, tolerance *= 0.3) {
        bat_curve_free(*out);
        *out = NULL, *error = 0;
        status = bat_tracks_curve(tracks, i, tolerance, out);
        if (status == BAT_TOLERANCE) status = BAT_OK; /* the error that is reported says so */
        if (status == BAT_OK) status = measure(m, *out, error);
        if (status != BAT_OK || *error <= m->tolerance) break;
    }
    return status;
}

static void put_curve(bat_text *text, const bat_curve *curve) {
    char *data = NULL;
    size_t size;
    if (bat_curve_write(curve, &data, &size) != BAT_OK)
        text->failed = true;
    else
        bat_text_add(text, data, size);
    bat_free(data);
}

static bat_status print(const meeting *m, const bat_tracks *tracks, bat_text *text) {
    double most = 0;
    bat_status status = BAT_OK;
    bat_text_string(text, "{\"curves\":[");
    for (size_t i = 0; i < bat_tracks_count(tracks) && status == BAT_OK; i++) {
        bat_curve *curve = NULL;
        double error = 0;
        status = fit(m, tracks, i, &curve, &error);
        if (i) bat_text_string(text, ",\n");
        if (status == BAT_OK) put_curve(text, curve);
        most = fmax(most, error);
        bat_curve_free(curve);
    }
    bat_text_string(text, "],\n\"tangential\":[");
    for (size_t i = 0; i < bat_tracks_crossing_count(tracks); i++) {
        if (i) bat_text_string(text, ",");
        put_numbers(text, bat_tracks_crossing(tracks, i)->point, 3);
    }
    bat_text_string(text, "],\n\"report\":{\"max_error\":");
    bat_text_number(text, most);
    bat_text_string(text, "}}");
    return status;
}

static int intersect(const cli_arguments *arguments, const meeting *m) {
    bat_intersect_options options = bat_intersect_defaults();
    bat_tracks *tracks = NULL;
    bat_text text = {0};
    options.tolerance = m->tolerance;
    options.chord = 0.05 * m->tolerance;
    bat_status status = bat_surface_intersect(m->side[0], m->side[1], &options, &tracks);
    if (status == BAT_OK) status = print(m, tracks, &text);
    int failed = EXIT_DONE;
    if (status == BAT_OK) {
        const bool given_up = bat_tracks_is_given_up(tracks);
        failed = write_text(&text);
        if (!failed && given_up)
            remark("%s: it touches the other surface along a curve; \"tangential\" has points of it, not all "
                   "of it",
                   arguments->operands[0]);
    } else {
        bat_text_free(&text);
        failed = status == BAT_MEMORY
                     ? fail_memory()
                     : fail_data(arguments->operands[0], NULL, "%s", bat_status_message(status));
    }
    bat_tracks_free(tracks);
    return failed;
}

static int run(const cli_arguments *arguments) {
    meeting m = {.tolerance = 0};
    int failed = arguments_number(arguments, "--tolerance", 1e-30, 1e30, &m.tolerance);
    if (!failed) failed = arguments_one_input(arguments, 2, "the surfaces");
    for (int k = 0; k < 2 && !failed; k++) failed = read_surface(arguments->operands[k], &m.side[k]);
    for (int k = 0; k < 2 && !failed; k++)
        if (bat_surface_finder_create(m.side[k], &m.finder[k]) != BAT_OK) failed = fail_memory();
    if (!failed && !(m.tolerance > 0)) m.tolerance = 1e-4 * size_of(&m);
    if (!failed) failed = intersect(arguments, &m);
    for (int k = 0; k < 2; k++) {
        bat_surface_finder_free(m.finder[k]);
        bat_surface_free(m.side[k]);
    }
    return failed;
}

const cli_command command_surface_intersect = {
    .name = "surface intersect",
    .usage = "A B [--tolerance T]",
    .summary = "The curves in which two surfaces meet.",
    .details = "A and B are SURFACEs. The result is {\"curves\":[CURVE, ...], \"tangential\":[[x,y,z], ...], "
               "\"report\":{\"max_error\"}}:\ncurves within T of both surfaces, loops closed; \"tangential\" "
               "has the "
               "places where the surfaces touch\nand where curves cross, at which curves end. No contact "
               "gives empty "
               "lists.",
    .example = "batten surface intersect jug.json sheet.json --tolerance 0.01",
    .operands = 2,
    .options = {{"--tolerance", "T", "greatest distance from the surfaces; 1e-4 of their size by default"}},
    .run = run,
};
