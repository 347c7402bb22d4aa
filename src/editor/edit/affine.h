/* Affine images of objects. A matrix is {a, b, c, d, e, f}: x' = a x + c y + e, y' = b x + d y + f. */
#ifndef BATTEN_EDITOR_EDIT_AFFINE_H
#define BATTEN_EDITOR_EDIT_AFFINE_H

#include <batten/document.h>

void bat_affine_translation(double dx, double dy, double out[6]);
/* About a fixed point. */
void bat_affine_scaling(double sx, double sy, const double about[2], double out[6]);
void bat_affine_rotation(double radians, const double about[2], double out[6]);
/* The object's image; every curve is bat_curve_transform's. A spline stays one when its points give that very
 * curve (to rounding), else it becomes a path. strokes: the line width grows with the root of the area. */
bat_status bat_affine_object(const bat_object *object, const double matrix[6], bool strokes,
                             bat_object **out);

#endif
