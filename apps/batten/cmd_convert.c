/* batten convert: from one format to another. */
#include "drawing.h"
#include "folder.h"
#include "io.h"
#include "model_file.h"
#include "picture.h"
#include "program.h"
#include "strokes.h"

#include "format/model/drawn.h"

#include <stdlib.h>
#include <string.h>

#define OPTION_TRIANGLES "--triangles"

enum { TEMPLATE_ROOM = 1024 };

/* The format of OUT: from --to, else from its name. *page: PDF or EPS, which are pictures; then *out is NULL. */
static int output_format(const cli_arguments *arguments, const bat_format **out, picture_kind *page) {
    const char *to = arguments_value(arguments, "--to"), *name = arguments->operands[1];
    char words[BAT_FORMATS_WORDS];
    *out = to ? bat_format_named(to) : drawing_format(name);
    *page = *out ? PICTURE_UNKNOWN : to ? picture_kind_of(to) : picture_kind_called(name);
    if (*page == PICTURE_PDF || *page == PICTURE_EPS) return EXIT_DONE;
    if (to && !*out) return fail_usage(arguments->command, "--to: no such format: %s", to);
    if (*out) return EXIT_DONE;
    if (strcmp(name, "-") == 0) return fail_usage(arguments->command, "for standard output, --to is needed");
    bat_formats_words(".", false, words);
    return fail_usage(arguments->command,
                      "%s: expected a name that ends in .pdf, .eps, .usda, .step, .iges, %s", name, words);
}

/* Lines of a template: "\\n" between them. */
static void unfold(const char *words, char out[TEMPLATE_ROOM]) {
    size_t size = 0;
    for (; *words && size < TEMPLATE_ROOM - 1; words++) {
        const bool end = words[0] == '\\' && words[1] == 'n';
        out[size++] = end ? '\n' : *words;
        words += end;
    }
    out[size] = '\0';
}

static int gcode(const cli_arguments *arguments, const bat_document *document, char **text, size_t *size) {
    bat_gcode_options options = bat_gcode_defaults();
    const char *up = arguments_value(arguments, "--up"), *down = arguments_value(arguments, "--down");
    char lines[2][TEMPLATE_ROOM];
    int failed = arguments_number(arguments, "--arcs", 1e-9, 1e30, &options.tolerance);
    if (!failed) failed = arguments_number(arguments, "--feed", 1e-3, 1e9, &options.feed);
    if (failed) return failed;
    if (up) unfold(up, lines[0]), options.up = lines[0];
    if (down) unfold(down, lines[1]), options.down = lines[1];
    const bat_status status = bat_gcode_write(document, &options, text, size);
    if (status == BAT_ARGUMENT)
        return fail_usage(arguments->command, "--up, --down: expected at most 1000 characters of ASCII");
    if (status == BAT_OK) return EXIT_DONE;
    return drawing_print(document, bat_format_named("gcode"), arguments->operands[0], text, size);
}

static int dxf(const cli_arguments *arguments, const bat_document *document, char **text, size_t *size) {
    double arcs = 0;
    const int failed = arguments_number(arguments, "--arcs", 1e-9, 1e30, &arcs);
    if (failed) return failed;
    const bat_status status = bat_dxf_write(document, arcs, text, size);
    if (status == BAT_OK) return EXIT_DONE;
    return fail_data(arguments->operands[0], NULL, "%s",
                     status == BAT_COUNT ? "expected a curve, found none" : bat_status_message(status));
}

/* SVG, rounded as asked, with our data or without. */
static int svg(const cli_arguments *arguments, const bat_document *document, char **text, size_t *size) {
    double precision = BAT_SVG_UNSEEN;
    const int failed = arguments_number(arguments, "--precision", 0, 1e30, &precision);
    if (failed) return failed;
    const bool plain = arguments_value(arguments, "--plain") != NULL;
    const drawing_writing how = {arguments->operands[0], arguments->operands[1],
                                 arguments_value(arguments, OPTION_LOSSY) != NULL};
    return drawing_print_svg(document, !plain, precision, &how, text, size);
}

/* The text of a glyph in a file, if that is what it holds; else NULL. */
static char *load_glyph(const char *name, size_t *size) {
    char *text = NULL;
    io_stamp stamp;
    drawing_file drawing;
    bat_problem problem;
    if (io_load(name, &text, size, &stamp) != IO_DONE || !text) return NULL;
    if (drawing_parse(text, *size, bat_format_named("glif"), NULL, &drawing, &problem) == BAT_OK) {
        drawing_free(&drawing);
        return text;
    }
    free(text);
    return NULL;
}

