/* Inside the kernel: the pieces of a spline from whose curve points were taken at parameters that nobody knows. */
#ifndef BATTEN_CURVE_PIECES_H
#define BATTEN_CURVE_PIECES_H

#include <batten/base.h>

typedef struct bat_pieces {
    int degree, dimension; /* degree 2 or more */
    bool closed;           /* the first point follows the last */
    size_t count;
    const double *points;
    double noise; /* how far the points may lie from the pieces */
} bat_pieces;

typedef struct bat_pieced {
    size_t first; /* the sample that comes first in the order of parameters; 0 unless closed */
    double *
        u; /* count of them, ascending, the first sample's first: what the spline's parameters are, but for scale and
                     origin. Open: from 0 on. Closed: the first knot is at 0 */
    double end;    /* open: the last sample's parameter; closed: the period */
    double *knots; /* ascending; closed: the first is 0. Room for count of them */
    size_t found;
} bat_pieced;

/*
 * A piece is a polynomial of the degree; there is one parameter only, but for scale and origin, for which it is that. It
 * is found by least squares across the curve (Gauss-Newton), the longest run of points that lies on one; where two runs
 * meet, the knot is where the pieces differ by c (u - k)^degree, which also gives scale and origin of the second. u and
 * knots are the caller's. False: the points are not such a curve's, or a piece has too few of them (8 of a plane cubic's
 * do). Cost: linear in the points; points of other curves are known by the first pieces.
 */
size_t bat_hidden_pieces_work(size_t count); /* bytes of work */
bool bat_hidden_pieces(const bat_pieces *h, void *work, bat_pieced *out);

#endif
