/* Internal: how far along a path one is, and where one is after so far. */
#ifndef BATTEN_FORM_CAMERA_PACE_H
#define BATTEN_FORM_CAMERA_PACE_H

#include "curve/hodograph.h"

/* A piece of a path on which eight Gauss-Legendre nodes give the length to rounding. */
typedef struct bat_pace_cell {
    size_t span; /* whose hodograph */
    double u;    /* where it begins */
} bat_pace_cell;

typedef struct bat_pace {
    size_t spans, count, room;
    bat_hodograph *hodographs;
    bat_pace_cell *cells; /* ascending; one more than there are, for the end */
    double *lengths;      /* from the start to each cell; likewise */
} bat_pace;

/* Clear it whatever happens. */
bat_status bat_pace_make(const bat_curve *path, bat_pace *out);
void bat_pace_clear(bat_pace *pace);
double bat_pace_length(const bat_pace *pace);
/* The parameter at a length from the start, clamped to the path. */
double bat_pace_at(const bat_pace *pace, double length);
/* The length up to a parameter in the domain. */
double bat_pace_until(const bat_pace *pace, double u);

#endif
