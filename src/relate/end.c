/* Ends of curves by arc length, and how two of them differ. */
#include "relate/end.h"
#include <batten/blend.h>

bat_curve_end bat_curve_end_of(vec at, vec d1, vec d2, vec d3) {
    bat_curve_end end = {.at = at, .tangent = vec_unit(d1), .known = 3};
    const double speed = vec_norm(d1);
    /* by a parameter in which the speed is 1 */
    const vec second = vec_scale(vec_scale(d2, 1 / speed), 1 / speed);
    const vec third = vec_scale(vec_scale(vec_scale(d3, 1 / speed), 1 / speed), 1 / speed);
    end.bend = vec_reject(second, end.tangent);
    const vec rest = vec_sub(third, vec_scale(end.bend, 3 * vec_dot(second, end.tangent)));
    end.rate = vec_sub(vec_reject(rest, end.tangent), vec_scale(end.tangent, vec_dot(end.bend, end.bend)));
    return end;
}

/* The limit of the tangent where the speed vanishes: the first derivative that does not; towards an end even ones count
 * backwards. */
static bat_curve_end still(vec at, const vec d[BAT_DEGREE_MAX], bool last) {
    bat_curve_end end = {.at = at};
    for (int i = 1; i < BAT_DEGREE_MAX && !end.known; i++) {
        end.tangent = vec_scale(vec_unit(d[i]), last && i % 2 ? -1 : 1);
        end.known = vec_norm(d[i]) > 0;
    }
    return end;
}

bat_curve_end bat_curve_end_at(const bat_curve *curve, bool last, bool turned) {
    double domain[2], all[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
    const int size = bat_curve_dimension(curve);
    vec d[BAT_DEGREE_MAX];
    bat_curve_domain(curve, domain);
    bat_curve_eval(curve, domain[last], BAT_DEGREE_MAX, all);
    for (int i = 0; i < BAT_DEGREE_MAX; i++) d[i] = vec_load(all + (i + 1) * size, size);
    const vec at = vec_load(all, size);
    bat_curve_end end = vec_norm(d[0]) > 0 ? bat_curve_end_of(at, d[0], d[1], d[2]) : still(at, d, last);
    if (turned) end.tangent = vec_scale(end.tangent, -1), end.rate = vec_scale(end.rate, -1);
    return end;
}

void bat_curve_end_derive(const bat_curve_end *end, const double s[3], vec d[3]) {
    d[0] = vec_scale(end->tangent, s[0]);
    d[1] = vec_add(vec_scale(end->bend, s[0] * s[0]), vec_scale(end->tangent, s[1]));
    d[2] = vec_add(vec_add(vec_scale(end->rate, s[0] * s[0] * s[0]), vec_scale(end->bend, 3 * s[0] * s[1])),
                   vec_scale(end->tangent, s[2]));
}

bool bat_curve_end_is_tension(double factor) { return factor >= 1 / 1e3 && factor <= 1e3; }

bat_status bat_ends_check(const bat_curve *a, const bat_curve *b) {
    if (!a || !b || bat_curve_is_closed(a) || bat_curve_is_closed(b)) return BAT_ARGUMENT;
    return bat_curve_dimension(a) == bat_curve_dimension(b) ? BAT_OK : BAT_DIMENSION;
}

bat_status bat_curve_jump(const bat_curve *a, bool a_end, const bat_curve *b, bool b_end, double jump[4]) {
    const bat_status status = bat_ends_check(a, b);
    if (status != BAT_OK || !jump) return status != BAT_OK ? status : BAT_ARGUMENT;
    const bat_curve_end from = bat_curve_end_at(a, a_end, !a_end), to = bat_curve_end_at(b, b_end, b_end);
    const int known = from.known < to.known ? from.known : to.known;
    jump[0] = vec_norm(vec_sub(from.at, to.at));
    jump[1] = known < 1 ? (double)INFINITY : vec_angle(from.tangent, to.tangent);
    jump[2] = known < 2 ? (double)INFINITY : vec_norm(vec_sub(from.bend, to.bend));
    jump[3] = known < 2
                  ? (double)INFINITY
                  : vec_norm(vec_sub(vec_reject(from.rate, from.tangent), vec_reject(to.rate, to.tangent)));
    return BAT_OK;
}
