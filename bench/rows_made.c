/* Surfaces made from curves, and where surfaces meet. */
#define _POSIX_C_SOURCE 199309L
#include "bench.h"
#include "made.h"
#include "timing.h"

#include <batten/sweep.h>
#include <batten/trace.h>
#include <string.h>

typedef struct made {
    bat_curve *path, *profile;
    bat_surface *tubes[2];
    size_t count;
    double far;
} made;

static void end(void *context) {
    made *m = context;
    bat_curve_free(m->path), bat_curve_free(m->profile);
    bat_surface_free(m->tubes[0]), bat_surface_free(m->tubes[1]);
    free(m);
}

static bat_status tube(int which, bat_surface **out) {
    double points[6 * BENCH_TUBE], line[4] = {0, 0, 1, 1}, ring[BENCH_TUBE + 1];
    for (int i = 0; i <= BENCH_TUBE; i++) ring[i] = i;
    bench_tube(which, points);
    return bat_surface_create((int[]){1, 3}, (bool[]){false, true}, (size_t[]){2, BENCH_TUBE}, points,
                              (int[]){4, BENCH_TUBE + 1}, line, ring, out);
}

static void *begin(int variant) {
    double path[3 * BENCH_PATH], ring[2 * BENCH_RING], knots[BENCH_RING + 1];
    made *m = calloc(1, sizeof *m);
    (void)variant;
    if (!m) return NULL;
    for (int i = 0; i <= BENCH_RING; i++) knots[i] = i;
    bench_path(path), bench_ring(ring);
    if (bat_curve_create_clamped(3, 3, BENCH_PATH, path, &m->path) != BAT_OK ||
        bat_curve_create(2, 3, true, BENCH_RING, ring, BENCH_RING + 1, knots, &m->profile) != BAT_OK ||
        tube(0, &m->tubes[0]) != BAT_OK || tube(1, &m->tubes[1]) != BAT_OK)
        return end(m), NULL;
    return m;
}

static void run_sweep(void *context) {
    made *m = context;
    bat_sweep *sweep = NULL;
    bat_surface *out = NULL;
    bat_sweep_report report;
    if (bat_sweep_create(m->path, m->profile, NULL, &sweep) != BAT_OK ||
        bat_sweep_surface(sweep, BENCH_SWEEP_TOLERANCE, &out, &report) != BAT_OK)
        abort();
    m->count = bat_surface_count(out, BAT_U) * bat_surface_count(out, BAT_V), m->far = report.max_error;
    bat_surface_free(out), bat_sweep_free(sweep);
}

static void note_sweep(void *context, char *out, int room) {
    const made *m = context;
    snprintf(out, (size_t)room, "%zu points, within %.1e", m->count, m->far);
}

static void run_meet(void *context) {
    made *m = context;
    bat_tracks *tracks = NULL;
    if (bat_surface_intersect(m->tubes[0], m->tubes[1], NULL, &tracks) != BAT_OK) abort();
    m->count = bat_tracks_count(tracks);
    for (size_t i = 0; i < m->count; i++) {
        bat_curve *curve = NULL;
        if (bat_tracks_curve(tracks, i, BENCH_MEET_TOLERANCE, &curve) != BAT_OK) abort();
        bat_curve_free(curve);
    }
    bat_tracks_free(tracks);
}

static void note_meet(void *context, char *out, int room) {
    snprintf(out, (size_t)room, "%zu curves", ((made *)context)->count);
}

const bench_row bench_rows_made[] = {
    {"sweep of a ring along a bent path", "us", 1e6, 1, 0, begin, run_sweep, end, note_sweep},
    {"intersection of two tubes", "us", 1e6, 1, 0, begin, run_meet, end, note_meet},
    {0},
};
