/* Internal: what follows each other, such as the spans of a curve, in boxes within boxes, each along an axis of its own. */
#ifndef BATTEN_SRC_RELATE_HULLS_H
#define BATTEN_SRC_RELATE_HULLS_H

#include <batten/curve.h>

#include "base/vec.h"

/* The points of thing i: *count of them, each of as many numbers as dimensions. */
typedef const double *(*bat_hull_points)(const void *things, size_t i, size_t *count);

/* Two boxes around the same points: along the coordinates and along axes of its own, the first of which points to what is
 * furthest away. */
typedef struct bat_hull {
    int size;
    double low[3], high[3];
    vec axis[3];
    double from[3], to[3];
    double across; /* the diagonal of the second */
} bat_hull;

/* A stretch of the things: `count` from `first` on, whose hull is hulls[node]. */
typedef struct bat_hull_part {
    size_t node, first, count;
} bat_hull_part;

/* The hulls of n >= 1 things and of their stretches, 2 n - 1 of them; the whole is {0, 0, n}. *out is the caller's (free).
 * O(n log n). */
bat_status bat_hulls_create(int size, size_t n, bat_hull_points points, const void *things, bat_hull **out);
/* Both halves of a stretch of several things. */
void bat_hull_halve(bat_hull_part s, bat_hull_part half[2]);
/* Whether two hulls are more than `gap` apart along one of their axes. */
bool bat_hulls_apart(const bat_hull *a, const bat_hull *b, double gap);
/* Whether a point is within `gap` of both boxes. */
bool bat_hull_beside(const bat_hull *hull, const double *point, double gap);

#endif
