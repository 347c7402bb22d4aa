/* Where two selected surfaces meet, as curves in space. */
#ifndef BATTEN_EDITOR_EDIT_MEETING_H
#define BATTEN_EDITOR_EDIT_MEETING_H

#include "editor/session/context.h"

/* Whether two surfaces are selected, and nothing else. */
bool bat_meet_fits(const bat_context *c);
/* Makes the curves in which they meet, as one step; they are then selected. With `bind` the longest of them alone, and the
 * surface that lies behind the other one in the drawing is bound to it. Tells what there is to be told. */
bat_status bat_meet_make(bat_context *c, bool bind);

#endif
