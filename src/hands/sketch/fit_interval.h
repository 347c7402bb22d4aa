/* Inside the sketch hand: the constrained least-squares fit of one interval (docs/math sketch 5.7). */
#ifndef BATTEN_HANDS_SKETCH_FIT_INTERVAL_H
#define BATTEN_HANDS_SKETCH_FIT_INTERVAL_H

#include "hands/sketch/machine.h"

typedef struct bat_local_result {
    int interior;   /* knots strictly inside, multiplicity counted (closed: w = 0 is a knot besides) */
    double *knots;  /* owned */
    double *points; /* control points of the interval: interior + p + 1 (closed: interior + 1); owned */
    double max_error;
    int solves;
    bool met;
} bat_local_result;

bat_status bat_local_fit(const bat_local_problem *problem, bat_local_result *out);
void bat_local_result_free(bat_local_result *result);

/* ---- steps of it, each in a file ---- */

/* The greatest weight of the change of curvature that keeps every sample within its limit, on the knots of
 * machine->best. After it the aim of solves is the fair curve. False: none that is greater than the plain penalty's. */
bool bat_fair_find(bat_local_machine *machine, bat_status *status);
/* Few knots for the fair curve, from few upwards, into machine->best; false: not within what is tried. */
bool bat_fair_few(bat_local_machine *machine, bat_status *status);
/* Removes and merges knots of machine->best while every sample stays within its limit. */
bat_status bat_local_reduce(bat_local_machine *machine);

#endif
