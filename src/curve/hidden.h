/* Inside the kernel: the knots of a cubic spline that points were sampled from at even parameters. */
#ifndef BATTEN_CURVE_HIDDEN_H
#define BATTEN_CURVE_HIDDEN_H

#include <batten/base.h>

/*
 * The fourth differences of a cubic vanish; around a knot they are its jump of the third derivative times a cubic B-spline.
 * Writes the knots in units of samples, ascending, `count` at most; 0: there are none, or this is no such curve, or it is
 * noisier than `noise`. work: count doubles.
 */
size_t bat_hidden_knots(int dimension, size_t count, const double *points, double noise, double *work,
                        double *knots);

#endif
