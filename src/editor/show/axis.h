/* The axis of symmetry, and what a stroke becomes on its other side. */
#ifndef BATTEN_EDITOR_SHOW_AXIS_H
#define BATTEN_EDITOR_SHOW_AXIS_H

#include "curve/mirror.h"
#include "editor/session/context.h"
#include "editor/show/overlay.h"

/* A dashed line across the window, while symmetry is on. */
void bat_axis_show(bat_context *c, bat_overlay *overlay);
/* The image of x y of so many places, and of a curve (NULL: none), as ghosts. */
void bat_axis_show_image(const bat_mirror *mirror, bat_overlay *overlay, size_t count, const double *points,
                         const bat_curve *curve);

#endif
