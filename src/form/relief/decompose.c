/* Takes a surface apart into levels, and moves levels to another base. */
#include "form/relief/relief.h"

#include <stdlib.h>
#include <string.h>

static const double SAME = 1e-12; /* of the size: control points of a pole differ by less */
static const double OPEN = 1e-9;  /* of the size: how far an edge is opened that is a point by chance */

/* ---- coarser surfaces ---- */

static bat_status coarser(const bat_surface *fine, int d, int count, bat_surface **out) {
    return fine->axis[d].count == count ? bat_surface_copy(fine, out)
                                        : bat_surface_coarsen(fine, (bat_direction)d, count, out);
}

static bat_status coarsen(const bat_surface *fine, const int count[2], bat_surface **out) {
    bat_surface *half = NULL;
    bat_status status = coarser(fine, 0, count[0], &half);
    if (status == BAT_OK) status = coarser(half, 1, count[1], out);
    bat_surface_free(half);
    return status;
}

/* An edge of the base that happens to be a point is no pole: its details differ, and a pole keeps their mean only. */
static void open_edge(const bat_surface *base, int e, double distance, double *points) {
    if (!bat_edge_is_point(base, e, 0)) return;
    const bat_edge edge = bat_edge_of(base, e);
    points[3 * (edge.first + edge.count / 2 * edge.step)] += distance;
}

/* The same base with poles where the fine surface has them, and nowhere else. */
static bat_status with_poles(const bat_surface *fine, bat_surface **base) {
    double *points = malloc(3 * bat_relief_points(*base) * sizeof *points);
    bat_surface *made = NULL;
    if (!points) return BAT_MEMORY;
    bat_surface_gather(*base, points);
    for (int e = 0; e < BAT_EDGES; e++)
        if (!bat_edge_is_point(fine, e, SAME * fine->size)) open_edge(*base, e, OPEN * fine->size, points);
    for (int e = 0; e < BAT_EDGES; e++) {
        if (!bat_edge_is_point(fine, e, SAME * fine->size)) continue;
        const bat_edge edge = bat_edge_of(*base, e);
        for (size_t k = 1; k < edge.count; k++)
            memcpy(points + 3 * (edge.first + k * edge.step), points + 3 * edge.first, 3 * sizeof *points);
    }
    bat_status status = bat_surface_remade(*base, points, &made);
    free(points);
    if (status != BAT_OK) return status;
    bat_surface_free(*base);
    *base = made;
    return BAT_OK;
}

/* Adds the level whose surface is to be `wanted`. */
static bat_status read_level(bat_relief *relief, const bat_surface *wanted) {
    const int knot_count[2] = {bat_surface_knot_count(wanted, BAT_U), bat_surface_knot_count(wanted, BAT_V)};
    const double *const knots[2] = {bat_surface_knots(wanted, BAT_U), bat_surface_knots(wanted, BAT_V)};
    bat_status status = bat_relief_push(relief, knot_count, knots);
    if (status != BAT_OK) return status;
    const int j = relief->count;
    bat_relief_level *level = &relief->levels[j - 1];
    const size_t n = bat_relief_points(wanted);
    double *points = malloc(6 * n * sizeof *points);
    status = points ? bat_relief_sources(relief, j, level->source) : BAT_MEMORY;
    if (status == BAT_OK) status = bat_relief_frames(relief, j, level->frames);
    if (status == BAT_OK) {
        bat_surface_gather(wanted, points);
        bat_surface_gather(level->surface, points + 3 * n);
        for (size_t i = 0; i < n; i++)
            bat_triad_to_local(&level->frames[i],
                               vec_sub(vec_load(points + 3 * i, 3), vec_load(points + 3 * n + 3 * i, 3)),
                               level->details + 3 * i);
        bat_pole_mean(level->surface, relief->pole, level->details);
        status = bat_relief_build(relief, j);
    }
    free(points);
    return status;
}

/* counts[j]: of level j, in each direction. */
static bat_status decompose(const bat_surface *surface, int levels, int counts[][2], bat_relief **out) {
    bat_surface *chain[BAT_RELIEF_LEVELS + 1] = {NULL};
    bat_relief *relief = NULL;
    bat_status status = bat_surface_copy(surface, &chain[levels]);
    for (int j = levels; j > 0 && status == BAT_OK; j--)
        status = coarsen(chain[j], counts[j - 1], &chain[j - 1]);
    if (status == BAT_OK) status = with_poles(surface, &chain[0]);
    if (status == BAT_OK) status = bat_relief_create(chain[0], &relief);
    for (int j = 1; j <= levels && status == BAT_OK; j++) status = read_level(relief, chain[j]);
    for (int j = 0; j <= levels; j++) bat_surface_free(chain[j]);
    if (status == BAT_OK)
        *out = relief;
    else
        bat_relief_free(relief);
    return status;
}

static int halved(const bat_curve *axis, int n) {
    const int half = bat_curve_halved(axis, n);
    return axis->closed && half < 3 ? n : half;
}

bat_status bat_relief_decompose(const bat_surface *surface, int levels, bat_relief **out) {
    int counts[BAT_RELIEF_LEVELS + 1][2];
    if (!surface || !out) return BAT_ARGUMENT;
    if (levels < 0 || levels > BAT_RELIEF_LEVELS) return BAT_COUNT;
    for (int d = 0; d < 2; d++) counts[levels][d] = surface->axis[d].count;
    for (int j = levels; j > 0; j--) {
        for (int d = 0; d < 2; d++) counts[j - 1][d] = halved(&surface->axis[d], counts[j][d]);
        if (counts[j - 1][0] == counts[j][0] && counts[j - 1][1] == counts[j][1]) return BAT_COUNT;
    }
    return decompose(surface, levels, counts, out);
}

bat_status bat_relief_decompose_to(const bat_surface *surface, int levels, const size_t coarsest[2],
                                   bat_relief **out) {
    int counts[BAT_RELIEF_LEVELS + 1][2], of[BAT_LEVELS_MAX + 1];
    if (!surface || !coarsest || !out) return BAT_ARGUMENT;
    if (levels < 1 || levels > BAT_RELIEF_LEVELS) return BAT_COUNT;
    bool thinner = false;
    for (int d = 0; d < 2; d++) {
        const bat_curve *axis = &surface->axis[d];
        const int n = axis->count, least = bat_count_inside(coarsest[d]);
        if (least != n && (least < (axis->closed ? 3 : axis->degree + 1) || least > n - levels))
            return BAT_COUNT;
        if (least != n) bat_levels_counts(n, least, levels, of);
        for (int j = 0; j <= levels; j++) counts[j][d] = least != n ? of[j] : n;
        thinner = thinner || least != n;
    }
    return thinner ? decompose(surface, levels, counts, out) : BAT_COUNT;
}
