/* Inside: how long a round handle is. docs/math/tangents.md, math 1.6. */
#ifndef BATTEN_SRC_HANDLE_H
#define BATTEN_SRC_HANDLE_H

#include "base/vec.h"

/* The length of the handle at t0 of a segment that leaves along t0 and arrives along t1, in chords; c: the chord's way.
 * All three are units. That of the handle at its other end has t0 and t1 exchanged. */
double bat_round_handle(vec t0, vec t1, vec c);

#endif
