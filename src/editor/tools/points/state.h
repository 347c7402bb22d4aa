/* The points tool's state, and what its files share: points.c (events), and the files named below. */
#ifndef BATTEN_EDITOR_TOOLS_POINTS_STATE_H
#define BATTEN_EDITOR_TOOLS_POINTS_STATE_H

#include "editor/input/double_tap.h"
#include "editor/session/context.h"
#include "editor/show/handles.h"
#include "editor/show/overlay.h"
#include "editor/tables/tables.h"

typedef struct bat_pointing {
    bool hovering;
    bat_device device;
    double hover[2]; /* view pixels */
    bat_handle hot;  /* what a press would drag */
    bat_id object;   /* the curve whose points stay displayed; 0: the one under the pen */
    int curve;
    bat_id adopted;         /* the selection already taken over */
    bat_handle chosen;      /* its chosen point or knot, or none */
    bat_handle corner;      /* the knot last made a corner, or none: its points move alone */
    unsigned char *marks;   /* several points that are chosen: 1 for each of them; owned */
    int marks_size, marked; /* of all points of the curve; how many are chosen, 0: the marks mean nothing */
    bool measured;          /* with Shift: a measured stretch of the curve, from the chosen knot */
    double stretch[2];      /* ascending; closed: the end may lie in the next period */

    /* between down and up */
    bool pressed, dragging, due;
    bool boxing; /* a box is drawn around points of the chosen curve */
    bat_handle grip;
    double start[2], at[2]; /* view pixels */
    bat_curve *base;        /* the curve before the drag, owned */

    bat_double_tap tap;
} bat_pointing;

/* The state of the tool. */
bat_pointing *bat_pointing_of(const bat_context *c);
/* The chosen curve; NULL when there is none or it is gone. */
const bat_curve *bat_pointing_curve(const bat_context *c, const bat_pointing *p);
void bat_pointing_choose_nothing(bat_pointing *p);
void bat_pointing_choose_curve(bat_context *c, bat_pointing *p, bat_id object, int curve);
/* Undo and other commands may have removed what was chosen. */
void bat_pointing_settle(bat_context *c, bat_pointing *p);
/* Position of the chosen control point or knot of a curve of the page; false: none is chosen. */
bool bat_pointing_chosen(bat_context *c, double place[2]);
/* Several control points of the chosen curve: while some are marked, the chosen handle is one of them. */
bool bat_pointing_is_marked(const bat_pointing *p, int index);
void bat_pointing_unmark(bat_pointing *p);
/* Tells of a failure; returns it. */
bat_status bat_pointing_told(bat_context *c, bat_status status);

/* find.c: what a press here would grab: handles of the displayed curve before curves. */
bat_handle bat_pointing_find(bat_context *c, bat_pointing *p, const double pixel[2]);

/* drag.c: whether the control point belongs to a smooth node that is to stay smooth. */
bool bat_pointing_is_tied(const bat_pointing *p, const bat_curve *curve, const bat_handle *handle);
void bat_pointing_begin_drag(bat_context *c, bat_pointing *p);
void bat_pointing_drag(bat_context *c, bat_pointing *p);
void bat_pointing_release(bat_pointing *p);
/* Moves what is chosen, as one step. */
bat_status bat_pointing_shift(bat_context *c, const double delta[2]);
bat_status bat_pointing_nudge(bat_context *c, double x, double y);

/* knots.c: inserts u until its multiplicity is `times` higher; the shape does not change. Chooses the knot. */
bat_status bat_pointing_insert(bat_context *c, bat_pointing *p, const bat_curve *curve, double u, int times,
                               bat_string label);
/* Commands, with what is chosen. */
bat_status bat_pointing_insert_knot(bat_context *c, bat_pointing *p);
bat_status bat_pointing_delete_knot(bat_context *c, bat_pointing *p);
bat_status bat_pointing_make_corner(bat_context *c, bat_pointing *p);
bat_status bat_pointing_smooth_corner(bat_context *c, bat_pointing *p);

/* many.c: several control points of the chosen curve. */
bat_status bat_pointing_toggle(bat_pointing *p, const bat_curve *curve, int index);
/* Those in the box from the press to the pen; adds: beside those that are marked. */
bat_status bat_pointing_mark_box(const bat_context *c, bat_pointing *p, const bat_curve *curve, bool adds);
/* Aligns or distributes them, as one step; nothing else moves. BAT_STATE: too few. */
bat_status bat_pointing_line_up(bat_context *c, bat_pointing *p, bat_command_id id);

/* keys.c, show.c */
bat_status bat_pointing_command(bat_context *c, void *state, bat_command_id id);
void bat_pointing_overlay(bat_context *c, void *state, bat_overlay *list);

#endif
