/* The side of selected surfaces. */
#ifndef BATTEN_EDITOR_EDIT_FLIP_H
#define BATTEN_EDITOR_EDIT_FLIP_H

#include "editor/session/context.h"

/* Whether something that has sides, a surface or a mesh, is selected. */
bool bat_flip_fits(const bat_context *c);
/* Turns the sides of all of these, as one step. Those made from curves are free then. BAT_STATE: there is none. */
bat_status bat_flip(bat_context *c);

#endif
