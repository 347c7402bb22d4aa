/* Inside the room: how corners and ends of an outline are formed, and which places those shapes hold beyond the circles. */
#ifndef BATTEN_SRC_RELATE_BRIM_H
#define BATTEN_SRC_RELATE_BRIM_H

#include <batten/nearest.h>
#include <batten/relate.h>

/* Where a corner or an end is nearest, what is beyond one of the lines is outside. */
typedef struct bat_patch {
    double u, point[2]; /* on the curve */
    int order, count;   /* order: in which they were added; count: of lines */
    double lines[3][3]; /* unit vector outwards, distance from the point */
    const bat_finder
        *rest; /* NULL, or the curve without the stretch before this end: what that holds is inside, too */
} bat_patch;

typedef struct bat_brim {
    bat_cap cap;
    bat_join join;
    double miter_limit, near; /* near: how far from its point a patch begins */
    int count, room;
    bat_patch *patches; /* ascending in u once they are sorted */
    bat_finder *rest[2];
} bat_brim;

bat_status bat_brim_add(bat_brim *brim, const bat_patch *patch);
void bat_brim_sort(bat_brim *brim);
/* How far x is outside of the outline at a distance, less than 0 inside, where `near` is the place of the curve nearest to it. */
double bat_brim_depth(const bat_brim *brim, const double *x, const bat_near *near, double distance);
void bat_brim_clear(bat_brim *brim);

#endif
