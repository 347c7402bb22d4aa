/* Unit normals on a grid. Those of ordinary points are computed side by side; where tangents nearly vanish or are nearly
 * parallel, bat_surface_normal decides. */
#include "base/lanes.h"
#include "form/surface/grid.h"
#include "form/surface/tile.h"

#include <math.h>
#include <string.h>

enum { PLANE = 3 * BAT_TILE };

/* Bounds on squares under which a point is left to bat_surface_normal. */
static const double ordinary_length = 1e-16, ordinary_sine = 1e-12, least = 1e-200, most = 1e200;

/* u_reach, v_reach: the least squares of S_u and, for each v, of S_v. False when one of the points is not ordinary. */
BAT_CLONES static bool normals_of(size_t count, const double *du, const double *dv, double u_reach,
                                  const double *v_reach, double *restrict out) {
    long long fault = 0;
    for (size_t j = 0; j < count; j++) {
        const double a = du[j], b = du[count + j], c = du[2 * count + j];
        const double d = dv[j], e = dv[count + j], f = dv[2 * count + j];
        const double x = b * f - c * e, y = c * d - a * f, z = a * e - b * d;
        const double square = x * x + y * y + z * z, u2 = a * a + b * b + c * c, v2 = d * d + e * e + f * f;
        const double scale = 1 / sqrt(square);
        out[3 * j] = x * scale, out[3 * j + 1] = y * scale, out[3 * j + 2] = z * scale;
        fault |= !(u2 > u_reach) | !(v2 > v_reach[j]) | !(square > ordinary_sine * u2 * v2) |
                 !(square > least) | !(square < most);
    }
    return !fault;
}

/* The least square of a tangent's length at a parameter: so long that over the span it is a share of the size. */
static double reach_at(const bat_surface *surface, const bat_curve *axis, double at, int *span) {
    *span = bat_span(axis, bat_curve_reduce(axis, at), *span);
    const double width = axis->knots[*span + 1] - axis->knots[*span];
    return ordinary_length * (surface->size / width) * (surface->size / width);
}

/* One row of a tile. */
static void row_of_normals(const bat_surface *surface, double u, size_t count, const double *v,
                           const double *du, const double *dv, double u_reach, const double *v_reach,
                           double *out) {
    if (normals_of(count, du, dv, u_reach, v_reach, out)) return;
    for (size_t j = 0; j < count; j++) {
        const double a[3] = {du[j], du[count + j], du[2 * count + j]};
        const double b[3] = {dv[j], dv[count + j], dv[2 * count + j]};
        double *to = out + 3 * j;
        if (!normals_of(1, a, b, u_reach, v_reach + j, to) &&
            bat_surface_normal(surface, u, v[j], to) != BAT_OK)
            memset(to, 0, 3 * sizeof *to);
    }
}

bat_status bat_surface_normal_grid(const bat_surface *surface, size_t u_count, const double *u,
                                   size_t v_count, const double *v, double *points, double *normals) {
    bat_status status = bat_grid_check(surface, u_count, u, v_count, v, normals);
    if (status != BAT_OK || u_count == 0 || v_count == 0) return status;
    double block[2][PLANE], v_reach[BAT_TILE];
    bat_tile *tile;
    status = bat_tile_create(surface, 1, true, &tile);
    if (status != BAT_OK) return status;
    int u_span = -1, v_span = -1;
    for (size_t start = 0; start < v_count; start += BAT_TILE) {
        const size_t count = v_count - start < BAT_TILE ? v_count - start : BAT_TILE;
        bat_tile_move(tile, count, v + start);
        for (size_t j = 0; j < count; j++)
            v_reach[j] = reach_at(surface, &surface->axis[1], v[start + j], &v_span);
        for (size_t i = 0; i < u_count; i++) {
            const size_t at = 3 * (i * v_count + start);
            double *const planes[BAT_TILE_PLANES] = {points ? points + at : NULL, block[0], block[1]};
            bat_tile_at(tile, u[i], planes);
            row_of_normals(surface, u[i], count, v + start, block[0], block[1],
                           reach_at(surface, &surface->axis[0], u[i], &u_span), v_reach, normals + at);
        }
    }
    bat_tile_free(tile);
    return BAT_OK;
}
