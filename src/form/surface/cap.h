/* Caps on the open ends of a surface that is closed around: it then bounds a solid. */
#ifndef BATTEN_FORM_CAP_H
#define BATTEN_FORM_CAP_H

#include <batten/surface.h>

/* How many ends of the surface are open: 0 to 2 where it is closed in one direction and its knots in the other end with full
 * multiplicity, 0 of any other. An end that is a point is closed. O(points). */
int bat_surface_open_ends(const bat_surface *surface);
/* Goes on from each open end, over a crease, in straight lines to the rim's middle, the mean of its control points: a rim that lies
 * in a plane gets a plane. The surface as it was keeps every bit. BAT_STATE: no end is open; else as bat_surface_create.
 * O(points). */
bat_status bat_surface_cap(const bat_surface *surface, bat_surface **out);

#endif
