#include "editor/view/view.h"
#include "base/real.h"
#include <math.h>
#include <string.h>

static double clamp(double value, double low, double high) { return fmin(fmax(value, low), high); }

static void keep_in_reach(bat_view *view) {
    view->x = clamp(view->x, -BAT_VIEW_REACH, BAT_VIEW_REACH);
    view->y = clamp(view->y, -BAT_VIEW_REACH, BAT_VIEW_REACH);
}

bat_view bat_view_defaults(void) {
    return (bat_view){.zoom = 1, .cosine = 1, .ratio = 1, .tilt_cosine = 1, .low = {0, 1}};
}

void bat_view_look_afresh(bat_view *view) {
    bat_view afresh = bat_view_defaults();
    afresh.width = view->width;
    afresh.height = view->height;
    afresh.ratio = view->ratio;
    afresh.fov = view->fov;
    *view = afresh;
}

/* Degrees in (-180, 180], whole hundredths. */
static double reduced(double degrees) {
    const double angle = round(remainder(degrees, 360) * 100) / 100;
    return angle <= -180 ? 180 : angle + 0; /* no -0 */
}

void bat_view_turn(bat_view *view, double degrees) {
    if (!isfinite(degrees)) return;
    const double angle = view->angle = reduced(degrees);
    /* Exact when upright. */
    view->cosine = angle == 0 ? 1 : bat_cos(view->angle * (BAT_PI / 180));
    view->sine = angle == 0 ? 0 : bat_sin(view->angle * (BAT_PI / 180));
    view->low[0] = view->sine;
    view->low[1] = view->cosine;
    if (view->roll != 0) {
        const double way = reduced(angle - view->roll) * (BAT_PI / 180);
        view->low[0] = bat_sin(way);
        view->low[1] = bat_cos(way);
    }
}

double bat_view_pixel(const bat_view *view) { return 1 / view->zoom; }

void bat_view_to_document(const bat_view *view, const double screen[2], double document[2]) {
    document[0] = view->x + (view->cosine * screen[0] + view->sine * screen[1]) / view->zoom;
    document[1] = view->y + (view->cosine * screen[1] - view->sine * screen[0]) / view->zoom;
}

void bat_view_axes(const bat_view *view, double right[3], double down[3], double ahead[3]) {
    const double s = view->low[0], c = view->low[1], k = view->tilt_cosine, h = view->tilt_sine;
    const double axes[3][3] = {{c, -s, 0}, {s * k, c * k, h}, {-s * h, -c * h, k}};
    memcpy(right, axes[0], sizeof axes[0]);
    memcpy(down, axes[1], sizeof axes[1]);
    memcpy(ahead, axes[2], sizeof axes[2]);
    if (view->roll == 0) return;
    const double a = view->roll * (BAT_PI / 180), turn = bat_cos(a), roll = bat_sin(a);
    for (int d = 0; d < 3; d++) {
        right[d] = turn * axes[0][d] - roll * axes[1][d];
        down[d] = roll * axes[0][d] + turn * axes[1][d];
    }
}

double bat_view_away(const bat_view *view) {
    if (view->tilt == 0 || !(view->fov > 0) || !(view->height > 0)) return 0;
    return view->height / (2 * view->zoom * bat_tan(view->fov * (BAT_PI / 360)));
}

/* The point of the plane through the pivot that has these drawing coordinates. */
static void in_space(const bat_view *view, const double seen[2], double out[3]) {
    double right[3], down[3], ahead[3], x = seen[0] - view->pivot[0], y = seen[1] - view->pivot[1];
    bat_view_axes(view, right, down, ahead);
    const double across = view->cosine * x - view->sine * y, below = view->sine * x + view->cosine * y;
    for (int k = 0; k < 3; k++) out[k] = view->pivot[k] + across * right[k] + below * down[k];
}

static void make_unit(double way[3]) {
    const double length = bat_hypot(bat_hypot(way[0], way[1]), way[2]);
    for (int k = 0; k < 3; k++) way[k] = length > 0 ? way[k] / length : 0;
}

/* Drawing coordinates of the window's middle. */
static void middle_of(const bat_view *view, double at[2]) {
    bat_view_to_document(view, (double[]){view->width / 2, view->height / 2}, at);
}

