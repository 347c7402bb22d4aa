#include "editor/edit/style.h"
#include "editor/edit/arrange.h"
#include "editor/edit/dashes.h"
#include "editor/edit/profile.h"
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
    case BAT_PROPERTY_FILL_RULE: return style->even_odd;
    case BAT_PROPERTY_DASHES:
    case BAT_PROPERTY_WIDTHS: return 0; /* of an object: see dashes.h, profile.h */
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
    case BAT_PROPERTY_FILL_RULE: style->even_odd = value != 0; break;
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

bat_dashing bat_styling_dashes(const bat_context *c) {
    return (bat_dashing)(int)c->settings->values[BAT_PROPERTY_DASHES];
}

const bat_object *bat_styling_selected(const bat_context *c, bat_property_id property) {
    const bat_document *document = c->session->document;
    const bat_object *found = NULL;
    for (int i = 0; i < bat_document_count(document) && c->choice->selection.count;) {
        int end = i + 1;
        if (bat_selection_has(&c->choice->selection, bat_object_id(bat_document_at(document, i)))) {
            end = bat_document_end(document, i);
            if (property == BAT_PROPERTY_OPACITY) found = bat_document_at(document, i);
            for (int k = i; k < end && property != BAT_PROPERTY_OPACITY; k++)
                if (!bat_object_is_group(bat_document_at(document, k))) found = bat_document_at(document, k);
        }
        i = end;
    }
    return found;
}

double bat_styling_of(const bat_object *object, bat_property_id property) {
    if (property == BAT_PROPERTY_WIDTHS) return (double)bat_profile_of(object);
    return property == BAT_PROPERTY_DASHES ? (double)bat_dashing_of(object)
                                           : bat_styling_value(bat_object_style(object), property);
}

uint32_t bat_styling_mixed(const bat_context *c) {
    const bat_document *document = c->session->document;
    const bat_object *first[BAT_PROPERTY_COUNT] = {NULL};
    uint32_t mixed = 0;
    for (int i = 0; i < bat_document_count(document) && c->choice->selection.count;) {
        int end = i + 1;
        const bool chosen = bat_selection_has(&c->choice->selection,
                                              bat_object_id(bat_document_at(document, i)));
        if (chosen) end = bat_document_end(document, i);
        for (int k = i; chosen && k < end; k++) {
            const bat_object *object = bat_document_at(document, k);
            for (int n = 0, p = 0; p < BAT_PROPERTY_COUNT; p++) {
                if (bat_property_at((bat_property_id)p)->group != BAT_GROUP_STYLE) continue;
                const bool asked = p == BAT_PROPERTY_OPACITY ? k == i : !bat_object_is_group(object);
                if (asked && !first[p]) first[p] = object;
                if (asked && bat_styling_of(object, (bat_property_id)p) !=
                                 bat_styling_of(first[p], (bat_property_id)p))
                    mixed |= (uint32_t)1 << n;
                n++;
            }
        }
        i = end;
    }
    return mixed;
}

static bool same_style(const bat_style *a, const bat_style *b) {
    for (int i = 0; i < BAT_PROPERTY_COUNT; i++)
        if (bat_property_at((bat_property_id)i)->group == BAT_GROUP_STYLE &&
            value_of(a, (bat_property_id)i) != value_of(b, (bat_property_id)i))
            return false;
    return true;
}

/* The dashes that an object gets: those asked for, or, with another width or other caps, the same by name. */
static bat_dashing dashing_after(const bat_object *object, int count, const bat_styling *values) {
    for (int i = 0; i < count; i++)
        if (values[i].property == BAT_PROPERTY_DASHES) return (bat_dashing)(int)values[i].value;
    return bat_dashing_of(object);
}

/* The profile asked for, or what it has. */
static bat_profile profile_after(const bat_object *object, int count, const bat_styling *values) {
    for (int i = 0; i < count; i++)
        if (values[i].property == BAT_PROPERTY_WIDTHS) return (bat_profile)(int)values[i].value;
    return bat_profile_of(object);
}

/* *object, which is released, with other widths along it. */
static bat_status widen(bat_object **object, bat_profile profile) {
    bat_object *made = NULL;
    if (!bat_object_is_made_of_curves(*object) || bat_profile_of(*object) == profile) return BAT_OK;
    const bat_status status = bat_profile_give(*object, profile, &made);
    if (status != BAT_OK) return status;
    bat_object_release(*object);
    *object = made;
    return BAT_OK;
}

static bat_status restyle(bat_context *c, int index, int count, const bat_styling *values) {
    const bat_object *object = bat_document_at(c->session->document, index);
    bat_style style = *bat_object_style(object);
    const bat_dashing before = bat_dashing_of(object), dashing = dashing_after(object, count, values);
    for (int i = 0; i < count; i++) give(&style, values[i].property, values[i].value);
    const bat_profile profile = profile_after(object, count, values);
    if (same_style(&style, bat_object_style(object)) && before == dashing &&
        profile == bat_profile_of(object))
        return BAT_OK;
    bat_object *after = NULL, *dashed = NULL;
    bat_status status = bat_object_with_style(object, &style, &after);
    if (status == BAT_OK && bat_object_is_made_of_curves(object) && (before || dashing)) {
        status = bat_dashing_give(after, dashing, &dashed);
        bat_object_release(after);
        after = dashed;
    }
    if (status == BAT_OK) status = widen(&after, profile);
    if (status == BAT_OK) status = bat_transaction_replace(c, index, after);
    bat_object_release(after);
    return status;
}

/* Widths along a stroke belong to objects alone, and so do dashes that have no name. */
static bool is_of_objects(const bat_styling *v) {
    return v->property == BAT_PROPERTY_WIDTHS ||
           (v->property == BAT_PROPERTY_DASHES && (int)v->value == BAT_DASHING_OTHER);
}

bat_status bat_styling_set(bat_context *c, int count, const bat_styling *values) {
    for (int i = 0; i < count; i++)
        if (!is_of_objects(&values[i])) c->settings->values[values[i].property] = values[i].value;
    if (count == 1 && is_of_objects(values) && !c->choice->selection.count)
        bat_notice(c, BAT_STRING_NOTICE_SELECT_FIRST);
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
