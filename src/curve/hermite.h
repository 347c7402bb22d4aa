/* One cubic with given ends and end directions: its two handle lengths are chosen so that it passes samples near. */
#ifndef BATTEN_SRC_CURVE_HERMITE_H
#define BATTEN_SRC_CURVE_HERMITE_H

#include <batten/curve.h>

typedef struct bat_hermite {
    int dimension;
    double end[2][BAT_DIMENSION_MAX];
    double way[2][BAT_DIMENSION_MAX]; /* unit vectors, both into the piece */
    double length;                    /* of the polyline through end 0, the samples and end 1 */
    size_t count, room;               /* samples */
    double *x;                        /* count * dimension */
    double *along;                    /* where each lies on the polyline, 0..1 */
    double *t, *weight;               /* work: parameters on the cubic, and weights */
} bat_hermite;

/* Makes room for so many samples; false without memory. */
bool bat_hermite_room(bat_hermite *h, size_t count);
void bat_hermite_free(bat_hermite *h);
/* Fills in `length` and `along`. */
void bat_hermite_measure(bat_hermite *h);
/* Least squares across the cubic, samples far away weighted up (Lawson), from several starts, until the greatest
 * distance of a sample is within the tolerance. Returns the least that was found, with its handle lengths. Cost:
 * O(samples) a round, 14 rounds a start at most. */
double bat_hermite_fit(bat_hermite *h, double tolerance, double handle[2]);
/* The four Bézier points. */
void bat_hermite_points(const bat_hermite *h, const double handle[2], double *points);

#endif
