/*
 * A tool: a small state machine that turns pointer events into edits. One tool a file (tool_<name>.c); its
 * state is a struct in the editor. Every member may be NULL. Tools never see contacts that navigate,
 * predicted samples of others, or bad numbers: events.c keeps those away.
 */
#ifndef BATTEN_EDITOR_TOOLS_TOOL_H
#define BATTEN_EDITOR_TOOLS_TOOL_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include <batten/sketch.h>

/* What a tool is making, for those who show it. */
typedef struct bat_readout {
    const bat_curve *curve;          /* as it would be; NULL: nothing to show */
    const bat_sketch_report *report; /* of its fit; NULL: none */
    bool waits;                      /* it waits for a yes */
} bat_readout;

typedef struct bat_tool {
    void (*hover)(bat_context *c, const bat_pointer *event);
    void (*leave)(bat_context *c);
    void (*down)(bat_context *c, const bat_pointer *event);
    void (*move)(bat_context *c, const bat_pointer *event); /* also predicted samples, flagged */
    void (*up)(bat_context *c, const bat_pointer *event);
    /* Drops whatever is under way, or waits for a yes; true when there was something. Nothing changes. */
    bool (*cancel)(bat_context *c);
    /* Drops what has not been committed, before undo and redo go through the history; NULL: cancel. */
    bool (*undo)(bat_context *c);
    /* Commands of tools (commands.def says which); BAT_STATE: there is nothing to do it to. */
    bat_status (*command)(bat_context *c, bat_command_id id);
    /* Says yes to what waits for it; false when nothing does. */
    bool (*accept)(bat_context *c);
    void (*modifiers)(bat_context *c);  /* c->modifiers has changed */
    bool (*busy)(const bat_context *c); /* between down and up */
    /* Once a frame, before the overlay: the costly part (previews, picking for the highlight). */
    void (*update)(bat_context *c);
    void (*overlay)(bat_context *c, bat_overlay *overlay);
    bat_string (*hint)(const bat_context *c);
    bat_cursor (*cursor)(const bat_context *c);
    void (*readout)(const bat_context *c, bat_readout *out); /* out: all zero before */
    const char *(*check)(const bat_context *c);              /* invariants; NULL when all hold */
} bat_tool;

#define TOOL(id, name, command, behaviour, traits) const bat_tool *behaviour(void);
#include "editor/tables/commands.def"

#endif
