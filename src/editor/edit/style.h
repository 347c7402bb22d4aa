/* The style that properties show and set: that of the selection if there is one, and that of new curves. */
#ifndef BATTEN_EDITOR_EDIT_STYLE_H
#define BATTEN_EDITOR_EDIT_STYLE_H

#include "editor/edit/dashes.h"
#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include <batten/editor.h>

typedef struct bat_styling {
    bat_property_id property;
    double value;
} bat_styling;

/* The style's value for the property, within its range. */
double bat_styling_value(const bat_style *style, bat_property_id property);
/* Sets the values for new curves, and for everything selected, as one step. Opacity alone is given to a group that is
 * selected, as one picture, and not to each thing in it. */
bat_status bat_styling_set(bat_context *c, int count, const bat_styling *values);
/* The style that new curves get. */
bat_style bat_styling_new(const bat_context *c);
/* The dashes that they get. */
bat_dashing bat_styling_dashes(const bat_context *c);
/* The frontmost selected object, or, for its opacity, the group that is selected as a whole; NULL: nothing is selected. */
const bat_object *bat_styling_selected(const bat_context *c, bat_property_id property);
/* The object's value for the property, within its range. */
double bat_styling_of(const bat_object *object, bat_property_id property);
/* Gives the object's style, with gradients and dashes, to everything selected, as one step, and to new curves. */
bat_status bat_styling_take(bat_context *c, const bat_object *from);
/* Which properties of the style differ among what is selected: a bit for each, in the order of the table. O(selected). */
uint32_t bat_styling_mixed(const bat_context *c);

#endif
