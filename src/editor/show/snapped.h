/* The grid, and what the last place of a drag snapped to, as pictures. */
#ifndef BATTEN_EDITOR_SHOW_SNAPPED_H
#define BATTEN_EDITOR_SHOW_SNAPPED_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"

/* Marks what was snapped to, with a word. */
void bat_snap_show(const bat_context *c, bat_overlay *overlay);
void bat_grid_show(const bat_context *c, bat_overlay *overlay);

#endif
