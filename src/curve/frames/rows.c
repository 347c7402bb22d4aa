/* The steps of double reflection in its parallel form (walk.c), each for many samples. */
#include "curve/frames/rows.h"

#include "base/lanes.h"

enum { Y = BAT_FRAME_PLANE, Z = 2 * BAT_FRAME_PLANE };

BAT_CLONES static bool reflect(int count, const double *restrict x0, const double *restrict t0,
                               const double *restrict s0, const double *restrict x1,
                               const double *restrict t1, double *restrict s1) {
    long long fault = 0;
    for (int i = 0; i < count; i++) {
        double ax = t0[i], ay = t0[Y + i], az = t0[Z + i], bx = t1[i], by = t1[Y + i], bz = t1[Z + i];
        double sx = s0[i], sy = s0[Y + i], sz = s0[Z + i];
        double vx = x1[i] - x0[i], vy = x1[Y + i] - x0[Y + i], vz = x1[Z + i] - x0[Z + i];
        double c1 = vx * vx + vy * vy + vz * vz, vs = vx * sx + vy * sy + vz * sz,
               vt = vx * ax + vy * ay + vz * az;
        /* v2 times c1: t1 - t0 + 2 (v1.t0) v1 / c1 */
        double wx = c1 * (bx - ax) + 2 * vt * vx, wy = c1 * (by - ay) + 2 * vt * vy,
               wz = c1 * (bz - az) + 2 * vt * vz;
        double c2 = wx * wx + wy * wy + wz * wz;
        long long within = (c1 > 1e-90) & (c1 < 1e90), plain = within & (c2 > 1e-20 * (c1 * c1));
        double cosine = ax * bx + ay * by + az * bz;
        double d1 = plain ? c1 : 1, d2 = plain ? c2 : 1 + cosine, one = 2 / (d1 * d2), k1 = vs * d2 * one;
        double lx = sx - k1 * vx, ly = sy - k1 * vy, lz = sz - k1 * vz;
        double k2 = (wx * lx + wy * ly + wz * lz) * d1 * one;
        double k = -0.5 * one * (sx * bx + sy * by + sz * bz);
        fault |= (!plain & !(cosine > 0.5)) | !(within | (c1 == 0));
        double x = plain ? lx - k2 * wx : sx + k * (ax + bx), y = plain ? ly - k2 * wy : sy + k * (ay + by),
               z = plain ? lz - k2 * wz : sz + k * (az + bz);
        /* Exactly at right angles to t and of unit length: one Newton step for the root. */
        double along = x * bx + y * by + z * bz;
        x -= along * bx, y -= along * by, z -= along * bz;
        double scale = 1.5 - 0.5 * (x * x + y * y + z * z);
        s1[i] = x * scale, s1[Y + i] = y * scale, s1[Z + i] = z * scale;
    }
    return !fault;
}

/* Without a branch (Duff et al. 2017). */
BAT_CLONES static void normals(int count, const double *restrict t, double *restrict e) {
    for (int i = 0; i < count; i++) {
        double x = t[i], y = t[Y + i], z = t[Z + i], sign = z < 0 ? -1 : 1, a = -1 / (sign + z);
        e[i] = 1 + sign * x * x * a, e[Y + i] = sign * x * y * a, e[Z + i] = -sign * x;
    }
}

BAT_CLONES static void measure(int count, int next, const double *restrict t, const double *restrict e,
                               const double *restrict s1, double *restrict re, double *restrict im) {
    for (int i = 0; i < count; i++) {
        int j = i + next;
        double ex = e[j], ey = e[Y + j], ez = e[Z + j], tx = t[j], ty = t[Y + j], tz = t[Z + j];
        double x = s1[i], y = s1[Y + i], z = s1[Z + i];
        re[i] = x * ex + y * ey + z * ez;
        im[i] = x * (ty * ez - tz * ey) + y * (tz * ex - tx * ez) + z * (tx * ey - ty * ex);
    }
}

BAT_CLONES static void spread(int count, const double *restrict t, const double *restrict e,
                              const double *restrict re, const double *restrict im, double *restrict s) {
    for (int i = 0; i < count; i++) {
        double ex = e[i], ey = e[Y + i], ez = e[Z + i], tx = t[i], ty = t[Y + i], tz = t[Z + i];
        s[i] = re[i] * ex + im[i] * (ty * ez - tz * ey);
        s[Y + i] = re[i] * ey + im[i] * (tz * ex - tx * ez);
        s[Z + i] = re[i] * ez + im[i] * (tx * ey - ty * ex);
    }
}

bool bat_rows_reflect(int count, const double *x0, const double *t0, const double *s0, const double *x1,
                      const double *t1, double *s1) {
    return reflect(count, x0, t0, s0, x1, t1, s1);
}

void bat_rows_normals(int count, const double *t, double *e) { normals(count, t, e); }

void bat_rows_measure(int count, int next, const double *t, const double *e, const double *s1, double *re,
                      double *im) {
    measure(count, next, t, e, s1, re, im);
}

void bat_rows_spread(int count, const double *t, const double *e, const double *re, const double *im,
                     double *s) {
    spread(count, t, e, re, im, s);
}

void bat_rows_multiply(int count, int next, vec s, const double *t, const double *e, double *re, double *im) {
    vec first = bat_rows_get(e, 0);
    double a = vec_dot(s, first), b = vec_dot(s, vec_cross(bat_rows_get(t, 0), first));
    for (int i = 0; i < count; i++, re += next, im += next) {
        /* Of unit length by one Newton step, for which the next product does not wait: it is not off by more than rounding. */
        double one = 1.5 - 0.5 * (a * a + b * b), x = *re, y = *im, turned = a * x - b * y;
        *re = a * one, *im = b * one;
        b = a * y + b * x, a = turned;
    }
}
