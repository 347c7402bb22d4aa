#include "draw_space.h"
#include "paint_bytes.h"
#include "shade_shown.h"

#include "text/base64.h"
#include "text/text.h"

#include <batten/sight.h>

#include <cairo-pdf.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { FINER = 2 }; /* pixels of the shading for each of the view, where there is room for them */

/* What is drawn, and how: styles[i] is that of curve i. Borrowed from the document. */
typedef struct content {
    const bat_surface **surfaces;
    const bat_curve **curves;
    const bat_style **styles;
    bat_line_scene scene;
    const bat_viewpoint *view;
    uint32_t background;
    cairo_surface_t *shading; /* owned; NULL: none, and what is hidden is dashed */
    bat_line_drawing *lines;  /* owned */
} content;

typedef struct pen {
    uint32_t colour;
    double width;
} pen;

/* Where lines go: SVG as text, or PDF by cairo. */
typedef struct sheet {
    bat_text text;
    cairo_t *cairo;
} sheet;

static bat_status add_object(const bat_object *object, void *user) {
    content *c = user;
    const bat_style *style = bat_object_style(object);
    const bat_surface *surface = bat_object_surface(object);
    if (surface) c->surfaces[c->scene.surface_count++] = surface;
    if (surface || (!style->stroked && !style->filled)) return BAT_OK;
    for (int k = 0; k < bat_object_curve_count(object); k++) {
        c->styles[c->scene.curve_count] = style;
        c->curves[c->scene.curve_count++] = bat_object_curve(object, k);
    }
    return BAT_OK;
}

static bat_status content_of(const bat_document *document, content *out) {
    size_t curves = 1;
    for (int i = 0; i < bat_document_count(document); i++)
        curves += (size_t)bat_object_curve_count(bat_document_at(document, i));
    out->surfaces = malloc(((size_t)bat_document_count(document) + 1) * sizeof *out->surfaces);
    out->curves = malloc(curves * sizeof *out->curves);
    out->styles = malloc(curves * sizeof *out->styles);
    if (!out->surfaces || !out->curves || !out->styles) return BAT_MEMORY;
    out->scene.surfaces = out->surfaces, out->scene.curves = out->curves;
    each_shown(document, add_object, out);
    return bat_line_drawing_create(out->view, &out->scene, &out->lines);
}

static void content_clear(content *c) {
    bat_line_drawing_free(c->lines);
    cairo_surface_destroy(c->shading);
    free((void *)c->surfaces);
    free((void *)c->curves);
    free((void *)c->styles);
}

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

/* The length of a pixel at the target. */
static double pixel_of(const bat_viewpoint *view) {
    double far = 0;
    for (int c = 0; c < 3; c++) far = hypot(far, view->target[c] - view->eye[c]);
    const double high = view->fov > 0 ? far * tan(view->fov * 3.14159265358979323846 / 360) * 2
                                      : view->height;
    return high / view->size[1];
}

