/*
 * Batten: the sketch hand. Draw over a curve: it follows the stroke there, stays C2, and keeps few knots. Source:
 * sketch-2005 sections 2 to 4, as docs/math/sketch.md (5.x) corrects and completes them.
 */
#ifndef BATTEN_SKETCH_H
#define BATTEN_SKETCH_H

#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A stroke as it came from the pen; borrowed arrays. pressure (0..1) and time (ms) may be NULL. */
typedef struct bat_stroke {
    int dimension;
    size_t count;
    const double *points;
    const double *pressure;
    const double *time;
} bat_stroke;

typedef struct bat_sketch_options {
    size_t size;         /* of this struct, as base.h says */
    double tolerance;    /* document units; 0: one pixel */
    double pixel;        /* a pen pixel in document units, > 0 */
    int pins;            /* control points a side taken from the kept piece: 3 (exact), or the paper's 2 */
    double width;        /* factor on the offset for the transitions, 3 (math 5.5) */
    bool keep_corners;   /* corners of the stroke and of the curve are kept */
    double smooth_limit; /* smoothing stroke: how far the curve may move at most, document units; 0: 5 px */
    /* Since after 0.2: */
    int degree; /* of new curves, which are C^(degree - 1): 3, or up to 7; 5 is what surfaces of class A ask for */
    double
        fairness; /* share of the tolerance that may be spent on less change of curvature: 0.2, near the stroke, to
                        0.6, fair; 0.4 */
} bat_sketch_options;

typedef struct bat_sketch_report {
    double max_error; /* stroke interior to curve, true distance */
    double noise;     /* sigma found in the stroke, document units */
    int knots_before; /* distinct knot values counted with multiplicity, as in the curve's knot vector */
    int knots_after;
    int solves;
    /* Interval [t_k, t_l] of the old curve that was replaced. Join: where a is left and where b is reached, in
     * the parameters they have once turned and b is brought to a's speed; 0 where an end follows the stroke. */
    double changed[2];
    double changed_new[2]; /* the interval of the new curve that replaces it */
    double transition[2];  /* lengths of the two transitions on the curve side */
    bool reversed;         /* the stroke ran against the curve */
    bool extended[2];      /* that end of the open curve now ends with the stroke */
    bool replaced;         /* the whole curve was replaced */
    double spans;          /* at a level of a shape: how many of its spans the stroke covers; else 0 */
} bat_sketch_report;

/* The defaults: tolerance 1 px, pixel 1, 3 pins, width 3, corners not kept, degree 3, fairness 0.4. */
BAT_API void bat_sketch_options_init(bat_sketch_options *options, size_t size);
static inline bat_sketch_options bat_sketch_defaults(void) {
    bat_sketch_options options;
    bat_sketch_options_init(&options, sizeof options);
    return options;
}

/*
 * options may be NULL: the defaults, here and below; so may report. Redraws the curve with the stroke. Degrees 1 and
 * 2 are first raised to 3, in every call that takes a curve; higher degrees stay. Cost: linear in the samples and in
 * the curve's points; about 0.9 ms for 240 samples on 100 points, 2 ms for 2,400 (one core of a server). For a stroke
 * that cannot be met, the call returns after at most 20 ms with the best curve found. BAT_DOT, BAT_FAR, BAT_TOLERANCE
 * (best curve handed over) as math 5.4 decides. BAT_FAR: the stroke lies too far from the curve to be meant for it;
 * for a closed curve it is enough that one end of the stroke does, unless the stroke closes itself, since a closed
 * curve has no end that could follow the stroke.
 */
BAT_API bat_status bat_sketch(const bat_curve *curve, const bat_stroke *stroke,
                              const bat_sketch_options *options, bat_curve **out, bat_sketch_report *report);
/* Makes a new curve from a stroke (math 5.8): closed if its ends meet (or with force_closed), with corners kept. */
BAT_API bat_status bat_sketch_new(const bat_stroke *stroke, bool force_closed,
                                  const bat_sketch_options *options, bat_curve **out,
                                  bat_sketch_report *report);
/* Fairs the stretch that the stroke passes over (math 5.8). */
BAT_API bat_status bat_sketch_smooth(const bat_curve *curve, const bat_stroke *stroke,
                                     const bat_sketch_options *options, bat_curve **out,
                                     bat_sketch_report *report);
/*
 * Calms the stretch range[0]..range[1] (closed: in any period, at most nine tenths of one) of a planar curve with its
 * present knots: the control points that determine the stretch move, and points of the curve move by at most `limit`
 * document units; waves shorter than the stretch are removed as far as that permits. The effect fades out over the
 * knots beside the stretch; a stretch that moves fewer than two control points is extended to the next knots. There
 * are never more extrema of curvature or inflections than before, nor is its peak higher; corners, ends and their
 * directions stay. pixel: a pen pixel in document units. BAT_STATE: nothing is left to calm. Cost: linear in the
 * stretch, some 0.5 ms for ten spans.
 */
BAT_API bat_status bat_sketch_calm(const bat_curve *curve, const double range[2], double limit, double pixel,
                                   bat_curve **out);
/* Joins two open curves by a stroke from one to the other (math 5.4); directions are reversed as needed. */
BAT_API bat_status bat_sketch_join(const bat_curve *a, const bat_curve *b, const bat_stroke *stroke,
                                   const bat_sketch_options *options, bat_curve **out,
                                   bat_sketch_report *report);

/*
 * Live (math 5.9): the same hand while the pen is down. The session copies what it needs of the curve (NULL: a new
 * curve). preview gives the fit so far, close to the stroke and with more knots than the commit; what it showed for
 * 125 ms stays where it is. Apart from one pass over the samples, its cost is bounded however long the stroke is.
 * commit gives exactly the result of the one-shot call for the whole stroke.
 */
typedef enum bat_sketch_kind { BAT_SKETCH_REDRAW, BAT_SKETCH_NEW, BAT_SKETCH_SMOOTH } bat_sketch_kind;
typedef struct bat_sketch_live bat_sketch_live;
BAT_API bat_status bat_sketch_live_begin(const bat_curve *curve, int dimension, bat_sketch_kind kind,
                                         const bat_sketch_options *options, bat_sketch_live **out);
BAT_API bat_status bat_sketch_live_add(bat_sketch_live *live, const bat_stroke *samples);

typedef struct bat_sketch_live_info {
    bat_sketch_report report;
    size_t target_count;  /* the smoothed target: stroke and transitions joined, as ink to be shown */
    const double *target; /* target_count points; owned by the session, valid until the next call */
    size_t stroke_first;  /* target[stroke_first..stroke_last] is the stroke proper */
    size_t stroke_last;
} bat_sketch_live_info;
/* BAT_DOT while the stroke is too short. *out is a new curve that the caller frees; out may be NULL when only info
 * is wanted. */
BAT_API bat_status bat_sketch_live_preview(bat_sketch_live *live, bat_curve **out,
                                           bat_sketch_live_info *info);
/* Ends the session whatever it returns. */
BAT_API bat_status bat_sketch_live_commit(bat_sketch_live *live, bat_curve **out, bat_sketch_report *report);
BAT_API void bat_sketch_live_cancel(bat_sketch_live *live); /* NULL is fine */

#ifdef __cplusplus
}
#endif
#endif
