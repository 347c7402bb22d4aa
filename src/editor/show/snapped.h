/* Display of the grid, and of what the last point of a drag snapped to. */
#ifndef BATTEN_EDITOR_SHOW_SNAPPED_H
#define BATTEN_EDITOR_SHOW_SNAPPED_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"

/* Marks what was snapped to, with a label. */
void bat_snap_show(const bat_context *c, bat_overlay *overlay);
void bat_grid_show(const bat_context *c, bat_overlay *overlay);

#endif
