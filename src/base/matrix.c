#include "base/matrix.h"

#include "base/real.h"

#include <math.h>
#include <string.h>

void bat_matrix_identity(double m[6]) {
    for (int i = 0; i < 6; i++) m[i] = i == 0 || i == 3;
}

void bat_matrix_compose(const double f[6], const double s[6], double out[restrict 6]) {
    out[0] = f[0] * s[0] + f[2] * s[1];
    out[1] = f[1] * s[0] + f[3] * s[1];
    out[2] = f[0] * s[2] + f[2] * s[3];
    out[3] = f[1] * s[2] + f[3] * s[3];
    out[4] = f[0] * s[4] + f[2] * s[5] + f[4];
    out[5] = f[1] * s[4] + f[3] * s[5] + f[5];
}

void bat_matrix_translation(double dx, double dy, double out[6]) {
    memcpy(out, (double[]){1, 0, 0, 1, dx, dy}, 6 * sizeof *out);
}

void bat_matrix_scaling(double sx, double sy, const double about[2], double out[6]) {
    memcpy(out, (double[]){sx, 0, 0, sy, about[0] - sx * about[0], about[1] - sy * about[1]},
           6 * sizeof *out);
}

void bat_matrix_rotation(double radians, const double about[2], double out[6]) {
    double c = bat_cos(radians), s = bat_sin(radians);
    memcpy(out,
           (double[]){c, s, -s, c, about[0] - c * about[0] + s * about[1],
                      about[1] - s * about[0] - c * about[1]},
           6 * sizeof *out);
}

void bat_matrix_rows(const double m[6], int dimension, double out[12]) {
    const double plane[12] = {m[0], m[2], m[4], m[1], m[3], m[5]};
    const double space[12] = {m[0], m[2], 0, m[4], m[1], m[3], 0, m[5], 0, 0, 1, 0};
    memcpy(out, dimension == 3 ? space : plane, sizeof space);
}

double bat_matrix_area(const double m[6]) { return fabs(m[0] * m[3] - m[1] * m[2]); }

bool bat_matrix_is_regular(const double m[4]) {
    const double area = m[0] * m[3] - m[1] * m[2];
    return area != 0 && isfinite(1 / area);
}
