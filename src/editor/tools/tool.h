/*
 * A tool: a small state machine that turns pointer events into edits. One tool per file or folder; its state is
 * private: the toolbox allocates it by its size and hands it to each call, and nobody else looks into it. A mode is a
 * tool that is active over the chosen one while it is on. Every member except size may be NULL. Tools never see
 * contacts that navigate, predicted samples of other pointers, or invalid numbers: events.c filters these.
 */
#ifndef BATTEN_EDITOR_TOOLS_TOOL_H
#define BATTEN_EDITOR_TOOLS_TOOL_H

#include "editor/scene/solid.h"
#include "editor/session/context.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"
#include <batten/sketch.h>
#include <batten/tangents.h>

/* What a tool is making, for those parts that display it. */
typedef struct bat_readout {
    const bat_curve *curve;                /* preview; NULL: nothing to show */
    bat_id object;                         /* that it is to replace a curve of; 0: none */
    int number;                            /* of that curve */
    const bat_sketch_report *report;       /* of the curve's fit; NULL: none */
    const struct bat_followers *followers; /* what follows it, as it will be; NULL: none */
    bool waits;                            /* it awaits confirmation */
    bool goes_on;                          /* it is made piece by piece until it is confirmed */
} bat_readout;

/* A stretch of a curve; closed curves: u[1] may lie in the next period. */
typedef struct bat_stretch {
    bat_id object;
    int curve;
    double u[2];
} bat_stretch;

/* A curve and its active level. */
typedef struct bat_focus {
    bat_id object;
    int curve, level;
} bat_focus;

/* A stroke without a pen. */
typedef struct bat_traced {
    size_t count;
    const double *points;     /* x y, document units */
    const bat_spline *spline; /* the spline that they lie on */
    bat_id object;            /* the object being redrawn; 0: depends on where the first point lies */
    int curve;
} bat_traced;

typedef struct bat_tool {
    size_t size; /* of the state, which is zeroed before `begin` */
    void (*begin)(void *state);
    void (*end)(void *state); /* frees what the state owns; also called when another document is opened */
    bool (*on)(const void *state); /* modes: active over the chosen tool now */
    void (*hover)(bat_context *c, void *state, const bat_pointer *event);
    void (*leave)(bat_context *c, void *state);
    void (*down)(bat_context *c, void *state, const bat_pointer *event);
    /* Also called for predicted samples, which are flagged. */
    void (*move)(bat_context *c, void *state, const bat_pointer *event);
    void (*up)(bat_context *c, void *state, const bat_pointer *event);
    /* Drops whatever is under way or awaits confirmation; true when there was something. The document does not
     * change. */
    bool (*cancel)(bat_context *c, void *state);
    /* Drops what has not been committed, before undo or redo steps through the history; NULL: cancel is called. */
    bool (*undo)(bat_context *c, void *state);
    /* Commands for tools (marked in commands.def); BAT_STATE: they have nothing to act on. */
    bat_status (*command)(bat_context *c, void *state, bat_command_id id);
    /* Confirms what awaits confirmation; false when nothing does. */
    bool (*accept)(bat_context *c, void *state);
    void (*modifiers)(bat_context *c, void *state);        /* c->modifiers has changed */
    bool (*busy)(const bat_context *c, const void *state); /* pointer is down */
    /* Whether a panel control is dragging something of the tool, whichever tool is chosen; the second ends that and
     * reverts it. */
    bool (*held_by_panel)(const void *state);
    void (*let_go)(bat_context *c, void *state);
    /* Once per frame, before the overlay: the costly part (previews, picking for the highlight). */
    void (*update)(bat_context *c, void *state);
    void (*overlay)(bat_context *c, void *state, bat_overlay *overlay);
    bat_string (*hint)(const bat_context *c, const void *state);
    /* Where a stroke lands, or would; NULL: on the stage as it is. */
    const struct bat_stage *(*lands)(const bat_context *c, const void *state);
    bat_cursor (*cursor)(const bat_context *c, const void *state);
    /* out: zeroed before the call. */
    void (*readout)(const bat_context *c, const void *state, bat_readout *out);
    /* The surfaces that it makes of objects'; returns how many. */
    int (*guises)(const bat_context *c, const void *state, bat_guise out[BAT_GUISES]);
    /* The number of other readings offered for the last step; 0: it cannot be read otherwise. */
    uint32_t (*readings)(const bat_context *c, const void *state);
    bool (*over)(const bat_context *c, const void *state); /* the pointer is over something of the tool */
    /* Whether a press there would act on something. */
    bool (*hits)(bat_context *c, void *state, const bat_pointer *event);
    /* The chosen stretch; false: none. */
    bool (*stretch)(const bat_context *c, const void *state, bat_stretch *out);
    bool (*focus)(const bat_context *c, const void *state, bat_focus *out); /* the curve it has chosen */
    /* What the tool does, applied to a stretch. */
    bat_status (*work)(bat_context *c, void *state, const bat_stretch *on);
    /* A stroke without a pen: as if the pen went down at the first point and moved through the others; lifted;
     * dropped. */
    bat_status (*trace)(bat_context *c, void *state, const bat_traced *stroke);
    bat_status (*lift)(bat_context *c, void *state, const bat_traced *stroke);
    void (*drop)(bat_context *c, void *state);
    const char *(*check)(const bat_context *c, const void *state); /* invariants; NULL when all hold */
} bat_tool;

#define TOOL(id, name, command, behaviour, traits) const bat_tool *behaviour(void);
#define MODE(id, behaviour) const bat_tool *behaviour(void);
#include "editor/tables/commands.def"

#endif
