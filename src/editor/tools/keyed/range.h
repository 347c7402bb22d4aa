/*
 * The range: a stretch of a curve chosen by keys, for those who hold no pen. It lies over whatever tool is chosen and
 * takes the keys; what Enter does with it is the tool's: redraw, fair, rub out.
 */
#ifndef BATTEN_EDITOR_TOOLS_MODES_RANGE_H
#define BATTEN_EDITOR_TOOLS_MODES_RANGE_H

#include "editor/session/context.h"
#include "editor/tools/tool.h"

typedef struct bat_range {
    bool on;
    bat_id object; /* the last one is remembered while it is off; 0: none yet */
    int curve;
    double u[2]; /* ascending; closed curves: u[1] may lie in the next period, at most one further */
    int end;     /* that the keys move */
} bat_range;

/* Begins on the selected curve, else on that nearest to the pen or the middle of the view; where it was before when
 * that is the same curve. BAT_STATE: there is no curve to be seen. */
bat_status bat_command_range(bat_context *c, bat_command_id id);
/* No range, and no waypoints over it. */
void bat_range_end(bat_context *c);
/* The curve it lies on, NULL: it is off, or the curve is gone. */
const bat_curve *bat_range_curve(const bat_context *c);
/* Lies over the chosen tool while the range is on. */
const bat_tool *bat_tool_range(void);
/* Of the tool. */
bat_range *bat_range_of(const bat_context *c);

#endif
