/*
 * Gaze handles: at each key of the selected camera a ray with a tick that is up; its end turns the gaze there, with Shift
 * rolls it, with Alt makes the camera look at what the pen is over. A camera that looks at a place has that place as its
 * handle. The edge of the picture at the playhead sets the field of view; a tap on the path adds a key. With the select tool.
 * While one is held, this mode is active over the chosen tool.
 */
#ifndef BATTEN_EDITOR_TOOLS_GAZES_H
#define BATTEN_EDITOR_TOOLS_GAZES_H

#include "editor/tools/gazes/state.h"
#include "editor/tools/tool.h"

/* On pointer down: true when the pointer takes hold of something of the camera. */
bool bat_gazes_take(bat_context *c, const bat_pointer *event);
const bat_tool *bat_tool_gazes(void);

#endif
