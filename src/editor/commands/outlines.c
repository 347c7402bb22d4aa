/* Commands that make curves beside curves: offsets, and the outlines of strokes. */
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/arrange.h"
#include "editor/edit/outlining.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/commands.h"
#include "editor/tables/settings.h"
#include "editor/tables/tables.h"

#include <stdlib.h>

/* What came of all objects: whether there was one that the command is for, and how many new ones were made. */
typedef struct made {
    int fit, count;
} made;

static bat_status insert_beside(bat_context *c, int index, const bat_object *object, made *m) {
    bat_object *placed = NULL;
    bat_status status = bat_object_with_id(object, bat_document_new_id(c->session->document), &placed);
    if (status == BAT_OK) status = bat_transaction_insert(c, index, placed);
    if (status == BAT_OK) status = bat_selection_add(&c->choice->selection, bat_object_id(placed));
    if (status == BAT_OK) m->count++;
    bat_object_release(placed);
    return status;
}

/* What grows lies behind what it was made from, what shrinks in front of it. */
static bat_status offset_one(bat_context *c, int index, made *m) {
    const bat_object *object = bat_document_at(c->session->document, index);
    const bat_offset_side side = (bat_offset_side)(int)c->settings->values[BAT_PROPERTY_OFFSET_SIDE];
    bat_object *beside = NULL;
    if (!bat_outlining_is_flat(object)) return BAT_OK;
    m->fit++;
    bat_status status = bat_outlining_offset(object, c->settings->values[BAT_PROPERTY_OFFSET_DISTANCE], side,
                                             &beside);
    if (status == BAT_OK && beside)
        status = insert_beside(c, side == BAT_OFFSET_INSIDE ? index + 1 : index, beside, m);
    bat_object_release(beside);
    return status;
}

/* A fill stays what it is; the outline lies where the stroke was painted. */
static bat_status outline_one(bat_context *c, int index, made *m) {
    const bat_object *object = bat_document_at(c->session->document, index);
    const bat_style *style = bat_object_style(object);
    bat_object *outline = NULL, *filled = NULL;
    bool first = false;
    if (!bat_outlining_is_flat(object) || !style->stroked || !(style->width > 0)) return BAT_OK;
    m->fit++;
    bat_status status = bat_outlining_stroke(object, &outline, &first);
    if (status != BAT_OK || !outline) return status;
    if (style->filled) {
        bat_style plain = *style;
        plain.stroked = false;
        status = bat_object_with_style(object, &plain, &filled);
        if (status == BAT_OK) status = bat_transaction_replace(c, index, filled);
        if (status == BAT_OK) status = insert_beside(c, first ? index : index + 1, outline, m);
    } else {
        status = bat_transaction_replace(c, index, outline);
        if (status == BAT_OK) status = bat_selection_add(&c->choice->selection, bat_object_id(outline));
        if (status == BAT_OK) m->count++;
    }
    bat_object_release(filled);
    bat_object_release(outline);
    return status;
}

static bat_string why_not(bat_status status, const made *m, bat_string unfit) {
    return status == BAT_SINGULAR            ? BAT_STRING_NOTICE_REGION_TANGLED
           : status == BAT_COUNT             ? BAT_STRING_NOTICE_MANY_DASHES
           : status == BAT_OK && m->fit == 0 ? unfit
           : status == BAT_OK                ? BAT_STRING_NOTICE_OFFSET_EMPTY
                                             : BAT_STRING_COUNT;
}

static bat_status each(bat_context *c, bat_status (*run)(bat_context *, int, made *), bat_string label,
                       bat_string unfit) {
    int *members = NULL, count = 0;
    made m = {0};
    bat_selection before = {0};
    bat_status status = bat_arrange_members(c, &members, &count);
    if (status == BAT_STATE) status = BAT_OK;
    if (status == BAT_OK) status = bat_transaction_begin(c);
    const bool open = status == BAT_OK;
    if (open) bat_selection_swap(&before, &c->choice->selection); /* what is made is selected */
    for (int i = count - 1; i >= 0 && status == BAT_OK; i--) status = run(c, members[i], &m);
    free(members);
    const bool done = status == BAT_OK && m.count > 0;
    if (done) status = bat_transaction_commit(c, label, NULL);
    if (open && !done) bat_transaction_cancel(c);
    if (open && (!done || status != BAT_OK)) bat_selection_swap(&before, &c->choice->selection);
    bat_selection_free(&before);
    if (done && status == BAT_OK) return BAT_OK;
    return bat_notice_refuse(c, status, why_not(status, &m, unfit));
}

bat_status bat_command_curve_offset(bat_context *c, bat_command_id id) {
    (void)id;
    return each(c, offset_one, BAT_STRING_STEP_CURVE_OFFSET, BAT_STRING_NOTICE_SELECT_FLAT);
}

bat_status bat_command_curve_outline(bat_context *c, bat_command_id id) {
    (void)id;
    return each(c, outline_one, BAT_STRING_STEP_CURVE_OUTLINE, BAT_STRING_NOTICE_SELECT_STROKED);
}
