/* Affine images of objects. */
#ifndef BATTEN_EDITOR_EDIT_AFFINE_H
#define BATTEN_EDITOR_EDIT_AFFINE_H

#include <batten/document.h>

/* Whether a matrix changes it: not groups, unless they are clipped. */
bool bat_affine_moves(const bat_object *object);
/* The object's image under three rows of four numbers (base/pose.h), which turn, move and stretch when they lead out of the page; every curve is as bat_curve_transform makes it. A spline stays
 * a spline when its points give exactly that curve (to rounding); otherwise it becomes a path. strokes: the line
 * width grows with the square root of the area. Of a group, what is seen of it is mapped. BAT_ARGUMENT: objects of this kind have no image. BAT_UNSUPPORTED: it
 * stays on the page, as texts, pictures, and what is clipped do. */
bat_status bat_affine_pose(const bat_object *object, const double rows[12], bool strokes, bat_object **out);
/* The same under a matrix of base/matrix.h. */
bat_status bat_affine_object(const bat_object *object, const double matrix[6], bool strokes,
                             bat_object **out);

#endif
