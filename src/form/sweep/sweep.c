/* Sweeps (multilevel-2016, section 5; docs/math/surfaces.md). */
#include "form/sweep/sweep.h"
#include "base/options.h"
#include "curve/frames_converged.h"

#include <batten/measure.h>
#include <batten/refine.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double corner = 1e-6; /* radians: a path that turns more at a knot has a corner there */

static const bat_sweep_options DEFAULTS = {
    .size = sizeof DEFAULTS, .frame = BAT_FRAMES_RMF, .scale = {1, NULL}};
enum { LEAST = sizeof DEFAULTS }; /* size in version 0.3: the first member added later begins there */

void bat_sweep_options_init(bat_sweep_options *options, size_t size) {
    bat_options_give(&DEFAULTS, sizeof DEFAULTS, size, options);
}

/* ---- making one ---- */

void bat_sweep_free(bat_sweep *sweep) {
    if (!sweep) return;
    bat_curve_free(sweep->path), bat_curve_free(sweep->profile);
    bat_frame_chain_free(sweep->chain);
    bat_function_clear(&sweep->twist), bat_function_clear(&sweep->scale);
    free(sweep);
}

static bool has_corner(const bat_curve *path) {
    const int p = path->degree;
    for (int r = 2 * p - 1; r < path->spread; r++) {
        if (path->knots[r] == path->knots[r + 1] || path->knots[r] != path->knots[r - p + 1]) continue;
        if ((path->closed || path->knots[r] > path->knots[p]) && bat_curve_corner_at(path, r, corner))
            return true;
    }
    return false;
}

static bool own_function(const bat_function *from, bat_function *to, bat_status *status) {
    *status = bat_function_check(from);
    to->constant = from->constant;
    if (*status == BAT_OK && from->curve) *status = bat_curve_copy(from->curve, &to->curve);
    return *status == BAT_OK;
}

static bat_status take_path(const bat_curve *path, bat_sweep *sweep) {
    bat_curve *space = NULL;
    bat_status status = bat_curve_to_dimension(path, 3, &space);
    if (status == BAT_OK)
        status = space->closed ? bat_curve_gather_seam(space, &sweep->path)
                               : bat_curve_clamp(space, &sweep->path);
    bat_curve_free(space);
    if (status != BAT_OK) return status;
    if (has_corner(sweep->path)) return BAT_UNSUPPORTED;
    bat_curve_domain(sweep->path, sweep->domain);
    return bat_curve_length(sweep->path, sweep->domain[0], sweep->domain[1], 1e-6) > 0 ? BAT_OK
                                                                                       : BAT_SINGULAR;
}

/* The frames: of a planar path as it was given, so that it gets its planar ones, unless their first is asked for. */
static bat_status take_frames(const bat_curve *path, const bat_sweep_options *options, bat_sweep *sweep) {
    bat_frame_options frames = bat_frame_defaults();
    frames.rule = sweep->rule = options->frame;
    frames.has_first = options->has_first;
    memcpy(frames.first, options->first, sizeof frames.first);
    for (int k = 0; k < 3; k++)
        if (frames.has_first && !(fabs(frames.first[k]) <= BAT_COORDINATE_MAX)) return BAT_NUMBER;
    bat_status status = bat_frame_chain_converged(options->has_first ? sweep->path : path, &frames,
                                                  &sweep->chain);
    if (status != BAT_OK || !sweep->path->closed || options->frame != BAT_FRAMES_RMF) return status;
    const double length = bat_curve_length(sweep->path, sweep->domain[0], sweep->domain[1], 1e-12);
    sweep->turning = -bat_frame_chain_holonomy(sweep->chain) / length;
    return BAT_OK;
}

bat_status bat_sweep_create(const bat_curve *path, const bat_curve *profile, const bat_sweep_options *options,
                            bat_sweep **out) {
    bat_sweep_options full;
    if (!path || !profile || !out) return BAT_ARGUMENT;
    full = DEFAULTS;
    bat_status status = bat_options_read(options, LEAST, sizeof full, &full);
    if (status != BAT_OK) return status;
    if (profile->dimension != 2) return BAT_DIMENSION;
    if ((unsigned)full.frame > BAT_FRAMES_FIXED) return BAT_ARGUMENT;
    bat_sweep *sweep = calloc(1, sizeof *sweep);
    if (!sweep) return BAT_MEMORY;
    status = take_path(path, sweep);
    if (status == BAT_OK) status = bat_curve_copy(profile, &sweep->profile);
    if (status == BAT_OK && own_function(&full.twist, &sweep->twist, &status) &&
        own_function(&full.scale, &sweep->scale, &status))
        status = take_frames(path, &full, sweep);
    if (status == BAT_OK)
        *out = sweep;
    else
        bat_sweep_free(sweep);
    return status;
}

