/* Inside the search for pieces: one polynomial that points lie on. */
#ifndef BATTEN_CURVE_PIECES_RUN_H
#define BATTEN_CURVE_PIECES_RUN_H

#include "curve/pieces.h"

enum { BAT_RUN_FREE = BAT_DEGREE_MAX - 1 };
#define BAT_RUN_SURE 1e-3 /* of the noise: a wrong branch is seldom that near */

/* C(v) = start + v way + v (1 - v) sum of part[k] Legendre_k(2 v - 1): first point at 0, last at 1. */
typedef struct bat_run {
    int free, m;
    double off; /* greatest distance of its samples */
    double start[BAT_DIMENSION_MAX], way[BAT_DIMENSION_MAX], part[BAT_RUN_FREE][BAT_DIMENSION_MAX];
} bat_run;

double bat_run_dot(const double *a, const double *b, int m);
double bat_run_apart(const double *a, const double *b, int m);
const double *bat_run_sample(const bat_pieces *h, size_t i); /* after the last the first again */

void bat_run_look(const bat_run *c, double v, double *at, double *slope);
/* The parameter nearest to a point from a guess on; the distance. */
double bat_run_foot(const bat_run *c, const double *x, double *v);
/* A guess for the next point. */
double bat_run_next(const bat_run *c, const double *x, double v);
/* By Householder's reflections; a: rows of columns + 1 numbers, the last is the right-hand side. */
void bat_run_least_squares(double *a, int rows, int columns, double *x);

/* As many samples as a fit needs to be a test. */
size_t bat_run_least(const bat_pieces *h);
/* Between samples range[0] and range[1] - 1, without those beside a knot: a peak tells its place but for a sample or two.
 * beside: the pieces before and after, or NULL. c: kept, if it is nearer (best) than what is found. The distance. */
double bat_run_fit(const bat_pieces *h, const size_t range[2], const bool knots[2],
                   const bat_run *const beside[2], double best, bat_run *c);

#endif
