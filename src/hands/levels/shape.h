/* Inside the levels hand: what a shape is made of. */
#ifndef BATTEN_HANDS_LEVELS_SHAPE_H
#define BATTEN_HANDS_LEVELS_SHAPE_H

#include <batten/levels.h>

#include "base/vec.h"

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
    bat_triad *frames; /* count: those that the curve was built with */
    int *rank;         /* how its knots contain those below (bat_refine_rank) */
    bat_curve *curve;  /* C^j */
} bat_level;

struct bat_shape {
    bat_shape_options options;
    int count; /* levels over the base */
    bat_curve *base;
    bat_level levels[BAT_LEVELS_MAX]; /* levels[j - 1] is level j */
    double holonomy[BAT_LEVELS_MAX];  /* of the frames of C^j, followed past +-pi (math 2.3) */
    bool turned; /* frames are no longer those that the curves alone would give: bat_shape_fold */
};

/* C^level, 0: the base. */
static inline bat_curve *bat_shape_curve_at(const bat_shape *shape, int level) {
    return level > 0 ? shape->levels[level - 1].curve : shape->base;
}
/* Builds C^level, refine(C^{j-1}) + sum g F d N, from the curve below and the frames that it has: all control
 * points, or the `count` of them from `first` on (closed: modulo n). */
bat_status bat_level_build(bat_level *level, const bat_curve *below);
void bat_level_build_some(bat_level *level, const bat_curve *below, int first, int count);

/*
 * Builds C^level and all above it (level 0: all above the base, which the caller has changed) in the frames that
 * the curves alone give. Details turn with their frames. On failure the shape is spoilt: edit a copy.
 */
bat_status bat_shape_rebuild(bat_shape *shape, int level);
/*
 * The details take over the frames that the curves alone give, with holonomies nearest to the present ones
 * (near) or principal ones. They turn back, so that nothing moves (math 3.4). On failure as above.
 */
bat_status bat_shape_fold(bat_shape *shape, bool near);
/* bat_shape_commit in place. On failure as above. */
bat_status bat_shape_settle(bat_shape *shape);
/* Takes over the contents of an edited copy, and frees its shell. */
void bat_shape_adopt(bat_shape *shape, bat_shape *edited);

bat_frame_options bat_shape_frame_options(const bat_shape_options *options, double holonomy_near);
/* The frames at the nodes of a level become those that the curves alone give. folded: the details turn back, so that
 * nothing moves, and whether any did is told; NULL: they turn with the frames. */
bat_status bat_shape_frames_of(bat_shape *shape, int level, bool *folded);

/* Whether r is at right angles to the plane, so that details have no part along it. Frenet frames of straight
 * stretches have no normal, and take any. */
static inline bool bat_shape_flat(const bat_shape *shape) {
    return bat_curve_dimension(shape->base) == 2 && shape->options.frame != BAT_FRAMES_FRENET;
}
/* What the details are multiplied by. */
static inline double bat_level_gain(const bat_level *level) { return level->muted ? 0 : level->gain; }

/* The linear part of an affine matrix of `dimension` rows, applied to v. */
vec bat_affine_turn(const double *matrix, int dimension, vec v);
double bat_affine_determinant(const double *matrix, int dimension);

/* Node parameters of a curve's basis functions (math 3.2): count doubles. */
bat_status bat_nodes(const bat_curve *curve, bat_node_rule rule, double *out);

/* Adds deltas in world coordinates to control points, or to the details there; the curve is not built yet.
 * BAT_STATE: a muted level shows no change. */
bat_status bat_level_add(bat_shape *shape, int level, int first, int count, const double *deltas,
                         double factor);

/* The checks of every edit by deltas. BAT_OK with *idle: nothing to do. */
bat_status bat_level_check(const bat_shape *shape, int level, int first, size_t count, const double *deltas,
                           bool *idle);
/* The deltas (degree + 1 of them at most) that move the point at u by delta (math 3.5). */
bat_status bat_level_pull(const bat_shape *shape, int level, double u, const double *delta, int *first,
                          int *count, double *deltas);
