/* Internal: where a path has corners, and how a sweep is cut there. */
#ifndef BATTEN_FORM_SWEEP_MITRE_MAKE_H
#define BATTEN_FORM_SWEEP_MITRE_MAKE_H

#include "form/sweep/sweep.h"

/* The stretches of the sweep's path, which has everything else. Frames that are fixed need no mitres: nothing turns there.
 * BAT_UNSUPPORTED: a corner is not between two straight stretches, the path turns back in it, or the frames are Frenet's, which
 * have no place there. O(spans). */
bat_status bat_mitres_create(bat_sweep *sweep);

#endif
