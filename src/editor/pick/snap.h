/*
 * Snapping: what a place near the pen is drawn to. Of what lies within reach, ends come before crossings, then guides,
 * curves, and the grid; of one kind, the nearest. Switched by properties; Ctrl or Meta held turns it off for a while.
 */
#ifndef BATTEN_EDITOR_PICK_SNAP_H
#define BATTEN_EDITOR_PICK_SNAP_H

#include "editor/session/context.h"

typedef enum bat_snap_kind {
    BAT_SNAP_NONE,
    BAT_SNAP_END,      /* of an open curve */
    BAT_SNAP_CROSSING, /* of two curves, a curve with itself, curves and guides */
    BAT_SNAP_GUIDE,
    BAT_SNAP_CURVE,
    BAT_SNAP_GRID,
    BAT_SNAP_ANGLE /* steps of 15 degrees from where a drag began, with Shift */
} bat_snap_kind;

typedef struct bat_snap {
    bat_snap_kind kind;
    double point[2]; /* document units */
    bool bound[2];   /* which of its coordinates are drawn; both but for guides and the grid */
    double distance; /* that it was drawn over, document units */
    double from[2];  /* ANGLE: where the ray begins */
} bat_snap;

/* A place that may snap, and to which kinds (bits 1 << kind). */
typedef struct bat_snap_source {
    double point[2]; /* document units */
    unsigned kinds;
} bat_snap_source;

#define BAT_SNAP_ALL (~0u)
#define BAT_SNAP_LINES (1u << BAT_SNAP_GUIDE | 1u << BAT_SNAP_GRID)

/*
 * What one of the sources, moved by delta, snaps to. kind NONE: nothing. Objects at the document indices but[0..count),
 * ascending, are left aside: what moves. The scene must be in step. Costs a box test an object and source, and the
 * finders of what is near. *which (may be NULL): the source that snapped.
 */
bat_snap bat_snap_find(bat_context *c, int count, const int *but, int source_count,
                       const bat_snap_source *sources, const double delta[2], int *which);
/* The same for one place; kept for the picture. `point` becomes the place snapped to. */
void bat_snap_point(bat_context *c, int count, const int *but, double point[2]);
/* `point` goes to the nearest ray of 15 degrees (or, with that switched off, axis) from the origin; kept for the
 * picture. */
void bat_snap_angle(bat_context *c, const double origin[2], double point[2]);

/* The distance of the grid's lines as they are drawn, document units; 0: no grid is shown. */
double bat_grid_step(const bat_context *c);

#endif
