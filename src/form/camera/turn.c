/* Edits of how a camera is turned (docs/math/camera.md, math 4). */
#include "form/camera/camera.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double met = 1e-12; /* radians */
enum { ROUNDS = 60 };

static double angle_of(quat q) {
    const double angle = vec_norm(quat_log(q));
    return fmin(angle, 2 * BAT_PI - angle);
}

/* The rotation vector of q, or of the same rotation by whole turns more, that is nearest to d. */
static vec log_near(quat q, vec d) {
    const vec v = quat_log(q.w < 0 ? quat_scale(q, -1) : q);
    const double length = vec_norm(v);
    const vec axis = length > 1e-9 ? vec_scale(v, 1 / length) : vec_unit(d);
    const double turns = rint((vec_dot(d, axis) - length) / (2 * BAT_PI));
    return vec_add(v, vec_scale(axis, 2 * BAT_PI * turns));
}

/* The weights N_i / sum N^2 of the points that are felt at a share of a curve's domain, the first of them and those after
 * it, of n in a ring: on a closed curve of few points several basis functions belong to one. Returns how many. */
static int weights_at(const bat_curve *curve, double u, int n, int *first, double *weights) {
    double sum = 0;
    bat_curve_basis(curve, u, first, weights);
    for (int i = curve->degree; i >= n; i--) weights[i - n] += weights[i];
    const int felt = curve->degree < n ? curve->degree + 1 : n;
    for (int i = 0; i < felt; i++) sum += weights[i] * weights[i];
    for (int i = 0; i < felt; i++) weights[i] /= sum;
    return felt;
}

static bat_status turn_level(bat_camera *camera, int number, double u, quat target) {
    bat_camera_level *level = &camera->level[number - 1];
    const bat_curve *old = level->details;
    double weights[BAT_DEGREE_MAX + 1], domain[2], at[3];
    if (bat_camera_loudness(level) == 0) return BAT_ARGUMENT;
    bat_curve_domain(old, domain);
    const double share = bat_camera_share(camera, u), width = domain[1] - domain[0];
    int first = 0;
    const int n = old->count, felt = weights_at(old, domain[0] + width * share, n, &first, weights);
    quat above = quat_one;
    for (int l = number + 1; l <= camera->levels; l++)
        above = quat_mul(above, bat_camera_detail(camera, l, u));
    const quat below = bat_camera_up_to(camera, number - 1, u);
    const quat wanted = quat_mul(quat_mul(quat_inverse(below), target), quat_inverse(above));
    bat_curve_eval(old, domain[0] + width * share, 0, at);
    const vec shown = vec_scale(vec_load(at, 3), level->gain);
    const vec delta = vec_scale(vec_sub(log_near(quat_unit(wanted), shown), shown), 1 / level->gain);
    bat_curve *made = NULL;
    double *points = malloc(3 * (size_t)n * sizeof *points);
    if (!points) return BAT_MEMORY;
    memcpy(points, bat_curve_points(old), 3 * (size_t)n * sizeof *points);
    for (int i = 0; i < felt; i++) {
        double *p = points + 3 * ((first + i) % n);
        p[0] += weights[i] * delta.x, p[1] += weights[i] * delta.y, p[2] += weights[i] * delta.z;
    }
    const bat_status status = bat_curve_create(3, old->degree, old->closed, (size_t)n, points,
                                               bat_curve_knot_count(old), bat_curve_knots(old), &made);
    free(points);
    if (status != BAT_OK) return status;
    bat_curve_free(level->details);
    level->details = made;
    level->shake = (bat_camera_shake){0};
    return BAT_OK;
}

/* One step: the keys that are felt at a share turn from the left by their weights of a rotation. */
static bat_status turn_keys(bat_rotation *base, double share, quat by) {
    double weights[BAT_DEGREE_MAX + 1];
    int first = 0;
    const double u = base->domain[0] + (base->domain[1] - base->domain[0]) * share;
    const int felt = weights_at(base->xyz, u, (int)base->count, &first, weights);
    const vec d = quat_log(by.w < 0 ? quat_scale(by, -1) : by);
    for (int i = 0; i < felt; i++) {
        double *key = base->keys + 4 * ((size_t)(first + i) % base->count);
        quat_store(quat_unit(quat_mul(quat_exp(vec_scale(d, weights[i])), quat_load(key))), key);
    }
    return bat_rotation_rebuild(base);
}