static void eye_of(const bat_view *view, double away, double eye[3]) {
    double right[3], down[3], ahead[3], middle[2];
    middle_of(view, middle);
    in_space(view, middle, eye);
    bat_view_axes(view, right, down, ahead);
    for (int k = 0; k < 3; k++) eye[k] -= away * ahead[k];
}

bat_ray bat_view_ray(const bat_view *view, const double pixel[2]) {
    bat_ray ray = {.along = {0, 0, 1}};
    bat_view_to_document(view, pixel, ray.from);
    if (view->tilt == 0) return ray;
    double right[3], down[3], seen[2] = {ray.from[0], ray.from[1]};
    const double away = bat_view_away(view);
    in_space(view, seen, ray.from);
    bat_view_axes(view, right, down, ray.along);
    if (away > 0) {
        double at[3];
        memcpy(at, ray.from, sizeof at);
        eye_of(view, away, ray.from);
        for (int k = 0; k < 3; k++) ray.along[k] = at[k] - ray.from[k];
        make_unit(ray.along);
    }
    return ray;
}

void bat_view_towards(const bat_view *view, const double point[3], double along[3]) {
    const double away = bat_view_away(view);
    double right[3], down[3], eye[3];
    bat_view_axes(view, right, down, along);
    if (away == 0) return;
    eye_of(view, away, eye);
    for (int k = 0; k < 3; k++) along[k] = point[k] - eye[k];
    make_unit(along);
}

/* Two rows: the parallel projection along the gaze. */
static void flat_map(const bat_view *view, double map[8]) {
    const double k = view->tilt_cosine, h = view->tilt_sine, *low = view->low;
    const double flat[8] = {1, 0, 0, 0, 0, 1, 0, 0}, less = view->tilt == 0 ? 0 : 1 - k;
    memcpy(map, flat, sizeof flat);
    if (view->tilt == 0) return;
    /* The page's own downward direction (s, c) is shortened, and what lies deeper is seen further down. */
    for (int row = 0; row < 2; row++) {
        for (int d = 0; d < 2; d++) map[4 * row + d] -= low[row] * low[d] * less;
        map[4 * row + 2] = low[row] * h;
        map[4 * row + 3] = view->pivot[row];
        for (int d = 0; d < 3; d++) map[4 * row + 3] -= map[4 * row + d] * view->pivot[d];
    }
}

void bat_view_map(const bat_view *view, double map[BAT_MAP_NUMBERS]) {
    const double still[4] = {0, 0, 0, 1}, away = bat_view_away(view);
    double right[3], down[3], ahead[3], middle[2], *deep = map + 8;
    flat_map(view, map);
    memcpy(deep, still, sizeof still);
    if (away == 0) return;
    bat_view_axes(view, right, down, ahead);
    middle_of(view, middle);
    for (int d = 0; d < 3; d++) {
        deep[d] = ahead[d] / away;
        deep[3] -= deep[d] * view->pivot[d];
    }
    /* Towards the middle, where the eye is: middle + (flat - middle) / deep. */
    for (int row = 0; row < 2; row++)
        for (int d = 0; d < 4; d++) map[4 * row + d] += middle[row] * (deep[d] - still[d]);
}

void bat_view_pose(bat_view *view, double angle, double tilt, double roll) {
    double at[2];
    if (!isfinite(angle) || !isfinite(tilt) || !isfinite(roll)) return;
    bat_view_to_screen(view, view->pivot, at);
    view->roll = reduced(roll);
    bat_view_turn(view, angle);
    view->tilt = round(clamp(tilt, 0, 180) * 100) / 100;
    view->tilt_cosine = view->tilt == 90 ? 0 : bat_cos(view->tilt * (BAT_PI / 180));
    view->tilt_sine = view->tilt == 180 ? 0 : bat_sin(view->tilt * (BAT_PI / 180));
    bat_view_hold(view, view->pivot, at);
}

void bat_view_orbit(bat_view *view, double angle, double tilt) { bat_view_pose(view, angle, tilt, 0); }

double bat_view_tolerance(const bat_view *view) { return 0.05 / view->zoom; }

double bat_map_depth(const double *map, int dimension, const double *point) {
    const double *deep = map + 8;
    return deep[0] * point[0] + deep[1] * point[1] + (dimension > 2 ? deep[2] * point[2] : 0) + deep[3];
}

