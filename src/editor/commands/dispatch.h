/* Commands and properties by id and by name. */
#ifndef BATTEN_EDITOR_COMMANDS_DISPATCH_H
#define BATTEN_EDITOR_COMMANDS_DISPATCH_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"

/* Whether the view is one in which it works: most change the page, and work face-on. */
bool bat_command_faces(const bat_context *c, bat_command_id id);
bat_status bat_command_run(bat_context *c, bat_command_id id, bool down);
/* See the calls of the same names in the public header. */
bat_status bat_command_do(bat_context *c, const char *name);
bat_status bat_command_bind(bat_context *c, const char *command, const char *keys);
bat_status bat_property_set(bat_context *c, const char *property, double value);
bat_status bat_property_get(const bat_context *c, const char *property, double *value);
/* Undoes or redoes steps until so many of the history are done. BAT_ARGUMENT: it has not so many. */
bat_status bat_history_go(bat_context *c, int done);
bat_status bat_layer_place(bat_context *c, bat_id id, bat_id target);
bat_status bat_layer_activate(bat_context *c, bat_id id);
bat_status bat_layer_rename(bat_context *c, bat_id id, const char *name);
bat_status bat_layer_set_state(bat_context *c, bat_id id, bool hidden, bool locked);
bat_status bat_choice_select(bat_context *c, bat_id id, bool add);

#endif
