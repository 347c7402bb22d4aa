#include "editor/view/stage.h"
#include "base/real.h"
#include <math.h>
#include <string.h>

static const double AWAY = 1000; /* of the eye from the page, in windows */

bat_stage bat_stage_defaults(void) {
    return (bat_stage){.view = bat_view_defaults(), .ground = bat_ground_page()};
}

int bat_stage_dimension(const bat_stage *stage) { return stage->ground.type->dimension; }

bat_status bat_stage_place(const bat_stage *stage, const double pixel[2], const bat_hit *last, bat_hit *out) {
    bat_ray ray = bat_view_ray(&stage->view, pixel);
    bat_hit hit = {.pixel = bat_view_pixel(&stage->view)};
    bat_status status = stage->ground.type->hit(&stage->ground, stage->casters, &ray, last, &hit);
    if (status != BAT_OK) return status;
    if (bat_stage_deep(stage)) {
        double map[BAT_MAP_NUMBERS];
        bat_view_map(&stage->view, map);
        const double depth = bat_map_depth(map, 3, hit.at);
        if (!(depth >= BAT_VIEW_NEAR)) return BAT_FAR; /* behind the eye: beyond the horizon */
        hit.pixel *= depth;
    }
    *out = hit;
    return BAT_OK;
}

bool bat_stage_on_page(const bat_stage *stage, const double pixel[2], double at[2]) {
    const bat_stage page = {.view = stage->view, .ground = bat_ground_page()};
    bat_hit hit;
    if (bat_stage_place(&page, pixel, NULL, &hit) != BAT_OK) return false;
    memcpy(at, hit.at, 2 * sizeof *at);
    return true;
}

/* The ground's normal, on the side where the eye looks along it; gives how far it does. */
static double normal_of(const bat_stage *stage, double normal[3]) {
    double x[3], y[3], right[3], down[3], ahead[3], along = 0;
    bat_ground_axes(&stage->ground, x, y);
    bat_view_axes(&stage->view, right, down, ahead);
    for (int k = 0; k < 3; k++) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        normal[k] = x[i] * y[j] - x[j] * y[i];
        along += normal[k] * ahead[k];
    }
    for (int k = 0; k < 3 && along < 0; k++) normal[k] = -normal[k];
    return fabs(along);
}

double bat_stage_slant(const bat_stage *stage) {
    double normal[3];
    return normal_of(stage, normal);
}

double bat_stage_slant_at(const bat_stage *stage, const bat_hit *hit) {
    double ahead[3], along = 0;
    bat_view_towards(&stage->view, hit->at, ahead);
    for (int k = 0; k < 3; k++) along += hit->normal[k] * ahead[k];
    return fabs(along);
}

void bat_stage_facing(const bat_stage *stage, double normal[3]) { (void)normal_of(stage, normal); }

void bat_stage_seen(const bat_stage *stage, const double pixel[2], double at[2]) {
    bat_view_to_document(&stage->view, pixel, at);
}

void bat_stage_project(const bat_stage *stage, const double at[2], double pixel[2]) {
    bat_view_to_screen(&stage->view, at, pixel);
}

bool bat_stage_tilted(const bat_stage *stage) { return stage->view.tilt != 0; }

void bat_stage_space_map(const bat_stage *stage, double map[BAT_MAP_NUMBERS]) {
    bat_view_map(&stage->view, map);
}

bool bat_stage_deep(const bat_stage *stage) { return bat_view_away(&stage->view) > 0; }

bool bat_stage_behind(const bat_stage *stage) {
    const bat_view *view = &stage->view;
    double middle[2];
    bat_stage_middle(stage, middle);
    return bat_stage_deep(stage) ? bat_view_ray(view, middle).from[2] > 0 : view->tilt > 90;
}

bool bat_stage_look(const bat_stage *stage, int dimension, const double *point, double at[2]) {
    double map[BAT_MAP_NUMBERS];
    bat_view_map(&stage->view, map);
    return bat_map_look(bat_stage_tilted(stage) ? map : NULL, dimension, point, at);
}

