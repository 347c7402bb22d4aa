/* Inside the library: a chain of frames whose steps are short enough. */
#ifndef BATTEN_CURVE_FRAMES_CONVERGED_H
#define BATTEN_CURVE_FRAMES_CONVERGED_H

#include <batten/frames.h>

/* Rotation-minimising frames to 1e-8 radians or better (docs/math/surfaces.md); other rules as they are. Sets
 * options->substeps. */
bat_status bat_frame_chain_converged(const bat_curve *path, bat_frame_options *options,
                                     bat_frame_chain **out);

#endif
