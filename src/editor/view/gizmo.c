#include "editor/view/gizmo.h"
#include "base/pose.h"
#include "base/real.h"
#include "base/vec.h"
#include <math.h>
#include <string.h>

static const double SIZE = 92;                /* px: of an arm that is seen at right angles */
static const double CLOSE = 8;                /* px to an arm or an arc */
static const double FREE = 0.3;               /* of an arm, where what lies in the middle is taken hold of */
static const double SQUARE = 0.42, ARC = 0.8; /* where the handles of planes and turns are */
static const double LEAST_ARM = 0.25,         /* sines: of the angle at which an arm is seen, and a plane */
    LEAST_SLANT = 0.17;
static const double STEEP = 0.02; /* no plane is met at a smaller sine, and no axis */

bool bat_gizmo_place(const bat_stage *stage, const double middle[3], bat_gizmo *out) {
    double map[BAT_MAP_NUMBERS], towards[3];
    if (!bat_stage_tilted(stage)) return false;
    bat_view_map(&stage->view, map);
    const double depth = bat_map_depth(map, 3, middle);
    if (!(depth >= BAT_VIEW_NEAR)) return false;
    bat_view_towards(&stage->view, middle, towards);
    memcpy(out->middle, middle, sizeof out->middle);
    for (int k = 0; k < 3; k++) {
        const double slant = fabs(towards[k]);
        out->arms[k] = (towards[k] > 0 ? -1 : 1) * SIZE * depth * bat_view_pixel(&stage->view);
        out->there[BAT_GIZMO_ALONG + k] = 1 - slant * slant >= LEAST_ARM * LEAST_ARM;
        out->there[BAT_GIZMO_ACROSS + k] = out->there[BAT_GIZMO_ABOUT + k] = slant >= LEAST_SLANT;
    }
    return true;
}

void bat_gizmo_at(const bat_gizmo *g, double x, double y, double z, double at[3]) {
    const double shares[3] = {x, y, z};
    for (int k = 0; k < 3; k++) at[k] = g->middle[k] + shares[k] * g->arms[k];
}

/* A point in the plane at right angles to an axis, by shares of the next arm and the one after it. */
static void in_plane(const bat_gizmo *g, int axis, double a, double b, double at[3]) {
    double shares[3] = {0, 0, 0};
    shares[(axis + 1) % 3] = a, shares[(axis + 2) % 3] = b;
    bat_gizmo_at(g, shares[0], shares[1], shares[2], at);
}

static void on_axis(const bat_gizmo *g, int axis, double share, double at[3]) {
    memcpy(at, g->middle, sizeof g->middle);
    at[axis] += share * g->arms[axis];
}

void bat_gizmo_handle(const bat_gizmo *g, int part, double at[3]) {
    const double half = ARC * sqrt(0.5);
    if (part < BAT_GIZMO_ACROSS)
        on_axis(g, part, 1, at);
    else if (part < BAT_GIZMO_ABOUT)
        in_plane(g, part - BAT_GIZMO_ACROSS, SQUARE, SQUARE, at);
    else
        in_plane(g, part - BAT_GIZMO_ABOUT, half, half, at);
}

void bat_gizmo_arc(const bat_gizmo *g, int axis, double points[3 * BAT_GIZMO_ARC]) {
    for (int i = 0; i < BAT_GIZMO_ARC; i++) {
        const double angle = BAT_PI / 12 + BAT_PI / 3 * i / (BAT_GIZMO_ARC - 1); /* from 15 to 75 degrees */
        in_plane(g, axis, ARC * bat_cos(angle), ARC * bat_sin(angle), points + (ptrdiff_t)3 * i);
    }
}

static bool pixel_of(const bat_stage *stage, const double at[3], double pixel[2]) {
    double seen[2];
    if (!bat_stage_look(stage, 3, at, seen)) return false;
    bat_stage_project(stage, seen, pixel);
    return true;
}

/* How far a pixel is from a polyline in space, as it is seen. */
static double away(const bat_stage *stage, int count, const double *points, const double pixel[2]) {
    double least = INFINITY, a[2], b[2];
    for (int i = 0; i + 1 < count; i++) {
        if (!pixel_of(stage, points + (ptrdiff_t)3 * i, a) ||
            !pixel_of(stage, points + (ptrdiff_t)3 * (i + 1), b))
            continue;
        const double x = b[0] - a[0], y = b[1] - a[1], square = x * x + y * y;
        const double along = square > 0 ? ((pixel[0] - a[0]) * x + (pixel[1] - a[1]) * y) / square : 0;
        const double t = fmin(fmax(along, 0), 1);
        least = fmin(least, bat_hypot(a[0] + t * x - pixel[0], a[1] + t * y - pixel[1]));
    }
    return least;
}

