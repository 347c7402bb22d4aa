#ifndef BATTEN_EDITOR_COMMANDS_ARRAY_H
#define BATTEN_EDITOR_COMMANDS_ARRAY_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"

/* A property was set: if it is the array's, the array that is being chosen is shown so. */
void bat_array_follow(bat_context *c, bat_property_id property);

#endif
