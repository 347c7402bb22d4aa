/*
 * Batten: human motion. A take is what was recorded: a skeleton, and for each frame the places and angles of its joints, as
 * BVH files hold them. A motion is a take with few knots: the root goes along a path with levels, and each joint's rotation is
 * a spline of quaternions with levels in the joint's own axes (camera.h), so that the step and the jitter are edited apart.
 * Source: multilevel-2016, section 5; docs/math/motion.md.
 */
#ifndef BATTEN_MOTION_H
#define BATTEN_MOTION_H

#include <batten/types.h>
#include <batten/levels.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { BAT_JOINTS_MAX = 10000, BAT_CHANNELS_MAX = 6 };
#define BAT_TAKE_NUMBERS_MAX ((size_t)50000000) /* frames times channels */

/* Angles are in degrees. Those of a joint are turned through in the order of its channels, each about an axis that those
 * before it have turned. Places take the place of the offset. */
typedef enum bat_channel {
    BAT_X_POSITION,
    BAT_Y_POSITION,
    BAT_Z_POSITION,
    BAT_X_ROTATION,
    BAT_Y_ROTATION,
    BAT_Z_ROTATION
} bat_channel;

typedef struct bat_bone {
    const char *name;
    int parent;       /* an earlier joint; -1: it is the root, which is the first */
    bool end;         /* no joint, but where the last bone ends: without channels and children */
    double offset[3]; /* from the parent, in the parent's axes */
    int channel_count;
    bat_channel channels[BAT_CHANNELS_MAX]; /* each once */
} bat_bone;

typedef struct bat_take bat_take;

/* Copies all of it. values: for each frame the channels of the first joint, of the second, and so on. BAT_ARGUMENT: what is
 * said above does not hold, or the time of a frame is not above 0; BAT_COUNT: no joint, no frame, or more than the most;
 * BAT_NUMBER: a number is not finite or too large. */
BAT_API bat_status bat_take_create(int joint_count, const bat_bone *joints, size_t frames, double frame_time,
                                   const double *values, bat_take **out);
/* The same check, without a take; problem (may be NULL) says what is wrong: "joints[2].parent", "values[40]". */
BAT_API bat_status bat_take_check(int joint_count, const bat_bone *joints, size_t frames, double frame_time,
                                  const double *values, bat_problem *problem);
BAT_API void bat_take_free(bat_take *take); /* NULL is fine */
/* Owned by the take. */
BAT_API const bat_bone *bat_take_joints(const bat_take *take, int *count);
BAT_API const double *bat_take_values(const bat_take *take, size_t *frames, size_t *channels);
BAT_API double bat_take_frame_time(const bat_take *take); /* seconds */
/* Where the joints are in a frame: 3 numbers each, ends too. BAT_ARGUMENT: no such frame. O(joints). */
BAT_API bat_status bat_take_positions(const bat_take *take, size_t frame, double *out);

typedef struct bat_motion_options {
    size_t size; /* of this struct, as base.h says */
    double
        tolerance; /* degrees, of each rotation in each frame; the root's place: as far as the most distant joint of the
                       * skeleton moves by such an angle. 0: every frame is kept exactly, which takes one level at
                       * least */
    int levels; /* of detail, 0 to 12; what has few knots has the finest of them */
} bat_motion_options;

/* The defaults: half a degree, 3 levels. */
BAT_API void bat_motion_options_init(bat_motion_options *options, size_t size);
static inline bat_motion_options bat_motion_defaults(void) {
    bat_motion_options options;
    bat_motion_options_init(&options, sizeof options);
    return options;
}

typedef struct bat_motion_report {
    double max_error;    /* degrees, of a rotation in a frame */
    double max_distance; /* of the root's place in a frame */
    size_t keys_before,
        keys_after; /* rotations and places in all frames; control points of the finest splines */
    size_t numbers_before, numbers_after; /* channels in all frames; 3 numbers a point, since quaternions
                                           * are unit, and the knots between them */
} bat_motion_report;

typedef struct bat_motion bat_motion;

/* options may be NULL, report too. BAT_ARGUMENT: an option is out of range. Some milliseconds for a hundred frames of a
 * body. */
