/* Edits of motions: gains of levels, another path, the style of another motion (docs/math/motion.md). */
#include "form/motion/motion.h"

#include "curve/frames/converged.h"
#include "hands/levels/shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double gain_most = 1e6;

/* ---- gains ---- */

/* The level of something with `own` levels, the last of which is the last of `all`; 0: it has none such. */
static int level_in(int level, int all, int own) { return level - all + own > 0 ? level - all + own : 0; }

static void set_joint(bat_motion *m, int joint, int level, double gain) {
    bat_camera *camera = m->joints[joint];
    const int own = camera ? level_in(level, m->levels, camera->levels) : 0;
    if (own > 0) bat_camera_set_gain(camera, own, gain);
}

bat_status bat_motion_set_gain(bat_motion *motion, int joint, int level, double gain) {
    if (!motion || joint < -1 || joint >= motion->take->joint_count || level < 1 || level > motion->levels)
        return BAT_ARGUMENT;
    if (!(fabs(gain) <= gain_most)) return BAT_NUMBER;
    if (joint >= 0) {
        set_joint(motion, joint, level, gain);
        return BAT_OK;
    }
    const int own = motion->first ? level_in(level, motion->levels, bat_shape_levels(motion->first)) : 0;
    bat_status status = own > 0 ? bat_shape_set_gain(motion->first, own, gain) : BAT_OK;
    if (status == BAT_OK && own > 0 && motion->bent) status = bat_shape_set_gain(motion->bent, own, gain);
    for (int i = 0; i < motion->take->joint_count && status == BAT_OK; i++) set_joint(motion, i, level, gain);
    return status;
}

/* ---- the path ---- */

/* The path's levels over another base. */
static bat_status rebase(const bat_shape *path, const bat_curve *onto, bat_shape **out) {
    const bat_shape_options options = bat_motion_shape_options();
    const bat_curve *base = bat_shape_curve(path, 0);
    bat_knot_map map = {.count = 2, .drawn = -1, .closed = bat_curve_is_closed(base)};
    bat_curve_domain(base, map.from);
    bat_curve_domain(onto, map.to);
    return bat_shape_copy_mapped(path, onto, &options, &map, out);
}

static bat_status chain_of(const bat_curve *path, bat_frame_chain **out) {
    const bat_shape_options like = bat_motion_shape_options();
    bat_frame_options options = bat_frame_defaults();
    options.has_first = true;
    memcpy(options.first, like.first, sizeof options.first);
    return bat_frame_chain_converged(path, &options, out);
}

bat_status bat_motion_bend(bat_motion *motion, const bat_curve *path) {
    if (!motion || !path) return BAT_ARGUMENT;
    if (!motion->first || bat_bone_turns(&motion->take->joints[0]) != 3 || bat_curve_is_closed(path))
        return BAT_UNSUPPORTED;
    bat_curve *space = NULL;
    bat_shape *made = NULL;
    bat_frame_chain *old = NULL, *fresh = NULL;
    const bat_curve *base = bat_shape_curve(motion->first, 0);
    bat_status status = bat_curve_to_dimension(path, 3, &space);
    if (status == BAT_OK) status = rebase(motion->first, space, &made);
    if (status == BAT_OK) status = chain_of(space, &fresh);
    if (status == BAT_OK && !motion->old) status = chain_of(base, &old);
    bat_curve_free(space);
    if (status != BAT_OK) {
        bat_shape_free(made);
        bat_frame_chain_free(fresh);
        return status;
    }
    bat_shape_free(motion->bent);
    bat_frame_chain_free(motion->fresh);
    motion->bent = made, motion->fresh = fresh;
    if (old) motion->old = old;
    bat_curve_domain(base, motion->old_domain);
    return BAT_OK;
}

/* ---- style ---- */

static bool same_skeleton(const bat_take *a, const bat_take *b) {
    if (a->joint_count != b->joint_count) return false;
    for (int i = 0; i < a->joint_count; i++)
        if (strcmp(a->joints[i].name, b->joints[i].name) != 0 || a->joints[i].parent != b->joints[i].parent)
            return false;
    return true;
}

/* A joint's base under another joint's levels. NULL: one of them does not turn. */
static bat_status restyle(const bat_camera *joint, const bat_camera *from, bat_camera **out) {
    bat_rotation_curve base;
    *out = NULL;
    if (!joint || !from || !bat_camera_base_curve(joint, &base)) return BAT_OK;
    bat_camera_options options = joint->options;
    options.base = &base;
    return bat_camera_again(from, joint->given, &options, out);
}

bat_status bat_motion_take_style(bat_motion *motion, const bat_motion *from) {
    if (!motion || !from || motion->levels != from->levels || !same_skeleton(motion->take, from->take))
        return BAT_ARGUMENT;
    const int count = motion->take->joint_count; /* 1 to BAT_JOINTS_MAX */
    bat_camera **joints = calloc((size_t)(unsigned)count, sizeof *joints);
    bat_shape *first = NULL, *bent = NULL;
    bat_status status = joints ? BAT_OK : BAT_MEMORY;
    for (int i = 0; i < count && status == BAT_OK; i++)
        status = restyle(motion->joints[i], from->joints[i], &joints[i]);
    if (status == BAT_OK && motion->first && from->first)
        status = rebase(from->first, bat_shape_curve(motion->first, 0), &first);
    if (status == BAT_OK && first && motion->bent)
        status = rebase(first, bat_shape_curve(motion->bent, 0), &bent);
    for (int i = 0; i < count && joints; i++) {
        if (status == BAT_OK && joints[i]) {
            bat_camera *before = motion->joints[i];
            motion->joints[i] = joints[i], joints[i] = before;
        }
        bat_camera_free(joints[i]);
    }
    if (status == BAT_OK && first) {
        bat_shape *before = motion->first;
        motion->first = first, first = before;
        before = motion->bent;
        motion->bent = bent, bent = before;
    }
    bat_shape_free(first), bat_shape_free(bent);
    free(joints);
    return status;
}
