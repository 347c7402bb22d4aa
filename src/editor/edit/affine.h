/* Affine images of objects. */
#ifndef BATTEN_EDITOR_EDIT_AFFINE_H
#define BATTEN_EDITOR_EDIT_AFFINE_H

#include <batten/document.h>

/* The object's image under a matrix of base/matrix.h; every curve is bat_curve_transform's. A spline stays one when its
 * points give that very curve (to rounding), else it becomes a path. strokes: the line width grows with the root of the
 * area. BAT_ARGUMENT: the object's kind has no image. */
bat_status bat_affine_object(const bat_object *object, const double matrix[6], bool strokes,
                             bat_object **out);

#endif
