/*
 * Keys from which a player makes a move: between two of them cubic spans, whose rotations it makes unit. Spans are halved
 * until the move and the player agree (docs/math/camera.md, math 4).
 */
#include "form/camera/camera.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double shortest = 0x1p-20; /* of the duration: times of players are floats */
enum { CHECKS = 8, KEYS_MOST = 1 << 20, EVEN = 32 };
static const double fine = 4e-7; /* radians: of moves that are polynomials in time */

typedef struct keys {
    const bat_camera *camera;
    double place, angle; /* tolerances: of the position, and of the rotation in radians */
    bat_camera_key *list;
    size_t count, room;
} keys;

typedef struct span {
    double from, to; /* times */
    bat_camera_key a, b;
} span;

static const double even = 0x1p-24; /* keys of players are floats */
static const double degree = BAT_PI / 180;

/* ---- one span ---- */

/* The slopes at the ends of the cubic through four values at even distances. */
static void slopes(const double *p, double length, double *leave, double *arrive) {
    *leave = (-11 * p[0] + 18 * p[1] - 9 * p[2] + 2 * p[3]) / (2 * length);
    *arrive = (11 * p[3] - 18 * p[2] + 9 * p[1] - 2 * p[0]) / (2 * length);
}

static double hermite(double a, double leave, double b, double arrive, double length, double x) {
    const double y = 1 - x;
    return a * y * y * (1 + 2 * x) + leave * length * x * y * y + b * x * x * (3 - 2 * x) -
           arrive * length * x * x * y;
}

/* A free base without levels is a cubic in time where the parameter is even, and so is a player's span before it is made unit: where
 * the spline is as long at both ends, its own values are the exact ones. It is divided by that length. */
static void take_spline(const bat_camera *camera, const bat_camera_pose *pose, double values[8][4]) {
    quat q[4];
    if (camera->options.mode != BAT_CAMERA_FREE || camera->levels > 0) return;
    for (int i = 0; i < 4; i++)
        q[i] = bat_rotation_spline(&camera->base, bat_camera_share(camera, pose[i].u));
    const double length = quat_norm(q[0]);
    if (!(fabs(quat_norm(q[3]) - length) <= even * length)) return;
    for (int i = 0; i < 4; i++) {
        double v[4];
        quat_store(quat_near(quat_scale(q[i], 1 / length), quat_load(pose[i].rotation)), v);
        for (int c = 0; c < 4; c++) values[3 + c][i] = v[c];
    }
}

/* The span through the move at its ends and at its thirds. Its first rotation is on the side of `near`. */
static void make_span(const bat_camera *camera, double from, double to, quat near, span *out) {
    bat_camera_pose pose[4];
    double values[8][4];
    for (int i = 0; i < 4; i++) {
        bat_camera_at_time(camera, i == 3 ? to : from + (to - from) * i / 3, &pose[i]);
        near = quat_near(quat_load(pose[i].rotation), near);
        quat_store(near, pose[i].rotation);
        for (int c = 0; c < 3; c++) values[c][i] = pose[i].position[c];
        for (int c = 0; c < 4; c++) values[3 + c][i] = pose[i].rotation[c];
        values[7][i] = pose[i].fov;
    }
    take_spline(camera, pose, values);
    *out = (span){.from = from, .to = to, .a = {.time = from}, .b = {.time = to}};
    for (int c = 0; c < 8; c++) {
        out->a.value[c] = values[c][0], out->b.value[c] = values[c][3];
        slopes(values[c], to - from, &out->a.leave[c], &out->b.arrive[c]);
    }
}

/* What a player shows, against the move. */
static bool agrees(const keys *k, const span *s) {
    for (int i = 1; i < CHECKS; i++) {
        bat_camera_pose pose;
        double shown[8], far = 0;
        const double x = (double)i / CHECKS, length = s->to - s->from;
        bat_camera_at_time(k->camera, s->from + length * x, &pose);
        for (int c = 0; c < 8; c++)
            shown[c] = hermite(s->a.value[c], s->a.leave[c], s->b.value[c], s->b.arrive[c], length, x);
        for (int c = 0; c < 3; c++) far = bat_hypot(far, shown[c] - pose.position[c]);
        const quat own = quat_load(pose.rotation), player = quat_near(quat_unit(quat_load(shown + 3)), own);
        const quat apart = {player.x - own.x, player.y - own.y, player.z - own.z, player.w - own.w};
        if (far > 0.5 * k->place || 2 * quat_norm(apart) > 0.5 * k->angle) return false;
        if (fabs(shown[7] - pose.fov) * degree > 0.5 * k->angle) return false;
    }
    return true;
}

/* ---- all of them ---- */

static bat_status add_key(keys *k, const bat_camera_key *key) {
    if (k->count == k->room) {
        const size_t room = k->room > 0 ? 2 * k->room : 64;
        bat_camera_key *list = realloc(k->list, room * sizeof *list);
        if (!list) return BAT_MEMORY;
        k->list = list, k->room = room;
    }
    k->list[k->count++] = *key;
    return BAT_OK;
}