BAT_API bat_status bat_motion_fit(const bat_take *take, const bat_motion_options *options, bat_motion **out,
                                  bat_motion_report *report);
BAT_API bat_status bat_motion_copy(const bat_motion *motion, bat_motion **out); /* the take is shared */
BAT_API void bat_motion_free(bat_motion *motion);                               /* NULL is fine */
/* What it was made of; owned by the motion. */
BAT_API const bat_take *bat_motion_take(const bat_motion *motion);
/* Seconds from the first frame to the last; of one frame alone, the time of one. */
BAT_API double bat_motion_duration(const bat_motion *motion);
/* Where the joints are at a time in seconds, which is clamped to the take's: 3 numbers each, ends too. Joints other than the root
 * that have places have those of the nearest frame. BAT_NUMBER: the time is not finite. O(joints * levels). */
BAT_API bat_status bat_motion_positions(const bat_motion *motion, double time, double *out);
BAT_API int bat_motion_levels(const bat_motion *motion);
/* The rotation of a joint as the gaze of a camera move on a tripod, over the time of the take; NULL: it does not turn, or
 * there is no such joint. Its last level is level bat_motion_levels. Owned by the motion, here and below. */
BAT_API const bat_camera *bat_motion_joint(const bat_motion *motion, int joint);
/* Where the root goes, its last level likewise; NULL: it stays. */
BAT_API const bat_shape *bat_motion_path(const bat_motion *motion);

/* Scales the details of a level, 1 to bat_motion_levels, of one joint, or -1: of all, and of the path. 0 mutes it, 1 leaves it
 * as it is. BAT_ARGUMENT: no such joint or level; BAT_NUMBER: beyond +-1e6. */
BAT_API bat_status bat_motion_set_gain(bat_motion *motion, int joint, int level, double gain);
/* One of the angles of a joint at a time in seconds: angle 0 is its first channel that is one. Of all angles that give the rotation,
 * those nearest to the recorded ones. BAT_ARGUMENT: no such angle; BAT_NUMBER: the time is not finite. */
BAT_API bat_status bat_motion_angle(const bat_motion *motion, int joint, int angle, double time,
                                    double *degrees);
/*
 * Redraws an angle of a joint by a stroke over its graph: points[2 i] is a time in seconds, points[2 i + 1] the angle then, in
 * degrees. The stretch is from the least to the largest time among them, within the take's, and where the stroke runs back the
 * later part counts; beyond its ends the joint goes over into what it was, within two spans of the level and a tenth of a second.
 * The other angles of the joint stay. By the least squares change of one level (math 3.6): 1 to the last of the joint's, or 0, its
 * base; points of the level that do not meet the stretch keep every bit. BAT_COUNT: fewer than 2 points; BAT_ARGUMENT: no such angle
 * or level, or one that is silent; BAT_NUMBER: a number is not finite, or an angle beyond 1e6; BAT_TOLERANCE: the base can't. On
 * failure the motion is as it was. O(frames * count) at most.
 */
BAT_API bat_status bat_motion_redraw(bat_motion *motion, int joint, int angle, int level, size_t count,
                                     const double *points);
/* Puts another base under the path, in space, to whose domain the time is mapped: the details of the path and the body's
 * direction ride in its rotation-minimising frames. BAT_UNSUPPORTED: the root stays, or does not turn freely. */
BAT_API bat_status bat_motion_bend(bat_motion *motion, const bat_curve *path);
/* Gives it the style of another motion, all levels of detail above the bases, with their gains. BAT_ARGUMENT: the skeletons
 * differ in names or parents, or the numbers of levels differ. On failure the motion is as it was. */
BAT_API bat_status bat_motion_take_style(bat_motion *motion, const bat_motion *from);

/* The frames as the motion now has them, in the channels of the take it was made of: of all angles that give a rotation, those
 * nearest to that take's; a rotation within 1e-9 radians of that take's, and a place within 1e-12 of its size, keeps every
 * bit. Bones keep their lengths. */
BAT_API bat_status bat_motion_sample(const bat_motion *motion, bat_take **out);

#ifdef __cplusplus
}
#endif
#endif
