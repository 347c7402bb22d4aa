/* Internal to surfaces: a stretch of a grid. The parameters v of a tile are met by many u: the stored rows of the
 * surface are evaluated at all v of the tile first, and for each u the values of a few rows are blended. */
#ifndef BATTEN_FORM_TILE_H
#define BATTEN_FORM_TILE_H

#include "form/surface/surface.h"

/* How many v a tile has at most: the rows that are blended then stay in the nearest cache. */
enum { BAT_TILE = 128, BAT_TILE_PLANES = 6 };

typedef struct bat_tile bat_tile;

/* order: 0 to 2, of the derivatives. apart, with order 1: planes of derivatives hold the x of all points, then the y, then
 * the z, which is quicker to compute with. Borrows the surface. One allocation. */
bat_status bat_tile_create(const bat_surface *surface, int order, bool apart, bat_tile **out);
void bat_tile_free(bat_tile *tile); /* NULL is fine */
/* count: at most BAT_TILE; v: ascending, without NaN, borrowed until the next move. */
void bat_tile_move(bat_tile *tile, size_t count, const double *v);
/* Position and derivatives at u (not NaN) and each v, a plane each: planes[n] gets 3 * count numbers, in the order of
 * bat_surface_eval; planes that are NULL are left out. Quickest when calls go through u in its order. */
void bat_tile_at(bat_tile *tile, double u, double *const planes[BAT_TILE_PLANES]);

/* Numbers that are not computed yet: the sum of weights[j] rows[j], planes of x, y and z. */
typedef struct bat_tile_sum {
    double weights[BAT_DEGREE_MAX + 1];
    const double *rows[BAT_DEGREE_MAX + 1];
} bat_tile_sum;

/* For tiles of order 1, apart: S_u at u and each v as a sum of as many rows as the degree in u says, S_v as one of one row
 * more, for who computes with them at once. points: as above; NULL: none. Returns whether the rows are others than those of
 * the last call for this tile. */
bool bat_tile_tangents(bat_tile *tile, double u, double *points, bat_tile_sum sums[2]);

#endif
