/* Internal: the nearest point of a triangle. */
#ifndef BATTEN_FORM_COMPARE_TRIANGLE_H
#define BATTEN_FORM_COMPARE_TRIANGLE_H

#include "base/vec.h"

/* The point of a triangle that is closest to p; its corners may coincide or lie on a line. */
vec bat_triangle_nearest(vec a, vec b, vec c, vec p);

#endif
