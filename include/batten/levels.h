/*
 * Batten: the levels hand. A base curve and levels of detail over it, each in the frames of the level below,
 * so that the sweep and the detail can be edited separately. Source: multilevel-2016 sections 3 and 4, as
 * docs/math/levels.md (math 3) corrects and completes them.
 *
 *     C^j = refine(C^{j-1}, U^j) + sum_i F^{j-1}(u_i) g_j d_i^j N_i^j,    U^0 in U^1 in ... in U^k
 */
#ifndef BATTEN_LEVELS_H
#define BATTEN_LEVELS_H

#include <batten/frames.h>
#include <batten/sketch.h>
#include <batten/tangents.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
    BAT_LEVELS_MAX = 24,
    BAT_LEVEL_SPANS_LEAST = 3 /* a stroke over fewer spans cannot be followed at that level (math 3.6) */
};

typedef enum bat_node_rule {
    BAT_NODES_GREVILLE, /* second order */
    BAT_NODES_ARGMAX    /* where N_i is greatest: the paper's */
} bat_node_rule;

typedef enum bat_propagation {
    BAT_PROPAGATION_LOCAL, /* in space: frames outside the edited stretch stay as they were (math 3.4) */
    BAT_PROPAGATION_PLAIN  /* the paper's: they follow the chain from the start */
} bat_propagation;

typedef struct bat_shape_options {
    size_t size; /* of this struct, as base.h says */
    bat_frame_rule frame;
    bat_node_rule nodes;
    bat_propagation propagation;
    /* has_reference: the persistent pair of math 2.2. has_first: s projected on the start tangent's normal
     * plane, at every level and after every edit. Neither: the base's start tangent and some normal become
     * the pair. */
    bool has_first, has_reference;
    double first[3], reference_t[3], reference_s[3];
} bat_shape_options;

/* The defaults: RMF, Greville, local. */
BAT_API void bat_shape_options_init(bat_shape_options *options, size_t size);
static inline bat_shape_options bat_shape_defaults(void) {
    bat_shape_options options;
    bat_shape_options_init(&options, sizeof options);
    return options;
}

typedef struct bat_shape bat_shape;

/* Copies the base. The shape has no level yet. options may be NULL: the defaults, here and below. */
BAT_API bat_status bat_shape_create(const bat_curve *base, const bat_shape_options *options, bat_shape **out);
/* The same with a G1 spline through points (bat_tangents) as the base. */
BAT_API bat_status bat_shape_from_spline(const bat_spline *spline, const bat_tangents_options *tangents,
                                         const bat_shape_options *options, bat_shape **out);
BAT_API bat_status bat_shape_copy(const bat_shape *shape, bat_shape **out);
BAT_API void bat_shape_free(bat_shape *shape); /* NULL is fine */

/* Adds a level on top. knots: a superset of the knots below, in the curve's own form (open: n + p + 1,
 * closed: n + 1); NULL: a knot in the middle of every span. details: count * 3 (t, s, r; planar: r is 0), or
 * NULL: none yet. source: count, the level whose frame each detail uses (math 3.7), or NULL: the level below.
 * BAT_KNOTS: not a superset; BAT_COUNT: BAT_LEVELS_MAX there are. O(count). */
BAT_API bat_status bat_shape_add_level(bat_shape *shape, int knot_count, const double *knots,
                                       const double *details, const int *source);

BAT_API int bat_shape_levels(const bat_shape *shape); /* k; how many, 0 at first */
/* C^0..C^k; owned by the shape, valid until it changes. NULL: no such level. */
BAT_API const bat_curve *bat_shape_curve(const bat_shape *shape, int level);
/* C^k as a curve of its own. */
BAT_API bat_status bat_shape_flatten(const bat_shape *shape, bat_curve **out);
/* Of level 1..k: count * 3 numbers, count parameters, and the level whose frame each detail uses, owned by the shape; its
 * gain, and whether it is muted. No such level: NULL, 0 and false. */
BAT_API const double *bat_shape_details(const bat_shape *shape, int level);
BAT_API const double *bat_shape_nodes(const bat_shape *shape, int level);
BAT_API const int *bat_shape_source(const bat_shape *shape, int level);
BAT_API double bat_shape_gain(const bat_shape *shape, int level);
BAT_API bool bat_shape_is_muted(const bat_shape *shape, int level);
BAT_API const bat_shape_options *bat_shape_options_of(const bat_shape *shape);

/*
 * Edits. Displacements are in world coordinates, dimension doubles each; level 0 is the base. On failure the shape is
 * as it was. What lies outside the stretch that an edit touches does not move (math 3.4), unless propagation is
 * plain.
 */
