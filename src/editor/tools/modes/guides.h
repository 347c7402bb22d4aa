/* Guides by hand: dragged out of the rulers, moved with the select tool, dragged back or deleted. While one is held,
 * this tool lies over the chosen one. */
#ifndef BATTEN_EDITOR_TOOLS_MODES_GUIDES_H
#define BATTEN_EDITOR_TOOLS_MODES_GUIDES_H

#include "editor/session/context.h"
#include "editor/tools/tool.h"

typedef struct bat_guiding {
    bool on;   /* one is held */
    bat_id id; /* which; 0: a new one */
    int axis;
    double at;       /* document units, where it would be */
    bool dropping;   /* it would be taken away */
    double start[2]; /* view pixels */
    bool moved;
    bat_id chosen; /* for Delete and numbers; 0: none */
} bat_guiding;

/* The pointer has come down: true when it takes hold of a guide. */
bool bat_guides_take(bat_context *c, const bat_pointer *event);
/* The axis of what the pointer could take hold of where it is, -1: nothing. */
int bat_guides_hot(bat_context *c);
void bat_guides_show(const bat_context *c, bat_overlay *overlay);
/* The chosen guide's document index, -1: none. */
int bat_guide_chosen(const bat_context *c);
/* As a step: the guide (0: a new one) goes there. It is chosen then. */
bat_status bat_guide_put(bat_context *c, bat_id id, int axis, double at);

bat_status bat_command_guide_delete(bat_context *c, bat_command_id id);
bat_status bat_command_guide_level(bat_context *c, bat_command_id id);
bat_status bat_command_guide_upright(bat_context *c, bat_command_id id);
const bat_tool *bat_tool_guides(void);
/* Of the tool. */
bat_guiding *bat_guiding_of(const bat_context *c);

#endif
