#include "editor/pick/isometric.h"
#include "base/real.h"
#include <math.h>

#define COSINE 0.86602540378443864676 /* of 30 degrees */

double bat_isometric_gap(double step) { return COSINE * step; }

const double *bat_isometric_normal(int family) {
    static const double normals[BAT_ISOMETRIC_FAMILIES][2] = {{1, 0}, {-0.5, COSINE}, {0.5, COSINE}};
    return normals[family];
}

/* How far the point lies from the family's line through zero, in gaps. */
static double gaps(const double zero[2], double step, int family, const double point[2]) {
    const double *normal = bat_isometric_normal(family);
    return ((point[0] - zero[0]) * normal[0] + (point[1] - zero[1]) * normal[1]) / bat_isometric_gap(step);
}

void bat_isometric_corner(const double zero[2], double step, const double point[2], double out[2]) {
    const double across = gaps(zero, step, 0, point);
    double least = INFINITY;
    /* The upright lines on both sides, and of each the corner that is next in height: every other one is farther away. */
    for (int side = 0; side < 2; side++) {
        const double column = floor(across) + side, middle = column / 2;
        const double row = round((point[1] - zero[1]) / step - middle) + middle;
        const double at[2] = {zero[0] + column * bat_isometric_gap(step), zero[1] + row * step};
        const double distance = bat_hypot(at[0] - point[0], at[1] - point[1]);
        if (distance >= least) continue;
        least = distance;
        out[0] = at[0];
        out[1] = at[1];
    }
}

void bat_isometric_foot(const double zero[2], double step, int family, const double point[2], double out[2]) {
    const double *normal = bat_isometric_normal(family), at = gaps(zero, step, family, point);
    for (int k = 0; k < 2; k++) out[k] = point[k] + (round(at) - at) * bat_isometric_gap(step) * normal[k];
}
