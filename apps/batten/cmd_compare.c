/* batten compare: how far the shapes of a file are from a reference. */
#include "compared.h"
#include "document/scale.h"
#include "results.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const char *kind_of(const compared_thing *thing) {
    if (thing->mesh) return bat_polymesh_face_count(thing->mesh) ? "mesh" : "points";
    return thing->surface ? "surface" : "curve";
}

/* Of what the extent is the number, the length or the area. */
static int dimension_of(const compared_thing *thing) {
    if (thing->mesh) return bat_polymesh_face_count(thing->mesh) ? 2 : 0;
    return thing->surface ? 2 : 1;
}

static bat_status measure(const compared_thing *thing, const bat_reference *reference, double spacing,
                          bat_deviation *out) {
    if (thing->curve) return bat_curve_deviation(thing->curve, reference, spacing, out);
    if (thing->surface) return bat_surface_deviation(thing->surface, reference, spacing, out);
    return bat_polymesh_deviation(thing->mesh, reference, spacing, out);
}

/* The greatest of all; mean and rms over what has an area, without any over what has a length, else over points. */
static bat_deviation of_all(const compared *a, const bat_deviation *each) {
    int most = 0;
    bat_deviation all = {.greatest = -1};
    for (size_t i = 0; i < a->count; i++)
        if (dimension_of(a->things + i) > most) most = dimension_of(a->things + i);
    for (size_t i = 0; i < a->count; i++) {
        const double extent = dimension_of(a->things + i) == most ? each[i].extent : 0;
        const double before = all.mean, square = all.rms;
        const size_t samples = all.samples + each[i].samples;
        const double spacing = fmax(all.spacing, each[i].spacing), whole = all.extent + extent;
        if (each[i].greatest > all.greatest) all = each[i];
        all.mean = before + extent * each[i].mean, all.rms = square + extent * each[i].rms * each[i].rms;
        all.extent = whole, all.samples = samples, all.spacing = spacing;
    }
    if (all.extent > 0) all.mean /= all.extent, all.rms = sqrt(all.rms / all.extent);
    return all;
}

/* ---- results ---- */

static void put_member(bat_text *text, const char *name, double value) {
    bat_text_string(text, name);
    bat_text_number(text, value);
}

static void put_deviation(bat_text *text, const bat_deviation *d) {
    put_member(text, "\"greatest\":", d->greatest);
    put_member(text, ",\"mean\":", d->mean);
    put_member(text, ",\"rms\":", d->rms);
    bat_text_string(text, ",\"at\":");
    put_numbers(text, d->at, 3);
    bat_text_string(text, ",\"to\":");
    put_numbers(text, d->to, 3);
    put_member(text, ",\"spacing\":", d->spacing);
}

static int print_json(const compared *a, const bat_deviation *each, const bat_deviation *all) {
    bat_text text = {0};
    bat_text_string(&text, "{");
    put_deviation(&text, all);
    if (a->scale > 0) {
        bat_text_string(&text, ",\"unit\":");
        bat_text_json_string(&text, bat_unit_name(a->unit));
        put_member(&text, ",\"scale\":", a->scale);
    }
    bat_text_string(&text, ",\n\"objects\":[");
    for (size_t i = 0; i < a->count; i++) {
        bat_text_string(&text, i ? ",\n{" : "\n{");
        if (a->things[i].id) {
            bat_text_string(&text, "\"id\":");
            bat_text_integer(&text, a->things[i].id);
            bat_text_string(&text, ",\"name\":");
            bat_text_json_string(&text, a->things[i].name);
            bat_text_string(&text, ",");
        }
        bat_text_string(&text, "\"kind\":\"");
        bat_text_string(&text, kind_of(a->things + i));
        bat_text_string(&text, "\",");
        put_deviation(&text, each + i);
        bat_text_string(&text, "}");
    }
    bat_text_string(&text, "]}");
    return write_text(&text);
}

