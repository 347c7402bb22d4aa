/* batten convert: from one format to another. */
#include "drawing.h"
#include "io.h"
#include "program.h"

#include <string.h>

/* The format of OUT: from --to, else from its name. */
static int output_format(const cli_arguments *arguments, const bat_format **out) {
    const char *to = arguments_value(arguments, "--to"), *name = arguments->operands[1];
    char words[BAT_FORMATS_WORDS];
    *out = to ? bat_format_named(to) : drawing_format(name);
    if (to && !*out) return fail_usage(arguments->command, "--to: no such format: %s", to);
    if (*out && arguments_value(arguments, "--plain") && strcmp((*out)->name, "svg") != 0)
        return fail_usage(arguments->command, "--plain: for SVG alone, found %s", (*out)->name);
    if (*out) return EXIT_DONE;
    if (strcmp(name, "-") == 0) return fail_usage(arguments->command, "for standard output, --to is needed");
    bat_formats_words(".", false, words);
    return fail_usage(arguments->command, "%s: expected a name that ends in %s", name, words);
}

/* With --arcs the curves become arcs and lines, which only DXF holds; with --plain SVG is written without our data. */
static int print(const cli_arguments *arguments, const bat_document *document, const bat_format *format,
                 char **text, size_t *size) {
    const char *in = arguments->operands[0];
    const bool plain = arguments_value(arguments, "--plain"), to_arcs = arguments_value(arguments, "--arcs");
    double arcs = 0;
    if (!plain && !to_arcs) return drawing_print(document, format, in, text, size);
    const int failed = arguments_number(arguments, "--arcs", 1e-9, 1e30, &arcs);
    if (failed) return failed;
    if (to_arcs && strcmp(format->name, "dxf") != 0)
        return fail_usage(arguments->command, "--arcs is for .dxf, not for .%s", format->name);
    const bat_status status = to_arcs ? bat_dxf_write(document, arcs, text, size)
                                      : bat_svg_write(document, false, text, size);
    if (status == BAT_OK) return EXIT_DONE;
    return fail_data(in, NULL, "%s",
                     status == BAT_COUNT ? "expected a curve, found none" : bat_status_message(status));
}

static int run(const cli_arguments *arguments) {
    const char *in = arguments->operands[0], *out = arguments->operands[1];
    const bat_format *format;
    bat_svg_options options = bat_svg_merging();
    int failed = output_format(arguments, &format);
    double tolerance = -1;
    if (!failed) failed = arguments_number(arguments, "--tolerance", 0, 1e30, &tolerance);
    if (tolerance >= 0)
        options.tolerance = tolerance, options.share = 0; /* as asked, however small the path */
    if (failed) return failed;
    drawing_file drawing;
    failed = drawing_read(in, &options, &drawing);
    if (failed) return failed;
    char *text;
    size_t size;
    failed = drawing_may_replace(arguments, &drawing, in, out, false);
    if (!failed) failed = print(arguments, drawing.document, format, &text, &size);
    if (!failed) {
        failed = io_write(out, text, size);
        bat_free(text);
    }
    if (!failed && !(format->keeps && drawing_keeps_file(&drawing))) drawing_remark(in, &drawing);
    drawing_free(&drawing);
    return failed;
}

const cli_command command_convert = {
    .name = "convert",
    .usage = "IN OUT [--to FORMAT] [--tolerance T] [--arcs T] [--plain] [--lossy]",
    .summary = "Converts between the native format, SVG, DXF, curves as JSON and others.",
    .details = "Formats go by the names' endings: .batten, .svg, .svgz, .json (a CURVE or a list), .jsonl, "
               ".dxf and .obj.\n"
               "Standard input is recognised. One line on standard error counts what an SVG held that was "
               "left out: texts,\n"
               "gradients, clips and the like. As SVG or .batten it is kept: from SVG to SVG the file stays "
               "as it is.",
    .example = "batten convert drawing.svg drawing.batten\n"
               "batten fit stroke.csv | batten convert - stroke.svg",
    .operands = 2,
    .options = {{"--to", "FORMAT", "the format of OUT, whatever its name: batten, svg, json ..."},
                {"--tolerance", "T",
                 "knots of imported paths are removed within T units; 0: only where nothing changes"},
                {"--arcs", "T", "to .dxf: curves as arcs and lines within T units, for cutters"},
                {"--plain", NULL, "SVG without our data: smaller, but curves come back as cubic paths"},
                OPTION_LOSSY},
    .run = run,
};
