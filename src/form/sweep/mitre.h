/* Internal: what becomes of a sweep's ends where the path has a corner between two straight stretches. They are cut by the plane
 * that halves the corner: x a + y b is longer by a part of the stretch's direction, linear in x and y as it is, and growing
 * along the stretch, so that the swept lines stay the same lines. */
#ifndef BATTEN_FORM_SWEEP_MITRE_H
#define BATTEN_FORM_SWEEP_MITRE_H

#include "base/vec.h"

#include <batten/sweep.h>

struct bat_sweep_jet; /* sweep.h */

/* How much longer x a + y b is at an end of a stretch: along its direction. */
typedef struct bat_mitre {
    vec a, b;
} bat_mitre;

/* A part of the path that is one straight line and ends in a corner, or begins in one. */
typedef struct bat_straight {
    double from, to; /* u */
    vec start, way;  /* where it begins, and its unit direction */
    double length;
    bool soft[2]; /* the path goes on from that end without a corner: what grows there grows smoothly */
    bat_mitre end[2];
} bat_straight;

typedef struct bat_mitres {
    int count;
    bat_straight *lines; /* by u */
    bool seam;           /* of a closed path: it begins in a corner */
    bat_mitre last;      /* then: at the end, where the twist is another */
} bat_mitres;

void bat_mitres_clear(bat_mitres *mitres);
/* Adds what there is to add at u to a, b and their derivatives. O(log stretches). */
void bat_mitres_apply(const bat_sweep *sweep, double u, struct bat_sweep_jet *jet);

#endif
