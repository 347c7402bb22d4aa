/* Cameras made of another one: a copy, a copy along another path, an image. */
#include "form/camera/camera.h"

#include "base/pose.h"
#include "curve/curve.h"
#include "curve/function.h"

#include <stdlib.h>
#include <string.h>

bool bat_camera_base_curve(const bat_camera *camera, bat_rotation_curve *out) {
    const bat_rotation *base = &camera->base;
    const bat_curve *spline = base->xyz;
    if (!base->keys) return false;
    *out = (bat_rotation_curve){.degree = spline->degree,
                                .closed = spline->closed,
                                .count = base->count,
                                .points = base->keys,
                                .knot_count = (size_t)bat_curve_knot_count(spline) -
                                              (base->antiperiodic ? base->count : 0),
                                .knots = bat_curve_knots(spline),
                                .weights = base->weights};
    return true;
}

static bat_status copy_levels(const bat_camera *from, bat_camera *to) {
    bat_status status = BAT_OK;
    for (int l = 0; l < from->levels && status == BAT_OK; l++) {
        status = bat_curve_copy(from->level[l].details, &to->level[l].details);
        to->level[l].gain = from->level[l].gain;
        to->level[l].muted = from->level[l].muted;
        to->level[l].shake = from->level[l].shake;
        if (status == BAT_OK) to->levels = l + 1;
    }
    return status;
}

bat_status bat_camera_again(const bat_camera *from, const bat_curve *path, const bat_camera_options *options,
                            bat_camera **out) {
    bat_camera *made = NULL;
    bat_status status = bat_camera_create(path, options, &made);
    if (status == BAT_OK) status = copy_levels(from, made);
    if (status == BAT_OK)
        *out = made;
    else
        bat_camera_free(made);
    return status;
}

/* ---- copies ---- */

/* What is a camera's own: all but the path and what is computed of it. */
static bat_status copy_own(const bat_camera *from, bat_camera *to) {
    const bat_camera_options *o = &from->options;
    to->options = *o;
    to->options.fov = to->options.timing = bat_function_of(0);
    to->options.target_curve = NULL;
    bat_status status = bat_function_copy(&o->fov, &to->options.fov);
    if (status == BAT_OK) status = bat_function_copy(&o->timing, &to->options.timing);
    if (status == BAT_OK && o->target_curve)
        status = bat_curve_copy(o->target_curve, (bat_curve **)&to->options.target_curve);
    if (status == BAT_OK) status = bat_rotation_copy(&from->base, &to->base);
    return status == BAT_OK ? copy_levels(from, to) : status;
}

static void share_path(const bat_camera *from, bat_camera *to) {
    bat_users_add(from->users);
    to->users = from->users;
    to->path = from->path, to->given = from->given;
    to->domain[0] = from->domain[0], to->domain[1] = from->domain[1];
    to->chain = from->chain, to->gaze = from->gaze, to->pace = from->pace;
}

/* path: NULL for the same, which is shared. */
static bat_status along(const bat_camera *camera, const bat_curve *path, bat_camera **out) {
    bat_camera *made = calloc(1, sizeof *made);
    if (!made) return BAT_MEMORY;
    bat_status status = copy_own(camera, made);
    if (status == BAT_OK && path)
        status = bat_camera_lay(made, path);
    else if (status == BAT_OK)
        share_path(camera, made);
    if (status == BAT_OK)
        *out = made;
    else
        bat_camera_free(made);
    return status;
}

bat_status bat_camera_copy(const bat_camera *camera, bat_camera **out) {
    return camera && out ? along(camera, NULL, out) : BAT_ARGUMENT;
}

bat_status bat_camera_with_path(const bat_camera *camera, const bat_curve *path, bat_camera **out) {
    if (!camera || !path || !out) return BAT_ARGUMENT;
    if (camera->levels > 0 && !camera->base.keys && camera->path->closed != path->closed)
        return BAT_UNSUPPORTED;
    return along(camera, path, out);
}

/* ---- images ---- */

/* The rotation that is nearest to a map; of one that mirrors, nearest to it after x is mirrored. */
typedef struct turn {
    bool mirrors, leaves; /* the page */
    quat q;
} turn;

