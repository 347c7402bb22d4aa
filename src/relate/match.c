/* An end of a curve moved to meet another: its derivatives there are given, and fix as many control points. */
#include "curve/curve.h"
#include "relate/end.h"
#include <batten/blend.h>
#include <batten/refine.h>

#include <math.h>
#include <string.h>

bat_status bat_curve_end_room(const bat_curve *a, int continuity, bool last, bat_curve **out) {
    const int apart = 2 * (continuity + 1);
    bat_curve *raised = NULL, *clamped = NULL;
    bat_status status = a->degree > continuity ? bat_curve_copy(a, &raised)
                                               : bat_curve_elevate(a, continuity + 1, &raised);
    if (status == BAT_OK) status = bat_curve_clamp(raised, &clamped);
    bat_curve_free(raised);
    if (status != BAT_OK || clamped->count >= apart) {
        if (status == BAT_OK) *out = clamped;
        return status;
    }
    /* evenly in the span at the end that moves */
    double knots[2 * BAT_CONTINUITY_MAX + 2];
    const int more = apart - clamped->count;
    const double from = clamped->knots[last ? clamped->count - 1 : clamped->degree];
    const double to = clamped->knots[last ? clamped->count : clamped->degree + 1];
    for (int i = 0; i < more; i++) knots[i] = from + (to - from) * (i + 1) / (more + 1);
    status = bat_curve_insert_knots(clamped, more, knots, out);
    bat_curve_free(clamped);
    return status;
}

/* The derivative of order j depends on the first j + 1 control points only. */
double bat_curve_end_put(bat_curve *curve, bool last, int continuity, const vec d[BAT_CONTINUITY_MAX + 1]) {
    double basis[(BAT_CONTINUITY_MAX + 1) * (BAT_DEGREE_MAX + 1)], moved = 0;
    const int p = curve->degree, size = curve->dimension, span = last ? curve->count - 1 : p;
    bat_basis(curve, span, curve->knots[last ? curve->count : p], continuity, basis);
    for (int j = 0; j <= continuity; j++) {
        const double *row = basis + j * (p + 1);
        vec at = d[j];
        for (int i = 0; i < j; i++) {
            const double *before = curve->points + (last ? curve->count - 1 - i : i) * size;
            at = vec_sub(at, vec_scale(vec_load(before, size), row[last ? p - i : i]));
        }
        double *point = curve->points + (last ? curve->count - 1 - j : j) * size, fresh[3];
        vec_store(vec_scale(at, 1 / row[last ? p - j : j]), fresh);
        moved = fmax(moved, bat_distance(point, fresh, size));
        memcpy(point, fresh, (size_t)size * sizeof *fresh);
    }
    return moved;
}

/* The speed of the end and its first two derivatives, as they are. Where it stands still: that of the whole curve. */
static void speeds_of(const bat_curve *curve, bool last, double s[3]) {
    double domain[2], all[4 * BAT_DIMENSION_MAX];
    const int size = curve->dimension;
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[last], 3, all);
    const vec d1 = vec_load(all + size, size), d2 = vec_load(all + 2 * size, size),
              d3 = vec_load(all + 3 * size, size), t = vec_unit(d1);
    s[0] = vec_norm(d1), s[1] = s[2] = 0;
    if (s[0] > 0) {
        const vec across = vec_scale(vec_reject(d2, t), 1 / s[0]);
        s[1] = vec_dot(d2, t);
        s[2] = vec_dot(d3, t) +
               vec_dot(across, across) * s[0]; /* C''' has -speed^3 bend^2 along the tangent */
    } else {
        s[0] = bat_curve_size(curve) / (domain[1] - domain[0]);
    }
}

bat_status bat_curve_match(const bat_curve *a, bool a_end, const bat_curve *b, bool b_end, int continuity,
                           double tension, bat_curve **out, double *moved) {
    bat_status status = bat_ends_check(a, b);
    if (status != BAT_OK) return status;
    if (!out || continuity < 0 || continuity > BAT_CONTINUITY_MAX || !bat_curve_end_is_tension(tension))
        return BAT_ARGUMENT;
    /* as a runs: on into b, or out of it */
    const bat_curve_end target = bat_curve_end_at(b, b_end, b_end == a_end);
    if (continuity > target.known) return BAT_SINGULAR;
    bat_curve *room = NULL;
    status = bat_curve_end_room(a, continuity, a_end, &room);
    if (status != BAT_OK) return status;
    double s[3];
    vec d[BAT_CONTINUITY_MAX + 1] = {target.at};
    speeds_of(room, a_end, s);
    for (int i = 0; i < 3; i++) s[i] *= tension;
    if (continuity > 0 && !(s[0] > 0)) {
        bat_curve_free(room);
        return BAT_SINGULAR;
    }
    bat_curve_end_derive(&target, s, d + 1);
    const double far = bat_curve_end_put(room, a_end, continuity, d);
    status = bat_curve_finish(room, out);
    if (status == BAT_OK && moved) *moved = far;
    return status;
}
