/* The paint of an object as hosts get it (bat_item). */
#ifndef BATTEN_EDITOR_SCENE_PAINT_H
#define BATTEN_EDITOR_SCENE_PAINT_H

#include <batten/paint.h>

/* NULL: out of memory. The caller frees them. */
float *bat_paint_floats(const bat_paint *paint, const double origin[2], uint32_t *count);
/* At least how much farther a stroke reaches than with a round pen. */
double bat_paint_reach(const bat_paint *paint);

#endif