static bat_status turn_base(bat_camera *camera, double u, quat target) {
    bat_rotation made;
    quat above = quat_one;
    const double share = bat_camera_share(camera, u);
    for (int l = 1; l <= camera->levels; l++) above = quat_mul(above, bat_camera_detail(camera, l, u));
    const quat wanted = quat_mul(target, quat_inverse(above));
    bat_status status = bat_rotation_copy(&camera->base, &made);
    for (int round = 0; round < ROUNDS && status == BAT_OK; round++) {
        const quat by = quat_unit(quat_mul(wanted, quat_inverse(bat_rotation_at(&made, share))));
        if (angle_of(by) <= met) break;
        status = turn_keys(&made, share, by);
    }
    if (status == BAT_OK &&
        !(angle_of(quat_mul(wanted, quat_inverse(bat_rotation_at(&made, share)))) <= 1e-9))
        status = BAT_TOLERANCE;
    if (status == BAT_OK) status = bat_rotation_measure(&made);
    if (status == BAT_OK) {
        const bat_rotation old = camera->base;
        camera->base = made, made = old;
    }
    bat_rotation_clear(&made);
    return status == BAT_SINGULAR || status == BAT_NUMBER ? BAT_TOLERANCE : status;
}

static bat_status unit_of(const double rotation[4], quat *out) {
    const quat q = quat_load(rotation);
    const double length = quat_norm(q);
    if (!(length <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    *out = quat_unit(q);
    return length > 0 ? BAT_OK : BAT_SINGULAR;
}

bat_status bat_camera_turn(bat_camera *camera, int level, double u, const double rotation[4]) {
    quat target = quat_one;
    if (!camera || !rotation || level < 0 || level > camera->levels) return BAT_ARGUMENT;
    bat_status status = unit_of(rotation, &target);
    if (status != BAT_OK) return status;
    if (isnan(u)) return BAT_NUMBER;
    if (level == 0 && !camera->base.keys) return BAT_UNSUPPORTED;
    u = u == camera->domain[1] ? u : bat_curve_reduce(camera->path, u);
    target = quat_mul(quat_inverse(bat_camera_ground(camera, u)), target);
    return level > 0 ? turn_level(camera, level, u, target) : turn_base(camera, u, target);
}

bat_status bat_camera_turn_base(bat_camera *camera, const double rotation[4]) {
    bat_rotation made;
    quat by = quat_one;
    if (!camera || !rotation) return BAT_ARGUMENT;
    bat_status status = unit_of(rotation, &by);
    if (status != BAT_OK) return status;
    if (!camera->base.keys) return BAT_UNSUPPORTED;
    status = bat_rotation_copy(&camera->base, &made);
    for (size_t i = 0; i < made.count && status == BAT_OK; i++)
        quat_store(quat_unit(quat_mul(by, quat_load(made.keys + 4 * i))), made.keys + 4 * i);
    if (status == BAT_OK) status = bat_rotation_remake(&made);
    if (status == BAT_OK) {
        const bat_rotation old = camera->base;
        camera->base = made, made = old;
    }
    bat_rotation_clear(&made);
    return status;
}

bat_status bat_pool_ascending(size_t count, double *values) {
    if (count == 0) return BAT_OK;
    if (!values || count > BAT_POINTS_MAX) return values ? BAT_COUNT : BAT_ARGUMENT;
    size_t blocks = 0, *lengths = malloc(count * sizeof *lengths);
    if (!lengths) return BAT_MEMORY;
    for (size_t i = 0; i < count; i++) { /* the first `blocks` values are the means of the blocks so far */
        double mean = values[i];
        size_t length = 1;
        while (blocks > 0 && values[blocks - 1] > mean) {
            const size_t before = lengths[--blocks];
            mean += (values[blocks] - mean) * (double)before / (double)(before + length);
            length += before;
        }
        values[blocks] = mean, lengths[blocks++] = length;
    }
    for (size_t at = count; blocks > 0; blocks--)
        for (size_t k = 0; k < lengths[blocks - 1]; k++) values[--at] = values[blocks - 1];
    free(lengths);
    return BAT_OK;
}
