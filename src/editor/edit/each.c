#include "editor/edit/each.h"
#include "editor/choice/choice.h"
#include "document/document.h"

static const bat_object *selected(const bat_context *c, int i, int *index) {
    const bat_document *document = c->session->document;
    *index = bat_document_find(document, c->choice->selection.ids[i]);
    return bat_document_at(document, *index);
}

bool bat_each_any(const bat_context *c, bat_each_fits *fits) {
    int index;
    for (int i = 0; i < c->choice->selection.count; i++) {
        const bat_object *object = selected(c, i, &index);
        if (object && fits(object)) return true;
    }
    return false;
}

bat_status bat_each_replace(bat_context *c, bat_each_fits *fits, bat_each_made *made, bat_string step) {
    if (!bat_each_any(c, fits)) return BAT_STATE;
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) return status;
    for (int i = 0; i < c->choice->selection.count && status == BAT_OK; i++) {
        int index;
        const bat_object *object = selected(c, i, &index);
        bat_object *other = NULL;
        if (!object || !fits(object)) continue;
        status = made(object, &other);
        if (status == BAT_OK) status = bat_transaction_replace(c, index, other);
        bat_object_release(other);
    }
    return bat_transaction_end(c, status, step);
}
