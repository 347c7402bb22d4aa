/* Planes to draw on. */
#ifndef BATTEN_EDITOR_COMMANDS_GROUND_H
#define BATTEN_EDITOR_COMMANDS_GROUND_H

#include "editor/session/context.h"

/* Draws on the plane through origin that is spanned by the axes, x and y: on a plane of the drawing that has them, or on a
 * new one, which is one step. */
bat_status bat_ground_draw_on(bat_context *c, const double origin[3], const double axes[6]);

#endif
