#include "editor/view/curve_ground.h"
#include "base/vec.h"
#include "form/recipe/flat.h"

enum { SAMPLES = 33 };
static const double SLANTED = 0.25881904510252076; /* sine of 15 degrees */
static bat_ground plane_of(const bat_flat *s) {
    double origin[3], x[3], y[3];
    vec_store(s->at, origin);
    vec_store(s->across, x);
    vec_store(vec_unit(vec_cross(s->normal, s->across)), y);
    return bat_ground_plane(origin, x, y);
}

bool bat_curve_normal(const bat_curve *curve, double normal[3]) {
    const bat_flat s = bat_curve_flat(curve);
    vec_store(bat_flat_is_straight(&s) ? vec_any_normal(s.across) : s.normal, normal);
    return s.planar;
}

bool bat_ground_of_planar(const bat_curve *curve, bat_ground *out) {
    const bat_flat s = bat_curve_flat(curve);
    if (s.planar) *out = plane_of(&s);
    return s.planar;
}

static vec gaze_at(const bat_stage *stage, vec at) {
    double point[3], along[3];
    vec_store(at, point);
    bat_view_towards(&stage->view, point, along);
    return vec_load(along, 3);
}

/* Whether the ruled surface is seen at less than 15 degrees along half of the curve. */
static bool edge_on(const bat_stage *stage, const bat_curve *curve, vec along) {
    double domain[2], jet[2 * BAT_DIMENSION_MAX];
    const int dimension = bat_curve_dimension(curve);
    int slanted = 0;
    bat_curve_domain(curve, domain);
    for (int i = 0; i < SAMPLES; i++) {
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * (i + 0.5) / SAMPLES, 1, jet);
        const vec across = vec_cross(along, gaze_at(stage, vec_load(jet, dimension)));
        slanted += !(fabs(vec_dot(vec_unit(vec_load(jet + dimension, dimension)), across)) >= SLANTED);
    }
    return 2 * slanted > SAMPLES;
}

/* Whether the line lies in the ground, which is a plane. */
static bool holds(const bat_ground *plane, const bat_flat *s) {
    double x[3], y[3];
    if (plane->type->numbers != BAT_GROUND_NUMBERS) return false;
    bat_ground_axes(plane, x, y);
    const vec n = vec_cross(vec_load(x, 3), vec_load(y, 3)),
              from = vec_sub(s->at, vec_load(plane->numbers, 3));
    return fabs(vec_dot(n, from)) <= BAT_FLAT_SHARE * s->size &&
           fabs(vec_dot(n, s->across)) <= BAT_FLAT_SHARE;
}

bat_ground bat_ground_of_curve(const bat_stage *stage, bat_id object, int index, const bat_curve *curve) {
    const bat_flat s = bat_curve_flat(curve);
    const vec gaze = gaze_at(stage, s.at);
    double along[3];
    if (s.planar && fabs(vec_dot(s.normal, gaze)) >= SLANTED) return plane_of(&s);
    if (bat_flat_is_straight(&s) && holds(&stage->ground, &s)) return stage->ground;
    vec d = s.normal;
    if (bat_flat_is_straight(&s) || edge_on(stage, curve, d)) d = vec_cross(gaze, s.across);
    d = vec_norm(d) > BAT_FLAT_SHARE ? vec_unit(d) : vec_any_normal(gaze);
    vec_store(d, along);
    return bat_ground_ruled(object, index, along);
}

void bat_ruled_outline(const bat_curve *curve, const double along[3], double tall, double *points) {
    const int dimension = bat_curve_dimension(curve);
    double domain[2], at[BAT_DIMENSION_MAX];
    bat_curve_domain(curve, domain);
    for (int i = 0; i < BAT_RULED_POINTS; i++) {
        const double u = domain[0] + (domain[1] - domain[0]) * i / (BAT_RULED_POINTS - 1);
        bat_curve_eval(curve, u, 0, at);
        double *here = points + 3 * i, *there = points + 3 * (2 * BAT_RULED_POINTS - 1 - i);
        for (int k = 0; k < 3; k++) {
            const double on = k < dimension ? at[k] : 0;
            here[k] = on + tall * along[k];
            there[k] = on - tall * along[k];
        }
    }
}