/* Where a glyph is already, only its contours are new. */
static int glif(const cli_arguments *arguments, const bat_document *document, char **text, size_t *size) {
    const bool extremes = arguments_value(arguments, "--extremes") != NULL;
    size_t old_size;
    char *old = load_glyph(arguments->operands[1], &old_size);
    bat_status status = old ? bat_glif_replace(old, old_size, document, extremes, text, size, NULL)
                            : BAT_SYNTAX;
    free(old);
    if (status == BAT_SYNTAX) status = bat_glif_write(document, extremes, text, size);
    return status == BAT_OK
               ? EXIT_DONE
               : drawing_print(document, bat_format_named("glif"), arguments->operands[0], text, size);
}

/* Formats that have options of their own. */
static const struct {
    const char *format;
    int (*print)(const cli_arguments *arguments, const bat_document *document, char **text, size_t *size);
    bool sized; /* its lengths are millimetres */
    const char *options[4];
} special[] = {{"svg", svg, false, {"--plain", "--precision"}},
               {"dxf", dxf, true, {"--arcs"}},
               {"gcode", gcode, true, {"--arcs", "--feed", "--up", "--down"}},
               {"glif", glif, false, {"--extremes"}}};
enum { SPECIAL = sizeof special / sizeof *special };

static bool is_sized(const char *format) {
    bool sized = strcmp(format, "geojson") == 0;
    for (int i = 0; i < SPECIAL; i++)
        sized = sized || (special[i].sized && strcmp(format, special[i].format) == 0);
    return sized;
}

static int print(const cli_arguments *arguments, const bat_document *document, const bat_format *format,
                 char **text, size_t *size) {
    for (int i = 0; i < SPECIAL; i++)
        if (strcmp(format->name, special[i].format) == 0)
            return special[i].print(arguments, document, text, size);
    return drawing_print(document, format, arguments->operands[0], text, size);
}

static bool has(int i, const char *option) {
    for (int k = 0; k < 4; k++)
        if (special[i].options[k] && strcmp(special[i].options[k], option) == 0) return true;
    return false;
}

/* Whether the options given are for that format. */
static int options_fit(const cli_arguments *arguments, const char *format) {
    for (int i = 0; i < SPECIAL; i++)
        for (int k = 0; k < 4 && special[i].options[k]; k++) {
            const char *option = special[i].options[k];
            bool fits = !arguments_value(arguments, option);
            for (int j = 0; j < SPECIAL && !fits; j++)
                fits = strcmp(special[j].format, format) == 0 && has(j, option);
            if (!fits)
                return fail_usage(arguments->command, "%s is for .%s, not for .%s", option, special[i].format,
                                  format);
        }
    return EXIT_DONE;
}

/* Where a stroke whose width changes is a line along its middle, or its outline. */
static int outline_fits(const cli_arguments *arguments, const char *format) {
    static const char *const following[] = {"dxf", "gcode", "glif", "eps"};
    bool fits = !arguments_value(arguments, OPTION_OUTLINE);
    for (size_t i = 0; i < sizeof following / sizeof *following; i++)
        fits = fits || strcmp(format, following[i]) == 0;
    if (fits) return EXIT_DONE;
    return fail_usage(arguments->command, "%s is for .dxf, .gcode, .glif and .eps", OPTION_OUTLINE);
}

/* Plotters follow lines: of a stroke whose width changes the one along its middle, or on request its outline. */
static int even_strokes(const cli_arguments *arguments, const drawing_file *drawing, picture_kind page) {
    const char *in = arguments->operands[0];
    int count = 0;
    bat_status status = BAT_OK;
    if (arguments_value(arguments, OPTION_OUTLINE))
        status = strokes_outlined(drawing->document);
    else if (page == PICTURE_EPS)
        status = strokes_even(drawing->document, &count);
    if (status != BAT_OK) return fail_data(in, NULL, "%s", bat_status_message(status));
    if (count)
        remark("%s: %d stroke%s of changing width written as %s of one width; %s writes the outline%s", in,
               count, count == 1 ? "" : "s", count == 1 ? "a line" : "lines", OPTION_OUTLINE,
               count == 1 ? "" : "s");
    return EXIT_DONE;
}

/* Texts are kept by .svg and .batten, and painted by .pdf and the like; no other file has them. */
static void remark_texts(const char *in, const bat_document *document) {
    int count = 0;
    for (int i = 0; i < bat_document_count(document); i++)
        count += bat_object_kind(bat_document_at(document, i)) == BAT_KIND_TEXT;
    if (count)
        remark("%s: %d text%s left out: .svg, .pdf and .batten keep texts", in, count, count == 1 ? "" : "s");
}

