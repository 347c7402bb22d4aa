/* Pairs of surfaces that touch, miss each other or cross by a gap that is known in closed form, turned and moved by chance. */
#ifndef BATTEN_TESTS_TOUCHING_H
#define BATTEN_TESTS_TOUCHING_H

#include "support/random_surface.h"
#include "support/solids.h"
#include <batten/trace.h>

#include <stdint.h>

typedef enum touching_kind {
    BALL_PLANE,
    BALLS,
    TUBES_ACROSS,
    TUBE_IN_TUBE,
    RING_PLANE,
    SADDLE_PLANE,
    TUBE_PLANE,
    TUBES_ALONG,
    RING_ON_PLANE,
    TOUCHING_KINDS
} touching_kind;

static const char *const touching_names[TOUCHING_KINDS] = {
    "ball and plane",   "balls",          "tubes across", "tube in tube", "ring and plane from inside",
    "saddle and plane", "tube and plane", "tubes along",  "ring on plane"};

/* What is found: branches, how many of them are closed, contacts, and whether it is given up. */
typedef struct touching_count {
    size_t branches, closed, contacts;
    bool along;
} touching_count;

typedef struct touching {
    bat_surface *side[2];
    touching_count want;
    size_t exact; /* branches without the tolerance; within it, as many as these to `want` */
    bool sure;
} touching;

static inline double touching_saddle(double x, double y) { return 0.5 * (x * x - y * y); }

/* A turn by chance, a scale, and a move of up to `far`. */
static inline void touching_pose(random_source *r, double scale, double far, double m[12]) {
    double q[4], norm = 0;
    for (int i = 0; i < 4; i++) q[i] = random_between(r, -1, 1), norm += q[i] * q[i];
    for (int i = 0; i < 4; i++) q[i] /= sqrt(norm);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double turn[9] = {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
                            2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                            2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) m[4 * i + k] = scale * turn[3 * i + k];
        m[4 * i + 3] = scale * far * random_between(r, -1, 1);
    }
}

/* large, small: radii; gap: how far the two are apart, below 0 into each other. */
static inline void touching_pair(touching_kind kind, double large, double small, double gap, double angle,
                                 bat_surface *out[2]) {
    const double n[3] = {cos(angle), sin(angle), 0}, outer = large + small + gap, thin = 0.7 * small;
    const double on[3] = {(large + gap) * n[0], (large + gap) * n[1], 0};
    const double inner[3] = {large - thin + gap, 0, 0}, top[3] = {0, 0, thin + gap}, low[3] = {0, 0, gap};
    const double x[3] = {1, 0, 0}, z[3] = {0, 0, 1};
    bat_surface *const made = kind == BALL_PLANE || kind == BALLS           ? solid_sphere(large, 24, 12)
                              : kind == RING_PLANE || kind == RING_ON_PLANE ? solid_torus(large, thin, 32, 16)
                              : kind == SADDLE_PLANE                        ? solid_sheet(24, touching_saddle)
                              : kind == TUBE_PLANE || kind == TUBES_ALONG   ? solid_cylinder(large, 1.3, 24)
                                                                            : solid_cylinder(large, 2.3, 24);
    out[0] = made;
    switch (kind) {
    case BALLS:
        out[1] = solid_move(solid_sphere(small, 24, 12), 0, 0.4, outer * n[0], outer * n[1], 0);
        break;
    case TUBES_ACROSS:
        out[1] = solid_move(solid_cylinder(small, 2, 24), 0, solid_pi / 2, outer, 0, 0.1 * angle);
        break;
    case TUBE_IN_TUBE:
        out[1] = solid_move(solid_cylinder(small, 2.1, 24), 0, solid_pi / 2, large - small + gap, 0,
                            0.1 * angle);
        break;
    case TUBES_ALONG:
        out[1] = solid_move(solid_cylinder(small, 1.1, 24), 0, 0, outer * n[0], outer * n[1], 0);
        break;
    case RING_PLANE: out[1] = solid_plane(inner, x, 3.1); break;
    case RING_ON_PLANE: out[1] = solid_plane(top, z, 3.1); break;
    case SADDLE_PLANE: out[1] = solid_plane(low, z, 3.1); break;
    default: out[1] = solid_plane(on, n, 3.1);
    }
}

/* The pair of a number; a gap of 1e-12 to 1e-2 to either side, or none. */
static inline touching touching_make(touching_kind kind, int number, double scale, double far) {
    random_source r = {1000 * (uint64_t)kind + (uint64_t)number + 1};
    const double large = random_between(&r, 0.5, 1.5), small = large * random_between(&r, 0.3, 0.7),
                 size = pow(10, random_between(&r, -12, -2)), angle = random_between(&r, -0.9, 0.9);
    const double gap = number % 8 == 0 ? 0 : number % 2 ? size : -size;
    touching t = {.exact = 0};
    double m[12];
    touching_pair(kind, large, small, gap, angle, t.side);
    touching_pose(&r, scale, far, m);
    for (int k = 0; k < 2; k++) {
        bat_surface *moved = NULL;
        if (bat_surface_transform(t.side[k], m, &moved) != BAT_OK) abort();
        bat_surface_free(t.side[k]);
        t.side[k] = moved;
    }
    const double within = 1e-4 * fmin(bat_surface_size(t.side[0]), bat_surface_size(t.side[1])) / scale,
                 off = 3e-5 * large; /* of circles that are splines */
    const bool eight = kind == TUBE_IN_TUBE || kind == RING_PLANE, loop = kind <= TUBES_ACROSS;
    const bool in = gap<-(loop ? 2.1 : 1) * within - off, out = gap> within + off,
               touch = fabs(gap) < within - off;
    t.sure = in || out || touch;
    if (loop)
        t.want = (touching_count){in, in, touch, false};
    else if (kind == SADDLE_PLANE)
        t.want = (touching_count){touch ? 4 : 2, 0, touch, false};
    else if (eight)
        t.want = (touching_count){out ? 1 : 2, in ? 2 : out, touch, false};
    else
        t.want = (touching_count){in ? 2 : 0, in && kind == RING_ON_PLANE ? 2 : 0, 0, touch};
    t.exact = !touch ? t.want.branches : kind == SADDLE_PLANE ? 2 : eight ? 1 : 0;
    return t;
}

static inline bool touching_agree(const touching *t, const touching_count *found) {
    const touching_count *w = &t->want;
    if (!t->sure) return true;
    if (w->along) return found->along; /* branches and contacts are as they come */
    if (found->along != w->along || found->contacts != w->contacts) return false;
    return found->branches >= t->exact && found->branches <= w->branches &&
           (t->exact < w->branches || found->closed == w->closed);
}

/* false: a status. The pair the other way round where `turned`. */
static inline bool touching_find(const touching *t, bool turned, touching_count *out) {
    bat_tracks *tracks = NULL;
    if (bat_surface_intersect(t->side[turned], t->side[!turned], NULL, &tracks) != BAT_OK) return false;
    *out = (touching_count){bat_tracks_count(tracks), 0, bat_tracks_crossing_count(tracks),
                            bat_tracks_is_given_up(tracks)};
    for (size_t i = 0; i < out->branches; i++) out->closed += bat_tracks_is_closed(tracks, i);
    bat_tracks_free(tracks);
    return true;
}

static inline void touching_free(touching *t) {
    for (int k = 0; k < 2; k++) bat_surface_free(t->side[k]);
}

#endif
