/* Part of the drawing as a document of its own. */
#include "editor/edit/excerpt.h"
#include "document/document.h"
#include "document/follow.h"
#include "editor/edit/arrange.h"
#include "editor/session/reorder.h"
#include "editor/session/session.h"
#include <stdlib.h>

/* Adds the object with everything in it, outside any group. */
static void gather_root(const bat_document *document, int index, bat_listing *listing) {
    bat_object *root = NULL;
    bat_object_with_parent(bat_document_at(document, index), 0, &root);
    bat_listing_take(listing, root);
    bat_listing_range(listing, document, index + 1, bat_document_end(document, index));
}

/* Adds the selected objects. */
static bat_status gather_selection(const bat_context *c, bat_listing *listing) {
    const bat_document *document = c->session->document;
    int *roots, count;
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) return status;
    for (int i = 0; i < count; i++) gather_root(document, roots[i], listing);
    free(roots);
    return listing->failed ? BAT_MEMORY : BAT_OK;
}

static bat_status gather_all(const bat_context *c, bat_listing *listing) {
    const bat_document *document = c->session->document;
    bat_listing_range(listing, document, 0, bat_document_count(document));
    return listing->failed ? BAT_MEMORY : BAT_OK;
}

static bat_status gather_object(const bat_context *c, bat_id id, bat_listing *listing) {
    const int index = bat_document_find(c->session->document, id);
    if (index < 0) return BAT_ARGUMENT;
    gather_root(c->session->document, index, listing);
    return listing->failed ? BAT_MEMORY : BAT_OK;
}

/* A document of what was gathered, which is released; status: of the gathering. */
static bat_status make(const bat_context *c, bat_status status, bat_listing *listing, bat_document **out) {
    bat_document *made = NULL;
    if (status == BAT_OK) status = bat_document_create(&made);
    if (status == BAT_OK)
        status = bat_document_set_scale(made, bat_document_scale(c->session->document),
                                        bat_document_unit(c->session->document));
    if (status == BAT_OK && (status = bat_document_fill(made, listing->count, listing->objects)) == BAT_OK)
        listing->count = 0; /* ownership has passed on */
    if (status == BAT_OK) status = bat_document_let_go(made);
    bat_listing_free(listing);
    if (status == BAT_OK)
        *out = made;
    else
        bat_document_free(made);
    return status;
}

bat_status bat_excerpt_make(const bat_context *c, bat_excerpt part, bat_document **out) {
    if (c->session->busy) return BAT_STATE;
    if (part == BAT_EXCERPT_PAGE) return bat_document_copy(c->session->document, out);
    bat_listing listing = {0};
    const bat_status status = part == BAT_EXCERPT_ALL ? gather_all(c, &listing)
                                                      : gather_selection(c, &listing);
    return make(c, status, &listing, out);
}

bat_status bat_excerpt_object(const bat_context *c, bat_id id, bat_document **out) {
    if (c->session->busy) return BAT_STATE;
    bat_listing listing = {0};
    return make(c, gather_object(c, id, &listing), &listing, out);
}
