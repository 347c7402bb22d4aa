/* The tools, each with its state, and which of them is in force. */
#ifndef BATTEN_EDITOR_TOOLS_TOOLBOX_H
#define BATTEN_EDITOR_TOOLS_TOOLBOX_H

#include "editor/choice/choice.h"
#include "editor/edit/pictures.h"
#include "editor/session/context.h"
#include "editor/tools/brushing.h"
#include "editor/tools/levels/state.h"
#include "editor/tools/modes/guides.h"
#include "editor/tools/modes/range.h"
#include "editor/tools/modes/waypoints.h"
#include "editor/tools/pointing.h"
#include "editor/tools/selecting.h"
#include "editor/tools/sketch/sketching.h"
#include "editor/tools/tangents/state.h"
#include "editor/tools/tool.h"

/* The zoom tool between down and up; view pixels. */
typedef struct bat_zooming {
    bool down;
    double start[2], at[2];
} bat_zooming;

typedef struct bat_toolbox {
    bat_sketching sketching;
    bat_splining splining;
    bat_leveling leveling;
    bat_pointing pointing;
    bat_brushing brushing;
    bat_zooming zooming;
    bat_selecting selecting;
    bat_spanning spanning;
    bat_range range; /* these two lie over the chosen tool while they are on */
    bat_waypoints waypoints;
    bat_guiding guiding; /* this one too */
} bat_toolbox;

void bat_toolbox_init(bat_toolbox *toolbox);
void bat_toolbox_free(bat_toolbox *toolbox);
/* Another document is opened. */
void bat_toolbox_forget(bat_toolbox *toolbox);
/* The tool in force. */
const bat_tool *bat_toolbox_tool(const bat_context *c);
bool bat_toolbox_busy(const bat_context *c); /* it is between down and up */
/* What the tool in force is making; all zero: nothing. */
bat_readout bat_toolbox_readout(const bat_context *c);
/* Whether the chosen tool has the trait. */
bool bat_toolbox_has(const bat_context *c, unsigned trait);
void bat_toolbox_choose(bat_context *c, bat_tool_id id);
/* Whatever is under way or waits for a yes is gone; false: nothing was. The second leaves what is chosen. */
bool bat_toolbox_drop(bat_context *c);
bool bat_toolbox_drop_uncommitted(bat_context *c);
/* After each event: the tool that was wanted is chosen, and the session knows whether the tool is busy. */
void bat_toolbox_settle(bat_context *c);
/* Ends every contact and whatever the tool has under way. */
void bat_toolbox_interrupt(bat_context *c);

#endif
