/* Casts a stroke into space (docs/math/surfaces.md): the ray of each sample against the plane, the ruled surface or
 * the surface that it shall lie on. */
#include "curve/curve.h"
#include "curve/roots.h"
#include "form/surface/surface.h"
#include "form/view/cast.h"
#include "form/view/view.h"
#include <batten/bezier.h>

#include <stdlib.h>

static const double edge_on = 0.0871557427476581736; /* sine of 5 degrees */
static const double equally_far =
    1e-6; /* of the size: places so equally far from the line are told apart by the eye */
static const double far_out = 4; /* times the curve's size */

typedef struct bat_caster {
    const bat_surface *surface; /* borrowed */
    bat_surface_finder *finder; /* of a surface */
    vec origin, direction;      /* unit: a plane's normal, or the direction in which a curve is ruled */
    bat_curve *curve;           /* in space */
    vec middle;                 /* of the curve or the surface */
    double size;                /* of the curve or the surface */
    double *bezier, *breaks;
    int pieces;
    double domain[2], s;  /* s: NaN before the first sample has landed */
    bool failed;          /* an allocation failed */
    bat_cast_point **all; /* where all places are wanted: the list, borrowed */
    size_t *room, count;
} casting;

/* ---- a plane ---- */

static void on_plane(casting *c, const bat_sight *ray, bat_cast_point *out) {
    const double towards = vec_dot(ray->along, c->direction);
    out->fate = BAT_CAST_EDGE_ON;
    if (!(fabs(towards) >= edge_on)) return;
    out->distance = vec_dot(vec_sub(c->origin, ray->from), c->direction) / towards;
    out->fate = out->distance < 0 ? BAT_CAST_BEHIND : BAT_CAST_LANDED;
    vec_store(vec_add(ray->from, vec_scale(ray->along, out->distance)), out->point);
}

/* ---- the ruled surface of a curve ---- */

static double from_last(const casting *c, double s) {
    const double d = fabs(s - c->s), period = c->domain[1] - c->domain[0];
    return c->curve->closed ? fmin(d, period - d) : d;
}

/* Whether a place is to be preferred to the best one so far; best->distance is NaN when there is none. */
static bool is_better(const casting *c, const bat_cast_point *place, const bat_cast_point *best) {
    if (best->fate != BAT_CAST_LANDED) return true;
    if (isnan(c->s)) {
        const double less = fabs(best->own[1]) - fabs(place->own[1]);
        return fabs(less) > equally_far * c->size ? less > 0 : place->distance < best->distance;
    }
    return from_last(c, place->own[0]) < from_last(c, best->own[0]);
}

/* The place of the ray on the ruled surface at s; false: s is no place (the curve jumps there). */
static bool place_at(const casting *c, const bat_sight *ray, double s, bat_cast_point *out) {
    double jet[6];
    bat_curve_eval(c->curve, s, 1, jet);
    const vec on = vec_load(jet, 3), d = c->direction, r = ray->along, way = vec_sub(on, ray->from);
    const double slope = vec_dot(d, r), across = 1 - slope * slope;
    const double sine = fabs(vec_dot(vec_unit(vec_load(jet + 3, 3)), vec_cross(d, r)));
    *out = (bat_cast_point){.fate = BAT_CAST_EDGE_ON, .own = {s, 0}};
    if (!(sine >= edge_on)) return true;
    /* h d - t r = -way, by least squares */
    out->own[1] = (slope * vec_dot(r, way) - vec_dot(d, way)) / across;
    out->distance = (vec_dot(r, way) - slope * vec_dot(d, way)) / across;
    const vec at = vec_add(on, vec_scale(d, out->own[1]));
    const vec seen = vec_add(ray->from, vec_scale(r, out->distance));
    if (vec_norm(vec_sub(at, seen)) > 1e-6 * c->size + 1e-12 * vec_norm(way)) return false;
    vec_store(at, out->point);
    out->fate = out->distance < 0                       ? BAT_CAST_BEHIND
                : fabs(out->own[1]) > far_out * c->size ? BAT_CAST_FAR
                                                        : BAT_CAST_LANDED;
    return true;
}

static void collect(casting *c, const bat_cast_point *place) {
    if (c->count == *c->room) {
        const size_t room = *c->room ? 2 * *c->room : 64;
        bat_cast_point *list = realloc(*c->all, room * sizeof *list);
        c->failed |= !list;
        if (!list) return;
        *c->all = list, *c->room = room;
    }
    (*c->all)[c->count++] = *place;
}

