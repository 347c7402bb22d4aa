#include "shade_shown.h"

#include "form/shade/colour.h"
#include "format/seen/seen.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct shown_surfaces {
    bat_shaded *surfaces;
    size_t count;
} shown_surfaces;

static bat_status add_surface(const bat_object *object, void *user) {
    shown_surfaces *s = user;
    const bat_surface *surface = bat_object_surface(object);
    const bat_style *style = bat_object_style(object);
    const bat_polymesh *mesh = bat_object_mesh(object);
    if (surface || mesh)
        s->surfaces[s->count++] = (bat_shaded){surface, style->filled ? style->fill | 255 : 0, mesh};
    return BAT_OK;
}

const char *shade_shown(const bat_document *document, const bat_viewpoint *view, bat_look look,
                        bat_shading **out) {
    shown_surfaces shown = {.count = 0};
    shown.surfaces = calloc((size_t)bat_document_count(document) + 1, sizeof *shown.surfaces);
    if (!shown.surfaces) return bat_status_message(BAT_MEMORY);
    bat_seen_each(document, add_surface, &shown);
    const bat_status status = bat_shade(view, shown.count, shown.surfaces, look, out);
    free(shown.surfaces);
    if (status == BAT_COUNT) return "the picture has too many pixels, or a surface too many spans";
    return status == BAT_OK ? NULL : bat_status_message(status);
}

double picture_unit(const bat_viewpoint *view) { return fmax(1, fmin(view->size[0], view->size[1]) / 700); }

/* cairo keeps a pixel as one number. */
cairo_surface_t *shading_picture(const bat_shading *shading) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, shading->width,
                                                          shading->height);
    if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
        cairo_surface_destroy(surface);
        return NULL;
    }
    unsigned char *rows = cairo_image_surface_get_data(surface);
    const size_t stride = (size_t)cairo_image_surface_get_stride(surface);
    cairo_surface_flush(surface);
    for (int y = 0; y < shading->height; y++)
        for (int x = 0; x < shading->width; x++) {
            const uint8_t *from = shading->rgba + 4 * ((size_t)y * (size_t)shading->width + (size_t)x);
            const uint32_t pixel = (uint32_t)from[3] << 24 | (uint32_t)from[0] << 16 |
                                   (uint32_t)from[1] << 8 | from[2];
            memcpy(rows + (size_t)y * stride + 4 * (size_t)x, &pixel, sizeof pixel);
        }
    cairo_surface_mark_dirty(surface);
    return surface;
}

static void put_text(cairo_t *cairo, double x, double y, const char *text) {
    cairo_move_to(cairo, x, y);
    cairo_show_text(cairo, text);
}

void paint_legend(cairo_t *cairo, const bat_viewpoint *view, bat_look look, double range) {
    enum { STEPS = 64 };
    const double unit = picture_unit(view), wide = 12 * unit;
    const double tall = fmin(130 * unit, 0.28 * view->size[1]);
    const double x = 16 * unit, y = view->size[1] - tall - 20 * unit;
    char text[32];
    if (look != BAT_LOOK_GAUSS && look != BAT_LOOK_MEAN) return;
    for (int k = 0; k < STEPS; k++) {
        double colour[3];
        bat_shade_legend(1 - 2 * (k + 0.5) / STEPS, colour);
        cairo_set_source_rgb(cairo, colour[0], colour[1], colour[2]);
        cairo_rectangle(cairo, x, y + tall * k / STEPS, wide, tall / STEPS + 0.5);
        cairo_fill(cairo);
    }
    cairo_set_source_rgb(cairo, 0.11, 0.13, 0.15);
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, 12 * unit);
    put_text(cairo, x, y - 9 * unit, look == BAT_LOOK_GAUSS ? "Gauss curvature" : "Mean curvature");
    for (int k = -1; k <= 1; k++) {
        snprintf(text, sizeof text, k == 0 ? "0" : "%+.3g", k * range);
        put_text(cairo, x + wide + 7 * unit, y + tall * (1 - k) / 2 + 4 * unit, text);
    }
}
