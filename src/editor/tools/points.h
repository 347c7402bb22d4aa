/* The points tool's state. */
#ifndef BATTEN_EDITOR_TOOLS_POINTS_H
#define BATTEN_EDITOR_TOOLS_POINTS_H

#include "editor/session/context.h"
#include "editor/show/handles.h"

typedef struct bat_pointing {
    bool hovering;
    bat_device device;
    double hover[2]; /* view pixels */
    bat_handle hot;  /* what a press would drag */
    bat_id object;   /* the curve whose points stay displayed; 0: the one under the pen */
    int curve;
    bat_id adopted;    /* the selection already taken over */
    bat_handle chosen; /* its chosen point or knot, or none */
    bat_handle corner; /* the knot last made a corner, or none: its points move alone */
    bool measured;     /* with Shift: a measured stretch of the curve, from the chosen knot */
    double stretch[2]; /* ascending; closed: the end may lie in the next period */

    /* between down and up */
    bool pressed, dragging, due;
    bat_handle grip;
    double start[2], at[2]; /* view pixels */
    bat_curve *base;        /* the curve before the drag, owned */

    bool tapped; /* a second tap now would make a double tap */
    double tap[2], tap_time;
} bat_pointing;

/* Position of the chosen control point or knot; false: none is chosen. Moving it is one step. */
bool bat_pointing_chosen(bat_context *c, double place[2]);
bat_status bat_pointing_shift(bat_context *c, const double delta[2]);
/* The state of the tool. */
bat_pointing *bat_pointing_of(const bat_context *c);

#endif
