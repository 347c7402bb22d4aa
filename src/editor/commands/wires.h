/* Commands that bind what is selected to wires. */
#ifndef BATTEN_EDITOR_COMMANDS_WIRES_H
#define BATTEN_EDITOR_COMMANDS_WIRES_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"

/* Whether the selection is such that the command has something to do. */
bool bat_wire_command_fits(const bat_context *c, bat_command_id id);

#endif
