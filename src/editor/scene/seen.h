/* View and scene together: what is seen, and where. */
#ifndef BATTEN_EDITOR_SCENE_SEEN_H
#define BATTEN_EDITOR_SCENE_SEEN_H

#include "editor/scene/scene.h"
#include "editor/session/context.h"

enum { BAT_FIT_MARGIN = 32 };

/* Brings the scene up to date before it is asked something. */
void bat_seen_sync(bat_context *c);
/* Hidden and locked objects, as the last picture had them, are not for tools. */
bool bat_seen_out_of_reach(const bat_context *c, int at);
/* Shows all: one rule for what "all" is. False: nothing to fit to. */
bool bat_seen_fit(bat_context *c);

#endif
