/* Internal: what is recorded frame by frame, as a spline with as few knots as keep a tolerance. */
#ifndef BATTEN_FORM_MOTION_TRACK_H
#define BATTEN_FORM_MOTION_TRACK_H

#include "base/quat.h"
#include "form/motion/spline.h"

#include <batten/camera.h>

/* Knots such that the spline of data[frames * 3] is within `tolerance` in every frame; 0: such that it goes through all. */
bat_status bat_track_knots(size_t frames, const double *data, double tolerance, bat_knots *out);
/* The rotations as the gaze of a camera on a tripod whose path's domain is the frames: a base and `levels` of detail, fewer
 * where there are too few knots, within `tolerance` radians in every frame (0: through all). *keys, *numbers: what the finest
 * spline takes. */
bat_status bat_track_turns(size_t frames, const quat *turns, double tolerance, int levels, double duration,
                           bat_camera **out, size_t *keys, size_t *numbers);

#endif
