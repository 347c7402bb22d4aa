/* Inside the sketch hand: third-order Whittaker smoothing of a sequence of points (Whittaker 1923; docs/math
 * sketch 5.2). */
#ifndef BATTEN_HANDS_SKETCH_WHITTAKER_H
#define BATTEN_HANDS_SKETCH_WHITTAKER_H

#include <batten/base.h>

/*
 * z minimises sum weight_i |y_i - z_i|^2 + lambda sum |third difference of z|^2. y, z: count * dimension,
 * weight NULL means 1. Fewer than five points are copied. work: count * 4 doubles. Cost linear.
 */
bat_status bat_whittaker(size_t count, int dimension, const double *y, const double *weight, double lambda,
                         double *work, double *z);

/* Standard deviation of the noise of a coordinate: robust, from differences of orders 3 to 6. work: 2 * count
 * doubles. 0 for fewer than 16 points. */
double bat_noise(size_t count, int dimension, const double *points, double *work);

/* Smooths so that the residual is 0.95 to 1 sigma (root mean square a coordinate). *lambda: what was used. */
bat_status bat_whittaker_sigma(size_t count, int dimension, const double *y, double sigma, double *work,
                               double *z, double *lambda);

#endif
