#include "document/placed.h"

#include "base/matrix.h"

#include <math.h>

void bat_placed_corners(const bat_placed *g, double corners[8]) {
    const double *m = g->matrix;
    double sides[2];
    bat_picture_sides(g->picture, sides);
    for (int i = 0; i < 4; i++) {
        double x = i == 1 || i == 2 ? sides[0] : 0, y = i >= 2 ? sides[1] : 0;
        corners[2 * i] = m[0] * x + m[2] * y + m[4];
        corners[2 * i + 1] = m[1] * x + m[3] * y + m[5];
    }
}

bat_status bat_placed_set(const bat_picture *picture, const double matrix[6], bat_placed *out) {
    double corners[8];
    out->picture = (bat_picture *)picture; /* no reference added yet */
    for (int i = 0; i < 6; i++) out->matrix[i] = matrix[i] + 0.0;
    if (!(bat_matrix_area(matrix) > 0)) return BAT_NUMBER;
    bat_placed_corners(out, corners);
    for (int i = 0; i < 8; i++)
        if (!(fabs(corners[i]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    return BAT_OK;
}

void bat_placed_bounds(const void *own, double box[4]) {
    double corners[8];
    bat_placed_corners(own, corners);
    for (int i = 0; i < 8; i++) {
        box[i & 1] = fmin(box[i & 1], corners[i]);
        box[2 + (i & 1)] = fmax(box[2 + (i & 1)], corners[i]);
    }
}
