/* Objects made beside others, by one step: they are selected then. */
#include "editor/commands/beside.h"
#include "editor/choice/choice.h"
#include "editor/choice/selection.h"
#include "editor/edit/arrange.h"
#include "editor/session/notice.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"

#include <stdlib.h>

bat_status bat_beside_insert(bat_context *c, int index, const bat_object *object, bat_beside *made) {
    bat_object *placed = NULL;
    bat_status status = bat_object_with_id(object, bat_document_new_id(c->session->document), &placed);
    if (status == BAT_OK) status = bat_transaction_insert(c, index, placed);
    if (status == BAT_OK) status = bat_selection_add(&c->choice->selection, bat_object_id(placed));
    if (status == BAT_OK) made->count++;
    bat_object_release(placed);
    return status;
}

static bat_string why_not(bat_status status, const bat_beside *m, bat_string unfit) {
    return status == BAT_SINGULAR            ? BAT_STRING_NOTICE_REGION_TANGLED
           : status == BAT_COUNT             ? BAT_STRING_NOTICE_MANY_DASHES
           : status == BAT_OK && m->fit == 0 ? unfit
           : status == BAT_OK                ? BAT_STRING_NOTICE_OFFSET_EMPTY
                                             : BAT_STRING_COUNT;
}

bat_status bat_beside_each(bat_context *c, bat_beside_maker *run, bat_string label, bat_string unfit) {
    int *members = NULL, count = 0;
    bat_beside m = {0};
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
