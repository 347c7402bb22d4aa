/*
 * The range: a stretch of a curve chosen by keys, for users without a pen. It is a mode over whichever tool is chosen
 * and takes the keys; what Enter does with it depends on the tool: redraw, fair, erase.
 */
#ifndef BATTEN_EDITOR_TOOLS_MODES_RANGE_H
#define BATTEN_EDITOR_TOOLS_MODES_RANGE_H

#include "editor/session/context.h"
#include "editor/tools/tool.h"

typedef struct bat_range {
    bool on;
    bat_id object; /* remembered while the range is off; 0: none yet */
    int curve;
    double u[2]; /* ascending; closed curves: u[1] may lie in the next period, at most one period on */
    int end;     /* the end that the keys move */
} bat_range;

/* Begins on the selected curve, or else on the one nearest to the pen or the middle of the view; at its earlier place
 * when that is the same curve. BAT_STATE: no curve is visible. */
bat_status bat_command_range(bat_context *c, bat_command_id id);
/* Ends the range, and the waypoints over it. */
void bat_range_end(bat_context *c);
/* The curve it lies on; NULL: it is off, or the curve is gone. */
const bat_curve *bat_range_curve(const bat_context *c);
/* The mode, active over the chosen tool while the range is on. */
const bat_tool *bat_tool_range(void);
/* The state of the tool. */
bat_range *bat_range_of(const bat_context *c);

#endif
