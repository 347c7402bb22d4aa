/* The parts of a motion: copies, another rotation of a joint, another path; where the joints are at any time. */
#include "form/motion/motion.h"

#include <math.h>
#include <stdlib.h>

/* ---- parts ---- */

static bool fits(const bat_motion *m, int joint, const bat_camera *camera) {
    double domain[2];
    if ((bat_bone_turns(&m->take->joints[joint]) > 0) != (camera != NULL)) return false;
    if (!camera) return true;
    bat_camera_domain(camera, domain);
    return bat_camera_mode_of(camera) == BAT_CAMERA_FREE && domain[0] == 0 && domain[1] == bat_motion_last(m);
}

bat_status bat_motion_assemble(const bat_take *take, int levels, bat_camera *const *joints, bat_shape *path,
                               const bat_curve *onto, bat_motion **out) {
    const int count = take->joint_count; /* 1 to BAT_JOINTS_MAX */
    bat_motion *made = calloc(1, sizeof *made);
    bat_camera **kept = calloc((size_t)(unsigned)count, sizeof *kept);
    if (!made || !kept) {
        for (int i = 0; i < count; i++) bat_camera_free(joints[i]);
        bat_shape_free(path);
        free(made), free(kept);
        return BAT_MEMORY;
    }
    *made = (bat_motion){.take = bat_take_share(take), .levels = levels, .joints = kept, .first = path};
    bat_status status = BAT_OK;
    for (int i = 0; i < count; i++) {
        kept[i] = joints[i];
        if (!fits(made, i, kept[i])) status = BAT_ARGUMENT;
    }
    if (path && bat_bone_places(&take->joints[0]) == 0) status = BAT_ARGUMENT;
    if (status == BAT_OK && onto) status = bat_motion_bend(made, onto);
    if (status == BAT_OK)
        *out = made;
    else
        bat_motion_free(made);
    return status;
}

bat_status bat_motion_copy(const bat_motion *motion, bat_motion **out) {
    if (!motion || !out) return BAT_ARGUMENT;
    const int count = motion->take->joint_count; /* 1 to BAT_JOINTS_MAX */
    bat_camera **joints = calloc((size_t)(unsigned)count, sizeof *joints);
    bat_shape *path = NULL;
    bat_motion *made = NULL;
    bat_status status = joints ? BAT_OK : BAT_MEMORY;
    for (int i = 0; i < count && status == BAT_OK; i++)
        if (motion->joints[i]) status = bat_camera_copy(motion->joints[i], &joints[i]);
    if (status == BAT_OK && motion->first) status = bat_shape_copy(motion->first, &path);
    if (status == BAT_OK) {
        const bat_curve *onto = motion->bent ? bat_shape_curve(motion->bent, 0) : NULL;
        status = bat_motion_assemble(motion->take, motion->levels, joints, path, onto, &made);
    } else {
        for (int i = 0; i < count && joints; i++) bat_camera_free(joints[i]);
    }
    free(joints);
    if (status != BAT_OK) return status;
    made->report = motion->report;
    *out = made;
    return BAT_OK;
}

bat_status bat_motion_set_joint(bat_motion *motion, int joint, bat_camera *camera) {
    if (joint < 0 || joint >= motion->take->joint_count || !camera || !fits(motion, joint, camera))
        return BAT_ARGUMENT;
    bat_camera_free(motion->joints[joint]);
    motion->joints[joint] = camera;
    return BAT_OK;
}

bat_status bat_motion_set_path(bat_motion *motion, bat_shape *path) {
    if (!motion->first || !path) return BAT_ARGUMENT;
    bat_shape *before = motion->first;
    motion->first = path;
    if (motion->bent) {
        const bat_status status = bat_motion_bend(motion, bat_shape_curve(motion->bent, 0));
        if (status != BAT_OK) {
            motion->first = before;
            return status;
        }
    }
    bat_shape_free(before);
    return BAT_OK;
}

const bat_take *bat_motion_take(const bat_motion *motion) { return motion->take; }

/* ---- times ---- */

double bat_motion_duration(const bat_motion *motion) {
    return motion->take->frame_time * bat_motion_last(motion);
}

bat_status bat_motion_positions(const bat_motion *motion, double time, double *out) {
    if (!motion || !out) return BAT_ARGUMENT;
    if (!isfinite(time)) return BAT_NUMBER;
    const bat_take *take = motion->take;
    quat *turns = malloc((size_t)take->joint_count * sizeof *turns);
    if (!turns) return BAT_MEMORY;
    const double last = bat_motion_last(motion), u = fmin(fmax(time / take->frame_time, 0), last);
    const size_t frame = (size_t)fmin(u + 0.5, (double)(take->frames - 1));
    for (int i = 0; i < take->joint_count; i++) {
        const int parent = take->joints[i].parent;
        const quat own = motion->joints[i] ? quat_unit(bat_motion_turn(motion, i, u)) : quat_one;
        vec at = i == 0 && motion->first ? bat_motion_place(motion, u) : bat_take_place(take, i, frame);
        if (parent >= 0) at = vec_add(vec_load(out + (ptrdiff_t)3 * parent, 3), quat_turn(turns[parent], at));
        turns[i] = parent < 0 ? own : quat_unit(quat_mul(turns[parent], own));
        vec_store(at, out + (ptrdiff_t)3 * i);
    }
    free(turns);
    return BAT_OK;
}
