/* Sweeps of curves as they were drawn: the profile's plane is found, and set across the path. */
#include "base/vec.h"
#include "curve/curve.h"
#include "form/recipe/flat.h"
#include "form/recipe/recipe.h"
#include "form/sweep/sweep.h"

#include <batten/measure.h>
#include <batten/refine.h>
#include <string.h>

enum { EACH = 64, LEAST = 4096 }; /* rows of the surface, at most: for each point of the path, and besides */
static const double fineness = 1e-4; /* of the curves' size: how far the surface is off at most */
static const double stands =
    0.5; /* cosine of the angle between the profile's normal and the path that is across it */
static const double near_plane = 0.01; /* of the profile's size: the path starts in its plane */

/* The plane of a profile: x and y span it, n is its normal. */
typedef struct plane {
    vec at, x, y, n;
} plane;

static vec start_of(const bat_curve *path, int end, vec *tangent) {
    double domain[2], jet[2 * BAT_DIMENSION_MAX];
    const int dimension = bat_curve_dimension(path);
    bat_curve_domain(path, domain);
    bat_curve_eval(path, domain[end], 1, jet);
    *tangent = vec_unit(vec_load(jet + dimension, dimension));
    return vec_load(jet, dimension);
}

/* x is the axis of the world that is least along the normal, so that the shape of the profile has no say in it. */
static plane plane_with(vec at, vec n) {
    const double most = fmax(fmax(fabs(n.x), fabs(n.y)), fabs(n.z));
    const double main = fabs(n.z) == most ? n.z : fabs(n.y) == most ? n.y : n.x;
    if (main < 0) n = vec_scale(n, -1);
    const vec x = vec_any_normal(n);
    return (plane){at, x, vec_cross(n, x), n};
}

/* A straight profile lies in many planes: the one most across the path's start is taken. */
static bat_status plane_of(const bat_curve *profile, vec tangent, plane *out) {
    const bat_flat flat = bat_curve_flat(profile);
    if (bat_curve_dimension(profile) == 2)
        *out = plane_with(flat.at, (vec){0, 0, 1});
    else if (flat.planar)
        *out = plane_with(flat.at, flat.normal);
    else if (bat_flat_is_straight(&flat)) {
        const vec across = vec_reject(tangent, flat.across);
        *out = plane_with(flat.at,
                          vec_norm(across) > BAT_FLAT_SHARE ? vec_unit(across) : vec_any_normal(flat.across));
    } else
        return BAT_UNSUPPORTED;
    return BAT_OK;
}

/* The profile's control points in its plane, with its origin at `from` or in the middle of the profile. */
static bat_status flatten(const bat_curve *profile, const plane *p, const vec *from, bat_curve **out) {
    const int dimension = bat_curve_dimension(profile);
    bat_curve *flat = NULL;
    double low[2], high[2];
    bat_status status = bat_curve_allocate(profile->degree, 2, profile->closed, profile->count, &flat);
    if (status != BAT_OK) return status;
    memcpy(bat_curve_own_knots(flat), bat_curve_knots(profile),
           (size_t)bat_curve_knot_count(profile) * sizeof(double));
    for (int i = 0; i < profile->count; i++) {
        const vec q = vec_sub(vec_load(bat_curve_points(profile) + i * dimension, dimension), p->at);
        double *to = bat_curve_own_points(flat) + 2 * i;
        to[0] = vec_dot(q, p->x), to[1] = vec_dot(q, p->y);
    }
    status = bat_curve_finish(flat, &flat);
    if (status != BAT_OK) return status;
    bat_curve_bounds(flat, low, high);
    double x = low[0] / 2 + high[0] / 2, y = low[1] / 2 + high[1] / 2;
    if (from) x = vec_dot(vec_sub(*from, p->at), p->x), y = vec_dot(vec_sub(*from, p->at), p->y);
    status = bat_curve_transform(flat, (double[]){1, 0, -x, 0, 1, -y}, out);
    bat_curve_free(flat);
    return status;
}

/* The least rotation that takes the unit a to the unit b, which is not opposite, applied to v. */
static vec turn(vec a, vec b, vec v) {
    const vec axis = vec_cross(a, b);
    const double along = vec_dot(axis, v) / (1 + vec_dot(a, b));
    return vec_add(vec_scale(v, vec_dot(a, b)), vec_add(vec_cross(axis, v), vec_scale(axis, along)));
}

