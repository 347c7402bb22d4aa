#include "form/recipe/flat.h"

static vec point(const bat_curve *curve, int i) {
    const int dimension = bat_curve_dimension(curve);
    return vec_load(bat_curve_points(curve) + i * dimension, dimension);
}

bat_flat bat_curve_flat(const bat_curve *curve) {
    bat_flat s = {.at = point(curve, 0)};
    const int count = (int)bat_curve_count(curve);
    double most = 0;
    for (int i = 1; i < count; i++) {
        const vec way = vec_sub(point(curve, i), s.at);
        if (vec_norm(way) > s.size) s.size = vec_norm(way), s.across = way;
    }
    s.across = vec_unit(s.across);
    for (int i = 1; i < count; i++) {
        const vec beside = vec_reject(vec_sub(point(curve, i), s.at), s.across);
        if (vec_norm(beside) > most) most = vec_norm(beside), s.normal = vec_cross(s.across, beside);
    }
    s.normal = most > BAT_FLAT_SHARE * s.size ? vec_unit(s.normal) : (vec){0, 0, 0};
    s.planar = most > BAT_FLAT_SHARE * s.size;
    for (int i = 1; i < count && s.planar; i++)
        s.planar = fabs(vec_dot(vec_sub(point(curve, i), s.at), s.normal)) <= BAT_FLAT_SHARE * s.size;
    return s;
}
