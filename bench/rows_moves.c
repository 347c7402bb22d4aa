/* A camera's path and gaze dragged, each of a thousand points, as the editor does it: from the move as it was; and a move
 * with three levels sampled. */
#define _POSIX_C_SOURCE 199309L
#include "bench.h"
#include "timing.h"

#include <batten/camera.h>
#include <batten/drag.h>
#include <math.h>

enum { POINTS = 1000, LEVELS = 2, SAMPLES = 10000 };

typedef struct flight {
    bat_curve *path;
    bat_camera *camera;
    double at;
} flight;

static void end(void *context) {
    flight *f = context;
    bat_curve_free(f->path);
    bat_camera_free(f->camera);
    free(f);
}

static bat_status make(flight *f, bat_camera_mode mode) {
    static double knots[POINTS + 4], points[3 * POINTS], keys[4 * POINTS], details[3 * POINTS];
    bench_curve(POINTS, 3, knots, points);
    for (int i = 0; i < POINTS; i++) {
        points[3 * i] = 900 * cos(0.02 * i), points[3 * i + 1] = 900 * sin(0.02 * i),
                   points[3 * i + 2] = 3 * i + 40 * sin(0.05 * i);
        keys[4 * i] = 0.3 * sin(0.1 * i), keys[4 * i + 1] = 0.2 * cos(0.07 * i), keys[4 * i + 2] = 0,
                 keys[4 * i + 3] = 1;
        for (int c = 0; c < 3; c++) details[3 * i + c] = 0.02 * sin(i * (c + 1.0));
    }
    const bat_rotation_curve base = {
        .degree = 3, .count = POINTS, .points = keys, .knot_count = POINTS + 4, .knots = knots};
    bat_camera_options options = bat_camera_defaults();
    options.mode = mode, options.base = &base;
    bat_status status = bat_curve_create(3, 3, false, POINTS, points, POINTS + 4, knots, &f->path);
    if (status == BAT_OK) status = bat_camera_create(f->path, &options, &f->camera);
    for (int l = 0; l < LEVELS && status == BAT_OK; l++)
        status = bat_camera_add_level(f->camera, POINTS + 4, knots, POINTS, details);
    return status;
}

static void *begin(int variant) {
    flight *f = calloc(1, sizeof *f);
    if (f && make(f, (bat_camera_mode)variant) == BAT_OK) return f;
    if (f) end(f);
    return NULL;
}

static double place(flight *f) { return f->at = fmod(f->at + 0.017, 0.9) + 0.05; }

static void run_path(void *context) {
    flight *f = context;
    const double u = place(f), by[3] = {3, -2, 5};
    bat_curve *path = NULL;
    bat_camera *camera = NULL;
    if (bat_curve_drag(f->path, 1, &u, by, &path) != BAT_OK ||
        bat_camera_with_path(f->camera, path, &camera) != BAT_OK)
        abort();
    bat_curve_free(path);
    bat_camera_free(camera);
}

static void turn(void *context, int level) {
    flight *f = context;
    const double u = place(f);
    bat_camera_pose pose;
    bat_camera *camera = NULL;
    bat_camera_at(f->camera, u, &pose);
    pose.rotation[0] += 0.05;
    if (bat_camera_copy(f->camera, &camera) != BAT_OK ||
        bat_camera_turn(camera, level, u, pose.rotation) != BAT_OK)
        abort();
    bat_camera_free(camera);
}

/* With one more level. */
static void *begin_samples(int variant) {
    static double knots[POINTS + 4], points[3 * POINTS], details[3 * POINTS];
    flight *f = begin(variant);
    bench_curve(POINTS, 3, knots, points);
    for (int i = 0; i < 3 * POINTS; i++) details[i] = 0.01 * cos(0.3 * i);
    if (f && bat_camera_add_level(f->camera, POINTS + 4, knots, POINTS, details) == BAT_OK) return f;
    if (f) end(f);
    return NULL;
}

static void run_samples(void *context) {
    static double times[SAMPLES];
    static bat_camera_pose poses[SAMPLES];
    const flight *f = context;
    for (int i = 0; i < SAMPLES; i++) times[i] = bat_camera_duration(f->camera) * i / (SAMPLES - 1);
    if (bat_camera_sample(f->camera, SAMPLES, times, poses) != BAT_OK) abort();
}

static void run_base(void *context) { turn(context, 0); }
static void run_gaze(void *context) { turn(context, LEVELS); }

const bench_row bench_rows_moves[] = {
    {"move, path dragged, free, 1000 points", "us", 1e6, 1, BAT_CAMERA_FREE, begin, run_path, end, 0},
    {"move, path dragged, along, 1000 points", "us", 1e6, 1, BAT_CAMERA_ALONG, begin, run_path, end, 0},
    {"move, gaze dragged at level 2, 1000 points", "us", 1e6, 1, BAT_CAMERA_ALONG, begin, run_gaze, end, 0},
    {"move, gaze dragged at the base, 1000 points", "us", 1e6, 1, BAT_CAMERA_ALONG, begin, run_base, end, 0},
    {"move with 3 levels, 10000 samples, free", "ms", 1e3, 1, BAT_CAMERA_FREE, begin_samples, run_samples,
     end, 0},
    {"move with 3 levels, 10000 samples, along", "ms", 1e3, 1, BAT_CAMERA_ALONG, begin_samples, run_samples,
     end, 0},
    {0},
};