void bat_stage_look_along(const bat_stage *stage, int dimension, const double *point, const double *way,
                          double seen[2]) {
    double map[BAT_MAP_NUMBERS], at[2];
    bat_view_map(&stage->view, map);
    const double *deep = map + 8, depth = bat_map_depth(map, dimension, point);
    if (!bat_map_look(bat_stage_tilted(stage) ? map : NULL, dimension, point, at)) at[0] = at[1] = 0;
    for (int k = 0; k < 2; k++) {
        const double *row = map + 4 * k;
        seen[k] = 0;
        for (int d = 0; d < dimension; d++) seen[k] += (row[d] - at[k] * deep[d]) * way[d] / depth;
    }
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
    double middle[2], right[3], down[3], ahead[3];
    bat_stage_middle(stage, middle);
    const bat_ray ray = bat_view_ray(view, middle);
    const double deep = bat_view_away(view);
    const double away = deep > 0 ? deep : AWAY * (view->width + view->height) / view->zoom;
    bat_view_axes(view, right, down, ahead);
    for (int k = 0; k < 3; k++) {
        seen.target[k] = deep > 0 ? ray.from[k] + deep * ahead[k] : ray.from[k];
        seen.eye[k] = deep > 0 ? ray.from[k] : ray.from[k] - away * ray.along[k];
        seen.up[k] = -down[k];
    }
    if (deep > 0) seen.fov = view->fov, seen.height = 0;
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

static void enclose(double box[4], const double at[2]) {
    for (int k = 0; k < 2; k++) {
        box[k] = fmin(box[k], at[k]);
        box[k + 2] = fmax(box[k + 2], at[k]);
    }
}

/* Own coordinates of a ground under a pixel. */
static bool own_place(const bat_stage *stage, double x, double y, double at[2]) {
    bat_hit hit;
    if (bat_stage_place(stage, (double[]){x, y}, NULL, &hit) != BAT_OK) return false;
    memcpy(at, hit.own, 2 * sizeof *at);
    return true;
}

/* In perspective a plane ends at its horizon, which is looked for along columns of the window. */
static bool deep_box(const bat_stage *stage, double box[4]) {
    enum { COLUMNS = 17, ROWS = 9, HALVINGS = 12 };
    const bat_view *view = &stage->view;
    for (int i = 0; i < COLUMNS * ROWS; i++) {
        const double x = view->width * (i % COLUMNS) / (COLUMNS - 1);
        double y = view->height * (i / COLUMNS) / (ROWS - 1), step = view->height / (ROWS - 1), at[2];
        if (!own_place(stage, x, y, at)) continue;
        enclose(box, at);
        for (int side = -1; side <= 1; side += 2) {
            double near = y, far = y + side * step;
            if (own_place(stage, x, far, at)) continue;
            for (int k = 0; k < HALVINGS; k++) {
                const double middle = (near + far) / 2;
                *(own_place(stage, x, middle, at) ? &near : &far) = middle;
            }
            if (own_place(stage, x, near, at)) enclose(box, at);
        }
    }
    return box[0] <= box[2];
}

bool bat_stage_flat_box(const bat_stage *stage, const bat_ground *flat, double box[4]) {
    const bat_view *view = &stage->view;
    const bat_stage on = {.view = *view, .ground = *flat};
    box[0] = box[1] = INFINITY, box[2] = box[3] = -INFINITY;
    if (bat_stage_deep(stage)) return deep_box(&on, box);
    for (int i = 0; i < 4; i++) {
        double at[2];
        if (!own_place(&on, i & 1 ? view->width : 0, i & 2 ? view->height : 0, at)) return false;
        enclose(box, at);
    }
    return true;
}

bool bat_stage_page_box(const bat_stage *stage, double box[4]) {
    const bat_ground page = bat_ground_page();
    if (bat_stage_tilted(stage)) return bat_stage_flat_box(stage, &page, box);
    bat_view_box(&stage->view, box);
    return true;
}

bool bat_stage_same(const bat_stage *a, const bat_stage *b) {
    const bat_view *v = &a->view, *w = &b->view;
    return v->x == w->x && v->y == w->y && v->zoom == w->zoom && v->angle == w->angle && v->tilt == w->tilt &&
           v->roll == w->roll && !memcmp(v->pivot, w->pivot, sizeof v->pivot) && v->width == w->width &&
           v->height == w->height && v->ratio == w->ratio && v->fov == w->fov &&
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