BAT_API bat_status bat_shape_move(bat_shape *shape, int level, int index, const double *delta);
/* Moves the point of C^level at u by exactly delta, with the least change of the control points (math 3.5). */
BAT_API bat_status bat_shape_drag(bat_shape *shape, int level, double u, const double *delta);
/* The same, repeated until the point of the finest curve at u has moved by delta within tolerance (at most 20
 * times). *left: what is still missing. BAT_TOLERANCE: the point does not get there. */
BAT_API bat_status bat_shape_drag_finest(bat_shape *shape, int level, double u, const double *delta,
                                         double tolerance, double *left);
/* What stays while a level is dragged: of the finest curve its places at `points` and its directions at `directions`,
 * parameters, at most BAT_HELD_MAX of each; its length; the area that it encloses, of a closed planar curve; its symmetry: that it is its
 * own mirror image, control point for control point, as is the level (to 1e-5 of the size, and no farther from it in the end), of several
 * axes about the one nearest to the direction `upright` (0, 0: the second axis). */
enum { BAT_HELD_MAX = 8 };
typedef struct bat_shape_held {
    bool length, area, symmetry;
    double upright[2];
    size_t point_count, direction_count;
    const double *points, *directions;
} bat_shape_held;
/*
 * Moves the finest curve's point at u by delta, and holds the rest, by the least change of the control points of `level` (math
 * 3.9); all to 1e-10 of the curve's size. BAT_TOLERANCE: that cannot be, or is not found; BAT_STATE: the level is muted;
 * BAT_DIMENSION: no area, no symmetry in space; BAT_COUNT: too much is held; BAT_SINGULAR: no direction, no symmetry there. The shape then is as it was. Cost: at most some
 * hundred rebuilds of the level and those above it; three to six as a rule.
 */
BAT_API bat_status bat_shape_drag_held(bat_shape *shape, int level, double u, const double *delta,
                                       const bat_shape_held *held);
/* The same with control point `index` of the level, which moves by delta. BAT_ARGUMENT: no such point. */
BAT_API bat_status bat_shape_move_held(bat_shape *shape, int level, int index, const double *delta,
                                       const bat_shape_held *held);
/* Moves control points first..first+count-1 (closed: modulo n) at once. */
BAT_API bat_status bat_shape_move_many(bat_shape *shape, int level, int first, size_t count,
                                       const double *deltas);
/* 0 mutes the detail, 1 leaves it as it is, above 1 exaggerates it; within +-1e6, else BAT_NUMBER. BAT_ARGUMENT:
 * level 0, or no such level. */
BAT_API bat_status bat_shape_set_gain(bat_shape *shape, int level, double gain);
/* A muted level shows nothing and cannot be edited; its gain is kept for when it is unmuted. */
BAT_API bat_status bat_shape_set_muted(bat_shape *shape, int level, bool muted);
/* Sketch at a level (math 3.6): targets[count * dimension] at parameters u[count] of C^level, in any order. The
 * stroke covers an open curve from the first parameter to the last, and a closed one except for the longest gap.
 * Beyond the stroke, C^level moves nowhere by more than the largest displacement asked for; more than two of its
 * spans away, it moves by at most 6 % of that; and it does not move at all beyond the supports of the basis
 * functions that the stroke meets. */
BAT_API bat_status bat_shape_sketch(bat_shape *shape, int level, size_t count, const double *u,
                                    const double *targets);
/* A pen stroke over C^level: cleaned and matched as the sketch hand does it. BAT_DOT, BAT_FAR (also a stroke with
 * a loop). options NULL: defaults. report (may be NULL) says how many spans of the level the stroke covers, and
 * how far at most it lies from C^level afterwards: over fewer than BAT_LEVEL_SPANS_LEAST spans that is far. */
BAT_API bat_status bat_shape_redraw_level(bat_shape *shape, int level, const bat_stroke *stroke,
                                          const bat_sketch_options *options, bat_sketch_report *report);
/* The same without a report. */
BAT_API bat_status bat_shape_sketch_stroke(bat_shape *shape, int level, const bat_stroke *stroke,
                                           const bat_sketch_options *options);
/* A free pen stroke over the base, or over the curve as it appears: the base is redrawn as bat_sketch does it, and
 * its knots change there. Details ride along; beyond the interval that was replaced they stay where they were,
 * within it they are kept and spread evenly, or dropped if drop is true. Bases of degree 1 and 2 become cubics,
 * and details are then taken at the nodes. report may be NULL. BAT_DOT, BAT_FAR, BAT_TOLERANCE (*out is handed
 * over) as bat_sketch. */
