/*
 * Frames of reference and wire, F_R and F_W, each along its own curve, and the angle between the pairs. The rotation at a
 * place is F_W F_R^T. Rotation-minimising frames of one curve differ by one angle about its tangents, so this angle is chosen
 * for the whole wire: that of the greatest trace, in sum, of F_W^T Q F_R, Q being the best rigid fit. A wire that is a rigid
 * motion of its reference is so turned by just this motion; which end of a wire comes first has no say. Round a loop the
 * rotation may come back as its other quaternion (a circle becomes a figure of eight), so that parts of it would not meet:
 * then the wire's frames take one turn more or less on their way.
 */
#include "form/wire/turner.h"
#include "curve/curve.h"
#include "curve/frames/converged.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 16 /* a control point */ };

static quat frame_of(const double *t, const double *s, const double *r) {
    return quat_of_axes(vec_load(t, 3), vec_load(s, 3), vec_load(r, 3));
}

/* ---- of a reference ---- */

bat_status bat_wire_frames_begin(const bat_curve *reference, size_t count, const void *at, size_t stride,
                                 bat_wire_frames *out) {
    bat_frame_options options = bat_frame_defaults();
    *out = (bat_wire_frames){.chain = NULL};
    bat_status status = bat_frame_chain_converged(reference, &options, &out->chain);
    if (status != BAT_OK) return status;
    out->substeps = options.substeps;
    out->at = malloc((count + 1) * sizeof *out->at);
    for (size_t i = 0; i < count && out->at; i++) {
        bat_frame3 frame;
        double u;
        memcpy(&u, (const char *)at + i * stride, sizeof u);
        bat_frame_chain_at(out->chain, u, &frame);
        out->at[i] = frame_of(frame.t, frame.s, frame.r);
    }
    if (out->at) return BAT_OK;
    bat_wire_frames_end(out);
    return BAT_MEMORY;
}

void bat_wire_frames_end(bat_wire_frames *frames) {
    bat_frame_chain_free(frames->chain);
    free(frames->at);
    *frames = (bat_wire_frames){.chain = NULL};
}

/* ---- from it to the wire ---- */

static bool same_knots(const bat_curve *a, const bat_curve *b) {
    const int count = bat_curve_knot_count(a);
    return bat_curve_degree(a) == bat_curve_degree(b) && count == bat_curve_knot_count(b) &&
           memcmp(bat_curve_knots(a), bat_curve_knots(b), (size_t)count * sizeof(double)) == 0;
}

/* Equal knots get equal steps, so that equal shapes get equal frames. holonomy: near which that of the wire is. */
static bat_status chain_of(const bat_curve *reference, const bat_wire_frames *frames, const bat_curve *wire,
                           double holonomy, bat_frame_chain **out) {
    bat_frame_options options = bat_frame_defaults();
    bat_curve *in_space = NULL;
    options.holonomy_near = holonomy;
    options.substeps = frames->substeps;
    bat_status status = bat_curve_to_dimension(wire, 3, &in_space);
    if (status != BAT_OK) return status;
    status = same_knots(reference, wire) ? bat_frame_chain_create(in_space, &options, out)
                                         : bat_frame_chain_converged(in_space, &options, out);
    bat_curve_free(in_space);
    return status;
}

/* Frames of both curves at even places. */
static quat best_fit(const bat_turner *turner, const bat_frame3 *from, const bat_frame3 *to, vec *room) {
    vec *a = room, *b = room + turner->count;
    for (size_t i = 0; i < turner->count; i++)
        a[i] = vec_load(from[i].point, 3), b[i] = vec_load(to[i].point, 3);
    return bat_rigid_fit(turner->count, a, b);
}

/* The angle about the tangents by which the wire's frames come closest to the reference's after the fit. */
static void find_angle(bat_turner *turner, quat fit, const bat_frame3 *from, const bat_frame3 *to) {
    double along = 0, aside = 0;
    for (size_t i = 0; i < turner->count; i++) {
        const vec s = quat_turn(fit, vec_load(from[i].s, 3)), r = quat_turn(fit, vec_load(from[i].r, 3));
        const vec to_s = vec_load(to[i].s, 3), to_r = vec_load(to[i].r, 3);
        along += vec_dot(s, to_s) + vec_dot(r, to_r);
        aside += vec_dot(s, to_r) - vec_dot(r, to_s);
    }
    const double length = bat_hypot(along, aside);
    const bool none = !(length > 1e-12 * (double)turner->count);
    turner->cosine = none ? 1 : along / length, turner->sine = none ? 0 : aside / length;
}

