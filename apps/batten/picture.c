#include "picture.h"

#include "draw_space.h"
#include "drawing.h"
#include "paint_cairo.h"
#include "paint_space.h"
#include "program.h"
#include "shot.h"
#include "tiles.h"
#include "views.h"

#include "document/document.h"
#include "document/unit.h"
#include "format/seen/seen.h"
#include "format/svg/markup.h"
#include "text/number.h"
#include "text/text.h"

#include <batten/bezier.h>
#include <batten/format.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

picture_kind picture_kind_of(const char *ending) {
    static const char *const endings[] = {"", "svg", "png", "pdf", "eps"};
    for (int i = PICTURE_SVG; i <= PICTURE_EPS; i++)
        if (strcasecmp(ending, endings[i]) == 0) return (picture_kind)i;
    return PICTURE_UNKNOWN;
}

picture_kind picture_kind_called(const char *name) {
    const char *slash = strrchr(name, '/'), *dot = strrchr(slash ? slash : name, '.');
    return dot ? picture_kind_of(dot + 1) : PICTURE_UNKNOWN;
}

static void put_attribute(bat_text *text, const char *name, double value) {
    bat_text_string(text, " ");
    bat_text_string(text, name);
    bat_text_string(text, "=\"");
    bat_text_number(text, value);
    bat_text_string(text, "\"");
}

/* The library's SVG, with the size and view set on the root element, and the background behind everything. */
static int svg_picture(const bat_document *document, const paint_area *area, const picture_wanted *w,
                       const char *in, unsigned char **data, size_t *size) {
    const uint32_t background = w->background;
    const bool sized = w->size[0] > 0 || w->size[1] > 0 || w->dpi > 0;
    char *inner;
    size_t inner_size;
    bat_status status = bat_svg_write_within(document, false, 0, &inner, &inner_size);
    if (status == BAT_MEMORY) return fail_memory();
    if (status != BAT_OK) return fail_data(in, NULL, "%s", bat_status_message(status));
    bat_text text = {0};
    bat_text_string(&text, "<svg xmlns=\"http://www.w3.org/2000/svg\"");
    const double *view = area->view;
    if (!sized && bat_unit_is_physical(bat_document_unit(document))) {
        bat_svg_write_size(&text, " width=\"", view[2], document);
        bat_svg_write_size(&text, " height=\"", view[3], document);
    } else {
        put_attribute(&text, "width", area->width);
        put_attribute(&text, "height", area->height);
    }
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

/* The view that is asked for, or the saved one, or of all; in the size that is asked for, in whole pixels. */
static int view_of(const char *in, bat_document *document, const picture_wanted *w, bat_viewpoint *out) {
    const char *name = w->view;
    const long *size = w->size;
    int failed = EXIT_DONE;
    const bat_viewpoint *saved = name ? NULL : bat_seen_view(document);
    if (saved)
        *out = *saved;
    else if (!name)
        space_view_of(document, (int)size[0], (int)size[1], out);
    else if (is_shot(document, name))
        failed = shot_view(in, document, name, size, out);
    else
        failed = read_view(name, out);
    for (int d = 0; !failed && d < 2; d++)
        out->size[d] = size[d] > 0 ? (double)size[d] : fmax(1, round(out->size[d]));
    return failed;
}

static int space_picture(const char *in, bat_document *document, const picture_wanted *w,
                         unsigned char **data, size_t *size) {
    bat_viewpoint view;
    const int failed = view_of(in, document, w, &view);
    if (failed) return failed;
    bool whole = true;
    const char *wrong = w->kind == PICTURE_PNG
                            ? paint_space(document, &view, w->look, w->background, data, size)
                            : draw_space(document, &view, w->look, w->background, w->kind, data, size,
                                         &whole);
    if (!wrong && !whole)
        remark("%s: surfaces touch along a curve, or are seen along one; lines near it may be wrong", in);
    return wrong ? fail_data(in, NULL, "cannot be painted: %s", wrong) : EXIT_DONE;
}

/* One line for all that is not in the picture as it is in the drawing. */
static void say_left(const char *in, const paint_left *left) {
    static const char *const one[] = {"image", "text or other foreign content", "pattern", "mask"},
                             *const more[] = {"images", "texts and other foreign contents", "patterns",
                                              "masks"};
    const int counts[] = {left->images, left->foreign, left->patterns, left->masks};
    char list[160] = "";
    for (int k = 0; k < 4; k++) {
        const size_t size = strlen(list);
        if (counts[k])
            snprintf(list + size, sizeof list - size, "%s%d %s", size ? ", " : "", counts[k],
                     (counts[k] == 1 ? one : more)[k]);
    }
    if (*list) remark("%s: left out, as librsvg did not paint them: %s", in, list);
}

/* In true size, over sheets of paper. */
static int tiled_picture(const char *in, bat_document *document, const picture_wanted *w,
                         unsigned char **data, size_t *size) {
    paint_area area;
    tiles_layout layout;
    paint_left left = {0};
    const picture_wanted whole = {.kind = PICTURE_PDF};
    paint_area_of(document, &whole, &area);
    const double scale = bat_document_scale(document);
    tiles_plan((double[2]){area.view[2] * scale, area.view[3] * scale}, w->sheet, w->overlap, &layout);
    const double count = layout.count[0] * layout.count[1];
    if (!(count <= TILES_MAX))
        return fail_data(in, NULL,
                         "expected at most %d sheets, found %.0f (%.0f rows, %.0f columns); a larger sheet "
                         "(--tile A0), less overlap or a smaller scale takes fewer",
                         TILES_MAX, count, layout.count[1], layout.count[0]);
    const char *wrong = tiles_paint(document, area.view, &layout, w->background, data, size, &left);
    if (wrong) return fail_data(in, NULL, "cannot be painted: %s", wrong);
    say_left(in, &left);
    drawing_remark_size(in, document);
    return EXIT_DONE;
}

static int flat_picture(const char *in, bat_document *document, const picture_wanted *w, unsigned char **data,
                        size_t *size) {
    paint_area area;
    paint_area_of(document, w, &area);
    if (w->kind == PICTURE_SVG) return svg_picture(document, &area, w, in, data, size);
    paint_left left = {0};
    const char *wrong = paint_document(document, &area, w, data, size, &left);
    if (!wrong) say_left(in, &left);
    const bool asked = w->dpi > 0 || (w->kind != PICTURE_PNG && !(w->size[0] > 0 && w->size[1] > 0));
    if (!wrong && asked) drawing_remark_size(in, document);
    return wrong ? fail_data(in, NULL, "cannot be painted: %s", wrong) : EXIT_DONE;
}

int picture_make(const char *in, bat_document *document, const picture_wanted *w, unsigned char **data,
                 size_t *size) {
    bat_document_set_origin(document, NULL); /* a picture is of what is drawn, not of the file */
    const bool space = w->view || bat_seen_in_space(document);
    if (space && w->sheet[0] > 0)
        return fail_data(in, NULL, "expected a drawing on a page for --tile, found one in space");
    if (w->sheet[0] > 0) return tiled_picture(in, document, w, data, size);
    return (space ? space_picture : flat_picture)(in, document, w, data, size);
}
