/* Inside the room: how often all edges cross a ray. */
#ifndef BATTEN_SRC_RELATE_REGION_WINDING_H
#define BATTEN_SRC_RELATE_REGION_WINDING_H

#include "relate/hulls.h"
#include "relate/region/ray.h"

/* Edges in the order of their curves, which are in the order of a curve that fills the plane, and the hulls of their stretches. A
 * run is a stretch of edges each of which begins where the one before ends. */
typedef struct bat_winding {
    const bat_arrangement *a;
    size_t count;
    size_t *order;               /* edges */
    size_t *run_start, *run_end; /* of the run of each place of the order; one behind its end */
    size_t *open; /* runs before each place of the order that do not come back to their start; count + 1 */
    bat_hull *hulls;
} bat_winding;

/* O(n log n) in the points of the edges. Free it also after a failure. */
bat_status bat_winding_create(const bat_arrangement *a, bat_winding *out);
void bat_winding_free(bat_winding *w);

/* Called for each stretch of a region's edges that crosses a ray. */
typedef void (*bat_winding_add)(void *to, size_t region, int crossed);
/* Edges that run along `skip`, and it, are left out. near: a stretch that is further away is only asked for its ends. The
 * logarithm of the edges, and what has the ray's start nearby. */
void bat_winding_count(const bat_winding *w, bat_region_ray *r, size_t skip, double near, bat_winding_add add,
                       void *to);

#endif
