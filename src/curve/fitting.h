/* Inside the library: the state of a fit of points, for the files that solve it, refine it and start it. */
#ifndef BATTEN_SRC_CURVE_FITTING_H
#define BATTEN_SRC_CURVE_FITTING_H

#include <batten/fit.h>

#include "curve/curve.h"
#include "curve/lsq.h"

/* Distinct knots of the domain, both ends included; closed: the last is the first, one period on. */
typedef struct bat_fit_mesh {
    int count;
    double *at;
    bool *corner; /* multiplicity degree instead of 1 */
    bool *kept;   /* known to be needed */
    bool *firm;   /* was needed when knots last went, and nothing near has changed since */
} bat_fit_mesh;

/* What a round of removal does with a knot of the accepted mesh. */
enum bat_fit_plan { KEEP, DROP, MERGE /* with the next one, into their middle */ };

typedef struct bat_fitting {
    const bat_fit_options *options;
    int degree, dimension;
    bool closed;
    size_t count;
    double *x, *u, *weight;          /* points, their parameters, half the chords beside them */
    double *near, *distance, *spare; /* of the trial: parameters of the projections, squared distances */
    bat_fit_mesh accepted, trial;
    int room; /* distinct knots at most */
    bat_curve space;
    double *knots, *a, *b, *border, *local, *rank, *soft; /* soft: the ridge's factors */
    double *points;                                       /* of the accepted state */
    void *pieces;                                         /* room to look for them */
    size_t *first, *from;                                 /* samples of the trial's slots and spans */
    bat_lsq_memo memo[2];                                 /* of the last solve, and of the one before */
    bool moved;                                           /* parameters are not those of the last solve */
    int *order, *failing, *samples, *place;
    enum bat_fit_plan *plan;
    double tolerance, worst; /* worst: greatest distance in the accepted state */
    double mu;
    int solves, budget;
    bool plain;            /* pieces are not looked for */
    bool still;            /* the second try: parameters stay until it fits */
    const double *ends[2]; /* the first and the last point as they were given */
    bool fits;             /* the accepted state is within tolerance */
} bat_fitting;

/* ---- fit_solve.c ---- */
/* The unrolled knots of a mesh, as struct bat_curve wants them. */
void bat_fitting_space(bat_fitting *f, const bat_fit_mesh *m);
/* Solves on f->trial and measures; the greatest distance. INFINITY when there is no solution. */
double bat_fitting_attempt(bat_fitting *f);
/* The trial becomes the accepted state; parameters follow when the curve is near enough. */
void bat_fitting_accept(bat_fitting *f, double worst);
/* ---- fit_knots.c ---- */
/* Knots go in until all points are within tolerance, or nothing helps. */
void bat_fitting_grow(bat_fitting *f);
/* The trial gets as many unknowns as there are samples, so that it interpolates; its corners stay. */
void bat_fitting_fill(bat_fitting *f);
/* Knots go out again, as long as the accepted state stays within tolerance. */
void bat_fitting_thin(bat_fitting *f);

#endif
