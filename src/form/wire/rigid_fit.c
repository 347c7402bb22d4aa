/* The best rotation from one set of points to another: the quaternion that belongs to the greatest eigenvalue of a symmetric
 * matrix (Horn 1987; the same rotation as Kabsch's). */
#include "form/wire/turner.h"

#include <math.h>
#include <string.h>

enum { SWEEPS = 16 };
static const double SAME =
    1e-9; /* eigenvalues, of the sum of the products of lengths: points on a line have two that are */

/* Cyclic Jacobi: m becomes diagonal, the columns of v its eigenvectors. */
static void turn_pair(double m[4][4], double v[4][4], int p, int q) {
    if (m[p][q] == 0) return;
    const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
    const double t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
    const double c = 1 / sqrt(t * t + 1), s = t * c;
    for (int k = 0; k < 4; k++) {
        const double a = m[k][p], b = m[k][q];
        m[k][p] = c * a - s * b, m[k][q] = s * a + c * b;
    }
    for (int k = 0; k < 4; k++) {
        const double a = m[p][k], b = m[q][k];
        m[p][k] = c * a - s * b, m[q][k] = s * a + c * b;
    }
    m[p][q] = m[q][p] = 0;
    for (int k = 0; k < 4; k++) {
        const double a = v[k][p], b = v[k][q];
        v[k][p] = c * a - s * b, v[k][q] = s * a + c * b;
    }
}

/* Of the vectors that belong to the greatest eigenvalue the one closest to no rotation, (0, 0, 0, 1). */
static quat greatest(double m[4][4], double v[4][4], double scale) {
    int top = 0;
    double sum[4] = {0, 0, 0, 0}, length = 0;
    for (int i = 1; i < 4; i++)
        if (m[i][i] > m[top][top]) top = i;
    for (int i = 0; i < 4; i++)
        if (m[i][i] >= m[top][top] - SAME * scale)
            for (int k = 0; k < 4; k++) sum[k] += v[3][i] * v[k][i];
    for (int k = 0; k < 4; k++) length += sum[k] * sum[k];
    if (length < 1e-12)
        for (int k = 0; k < 4; k++) sum[k] = v[k][top];
    return quat_unit((quat){sum[0], sum[1], sum[2], sum[3]});
}

static vec mean_of(size_t count, const vec *p) {
    vec sum = {0, 0, 0};
    for (size_t i = 0; i < count; i++) sum = vec_add(sum, vec_scale(p[i], 1 / (double)count));
    return sum;
}

static double size_of(size_t count, const vec *p, vec mean) {
    double most = 0;
    for (size_t i = 0; i < count; i++) {
        const vec d = vec_sub(p[i], mean);
        most = fmax(most, fmax(fabs(d.x), fmax(fabs(d.y), fabs(d.z))));
    }
    return most;
}

quat bat_rigid_fit(size_t count, const vec *a, const vec *b) {
    const vec ma = mean_of(count, a), mb = mean_of(count, b);
    const double sa = size_of(count, a, ma), sb = size_of(count, b, mb);
    double h[3][3] = {{0}}, scale = 0, v[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    if (!(sa > 0 && sb > 0)) return quat_one;
    for (size_t i = 0; i < count; i++) {
        const vec p = vec_scale(vec_sub(a[i], ma), 1 / sa), q = vec_scale(vec_sub(b[i], mb), 1 / sb);
        const double x[3] = {p.x, p.y, p.z}, y[3] = {q.x, q.y, q.z};
        for (int k = 0; k < 9; k++) h[k / 3][k % 3] += x[k / 3] * y[k % 3];
        scale += sqrt(vec_dot(p, p) * vec_dot(q, q));
    }
    double m[4][4] = {{h[0][0] - h[1][1] - h[2][2], h[0][1] + h[1][0], h[2][0] + h[0][2], h[1][2] - h[2][1]},
                      {h[0][1] + h[1][0], h[1][1] - h[0][0] - h[2][2], h[1][2] + h[2][1], h[2][0] - h[0][2]},
                      {h[2][0] + h[0][2], h[1][2] + h[2][1], h[2][2] - h[0][0] - h[1][1], h[0][1] - h[1][0]},
                      {h[1][2] - h[2][1], h[2][0] - h[0][2], h[0][1] - h[1][0], h[0][0] + h[1][1] + h[2][2]}};
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (int p = 0; p < 3; p++)
            for (int q = p + 1; q < 4; q++) turn_pair(m, v, p, q);
    return greatest(m, v, scale);
}
