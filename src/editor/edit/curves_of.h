/* Putting a changed curve into the document: what most tools end with. */
#ifndef BATTEN_EDITOR_EDIT_CURVES_OF_H
#define BATTEN_EDITOR_EDIT_CURVES_OF_H

#include "editor/edit/dashes.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include "editor/view/ground.h"
#include <batten/document.h>
#include <batten/editor.h>
#include <batten/levels.h>

/* The curve that an edit works on, of the given dimension (0: any) or planar; NULL when the document has no such
 * curve. */
const bat_curve *bat_edit_target_in(const bat_document *document, int dimension, bat_id object, int curve);
const bat_curve *bat_edit_target(const bat_document *document, bat_id object, int curve);
/* The object without one of its curves; *out NULL when none is left. */
bat_status bat_without_curve(const bat_object *object, int index, bat_object **out);
/* Within a transaction, before an object of a new id is drawn on that ground: the plane of a view becomes a plane of a drawing that is flat,
 * whose page so stays the floor that it was in that view. */
bat_status bat_keep_view_plane(bat_context *c, const bat_ground *ground, bat_id drawn);
/* Within a transaction: inserts a new path of one curve, frontmost within `parent` (0: of all). Takes ownership of
 * the curve, whatever it returns. */
bat_status bat_insert_curve(bat_context *c, bat_id id, const bat_style *style, bat_id parent,
                            bat_curve *curve);
/* A new path of one curve in the active layer, with the style of new curves, as an undo step of its own; takes ownership
 * of the curve, whatever it returns. id: gets its number, unless it is NULL. */
/* Gives dashes to an object that was just inserted, within the open transaction. */
bat_status bat_dash_new(bat_context *c, bat_id id, bat_dashing dashes);
bat_status bat_commit_new_curve(bat_context *c, bat_curve *curve, bat_string label, bat_id *id);
/* The same within a transaction, by the number that it gets. */
bat_status bat_put_new_curve(bat_context *c, bat_id id, bat_curve *curve);
/* The same, and it alone is selected. */
bat_status bat_commit_chosen_curve(bat_context *c, bat_curve *curve, bat_string label);
/* Within a transaction: replaces the object's curve `index` by `curve`; takes ownership of it, whatever it returns. */
bat_status bat_put_curve(bat_context *c, bat_id object, int index, bat_curve *curve);
/* Within a transaction: removes that curve from the object, or the object when no curve is left. */
bat_status bat_remove_curve(bat_context *c, bat_id object, int index);
/* bat_put_curve as an undo step of its own. */
bat_status bat_commit_curve(bat_context *c, bat_id object, int index, bat_curve *curve, bat_string label);

/* The same for a curve with levels. */
bat_status bat_put_shape(bat_context *c, bat_id object, int index, bat_shape *shape);
bat_status bat_commit_shape(bat_context *c, bat_id object, int index, bat_shape *shape, bat_string label);

#endif
