/* Internal to surfaces: the representation. Both directions are stored unrolled, as in curves. */
#ifndef BATTEN_FORM_SURFACE_H
#define BATTEN_FORM_SURFACE_H

#include "curve/curve.h"
#include <batten/surface.h>

struct bat_surface {
    bat_curve axis[2]; /* degree, knots and counts of u and v, without points */
    double size;       /* bat_surface_size */
    double *points;    /* axis[0].spread rows of axis[1].spread points */
};

/* Chords nearer to a surface than this are hidden by rounding: 1e-12 of its greatest coordinate. O(points). */
double bat_surface_least_chord(const bat_surface *surface);
/* Allocates one block; the counts are set, the contents of the arrays are not. */
bat_status bat_surface_allocate(const int degree[2], const bool closed[2], const int count[2],
                                bat_surface **out);
/* Checks a filled surface, reading only the user's knots and points, fills in the unrolled rest, and hands the
 * surface over; frees it when it is not valid. */
bat_status bat_surface_finish(bat_surface *surface, bat_surface **out);
/* The user's row i, writable while a surface is being made. */
double *bat_surface_own_row(bat_surface *surface, int i);
/* Stored row i (0 <= i < axis[0].spread) as a curve in space along v, which borrows the surface's arrays. */
bat_curve bat_surface_stored_row(const bat_surface *surface, int i);
/* All rows as one curve along u, whose points are whole stored rows: 3 * axis[1].spread numbers. */
bat_curve bat_surface_whole(const bat_surface *surface);
/* Exchanges u and v; keeps every bit. */
bat_status bat_surface_transpose(const bat_surface *surface, bat_surface **out);

/* What is done to each line of a direction; it gives all of them the same degree and knots. */
typedef bat_status bat_row_operation(const bat_curve *row, int count, const double *numbers, bat_curve **out);
bat_status bat_surface_change(const bat_surface *surface, bat_direction direction, bat_row_operation *how,
                              int count, const double *numbers, bat_surface **out);
/* To a higher degree in a direction; exact. */
bat_status bat_surface_raise(const bat_surface *surface, bat_direction direction, int degree,
                             bat_surface **out);
/* With fewer knots in a direction, `count` control points, as bat_curve_coarsen (hands/levels/shape.h) fits each line. */
bat_status bat_surface_coarsen(const bat_surface *surface, bat_direction direction, int count,
                               bat_surface **out);
/* Removes one copy of the knot v if no row moves by more than allowed[row] (a proven bound); *out stays as it is when
 * one would. *error: the most by which a row moved. */
bat_status bat_surface_drop_knot(const bat_surface *surface, double v, const double *allowed,
                                 bat_surface **out, double *error);

/* Position and derivatives in given spans, as bat_surface_eval gives them; u and v may lie outside the span
 * (the polynomial is extended). */
void bat_surface_eval_spans(const bat_surface *surface, const int span[2], double u, double v, int order,
                            double *out);

#endif
