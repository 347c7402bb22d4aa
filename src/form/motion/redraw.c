/* An angle of a joint over time, and its redrawing by a stroke (docs/math/motion.md; math 3.6, math 4). */
#include "curve/banded.h"
#include "form/motion/motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FEW = 64, PARTS = 4, ROUNDS = 12 };          /* a stretch of fewer frames is met between them, too */
static const double ridge = 1e-9, stiffness = 1e-4; /* of the weight of a place, of second differences */
static const double settled = 1e-10, spread = 0.1;  /* radians, seconds */
static const double angle_most = 1e6;

/* ---- the angle ---- */

static void angles_at(const bat_motion *m, int joint, double u, double angles[3]) {
    const size_t frame = (size_t)fmin(u + 0.5, (double)(m->take->frames - 1));
    bat_take_angles(m->take, joint, frame, angles);
    bat_bone_angles(&m->take->joints[joint], quat_unit(bat_motion_turn(m, joint, u)), angles);
}

static bool has_angle(const bat_motion *m, int joint, int angle) {
    return joint >= 0 && joint < m->take->joint_count && m->joints[joint] && angle >= 0 &&
           angle < bat_bone_turns(&m->take->joints[joint]);
}

static double parameter_of(const bat_motion *m, double time) {
    return fmin(fmax(time / m->take->frame_time, 0), bat_motion_last(m));
}

bat_status bat_motion_angle(const bat_motion *motion, int joint, int angle, double time, double *degrees) {
    double angles[3];
    if (!motion || !degrees || !has_angle(motion, joint, angle)) return BAT_ARGUMENT;
    if (!isfinite(time)) return BAT_NUMBER;
    angles_at(motion, joint, parameter_of(motion, time), angles);
    *degrees = angles[angle];
    return BAT_OK;
}

/* ---- what is wanted ---- */

typedef struct redrawing {
    const bat_motion *motion;
    bat_camera *camera; /* the joint's, as it becomes */
    int joint, angle, level;
    size_t count; /* of the stroke */
    const double *points;
    double from, to;      /* the stretch, in frames */
    double before, after; /* over how many frames it goes over into what it was */
    vec first, last;      /* what is wanted at its ends */
} redrawing;

/* The stroke's angle at a time: of its last part that is there. */
static double stroke_at(const redrawing *r, double time) {
    for (size_t i = r->count - 1; i > 0; i--) {
        const double *a = r->points + 2 * (i - 1), *b = r->points + 2 * i;
        if (time < fmin(a[0], b[0]) || time > fmax(a[0], b[0])) continue;
        return a[0] == b[0] ? b[1] : a[1] + (b[1] - a[1]) * (time - a[0]) / (b[0] - a[0]);
    }
    return r->points[2 * r->count - 1]; /* rounding at an end */
}

static vec log_near(quat q, vec d) {
    const vec v = quat_log(q.w < 0 ? quat_scale(q, -1) : q);
    const double length = vec_norm(v);
    const vec axis = length > 1e-9 ? vec_scale(v, 1 / length) : vec_unit(d);
    return vec_add(v, vec_scale(axis, 2 * BAT_PI * rint((vec_dot(d, axis) - length) / (2 * BAT_PI))));
}

/* By what the level's rotation vector (of the base: its rotation, from the left) has to change at u within the stretch. */
static vec change_at(const redrawing *r, double u) {
    const bat_camera *camera = r->camera;
    double angles[3], at[3];
    angles_at(r->motion, r->joint, u, angles);
    angles[r->angle] = stroke_at(r, u * r->motion->take->frame_time);
    quat above = quat_one;
    for (int l = r->level + 1; l <= camera->levels; l++)
        above = quat_mul(above, bat_camera_detail(camera, l, u));
    quat target = bat_bone_turn(&r->motion->take->joints[r->joint], angles);
    if (r->joint == 0 && r->motion->fresh) { /* it shows turned with the path */
        const quat shown = bat_motion_turn(r->motion, 0, u),
                   own = bat_camera_up_to(r->motion->joints[0], camera->levels, u);
        target = quat_mul(quat_mul(own, quat_inverse(shown)), target);
    }
    const quat wanted = quat_mul(target, quat_inverse(above));
    if (r->level == 0)
        return log_near(quat_unit(quat_mul(wanted, quat_inverse(bat_camera_up_to(camera, 0, u)))),
                        (vec){0, 0, 0});
    const bat_camera_level *level = &camera->level[r->level - 1];
    const quat below = bat_camera_up_to(camera, r->level - 1, u);
    bat_curve_eval(level->details, u, 0, at);
    const vec shown = vec_scale(vec_load(at, 3), level->gain);
    return vec_scale(vec_sub(log_near(quat_unit(quat_mul(quat_inverse(below), wanted)), shown), shown),
                     1 / level->gain);
}

