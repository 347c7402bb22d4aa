/*
 * Snapping: what a point near the pen is attracted to. Near is what is seen near: in a tilted view, too. Among things within reach, ends come before crossings, then
 * guides, curves, and the grid; of one kind, the nearest wins. Properties turn it on and off; holding Ctrl or Meta
 * suspends it.
 */
#ifndef BATTEN_EDITOR_PICK_SNAP_H
#define BATTEN_EDITOR_PICK_SNAP_H

#include "editor/session/context.h"
#include "editor/view/ground.h"

typedef enum bat_snap_kind {
    BAT_SNAP_NONE,
    BAT_SNAP_END,      /* of an open curve */
    BAT_SNAP_CROSSING, /* of two curves, a curve with itself, curves and guides */
    BAT_SNAP_GUIDE,
    BAT_SNAP_CURVE,
    BAT_SNAP_GRID,
    BAT_SNAP_ANGLE /* Shift: steps of 15 degrees from where a drag began */
} bat_snap_kind;

typedef struct bat_snap {
    bat_snap_kind kind;
    double point[3]; /* document units; on the page z is 0 */
    bool bound[3];   /* which coordinates are fixed; all, except for guides and the square grid */
    double distance; /* by which it was moved, document units */
    double from[2];  /* ANGLE: origin of the ray */
} bat_snap;

/* A point that may snap, and the kinds it may snap to (bits 1 << kind). */
typedef struct bat_snap_source {
    double point[3]; /* document units */
    unsigned kinds;
} bat_snap_source;

#define BAT_SNAP_ALL (~0u)
#define BAT_SNAP_LINES (1u << BAT_SNAP_GUIDE | 1u << BAT_SNAP_GRID)

/*
 * What one of the sources, moved by delta, snaps to. kind NONE: nothing. Objects at the document indices
 * but[0..count), ascending, are ignored: they are being moved. The scene must be up to date. Costs a box test per
 * object and source, and a search in the curves nearby. *which (may be NULL): the source that snapped.
 */
bat_snap bat_snap_find(bat_context *c, int count, const int *but, int source_count,
                       const bat_snap_source *sources, const double delta[2], int *which);
/* The same in space: it snaps to what is on the page or in space, as far as the coordinates that are free allow, and to no
 * guides; to what is found beside them it comes only where both are then seen in one place. */
bat_snap bat_snap_find_space(bat_context *c, int count, const int *but, int source_count,
                             const bat_snap_source *sources, const double delta[3], const bool free[3],
                             int *which);
/* The same for a single point of the page; the result is kept for display. `point` becomes the point snapped to. */
void bat_snap_point(bat_context *c, int count, const int *but, double point[2]);
/* The same for a single point of the plane in space that is drawn on: the grid is the plane's own. */
void bat_snap_point_space(bat_context *c, int count, const int *but, double point[3]);
/* Moves `point` to the nearest ray in steps of 15 degrees (or, with that turned off, the nearest axis) from the
 * origin; the result is kept for display. */
void bat_snap_angle(bat_context *c, const double origin[2], double point[2]);

/* The grid: on the plane in space that is drawn on, or else on the page. */
typedef struct bat_grid {
    double step;    /* between lines as they are drawn, document units; 0: no grid is shown */
    bool triangles; /* isometric.h; otherwise squares */
    bat_ground
        ground; /* the plane or the page; zero: the corner it counts from, in the ground's own coordinates */
    double zero[2];
} bat_grid;

bat_grid bat_grid_shown(const bat_context *c);

#endif
