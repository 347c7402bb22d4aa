/* Frames along a curve, and the levels hand. */
#define _POSIX_C_SOURCE 199309L
#include "bench.h"
#include "timing.h"
#include "wave.h"

#include <batten/levels.h>
#include <batten/refine.h>

enum { FRAMES = 10000 };

/* ---- frames ---- */

typedef struct framing {
    bat_curve *curve;
    double u[FRAMES], t[3 * FRAMES], s[3 * FRAMES], point[3 * FRAMES];
    bat_frame3 frames[FRAMES];
    bat_frame_chain *chain;
} framing;

static void end_frames(void *context) {
    framing *f = context;
    bat_curve_free(f->curve);
    bat_frame_chain_free(f->chain);
    free(f);
}

static void *begin_frames(int variant) { /* negative: in the plane */
    framing *f = calloc(1, sizeof *f);
    if (!f) return NULL;
    f->curve = bench_wave(abs(variant), variant < 0 ? 2 : 3);
    if (!f->curve || bat_frame_chain_create(f->curve, NULL, &f->chain) != BAT_OK) return end_frames(f), NULL;
    bat_curve_spread(f->curve, FRAMES, f->u);
    return f;
}

/* Everything, with a new chain of frames each time. */
static void run_bulk(void *context) {
    framing *f = context;
    bat_frame_arrays out = {f->point, f->t, f->s, NULL};
    bat_frame_chain *chain;
    if (bat_frame_chain_create(f->curve, NULL, &chain) != BAT_OK) abort();
    bat_frame_chain_many(chain, FRAMES, f->u, &out);
    bat_frame_chain_free(chain);
}

/* From the chain that is there already. */
static void run_kept(void *context) {
    framing *f = context;
    bat_frame_arrays out = {f->point, f->t, f->s, NULL};
    if (bat_frame_chain_many(f->chain, FRAMES, f->u, &out) != BAT_OK) abort();
}

static void run_structs(void *context) {
    framing *f = context;
    if (bat_frames(f->curve, FRAMES, f->u, NULL, f->frames, NULL) != BAT_OK) abort();
}

static void run_serial(void *context) {
    framing *f = context;
    for (int i = 0; i < FRAMES; i++) bat_frame_chain_at(f->chain, f->u[i], &f->frames[i]);
}

/* ---- levels ---- */

typedef struct shaping {
    bat_curve *curve;
    bat_shape *shape;
    bat_shape_live *live;
    double u, step;
} shaping;

static void end_shape(void *context) {
    shaping *s = context;
    bat_shape_live_cancel(s->live);
    bat_shape_free(s->shape);
    bat_curve_free(s->curve);
    free(s);
}

/* A wave of `variant` points (negative: in the plane), decomposed into three levels. */
static void *begin_shape(int variant) {
    shaping *s = calloc(1, sizeof *s);
    if (!s) return NULL;
    s->u = 0.37;
    s->curve = bench_wave(abs(variant), variant < 0 ? 2 : 3);
    if (!s->curve || bat_shape_decompose(s->curve, 3, NULL, &s->shape) != BAT_OK ||
        bat_shape_live_begin(s->shape, 0, &s->live) != BAT_OK)
        return end_shape(s), NULL;
    return s;
}

static void run_decompose(void *context) {
    shaping *s = context;
    bat_shape *shape;
    if (bat_shape_decompose(s->curve, 3, NULL, &shape) != BAT_OK) abort();
    bat_shape_free(shape);
}

/* One pointer event: the base is dragged, and the finest curve with it. */
static void run_drag(void *context) {
    shaping *s = context;
    s->step += 0.01;
    const double delta[3] = {0, 5 + s->step, 3};
    if (bat_shape_live_drag(s->live, s->u, delta) != BAT_OK) abort();
}

/* A whole gesture: a copy, one event, and the details converted back to the frames of the curves themselves. */
static void run_gesture(void *context) {
    shaping *s = context;
    const double delta[3] = {0, 5, 3};
    bat_shape_live *live;
    bat_shape *out;
    if (bat_shape_live_begin(s->shape, 0, &live) != BAT_OK ||
        bat_shape_live_drag(live, s->u, delta) != BAT_OK || bat_shape_live_commit(live, &out) != BAT_OK)
        abort();
    bat_shape_free(out);
}

/* The gain of a level changes, and all finer levels follow. */
static void run_gain(void *context) {
    shaping *s = context;
    s->step += 0.01;
    if (bat_shape_set_gain(s->shape, 1, 1 + s->step / 1000) != BAT_OK) abort();
}

const bench_row bench_rows_levels[] = {
    {"RMF 10000 in bulk, n=16", "ns/frame", 1e9, FRAMES, 16, begin_frames, run_bulk, end_frames, 0},
    {"RMF 10000 in bulk, n=1000", "ns/frame", 1e9, FRAMES, 1000, begin_frames, run_bulk, end_frames, 0},
    {"RMF 10000, chain kept, n=16", "ns/frame", 1e9, FRAMES, 16, begin_frames, run_kept, end_frames, 0},
    {"RMF 10000, chain kept, n=1000", "ns/frame", 1e9, FRAMES, 1000, begin_frames, run_kept, end_frames, 0},
    {"RMF 10000 as structs, n=16", "ns/frame", 1e9, FRAMES, 16, begin_frames, run_structs, end_frames, 0},
    {"RMF one at a time, n=16", "ns/frame", 1e9, FRAMES, 16, begin_frames, run_serial, end_frames, 0},
    {"level drag, plane, 1000 points", "us", 1e6, 1, -1000, begin_shape, run_drag, end_shape, 0},
    {"level drag, space, 1000 points", "us", 1e6, 1, 1000, begin_shape, run_drag, end_shape, 0},
    {"level drag, plane, 100000 points", "us", 1e6, 1, -100000, begin_shape, run_drag, end_shape, 0},
    {"level drag, space, 100000 points", "us", 1e6, 1, 100000, begin_shape, run_drag, end_shape, 0},
    {"level gesture, plane, 1000 points", "us", 1e6, 1, -1000, begin_shape, run_gesture, end_shape, 0},
    {"level gesture, space, 1000 points", "us", 1e6, 1, 1000, begin_shape, run_gesture, end_shape, 0},
    {"level gesture, space, 100000 points", "us", 1e6, 1, 100000, begin_shape, run_gesture, end_shape, 0},
    {"level gain, space, 1000 points", "us", 1e6, 1, 1000, begin_shape, run_gain, end_shape, 0},
    {"decompose, plane, 1000 points, 3 levels", "us", 1e6, 1, -1000, begin_shape, run_decompose, end_shape,
     0},
    {"decompose, space, 100000 points, 3 levels", "us", 1e6, 1, 100000, begin_shape, run_decompose, end_shape,
     0},
    {0},
};
