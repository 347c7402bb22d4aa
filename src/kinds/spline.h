/* A spline as an object keeps it: a counted value with arrays of its own, shared by copies of the object. */
#ifndef BATTEN_KINDS_SPLINE_H
#define BATTEN_KINDS_SPLINE_H

#include "base/users.h"

#include <batten/tangents.h>

typedef struct bat_kept_spline {
    bat_users users;
    bat_spline spline; /* its arrays lie behind it in the same block; none is NULL */
    bat_tangents_options options;
} bat_kept_spline;

/* Copies the spline and makes its curve. What bat_tangents refuses is refused. Directions of no length become
 * plain zeros, so that equal splines have equal bits. */
bat_status bat_kept_spline_create(const bat_spline *spline, const bat_tangents_options *options,
                                  bat_kept_spline **out, bat_curve **curve);
void bat_kept_spline_release(bat_kept_spline *kept); /* NULL is fine */
uint64_t bat_kept_spline_digest(uint64_t digest, const bat_kept_spline *kept);
/* NULL, or what does not hold: the curve is the one that the spline gives. */
const char *bat_kept_spline_check(const bat_kept_spline *kept, const bat_curve *curve);

#endif
