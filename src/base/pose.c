#include "base/pose.h"

#include "base/real.h"

#include <string.h>

const double bat_pose_none[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

void bat_pose_multiply(const double a[12], const double b[12], double out[12]) {
    double made[12];
    for (int i = 0; i < 12; i++) {
        const int row = i / 4 * 4, column = i % 4;
        made[i] = a[row] * b[column] + a[row + 1] * b[4 + column] + a[row + 2] * b[8 + column];
        if (column == 3) made[i] += a[row + 3];
    }
    memcpy(out, made, sizeof made);
}

void bat_pose_apply(const double rows[12], size_t count, const double *points, double *out) {
    for (size_t i = 0; i < 3 * count; i += 3) {
        const double x = points[i], y = points[i + 1], z = points[i + 2];
        for (size_t k = 0; k < 3; k++)
            out[i + k] = rows[4 * k] * x + rows[4 * k + 1] * y + rows[4 * k + 2] * z + rows[4 * k + 3];
    }
}

void bat_pose_turn(const double rows[12], size_t count, const double *directions, double *out) {
    double turn[12];
    memcpy(turn, rows, sizeof turn);
    turn[3] = turn[7] = turn[11] = 0;
    bat_pose_apply(turn, count, directions, out);
}

bool bat_pose_in_plane(const double r[12], double m[6]) {
    if (r[2] != 0 || r[6] != 0 || r[8] != 0 || r[9] != 0 || r[10] != 1 || r[11] != 0) return false;
    memcpy(m, (double[]){r[0], r[4], r[1], r[5], r[3], r[7]}, 6 * sizeof *m);
    return true;
}

void bat_pose_translation(const double by[3], double out[12]) {
    memcpy(out, bat_pose_none, sizeof bat_pose_none);
    for (int k = 0; k < 3; k++) out[4 * k + 3] = by[k];
}

void bat_pose_rotation(double radians, const double a[3], const double about[3], double out[12]) {
    const double c = bat_cos(radians), s = bat_sin(radians), rest = 1 - c;
    const double cross[9] = {0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0};
    for (int i = 0; i < 3; i++) {
        out[4 * i + 3] = about[i];
        for (int k = 0; k < 3; k++) {
            /* Exact about the axes of the drawing: what lies in the page stays there. */
            const double kept = a[i] * a[k] == 1 ? 1 : (i == k ? c : 0) + rest * a[i] * a[k];
            out[4 * i + k] = kept + s * cross[3 * i + k] + 0.0;
            out[4 * i + 3] -= out[4 * i + k] * about[k];
        }
        if (a[i] == 1 || a[i] == -1) out[4 * i + 3] = 0;
    }
}

bool bat_pose_mirrors(const double m[12]) {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
               m[2] * (m[4] * m[9] - m[5] * m[8]) <
           0;
}
