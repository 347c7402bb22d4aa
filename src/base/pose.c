#include "base/pose.h"

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

bool bat_pose_mirrors(const double m[12]) {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
               m[2] * (m[4] * m[9] - m[5] * m[8]) <
           0;
}
