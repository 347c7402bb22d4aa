#include "format/svg/outline.h"

#include "base/real.h"

#include <math.h>
#include <stdlib.h>

static bool make_room(bat_outline *o, size_t points) {
    if (o->failed || o->full) return false;
    if (o->count + points > (size_t)3 * BAT_OUTLINE_MAX) {
        o->full = true;
        return false;
    }
    if (o->count + points <= o->room) return true;
    size_t room = o->room < 64 ? 64 : o->room + o->room / 2;
    double *grown = realloc(o->points, room * 2 * sizeof *grown);
    if (!grown) {
        o->failed = true;
        return false;
    }
    o->points = grown;
    o->room = room;
    return true;
}

static void add_point(bat_outline *o, double x, double y) {
    o->points[2 * o->count] = x;
    o->points[2 * o->count + 1] = y;
    o->count++;
}

/* The subpath being drawn; begins one when there is none. */
static bat_subpath *current(bat_outline *o) {
    if (!make_room(o, 4)) return NULL;
    if (o->drawing) return &o->subpaths[o->subpath_count - 1];
    if (o->subpath_count == o->subpath_room) {
        int room = o->subpath_room < 8 ? 8 : o->subpath_room * 2;
        bat_subpath *grown = realloc(o->subpaths, (size_t)room * sizeof *grown);
        if (!grown) {
            o->failed = true;
            return NULL;
        }
        o->subpaths = grown;
        o->subpath_room = room;
    }
    bat_subpath *made = &o->subpaths[o->subpath_count++];
    *made = (bat_subpath){.first = o->count};
    o->start[0] = o->at[0], o->start[1] = o->at[1];
    add_point(o, o->at[0], o->at[1]);
    o->drawing = true;
    return made;
}

void bat_outline_move(bat_outline *o, double x, double y) {
    o->drawing = false;
    o->at[0] = o->start[0] = x;
    o->at[1] = o->start[1] = y;
}

void bat_outline_cubic(bat_outline *o, double x1, double y1, double x2, double y2, double x, double y) {
    bat_subpath *path = current(o);
    if (path) {
        add_point(o, x1, y1);
        add_point(o, x2, y2);
        add_point(o, x, y);
        path->segments++;
    }
    o->at[0] = x, o->at[1] = y;
}

void bat_outline_line(bat_outline *o, double x, double y) {
    double dx = (x - o->at[0]) / 3, dy = (y - o->at[1]) / 3;
    bat_outline_cubic(o, o->at[0] + dx, o->at[1] + dy, x - dx, y - dy, x, y);
}

void bat_outline_quadratic(bat_outline *o, double x1, double y1, double x, double y) {
    double x0 = o->at[0], y0 = o->at[1];
    bat_outline_cubic(o, x0 + 2 * (x1 - x0) / 3, y0 + 2 * (y1 - y0) / 3, x + 2 * (x1 - x) / 3,
                      y + 2 * (y1 - y) / 3, x, y);
}