static int put_drawing(const cli_arguments *arguments, const drawing_file *drawing,
                       const bat_format *format) {
    const char *in = arguments->operands[0], *out = arguments->operands[1];
    char *text;
    size_t size;
    const bool same = drawing->format == format && strcmp(format->name, "glif") == 0;
    int failed = same ? EXIT_DONE
                      : drawing_may_replace(arguments_value(arguments, OPTION_LOSSY) != NULL, drawing, in,
                                            out, false);
    if (!failed) failed = print(arguments, drawing->document, format, &text, &size);
    if (failed) return failed;
    failed = io_write(out, text, size);
    bat_free(text);
    if (!failed && !(format->keeps && drawing_keeps_file(drawing))) drawing_remark(in, drawing);
    if (!failed && is_sized(format->name)) drawing_remark_size(in, drawing->document);
    if (!failed && !format->keeps && strcmp(format->name, "batten") != 0) remark_texts(in, drawing->document);
    return failed;
}

static int put_page(const cli_arguments *arguments, const drawing_file *drawing, picture_kind page) {
    const char *in = arguments->operands[0], *out = arguments->operands[1];
    const picture_wanted wanted = {.kind = page};
    unsigned char *data = NULL;
    size_t size;
    int failed = drawing_may_replace(arguments_value(arguments, OPTION_LOSSY) != NULL, drawing, in, out,
                                     true);
    if (!failed) failed = picture_make(in, drawing->document, &wanted, &data, &size);
    if (!failed) failed = io_write(out, data, size);
    if (!failed) drawing_remark(in, drawing);
    free(data);
    return failed;
}

/* What is in space, as a file of another program. */
static int put_model(const cli_arguments *arguments, const drawing_file *drawing,
                     const bat_model_format *format, const bat_dividing *how) {
    const char *in = arguments->operands[0], *out = arguments->operands[1];
    bat_model model;
    int flat;
    const bat_stand stand = arguments_value(arguments, "--floor")  ? BAT_STAND_FLOOR
                            : arguments_value(arguments, "--wall") ? BAT_STAND_WALL
                                                                   : bat_stand_of(drawing->document);
    const bat_room room = {stand, format->unit, format->up_is_y};
    const bat_status status = bat_model_of_drawing(drawing->document, &room, &model, &flat);
    const bat_dividing there = {how->tolerance * bat_document_scale(drawing->document) / format->unit,
                                how->cap, how->always}; /* a length of the drawing, in the file's unit */
    if (status == BAT_COUNT)
        return fail_data(in, NULL, "expected a surface, a mesh or a curve in space, found %s",
                         flat ? "curves that lie flat: write them as .svg or .dxf" : "none");
    if (status != BAT_OK) return fail_data(in, NULL, "%s", bat_status_message(status));
    const int failed = model_put(in, out, format, &model, &there);
    bat_model_clear(&model);
    if (failed) return failed;
    if (flat) remark("%s: %d curve%s left out: on the page, not in space", in, flat, flat == 1 ? "" : "s");
    drawing_remark_size(in, drawing->document);
    remark_texts(in, drawing->document);
    return EXIT_DONE;
}

static int fail_cap(const cli_arguments *arguments) {
    return fail_usage(arguments->command,
                      "--cap is for .stl, .3mf, .glb, .gltf, .ply, .usda and, with %s, .obj",
                      OPTION_TRIANGLES);
}

/* A drawing as a model: --to or the name says so, and for .obj an option, too. */
static const bat_model_format *model_wanted(const cli_arguments *arguments) {
    const char *to = arguments_value(arguments, "--to");
    const bat_model_format *format = to ? bat_model_format_named(to)
                                        : bat_model_format_called(arguments->operands[1]);
    if (!format ||
        !(arguments_value(arguments, OPTION_TRIANGLES) ? format->divide != NULL : format->of_drawings))
        return NULL;
    return format;
}

static int run_model(const cli_arguments *arguments, const bat_model_format *format) {
    bat_dividing how = {0, arguments_value(arguments, "--cap") != NULL,
                        arguments_value(arguments, OPTION_TRIANGLES) != NULL};
    drawing_file drawing;
    int failed = options_fit(arguments, format->name);
    if (!failed) failed = outline_fits(arguments, format->name);
    if (arguments_value(arguments, "--floor") && arguments_value(arguments, "--wall"))
        failed = fail_usage(arguments->command, "--floor and --wall exclude each other");
    if (how.cap && !format->divide) failed = fail_cap(arguments);
    if (!failed) failed = arguments_number(arguments, "--tolerance", 0, 1e30, &how.tolerance);
    if (!failed) failed = drawing_read(arguments->operands[0], NULL, &drawing);
    if (failed) return failed;
    failed = put_model(arguments, &drawing, format, &how);
    drawing_free(&drawing);
    return failed;
}

