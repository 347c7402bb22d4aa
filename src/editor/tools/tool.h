/*
 * A tool: a small state machine that turns pointer events into edits. One tool a file, or a folder; its state is its own:
 * the toolbox allocates it by its size and hands it to each call, and nobody else looks into it. A mode is a tool that
 * lies over the chosen one while it is on. Every member but size may be NULL. Tools never see contacts that navigate,
 * predicted samples of others, or bad numbers: events.c keeps those away.
 */
#ifndef BATTEN_EDITOR_TOOLS_TOOL_H
#define BATTEN_EDITOR_TOOLS_TOOL_H

#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include <batten/sketch.h>
#include <batten/tangents.h>

/* What a tool is making, for those who show it. */
typedef struct bat_readout {
    const bat_curve *curve;          /* as it would be; NULL: nothing to show */
    const bat_sketch_report *report; /* of its fit; NULL: none */
    bool waits;                      /* it waits for a yes */
    bool goes_on;                    /* it is made piece by piece, until a yes ends it */
} bat_readout;

/* A stretch of a curve; closed curves: u[1] may lie in the next period. */
typedef struct bat_stretch {
    bat_id object;
    int curve;
    double u[2];
} bat_stretch;

/* A curve, and the active one of its levels. */
typedef struct bat_focus {
    bat_id object;
    int curve, level;
} bat_focus;

/* A stroke without a pen. */
typedef struct bat_traced {
    size_t count;
    const double *points;     /* x y, document units */
    const bat_spline *spline; /* that they lie on */
    bat_id object;            /* that is redrawn; 0: what the place of the first one means */
    int curve;
} bat_traced;

typedef struct bat_tool {
    size_t size; /* of its state, which is all zero before `begin` */
    void (*begin)(void *state);
    void (*end)(void *state);      /* frees what the state owns: also when another document is opened */
    bool (*on)(const void *state); /* modes: lies over the chosen tool now */
    void (*hover)(bat_context *c, void *state, const bat_pointer *event);
    void (*leave)(bat_context *c, void *state);
    void (*down)(bat_context *c, void *state, const bat_pointer *event);
    void (*move)(bat_context *c, void *state, const bat_pointer *event); /* also predicted samples, flagged */
    void (*up)(bat_context *c, void *state, const bat_pointer *event);
    /* Drops whatever is under way, or waits for a yes; true when there was something. Nothing changes. */
    bool (*cancel)(bat_context *c, void *state);
    /* Drops what has not been committed, before undo and redo go through the history; NULL: cancel. */
    bool (*undo)(bat_context *c, void *state);
    /* Commands of tools (commands.def says which); BAT_STATE: there is nothing to do it to. */
    bat_status (*command)(bat_context *c, void *state, bat_command_id id);
    /* Says yes to what waits for it; false when nothing does. */
    bool (*accept)(bat_context *c, void *state);
    void (*modifiers)(bat_context *c, void *state);        /* c->modifiers has changed */
    bool (*busy)(const bat_context *c, const void *state); /* between down and up */
    /* A panel's hand holds something of it, whichever tool is chosen; and is taken off, what it did taken back. */
    bool (*held_by_panel)(const void *state);
    void (*let_go)(bat_context *c, void *state);
    /* Once a frame, before the overlay: the costly part (previews, picking for the highlight). */
    void (*update)(bat_context *c, void *state);
    void (*overlay)(bat_context *c, void *state, bat_overlay *overlay);
    bat_string (*hint)(const bat_context *c, const void *state);
    bat_cursor (*cursor)(const bat_context *c, const void *state);
    void (*readout)(const bat_context *c, const void *state, bat_readout *out); /* out: all zero before */
    /* The last step can be read as something else: the number of the readings offered; 0: it cannot. */
    uint32_t (*readings)(const bat_context *c, const void *state);
    bool (*over)(const bat_context *c, const void *state); /* the pointer is over something of it */
    bool (*hits)(bat_context *c, void *state,
                 const bat_pointer *event); /* a press there would be on something */
    bool (*stretch)(const bat_context *c, const void *state,
                    bat_stretch *out);                                      /* that is chosen; false: none */
    bool (*focus)(const bat_context *c, const void *state, bat_focus *out); /* the curve that it has chosen */
    bat_status (*work)(bat_context *c, void *state,
                       const bat_stretch *on); /* what the tool does, on a stretch */
    /* A stroke without a pen: as if it came down at the first point and went through the others; lifted; forgotten. */
    bat_status (*trace)(bat_context *c, void *state, const bat_traced *stroke);
    bat_status (*lift)(bat_context *c, void *state, const bat_traced *stroke);
    void (*drop)(bat_context *c, void *state);
    const char *(*check)(const bat_context *c, const void *state); /* invariants; NULL when all hold */
} bat_tool;

#define TOOL(id, name, command, behaviour, traits) const bat_tool *behaviour(void);
#define MODE(id, behaviour) const bat_tool *behaviour(void);
#include "editor/tables/commands.def"

#endif
