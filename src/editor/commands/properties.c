/* Property values: numbers within the ranges of the table. */
#include "editor/tools/span.h"
#include "editor/commands/array.h"
#include "editor/commands/dispatch.h"
#include "editor/commands/offset.h"
#include "editor/commands/tuning.h"
#include "editor/edit/pictures.h"
#include "editor/pick/pivot.h"
#include "editor/session/context.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include "editor/tools/levels/state.h"
#include "editor/tools/tangents/state.h"
#include "editor/tools/tool.h"
#include "editor/edit/style.h"
#include <math.h>

bat_status bat_property_set(bat_context *c, const char *property, double value) {
    bat_property_id id = bat_property_named(property);
    if (id == BAT_PROPERTY_COUNT) return BAT_UNSUPPORTED;
    const bat_property_row *row = bat_property_at(id);
    if (isnan(value)) return BAT_NUMBER;
    if (value < row->low || value > row->high) return BAT_ARGUMENT;
    if (row->type != BAT_PROPERTY_NUMBER && value != floor(value)) return BAT_ARGUMENT;
    if (bat_property_at(id)->group == BAT_GROUP_STYLE) {
        /* Choosing a colour also makes it visible. */
        bat_property_id shown = id == BAT_PROPERTY_STROKE_COLOUR ? BAT_PROPERTY_STROKED
                                : id == BAT_PROPERTY_FILL_COLOUR ? BAT_PROPERTY_FILLED
                                                                 : id;
        bat_styling values[2] = {{id, value}, {shown, 1}};
        return bat_styling_set(c, shown == id ? 1 : 2, values);
    }
    if (id == BAT_PROPERTY_PICTURE_SPAN) return bat_span_set(c, value);
    if (id == BAT_PROPERTY_PICTURE_OPACITY) return bat_tracing_fade(c, value);
    if (id == BAT_PROPERTY_FIRST_HINTS) c->settings->followed = 0;
    c->settings->values[id] = value;
    if (id == BAT_PROPERTY_PERSPECTIVE) bat_perspective_follow(c);
    bat_offset_follow(c, id);
    bat_array_follow(c, id);
    if (id == BAT_PROPERTY_SPLINE_MODE) return bat_splining_set_mode(c, value);
    return bat_property_at(id)->group == BAT_GROUP_LEVELS ? bat_leveling_set(c, id, value) : BAT_OK;
}

bat_status bat_property_get(const bat_context *c, const char *property, double *value) {
    bat_property_id id = bat_property_named(property);
    if (id == BAT_PROPERTY_COUNT) return BAT_UNSUPPORTED;
    const bat_shape *shape = id == BAT_PROPERTY_FRAME_RULE ? bat_leveling_shape(c) : NULL;
    if (shape) {
        *value = (double)bat_shape_options_of(shape)->frame;
        return BAT_OK;
    }
    const bat_object *styled = bat_property_at(id)->group == BAT_GROUP_STYLE ? bat_styling_selected(c, id)
                                                                             : NULL;
    *value = styled                               ? bat_styling_of(styled, id)
             : id == BAT_PROPERTY_SPLINE_MODE     ? (double)bat_splining_mode(c)
             : id == BAT_PROPERTY_PICTURE_SPAN    ? bat_span_value(c)
             : id == BAT_PROPERTY_PICTURE_OPACITY ? bat_tracing_opacity(c)
                                                  : c->settings->values[id];
    return BAT_OK;
}
