/* Figures as closed curves: rectangles, ellipses, regular polygons. Cubics, with the same knots as if a file had brought them. */
#ifndef BATTEN_HANDS_FIGURES_OUTLINES_H
#define BATTEN_HANDS_FIGURES_OUTLINES_H

#include <batten/curve.h>

/* box: x0 y0 x1 y1. radius: of its corners, at most half the shorter side; 0: sharp. Round corners are off a circle by at most
 * 5e-6 of the radius. BAT_COUNT: the box has no width or no height. */
bat_status bat_figure_rectangle(const double box[4], double radius, bat_curve **out);
/* The ellipse in the box, off it by at most 5e-6 of the half axes: eight cubics (handles of 4/3 tan(pi / 16)). */
bat_status bat_figure_ellipse(const double box[4], bat_curve **out);
/* A regular polygon about a middle, with one corner at `corner`; sides: 3 to 1000. */
bat_status bat_figure_polygon(const double middle[2], const double corner[2], int sides, bat_curve **out);

#endif
