#include "editor/scene/path.h"
#include "editor/scene/image.h"
#include "editor/view/view.h"
#include <batten/bezier.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

float bat_path_float(double value) {
    return !(value >= -1e30) ? -1e30F : value > 1e30 ? 1e30F : (float)value;
}

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

/* ---- in perspective ---- */

static bool deep(const bat_path *path) {
    static const double still[4] = {0, 0, 0, 1};
    return path->map && memcmp(path->map + 8, still, sizeof still) != 0;
}

typedef struct pen {
    bat_path *path;
    bool down, lifted; /* some piece was behind the eye */
} pen;

static void draw(void *host, const double u[2], const double cubic[8]) {
    pen *p = host;
    (void)u;
    if (cubic && !p->down) bat_path_move(p->path, cubic[0], cubic[1]);
    if (cubic) bat_path_cubic(p->path, cubic + 2);
    p->down = cubic != NULL;
    p->lifted = p->lifted || !cubic;
}

static void deep_curve(bat_path *path, const bat_curve *curve) {
    pen p = {.path = path};
    if (bat_image_walk(curve, path->map, path->tolerance, draw, &p) != BAT_OK)
        path->failed = true;
    else if (bat_curve_is_closed(curve) && p.down && !p.lifted)
        bat_path_close(path);
}

/* The point of the edge from a to b at which it passes the near plane. */
static void pass(const double *map, int dimension, const double *a, const double *b, double at[2]) {
    const double from = bat_map_depth(map, dimension, a), to = bat_map_depth(map, dimension, b);
    /* a little on this side of it */
    const double t = (BAT_VIEW_NEAR * (1 + 1e-6) - from) / (to - from);
    double point[BAT_DIMENSION_MAX] = {0};
    for (int d = 0; d < dimension; d++) point[d] = a[d] + t * (b[d] - a[d]);
    bat_map_look(map, dimension, point, at);
}

void bat_path_polygon(bat_path *path, int dimension, int count, const double *points, bool closed) {
    bool down = false, last = false;
    double at[2];
    for (int i = 0; i < count + closed; i++) {
        const double *here = points + (ptrdiff_t)(i % count) * dimension;
        const bool seen = bat_map_look(path->map, dimension, here, at);
        if (i > 0 && seen != last) {
            double edge[2];
            pass(path->map, dimension, here - (i % count ? dimension : -(count - 1) * dimension), here, edge);
            (down ? bat_path_line : bat_path_move)(path, edge[0], edge[1]);
            down = closed || seen; /* a closed one goes on along the near plane */
        }
        last = seen;
        if (!seen || i == count) continue;
        (down ? bat_path_line : bat_path_move)(path, at[0], at[1]);
        down = true;
    }
    if (closed && down) bat_path_close(path);
}

/* Whether a cubic is the line between its ends, evenly run through, to rounding: it then takes three numbers, not seven. */
static bool straight(const double p[8]) {
    double far = 0, size = 0;
    for (int d = 0; d < 2; d++) {
        const double step = (p[6 + d] - p[d]) / 3;
        far = fmax(far, fmax(fabs(p[2 + d] - p[d] - step), fabs(p[4 + d] - p[6 + d] + step)));
        size = fmax(size, fmax(fabs(p[d]), fabs(p[6 + d])));
    }
    return far <= 32 * DBL_EPSILON * size && (p[0] != p[6] || p[1] != p[7]);
}

void bat_path_curve(bat_path *path, const bat_curve *curve) {
    double *points = NULL;
    int count = 0, dimension = bat_curve_dimension(curve);
    if (path->failed) return;
    if (deep(path)) {
        deep_curve(path, curve);
        return;
    }
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
        if (straight(planar))
            bat_path_line(path, planar[6], planar[7]);
        else
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
