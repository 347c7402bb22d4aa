/* Inside the library: how precise a chain of frames is. */
#ifndef BATTEN_CURVE_FRAMES_H
#define BATTEN_CURVE_FRAMES_H

#include <batten/frames.h>

/* How far a chain with an even number of substeps is from one with half as many, in radians, at all of its frames, before those of a loop
 * are turned back to close it. O(nodes), without their memory. */
bat_status bat_frame_chain_error(const bat_frame_chain *chain, double *out);

#endif
