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
/* The last of these parameters, 1 when there is one frame alone. */
static inline double bat_motion_last(const bat_motion *motion) {
    return motion->take->frames > 1 ? (double)(motion->take->frames - 1) : 1;
}
/* Where the root is, which moves, and how a joint is turned, which turns, at such a parameter. */
vec bat_motion_place(const bat_motion *motion, double u);
quat bat_motion_turn(const bat_motion *motion, int joint, double u);
bat_shape_options bat_motion_shape_options(void);
/* A motion of parts that were one before: cameras on tripods over the frames for the joints that turn, NULL for the others; the
 * root's path as it was fitted, NULL: it stays; what it was bent onto, NULL: nothing. Takes the cameras and the path over, but not
 * the array, even on failure. BAT_ARGUMENT: a joint that turns has none, or one that does not has one, or not over the frames. */
bat_status bat_motion_assemble(const bat_take *take, int levels, bat_camera *const *joints, bat_shape *path,
                               const bat_curve *onto, bat_motion **out);
/* Replaces the rotation of a joint that turns, or the path that was fitted (and, where it is bent, the bent one); taken over on
 * success. */
bat_status bat_motion_set_joint(bat_motion *motion, int joint, bat_camera *camera);
bat_status bat_motion_set_path(bat_motion *motion, bat_shape *path);

#endif
