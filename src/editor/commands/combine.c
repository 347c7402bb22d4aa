/* Commands that make one object of several curves, and several of one; mirrors. */
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "curve/mirror.h"
#include "editor/edit/arrange.h"
#include "editor/edit/symmetry.h"
#include "editor/session/context.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/commands.h"
#include "editor/tables/tables.h"
#include "kinds/kinds.h"

#include <stdlib.h>

/* ---- mirrors ---- */

bat_status bat_command_mirror(bat_context *c, bat_command_id id) {
    double box[4], matrix[6];
    if (!bat_arrange_selection_box(c, box)) {
        bat_notice(c, BAT_STRING_NOTICE_SELECT_FIRST);
        return BAT_STATE;
    }
    const bat_mirror axis = {true, {box[0] / 2 + box[2] / 2, box[1] / 2 + box[3] / 2}, {0, 1}};
    const bat_mirror level = {true, {axis.at[0], axis.at[1]}, {1, 0}};
    const bat_mirror chosen = id == BAT_COMMAND_MIRROR_ACROSS ? axis
                              : id == BAT_COMMAND_MIRROR_DOWN ? level
                                                              : bat_symmetry_axis(c);
    bat_mirror_matrix(&chosen, matrix);
    return bat_arrange_transform(c, matrix, BAT_STRING_STEP_MIRROR);
}

/* ---- compound paths ---- */

/* The selected objects that are made of curves, ascending, in the list that `members` is. */
static int keep_curved(const bat_context *c, int *members, int count) {
    int kept = 0;
    for (int i = 0; i < count; i++)
        if (bat_object_is_made_of_curves(bat_document_at(c->session->document, members[i])))
            members[kept++] = members[i];
    return kept;
}

/* The lowest takes all curves; crossing or within each other they leave holes. */
static bat_status combined(bat_context *c, const int *members, int count) {
    const bat_document *document = c->session->document;
    const bat_object *lowest = bat_document_at(document, members[0]);
    bat_object *made = NULL, *styled = NULL;
    int total = 0, n = 0;
    for (int i = 0; i < count; i++) total += bat_object_curve_count(bat_document_at(document, members[i]));
    bat_object_part *list = calloc((size_t)total, sizeof *list);
    if (!list) return BAT_MEMORY;
    for (int i = 0; i < count; i++) {
        const bat_object *object = bat_document_at(document, members[i]);
        for (int k = 0; k < bat_object_curve_count(object); k++) list[n++] = (bat_object_part){object, k};
    }
    bat_style style = *bat_object_style(lowest);
    style.even_odd = true;
    bat_status status = bat_path_of_parts(lowest, total, list, &made);
    free(list);
    if (status == BAT_OK) status = bat_object_with_style(made, &style, &styled);
    for (int i = count - 1; i > 0 && status == BAT_OK; i--) status = bat_transaction_remove(c, members[i]);
    if (status == BAT_OK) status = bat_transaction_replace(c, members[0], styled);
    bat_object_release(made);
    bat_object_release(styled);
    return status;
}

/* An object of each of its curves, in the order that they were drawn in; the first keeps its id. */
static bat_status taken_apart(bat_context *c, int index) {
    bat_object *whole = bat_object_retain(bat_document_at(c->session->document, index));
    bat_status status = BAT_OK;
    for (int k = bat_object_curve_count(whole) - 1; k >= 0 && status == BAT_OK; k--) {
        bat_object *one = NULL, *placed = NULL;
        status = bat_path_of_parts(whole, 1, &(bat_object_part){whole, k}, &one);
        if (status == BAT_OK && k > 0) {
            status = bat_object_with_id(one, bat_document_new_id(c->session->document), &placed);
            if (status == BAT_OK) status = bat_transaction_insert(c, index + 1, placed);
            if (status == BAT_OK) status = bat_selection_add(&c->choice->selection, bat_object_id(placed));
        } else if (status == BAT_OK) {
            status = bat_transaction_replace(c, index, one);
        }
        bat_object_release(one);
        bat_object_release(placed);
    }
    bat_object_release(whole);
    return status;
}

static bat_status finish(bat_context *c, bat_status status, bool changed, bat_string label,
                         bat_string otherwise) {
    if (status == BAT_OK && changed) return bat_transaction_commit(c, label, NULL);
    bat_transaction_cancel(c);
    if (status == BAT_OK)
        bat_notice(c, otherwise);
    else
        bat_notice_failure(c, status);
    return status == BAT_OK ? BAT_STATE : status;
}

bat_status bat_command_combine(bat_context *c, bat_command_id id) {
    int *members = NULL, count = 0;
    (void)id;
    bat_status status = bat_arrange_members(c, &members, &count);
    if (status == BAT_STATE) status = BAT_OK;
    count = keep_curved(c, members, count);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status == BAT_OK && count > 1) status = combined(c, members, count);
    free(members);
    return finish(c, status, count > 1, BAT_STRING_STEP_COMBINE, BAT_STRING_NOTICE_SELECT_TWO);
}

bat_status bat_command_release(bat_context *c, bat_command_id id) {
    int *members = NULL, count = 0;
    bool changed = false;
    (void)id;
    bat_status status = bat_arrange_members(c, &members, &count);
    if (status == BAT_STATE) status = BAT_OK;
    count = keep_curved(c, members, count);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    for (int i = count - 1; i >= 0 && status == BAT_OK; i--) {
        if (bat_object_curve_count(bat_document_at(c->session->document, members[i])) < 2) continue;
        status = taken_apart(c, members[i]);
        changed = true;
    }
    free(members);
    return finish(c, status, changed, BAT_STRING_STEP_RELEASE, BAT_STRING_NOTICE_SELECT_COMPOUND);
}