int bat_gizmo_find(const bat_gizmo *g, const bat_stage *stage, const double pixel[2], double reach) {
    double best = reach, at[3], seen[2], line[3 * BAT_GIZMO_ARC];
    int found = BAT_GIZMO_NONE;
    for (int part = 0; part < BAT_GIZMO_PARTS; part++) {
        bat_gizmo_handle(g, part, at);
        if (!g->there[part] || !pixel_of(stage, at, seen)) continue;
        const double far = bat_hypot(seen[0] - pixel[0], seen[1] - pixel[1]);
        if (far <= best) best = far, found = part;
    }
    if (found != BAT_GIZMO_NONE) return found;
    best = CLOSE;
    for (int axis = 0; axis < 3; axis++)
        for (int turn = 0; turn < 2; turn++) {
            const int part = axis + (turn ? BAT_GIZMO_ABOUT : BAT_GIZMO_ALONG);
            if (!g->there[part]) continue;
            if (turn)
                bat_gizmo_arc(g, axis, line);
            else
                on_axis(g, axis, FREE, line), on_axis(g, axis, 1, line + 3);
            const double far = away(stage, turn ? BAT_GIZMO_ARC : 2, line, pixel);
            if (far <= best) best = far, found = part;
        }
    return found;
}

/* Where the pen is along an axis: the point of it that is nearest to the line of sight. */
static bool along_axis(const bat_gizmo *g, const bat_ray *ray, int axis, double *at) {
    const vec way = vec_load(ray->along, 3), from = vec_sub(vec_load(g->middle, 3), vec_load(ray->from, 3));
    const double cosine = ray->along[axis], start = g->middle[axis] - ray->from[axis];
    if (!(1 - cosine * cosine >= STEEP * STEEP)) return false;
    *at = (cosine * vec_dot(way, from) - start) / (1 - cosine * cosine);
    return true;
}

/* Where the pen is on the plane at right angles to an axis, from the middle. */
static bool on_plane(const bat_gizmo *g, const bat_ray *ray, int axis, bool deep, double at[3]) {
    const double sine = ray->along[axis], far = (g->middle[axis] - ray->from[axis]) / sine;
    if (!(fabs(sine) >= STEEP) || (deep && !(far > 0))) return false;
    for (int k = 0; k < 3; k++) at[k] = k == axis ? 0 : ray->from[k] + far * ray->along[k] - g->middle[k];
    return true;
}

bool bat_gizmo_drag(const bat_gizmo *g, const bat_stage *stage, int part, const double from[2],
                    const double to[2], double by[3]) {
    const bat_ray rays[2] = {bat_view_ray(&stage->view, from), bat_view_ray(&stage->view, to)};
    const int axis = part % 3, next = (axis + 1) % 3, last = (axis + 2) % 3;
    const bool deep = bat_stage_deep(stage);
    double at[2][3] = {{0}};
    for (int i = 0; i < 2; i++)
        if (part < BAT_GIZMO_ACROSS ? !along_axis(g, &rays[i], axis, &at[i][axis])
                                    : !on_plane(g, &rays[i], axis, deep, at[i]))
            return false;
    for (int k = 0; k < 3; k++) by[k] = at[1][k] - at[0][k];
    if (part < BAT_GIZMO_ABOUT) return true;
    const double turn = bat_atan2(at[1][last], at[1][next]) - bat_atan2(at[0][last], at[0][next]);
    by[0] = by[1] = by[2] = 0;
    by[axis] = turn > BAT_PI ? turn - 2 * BAT_PI : turn <= -BAT_PI ? turn + 2 * BAT_PI : turn;
    return true;
}

void bat_gizmo_rows(const bat_gizmo *g, int part, const double by[3], double rows[12]) {
    const int axis = part % 3;
    const double along[3] = {axis == 0, axis == 1, axis == 2};
    if (part < BAT_GIZMO_ABOUT)
        bat_pose_translation(by, rows);
    else
        bat_pose_rotation(by[axis], along, g->middle, rows);
}
