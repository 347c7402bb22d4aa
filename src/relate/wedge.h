/* Inside the room: what the lines across a curve leave out near it. */
#ifndef BATTEN_SRC_RELATE_WEDGE_H
#define BATTEN_SRC_RELATE_WEDGE_H

#include <batten/curve.h>

/* A line across a curve: where, and the curve's direction (a unit vector) there. */
typedef struct bat_across {
    double at[2], way[2];
    bool corner; /* from here the direction jumps to that of the next one */
} bat_across;

/* A convex polygon, anticlockwise; its points are the caller's. */
typedef struct bat_wedge {
    size_t count;
    double *points; /* x y */
    bool used;
} bat_wedge;

/*
 * What no line across an open curve meets, of a square of half size `far` around the origin: there the curve first leaves
 * a point and, from a corner on, comes nearer; a convex polygon for each of the corners and the ends, or none.
 * *out is the caller's (bat_wedges_free). O(n m), m the points of a polygon: few, unless the curve bends evenly.
 */
bat_status bat_wedges_of(const bat_across *lines, size_t n, double far, size_t *count, bat_wedge **out);
void bat_wedges_free(size_t count, bat_wedge *wedges);
/* The points of a wedge that lie, clockwise, between two places on its border, which are no further from it than `reach`; at most
 * `count` of the wedge's are written. False: the places are not on its border, or that way leads around it. */
bool bat_wedge_between(const bat_wedge *w, const double *from, const double *to, double reach, double *out,
                       size_t *count);

#endif
