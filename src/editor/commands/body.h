#ifndef BATTEN_EDITOR_COMMANDS_BODY_H
#define BATTEN_EDITOR_COMMANDS_BODY_H

#include "editor/session/context.h"

/* Whether a skeleton is selected, alone or with the curve that it can go along. */
bool bat_command_body_path_fits(const bat_context *c);

#endif
