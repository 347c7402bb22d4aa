/* Caps on the open ends of selected surfaces. */
#ifndef BATTEN_EDITOR_EDIT_CAPPING_H
#define BATTEN_EDITOR_EDIT_CAPPING_H

#include "editor/session/context.h"

/* Whether a surface is selected that is closed around and open at an end (form/surface/cap.h). */
bool bat_capping_fits(const bat_context *c);
/* Closes all of these, as one step. Those made from curves are free then. BAT_STATE: there is none. */
bat_status bat_capping(bat_context *c);

#endif
