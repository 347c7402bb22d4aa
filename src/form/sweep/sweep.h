/* Internal: a sweep, and how its frame runs along the path. */
#ifndef BATTEN_FORM_SWEEP_H
#define BATTEN_FORM_SWEEP_H

#include "base/vec.h"
#include "curve/curve.h"
#include "form/sweep/mitre.h"

#include <batten/sweep.h>

struct bat_sweep {
    bat_curve *path;    /* in space, clamped or with its seam gathered */
    bat_curve *profile; /* x, y */
    bat_frame_chain *chain;
    bat_frame_rule rule;
    bat_function twist, scale; /* with curves of their own */
    double domain[2];          /* of u */
    double turning;            /* by how much the frames turn along the path, per length; 0 on open paths */
    bat_mitres mitres;         /* where the path has corners */
};

/* At u: the path C and its derivative, and the vectors a, b that the profile's x and y go along, with derivatives. */
typedef struct bat_sweep_jet {
    vec c, c1, a, a1, b, b1;
    vec t; /* the tangent; zero where the path stands still */
    double speed;
} bat_sweep_jet;
/* u within the path's domain, both ends included (at the end of a closed path twist and scale are those of the end). */
void bat_sweep_jet_at(const bat_sweep *sweep, double u, bat_sweep_jet *out);

/* bat_sweep_surface with at most this many points along u: BAT_TOLERANCE when that is too few. */
bat_status bat_sweep_surface_within(const bat_sweep *sweep, double tolerance, size_t most, bat_surface **out,
                                    bat_sweep_report *report);

#endif