void bat_sweep_domain(const bat_sweep *sweep, bat_direction direction, double domain[2]) {
    bat_curve_domain(direction == BAT_U ? sweep->path : sweep->profile, domain);
}

double bat_sweep_holonomy(const bat_sweep *sweep) { return bat_frame_chain_holonomy(sweep->chain); }

/* ---- evaluation ---- */

/* How fast the frame turns about the tangent in its own plane, per length: the torsion of Frenet frames. */
static double turning_of(const bat_sweep *sweep, vec c1, vec c2, vec c3) {
    if (sweep->rule != BAT_FRAMES_FRENET) return sweep->turning;
    const vec across = vec_cross(c1, c2);
    const double square = vec_dot(across, across), speed = vec_norm(c1);
    return square > 1e-24 * speed * speed * speed * speed * speed * speed ? vec_dot(across, c3) / square : 0;
}

/* The frame's s and r along u: they turn with the tangent, and about it. */
static void frame_along(const bat_sweep *sweep, const double *jet, const bat_frame3 *f, vec *s1, vec *r1) {
    const vec t = vec_load(f->t, 3), s = vec_load(f->s, 3), r = vec_load(f->r, 3);
    const vec c1 = vec_load(jet + 3, 3), c2 = vec_load(jet + 6, 3);
    const double speed = vec_norm(c1);
    *s1 = *r1 = (vec){0, 0, 0};
    if (sweep->rule == BAT_FRAMES_FIXED || !(speed > 0)) return;
    const vec bend = vec_scale(vec_reject(c2, t), 1 / speed); /* curvature times speed */
    const double turn = speed * turning_of(sweep, c1, c2, vec_load(jet + 9, 3));
    *s1 = vec_sub(vec_scale(r, turn), vec_scale(t, vec_dot(bend, s)));
    *r1 = vec_sub(vec_scale(s, -turn), vec_scale(t, vec_dot(bend, r)));
}

void bat_sweep_jet_at(const bat_sweep *sweep, double u, bat_sweep_jet *out) {
    const double width = sweep->domain[1] - sweep->domain[0], x = (u - sweep->domain[0]) / width;
    double jet[12], g[3], w[3];
    bat_frame3 f;
    bat_curve_eval(sweep->path, u, 3, jet);
    bat_frame_chain_at(sweep->chain, u, &f);
    bat_function_eval(&sweep->scale, x, g), bat_function_eval(&sweep->twist, x, w);
    const vec s = vec_load(f.s, 3), r = vec_load(f.r, 3);
    const double cosine = bat_cos(w[0]), sine = bat_sin(w[0]), turn = w[1] / width, grow = g[1] / width;
    vec s1, r1;
    frame_along(sweep, jet, &f, &s1, &r1);
    const vec a = vec_add(vec_scale(s, cosine), vec_scale(r, sine));
    const vec b = vec_add(vec_scale(s, -sine), vec_scale(r, cosine));
    const vec a1 = vec_add(vec_add(vec_scale(s1, cosine), vec_scale(r1, sine)), vec_scale(b, turn));
    const vec b1 = vec_add(vec_add(vec_scale(s1, -sine), vec_scale(r1, cosine)), vec_scale(a, -turn));
    out->c = vec_load(jet, 3), out->c1 = vec_load(jet + 3, 3);
    out->a = vec_scale(a, g[0]), out->b = vec_scale(b, g[0]);
    out->a1 = vec_add(vec_scale(a1, g[0]), vec_scale(a, grow));
    out->b1 = vec_add(vec_scale(b1, g[0]), vec_scale(b, grow));
    out->speed = vec_norm(out->c1);
    out->t = vec_unit(out->c1);
}

static vec mix(vec c, vec a, vec b, double x, double y) {
    return vec_add(c, vec_add(vec_scale(a, x), vec_scale(b, y)));
}

/* Into the path's domain, where its end stays the end. */
static double reduce(const bat_sweep *sweep, double u) {
    return u == sweep->domain[1] ? u : bat_curve_reduce(sweep->path, u);
}

void bat_sweep_at(const bat_sweep *sweep, double u, double v, bat_sweep_point *out) {
    double at[4];
    bat_sweep_jet j;
    bat_curve_eval(sweep->profile, v, 1, at);
    bat_sweep_jet_at(sweep, reduce(sweep, u), &j);
    const vec along = mix(j.c1, j.a1, j.b1, at[0], at[1]);
    const vec across = mix((vec){0, 0, 0}, j.a, j.b, at[2], at[3]);
    const vec normal = vec_cross(vec_unit(along), vec_unit(across));
    vec_store(mix(j.c, j.a, j.b, at[0], at[1]), out->point);
    vec_store(vec_norm(normal) > 1e-12 ? vec_unit(normal) : (vec){0, 0, 0}, out->normal);
    out->factor = j.speed > 0 ? vec_dot(along, j.t) / j.speed : 0;
}
