/* The points tool's state. */
#ifndef BATTEN_EDITOR_TOOLS_POINTS_H
#define BATTEN_EDITOR_TOOLS_POINTS_H

#include "editor/session/context.h"
#include "editor/show/handles.h"

typedef struct bat_pointing {
    bool hovering;
    bat_device device;
    double hover[2]; /* view pixels */
    bat_handle hot;  /* what would be dragged */
    bat_id object;   /* the curve whose points are shown for good; 0: that under the pen */
    int curve;
    bat_id adopted;    /* the selection that has been taken up */
    bat_handle chosen; /* a point or knot of it, or none */
    bat_handle corner; /* the knot that was made a corner last, or none: its points move alone */
    bool measured;     /* with Shift: a stretch of it, from the chosen knot */
    double stretch[2]; /* ascending; closed: the end may lie in the next period */

    /* between down and up */
    bool pressed, dragging, due;
    bat_handle grip;
    double start[2], at[2]; /* view pixels */
    bat_curve *base;        /* the curve as it was when the drag began, owned */

    bool tapped; /* a tap that a second one would make a double one */
    double tap[2], tap_time;
} bat_pointing;

/* The place of the chosen control point or knot; false: none is chosen. Moving it is a step. */
bool bat_pointing_chosen(bat_context *c, double place[2]);
bat_status bat_pointing_shift(bat_context *c, const double delta[2]);
/* Of the tool. */
bat_pointing *bat_pointing_of(const bat_context *c);

#endif
