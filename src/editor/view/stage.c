#include "editor/view/stage.h"
#include <string.h>

static const double AWAY = 1000; /* of the eye from the page, in windows */

bat_stage bat_stage_defaults(void) { return (bat_stage){bat_view_defaults(), bat_ground_page()}; }

int bat_stage_dimension(const bat_stage *stage) { return stage->ground.type->dimension; }

bat_status bat_stage_place(const bat_stage *stage, const double pixel[2], bat_hit *out) {
    bat_ray ray = bat_view_ray(&stage->view, pixel);
    bat_hit hit = {.pixel = bat_view_pixel(&stage->view)};
    bat_status status = stage->ground.type->hit(&stage->ground, &ray, &hit);
    if (status == BAT_OK) *out = hit;
    return status;
}

void bat_stage_seen(const bat_stage *stage, const double pixel[2], double at[2]) {
    bat_view_to_document(&stage->view, pixel, at);
}

void bat_stage_project(const bat_stage *stage, const double at[2], double pixel[2]) {
    bat_view_to_screen(&stage->view, at, pixel);
}

void bat_stage_map(const bat_stage *stage, double map[6]) {
    const bat_view *view = &stage->view;
    const double z = view->zoom, c = view->cosine * z, s = view->sine * z;
    const double to[6] = {c, -s, -(c * view->x - s * view->y), s, c, -(s * view->x + c * view->y)};
    memcpy(map, to, sizeof to);
}

double bat_stage_pixel(const bat_stage *stage) { return bat_view_pixel(&stage->view); }
double bat_stage_scale(const bat_stage *stage) { return stage->view.zoom; }
double bat_stage_angle(const bat_stage *stage) { return stage->view.angle; }

void bat_stage_up(const bat_stage *stage, double up[2]) {
    up[0] = stage->view.sine;
    up[1] = -stage->view.cosine;
}

bat_status bat_stage_viewpoint(const bat_stage *stage, bat_viewpoint *out) {
    const bat_view *view = &stage->view;
    if (!(view->width > 0 && view->height > 0)) return BAT_STATE;
    bat_viewpoint seen = {.size = {view->width, view->height}, .height = view->height / view->zoom};
    double middle[2];
    bat_stage_middle(stage, middle);
    bat_view_to_document(view, middle, seen.target);
    memcpy(seen.eye, seen.target, sizeof seen.eye);
    seen.eye[2] = -AWAY * (view->width + view->height) / view->zoom;
    seen.up[0] = -view->sine;
    seen.up[1] = -view->cosine;
    *out = seen;
    return BAT_OK;
}

void bat_stage_window(const bat_stage *stage, double size[2]) {
    size[0] = stage->view.width;
    size[1] = stage->view.height;
}

void bat_stage_middle(const bat_stage *stage, double pixel[2]) {
    pixel[0] = stage->view.width / 2;
    pixel[1] = stage->view.height / 2;
}

void bat_stage_box(const bat_stage *stage, double box[4]) { bat_view_box(&stage->view, box); }

bool bat_stage_same(const bat_stage *a, const bat_stage *b) {
    const bat_view *v = &a->view, *w = &b->view;
    return v->x == w->x && v->y == w->y && v->zoom == w->zoom && v->angle == w->angle &&
           v->width == w->width && v->height == w->height && v->ratio == w->ratio &&
           bat_ground_same(&a->ground, &b->ground);
}

void bat_stage_pan(bat_stage *stage, const double from[2], const double to[2]) {
    bat_view_pan(&stage->view, from, to);
}

void bat_stage_bring(bat_stage *stage, const double at[2], double margin) {
    bat_view_show(&stage->view, at, margin);
}

void bat_stage_zoom(bat_stage *stage, const double about[2], double factor) {
    bat_view_zoom(&stage->view, about, factor);
}

void bat_stage_rotate(bat_stage *stage, const double about[2], double degrees) {
    bat_view_rotate(&stage->view, about, degrees);
}
