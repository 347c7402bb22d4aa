#include "document/follow.h"

#include "document/document.h"
#include "document/kind.h"

bat_status bat_document_follower(const bat_document *document, int index, bat_object **out) {
    const bat_object *object = bat_document_at(document, index);
    const bat_object *source = bat_document_source(document, object);
    *out = NULL;
    return source ? bat_object_type(object)->follow(object, bat_object_id(source),
                                                    bat_object_curve(source, 0), out)
                  : BAT_OK;
}

/* Takes `made` over. */
static bat_status put(bat_document *document, int index, bat_object *made) {
    const bat_status status = made ? bat_document_replace(document, index, made) : BAT_OK;
    bat_object_release(made);
    return status;
}

bat_status bat_document_follow(bat_document *document) {
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        bat_object *made = NULL;
        if (bat_document_is_left(document, i)) return BAT_ARGUMENT;
        status = bat_document_follower(document, i, &made);
        if (status == BAT_OK) status = put(document, i, made);
    }
    return status;
}

bat_status bat_document_let_go(bat_document *document) {
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_object *made = NULL;
        if (!bat_document_is_left(document, i)) continue;
        status = bat_object_type(object)->follow(object, 0, NULL, &made);
        if (status == BAT_OK) status = put(document, i, made);
    }
    return status;
}
