/* Inside the sketch hand: a curve tabulated by arc length, so that lengths and parameters convert quickly. */
#ifndef BATTEN_HANDS_SKETCH_TRACK_H
#define BATTEN_HANDS_SKETCH_TRACK_H

#include "curve/curve.h"

typedef struct bat_stroke_track {
    const bat_curve *curve; /* borrowed */
    int count;              /* nodes; the first and last are the ends of the domain */
    double *u, *s, *speed;  /* parameter, arc length, |C'|; one block, owned */
    double *points;
    double length;
    double start, end; /* domain */
    double mean;       /* mean speed, length / (end - start); 0 for a curve that is a point */
} bat_stroke_track;

/* 2 p + 2 nodes a span; lengths by Simpson's rule between them (relative error some 1e-5). Linear cost. */
bat_status bat_track_create(const bat_curve *curve, bat_stroke_track *out);
void bat_track_free(bat_stroke_track *track);
/* Inverse of each other to some 1e-4 of a node's interval, both monotone with continuous slope; open curves
 * clamp, closed ones go on into other periods. */
double bat_track_s(const bat_stroke_track *track, double u);
double bat_track_u(const bat_stroke_track *track, double s);
/* Point of the table's polyline at arc length s. */
void bat_stroke_track_point(const bat_stroke_track *track, double s, double *point);
/* Unit tangent at u; a zero-speed point borrows from its neighbourhood. */
void bat_track_tangent(const bat_stroke_track *track, double u, double *tangent);

typedef struct bat_track_near {
    double s, distance;
} bat_track_near;
/* Local minima of distance, nearest first, at most `room`; those beyond twice the nearest plus slack are left
 * out. At least one is found. */
int bat_track_candidates(const bat_stroke_track *track, const double *point, double slack, int room,
                         bat_track_near *out);

#endif
