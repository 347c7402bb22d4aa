/*
 * Operations on the selection as a whole: each call is one undo step. The "roots" are the selected objects that are
 * not inside a selected group; a root stands for everything in it.
 */
#ifndef BATTEN_EDITOR_EDIT_ARRANGE_H
#define BATTEN_EDITOR_EDIT_ARRANGE_H

#include "editor/edit/line_up.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include <batten/editor.h>

/* Document indices of the roots, ascending; release with free. BAT_STATE: nothing is selected. */
bat_status bat_arrange_roots(const bat_context *c, int **roots, int *count);
/* The same for everything in the roots except groups; there may be none. */
bat_status bat_arrange_members(const bat_context *c, int **members, int *count);
/* Those that move with it: its members, and the groups in it that are clipped. */
bat_status bat_arrange_moving(const bat_context *c, int **members, int *count);
/* The exact box of the outlines of objects first to end. False: there are none. */
bool bat_arrange_box(const bat_document *document, int first, int end, double box[4]);
/* The box of the selection. */
bool bat_arrange_selection_box(const bat_context *c, double box[4]);
/* The same in space: low and high x y z. */
bool bat_arrange_selection_space(const bat_context *c, double low[3], double high[3]);
/* The topmost group that contains the object at the index, below layers and below the entered group, or the object
 * itself: what a click selects. */
int bat_arrange_whole(const bat_context *c, int index);
/* Whether the object is in the entered group; true when no group is entered. */
bool bat_arrange_entered(const bat_context *c, int index);
/* Leaves one group, which is then selected; false: no group was entered. */
bool bat_arrange_leave(bat_context *c);
/* Where a new object goes: into the active layer (unless it is hidden or locked), in front of everything there.
 * Returns its index; *parent: the layer or 0. */
int bat_arrange_place(const bat_context *c, bat_id *parent);
/* Inserts a new object there, within a transaction. */
bat_status bat_arrange_insert(bat_context *c, const bat_object *object);

/* It can be repeated then (choice/repetition.h). */
bat_status bat_arrange_transform(bat_context *c, const double matrix[6], bat_string label);
/* The same by three rows of four numbers, as bat_affine_pose takes them, whose status it has, too. Only what stays in the page can
 * be repeated. */
bat_status bat_arrange_pose(bat_context *c, const double rows[12], bat_string label);
bat_status bat_arrange_delete(bat_context *c);
/* Puts a copy in front of each root, mapped by the matrix; the copies are selected then. */
bat_status bat_arrange_duplicate(bat_context *c, const double matrix[6]);
/* Puts so many copies in front of each root, each mapped by its matrix; they are selected then, too. */
bat_status bat_arrange_copies(bat_context *c, int copies, const double (*matrices)[6], bat_string label);
/* Begins a transaction with copies in the places of the roots; these are selected, to be dragged away. On failure the
 * transaction is still open. */
bat_status bat_arrange_lift(bat_context *c);
/* BAT_STATE: fewer than two roots, a layer among them, or groups would be nested too deeply. */
bat_status bat_arrange_group(bat_context *c);
bat_status bat_arrange_ungroup(bat_context *c); /* BAT_STATE: no group among the roots */

typedef enum bat_order { BAT_ORDER_BACK, BAT_ORDER_BACKWARD, BAT_ORDER_FORWARD, BAT_ORDER_FRONT } bat_order;
/* Reorders within the same group. BAT_STATE: they are there already. */
bat_status bat_arrange_order(bat_context *c, bat_order order);

/* Aligns the roots to the box of all, a single one to the page, or makes the distances between three or more equal. BAT_STATE: too
 * few, or nothing to align to. */
bat_status bat_arrange_line_up(bat_context *c, const bat_line_up *how);

#endif
