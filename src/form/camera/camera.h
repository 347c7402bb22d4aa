/* Internal: a camera move. */
#ifndef BATTEN_FORM_CAMERA_H
#define BATTEN_FORM_CAMERA_H

#include "base/users.h"
#include "form/camera/gaze.h"
#include "form/camera/pace.h"
#include "form/camera/rotation.h"

#include <batten/frames.h>

typedef struct bat_camera_level {
    bat_curve *details;
    double gain;
    bool muted;
    bat_camera_shake shake; /* what its details were drawn from; rate 0: nothing, or they have been changed */
} bat_camera_level;

/* The gain as it shows. */
static inline double bat_camera_loudness(const bat_camera_level *level) {
    return level->muted ? 0 : level->gain;
}

struct bat_camera {
    bat_camera_options options; /* what it points to is the camera's own */
    bat_rotation base;          /* no keys: none */
    bat_users *users; /* of what follows, down to the pace: copies share it, and nothing of it ever changes */
    bat_curve *path;  /* in space */
    bat_curve *given; /* as it was given: one in the plane has the frames of the plane */
    double domain[2];
    bat_frame_chain *chain; /* along */
    bat_look_at gaze;       /* look-at */
    bat_pace pace;
    int levels;
    bat_camera_level level[BAT_CAMERA_LEVELS_MAX];
};

/* A share of the domain, 0 to 1. */
double bat_camera_share(const bat_camera *camera, double u);
/* What the base is relative to. */
quat bat_camera_ground(const bat_camera *camera, double u);
/* The base as it would be given; false: there is none. Borrows from the camera. */
bool bat_camera_base_curve(const bat_camera *camera, bat_rotation_curve *out);
/* How many keys, and where, an along camera without a base gets as its first ones; gives it those. Nothing happens to one that
 * has a base. BAT_UNSUPPORTED: it looks at something. */
size_t bat_camera_first_keys(const bat_camera *camera);
double bat_camera_first_place(const bat_camera *camera, size_t key);
bat_status bat_camera_give_base(bat_camera *camera);
/* The point that it looks at; false: it looks at none. */
bool bat_camera_target(const bat_camera *camera, double target[3]);
/* The time at which it reaches a parameter. */
double bat_camera_time_of(const bat_camera *camera, double u);
/* Gives a camera without a path one, and all that is computed of it. What is there after a failure is freed with the camera. */
bat_status bat_camera_lay(bat_camera *camera, const bat_curve *path);
/* Another camera of these parts. NULL in `options`: as in bat_camera_create. Copies the levels of `from`. */
bat_status bat_camera_again(const bat_camera *from, const bat_curve *path, const bat_camera_options *options,
                            bat_camera **out);
/* The image under three rows of four numbers, of the page (base/pose.h) or such that turn, move and stretch: a path is moved by them
 * (NULL: the camera's own, else this one, which is there already), the gaze is turned by the rotation that is nearest to
 * them; a mirrored camera sees what is mirrored as the camera saw it, left and right exchanged. */
bat_status bat_camera_image(const bat_camera *camera, const double rows[12], const bat_curve *path,
                            bat_camera **out);
/* The rotation of levels 0..top at u, relative to the ground. */
quat bat_camera_up_to(const bat_camera *camera, int top, double u);
/* The detail of a level as it shows. */
quat bat_camera_detail(const bat_camera *camera, int level, double u);

#endif
