/* The radius of a wire by hand: with the select tool the wall of a tube of reach is dragged, at its stops or anywhere else, where
 * it gets another stop. While it is held, this mode is active over the chosen tool. */
#ifndef BATTEN_EDITOR_TOOLS_MODES_REACH_H
#define BATTEN_EDITOR_TOOLS_MODES_REACH_H

#include "editor/session/context.h"
#include "editor/tools/tool.h"
#include "form/wire/stops.h"

typedef struct bat_reaching {
    bool on;
    bat_id wire; /* the object whose curve it is */
    bat_stops stops;
    int stop;      /* the one that is held */
    bool moved;    /* the transaction is open */
    bool due;      /* dragged since the objects were last bound again */
    double before; /* its radius */
} bat_reaching;

/* On pointer down: true when the pointer grabs a tube's wall. */
bool bat_reach_take(bat_context *c, const bat_pointer *event);
void bat_reach_show(const bat_context *c, bat_overlay *overlay);
const bat_tool *bat_tool_reach(void);

#endif
