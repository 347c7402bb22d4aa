#include "editor/view.h"
#include <math.h>

static double clamp(double value, double low, double high) { return fmin(fmax(value, low), high); }

static void keep_in_reach(bat_view *view) {
    view->x = clamp(view->x, -BAT_VIEW_REACH, BAT_VIEW_REACH);
    view->y = clamp(view->y, -BAT_VIEW_REACH, BAT_VIEW_REACH);
}

bat_view bat_view_defaults(void) { return (bat_view){.zoom = 1, .ratio = 1}; }

double bat_view_pixel(const bat_view *view) { return 1 / view->zoom; }

void bat_view_to_document(const bat_view *view, const double screen[2], double document[2]) {
    document[0] = view->x + screen[0] / view->zoom;
    document[1] = view->y + screen[1] / view->zoom;
}

void bat_view_to_screen(const bat_view *view, const double document[2], double screen[2]) {
    screen[0] = (document[0] - view->x) * view->zoom;
    screen[1] = (document[1] - view->y) * view->zoom;
}

void bat_view_pan(bat_view *view, const double from[2], const double to[2]) {
    view->x += (from[0] - to[0]) / view->zoom;
    view->y += (from[1] - to[1]) / view->zoom;
    keep_in_reach(view);
}

void bat_view_zoom(bat_view *view, const double about[2], double factor) {
    if (!(factor > 0)) return;
    double zoom = clamp(view->zoom * factor, BAT_ZOOM_MIN, BAT_ZOOM_MAX);
    view->x += about[0] / view->zoom - about[0] / zoom;
    view->y += about[1] / view->zoom - about[1] / zoom;
    view->zoom = zoom;
    keep_in_reach(view);
}

bool bat_view_fit(bat_view *view, const double box[4], double margin) {
    double width = box[2] - box[0], height = box[3] - box[1];
    if (!(width >= 0 && height >= 0) || !isfinite(width) || !isfinite(height)) return false;
    if (!(view->width > 0 && view->height > 0)) return false;
    /* Tiny windows give up their margin before the drawing. */
    double room_x = fmax(view->width - 2 * margin, view->width / 2);
    double room_y = fmax(view->height - 2 * margin, view->height / 2);
    double zoom = view->zoom;
    if (width > 0 || height > 0)
        zoom = fmin(width > 0 ? room_x / width : INFINITY, height > 0 ? room_y / height : INFINITY);
    view->zoom = clamp(zoom, BAT_ZOOM_MIN, BAT_ZOOM_MAX);
    view->x = box[0] + width / 2 - view->width / 2 / view->zoom;
    view->y = box[1] + height / 2 - view->height / 2 / view->zoom;
    keep_in_reach(view);
    return true;
}
