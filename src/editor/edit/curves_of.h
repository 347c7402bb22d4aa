/* One changed curve into the document: what most tools end with. */
#ifndef BATTEN_EDITOR_EDIT_CURVES_OF_H
#define BATTEN_EDITOR_EDIT_CURVES_OF_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include <batten/document.h>
#include <batten/editor.h>
#include <batten/levels.h>

/* The curve of that dimension that an edit works on, or NULL when the document has none such; a planar one. */
const bat_curve *bat_edit_target_in(const bat_document *document, int dimension, bat_id object, int curve);
const bat_curve *bat_edit_target(const bat_document *document, bat_id object, int curve);
/* The object without one of its curves; *out NULL when none is left. */
bat_status bat_without_curve(const bat_object *object, int index, bat_object **out);
/* Within a transaction: a new path of one curve, in front within `parent` (0: of all). Takes the curve over, whatever it
 * returns. */
bat_status bat_insert_curve(bat_context *c, bat_id id, const bat_style *style, bat_id parent,
                            bat_curve *curve);
/* Within a transaction: the object's curve `index` becomes `curve`, which is taken over whatever it returns. */
bat_status bat_put_curve(bat_context *c, bat_id object, int index, bat_curve *curve);
/* Within a transaction: the object is without that curve, or gone. */
bat_status bat_remove_curve(bat_context *c, bat_id object, int index);
/* bat_put_curve as one step of its own. */
bat_status bat_commit_curve(bat_context *c, bat_id object, int index, bat_curve *curve, bat_string label);

/* The same with a curve of levels. */
bat_status bat_put_shape(bat_context *c, bat_id object, int index, bat_shape *shape);
bat_status bat_commit_shape(bat_context *c, bat_id object, int index, bat_shape *shape, bat_string label);

#endif
