/* What the pen draws on, shown: the plane in space, and the disc under a hovering pen, tilted as its ground is. */
#ifndef BATTEN_EDITOR_SHOW_DISC_H
#define BATTEN_EDITOR_SHOW_DISC_H

#include "editor/show/overlay.h"
#include "editor/view/stage.h"

/* Shown in a tilted view, and over a ground other than the page; paler where the ground is seen at less than 15
 * degrees, not at all where nothing can be drawn. */
void bat_disc_show(const bat_stage *stage, const double pixel[2], bat_overlay *overlay);

/* A translucent piece of the plane about its origin; nothing on the page. */
void bat_plane_show(const bat_stage *stage, bat_overlay *overlay);

/* A translucent piece of the ruled surface of a curve. */
void bat_ruled_show(const bat_curve *curve, const double along[3], bat_overlay *overlay);

#endif
