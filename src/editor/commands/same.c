/* Commands that select what looks like what is selected. */
#include "document/document.h"
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

bat_status bat_command_select_same(bat_context *c, bat_command_id id) {
    const bat_document *document = c->session->document;
    const bat_object *like = bat_styling_selected(c, BAT_PROPERTY_STROKE_COLOUR);
    if (!like || !bat_object_is_made_of_curves(like)) {
        bat_notice(c, BAT_STRING_NOTICE_SELECT_FIRST);
        return BAT_STATE;
    }
    bat_seen_sync(c);
    bat_selection found = {0};
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        if (!bat_object_is_made_of_curves(object) || !bat_object_is_drawn(object) ||
            bat_seen_out_of_reach(c, i))
            continue;
        if (id != BAT_COMMAND_SELECT_SAME_FILL && !same_stroke(like, object)) continue;
        if (id != BAT_COMMAND_SELECT_SAME_STROKE && !same_fill(like, object)) continue;
        status = bat_selection_append(&found, bat_object_id(object));
    }
    bat_selection_sort(&found);
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
