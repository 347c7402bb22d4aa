/* Commands that select what looks like what is selected. */
#include "document/document.h"
#include "document/kind.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/dashes.h"
#include "editor/edit/style.h"
#include "editor/scene/seen.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/tables/commands.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"
#include "editor/tools/toolbox.h"

#include <batten/paint.h>

#include <stdio.h>
#include <string.h>

/* Gradients are compared as far as one look goes: whether there is one, and its first colours. */
static bool same_gradient(const bat_gradient *a, const bat_gradient *b) {
    if (a->count != b->count) return false;
    if (a->count == 0 || !a->stops || !b->stops) return true;
    if (a->radial != b->radial) return false;
    for (size_t i = 0; i < a->count; i++)
        if (a->stops[i].colour != b->stops[i].colour) return false;
    return true;
}

static bat_paint paint_of(const bat_object *object) {
    const bat_paint *paint = bat_object_paint(object);
    return paint ? *paint : (bat_paint){0};
}

static bool same_stroke(const bat_object *a, const bat_object *b) {
    const bat_style *x = bat_object_style(a), *y = bat_object_style(b);
    const bat_paint p = paint_of(a), q = paint_of(b);
    if (x->stroked != y->stroked) return false;
    return !x->stroked || (x->stroke == y->stroke && x->width == y->width &&
                           same_gradient(&p.stroke, &q.stroke) && bat_dashing_of(a) == bat_dashing_of(b));
}

static bool same_fill(const bat_object *a, const bat_object *b) {
    const bat_style *x = bat_object_style(a), *y = bat_object_style(b);
    const bat_paint p = paint_of(a), q = paint_of(b);
    if (x->filled != y->filled) return false;
    return !x->filled || (x->fill == y->fill && same_gradient(&p.fill, &q.fill));
}

static bool same_width(const bat_object *a, const bat_object *b) {
    const bat_style *x = bat_object_style(a), *y = bat_object_style(b);
    return x->stroked == y->stroked && (!x->stroked || x->width == y->width);
}

static bool same_kind(const bat_object *a, const bat_object *b) {
    return bat_object_type(a) == bat_object_type(b);
}

/* How much of a name is left without the number at its end, and what parts it from the rest. */
static size_t stem(const char *name) {
    const size_t whole = strlen(name);
    size_t size = whole;
    while (size > 0 && name[size - 1] >= '0' && name[size - 1] <= '9') size--;
    if (size < whole)
        while (size > 0 && strchr(" -_.", name[size - 1])) size--;
    return size > 0 ? size : whole;
}

static bool same_name(const bat_object *a, const bat_object *b) {
    const char *x = bat_object_name(a), *y = bat_object_name(b);
    const size_t size = stem(x);
    return size > 0 && size == stem(y) && !memcmp(x, y, size);
}

/* By what the command compares. */
static bool is_same(bat_command_id id, const bat_object *like, const bat_object *object) {
    switch (id) {
    case BAT_COMMAND_SELECT_SAME_KIND: return same_kind(like, object);
    case BAT_COMMAND_SELECT_SAME_NAME: return same_name(like, object);
    case BAT_COMMAND_SELECT_SAME_WIDTH: return same_width(like, object);
    case BAT_COMMAND_SELECT_SAME_STROKE: return same_stroke(like, object);
    case BAT_COMMAND_SELECT_SAME_FILL: return same_fill(like, object);
    default: return same_stroke(like, object) && same_fill(like, object);
    }
}

/* Whether it compares how curves look; otherwise groups and all that is drawn are compared. */
static bool is_of_curves(bat_command_id id) {
    return id != BAT_COMMAND_SELECT_SAME_KIND && id != BAT_COMMAND_SELECT_SAME_NAME;
}

static bool is_fit(bat_command_id id, const bat_object *object) {
    if (is_of_curves(id)) return bat_object_is_made_of_curves(object) && bat_object_is_drawn(object);
    return bat_object_is_drawn(object) || bat_object_is_mere_group(object);
}

/* What the others are compared with; NULL: nothing is selected that can be. */
static const bat_object *find_like(const bat_context *c, bat_command_id id) {
    const bat_selection *selection = &c->choice->selection;
    const bat_document *document = c->session->document;
    if (is_of_curves(id)) {
        const bat_object *like = bat_styling_selected(c, BAT_PROPERTY_STROKE_COLOUR);
        return like && bat_object_is_made_of_curves(like) ? like : NULL;
    }
    return selection->count ? bat_document_at(document, bat_document_find(document, selection->ids[0]))
                            : NULL;
}

static bat_status find_same(bat_context *c, bat_command_id id, const bat_object *like, bat_selection *found) {
    const bat_document *document = c->session->document;
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        if (is_fit(id, object) && !bat_seen_out_of_reach(c, i) && is_same(id, like, object))
            status = bat_selection_append(found, bat_object_id(object));
    }
    bat_selection_sort(found);
    return status;
}

bat_status bat_command_select_same(bat_context *c, bat_command_id id) {
    const bat_object *like = find_like(c, id);
    if (!like) return bat_notice_refuse(c, BAT_STATE, BAT_STRING_NOTICE_SELECT_FIRST);
    if (id == BAT_COMMAND_SELECT_SAME_NAME && !*bat_object_name(like))
        return bat_notice_refuse(c, BAT_STATE, BAT_STRING_NOTICE_NO_NAME);
    bat_seen_sync(c);
    bat_selection found = {0};
    const bat_status status = find_same(c, id, like, &found);
    if (status == BAT_OK) {
        char text[24];
        bat_selection_swap(&found, &c->choice->selection);
        snprintf(text, sizeof text, "%d", c->choice->selection.count);
        bat_notice_value(c, BAT_STRING_NOTICE_SELECTED_SAME, text);
        if (bat_tool_at(c->choice->tool)->traits & BAT_DRAWS)
            bat_toolbox_choose(c, bat_tool_that(BAT_CHOOSES));
    } else {
        bat_notice_failure(c, status);
    }
    bat_selection_free(&found);
    return status;
}
