/*
 * What is done with the selection as a whole: each call is one step of the history. The "roots" are the
 * selected objects that are in no selected group; a root stands for all that is in it.
 */
#ifndef BATTEN_EDITOR_EDIT_ARRANGE_H
#define BATTEN_EDITOR_EDIT_ARRANGE_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include <batten/editor.h>

/* Document indices of the roots, ascending; freed by free. BAT_STATE: nothing is selected. */
bat_status bat_arrange_roots(const bat_context *c, int **roots, int *count);
/* The same of all that is in them, but for groups: it may be none. */
bat_status bat_arrange_members(const bat_context *c, int **members, int *count);
/* The box of objects first..end of the document: outlines, exact. False: there are none. */
bool bat_arrange_box(const bat_document *document, int first, int end, double box[4]);
/* The box of the selection. */
bool bat_arrange_selection_box(const bat_context *c, double box[4]);
/* The topmost group below layers, and below the group that was entered, that the object at index is in, or itself:
 * what a click means. */
int bat_arrange_whole(const bat_context *c, int index);
/* It is in the group that was entered, or none was. */
bool bat_arrange_entered(const bat_context *c, int index);
/* One group out, which is selected then; false: none was entered. */
bool bat_arrange_leave(bat_context *c);
/* Where a new object goes: into the active layer (unless it is hidden or locked), in front of all there. Its
 * index; *parent: the layer or 0. */
int bat_arrange_place(const bat_context *c, bat_id *parent);
/* Puts a new object there, within a transaction. */
bat_status bat_arrange_insert(bat_context *c, const bat_object *object);

bat_status bat_arrange_transform(bat_context *c, const double matrix[6], bat_string label);
bat_status bat_arrange_delete(bat_context *c);
/* Copies in front of each root, moved by dx, dy; they are selected then. */
bat_status bat_arrange_duplicate(bat_context *c, double dx, double dy);
/* Begins a transaction with copies that lie where the roots are, and are selected: to be dragged off. On failure the
 * transaction is open still. */
bat_status bat_arrange_lift(bat_context *c);
/* BAT_STATE: less than two roots, a layer among them, or groups would be too deep. */
bat_status bat_arrange_group(bat_context *c);
bat_status bat_arrange_ungroup(bat_context *c); /* BAT_STATE: no group among the roots */

typedef enum bat_order { BAT_ORDER_BACK, BAT_ORDER_BACKWARD, BAT_ORDER_FORWARD, BAT_ORDER_FRONT } bat_order;
/* Among those in the same group. BAT_STATE: they are there already. */
bat_status bat_arrange_order(bat_context *c, bat_order order);

typedef enum bat_align {
    BAT_ALIGN_LEFT,
    BAT_ALIGN_CENTRE,
    BAT_ALIGN_RIGHT,
    BAT_ALIGN_TOP,
    BAT_ALIGN_MIDDLE,
    BAT_ALIGN_BOTTOM
} bat_align;
/* Roots to the box of all; a single one to the page. BAT_STATE: nothing to align to. */
bat_status bat_arrange_align(bat_context *c, bat_align align);
/* Even distances between the middles, along x (0) or y (1); three roots at least. */
bat_status bat_arrange_distribute(bat_context *c, int axis);

#endif
