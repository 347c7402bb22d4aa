#include "editor/view/view.h"
#include "base/real.h"
#include <math.h>

static double clamp(double value, double low, double high) { return fmin(fmax(value, low), high); }

static void keep_in_reach(bat_view *view) {
    view->x = clamp(view->x, -BAT_VIEW_REACH, BAT_VIEW_REACH);
    view->y = clamp(view->y, -BAT_VIEW_REACH, BAT_VIEW_REACH);
}

bat_view bat_view_defaults(void) { return (bat_view){.zoom = 1, .cosine = 1, .ratio = 1}; }

void bat_view_look_afresh(bat_view *view) {
    bat_view afresh = bat_view_defaults();
    afresh.width = view->width;
    afresh.height = view->height;
    afresh.ratio = view->ratio;
    *view = afresh;
}

void bat_view_turn(bat_view *view, double degrees) {
    if (!isfinite(degrees)) return;
    double angle = round(remainder(degrees, 360) * 100) / 100;
    view->angle = angle <= -180 ? 180 : angle + 0; /* no -0 */
    /* Exact when upright. */
    view->cosine = angle == 0 ? 1 : bat_cos(view->angle * (BAT_PI / 180));
    view->sine = angle == 0 ? 0 : bat_sin(view->angle * (BAT_PI / 180));
}

double bat_view_pixel(const bat_view *view) { return 1 / view->zoom; }

void bat_view_to_document(const bat_view *view, const double screen[2], double document[2]) {
    document[0] = view->x + (view->cosine * screen[0] + view->sine * screen[1]) / view->zoom;
    document[1] = view->y + (view->cosine * screen[1] - view->sine * screen[0]) / view->zoom;
}

bat_ray bat_view_ray(const bat_view *view, const double pixel[2]) {
    bat_ray ray = {.along = {0, 0, 1}};
    bat_view_to_document(view, pixel, ray.from);
    return ray;
}

void bat_view_to_screen(const bat_view *view, const double document[2], double screen[2]) {
    double x = document[0] - view->x, y = document[1] - view->y;
    screen[0] = (view->cosine * x - view->sine * y) * view->zoom;
    screen[1] = (view->sine * x + view->cosine * y) * view->zoom;
}

void bat_view_hold(bat_view *view, const double document[2], const double screen[2]) {
    double under[2];
    bat_view_to_document(view, screen, under);
    view->x += document[0] - under[0];
    view->y += document[1] - under[1];
    keep_in_reach(view);
}

void bat_view_pan(bat_view *view, const double from[2], const double to[2]) {
    double document[2];
    bat_view_to_document(view, from, document);
    bat_view_hold(view, document, to);
}

void bat_view_show(bat_view *view, const double point[2], double margin) {
    double at[2], size[2] = {view->width, view->height}, to[2];
    bat_view_to_screen(view, point, at);
    for (int k = 0; k < 2; k++) {
        double border = fmin(margin, size[k] / 2);
        to[k] = clamp(at[k], border, size[k] - border);
    }
    if (to[0] != at[0] || to[1] != at[1]) bat_view_pan(view, at, to);
}

void bat_view_zoom(bat_view *view, const double about[2], double factor) {
    if (!(factor > 0)) return;
    double document[2];
    bat_view_to_document(view, about, document);
    view->zoom = clamp(view->zoom * factor, BAT_ZOOM_MIN, BAT_ZOOM_MAX);
    bat_view_hold(view, document, about);
}

void bat_view_rotate(bat_view *view, const double about[2], double degrees) {
    double document[2];
    bat_view_to_document(view, about, document);
    bat_view_turn(view, view->angle + degrees);
    bat_view_hold(view, document, about);
}

bool bat_view_fit(bat_view *view, const double box[4], double margin) {
    double width = box[2] - box[0], height = box[3] - box[1];
    if (!(width >= 0 && height >= 0) || !isfinite(width) || !isfinite(height)) return false;
    if (!(view->width > 0 && view->height > 0)) return false;
    /* In tiny windows the margin shrinks rather than the drawing. */
    double room_x = fmax(view->width - 2 * margin, view->width / 2);
    double room_y = fmax(view->height - 2 * margin, view->height / 2);
    double middle[2] = {box[0] + width / 2, box[1] + height / 2};
    double c = fabs(view->cosine), s = fabs(view->sine), zoom = view->zoom;
    double across = c * width + s * height, down = s * width + c * height; /* extent of the rotated box */
    if (width > 0 || height > 0)
        zoom = fmin(across > 0 ? room_x / across : INFINITY, down > 0 ? room_y / down : INFINITY);
    view->zoom = clamp(zoom, BAT_ZOOM_MIN, BAT_ZOOM_MAX);
    view->x = view->y = 0;
    bat_view_hold(view, middle, (double[]){view->width / 2, view->height / 2});
    return true;
}

void bat_view_box(const bat_view *view, double box[4]) {
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
    for (int i = 0; i < 4; i++) {
        double at[2];
        bat_view_to_document(view, (double[]){i & 1 ? view->width : 0, i & 2 ? view->height : 0}, at);
        for (int k = 0; k < 2; k++) {
            box[k] = fmin(box[k], at[k]);
            box[k + 2] = fmax(box[k + 2], at[k]);
        }
    }
}
