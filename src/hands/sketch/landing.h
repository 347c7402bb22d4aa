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

#endif
