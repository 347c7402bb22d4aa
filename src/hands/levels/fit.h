/* Inside the levels hand: the least squares of a sketch at a level (math 3.6). */
#ifndef BATTEN_HANDS_LEVELS_FIT_H
#define BATTEN_HANDS_LEVELS_FIT_H

#include "hands/levels/shape.h"

/* bat_shape_sketch; *spans: how many spans of the level the targets cover. */
bat_status bat_level_fit(bat_shape *shape, int level, size_t count, const double *u, const double *targets,
                         double *spans);

#endif
