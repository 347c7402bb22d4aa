/* Pieces of curves as Bézier segments, which are halved until what is asked of them is plain. */
#ifndef BATTEN_SRC_RELATE_SEGMENT_H
#define BATTEN_SRC_RELATE_SEGMENT_H

#include <batten/curve.h>

typedef struct bat_segment {
    int degree, size;                                   /* size: numbers of a point */
    double from, to;                                    /* parameters of its ends on the curve */
    double b[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX]; /* degree + 1 points */
} bat_segment;

/* The greatest coordinate of its control points: what is nearer than some of its last digits is hidden by rounding. */
double bat_segments_reach_of(const bat_curve *curve);
/* The gap below which rounding hides whether points of the curve are the same: 64 epsilons of that. */
double bat_segments_hidden(const bat_curve *curve);
/* Whether rounding hides a tolerance, which is below that, and the curve is not straight anyway. */
bool bat_segments_hide(const bat_curve *curve, double tolerance);
/* The spans of a curve; *out is the caller's (free). */
bat_status bat_segments_of(const bat_curve *curve, int *count, bat_segment **out);
void bat_segment_halve(const bat_segment *s, bat_segment *left, bat_segment *right);
/* The piece between x0 and x1 of it, 0 to 1. */
void bat_segment_part(const bat_segment *s, double x0, double x1, bat_segment *out);
/* Exact, to a degree not below its own. */
void bat_segment_raise(bat_segment *s, int degree);
/* The greatest distance from its first point that a control point has: no point of it is further away. */
double bat_segment_reach(const bat_segment *s);
/* No point of it is further from its chord than this: Wang's bound by second differences, or the hull's. */
double bat_segment_bulge(const bat_segment *s);
/* No tangent is further than *half, in radians, from the unit axis[size]; a full turn where no axis is known, 0 where the
 * segment is a point. */
void bat_segment_cone(const bat_segment *s, double *axis, double *half);
/* Whether the hulls of two segments are more than `gap` apart along one of the axes that are tried: those of the
 * coordinates, and across the chords. */
bool bat_segments_apart(const bat_segment *a, const bat_segment *b, double gap);

#endif
