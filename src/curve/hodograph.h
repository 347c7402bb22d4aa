/* Inside the kernel: the derivative of one span as a polynomial, and arc lengths from it. */
#ifndef BATTEN_CURVE_HODOGRAPH_H
#define BATTEN_CURVE_HODOGRAPH_H

#include "curve/curve.h"

/* C' with respect to u, as a polynomial of the local coordinate of one slot, divided by a power of two that
 * makes its coefficients at most 1: squares neither overflow nor vanish. Lengths taken from it are in units
 * of that scale. */
typedef struct bat_hodograph {
    int terms, dimension;
    double middle, half;
    double scale;
    double density; /* error allowed per unit of u */
    double noise;   /* what the speed may be wrong by, from rounding */
    double c[(BAT_DEGREE_MAX + 1) * BAT_DIMENSION_MAX];
} bat_hodograph;

/* Of the stored span `slot` (0: the first of the domain). density: error allowed per unit of u. */
void bat_hodograph_of(const bat_curve *curve, int slot, double density, bat_hodograph *out);
/* Error allowed per unit of u for a relative error of all, from the length of the control polygon. */
double bat_hodograph_density(const bat_curve *curve, double relative);
/* In units of the scale, here and below. */
double bat_hodograph_speed(const bat_hodograph *h, double u);
/* The length of a..b by eight Gauss-Legendre nodes. */
double bat_hodograph_gauss(const bat_hodograph *h, double a, double b);
/* The same, as precisely as it is asked for. */
double bat_hodograph_length(const bat_hodograph *h, double a, double b, double relative);
/* Where the length from a reaches s, forwards, a <= u <= b; total: the length of a..b. */
double bat_hodograph_at_length(const bat_hodograph *h, double a, double b, double s, double total,
                               double relative);

#endif
