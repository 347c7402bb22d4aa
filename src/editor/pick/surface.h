/* The surface that is seen at a place. */
#ifndef BATTEN_EDITOR_PICK_SURFACE_H
#define BATTEN_EDITOR_PICK_SURFACE_H

#include "editor/session/context.h"

/* Of all that can be reached, the one nearest to the eye under a pixel; NULL: none. */
const bat_object *bat_pick_surface(bat_context *c, const double pixel[2]);
/* Makes an object the ground, and says so; NULL: the page. False: it cannot be drawn on. */
bool bat_ground_take(bat_context *c, const bat_object *object);

#endif
