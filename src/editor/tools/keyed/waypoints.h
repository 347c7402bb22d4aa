/*
 * Waypoints: a substitute for the pen. Points are placed with Enter and moved with the arrow keys; a smooth stroke
 * runs through them, and the tool treats it like a pen stroke: the sketch tool makes a new curve, a redrawn range or
 * a join of it, the tangents tool a spline.
 */
#ifndef BATTEN_EDITOR_TOOLS_MODES_WAYPOINTS_H
#define BATTEN_EDITOR_TOOLS_MODES_WAYPOINTS_H

#include "editor/session/context.h"
#include "editor/tools/tool.h"
#include "editor/view/stage.h"

enum { BAT_WAYPOINTS_MAX = 128 };

typedef struct bat_waypoints {
    bool on, due;  /* due: the preview is of other points or another view */
    bat_id object; /* the one being redrawn; 0: depends on where the first point lies */
    int curve;
    double points[2 * BAT_WAYPOINTS_MAX]; /* document units */
    double leads[4]; /* redrawing: directions of the curve where the stroke begins and ends */
    int count, chosen;
    bat_stage stage; /* the view of the preview */
    bool *beneath;   /* the range's `on`, cleared after the redraw; NULL: no range */
} bat_waypoints;

/* Begins with a first point, where the pen is or in the middle of the view. BAT_STATE: this tool does not draw. */
bat_status bat_command_place(bat_context *c, bat_command_id id);
/* Places points along the stretch u[0]..u[1] of a curve, which is to be redrawn; chooses the sketch tool. *on becomes
 * false when the redraw is done. */
void bat_waypoints_over(bat_context *c, bat_id object, int curve, const double u[2], bool *on);
void bat_waypoints_end(bat_context *c);
/* The mode, active over the chosen tool while there are waypoints. */
const bat_tool *bat_tool_waypoints(void);
/* The state of the tool. */
bat_waypoints *bat_waypoints_of(const bat_context *c);

#endif
