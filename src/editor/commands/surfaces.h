/* Surfaces from curves: which of the commands the selection makes possible. */
#ifndef BATTEN_EDITOR_COMMANDS_SURFACES_H
#define BATTEN_EDITOR_COMMANDS_SURFACES_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"

/* id: one of the section SURFACES. O(selected curves, at most BAT_RECIPE_CURVES of them). */
bool bat_surface_command_fits(const bat_context *c, bat_command_id id);

#endif
