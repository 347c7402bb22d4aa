/* The tools, each with its state, and which of them is in force. It knows none of them by name. */
#ifndef BATTEN_EDITOR_TOOLS_TOOLBOX_H
#define BATTEN_EDITOR_TOOLS_TOOLBOX_H

#include "editor/tools/tool.h"

enum { BAT_SLOTS = BAT_TOOL_COUNT + BAT_MODE_COUNT };

typedef struct bat_slot {
    const bat_tool *is;
    void *state; /* owned */
} bat_slot;

/* The tools as the table has them, then the modes, the uppermost first. */
typedef struct bat_toolbox {
    bat_slot slots[BAT_SLOTS];
} bat_toolbox;

/* Makes the states. BAT_MEMORY: bat_toolbox_free gives back what there is. */
bat_status bat_toolbox_fill(bat_toolbox *toolbox, const bat_tool *(*const tools[BAT_SLOTS])(void));
void bat_toolbox_free(bat_toolbox *toolbox);
/* Another document is opened: all states begin anew. */
void bat_toolbox_forget(bat_toolbox *toolbox);

/* In force: a mode that is on, else the chosen tool, or the one at the pen's other end. */
const bat_slot *bat_toolbox_tool(const bat_context *c);
/* The chosen tool, whatever lies over it; the first tool with a trait. */
const bat_slot *bat_toolbox_chosen(const bat_context *c);
const bat_slot *bat_toolbox_that(const bat_context *c, unsigned trait);
/* The state of a tool, for its own files. */
void *bat_toolbox_state(const bat_context *c, const bat_tool *tool);
/* Whether the chosen tool has the trait. */
bool bat_toolbox_has(const bat_context *c, unsigned trait);
bool bat_toolbox_busy(
    const bat_context *c); /* the one in force is between down and up, or a panel holds something */
/* What the tool in force is making; all zero: nothing. */
bat_readout bat_toolbox_readout(const bat_context *c);
/* The readings that a tool, chosen or not, offers of the last step (tool.h). */
uint32_t bat_toolbox_readings(const bat_context *c);

void bat_toolbox_choose(bat_context *c, bat_tool_id id);
/* The tool in force lets go of whatever is under way or waits for a yes, and of the pointer. */
void bat_toolbox_leave(bat_context *c);
/* Whatever is under way or waits for a yes is gone; false: nothing was. The second leaves what is chosen. */
bool bat_toolbox_drop(bat_context *c);
bool bat_toolbox_drop_uncommitted(bat_context *c);
/* No mode is on. */
void bat_toolbox_end_modes(bat_context *c);
/* After each event: the tool that was wanted is chosen, and the session knows whether the tool is busy. */
void bat_toolbox_settle(bat_context *c);
/* Ends every contact and whatever the tool has under way. */
void bat_toolbox_interrupt(bat_context *c);

#endif
