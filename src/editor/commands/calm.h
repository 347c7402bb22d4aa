/* Calming: a stretch of a curve, or what is selected, is faired with the knots there are. */
#ifndef BATTEN_EDITOR_COMMANDS_CALM_H
#define BATTEN_EDITOR_COMMANDS_CALM_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"

/* While the key is down: what would be calmed. */
void bat_calm_show(bat_context *c, bat_overlay *overlay);

#endif
