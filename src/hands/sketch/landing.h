/* Inside the sketch hand: what a pen draws while it lands and leaves, at less than its pressure. */
#ifndef BATTEN_HANDS_SKETCH_LANDING_H
#define BATTEN_HANDS_SKETCH_LANDING_H

#include "hands/sketch/path.h"

/* How the pen was pressed at each sample, and when (ms; all 0: not known). */
typedef struct bat_press {
    const double *pressure, *time;
    double usual; /* what half of the pressures are below */
} bat_press;

/* How many samples at one end of the stroke are a hook: a short way, at less than the usual pressure, within the first
 * 60 ms, that turns sharply away from what follows. */
size_t bat_landing(const bat_stroke_path *path, const bat_press *press, bool at_end);

/* What was taken away at an end, in the stroke's order, and the length h that tells how the end bends. */
typedef struct bat_landed {
    const double *points;
    size_t count;
    double h;
} bat_landed;

/* As far as that leads on along the stroke, `count` places where the stroke goes on beyond its end, bent as its last 2 h
 * are, in the stroke's order. False: it leads nowhere. path: smooth, of 2 h or more. */
bool bat_lead_on(const bat_stroke_path *path, const bat_landed *landed, bool at_end, double *out);

#endif
