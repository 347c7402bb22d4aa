#include "editor/edit/curves_of.h"
#include "editor/edit/arrange.h"
#include "document/document.h"
#include "editor/choice/choice.h"
#include "editor/edit/style.h"
#include "editor/session/context.h"
#include "editor/session/session.h"
#include "editor/session/transaction.h"
#include "editor/tables/tables.h"
#include "editor/view/stage.h"
#include "format/model/drawn.h"
#include "format/seen/seen.h"
#include "kinds/kinds.h"

#include <stdlib.h>

const bat_curve *bat_edit_target_in(const bat_document *document, int dimension, bat_id object, int curve) {
    const bat_object *found = bat_document_at(document, bat_document_find(document, object));
    if (!found || curve < 0 || curve >= bat_object_curve_count(found)) return NULL;
    const bat_curve *target = bat_object_curve(found, curve);
    return !dimension || bat_curve_dimension(target) == dimension ? target : NULL;
}

const bat_curve *bat_edit_target(const bat_document *document, bat_id object, int curve) {
    return bat_edit_target_in(document, 2, object, curve);
}

bat_status bat_without_curve(const bat_object *object, int index, bat_object **out) {
    const int count = bat_object_curve_count(object);
    int kept = 0;
    *out = NULL;
    if (count == 1) return BAT_OK;
    bat_object_part *list = calloc((size_t)count, sizeof *list);
    if (!list) return BAT_MEMORY;
    for (int i = 0; i < count; i++)
        if (i != index) list[kept++] = (bat_object_part){object, i};
    const bat_status status = bat_path_of_parts(object, kept, list, out);
    free(list);
    return status;
}

bat_status bat_insert_curve(bat_context *c, bat_id id, const bat_style *style, bat_id parent,
                            bat_curve *curve) {
    const bat_document *document = c->session->document;
    bat_object *object = NULL, *placed = NULL;
    bat_status status = bat_object_create_path(id, NULL, style, 1, &curve, &object);
    if (status != BAT_OK) return status;
    int layer = parent ? bat_document_find(document, parent) : -1;
    int index = layer < 0 ? bat_document_count(document) : bat_document_end(document, layer);
    status = parent && layer < 0 ? BAT_ARGUMENT : bat_object_with_parent(object, parent, &placed);
    if (status == BAT_OK) status = bat_transaction_insert(c, index, placed);
    bat_object_release(placed);
    bat_object_release(object);
    return status;
}

bat_status bat_dash_new(bat_context *c, bat_id id, bat_dashing dashes) {
    const int index = bat_document_find(c->session->document, id);
    bat_object *made = NULL;
    if (dashes == BAT_DASHING_SOLID || index < 0) return BAT_OK;
    bat_status status = bat_dashing_give(bat_document_at(c->session->document, index), dashes, &made);
    if (status == BAT_OK) status = bat_transaction_replace(c, index, made);
    bat_object_release(made);
    return status;
}

bat_status bat_keep_view_plane(bat_context *c, const bat_ground *ground, bat_id drawn) {
    const bat_document *document = c->session->document;
    bat_object *plane = NULL;
    if (!bat_ground_is_of_view(ground) || bat_seen_in_space(document) ||
        bat_stand_of(document) == BAT_STAND_FLOOR)
        return BAT_OK;
    bat_status status = bat_object_create_plane(drawn + 1, "", ground->numbers, ground->numbers + 3, &plane);
    if (status == BAT_OK) status = bat_transaction_insert(c, 0, plane);
    bat_object_release(plane);
    return status;
}

bat_status bat_put_new_curve(bat_context *c, bat_id id, bat_curve *curve) {
    const bat_style style = bat_styling_new(c);
    bat_id parent; /* not a layer where it could not be seen, or not be chosen */
    bat_arrange_place(c, &parent);
    bat_status status = bat_keep_view_plane(c, &c->stage->ground, id);
    if (status == BAT_OK)
        status = bat_insert_curve(c, id, &style, parent, curve);
    else
        bat_curve_free(curve);
    return status == BAT_OK ? bat_dash_new(c, id, bat_styling_dashes(c)) : status;
}

bat_status bat_commit_new_curve(bat_context *c, bat_curve *curve, bat_string label, bat_id *id) {
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    const bat_id made = bat_document_new_id(c->session->document);
    status = bat_transaction_end(c, bat_put_new_curve(c, made, curve), label);
    if (status == BAT_OK && id) *id = made;
    return status;
}

bat_status bat_commit_chosen_curve(bat_context *c, bat_curve *curve, bat_string label) {
    bat_id id = 0;
    const bat_status status = bat_commit_new_curve(c, curve, label, &id);
    if (status != BAT_OK) return status;
    bat_selection_clear(&c->choice->selection);
    return bat_selection_add(&c->choice->selection, id);
}

/* Replaces the object at this index, within the open transaction; status: of making the new object. */
static bat_status put(bat_context *c, int at, bat_status status, bat_object *after) {
    if (status == BAT_OK) status = bat_transaction_replace(c, at, after);
    bat_object_release(after);
    return status;
}

bat_status bat_put_curve(bat_context *c, bat_id object, int index, bat_curve *curve) {
    const bat_document *document = c->session->document;
    const int at = bat_document_find(document, object);
    bat_object *after = NULL;
    bat_status status = bat_object_with_curve(bat_document_at(document, at), index, curve, &after);
    return put(c, at, status, after);
}

bat_status bat_remove_curve(bat_context *c, bat_id id, int index) {
    int at = bat_document_find(c->session->document, id);
    if (at < 0) return BAT_ARGUMENT;
    bat_object *after = NULL;
    bat_status status = bat_without_curve(bat_document_at(c->session->document, at), index, &after);
    if (status != BAT_OK) return status;
    status = after ? bat_transaction_replace(c, at, after) : bat_transaction_remove(c, at);
    bat_object_release(after);
    return status;
}

bat_status bat_commit_curve(bat_context *c, bat_id object, int index, bat_curve *curve, bat_string label) {
    bat_status status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_curve_free(curve);
        return status;
    }
    return bat_transaction_end(c, bat_put_curve(c, object, index, curve), label);
}

bat_status bat_put_shape(bat_context *c, bat_id id, int curve, bat_shape *shape) {
    const bat_document *document = c->session->document;
    const int at = bat_document_find(document, id);
    bat_object *after = NULL;
    bat_status status = bat_object_with_shape(bat_document_at(document, at), curve, shape, &after);
    return put(c, at, status, after);
}

bat_status bat_commit_shape(bat_context *c, bat_id id, int curve, bat_shape *shape, bat_string label) {
    bat_status status = bat_shape_commit(shape);
    if (status == BAT_OK) status = bat_transaction_begin(c);
    if (status != BAT_OK) {
        bat_shape_free(shape);
        return status;
    }
    return bat_transaction_end(c, bat_put_shape(c, id, curve, shape), label);
}
