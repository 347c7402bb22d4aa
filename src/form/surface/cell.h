/* Internal to surfaces: cells, which are pieces of a span in Bézier form, halved until a query is decided. */
#ifndef BATTEN_FORM_CELL_H
#define BATTEN_FORM_CELL_H

#include "form/surface/surface.h"

enum {
    BAT_CELL_POINTS = (BAT_DEGREE_MAX + 1) * (BAT_DEGREE_MAX + 1),
    BAT_CELL_HALVINGS = 80 /* of both directions together */
};

typedef struct bat_cell {
    double net[3 * BAT_CELL_POINTS]; /* rows of control points: rows along u, points along v */
    double low[2], high[2];          /* range of the cell within the span's [0, 1] */
    int halvings;
} bat_cell;

/* Cells that wait, the last of them first; few wait at once, though many are halved. */
typedef struct bat_cells {
    bat_cell *at;
    int room;
} bat_cells;

/* Makes room for a number of cells and keeps those that are there; false without memory. */
bool bat_cells_hold(bat_cells *cells, int wanted);
/* The control points of a span of the surface, of which the span is an average, as the net of a cell. */
void bat_cell_gather(const bat_surface *surface, const int span[2], double *net);
/* The Bézier points of a span of an axis as sums of its p + 1 control points: (p + 1)^2 shares, row by row. */
void bat_cell_shares(const bat_curve *axis, int span, double *out);
/* The net that bat_cell_gather gave, as that of a cell, by the shares of both directions. */
void bat_cell_share(const int degree[2], const double *const shares[2], double *net);
/* The whole span as a cell. */
void bat_cell_of(const bat_surface *surface, const int span[2], bat_cell *out);
/* Halves the cell in a direction: `cell` keeps the lower half, `upper` becomes the other one. */
void bat_cell_halve(const int degree[2], int direction, bat_cell *cell, bat_cell *upper);
/* The parameter in a direction at x in a span's [0, 1]. */
double bat_span_parameter(const bat_surface *surface, int direction, int span, double x);

#endif
