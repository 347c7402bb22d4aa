/* Levels of a camera that are muted, that shake, or that come from another camera (docs/math/camera.md, math 4). */
#include "form/camera/camera.h"

#include <math.h>
#include <stdlib.h>

enum { LEAST = 4 };             /* points of a level that shakes */
static const double LESS = 0.5; /* of the amount, in roll */

bat_status bat_camera_set_muted(bat_camera *camera, int level, bool muted) {
    if (!camera || level < 1 || level > camera->levels) return BAT_ARGUMENT;
    camera->level[level - 1].muted = muted;
    return BAT_OK;
}

bool bat_camera_is_muted(const bat_camera *camera, int level) {
    return level >= 1 && level <= camera->levels && camera->level[level - 1].muted;
}

/* ---- shake ---- */

/* From -1 to 1 (splitmix64: Steele, Lea, Flood, 2014). */
static double drawn(uint64_t *state) {
    uint64_t x = *state += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    x ^= x >> 31;
    return (double)(x >> 11) * 0x1p-52 - 1;
}

/* Where the camera is after a share of its time, never before `last`. */
static double place_after(const bat_camera *camera, double share, double last) {
    bat_camera_pose pose;
    bat_camera_at_time(camera, share * camera->options.duration, &pose);
    return fmax(pose.u, last);
}

/* Knots at even times, so that the shake is as fast wherever the camera is slow; where it stands still, at even shares. */
static void even_times(const bat_camera *camera, int degree, bool closed, int spans, double *knots) {
    const int before = closed ? 0 : degree;
    const double *domain = camera->domain, width = domain[1] - domain[0];
    double last = domain[0];
    for (int i = 0; i <= spans; i++) {
        const double rest = spans - i, even = last + (domain[1] - last) / (rest + 1);
        double u = i == 0 ? domain[0] : i == spans ? domain[1] : place_after(camera, (double)i / spans, last);
        if (i > 0 && i < spans &&
            !(u - last > 1e-3 * width / spans && domain[1] - u > 1e-3 * width / spans * rest))
            u = even;
        knots[before + i] = last = u;
    }
    for (int i = 0; i < before; i++) knots[i] = domain[0], knots[before + spans + 1 + i] = domain[1];
}

bat_status bat_camera_add_shake(bat_camera *camera, uint64_t seed, double amount, double rate) {
    if (!camera) return BAT_ARGUMENT;
    if (!(amount > 0 && amount <= BAT_PI) || !(rate > 0) || seed > BAT_CAMERA_SEED_MAX) return BAT_NUMBER;
    const double wanted = ceil(rate * camera->options.duration);
    if (!(wanted <= BAT_CAMERA_SHAKE_MAX)) return BAT_COUNT;
    const bat_curve *base = camera->base.xyz;
    const int degree = base ? base->degree : 3;
    const bool closed = base ? base->closed : camera->path->closed;
    const int spans = wanted > LEAST ? (int)wanted : LEAST, count = closed ? spans : spans + degree;
    const int knot_count = closed ? count + 1 : count + degree + 1;
    double *numbers = malloc((3 * (size_t)count + (size_t)knot_count) * sizeof *numbers);
    if (!numbers) return BAT_MEMORY;
    uint64_t state = seed;
    for (int i = 0; i < 3 * count; i++) numbers[i] = (i % 3 == 2 ? LESS : 1) * amount * drawn(&state);
    even_times(camera, degree, closed, spans, numbers + 3 * (size_t)count);
    const bat_status status = bat_camera_add_level(camera, knot_count, numbers + 3 * (size_t)count,
                                                   (size_t)count, numbers);
    free(numbers);
    if (status == BAT_OK) camera->level[camera->levels - 1].shake = (bat_camera_shake){seed, amount, rate};
    return status;
}

bat_status bat_camera_shake_of(const bat_camera *camera, int level, bat_camera_shake *out) {
    if (!camera || !out || level < 1 || level > camera->levels) return BAT_ARGUMENT;
    const bat_camera_shake *shake = &camera->level[level - 1].shake;
    if (!(shake->rate > 0)) return BAT_STATE;
    *out = *shake;
    return BAT_OK;
}

/* ---- levels of another camera ---- */

bat_status bat_camera_take_levels(bat_camera *camera, const bat_camera *from) {
    if (!camera || !from) return BAT_ARGUMENT;
    if (camera == from) return BAT_OK;
    const bat_curve *base = camera->base.xyz, *other = from->base.xyz;
    if ((base ? base->degree : 3) != (other ? other->degree : 3) ||
        (base ? base->closed : camera->path->closed) != (other ? other->closed : from->path->closed))
        return BAT_UNSUPPORTED;
    bat_camera_level made[BAT_CAMERA_LEVELS_MAX];
    bat_status status = BAT_OK;
    int count = 0;
    while (count < from->levels && status == BAT_OK) {
        made[count] = from->level[count];
        status = bat_curve_copy(from->level[count].details, &made[count].details);
        if (status == BAT_OK) count++;
    }
    if (status != BAT_OK) {
        while (count > 0) bat_curve_free(made[--count].details);
        return status;
    }
    for (int l = 0; l < camera->levels; l++) bat_curve_free(camera->level[l].details);
    for (int l = 0; l < count; l++) camera->level[l] = made[l];
    camera->levels = count;
    return BAT_OK;
}
