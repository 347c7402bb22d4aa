/*
 * A listing: the document's list as it should become, built separately and then applied within the open transaction
 * with as few removals and insertions as possible. Every change of order, grouping or count goes this way.
 */
#ifndef BATTEN_EDITOR_SESSION_REORDER_H
#define BATTEN_EDITOR_SESSION_REORDER_H

#include "editor/session/context.h"
#include <batten/editor.h>

typedef struct bat_listing {
    bat_object **objects; /* retained, back to front */
    int count, room;
    bool failed; /* an allocation failed; the listing cannot be used any more */
} bat_listing;

void bat_listing_free(bat_listing *listing);
void bat_listing_add(bat_listing *listing, const bat_object *object); /* retains it */
void bat_listing_take(bat_listing *listing, bat_object *object);      /* takes ownership; NULL: a failure */
/* Adds the objects first to end of the document. */
void bat_listing_range(bat_listing *listing, const bat_document *document, int first, int end);
/* Makes the document equal to the listing: objects stay in place where they can (a longest increasing subsequence),
 * and those whose pointer differs are replaced. Needs an open transaction. O(n log n), plus O(n) for every change. */
bat_status bat_listing_apply(const bat_listing *listing, bat_context *c);

#endif
