/* batten render: a picture of a drawing. */
#include "draw_space.h"
#include "drawing.h"
#include "io.h"
#include "paint_cairo.h"
#include "paint_space.h"
#include "program.h"
#include "shot.h"
#include "views.h"

#include "document/document.h"
#include "format/seen/seen.h"
#include "text/number.h"
#include "text/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { PICTURE_UNKNOWN, PICTURE_SVG, PICTURE_PNG, PICTURE_PDF };

static int picture_of(const char *ending) {
    static const char *const endings[] = {"", "svg", "png", "pdf"};
    for (int i = PICTURE_SVG; i <= PICTURE_PDF; i++) {
        if (strcasecmp(ending, endings[i]) == 0) return i;
    }
    return PICTURE_UNKNOWN;
}

static int picture_kind(const cli_arguments *arguments, int *out) {
    const char *to = arguments_value(arguments, "--to"), *name = arguments->operands[1];
    if (to) {
        *out = picture_of(to);
        return *out ? EXIT_DONE : fail_usage(arguments->command, "--to: no such format: %s", to);
    }
    const char *slash = strrchr(name, '/'), *dot = strrchr(slash ? slash : name, '.');
    *out = dot ? picture_of(dot + 1) : PICTURE_UNKNOWN;
    if (*out) return EXIT_DONE;
    if (strcmp(name, "-") == 0) return fail_usage(arguments->command, "for standard output, --to is needed");
    return fail_usage(arguments->command, "%s: expected a name that ends in .svg, .png or .pdf", name);
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

static void put_attribute(bat_text *text, const char *name, double value) {
    bat_text_string(text, " ");
    bat_text_string(text, name);
    bat_text_string(text, "=\"");
    bat_text_number(text, value);
    bat_text_string(text, "\"");
}

/* The library's SVG, with the size and view set on the root element, and the background behind everything. */
static int svg_picture(const bat_document *document, const paint_area *area, uint32_t background,
                       const char *in, unsigned char **data, size_t *size) {
    char *inner;
    size_t inner_size;
    bat_status status = bat_svg_write(document, false, &inner, &inner_size);
    if (status == BAT_MEMORY) return fail_memory();
    if (status != BAT_OK) return fail_data(in, NULL, "%s", bat_status_message(status));
    bat_text text = {0};
    bat_text_string(&text, "<svg xmlns=\"http://www.w3.org/2000/svg\"");
    put_attribute(&text, "width", area->width);
    put_attribute(&text, "height", area->height);
    const double *view = area->view;
    bat_text_string(&text, " viewBox=\"");
    for (int i = 0; i < 4; i++) {
        if (i) bat_text_string(&text, " ");
        bat_text_number(&text, view[i]);
    }
    bat_text_string(&text, "\">\n");
    if (background & 255) {
        static const char hex[] = "0123456789abcdef";
        char colour[8] = "#";
        for (int i = 0; i < 6; i++) colour[1 + i] = hex[(background >> (28 - 4 * i)) & 15];
        bat_text_string(&text, "<rect");
        put_attribute(&text, "x", view[0] - view[2]); /* larger than the view, as proportions may differ */
        put_attribute(&text, "y", view[1] - view[3]);
        put_attribute(&text, "width", 3 * view[2]);
        put_attribute(&text, "height", 3 * view[3]);
        bat_text_string(&text, " fill=\"");
        bat_text_string(&text, colour);
        bat_text_string(&text, "\"");
        put_attribute(&text, "fill-opacity", (background & 255) / 255.0);
        bat_text_string(&text, "/>\n");
    }
    const char *root = strstr(inner, "<svg"), *content = root ? strchr(root, '>') : NULL;
    if (content)
        bat_text_add(&text, content + 1, inner_size - (size_t)(content + 1 - inner));
    else
        text.failed = true;
    bat_free(inner);
    char *whole;
    if (bat_text_finish(&text, &whole, size) != BAT_OK) return fail_memory();
    *data = (unsigned char *)whole;
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

/* The view that is asked for, or the saved one, or of all; in the size that is asked for, in whole pixels. */
static int view_of(const cli_arguments *arguments, const bat_document *document, const long size[2],
                   bat_viewpoint *out) {
    const char *name = arguments_value(arguments, "--view");
    int failed = EXIT_DONE;
    const bat_viewpoint *saved = name ? NULL : bat_seen_view(document);
    if (saved)
        *out = *saved;
    else if (!name)
        space_view_of(document, (int)size[0], (int)size[1], out);
    else if (is_shot(document, name))
        failed = shot_view(arguments->operands[0], document, name, size, out);
    else
        failed = read_view(name, out);
    for (int d = 0; !failed && d < 2; d++)
        out->size[d] = size[d] > 0 ? (double)size[d] : fmax(1, round(out->size[d]));
    return failed;
}

/* What is asked for, beside the operands. */
typedef struct wanted {
    int kind;
    long size[2]; /* 0: not given */
    uint32_t background;
    bat_look look;
} wanted;

static int wanted_of(const cli_arguments *arguments, wanted *out) {
    *out = (wanted){.kind = PICTURE_UNKNOWN};
    int failed = picture_kind(arguments, &out->kind);
    if (!failed) failed = arguments_product(arguments, "--size", PAINT_SIZE_MAX, out->size);
    if (out->kind == PICTURE_PNG) out->background = 0xffffffff;
    if (!failed) failed = background_of(arguments, &out->background);
    if (!failed) failed = look_of(arguments, &out->look);
    return failed;
}

static int space_picture(const cli_arguments *arguments, const bat_document *document, const wanted *w,
                         unsigned char **data, size_t *size) {
    bat_viewpoint view;
    const int failed = view_of(arguments, document, w->size, &view);
    if (failed) return failed;
    bool whole = true;
    const char *wrong = w->kind == PICTURE_PNG
                            ? paint_space(document, &view, w->look, w->background, data, size)
                            : draw_space(document, &view, w->look, w->background, w->kind == PICTURE_PDF,
                                         data, size, &whole);
    if (!wrong && !whole)
        remark("%s: surfaces touch along a curve, or are seen along one; lines near it may be wrong",
               arguments->operands[0]);
    return wrong ? fail_data(arguments->operands[0], NULL, "cannot be painted: %s", wrong) : EXIT_DONE;
}

static int flat_picture(const cli_arguments *arguments, const bat_document *document, const wanted *w,
                        unsigned char **data, size_t *size) {
    const char *in = arguments->operands[0];
    paint_area area;
    paint_area_of(document, (int)w->size[0], (int)w->size[1], &area);
    if (w->kind == PICTURE_SVG) return svg_picture(document, &area, w->background, in, data, size);
    bool whole = true;
    const char *wrong = paint_document(document, &area, w->kind == PICTURE_PDF ? PAINT_PDF : PAINT_PNG,
                                       w->background, data, size, &whole);
    if (!wrong && !whole)
        remark("%s: texts and other foreign content are left out: librsvg did not paint them", in);
    return wrong ? fail_data(in, NULL, "cannot be painted: %s", wrong) : EXIT_DONE;
}

static int run(const cli_arguments *arguments) {
    const char *in = arguments->operands[0];
    wanted w;
    int failed = wanted_of(arguments, &w);
    if (failed) return failed;
    drawing_file drawing;
    failed = drawing_read(in, NULL, &drawing);
    if (failed) return failed;
    bat_document_set_origin(drawing.document, NULL); /* a picture is of what is drawn, not of the file */
    failed = drawing_may_replace(arguments, &drawing, in, arguments->operands[1], true);
    unsigned char *data = NULL;
    size_t size = 0;
    if (!failed) {
        const bool space = arguments_value(arguments, "--view") || bat_seen_in_space(drawing.document);
        failed = (space ? space_picture : flat_picture)(arguments, drawing.document, &w, &data, &size);
    }
    if (!failed) failed = io_write(arguments->operands[1], data, size);
    if (!failed) drawing_remark(in, &drawing);
    free(data);
    drawing_free(&drawing);
    return failed;
}

const cli_command command_render = {
    .name = "render",
    .usage = "IN OUT [--size WxH] [--background COLOUR] [--to svg|png|pdf] [--view VIEW] [--look LOOK] "
             "[--lossy]",
    .summary = "Makes a picture of a drawing or a curve: SVG, PNG or PDF.",
    .details =
        "The page is shown, or the whole drawing when it has no page: one pixel a unit of the page, or 1000\n"
        "pixels on the longer side. With --size the proportions are kept and the view is centred. Pictures "
        "to\n"
        "trace are in an SVG, not in a PNG or PDF.\n"
        "\n"
        "A drawing with anything outside its page is seen in space: from --view, else from its saved view\n"
        "(the last in its list that is not hidden), else in a three-quarter view of all of it.\n"
        "--view NAME@SECONDS looks through the camera of that name in the drawing, at that time of its\n"
        "move, in 960x540 pixels without --size.\n"
        "As PNG surfaces are shaded, and what is hidden "
        "is fainter, thinner and dashed.\n"
        "As SVG and PDF it is drawn in lines, as Bezier curves within 0.1 pixels: edges, lines at knots,\n"
        "silhouettes, intersections and curves, over the shading as one picture. What is hidden is left "
        "out;\n"
        "with --look lines it is dashed, and there is no shading.",
    .example = "batten render drawing.svg drawing.png --size 1600x900",
    .operands = 2,
    .options = {{"--size", "WxH", "in pixels; in points for PDF"},
                {"--background", "COLOUR", "white, none, #rrggbb or #rrggbbaa; white for PNG, else none"},
                {"--view", "VIEW",
                 "the eye, as JSON, whose size is the picture's; or a camera: NAME@SECONDS"},
                {"--look", "LOOK", "in space: shaded, zebra, curvature (Gauss), mean (curvature) or lines"},
                {"--to", "FORMAT", "the format of OUT, whatever its name: svg, png or pdf"},
                OPTION_LOSSY},
    .run = run,
};
