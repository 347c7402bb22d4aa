/* The axis of symmetry, and the result of a stroke on its other side. */
#ifndef BATTEN_EDITOR_SHOW_AXIS_H
#define BATTEN_EDITOR_SHOW_AXIS_H

#include "curve/mirror.h"
#include "editor/session/context.h"
#include "editor/show/overlay.h"

/* A dashed line across the window, while symmetry is on. */
void bat_axis_show(bat_context *c, bat_overlay *overlay);
/* Shows as ghosts the curve, or when that is NULL the image of `count` points x y. */
void bat_axis_show_ghost(const bat_mirror *mirror, bat_overlay *overlay, size_t count, const double *points,
                         const bat_curve *curve);

#endif
