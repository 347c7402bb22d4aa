/* The paint of an object as hosts get it (bat_item). */
#ifndef BATTEN_EDITOR_SCENE_PAINT_H
#define BATTEN_EDITOR_SCENE_PAINT_H

#include <batten/frame.h>
#include <batten/paint.h>

/* NULL: out of memory. The caller frees them. */
float *bat_paint_floats(const bat_paint *paint, const double origin[2], uint32_t *count);
/* At least how far a stroke reaches beyond its curve. paint: NULL: as the style is. */
double bat_paint_reach(const bat_style *style, const bat_paint *paint);
/* What of an item a style says, but for its flags. */
void bat_paint_style(const bat_style *style, bat_item *item);

#endif
