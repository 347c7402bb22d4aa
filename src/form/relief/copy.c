/* Moves the levels of one relief to another base: details are splines of three coordinates that go along, direction by
 * direction, as those of curves do. */
#include "form/relief/relief.h"

#include <stdlib.h>
#include <string.h>

/* How parameters of one direction are carried over. */
static bat_knot_map map_of(const bat_relief *from, const bat_surface *onto, int d) {
    bat_knot_map map = {.count = 2, .drawn = -1, .closed = from->base->axis[d].closed};
    bat_curve_domain(&from->base->axis[d], map.from);
    bat_curve_domain(&onto->axis[d], map.to);
    return map;
}

/* The knots of the level in a direction: those below, and those of the details. The detail of the first row or column
 * serves as example: the others have the same knots. */
static bat_status knots_of(const bat_curve *details_axis, const bat_curve *below, const bat_knot_map *map,
                           double **knots, int *count) {
    double *zeros = calloc(3 * (size_t)details_axis->count, sizeof *zeros);
    bat_curve *curve = NULL;
    bat_status status = zeros ? bat_detail_curve(details_axis, zeros, below, map, &curve) : BAT_MEMORY;
    free(zeros);
    if (status != BAT_OK) return status;
    *knots = malloc((size_t)(bat_curve_knot_count(below) + bat_curve_knot_count(curve)) * sizeof **knots);
    if (*knots)
        *count = bat_detail_knots(below, curve, *knots);
    else
        status = BAT_MEMORY;
    bat_curve_free(curve);
    return status;
}

/* One direction of a transfer: lines of details from one basis to another. */
typedef struct carriage {
    const bat_curve *from, *below, *onto;
    const bat_knot_map *map;
    double *nodes; /* of onto, in its domain */
} carriage;

static bat_status carry(const carriage *c, const double *details, double *out) {
    bat_curve *curve = NULL;
    bat_status status = bat_detail_curve(c->from, details, c->below, c->map, &curve);
    if (status == BAT_OK) status = bat_detail_take(curve, c->onto, c->nodes, out);
    bat_curve_free(curve);
    return status;
}

static bat_status nodes_of(const bat_curve *axis, double **out) {
    *out = malloc((size_t)axis->count * sizeof **out);
    if (!*out) return BAT_MEMORY;
    bat_curve_greville(axis, *out);
    for (int i = 0; i < axis->count; i++) (*out)[i] = bat_curve_reduce(axis, (*out)[i]);
    return BAT_OK;
}

/* Rows first, then columns: rows * columns vectors become c[0].onto->count * c[1].onto->count of them. */
static bat_status carry_both(const carriage c[2], const double *details, double *out) {
    const size_t rows = (size_t)c[0].from->count, tall = (size_t)c[0].onto->count,
                 columns = (size_t)c[1].from->count, wide = (size_t)c[1].onto->count;
    double *middle = malloc(3 * rows * wide * sizeof *middle), *column = malloc(3 * rows * sizeof *column),
           *carried = malloc(3 * tall * sizeof *carried);
    bat_status status = middle && column && carried ? BAT_OK : BAT_MEMORY;
    for (size_t i = 0; i < rows && status == BAT_OK; i++)
        status = carry(&c[1], details + 3 * i * columns, middle + 3 * i * wide);
    for (size_t k = 0; k < wide && status == BAT_OK; k++) {
        for (size_t i = 0; i < rows; i++)
            memcpy(column + 3 * i, middle + 3 * (i * wide + k), 3 * sizeof *column);
        status = carry(&c[0], column, carried);
        for (size_t i = 0; i < tall && status == BAT_OK; i++)
            memcpy(out + 3 * (i * wide + k), carried + 3 * i, 3 * sizeof *out);
    }
    free(middle), free(column), free(carried);
    return status;
}

static bat_status copy_level(bat_relief *relief, const bat_relief_level *from, const bat_knot_map map[2]) {
    const bat_surface *below = bat_relief_at(relief, relief->count);
    double *knots[2] = {NULL, NULL}, *nodes[2] = {NULL, NULL};
    int count[2] = {0, 0};
    bat_status status = BAT_OK;
    for (int d = 0; d < 2 && status == BAT_OK; d++)
        status = knots_of(&from->surface->axis[d], &below->axis[d], &map[d], &knots[d], &count[d]);
    if (status == BAT_OK) status = bat_relief_push(relief, count, (const double *const *)knots);
    if (status == BAT_OK) {
        bat_relief_level *level = &relief->levels[relief->count - 1];
        carriage c[2];
        level->gain = from->gain, level->muted = from->muted;
        for (int d = 0; d < 2 && status == BAT_OK; d++) {
            status = nodes_of(&level->surface->axis[d], &nodes[d]);
            c[d] = (carriage){&from->surface->axis[d], &below->axis[d], &level->surface->axis[d], &map[d],
                              nodes[d]};
        }
        if (status == BAT_OK) status = carry_both(c, from->details, level->details);
        if (status == BAT_OK) status = bat_relief_sources(relief, relief->count, level->source);
        if (status == BAT_OK) status = bat_relief_frames(relief, relief->count, level->frames);
        if (status == BAT_OK) {
            bat_pole_mean(level->surface, relief->pole, level->details);
            status = bat_relief_build(relief, relief->count);
        }
    }
    for (int d = 0; d < 2; d++) free(knots[d]), free(nodes[d]);
    return status;
}

bat_status bat_relief_copy_levels(const bat_relief *from, const bat_surface *onto, bat_relief **out) {
    if (!from || !onto || !out) return BAT_ARGUMENT;
    bat_relief *relief = NULL;
    const bat_knot_map map[2] = {map_of(from, onto, 0), map_of(from, onto, 1)};
    bat_status status = bat_relief_create(onto, &relief);
    for (int l = 0; l < from->count && status == BAT_OK; l++)
        status = copy_level(relief, &from->levels[l], map);
    if (status == BAT_OK)
        *out = relief;
    else
        bat_relief_free(relief);
    return status;
}
