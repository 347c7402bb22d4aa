/* Surfaces on grids, and as triangles. */
#define _POSIX_C_SOURCE 199309L
#include "bench.h"
#include "timing.h"

#include <batten/surface.h>
#include <string.h>

enum { NET = 32, SIDE = 512, RAYS = 1000, LINE = 67 /* 64 patches */ };

typedef struct sheet {
    bat_surface *surface;
    double u[SIDE], v[SIDE], *points, *normals;
    size_t triangles, hits;
    bat_surface_finder *finder;
    bat_curve *line; /* what the line at 0.5 is redrawn as */
    bat_direction direction;
    bat_tessellation *tessellation;
} sheet;

static void end_grid(void *context) {
    sheet *s = context;
    bat_surface_free(s->surface);
    bat_surface_finder_free(s->finder);
    bat_curve_free(s->line);
    bat_tessellation_free(s->tessellation);
    free(s->points), free(s->normals), free(s);
}

static void *begin(int n, int p) {
    static double points[LINE * LINE * 3], knots[LINE + BAT_DEGREE_MAX + 1];
    sheet *s = calloc(1, sizeof *s);
    if (!s) return NULL;
    bench_surface(n, p, knots, points);
    s->points = malloc(sizeof(double) * SIDE * SIDE * 9);
    s->normals = malloc(sizeof(double) * SIDE * SIDE * 3);
    if (!s->points || !s->normals ||
        bat_surface_create((const int[2]){p, p}, (const bool[2]){false, false},
                           (const size_t[2]){(size_t)n, (size_t)n}, points,
                           (const int[2]){n + p + 1, n + p + 1}, knots, knots, &s->surface) != BAT_OK ||
        bat_surface_finder_create(s->surface, &s->finder) != BAT_OK)
        return end_grid(s), NULL;
    bat_surface_spread(s->surface, BAT_U, SIDE, s->u);
    bat_surface_spread(s->surface, BAT_V, SIDE, s->v);
    return s;
}

static void *begin_grid(int variant) { /* variant: the degree */
    return begin(NET, variant);
}

/* variant: the direction. A bump of 5 units over a third of the line. */
static void *begin_line(int variant) {
    double points[3 * LINE];
    sheet *s = begin(LINE, 3);
    bat_curve *now = NULL;
    if (!s) return NULL;
    s->direction = variant ? BAT_V : BAT_U;
    if (bat_surface_isocurve(s->surface, s->direction, 0.5, &now) != BAT_OK) return end_grid(s), NULL;
    memcpy(points, bat_curve_points(now), sizeof points);
    for (int i = LINE / 3; i < 2 * LINE / 3; i++) points[3 * i + 2] += 5;
    const bat_status status = bat_curve_create(3, 3, false, LINE, points, bat_curve_knot_count(now),
                                               bat_curve_knots(now), &s->line);
    bat_curve_free(now);
    if (status != BAT_OK || bat_surface_tessellate(s->surface, NULL, &s->tessellation, NULL) != BAT_OK)
        return end_grid(s), NULL;
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
    options.tolerance = 0.5;
    if (bat_surface_tessellate(s->surface, &options, &t, NULL) != BAT_OK) abort();
    bat_mesh mesh;
    bat_tessellation_mesh(t, &mesh);
    s->triangles = mesh.triangle_count;
    bat_tessellation_free(t);
}

static void note_triangles(void *context, char *out, int room) {
    snprintf(out, (size_t)room, "%zu triangles", ((sheet *)context)->triangles);
}

static void run_redraw(void *context) {
    sheet *s = context;
    bat_surface *made = NULL;
    if (bat_surface_redraw(s->surface, s->direction, 0.5, s->line, NULL, &made, NULL, NULL) != BAT_OK)
        abort();
    bat_surface_free(made);
}

/* What a frame needs while a line is dragged. */
static void run_follow(void *context) {
    sheet *s = context;
    bat_surface *made = NULL;
    bat_surface_redraw_report report;
    if (bat_surface_redraw(s->surface, s->direction, 0.5, s->line, NULL, &made, NULL, &report) != BAT_OK ||
        bat_tessellation_update(s->tessellation, made, s->direction, report.moved, NULL) != BAT_OK)
        abort();
    bat_surface_free(made);
}

static void note_mesh(void *context, char *out, int room) {
    bat_mesh mesh;
    bat_tessellation_mesh(((sheet *)context)->tessellation, &mesh);
    snprintf(out, (size_t)room, "%zu x %zu vertices", mesh.rows, mesh.columns);
}

static void run_rays(void *context) {
    sheet *s = context;
    s->hits = 0;
    for (int k = 0; k < RAYS; k++) {
        double origin[3], direction[3];
        bat_surface_point hits[8];
        size_t count = 0;
        bench_ray(NET, k, origin, direction);
        if (bat_surface_finder_hits(s->finder, origin, direction, 8, hits, &count) != BAT_OK) abort();
        s->hits += count;
    }
}

static void note_hits(void *context, char *out, int room) {
    snprintf(out, (size_t)room, "%zu hits of %d rays", ((sheet *)context)->hits, RAYS);
}

const bench_row bench_rows_surface[] = {
    {"bicubic 32 x 32 on 512 x 512", "ns", 1e9, SIDE *SIDE, 3, begin_grid, run_points, end_grid, 0},
    {"bicubic 32 x 32, derivatives", "ns", 1e9, SIDE *SIDE, 3, begin_grid, run_tangents, end_grid, 0},
    {"bicubic 32 x 32, unit normals", "ns", 1e9, SIDE *SIDE, 3, begin_grid, run_normals, end_grid, 0},
    {"degree 5, 32 x 32 on 512 x 512", "ns", 1e9, SIDE *SIDE, 5, begin_grid, run_points, end_grid, 0},
    {"bicubic 32 x 32, triangles to 0.5", "ms", 1e3, 1, 3, begin_grid, run_tessellate, end_grid,
     note_triangles},
    {"redraw a line, 64 x 64 patches", "us", 1e6, 1, 0, begin_line, run_redraw, end_grid, 0},
    {"redraw a line across, 64 x 64 patches", "us", 1e6, 1, 1, begin_line, run_redraw, end_grid, 0},
    {"redraw and move triangles, 64 x 64", "us", 1e6, 1, 0, begin_line, run_follow, end_grid, note_mesh},
    {"ray, bicubic 32 x 32", "us", 1e6, RAYS, 3, begin_grid, run_rays, end_grid, note_hits},
    {0},
};
