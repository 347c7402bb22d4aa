/* The command that makes filled shapes of strokes. */
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/commands/beside.h"
#include "editor/edit/outlining.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/commands.h"

/* A fill stays what it is; the outline lies where the stroke was painted. */
static bat_status outline_one(bat_context *c, int index, bat_beside *m) {
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
        if (status == BAT_OK) status = bat_beside_insert(c, first ? index : index + 1, outline, m);
    } else {
        status = bat_transaction_replace(c, index, outline);
        if (status == BAT_OK) status = bat_selection_add(&c->choice->selection, bat_object_id(outline));
        if (status == BAT_OK) m->count++;
    }
    bat_object_release(filled);
    bat_object_release(outline);
    return status;
}

bat_status bat_command_curve_outline(bat_context *c, bat_command_id id) {
    (void)id;
    return bat_beside_each(c, outline_one, BAT_STRING_STEP_CURVE_OUTLINE, BAT_STRING_NOTICE_SELECT_STROKED);
}