/* One line, in the unit that the document says. */
static void put_line(bat_text *text, const compared *a, const char *name, const char *kind,
                     const bat_deviation *d) {
    const double unit = a->scale > 0 ? a->scale / bat_unit_millimetres(a->unit) : 1;
    const char *called = a->scale > 0 ? bat_unit_name(a->unit) : "", *blank = *called ? " " : "";
    char line[400];
    snprintf(line, sizeof line, "greatest %.6g%s%s, mean %.6g, rms %.6g, at (%.6g, %.6g, %.6g)",
             unit * d->greatest, blank, called, unit * d->mean, unit * d->rms, unit * d->at[0],
             unit * d->at[1], unit * d->at[2]);
    bat_text_string(text, name);
    if (*name) bat_text_string(text, ", ");
    bat_text_string(text, kind);
    bat_text_string(text, ": ");
    bat_text_string(text, line);
}

static int print_lines(const compared *a, const bat_deviation *each, const bat_deviation *all) {
    bat_text text = {0};
    for (size_t i = 0; i < a->count && a->count > 1; i++) {
        put_line(&text, a, a->things[i].name, kind_of(a->things + i), each + i);
        bat_text_string(&text, "\n");
    }
    put_line(&text, a, "", "all", all);
    return write_text(&text);
}

/* ---- the command ---- */

static int compare(const cli_arguments *arguments, const compared *a, const compared *b, double spacing) {
    bat_reference *reference = NULL;
    bat_deviation *each = calloc(a->count, sizeof *each);
    bat_status status = each ? compared_reference(b, &reference) : BAT_MEMORY;
    for (size_t i = 0; i < a->count && status == BAT_OK; i++)
        status = measure(a->things + i, reference, spacing, each + i);
    int failed = EXIT_DONE;
    if (status == BAT_MEMORY)
        failed = fail_memory();
    else if (status == BAT_COUNT)
        failed = fail_data(arguments->operands[0], "--spacing",
                           "expected a spacing that gives at most 2^24 samples of each object, found %g",
                           spacing);
    else if (status != BAT_OK)
        failed = fail_data(arguments->operands[0], NULL, "%s", bat_status_message(status));
    if (!failed && each) {
        const bat_deviation all = of_all(a, each);
        failed = arguments_value(arguments, "--json") ? print_json(a, each, &all)
                                                      : print_lines(a, each, &all);
    }
    bat_reference_free(reference);
    free(each);
    return failed;
}

static int run(const cli_arguments *arguments) {
    double spacing = 0;
    compared a, b;
    int failed = arguments_one_input(arguments, 2, "A and B");
    if (!failed) failed = arguments_number(arguments, "--spacing", 0, BAT_COORDINATE_MAX, &spacing);
    if (!failed) failed = compared_read(arguments->operands[0], &a);
    if (failed) return failed;
    failed = compared_read(arguments->operands[1], &b);
    if (!failed) {
        failed = compared_align(&a, &b);
        if (!failed) failed = compare(arguments, &a, &b, spacing);
        compared_clear(&b);
    }
    compared_clear(&a);
    return failed;
}

const cli_command command_compare = {
    .name = "compare",
    .usage = "A B [--spacing S] [--json]",
    .summary = "How far the curves, surfaces and meshes of A are from the reference B.",
    .details =
        "A and B are drawings, models (.stl, .3mf, .glb, .gltf, .ply, .obj, .step, .iges), SURFACEs, MESHes "
        "and "
        "CURVEs as\n"
        ".json, or FILE#NAME, an object of a drawing; a MESH without faces is points. For each object of A, "
        "and for all:\n"
        "the greatest distance from B and where, the mean and the root of the mean square, over area, over "
        "length where\n"
        "there is none, or over points; in A's unit. B is scaled to it, and a model stands as A's page does. "
        "The greatest\n"
        "distance is that of a point, and below the true one by at most the spacing. With --json: "
        "{\"greatest\", \"mean\", \"rms\",\n"
        "\"at\", \"to\", \"spacing\", \"unit\", \"scale\", \"objects\"}, in units of A's document, of which "
        "one "
        "is scale millimetres.",
    .example = "batten compare scan.batten#hull hull.step --json",
    .operands = 2,
    .options = {{"--spacing", "S",
                 "how far samples are apart at most, in A's units; 1/32 of each object by default"},
                {"--json", NULL, "as JSON"}},
    .run = run,
};
