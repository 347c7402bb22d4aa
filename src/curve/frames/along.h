/* Inside the library: frames at given parameters, met on a walk. */
#ifndef BATTEN_CURVE_FRAMES_ALONG_H
#define BATTEN_CURVE_FRAMES_ALONG_H

#include "curve/frames/walk.h"

/* Takes the i-th frame. */
typedef void bat_frame_met(void *context, int i, vec t, vec s);
/* Frames at u[0..count), in the order in which the walk meets them (those it does not meet are left out, with
 * all behind them), are told to `met`; lengths (may be NULL) when the walk is measured. Returns how many. */
int bat_frame_walk_along(bat_frame_walk *walk, int count, const double *u, bat_frame_met *met, void *context,
                         double *lengths);

#endif
