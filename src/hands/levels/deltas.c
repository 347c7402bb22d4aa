/* Deltas of control points, as details. */
#include "hands/levels/shape.h"

#include "curve/curve.h"

bat_status bat_level_add(bat_shape *shape, int level, int first, int count, const double *deltas,
                         double factor) {
    int size = shape->base->dimension, n = bat_shape_curve(shape, level)->count;
    bat_level *at = level > 0 ? &shape->levels[level - 1] : NULL;
    double gain = at ? bat_level_gain(at) : 1;
    if (gain == 0) return BAT_STATE; /* a muted level shows no change */
    for (int i = 0; i < count; i++) {
        int k = (first + i) % n;
        vec v = vec_scale(vec_load(deltas + i * size, size), factor);
        double local[3], *to = at ? at->details + 3 * k : bat_curve_own_points(shape->base) + k * size;
        if (at)
            bat_triad_to_local(&at->frames[k], vec_scale(v, 1 / gain), local);
        else
            vec_store(v, local);
        for (int d = 0; d < (at ? 3 : size); d++) to[d] += local[d];
    }
    if (!at) bat_curve_unroll(shape->base);
    return BAT_OK;
}
