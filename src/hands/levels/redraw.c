/* A free stroke over a shape's base: the base takes the sketch's knots, the details follow their places. */
#include "hands/levels/shape.h"

#include "curve/curve.h"

#include <string.h>

/* Outside the replaced interval the parameters move as one; on it they are stretched evenly. */
static bat_knot_map map_of(const bat_curve *old, const bat_curve *fresh, const bat_sketch_report *r,
                           bool drop) {
    bat_knot_map map = {.closed = old->closed, .drop = drop};
    double a[2], b[2];
    bat_curve_domain(old, a);
    bat_curve_domain(fresh, b);
    const double *from = r->changed, *to = r->changed_new;
    if (r->replaced || !(from[0] < from[1])) {
        map.count = 2;
        memcpy(map.from, a, sizeof a), memcpy(map.to, b, sizeof b);
        return map;
    }
    if (old->closed) {
        map.count = 3;
        map.from[0] = from[0], map.from[1] = from[1], map.from[2] = from[0] + (a[1] - a[0]);
        map.to[0] = to[0], map.to[1] = to[1], map.to[2] = to[0] + (b[1] - b[0]);
        return map;
    }
    map.count = 4, map.drawn = 1;
    map.from[0] = a[0], map.from[1] = from[0], map.from[2] = from[1], map.from[3] = a[1];
    map.to[0] = b[0], map.to[1] = to[0], map.to[2] = to[1], map.to[3] = b[1];
    return map;
}

bat_status bat_shape_redraw(const bat_shape *shape, const bat_stroke *stroke, bool drop,
                            const bat_sketch_options *options, bat_shape **out, bat_sketch_report *report) {
    if (!shape || !out) return BAT_ARGUMENT;
    bat_curve *base;
    bat_sketch_report facts;
    bat_status drawn = bat_sketch(shape->base, stroke, options, &base, &facts);
    if (drawn != BAT_OK && drawn != BAT_TOLERANCE) return drawn;
    bat_knot_map map = map_of(shape->base, base, &facts, drop);
    bat_status status = bat_shape_copy_mapped(shape, base, &shape->options, &map, out);
    bat_curve_free(base);
    if (status != BAT_OK) return status;
    if (report) *report = facts;
    return drawn;
}
