/* The side of selected surfaces. */
#ifndef BATTEN_EDITOR_EDIT_FLIP_H
#define BATTEN_EDITOR_EDIT_FLIP_H

#include "editor/session/context.h"

/* Whether a surface without levels, and bound to no wire, is selected. */
bool bat_flip_fits(const bat_context *c);
/* Turns the side of all of these, as one step: u and v change places. Those made from curves are free then. BAT_STATE: there is none. */
bat_status bat_flip(bat_context *c);

#endif
