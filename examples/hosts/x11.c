/* The editor in a window, by Xlib and cairo: cc x11.c $(pkg-config --cflags --libs batten cairo-xlib x11) */
#include <X11/Xlib.h>
#include <batten/batten.h>
#include <cairo/cairo-xlib.h>

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

int main(void) {
    bat_editor *editor = NULL;
    Display *x = XOpenDisplay(NULL);
    if (!x || bat_editor_create(&editor) != BAT_OK) return 1;
    Window w = XCreateSimpleWindow(x, DefaultRootWindow(x), 0, 0, 900, 600, 0, 0, 0);
    XSelectInput(x, w, ExposureMask | ButtonPressMask | ButtonReleaseMask | PointerMotionMask);
    XMapWindow(x, w);
    cairo_surface_t *s = cairo_xlib_surface_create(x, w, DefaultVisual(x, DefaultScreen(x)), 900, 600);
    bat_editor_resize(editor, 900, 600, 1);
    for (XEvent e; XNextEvent(x, &e) == 0; XPending(x) ? (void)0 : paint(bat_editor_frame(editor), s)) {
        if (e.type < ButtonPress || e.type > MotionNotify) continue;
        bat_pointer p = {.device = BAT_DEVICE_MOUSE, .x = e.xbutton.x, .y = e.xbutton.y, .pressure = 0.5};
        p.buttons = e.type == ButtonPress || (e.type == MotionNotify && e.xbutton.state & Button1Mask);
        p.phase = e.type == ButtonRelease ? BAT_POINTER_UP : p.buttons ? BAT_POINTER_MOVE : BAT_POINTER_HOVER;
        if (e.type == ButtonPress) p.phase = BAT_POINTER_DOWN;
        p.time = (double)e.xbutton.time;
        bat_editor_pointer(editor, 1, &p);
    }
}
