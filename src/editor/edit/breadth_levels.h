/*
 * The levels of the width along a stroke: its sweep and its detail apart, as those of a curve (docs/math/levels.md 3.10). The base
 * is the widths that a few points of a spline along the stroke can tell; each level has a few times as many of them, in spaces
 * that lie in one another; the finest is the profile itself, stop by stop. What a level adds to the one below it is its detail.
 */
#ifndef BATTEN_EDITOR_EDIT_BREADTH_LEVELS_H
#define BATTEN_EDITOR_EDIT_BREADTH_LEVELS_H

#include "editor/edit/breadths.h"

enum {
    BAT_BREADTH_LEVELS = 4, /* the most below the finest */
    BAT_BREADTH_DETAILS = (BAT_BREADTH_LEVELS + 1) * BAT_WIDTHS_MAX
};

/* The level of the finest detail; the base is 0. 0: so few stops have no levels. */
int bat_breadth_levels(const bat_breadths *breadths);
/* What a level can tell apart: points of its spline, for the finest the stops. */
int bat_breadth_level_points(const bat_breadths *breadths, int level);
/* What each level adds, a row of stops each: the base first, the finest last; together the shares. details: levels + 1 rows, at
 * most BAT_BREADTH_DETAILS numbers. BAT_MEMORY. O(stops * points of the level below the finest, squared). */
bat_status bat_breadths_details(const bat_breadths *breadths, double *details);
/* Every level's detail times a gain, gains[1] for that over the base up to the finest; where all are 1 nothing changes, to the bit.
 * Widths stay within 0..BAT_WIDTH_SHARE_MAX. BAT_NUMBER: a gain is not finite. As long as bat_breadths_details. */
bat_status bat_breadths_scale(const bat_breadths *base, const double *gains, bat_breadths *out);
/* A stop takes a share, and the others so much of the change as the spline of that level does (least change of its points): finer
 * detail stays as it is. From the finest level on: that stop alone. */
void bat_breadths_pull(bat_breadths *breadths, int stop, double share, int level);

#endif
