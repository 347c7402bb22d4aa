/* The view of a drawing in space as text, for the host to remember. */
#ifndef BATTEN_EDITOR_PANELS_VIEW_H
#define BATTEN_EDITOR_PANELS_VIEW_H

#include "editor/session/context.h"
#include "editor/view/unit.h"

/* As bat_panel_number: JSON; "" while nothing of the drawing is in space, or while it is seen through a camera. */
const char *bat_view_text(bat_context *c);
/* How the view stands in the room, for the dial: three angles in degrees (editor/view/room.h). */
void bat_view_room_text(const bat_context *c, char out[BAT_UNIT_ROOM]);
/* Goes to such a view, in a window of this size; "": to the one in which the drawing opens, which is the saved one, else from
 * three quarters. BAT_STATE: nothing is in space. BAT_SYNTAX: other text. */
bat_status bat_view_enter(bat_context *c, const char *text);

#endif
