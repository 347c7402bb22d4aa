/* Inside the kernel: the knots of a spline that points were sampled from at even parameters. */
#ifndef BATTEN_CURVE_HIDDEN_H
#define BATTEN_CURVE_HIDDEN_H

#include <batten/base.h>

typedef struct bat_hidden {
    int degree, dimension;
    bool closed; /* the first point follows the last */
    size_t count,
        stride; /* stride: between the samples that are compared; 1 is finest, more hears weaker knots */
    const double *points;
} bat_hidden;

/*
 * The differences of order degree + 1 vanish; around a knot they are its jump of the highest derivative times a B-spline.
 * Writes the knots in units of samples, ascending, `count` at most; closed: they may begin anywhere, and span less than
 * a period. False: this is no such curve, or it is noisier than `noise`. work: count doubles.
 */
bool bat_hidden_knots(const bat_hidden *h, double noise, double *work, double *knots, size_t *found);

#endif
