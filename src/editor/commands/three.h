/* A plane through three points that are picked one after the other. */
#ifndef BATTEN_EDITOR_COMMANDS_THREE_H
#define BATTEN_EDITOR_COMMANDS_THREE_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"

/* Picks what is seen at the pixel: a point of a curve, else of a surface, else of the ground. With the third the plane is
 * made. False: no points are being picked. */
bool bat_three_pick(bat_context *c, const double pixel[2]);
/* Picks no more; false: none were being picked. */
bool bat_three_cancel(bat_context *c);
/* Marks the points picked so far. */
void bat_three_show(const bat_context *c, bat_overlay *overlay);

#endif
