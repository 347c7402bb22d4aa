/* Property values: numbers within the ranges of the table. */
#include "editor/editor.h"
#include <math.h>

bat_status bat_editor_set(bat_editor *editor, const char *property, double value) {
    bat_property_id id = bat_property_named(property);
    if (id == BAT_PROPERTY_COUNT) return BAT_UNSUPPORTED;
    const bat_property_row *row = bat_property_at(id);
    if (isnan(value)) return BAT_NUMBER;
    if (value < row->low || value > row->high) return BAT_ARGUMENT;
    if (row->type != BAT_PROPERTY_NUMBER && value != floor(value)) return BAT_ARGUMENT;
    editor->values[id] = value;
    return BAT_OK;
}

bat_status bat_editor_get(const bat_editor *editor, const char *property, double *value) {
    bat_property_id id = bat_property_named(property);
    if (id == BAT_PROPERTY_COUNT) return BAT_UNSUPPORTED;
    *value = editor->values[id];
    return BAT_OK;
}
