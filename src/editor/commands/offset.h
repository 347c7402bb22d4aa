#ifndef BATTEN_EDITOR_COMMANDS_OFFSET_H
#define BATTEN_EDITOR_COMMANDS_OFFSET_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"

/* A property was set: if it is the offset's, the offset that is being chosen is shown so. */
void bat_offset_follow(bat_context *c, bat_property_id property);

#endif
