/* Rulers along the window's upper and left borders, while the view is not rotated. */
#ifndef BATTEN_EDITOR_SHOW_RULER_H
#define BATTEN_EDITOR_SHOW_RULER_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"

#define BAT_RULER_WIDTH 22.0 /* px */

/* Whether they are shown. */
bool bat_rulers_on(const bat_context *c);
/* The axis whose guides come out of the ruler at the view pixel: 0 left, 1 upper; -1: no ruler there. */
int bat_ruler_at(const bat_context *c, const double pixel[2]);
void bat_rulers_show(const bat_context *c, bat_overlay *overlay);

#endif