static void consider(casting *c, const bat_sight *ray, double s, bat_cast_point *best) {
    bat_cast_point place;
    if (!place_at(c, ray, s, &place)) return;
    if (c->all && place.fate == BAT_CAST_LANDED) collect(c, &place);
    const bool lands = place.fate == BAT_CAST_LANDED;
    if (lands ? is_better(c, &place, best) : best->fate != BAT_CAST_LANDED && place.fate < best->fate)
        *best = place;
}

/* The ends of an open curve, whose sign rounding decides. */
static void consider_ends(casting *c, const bat_sight *ray, vec across, bat_cast_point *best) {
    for (int k = 0; k < 2; k++) {
        double at[3];
        bat_curve_eval(c->curve, c->domain[k], 0, at);
        const vec way = vec_sub(vec_load(at, 3), ray->from);
        if (fabs(vec_dot(way, across)) <= (1e-10 * c->size + 1e-15 * vec_norm(way)) * vec_norm(across))
            consider(c, ray, c->domain[k], best);
    }
}

/* The places are the zeros of (C(s) - from) . (d x r), found in Bernstein form on each piece. */
static void on_ruled(casting *c, const bat_sight *ray, bat_cast_point *out) {
    const vec across = vec_cross(c->direction, ray->along);
    const int p = c->curve->degree;
    bat_signs signs = {0};
    const bool along = !(vec_norm(across) >= edge_on);
    /* worse than every fate of a place, so that the first place takes over */
    bat_cast_point best = {.fate = (bat_cast_fate)(BAT_CAST_FAR + 1)};
    for (int k = 0; k < c->pieces && !along; k++) {
        double g[BAT_DEGREE_MAX + 1], x[BAT_DEGREE_MAX + 1], reach = 0;
        for (int i = 0; i <= p; i++) {
            const vec way = vec_sub(vec_load(c->bezier + 3 * (k * (p + 1) + i), 3), ray->from);
            g[i] = vec_dot(way, across), reach = fmax(reach, vec_norm(way));
        }
        const int count = bat_bernstein_crossings(p, g, 1e-15 * reach, &signs, x);
        for (int i = 0; i < count; i++)
            consider(c, ray, c->breaks[k] + x[i] * (c->breaks[k + 1] - c->breaks[k]), &best);
    }
    if (!along && !c->curve->closed) consider_ends(c, ray, across, &best);
    if (c->curve->closed && signs.opening && signs.before == -signs.opening)
        consider(c, ray, c->domain[0], &best);
    if (best.fate > BAT_CAST_FAR) best.fate = along ? BAT_CAST_EDGE_ON : BAT_CAST_MISSED;
    if (best.fate == BAT_CAST_LANDED) c->s = best.own[0];
    *out = best;
}

/* ---- a surface ---- */

static void on_surface(casting *c, const bat_sight *ray, bat_cast_point *out) {
    bat_surface_point hit;
    double from[3], along[3], normal[3];
    size_t count = 0;
    vec_store(ray->from, from);
    vec_store(ray->along, along);
    out->fate = BAT_CAST_MISSED;
    c->failed |= bat_surface_finder_hits(c->finder, from, along, 1, &hit, &count) != BAT_OK;
    if (c->failed) return;
    if (count == 0) {
        for (int k = 0; k < 3; k++) along[k] = -along[k];
        c->failed |= bat_surface_finder_hits(c->finder, from, along, 1, &hit, &count) != BAT_OK;
        if (!c->failed && count > 0) out->fate = BAT_CAST_BEHIND;
        return;
    }
    const bool smooth = bat_surface_normal(c->surface, hit.u, hit.v, normal) == BAT_OK;
    if (smooth && !(fabs(vec_dot(vec_load(normal, 3), ray->along)) >= edge_on)) {
        out->fate = BAT_CAST_EDGE_ON;
        return;
    }
    *out = (bat_cast_point){.own = {hit.u, hit.v}, .distance = hit.distance};
    for (int k = 0; k < 3; k++) out->point[k] = hit.point[k];
}

/* ---- the stroke ---- */

