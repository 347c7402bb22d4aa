/* The functions behind the rows of the table of commands, declared in one place wherever they are defined. */
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
