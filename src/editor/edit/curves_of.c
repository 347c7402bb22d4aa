#include "editor/edit/curves_of.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "editor/tools/tool.h"

bat_status bat_put_curve(bat_context *c, bat_id object, int index, bat_curve *curve) {
    int at = bat_document_find(c->session->document, object);
    bat_object *after = NULL;
    bat_status status = at < 0 ? BAT_ARGUMENT
                               : bat_object_with_curve(bat_document_at(c->session->document, at), index,
                                                       curve, &after);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    status = bat_transaction_replace(c, at, after);
    bat_object_release(after);
    return status;
}

bat_status bat_commit_curve(bat_context *c, bat_id object, int index, bat_curve *curve, bat_string label) {
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    status = bat_put_curve(c, object, index, curve);
    if (status == BAT_OK) return bat_transaction_commit(c, label, NULL);
    bat_transaction_cancel(c);
    return status;
}
