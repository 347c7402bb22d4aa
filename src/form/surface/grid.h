/* Internal to surfaces: what grids have in common. */
#ifndef BATTEN_FORM_GRID_H
#define BATTEN_FORM_GRID_H

#include "form/surface/surface.h"

/* The arguments of a call that fills a grid, before anything is written; a grid without points is BAT_OK. */
bat_status bat_grid_check(const bat_surface *surface, size_t u_count, const double *u, size_t v_count,
                          const double *v, const double *out);

#endif
