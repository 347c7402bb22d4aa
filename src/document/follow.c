#include "document/follow.h"

#include "document/document.h"
#include "document/kind.h"
#include <batten/recipe.h>

bat_status bat_document_follower(const bat_document *document, int index, bat_object **out) {
    const bat_object *object = bat_document_at(document, index), *from[BAT_RECIPE_CURVES];
    const bat_object *source = bat_document_source(document, object);
    const bat_kind_type *type = bat_object_type(object);
    *out = NULL;
    if (source) return type->follow(object, bat_object_id(source), bat_object_curve(source, 0), out);
    if (bat_object_sources(object, NULL) == 0) return BAT_OK;
    bat_document_sources(document, object, from); /* what is gone is NULL */
    return type->remake(object, NULL, from, out);
}

/* Takes `made` over. */
static bat_status put(bat_document *document, int index, bat_object *made) {
    const bat_status status = made ? bat_document_replace(document, index, made) : BAT_OK;
    bat_object_release(made);
    return status;
}

static bool is_short(const bat_document *document, int index) {
    const bat_object *from[BAT_RECIPE_CURVES];
    return bat_document_is_left(document, index) ||
           !bat_document_sources(document, bat_document_at(document, index), from);
}

bat_status bat_document_follow(bat_document *document) {
    bat_status status = BAT_OK;
    if (!bat_document_has_followers(document)) return BAT_OK;
    for (int i = 0; i < bat_document_count(document) && status == BAT_OK; i++) {
        bat_object *made = NULL;
        if (is_short(document, i)) return BAT_ARGUMENT;
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
        if (!is_short(document, i)) continue;
        status = bat_document_is_left(document, i) ? bat_object_type(object)->follow(object, 0, NULL, &made)
                                                   : bat_document_follower(document, i, &made);
        if (status == BAT_OK) status = put(document, i, made);
    }
    return status;
}

bat_status bat_object_renumbered(const bat_object *object, const bat_id *ids, bat_object **out) {
    const bat_id followed = bat_object_followed(object);
    const int count = bat_object_sources(object, NULL);
    *out = NULL;
    if (followed) return bat_object_type(object)->follow(object, ids[0], NULL, out);
    if (count == 0) return BAT_OK;
    return bat_object_type(object)->remake(object, ids, NULL, out);
}
