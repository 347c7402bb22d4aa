/* The style that properties show and set: of the selection when there is one, and of new curves. */
#ifndef BATTEN_EDITOR_EDIT_STYLE_H
#define BATTEN_EDITOR_EDIT_STYLE_H

#include "editor/session/context.h"
#include "editor/tables/tables.h"
#include <batten/editor.h>

typedef struct bat_styling {
    bat_property_id property;
    double value;
} bat_styling;

/* What the style has for the property, within its range. */
double bat_styling_value(const bat_style *style, bat_property_id property);
/* Sets the values for new curves, and gives them to all that is selected, as one step. */
bat_status bat_styling_set(bat_context *c, int count, const bat_styling *values);
/* The style that new curves get. */
bat_style bat_styling_new(const bat_context *c);
/* The style of what is selected in front; NULL: nothing is selected. */
const bat_style *bat_styling_selected(const bat_context *c);

#endif