/* The middle and the size of what n points span. */
static void measure(casting *c, size_t n, const double *points) {
    vec low = vec_load(points, 3), high = low;
    for (size_t i = 1; i < n; i++) {
        const vec p = vec_load(points + 3 * i, 3);
        low = (vec){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (vec){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    c->middle = vec_scale(vec_add(low, high), 0.5);
    c->size = vec_norm(vec_sub(high, low));
}

static bat_status prepare_surface(const bat_surface *surface, casting *out) {
    out->surface = surface;
    measure(out, (size_t)surface->axis[0].spread * (size_t)surface->axis[1].spread, surface->points);
    return bat_surface_finder_create(surface, &out->finder);
}

static bat_status prepare(const bat_canvas *canvas, casting *out) {
    *out = (casting){.s = NAN};
    if (canvas->surface && !canvas->curve) return prepare_surface(canvas->surface, out);
    const double *way = canvas->curve ? canvas->along : canvas->normal;
    if (!bat_are_coordinates(way, 3) || (!canvas->curve && !bat_are_coordinates(canvas->origin, 3)))
        return BAT_NUMBER;
    out->direction = vec_unit(vec_load(way, 3));
    if (!(vec_norm(out->direction) > 0)) return BAT_ARGUMENT;
    out->origin = vec_load(canvas->origin, 3);
    if (!canvas->curve) return BAT_OK;
    bat_status status = bat_curve_to_dimension(canvas->curve, 3, &out->curve);
    if (status != BAT_OK) return status;
    measure(out, bat_curve_count(out->curve), bat_curve_points(out->curve));
    out->size = bat_curve_size(out->curve);
    bat_curve_domain(out->curve, out->domain);
    out->pieces = bat_curve_segment_count(out->curve);
    const size_t points = (size_t)out->pieces * (size_t)(out->curve->degree + 1) * 3;
    out->bezier = malloc((points + (size_t)out->pieces + 1) * sizeof *out->bezier);
    if (!out->bezier) return BAT_MEMORY;
    out->breaks = out->bezier + points;
    return bat_curve_to_bezier(out->curve, out->bezier, out->breaks);
}

static void release(casting *c) {
    bat_surface_finder_free(c->finder);
    free(c->bezier);
    bat_curve_free(c->curve);
}

static void cast(casting *c, const bat_sight *ray, bat_cast_point *out) {
    *out = (bat_cast_point){.fate = BAT_CAST_MISSED};
    if (c->curve)
        on_ruled(c, ray, out);
    else if (c->surface)
        on_surface(c, ray, out);
    else
        on_plane(c, ray, out);
}

bat_status bat_cast(const bat_viewpoint *view, const bat_stroke *stroke, const bat_canvas *canvas,
                    bat_cast_point *out, size_t *landed) {
    if (!stroke || !canvas || (stroke->count > 0 && !out)) return BAT_ARGUMENT;
    bat_gaze gaze;
    bat_status status = bat_gaze_through(view, stroke, &gaze);
    if (status != BAT_OK) return status;
    casting c;
    status = prepare(canvas, &c);
    size_t kept = 0;
    for (size_t i = 0; i < stroke->count && status == BAT_OK; i++) {
        const bat_sight ray = bat_gaze_ray(&gaze, stroke->points + 2 * i);
        cast(&c, &ray, &out[i]);
        kept += out[i].fate == BAT_CAST_LANDED;
        if (c.failed) status = BAT_MEMORY;
    }
    release(&c);
    if (status == BAT_OK && landed) *landed = kept;
    return status;
}

/* ---- one ray at a time ---- */

bat_status bat_caster_create(const bat_canvas *canvas, bat_caster **out) {
    casting *c = malloc(sizeof *c);
    bat_status status = c ? prepare(canvas, c) : BAT_MEMORY;
    if (status == BAT_OK)
        *out = c;
    else
        bat_caster_free(c);
    return status;
}

void bat_caster_free(bat_caster *caster) {
    if (!caster) return;
    release(caster);
    free(caster);
}

/* The line as a ray that starts before all that can be met. */
static bat_sight ray_of(const bat_caster *caster, const double from[3], const double along[3]) {
    bat_sight ray = {vec_load(from, 3), vec_load(along, 3)};
    const double ahead = vec_dot(vec_sub(caster->middle, ray.from), ray.along);
    ray.from = vec_add(ray.from, vec_scale(ray.along, ahead - (2 + far_out) * caster->size));
    return ray;
}

bat_status bat_caster_places(bat_caster *caster, const double from[3], const double along[3],
                             bat_cast_point **list, size_t *room, size_t *count) {
    bat_cast_point best;
    const bat_sight ray = ray_of(caster, from, along);
    caster->all = list, caster->room = room, caster->count = 0;
    caster->failed = false;
    on_ruled(caster, &ray, &best);
    caster->all = NULL;
    *count = caster->count;
    return caster->failed ? BAT_MEMORY : BAT_OK;
}

bat_status bat_caster_line(bat_caster *caster, const double from[3], const double along[3], double last,
                           bat_cast_point *out) {
    const bat_sight ray = ray_of(caster, from, along);
    caster->s = last;
    caster->failed = false;
    cast(caster, &ray, out);
    return caster->failed ? BAT_MEMORY : BAT_OK;
}

void bat_canvas_clear(bat_canvas *canvas) {
    if (!canvas) return;
    bat_curve_free(canvas->curve);
    bat_surface_free(canvas->surface);
    *canvas = (bat_canvas){.curve = NULL};
}