static quat turned_frame(const bat_turner *turner, const double *t, const double *s, const double *r) {
    const vec x = vec_load(s, 3), y = vec_load(r, 3);
    return quat_of_axes(vec_load(t, 3), vec_add(vec_scale(x, turner->cosine), vec_scale(y, turner->sine)),
                        vec_sub(vec_scale(y, turner->cosine), vec_scale(x, turner->sine)));
}

/* The rotation that is closest to the fit is on its side, each other one on that of its neighbour. */
static void find_signs(bat_turner *turner, quat fit, const bat_frame3 *from, const bat_frame3 *to) {
    size_t best = 0;
    for (size_t i = 0; i < turner->count; i++) {
        turner->signs[i] = quat_mul(turned_frame(turner, to[i].t, to[i].s, to[i].r),
                                    quat_inverse(frame_of(from[i].t, from[i].s, from[i].r)));
        if (fabs(quat_dot(turner->signs[i], fit)) > fabs(quat_dot(turner->signs[best], fit))) best = i;
    }
    turner->signs[best] = quat_near(turner->signs[best], fit);
    for (size_t i = best; i-- > 0;) turner->signs[i] = quat_near(turner->signs[i], turner->signs[i + 1]);
    for (size_t i = best + 1; i < turner->count; i++)
        turner->signs[i] = quat_near(turner->signs[i], turner->signs[i - 1]);
}

/* Of a closed wire: whether the rotation comes back from once round as its other quaternion. */
static bool comes_back_turned(const bat_turner *turner) {
    return quat_dot(turner->signs[0], turner->signs[turner->count - 1]) < 0;
}

static bat_status compare(const bat_wire_frames *frames, bat_turner *turner) {
    bat_frame3 *from = malloc(2 * turner->count * sizeof *from), *to = from ? from + turner->count : NULL;
    vec *room = calloc(2 * turner->count, sizeof *room);
    turner->signs = malloc(turner->count * sizeof *turner->signs);
    const bool there = from && room && turner->signs;
    if (there) {
        for (size_t i = 0; i < turner->count; i++) {
            const double u = turner->start + turner->step * (double)i;
            bat_frame_chain_at(frames->chain, u, &from[i]), bat_frame_chain_at(turner->chain, u, &to[i]);
        }
        quat fit = best_fit(turner, from, to, room);
        if (fit.w < 0) fit = quat_scale(fit, -1);
        find_angle(turner, fit, from, to);
        find_signs(turner, fit, from, to);
    }
    free(from), free(room);
    return there ? BAT_OK : BAT_MEMORY;
}

bat_status bat_turner_begin(const bat_curve *reference, const bat_wire_frames *frames, const bat_curve *wire,
                            bat_turner *out) {
    const size_t steps = SAMPLES * bat_curve_count(reference);
    const bool closed = bat_curve_is_closed(reference);
    double domain[2];
    bat_curve_domain(reference, domain);
    *out = (bat_turner){.start = domain[0], .step = (domain[1] - domain[0]) / (double)steps};
    out->count = closed ? steps : steps + 1; /* closed: the end is the start */
    const double own = bat_frame_chain_holonomy(frames->chain);
    bat_status status = chain_of(reference, frames, wire, own, &out->chain);
    if (status == BAT_OK) status = compare(frames, out);
    if (status == BAT_OK && closed && comes_back_turned(out)) {
        const double first = bat_frame_chain_holonomy(out->chain), more = first < own ? BAT_PI : -BAT_PI;
        bat_frame_chain_free(out->chain), free(out->signs);
        out->chain = NULL, out->signs = NULL;
        status = chain_of(reference, frames, wire, first + 2 * more, &out->chain);
        if (status == BAT_OK) status = compare(frames, out);
    }
    if (status != BAT_OK) bat_turner_end(out);
    return status;
}

void bat_turner_end(bat_turner *turner) {
    bat_frame_chain_free(turner->chain);
    free(turner->signs);
    *turner = (bat_turner){.chain = NULL};
}

void bat_turner_at(const bat_turner *turner, int count, const double *u, const quat *from, vec *out) {
    double t[3 * BAT_TURNER_BATCH], s[3 * BAT_TURNER_BATCH], r[3 * BAT_TURNER_BATCH];
    const bat_frame_arrays arrays = {.t = t, .s = s, .r = r};
    if (bat_frame_chain_many(turner->chain, (size_t)count, u, &arrays) != BAT_OK) count = 0;
    for (int i = 0; i < count; i++) {
        const double place = floor((u[i] - turner->start) / turner->step + 0.5);
        const size_t k = (size_t)fmin(fmax(place, 0), (double)(turner->count - 1));
        const quat to = turned_frame(turner, t + 3 * i, s + 3 * i, r + 3 * i);
        out[i] = quat_log(quat_near(quat_mul(to, quat_inverse(from[i])), turner->signs[k]));
    }
}
