/* Internal: a motion. */
#ifndef BATTEN_FORM_MOTION_MOTION_H
#define BATTEN_FORM_MOTION_MOTION_H

#include "form/camera/camera.h"
#include "form/motion/take.h"

#include <batten/frames.h>

struct bat_motion {
    bat_take *take; /* what it was made of */
    int levels;
    bat_camera **joints; /* of each joint; NULL: it does not turn */
    bat_shape *first,
        *bent; /* the path as it was fitted, NULL: the root stays; over another base, NULL: it is not */
    bat_frame_chain *old,
        *fresh; /* bent: the frames of the base that there was, and of that which is there now */
    double old_domain[2];
    bat_motion_report report;
};

/* The path as it is now. */
static inline bat_shape *bat_motion_way(const bat_motion *motion) {
    return motion->bent ? motion->bent : motion->first;
}
/* Where in the take's time a frame is: the parameter of its joints. */
double bat_motion_time(const bat_motion *motion, size_t frame);
bat_shape_options bat_motion_shape_options(void);

#endif
