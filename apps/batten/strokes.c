#include "strokes.h"

#include "editor/edit/outlining.h"

#include <batten/paint.h>

static bat_status put(bat_document *document, int index, bat_status status, bat_object *made) {
    if (status == BAT_OK) status = bat_document_replace(document, index, made);
    bat_object_release(made);
    return status;
}

bat_status strokes_even(bat_document *document, int *count) {
    bat_status status = BAT_OK;
    *count = 0;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        const bat_object *object = bat_document_at(document, i);
        bat_object *made = NULL;
        if (!bat_object_widths(object).count) continue;
        bat_paint paint = *bat_object_paint(object);
        paint.width_count = 0, paint.widths = NULL;
        status = bat_object_with_paint(object, &paint, &made);
        status = put(document, i, status, made);
        ++*count;
    }
    return status;
}

/* Puts the outline where the stroke was painted; a fill stays what it is. *more: an object has been added. */
static bat_status outline(bat_document *document, int index, bool *more) {
    const bat_object *object = bat_document_at(document, index);
    bat_style plain = *bat_object_style(object);
    bat_object *made = NULL, *named = NULL, *filled = NULL;
    bool first = false;
    plain.stroked = false;
    bat_status status = bat_outlining_stroke(object, &made, &first);
    *more = status == BAT_OK && plain.filled && made;
    if (status == BAT_OK && (*more || !made)) {
        status = bat_object_with_style(object, &plain, &filled);
        status = put(document, index, status, filled);
        if (status == BAT_OK && *more)
            status = bat_object_with_id(made, bat_document_new_id(document), &named);
        if (status == BAT_OK && *more)
            status = bat_document_insert(document, first ? index : index + 1, named);
        bat_object_release(named);
        bat_object_release(made);
        return status;
    }
    return put(document, index, status, made);
}

bat_status strokes_outlined(bat_document *document) {
    bat_status status = BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        bool more = false;
        if (!bat_object_widths(bat_document_at(document, i)).count) continue;
        status = outline(document, i, &more);
        i += more;
    }
    return status;
}