/* The profile's plane at the path's start, seen along the path; *first: where its x goes. */
static vec stand(plane *p, bat_recipe_stand way, vec tangent) {
    if (way == BAT_STAND_LYING) {
        const vec across = vec_cross(p->n, tangent);
        return vec_norm(across) > BAT_FLAT_SHARE ? vec_unit(across) : vec_any_normal(tangent);
    }
    if (vec_dot(p->n, tangent) < 0) p->n = vec_scale(p->n, -1), p->y = vec_scale(p->y, -1);
    return turn(p->n, tangent, p->x);
}

/* How far the point is from the profile's plane, and whether it lies beside the profile. */
static bool is_beside(const bat_curve *profile, const plane *p, vec point) {
    const double size = bat_curve_size(profile);
    const vec way = vec_sub(point, p->at);
    return fabs(vec_dot(way, p->n)) <= near_plane * size && vec_norm(way) <= 2 * size;
}

bat_recipe_stand bat_recipe_stands(const bat_curve *path, const bat_curve *profile) {
    bat_recipe_stand best = BAT_STAND_LYING;
    if (!path || !profile) return best;
    for (int end = 0; end < 2; end++) {
        vec tangent;
        plane p;
        const vec at = start_of(path, end, &tangent);
        if (plane_of(profile, tangent, &p) != BAT_OK || !(fabs(vec_dot(p.n, tangent)) >= stands)) continue;
        if (is_beside(profile, &p, at)) return BAT_STAND_IN_PLACE;
        if (end == 0) best = BAT_STAND_ACROSS;
    }
    return best;
}

/* The path, begun at the end that is nearer to where the profile is. */
static bat_status begin_beside(const bat_curve *path, const bat_curve *profile, bat_curve **out) {
    vec tangent;
    const vec at = vec_load(bat_curve_points(profile), bat_curve_dimension(profile));
    const double from_start = vec_norm(vec_sub(start_of(path, 0, &tangent), at));
    const double from_end = vec_norm(vec_sub(start_of(path, 1, &tangent), at));
    return from_end < from_start * (1 - 1e-9) ? bat_curve_reverse(path, out) : bat_curve_copy(path, out);
}

/* A function that runs evenly from one value to the other; on failure nothing is left in it. */
static bat_status line(double from, double to, bat_function *out) {
    *out = bat_function_of(from);
    return from == to ? BAT_OK
                      : bat_curve_create(2, 1, false, 2, (double[]){from, 0, to, 1}, 4,
                                         (double[]){0, 0, 1, 1}, &out->curve);
}

static bat_status make(const bat_recipe *recipe, const bat_curve *path, const bat_curve *profile, vec first,
                       bat_surface **out, bat_recipe_report *report) {
    bat_sweep_options options = bat_sweep_defaults();
    bat_sweep *sweep = NULL;
    bat_status status = line(0, recipe->twist * (BAT_PI / 180), &options.twist);
    if (status == BAT_OK) status = line(1, recipe->scale, &options.scale);
    options.has_first = true;
    vec_store(first, options.first);
    if (status == BAT_OK) status = bat_sweep_create(path, profile, &options, &sweep);
    if (status == BAT_OK)
        status = bat_sweep_surface_within(sweep, fineness * (bat_curve_size(path) + bat_curve_size(profile)),
                                          bat_curve_count(path) * EACH + LEAST, out, NULL);
    if (status == BAT_OK && report) {
        status = bat_sweep_folds(sweep, BAT_RECIPE_FOLDS, report->folded, &report->folds);
        if (status != BAT_OK) bat_surface_free(*out);
    }
    bat_sweep_free(sweep);
    bat_function_clear(&options.twist), bat_function_clear(&options.scale);
    return status;
}

bat_status bat_recipe_sweep(const bat_recipe *recipe, const bat_curve *path, const bat_curve *profile,
                            bat_surface **out, bat_recipe_report *report) {
    const bool in_place = recipe->stand == BAT_STAND_IN_PLACE && !bat_curve_is_closed(path);
    bat_curve *begun = NULL, *flat = NULL;
    vec tangent;
    plane p;
    bat_status status = in_place ? begin_beside(path, profile, &begun) : bat_curve_copy(path, &begun);
    if (status != BAT_OK) return status;
    const vec at = start_of(begun, 0, &tangent);
    if (!(vec_norm(tangent) > 0)) status = BAT_SINGULAR;
    if (status == BAT_OK) status = plane_of(profile, tangent, &p);
    if (status == BAT_OK) {
        const vec first = stand(&p, recipe->stand, tangent);
        status = flatten(profile, &p, recipe->stand == BAT_STAND_IN_PLACE ? &at : NULL, &flat);
        if (status == BAT_OK) status = make(recipe, begun, flat, first, out, report);
    }
    bat_curve_free(begun), bat_curve_free(flat);
    return status;
}
