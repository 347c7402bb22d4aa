/* Internal: what shows a camera: a pyramid from the eye to its picture, with a tip that is up. */
#ifndef BATTEN_FORM_CAMERA_PYRAMID_H
#define BATTEN_FORM_CAMERA_PYRAMID_H

#include <batten/camera.h>

enum { BAT_PYRAMID_CORNERS = 11 };

/* How deep the pyramids of a camera are: a tenth of its path's size; of a tripod 24 document units. */
double bat_pyramid_depth(const bat_camera *camera);
/* One line through all its edges, 3 numbers a point. */
void bat_pyramid_of(const bat_camera_pose *pose, double depth, double points[3 * BAT_PYRAMID_CORNERS]);

#endif
