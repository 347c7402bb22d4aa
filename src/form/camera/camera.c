/* Camera moves (multilevel-2016, section 5; docs/math/camera.md, math 4). */
#include "form/camera/camera.h"

#include "base/options.h"
#include "curve/frames/converged.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const bat_camera_options DEFAULTS = {
    .size = sizeof DEFAULTS, .up = {0, 0, 1}, .fov = {40, NULL}, .duration = 4};
enum { LEAST = sizeof DEFAULTS }; /* size in version 0.3: the first member added later begins there */
static const double GAIN_MOST = 1e6, DURATION_MOST = 1e9;

void bat_camera_options_init(bat_camera_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

/* ---- making one ---- */

void bat_camera_free(bat_camera *camera) {
    if (!camera) return;
    if (camera->users && bat_users_drop(camera->users)) {
        bat_curve_free(camera->path), bat_curve_free(camera->given);
        bat_frame_chain_free(camera->chain);
        bat_gaze_clear(&camera->gaze);
        bat_pace_clear(&camera->pace);
        free(camera->users);
    }
    bat_rotation_clear(&camera->base);
    for (int l = 0; l < camera->levels; l++) bat_curve_free(camera->level[l].details);
    bat_curve_free((bat_curve *)camera->options.target_curve);
    bat_function_clear(&camera->options.fov), bat_function_clear(&camera->options.timing);
    free(camera);
}

static bat_status own_function(const bat_function *from, bat_function *to) {
    const bat_status status = bat_function_check(from, NULL);
    *to = bat_function_of(from->constant);
    return status == BAT_OK && from->curve ? bat_curve_copy(from->curve, &to->curve) : status;
}

/* From 0 to 1, and never falling: by its coefficients. */
static bat_status check_timing(const bat_function *timing) {
    const bat_curve *curve = timing->curve;
    double start[3], end[3];
    if (!curve) return BAT_OK;
    if (curve->closed) return BAT_PARAMETER;
    bat_function_eval(timing, 0, start), bat_function_eval(timing, 1, end);
    if (!(fabs(start[0]) <= 1e-12) || !(fabs(end[0] - 1) <= 1e-12)) return BAT_PARAMETER;
    for (int i = 1; i < curve->count; i++)
        if (curve->points[i * curve->dimension] < curve->points[(i - 1) * curve->dimension])
            return BAT_PARAMETER;
    return BAT_OK;
}

static bat_status take_options(const bat_camera_options *given, bat_camera *camera) {
    bat_camera_options *own = &camera->options;
    *own = *given;
    own->base = NULL, own->target_curve = NULL;
    own->fov = own->timing = bat_function_of(0);
    if ((unsigned)own->mode > BAT_CAMERA_LOOK_AT || !(own->duration > 0)) return BAT_ARGUMENT;
    if (!(own->duration <= DURATION_MOST)) return BAT_NUMBER;
    bat_status status = own_function(&given->fov, &own->fov);
    if (status == BAT_OK) status = own_function(&given->timing, &own->timing);
    if (status == BAT_OK) status = check_timing(&own->timing);
    if (status == BAT_OK && given->target_curve)
        status = bat_curve_copy(given->target_curve, (bat_curve **)&own->target_curve);
    return status;
}

/* The frames of a planar path as it was given, so that it gets its planar ones, unless their first is asked for. */
static bat_status take_frames(const bat_curve *path, bat_camera *camera) {
    const bat_camera_options *own = &camera->options;
    bat_frame_options frames = bat_frame_defaults();
    frames.has_first = own->has_first;
    memcpy(frames.first, own->first, sizeof frames.first);
    for (int k = 0; k < 3; k++)
        if (frames.has_first && !(fabs(frames.first[k]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    return bat_frame_chain_converged(own->has_first ? camera->path : path, &frames, &camera->chain);
}

bat_status bat_camera_lay(bat_camera *camera, const bat_curve *path) {
    const bat_camera_mode mode = camera->options.mode;
    camera->users = malloc(sizeof *camera->users);
    if (!camera->users) return BAT_MEMORY;
    *camera->users = BAT_USERS_ONE;
    bat_status status = bat_curve_to_dimension(path, 3, &camera->path);
    if (status == BAT_OK) status = bat_curve_copy(path, &camera->given);
    if (status != BAT_OK) return status;
    bat_curve_domain(camera->path, camera->domain);
    if (mode == BAT_CAMERA_LOOK_AT) status = bat_gaze_make(camera->path, &camera->options, &camera->gaze);
    if (mode == BAT_CAMERA_ALONG) status = take_frames(path, camera);
    return status == BAT_OK ? bat_pace_make(camera->path, &camera->pace) : status;
}

bat_status bat_camera_create(const bat_curve *path, const bat_camera_options *options, bat_camera **out) {
    bat_camera_options full = DEFAULTS;
    if (!path || !out) return BAT_ARGUMENT;
    bat_status status = bat_options_read(options, LEAST, sizeof full, &full);
    if (status != BAT_OK) return status;
    if (full.mode == BAT_CAMERA_FREE && !full.base) return BAT_ARGUMENT;
    bat_camera *camera = calloc(1, sizeof *camera);
    if (!camera) return BAT_MEMORY;
    camera->base.least = 1;
    status = take_options(&full, camera);
    if (status == BAT_OK) status = bat_camera_lay(camera, path);
    if (status == BAT_OK && full.mode != BAT_CAMERA_LOOK_AT && full.base)
        status = bat_rotation_make(full.base, &camera->base);
    if (status == BAT_OK)
        *out = camera;
    else
        bat_camera_free(camera);
    return status;
}

/* ---- levels ---- */

bat_status bat_camera_add_level(bat_camera *camera, int knot_count, const double *knots, size_t count,
                                const double *details) {
    if (!camera || !knots || !details) return BAT_ARGUMENT;
    if (camera->levels == BAT_CAMERA_LEVELS_MAX) return BAT_COUNT;
    const bat_curve *base = camera->base.xyz;
    bat_camera_level *level = &camera->level[camera->levels];
    const bat_status status = bat_curve_create(3, base ? base->degree : 3,
                                               base ? base->closed : camera->path->closed, count, details,
                                               knot_count, knots, &level->details);
    if (status != BAT_OK) return status;
    level->gain = 1, level->muted = false, level->shake = (bat_camera_shake){0};
    camera->levels++;
    return BAT_OK;
}

int bat_camera_levels(const bat_camera *camera) { return camera->levels; }

const bat_curve *bat_camera_details(const bat_camera *camera, int level) {
    return level >= 1 && level <= camera->levels ? camera->level[level - 1].details : NULL;
}

double bat_camera_gain(const bat_camera *camera, int level) {
    return level >= 1 && level <= camera->levels ? camera->level[level - 1].gain : 0;
}

bat_status bat_camera_set_gain(bat_camera *camera, int level, double gain) {
    if (!camera || level < 1 || level > camera->levels) return BAT_ARGUMENT;
    if (!(fabs(gain) <= GAIN_MOST)) return BAT_NUMBER;
    camera->level[level - 1].gain = gain;
    return BAT_OK;
}

/* ---- evaluation ---- */

double bat_camera_share(const bat_camera *camera, double u) {
    return (u - camera->domain[0]) / (camera->domain[1] - camera->domain[0]);
}

quat bat_camera_ground(const bat_camera *camera, double u) {
    bat_frame3 f;
    switch (camera->options.mode) {
    case BAT_CAMERA_LOOK_AT: return bat_gaze_at(&camera->gaze, u);
    case BAT_CAMERA_ALONG:
        bat_frame_chain_at(camera->chain, u, &f);
        return quat_of_axes(vec_load(f.r, 3), vec_load(f.s, 3), vec_scale(vec_load(f.t, 3), -1));
    default: return quat_one;
    }
}

quat bat_camera_detail(const bat_camera *camera, int level, double u) {
    const bat_camera_level *l = &camera->level[level - 1];
    double domain[2], d[3];
    bat_curve_domain(l->details, domain);
    bat_curve_eval(l->details, domain[0] + (domain[1] - domain[0]) * bat_camera_share(camera, u), 0, d);
    return quat_exp(vec_scale(vec_load(d, 3), bat_camera_loudness(l)));
}

quat bat_camera_up_to(const bat_camera *camera, int top, double u) {
    quat q = camera->base.keys ? bat_rotation_at(&camera->base, bat_camera_share(camera, u)) : quat_one;
    for (int l = 1; l <= top; l++)
        if (bat_camera_loudness(&camera->level[l - 1]) != 0) q = quat_mul(q, bat_camera_detail(camera, l, u));
    return q;
}

/* The rest of a pose, u and distance being known. */
static void look(const bat_camera *camera, bat_camera_pose *out) {
    double fov[3];
    const quat q = quat_mul(bat_camera_ground(camera, out->u),
                            bat_camera_up_to(camera, camera->levels, out->u));
    bat_curve_eval(camera->path, out->u, 0, out->position);
    quat_store(quat_unit(q), out->rotation);
    bat_function_eval(&camera->options.fov, bat_camera_share(camera, out->u), fov);
    out->fov = fov[0];
}

void bat_camera_at(const bat_camera *camera, double u, bat_camera_pose *out) {
    out->time = 0;
    out->u = u == camera->domain[1] ? u : bat_curve_reduce(camera->path, u);
    out->distance = bat_pace_until(&camera->pace, out->u);
    look(camera, out);
}

void bat_camera_at_time(const bat_camera *camera, double time, bat_camera_pose *out) {
    const double duration = camera->options.duration, x = fmin(fmax(time, 0), duration) / duration;
    const double length = bat_pace_length(&camera->pace), *domain = camera->domain;
    double share[3] = {x};
    if (camera->options.timing.curve) bat_function_eval(&camera->options.timing, x, share);
    out->time = time;
    out->distance = length * fmin(fmax(share[0], 0), 1);
    out->u = length > 0 ? bat_pace_at(&camera->pace, out->distance)
             : x < 1    ? domain[0] + (domain[1] - domain[0]) * x
                        : domain[1];
    look(camera, out);
}

bat_status bat_camera_sample(const bat_camera *camera, size_t count, const double *times,
                             bat_camera_pose *out) {
    if (!camera || (count > 0 && (!times || !out))) return BAT_ARGUMENT;
    for (size_t i = 0; i < count; i++)
        if (!isfinite(times[i])) return BAT_NUMBER;
    for (size_t i = 0; i < count; i++) {
        bat_camera_at_time(camera, times[i], &out[i]);
        if (i > 0)
            quat_store(quat_near(quat_load(out[i].rotation), quat_load(out[i - 1].rotation)),
                       out[i].rotation);
    }
    return BAT_OK;
}

bat_status bat_camera_view(const bat_camera_pose *pose, double distance, const double size[2],
                           bat_viewpoint *out) {
    if (!pose || !size || !out || !(distance > 0)) return BAT_ARGUMENT;
    const quat q = quat_load(pose->rotation);
    const vec eye = vec_load(pose->position, 3), ahead = quat_turn(q, (vec){0, 0, -1});
    bat_viewpoint view = {.size = {size[0], size[1]}, .fov = pose->fov};
    vec_store(eye, view.eye);
    vec_store(vec_add(eye, vec_scale(ahead, distance)), view.target);
    vec_store(quat_turn(q, (vec){0, 1, 0}), view.up);
    const bat_status status = bat_viewpoint_check(&view, NULL);
    if (status == BAT_OK) *out = view;
    return status;
}

/* ---- what it is ---- */

bat_camera_mode bat_camera_mode_of(const bat_camera *camera) { return camera->options.mode; }

void bat_camera_domain(const bat_camera *camera, double domain[2]) {
    domain[0] = camera->domain[0], domain[1] = camera->domain[1];
}

const bat_curve *bat_camera_path(const bat_camera *camera) { return camera->path; }
double bat_camera_length(const bat_camera *camera) { return bat_pace_length(&camera->pace); }
double bat_camera_duration(const bat_camera *camera) { return camera->options.duration; }
double bat_camera_least_norm(const bat_camera *camera) { return camera->base.least; }

const double *bat_camera_base(const bat_camera *camera, size_t *count) {
    if (count) *count = camera->base.count;
    return camera->base.keys;
}

size_t bat_camera_held(const bat_camera *camera, size_t room, double *out) {
    size_t found = 0;
    for (size_t i = 0; i < camera->gaze.parts; i++) {
        const bat_gaze_part *part = &camera->gaze.part[i];
        if (part->kind != BAT_GAZE_HELD) continue;
        if (found < room && out) out[2 * found] = part->a, out[2 * found + 1] = part->b;
        found++;
    }
    return found;
}
