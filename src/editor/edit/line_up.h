/* Aligning and distributing: how far each of several things is to go along an axis. */
#ifndef BATTEN_EDITOR_EDIT_LINE_UP_H
#define BATTEN_EDITOR_EDIT_LINE_UP_H

#include "editor/tables/commands.h"

typedef struct bat_line_up {
    int axis;     /* 0: x, 1: y */
    bool spreads; /* the distances between middles become equal, and the outer two stay; else: */
    double
        share; /* where all come to: 0 at the least coordinate of the whole, .5 in its middle, 1 at its end */
    bat_string step; /* what it is called */
} bat_line_up;

typedef struct bat_in_line {
    double low, high; /* what a thing takes up along the axis */
    double by;        /* how far it is to go */
} bat_in_line;

/* What the command does. */
bat_line_up bat_line_up_of(bat_command_id id);
/* Finds `by` of each. whole: from where to where they are aligned; NULL: what all take up. BAT_STATE: fewer than two without a
 * whole, or fewer than three to distribute; BAT_MEMORY. O(n log n). */
bat_status bat_line_up_find(const bat_line_up *how, int count, bat_in_line *things, const double *whole);

#endif
