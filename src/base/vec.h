/* Internal to the library: vectors in space; planar ones have z = 0. */
#ifndef BATTEN_BASE_VEC_H
#define BATTEN_BASE_VEC_H

#include "base/real.h"

#include <math.h>

typedef struct vec {
    double x, y, z;
} vec;

static inline vec vec_add(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline vec vec_sub(vec a, vec b) { return (vec){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline vec vec_scale(vec a, double s) { return (vec){a.x * s, a.y * s, a.z * s}; }
static inline double vec_dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline double vec_dot3(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
static inline vec vec_cross(vec a, vec b) {
    return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double vec_norm(vec a) { return bat_hypot(bat_hypot(a.x, a.y), a.z); }
/* Divides by the greatest coordinate first, so that neither huge nor tiny vectors overflow or underflow; zero
 * stays zero. */
static inline vec vec_unit(vec a) {
    double most = fmax(fmax(fabs(a.x), fabs(a.y)), fabs(a.z));
    if (!(most > 0)) return (vec){0, 0, 0};
    a = (vec){a.x / most, a.y / most, a.z / most};
    double length = sqrt(vec_dot(a, a));
    return (vec){a.x / length, a.y / length, a.z / length};
}
static inline double vec_angle(vec a, vec b) { return bat_atan2(vec_norm(vec_cross(a, b)), vec_dot(a, b)); }
/* The part of a at right angles to the unit t. */
static inline vec vec_reject(vec a, vec t) { return vec_sub(a, vec_scale(t, vec_dot(a, t))); }
/* A unit vector at right angles to t, always the same for the same t: made from the axis that t follows least. */
static inline vec vec_any_normal(vec t) {
    double x = fabs(t.x), y = fabs(t.y), z = fabs(t.z);
    vec axis = x <= y && x <= z ? (vec){1, 0, 0} : y <= z ? (vec){0, 1, 0} : (vec){0, 0, 1};
    return vec_unit(vec_reject(axis, t));
}
static inline vec vec_load(const double *p, int dimension) {
    return (vec){p[0], p[1], dimension == 3 ? p[2] : 0};
}
static inline void vec_store(vec v, double *p) { p[0] = v.x, p[1] = v.y, p[2] = v.z; }

#endif
