/* The editor in a window, by Xlib and cairo: cc x11.c $(pkg-config --cflags --libs batten cairo-xlib x11) */
#include <X11/Xlib.h>
#include <batten/batten.h>
#include <cairo/cairo-xlib.h>

#include "paint.h"

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
