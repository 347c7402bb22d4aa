#include "format/dxf/path.h"

#include "base/real.h"

#include <batten/bezier.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double CORNER = 0.05; /* radians */

static void put(bat_dxf_path *path, const double point[3]) {
    for (int k = 0; k < 3; k++)
        if (!bat_numbers_add(&path->points, point[k])) path->failed = true;
}

static const double *last(const bat_dxf_path *path) { return path->points.list + path->points.count - 3; }

static void piece(bat_dxf_path *path, const double a[3], const double b[3], const double to[3]) {
    put(path, a), put(path, b), put(path, to);
}

void bat_dxf_begin(bat_dxf_path *path, const double at[3]) {
    if (!path->begun) put(path, at);
    path->begun = true;
}

void bat_dxf_line(bat_dxf_path *path, const double to[3]) {
    double a[3], b[3];
    if (path->failed || memcmp(last(path), to, 3 * sizeof *to) == 0) return;
    for (int k = 0; k < 3; k++) {
        const double from = last(path)[k];
        a[k] = from + (to[k] - from) / 3, b[k] = to[k] - (to[k] - from) / 3;
    }
    piece(path, a, b, to);
}

void bat_dxf_sweep(bat_dxf_path *path, const double centre[3], const double x[3], const double y[3],
                   double from, double to) {
    const int n = (int)fmax(ceil(fabs(to - from) / (BAT_PI / 6) - 1e-9), 1);
    const double step = (to - from) / n, handle = 4.0 / 3.0 * bat_tan(step / 4);
    double at[3], along[3], points[3][3];
    path->curved = true;
    for (int i = 0; i <= n && !path->failed; i++) {
        const double t = i == n ? to : from + i * step, c = bat_cos(t), s = bat_sin(t);
        for (int k = 0; k < 3; k++) {
            const double here = centre[k] + c * x[k] + s * y[k], speed = c * y[k] - s * x[k];
            if (i > 0)
                points[0][k] = at[k] + handle * along[k], points[1][k] = here - handle * speed,
                points[2][k] = here;
            at[k] = here, along[k] = speed;
        }
        if (i > 0)
            piece(path, points[0], points[1], points[2]);
        else
            bat_dxf_begin(path, at);
    }
}

void bat_dxf_bulge(bat_dxf_path *path, const double to[3], double bulge) {
    if (path->failed) return;
    const double from[3] = {last(path)[0], last(path)[1], last(path)[2]};
    const double chord[2] = {to[0] - from[0], to[1] - from[1]};
    const double length = bat_hypot(chord[0], chord[1]);
    /* An arc that stays within 1e-9 of its chord, or one of more than a whole turn but for 1e-9, is drawn as the chord. */
    if (!(fabs(bulge) > 1e-9 && fabs(bulge) < 1e9) || !(length > 0)) {
        bat_dxf_line(path, to);
        return;
    }
    const double aside = (1 / bulge - bulge) / 4; /* from the chord's middle to the centre, in chords */
    const double centre[3] = {from[0] + chord[0] / 2 - aside * chord[1],
                              from[1] + chord[1] / 2 + aside * chord[0], from[2]};
    const double radius = length * (1 + bulge * bulge) / (4 * fabs(bulge));
    const double x[3] = {radius, 0, 0}, y[3] = {0, radius, 0};
    const double start = bat_atan2(from[1] - centre[1], from[0] - centre[0]);
    bat_dxf_sweep(path, centre, x, y, start, start + 4 * bat_atan(bulge));
    if (!path->failed) memcpy(path->points.list + path->points.count - 3, to, 3 * sizeof *to);
}

/* ---- the curve ---- */

static bat_status polyline(const bat_dxf_path *path, bool closed, int dimension, const double *points,
                           bat_curve **out) {
    const size_t ends = path->points.count / 9 + 1, count = ends - closed;
    double *chosen = malloc((ends * 3 + count + 2) * sizeof *chosen),
           *knots = chosen ? chosen + 3 * ends : NULL;
    if (!chosen) return BAT_MEMORY;
    for (size_t i = 0; i < ends; i++)
        memcpy(chosen + i * (size_t)dimension, points + 3 * i * (size_t)dimension,
               (size_t)dimension * sizeof *points);
    bat_status status = BAT_OK;
    if (closed) {
        for (size_t i = 0; i <= count; i++) knots[i] = (double)i;
        status = bat_curve_create(dimension, 1, true, count, chosen, (int)count + 1, knots, out);
    } else {
        status = bat_curve_create_clamped(dimension, 1, count, chosen, out);
    }
    free(chosen);
    return status;
}

bat_status bat_dxf_path_curve(bat_dxf_path *path, bool closed, const bat_dxf_place *place,
                              const bat_svg_options *how, bat_curve **out) {
    bat_status status = path->failed ? BAT_MEMORY : BAT_OK;
    const size_t segments = path->points.count / 9;
    *out = NULL;
    if (status == BAT_OK && closed && segments > 0)
        memcpy(path->points.list + path->points.count - 3, path->points.list, 3 * sizeof(double));
    if (status == BAT_OK && segments >= BAT_POINTS_MAX / 3) status = BAT_COUNT;
    if (status == BAT_OK && segments > 0) {
        const size_t count = 3 * segments + 1;
        double *points = path->points.list;
        for (size_t i = 0; i < count; i++) bat_dxf_put(place, points + 3 * i, points + 3 * i);
        const double side = bat_full_side(count, points);
        const int dimension = bat_full_pack(count, points);
        if (path->curved) {
            const double tolerance = how->share > 0 ? fmin(how->tolerance, how->share * side)
                                                    : how->tolerance;
            status = bat_curve_from_bezier(dimension, 3, closed, (int)segments, points,
                                           how->corner > 0 ? how->corner : CORNER, tolerance, out, NULL);
        } else {
            status = polyline(path, closed && segments > 1, dimension, points, out);
        }
    }
    bat_numbers_clear(&path->points);
    return status;
}
