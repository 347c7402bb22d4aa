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
/* The same of directions, which no translation moves. */
void bat_pose_turn(const double rows[12], size_t count, const double *directions, double *out);
/* The map of the page that it is for what lies there, {a, b, c, d, e, f} as in base/matrix.h; false: the page does not stay
 * the page, or heights change. */
bool bat_pose_in_plane(const double rows[12], double m[6]);
void bat_pose_translation(const double by[3], double out[12]);
/* By radians, right-handed, about the line through a point along a direction of length 1. */
void bat_pose_rotation(double radians, const double axis[3], const double about[3], double out[12]);
/* Whether it turns right hands into left ones. */
bool bat_pose_mirrors(const double rows[12]);

#endif
