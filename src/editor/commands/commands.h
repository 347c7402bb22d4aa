/* What each row of the table of commands does: all functions of that shape, wherever they stand. */
#ifndef BATTEN_EDITOR_COMMANDS_COMMANDS_H
#define BATTEN_EDITOR_COMMANDS_COMMANDS_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"

typedef bat_status bat_command_function(bat_context *c, bat_command_id id);
typedef bat_status bat_held_function(bat_context *c, bool down);

#define COMMAND(id, name, keys, when, function) bat_command_function function;
#define HELD(id, name, keys, function) bat_held_function function;
#include "editor/tables/commands.def"

#endif
