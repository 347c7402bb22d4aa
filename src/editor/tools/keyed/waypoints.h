/*
 * Waypoints: the pen of those who hold none. Points are put with Enter and moved with the arrows; a smooth stroke
 * runs through them, and what the tool would make of a pen's stroke it makes of this one: the sketch tool a new
 * curve, a redrawn range or a join, the tangents tool a spline.
 */
#ifndef BATTEN_EDITOR_TOOLS_MODES_WAYPOINTS_H
#define BATTEN_EDITOR_TOOLS_MODES_WAYPOINTS_H

#include "editor/session/context.h"
#include "editor/tools/tool.h"
#include "editor/view/stage.h"

enum { BAT_WAYPOINTS_MAX = 128 };

typedef struct bat_waypoints {
    bool on, due;  /* due: the preview is not of these points, or of another view */
    bat_id object; /* that is redrawn; 0: what the place of the first one means */
    int curve;
    double points[2 * BAT_WAYPOINTS_MAX]; /* document units */
    double leads[4]; /* redrawn: the curve's directions where the stroke begins and ends */
    int count, chosen;
    bat_stage stage; /* that the preview was made in */
    bool *beneath; /* whether the range is on that they redraw: when they are done, it is, too; NULL: none */
} bat_waypoints;

/* The first point, where the pen is or in the middle of the view. BAT_STATE: this tool draws nothing. */
bat_status bat_command_place(bat_context *c, bat_command_id id);
/* Points along the stretch u[0]..u[1] of a curve, which is to be redrawn; the tool is the sketch tool then. *on becomes
 * false when it has been. */
void bat_waypoints_over(bat_context *c, bat_id object, int curve, const double u[2], bool *on);
void bat_waypoints_end(bat_context *c);
/* Lies over the chosen tool while there are waypoints. */
const bat_tool *bat_tool_waypoints(void);
/* Of the tool. */
bat_waypoints *bat_waypoints_of(const bat_context *c);

#endif
