/* Internal to the library: rotations as unit quaternions, and rotation vectors (axis times angle in radians). */
#ifndef BATTEN_BASE_QUAT_H
#define BATTEN_BASE_QUAT_H

#include "base/vec.h"

typedef struct quat {
    double x, y, z, w;
} quat;

static const quat quat_one = {0, 0, 0, 1};

static inline quat quat_load(const double *q) { return (quat){q[0], q[1], q[2], q[3]}; }
static inline void quat_store(quat q, double *out) { out[0] = q.x, out[1] = q.y, out[2] = q.z, out[3] = q.w; }
static inline double quat_dot(quat a, quat b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
static inline double quat_norm(quat a) { return bat_hypot(bat_hypot(a.x, a.y), bat_hypot(a.z, a.w)); }
static inline quat quat_scale(quat a, double s) { return (quat){a.x * s, a.y * s, a.z * s, a.w * s}; }
static inline quat quat_inverse(quat a) { return (quat){-a.x, -a.y, -a.z, a.w}; } /* of a unit quaternion */
/* Zero stays zero. */
static inline quat quat_unit(quat a) {
    const double length = quat_norm(a);
    return length > 0 ? (quat){a.x / length, a.y / length, a.z / length, a.w / length} : a;
}
/* First b, then a. */
static inline quat quat_mul(quat a, quat b) {
    return (quat){
        a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
        a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
/* Of the two that are the same rotation, the one on b's side. */
static inline quat quat_near(quat a, quat b) { return quat_dot(a, b) < 0 ? quat_scale(a, -1) : a; }
static inline vec quat_turn(quat q, vec v) {
    const vec u = {q.x, q.y, q.z}, c = vec_scale(vec_cross(u, v), 2);
    return vec_add(v, vec_add(vec_scale(c, q.w), vec_cross(u, c)));
}
static inline quat quat_exp(vec d) {
    const double angle = vec_norm(d), half = 0.5 * angle;
    const double s = angle > 1e-9 ? bat_sin(half) / angle : 0.5;
    return (quat){s * d.x, s * d.y, s * d.z, bat_cos(half)};
}
/* The rotation vector of a unit quaternion, of length 0 to 2 pi: that of -q is the longer way round. */
static inline vec quat_log(quat q) {
    const vec v = {q.x, q.y, q.z};
    const double sine = vec_norm(v), angle = 2 * bat_atan2(sine, q.w);
    return vec_scale(v, sine > 1e-12 ? angle / sine : q.w > 0 ? 2 : 0);
}
/* The rotation that takes the axes x, y, z to these, which are right-handed unit vectors. */
static inline quat quat_of_axes(vec x, vec y, vec z) {
    const double trace = x.x + y.y + z.z;
    quat q;
    if (trace > 0)
        q = (quat){y.z - z.y, z.x - x.z, x.y - y.x, 1 + trace};
    else if (x.x >= y.y && x.x >= z.z)
        q = (quat){1 + x.x - y.y - z.z, y.x + x.y, z.x + x.z, y.z - z.y};
    else if (y.y >= z.z)
        q = (quat){y.x + x.y, 1 + y.y - x.x - z.z, z.y + y.z, z.x - x.z};
    else
        q = (quat){z.x + x.z, z.y + y.z, 1 + z.z - x.x - y.y, x.y - y.x};
    return quat_unit(q);
}

#endif
