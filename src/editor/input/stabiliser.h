/*
 * The stabiliser: a line that follows the pen as if on a spring. Along the pen's path (arc length s) the line's end b
 * obeys db/ds = (p - b) / reach, solved exactly for each straight piece of the path; so the result depends neither on
 * how many samples, events or frames carry the path nor on its speed. The lag never exceeds `reach`. The line's end
 * always moves towards the pen, so a straight last piece to the pen joins without a kink.
 */
#ifndef BATTEN_EDITOR_INPUT_STABILISER_H
#define BATTEN_EDITOR_INPUT_STABILISER_H

#include <stdbool.h>

typedef struct bat_steady {
    double most, reach;    /* px, at most and now; 0: the line is exactly the pen's path */
    double pen[2], end[2]; /* px: positions of the pen and of the line's end */
} bat_steady;

/* strength: 0 to 10. */
bat_steady bat_steady_begin(double strength, const double at[2]);
/* The reach for what is so large, px: a fiftieth of it at most. extent: it never falls. */
void bat_steady_fit(bat_steady *steady, double extent);
/* The pen has moved to `to`; the line's end follows. */
void bat_steady_move(bat_steady *steady, const double to[2]);
/* At pen-up: moves the line's end by a step of at most a few pixels towards the pen; false: it has arrived. */
bool bat_steady_catch_up(bat_steady *steady);

#endif
