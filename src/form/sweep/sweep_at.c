/* A sweep at a place: the frame, twist and scale with their derivatives (docs/math/surfaces.md). */
#include "form/sweep/sweep.h"

#include <math.h>

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
    bat_mitres_apply(sweep, u, out);
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
