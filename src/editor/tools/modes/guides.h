/* Guides by hand: dragged out of the rulers, moved with the select tool, dragged back or deleted. While one is held,
 * this mode is active over the chosen tool. */
#ifndef BATTEN_EDITOR_TOOLS_MODES_GUIDES_H
#define BATTEN_EDITOR_TOOLS_MODES_GUIDES_H

#include "editor/session/context.h"
#include "editor/tools/tool.h"

typedef struct bat_guiding {
    bool on;   /* a guide is held */
    bat_id id; /* its id; 0: a new one */
    int axis;
    double at;       /* document units: its new position */
    bool dropping;   /* releasing it now would remove it */
    double start[2]; /* view pixels */
    bool moved;
    bat_id chosen; /* for Delete and number entry; 0: none */
} bat_guiding;

/* On pointer down: true when the pointer grabs a guide. */
bool bat_guides_take(bat_context *c, const bat_pointer *event);
/* The axis of the guide or ruler that the pointer could grab where it is; -1: nothing. */
int bat_guides_hot(bat_context *c);
void bat_guides_show(const bat_context *c, bat_overlay *overlay);
/* Document index of the chosen guide; -1: none. */
int bat_guide_chosen(const bat_context *c);
/* Puts the guide (0: a new one) there, as one step, and chooses it. */
bat_status bat_guide_put(bat_context *c, bat_id id, int axis, double at);

bat_status bat_command_guide_delete(bat_context *c, bat_command_id id);
bat_status bat_command_guide_level(bat_context *c, bat_command_id id);
bat_status bat_command_guide_upright(bat_context *c, bat_command_id id);
const bat_tool *bat_tool_guides(void);
/* The state of the tool. */
bat_guiding *bat_guiding_of(const bat_context *c);

#endif
