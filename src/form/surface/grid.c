/* Evaluation on a grid, tile by tile. */
#include "form/surface/grid.h"
#include "form/surface/tile.h"

#include <math.h>
#include <string.h>

enum { PLANE = 3 * BAT_TILE };

bat_status bat_grid_check(const bat_surface *surface, size_t u_count, const double *u, size_t v_count,
                          const double *v, const double *out) {
    if (!surface) return BAT_ARGUMENT;
    if (u_count == 0 || v_count == 0) return BAT_OK;
    if (!u || !v || !out) return BAT_ARGUMENT;
    if (v_count > SIZE_MAX / 256 || u_count > SIZE_MAX / 256 / v_count) return BAT_COUNT;
    for (size_t i = 0; i < u_count; i++)
        if (isnan(u[i])) return BAT_NUMBER;
    return bat_parameters_check(v_count, v);
}

/* Planes side by side: blocks of 3 * planes numbers. */
static void weave(int planes, size_t count, double *const *from, double *out) {
    const size_t block = 3 * (size_t)planes;
    for (int n = 0; n < planes; n++) {
        const double *in = from[n];
        double *to = out + 3 * n;
        for (size_t j = 0; j < count; j++, in += 3, to += block) memcpy(to, in, 3 * sizeof *to);
    }
}

bat_status bat_surface_eval_grid(const bat_surface *surface, size_t u_count, const double *u, size_t v_count,
                                 const double *v, int order, double *out) {
    if (order < 0 || order > 2) return BAT_ARGUMENT;
    bat_status status = bat_grid_check(surface, u_count, u, v_count, v, out);
    if (status != BAT_OK || u_count == 0 || v_count == 0) return status;
    const int planes = (order + 1) * (order + 2) / 2;
    double block[BAT_TILE_PLANES][PLANE], *plane[BAT_TILE_PLANES];
    bat_tile *tile;
    status = bat_tile_create(surface, order, false, &tile);
    if (status != BAT_OK) return status;
    for (int n = 0; n < BAT_TILE_PLANES; n++) plane[n] = block[n];
    for (size_t start = 0; start < v_count; start += BAT_TILE) {
        const size_t count = v_count - start < BAT_TILE ? v_count - start : BAT_TILE;
        bat_tile_move(tile, count, v + start);
        for (size_t i = 0; i < u_count; i++) {
            double *to = out + (i * v_count + start) * 3 * (size_t)planes;
            if (order == 0) plane[0] = to;
            bat_tile_at(tile, u[i], plane);
            if (order > 0) weave(planes, count, plane, to);
        }
    }
    bat_tile_free(tile);
    return BAT_OK;
}
