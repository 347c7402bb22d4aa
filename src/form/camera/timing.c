/* How a camera goes in time, and edits of that (docs/math/camera.md, math 4). */
#include "form/camera/camera.h"
#include "form/camera/retime.h"

#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { EASE_POINTS = 33, DEGREE = 3 };

const bat_function *bat_camera_timing(const bat_camera *camera) { return &camera->options.timing; }

bat_status bat_camera_set_timing(bat_camera *camera, double duration, const bat_function *timing) {
    bat_camera *made = NULL;
    if (!camera) return BAT_ARGUMENT;
    if (timing && timing->curve) {
        bat_camera_options options = camera->options;
        bat_rotation_curve base;
        options.base = bat_camera_base_curve(camera, &base) ? &base : NULL;
        options.timing = *timing, options.duration = duration;
        const bat_status status = bat_camera_again(camera, camera->given, &options, &made);
        if (status != BAT_OK) return status;
        const bat_camera before = *camera;
        *camera = *made, *made = before;
        bat_camera_free(made);
        return BAT_OK;
    }
    if (!(duration > 0)) return BAT_ARGUMENT;
    if (!(duration <= 1e9)) return BAT_NUMBER;
    if (timing) bat_function_clear(&camera->options.timing);
    camera->options.duration = duration;
    return BAT_OK;
}

/* ---- strokes ---- */

/* A cubic at least; even timing is a straight line. */
static bat_status plain_timing(const bat_camera *camera, bat_curve **out) {
    static const double line[4] = {0, 0, 1, 0}, ends[4] = {0, 0, 1, 1};
    const bat_curve *now = camera->options.timing.curve;
    bat_curve *straight = NULL;
    bat_status status = now ? bat_curve_copy(now, &straight)
                            : bat_curve_create(2, 1, false, 2, line, 4, ends, &straight);
    if (status == BAT_OK)
        status = straight->degree < DEGREE ? bat_curve_elevate(straight, DEGREE, out)
                                           : bat_curve_copy(straight, out);
    bat_curve_free(straight);
    return status;
}

/* The same with knots enough. */
static bat_status fine_timing(const bat_curve *plain, bat_curve **out) {
    double more[BAT_CAMERA_PACE_SPANS];
    int count = 0;
    for (int i = 1; i < BAT_CAMERA_PACE_SPANS; i++) { /* where no knot is near */
        const double u = (double)i / BAT_CAMERA_PACE_SPANS;
        bool near = false;
        for (int k = 0; k < plain->spread + plain->degree + 1; k++)
            near = near || fabs(plain->knots[k] - u) < 0.25 / BAT_CAMERA_PACE_SPANS;
        if (!near) more[count++] = u;
    }
    return bat_curve_insert_knots(plain, count, more, out);
}

/* The coefficients first..last are drawn; they are made ascending by the least change, and those on both sides then give way to
 * them: pooling with weights of which the others' are as good as none. */
static bat_status settle(size_t n, double *values, size_t first, size_t last) {
    if (first == 0) values[0] = 0;
    if (last == n - 1) values[n - 1] = 1;
    const bat_status status = bat_pool_ascending(last - first + 1, values + first);
    if (status != BAT_OK) return status;
    for (size_t i = 0; i < first; i++) values[i] = fmin(values[i], values[first]);
    for (size_t i = last + 1; i < n; i++) values[i] = fmax(values[i], values[last]);
    for (size_t i = 1; i < n; i++) values[i] = fmax(values[i], values[i - 1]); /* inserted knots round */
    values[0] = 0, values[n - 1] = 1;
    return BAT_OK;
}

static bat_status redraw(bat_curve *timing, size_t count, const double *points) {
    const size_t n = (size_t)timing->count, size = (size_t)timing->dimension;
    double low = INFINITY, high = -INFINITY;
    double *places = malloc(2 * n * sizeof *places);
    size_t first = n, last = 0;
    if (!places) return BAT_MEMORY;
    double *values = places + n;
    for (size_t i = 0; i < count; i++) low = fmin(low, points[2 * i]), high = fmax(high, points[2 * i]);
    bat_curve_greville(timing, places);
    for (size_t i = 0; i < n; i++) {
        const bool drawn = places[i] >= low && places[i] <= high;
        values[i] = drawn ? bat_stroke_height(count, points, places[i]) : timing->points[i * size];
        if (drawn && first == n) first = i;
        if (drawn) last = i;
    }
    const bat_status status = first < n ? settle(n, values, first, last) : BAT_OK;
    for (size_t i = 0; i < n && status == BAT_OK; i++) timing->points[i * size] = fmin(fmax(values[i], 0), 1);
    free(places);
    return status;
}