/* An edit that touches everything, on a copy: details turn with the frames that the curves alone give. */
bat_status bat_shape_move_all(bat_shape *shape, int level, int first, int count, const double *deltas);

/*
 * What an edit of control points first..first+count-1 of a level touches, and its state before: from there
 * the edit can be made again and again. Costs what it touches (math 3.4). *out is NULL when that is
 * everything.
 */
typedef struct bat_touch bat_touch;
bat_status bat_touch_begin(bat_shape *shape, int level, int first, int count, bat_touch **out);
bat_status bat_touch_apply(bat_touch *touch, const double *deltas); /* reverts first, and on failure */
void bat_touch_revert(bat_touch *touch);
bool bat_touch_fits(const bat_touch *touch, int level, int first, int count);
void bat_touch_run(const bat_touch *touch, int level, int *first, int *count); /* which of C^level change */
void bat_touch_free(bat_touch *touch);

/* Where the parameters of one base lie on another: linear between count breakpoints; on a closed base these
 * make one period. Piece `drawn` (-1: none) was drawn anew; drop: its details go. */
typedef struct bat_knot_map {
    int count, drawn;
    bool closed, drop;
    double from[4], to[4];
} bat_knot_map;
double bat_knot_map_at(const bat_knot_map *map, double u);
bat_status bat_shape_copy_mapped(const bat_shape *from, const bat_curve *onto,
                                 const bat_shape_options *options, const bat_knot_map *map, bat_shape **out);

/* Details of a level with that basis, 3 numbers a control point, as a curve over the domain of `below`; knots near those
 * of `below` become equal to them. */
bat_status bat_detail_curve(const bat_curve *curve, const double *details, const bat_curve *below,
                            const bat_knot_map *map, bat_curve **out);
/* All knots of both, each with the greater of its two multiplicities; of a closed curve one period. Returns how many. */
int bat_detail_knots(const bat_curve *below, const bat_curve *detail, double *out);
/* Details on the knots of `fine`: those of the detail curve, exactly where it has these knots, else its values at the
 * nodes. */
bat_status bat_detail_take(const bat_curve *detail, const bat_curve *fine, const double *nodes,
                           double *details);

/* A curve with fewer knots, `count` control points: by least squares over those of `fine`, weighted by the width of their
 * supports; clamped ends are kept (math 3.7). BAT_COUNT: there are not that few. */
bat_status bat_curve_coarsen(const bat_curve *fine, int count, bat_curve **out);
/* How many control points the level below a level of n has: every other interior knot is left out. */
int bat_curve_halved(const bat_curve *curve, int n);
/* How many the levels have, from the base of `coarsest` to that of n: a geometric progression. */
void bat_levels_counts(int n, int coarsest, int levels, int counts[BAT_LEVELS_MAX + 1]);

/* Details in `old` frames, expressed in `fresh` ones that differ by a turn about t. False: the two are the same. */
bool bat_triad_turn_back(const bat_triad *old, const bat_triad *fresh, double *details);
static inline vec bat_triad_to_world(const bat_triad *f, const double *d) {
    return vec_add(vec_add(vec_scale(f->t, d[0]), vec_scale(f->s, d[1])), vec_scale(f->r, d[2]));
}
static inline void bat_triad_to_local(const bat_triad *f, vec v, double *d) {
    d[0] = vec_dot(f->t, v), d[1] = vec_dot(f->s, v), d[2] = vec_dot(f->r, v);
}
/* Frames in the plane have r = z, whatever t and s (Frenet's s may lie to the right). */
static inline bat_triad bat_triad_of(const bat_shape *shape, vec t, vec s) {
    bool flat = bat_curve_dimension(shape->base) == 2 && shape->options.frame == BAT_FRAMES_RMF;
    return (bat_triad){t, s, flat ? (vec){0, 0, 1} : vec_cross(t, s)};
}

#endif
