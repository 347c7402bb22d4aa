/* The tools with their states, and which of them is in force. It knows none of them by name. */
#ifndef BATTEN_EDITOR_TOOLS_TOOLBOX_H
#define BATTEN_EDITOR_TOOLS_TOOLBOX_H

#include "editor/tools/tool.h"

enum { BAT_SLOTS = BAT_TOOL_COUNT + BAT_MODE_COUNT };

typedef struct bat_slot {
    const bat_tool *is;
    void *state; /* owned */
} bat_slot;

/* The tools in the order of the table, then the modes, topmost first. */
typedef struct bat_toolbox {
    bat_slot slots[BAT_SLOTS];
} bat_toolbox;

/* Allocates the states. BAT_MEMORY: bat_toolbox_free releases those that exist. */
bat_status bat_toolbox_fill(bat_toolbox *toolbox, const bat_tool *(*const tools[BAT_SLOTS])(void));
void bat_toolbox_free(bat_toolbox *toolbox);
/* Another document is opened: all states start anew. */
void bat_toolbox_forget(bat_toolbox *toolbox);

/* The tool in force: a mode that is on, else the chosen tool, or the one for the pen's eraser end or barrel button. */
const bat_slot *bat_toolbox_tool(const bat_context *c);
/* What the tool in force does at this command. BAT_STATE: nothing. */
bat_status bat_toolbox_command(bat_context *c, bat_command_id id);
/* The chosen tool, whatever mode is active over it; the first tool with a trait. */
const bat_slot *bat_toolbox_chosen(const bat_context *c);
const bat_slot *bat_toolbox_that(const bat_context *c, unsigned trait);
/* The state of a tool, for its own files. */
void *bat_toolbox_state(const bat_context *c, const bat_tool *tool);
/* Whether the chosen tool has the trait. */
bool bat_toolbox_has(const bat_context *c, unsigned trait);
/* Whether the tool in force can work in the view as it is. */
bool bat_toolbox_faces(const bat_context *c);
/* The tool in force has the pointer down, or a panel control is being dragged. */
bool bat_toolbox_busy(const bat_context *c);
/* What the tool in force is making; all zero: nothing. */
bat_readout bat_toolbox_readout(const bat_context *c);
/* The number of readings that a tool, chosen or not, offers for the last step (tool.h). */
uint32_t bat_toolbox_readings(const bat_context *c);

void bat_toolbox_choose(bat_context *c, bat_tool_id id);
/* The tool in force drops whatever is under way or awaits confirmation, and releases the pointer. */
void bat_toolbox_leave(bat_context *c);
/* Drops whatever is under way or awaits confirmation; false: there was nothing. The second keeps what is chosen. */
bool bat_toolbox_drop(bat_context *c);
bool bat_toolbox_drop_uncommitted(bat_context *c);
/* Turns all modes off. */
void bat_toolbox_end_modes(bat_context *c);
/* After each event: chooses the tool that was requested, and tells the session whether the tool is busy. */
void bat_toolbox_settle(bat_context *c);
/* Ends every contact and whatever the tool has under way. */
void bat_toolbox_interrupt(bat_context *c);

#endif
