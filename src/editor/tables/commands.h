/* What each row of the table of commands does: all functions of that shape, wherever they stand. */
#ifndef BATTEN_EDITOR_TABLES_COMMANDS_H
#define BATTEN_EDITOR_TABLES_COMMANDS_H

#include "editor/tables/tables.h"

struct bat_context;
typedef bat_status bat_command_function(struct bat_context *c, bat_command_id id);
typedef bat_status bat_held_function(struct bat_context *c, bool down);

#define COMMAND(id, name, keys, when, function) bat_command_function function;
#define HELD(id, name, keys, function) bat_held_function function;
#include "editor/tables/commands.def"

#endif
