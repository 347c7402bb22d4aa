#include "draw_space.h"
#include "paint_bytes.h"

#include "document/nesting.h"
#include "text/text.h"

#include <batten/sight.h>

#include <cairo-pdf.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* What is drawn, and how: styles[i] is that of curve i. Borrowed from the document. */
typedef struct content {
    const bat_surface **surfaces;
    const bat_curve **curves;
    const bat_style **styles;
    bat_line_scene scene;
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

static bool content_of(const bat_document *document, content *out) {
    size_t curves = 1, surfaces = 0;
    bat_nesting nesting = {0};
    for (int i = 0; i < bat_document_count(document); i++)
        curves += (size_t)bat_object_curve_count(bat_document_at(document, i));
    out->surfaces = malloc(((size_t)bat_document_count(document) + 1) * sizeof *out->surfaces);
    out->curves = malloc(curves * sizeof *out->curves);
    out->styles = malloc(curves * sizeof *out->styles);
    if (!out->surfaces || !out->curves || !out->styles) return false;
    curves = 0;
    for (int i = 0; i < bat_document_count(document); i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_nesting_level level = {0};
        bat_nesting_next(&nesting, object, &level);
        if (level.hidden || !bat_object_is_drawn(object)) continue;
        const bat_style *style = bat_object_style(object);
        if (bat_object_surface(object)) out->surfaces[surfaces++] = bat_object_surface(object);
        if (bat_object_surface(object) || (!style->stroked && !style->filled)) continue;
        for (int k = 0; k < bat_object_curve_count(object); k++)
            out->styles[curves] = style, out->curves[curves++] = bat_object_curve(object, k);
    }
    out->scene = (bat_line_scene){surfaces, out->surfaces, curves, out->curves};
    return true;
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
static void put_lines(sheet *s, const content *c, const bat_viewpoint *view, bool dashed,
                      const bat_line_drawing *drawing) {
    for (int pass = dashed ? 0 : 1; pass < 2; pass++)
        for (size_t i = 0; i < bat_line_drawing_count(drawing); i++) {
            bat_seen_line line;
            bat_line_drawing_at(drawing, i, &line);
            if (line.hidden == (pass == 1)) continue;
            const pen p = pen_of(c, view, &line);
            if (s->cairo)
                stroke_line(s->cairo, &line, &p);
            else
                put_line(&s->text, &line, &p);
        }
}

static const char *make_svg(const content *c, const bat_viewpoint *view, bool dashed, uint32_t background,
                            const bat_line_drawing *drawing, unsigned char **data, size_t *size) {
    sheet s = {.cairo = NULL};
    char *whole;
    put_numbers_as(&s.text, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.17g\" height=\"%.17g\"",
                   view->size[0], view->size[1]);
    put_numbers_as(&s.text, " viewBox=\"0 0 %.17g %.17g\">\n", view->size[0], view->size[1]);
    if (background & 255) {
        bat_text_string(&s.text, "<rect width=\"100%\" height=\"100%\"");
        put_colour(&s.text, "fill", background);
        bat_text_string(&s.text, "/>\n");
    }
    bat_text_string(&s.text, "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
    put_lines(&s, c, view, dashed, drawing);
    bat_text_string(&s.text, "</g>\n</svg>\n");
    if (bat_text_finish(&s.text, &whole, size) != BAT_OK) return bat_status_message(BAT_MEMORY);
    *data = (unsigned char *)whole;
    return NULL;
}

static const char *make_pdf(const content *c, const bat_viewpoint *view, bool dashed, uint32_t background,
                            const bat_line_drawing *drawing, unsigned char **data, size_t *size) {
    byte_list bytes = {0};
    cairo_surface_t *surface = cairo_pdf_surface_create_for_stream(collect_bytes, &bytes, view->size[0],
                                                                   view->size[1]);
    sheet s = {.cairo = cairo_create(surface)};
    if (background & 255) {
        set_colour(s.cairo, background);
        cairo_paint(s.cairo);
    }
    put_lines(&s, c, view, dashed, drawing);
    cairo_status_t painted = cairo_status(s.cairo);
    cairo_destroy(s.cairo);
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

const char *draw_space(const bat_document *document, const bat_viewpoint *view, bool dashed,
                       uint32_t background, bool pdf, unsigned char **data, size_t *size, bool *whole) {
    content c = {.surfaces = NULL};
    bat_line_drawing *drawing = NULL;
    const char *wrong = NULL;
    bat_status status = content_of(document, &c) ? BAT_OK : BAT_MEMORY;
    if (status == BAT_OK) status = bat_line_drawing_create(view, &c.scene, &drawing);
    if (status != BAT_OK)
        wrong = bat_status_message(status);
    else
        wrong = (pdf ? make_pdf : make_svg)(&c, view, dashed, background, drawing, data, size);
    *whole = drawing && bat_line_drawing_is_whole(drawing);
    bat_line_drawing_free(drawing);
    free((void *)c.surfaces);
    free((void *)c.curves);
    free((void *)c.styles);
    return wrong;
}
