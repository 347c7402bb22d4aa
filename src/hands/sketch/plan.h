/* Inside the sketch hand: what a stroke does to a curve, decided before any fit. One record runs through the
 * steps: correspondence -> ends -> transitions -> interval -> target -> fit -> splice. Pixels throughout. */
#ifndef BATTEN_HANDS_SKETCH_PLAN_H
#define BATTEN_HANDS_SKETCH_PLAN_H

#include "hands/sketch/correspond.h"
#include "hands/sketch/fit_interval.h"
#include "hands/sketch/meant.h"

typedef enum bat_end_kind {
    BAT_END_KEPT,  /* what lies beyond is kept; the new piece joins it C^(p-1) */
    BAT_END_POINT, /* the new piece begins at a point of the curve: its end, or a kept corner (C0) */
    BAT_END_FREE   /* the new piece ends with the stroke */
} bat_end_kind;

/* One end of the stretch that changes; end 0 lies before it, end 1 after it. */
typedef struct bat_end {
    bat_end_kind kind;
    bat_end_rule rule;
    const bat_curve *curve;    /* in pixels; borrowed */
    const bat_curve *original; /* the same in document units; borrowed */
    const bat_stroke_track *track;
    double s;      /* arc length where the stroke's end belongs */
    double offset; /* distance there */
    double angle;  /* between the stroke's direction and the curve's */
    double lead;   /* length of the transition on the curve, d */
    double
        look; /* length of stroke that its direction there is taken from, if the transition is a long one */
    double blend;   /* length of the stroke that gives way, e */
    double joint;   /* arc length where the transition begins: s -+ lead */
    double joint_u; /* its parameter (closed: unrolled) */
    double cut;     /* parameter of the cut: joint_u, or the knot beyond it */
    bool corner;    /* POINT at a kept corner inside the curve */
} bat_end;

typedef struct bat_target {
    size_t count, room;
    double *x, *w, *weight, *allowed, *law;
    size_t first, last;   /* the stroke proper */
    double end;           /* w runs from 0 to this */
    double rate;          /* w per unit of the curve's parameter */
    double before, after; /* w of the kept portions refitted at either end */
} bat_target;

typedef struct bat_plan {
    int degree, dimension, pins;
    double tolerance, width; /* tolerance in pixels */
    double fairness;         /* share of it, for what follows the dense fit (5.7) */
    bool keep_corners;
    double speed;  /* pixels per parameter unit, where the curve has no speed of its own to continue */
    bool closed;   /* the curve stays closed: ends 0 and 1 are on one closed curve */
    bool periodic; /* the whole closed curve is the stroke */
    bat_end end[2];
    bat_clean *stroke;
    bat_target target;
    int fixed_count;
    double *fixed; /* w of kept corners of the stroke; owned */
} bat_plan;

/* Whether the stroke is too far from the curve to be meant for it: both ends are far. around > 0: for a
 * closed curve of that length one far end is enough. An open curve can end with the stroke; a closed one has
 * no end, and would lose the arc up to wherever it comes nearest to the far end of the stroke. */
bool bat_ends_far(const bat_clean *stroke, const bat_correspondence *found, double around);
/* docs/math sketch 5.4: decides the kinds of both ends. BAT_FAR: both are far. */
bat_status bat_plan_ends(bat_plan *plan, const bat_correspondence *found);
/* 5.5: lengths of the transitions. */
void bat_plan_leads(bat_plan *plan);
/* 5.6: where they begin, and where the curve is cut. */
void bat_plan_cuts(bat_plan *plan);
/* Cuts exactly at a knot where the curve is only C0, or at its end. */
void bat_end_stop(bat_end *e, int side, double u, bool corner);
/* 5.5, 5.6: the target polyline with weights, allowed errors and parameters. */
bat_status bat_plan_target(bat_plan *plan);
/* The old curve between a cut and its joint, part of every target; step: pixels between samples. */
bat_status bat_plan_add_kept(bat_plan *plan, int side, double step);
/* |C'| of the kept piece at a joint, `mean` where nothing is kept. */
double bat_plan_joint_speed(const bat_end *end, int side, double mean);
/* Parameters of a target whose samples 0..a-1 and b+1.. are kept portions. */
void bat_plan_parameters(bat_plan *plan, size_t a, size_t b);
/* Parameters of the stroke's kept corners, samples `index` of the target, once parameters are known. */
bat_status bat_plan_fix_corners(bat_plan *plan, const size_t *index, size_t count);
/* The same for a stroke that closes upon itself: the gap is bridged, or its ends meet in a corner. */
bat_status bat_plan_ring(bat_plan *plan);
void bat_plan_free(bat_plan *plan);

bat_status bat_target_add(bat_target *target, int dimension, const double *x, double allowed);
/* Assigns weights and parameters: du = ds / v(s), samples 0..a and b..count-1 already have theirs (a = 0,
 * b = count - 1 when none). */
void bat_target_speed(bat_target *target, int dimension, size_t a, size_t b, double before, double after,
                      double mean);

/* G2 transition between two frames (point, unit direction, curvature vector): quintic Hermite, the fairest of
 * a few tangent lengths. Writes `count` points, both ends included. */
typedef struct bat_plan_frame {
    double point[BAT_DIMENSION_MAX], direction[BAT_DIMENSION_MAX], curvature[BAT_DIMENSION_MAX];
} bat_plan_frame;
/* The frame of a cleaned stroke at arc length s; its curvature is that of a circle of 20 px at most. Its direction is
 * that of 12 px of the stroke, or of `look` if that is more. */
void bat_stroke_frame(const bat_clean *stroke, double s, double look, bat_plan_frame *out);
void bat_bridge(int dimension, const bat_plan_frame *from, const bat_plan_frame *to, size_t count,
                double *points);
/* Greatest discrete curvature, and the sum of squared changes of curvature, of points meant to be evenly
 * spaced. */
void bat_fairness(int dimension, size_t count, const double *points, double *tightest, double *variation);

/* Puts a fitted interval into the curve. origin, pixel: from pixels back to document units. */
bat_status bat_splice(const bat_plan *plan, const bat_local_problem *problem, const bat_local_result *fit,
                      const double *origin, double pixel, bat_curve **out, double changed_new[2]);
/* Fills the fit's problem from the plan (its arrays are borrowed). */
void bat_plan_problem(const bat_plan *plan, bat_local_problem *problem);

#endif
