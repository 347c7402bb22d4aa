#include "draw_space.h"
#include "paint_bytes.h"
#include "shade_shown.h"

#include "format/seen/seen.h"
#include "format/svg/markup.h"
#include "text/base64.h"
#include "text/text.h"

#include <batten/sight.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { FINER = 2 }; /* pixels of the shading for each of the view, where there is room for them */

/* What is drawn, and on what. */
typedef struct content {
    bat_seen_content seen;
    const bat_viewpoint *view;
    uint32_t background;
    cairo_surface_t *shading; /* owned; NULL: none, and what is hidden is dashed */
} content;

/* The picture that lies below the lines. */
static const char *shade(const bat_document *document, bat_look look, content *c) {
    bat_viewpoint fine = *c->view;
    if (fine.size[0] * fine.size[1] * FINER * FINER <= BAT_SHADE_PIXELS_MAX)
        fine.size[0] *= FINER, fine.size[1] *= FINER;
    bat_shading *shading = NULL;
    const char *wrong = shade_shown(document, &fine, look, &shading);
    if (wrong) return wrong;
    c->shading = shading_picture(shading);
    if (c->shading) {
        cairo_t *cairo = cairo_create(c->shading);
        paint_legend(cairo, &fine, look, shading->range);
        cairo_destroy(cairo);
    }
    bat_shading_free(shading);
    return c->shading ? NULL : bat_status_message(BAT_MEMORY);
}

static void put_numbers_as(bat_text *text, const char *format, double a, double b) {
    char line[704]; /* room for any two numbers */
    snprintf(line, sizeof line, format, a, b);
    bat_text_string(text, line);
}

static void put_colour(bat_text *text, const char *name, uint32_t colour) {
    char line[96];
    snprintf(line, sizeof line, " %s=\"#%06x\"", name, (unsigned)(colour >> 8));
    bat_text_string(text, line);
    if ((colour & 255) == 255) return;
    snprintf(line, sizeof line, " %s-opacity=\"%.3g\"", name, (colour & 255) / 255.0);
    bat_text_string(text, line);
}

static void set_colour(cairo_t *cairo, uint32_t colour) {
    cairo_set_source_rgba(cairo, (colour >> 24) / 255.0, ((colour >> 16) & 255) / 255.0,
                          ((colour >> 8) & 255) / 255.0, (colour & 255) / 255.0);
}

static void stroke_line(cairo_t *cairo, const bat_seen_line *line, const bat_seen_pen *p) {
    const double dashes[] = {BAT_SEEN_DASH, BAT_SEEN_GAP}, *at = line->points;
    set_colour(cairo, p->colour);
    cairo_set_line_width(cairo, p->width);
    cairo_set_line_cap(cairo, line->hidden ? CAIRO_LINE_CAP_BUTT : CAIRO_LINE_CAP_ROUND);
    cairo_set_dash(cairo, dashes, line->hidden ? 2 : 0, 0);
    cairo_move_to(cairo, at[0], at[1]);
    for (int k = 0; k < line->segments; k++, at += 6)
        cairo_curve_to(cairo, at[2], at[3], at[4], at[5], at[6], at[7]);
    cairo_stroke(cairo);
}

/* Hidden lines lie below the others. */
static void stroke_lines(cairo_t *cairo, const content *c) {
    for (int pass = c->shading ? 1 : 0; pass < 2; pass++)
        for (size_t i = 0; i < bat_line_drawing_count(c->seen.lines); i++) {
            bat_seen_line line;
            bat_line_drawing_at(c->seen.lines, i, &line);
            if (line.hidden == (pass == 1)) continue;
            const bat_seen_pen p = bat_seen_pen_of(&c->seen, &line);
            stroke_line(cairo, &line, &p);
        }
}

static cairo_status_t put_picture(bat_text *text, const content *c) {
    byte_list png = {0};
    const cairo_status_t status = cairo_surface_write_to_png_stream(c->shading, collect_bytes, &png);
    put_numbers_as(text, "<image width=\"%.17g\" height=\"%.17g\" preserveAspectRatio=\"none\" ",
                   c->view->size[0], c->view->size[1]);
    bat_text_string(text, "href=\"data:image/png;base64,");
    bat_base64_write(text, png.data, png.size);
    bat_text_string(text, "\"/>\n");
    free(png.data);
    return status;
}

static const char *make_svg(const content *c, unsigned char **data, size_t *size) {
    bat_text text = {0};
    char *whole;
    put_numbers_as(&text, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.17g\" height=\"%.17g\"",
                   c->view->size[0], c->view->size[1]);
    put_numbers_as(&text, " viewBox=\"0 0 %.17g %.17g\">\n", c->view->size[0], c->view->size[1]);
    if (c->background & 255) {
        bat_text_string(&text, "<rect width=\"100%\" height=\"100%\"");
        put_colour(&text, "fill", c->background);
        bat_text_string(&text, "/>\n");
    }
    const cairo_status_t painted = c->shading ? put_picture(&text, c) : CAIRO_STATUS_SUCCESS;
    const bat_status written = bat_svg_write_seen(&text, &c->seen, !c->shading, NULL);
    bat_text_string(&text, "</svg>\n");
    if (written != BAT_OK) {
        bat_text_free(&text);
        return bat_status_message(written);
    }
    if (painted != CAIRO_STATUS_SUCCESS) {
        bat_text_free(&text);
        return cairo_status_to_string(painted);
    }
    if (bat_text_finish(&text, &whole, size) != BAT_OK) return bat_status_message(BAT_MEMORY);
    *data = (unsigned char *)whole;
    return NULL;
}

static void paint_page(cairo_t *cairo, const content *c) {
    if (c->background & 255) {
        set_colour(cairo, c->background);
        cairo_paint(cairo);
    }
    if (c->shading) {
        cairo_save(cairo);
        cairo_scale(cairo, c->view->size[0] / cairo_image_surface_get_width(c->shading),
                    c->view->size[1] / cairo_image_surface_get_height(c->shading));
        cairo_set_source_surface(cairo, c->shading, 0, 0);
        cairo_paint(cairo);
        cairo_restore(cairo);
    }
    stroke_lines(cairo, c);
}

static const char *make_page(const content *c, picture_kind kind, unsigned char **data, size_t *size) {
    byte_list bytes = {0};
    cairo_surface_t *surface = page_create(kind, &bytes, c->view->size[0], c->view->size[1]);
    cairo_t *cairo = cairo_create(surface);
    paint_page(cairo, c);
    const cairo_status_t painted = cairo_status(cairo);
    cairo_destroy(cairo);
    return page_end(surface, BAT_OK, painted, &bytes, data, size);
}

const char *draw_space(const bat_document *document, const bat_viewpoint *view, bat_look look,
                       uint32_t background, picture_kind kind, unsigned char **data, size_t *size,
                       bool *whole) {
    content c = {.view = view, .background = background};
    const bat_status status = bat_seen_draw(document, view, &c.seen);
    const char *wrong = status == BAT_OK ? NULL : bat_status_message(status);
    if (!wrong && look != BAT_LOOK_LINES) wrong = shade(document, look, &c);
    if (!wrong) wrong = kind == PICTURE_SVG ? make_svg(&c, data, size) : make_page(&c, kind, data, size);
    *whole = c.seen.lines && bat_line_drawing_is_whole(c.seen.lines);
    bat_seen_clear(&c.seen);
    cairo_surface_destroy(c.shading);
    return wrong;
}
