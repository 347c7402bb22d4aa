/*
 * The isometric grid: triangles whose sides have the length `step`, made of three families of parallel lines: upright, and
 * 30 degrees to both sides of level. Lines of a family are `step` times the cosine of 30 degrees apart, one of each goes through
 * `zero`, and where two lines meet there is a third one.
 */
#ifndef BATTEN_EDITOR_PICK_ISOMETRIC_H
#define BATTEN_EDITOR_PICK_ISOMETRIC_H

enum { BAT_ISOMETRIC_FAMILIES = 3 };

/* The distance between neighbouring lines. */
double bat_isometric_gap(double step);
/* The unit normal of a family's lines: line k holds the points at k gaps from zero along it. */
const double *bat_isometric_normal(int family);
/* The corner of a triangle that is nearest to the point. */
void bat_isometric_corner(const double zero[2], double step, const double point[2], double out[2]);
/* The point of the nearest line of a family. */
void bat_isometric_foot(const double zero[2], double step, int family, const double point[2], double out[2]);

#endif