static double smooth(double x) { return x >= 1 ? 1 : x <= 0 ? 0 : x * x * (3 - 2 * x); }

static vec wanted_at(const redrawing *r, double u) {
    if (u < r->from) return vec_scale(r->first, 1 - smooth((r->from - u) / r->before));
    if (u > r->to) return vec_scale(r->last, 1 - smooth((u - r->to) / r->after));
    return change_at(r, u);
}

/* ---- the change of the level's points ---- */

static const bat_curve *basis_of(const redrawing *r) {
    return r->level > 0 ? r->camera->level[r->level - 1].details : r->camera->base.xyz;
}

static void add_row(const bat_curve *basis, double u, vec wanted, int first_point, int n, double *a,
                    double *b) {
    const int p = bat_curve_degree(basis);
    double weights[BAT_DEGREE_MAX + 1];
    const double want[3] = {wanted.x, wanted.y, wanted.z};
    int first;
    bat_curve_basis(basis, u, &first, weights);
    for (int i = 0; i <= p; i++) {
        const int row = first + i - first_point;
        if (row < 0 || row >= n) continue;
        for (int k = 0; k <= i && row - k >= 0; k++) a[row * (p + 1) + k] += weights[i] * weights[i - k];
        for (int k = 0; k < 3; k++) b[3 * row + k] += weights[i] * want[k];
    }
}

static void add_stiffness(int n, int p, double *a) {
    static const double d[3] = {1, -2, 1};
    for (int i = 0; i < n; i++) a[i * (p + 1)] += ridge;
    for (int i = 0; i + 2 < n && p >= 2; i++)
        for (int k = 0; k < 3; k++)
            for (int l = 0; l <= k; l++) a[(i + k) * (p + 1) + k - l] += stiffness * d[k] * d[l];
}

/* Points low .. high of the basis meet the stretch and its ends. */
static void meeting(const redrawing *r, int *low, int *high) {
    const bat_curve *basis = basis_of(r);
    const double *t = bat_curve_knots(basis);
    const int p = bat_curve_degree(basis), count = (int)bat_curve_count(basis);
    *low = 0, *high = count - 1;
    while (*low < *high && t[*low + p + 1] <= r->from - r->before) ++*low;
    while (*high > *low && t[*high] >= r->to + r->after) --*high;
}

/* out: 3 numbers for each of points low .. high. */
static bat_status solve(const redrawing *r, int low, int high, double *out) {
    const bat_curve *basis = basis_of(r);
    const double *t = bat_curve_knots(basis);
    const int p = bat_curve_degree(basis), n = high - low + 1;
    double *a = calloc((size_t)n * ((size_t)p + 1), sizeof *a);
    if (!a) return BAT_MEMORY;
    memset(out, 0, 3 * (size_t)n * sizeof *out);
    const int parts = r->to - r->from < FEW ? PARTS : 1;
    const long start = (long)ceil(t[low] * parts), end = (long)floor(t[high + p + 1] * parts);
    for (long i = start; i <= end; i++)
        add_row(basis, (double)i / parts, wanted_at(r, (double)i / parts), low, n, a, out);
    add_stiffness(n, p, a);
    const bat_status status = bat_banded_factor(a, n, p);
    if (status == BAT_OK) bat_banded_solve(a, n, p, out, 3);
    free(a);
    return status;
}