void bat_outline_arc(bat_outline *o, double rx, double ry, double rotation, bool large, bool sweep, double x,
                     double y) {
    double x0 = o->at[0], y0 = o->at[1];
    rx = fabs(rx), ry = fabs(ry);
    if (x == x0 && y == y0) return;
    double angle = fmod(rotation, 360) * (BAT_PI / 180), c = bat_cos(angle), s = bat_sin(angle);
    /* On the unit circle: u is half the chord, v goes from its middle to the centre. */
    double hx = (x - x0) / 2, hy = (y - y0) / 2;
    double ux = (c * hx + s * hy) / rx, uy = (c * hy - s * hx) / ry, length = bat_hypot(ux, uy);
    if (!(length > 1e-150 &&
          length < 1e150)) { /* a radius that is zero, or far too small or too large for the chord */
        bat_outline_line(o, x, y);
        return;
    }
    if (length > 1) {
        rx *= length, ry *= length; /* radii too small to reach: scaled up, B.2.5 */
        ux /= length, uy /= length, length = 1;
    }
    double reach = sqrt(fmax(0, (1 - length) * (1 + length))) / length;
    if (large == sweep) reach = -reach;
    double vx = -reach * uy, vy = reach * ux;
    double from = bat_atan2(-uy - vy, -ux - vx), to = bat_atan2(uy - vy, ux - vx), turn = to - from;
    if (sweep && turn < 0) turn += 2 * BAT_PI;
    if (!sweep && turn > 0) turn -= 2 * BAT_PI;
    double mx = x0 + hx + c * rx * vx - s * ry * vy, my = y0 + hy + s * rx * vx + c * ry * vy;
    int n = (int)ceil(fabs(turn) / (BAT_PI / 6) - 1e-9);
    if (n < 1) n = 1;
    double step = turn / n, handle = 4.0 / 3.0 * bat_tan(step / 4);
    double pc = bat_cos(from), ps = bat_sin(from), px = x0, py = y0;
    for (int i = 1; i <= n; i++) {
        double qc = bat_cos(from + i * step), qs = bat_sin(from + i * step);
        double qx = i == n ? x : mx + c * rx * qc - s * ry * qs,
               qy = i == n ? y : my + s * rx * qc + c * ry * qs;
        double ax = -handle * ps, ay = handle * pc, bx = handle * qs, by = -handle * qc;
        bat_outline_cubic(o, px + c * rx * ax - s * ry * ay, py + s * rx * ax + c * ry * ay,
                          qx + c * rx * bx - s * ry * by, qy + s * rx * bx + c * ry * by, qx, qy);
        pc = qc, ps = qs, px = qx, py = qy;
    }
}

void bat_outline_close(bat_outline *o) {
    if (!o->drawing) return;
    if (o->at[0] != o->start[0] || o->at[1] != o->start[1]) bat_outline_line(o, o->start[0], o->start[1]);
    if (o->failed || o->full) return;
    o->subpaths[o->subpath_count - 1].closed = true;
    bat_outline_move(o, o->start[0], o->start[1]);
}

void bat_outline_transform(bat_outline *o, const double m[6]) {
    if (m[0] == 1 && m[1] == 0 && m[2] == 0 && m[3] == 1 && m[4] == 0 && m[5] == 0) return; /* keeps -0.0 */
    for (size_t i = 0; i < o->count; i++) {
        double *p = o->points + 2 * i, x = p[0], y = p[1];
        p[0] = m[0] * x + m[2] * y + m[4];
        p[1] = m[1] * x + m[3] * y + m[5];
    }
}

void bat_outline_clear(bat_outline *o) {
    o->count = 0, o->subpath_count = 0, o->drawing = false;
    o->at[0] = o->at[1] = o->start[0] = o->start[1] = 0;
}

void bat_outline_free(bat_outline *o) {
    free(o->points);
    free(o->subpaths);
    *o = (bat_outline){0};
}

/* ---- the box ---- */

static double cubic_at(const double *p, double t) {
    const double u = 1 - t;
    return u * u * u * p[0] + 3 * u * u * t * p[2] + 3 * u * t * t * p[4] + t * t * t * p[6];
}

static void widen(double value, double *low, double *high) {
    *low = fmin(*low, value);
    *high = fmax(*high, value);
}

/* One coordinate of a cubic, p[0], p[2], p[4], p[6]: where its derivative a t^2 + 2 b t + c is zero. */
static void widen_by_cubic(const double *p, double *low, double *high) {
    const double a = p[6] - 3 * p[4] + 3 * p[2] - p[0], b = p[4] - 2 * p[2] + p[0], c = p[2] - p[0];
    const double root = b * b - a * c;
    widen(p[0], low, high);
    widen(p[6], low, high);
    if (!(root >= 0)) return;
    const double q = -(b + (b < 0 ? -1 : 1) * sqrt(root)), t[2] = {q / a, c / q};
    for (int i = 0; i < 2; i++)
        if (t[i] > 0 && t[i] < 1) widen(cubic_at(p, t[i]), low, high);
}

void bat_outline_box(const bat_outline *outline, double box[4]) {
    box[0] = box[1] = INFINITY, box[2] = box[3] = -INFINITY;
    for (int i = 0; i < outline->subpath_count; i++) {
        const bat_subpath *path = &outline->subpaths[i];
        for (int k = 0; k < path->segments; k++)
            for (int axis = 0; axis < 2; axis++)
                widen_by_cubic(outline->points + 2 * (path->first + 3 * (size_t)k) + axis, &box[axis],
                               &box[axis + 2]);
    }
}
