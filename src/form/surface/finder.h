/* Internal: the boxes of a surface's spans, and of blocks of them, made once for many queries. */
#ifndef BATTEN_FORM_FINDER_H
#define BATTEN_FORM_FINDER_H

#include "form/surface/cell.h"

enum { BAT_FINDER_BLOCK = 8 }; /* spans to a side of a block */

typedef struct bat_box {
    double low[3], high[3];
} bat_box;

struct bat_surface_finder {
    const bat_surface *surface;
    int spans[2], blocks[2]; /* counts; spans that are empty have their box, too */
    bat_box *span, *block;   /* rows along u */
    bat_box whole;
    double *shares[2]; /* of each span of u, of v: bat_cell_shares */
};

/* The numbers of a span (from 0) as stored knot intervals; false: the span is empty. */
bool bat_finder_span(const bat_surface_finder *finder, int i, int j, int span[2]);
/* The net of a span, as bat_cell_gather gave it, as that of a cell. */
void bat_finder_share(const bat_surface_finder *finder, const int span[2], double *net);
/* The closest point within a distance, to 1e-12 of it, for many queries that follow each other. Where more than BAT_NEAR_CELLS
 * pieces are nearly as close (on the axis of a tube), it is within 1e-6 of the closest. *found: whether there is one; out is
 * filled in then. hints NULL: bat_surface_finder_nearest. */
enum { BAT_NEAR_CELLS = 2000 };
typedef struct bat_near_hints {
    double within;    /* may be INFINITY */
    const double *at; /* u and v where it is expected; NULL: not known */
    size_t *pieces;   /* how many were looked at is added; NULL: nobody asks */
} bat_near_hints;
bat_status bat_finder_near(const bat_surface_finder *finder, const double point[3],
                           const bat_near_hints *hints, bat_surface_point *out, bool *found);
/* Room for the surface in other coordinates: knots, but no points yet. */
bat_status bat_finder_seen(const bat_surface_finder *finder, bat_surface **out);
/* Fills in the points of a span: axes . (point - origin); axes: 3 rows, or NULL: the identity. */
void bat_finder_see(const bat_surface_finder *finder, const int span[2], const double *origin,
                    const double *axes, bat_surface *seen);

#endif
