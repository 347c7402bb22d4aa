/* batten render: a picture of a drawing. */
#include "drawing.h"
#include "io.h"
#include "paint_cairo.h"
#include "picture.h"
#include "program.h"
#include "tiles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int kind_of(const cli_arguments *arguments, picture_kind *out) {
    const char *to = arguments_value(arguments, "--to"), *name = arguments->operands[1];
    *out = to ? picture_kind_of(to) : picture_kind_called(name);
    if (*out) return EXIT_DONE;
    if (to) return fail_usage(arguments->command, "--to: no such format: %s", to);
    if (strcmp(name, "-") == 0) return fail_usage(arguments->command, "for standard output, --to is needed");
    return fail_usage(arguments->command, "%s: expected a name that ends in .svg, .png, .pdf or .eps", name);
}

/* "white", "none", "#rrggbb" or "#rrggbbaa". */
static int background_of(const cli_arguments *arguments, uint32_t *out) {
    const char *text = arguments_value(arguments, "--background");
    if (!text) return EXIT_DONE;
    if (strcmp(text, "none") == 0) {
        *out = 0;
    } else if (strcmp(text, "white") == 0) {
        *out = 0xffffffff;
    } else {
        size_t digits = text[0] == '#' ? strspn(text + 1, "0123456789abcdefABCDEF") : 0;
        if ((digits != 6 && digits != 8) || text[1 + digits]) {
            return fail_usage(arguments->command, "--background: expected white, none or #rrggbb, found '%s'",
                              text);
        }
        unsigned long value = strtoul(text + 1, NULL, 16);
        *out = (uint32_t)(digits == 6 ? value << 8 | 255 : value);
    }
    return EXIT_DONE;
}

/* How a drawing in space is looked at. */
static int look_of(const cli_arguments *arguments, bat_look *out) {
    static const char *const names[] = {"shaded", "zebra", "curvature", "mean", "lines"};
    const char *look = arguments_value(arguments, "--look"), *view = arguments_value(arguments, "--view");
    *out = BAT_LOOK_SHADED;
    if (view && strcmp(view, "-") == 0 && strcmp(arguments->operands[0], "-") == 0)
        return fail_usage(arguments->command, "only one of IN and VIEW can be standard input");
    for (int k = 0; look && k < BAT_LOOK_COUNT; k++)
        if (strcmp(look, names[k]) == 0) {
            *out = (bat_look)k;
            return EXIT_DONE;
        }
    return look ? fail_usage(arguments->command,
                             "--look: expected shaded, zebra, curvature, mean or lines, "
                             "found '%s'",
                             look)
                : EXIT_DONE;
}

/* Over which sheets of paper, and how much neighbours share. */
static int sheets_of(const cli_arguments *arguments, picture_wanted *out) {
    const cli_command *command = arguments->command;
    const char *tile = arguments_value(arguments, "--tile");
    double room[2];
    out->overlap = 10;
    int failed = arguments_number(arguments, "--overlap", 0, 1e6, &out->overlap);
    if (failed) return failed;
    if (!tile)
        return arguments_value(arguments, "--overlap") ? fail_usage(command, "--overlap is for --tile")
                                                       : EXIT_DONE;
    if (!tiles_sheet(tile, out->sheet))
        return fail_usage(command,
                          "--tile: expected A0 to A5, letter, legal, tabloid, or two sides such as "
                          "100x150mm, found '%s'",
                          tile);
    if (out->kind != PICTURE_PDF) return fail_usage(command, "--tile is for .pdf");
    if (out->size[0] > 0 || out->view)
        return fail_usage(command, "--tile makes true sizes: it goes neither with --size nor with --view");
    tiles_room(out->sheet, room);
    const double most = fmin(room[0], room[1]);
    if (!arguments_value(arguments, "--overlap")) out->overlap = fmin(out->overlap, most / 4);
    return out->overlap < most
               ? EXIT_DONE
               : fail_usage(command,
                            "--overlap: expected less than the %g mm that a sheet shows, found "
                            "%g",
                            most, out->overlap);
}

