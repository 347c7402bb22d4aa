/* Surfaces on grids, and as triangles. */
#define _POSIX_C_SOURCE 199309L
#include "bench.h"
#include "timing.h"

#include <batten/surface.h>

enum { NET = 32, SIDE = 512 };

typedef struct sheet {
    bat_surface *surface;
    double u[SIDE], v[SIDE], *points, *normals;
    size_t triangles;
} sheet;

static void end_grid(void *context) {
    sheet *s = context;
    bat_surface_free(s->surface);
    free(s->points), free(s->normals), free(s);
}

static void *begin_grid(int variant) { /* variant: the degree */
    const int p = variant, knots = NET + p + 1;
    double points[NET * NET * 3], t[NET + 8];
    unsigned long long state = 7;
    for (int i = 0; i < knots; i++) t[i] = i <= p ? 0 : i >= NET ? 1 : (double)(i - p) / (NET - p);
    for (int i = 0; i < NET * NET; i++) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        points[3 * i] = 10.0 * (i / NET), points[3 * i + 1] = 10.0 * (i % NET);
        points[3 * i + 2] = 10 * ((double)(state >> 11) / 9007199254740992.0);
    }
    sheet *s = calloc(1, sizeof *s);
    if (!s) return NULL;
    s->points = malloc(sizeof(double) * SIDE * SIDE * 9),
    s->normals = malloc(sizeof(double) * SIDE * SIDE * 3);
    if (!s->points || !s->normals ||
        bat_surface_create((const int[2]){p, p}, (const bool[2]){false, false}, (const size_t[2]){NET, NET},
                           points, (const int[2]){knots, knots}, t, t, &s->surface) != BAT_OK)
        return end_grid(s), NULL;
    bat_surface_spread(s->surface, BAT_U, SIDE, s->u);
    bat_surface_spread(s->surface, BAT_V, SIDE, s->v);
    return s;
}

static void run_points(void *context) {
    sheet *s = context;
    if (bat_surface_eval_grid(s->surface, SIDE, s->u, SIDE, s->v, 0, s->points) != BAT_OK) abort();
}

static void run_tangents(void *context) {
    sheet *s = context;
    if (bat_surface_eval_grid(s->surface, SIDE, s->u, SIDE, s->v, 1, s->points) != BAT_OK) abort();
}

static void run_normals(void *context) {
    sheet *s = context;
    if (bat_surface_normal_grid(s->surface, SIDE, s->u, SIDE, s->v, s->points, s->normals) != BAT_OK) abort();
}

static void run_tessellate(void *context) {
    sheet *s = context;
    bat_tessellation *t = NULL;
    bat_tessellate_options options = bat_tessellate_defaults();
    options.tolerance = 0.002;
    if (bat_surface_tessellate(s->surface, &options, &t, NULL) != BAT_OK) abort();
    bat_mesh mesh;
    bat_tessellation_mesh(t, &mesh);
    s->triangles = mesh.triangle_count;
    bat_tessellation_free(t);
}

static void note_triangles(void *context, char *out, int room) {
    snprintf(out, (size_t)room, "%zu triangles", ((sheet *)context)->triangles);
}

const bench_row bench_rows_surface[] = {
    {"bicubic 32 x 32 on 512 x 512", "ns", 1e9, SIDE *SIDE, 3, begin_grid, run_points, end_grid, 0},
    {"bicubic 32 x 32, derivatives", "ns", 1e9, SIDE *SIDE, 3, begin_grid, run_tangents, end_grid, 0},
    {"bicubic 32 x 32, unit normals", "ns", 1e9, SIDE *SIDE, 3, begin_grid, run_normals, end_grid, 0},
    {"degree 5, 32 x 32 on 512 x 512", "ns", 1e9, SIDE *SIDE, 5, begin_grid, run_points, end_grid, 0},
    {"bicubic 32 x 32, triangles to 0.002", "ms", 1e3, 1, 3, begin_grid, run_tessellate, end_grid,
     note_triangles},
    {0},
};
