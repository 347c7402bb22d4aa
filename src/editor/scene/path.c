#include "editor/scene/path.h"
#include "editor/view/stage.h"
#include <batten/bezier.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

float bat_path_float(double value) { return (float)fmin(fmax(value, -1e30), 1e30); }

static float *grow(bat_path *path, size_t more) {
    if (path->failed) return NULL;
    if (path->room - path->count < more) {
        size_t room = path->room ? 2 * path->room : 64;
        while (room - path->count < more) room *= 2;
        float *data = realloc(path->data, room * sizeof *data);
        if (!data) {
            path->failed = true;
            return NULL;
        }
        path->data = data;
        path->room = room;
    }
    float *end = path->data + path->count;
    path->count += more;
    return end;
}

static void command(bat_path *path, int kind, const double *points, int count) {
    float *end = grow(path, (size_t)(1 + 2 * count));
    if (!end) return;
    *end++ = (float)kind;
    for (int i = 0; i < 2 * count; i++) *end++ = bat_path_float(points[i] - path->origin[i & 1]);
}

void bat_path_move(bat_path *path, double x, double y) { command(path, BAT_PATH_MOVE, (double[]){x, y}, 1); }
void bat_path_line(bat_path *path, double x, double y) { command(path, BAT_PATH_LINE, (double[]){x, y}, 1); }
void bat_path_cubic(bat_path *path, const double *three_points) {
    command(path, BAT_PATH_CUBIC, three_points, 3);
}
void bat_path_close(bat_path *path) { command(path, BAT_PATH_CLOSE, NULL, 0); }

void bat_path_copy(bat_path *path, const float *commands, size_t count) {
    float *end = count ? grow(path, count) : NULL;
    if (end) memcpy(end, commands, count * sizeof *commands);
}

void bat_path_curve(bat_path *path, const bat_curve *curve) {
    double *points = NULL;
    int count = 0, dimension = bat_curve_dimension(curve);
    if (path->failed) return;
    double tolerance = fmax(bat_curve_size(curve) * 1e-7, 1e-300);
    bat_status status = bat_curve_to_cubics(curve, tolerance, &count, &points);
    if (status != BAT_OK) {
        if (status == BAT_MEMORY) path->failed = true;
        return;
    }
    for (int i = 0; i < count; i++) {
        const double *p = points + (size_t)i * 4 * (size_t)dimension;
        double planar[8];
        for (int j = 0; j < 4; j++) bat_map_look(path->map, dimension, p + j * dimension, planar + 2 * j);
        if (i == 0) bat_path_move(path, planar[0], planar[1]);
        bat_path_cubic(path, planar + 2);
    }
    if (count && bat_curve_is_closed(curve)) bat_path_close(path);
    bat_free(points);
}

void bat_box_clear(float box[4]) {
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
}

void bat_box_add(float box[4], const float other[4]) {
    box[0] = fminf(box[0], other[0]);
    box[1] = fminf(box[1], other[1]);
    box[2] = fmaxf(box[2], other[2]);
    box[3] = fmaxf(box[3], other[3]);
}

void bat_path_bounds(const bat_path *path, size_t first, float bounds[4]) {
    bat_box_clear(bounds);
    for (size_t i = first; i < path->count;) {
        int kind = (int)path->data[i++];
        int points = kind == BAT_PATH_CUBIC ? 3 : kind == BAT_PATH_CLOSE ? 0 : 1;
        for (int j = 0; j < points; j++, i += 2) {
            const float *p = path->data + i;
            bat_box_add(bounds, (float[]){p[0], p[1], p[0], p[1]});
        }
    }
}
