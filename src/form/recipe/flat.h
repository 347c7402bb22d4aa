/* Internal: the plane or line that the control points of a curve lie in. */
#ifndef BATTEN_FORM_FLAT_H
#define BATTEN_FORM_FLAT_H

#include "base/vec.h"

#include <batten/curve.h>

/* Of the size: what is this close to a plane or a line lies in it. */
#define BAT_FLAT_SHARE 1e-6

typedef struct bat_flat {
    vec at, across, normal; /* a point; unit: the longest way from it, the normal of the plane; 0: straight */
    double size;
    bool planar; /* and not straight */
} bat_flat;

/* The plane through the first control point, the one farthest from it, and the one farthest from the line of both.
 * O(points). */
bat_flat bat_curve_flat(const bat_curve *curve);
static inline bool bat_flat_is_straight(const bat_flat *flat) { return !(vec_norm(flat->normal) > 0); }

#endif
