/* Inside the levels hand: what a shape is made of. */
#ifndef BATTEN_SRC_LEVELS_H
#define BATTEN_SRC_LEVELS_H

#include <batten/levels.h>

#include "curve/vec.h"

typedef struct bat_triad {
    vec t, s, r;
} bat_triad;

typedef struct bat_level {
    double gain;
    bool muted;
    int count;
    double *details;   /* count * 3, in the frames below */
    double *nodes;     /* count, parameters in the domain */
    int *source;       /* count: the level, below this one, whose curve carries the frame */
    bat_triad *frames; /* count: those that the curve was last built with */
    bat_curve *curve;  /* C^j */
} bat_level;

struct bat_shape {
    bat_shape_options options;
    int count; /* levels over the base */
    bat_curve *base;
    bat_level levels[BAT_LEVELS_MAX]; /* levels[j - 1] is level j */
    double holonomy[BAT_LEVELS_MAX];  /* of the frames of C^j, followed past +-pi (math 2.3) */
};

/* The stretch of the parameter that an edit touches: from start over `length`; on a closed curve it may pass
 * the seam. A negative length: everything. */
typedef struct bat_stretch {
    double start, length;
} bat_stretch;

static const bat_stretch BAT_EVERYWHERE = {0, -1};

/* The stretch over which control points first..first+count-1 of a curve act. */
bat_stretch bat_stretch_of(const bat_curve *curve, int first, int count);

/*
 * Rebuilds C^level and all above it (level 0: all above the base, which the caller has changed). Where frames
 * in space would turn outside the touched stretch because the chain passes through it, details turn back, so
 * that nothing moves there (math 3.4). On failure the shape is spoilt: edit a copy.
 */
bat_status bat_shape_rebuild(bat_shape *shape, int level, bat_stretch touched);
/* Takes over the contents of an edited copy, and frees the shell of it. */
void bat_shape_adopt(bat_shape *shape, bat_shape *edited);

/* Frames at the nodes of a level, as things stand. */
bat_status bat_shape_frames_of(bat_shape *shape, int level, bat_triad *out);

/* C^j of the curve below and the frames the level has: refine(C^{j-1}) + sum g F d N. */
bat_status bat_level_build(bat_level *level, const bat_curve *below);
/* Whether r is across the plane, so that details have nothing there. Frenet frames of straight stretches have no
 * normal, and take any. */
static inline bool bat_shape_flat(const bat_shape *shape) {
    return bat_curve_dimension(shape->base) == 2 && shape->options.frame != BAT_FRAMES_FRENET;
}
/* What the details are multiplied with. */
static inline double bat_level_gain(const bat_level *level) { return level->muted ? 0 : level->gain; }

/* The linear part of an affine matrix of dimension rows. */
vec bat_affine_turn(const double *matrix, int dimension, vec v);
double bat_affine_determinant(const double *matrix, int dimension);

/* Node parameters of a curve's basis functions (math 3.2): count doubles. */
bat_status bat_nodes(const bat_curve *curve, bat_node_rule rule, double *out);

static inline vec bat_triad_to_world(const bat_triad *f, const double *d) {
    return vec_add(vec_add(vec_scale(f->t, d[0]), vec_scale(f->s, d[1])), vec_scale(f->r, d[2]));
}
static inline void bat_triad_to_local(const bat_triad *f, vec v, double *d) {
    d[0] = vec_dot(f->t, v), d[1] = vec_dot(f->s, v), d[2] = vec_dot(f->r, v);
}

#endif