static bat_status move_details(redrawing *r, int low, int high, const double *by) {
    bat_camera_level *level = &r->camera->level[r->level - 1];
    const bat_curve *old = level->details;
    const size_t count = (size_t)bat_curve_count(old);
    double *points = malloc(3 * count * sizeof *points);
    bat_curve *made = NULL;
    if (!points) return BAT_MEMORY;
    memcpy(points, bat_curve_points(old), 3 * count * sizeof *points);
    for (int i = 0; i < 3 * (high - low + 1); i++) points[3 * low + i] += by[i];
    const bat_status status = bat_curve_create(3, bat_curve_degree(old), false, count, points,
                                               bat_curve_knot_count(old), bat_curve_knots(old), &made);
    free(points);
    if (status != BAT_OK) return status;
    bat_curve_free(level->details);
    level->details = made;
    level->shake = (bat_camera_shake){0};
    return BAT_OK;
}

/* *most: the largest turn of a key. */
static bat_status move_keys(redrawing *r, int low, int high, const double *by, double *most) {
    bat_rotation *base = &r->camera->base;
    *most = 0;
    for (int i = low; i <= high; i++) {
        const vec d = vec_load(by + (ptrdiff_t)3 * (i - low), 3);
        double *key = base->keys + (ptrdiff_t)4 * i;
        *most = fmax(*most, vec_norm(d));
        quat_store(quat_unit(quat_mul(quat_exp(d), quat_load(key))), key);
    }
    return bat_rotation_remake(base);
}

/* Details are a spline of what is solved for; a base is one only nearly, and is met in steps. */
static bat_status change(redrawing *r) {
    int low, high;
    meeting(r, &low, &high);
    double *by = malloc(3 * (size_t)(high - low + 1) * sizeof *by), most = INFINITY;
    bat_status status = by ? BAT_OK : BAT_MEMORY;
    for (int round = 0; round < (r->level > 0 ? 1 : ROUNDS) && status == BAT_OK && most > settled; round++) {
        r->first = change_at(r, r->from), r->last = change_at(r, r->to);
        status = solve(r, low, high, by);
        if (status == BAT_OK)
            status = r->level > 0 ? move_details(r, low, high, by) : move_keys(r, low, high, by, &most);
    }
    free(by);
    return status == BAT_SINGULAR ? BAT_TOLERANCE : status;
}

/* How wide the spans of the level are, near a parameter. */
static double span_at(const bat_curve *basis, double u) {
    const double *t = bat_curve_knots(basis);
    int i = bat_curve_degree(basis);
    while (i + 1 < (int)bat_curve_count(basis) && t[i + 1] <= u) i++;
    return t[i + 1] - t[i];
}

static bat_status stretch(redrawing *r) {
    const bat_motion *m = r->motion;
    double from = INFINITY, to = -INFINITY;
    for (size_t i = 0; i < r->count; i++) {
        const double time = r->points[2 * i];
        if (!isfinite(time) || !(fabs(r->points[2 * i + 1]) <= angle_most)) return BAT_NUMBER;
        from = fmin(from, time), to = fmax(to, time);
    }
    r->from = parameter_of(m, from), r->to = parameter_of(m, to);
    const double least = fmax(spread / m->take->frame_time, 1);
    r->before = fmax(least, 2 * span_at(basis_of(r), r->from));
    r->after = fmax(least, 2 * span_at(basis_of(r), r->to));
    return BAT_OK;
}

bat_status bat_motion_redraw(bat_motion *motion, int joint, int angle, int level, size_t count,
                             const double *points) {
    if (!motion || !points || !has_angle(motion, joint, angle)) return BAT_ARGUMENT;
    const bat_camera *was = motion->joints[joint];
    if (level < 0 || level > was->levels) return BAT_ARGUMENT;
    if (level > 0 && bat_camera_loudness(&was->level[level - 1]) == 0) return BAT_ARGUMENT;
    if (count < 2) return BAT_COUNT;
    redrawing r = {
        .motion = motion, .joint = joint, .angle = angle, .level = level, .count = count, .points = points};
    bat_status status = bat_camera_copy(was, &r.camera);
    if (status == BAT_OK) status = stretch(&r);
    if (status == BAT_OK) status = change(&r);
    if (status == BAT_OK) status = bat_motion_set_joint(motion, joint, r.camera);
    if (status != BAT_OK) bat_camera_free(r.camera);
    return status;
}
