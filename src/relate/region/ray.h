/* Rays from places of edges, which tell on which side of them a region lies (docs/math/relate.md 6). */
#ifndef BATTEN_SRC_RELATE_REGION_RAY_H
#define BATTEN_SRC_RELATE_REGION_RAY_H

#include "relate/region/arrangement.h"

/* A ray along +x from a point; across: x and y have changed places. */
typedef struct bat_region_ray {
    double x, y;
    bool across;
    double
        near; /* how near to the point a box was that it lies in: no more than a few times the distance of the edge */
} bat_region_ray;

/* How often an edge crosses the ray upwards, less how often downwards. */
int bat_ray_crossings(bat_region_ray *r, const bat_region_edge *e, int degree);
/* The ray from a place of the edge, and how often the rest of the edge crosses it: all but a piece round the place, which
 * crosses it once there. False: it cannot be told there. */
bool bat_ray_cast(const bat_region_edge *e, int degree, double place, bat_region_ray *r, bool *up, int *rest);
/* The same of the straight line between two points, which the ray's start is not on. */
int bat_ray_chord(const bat_region_ray *r, const double *from, const double *to);

#endif
