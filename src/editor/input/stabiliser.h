/*
 * The stabiliser: a line that follows the pen on a spring. Along the pen's path (arc length s) the line's end b obeys
 * db/ds = (p - b) / reach, solved exactly for each straight piece of the path; so it does not matter in how
 * many samples, events or frames the same path comes, nor how fast. The lag grows to `reach` and no further.
 * The line's end always moves towards the pen, so a straight last piece to it joins without a kink.
 */
#ifndef BATTEN_EDITOR_INPUT_STABILISER_H
#define BATTEN_EDITOR_INPUT_STABILISER_H

#include <stdbool.h>

typedef struct bat_steady {
    double reach;          /* px; 0: the line is the pen's path, bit for bit */
    double pen[2], end[2]; /* px: where the pen is, and the line's end */
} bat_steady;

/* strength: 0 to 10. */
bat_steady bat_steady_begin(double strength, const double at[2]);
/* The pen has come to `to`; the line's end follows. */
void bat_steady_move(bat_steady *steady, const double to[2]);
/* At pen-up: the line's end goes a step of at most a few pixels towards the pen; false: it is there. */
bool bat_steady_catch_up(bat_steady *steady);

#endif
