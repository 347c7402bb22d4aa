/* Inside the library: a span as frames see it. */
#ifndef BATTEN_CURVE_FRAMES_SPAN_H
#define BATTEN_CURVE_FRAMES_SPAN_H

#include "curve/curve.h"
#include "curve/frames/rows.h"

/* A span in three coordinates, positions relative to its middle: far from the origin no digits are lost. */
typedef struct bat_frame_span {
    int span, degree;
    double middle, origin[3], c[BAT_DEGREE_MAX + 1][3];
    double slow; /* squared speeds up to this are left to bat_frame_step */
} bat_frame_span;

void bat_frame_span_make(const bat_curve *curve, int span, bat_frame_span *out);
/* Positions and unit tangents at u[0..count), count at most ROOM; false where a tangent cannot be found in this way. */
bool bat_frame_span_eval(const bat_frame_span *piece, int count, const double *u, double *xs, double *ts);
/* t and s at u[0..count) of one span, each one step from its node: from_x, from_t, from_s. xs: positions.
 * False: not possible in this way; use bat_frame_step for each. count is ROOM at most. */
bool bat_frame_steps(const bat_frame_span *piece, int dimension, int count, const double *u,
                     const double *from_x, const double *from_t, const double *from_s, double *xs, double *ts,
                     double *ss);
/* s of planar frames: t turned to the left. */
void bat_rows_turn_left(int count, const double *t, double *s);
/* Arc length inside a span. */
double bat_frame_length(const bat_frame_span *piece, double a, double b);

#endif
