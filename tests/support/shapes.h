/* Comparisons of shapes for the tests of levels. */
#ifndef BATTEN_TESTS_SHAPES_H
#define BATTEN_TESTS_SHAPES_H

#include <batten/levels.h>
#include <math.h>

#include "curve/curve.h"

static inline const bat_curve *shape_finest(const bat_shape *shape) {
    return bat_shape_curve(shape, bat_shape_levels(shape));
}

/* The greatest difference of a coordinate of the control points; INFINITY if their numbers differ. */
static inline double points_apart(const bat_curve *a, const bat_curve *b) {
    double most = 0;
    if (bat_point_count(a) != bat_point_count(b)) return INFINITY;
    for (int i = 0; i < bat_point_count(a) * bat_curve_dimension(a); i++)
        most = fmax(most, fabs(bat_curve_points(a)[i] - bat_curve_points(b)[i]));
    return most;
}

/* The same curves and details, bit for bit. */
static inline bool shapes_same(const bat_shape *a, const bat_shape *b) {
    if (bat_shape_levels(a) != bat_shape_levels(b)) return false;
    for (int l = 0; l <= bat_shape_levels(a); l++) {
        const bat_curve *c = bat_shape_curve(a, l);
        if (!bat_curve_is_equal(c, bat_shape_curve(b, l))) return false;
        for (int i = 0; l > 0 && i < 3 * bat_point_count(c); i++)
            if (bat_shape_details(a, l)[i] != bat_shape_details(b, l)[i]) return false;
    }
    return true;
}

#endif