BAT_API bat_status bat_shape_redraw(const bat_shape *shape, const bat_stroke *stroke, bool drop,
                                    const bat_sketch_options *options, bat_shape **out,
                                    bat_sketch_report *report);
/* Affine map, dimension rows of dimension + 1. Details turn with it and scale by the root of its determinant.
 * BAT_SINGULAR: the matrix is singular; BAT_NUMBER. */
BAT_API bat_status bat_shape_transform(bat_shape *shape, const double *matrix);
/* Changes the frame rule, applies an affine map (matrix NULL: none), or does both at once: the details are
 * re-expressed so that each of C^0..C^k is exactly the image of what it was, whatever the matrix. BAT_SINGULAR:
 * the matrix is singular. */
BAT_API bat_status bat_shape_reframe(bat_shape *shape, const double *matrix, bat_frame_rule rule);
/* The shape in the plane z = 0 (dimension 2), seen along z, or in space (3, with z = 0): the details are re-expressed so that
 * each of C^0..C^k is exactly that view of what it was, muted levels, too; knots, gains and rules stay. BAT_DIMENSION: any
 * other dimension; BAT_SINGULAR: the curve is seen as a point. O(points). */
BAT_API bat_status bat_shape_to_dimension(const bat_shape *shape, int dimension, bat_shape **out);
/* Ends an edit. Edits in space may have left details in frames that the curves alone would not give: they are
 * re-expressed in the frames that the curves give, and a new persistent pair is taken when the start tangent has
 * turned far from the old one (math 2.2); nothing moves by more than rounding. A committed shape that is written
 * and read back is the same, bit for bit. */
BAT_API bat_status bat_shape_commit(bat_shape *shape);

/*
 * Live: the same edits while the pen is down. The session works on a copy of the shape. Every call edits the shape as
 * it was at the beginning, so that the result depends on the last call alone, and is bit for bit what the one-shot
 * call and bat_shape_commit give; an edit that moves nothing gives the shape as it was, bit for bit. Cost: what the
 * edit touches at its level and above (math 3.4), some microseconds, however large the shape, for as long as the same
 * control points move (nine times that in space where tangents turn a lot); the first call of a run, and edits that
 * touch everything (a base of few points; Frenet frames and plain propagation in space), cost more. On failure: the
 * shape as it was at the beginning.
 */
typedef struct bat_shape_live bat_shape_live;
BAT_API bat_status bat_shape_live_begin(const bat_shape *shape, int level, bat_shape_live **out);
BAT_API bat_status bat_shape_live_move(bat_shape_live *live, int first, size_t count, const double *deltas);
BAT_API bat_status bat_shape_live_drag(bat_shape_live *live, double u, const double *delta);
BAT_API bat_status bat_shape_live_drag_finest(bat_shape_live *live, double u, const double *delta,
                                              double tolerance, double *left);
/* The shape as it stands; owned by the session, its curves valid until the next call. */
BAT_API const bat_shape *bat_shape_live_shape(const bat_shape_live *live);
/* The control points of C^level that differ from those at the beginning: *count from *first on (closed: modulo n). */
BAT_API void bat_shape_live_touched(const bat_shape_live *live, int level, int *first, size_t *count);
/* Ends the session whatever it returns. *out: the edited shape, committed. */
BAT_API bat_status bat_shape_live_commit(bat_shape_live *live, bat_shape **out);
BAT_API void bat_shape_live_cancel(bat_shape_live *live); /* NULL is fine */

/* Takes a curve apart into `levels` levels, exactly: every other interior knot is left out at each level (math
 * 3.7); second and third copies of a knot are removed before any knot is removed altogether, so that the coarse
 * curves are smooth. BAT_COUNT: too few knots for so many levels. */
BAT_API bat_status bat_shape_decompose(const bat_curve *curve, int levels, const bat_shape_options *options,
                                       bat_shape **out);
/* The same down to a base of `coarsest` control points (open: at least degree + 1, closed: 3), the numbers of
 * points of the levels in between forming a geometric progression. */
BAT_API bat_status bat_shape_decompose_to(const bat_curve *curve, int levels, size_t coarsest,
                                          const bat_shape_options *options, bat_shape **out);

/* The levels of `from`, with their gains, over another base: the domains are mapped onto each other, and details
 * keep their length and their orientation to the curve. If degree and closedness are the same, the details are the
 * same splines, refined; otherwise they are taken at the nodes. BAT_DIMENSION: the dimensions differ. */
BAT_API bat_status bat_shape_copy_levels(const bat_shape *from, const bat_curve *onto, bat_shape **out);

#ifdef __cplusplus
}
#endif
#endif
