/*
 * A listing: the document's list as it is to be, built apart and then made so within the open transaction by
 * as few removals and insertions as can be. Everything that changes order, groups or number goes this way.
 */
#ifndef BATTEN_EDITOR_SESSION_REORDER_H
#define BATTEN_EDITOR_SESSION_REORDER_H

#include "editor/session/context.h"
#include <batten/editor.h>

typedef struct bat_listing {
    bat_object **objects; /* retained, back to front */
    int count, room;
    bool failed; /* an allocation failed; it cannot be used any more */
} bat_listing;

void bat_listing_free(bat_listing *listing);
void bat_listing_add(bat_listing *listing, const bat_object *object); /* retains it */
void bat_listing_take(bat_listing *listing, bat_object *object);      /* takes it over; NULL: a failure */
/* Adds the objects first..end of the document. */
void bat_listing_range(bat_listing *listing, const bat_document *document, int first, int end);
/* Makes the document so: objects keep their place when they can (a longest ascending run stays), those with
 * another pointer are replaced. Needs an open transaction. O(n log n) and n for every change. */
bat_status bat_listing_apply(const bat_listing *listing, bat_context *c);

#endif
