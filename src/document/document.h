/* Inside the document: what readers need beyond the public calls. */
#ifndef BATTEN_SRC_DOCUMENT_H
#define BATTEN_SRC_DOCUMENT_H

#include <batten/document.h>

/* Fills an empty document with objects (one use of each is taken over on success), back to front.
 * BAT_ARGUMENT when two share an id. O(n). */
bat_status bat_document_fill(bat_document *document, int count, bat_object *const *objects);
/* The id that bat_document_new_id gives next, and raising it (a lower value changes nothing). */
bat_id bat_document_next(const bat_document *document);
void bat_document_raise_next(bat_document *document, bat_id next);

/* NULL, or what is wrong with the groups: the last part of bat_document_check. O(objects), no memory. */
const char *bat_document_check_nesting(const bat_document *document);

#endif
