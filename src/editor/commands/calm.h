/* Calming: fairs a stretch of a curve, or the selection, without changing the knots. */
#ifndef BATTEN_EDITOR_COMMANDS_CALM_H
#define BATTEN_EDITOR_COMMANDS_CALM_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"

/* While the key is down: shows what would be faired. */
void bat_calm_show(bat_context *c, bat_overlay *overlay);

#endif