static turn turn_of(const double r[12]) {
    double m[6];
    if (!bat_pose_in_plane(r, m))
        return (turn){false, true,
                      quat_of_axes(vec_unit((vec){r[0], r[4], r[8]}), vec_unit((vec){r[1], r[5], r[9]}),
                                   vec_unit((vec){r[2], r[6], r[10]}))};
    const bool mirrors = m[0] * m[3] - m[1] * m[2] < 0;
    const double a = mirrors ? -m[0] : m[0], b = mirrors ? -m[1] : m[1];
    const double half = 0.5 * bat_atan2(b - m[2], a + m[3]);
    return (turn){mirrors, false, {0, 0, bat_sin(half), bat_cos(half)}};
}

static vec turned(const turn *t, vec v) {
    if (t->mirrors) v.x = -v.x;
    return quat_turn(t->q, v);
}

/* A rotation in the world; `here`: one in the camera's own axes, or in the frame of a path, which are only mirrored. */
static quat turned_gaze(const turn *t, quat q, bool here) {
    const quat seen = t->mirrors ? (quat){q.x, -q.y, -q.z, q.w} : q;
    return here ? seen : quat_mul(t->q, seen);
}

/* Moves what the options point to; *block: what that takes. */
static bat_status turn_options(const turn *t, const double rows[12], bat_camera_options *o,
                               bat_rotation_curve *base, double **keys, bat_curve **target) {
    vec_store(turned(t, vec_load(o->up, 3)), o->up);
    vec_store(turned(t, vec_load(o->first, 3)), o->first);
    if (o->target_curve) {
        bat_curve *space = NULL;
        bat_status status = bat_curve_to_dimension(o->target_curve, 3, &space);
        if (status == BAT_OK) status = bat_curve_transform(space, rows, target);
        bat_curve_free(space);
        o->target_curve = *target;
        if (status != BAT_OK) return status;
    }
    bat_pose_apply(rows, 1, o->target, o->target);
    if (!o->base) return BAT_OK;
    *keys = malloc(4 * base->count * sizeof **keys);
    if (!*keys) return BAT_MEMORY;
    for (size_t i = 0; i < base->count; i++)
        quat_store(turned_gaze(t, quat_load(base->points + 4 * i), o->mode == BAT_CAMERA_ALONG),
                   *keys + 4 * i);
    base->points = *keys;
    return BAT_OK;
}

/* Rotation vectors are mirrored as the rotations are. */
static bat_status mirror_levels(bat_camera *camera) {
    static const double rows[12] = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0};
    for (int l = 0; l < camera->levels; l++) {
        bat_curve *image = NULL;
        const bat_status status = bat_curve_transform(camera->level[l].details, rows, &image);
        if (status != BAT_OK) return status;
        bat_curve_free(camera->level[l].details);
        camera->level[l].details = image;
        camera->level[l].shake = (bat_camera_shake){0};
    }
    return BAT_OK;
}

/* The first frame that a path gets by itself does not turn with it, but for paths in the plane. */
static void pin_frame(const bat_camera *camera, const turn *t, bat_camera_options *o) {
    bat_frame3 frame;
    const bool turns = t->q.z != 0, flat = bat_curve_dimension(camera->given) == 2;
    if (o->mode != BAT_CAMERA_ALONG || o->has_first || !(t->mirrors || t->leaves || (turns && !flat))) return;
    bat_frame_chain_at(camera->chain, camera->domain[0], &frame);
    for (int k = 0; k < 3; k++) o->first[k] = frame.s[k];
    o->has_first = true;
}

bat_status bat_camera_image(const bat_camera *camera, const double rows[12], const bat_curve *path,
                            bat_camera **out) {
    const turn t = turn_of(rows);
    double *keys = NULL;
    bat_camera_options options = camera->options;
    pin_frame(camera, &t, &options);
    bat_rotation_curve base;
    bat_curve *target = NULL, *moved = NULL;
    bat_camera *made = NULL;
    for (int k = 0; k < 12; k++)
        if (!(fabs(rows[k]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    options.base = bat_camera_base_curve(camera, &base) ? &base : NULL;
    bat_status status = turn_options(&t, rows, &options, &base, &keys, &target);
    if (status == BAT_OK && !path) status = bat_curve_posed(camera->given, rows, &moved);
    if (status == BAT_OK) status = bat_camera_again(camera, path ? path : moved, &options, &made);
    if (status == BAT_OK && t.mirrors) status = mirror_levels(made);
    free(keys);
    bat_curve_free(target), bat_curve_free(moved);
    if (status == BAT_OK)
        *out = made;
    else
        bat_camera_free(made);
    return status;
}
