/* Internal: a take. */
#ifndef BATTEN_FORM_MOTION_TAKE_H
#define BATTEN_FORM_MOTION_TAKE_H

#include "base/quat.h"
#include "base/users.h"

#include <batten/motion.h>

struct bat_take {
    bat_users users; /* takes do not change once they are made: motions share them */
    int joint_count;
    bat_bone *joints; /* whose names lie in `names` */
    int *first;       /* of each joint: its first channel in a frame */
    char *names;
    size_t frames, channels;
    double frame_time, *values;
};

/* The place of a joint in its parent's axes, and its rotation, in a frame. */
vec bat_take_place(const bat_take *take, int joint, size_t frame);
quat bat_take_turn(const bat_take *take, int joint, size_t frame);
/* One more user of the same take, which bat_take_free takes away. */
bat_take *bat_take_share(const bat_take *take);
/* A copy with room for other values, which are those of the take. */
bat_status bat_take_copy(const bat_take *take, bat_take **out);
/* The angles of a joint as they were recorded, and zeros. */
void bat_take_angles(const bat_take *take, int joint, size_t frame, double angles[3]);
/* Sets the angles of a joint to a rotation, of all that give it those nearest to the angles that are there. Angles of a joint
 * with fewer than three give what they can. */
void bat_take_set_turn(bat_take *take, int joint, size_t frame, quat turn);
/* The same for angles alone, those of the joint's channels that are angles, in their order; and the turn that angles give. */
void bat_bone_angles(const bat_bone *joint, quat turn, double angles[3]);
quat bat_bone_turn(const bat_bone *joint, const double angles[3]);
void bat_take_set_place(bat_take *take, int joint, size_t frame, vec place);
int bat_bone_turns(const bat_bone *joint);  /* how many of its channels are angles */
int bat_bone_places(const bat_bone *joint); /* and how many are places */

#endif
