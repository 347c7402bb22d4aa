/* Paints a frame of the editor with cairo, for the hosts beside this file. */
#ifndef BATTEN_HOSTS_PAINT_H
#define BATTEN_HOSTS_PAINT_H
#include <batten/batten.h>
#include <cairo/cairo.h>

static void paint_item(cairo_t *c, const bat_item *item, double scale) {
    bool own = item->role == BAT_ROLE_OBJECT; /* all else is coloured by the host */
    for (const float *p = item->path, *end = p + item->path_count; p < end;) {
        int command = (int)*p++;
        if (command == BAT_PATH_MOVE) cairo_move_to(c, p[0], p[1]), p += 2;
        if (command == BAT_PATH_LINE) cairo_line_to(c, p[0], p[1]), p += 2;
        if (command == BAT_PATH_CUBIC) cairo_curve_to(c, p[0], p[1], p[2], p[3], p[4], p[5]), p += 6;
        if (command == BAT_PATH_CLOSE) cairo_close_path(c);
    }
    cairo_set_line_width(c, item->width / (item->flags & BAT_ITEM_SCREEN_WIDTH ? scale : 1));
    for (int part = 0; part < 2; part++) {
        uint32_t rgba = own ? (part ? item->stroke : item->fill) : part ? 0x2060c0ff : 0x2060c030;
        cairo_set_source_rgba(c, (rgba >> 24) / 255.0, (rgba >> 16 & 255) / 255.0, (rgba >> 8 & 255) / 255.0,
                              (rgba & 255) / 255.0 * item->opacity);
        if (!part && item->flags & BAT_ITEM_FILLED) cairo_fill_preserve(c);
        if (part && item->flags & BAT_ITEM_STROKED) cairo_stroke_preserve(c);
    }
    cairo_new_path(c);
}

static void paint(const bat_frame *f, cairo_surface_t *surface) {
    cairo_t *c = cairo_create(surface);
    cairo_push_group(c), cairo_set_source_rgb(c, 1, 1, 1), cairo_paint(c);
    cairo_scale(c, f->view[2], f->view[2]);
    cairo_translate(c, f->origin[0] - f->view[0], f->origin[1] - f->view[1]);
    for (uint32_t i = 0; i < f->still_count; i++) paint_item(c, f->still + i, f->view[2]);
    for (uint32_t i = 0; i < f->live_count; i++) paint_item(c, f->live + i, f->view[2]);
    cairo_pop_group_to_source(c), cairo_paint(c), cairo_destroy(c);
}
#endif