static int run_one(const cli_arguments *arguments) {
    const bat_model_format *model = model_wanted(arguments);
    if (model) return run_model(arguments, model);
    if (arguments_value(arguments, "--floor") || arguments_value(arguments, "--wall"))
        return fail_usage(arguments->command, "--floor and --wall are for shapes in space: .stl, .3mf, .glb, "
                                              ".gltf, .ply, .usda, .step and .iges");
    if (arguments_value(arguments, "--cap")) return fail_cap(arguments);
    if (arguments_value(arguments, OPTION_TRIANGLES))
        return fail_usage(arguments->command, "%s is for .obj", OPTION_TRIANGLES);
    const bat_format *format = NULL;
    picture_kind page = PICTURE_UNKNOWN;
    bat_svg_options options = bat_svg_merging();
    int failed = output_format(arguments, &format, &page);
    double tolerance = -1;
    const char *name = format ? format->name : page == PICTURE_PDF ? "pdf" : "eps";
    if (!failed) failed = options_fit(arguments, name);
    if (!failed) failed = outline_fits(arguments, name);
    if (!failed) failed = arguments_number(arguments, "--tolerance", 0, 1e30, &tolerance);
    if (tolerance >= 0)
        options.tolerance = tolerance, options.share = 0; /* as asked, however small the path */
    if (failed) return failed;
    drawing_file drawing;
    failed = drawing_read(arguments->operands[0], &options, &drawing);
    if (failed) return failed;
    failed = even_strokes(arguments, &drawing, page);
    if (!failed)
        failed = format ? put_drawing(arguments, &drawing, format) : put_page(arguments, &drawing, page);
    drawing_free(&drawing);
    return failed;
}

static int run(const cli_arguments *arguments) {
    const char *to = arguments_value(arguments, "--to");
    if (!folder_is_one(arguments->operands[0])) return run_one(arguments);
    if (!to) return fail_usage(arguments->command, "for a folder, --to is needed");
    return folder_each(arguments, to, run_one);
}

const cli_command command_convert = {
    .name = "convert",
    .usage = "IN OUT [--to KIND] [--tolerance T] [--plain] [--lossy] [options of OUT's format]",
    .summary = "Converts between the native format, SVG, DXF, curves as JSON and others.",
    .details =
        "Formats go by the names' endings: .batten, .svg, .svgz, .json (a CURVE or a list), .jsonl, "
        ".dxf, .obj,\n"
        ".stl, .3mf, .glb, .gltf and .ply (meshes), .step and .iges (surfaces), .glif, .gcode, .pdf and "
        ".eps;\nstandard input is recognised. G-code and EPS are only written. Of a PDF (.ai\n"
        "files are PDFs, too) the first page is read, by pdftocairo of poppler-utils. One line on "
        "standard error\n"
        "counts what an SVG held that was left out: texts, gradients, clips and the like. As SVG or "
        ".batten it is\n"
        "kept: from SVG to SVG the file stays as it is. Of a folder, or the glyphs of a font (UFO), each "
        "drawing is\n"
        "converted into the folder OUT. Where a glyph is already, only its contours change.\n"
        "Surfaces, meshes and curves in space of a drawing go to .stl, .3mf, .glb, .gltf, .ply, .usda, "
        ".step\nand .iges: upright, in millimetres (glTF: metres), what is closed with its normals outward.",
    .example = "batten convert drawing.svg drawing.batten\n"
               "batten fit stroke.csv | batten convert - stroke.svg\n"
               "batten convert Sans.ufo drawings --to svg",
    .operands = 2,
    .options =
        {{"--to", "KIND", "the format of OUT, whatever its name: batten, svg, json ..."},
         {"--tolerance", "T",
          "knots of imported paths go within T units of the drawing; triangles and lines lie within T"},
         {"--arcs", "T", "to .dxf: curves as arcs and lines within T mm, for cutters; to .gcode: 0.01"},
         {"--feed", "F", "to .gcode: millimetres a minute, 1000 by default"},
         {"--up", "L", "to .gcode: lines that raise the tool, \\n between them; G0 Z5 by default"},
         {"--down", "L", "to .gcode: lines that lower it; G1 Z-1 F300 by default"},
         {"--extremes", NULL,
          "to .glif: curves get a point where they are furthest left, right, up and down"},
         {OPTION_OUTLINE, NULL,
          "to .dxf, .gcode, .glif and .eps: outlines of strokes whose width changes, not their middles"},
         {"--precision", "D", "SVG: no point moves by more than D when numbers are rounded; 0: none is"},
         {"--plain", NULL, "SVG without our data: smaller, but curves come back as cubic paths"},
         {"--floor", NULL,
          "to files of shapes in space: up is towards the eye; so where a plane stands on the page"},
         {"--wall", NULL, "to the same: up is the page's up; so where none does"},
         {OPTION_TRIANGLES, NULL,
          "to .obj: triangles of what is in space, upright and in millimetres, not B-splines"},
         {"--cap", NULL, "to files of triangles: the ends of tubes and rims that lie in a plane are filled"},
         {OPTION_LOSSY, NULL, "write over the input even when something of it is lost"}},
    .run = run,
};
