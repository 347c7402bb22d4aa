/* Affine maps of the plane. A matrix is {a, b, c, d, e, f}, as in SVG: x' = a x + c y + e, y' = b x + d y + f. */
#ifndef BATTEN_BASE_MATRIX_H
#define BATTEN_BASE_MATRIX_H

#include <stdbool.h>

void bat_matrix_identity(double m[6]);
/* out(p) = first(second(p)). out must be neither of the two. */
void bat_matrix_compose(const double first[6], const double second[6], double out[restrict 6]);
void bat_matrix_translation(double dx, double dy, double out[6]);
/* Scaling and rotation about a fixed point. */
void bat_matrix_scaling(double sx, double sy, const double about[2], double out[6]);
void bat_matrix_rotation(double radians, const double about[2], double out[6]);
/* The matrix as bat_curve_transform takes it, for a curve of that dimension (2 or 3; a third coordinate is
 * unchanged). */
void bat_matrix_rows(const double m[6], int dimension, double out[12]);
/* The factor by which the matrix scales areas, without sign. */
double bat_matrix_area(const double m[6]);
/* Whether {a, b, c, d} can be inverted. */
bool bat_matrix_is_regular(const double m[4]);

#endif
