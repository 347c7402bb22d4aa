/* Corrections of a move, made in the picture that its camera sees. */
#ifndef BATTEN_EDITOR_TOOLS_GAZES_CORRECT_H
#define BATTEN_EDITOR_TOOLS_GAZES_CORRECT_H

#include "editor/session/context.h"

#include <batten/panels.h>

/* See the call of the same name in the public header. */
bat_status bat_correct(bat_context *c, bat_correction kind, const double size[2], const double from[2],
                       const double to[2], bool done);

#endif
