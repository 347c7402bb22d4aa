/*
 * Round handles: the velocity function of J. D. Hobby, Smooth, Easy to Compute Interpolating Splines, 1986. With theta and
 * phi the angles from the chord to both directions it has only their cosines, u and v, the squares of their sines, and
 * the product of these; written with vectors it needs no angle, and holds in space.
 */
#include "hands/tangents/handle.h"

static const double LONGEST = 2; /* chords */

double bat_round_handle(vec t0, vec t1, vec c) {
    const double u = vec_dot(t0, c), v = vec_dot(t1, c), sines = u * v - vec_dot(t0, t1);
    const double root = sqrt(5), skew = sines * (1 + 1 / 256.0) - (2 - u * u - v * v) / 16;
    const double room = 3 * (1 + (root - 1) / 2 * u + (3 - root) / 2 * v),
                 length = 2 + sqrt(2) * skew * (u - v);
    return room * LONGEST > length ? length / room : LONGEST;
}
