/* Shapes of the selection that stay shapes: their numbers, and the handles of the one that is selected alone. */
#ifndef BATTEN_EDITOR_EDIT_PRIMITIVES_H
#define BATTEN_EDITOR_EDIT_PRIMITIVES_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include "hands/figures/primitive.h"

/* A new shape in the active layer, with the style of new curves, as an undo step of its own; it alone is selected. BAT_COUNT: it has no
 * width or no height. */
bat_status bat_primitive_commit(bat_context *c, const bat_primitive *primitive, bat_string label);

/* Of the first selected shape that has such a number. False: there is none. */
bool bat_primitives_get(const bat_context *c, bat_primitive_number number, double *value);
/* Of all of them, as one step. BAT_STATE: there are none. */
bat_status bat_primitives_set(bat_context *c, bat_primitive_number number, double value);

/* How all selected parts of ellipses are closed, as one step. BAT_STATE: there are none. */
bat_status bat_primitives_end(bat_context *c, bat_arc_ends ends);
/* Whether one of them is closed in another way. */
bool bat_primitives_are_arcs(const bat_context *c, bat_arc_ends but);

/* The shape that is selected alone, and large enough to be seen for handles to be on it; NULL: there is none. */
const bat_primitive *bat_primitive_held(const bat_context *c);
/* Where the handle of that number is seen, view pixels. False: nowhere. */
bool bat_primitive_grip(const bat_context *c, const bat_primitive *p, bat_primitive_number number,
                        double pixel[2]);

#endif
