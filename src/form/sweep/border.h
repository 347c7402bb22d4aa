/* Internal: the edge of a surface, and how the surface goes on across it. */
#ifndef BATTEN_FORM_BORDER_H
#define BATTEN_FORM_BORDER_H

#include "curve/curve.h"
#include <batten/blend.h>
#include <batten/sweep.h>

/* An edge: the line, and its derivatives along the outward direction, points of curves with the line's knots. */
typedef struct bat_surface_border {
    bat_curve *line; /* in space */
    double *across;  /* (order + 1) * count * 3 */
    int order;
} bat_surface_border;

bool bat_is_side(bat_side side);
/* out: all zero before, to be cleared whatever it returns. BAT_ARGUMENT: the surface is closed across the edge; BAT_SINGULAR: the edge is a point. */
bat_status bat_surface_border_read(const bat_surface *s, bat_side side, int order, bat_surface_border *out);
void bat_surface_border_clear(bat_surface_border *b);
/* How fast its surface runs across, in the mean of even shares of the edge. */
double bat_surface_border_speed(const bat_surface_border *b);

#endif
