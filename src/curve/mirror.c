#include "curve/mirror.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

bool bat_mirror_is_good(const bat_mirror *m) {
    for (int k = 0; k < 2; k++)
        if (!(fabs(m->at[k]) <= BAT_COORDINATE_MAX)) return false;
    return fabs(m->along[0] * m->along[0] + m->along[1] * m->along[1] - 1) <= 1e-9;
}

double bat_mirror_side(const bat_mirror *m, const double p[2]) {
    return (p[0] - m->at[0]) * m->along[1] - (p[1] - m->at[1]) * m->along[0];
}

double bat_mirror_along(const bat_mirror *m, const double p[2]) {
    return (p[0] - m->at[0]) * m->along[0] + (p[1] - m->at[1]) * m->along[1];
}

void bat_mirror_place(const bat_mirror *m, double s, double out[2]) {
    for (int k = 0; k < 2; k++) out[k] = m->at[k] + s * m->along[k];
}

void bat_mirror_point(const bat_mirror *m, const double p[2], double out[2]) {
    const double twice = 2 * bat_mirror_side(m, p), x = p[0] - twice * m->along[1];
    out[1] = p[1] + twice * m->along[0];
    out[0] = x;
}

void bat_mirror_matrix(const bat_mirror *m, double out[6]) {
    const double x = m->along[0], y = m->along[1];
    const double zero[2] = {0, 0};
    double to[2];
    bat_mirror_point(m, zero, to);
    const double all[6] = {1 - 2 * y * y, 2 * x * y, 2 * x * y, 1 - 2 * x * x, to[0], to[1]};
    memcpy(out, all, sizeof all);
}

bat_status bat_mirror_map(const bat_mirror *m, const bat_curve *curve,
                          void (*map)(const bat_mirror *m, const double p[2], double out[2]),
                          bat_curve **out) {
    const size_t count = bat_curve_count(curve);
    if (bat_curve_dimension(curve) != 2) return BAT_DIMENSION;
    double *points = malloc(2 * count * sizeof *points);
    if (!points) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) map(m, bat_curve_points(curve) + 2 * i, points + 2 * i);
    bat_status status = bat_curve_create(2, bat_curve_degree(curve), bat_curve_is_closed(curve), count,
                                         points, bat_curve_knot_count(curve), bat_curve_knots(curve), out);
    free(points);
    return status;
}

bat_status bat_mirror_curve(const bat_mirror *m, const bat_curve *curve, bat_curve **out) {
    return bat_mirror_map(m, curve, bat_mirror_point, out);
}