/* By the sketch hand's fit, with few knots; exactly (`coefficients`), or where that does not do, by the coefficients of many. */
static bat_status redrawn(const bat_camera *camera, size_t count, const double *points, bool coefficients,
                          bat_curve **out) {
    double low = INFINITY, high = -INFINITY;
    bat_curve *plain = NULL, *made = NULL;
    for (size_t i = 0; i < count; i++) low = fmin(low, points[2 * i]), high = fmax(high, points[2 * i]);
    bat_status status = plain_timing(camera, &plain);
    if (status == BAT_OK && !coefficients) status = bat_timing_fit(plain, count, points, low, high, &made);
    if (status == BAT_OK && !made) {
        status = fine_timing(plain, &made);
        if (status == BAT_OK) status = redraw(made, count, points);
    }
    bat_curve_free(plain);
    if (status == BAT_OK)
        *out = made;
    else
        bat_curve_free(made);
    return status;
}

static bat_status retime(bat_camera *camera, size_t count, const double *points, bool coefficients) {
    if (!camera || !points) return BAT_ARGUMENT;
    if (count < 2 || count > BAT_POINTS_MAX || !(bat_camera_length(camera) > 0)) return BAT_COUNT;
    double *within = malloc(2 * count * sizeof *within);
    if (!within) return BAT_MEMORY;
    bat_curve *timing = NULL;
    bat_status status = BAT_OK;
    for (size_t i = 0; i < 2 * count; i++) {
        if (!isfinite(points[i])) status = BAT_NUMBER;
        within[i] = fmin(fmax(points[i], 0), 1);
    }
    if (status == BAT_OK) status = redrawn(camera, count, within, coefficients, &timing);
    free(within);
    if (status != BAT_OK) return status;
    bat_curve_free(camera->options.timing.curve);
    camera->options.timing = (bat_function){0, timing};
    return BAT_OK;
}

bat_status bat_camera_retime(bat_camera *camera, size_t count, const double *points) {
    return retime(camera, count, points, false);
}

/* ---- ease ---- */

/* From standing at the end of the move to the speed after so long: a cubic, which never falls. end: the move's end. */
static bat_status ease_one(bat_camera *camera, double share, bool end) {
    double points[2 * EASE_POINTS], at[3];
    const bat_function *timing = &camera->options.timing;
    const double x = end ? 1 - share : share;
    if (!(share > 0)) return BAT_OK;
    if (timing->curve)
        bat_function_eval(timing, x, at);
    else
        at[0] = x, at[1] = 1;
    const double rise = end ? 1 - at[0] : at[0], slope = fmin(at[1] * share, 3 * rise);
    for (int i = 0; i < EASE_POINTS; i++) {
        const double t = (double)i / (EASE_POINTS - 1), way = t * t * ((3 - 2 * t) * rise - (1 - t) * slope);
        const int k = end ? EASE_POINTS - 1 - i : i;
        points[2 * k] = end ? 1 - share * t : share * t;
        points[2 * k + 1] = end ? 1 - way : way;
    }
    const bat_status status = retime(camera, EASE_POINTS, points, true);
    bat_curve *drawn = camera->options.timing.curve;
    if (status != BAT_OK) return status;
    const size_t size = (size_t)drawn->dimension; /* two equal coefficients: it stands still there */
    if (end)
        drawn->points[((size_t)drawn->count - 2) * size] = 1;
    else
        drawn->points[size] = 0;
    return BAT_OK;
}

bat_status bat_camera_ease(bat_camera *camera, double in, double out) {
    if (!camera) return BAT_ARGUMENT;
    if (!(in >= 0) || !(out >= 0)) return BAT_NUMBER;
    const double duration = camera->options.duration;
    if (!(bat_camera_length(camera) > 0)) return BAT_COUNT;
    bat_curve *before = NULL;
    const bool had = camera->options.timing.curve != NULL;
    bat_status status = had ? bat_curve_copy(camera->options.timing.curve, &before) : BAT_OK;
    if (status != BAT_OK) return status;
    status = ease_one(camera, fmin(in / duration, 0.5), false);
    if (status == BAT_OK) status = ease_one(camera, fmin(out / duration, 0.5), true);
    if (status == BAT_OK) {
        bat_curve_free(before);
        return BAT_OK;
    }
    bat_curve_free(camera->options.timing.curve);
    camera->options.timing = (bat_function){had ? 0 : camera->options.timing.constant, before};
    return status;
}