static pen pen_of(const content *c, const bat_viewpoint *view, const bat_seen_line *line) {
    pen p = {0x1c2126ff, 1.5};
    if (line->kind == BAT_LINE_PARAMETER) p = (pen){0x46505bd0, 0.6};
    if (line->kind == BAT_LINE_CURVE) {
        const bat_style *style = c->styles[line->source];
        const uint32_t colour = style->stroked ? style->stroke : style->fill;
        p.colour = (colour & ~(uint32_t)255) | (uint32_t)((colour & 255) * style->opacity + 0.5);
        p.width = style->stroked ? fmin(fmax(style->width / pixel_of(view), 1), 6) : 1;
    }
    if (line->hidden) p.width *= 0.6, p.colour = (p.colour & ~(uint32_t)255) | (p.colour & 255) / 2;
    return p;
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

static void put_line(bat_text *text, const bat_seen_line *line, const pen *p) {
    bat_text_string(text, "<path");
    put_colour(text, "stroke", p->colour);
    put_numbers_as(text, " stroke-width=\"%.3g\"", p->width, 0);
    if (line->hidden) put_numbers_as(text, " stroke-dasharray=\"%.3g %.3g\"", 4, 3);
    for (int k = 0; k < 3 * line->segments + 1; k++) {
        bat_text_string(text, k == 0 ? " d=\"M" : k % 3 == 1 ? "C" : " ");
        put_numbers_as(text, "%.2f %.2f", line->points[2 * k], line->points[2 * k + 1]);
    }
    bat_text_string(text, "\"/>\n");
}

static void set_colour(cairo_t *cairo, uint32_t colour) {
    cairo_set_source_rgba(cairo, (colour >> 24) / 255.0, ((colour >> 16) & 255) / 255.0,
                          ((colour >> 8) & 255) / 255.0, (colour & 255) / 255.0);
}

static void stroke_line(cairo_t *cairo, const bat_seen_line *line, const pen *p) {
    const double dashes[] = {4, 3}, *at = line->points;
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
static void put_lines(sheet *s, const content *c) {
    for (int pass = c->shading ? 1 : 0; pass < 2; pass++)
        for (size_t i = 0; i < bat_line_drawing_count(c->lines); i++) {
            bat_seen_line line;
            bat_line_drawing_at(c->lines, i, &line);
            if (line.hidden == (pass == 1)) continue;
            const pen p = pen_of(c, c->view, &line);
            if (s->cairo)
                stroke_line(s->cairo, &line, &p);
            else
                put_line(&s->text, &line, &p);
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
    sheet s = {.cairo = NULL};
    char *whole;
    put_numbers_as(&s.text, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.17g\" height=\"%.17g\"",
                   c->view->size[0], c->view->size[1]);
    put_numbers_as(&s.text, " viewBox=\"0 0 %.17g %.17g\">\n", c->view->size[0], c->view->size[1]);
    if (c->background & 255) {
        bat_text_string(&s.text, "<rect width=\"100%\" height=\"100%\"");
        put_colour(&s.text, "fill", c->background);
        bat_text_string(&s.text, "/>\n");
    }
    const cairo_status_t painted = c->shading ? put_picture(&s.text, c) : CAIRO_STATUS_SUCCESS;
    bat_text_string(&s.text, "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
    put_lines(&s, c);
    bat_text_string(&s.text, "</g>\n</svg>\n");
    if (painted != CAIRO_STATUS_SUCCESS) {
        bat_text_free(&s.text);
        return cairo_status_to_string(painted);
    }
    if (bat_text_finish(&s.text, &whole, size) != BAT_OK) return bat_status_message(BAT_MEMORY);
    *data = (unsigned char *)whole;
    return NULL;
}

static void paint_pdf(cairo_t *cairo, const content *c) {
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
    put_lines(&(sheet){.cairo = cairo}, c);
}

static const char *make_pdf(const content *c, unsigned char **data, size_t *size) {
    byte_list bytes = {0};
    cairo_surface_t *surface = cairo_pdf_surface_create_for_stream(collect_bytes, &bytes, c->view->size[0],
                                                                   c->view->size[1]);
    cairo_t *cairo = cairo_create(surface);
    paint_pdf(cairo, c);
    cairo_status_t painted = cairo_status(cairo);
    cairo_destroy(cairo);
    cairo_surface_finish(surface);
    if (painted == CAIRO_STATUS_SUCCESS) painted = cairo_surface_status(surface);
    cairo_surface_destroy(surface);
    if (painted != CAIRO_STATUS_SUCCESS) {
        free(bytes.data);
        return cairo_status_to_string(painted);
    }
    *data = bytes.data, *size = bytes.size;
    return NULL;
}

const char *draw_space(const bat_document *document, const bat_viewpoint *view, bat_look look,
                       uint32_t background, bool pdf, unsigned char **data, size_t *size, bool *whole) {
    content c = {.view = view, .background = background};
    const bat_status status = content_of(document, &c);
    const char *wrong = status == BAT_OK ? NULL : bat_status_message(status);
    if (!wrong && look != BAT_LOOK_LINES) wrong = shade(document, look, &c);
    if (!wrong) wrong = (pdf ? make_pdf : make_svg)(&c, data, size);
    *whole = c.lines && bat_line_drawing_is_whole(c.lines);
    content_clear(&c);
    return wrong;
}
