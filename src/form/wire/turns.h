/* Parts of angles, many at once. */
#ifndef BATTEN_FORM_WIRE_TURNS_H
#define BATTEN_FORM_WIRE_TURNS_H

#include <stddef.h>

/* For angles from 0 to pi, each given by numbers in the ratio of its sine and cosine, sine[i] >= 0, and parts[i] from 0 to
 * 1: the sine and cosine of parts[i] times the angle, in place, to 4 units in the last place of 1. Where both are 0 the
 * angle counts as 0. Some nanoseconds each: without branches, so that several are computed at once. */
void bat_turns(size_t count, const double *parts, double *sine, double *cosine);

#endif
