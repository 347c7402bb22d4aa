#include "editor/view/curve_ground.h"
#include "base/vec.h"

enum { SAMPLES = 33 };
static const double SLANTED = 0.25881904510252076; /* sine of 15 degrees */
static const double FLAT = 1e-6; /* of the size: what is this close to a plane or a line lies in it */

typedef struct spread {
    vec at, across, normal; /* a point; unit: the longest way from it, the normal of the plane; 0: none */
    double size;
    bool planar;
} spread;

static vec point(const bat_curve *curve, int i) {
    const int dimension = bat_curve_dimension(curve);
    return vec_load(bat_curve_points(curve) + i * dimension, dimension);
}

/* The plane through the first point, the one farthest from it, and the one farthest from the line of both. */
static spread measure(const bat_curve *curve) {
    spread s = {.at = point(curve, 0)};
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
    s.normal = most > FLAT * s.size ? vec_unit(s.normal) : (vec){0, 0, 0};
    s.planar = most > FLAT * s.size;
    for (int i = 1; i < count && s.planar; i++)
        s.planar = fabs(vec_dot(vec_sub(point(curve, i), s.at), s.normal)) <= FLAT * s.size;
    return s;
}

static bool straight(const spread *s) { return !(vec_norm(s->normal) > 0); }

static bat_ground plane_of(const spread *s) {
    double origin[3], x[3], y[3];
    vec_store(s->at, origin);
    vec_store(s->across, x);
    vec_store(vec_unit(vec_cross(s->normal, s->across)), y);
    return bat_ground_plane(origin, x, y);
}

bool bat_curve_normal(const bat_curve *curve, double normal[3]) {
    const spread s = measure(curve);
    vec_store(straight(&s) ? vec_any_normal(s.across) : s.normal, normal);
    return s.planar;
}

bool bat_ground_of_planar(const bat_curve *curve, bat_ground *out) {
    const spread s = measure(curve);
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
static bool holds(const bat_ground *plane, const spread *s) {
    double x[3], y[3];
    if (plane->type->numbers != BAT_GROUND_NUMBERS) return false;
    bat_ground_axes(plane, x, y);
    const vec n = vec_cross(vec_load(x, 3), vec_load(y, 3)),
              from = vec_sub(s->at, vec_load(plane->numbers, 3));
    return fabs(vec_dot(n, from)) <= FLAT * s->size && fabs(vec_dot(n, s->across)) <= FLAT;
}

bat_ground bat_ground_of_curve(const bat_stage *stage, bat_id object, int index, const bat_curve *curve) {
    const spread s = measure(curve);
    const vec gaze = gaze_at(stage, s.at);
    double along[3];
    if (s.planar && fabs(vec_dot(s.normal, gaze)) >= SLANTED) return plane_of(&s);
    if (straight(&s) && holds(&stage->ground, &s)) return stage->ground;
    vec d = s.normal;
    if (straight(&s) || edge_on(stage, curve, d)) d = vec_cross(gaze, s.across);
    d = vec_norm(d) > FLAT ? vec_unit(d) : vec_any_normal(gaze);
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
