/* Internal to surfaces: how finely each span is divided for triangles. Every span of a direction has one number of steps,
 * so that the triangles of neighbouring spans meet without cracks. */
#ifndef BATTEN_FORM_STEPS_H
#define BATTEN_FORM_STEPS_H

#include "form/surface/surface.h"

enum { BAT_STEPS_MAX = 1024 }; /* of one span */

typedef struct bat_steps {
    int spans[2]; /* non-empty spans of u and v */
    int *span[2]; /* their stored knot intervals */
    int *count[2];
    double *bend; /* for each pair of spans: bounds on |S_uu|, 2 |S_uv|, |S_vv| with each span as [0, 1] */
} bat_steps;

/* All counts are 1. */
bat_status bat_steps_create(const bat_surface *surface, bat_steps *out);
void bat_steps_clear(bat_steps *steps);
/* The least counts, nearly, with which no triangle is farther from the surface than the tolerance. */
void bat_steps_to_chord(bat_steps *steps, double tolerance);
/* Bound on that distance with the present counts. */
double bat_steps_chord(const bat_steps *steps);
/* Number of triangles, or more where some have no area. */
double bat_steps_triangles(const bat_steps *steps);

#endif
