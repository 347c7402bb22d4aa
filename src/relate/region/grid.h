/* Whole numbers as doubles: places on a grid, and exact answers about them (docs/math/relate.md 6). */
#ifndef BATTEN_SRC_RELATE_REGION_GRID_H
#define BATTEN_SRC_RELATE_REGION_GRID_H

#include "relate/region/arrangement.h"

/* The sign of x0 y1 - y0 x1, exact for whole numbers of up to 2^52. */
int bat_grid_turn(const double x[2], const double y[2]);

/* The union as by bat_regions_combine, but decided on the grid at once: for boundaries that run over each other. */
bat_status bat_regions_combine_on_grid(size_t count, const bat_region *regions, double tolerance,
                                       size_t *made, bat_curve ***out);

#endif
