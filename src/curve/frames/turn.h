/* Inside the library: unit vectors turned. */
#ifndef BATTEN_CURVE_FRAMES_TURN_H
#define BATTEN_CURVE_FRAMES_TURN_H

#include "base/vec.h"

/* The least rotation that takes t0 to t1, applied to s. */
static inline vec bat_turn_least(vec s, vec t0, vec t1) {
    double c = 1 + vec_dot(t0, t1);
    return c > 1e-14 ? vec_sub(s, vec_scale(vec_add(t0, t1), vec_dot(s, t1) / c)) : s;
}
/* s turned about t by an angle. */
static inline vec bat_turn_about(vec s, vec t, double angle) {
    return vec_add(vec_scale(s, bat_cos(angle)), vec_scale(vec_cross(t, s), bat_sin(angle)));
}
/* s at right angles to t again, and of unit length. */
static inline vec bat_square_up(vec s, vec t) { return vec_unit(vec_reject(s, t)); }

#endif
