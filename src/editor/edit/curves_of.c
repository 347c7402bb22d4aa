#include "editor/edit/curves_of.h"
#include "editor/editor.h"

bat_status bat_put_curve(bat_editor *editor, bat_id object, int index, bat_curve *curve) {
    int at = bat_document_find(editor->document, object);
    bat_object *after = NULL;
    bat_status status = at < 0 ? BAT_ARGUMENT
                               : bat_object_with_curve(bat_document_at(editor->document, at), index, curve,
                                                       &after);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    status = bat_transaction_replace(editor, at, after);
    bat_object_release(after);
    return status;
}

bat_status bat_commit_curve(bat_editor *editor, bat_id object, int index, bat_curve *curve,
                            bat_string label) {
    bat_status status = bat_transaction_begin(editor);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    status = bat_put_curve(editor, object, index, curve);
    if (status == BAT_OK) return bat_transaction_commit(editor, label, NULL);
    bat_transaction_cancel(editor);
    return status;
}
