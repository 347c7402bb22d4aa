/* Affine maps of space as three rows of four numbers, as bat_surface_transform takes them. */
#ifndef BATTEN_BASE_POSE_H
#define BATTEN_BASE_POSE_H

#include <batten/base.h>

/* What does nothing. */
extern const double bat_pose_none[12];
/* out(p) = a(b(p)); out may be one of the two. */
void bat_pose_multiply(const double a[12], const double b[12], double out[12]);
/* Points of 3 numbers each; out may be the same points. */
void bat_pose_apply(const double rows[12], size_t count, const double *points, double *out);
/* Whether it turns right hands into left ones. */
bool bat_pose_mirrors(const double rows[12]);

#endif
