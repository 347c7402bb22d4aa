#include "editor/edit/style.h"
#include "editor/edit/arrange.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static double value_of(const bat_style *style, bat_property_id property) {
    switch (property) {
    case BAT_PROPERTY_STROKE_WIDTH: return style->width;
    case BAT_PROPERTY_STROKE_COLOUR: return style->stroke;
    case BAT_PROPERTY_STROKED: return style->stroked;
    case BAT_PROPERTY_FILLED: return style->filled;
    case BAT_PROPERTY_FILL_COLOUR: return style->fill;
    case BAT_PROPERTY_OPACITY: return style->opacity;
    case BAT_PROPERTY_STROKE_CAP: return (double)style->cap;
    default: return (double)style->join;
    }
}

double bat_styling_value(const bat_style *style, bat_property_id property) {
    const bat_property_row *row = bat_property_at(property);
    return fmin(fmax(value_of(style, property), row->low), row->high);
}

static void give(bat_style *style, bat_property_id property, double value) {
    switch (property) {
    case BAT_PROPERTY_STROKE_WIDTH: style->width = value; break;
    case BAT_PROPERTY_STROKE_COLOUR: style->stroke = (uint32_t)value; break;
    case BAT_PROPERTY_STROKED: style->stroked = value != 0; break;
    case BAT_PROPERTY_FILLED: style->filled = value != 0; break;
    case BAT_PROPERTY_FILL_COLOUR: style->fill = (uint32_t)value; break;
    case BAT_PROPERTY_OPACITY: style->opacity = value; break;
    case BAT_PROPERTY_STROKE_CAP: style->cap = (bat_cap)(int)value; break;
    case BAT_PROPERTY_STROKE_JOIN: style->join = (bat_join)(int)value; break;
    default: break;
    }
}

bat_style bat_styling_new(const bat_context *c) {
    bat_style style = bat_style_defaults();
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++)
        if (bat_property_at((bat_property_id)i)->group == BAT_GROUP_STYLE)
            give(&style, (bat_property_id)i, c->settings->values[i]);
    return style;
}

const bat_style *bat_styling_selected(const bat_context *c, bat_property_id property) {
    const bat_document *document = c->session->document;
    const bat_style *found = NULL;
    for (int i = 0; i < bat_document_count(document) && c->choice->selection.count;) {
        int end = i + 1;
        if (bat_selection_has(&c->choice->selection, bat_object_id(bat_document_at(document, i)))) {
            end = bat_document_end(document, i);
            if (property == BAT_PROPERTY_OPACITY) found = bat_object_style(bat_document_at(document, i));
            for (int k = i; k < end && property != BAT_PROPERTY_OPACITY; k++)
                if (!bat_object_is_group(bat_document_at(document, k)))
                    found = bat_object_style(bat_document_at(document, k));
        }
        i = end;
    }
    return found;
}

static bool same_style(const bat_style *a, const bat_style *b) {
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++)
        if (bat_property_at((bat_property_id)i)->group == BAT_GROUP_STYLE &&
            value_of(a, (bat_property_id)i) != value_of(b, (bat_property_id)i))
            return false;
    return true;
}

static bat_status restyle(bat_context *c, int index, int count, const bat_styling *values) {
    const bat_object *object = bat_document_at(c->session->document, index);
    bat_style style = *bat_object_style(object);
    for (int i = 0; i < count; i++) give(&style, values[i].property, values[i].value);
    if (same_style(&style, bat_object_style(object))) return BAT_OK;
    bat_object *after = NULL;
    bat_status status = bat_object_with_style(object, &style, &after);
    if (status == BAT_OK) status = bat_transaction_replace(c, index, after);
    bat_object_release(after);
    return status;
}

bat_status bat_styling_set(bat_context *c, int count, const bat_styling *values) {
    for (int i = 0; i < count; i++) c->settings->values[values[i].property] = values[i].value;
    if (!c->choice->selection.count || c->session->busy || c->session->transaction.open) return BAT_OK;
    int *members, member_count;
    const bool whole = count == 1 && values->property == BAT_PROPERTY_OPACITY;
    bat_status status = whole ? bat_arrange_roots(c, &members, &member_count)
                              : bat_arrange_members(c, &members, &member_count);
    if (status != BAT_OK) return status;
    status = bat_transaction_begin(c);
    for (int i = 0; i < member_count && status == BAT_OK; i++) status = restyle(c, members[i], count, values);
    free(members);
    return bat_transaction_end(c, status, BAT_STRING_STEP_STYLE);
}
