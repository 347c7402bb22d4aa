#ifndef BATTEN_EDITOR_COMMANDS_OFFSET_H
#define BATTEN_EDITOR_COMMANDS_OFFSET_H

#include "editor/session/context.h"

/* The distance or the side was set: the offset that is being chosen is shown so. */
void bat_offset_follow(bat_context *c);

#endif
