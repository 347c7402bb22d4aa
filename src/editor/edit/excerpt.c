/* Part of the drawing as a document of its own. */
#include "editor/edit/excerpt.h"
#include "document/document.h"
#include "document/follow.h"
#include "editor/edit/arrange.h"
#include "editor/session/reorder.h"
#include "editor/session/session.h"
#include <stdlib.h>

/* Adds the selected objects with everything in them, outside any group of the others. */
static bat_status gather_selection(const bat_context *c, bat_listing *listing) {
    const bat_document *document = c->session->document;
    int *roots, count;
    bat_status status = bat_arrange_roots(c, &roots, &count);
    if (status != BAT_OK) return status;
    for (int i = 0; i < count; i++) {
        bat_object *root = NULL;
        bat_object_with_parent(bat_document_at(document, roots[i]), 0, &root);
        bat_listing_take(listing, root);
        bat_listing_range(listing, document, roots[i] + 1, bat_document_end(document, roots[i]));
    }
    free(roots);
    return listing->failed ? BAT_MEMORY : BAT_OK;
}

static bat_status gather_all(const bat_context *c, bat_listing *listing) {
    const bat_document *document = c->session->document;
    bat_listing_range(listing, document, 0, bat_document_count(document));
    return listing->failed ? BAT_MEMORY : BAT_OK;
}

bat_status bat_excerpt_make(const bat_context *c, bat_excerpt part, bat_document **out) {
    if (c->session->busy) return BAT_STATE;
    if (part == BAT_EXCERPT_PAGE) return bat_document_copy(c->session->document, out);
    bat_listing listing = {0};
    bat_document *made = NULL;
    bat_status status = part == BAT_EXCERPT_ALL ? gather_all(c, &listing) : gather_selection(c, &listing);
    if (status == BAT_OK) status = bat_document_create(&made);
    if (status == BAT_OK)
        status = bat_document_set_scale(made, bat_document_scale(c->session->document),
                                        bat_document_unit(c->session->document));
    if (status == BAT_OK && (status = bat_document_fill(made, listing.count, listing.objects)) == BAT_OK)
        listing.count = 0; /* ownership has passed on */
    if (status == BAT_OK) status = bat_document_let_go(made);
    bat_listing_free(&listing);
    if (status == BAT_OK)
        *out = made;
    else
        bat_document_free(made);
    return status;
}
