/* Inside the library: frames carried along a curve, span by span. The chain, the levels and bulk evaluation
 * are all made of these steps. */
#ifndef BATTEN_CURVE_FRAMES_WALK_H
#define BATTEN_CURVE_FRAMES_WALK_H

#include <batten/frames.h>

#include "curve/frames/ahead.h"

/* A sample of the curve: where (relative to the span's middle), and the unit tangent; s once it is known. */
typedef struct bat_frame_node {
    double u, length; /* arc length from the start of the walk, when it is asked for */
    int span;
    vec x, t, s;
} bat_frame_node;

/* Walks over spans and stops at the samples of each, a run at a time. */
typedef struct bat_frame_walk {
    const bat_curve *curve;
    bat_frame_rule rule;
    int wanted;      /* least number of steps per span; 0: adaptive */
    bool measured;   /* arc length is */
    int next, left;  /* the span to come (stored index), and how many there are */
    int steps, done; /* of the present span */
    vec t, s;        /* before the run */
    double length;
    bat_frame_span piece;
    /* the run: samples of one span, ascending; the first may be the last of the run before it */
    bool slow; /* of irregular points: one at a time */
    int count;
    int apart; /* samples in the rows that follow */
    const double *u, *xs, *ts, *ss;
    double lengths[BAT_FRAME_ROOM]; /* zero unless measured */
    /* where samples are kept: of spans that are walked alone, and of those side by side */
    double own_u[BAT_FRAME_ROOM];
    bat_rows own_x, own_t, own_s;
    bat_frame_ahead ahead;
} bat_frame_walk;

static inline double bat_frame_walk_u(const bat_frame_walk *walk, int i) { return walk->u[i * walk->apart]; }
/* Sample i of the run, of the rows xs, ts or ss. */
static inline vec bat_frame_walk_get(const bat_frame_walk *walk, const double *rows, int i) {
    return bat_rows_get(rows, i * walk->apart);
}

/* From the start of the stored span `first` over `spans` of them (closed: round and round). t, s: the frame
 * just before. */
void bat_frame_walk_begin(bat_frame_walk *walk, const bat_curve *curve, const bat_frame_options *options,
                          int first, int spans, vec t, vec s);
bool bat_frame_walk_next(bat_frame_walk *walk);
/* The whole curve, from its first frame; measured where the frames of a loop are turned back to close. */
void bat_frame_walk_whole(bat_frame_walk *walk, const bat_curve *curve, const bat_frame_options *options);

/* A tangent at a knot: at the start of a stored span, or at its end. */
vec bat_frame_tangent(const bat_curve *curve, int span, bool at_end);
/* s at the start of the whole curve; of a planar one, to the left. */
vec bat_frame_first(const bat_frame_options *options, int dimension, vec t);
/* Where the walk just done brings the frame: s at the start of the span behind it. */
vec bat_frame_walk_end(const bat_frame_walk *walk, vec t);

/* One step from a node, as bat_frame_steps, whatever the curve is like there, and for every rule. out->u tells where. */
void bat_frame_step(const bat_curve *curve, bat_frame_rule rule, const bat_frame_span *piece,
                    const bat_frame_node *from, bool at_end, bat_frame_node *out);
/* The angle that closes a loop: of s, transported to the end where the tangent is t, against first_s at first_t;
 * of all that differ by whole turns, the one nearest to `near` (near 0: in (-pi, pi]). */
double bat_frame_holonomy(vec first_t, vec first_s, vec t, vec s, double near);

#endif