/* The last key is there; adds those after it up to `to`. */
static bat_status add_span(keys *k, double to) {
    bat_camera_key *last = &k->list[k->count - 1];
    const double from = last->time, middle = 0.5 * (from + to);
    span s;
    make_span(k->camera, from, to, quat_load(last->value + 3), &s);
    if (!(to - from > 2 * shortest * k->camera->options.duration) || agrees(k, &s)) {
        memcpy(last->leave, s.a.leave, sizeof last->leave);
        return add_key(k, &s.b);
    }
    if (k->count >= KEYS_MOST) return BAT_TOLERANCE;
    const bat_status status = add_span(k, middle);
    return status == BAT_OK ? add_span(k, to) : status;
}

double bat_camera_time_of(const bat_camera *camera, double u) {
    double low = 0, high = camera->options.duration;
    for (int i = 0; i < 60; i++) {
        bat_camera_pose pose;
        const double middle = 0.5 * (low + high);
        bat_camera_at_time(camera, middle, &pose);
        if (pose.u < u)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

/* The times at which something that the move is made of goes from one polynomial to the next. */
static size_t knots_of(const bat_camera *camera, const bat_curve *curve, bool in_time, double *out) {
    size_t count = 0;
    const double *t = curve->knots, start = t[curve->degree], width = t[curve->spread] - start;
    const bat_curve *base = camera->base.xyz;
    for (int i = curve->degree + 1; i < curve->spread; i++) {
        double share = (t[i] - start) / width;
        if (curve == base && camera->base.antiperiodic) share *= 2;
        if (t[i] == t[i - 1] || !(share > 0 && share < 1)) continue;
        out[count++] = in_time
                           ? camera->options.duration * share
                           : bat_camera_time_of(camera, camera->domain[0] +
                                                            (camera->domain[1] - camera->domain[0]) * share);
    }
    return count;
}

static int compare(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

static bat_status find_times(const bat_camera *camera, double **out, size_t *count) {
    const bat_curve *curves[BAT_CAMERA_LEVELS_MAX + 5] = {camera->path, camera->options.timing.curve,
                                                          camera->base.xyz, camera->options.fov.curve,
                                                          camera->gaze.target};
    size_t room = 2 * camera->gaze.parts + 2, made = 0;
    for (int l = 0; l < camera->levels; l++) curves[5 + l] = camera->level[l].details;
    const int all = 5 + camera->levels;
    for (int i = 0; i < all; i++) room += curves[i] ? (size_t)curves[i]->spread : 0;
    double *times = malloc(room * sizeof *times);
    if (!times) return BAT_MEMORY;
    for (int i = 0; i < all; i++)
        if (curves[i]) made += knots_of(camera, curves[i], i == 1, times + made);
    for (size_t i = 0; i < camera->gaze.parts; i++)
        times[made++] = bat_camera_time_of(camera, camera->gaze.part[i].a);
    times[made++] = camera->options.duration;
    qsort(times, made, sizeof *times, compare); /* no ties */
    *out = times, *count = made;
    return BAT_OK;
}

/* A base without levels whose parameter is even in time: a player's spans come as near to it as floats can say, for few keys more. */
static bool is_polynomial(const bat_camera *camera) {
    bool plain = camera->options.mode == BAT_CAMERA_FREE;
    for (int l = 0; l < camera->levels; l++) plain = plain && bat_camera_loudness(&camera->level[l]) == 0;
    for (int i = 1; i < EVEN && plain; i++) {
        bat_camera_pose pose;
        bat_camera_at_time(camera, camera->options.duration * i / EVEN, &pose);
        plain = fabs(bat_camera_share(camera, pose.u) - (double)i / EVEN) <= 1e-9;
    }
    return plain;
}

bat_status bat_camera_keys(const bat_camera *camera, double place, double angle, size_t *count,
                           bat_camera_key **out) {
    double *times = NULL;
    size_t time_count = 0;
    span first;
    if (!camera || !count || !out || !(place > 0) || !(angle > 0)) return BAT_ARGUMENT;
    keys k = {.camera = camera, .place = place, .angle = angle};
    if (is_polynomial(camera)) k.angle = fmin(angle, fine);
    bat_status status = find_times(camera, &times, &time_count);
    const double duration = camera->options.duration;
    if (status == BAT_OK) {
        make_span(camera, 0, duration, quat_one, &first);
        status = add_key(&k, &first.a);
    }
    for (size_t i = 0; i < time_count && status == BAT_OK; i++)
        if (i + 1 == time_count ||
            fmin(times[i] - k.list[k.count - 1].time, duration - times[i]) > shortest * duration)
            status = add_span(&k, times[i]);
    if (status == BAT_OK) memcpy(k.list[k.count - 1].leave, k.list[k.count - 1].arrive, sizeof k.list->leave);
    if (status == BAT_OK) memcpy(k.list[0].arrive, k.list[0].leave, sizeof k.list->leave);
    free(times);
    if (status == BAT_OK)
        *count = k.count, *out = k.list;
    else
        free(k.list);
    return status;
}
