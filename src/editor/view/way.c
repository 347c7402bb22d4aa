#include "editor/view/way.h"
#include "base/vec.h"
#include "editor/view/curve_ground.h"

enum { SAMPLES = 64 };
static const double SLANTED = 0.25881904510252076;   /* sine of 15 degrees */
static const double EDGE_ON = 0.0871557427476581736; /* sine of 5 degrees */

/* Along the plane with this normal, as far as is seen. */
static bool across(vec seen, vec gaze, vec normal, double way[3]) {
    const double slant = vec_dot(gaze, normal);
    if (!(fabs(slant) >= EDGE_ON)) return false;
    vec_store(vec_sub(seen, vec_scale(gaze, vec_dot(seen, normal) / slant)), way);
    return true;
}

/* Along the normal, as far as it is seen to go the same way. */
static bool along(vec seen, vec gaze, vec normal, double way[3]) {
    const vec shown = vec_reject(normal, gaze);
    const double square = vec_dot(shown, shown);
    if (!(square >= EDGE_ON * EDGE_ON)) return false;
    vec_store(vec_scale(normal, vec_dot(seen, shown) / square), way);
    return true;
}

/* In perspective: how deep the curve lies where it is seen nearest to a pixel, in distances of the pivot, and the gaze
 * there; else 1. */
static double depth_near(const bat_stage *stage, const bat_curve *curve, const double pixel[2], vec *gaze) {
    double map[BAT_MAP_NUMBERS], domain[2], place[BAT_DIMENSION_MAX] = {0}, at[2], seen[2], along[3];
    double best = INFINITY, depth = 1;
    if (!bat_stage_deep(stage)) return 1;
    bat_stage_space_map(stage, map);
    bat_stage_seen(stage, pixel, seen);
    bat_curve_domain(curve, domain);
    for (int i = 0; i <= SAMPLES; i++) {
        place[2] = 0;
        bat_curve_eval(curve, domain[0] + (domain[1] - domain[0]) * i / SAMPLES, 0, place);
        if (!bat_map_look(map, bat_curve_dimension(curve), place, at)) continue;
        const double x = at[0] - seen[0], y = at[1] - seen[1], far = x * x + y * y;
        if (!(far < best)) continue;
        best = far;
        depth = bat_map_depth(map, bat_curve_dimension(curve), place);
        bat_view_towards(&stage->view, place, along);
        *gaze = vec_load(along, 3);
    }
    return depth;
}

bool bat_stage_way(const bat_stage *stage, const bat_curve *curve, const double from[2], const double to[2],
                   bool rise, double way[3]) {
    double right[3], down[3], ahead[3], a[2], b[2];
    vec normal = {0, 0, 1};
    way[2] = 0;
    if (bat_curve_dimension(curve) == 2 && !bat_stage_tilted(stage) && !rise) {
        bat_stage_seen(stage, from, a);
        bat_stage_seen(stage, to, b);
        for (int k = 0; k < 2; k++) way[k] = b[k] - a[k];
        return true;
    }
    bat_view_axes(&stage->view, right, down, ahead);
    vec gaze = vec_load(ahead, 3);
    const double pixel = bat_stage_pixel(stage) * depth_near(stage, curve, from, &gaze);
    const vec seen = vec_add(vec_scale(vec_load(right, 3), (to[0] - from[0]) * pixel),
                             vec_scale(vec_load(down, 3), (to[1] - from[1]) * pixel));
    if (bat_curve_dimension(curve) == 2) return !rise && across(seen, gaze, normal, way);
    double best[3];
    const bool planar = bat_curve_normal(curve, best);
    normal = vec_load(best, 3);
    if (rise) return along(seen, gaze, normal, way);
    return across(seen, gaze, planar && fabs(vec_dot(normal, gaze)) >= SLANTED ? normal : gaze, way);
}

/* Where the ray through a pixel meets the plane through a point; false: seen from its edge, or behind the eye. */
static bool on_plane(const bat_stage *stage, const double pixel[2], vec at, vec normal, vec *out) {
    const bat_ray ray = bat_view_ray(&stage->view, pixel);
    const vec from = vec_load(ray.from, 3), gaze = vec_load(ray.along, 3);
    const double slant = vec_dot(gaze, normal);
    if (!(fabs(slant) >= EDGE_ON)) return false;
    const double far = vec_dot(vec_sub(at, from), normal) / slant;
    *out = vec_add(from, vec_scale(gaze, far));
    return !bat_stage_deep(stage) || far > 0;
}

/* Where the ray through a pixel comes nearest to the line through a point along its normal. */
static bool on_line(const bat_stage *stage, const double pixel[2], vec at, vec normal, vec *out) {
    const bat_ray ray = bat_view_ray(&stage->view, pixel);
    const vec from = vec_load(ray.from, 3), gaze = vec_load(ray.along, 3);
    const vec shown = vec_reject(normal, gaze);
    const double square = vec_dot(shown, shown);
    if (!(square >= EDGE_ON * EDGE_ON)) return false;
    *out = vec_add(at, vec_scale(normal, vec_dot(vec_sub(from, at), shown) / square));
    return true;
}

bool bat_stage_way_in(const bat_stage *stage, int dimension, const double normal[3], const double place[3],
                      const double from[2], const double to[2], bool rise, double way[3]) {
    double a[2], b[2], right[3], down[3], ahead[3];
    way[2] = 0;
    if (dimension == 2 && rise) return false;
    if (dimension == 2 && !bat_stage_tilted(stage)) {
        bat_stage_seen(stage, from, a);
        bat_stage_seen(stage, to, b);
        for (int k = 0; k < 2; k++) way[k] = b[k] - a[k];
        return true;
    }
    const vec at = vec_load(place, dimension);
    vec plane = dimension == 2 ? (vec){0, 0, 1} : vec_load(normal, 3), start, end;
    bat_view_towards(&stage->view, place, ahead);
    if (dimension == 3 && !rise && !(fabs(vec_dot(plane, vec_load(ahead, 3))) >= SLANTED)) {
        bat_view_axes(&stage->view, right, down, ahead);
        plane = vec_load(ahead, 3);
    }
    bool (*const meet)(const bat_stage *, const double *, vec, vec, vec *) = rise ? on_line : on_plane;
    if (!meet(stage, from, at, plane, &start) || !meet(stage, to, at, plane, &end)) return false;
    vec_store(vec_sub(end, start), way);
    if (dimension == 2) way[2] = 0;
    return true;
}

bool bat_stage_aim(const bat_stage *stage, int dimension, const double normal[3], const double *at,
                   const double pixel[2], double way[3]) {
    double seen[2], from[2], place[3] = {0};
    if (!bat_stage_look(stage, dimension, at, seen)) return false;
    if (dimension == 2 && !bat_stage_tilted(stage)) {
        bat_stage_seen(stage, pixel, way);
        for (int k = 0; k < 2; k++) way[k] -= seen[k];
        way[2] = 0;
        return true;
    }
    for (int k = 0; k < dimension; k++) place[k] = at[k];
    bat_stage_project(stage, seen, from);
    return bat_stage_way_in(stage, dimension, normal, place, from, pixel, false, way);
}

void bat_stage_turn_away(const bat_stage *stage, double normal[3]) {
    double right[3], down[3], ahead[3];
    bat_view_axes(&stage->view, right, down, ahead);
    const double towards = vec_dot3(normal, ahead);
    const bool none = !(vec_dot3(normal, normal) > 0);
    for (int k = 0; k < 3; k++) normal[k] = none ? ahead[k] : towards < 0 ? -normal[k] : normal[k];
}