static int picture_of(const cli_arguments *arguments, picture_wanted *out) {
    *out = (picture_wanted){.view = arguments_value(arguments, "--view")};
    int failed = kind_of(arguments, &out->kind);
    if (!failed) failed = arguments_product(arguments, "--size", PAINT_SIZE_MAX, out->size);
    if (!failed) failed = arguments_number(arguments, "--dpi", 1e-3, 1e6, &out->dpi);
    if (!failed && out->dpi > 0 && (out->kind == PICTURE_PDF || out->kind == PICTURE_EPS))
        return fail_usage(arguments->command, "--dpi is for .png and .svg: PDF and EPS have no pixels");
    if (!failed && out->dpi > 0 && arguments_value(arguments, "--size"))
        return fail_usage(arguments->command, "either --size or --dpi says how many pixels there are");
    if (out->kind == PICTURE_PNG) out->background = 0xffffffff;
    if (!failed) failed = background_of(arguments, &out->background);
    if (!failed) failed = look_of(arguments, &out->look);
    if (!failed) failed = sheets_of(arguments, out);
    return failed;
}

static int run(const cli_arguments *arguments) {
    const char *in = arguments->operands[0];
    picture_wanted w;
    int failed = picture_of(arguments, &w);
    if (failed) return failed;
    drawing_file drawing;
    failed = drawing_read(in, NULL, &drawing);
    if (failed) return failed;
    failed = drawing_may_replace(arguments_value(arguments, OPTION_LOSSY) != NULL, &drawing, in,
                                 arguments->operands[1], true);
    unsigned char *data = NULL;
    size_t size = 0;
    if (!failed) failed = picture_make(in, drawing.document, &w, &data, &size);
    if (!failed) failed = io_write(arguments->operands[1], data, size);
    if (!failed) drawing_remark(in, &drawing);
    free(data);
    drawing_free(&drawing);
    return failed;
}

const cli_command command_render = {
    .name = "render",
    .usage = "IN OUT [--size WxH|--dpi N|--tile SHEET] [--background COLOUR] [--view VIEW] [options]",
    .summary = "Makes a picture of a drawing or a curve: SVG, PNG, PDF or EPS.",
    .details =
        "The page is shown, or the whole drawing when it has no page. PDF and EPS have the drawing's own "
        "size;\n"
        "in pixels it is 96 an inch where the drawing says its size in mm, cm, in, pt or pc, otherwise one "
        "pixel\n"
        "a unit of the page, or 1000 on the longer side. A PNG of such a size, or by --dpi, says how large "
        "a\n"
        "pixel is. A drawing in px has 96 an inch, which is said in one line.\n"
        "With --size the proportions are kept and the view is centred. Placed\n"
        "images are painted unless they are hidden; what could not be painted is said in one line.\n"
        "\n"
        "A drawing with anything outside its page is seen in space: from --view, else from its saved view\n"
        "(the last in its list that is not hidden), else in a three-quarter view of all of it.\n"
        "--view NAME@SECONDS looks through the camera of that name in the drawing, at that time of its\n"
        "move, in 960x540 pixels without --size; skeletons stand as they do then.\n"
        "As PNG surfaces are shaded, and what is hidden "
        "is fainter, thinner and dashed.\n"
        "As SVG, PDF and EPS it is drawn in lines, as Bezier curves within 0.1 pixels: edges, lines at "
        "knots,\n"
        "silhouettes, intersections and curves, over the shading as one picture. What is hidden is left "
        "out;\n"
        "with --look lines it is dashed, and there is no shading.\n"
        "\n"
        "--tile A4 makes a PDF of as many sheets as the drawing needs in its true size, to be cut and glued: "
        "row by\n"
        "row, each with marks, its row and its column, and on the first a square of 50 mm to check the "
        "printer by.\n"
        "Around each sheet 10 mm are left white (a tenth of a small one); a drawing that fits one sheet is "
        "put in\n"
        "its middle. More than 400 sheets are refused.",
    .example = "batten render drawing.svg drawing.png --size 1600x900",
    .operands = 2,
    .options = {{"--size", "WxH", "in pixels; in points for PDF and EPS"},
                {"--dpi", "N", "PNG, SVG: pixels an inch of the drawing's own size"},
                {"--background", "COLOUR", "white, none, #rrggbb or #rrggbbaa; white for PNG, else none"},
                {"--view", "VIEW",
                 "the eye, as JSON, whose size is the picture's; or a camera: NAME@SECONDS"},
                {"--look", "LOOK", "in space: shaded, zebra, curvature (Gauss), mean (curvature) or lines"},
                {"--tile", "SHEET", "PDF: sheets of A0 to A5, letter, legal, tabloid, or such as 100x150mm"},
                {"--overlap", "MM", "of the drawing on two neighbouring sheets; 10 by default"},
                {"--to", "KIND", "the format of OUT, whatever its name: svg, png, pdf or eps"},
                {OPTION_LOSSY, NULL, "write over the input even when something of it is lost"}},
    .run = run,
};
