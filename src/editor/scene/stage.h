/* View and scene together: what is seen, and where. */
#ifndef BATTEN_EDITOR_SCENE_STAGE_H
#define BATTEN_EDITOR_SCENE_STAGE_H

#include "editor/scene/scene.h"
#include "editor/session/context.h"

enum { BAT_FIT_MARGIN = 32 };

/* Brings the scene up to date before it is asked something. */
void bat_stage_sync(bat_context *c);
/* Hidden and locked objects, as the last picture had them, are not for tools. */
bool bat_stage_out_of_reach(const bat_context *c, int at);
/* Shows all: one rule for what "all" is. False: nothing to fit to. */
bool bat_stage_fit(bat_context *c);

#endif
