/* The nearest point of a triangle. */
#include "form/compare/triangle.h"

static vec nearest_on_side(vec a, vec b, vec p) {
    const vec way = vec_sub(b, a);
    const double square = vec_dot(way, way);
    const double share = square > 0 ? vec_dot(vec_sub(p, a), way) / square : 0;
    if (!(share > 0)) return a;
    return share < 1 ? vec_add(a, vec_scale(way, share)) : b;
}

vec bat_triangle_nearest(vec a, vec b, vec c, vec p) {
    const vec ab = vec_sub(b, a), ac = vec_sub(c, a), ap = vec_sub(p, a), across = vec_cross(ab, ac);
    const vec normal = vec_unit(across);
    /* Areas: of the whole, and of the parts that belong to b and c at the foot of p on the plane. */
    const double whole = vec_dot(across, normal);
    const double at_b = vec_dot(vec_cross(ap, ac), normal), at_c = vec_dot(vec_cross(ab, ap), normal);
    vec foot[4] = {nearest_on_side(a, b, p), nearest_on_side(b, c, p), nearest_on_side(c, a, p)};
    int count = 3;
    if (whole > 0 && at_b >= 0 && at_c >= 0 && at_b + at_c <= whole)
        foot[count++] = vec_add(a, vec_add(vec_scale(ab, at_b / whole), vec_scale(ac, at_c / whole)));
    vec best = foot[0];
    for (int i = 1; i < count; i++) {
        const vec d = vec_sub(foot[i], p), e = vec_sub(best, p);
        if (vec_dot(d, d) < vec_dot(e, e)) best = foot[i];
    }
    return best;
}
