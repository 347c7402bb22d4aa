/* Inside the library: frames carried along a curve, span by span. The chain, the levels and bulk evaluation
 * are all made of these steps. */
#ifndef BATTEN_CURVE_FRAMES_WALK_H
#define BATTEN_CURVE_FRAMES_WALK_H

#include <batten/frames.h>

#include "curve/piece.h"
#include "base/vec.h"

enum { BAT_FRAME_ROOM = 64 };

/* Three rows of coordinates: x in [0, ROOM), y behind it, then z: loops over them become vector code. */
typedef double bat_rows[3 * BAT_FRAME_ROOM];

static inline vec bat_rows_get(const double *rows, int i) {
    return (vec){rows[i], rows[BAT_FRAME_ROOM + i], rows[2 * BAT_FRAME_ROOM + i]};
}
static inline void bat_rows_put(double *rows, int i, vec v) {
    rows[i] = v.x, rows[BAT_FRAME_ROOM + i] = v.y, rows[2 * BAT_FRAME_ROOM + i] = v.z;
}

/* A span in three coordinates, positions relative to its middle: far from the origin no digits are lost. */
typedef struct bat_frame_span {
    int span, degree;
    double middle, origin[3], c[BAT_DEGREE_MAX + 1][3];
    double slow; /* squared speeds up to this are left to sample_at */
} bat_frame_span;

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
    double u[BAT_FRAME_ROOM], lengths[BAT_FRAME_ROOM];
    bat_rows xs, ts, ss;
} bat_frame_walk;

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
/* Frames at u[0..count), in the order in which the walk meets them (those it does not meet are left out, with
 * all behind them): t, s and, when measured, lengths (may be NULL). Returns how many. */
int bat_frame_walk_along(bat_frame_walk *walk, int count, const double *u, vec *t, vec *s, double *lengths);
/* Where the walk just done brings the frame: s at the start of the span behind it. */
vec bat_frame_walk_end(const bat_frame_walk *walk, vec t);

void bat_frame_span_make(const bat_curve *curve, int span, bat_frame_span *out);
/* t and s at u[0..count) of one span, each one step from its node: from_x, from_t, from_s. xs: positions.
 * False: not possible in this way; use bat_frame_step for each. count is ROOM at most. */
bool bat_frame_steps(const bat_frame_span *piece, int dimension, int count, const double *u,
                     const double *from_x, const double *from_t, const double *from_s, double *xs, double *ts,
                     double *ss);
/* The same for one sample, whatever the curve is like there, and for every rule. out->u tells where. */
void bat_frame_step(const bat_curve *curve, bat_frame_rule rule, const bat_frame_span *piece,
                    const bat_frame_node *from, bool at_end, bat_frame_node *out);
/* Arc length inside a span. */
double bat_frame_length(const bat_frame_span *piece, double a, double b);
/* The least rotation that takes t0 to t1, applied to s. */
vec bat_turn_least(vec s, vec t0, vec t1);
/* s turned about t by an angle. */
static inline vec bat_turn_about(vec s, vec t, double angle) {
    return vec_add(vec_scale(s, bat_cos(angle)), vec_scale(vec_cross(t, s), bat_sin(angle)));
}
/* The angle that closes a loop: of s, transported to the end where the tangent is t, against first_s at first_t;
 * of all that differ by whole turns, the one nearest to `near` (near 0: in (-pi, pi]). */
double bat_frame_holonomy(vec first_t, vec first_s, vec t, vec s, double near);

#endif
