/* Inside the document: what readers need beyond the public calls. */
#ifndef BATTEN_SRC_DOCUMENT_H
#define BATTEN_SRC_DOCUMENT_H

#include "document/nesting.h"

/* Fills an empty document with objects (one use of each is taken over on success), back to front.
 * BAT_ARGUMENT when two share an id. O(n). */
bat_status bat_document_fill(bat_document *document, int count, bat_object *const *objects);
/* The id that bat_document_new_id gives next, and raising it (a lower value changes nothing). */
bat_id bat_document_next(const bat_document *document);
void bat_document_raise_next(bat_document *document, bat_id next);

/* NULL, or what is wrong with an object by itself. An object never changes: once is enough. */
const char *bat_object_check(const bat_object *object);
/* What bat_nesting_next finds, without a walk: by the parents' ids, in a document whose groups are right. O(depth). */
bat_nesting_level bat_document_level(const bat_document *document, int index);
/* Whether the object at index is with its group, if all before it are, and no layer in a mere group. What changed
 * between two neighbours shows in the hinder one. True when there is none at index. O(depth). */
bool bat_document_fits(const bat_document *document, int index);
/* NULL, or what is wrong with the groups: the last part of bat_document_check. O(objects), no memory. */
const char *bat_document_check_nesting(const bat_document *document);

#endif