bool bat_map_look(const double *map, int dimension, const double *point, double at[2]) {
    if (!map) {
        memcpy(at, point, 2 * sizeof *point);
        return true;
    }
    const double x = point[0], y = point[1], z = dimension > 2 ? point[2] : 0;
    const double depth = bat_map_depth(map, dimension, point);
    const bool seen = depth >= BAT_VIEW_NEAR;
    for (int k = 0; k < 2; k++, map += 4)
        at[k] = seen ? (map[0] * x + map[1] * y + map[2] * z + map[3]) / depth : BAT_NOWHERE;
    return seen;
}

/* In perspective the plane through the pivot moves, and with it the zoom, which is that of the plane. */
static void move_deep_pivot(bat_view *view, const double at[3]) {
    double map[BAT_MAP_NUMBERS], seen[2], pixel[2];
    bat_view_map(view, map);
    const double zoom = view->zoom / bat_map_depth(map, 3, at);
    if (!bat_map_look(map, 3, at, seen) || !(zoom >= BAT_ZOOM_MIN && zoom <= BAT_ZOOM_MAX)) return;
    bat_view_to_screen(view, seen, pixel);
    memcpy(view->pivot, at, sizeof view->pivot);
    view->zoom = zoom;
    bat_view_hold(view, at, pixel);
}

void bat_view_set_pivot(bat_view *view, const double at[3]) {
    double map[8];
    for (int k = 0; k < 3; k++)
        if (!(fabs(at[k]) <= BAT_COORDINATE_MAX)) return;
    if (bat_view_away(view) > 0) {
        move_deep_pivot(view, at);
        return;
    }
    flat_map(view, map);
    for (int k = 0; k < 2 && view->tilt != 0; k++) {
        const double *row = map + 4 * k;
        const double seen = row[0] * at[0] + row[1] * at[1] + row[2] * at[2] + row[3];
        (k ? &view->y : &view->x)[0] += at[k] - seen;
    }
    memcpy(view->pivot, at, sizeof view->pivot);
    keep_in_reach(view);
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

void bat_view_extent_start(const bat_view *view, double margin, bat_view_extent *extent) {
    const double size[2] = {view->width, view->height};
    const double tangent = bat_tan(view->fov * (BAT_PI / 360));
    for (int k = 0; k < 2; k++)
        extent->room[k] = tangent * fmax(size[k] - 2 * margin, size[k] / 2) / view->height;
    for (int i = 0; i < 4; i++) extent->most[i] = -INFINITY;
    extent->near = -INFINITY;
}

void bat_view_extent_add(const bat_view *view, bat_view_extent *extent, const double point[3]) {
    double axes[3][3], at[3] = {0};
    bat_view_axes(view, axes[0], axes[1], axes[2]);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) at[i] += axes[i][k] * (point[k] - view->pivot[k]);
    for (int i = 0; i < 4; i++) {
        const double aside = i & 1 ? -at[i >> 1] : at[i >> 1];
        extent->most[i] = fmax(extent->most[i], aside - extent->room[i >> 1] * at[2]);
    }
    extent->near = fmax(extent->near, -at[2]);
}

bool bat_view_extent_fit(bat_view *view, const bat_view_extent *extent) {
    const double *most = extent->most, tangent = bat_tan(view->fov * (BAT_PI / 360));
    double away = 1.05 * extent->near, foot[2], at[2]; /* the eye stays outside */
    if (!(view->width > 0 && view->height > 0) || !(fabs(extent->near) < INFINITY)) return false;
    for (int k = 0; k < 2; k++) {
        away = fmax(away, (most[2 * k] + most[2 * k + 1]) / (2 * extent->room[k]));
        foot[k] = (most[2 * k] - most[2 * k + 1]) / 2;
    }
    if (away > 0) view->zoom = clamp(view->height / (2 * tangent * away), BAT_ZOOM_MIN, BAT_ZOOM_MAX);
    at[0] = view->pivot[0] + view->cosine * foot[0] + view->sine * foot[1];
    at[1] = view->pivot[1] + view->cosine * foot[1] - view->sine * foot[0];
    view->x = view->y = 0;
    bat_view_hold(view, at, (double[]){view->width / 2, view->height / 2});
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
