/* Frames along a curve, and the levels hand. */
#define _POSIX_C_SOURCE 199309L
#include "bench.h"
#include "timing.h"

#include <batten/levels.h>
#include <batten/refine.h>

enum { FRAMES = 10000 };

static bat_curve *wave(int n, int dimension) {
    double *knots = malloc(sizeof(double) * (size_t)(n + 4)),
           *points = malloc(sizeof(double) * (size_t)(n * dimension));
    bat_curve *curve = NULL;
    if (knots && points) {
        bench_curve(n, dimension, knots, points);
        if (bat_curve_create(3, dimension, false, n, knots, points, &curve) != BAT_OK) curve = NULL;
    }
    free(knots), free(points);
    return curve;
}

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
    f->curve = wave(abs(variant), variant < 0 ? 2 : 3);
    if (!f->curve || bat_frame_chain_create(f->curve, NULL, &f->chain) != BAT_OK) return end_frames(f), NULL;
    bat_curve_spread(f->curve, FRAMES, f->u);
    return f;
}

/* All of it: the chain is made anew. */
static void run_bulk(void *context) {
    framing *f = context;
    bat_frame_arrays out = {f->point, f->t, f->s, NULL};
    bat_frame_chain *chain;
    if (bat_frame_chain_create(f->curve, NULL, &chain) != BAT_OK) abort();
    bat_frame_chain_many(chain, FRAMES, f->u, &out);
    bat_frame_chain_free(chain);
}

static void run_structs(void *context) {
    framing *f = context;
    if (bat_frames(f->curve, NULL, FRAMES, f->u, f->frames, NULL) != BAT_OK) abort();
}

static void run_serial(void *context) {
    framing *f = context;
    for (int i = 0; i < FRAMES; i++) bat_frame_chain_at(f->chain, f->u[i], &f->frames[i]);
}

const bench_row bench_rows_levels[] = {
    {"RMF 10000 in bulk, n=16", "ns/frame", 1e9, FRAMES, 16, begin_frames, run_bulk, end_frames, 0},
    {"RMF 10000 in bulk, n=1000", "ns/frame", 1e9, FRAMES, 1000, begin_frames, run_bulk, end_frames, 0},
    {"RMF 10000 as structs, n=16", "ns/frame", 1e9, FRAMES, 16, begin_frames, run_structs, end_frames, 0},
    {"RMF one at a time, n=16", "ns/frame", 1e9, FRAMES, 16, begin_frames, run_serial, end_frames, 0},
    {0},
};
